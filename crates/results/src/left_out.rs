//! Parts of the results that a run leaves out where nothing that was selected needs them.

use serde::{Deserialize, Serialize};
use tank::listed;

use crate::{Check, Results, Verdict};

listed! {
    /// A part that can be left out.
    #[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
    #[serde(rename_all = "snake_case")]
    pub enum Omittable {
        /// Its name in a list.
        name: &'static str,
        /// What its absence means.
        text: &'static str,
    }
    /// The second mesh, and what it says of values and checks.
    MeshError: "mesh error",
        "The discretisation error is not estimated: checks have no `error`, none is marked as within it, and no value as unusable.";
    /// Envelopes over the height.
    Envelopes: "envelopes over the height", "Envelopes of stresses, forces and pressure over the height are left out.";
    /// Time histories.
    Histories: "time histories", "Time histories and series.csv are left out.";
    /// A base that lifts on softer and on harder ground.
    Grounds: "softer and harder ground",
        "The base was not run on softer and harder ground. It was run under slightly weaker and stronger motions, so that checks know whether it repeats.";
}

/// A part that was left out, in words.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize)]
pub struct LeftOut {
    /// The part.
    pub part: Omittable,
    /// What its absence means, a sentence or two.
    pub text: String,
}

impl LeftOut {
    /// The words for a part.
    pub fn of(part: Omittable) -> LeftOut {
        LeftOut { part, text: part.text().into() }
    }

    /// Names of parts in one line.
    pub fn names(all: &[LeftOut]) -> String {
        all.iter().map(|left| left.part.name()).collect::<Vec<_>>().join(", ")
    }
}

impl Results {
    /// Whether they have something of a part.
    pub fn has(&self, part: Omittable) -> bool {
        self.runs.iter().any(|run| match part {
            Omittable::MeshError => !run.mesh_error.is_empty(),
            Omittable::Envelopes => !run.envelopes.is_empty(),
            Omittable::Histories => !run.histories.is_empty(),
            Omittable::Grounds => {
                run.base.as_ref().is_some_and(|base| !base.band.is_empty() || !base.missed.is_empty())
            }
        })
    }

    /// The same without parts, as a run that leaves them out has it. Remarks of the engines go too: they speak of these parts among others.
    pub fn without(mut self, parts: &[LeftOut]) -> Results {
        for left in parts {
            for run in &mut self.runs {
                match left.part {
                    Omittable::MeshError => run.mesh_error.clear(),
                    Omittable::Envelopes => run.envelopes.clear(),
                    Omittable::Histories => run.histories.clear(),
                    Omittable::Grounds => {
                        if let Some(base) = &mut run.base {
                            base.band.clear();
                            base.missed.clear();
                        }
                    }
                }
            }
            if left.part == Omittable::MeshError {
                self.forget_errors();
            }
        }
        if !parts.is_empty() {
            let engines = self.methods.iter_mut().filter(|method| method.is_run());
            engines.for_each(|method| method.notes.clear());
        }
        self.not_computed.clear();
        self
    }

    fn forget_errors(&mut self) {
        let Verdict { counts, governing, missing, record, .. } = &mut self.verdict;
        counts.within_error = 0;
        if let Some(aside) = record.as_mut() {
            aside.counts.within_error = 0;
        }
        let aside = record.as_mut().and_then(|aside| aside.governing.as_mut());
        let named = governing.iter_mut().chain(missing).chain(aside);
        let own = self.methods.iter_mut().flat_map(|method| &mut method.checks);
        for check in named.map(|named| &mut named.check).chain(own) {
            forget_error(check);
        }
        for cell in self.comparison.rows.iter_mut().flat_map(|row| &mut row.cells).flatten() {
            cell.unusable = false;
        }
    }
}

fn forget_error(check: &mut Check) {
    check.error = None;
    check.within_error = false;
}
