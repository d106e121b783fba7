//! Faults in an input file, collected and shown all at once. A [`Fault`] has a [`Code`], a message, a place (bytes of the file,
//! path in the document), the found and the expected value, and a help. [`Faults`] renders them as rustc does, with
//! the place in the file underlined:
//!
//! ```text
//! error[T0214]: a mass where a length belongs
//!  --> tank.json:4:27
//!   |
//! 4 |   "tank": { "radius": "1.83 kg",
//!   |                       ^^^^^^^^^ found "1.83 kg"
//!   |
//!   = path: tank.radius
//!   = expected: a length such as "1.83 m" (units: mm, cm, m, in, ft), greater than 0
//! ```
//!
//! Record files use the same with [`Source::line_span`], where the place is a line instead of a JSON value.

use std::borrow::Cow;
use std::collections::BTreeSet;
use std::ops::Range;
use std::path::Path;

use annotate_snippets::{AnnotationKind, Group, Level, Origin, Renderer, Snippet};

use files::code::Code;
use files::error::Error;
use files::text;

/// Longest message part shown [characters].
const SHOWN_TEXT: usize = 400;
/// Largest number of faults shown.
const SHOWN_FAULTS: usize = 50;
/// Largest number of codes whose explanation is named.
const EXPLAINED: usize = 3;
/// Largest number of faults kept: the first ones of the file; the others are only counted.
const KEPT_FAULTS: usize = 1000;
/// Longest line passed to the renderer as a whole [bytes]; of a longer line only a piece around the place.
const LONGEST_LINE: usize = 1000;
/// Piece of a long line: bytes before the place, and of place and rest together.
const PIECE: (usize, usize) = (60, 240);

/// One fault.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Fault {
    /// Kind.
    pub code: Code,
    /// Message, one line ("unknown key `radios`").
    pub message: String,
    /// Bytes of the file to underline; `None` for a fault without a place.
    pub span: Option<Range<usize>>,
    /// Path in the document (`tank.courses[0].thickness`), or empty.
    pub path: Box<str>,
    /// Found text, as written; may be empty.
    pub found: Box<str>,
    /// Expected values; may be empty.
    pub allowed: Box<str>,
    /// How to fix it, if known.
    pub help: Option<Box<str>>,
}

impl Fault {
    /// A fault of a kind, with only a message.
    pub fn new(code: Code, message: impl Into<String>) -> Fault {
        Fault {
            code,
            message: message.into(),
            span: None,
            path: Box::default(),
            found: Box::default(),
            allowed: Box::default(),
            help: None,
        }
    }

    /// Sets the place: bytes of the file.
    pub fn at(mut self, span: Range<usize>) -> Fault {
        self.span = Some(span);
        self
    }

    /// Sets the place: path in the document.
    pub fn path(mut self, path: impl Into<String>) -> Fault {
        self.path = path.into().into();
        self
    }

    /// Sets the found text.
    pub fn found(mut self, found: impl Into<String>) -> Fault {
        self.found = found.into().into();
        self
    }

    /// Sets the expected values.
    pub fn allowed(mut self, allowed: impl Into<String>) -> Fault {
        self.allowed = allowed.into().into();
        self
    }

    /// Sets the help.
    pub fn help(mut self, help: impl Into<String>) -> Fault {
        self.help = Some(help.into().into());
        self
    }
}

impl Fault {
    /// Sort key: the first byte of its place.
    fn place(&self) -> usize {
        self.span.as_ref().map_or(usize::MAX, |s| s.start)
    }
}

/// Beginning of helps that suggest a word.
const SUGGESTION: &str = "did you mean ";

/// An input file and its text.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Source {
    /// Path as the user gave it, for messages (`<stdin>` for standard input).
    pub name: String,
    /// Text.
    pub text: String,
    /// Bytes at which lines begin.
    starts: Vec<usize>,
}

impl Source {
    /// A file of this name and text.
    pub fn new(name: impl Into<String>, text: impl Into<String>) -> Source {
        let text = text.into();
        let starts = std::iter::once(0).chain(text.match_indices('\n').map(|(at, _)| at + 1));
        Source { name: name.into(), starts: starts.collect(), text }
    }

    /// A file at this path with this text; `-` is standard input.
    pub fn at(path: &Path, text: impl Into<String>) -> Source {
        let name = if path == Path::new("-") { "<stdin>".into() } else { path.display().to_string() };
        Source::new(name, text)
    }

