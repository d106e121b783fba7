//! Failures of the engines.

use fem::analysis::checkpoint::CheckpointError;
use fem::linalg::LinalgError;

/// Failure of the engine.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
pub enum FeError {
    /// The case has no ground motion.
    #[error("no ground motion: give a record with --quake")]
    NoRecord,
    /// Something the linear engine does not model.
    #[error("{0}")]
    Unsupported(String),
    /// An option out of range.
    #[error("option {option}: found {found}, allowed {allowed}")]
    Option {
        /// Name.
        option: String,
        /// Found.
        found: String,
        /// Allowed.
        allowed: String,
    },
    /// A matrix that must be positive definite is not.
    #[error("{matrix} is not positive definite ({cause})")]
    NotPositiveDefinite {
        /// Which matrix.
        matrix: String,
        /// Likely cause.
        cause: String,
    },
    /// The eigenvalue solver failed.
    #[error("eigenvalue solver: {0}")]
    Eigen(String),
    /// A run that takes more memory than allowed.
    #[error("the {run} needs about {needed_mib} MiB, more than the allowed {allowed_mib} MiB\n  help: {help}")]
    Memory {
        /// Which run, with its size.
        run: String,
        /// Estimate [MiB].
        needed_mib: u64,
        /// Limit [MiB].
        allowed_mib: u64,
        /// Remedy, with a size that fits.
        help: String,
    },
    /// A run that takes more steps, samples or time than allowed.
    #[error("{what}; allowed {allowed}\n  help: {help}")]
    TooLong {
        /// The quantity and its number.
        what: String,
        /// The limit.
        allowed: String,
        /// Remedy, with a size that fits.
        help: String,
    },
    /// An analysis failed.
    #[error("{0}")]
    Analysis(String),
    /// A checkpoint that cannot be written, read or used.
    #[error("{0}{help}", help = way_out(.0))]
    Checkpoint(#[from] CheckpointError),
    /// The user stopped the run before it had results.
    #[error("interrupted during {stage}; there are no results yet")]
    Interrupted {
        /// Stage of the run.
        stage: String,
    },
    /// The response grows without bound or is not a number.
    #[error("the response is not finite at t = {time:.4} s ({cause})")]
    NotFinite {
        /// Time [s].
        time: f64,
        /// Likely cause.
        cause: String,
    },
}

impl FeError {
    /// An option out of range.
    pub(crate) fn option(option: impl Into<String>, found: impl Into<String>, allowed: impl Into<String>) -> FeError {
        FeError::Option { option: option.into(), found: found.into(), allowed: allowed.into() }
    }
}

/// Help for an unusable checkpoint.
fn way_out(error: &CheckpointError) -> &'static str {
    match error {
        CheckpointError::Unusable { .. } => {
            "\n  help: omit --resume to start over and overwrite it, or give the checkpoint of the same tank file, record, \
             options and version"
        }
        _ => "",
    }
}

/// An error of a model or an analysis as one of the engine.
pub(crate) fn failed(error: impl std::fmt::Display) -> FeError {
    FeError::Analysis(error.to_string())
}

/// Turns a failed factorisation into an error of the engine.
pub(crate) fn failure(matrix: &'static str) -> impl Fn(LinalgError) -> FeError {
    move |error| match error {
        LinalgError::NotPositiveDefinite { .. } => {
            FeError::NotPositiveDefinite { matrix: matrix.into(), cause: error.to_string() }
        }
        other => FeError::Eigen(format!("{matrix}: {other}")),
    }
}
