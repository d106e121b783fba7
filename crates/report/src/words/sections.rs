//! Sections and pages: their titles and the sentences of their templates.

mod texts;

use std::collections::BTreeMap;

use texts::ALL;

/// Title of a section or page by its id; the id itself if it is not listed.
pub fn heading(id: &'static str) -> &'static str {
    ALL.iter().find(|words| words.id == id).map_or(id, |words| words.title)
}

/// Sentences of the template of a section or page by their keys.
pub fn sentences(id: &str) -> BTreeMap<&'static str, &'static str> {
    let found = ALL.iter().find(|words| words.id == id);
    found.map_or(&[][..], |words| words.sentences).iter().copied().collect()
}

/// How many of `all` histories are drawn and listed; empty if all are both.
pub fn undrawn(drawn: usize, listed: usize, all: usize) -> String {
    if all > listed {
        return format!("Of {all} histories {drawn} are drawn and {listed} listed below; `series.csv` has all.");
    }
    match all.saturating_sub(drawn) {
        0 => String::new(),
        1 => "1 further history is listed below, not drawn.".into(),
        count => format!("{count} further histories are listed below, not drawn."),
    }
}

/// Modes that are not listed; empty without any.
pub fn unlisted(count: usize) -> String {
    match count {
        0 => String::new(),
        1 => "1 higher mode is in `results.json`.".into(),
        count => format!("{count} higher modes are in `results.json`."),
    }
}

/// How many limits of the theory are exceeded.
pub fn exceeded(count: usize) -> String {
    match count {
        0 => "The run stays within all limits of the linear theory.".into(),
        1 => "One limit of the linear theory is exceeded.".into(),
        count => format!("{count} limits of the linear theory are exceeded."),
    }
}

/// Lines that a sheet shares with that for the record, up to the link to it; empty without any.
pub fn shared(count: usize) -> String {
    match count {
        0 => String::new(),
        1 => "Only lines that depend on the ground motion; 1 further line is the same as in".into(),
        count => format!("Only lines that depend on the ground motion; {count} further lines are the same as in"),
    }
}

/// Residual of an energy balance as a part of the largest input.
pub fn residual(part: &str) -> String {
    format!("Largest residual {part} of the largest input.")
}

/// The deformability parameter as printed and corrected.
pub fn deformability(printed: &str, corrected: &str) -> String {
    format!("K = {printed} as printed; {corrected} if defined so that a thinner wall deforms more.")
}

/// Format of the results.
pub fn format(format: &str) -> String {
    format!("Results format `{format}`.")
}

/// What clauses without the name of a document are of.
pub fn clauses_of(document: &str) -> String {
    format!("Clauses without the name of a document are of {document}.")
}
