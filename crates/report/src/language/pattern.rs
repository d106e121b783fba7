//! A sentence with holes, and how a text matches it.

use super::decimal::commas;
use super::text::{is_neutral, sentences};

/// A piece of an entry.
#[derive(Clone, Debug, PartialEq)]
pub(super) enum Piece {
    Text(String),
    /// A hole with its index.
    Hole(usize, Kind),
}

#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) enum Kind {
    Words,
    Value,
    Same,
    Word,
}

/// A sentence with holes.
#[derive(Debug)]
pub(super) struct Pattern {
    pub(super) english: Vec<Piece>,
    pub(super) german: Vec<Piece>,
    /// Letters outside the holes.
    pub(super) weight: usize,
    /// The longest text outside the holes.
    pub(super) longest: String,
}

impl Pattern {
    /// Calls `accept` with the texts of the holes for each way in which `text` matches, until it returns true.
    pub(super) fn matched(&self, text: &str, accept: &mut dyn FnMut(&[&str]) -> bool) {
        let literal: usize = self
            .english
            .iter()
            .map(|p| match p {
                Piece::Text(t) => t.len(),
                Piece::Hole(..) => 1,
            })
            .sum();
        if literal > text.len() {
            return;
        }
        if let Some(Piece::Text(last)) = self.english.last()
            && !text.ends_with(last.as_str())
        {
            return;
        }
        let mut holes = Vec::new();
        rest(&self.english, text, &mut holes, accept);
    }

    /// The text of a hole that stays: only values behind an equals sign get their decimal comma.
    pub(super) fn same(&self, index: usize, text: &str) -> String {
        let hole = |p: &Piece| matches!(p, Piece::Hole(i, _) if *i == index);
        let at = self.english.iter().position(hole).and_then(|p| p.checked_sub(1));
        let before = at.and_then(|p| self.english.get(p));
        if matches!(before, Some(Piece::Text(t)) if t.ends_with("= ")) {
            return commas(text);
        }
        match text.rsplit_once("= ") {
            Some((left, right)) => format!("{left}= {}", commas(right)),
            None => text.to_owned(),
        }
    }

    pub(super) fn filled(&self, holes: &[String]) -> String {
        self.german
            .iter()
            .map(|p| match p {
                Piece::Text(text) => text.as_str(),
                Piece::Hole(i, _) => holes.get(*i).map_or("", String::as_str),
            })
            .collect()
    }
}

/// Matches `pieces` against `text`; holes are as short as they can be first.
fn rest<'a>(
    pieces: &[Piece],
    text: &'a str,
    holes: &mut Vec<&'a str>,
    accept: &mut dyn FnMut(&[&str]) -> bool,
) -> bool {
    match pieces {
        [] => text.is_empty() && accept(holes),
        [Piece::Text(literal), others @ ..] => match text.strip_prefix(literal.as_str()) {
            Some(after) => rest(others, after, holes, accept),
            None => false,
        },
        [Piece::Hole(_, kind)] => {
            if !fits(text, *kind) {
                return false;
            }
            holes.push(text);
            let accepted = accept(holes);
            holes.pop();
            accepted
        }
        [Piece::Hole(_, kind), others @ ..] => {
            let Some(Piece::Text(next)) = others.first() else { return false };
            let mut from = 0;
            while let Some(at) = text[from..].find(next.as_str()).map(|p| p + from) {
                if at > 0 && fits(&text[..at], *kind) {
                    holes.push(&text[..at]);
                    let accepted = rest(others, &text[at..], holes, accept);
                    holes.pop();
                    if accepted {
                        return true;
                    }
                }
                from = at + next.chars().next().map_or(1, char::len_utf8);
                if from >= text.len() {
                    break;
                }
            }
            false
        }
    }
}

/// Whether a text may fill a hole: words within one sentence and with their brackets, or a value.
fn fits(text: &str, kind: Kind) -> bool {
    let count = |c: char| text.matches(c).count();
    match kind {
        Kind::Same => !text.is_empty() && sentences(text).len() == 1 && !text.contains("; "),
        Kind::Word => !text.contains(' '),
        Kind::Words => {
            !text.trim().is_empty() && count('(') == count(')') && count('`') % 2 == 0 && sentences(text).len() == 1
        }
        Kind::Value => text.chars().any(|c| c.is_ascii_digit() || c == '∞') && is_neutral(text) && text.len() < 60,
    }
}

pub(super) fn kinds(pieces: &[Piece]) -> impl Iterator<Item = Kind> {
    pieces.iter().filter_map(|p| match p {
        Piece::Hole(_, kind) => Some(*kind),
        Piece::Text(_) => None,
    })
}

/// A line of the catalogue as pieces.
pub(super) fn pieces(line: &str) -> Vec<Piece> {
    let mut out = Vec::new();
    let mut rest = line;
    let mut count = 0;
    while let Some((before, inside, after)) = hole(rest) {
        if !before.is_empty() {
            out.push(Piece::Text(before.into()));
        }
        let (index, kind) = match inside {
            "" => (count, Kind::Words),
            "#" => (count, Kind::Value),
            "=" => (count, Kind::Same),
            "w" => (count, Kind::Word),
            number => (number.parse::<usize>().unwrap_or(1).saturating_sub(1), Kind::Words),
        };
        out.push(Piece::Hole(index, kind));
        count += 1;
        rest = after;
    }
    if !rest.is_empty() {
        out.push(Piece::Text(rest.into()));
    }
    out
}

/// The next hole: text before, its inside, text behind.
fn hole(text: &str) -> Option<(&str, &str, &str)> {
    for (open, _) in text.match_indices('{') {
        let Some(close) = text[open..].find('}').map(|c| c + open) else { continue };
        let inside = &text[open + 1..close];
        if matches!(inside, "" | "#" | "=" | "w") || (inside.len() == 1 && inside.as_bytes()[0].is_ascii_digit()) {
            return Some((&text[..open], inside, &text[close + 1..]));
        }
    }
    None
}
