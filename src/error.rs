//! The error of the whole program and its exit codes.

use std::path::PathBuf;

use crate::fe::FeError;

/// Exit code 0: computed, every applicable check holds (or `diff` found no change).
pub const EXIT_OK: u8 = 0;
/// Exit code 1: computed, but a check fails (or `diff` found a change).
pub const EXIT_CHECK_FAILED: u8 = 1;
/// Exit code 2: bad input or usage.
pub const EXIT_INPUT: u8 = 2;
/// Exit code 3: the computation failed, or its results are incomplete: it was interrupted, or the tank collapsed.
pub const EXIT_COMPUTATION: u8 = 3;
/// Exit code 130: ended by Ctrl-C, nothing is written (128 + SIGINT, as shells have it).
pub const EXIT_INTERRUPTED: u8 = 130;

/// Any failure the command line reports.
#[derive(Debug, thiserror::Error)]
pub enum Error {
    /// Faults in input files; already rendered as diagnostics (file, line, JSON path, found, allowed), all at once.
    #[error("{0}")]
    Input(String),
    /// A file that cannot be read or written.
    #[error("{path}: {what}", path = path.display())]
    File {
        /// The file.
        path: PathBuf,
        /// What went wrong and what would be right.
        what: String,
    },
    /// A code procedure failed.
    #[error("{procedure}: {source}")]
    Code {
        /// Id of the procedure.
        procedure: String,
        /// Cause.
        source: codes::procedure::CodeError,
    },
    /// The finite-element computation failed.
    #[error("finite elements: {0}")]
    Fe(#[from] FeError),
    /// A benchmark of the verification manual failed to run.
    #[error("verification, {topic}: {what}")]
    Verification {
        /// Topic.
        topic: String,
        /// Cause.
        what: String,
    },
    /// The report could not be rendered.
    #[error("report: {0}")]
    Report(String),
}

impl Error {
    /// Exit code of this failure.
    pub fn exit_code(&self) -> u8 {
        match self {
            Error::Input(_) | Error::File { .. } => EXIT_INPUT,
            Error::Fe(
                FeError::Option { .. }
                | FeError::NoRecord
                | FeError::Memory { .. }
                | FeError::Unsupported(_)
                | FeError::Checkpoint(_),
            ) => EXIT_INPUT,
            Error::Code { .. } | Error::Fe(_) | Error::Report(_) | Error::Verification { .. } => EXIT_COMPUTATION,
        }
    }
}
