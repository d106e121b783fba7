//! Cylinders: half a wall of shells (or the whole) and the condensed liquid, marched through the record.

mod contact;
mod describe;
pub(super) mod mesh;
mod model;
mod points;
mod report;
pub(super) mod section;
mod state;
mod watch;

use codes::Case;
use codes::record::Record;
use fem::analysis::AnalysisError;
use fem::analysis::march::{Checkpoint, Outcome, Run, Settings, march};
use fem::analysis::motion::{Grid, Motion};
use fem::analysis::newton::Options;
use fem::analysis::scheme::TimeScheme;
use fem::analysis::transient::Load;
use fem::progress::Progress;

use super::{CheckpointFile, NonlinearOptions};
use crate::fe::simulate::checked_motion;
use crate::fe::{FeError, Simulation};

use model::CylinderModel;
use watch::Watch;

/// Steps of the time integration in a period of the first mode of wall and liquid.
const STEPS_PER_PERIOD: f64 = 20.0;
/// Looks at all material points in a run.
const LOOKS: f64 = 200.0;

/// Time history of a cylinder.
///
/// Errors: as [`super::simulate`].
pub fn simulate(
    case: &Case,
    options: &NonlinearOptions,
    checkpoint: Option<&CheckpointFile>,
    progress: &dyn Progress,
) -> Result<Simulation, FeError> {
    let motion = checked_motion(case)?;
    progress.stage("mesh, condensed liquid, order of elimination", 1);
    let tank = CylinderModel::new(case, options)?;
    progress.advance(1);
    let record = &motion.horizontal;
    let period = std::f64::consts::TAU / tank.wall_omega;
    let step = options
        .time_step
        .unwrap_or_else(|| (period / STEPS_PER_PERIOD).min(0.5 * record.dt));
    let grid = Grid::new(record.dt, record.duration(), 0.0, step);
    let sampled = |record: &Record| Motion::sampled(record.dt, &record.acceleration, &grid);
    let mut load = Load::ground(0, sampled(record));
    if let Some(vertical) = &motion.vertical {
        let motion = sampled(vertical);
        let unit: Vec<f64> = tank.pressure.iter().map(|p| p / tank.gravity).collect();
        load.forces.push((unit, motion.clone()));
        load.ground[2] = Some(motion);
    }
    let mut settings = Settings::new(grid);
    settings.scheme = TimeScheme::GeneralizedAlpha {
        radius: options.spectral_radius,
    };
    settings.constant = tank.constant();
    if tank.joints.is_some() {
        settings.newton = Options::for_contact();
    }
    settings.checkpoint = checkpoint.map(|file| Checkpoint {
        path: file.path.clone(),
        steps: 0,
        seconds: options.checkpoint,
        key: file.key.clone(),
        resume: file.resume,
    });
    let interval = (record.duration() / LOOKS).max(record.dt);
    let mut watch = Watch::new(&tank, interval).map_err(analysis)?;
    let run = march(tank.problem(), &load, &settings, &mut [&mut watch], progress).map_err(analysis)?;
    if let Some(failure) = watch.failure.take() {
        return Err(analysis(failure));
    }
    if run.outcome == Outcome::Interrupted && watch.recorder.times.len() < 2 {
        return Err(FeError::Interrupted {
            stage: "the nonlinear run".into(),
        });
    }
    Ok(report::report(case, options, &tank, &watch, &run))
}

fn analysis(error: AnalysisError) -> FeError {
    match error {
        AnalysisError::Checkpoint(fault) => FeError::Checkpoint(fault),
        other => FeError::Analysis(other.to_string()),
    }
}

/// Whether a run came to the end of its record.
fn completed(run: &Run) -> bool {
    run.outcome == Outcome::Completed
}

#[cfg(test)]
mod tests;
