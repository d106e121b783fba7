//! A wall of the strip through an earthquake, and through the same earthquake at rising scales.

use std::sync::atomic::{AtomicBool, Ordering};

use oscillator::record::Record;

use fem::analysis::ida::{self, Point};
use fem::analysis::march::{Checkpoint, Observe, Outcome, Problem, Run, Settings, march};
use fem::analysis::motion::{Grid, Motion};
use fem::analysis::newton::Options;
use fem::analysis::scheme::TimeScheme;
use fem::analysis::transient::Load;
use fem::progress::{Progress, Quiet};
use results::channel::Side;

use super::demand::Demand;
use super::history::{WallHistory, WallObserver};
use super::model::StripModel;
use super::parameters::StripError;

/// Earthquake and integration of a run.
#[derive(Clone, Debug)]
pub struct StripQuake {
    /// Horizontal record, towards +x.
    pub horizontal: Record,
    /// Vertical record, upwards: it changes the pressure by ρ a_v (H − z) and the weight of the wall.
    pub vertical: Option<Record>,
    /// Longest nominal step [s].
    pub longest_step: f64,
    /// End of the run [s]; that of the horizontal record without.
    pub until: Option<f64>,
    /// Scheme.
    pub scheme: TimeScheme,
    /// Newton's method.
    pub newton: Options,
    /// A nominal step is halved so often at most.
    pub halvings: u32,
    /// Time between states for pictures [s]; none keeps none.
    pub states: Option<f64>,
}

impl StripQuake {
    /// Generalised-α with ρ_∞ = 0.9 in steps of at most `longest_step` [s].
    pub fn new(horizontal: Record, longest_step: f64) -> StripQuake {
        StripQuake {
            horizontal,
            vertical: None,
            longest_step,
            until: None,
            scheme: TimeScheme::GeneralizedAlpha { radius: 0.9 },
            newton: Options::default(),
            halvings: 8,
            states: None,
        }
    }
}

/// One wall after a run.
#[derive(Clone, Debug, PartialEq)]
pub struct StripRun {
    /// Largest values.
    pub demand: Demand,
    /// How it ended.
    pub outcome: Outcome,
    /// Time reached [s].
    pub time: f64,
    /// Energy dissipated by the materials [J per m].
    pub hysteretic: f64,
    /// Residual of the energy balance over the largest energy.
    pub imbalance: f64,
    /// Number of times that a step was halved.
    pub halvings: u64,
    /// Steps done.
    pub steps: u64,
    /// Newton iterations, failed steps included.
    pub iterations: u64,
}

impl StripRun {
    fn of(observed: WallRun) -> StripRun {
        let run = observed.run;
        StripRun {
            demand: Demand::of(&observed.history),
            time: run.time,
            hysteretic: run.balance.samples.last().map_or(0.0, |e| e.hysteretic),
            imbalance: run.balance.error(),
            halvings: run.cuts,
            steps: run.cost.steps,
            iterations: run.cost.iterations,
            outcome: run.outcome,
        }
    }
}

/// One wall after a run that was observed closely.
#[derive(Clone, Debug)]
pub struct WallRun {
    /// Its results.
    pub history: WallHistory,
    /// How it ended, energies, cost.
    pub run: Run,
    /// Why the run ended although equilibrium was found: the top has moved too far, or the run has left its model.
    pub lost: Option<String>,
}

impl WallRun {
    /// Whether the wall has collapsed.
    pub fn collapsed(&self) -> bool {
        self.lost.is_some() || matches!(self.run.outcome, Outcome::Collapsed(_))
    }
}

/// Both walls at one scale.
#[derive(Clone, Debug, PartialEq)]
pub struct StripLevel {
    /// Scale of the records.
    pub scale: f64,
    /// The walls at +L and −L.
    pub walls: [StripRun; 2],
}

impl StripLevel {
    /// The worse wall in every quantity.
    pub fn demand(&self) -> Demand {
        self.walls[0].demand.worse(&self.walls[1].demand)
    }

    /// Whether a wall found no equilibrium or moved too far: its demands are lower bounds.
    pub fn collapsed(&self) -> bool {
        let ended = |w: &StripRun| matches!(w.outcome, Outcome::Collapsed(_) | Outcome::Stopped { .. });
        self.walls.iter().any(ended)
    }

    /// Step halvings of both walls.
    pub fn halvings(&self) -> u64 {
        self.walls.iter().map(|w| w.halvings).sum()
    }

    /// Larger imbalance of energy.
    pub fn imbalance(&self) -> f64 {
        self.walls[0].imbalance.max(self.walls[1].imbalance)
    }

