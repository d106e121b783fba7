//! A cylinder marched through its record.

use fem::analysis::AnalysisError;
use fem::analysis::march::{Adaptive, Run, Settings, march};
use fem::analysis::motion::{Grid, Motion};
use fem::analysis::newton::{Criteria, Options};
use fem::analysis::scheme::TimeScheme;
use fem::analysis::transient::Load;
use fem::progress::Progress;
use oscillator::record::Record;
use tank::Case;
use tank::case::GroundMotion;

use super::super::CheckpointFile;
use super::super::after_record::Span;
use crate::FeError;
use crate::checks::checked_motion;
use tank::options::nonlinear::{NonlinearOptions, StepLength};

use super::model::CylinderModel;
use super::pictures::Pictures;
use super::watch::Watch;

/// Steps of the time integration in a period of the first mode of wall and liquid.
const STEPS_PER_PERIOD: f64 = 20.0;
/// Longest step on isolators, whose slab changes its acceleration within some milliseconds as it begins to slide [s].
const SLIDING: f64 = 2e-3;
/// Looks at all material points in a run.
pub(super) const LOOKS: f64 = 200.0;

/// Longest step by default, of a first period of the wall and the step of the record [s].
pub(super) fn usual_step(case: &Case, period: f64, record: f64) -> f64 {
    let longest = if case.tank.isolators.is_some() { SLIDING } else { f64::INFINITY };
    (period / STEPS_PER_PERIOD).min(0.5 * record).min(longest)
}

/// A cylinder with its options.
pub(crate) struct Cylinder<'a> {
    pub case: &'a Case,
    pub options: &'a NonlinearOptions,
    pub tank: CylinderModel,
    /// End of the records and of a run.
    pub span: Span,
    /// Time between states for pictures [s]; none keeps none.
    pub states: Option<f64>,
    /// When a step has converged, other than by default.
    pub criteria: Option<Criteria>,
}

impl<'a> Cylinder<'a> {
    /// Errors: no record; a tank that is not a cylinder; an unsupported wall, law or option; parameters out of range.
    pub(crate) fn new(
        case: &'a Case,
        options: &'a NonlinearOptions,
        progress: &dyn Progress,
    ) -> Result<Cylinder<'a>, FeError> {
        checked_motion(case)?;
        progress.stage("mesh, condensed liquid, order of elimination", 1);
        let tank = CylinderModel::new(case, options)?;
        progress.advance(1);
        Cylinder::of(case, options, tank)
    }

    /// The march of a model that is there.
    ///
    /// Errors: no ground motion.
    pub(crate) fn of(
        case: &'a Case,
        options: &'a NonlinearOptions,
        tank: CylinderModel,
    ) -> Result<Cylinder<'a>, FeError> {
        let motion = checked_motion(case)?;
        let span = Span::new(motion, options.after_record, tank.sloshing_omega)?;
        Ok(Cylinder { case, options, tank, span, states: None, criteria: None })
    }

    /// Longest step [s].
    pub(crate) fn step(&self, record: &Record) -> f64 {
        let period = std::f64::consts::TAU / self.tank.wall_omega;
        self.options.time_step.unwrap_or_else(|| usual_step(self.case, period, record.dt))
    }

    /// Through `scale` times the records and the free vibration after them, on `threads` threads.
    pub(crate) fn march(
        &self,
        motion: &GroundMotion,
        scale: f64,
        threads: usize,
        checkpoint: Option<&CheckpointFile>,
        progress: &dyn Progress,
    ) -> Result<(Watch<'_>, Run), FeError> {
        let (tank, options) = (&self.tank, self.options);
        // That of the case: the motion of a slab on isolators has finer steps.
        let record = &checked_motion(self.case)?.horizontal;
        let grid = Grid::new(record.dt, self.span.record, self.span.tail, self.step(record));
        let sampled = |record: &Record| {
            let scaled: Vec<f64> = record.acceleration.iter().map(|a| scale * a).collect();
            Motion::sampled(record.dt, &scaled, &grid)
        };
        let mut load = Load::ground(0, sampled(&motion.horizontal));
        load.ground[1] = motion.transverse.as_ref().map(sampled);
        if let Some(vertical) = &motion.vertical {
            let motion = sampled(vertical);
            let unit: Vec<f64> = tank.pressure.iter().map(|p| p / tank.gravity).collect();
            load.forces.push((unit, motion.clone()));
            load.ground[2] = Some(motion);
        }
        let mut settings = Settings::new(grid);
        settings.scheme = TimeScheme::GeneralizedAlpha { radius: options.spectral_radius };
        settings.constant = tank.constant();
        settings.threads = threads;
        settings.adaptive = match options.step {
            StepLength::Fixed => None,
            StepLength::Adaptive => Some(Adaptive::DEFAULT),
        };
        if tank.assembler.acts_at_end() {
            settings.newton = match tank.zone.clone() {
                Some(zone) => Options::for_ground(zone),
                None => Options::for_contact(),
            };
        }
        if let Some(criteria) = self.criteria {
            settings.newton.criteria = criteria;
        }
        settings.checkpoint = checkpoint.map(|file| file.whole(options.checkpoint));
        let interval = (record.duration() / LOOKS).max(record.dt);
        let mut watch = Watch::new(tank, interval, motion.transverse.is_some()).map_err(analysis)?;
        watch.pictures = self.states.map(|every| Pictures::new(tank, every));
        let run = march(tank.problem(), &load, &settings, &mut [&mut watch], progress).map_err(analysis)?;
        match watch.failure.take() {
            Some(failure) => Err(analysis(failure)),
            None => Ok((watch, run)),
        }
    }
}

fn analysis(error: AnalysisError) -> FeError {
    match error {
        AnalysisError::Checkpoint(fault) => FeError::Checkpoint(fault),
        other => FeError::Analysis(other.to_string()),
    }
}