    /// Bytes of a line (counted from 1) without its line break; the end of the file beyond the last line.
    pub fn line_span(&self, line: usize) -> Range<usize> {
        let end = self.text.len();
        let start = line.checked_sub(1).and_then(|i| self.starts.get(i)).map_or(end, |s| *s);
        let next = self.starts.get(line).map_or(end, |s| *s);
        start..start + self.text[start..next.max(start)].trim_end_matches(['\n', '\r']).len()
    }

    /// Line and column (in characters) of a byte, both counted from 1.
    pub fn line_column(&self, byte: usize) -> (usize, usize) {
        let byte = floor(&self.text, byte);
        let line = self.starts.partition_point(|start| *start <= byte);
        let start = self.starts[line - 1];
        (line, self.text[start..byte].chars().count() + 1)
    }
}

/// The nearest character boundary at or before a byte.
fn floor(text: &str, byte: usize) -> usize {
    let mut byte = byte.min(text.len());
    while !text.is_char_boundary(byte) {
        byte -= 1;
    }
    byte
}

/// The faults of one file.
///
/// Memory and time are bounded by the number of faults, not by its square: of more than a thousand only the first
/// ones of the file are kept; all are counted.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Faults {
    list: Vec<Fault>,
    count: usize,
    /// Helps that suggest a word, of all faults.
    suggested: BTreeSet<String>,
}

impl Faults {
    /// An empty list.
    pub fn new() -> Faults {
        Faults::default()
    }

    /// Adds a fault.
    pub fn push(&mut self, fault: Fault) {
        if let Some(help) = &fault.help
            && help.starts_with(SUGGESTION)
            && help.len() < SHOWN_TEXT
        {
            self.suggested.insert(help.to_string());
        }
        self.count += 1;
        self.list.push(fault);
        if self.list.len() >= 2 * KEPT_FAULTS {
            self.list.sort_by_key(Fault::place);
            self.list.truncate(KEPT_FAULTS);
        }
    }

    /// Gives the fault pushed last another help, if it is of this kind at this place.
    pub fn help_last(&mut self, code: Code, path: &str, help: &str) {
        if let Some(fault) = self.list.last_mut()
            && fault.code == code
            && &*fault.path == path
        {
            fault.help = Some(help.into());
        }
    }

    /// Whether the list is empty.
    pub fn is_empty(&self) -> bool {
        self.count == 0
    }

    /// Number of faults.
    pub fn count(&self) -> usize {
        self.count
    }

    /// The faults; of more than a thousand the first ones of the file.
    pub fn list(&self) -> &[Fault] {
        &self.list
    }

    /// Notes that a fault asks for this key in place of another, as "did you mean" does: it is then not missing as well.
    pub fn asks_for(&mut self, key: &str) {
        self.suggested.insert(format!("{SUGGESTION}`{key}`?"));
    }

    /// Whether a fault has exactly this help, which begins with "did you mean".
    pub fn suggest(&self, help: &str) -> bool {
        self.suggested.contains(help)
    }

    /// The message for people: every fault (at most the first ones), then their number. Coloured if `styled`; else
    /// without control characters except line breaks.
    pub fn render(&self, source: &Source, styled: bool) -> String {
        let renderer = if styled { Renderer::styled() } else { Renderer::plain() };
        let mut ordered: Vec<&Fault> = self.list.iter().collect();
        ordered.sort_by_key(|f| f.place());
        let mut out = String::new();
        for fault in ordered.iter().take(SHOWN_FAULTS) {
            out.push_str(&render_one(fault, source, &renderer));
            out.push_str("\n\n");
        }
        let name = text::line(&source.name);
        let count = match self.count {
            1 => format!("1 fault in {name}"),
            n if n > SHOWN_FAULTS => {
                format!("{n} faults in {name}, the first {SHOWN_FAULTS} shown, {} more", n - SHOWN_FAULTS)
            }
            n => format!("{n} faults in {name}"),
        };
        out.push_str(
            &renderer
                .render(&[Group::with_title(Level::ERROR.primary_title(format!("{count}; nothing was computed")))]),
        );
        out.push('\n');
        let codes: BTreeSet<Code> = ordered.iter().take(SHOWN_FAULTS).map(|fault| fault.code).collect();
        for code in codes.iter().take(EXPLAINED) {
            out.push_str(&format!("  help: `tankcheck explain {code}` ({})\n", code.title()));
        }
        out
    }

    /// The faults as the program's error, coloured if standard error shows colours.
    pub fn into_error(self, source: &Source) -> Error {
        let styled = anstream::AutoStream::choice(&std::io::stderr()) != anstream::ColorChoice::Never;
        Error::Faults(self.render(source, styled))
    }
}