    /// The level as a point of a curve.
    pub fn point(&self, demand: impl Fn(&Demand) -> f64) -> Point {
        Point { scale: self.scale, demand: demand(&self.demand()), censored: self.collapsed() }
    }
}

impl StripModel {
    /// The wall of `side` under `scale` times the records, from rest under weight and pressure.
    ///
    /// Errors: those of the analysis; collapse is a result.
    pub fn run(
        &self,
        quake: &StripQuake,
        scale: f64,
        side: Side,
        progress: &dyn Progress,
    ) -> Result<StripRun, StripError> {
        self.resumable(quake, scale, side, None, progress)
    }

    /// As [`StripModel::run`], with checkpoints.
    ///
    /// Errors: those of the analysis; a checkpoint that cannot be written or is of another run.
    pub fn resumable(
        &self,
        quake: &StripQuake,
        scale: f64,
        side: Side,
        checkpoint: Option<Checkpoint>,
        progress: &dyn Progress,
    ) -> Result<StripRun, StripError> {
        Ok(StripRun::of(self.observed(quake, scale, side, checkpoint, None, progress)?))
    }

    /// Both walls under the unscaled records, in parallel, with full histories. The tank ends with the wall
    /// that collapses first: the other one is not observed further.
    ///
    /// * `checkpoints`: of the walls at +L and −L
    ///
    /// Errors: those of the analysis; a checkpoint that cannot be written or is of another run. Collapse is a result, not an error.
    pub fn histories(
        &self,
        quake: &StripQuake,
        checkpoints: [Option<Checkpoint>; 2],
        progress: &dyn Progress,
    ) -> Result<[WallRun; 2], StripError> {
        if self.chain.is_some() {
            let [first, _] = checkpoints;
            return self.both(quake, 1.0, first, progress);
        }
        progress.stage("time steps of both walls", 2 * self.grid(quake).steps() as u64);
        let counted = Counted::new(progress);
        let [first, second] = checkpoints;
        let observe = |side, checkpoint, until| self.observed(quake, 1.0, side, checkpoint, until, &counted);
        let (a, b) = rayon::join(
            || observe(Side::Front, first, None),
            || self.observed(quake, 1.0, Side::Back, second, None, &Counted::new(progress)),
        );
        let mut walls = [a?, b?];
        let end = walls.iter().filter(|w| w.collapsed()).map(|w| w.run.time);
        let end = end.fold(f64::INFINITY, f64::min);
        for (wall, side) in walls.iter_mut().zip(Side::BOTH) {
            if wall.run.time > end && wall.run.outcome != Outcome::Interrupted {
                *wall = self.observed(quake, 1.0, side, None, Some(end), &Quiet(progress))?;
            }
        }
        Ok(walls)
    }

    /// One wall under the unscaled record, with full histories.
    ///
    /// Errors: those of the analysis. Collapse is a result, not an error.
    pub fn single(&self, quake: &StripQuake, side: Side, progress: &dyn Progress) -> Result<WallRun, StripError> {
        self.observed(quake, 1.0, side, None, None, progress)
    }

