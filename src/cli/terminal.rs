//! The two streams of the command line: results on standard output, everything else on standard error.
//!
//! The user's text on its way to either of them is made visible here, see [`files::text`].
//!
//! A result that cannot be written is a failure of the run (exit code 3). A message that cannot be written is not: the run
//! goes on, and its exit code still says how it ended.

use std::fmt::Display;
use std::io::{ErrorKind, Write};

use crate::error::Error;
use files::text;
use results::describe;

/// Writes a result to standard output. A reader that has seen enough (`| head`) is no failure.
///
/// Errors: [`Error::Output`] if the text cannot be written, for instance because a device is full.
pub(crate) fn print(text: &str) -> Result<(), Error> {
    print_coloured(&text::visible(text))
}

/// Writes a result without text of the user's to standard output; see [`print`].
///
/// Errors: as [`print`].
pub(crate) fn print_coloured(text: &str) -> Result<(), Error> {
    let mut out = std::io::stdout().lock();
    match out.write_all(text.as_bytes()).and_then(|()| out.flush()) {
        Err(error) if error.kind() != ErrorKind::BrokenPipe => Err(Error::output(describe(&error))),
        _ => Ok(()),
    }
}

/// Writes a line to standard error. Failure to write is ignored: there is no other place to report it.
pub(crate) fn message(text: impl Display) {
    coloured(&text::visible(&text.to_string()));
}

/// Writes a line in which the user's text has been made visible to standard error, with our own colours only where
/// [`anstream`] finds them wanted.
pub(crate) fn coloured(text: &str) {
    // One piece, so that lines of several threads do not mix.
    let line = format!("{text}\n");
    let mut messages = anstream::stderr().lock();
    let _ = messages.write_all(line.as_bytes()).and_then(|()| messages.flush());
}

/// [`message`] with the arguments of [`format!`].
macro_rules! say {
    ($($text:tt)*) => {
        $crate::cli::terminal::message(format_args!($($text)*))
    };
}
pub(crate) use say;
