//! Time history of a case: march and report.

use fem::analysis::march::Outcome;
use fem::cores;
use fem::progress::Progress;
use tank::Case;
use tank::options::nonlinear::NonlinearOptions;

use super::super::CheckpointFile;
use super::march::Cylinder;
use super::model::CylinderModel;
use super::report::report;
use super::watch::Watch;
use crate::checks::checked_motion;
use crate::linear::soil;
use crate::{FeError, Simulation};
use results::Part;

/// Time history of a cylinder.
///
/// * `states`: time between states for pictures [s]; none keeps none
///
/// Errors: as [`Cylinder::new`]; no record; interrupted before there are results.
pub(crate) fn simulate(
    case: &Case,
    options: &NonlinearOptions,
    (states, checkpoint): (Option<f64>, Option<&CheckpointFile>),
    progress: &dyn Progress,
) -> Result<Simulation, FeError> {
    let motion = checked_motion(case)?;
    let cylinder = Cylinder { states, ..Cylinder::new(case, options, progress)? };
    let (watch, run) = cylinder.march(motion, 1.0, cores::available(), checkpoint, progress)?;
    if run.outcome == Outcome::Interrupted && watch.recorder.times.len() < 2 {
        return Err(FeError::Interrupted { stage: "the nonlinear run".into() });
    }
    let mut simulation = report(&cylinder, &watch, &run);
    simulation.result.parts.extend(on_soil(case, &cylinder.tank, &watch)?);
    Ok(simulation)
}

/// What is reported of a slab that moves; none of another tank.
///
/// Errors: those of the model on a fixed base.
fn on_soil(case: &Case, tank: &CylinderModel, watch: &Watch<'_>) -> Result<Option<Part>, FeError> {
    let (Some(slab), Some(numbers)) = (&tank.slab, watch.foundation) else { return Ok(None) };
    soil::part(case, (&slab.slab, &slab.ground), numbers.map(|k| watch.recorder.ranges[k].peak()))
}
