//! The two streams of the command line: results on standard output, everything else on standard error.
//! Text of the user is escaped here, see [`files::text`].
//!
//! A result that cannot be written is a failure of the run (exit code 3). A message that cannot be written is not:
//! the run continues with its usual exit code.

use std::fmt::Display;
use std::io::{ErrorKind, Write};

use crate::cli::table::Mark;
use crate::error::Error;
use files::code::Warning;
use files::text;
use results::describe;

/// Writes a result to standard output. A reader that closes early (`| head`) is not a failure.
///
/// Errors: [`Error::Output`] if the text cannot be written, for instance because a device is full.
pub(crate) fn print(text: &str) -> Result<(), Error> {
    print_coloured(&text::printed(text))
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

/// Writes a result in which lines with the sign of a [`Mark`] are coloured, where standard output shows colours.
///
/// Errors: as [`print`].
pub(crate) fn print_marked(text: &str) -> Result<(), Error> {
    let text = text::printed(text);
    if anstream::AutoStream::choice(&std::io::stdout()) == anstream::ColorChoice::Never {
        return print_coloured(&text);
    }
    print_coloured(&painted(&text))
}

/// The lines that begin with a sign in its colour.
fn painted(text: &str) -> String {
    let colour = |line: &str| match line.chars().next()? {
        sign if sign == Mark::Fails.sign() => Some("\u{1b}[31m"),
        sign if sign == Mark::Open.sign() => Some("\u{1b}[33m"),
        _ => None,
    };
    let mut out = String::with_capacity(text.len());
    for line in text.split_inclusive('\n') {
        let bare = line.trim_end_matches('\n');
        match colour(bare) {
            Some(colour) => out.push_str(&format!("{colour}{bare}\u{1b}[0m{}", &line[bare.len()..])),
            None => out.push_str(line),
        }
    }
    out
}

/// Width of the terminal of standard output [characters]; none where it is not one.
pub(crate) fn width() -> Option<usize> {
    let terminal = console::Term::stdout();
    let (_, columns) = terminal.is_term().then(|| terminal.size_checked()).flatten()?;
    Some(usize::from(columns))
}

/// Writes a line to standard error. Failure to write is ignored: it cannot be reported elsewhere.
pub(crate) fn message(text: impl Display) {
    coloured(&text::visible(&text.to_string()));
}

/// Writes a line with escaped user text to standard error, in colour where [`anstream`] allows it.
pub(crate) fn coloured(text: &str) {
    // One write, so that lines of several threads do not mix.
    let line = format!("{}\n", text::without_commands(text));
    let mut messages = anstream::stderr().lock();
    let _ = messages.write_all(line.as_bytes()).and_then(|()| messages.flush());
}

/// Prints the error of a failed run; returns its exit code.
pub(crate) fn report_failure(error: &Error) -> u8 {
    match error {
        // The user's text is already escaped; the remaining escapes are our own colours.
        Error::Files(files::error::Error::Faults(rendered)) => coloured(rendered.trim_end()),
        other => message(other.message()),
    }
    error.exit_code()
}

/// Writes a warning with its code to standard error.
///
/// * `origin`: what it is about ("tanks.csv:3: "), may be empty
pub(crate) fn warn(origin: &str, warning: &Warning) {
    message(format_args!("{}: {}{}", warning.head(), text::line(origin), text::line(warning.text())));
}

/// [`message`] with the arguments of [`format!`].
macro_rules! say {
    ($($text:tt)*) => {
        $crate::cli::terminal::message(format_args!($($text)*))
    };
}
pub(crate) use say;

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn lines_with_a_sign_are_coloured_and_no_others() {
        let text = painted("✗ buckling  1.2\n? pipes\n  hoop ✗\n");
        assert_eq!(text, "\u{1b}[31m✗ buckling  1.2\u{1b}[0m\n\u{1b}[33m? pipes\u{1b}[0m\n  hoop ✗\n");
    }
}
