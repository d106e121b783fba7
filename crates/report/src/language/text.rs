//! Words, sentences and first letters of a text.

use std::borrow::Cow;
use std::collections::HashSet;
use std::sync::LazyLock;

use tank::units::UNITS;

/// What becomes of the first letter of the German.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) enum Case {
    Same,
    Upper,
    Lower,
}

impl Case {
    pub(super) fn of(self, german: &str) -> String {
        match self {
            Case::Same => german.to_owned(),
            Case::Upper => crate::words::capital(german),
            Case::Lower => {
                let mut chars = german.chars();
                let first = chars.next().map(|c| c.to_lowercase().collect::<String>());
                first.unwrap_or_default() + chars.as_str()
            }
        }
    }
}

/// Words that begin an English sentence and whose German is not a noun.
const PARTICLES: [&str; 14] =
    ["the", "a", "an", "on", "without", "with", "at", "no", "it", "in", "one", "of", "under", "from"];

/// The text as it stands; with its first letter in lower case, or in upper case.
pub(super) fn forms(text: &str) -> impl Iterator<Item = (Cow<'_, str>, Case)> {
    let mut chars = text.chars();
    let first = chars.next().unwrap_or_default();
    let changed = |letters: String, case| (Cow::Owned(letters + &text[first.len_utf8()..]), case);
    let other = if first.is_uppercase() && !chars.next().is_some_and(char::is_uppercase) {
        Some(changed(first.to_lowercase().collect(), Case::Upper))
    } else if first.is_lowercase() {
        let particle = PARTICLES.contains(&text.split(' ').next().unwrap_or_default());
        let case = if particle { Case::Lower } else { Case::Same };
        Some(changed(first.to_uppercase().collect(), case))
    } else {
        None
    };
    std::iter::once((Cow::Borrowed(text), Case::Same)).chain(other)
}

/// Abbreviations that do not end a sentence.
const ABBREVIATIONS: [&str; 12] =
    ["eq.", "Eq.", "fig.", "Fig.", "no.", "e.g.", "i.e.", "vs.", "al.", "rev.", "ed.", "ch."];

/// A text as sentences.
pub(super) fn sentences(text: &str) -> Vec<&str> {
    let mut out = Vec::new();
    let mut start = 0;
    for (at, _) in text.match_indices(". ") {
        let after = text[at + 2..].chars().next();
        let begins = after.is_some_and(|c| c.is_uppercase() || c.is_ascii_digit() || c == '`' || c == '√');
        let word = text[start..=at].rsplit([' ', '(']).next().unwrap_or_default();
        let code = text[start..at].matches('`').count() % 2 == 1;
        let initial = word.chars().count() == 2 && word.starts_with(char::is_uppercase);
        if begins && !code && !initial && !ABBREVIATIONS.contains(&word) {
            out.push(&text[start..=at]);
            start = at + 2;
        }
    }
    if start < text.len() {
        out.push(&text[start..]);
    }
    out
}

/// Words that are the same in both languages beside names of units.
const SAME: [&str; 24] = [
    "Housner", "Manos", "Clough", "Rotter", "Veletsos", "Yang", "Tang", "Wozniak", "Mitchell", "Haroun", "El",
    "Centro", "Rayleigh", "min", "max", "sin", "cos", "tan", "tanh", "cosh", "sinh", "exp", "ln", "Kármán",
];

/// Words of texts without words: these, and symbols of units.
static NEUTRAL: LazyLock<HashSet<&'static str>> = LazyLock::new(|| {
    let units = UNITS.iter().flat_map(|u| u.symbol.split(['·', '/']));
    SAME.into_iter().chain(units).collect()
});

/// Whether a text has no words: numbers, units, symbols, abbreviations in capitals, code.
pub(super) fn is_neutral(text: &str) -> bool {
    let mut code = false;
    let mut word = String::new();
    // A letter, digit or underscore next to a word makes a symbol of it: `S235`, `T_c1`.
    let mut symbol = false;
    let plain = |word: &str, symbol: bool| {
        symbol || word.chars().count() < 2 || word.chars().all(|c| !c.is_lowercase()) || NEUTRAL.contains(word)
    };
    let mut last = ' ';
    let mut chars = text.chars().chain(" ".chars()).peekable();
    while let Some(c) = chars.next() {
        if c == '`' {
            code = !code;
        }
        // A point within a word makes a path of it: `tank.radius`.
        let point = c == '.' && last.is_alphanumeric() && chars.peek().is_some_and(|n| n.is_alphabetic());
        last = c;
        if code {
            continue;
        }
        if c.is_alphabetic() && !is_sign(c) {
            word.push(c);
        } else if c.is_ascii_digit() || c == '_' || point || is_sign(c) {
            symbol = true;
        } else {
            if !plain(&word, symbol) {
                return false;
            }
            word.clear();
            symbol = false;
        }
    }
    true
}

/// Letters that stand in symbols, not in words.
fn is_sign(c: char) -> bool {
    matches!(c, 'Α'..='ω' | '′' | '″' | '²' | '³' | '₀'..='₉')
}

/// With no-break spaces between numbers and units.
pub(super) fn bound(text: &str) -> String {
    let mut out = String::with_capacity(text.len());
    let mut rest = text;
    while let Some(at) = rest.find(' ') {
        let (before, after) = (&rest[..at], &rest[at + 1..]);
        out.push_str(before);
        let number =
            before.chars().next_back().is_some_and(|c| c.is_ascii_digit() || matches!(c, '⁰'..='⁹' | '²' | '³'));
        let word = after.split([' ', ',', ';', '.', ')', ':', '\u{a0}']).next().unwrap_or_default();
        let unit = !word.is_empty() && UNITS.iter().any(|u| u.symbol == word);
        out.push(if number && unit { '\u{a0}' } else { ' ' });
        rest = after;
    }
    out.push_str(rest);
    out
}
