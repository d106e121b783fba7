//! Sentences with holes, and how a text matches them.
//!
//! An entry is two lines, English and German; blank lines and lines that begin with `#` separate. Holes:
//!
//! | English | matches | German |
//! |---|---|---|
//! | `{}` | any words, translated in their turn | `{}`, or `{2}` for the second |
//! | `{#}` | a value: a number, with its unit if it has one | likewise |
//! | `{=}` | anything, unchanged | likewise |
//! | `{w}` | one word, unchanged | likewise |
//!
//! A text is looked up as a whole, then by the entry with the most letters whose holes fit, then sentence by sentence. A
//! first letter in upper case matches an entry in lower case. Texts without words (numbers, units, symbols, names) need
//! no entry.

use std::cell::RefCell;
use std::collections::{BTreeSet, HashMap};

use super::decimal::commas;
use super::made::is_made;
use super::pattern::{Kind, Pattern, Piece, kinds, pieces};
use super::text::{bound, forms, is_neutral, sentences};

/// Weight below which an entry joins parts (`{}, {}`) instead of saying something, and the longest text for which that
/// is tried, in bytes.
const JOINT: usize = 4 * 4;
const JOINED: usize = 800;

/// Entries by their English.
#[derive(Debug)]
pub(super) struct Catalogue {
    exact: HashMap<String, String>,
    patterns: Vec<Pattern>,
    /// Patterns by their first letter, each list with those that begin with a hole; these alone.
    first: HashMap<char, Vec<usize>>,
    any: Vec<usize>,
    /// What is wrong in the files.
    pub(super) faults: Vec<String>,
}

impl Catalogue {
    /// Reads the files, each with its name.
    pub(super) fn new(files: &[(&str, &str)]) -> Catalogue {
        let mut catalogue = Catalogue {
            exact: HashMap::new(),
            patterns: Vec::new(),
            first: HashMap::new(),
            any: Vec::new(),
            faults: Vec::new(),
        };
        for (name, text) in files {
            catalogue.read(name, text);
        }
        catalogue.patterns.sort_by_key(|p| std::cmp::Reverse(p.weight));
        let start = |p: &Pattern| match p.english.first() {
            Some(Piece::Text(text)) => text.chars().next(),
            _ => None,
        };
        let starts: Vec<Option<char>> = catalogue.patterns.iter().map(start).collect();
        let with = |wanted: Option<char>| {
            let fits = |s: &&(usize, &Option<char>)| s.1.is_none() || *s.1 == wanted;
            starts.iter().enumerate().filter(|s| fits(&s)).map(|(i, _)| i).collect::<Vec<_>>()
        };
        for letter in starts.iter().flatten() {
            catalogue.first.entry(*letter).or_insert_with(|| with(Some(*letter)));
        }
        catalogue.any = with(None);
        catalogue
    }

    fn read(&mut self, name: &str, text: &str) {
        let mut english: Option<(usize, &str)> = None;
        let lines = text.lines().enumerate().filter(|(_, l)| !l.starts_with('#'));
        for (number, line) in lines {
            let line = line.trim();
            match (english.take(), line) {
                (None, "") => {}
                (None, line) => english = Some((number + 1, line)),
                (Some((at, key)), "") => self.faults.push(format!("{name}:{at}: `{key}` without its German")),
                (Some((at, key)), line) => self.add(name, at, key, line),
            }
        }
        if let Some((at, key)) = english {
            self.faults.push(format!("{name}:{at}: `{key}` without its German"));
        }
    }

    fn add(&mut self, name: &str, at: usize, english: &str, german: &str) {
        let (from, to) = (pieces(english), pieces(german));
        let holes = |pieces: &[Piece]| {
            let numbers = pieces.iter().filter_map(|p| match p {
                Piece::Hole(i, _) => Some(*i),
                Piece::Text(_) => None,
            });
            numbers.collect::<BTreeSet<usize>>()
        };
        let (filled, used) = (holes(&from), holes(&to));
        if used.iter().any(|i| !filled.contains(i)) {
            self.faults.push(format!("{name}:{at}: `{german}` has a hole that `{english}` lacks"));
            return;
        }
        if filled.is_empty() {
            if let Some(other) = self.exact.insert(english.into(), german.into())
                && other != german
            {
                self.faults.push(format!("{name}:{at}: `{english}` is `{other}` and `{german}`"));
            }
            return;
        }
        let weight = from
            .iter()
            .map(|p| match p {
                Piece::Text(text) => 4 * text.chars().filter(|c| !c.is_whitespace()).count(),
                Piece::Hole(_, Kind::Value) => 1,
                Piece::Hole(..) => 0,
            })
            .sum();
        let texts = from.iter().filter_map(|p| match p {
            Piece::Text(text) => Some(text.clone()),
            Piece::Hole(..) => None,
        });
        let longest = texts.max_by_key(String::len).unwrap_or_default();
        self.patterns.push(Pattern { english: from, german: to, weight, longest });
    }

    /// The German of a text; parts that the catalogue lacks stay, and are added to `missing`.
    pub(super) fn translate(&self, text: &str, missing: &mut Vec<String>) -> String {
        let plain = text.replace('\u{a0}', " ");
        let seen = Seen::default();
        // All of it, or as far as it goes with what stops it.
        let german = self.found(&plain, &seen).unwrap_or_else(|| self.partial(&plain, &seen, missing));
        bound(&german)
    }

