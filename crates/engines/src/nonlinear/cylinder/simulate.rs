//! Time history of a case: march and report.

use fem::analysis::march::Outcome;
use fem::cores;
use fem::progress::Progress;
use tank::Case;
use tank::options::nonlinear::NonlinearOptions;

use super::super::CheckpointFile;
use super::march::Cylinder;
use super::report::report;
use crate::checks::checked_motion;
use crate::{FeError, Simulation};

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
    Ok(report(&cylinder, &watch, &run))
}
