//! The nonlinear engine: walls that yield and crack, in large rotations, with the liquid of linear theory.
//!
//! [`simulate`] runs a case once, [`Incremental`] at rising scales of its record, [`push`] is the static pushover of a cylinder.

pub(crate) mod after_record;
mod arcs;
mod bottom;
pub(crate) mod cylinder;
pub(crate) mod extremes;
mod incremental;
pub(crate) mod lasting;
pub(crate) mod laws;
pub(crate) mod parting;
pub mod push;
pub(crate) mod scope;

use fem::progress::Progress;
use tank::Case;
use tank::Shape;

use super::estimate::Estimate;
use super::{FeError, Simulation};
use crate::checks::check_depth;
use crate::strip;

pub use crate::checkpoint::CheckpointFile;
pub use incremental::Incremental;
pub use tank::options::nonlinear::{
    Contact, Damping, Integration, MassProportionalAt, NonlinearOptions, ThicknessRule, WallElements,
};

/// Memory and time of [`simulate`], from case and options alone.
///
/// Errors: no record; a response longer than the limits.
pub fn estimate(case: &Case, options: &NonlinearOptions) -> Result<Estimate, FeError> {
    check_depth(case)?;
    match case.tank.shape {
        Shape::Cylinder { .. } => cylinder::estimate::estimate(case, options, 0, 1),
        Shape::Rectangle { .. } => strip::estimate::estimate(case, options, 0, 1),
    }
}

/// Memory and time of `runs` runs of an [`Incremental`] analysis, `jobs` in parallel.
///
/// Errors: as [`estimate`].
pub fn estimate_incremental(
    case: &Case,
    options: &NonlinearOptions,
    jobs: usize,
    runs: usize,
) -> Result<Estimate, FeError> {
    check_depth(case)?;
    match case.tank.shape {
        Shape::Cylinder { .. } => cylinder::estimate::estimate(case, options, jobs, runs),
        Shape::Rectangle { .. } => strip::estimate::estimate(case, options, jobs, runs),
    }
}

/// Time history of a case by the nonlinear engine. Collapse is a result, not an error.
///
/// Errors: no record; an unsupported tank, wall, law or option; parameters out of range; a checkpoint that cannot be written or
/// belongs to another analysis; interrupted before there are results.
pub fn simulate(
    case: &Case,
    options: &NonlinearOptions,
    checkpoint: Option<&CheckpointFile>,
    progress: &dyn Progress,
) -> Result<Simulation, FeError> {
    simulate_with_states(case, options, (None, checkpoint), progress)
}

/// [`simulate`] that keeps states every `states` [s] for pictures.
///
/// Errors: as [`simulate`].
pub(crate) fn simulate_with_states(
    case: &Case,
    options: &NonlinearOptions,
    (states, checkpoint): (Option<f64>, Option<&CheckpointFile>),
    progress: &dyn Progress,
) -> Result<Simulation, FeError> {
    check_depth(case)?;
    match case.tank.shape {
        Shape::Cylinder { .. } => cylinder::simulate(case, options, (states, checkpoint), progress),
        Shape::Rectangle { .. } => strip::simulate(case, options, (states, checkpoint), progress),
    }
}
