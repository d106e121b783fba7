//! A cylinder at rising scales of its record.

use fem::analysis::ida;
use fem::analysis::march::{Outcome, Run};
use fem::cores;
use fem::liquid::separation::Parting;
use fem::progress::{Progress, Quiet};

use super::super::CheckpointFile;
use super::super::parting::parting;
use super::describe::{assumptions, facts};
use super::extremes;
use super::limits::limits;
use super::march::Cylinder;
use super::model::CylinderModel;
use super::points::{Happening, look};
use super::recorded::{BASE_MOMENT, WAVE_BACK, WAVE_FRONT};
use super::state::maps;
use super::watch::Watch;
use crate::FeError;
use crate::checks::checked_motion;
use results::nonlinear::{Departure, DepartureKind};
use results::{Collapse, Fact, FirstCrack, IdaRun};

impl Cylinder<'_> {
    /// The model in numbers.
    pub(crate) fn facts(&self) -> Result<Vec<Fact>, FeError> {
        let step = self.step(&checked_motion(self.case)?.horizontal);
        Ok(facts(&self.tank, step))
    }

    /// Assumptions, one sentence each.
    pub(crate) fn assumptions(&self) -> Vec<String> {
        assumptions(self.case, self.options, &self.tank, &self.span)
    }

    /// The tank at every scale on `threads` threads, by ascending scale; `each` receives every finished run.
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
        let motion = checked_motion(self.case)?;
        // Highest first: these halve their steps and take longest.
        let mut order: Vec<f64> = scales.to_vec();
        order.sort_by(|a, b| b.total_cmp(a));
        // Runs at a time share the cores.
        let inner = cores::share(threads.min(scales.len()));
        let run = |scale: f64| -> Result<Option<IdaRun>, FeError> {
            let file = checkpoint(scale).map(|mut file| {
                file.key = format!("{} {scale}", file.key);
                file
            });
            let (watch, run) = self.march(motion, scale, inner, file.as_ref(), &Quiet(progress))?;
            Ok((run.outcome != Outcome::Interrupted)
                .then(|| self.summary(scale, motion.horizontal.pga(), &watch, &run)))
        };
        let found = ida::incremental(&order, threads, progress, run, |_, found| {
            if let Ok(Some(run)) = found {
                each(run.clone());
            }
        });
        let found: Vec<Option<IdaRun>> = found.into_iter().flatten().collect::<Result<_, _>>()?;
        let mut runs: Vec<IdaRun> = found.into_iter().flatten().collect();
        runs.sort_by(|a, b| a.scale.total_cmp(&b.scale));
        Ok(runs)
    }

    fn summary(&self, scale: f64, pga: f64, watch: &Watch<'_>, run: &Run) -> IdaRun {
        let (tank, seen, recorder) = (&self.tank, &watch.seen, &watch.recorder);
        let last = look(tank, &run.state);
        let mut worst = seen.worst.clone().unwrap_or_else(|| last.clone());
        worst.envelop(&last);
        // Relative to the static state, in which the wall has deflected and the surface has settled.
        let swing = |k: usize| match recorder.histories[k].first() {
            Some(rest) => (recorder.ranges[k].max - rest).max(rest - recorder.ranges[k].min),
            None => 0.0,
        };
        let most = |list: &[f64]| list.iter().copied().fold(0.0, f64::max);
        let columns = tank.cells.columns();
        let cracked = worst.crack_width.iter().flat_map(|face| face.iter().enumerate());
        let highest = cracked.filter(|(_, w)| **w > 0.0).map(|(cell, _)| {
            let row = cell / columns;
            0.5 * (tank.cells.z[row] + tank.cells.z[row + 1])
        });
        let first_crack = seen.first.iter().find(|f| f.0 == Happening::Crack).map(|&(_, time, cell)| {
            let row = cell / columns;
            let at = recorder.times.partition_point(|t| *t < time - 1e-12);
            FirstCrack {
                time,
                height: 0.5 * (tank.cells.z[row] + tank.cells.z[row + 1]),
                base_moment: recorder.histories[BASE_MOMENT].get(at).map_or(0.0, |m| m.abs()),
            }
        });
        let collapse = match &run.outcome {
            Outcome::Collapsed(collapse) => {
                Some(Collapse { time: collapse.time, reason: collapse.failure.to_string() })
            }
            Outcome::Stopped { reason } => Some(Collapse { time: run.time, reason: reason.clone() }),
            _ => None,
        };
        let maps = maps(self.case, tank, watch, &worst, &last);
        let energy = run.balance.samples.last().map_or(0.0, |e| e.hysteretic);
        IdaRun {
            scale,
            pga: scale * pga,
            collapse,
            wave: swing(WAVE_FRONT).max(swing(WAVE_BACK)),
            wall_displacement: seen.displacement.0,
            wall_displacement_time: seen.displacement.1,
            departures: departures(tank, watch),
            base_moment: swing(BASE_MOMENT),
            section_moment: None,
            moment_parts: None,
            first_crack,
            parting: Parting::first(&watch.separation, watch.openings.as_ref()).map(parting),
            limits: limits(self, watch, &worst),
            open_share: extremes::open_history(tank, watch).map(|open| open.into_iter().fold(0.0, f64::max)),
            extremes: extremes::extremes(tank, watch, &maps),
            highest_crack: highest.fold(0.0, f64::max),
            largest_crack: worst.crack_strain,
            plastic_strain: most(&last.plastic_strain),
            bar_stress: most(&worst.bar_stress),
            bar_plastic_strain: most(&worst.bar_plastic_strain),
            hysteretic_energy: watch.copies() * energy,
            wall_damping: tank.wall_ratio,
            halvings: run.cuts,
            steps: run.cost.steps,
            energy_residual: run.balance.error(),
        }
    }
}

/// Bars beyond their rupture strain: their law continues to harden.
pub(super) fn departures(tank: &CylinderModel, watch: &Watch<'_>) -> Vec<Departure> {
    let rupture = watch.seen.first.iter().find(|f| f.0 == Happening::BarRupture);
    let departure = |&(_, time, cell): &(Happening, f64, usize)| {
        let z = &tank.cells.z[cell / tank.cells.columns()..];
        Departure { kind: DepartureKind::BarStrain, time, theta: None, height: 0.5 * (z[0] + z[1]), passed: None }
    };
    rupture.map(departure).into_iter().collect()
}
