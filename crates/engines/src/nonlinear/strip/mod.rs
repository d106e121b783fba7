//! From a case to the strip of the nonlinear engine: fibre walls, liquid condensed onto them.
//!
//! [`Strip`] is the model; [`simulate`] runs it once and tells everything, [`Strip::incremental`] at rising scales.

mod departures;
mod describe;
pub(super) mod estimate;
mod modes;
mod report;
pub(super) mod section;
mod simulate;
mod walls;

#[cfg(test)]
mod tests;

use std::sync::Arc;

use fem::analysis::AnalysisError;
use fem::analysis::march::Outcome;
use fem::analysis::newton::Options;
use fem::analysis::scheme::TimeScheme;
use fem::element::fibre_beam;
use fem::liquid::strip::StripLiquid;
use fem::progress::Progress;
use fem::strip::{StripError, StripLevel, StripModel, StripQuake, StripTank};
use tank::Case;
use tank::Shape;

use super::laws::unsupported;
use super::{CheckpointFile, Contact, NonlinearOptions, parting};
use crate::FeError;
use departures::{base_moment, departure};
use describe::{assumptions, damping, facts};
use results::{Collapse, Fact, FirstCrack, IdaRun};
use section::{course_at, levels, section};
use simulate::wall_file;

pub(super) use simulate::{simulate, wall_path};

/// Sloshing modes of the condensed liquid: the tenth holds 1e-4 of the liquid's mass.
const SLOSHING_MODES: usize = 12;
/// Elements over the wall unless the user says otherwise.
pub(super) const ELEMENTS: u32 = 40;
/// Steps of the time integration in a period of the first mode of wall and liquid.
const STEPS_PER_PERIOD: f64 = 20.0;

/// A strip ready to be shaken.
pub struct Strip {
    model: StripModel,
    quake: StripQuake,
    /// Computing time between two checkpoints [s].
    seconds: f64,
    /// The model in numbers.
    pub facts: Vec<Fact>,
    /// What was assumed, one sentence each.
    pub assumptions: Vec<String>,
}

fn failed(error: impl Into<StripError>) -> FeError {
    match error.into() {
        StripError::Analysis(AnalysisError::Checkpoint(fault)) => FeError::Checkpoint(fault),
        other => FeError::Analysis(other.to_string()),
    }
}

impl Strip {
    /// The strip of a case with its record.
    ///
    /// Errors: no record; a tank that is no strip; a wall, a law or an option that the strip does not know; parameters out of
    /// range.
    pub fn new(case: &Case, options: &NonlinearOptions) -> Result<Strip, FeError> {
        let Some(motion) = &case.ground_motion else {
            return Err(FeError::NoRecord);
        };
        let Shape::Rectangle {
            length, strip: true, ..
        } = case.tank.shape
        else {
            return unsupported(
                "the nonlinear engine runs strips of long rectangular tanks (shape rectangle, strip true); this tank is none",
            );
        };
        if case.tank.roof.mass > 0.0 {
            return unsupported("the nonlinear strip knows no roof: leave its mass out");
        }
        let levels = levels(case, options.elements.map_or(ELEMENTS, |e| e.height));
        let mut sections = Vec::new();
        for ends in levels.windows(2) {
            let layers = course_at(case, 0.5 * (ends[0] + ends[1])).build_up();
            sections.push(Arc::new(section(&layers, ends[1] - ends[0], options)?));
        }
        let liquid = StripLiquid {
            half_width: 0.5 * length,
            depth: case.liquid.fill_height,
            density: case.liquid.density,
            gravity: case.gravity,
        };
        let tank = StripTank {
            levels,
            sections,
            options: fibre_beam::Options::default(),
            base_spring: None,
            liquid,
            sloshing: SLOSHING_MODES,
            contact: match options.contact {
                Contact::Bonded => fem::strip::Contact::Bonded,
                Contact::Opening => fem::strip::Contact::Joined {
                    opens: true,
                    penalty: None,
                },
            },
        };
        let mut model = StripModel::new(&tank, damping(options.damping, &liquid)?).map_err(failed)?;
        if !options.self_weight {
            model.weight.fill(0.0);
        }
        let record = &motion.horizontal;
        let period = std::f64::consts::TAU / model.wall_frequency();
        let step = options
            .time_step
            .unwrap_or_else(|| (period / STEPS_PER_PERIOD).min(0.5 * record.dt));
        let mut quake = StripQuake::new(record.clone(), step);
        quake.vertical.clone_from(&motion.vertical);
        quake.scheme = TimeScheme::GeneralizedAlpha {
            radius: options.spectral_radius,
        };
        if options.contact == Contact::Opening {
            quake.newton = Options::for_contact();
        }
        let facts = facts(&model, &tank, step);
        Ok(Strip {
            model,
            quake,
            seconds: options.checkpoint,
            facts,
            assumptions: assumptions(case, options),
        })
    }

    /// Both walls at every scale on `threads` threads, by ascending scale; `each` gets every run as it is finished.
    ///
    /// * `checkpoint`: where the run of a scale keeps what it needs to be resumed; left to the caller to remove
    ///
    /// Errors: a failure of the analysis; a checkpoint that cannot be written or is of another run. Collapse is none.
    pub fn incremental(
        &self,
        scales: &[f64],
        threads: usize,
        checkpoint: &(dyn Fn(f64) -> Option<CheckpointFile> + Sync),
        progress: &dyn Progress,
        mut each: impl FnMut(IdaRun),
    ) -> Result<Vec<IdaRun>, FeError> {
        let file = |scale, side| checkpoint(scale).map(|file| wall_file(&file, side, self.seconds));
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
            // A run that has left its model has not collapsed.
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
