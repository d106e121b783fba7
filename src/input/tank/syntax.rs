//! Text → tree of values, each with its place and path.
//!
//! JSON with comments (`//`, `/* */`) and trailing commas; everything else follows JSON, and a key may occur
//! only once in an object. Nesting is limited, so that no file can exhaust the stack.

use files::code::Code;
use std::borrow::Cow;
use std::collections::BTreeMap;
use std::ops::Range;

use jsonc_parser::common::Ranged;
use jsonc_parser::tokens::Token;
use jsonc_parser::{CollectOptions, ParseOptions, Scanner, ScannerOptions, ast, parse_to_ast};

use crate::input::diagnostic::{Fault, Faults, Source};

/// Deepest nesting of objects and lists.
const MAX_DEPTH: usize = 32;
/// Longest path that is stored in full [bytes]: every value stores its path, so the memory for long keys above many values
/// grows with the square of the file.
const MAX_PATH: usize = 240;
/// Kept part of a longer path: bytes at its beginning and at its end.
const PATH_ENDS: (usize, usize) = (80, 140);

/// A value with its place.
#[derive(Clone, Debug, PartialEq)]
pub(in crate::input) struct Node {
    /// Bytes of the file.
    pub span: Range<usize>,
    /// Path (`tank.courses[0].thickness`), empty for the whole document.
    pub path: String,
    /// The value.
    pub kind: Kind,
}

/// A JSON value.
#[derive(Clone, Debug, PartialEq)]
pub(in crate::input) enum Kind {
    Null,
    Bool(bool),
    /// A number as written.
    Number(String),
    Text(String),
    List(Vec<Node>),
    Object(Vec<Member>),
}

/// A key and its value.
#[derive(Clone, Debug, PartialEq)]
pub(in crate::input) struct Member {
    pub key: String,
    pub key_span: Range<usize>,
    pub value: Node,
}

impl Node {
    /// The kind of value, in words with its article.
    pub(crate) fn noun(&self) -> &'static str {
        match self.kind {
            Kind::Null => "null",
            Kind::Bool(_) => "true or false",
            Kind::Number(_) => "a number",
            Kind::Text(_) => "a text",
            Kind::List(_) => "a list",
            Kind::Object(_) => "an object",
        }
    }

    /// The value as written, for messages: scalars in full, the others by name.
    pub(crate) fn shown(&self) -> String {
        match &self.kind {
            Kind::Bool(value) => value.to_string(),
            Kind::Number(text) => text.clone(),
            Kind::Text(text) => format!("\"{text}\""),
            Kind::Null | Kind::List(_) | Kind::Object(_) => self.noun().into(),
        }
    }
}

/// Path of a member of the object at `path`; the middle of a path of more than 240 bytes is left out.
pub(in crate::input) fn join(path: &str, key: &str) -> String {
    let key = shortened(key);
    let plain = !key.is_empty() && key.chars().all(|c| c.is_ascii_alphanumeric() || c == '_' || c == '-');
    let joined = match (plain, path.is_empty()) {
        (true, true) => return key.into_owned(),
        (true, false) => format!("{path}.{key}"),
        (false, _) => format!("{path}[{key:?}]"),
    };
    shortened(&joined).into_owned()
}

/// The text, or its two ends if it is longer than a path may be.
fn shortened(text: &str) -> Cow<'_, str> {
    if text.len() <= MAX_PATH {
        return text.into();
    }
    let mut ends = (PATH_ENDS.0, text.len() - PATH_ENDS.1);
    while !text.is_char_boundary(ends.0) {
        ends.0 -= 1;
    }
    while !text.is_char_boundary(ends.1) {
        ends.1 += 1;
    }
    format!("{}…{}", &text[..ends.0], &text[ends.1..]).into()
}

/// Reads the text. A syntax error ends the reading, so there is only one. Duplicate keys are added to `faults`; the first
/// one counts.
pub(in crate::input) fn parse(source: &Source, faults: &mut Faults) -> Option<Node> {
    let text = source.text.as_str();
    if text.trim().is_empty() {
        faults.push(
            Fault::new(Code::EmptyFile, "the file is empty")
                .allowed("an object { … } with at least name, tank, liquid and materials")
                .help("`tankcheck init` writes a commented file to start from"),
        );
        return None;
    }
    if let Err(fault) = check_tokens(text) {
        faults.push(fault);
        return None;
    }
    let options = ParseOptions {
        allow_comments: true,
        allow_trailing_commas: true,
        allow_loose_object_property_names: false,
        allow_missing_commas: false,
        allow_single_quoted_strings: false,
        allow_hexadecimal_numbers: false,
        allow_unary_plus_numbers: false,
    };
    match parse_to_ast(text, &CollectOptions::default(), &options) {
        Ok(result) => match result.value {
            Some(value) => Some(build(value, String::new(), &line_ends(text), faults)),
            None => {
                faults.push(Fault::new(Code::EmptyFile, "the file contains only comments").allowed("an object { … }"));
                None
            }
        },
        Err(error) => {
            let span = error.range().start..error.range().end;
            faults.push(explain(&error.kind().to_string(), span, text));
            None
        }
    }
}

