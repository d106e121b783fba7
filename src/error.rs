//! The error of the whole program.

use engines::FeError;
use files::code::Code;
pub use files::error::{
    EXIT_CHECK_FAILED, EXIT_COMPUTATION, EXIT_INPUT, EXIT_INTERRUPTED, EXIT_NOT_CHECKED, EXIT_OK, describe,
};

/// Any failure the command line reports.
#[derive(Debug, thiserror::Error)]
pub enum Error {
    /// Input, results or their files are at fault.
    #[error(transparent)]
    Files(#[from] files::error::Error),
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
    /// The base of the tank has no equilibrium.
    #[error("base of the tank: {0}")]
    Base(#[from] base::BaseError),
}

impl Error {
    /// A fault of the command line or between files: its kind, what is wrong, and a line `help: …`.
    pub fn input(code: Code, text: String) -> Error {
        Error::Files(files::error::Error::Input(code, text))
    }

    /// An option with a value that it does not take.
    pub fn value(text: impl Into<String>) -> Error {
        Error::input(Code::OptionValue, text.into())
    }

    /// Options, or an option and a file, that do not go together.
    pub fn conflict(text: impl Into<String>) -> Error {
        Error::input(Code::OptionConflict, text.into())
    }

    /// Input that is missing.
    pub fn missing(text: impl Into<String>) -> Error {
        Error::input(Code::MissingInput, text.into())
    }

    /// Its kind; none where every fault of a file has its own.
    pub fn code(&self) -> Option<Code> {
        Some(match self {
            Error::Files(error) => return error.code(),
            Error::Code { .. } => Code::Procedure,
            Error::Base(_) => Code::Base,
            Error::Fe(error) => match error {
                FeError::NoRecord => Code::MissingInput,
                FeError::Unsupported(_) => Code::Unsupported,
                FeError::Option { .. } => Code::OptionValue,
                FeError::NotPositiveDefinite { .. } => Code::NotPositiveDefinite,
                FeError::Eigen(_) => Code::Eigenvalues,
                FeError::Memory { .. } => Code::Memory,
                FeError::TooLong { .. } => Code::TooLong,
                FeError::Analysis(_) => Code::Analysis,
                FeError::Checkpoint(_) => Code::Checkpoint,
                FeError::Interrupted { .. } => Code::Interrupted,
                FeError::NotFinite { .. } => Code::ResultNotFinite,
            },
        })
    }

    /// The whole message: `error[T0102]: what is wrong`, and its help.
    pub fn message(&self) -> String {
        match (self, self.code()) {
            (_, Some(code)) => format!("{}: {}", code.head(), self.to_string().trim_end()),
            // Every fault has its own head.
            (_, None) => self.to_string().trim_end().to_owned(),
        }
    }

    /// Standard output that cannot be written.
    pub fn output(text: String) -> Error {
        Error::Files(files::error::Error::Output(text))
    }

    /// A report that cannot be rendered.
    pub fn report(text: String) -> Error {
        Error::Files(files::error::Error::Report(text))
    }

    /// Exit code of this failure.
    pub fn exit_code(&self) -> u8 {
        match self {
            Error::Files(error) => error.exit_code(),
            Error::Fe(
                FeError::Option { .. }
                | FeError::NoRecord
                | FeError::Memory { .. }
                | FeError::TooLong { .. }
                | FeError::Unsupported(_)
                | FeError::Checkpoint(_),
            ) => EXIT_INPUT,
            Error::Code { .. } | Error::Fe(_) | Error::Base(_) => EXIT_COMPUTATION,
        }
    }
}
