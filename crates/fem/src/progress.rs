//! Progress of a long analysis, and its interruption.

/// Listener of a long analysis.
pub trait Progress: Sync {
    /// A stage begins that takes `steps` steps.
    fn stage(&self, name: &str, steps: u64);
    /// So many steps of the stage are done.
    fn advance(&self, steps: u64);
    /// True if the user wants to stop: the analysis returns its results so far, marked incomplete.
    fn interrupted(&self) -> bool;
    /// Something went wrong that the analysis can do without: a sentence without its full stop.
    fn warn(&self, _what: &str) {}
}

/// No output, never interrupted.
#[derive(Clone, Copy, Debug, Default)]
pub struct Silent;

impl Progress for Silent {
    fn stage(&self, _name: &str, _steps: u64) {}
    fn advance(&self, _steps: u64) {}
    fn interrupted(&self) -> bool {
        false
    }
}

/// Passes on only the interruption: for parallel runs, which the caller counts as a whole.
pub struct Quiet<'a>(pub &'a dyn Progress);

impl Progress for Quiet<'_> {
    fn stage(&self, _name: &str, _steps: u64) {}
    fn advance(&self, _steps: u64) {}
    fn interrupted(&self) -> bool {
        self.0.interrupted()
    }
    fn warn(&self, what: &str) {
        self.0.warn(what);
    }
}
