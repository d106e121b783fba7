//! Failures of benchmarks and of the manual's files.

use files::code::Code;
use files::error::EXIT_COMPUTATION;

use crate::row::Row;

/// Failure of a model that should have a solution.
pub type Failure = Box<dyn std::error::Error + Send + Sync>;

/// The rows of a part, or why there are none.
pub type Answer<T = Vec<Row>> = Result<T, Failure>;

/// A failure of a benchmark or of the manual's files.
#[derive(Debug, thiserror::Error)]
pub enum Error {
    /// A benchmark without rows.
    #[error("verification, {benchmark}: {what}")]
    Benchmark {
        /// Id of the benchmark.
        benchmark: String,
        /// Cause.
        what: String,
    },
    /// A file of the manual that cannot be read, drawn or written.
    #[error(transparent)]
    Files(#[from] files::error::Error),
}

impl Error {
    /// Its kind; none where every fault of a file has its own.
    pub fn code(&self) -> Option<Code> {
        match self {
            Error::Benchmark { .. } => Some(Code::Benchmark),
            Error::Files(error) => error.code(),
        }
    }

    /// Exit code of this failure.
    pub fn exit_code(&self) -> u8 {
        match self {
            Error::Benchmark { .. } => EXIT_COMPUTATION,
            Error::Files(error) => error.exit_code(),
        }
    }
}
