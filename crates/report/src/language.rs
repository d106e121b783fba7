//! The language of a page: one catalogue from English sentences to German ones.
//!
//! Sections, templates, procedures and engines write English. A finished page is read once ([`page`]): every text between
//! two tags, and every caption, label and description within a figure, is looked up in the catalogue and replaced.
//! Nothing else of the page changes: code, paths, ids, styles and coordinates stay. An English page is not read at all,
//! unless its units are not those of SI.
//!
//! | module | does |
//! |---|---|
//! | `catalogue` | looks texts up |
//! | `pattern` | a sentence with holes, and how a text matches it |
//! | `text` | words, sentences, first letters |
//! | `markup` | finds the texts of a page |
//! | `decimal` | decimal commas |
//! | `made` | texts that are in the language already |
//! | `german/*.txt` | the catalogue, by topic |
//!
//! A text of [`crate::message`] is in the language of the page already, and stays.
//!
//! Texts about an input file have a catalogue of their own: [`of_input`].
//!
//! A text that the catalogue lacks stays English and is remembered: [`untranslated`]. The tests render the examples and
//! allow none.

mod catalogue;
mod decimal;
pub(crate) mod made;
mod markup;
mod pattern;
#[cfg(test)]
mod tests;
mod text;

use std::borrow::Cow;
use std::cell::RefCell;
use std::collections::{BTreeSet, HashMap};
use std::sync::LazyLock;

use tank::Language;
use tank::units::{System, converted};

use crate::style;
use catalogue::Catalogue;

/// The German catalogue by topic.
const GERMAN: &[(&str, &str)] = &[
    ("terms", include_str!("language/german/terms.txt")),
    ("page", include_str!("language/german/page.txt")),
    ("codes", include_str!("language/german/codes.txt")),
    ("engines", include_str!("language/german/engines.txt")),
    ("figures", include_str!("language/german/figures.txt")),
    ("analyses", include_str!("language/german/analyses.txt")),
];

/// What people read who write an input file; pages of results are read without it.
const INPUT: &[(&str, &str)] =
    &[("keys", include_str!("language/german/keys.txt")), ("faults", include_str!("language/german/faults.txt"))];

static CATALOGUE: LazyLock<Catalogue> = LazyLock::new(|| Catalogue::new(GERMAN));
static INPUT_CATALOGUE: LazyLock<Catalogue> = LazyLock::new(|| Catalogue::new(INPUT));

thread_local! {
    /// Texts seen so far and their translations.
    static SEEN: RefCell<HashMap<String, String>> = RefCell::default();
    static MISSING: RefCell<BTreeSet<String>> = RefCell::default();
}

/// Longest memory of texts, in entries: a process that renders many reports keeps no more.
const SEEN_AT_MOST: usize = 20_000;

/// Texts without a translation that were met in this thread since the last call.
pub fn untranslated() -> Vec<String> {
    MISSING.take().into_iter().collect()
}

/// A message of this id has no text: it is remembered as a text without a translation, and shown by its id.
pub(crate) fn lacks(id: &str) -> String {
    MISSING.with_borrow_mut(|all| all.insert(id.to_owned()));
    id.to_owned()
}

/// A number as the language writes it.
pub(crate) fn decimal(number: String) -> String {
    match style::language() {
        Language::English => number,
        Language::German => decimal::commas(&number),
    }
}

/// A plain text in the language and units of the page under construction.
pub fn say(text: &str) -> Cow<'_, str> {
    match style::language() {
        Language::English => converted(text, System::current(), DIGITS),
        Language::German => Cow::Owned(german(&converted(text, System::current(), DIGITS))),
    }
}

/// Significant digits of a value within a sentence in other units than the sentence was written in.
const DIGITS: usize = 3;

/// The German of a text about an input file: help of a key, a fault, a warning; none where the catalogues lack a part of it,
/// since half a translation is worse to read than the English.
pub fn of_input(text: &str) -> Option<String> {
    let paragraph = |text: &str| INPUT_CATALOGUE.complete(text).or_else(|| CATALOGUE.complete(text));
    let german: Option<Vec<String>> = text.split("\n\n").map(paragraph).collect();
    Some(german?.join("\n\n"))
}

/// A finished page or figure in the language and units under construction.
pub fn page(html: String) -> String {
    match (style::language(), System::current()) {
        (Language::English, System::Si) => html,
        (language, units) => markup::rewritten(&html, language, units),
    }
}

/// The German of a clause (`table A.2`, `annex E`): its numbers stay as they are.
fn clause(text: &str) -> String {
    let plain = text.replace('\u{a0}', " ");
    let mut missing = Vec::new();
    let out = CATALOGUE.reference(&plain, &mut missing);
    MISSING.with_borrow_mut(|all| all.extend(missing));
    out
}

/// The German of a text; the text itself, with decimal commas, where the catalogue lacks it.
fn german(text: &str) -> String {
    if made::is_made(text) {
        return text.to_owned();
    }
    if let Some(known) = SEEN.with_borrow(|seen| seen.get(text).cloned()) {
        return known;
    }
    let mut missing = Vec::new();
    let out = CATALOGUE.translate(text, &mut missing);
    MISSING.with_borrow_mut(|all| all.extend(missing));
    SEEN.with_borrow_mut(|seen| {
        if seen.len() >= SEEN_AT_MOST {
            seen.clear();
        }
        seen.insert(text.to_owned(), out.clone());
    });
    out
}
