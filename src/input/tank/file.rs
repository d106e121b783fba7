//! `tank.json`, resolved: the case, its options, and where each value stands in the file.

use files::code::Warning;
use results::InputValue;
use tank::check::Decision;
use tank::options::{LinearOptions, NonlinearOptions, SolidOptions};
use tank::refusal::Refusal;
use tank::{Case, Project};

use super::places::Places;
use crate::input::diagnostic::{Faults, Source};
use crate::input::records::Processing;

/// `tank.json`, resolved.
#[derive(Clone, Debug)]
pub struct TankFile {
    /// The case, complete but for the ground motion.
    pub case: Case,
    /// Cover of the report.
    pub project: Option<Project>,
    /// Processing of the record.
    pub record: Processing,
    /// Echo of every field, defaults marked.
    pub echo: Vec<InputValue>,
    /// Ids of the procedures to run; empty for all.
    pub procedures: Vec<String>,
    /// Who decides, and which gaps are accepted.
    pub decision: Decision,
    /// Options of the finite-element engine.
    pub fe: LinearOptions,
    /// Options of the three-dimensional engine.
    pub solid: SolidOptions,
    /// Options of the nonlinear engine.
    pub nonlinear: NonlinearOptions,
    /// Remarks that are not faults ("material `steel` is unused"), one sentence each.
    pub remarks: Vec<String>,
    /// Values that are possible but unusual, one sentence each with the usual range.
    pub warnings: Vec<Warning>,
    /// SHA-256 of the file.
    pub sha256: String,
    /// Its text.
    pub source: Source,
    /// Places in it that an engine may reject.
    pub places: Places,
}

impl TankFile {
    /// The refusals of an engine as faults of this file, each with its place.
    pub fn faults(&self, refusals: &[Refusal]) -> Faults {
        let mut faults = Faults::new();
        for refusal in refusals {
            faults.push(self.places.fault(refusal));
        }
        faults
    }
}
