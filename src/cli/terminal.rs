//! The two streams of the command line: results on standard output, everything else on standard error.
//! Text of the user is escaped here, see [`files::text`].
//!
//! A result that cannot be written is a failure of the run (exit code 3). A message that cannot be written is not:
//! the run continues with its usual exit code.

use std::fmt::Display;
use std::io::{ErrorKind, Write};

use crate::error::Error;
use files::code::Warning;
use files::text;
use results::describe;

/// Writes a result to standard output. A reader that closes early (`| head`) is not a failure.
///
/// Errors: [`Error::Output`] if the text cannot be written, for instance because a device is full.
pub(crate) fn print(text: &str) -> Result<(), Error> {
    print_coloured(&text::visible(text))
}

/// Writes a result that does not contain text of the user to standard output; see [`print`].
///
/// Errors: as [`print`].
pub(crate) fn print_coloured(text: &str) -> Result<(), Error> {
    let mut out = std::io::stdout().lock();
    match out.write_all(text.as_bytes()).and_then(|()| out.flush()) {
        Err(error) if error.kind() != ErrorKind::BrokenPipe => Err(Error::output(describe(&error))),
        _ => Ok(()),
    }
}

/// Writes a line to standard error. Failure to write is ignored: it cannot be reported elsewhere.
pub(crate) fn message(text: impl Display) {
    coloured(&text::visible(&text.to_string()));
}

/// Writes a line with escaped user text to standard error, in colour where [`anstream`] allows it.
pub(crate) fn coloured(text: &str) {
    // One write, so that lines of several threads do not mix.
    let line = format!("{text}\n");
    let mut messages = anstream::stderr().lock();
    let _ = messages.write_all(line.as_bytes()).and_then(|()| messages.flush());
}

/// Writes a warning with its code to standard error.
///
/// * `origin`: what it is about ("tanks.csv:3: "), may be empty
pub(crate) fn warn(origin: &str, warning: &Warning) {
    message(format_args!(
        "{}: {}{}",
        warning.head(),
        text::line(origin),
        text::line(warning.text())
    ));
}

/// [`message`] with the arguments of [`format!`].
macro_rules! say {
    ($($text:tt)*) => {
        $crate::cli::terminal::message(format_args!($($text)*))
    };
}
pub(crate) use say;
