//! `accepted`: gaps of the deciding codes that the user accepts.

use std::collections::BTreeSet;

use ::tank::check::{self, Approval};
use files::code::Code;

use super::project::is_date;
use crate::input::tank::read::{Field, Opt, object};
use crate::input::tank::resolver::Resolver;

object! {
    /// A limit state that is not checked and accepted all the same. It is printed before everything else, with who accepts it, when and why.
    Accepted {
        /// Id of the limit state, as `check` prints it; of one code only with its id, such as "ec8-2006/sliding".
        check ("sliding"): Field<String>,
        /// Why the gap is acceptable, in several words.
        reason ("keyed foundation, sheet 12 of the statics"): Field<String>,
        /// Who accepts it.
        by ("J. Doe"): Field<String>,
        /// When, year-month-day.
        date ("2026-03-14"): Field<String>,
    }
}

/// Fewest different words of a reason.
const WORDS: usize = 2;

/// Whether a text has several words, of two letters or more each.
fn has_words(text: &str) -> bool {
    let words = text.split(|c: char| !c.is_alphanumeric());
    let words = words.filter(|word| word.chars().filter(|c| c.is_alphabetic()).count() >= 2);
    words.map(str::to_lowercase).collect::<BTreeSet<_>>().len() >= WORDS
}

/// Accepted gaps, each once, with a reason, a name and a date.
pub(super) fn accepted(r: &mut Resolver<'_>, option: &Opt<Vec<Field<Accepted>>>) -> Vec<check::Accepted> {
    let mut all: Vec<check::Accepted> = Vec::new();
    let mut seen = BTreeSet::new();
    for given in option.value().into_iter().flatten().filter_map(|g| g.value.as_ref()) {
        let (check, reason) = (r.text(&given.check), r.text(&given.reason));
        let (by, date) = (r.text(&given.by), r.text(&given.date));
        let (Some(check), Some(reason), Some(by), Some(date)) = (check, reason, by, date) else { continue };
        if !seen.insert(check.clone()) {
            let message = "duplicate limit state";
            r.refuse(Code::Repeated, &given.check, message, "each limit state once");
        }
        if !has_words(&reason) {
            let found = format!("the reason `{reason}`");
            let expected = "why the gap is acceptable, in several words";
            r.refuse(Code::BadForm, &given.reason, &found, expected);
        }
        if !by.chars().any(char::is_alphabetic) {
            let found = format!("the name `{by}`");
            r.refuse(Code::BadForm, &given.by, &found, "who accepts the gap");
        }
        if !is_date(&date) {
            let found = format!("the date `{date}`");
            r.refuse(Code::BadForm, &given.date, &found, "a date as 2026-03-14");
        }
        all.push(check::Accepted { check, reason, approval: Approval { by, date } });
    }
    all
}
