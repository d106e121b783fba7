//! Errors of files, each with one message: the file, the found and the expected value.

use std::path::{Path, PathBuf};

use crate::code::Code;
use crate::text;

/// Exit code 0: computed, everything that the deciding codes require was checked and holds (or `diff` found no change).
pub const EXIT_OK: u8 = 0;
/// Exit code 1: computed, but a check fails (or `diff` found a change).
pub const EXIT_CHECK_FAILED: u8 = 1;
/// Exit code 2: bad input or usage.
pub const EXIT_INPUT: u8 = 2;
/// Exit code 3: the computation failed, its results could not be written, or they are incomplete: it was interrupted, or the
/// tank collapsed.
pub const EXIT_COMPUTATION: u8 = 3;
/// Exit code 4: computed, no check fails, but something that the deciding codes require was not checked, or nothing was.
pub const EXIT_NOT_CHECKED: u8 = 4;
/// Exit code 130: ended by Ctrl-C without results (128 + SIGINT, as in shells).
pub const EXIT_INTERRUPTED: u8 = 130;

/// A failure of reading or writing.
#[derive(Debug, thiserror::Error)]
pub enum Error {
    /// A fault of the command line or between files: its kind, what is wrong, and a line `help: …`.
    #[error("{1}")]
    Input(Code, String),
    /// Faults of an input file, rendered as diagnostics (file, line, JSON path, found, expected), all together;
    /// coloured if standard error is, with the user's text escaped.
    #[error("{0}")]
    Faults(String),
    /// A file that cannot be read or written.
    #[error("{path}: {what}", path = text::line(&path.to_string_lossy()), what = text::line(what))]
    File {
        /// Kind.
        code: Code,
        /// The file.
        path: PathBuf,
        /// Cause and expected value.
        what: String,
    },
    /// A file or folder that this run must not change, with a help.
    #[error(
        "{path}: {what}\n  help: {help}",
        path = text::line(&path.to_string_lossy()),
        what = text::line(what),
        help = text::line(help)
    )]
    Taken {
        /// The file or folder.
        path: PathBuf,
        /// Cause.
        what: String,
        /// Imperative help.
        help: String,
    },
    /// Results that could not be written.
    #[error(
        "{path}: the results cannot be written: {what}",
        path = text::line(&path.to_string_lossy()),
        what = text::line(what)
    )]
    Unwritten {
        /// The file or folder.
        path: PathBuf,
        /// Cause.
        what: String,
    },
    /// A result that cannot be written to standard output.
    #[error("cannot write to standard output: {0}")]
    Output(String),
    /// A result that is not a finite number.
    #[error("the computation gave {value} for {quantity}")]
    NotFinite {
        /// The quantity and the method that computed it.
        quantity: String,
        /// NaN or an infinity.
        value: f64,
    },
    /// The report could not be rendered.
    #[error("report: {0}")]
    Report(String),
}

impl Error {
    /// A file that cannot be read.
    pub fn unreadable(path: &Path, error: &std::io::Error) -> Error {
        Error::File { code: Code::FileUnreadable, path: path.into(), what: describe(error) }
    }

    /// Its kind; none for [`Error::Faults`], where every fault has its own.
    pub fn code(&self) -> Option<Code> {
        match self {
            Error::Input(code, _) | Error::File { code, .. } => Some(*code),
            Error::Faults(_) => None,
            Error::Taken { .. } => Some(Code::FileTaken),
            Error::Unwritten { .. } => Some(Code::NotWritten),
            Error::Output(_) => Some(Code::Output),
            Error::NotFinite { .. } => Some(Code::ResultNotFinite),
            Error::Report(_) => Some(Code::Report),
        }
    }

    /// Exit code of this failure.
    pub fn exit_code(&self) -> u8 {
        match self {
            Error::Input(..) | Error::Faults(_) | Error::File { .. } | Error::Taken { .. } => EXIT_INPUT,
            Error::Unwritten { .. } | Error::Output(_) | Error::NotFinite { .. } | Error::Report(_) => EXIT_COMPUTATION,
        }
    }
}

/// An input/output error in words.
pub fn describe(error: &std::io::Error) -> String {
    use std::io::ErrorKind;
    match error.kind() {
        ErrorKind::NotFound => "no such file".into(),
        ErrorKind::PermissionDenied => "permission denied".into(),
        ErrorKind::IsADirectory => "is a folder, expected a file".into(),
        ErrorKind::ReadOnlyFilesystem => "the file system is read-only".into(),
        ErrorKind::StorageFull => "no space left on the device".into(),
        _ => error.to_string(),
    }
}