impl From<Fault> for Faults {
    fn from(fault: Fault) -> Faults {
        let mut faults = Faults::new();
        faults.push(fault);
        faults
    }
}

fn render_one(fault: &Fault, source: &Source, renderer: &Renderer) -> String {
    let mut group = Group::with_title(Level::ERROR.primary_title(one_line(&fault.message)).id(fault.code.id()));
    let label = match &*fault.found {
        "" => String::new(),
        found => format!("found {}", one_line(found)),
    };
    let name = text::line(&source.name);
    // Only the line of the place is passed; the renderer cuts it to the width of a terminal.
    if let Some(span) = &fault.span {
        let window = Window::around(source, span);
        let mut annotation = AnnotationKind::Primary.span(window.span.clone());
        if !label.is_empty() {
            annotation = annotation.label(label);
        }
        let snippet = Snippet::source(window.text).line_start(window.line).annotation(annotation);
        group = match window.column {
            None => group.element(snippet.path(name)),
            Some(column) => group.element(Origin::path(name).line(window.line).char_column(column)).element(snippet),
        };
    } else {
        group = group.element(Origin::path(name));
        if !label.is_empty() {
            group = group.element(Level::NOTE.no_name().message(label));
        }
    }
    let mut remark = |name: &'static str, text: &str| {
        if !text.is_empty() {
            let message = format!("{name}: {}", one_line(text));
            group = std::mem::replace(&mut group, Group::with_level(Level::ERROR))
                .element(Level::NOTE.no_name().message(message));
        }
    };
    remark("path", &fault.path);
    remark("expected", &fault.allowed);
    remark("help", fault.help.as_deref().unwrap_or_default());
    let rendered = renderer.render(&[group]);
    if !rendered.contains(NAMELESS) {
        return rendered;
    }
    // The renderer leaves a line for the name of a second file between the place and a piece of its line.
    let lines = rendered.lines().filter(|l| anstream::adapter::strip_str(l).to_string().trim() != NAMELESS);
    lines.collect::<Vec<_>>().join("\n")
}

/// Text of the renderer before the name of a further file.
const NAMELESS: &str = ":::";

/// User text on one line, without control characters, cut to [`SHOWN_TEXT`].
fn one_line(text: &str) -> String {
    let mut line: String =
        text.chars().take(SHOWN_TEXT).map(|c| if matches!(c, ' ' | '\t' | '\n' | '\r') { ' ' } else { c }).collect();
    if text.chars().nth(SHOWN_TEXT).is_some() {
        line.push('…');
    }
    text::line(&line).into_owned()
}

/// The line in which a span begins, or a piece of it.
struct Window<'a> {
    text: Cow<'a, str>,
    line: usize,
    /// Bytes of `text`.
    span: Range<usize>,
    /// Column of the place in its line, in characters from 1, if `text` is only a piece of the line.
    column: Option<usize>,
}

impl<'a> Window<'a> {
    fn around(source: &'a Source, span: &Range<usize>) -> Window<'a> {
        let text = source.text.as_str();
        let start = floor(text, span.start);
        let line_start = text[..start].rfind('\n').map_or(0, |i| i + 1);
        let line_end = text[start..].find('\n').map_or(text.len(), |i| start + i);
        let line_end = line_start + text[line_start..line_end].trim_end_matches('\r').len();
        let line_end = line_end.max(start);
        let end = floor(text, span.end).clamp(start, line_end);
        let (line, column) = source.line_column(start);
        let whole = &text[line_start..line_end];
        if whole.len() <= LONGEST_LINE && !whole.chars().any(text::hostile) {
            return Window { text: whole.into(), line, span: start - line_start..end - line_start, column: None };
        }
        let (from, to) = match whole.len() <= LONGEST_LINE {
            true => (line_start, line_end),
            false => {
                (floor(text, start.saturating_sub(PIECE.0)).max(line_start), floor(text, start + PIECE.1).min(line_end))
            }
        };
        let end = end.min(to);
        let mut shown = String::new();
        if from > line_start {
            shown.push('…');
        }
        shown.push_str(&text::visible(&text[from..start]));
        let first = shown.len();
        shown.push_str(&text::visible(&text[start..end]));
        let last = shown.len();
        shown.push_str(&text::visible(&text[end..to]));
        if to < line_end {
            shown.push('…');
        }
        Window { text: shown.into(), line, span: first..last, column: Some(column) }
    }
}

#[cfg(test)]
mod tests;