    /// The German of a text, if the catalogue has all of it.
    pub(super) fn complete(&self, text: &str) -> Option<String> {
        self.found(text, &Seen::default())
    }

    /// The German of a reference to a document, word by word behind its commas; numbers stay.
    pub(super) fn reference(&self, text: &str, missing: &mut Vec<String>) -> String {
        let inner = text.strip_prefix('(').and_then(|t| t.strip_suffix(')'));
        if let Some(inner) = inner.filter(|i| !i.contains(['(', ')'])) {
            return format!("({})", self.reference(inner, missing));
        }
        let part = |part: &str, missing: &mut Vec<String>| {
            if let Some(german) = self.whole(part) {
                return german;
            }
            let words: Vec<&str> = part.split(' ').collect();
            let word = |(i, word): (usize, &&str)| match self.whole(word) {
                Some(german) => german,
                // A value, not the number of a clause.
                None if words.get(i + 1) == Some(&"%")
                    || (i > 0 && matches!(words[i - 1], "<" | ">" | "≤" | "≥" | "=")) =>
                {
                    commas(word)
                }
                None => (*word).to_owned(),
            };
            let german = words.iter().enumerate().map(word).collect::<Vec<_>>().join(" ");
            if german == part && !is_neutral(part) {
                return self.partial(part, &Seen::default(), missing);
            }
            german
        };
        match self.whole(text) {
            Some(german) => german,
            // More than a reference.
            None if text.contains('(') => self.partial(text, &Seen::default(), missing),
            None => text.split(", ").map(|p| part(p, missing)).collect::<Vec<_>>().join(", "),
        }
    }

    /// The German of a text, all of it.
    fn found(&self, text: &str, seen: &Seen) -> Option<String> {
        if is_made(text) {
            return Some(text.to_owned());
        }
        if let Some(german) = self.whole(text) {
            return Some(german);
        }
        if is_neutral(text) {
            return Some(commas(text));
        }
        if let Some(known) = seen.borrow().get(text) {
            return known.clone();
        }
        let found = self.composed(text, seen);
        seen.borrow_mut().insert(text.to_owned(), found.clone());
        found
    }

    /// The German of a text of several parts.
    fn composed(&self, text: &str, seen: &Seen) -> Option<String> {
        let fill = |pattern: &Pattern, holes: &[&str]| {
            let mut filled = Vec::with_capacity(holes.len());
            for (hole, kind) in holes.iter().zip(kinds(&pattern.english)) {
                filled.push(match kind {
                    Kind::Same | Kind::Word => pattern.same(filled.len(), hole),
                    Kind::Value => commas(hole),
                    // Holes are shorter than the text: this ends.
                    Kind::Words => self.found(hole, seen)?,
                });
            }
            Some(filled)
        };
        let sentences = sentences(text);
        for (text, case) in forms(text) {
            for pattern in self.candidates(&text) {
                if pattern.weight < JOINT && (sentences.len() > 1 || text.len() > JOINED) {
                    break;
                }
                let mut german = None;
                pattern.matched(&text, &mut |holes| {
                    german = fill(pattern, holes).map(|filled| pattern.filled(&filled));
                    german.is_some()
                });
                if let Some(german) = german {
                    return Some(case.of(&german));
                }
            }
        }
        if sentences.len() > 1 {
            let german: Option<Vec<String>> = sentences.iter().map(|s| self.found(s, seen)).collect();
            return german.map(|g| g.join(" "));
        }
        None
    }

    /// The German of what is known, with what is not as it stands.
    fn partial(&self, text: &str, seen: &Seen, missing: &mut Vec<String>) -> String {
        if let Some(german) = self.found(text, seen) {
            return german;
        }
        let sentences = sentences(text);
        if sentences.len() > 1 {
            let german: Vec<String> = sentences.iter().map(|s| self.partial(s, seen, missing)).collect();
            return german.join(" ");
        }
        for (text, case) in forms(text) {
            // An entry of few letters fits too much to be meant.
            for pattern in self.candidates(&text).filter(|p| p.weight >= 4 * 6) {
                let mut best: Option<Vec<String>> = None;
                pattern.matched(&text, &mut |holes| {
                    best = Some(holes.iter().map(|h| (*h).to_owned()).collect());
                    true
                });
                let Some(holes) = best else { continue };
                let mut filled = Vec::new();
                for (hole, kind) in holes.iter().zip(kinds(&pattern.english)) {
                    filled.push(match kind {
                        Kind::Same | Kind::Word => pattern.same(filled.len(), hole),
                        Kind::Value => commas(hole),
                        Kind::Words => self.partial(hole, seen, missing),
                    });
                }
                let german = pattern.filled(&filled);
                return case.of(&german);
            }
        }
        missing.push(text.to_owned());
        commas(text)
    }

    /// The entry without holes.
    fn whole(&self, text: &str) -> Option<String> {
        forms(text).find_map(|(form, case)| Some(case.of(self.exact.get(form.as_ref())?)))
    }

    /// The entries with holes that may match, those of the most letters first.
    fn candidates<'a>(&'a self, text: &'a str) -> impl Iterator<Item = &'a Pattern> {
        let first = text.chars().next().and_then(|c| self.first.get(&c));
        let all = first.unwrap_or(&self.any).iter().map(|&i| &self.patterns[i]);
        all.filter(|p| text.contains(p.longest.as_str()))
    }
}

/// What is known of the parts of a text.
type Seen = RefCell<HashMap<String, Option<String>>>;
