//! Long runs: progress with the time left on standard error, and Ctrl-C.
//!
//! The first Ctrl-C asks the analysis to stop: it returns what it has, marked incomplete. The second ends the process
//! at once and removes what is half-written.

use std::sync::atomic::{AtomicBool, Ordering};
use std::time::Duration;

use fem::progress::Progress;
use indicatif::{ProgressBar, ProgressStyle};

use crate::cli::Global;
use crate::error::EXIT_INTERRUPTED;
use crate::pipeline;

/// Set by Ctrl-C.
static STOP: AtomicBool = AtomicBool::new(false);

/// What a second Ctrl-C, or the first one where nothing can be kept, does.
fn abort() -> ! {
    pipeline::discard_unfinished();
    std::process::exit(i32::from(EXIT_INTERRUPTED));
}

/// Hears Ctrl-C from here on. Where the analysis can stop half-way (`graceful`) the first one asks it to; else it ends the
/// process.
pub fn listen(global: &Global, graceful: bool) {
    let quiet = global.quiet;
    // A handler that is already set (a second run in one process) does the same.
    let _ = ctrlc::set_handler(move || {
        if !graceful || STOP.swap(true, Ordering::SeqCst) {
            abort();
        }
        if !quiet {
            anstream::eprintln!("interrupted: finishing what is computed (Ctrl-C again to drop it)");
        }
    });
}

/// A bar on standard error, invisible unless a person watches a terminal, that also knows of Ctrl-C.
pub struct Watch {
    bar: ProgressBar,
}

impl Watch {
    /// Begins with a spinner that says `what`.
    pub fn new(global: &Global, what: &'static str) -> Watch {
        Watch {
            bar: super::spinner(global, what),
        }
    }

    /// Removes the bar.
    pub fn finish(self) {
        self.bar.finish_and_clear();
    }
}

impl Progress for Watch {
    fn stage(&self, name: &str, steps: u64) {
        if self.bar.is_hidden() {
            return;
        }
        self.bar.reset();
        self.bar.set_message(name.to_owned());
        if steps > 1 {
            self.bar.set_length(steps);
            // The template is a constant: if it does not parse, the plain bar serves.
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
    }

    fn interrupted(&self) -> bool {
        STOP.load(Ordering::Relaxed)
    }
}
