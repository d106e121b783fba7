//! A strip at rising scales of its record.

use fem::analysis::march::{Outcome, Range};
use fem::progress::Progress;

use super::case::Strip;
use super::history::Scalar;
use super::run::{StripLevel, StripRun};
use crate::FeError;
use crate::checkpoint::CheckpointFile;
use crate::linear::limits;
use crate::nonlinear::extremes::of_range;
use crate::nonlinear::parting::parting;
use results::channel::{OnWall, Side};
use results::nonlinear::{BaseMoment, TwoSided};
use results::{Channel, Collapse, IdaRun, Limit};

/// Extremes of a wall: both signs.
fn extremes((wall, side): (&StripRun, Side)) -> Vec<TwoSided> {
    let channel = |scalar: Scalar| match scalar {
        Scalar::Elevation => Some(Channel::Wave(side)),
        Scalar::Deflection => Some(Channel::Deflection(side)),
        Scalar::Shear => Some(Channel::BaseOn(OnWall::Shear, side)),
        Scalar::Moment => Some(Channel::BaseOn(OnWall::Moment, side)),
        Scalar::SectionMoment => Some(Channel::SectionMoment(side)),
        _ => None,
    };
    let of = |(scalar, rest, range): &(Scalar, f64, Range)| {
        let channel = channel(*scalar)?;
        of_range(channel.title(), channel.dimension(), *rest, range)
    };
    wall.demand.ranges.iter().filter_map(of).collect()
}

impl Strip {
    /// Depth of the liquid [m].
    fn depth(&self) -> f64 {
        self.model.tank.liquid.depth
    }

    /// Limits of validity of a run with waves of the height `wave` [m].
    pub(super) fn limits(&self, wave: f64, suction: Option<Limit>) -> Vec<Limit> {
        let mut found = limits::waves(&self.case, wave, None).to_vec();
        found.extend(suction);
        let omega = self.model.wall_frequency();
        found.push(limits::compressibility(&self.case, omega / std::f64::consts::TAU));
        found.push(limits::record(omega, self.quake.horizontal.dt));
        found
    }

    /// Both walls at every scale on `threads` threads, by ascending scale; `each` receives every finished run.
    ///
    /// * `checkpoint`: checkpoint of the run of a scale; the caller removes it
    ///
    /// Errors: a failure of the analysis; a checkpoint that cannot be written or belongs to another run. Collapse is a result,
    /// not an error.
    pub(crate) fn incremental(
        &self,
        scales: &[f64],
        threads: usize,
        checkpoint: &(dyn Fn(f64) -> Option<CheckpointFile> + Sync),
        progress: &dyn Progress,
        mut each: impl FnMut(IdaRun),
    ) -> Result<Vec<IdaRun>, FeError> {
        let file = |scale, side| checkpoint(scale).map(|file| file.wall(side, self.seconds));
        let levels = self.model.incremental_from(&self.quake, scales, threads, &file, progress, |level| {
            each(self.run(level));
        })?;
        Ok(levels.iter().map(|level| self.run(level)).collect())
    }

    fn run(&self, level: &StripLevel) -> IdaRun {
        let demand = level.demand();
        let rise = |wall: &StripRun| {
            let found = wall.demand.ranges.iter().find(|r| r.0 == Scalar::Elevation);
            found.map_or(0.0, |(_, rest, range)| range.max - rest)
        };
        let wave = level.walls.iter().map(rise).fold(0.0, f64::max);
        let collapse = level.walls.iter().find_map(|wall| match &wall.outcome {
            Outcome::Collapsed(collapse) => {
                Some(Collapse { time: collapse.time, reason: collapse.failure.to_string() })
            }
            // A run that exceeded a limit of its model has not collapsed.
            Outcome::Stopped { reason } if !wall.demand.departures.iter().any(|d| d.kind.stops()) => {
                Some(Collapse { time: wall.time, reason: reason.clone() })
            }
            _ => None,
        });
        let [a, b] = &level.walls;
        IdaRun {
            scale: level.scale,
            pga: level.scale * self.quake.horizontal.pga(),
            collapse,
            wave: demand.wave,
            wall_displacement: demand.deflection,
            wall_displacement_time: demand.deflection_time,
            departures: demand.departures,
            base_moment: demand.base_moment,
            section_moment: Some(demand.section_moment),
            moment_parts: Some(BaseMoment { largest_section: demand.section_moment, ..demand.parts }),
            first_crack: demand.first_crack,
            parting: demand.parting.map(parting),
            limits: self.limits(wave, None),
            open_share: demand.open.map(|length| length / self.depth()),
            extremes: level.walls.iter().zip(Side::BOTH).flat_map(extremes).collect(),
            highest_crack: demand.highest_crack,
            largest_crack: demand.largest_crack,
            plastic_strain: demand.plastic_strain,
            bar_stress: demand.bar_stress,
            bar_plastic_strain: demand.bar_plastic_strain,
            hysteretic_energy: a.hysteretic.max(b.hysteretic),
            wall_damping: self.model.wall_ratio(),
            halvings: level.halvings(),
            steps: level.walls[..self.model.marches()].iter().map(|w| w.steps).sum(),
            energy_residual: level.imbalance(),
        }
    }
}
