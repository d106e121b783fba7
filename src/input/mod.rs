//! Reading `tank.json` and accelerograms: text, units and file formats end here.

pub mod diagnostic;
pub mod records;
pub mod tank;

use std::path::Path;

use ::tank::Case;

use diagnostic::{Faults, Source};
use engines::nonlinear::scope::{self, Purpose};
use files::error::Error;
use results::InputValue;
use tank::Places;

/// `tank.json`, resolved.
#[derive(Clone, Debug)]
pub struct TankFile {
    /// The case, complete but for the ground motion.
    pub case: Case,
    /// Processing of the record.
    pub record: records::Processing,
    /// Echo of every field, defaults marked.
    pub echo: Vec<InputValue>,
    /// Ids of the procedures to run; empty for all.
    pub procedures: Vec<String>,
    /// Options of the finite-element engine.
    pub fe: engines::Options,
    /// Options of the three-dimensional engine.
    pub solid: engines::solid::SolidOptions,
    /// Options of the nonlinear engine.
    pub nonlinear: engines::nonlinear::NonlinearOptions,
    /// Remarks that are not faults ("material `steel` is unused"), one sentence each.
    pub remarks: Vec<String>,
    /// Values that are possible but unusual, one sentence each with the usual range.
    pub warnings: Vec<String>,
    /// SHA-256 of the file.
    pub sha256: String,
    /// Its text.
    pub source: Source,
    /// Places in it that the nonlinear engine may reject.
    pub places: Places,
}

impl TankFile {
    /// Whether the nonlinear engine can run this file. Errors: all unsupported inputs, each with
    /// its place.
    pub fn fits(&self, purpose: Purpose) -> Result<(), Error> {
        let faults = self.refused(purpose);
        match faults.is_empty() {
            true => Ok(()),
            false => Err(faults.into_error(&self.source)),
        }
    }

    /// Inputs of this file that the nonlinear engine rejects.
    pub fn refused(&self, purpose: Purpose) -> Faults {
        let mut faults = Faults::new();
        for refusal in scope::refusals(&self.case, &self.nonlinear, purpose) {
            faults.push(self.places.fault(&refusal));
        }
        faults
    }
}

/// Reads and resolves a tank file (`-` reads standard input). All faults are reported at once in [`Error::Input`].
pub fn read_tank(path: &Path) -> Result<TankFile, Error> {
    tank::read(path)
}
