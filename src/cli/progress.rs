//! Long runs: progress with the time left on standard error, and Ctrl-C. A terminal shows a bar; a file gets a line
//! every tenth of a stage, or every minute if that is sooner; a program that asks by [`VARIABLE`] gets lines of JSON. The first Ctrl-C stops the analysis, which returns the
//! finished part, marked incomplete. The second ends the process immediately and removes partial files.

use files::code::{Code, Warning};
use std::sync::atomic::{AtomicBool, Ordering};
use std::sync::{LazyLock, Mutex, OnceLock, PoisonError};
use std::time::{Duration, Instant};

use fem::progress::Progress;
use indicatif::{ProgressBar, ProgressStyle};

use crate::cli::Global;
use crate::cli::terminal::{say, warn};
use crate::error::{EXIT_COMPUTATION, EXIT_INTERRUPTED};
use engines::estimate::span;

/// Set by Ctrl-C.
static STOP: AtomicBool = AtomicBool::new(false);
/// Whether the first Ctrl-C stops the analysis instead of ending the process.
static GRACEFUL: AtomicBool = AtomicBool::new(false);

/// What the first Ctrl-C does then.
static STOPPING: OnceLock<&str> = OnceLock::new();

/// Installs the Ctrl-C handler of every command: it ends the process with exit code 130 and removes partial files,
/// unless [`stop_gracefully`] was called.
pub(crate) fn listen(global: &Global) {
    let quiet = global.quiet;
    // A handler that is already set (a second run in one process) does the same.
    let _ = ctrlc::set_handler(move || {
        let graceful = GRACEFUL.load(Ordering::SeqCst);
        if !graceful || STOP.swap(true, Ordering::SeqCst) {
            // Results already in place stay: the run was finished except for its messages.
            std::process::exit(i32::from(match files::discard_unfinished() {
                true => EXIT_COMPUTATION,
                false => EXIT_INTERRUPTED,
            }));
        }
        if !quiet {
            say!("interrupted: {}", STOPPING.get().copied().unwrap_or_default());
        }
    });
}

/// What the first Ctrl-C does of a run that can be cut short.
pub(crate) const FINISHED_PART: &str = "writing the finished part (press Ctrl-C again to discard it)";

/// Makes the first Ctrl-C stop the analysis, which returns the finished part. The second ends the process.
///
/// * `what`: what happens until then, for the user
pub(crate) fn stop_gracefully(what: &'static str) {
    // A second run in one process does the same.
    STOPPING.get_or_init(|| what);
    GRACEFUL.store(true, Ordering::SeqCst);
}

/// Whether Ctrl-C was pressed in a run that [`stop_gracefully`] has ended.
pub(crate) fn stopped() -> bool {
    STOP.load(Ordering::Relaxed)
}

/// Progress on standard error, with the state of Ctrl-C.
pub(crate) struct Watch {
    /// Hidden unless standard error is a terminal.
    bar: ProgressBar,
    /// For a file, unless `--quiet`.
    log: Option<Mutex<Log>>,
}

impl Watch {
    /// Starts a spinner with the message `what`.
    pub(crate) fn new(global: &Global, what: &'static str) -> Watch {
        let bar = super::spinner(global, what);
        let log = (bar.is_hidden() && !global.quiet).then(|| Mutex::new(Log::new(Instant::now())));
        Watch { bar, log }
    }

    /// Removes the bar.
    pub(crate) fn finish(self) {
        self.bar.finish_and_clear();
    }

    fn logged<T>(&self, act: impl FnOnce(&mut Log) -> T) -> Option<T> {
        // Counts of a thread that panicked are still valid for progress.
        let mut log = self.log.as_ref()?.lock().unwrap_or_else(PoisonError::into_inner);
        Some(act(&mut log))
    }
}

impl Progress for Watch {
    fn stage(&self, name: &str, steps: u64) {
        if self.logged(|log| log.stage(name, steps, Instant::now())).is_some() && asked() {
            say!("{}", told(name, None, None));
        }
        if self.bar.is_hidden() {
            return;
        }
        self.bar.reset();
        self.bar.set_message(name.to_owned());
        if steps > 1 {
            self.bar.set_length(steps);
            // The template is a constant: if it does not parse, the plain bar is used.
            if let Ok(style) = ProgressStyle::with_template("{msg} {bar:30} {pos}/{len}, {eta} left") {
                self.bar.set_style(style);
            }
        } else {
            self.bar.set_style(ProgressStyle::default_spinner());
        }
        self.bar.enable_steady_tick(Duration::from_millis(100));
    }

    fn advance(&self, steps: u64) {
        self.bar.inc(steps);
        if let Some(Some(line)) = self.logged(|log| log.advance(steps, Instant::now())) {
            say!("{line}");
        }
    }

