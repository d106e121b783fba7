//! A strip at rising scales of its record.

use fem::analysis::march::Outcome;
use fem::progress::Progress;
use fem::strip::StripLevel;

use super::super::CheckpointFile;
use super::super::parting::parting;
use super::build::Strip;
use super::departures::{base_moment, departure};
use super::failure::failed;
use crate::FeError;
use results::channel::Side;
use results::{Collapse, FirstCrack, IdaRun};

impl Strip {
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
        let file = |scale, side| checkpoint(scale).map(|file| file.wall(Side::BOTH[side as usize], self.seconds));
        let levels = self
            .model
            .incremental_from(&self.quake, scales, threads, &file, progress, |level| {
                each(self.run(level));
            })
            .map_err(failed)?;
        Ok(levels.iter().map(|level| self.run(level)).collect())
    }

    fn run(&self, level: &StripLevel) -> IdaRun {
        let demand = level.demand();
        let collapse = level.walls.iter().find_map(|wall| match &wall.outcome {
            Outcome::Collapsed(collapse) => Some(Collapse {
                time: collapse.time,
                reason: collapse.failure.to_string(),
            }),
            // A run that exceeded a limit of its model has not collapsed.
            Outcome::Stopped { reason } if !wall.demand.departures.iter().any(|d| d.kind.stops()) => Some(Collapse {
                time: wall.time,
                reason: reason.clone(),
            }),
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
            departures: demand.departures.iter().map(|d| departure(d, None)).collect(),
            base_moment: demand.base_moment,
            section_moment: Some(demand.section_moment),
            moment_parts: Some(base_moment(&demand.parts, "", demand.section_moment)),
            first_crack: demand.first_crack.map(|c| FirstCrack {
                time: c.time,
                height: c.height,
                base_moment: c.base_moment,
            }),
            parting: demand.parting.map(parting),
            highest_crack: demand.highest_crack,
            largest_crack: demand.largest_crack,
            plastic_strain: demand.plastic_strain,
            bar_stress: demand.bar_stress,
            bar_plastic_strain: demand.bar_plastic_strain,
            hysteretic_energy: a.hysteretic.max(b.hysteretic),
            wall_damping: self.model.wall_ratio(),
            halvings: level.halvings(),
            steps: a.steps + b.steps,
            energy_residual: level.imbalance(),
        }
    }
}
