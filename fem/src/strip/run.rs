//! A wall of the strip through an earthquake, and through the same earthquake at rising scales.

use codes::record::Record;

use super::{Demand, Side, StripError, StripModel};
use crate::analysis::ida::{self, Point};
use crate::analysis::march::{Instant, Outcome, Problem, Settings, march};
use crate::analysis::motion::{Grid, Motion};
use crate::analysis::newton::Options;
use crate::analysis::scheme::TimeScheme;
use crate::analysis::transient::Load;
use crate::progress::{Progress, Silent};

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

    /// Whether a wall found no equilibrium: its demands are lower bounds.
    pub fn collapsed(&self) -> bool {
        self.walls.iter().any(|w| matches!(w.outcome, Outcome::Collapsed(_)))
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
        Point {
            scale: self.scale,
            demand: demand(&self.demand()),
            censored: self.collapsed(),
        }
    }
}

impl StripModel {
    /// The wall of `side` under `scale` times the records, from rest under weight and pressure.
    ///
    /// Errors: those of the analysis; collapse is none.
    pub fn run(
        &self,
        quake: &StripQuake,
        scale: f64,
        side: Side,
        progress: &dyn Progress,
    ) -> Result<StripRun, StripError> {
        let record = &quake.horizontal;
        let end = quake.until.unwrap_or_else(|| record.duration());
        let grid = Grid::new(record.dt, end, 0.0, quake.longest_step);
        let motion = |record: &Record, factor: f64| {
            let scaled: Vec<f64> = record.acceleration.iter().map(|a| factor * a).collect();
            Motion::sampled(record.dt, &scaled, &grid)
        };
        let mut load = Load::ground(0, motion(record, scale * side.sign()));
        if let Some(vertical) = &quake.vertical {
            let motion = motion(vertical, scale);
            load.forces.push((self.vertical_pressure(), motion.clone()));
            load.ground[2] = Some(motion);
        }
        let mut settings = Settings::new(grid);
        settings.scheme = quake.scheme;
        settings.constant = self.weight.clone();
        settings.newton = quake.newton.clone();
        settings.halvings = quake.halvings;
        let problem = Problem {
            model: &self.model,
            assembler: &self.assembler,
            symbolic: &self.symbolic,
            system: &self.system,
        };
        let (mut demand, mut failure) = (Demand::default(), None);
        let mut observer = |now: &Instant<'_>| {
            let seen = demand.see(self, now.time, now.state, now.ground[0]);
            failure = failure.take().or(seen.err());
        };
        let run = march(problem, &load, &settings, &mut [&mut observer], progress)?;
        if let Some(failure) = failure {
            return Err(failure);
        }
        Ok(StripRun {
            demand,
            time: run.time,
            hysteretic: run.balance.samples.last().map_or(0.0, |e| e.hysteretic),
            imbalance: run.balance.error(),
            halvings: run.cuts,
            steps: run.cost.steps,
            iterations: run.cost.iterations,
            outcome: run.outcome,
        })
    }

    /// Both walls at every scale on `threads` threads; `each` hears of every level as it is finished, so that the caller may
    /// keep it. A wall that was interrupted leaves its level out.
    ///
    /// Errors: the first failure of an analysis, in the order of the scales.
    pub fn incremental(
        &self,
        quake: &StripQuake,
        scales: &[f64],
        threads: usize,
        progress: &dyn Progress,
        mut each: impl FnMut(&StripLevel),
    ) -> Result<Vec<StripLevel>, StripError> {
        // Highest first: these cut their steps and take longest.
        let mut order: Vec<f64> = scales.to_vec();
        order.sort_by(|a, b| b.total_cmp(a));
        let run = |scale: f64| -> Result<StripLevel, StripError> {
            let wall = |side| self.run(quake, scale, side, &Quiet(progress));
            Ok(StripLevel {
                scale,
                walls: [wall(Side::Positive)?, wall(Side::Negative)?],
            })
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

/// Passes on the wish to stop and nothing else: the levels are the progress.
struct Quiet<'a>(&'a dyn Progress);

impl Progress for Quiet<'_> {
    fn stage(&self, name: &str, steps: u64) {
        Silent.stage(name, steps);
    }

    fn advance(&self, steps: u64) {
        Silent.advance(steps);
    }

    fn interrupted(&self) -> bool {
        self.0.interrupted()
    }
}
