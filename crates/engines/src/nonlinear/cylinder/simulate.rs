//! Time history of a case: march and report.

use fem::analysis::march::{Outcome, Run};
use fem::cores;
use fem::progress::Progress;
use tank::Case;
use tank::case::GroundMotion;
use tank::options::nonlinear::NonlinearOptions;

use super::super::CheckpointFile;
use super::march::Cylinder;
use super::model::CylinderModel;
use super::recorded::BASE_SHEAR;
use super::report::report;
use super::two;
use super::watch::Watch;
use crate::checks::checked_motion;
use crate::linear::isolation::{Below, Beneath};
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
    if let Some(beneath) = Beneath::of(case)? {
        return on_isolators(&cylinder, &beneath, checkpoint, progress);
    }
    let (watch, run) = marched(&cylinder, motion, checkpoint, progress)?;
    let mut simulation = report(&cylinder, &watch, &run);
    simulation.result.parts.extend(on_soil(case, &cylinder.tank, &watch)?);
    Ok(simulation)
}

/// A march that has results.
///
/// Errors: as [`simulate`].
fn marched<'a>(
    cylinder: &'a Cylinder<'_>,
    motion: &GroundMotion,
    checkpoint: Option<&CheckpointFile>,
    progress: &dyn Progress,
) -> Result<(Watch<'a>, Run), FeError> {
    let (watch, run) = cylinder.march(motion, 1.0, cores::available(), checkpoint, progress)?;
    if run.outcome == Outcome::Interrupted && watch.recorder.times.len() < 2 {
        return Err(FeError::Interrupted { stage: "the nonlinear run".into() });
    }
    Ok((watch, run))
}

/// Change of the base shear over the force of the isolators with which a second run is not worth its time.
const SETTLED: f64 = 0.01;

/// The tank under the motion of its slab on isolators: once as they move under the modes of the tank, and again under the forces of that run.
///
/// Errors: as [`simulate`]; those of the linear engine.
fn on_isolators(
    cylinder: &Cylinder<'_>,
    beneath: &Beneath<'_>,
    checkpoint: Option<&CheckpointFile>,
    progress: &dyn Progress,
) -> Result<Simulation, FeError> {
    let shear = |watch: &Watch<'_>| -> Vec<Vec<f64>> {
        let two = beneath.is_two().then_some(two::SHEAR_Y);
        let own = |k: usize| {
            let history = &watch.recorder.histories[k];
            let rest = history.first().copied().unwrap_or_default();
            history.iter().map(|v| v - rest).collect()
        };
        std::iter::once(BASE_SHEAR).chain(two).map(own).collect()
    };
    let change = |below: &Below, watch: &Watch<'_>| {
        let own = shear(watch);
        let across = own.get(1).map_or(&[][..], Vec::as_slice);
        beneath.next(below, &watch.recorder.times, [&own[0], across])
    };
    let mut below = beneath.first()?;
    let (mut watch, mut run) = marched(cylinder, &below.motion, checkpoint, progress)?;
    let (next, mut apart) = change(&below, &watch)?;
    if apart > SETTLED && run.outcome == Outcome::Completed {
        let again = checkpoint.map(CheckpointFile::again);
        below = next;
        (watch, run) = marched(cylinder, &below.motion, again.as_ref(), progress)?;
        apart = change(&below, &watch)?.1;
    }
    let mut simulation = report(cylinder, &watch, &run);
    simulation.slab_motion = Some(below.motion.clone());
    if let Some(demands) = &mut simulation.demands {
        let times = &watch.recorder.times;
        let found = beneath.finish(below, apart, times, &mut simulation.values, demands)?;
        simulation.result.parts.push(found.part);
        simulation.notes.extend(found.notes);
        for (info, column) in found.columns {
            simulation.series.ids.push(info.id.clone());
            simulation.series.columns.push(column);
            simulation.result.histories.push(info);
        }
    }
    Ok(simulation)
}

/// What is reported of a slab that moves; none of another tank.
///
/// Errors: those of the model on a fixed base.
fn on_soil(case: &Case, tank: &CylinderModel, watch: &Watch<'_>) -> Result<Option<Part>, FeError> {
    let (Some(slab), Some(numbers)) = (&tank.slab, watch.foundation) else { return Ok(None) };
    soil::part(case, (&slab.slab, &slab.ground), numbers.map(|k| watch.recorder.ranges[k].peak()))
}
