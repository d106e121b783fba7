//! The finite-element engine: `simulate` a case, or find its `modes`.
//!
//! The linear engine works harmonic by harmonic: a displacement-potential liquid, condensed to the wall and the free
//! surface, coupled to a shell of revolution (or a plane wall strip). Everything it reports is a linear functional of
//! the unknowns, a [`probe::Probe`]; the response analyses know nothing else of the model.

pub mod coupled;
pub mod damping;
pub mod estimate;
pub mod harmonic;
pub mod nonlinear;

pub mod probe;
pub mod response;
mod simulate;
pub mod solid;

pub use fem::liquid;
pub use simulate::{simulate, simulate_watched};

use std::collections::BTreeMap;

use fem::analysis::checkpoint::CheckpointError;
use tank::{Case, Quantity};

use results::{FeResult, Mode, Series, Snapshots};

/// Time integration of the linear engine.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Integrator {
    /// Exact piecewise-linear modal integration with missing mass.
    Modal,
    /// Direct Newmark (average acceleration) on all unknowns, with energy balance.
    Newmark,
}

/// Damping of the linear engine.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum DampingModel {
    /// Ratios of `Case::damping` by kind of mode.
    Modal,
    /// Rayleigh damping C = a_M M + a_K K fitted to two (circular frequency [rad/s], ratio) pairs.
    Rayleigh {
        /// First pair.
        first: (f64, f64),
        /// Second pair.
        second: (f64, f64),
        /// Accept a negative coefficient (parity with published runs), with a warning.
        allow_negative: bool,
    },
    /// Rayleigh damping with its coefficients given, whatever their sign (parity with published runs), with a warning if
    /// one is negative.
    Coefficients {
        /// a_M [1/s].
        mass: f64,
        /// a_K [s].
        stiffness: f64,
    },
}

/// Options of the engine. The defaults keep the errors stated in the theory manual.
#[derive(Clone, Debug, PartialEq)]
pub struct Options {
    /// Mesh refinement: every element count is multiplied by this (1 = default mesh).
    pub refine: f64,
    /// Time integration.
    pub integrator: Integrator,
    /// Damping.
    pub damping: DampingModel,
    /// Sloshing modes that count for the wave height (5).
    pub wave_modes: usize,
    /// Estimate the discretisation error by a second, coarser mesh.
    pub mesh_error: bool,
    /// Extra wave gauges: radii (or x) in the direction of shaking [m]; the wall is always gauged.
    pub gauges: Vec<f64>,
    /// Extra stress stations: heights above the base [m] with histories of hoop, axial and bending stress.
    pub stations: Vec<f64>,
}

impl Default for Options {
    fn default() -> Self {
        Options {
            refine: 1.0,
            integrator: Integrator::Modal,
            damping: DampingModel::Modal,
            wave_modes: 5,
            mesh_error: true,
            gauges: Vec::new(),
            stations: Vec::new(),
        }
    }
}

/// A finished run.
#[derive(Clone, Debug)]
pub struct Simulation {
    /// Comparable values, SI.
    pub values: BTreeMap<Quantity, f64>,
    /// The run in the vocabulary of the results folder.
    pub result: FeResult,
    /// Time histories.
    pub series: Series,
    /// What the engine assumed, one sentence each.
    pub assumptions: Vec<String>,
    /// Warnings, one sentence each.
    pub notes: Vec<String>,
    /// States of the three-dimensional model at moments, where they were asked for.
    pub snapshots: Option<Snapshots>,
}

/// Failure of the engine.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
pub enum FeError {
    /// The case has no ground motion.
    #[error("no ground motion: give a record with --quake")]
    NoRecord,
    /// Something the linear engine does not model.
    #[error("{0}")]
    Unsupported(String),
    /// An option out of range.
    #[error("option {option}: found {found}, allowed {allowed}")]
    Option {
        /// Name.
        option: String,
        /// Found.
        found: String,
        /// Allowed.
        allowed: String,
    },
    /// A matrix that must be positive definite is not.
    #[error("{matrix} is not positive definite ({cause})")]
    NotPositiveDefinite {
        /// Which matrix.
        matrix: String,
        /// Likely cause.
        cause: String,
    },
    /// The eigenvalue solver failed.
    #[error("eigenvalue solver: {0}")]
    Eigen(String),
    /// A run that takes more memory than allowed.
    #[error("the {run} needs about {needed_mib} MiB, more than the allowed {allowed_mib} MiB\n  help: {help}")]
    Memory {
        /// Which run, with its size.
        run: String,
        /// Estimate [MiB].
        needed_mib: u64,
        /// Limit [MiB].
        allowed_mib: u64,
        /// What to do, and what fits.
        help: String,
    },
    /// A run that takes more steps, samples or time than allowed.
    #[error("{what}; allowed {allowed}\n  help: {help}")]
    TooLong {
        /// What takes how many.
        what: String,
        /// The limit.
        allowed: String,
        /// What to do, and what fits.
        help: String,
    },
    /// An analysis failed.
    #[error("{0}")]
    Analysis(String),
    /// A checkpoint that cannot be written, read or used.
    #[error("{0}{help}", help = way_out(.0))]
    Checkpoint(#[from] CheckpointError),
    /// The user stopped the run before it had anything to show.
    #[error("interrupted during {stage}: nothing is computed yet")]
    Interrupted {
        /// What was under way.
        stage: String,
    },
    /// The response grows without bound or is not a number.
    #[error("the response is not finite at t = {time:.4} s ({cause})")]
    NotFinite {
        /// Time [s].
        time: f64,
        /// Likely cause.
        cause: String,
    },
}

/// What to do about a checkpoint that is of no use.
fn way_out(error: &CheckpointError) -> &'static str {
    match error {
        CheckpointError::Unusable { .. } => {
            "\n  help: leave --resume out to start over, which overwrites it, or name that of the same tank file, record, options \
             and version"
        }
        _ => "",
    }
}

/// Coupled modes of the given harmonics (0, 1, 2, …), at most `count` of each kind and harmonic, by ascending frequency.
pub fn modes(case: &Case, options: &Options, harmonics: &[u32], count: usize) -> Result<Vec<Mode>, FeError> {
    harmonic::modes(case, options, harmonics, count)
}