/// Errors that the parser accepts or reports unclearly: deep nesting, missing commas in lists, bare words, and numbers
/// without a separator after them.
pub(super) fn check_tokens(text: &str) -> Result<(), Fault> {
    let mut scanner = Scanner::new(
        text,
        &ScannerOptions {
            allow_single_quoted_strings: false,
            allow_hexadecimal_numbers: false,
            allow_unary_plus_numbers: false,
        },
    );
    // Containers that are open: whether each is an object.
    let mut open: Vec<bool> = Vec::new();
    let mut last = Last::Separator;
    loop {
        let token = match scanner.scan() {
            Ok(Some(token)) => token,
            Ok(None) => return Ok(()),
            Err(error) => {
                let span = error.range().start..error.range().end;
                return Err(explain(&error.kind().to_string(), span, text));
            }
        };
        let span = scanner.token_start()..scanner.token_end();
        let (inside, in_object) = (!open.is_empty(), open.last() == Some(&true));
        let begins_value = match token {
            Token::CommentLine(_) | Token::CommentBlock(_) => continue,
            Token::Word(_) => return Err(word(span, text)),
            Token::OpenBrace | Token::OpenBracket => {
                open.push(token == Token::OpenBrace);
                if open.len() > MAX_DEPTH {
                    return Err(Fault::new(Code::TooLarge, "nested too deeply")
                        .at(span)
                        .found(format!("{} levels", open.len()))
                        .allowed(format!("at most {MAX_DEPTH} levels of objects and lists")));
                }
                true
            }
            Token::CloseBrace | Token::CloseBracket => {
                open.pop();
                false
            }
            Token::String(_) | Token::Boolean(_) | Token::Number(_) | Token::Null => true,
            Token::Comma | Token::Colon => false,
        };
        let missing = |what: &str, end: usize| Fault::new(Code::Syntax, format!("a {what} is missing")).at(end..end);
        match last {
            Last::Key(end) if token != Token::Colon => {
                return Err(missing("colon", end).allowed("a colon between a key and its value"));
            }
            Last::Value { end, number: true } if begins_value && end == span.start => {
                return Err(malformed_number(end, text));
            }
            Last::Value { end, .. } if begins_value && inside => {
                return Err(missing("comma", end).allowed("a comma between two values"));
            }
            _ => {}
        }
        last = match (&token, last) {
            (Token::String(_), Last::Separator) if in_object => Last::Key(span.end),
            (Token::OpenBrace | Token::OpenBracket | Token::Comma, _) => Last::Separator,
            (Token::Colon, _) => Last::Colon,
            (Token::Number(_), _) => Last::Value { end: span.end, number: true },
            _ => Last::Value { end: span.end, number: false },
        };
    }
}

/// The last token.
#[derive(Clone, Copy)]
enum Last {
    /// An opening brace or bracket, a comma, or the beginning of the file.
    Separator,
    /// A key that ends there.
    Key(usize),
    Colon,
    /// A value that ends there.
    Value {
        end: usize,
        number: bool,
    },
}

/// The run of characters around a place that looks like one word.
fn run_around(at: usize, text: &str) -> Range<usize> {
    let stops = |c: char| c.is_whitespace() || "{}[],:\"".contains(c);
    let start = text[..at].rfind(stops).map_or(0, |i| i + text[i..].chars().next().map_or(1, char::len_utf8));
    let end = text[at..].find(stops).map_or(text.len(), |i| at + i);
    start..end
}

fn malformed_number(at: usize, text: &str) -> Fault {
    let span = run_around(at, text);
    Fault::new(Code::NotANumber, "this is not a number")
        .found(&text[span.clone()])
        .at(span)
        .allowed("a number such as 0.02 or 1.5e-3; put a value with a unit in quotes: \"1.83 m\"")
}

