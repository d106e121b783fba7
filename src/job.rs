//! What is to be computed: plain, validated data in SI.

use sha2::{Digest, Sha256};
use tank::Case;

use engines::nonlinear::push::PushOptions;
use engines::nonlinear::{CheckpointFile, NonlinearOptions};
use engines::solid::SolidOptions;
use results::{InputValue, SourceFile};

/// Which finite-element engines run.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Engines {
    /// One Fourier harmonic at a time.
    #[default]
    Harmonic,
    /// Three-dimensional elements.
    Solid,
    /// The harmonic engine, and the three-dimensional one beside it.
    Both,
    /// The harmonic engine, and the nonlinear one beside it.
    Nonlinear,
}

impl Engines {
    /// Whether the three-dimensional engine runs.
    pub fn solid(self) -> bool {
        matches!(self, Engines::Solid | Engines::Both)
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
    /// Where the nonlinear run is kept while it is under way.
    pub checkpoint: Option<CheckpointFile>,
    /// Echo of the input, defaults marked.
    pub echo: Vec<InputValue>,
    /// Files the job was made from, with their hashes.
    pub files: Vec<SourceFile>,
    /// What is unusual in the input, one sentence each.
    pub warnings: Vec<String>,
    /// Horizontal (and vertical) record as read, before scaling, for the report's echo.
    pub raw_records: Vec<oscillator::record::Record>,
}

impl Job {
    /// Fingerprint of everything a nonlinear run depends on: the version, the tank, the records as computed with, the options.
    pub fn key(&self) -> String {
        fingerprint(&(&self.case, &self.nonlinear))
    }
}

/// Hash of the version and of data.
fn fingerprint(of: &dyn std::fmt::Debug) -> String {
    let mut hash = Sha256::new();
    hash.update(env!("CARGO_PKG_VERSION"));
    // The debug form holds every number to the last digit.
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
    /// Runs at a time, ≥ 1.
    pub jobs: usize,
    /// Folder of the results.
    pub out: std::path::PathBuf,
    /// Whether runs that the folder has already are kept.
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
    /// Where the run is kept while it is under way.
    pub checkpoint: Option<CheckpointFile>,
}

impl PushJob {
    /// Fingerprint of everything a pushover depends on: the version, the tank, the options, the imperfection.
    pub fn key(&self) -> String {
        fingerprint(&(&self.job.case, &self.job.nonlinear, &self.options))
    }
}
