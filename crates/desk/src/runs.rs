//! The queue of long computations. Each is the program itself with the arguments of a terminal; one computes, the others wait. What a run prints on
//! standard error is kept; lines that begin with [`PROGRESS`] are its progress.

use std::collections::VecDeque;
use std::io::{BufRead, BufReader, Read};
use std::path::PathBuf;
use std::process::{Child, Command, Stdio};
use std::sync::{Arc, Mutex, MutexGuard, PoisonError};
use std::time::Instant;

use serde::{Deserialize, Serialize};
use tokio::sync::watch;

/// Variable that asks the program for lines of progress that a program reads.
pub(crate) const VARIABLE: &str = "TANKCHECK_PROGRESS";
/// Beginning of such a line; JSON follows.
const PROGRESS: &str = "progress ";
/// Most lines of a run that are kept.
const LINES: usize = 400;
/// Longest line that is kept [characters].
const LONGEST: usize = 2_000;
/// Most runs that are listed; of more, ended ones go.
const LISTED: usize = 100;

/// The queue.
#[derive(Clone)]
pub(crate) struct Runs {
    program: PathBuf,
    folder: PathBuf,
    all: Arc<Mutex<Vec<Run>>>,
    changed: watch::Sender<u64>,
}

struct Run {
    id: u64,
    arguments: Vec<String>,
    out: Option<String>,
    state: State,
    code: Option<i32>,
    asked: Instant,
    began: Option<Instant>,
    seconds: f64,
    progress: Progress,
    output: VecDeque<String>,
    /// Number of the process, while it lives.
    process: Option<u32>,
    cancelled: bool,
}

#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize)]
#[serde(rename_all = "lowercase")]
enum State {
    Waiting,
    Running,
    Done,
    Failed,
    Cancelled,
}

/// Where a run is.
#[derive(Clone, Debug, Default, Deserialize, Serialize)]
struct Progress {
    stage: String,
    #[serde(default)]
    percent: Option<f64>,
    #[serde(default)]
    left: Option<f64>,
}

/// A run as the page sees it.
#[derive(Serialize)]
pub(crate) struct Shown {
    id: u64,
    command: String,
    out: Option<String>,
    state: State,
    code: Option<i32>,
    /// Seconds since it was asked for.
    age: f64,
    seconds: f64,
    #[serde(flatten)]
    progress: Progress,
    output: Vec<String>,
}

impl Runs {
    pub(crate) fn new(program: PathBuf, folder: PathBuf) -> Runs {
        Runs { program, folder, all: Arc::default(), changed: watch::Sender::new(0) }
    }