    /// Both walls of a model that holds both.
    ///
    /// Errors: as [`StripModel::histories`].
    fn both(
        &self,
        quake: &StripQuake,
        scale: f64,
        checkpoint: Option<Checkpoint>,
        progress: &dyn Progress,
    ) -> Result<[WallRun; 2], StripError> {
        let [mut first, mut second] = Side::BOTH.map(|side| WallObserver::new(self, side, None, quake.states));
        let run = self.march(quake, scale, Side::Front, checkpoint, &mut [&mut first, &mut second], progress)?;
        let of = |observer: WallObserver<'_>| -> Result<WallRun, StripError> {
            Ok(WallRun { lost: observer.lost(), history: observer.finish()?, run: run.clone() })
        };
        Ok([of(first)?, of(second)?])
    }

    /// Every run of a wall.
    fn observed(
        &self,
        quake: &StripQuake,
        scale: f64,
        side: Side,
        checkpoint: Option<Checkpoint>,
        until: Option<f64>,
        progress: &dyn Progress,
    ) -> Result<WallRun, StripError> {
        let mut observer = WallObserver::new(self, side, until, quake.states);
        let run = self.march(quake, scale, side, checkpoint, &mut [&mut observer], progress)?;
        Ok(WallRun { lost: observer.lost(), history: observer.finish()?, run })
    }

    /// Samples and steps of a run.
    pub fn grid(&self, quake: &StripQuake) -> Grid {
        let record = &quake.horizontal;
        let end = quake.until.unwrap_or_else(|| record.duration());
        Grid::new(record.dt, end, 0.0, quake.longest_step)
    }

    fn march(
        &self,
        quake: &StripQuake,
        scale: f64,
        side: Side,
        checkpoint: Option<Checkpoint>,
        observers: &mut [&mut dyn Observe],
        progress: &dyn Progress,
    ) -> Result<Run, StripError> {
        let grid = self.grid(quake);
        let motion = |record: &Record, factor: f64| {
            let scaled: Vec<f64> = record.acceleration.iter().map(|a| factor * a).collect();
            Motion::sampled(record.dt, &scaled, &grid)
        };
        let mut load = Load::ground(0, motion(&quake.horizontal, scale * sign(side)));
        if let Some(vertical) = &quake.vertical {
            let motion = motion(vertical, scale);
            // Elements of the liquid have a mass that the ground lifts.
            if self.chain.is_none() {
                load.forces.push((self.vertical_pressure(), motion.clone()));
            }
            load.ground[2] = Some(motion);
        }
        let mut settings = Settings::new(grid);
        settings.scheme = quake.scheme;
        settings.constant = self.at_rest();
        settings.newton = quake.newton.clone();
        settings.halvings = quake.halvings;
        settings.checkpoint = checkpoint;
        let problem =
            Problem { model: &self.model, assembler: &self.assembler, symbolic: &self.symbolic, system: &self.system };
        Ok(march(problem, &load, &settings, observers, progress)?)
    }

    /// Both walls at every scale on `threads` threads; `each` is called for every level as it is finished, so that the caller may
    /// keep it. A wall that was interrupted leaves its level out.
    ///
    /// Errors: the first failure of an analysis, in the order of the scales.
    pub fn incremental(
        &self,
        quake: &StripQuake,
        scales: &[f64],
        threads: usize,
        progress: &dyn Progress,
        each: impl FnMut(&StripLevel),
    ) -> Result<Vec<StripLevel>, StripError> {
        self.incremental_from(quake, scales, threads, &|_, _| None, progress, each)
    }

    /// As [`StripModel::incremental`], with the `checkpoint` of each scale and wall.
    ///
    /// Errors: as there; a checkpoint that cannot be written or is of another run.
    pub fn incremental_from(
        &self,
        quake: &StripQuake,
        scales: &[f64],
        threads: usize,
        checkpoint: &(dyn Fn(f64, Side) -> Option<Checkpoint> + Sync),
        progress: &dyn Progress,
        mut each: impl FnMut(&StripLevel),
    ) -> Result<Vec<StripLevel>, StripError> {
        // Highest first: these cut their steps and take longest.
        let mut order: Vec<f64> = scales.to_vec();
        order.sort_by(|a, b| b.total_cmp(a));
        let run = |scale: f64| -> Result<StripLevel, StripError> {
            if self.chain.is_some() {
                let both = self.both(quake, scale, checkpoint(scale, Side::Front), &Quiet(progress))?;
                return Ok(StripLevel { scale, walls: both.map(StripRun::of) });
            }
            let wall = |side| self.resumable(quake, scale, side, checkpoint(scale, side), &Quiet(progress));
            Ok(StripLevel { scale, walls: [wall(Side::Front)?, wall(Side::Back)?] })
        };
        let complete = |level: &StripLevel| level.walls.iter().all(|w| w.outcome != Outcome::Interrupted);
        let found = ida::incremental(&order, threads, progress, run, |_, level| {
            if let Ok(level) = level
                && complete(level)
            {
                each(level);
            }
        });
        let mut levels: Vec<StripLevel> = found.into_iter().flatten().collect::<Result<_, _>>()?;
        levels.retain(complete);
        levels.sort_by(|a, b| a.scale.total_cmp(&b.scale));
        Ok(levels)
    }
}

/// Sign of the record: the wall at −L is the one at +L under the record with the opposite sign.
fn sign(side: Side) -> f64 {
    match side {
        Side::Front => 1.0,
        Side::Back => -1.0,
    }
}

/// Passes on the time steps that are done, and no stage: another wall counts on the same one.
struct Counted<'a> {
    progress: &'a dyn Progress,
    stepping: AtomicBool,
}

impl<'a> Counted<'a> {
    fn new(progress: &'a dyn Progress) -> Counted<'a> {
        Counted { progress, stepping: AtomicBool::new(false) }
    }
}

impl Progress for Counted<'_> {
    fn warn(&self, what: &str) {
        self.progress.warn(what);
    }

    fn stage(&self, name: &str, _steps: u64) {
        self.stepping.store(name == "time steps", Ordering::Relaxed);
    }

    fn advance(&self, steps: u64) {
        if self.stepping.load(Ordering::Relaxed) {
            self.progress.advance(steps);
        }
    }

    fn interrupted(&self) -> bool {
        self.progress.interrupted()
    }
}