    fn interrupted(&self) -> bool {
        stopped()
    }

    fn warn(&self, what: &str) {
        self.bar.suspend(|| warn("", &Warning::new(Code::PartlyKept, what)));
    }
}

/// Variable with which a program that starts this one asks for lines `progress {"stage":…,"percent":…,"left":…}`, the time left in seconds.
const VARIABLE: &str = "TANKCHECK_PROGRESS";
/// Shortest time between two of them.
const TOLD: Duration = Duration::from_millis(250);

/// Whether a program asks.
fn asked() -> bool {
    static ASKED: LazyLock<bool> = LazyLock::new(|| std::env::var_os(VARIABLE).is_some_and(|value| !value.is_empty()));
    *ASKED
}

/// A line for a program.
fn told(stage: &str, percent: Option<f64>, left: Option<f64>) -> String {
    format!("progress {}", serde_json::json!({ "stage": stage, "percent": percent, "left": left }))
}

/// Shortest time between two lines: short stages do not need ten.
const LEAST: Duration = Duration::from_secs(5);
/// Longest time between two lines, while steps advance.
const MOST: Duration = Duration::from_secs(60);

/// Progress of a stage as lines.
struct Log {
    name: String,
    steps: u64,
    done: u64,
    /// Steps done before the stage began (a resumed run); excluded from the pace.
    before: Option<u64>,
    began: Instant,
    /// Time and tenths of the last line.
    last: (Instant, u64),
}

impl Log {
    fn new(now: Instant) -> Log {
        Log { name: String::new(), steps: 0, done: 0, before: None, began: now, last: (now, 0) }
    }

    fn stage(&mut self, name: &str, steps: u64, now: Instant) {
        *self = Log { name: name.to_owned(), steps, ..Log::new(now) };
    }

    /// Counts steps; returns a line when one is due.
    fn advance(&mut self, steps: u64, now: Instant) -> Option<String> {
        self.done += steps;
        // The first count of a resumed run is its earlier steps; that of a new run is zero or one.
        let before = *self.before.get_or_insert(if steps > 1 { steps } else { 0 });
        if self.steps <= 1 || self.done >= self.steps {
            return None;
        }
        let since = now.duration_since(self.last.0);
        let tenths = 10 * self.done / self.steps;
        let early = if asked() { since < TOLD } else { since < LEAST || (tenths <= self.last.1 && since < MOST) };
        if early {
            return None;
        }
        self.last = (now, tenths);
        let seconds = now.duration_since(self.began).as_secs_f64();
        let own = (self.done - before).max(1);
        let left = seconds * (self.steps - self.done) as f64 / own as f64;
        if asked() {
            return Some(told(&self.name, Some(100.0 * self.done as f64 / self.steps as f64), Some(left)));
        }
        Some(format!(
            "{}: {} % ({} of {}), {} so far, about {} left",
            self.name,
            100 * self.done / self.steps,
            self.done,
            self.steps,
            span(seconds),
            span(left)
        ))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_file_gets_a_line_per_tenth_but_not_every_second() {
        let start = Instant::now();
        let after = |s: f64| start + Duration::from_secs_f64(s);
        let mut log = Log::new(start);
        log.stage("time steps", 1000, start);
        // 100 s for 1000 steps: a tenth every ten seconds.
        let lines: Vec<String> = (1..=1000).filter_map(|i| log.advance(1, after(0.1 * f64::from(i)))).collect();
        assert_eq!(lines.len(), 9, "{lines:#?}");
        assert_eq!(lines[0], "time steps: 10 % (100 of 1000), 10 s so far, about 2 min left");
        assert_eq!(lines[8], "time steps: 90 % (900 of 1000), 2 min so far, about 10 s left");
        // Ten seconds in all: a line every five at most.
        log.stage("quick", 1000, start);
        let lines = (1..=1000).filter_map(|i| log.advance(1, after(0.01 * f64::from(i)))).count();
        assert_eq!(lines, 1);
        // A step in forty seconds: a line a minute.
        log.stage("slow", 1000, start);
        let lines = (1..=9).filter_map(|i| log.advance(1, after(40.0 * f64::from(i)))).count();
        assert_eq!(lines, 4);
    }

    #[test]
    fn earlier_steps_of_a_resumed_run_do_not_count_for_its_pace() {
        let start = Instant::now();
        let mut log = Log::new(start);
        log.stage("time steps", 1000, start);
        assert_eq!(log.advance(500, start), None);
        let line = (1..=100).find_map(|i| log.advance(1, start + Duration::from_millis(100 * i)));
        assert_eq!(line.as_deref(), Some("time steps: 55 % (550 of 1000), 5 s so far, about 45 s left"));
    }
}