    fn locked(&self) -> MutexGuard<'_, Vec<Run>> {
        // A list whose thread panicked is still a list.
        self.all.lock().unwrap_or_else(PoisonError::into_inner)
    }

    /// Tells of changes.
    pub(crate) fn changes(&self) -> watch::Receiver<u64> {
        self.changed.subscribe()
    }

    fn tell(&self) {
        self.changed.send_modify(|count| *count += 1);
    }

    /// The runs, the newest first.
    pub(crate) fn list(&self) -> Vec<Shown> {
        let shown = |run: &Run| Shown {
            id: run.id,
            command: typed(&run.arguments),
            out: run.out.clone(),
            state: run.state,
            code: run.code,
            age: run.asked.elapsed().as_secs_f64(),
            seconds: run
                .began
                .filter(|_| run.state == State::Running)
                .map_or(run.seconds, |t| t.elapsed().as_secs_f64()),
            progress: run.progress.clone(),
            output: run.output.iter().cloned().collect(),
        };
        self.locked().iter().rev().map(shown).collect()
    }

    /// Whether a run that waits or computes writes into a folder.
    pub(crate) fn writes(&self, out: &str) -> bool {
        let open = |run: &Run| matches!(run.state, State::Waiting | State::Running);
        self.locked().iter().any(|run| open(run) && run.out.as_deref() == Some(out))
    }

    /// Appends a run; returns its id.
    pub(crate) fn add(&self, arguments: Vec<String>, out: Option<String>) -> u64 {
        let mut all = self.locked();
        while all.len() >= LISTED {
            match all.iter().position(|run| !matches!(run.state, State::Waiting | State::Running)) {
                Some(ended) => drop(all.remove(ended)),
                None => break,
            }
        }
        let id = all.last().map_or(1, |run| run.id + 1);
        all.push(Run {
            id,
            arguments,
            out,
            state: State::Waiting,
            code: None,
            asked: Instant::now(),
            began: None,
            seconds: 0.0,
            progress: Progress::default(),
            output: VecDeque::new(),
            process: None,
            cancelled: false,
        });
        drop(all);
        self.next();
        id
    }

    /// Ends a run: one that waits never begins, one that computes keeps what it has, as after Ctrl-C.
    pub(crate) fn cancel(&self, id: u64) -> bool {
        let mut all = self.locked();
        let Some(run) = all.iter_mut().find(|run| run.id == id) else { return false };
        run.cancelled = true;
        match run.state {
            State::Waiting => run.state = State::Cancelled,
            State::Running => interrupt(run.process),
            _ => {}
        }
        drop(all);
        self.tell();
        true
    }

    /// Ends all of them.
    pub(crate) fn close(&self) {
        let ids: Vec<u64> = self.locked().iter().map(|run| run.id).collect();
        for id in ids {
            self.cancel(id);
        }
    }

    /// Begins the first that waits, where none computes.
    fn next(&self) {
        let mut all = self.locked();
        let busy = all.iter().any(|run| run.state == State::Running);
        if let Some(run) = all.iter_mut().find(|run| run.state == State::Waiting).filter(|_| !busy) {
            run.state = State::Running;
            run.began = Some(Instant::now());
            let (id, arguments, own) = (run.id, run.arguments.clone(), self.clone());
            std::thread::spawn(move || own.compute(id, &arguments));
        }
        drop(all);
        self.tell();
    }

    fn compute(&self, id: u64, arguments: &[String]) {
        let mut command = Command::new(&self.program);
        command.args(arguments).current_dir(&self.folder).env(VARIABLE, "lines").env("NO_COLOR", "1");
        command.stdin(Stdio::null()).stdout(Stdio::piped()).stderr(Stdio::piped());
        let ended = match command.spawn() {
            Err(error) => {
                self.change(id, |run| run.output.push_back(format!("the program did not start: {error}")));
                None
            }
            Ok(mut child) => {
                self.change(id, |run| run.process = Some(child.id()));
                self.watch(id, &mut child)
            }
        };
        self.change(id, |run| {
            run.process = None;
            run.code = ended;
            run.seconds = run.began.map_or(0.0, |began| began.elapsed().as_secs_f64());
            run.state = match ended {
                _ if run.cancelled => State::Cancelled,
                // A verdict that fails or is open is a result.
                Some(0 | 1 | 4) => State::Done,
                _ => State::Failed,
            };
        });
        self.next();
    }

    /// Reads what it says until it ends; returns its exit code.
    fn watch(&self, id: u64, child: &mut Child) -> Option<i32> {
        let output = child.stdout.take();
        // What a terminal would show at the end: the last lines of it are kept too.
        let said = std::thread::spawn(move || {
            let mut text = Vec::new();
            let read = output.map(|stream| stream.take(1 << 20).read_to_end(&mut text));
            drop(read);
            String::from_utf8_lossy(&text).into_owned()
        });
        for line in lines(child.stderr.take()) {
            match line.strip_prefix(PROGRESS).and_then(|json| serde_json::from_str(json).ok()) {
                Some(progress) => self.change(id, |run| run.progress = progress),
                None => self.change(id, |run| keep(&mut run.output, line)),
            }
        }
        let said = said.join().unwrap_or_default();
        self.change(id, |run| said.lines().for_each(|line| keep(&mut run.output, line.to_owned())));
        child.wait().ok().and_then(|status| status.code())
    }

    fn change(&self, id: u64, act: impl FnOnce(&mut Run)) {
        if let Some(run) = self.locked().iter_mut().find(|run| run.id == id) {
            act(run);
        }
        self.tell();
    }
}