fn word(span: Range<usize>, text: &str) -> Fault {
    let run = run_around(span.start, text);
    let found = &text[run.clone()];
    let fault = Fault::new(Code::Syntax, "text without quotes").at(run.clone()).found(found);
    let bare = found.trim_start_matches(['+', '-']).to_lowercase();
    if ["nan", "inf", "infinity"].contains(&bare.as_str()) {
        return Fault::new(Code::NotFinite, "not a finite number")
            .at(run.clone())
            .found(found)
            .allowed("finite numbers");
    }
    if ["true", "false", "null"].contains(&bare.as_str()) {
        return fault.allowed("lower case").help(format!("did you mean `{bare}`?"));
    }
    // `1.83m` or `1.83 m`: a value with its unit.
    let in_quotes = |number: &str, unit: &str, span: Range<usize>| {
        Fault::new(Code::Syntax, "a value with a unit must be in quotes")
            .found(&text[span.clone()])
            .at(span)
            .help(format!("write \"{number} {unit}\""))
    };
    let digits = found.find(|c: char| !c.is_ascii_digit() && !"+-.".contains(c));
    if let Some((number, unit)) = digits.filter(|d| *d > 0).and_then(|d| found.split_at_checked(d)) {
        return in_quotes(number, unit, run);
    }
    let before = text[..run.start].trim_end_matches([' ', '\t']);
    if before.ends_with(|c: char| c.is_ascii_digit()) {
        let number = run_around(before.len() - 1, text);
        return in_quotes(&text[number.clone()], found, number.start..run.end);
    }
    fault.allowed("texts and keys in double quotes")
}

/// The parser's error as a fault.
fn explain(kind: &str, span: Range<usize>, text: &str) -> Fault {
    let at = span.start.min(text.len());
    let rest = &text[at..];
    let ahead = rest.chars().next();
    if ahead.is_some_and(char::is_alphabetic) && kind.starts_with("Unexpected token") {
        return word(span, text);
    }
    if ahead.is_some_and(|c| "+-.0123456789".contains(c)) || kind.contains("digit") || kind.contains("Unary") {
        let run = run_around(at, text);
        let bare = text[run.clone()].trim_start_matches(['+', '-']).to_lowercase();
        if bare.starts_with("inf") || bare.starts_with("nan") {
            return word(run, text);
        }
        return malformed_number(at, text);
    }
    let fault = |message: &str| Fault::new(Code::Syntax, message).at(span.clone());
    if kind.starts_with("Unterminated") || (rest.is_empty() && kind.starts_with("Expected")) {
        let what = if kind.contains("object") {
            "this { is never closed by }"
        } else if kind.contains("array") {
            "this [ is never closed by ]"
        } else if kind.contains("comment") {
            "this /* is never closed by */"
        } else if kind.contains("string") {
            "this text is never closed by a quote"
        } else {
            "the file ends in the middle of a value"
        };
        return Fault::new(Code::CutOff, what)
            .at(at..(at + ahead.map_or(0, char::len_utf8)))
            .help("the file may have been cut off");
    }
    match kind {
        k if k.contains("Single-quoted") => fault("single quotes").allowed("texts and keys in double quotes"),
        k if k.contains("more than one") => fault("text after the end of the document").allowed("one object { … }"),
        other => {
            let mut words = other.to_lowercase();
            if let Some(found) = ahead {
                words.push_str(&format!(" before `{}`", found.escape_debug()));
            }
            fault(&words)
        }
    }
}

/// Bytes at which lines end, ascending.
fn line_ends(text: &str) -> Vec<usize> {
    text.match_indices('\n').map(|(at, _)| at).collect()
}

fn build(value: ast::Value<'_>, path: String, line_ends: &[usize], faults: &mut Faults) -> Node {
    let range = value.range();
    let kind = match value {
        ast::Value::NullKeyword(_) => Kind::Null,
        ast::Value::BooleanLit(literal) => Kind::Bool(literal.value),
        ast::Value::NumberLit(literal) => Kind::Number(literal.value.into()),
        ast::Value::StringLit(literal) => Kind::Text(literal.value.into_owned()),
        ast::Value::Array(array) => Kind::List(
            (array.elements.into_iter().enumerate())
                .map(|(i, element)| {
                    let path = shortened(&format!("{path}[{i}]")).into_owned();
                    build(element, path, line_ends, faults)
                })
                .collect(),
        ),
        ast::Value::Object(object) => {
            let mut seen: BTreeMap<String, usize> = BTreeMap::new();
            let mut members = Vec::with_capacity(object.properties.len());
            for property in object.properties {
                let key_span = property.name.range().start..property.name.range().end;
                let key = property.name.into_string();
                let path = join(&path, &key);
                if let Some(first) = seen.get(&key) {
                    let line = line_ends.partition_point(|end| end < first) + 1;
                    faults.push(
                        Fault::new(Code::DuplicateKey, format!("duplicate key `{key}`"))
                            .at(key_span)
                            .path(path)
                            .allowed("each key once in an object")
                            .help(format!("remove one; the first is in line {line}")),
                    );
                    continue;
                }
                seen.insert(key.clone(), key_span.start);
                let value = build(property.value, path, line_ends, faults);
                members.push(Member { key, key_span, value });
            }
            Kind::Object(members)
        }
    };
    Node { span: range.start..range.end, path, kind }
}
