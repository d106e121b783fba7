//! Input of a computation: plain, validated data in SI.

use sha2::{Digest, Sha256};
use tank::Case;

use crate::input::TankFile;
use crate::input::diagnostic::Faults;
use engines::nonlinear::push::PushOptions;
use engines::nonlinear::scope::{self, Purpose};
use engines::nonlinear::{CheckpointFile, NonlinearOptions};
use engines::solid::SolidOptions;
use files::error::Error;
use results::{InputValue, SourceFile};

/// Which finite-element engines run.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Engines {
    /// One Fourier harmonic at a time.
    #[default]
    Harmonic,
    /// Three-dimensional elements.
    Solid,
    /// The harmonic and the three-dimensional engine.
    Both,
    /// The harmonic and the nonlinear engine.
    Nonlinear,
}

impl Engines {
    /// Whether the three-dimensional engine runs.
    pub fn solid(self) -> bool {
        matches!(self, Engines::Solid | Engines::Both)
    }
}

/// What the nonlinear engine refuses of a tank file, each with its place in the file.
pub fn refused(tank: &TankFile, purpose: Purpose) -> Faults {
    tank.faults(&scope::refusals(&tank.case, &tank.nonlinear, purpose))
}

/// Whether the nonlinear engine can run a tank file.
///
/// Errors: [`Error::Input`] with all that it refuses.
pub fn fits(tank: &TankFile, purpose: Purpose) -> Result<(), Error> {
    let faults = refused(tank, purpose);
    match faults.is_empty() {
        true => Ok(()),
        false => Err(faults.into_error(&tank.source)),
    }
}

/// One verification to be run.
#[derive(Clone, Debug)]
pub struct Job {
    /// The case, complete and validated.
    pub case: Case,
    /// Ids of the procedures to run, in report order.
    pub procedures: Vec<String>,
    /// Finite-element options of both engines; `None` leaves the engines out (`check`).
    pub fe: Option<engines::Options>,
    /// Which engines run.
    pub engines: Engines,
    /// Options of the three-dimensional engine alone.
    pub solid: SolidOptions,
    /// Options of the nonlinear engine alone.
    pub nonlinear: NonlinearOptions,
    /// Checkpoint file of the nonlinear run.
    pub checkpoint: Option<CheckpointFile>,
    /// Echo of the input, defaults marked.
    pub echo: Vec<InputValue>,
    /// Input files of the job, with their hashes.
    pub files: Vec<SourceFile>,
    /// Warnings about the input, one sentence each.
    pub warnings: Vec<String>,
    /// Horizontal (and vertical) record as read, before scaling, for the report's echo.
    pub raw_records: Vec<oscillator::record::Record>,
}

impl Job {
    /// Fingerprint of everything a nonlinear run depends on: the version, the tank, the processed records, the
    /// options.
    pub fn key(&self) -> String {
        fingerprint(&(&self.case, &self.nonlinear))
    }
}

/// Hash of the version and of data.
fn fingerprint(of: &dyn std::fmt::Debug) -> String {
    let mut hash = Sha256::new();
    hash.update(env!("CARGO_PKG_VERSION"));
    // The debug form has every number to the last digit.
    hash.update(format!("{of:?}"));
    hash.finalize().iter().map(|byte| format!("{byte:02x}")).collect()
}

/// One incremental dynamic analysis: the nonlinear run of a job, once for each scale of its record.
#[derive(Clone, Debug)]
pub struct IdaJob {
    /// The job, its record at the scale of the tank file.
    pub job: Job,
    /// Factors on the record, ascending and different, ≥ 0; never empty.
    pub scales: Vec<f64>,
    /// Number of parallel runs, ≥ 1.
    pub jobs: usize,
    /// Folder of the results.
    pub out: std::path::PathBuf,
    /// Whether existing runs of the folder are kept.
    pub resume: bool,
}

/// One pushover.
#[derive(Clone, Debug)]
pub struct PushJob {
    /// The job, without a record.
    pub job: Job,
    /// The imperfect shell.
    pub options: PushOptions,
    /// Folder of the results.
    pub out: std::path::PathBuf,
    /// Checkpoint file of the run.
    pub checkpoint: Option<CheckpointFile>,
}

impl PushJob {
    /// Fingerprint of everything a pushover depends on: the version, the tank, the options, the imperfection.
    pub fn key(&self) -> String {
        fingerprint(&(&self.job.case, &self.job.nonlinear, &self.options))
    }
}
