//! How the input of a study departs from its plan.

use std::path::Path;

use crate::cli::terminal::say;
use crate::error::Error;
use crate::input::study as input;
use crate::study::changes;
use crate::study::plan::{Plan, Task};
use files::code::Code;

/// How the input of a study departs from its plan.
pub(super) enum Departure {
    /// What changed.
    Changed(String),
    /// The first fault of input that was right.
    Faulty(String),
}

impl Departure {
    pub(super) fn clause(&self) -> String {
        match self {
            Departure::Changed(what) => changes::since(what),
            Departure::Faulty(fault) => format!("the input of the study is faulty since the plan: {fault}"),
        }
    }

    pub(super) fn error(&self) -> Error {
        match self {
            Departure::Changed(what) => changes::changed_since(what),
            Departure::Faulty(_) => Error::input(
                Code::StudyChanged,
                format!("{}\n  help: correct the file; `tankcheck study plan` lists all faults", self.clause()),
            ),
        }
    }
}

/// What the input of a study has that its plan has not; none where nothing changed, or the input is not here (results that were taken to another machine),
/// which is said. Input that was right when the plan was made and is faulty now has changed.
pub(super) fn departure(folder: &Path, planned: (&Plan, &[Task]), quiet: bool) -> Option<Departure> {
    let compared = study_of(folder, planned.0).and_then(|study| changes::departure(&study, planned, folder));
    let compared = compared.map(|found| found.map(Departure::Changed));
    compared.unwrap_or_else(|error| {
        let message = error.message();
        let first = message.lines().next().unwrap_or_default();
        let absent = Code::FileUnreadable.head();
        if !first.starts_with(&absent) {
            // The place stands in the line below.
            let place = message.lines().nth(1).and_then(|line| line.trim().strip_prefix("--> "));
            let place = place.map_or(String::new(), |place| format!(", {place}"));
            return Some(Departure::Faulty(format!("{first}{place}")));
        }
        if !quiet {
            say!("note: the input of the study is not compared with its plan: {first}");
        }
        None
    })
}

/// Errors: input that changed since the plan.
pub(super) fn unchanged(folder: &Path, planned: (&Plan, &[Task]), quiet: bool) -> Result<(), Error> {
    departure(folder, planned, quiet).map_or(Ok(()), |found| Err(found.error()))
}

/// The study file of a plan.
pub(super) fn study_of(folder: &Path, plan: &Plan) -> Result<input::StudyInput, Error> {
    Ok(input::read(&folder.join(&plan.study))?)
}