/// Yields the lines of a stream; bytes that are not UTF-8 are replaced.
fn lines(stream: Option<impl Read>) -> impl Iterator<Item = String> {
    let mut reader = stream.map(BufReader::new);
    std::iter::from_fn(move || {
        let mut bytes = Vec::new();
        match reader.as_mut()?.read_until(b'\n', &mut bytes) {
            Ok(1..) => Some(String::from_utf8_lossy(&bytes).trim_end().to_owned()),
            _ => None,
        }
    })
}

fn keep(output: &mut VecDeque<String>, line: String) {
    if output.len() == LINES {
        output.pop_front();
    }
    output.push_back(line.chars().take(LONGEST).collect());
}

/// Ctrl-C.
#[cfg(unix)]
fn interrupt(process: Option<u32>) {
    let id = process.and_then(|id| i32::try_from(id).ok()).and_then(rustix::process::Pid::from_raw);
    if let Some(id) = id {
        // It may have ended by itself.
        let _ = rustix::process::kill_process(id, rustix::process::Signal::INT);
    }
}

/// Windows cannot send Ctrl-C to one process: the run ends at once, and its folder stays as it was.
#[cfg(not(unix))]
fn interrupt(process: Option<u32>) {
    if let Some(id) = process {
        let _ = Command::new("taskkill").args(["/F", "/PID", &id.to_string()]).status();
    }
}

/// The command as a shell takes it.
pub(crate) fn typed(arguments: &[String]) -> String {
    let plain = |c: char| c.is_ascii_alphanumeric() || "-_./,=:+%@".contains(c);
    let quoted = |text: &String| match text.as_str() {
        text if !text.is_empty() && text.chars().all(plain) => text.to_owned(),
        text => format!("'{}'", text.replace('\'', "'\\''")),
    };
    std::iter::once("tankcheck".to_owned()).chain(arguments.iter().map(quoted)).collect::<Vec<_>>().join(" ")
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_command_is_shown_as_a_shell_takes_it() {
        let typed = |arguments: &[&str]| typed(&arguments.iter().map(|a| (*a).to_owned()).collect::<Vec<_>>());
        assert_eq!(typed(&["compare", "tank.json", "--out", "out/1"]), "tankcheck compare tank.json --out out/1");
        assert_eq!(typed(&["check", "a b's.json", ""]), "tankcheck check 'a b'\\''s.json' ''");
    }

    /// A shell stands for the program; what it waits for is a file that goes.
    #[cfg(unix)]
    #[test]
    fn one_computes_and_the_others_wait() {
        let folder = tempfile::tempdir().unwrap();
        let gate = folder.path().join("gate");
        std::fs::write(&gate, "").unwrap();
        let runs = Runs::new("/bin/sh".into(), folder.path().to_owned());
        let shell = |script: &str| vec!["-c".to_owned(), script.to_owned()];
        let begun = "echo 'progress {\"stage\":\"steps\",\"percent\":40}' >&2";
        let slow = runs.add(shell(&format!("{begun}; while [ -e gate ]; do sleep 0.01; done")), Some("a".into()));
        let never = runs.add(shell("touch never"), Some("b".into()));
        let quick = runs.add(shell("echo said >&2; echo shown; exit 4"), None);
        let wait = |what: &dyn Fn(&[Shown]) -> bool| {
            let began = Instant::now();
            while !what(&runs.list()) {
                assert!(began.elapsed().as_secs() < 120, "nothing happens");
                std::thread::sleep(std::time::Duration::from_millis(5));
            }
        };
        // The newest stands first.
        wait(&|list| list[2].progress.percent == Some(40.0));
        let states = |list: &[Shown]| list.iter().map(|run| run.state).collect::<Vec<_>>();
        assert_eq!(states(&runs.list()), [State::Waiting, State::Waiting, State::Running]);
        assert!(runs.writes("a") && runs.writes("b") && !runs.writes("c"));
        assert!(runs.cancel(never) && !runs.cancel(99));
        std::fs::remove_file(&gate).unwrap();
        wait(&|list| list[0].state == State::Done);
        let list = runs.list();
        assert_eq!(states(&list), [State::Done, State::Cancelled, State::Done]);
        assert_eq!((list[0].id, list[0].code, list[2].id, list[2].code), (quick, Some(4), slow, Some(0)));
        assert_eq!(list[0].output, ["said", "shown"]);
        assert!(!runs.writes("a") && !folder.path().join("never").exists());
    }
}
