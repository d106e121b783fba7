//! The one shape of an engine: what it refuses of a case, what a run of it takes, the run.

use std::collections::BTreeMap;

use fem::progress::Progress;
use results::{EngineId, Run, Series, Snapshots};
use tank::{Case, Quantity, Shape};

use crate::estimate::Estimate;
use crate::nonlinear::scope::{self, Place, Purpose, Refusal};
use crate::nonlinear::{CheckpointFile, NonlinearOptions};
use crate::solid::SolidOptions;
use crate::{FeError, Options, harmonic, nonlinear, simulate_watched, solid};

/// What an engine is asked for: a case, and the options of all engines, of which it takes its own.
#[derive(Clone, Copy, Debug)]
pub struct Task<'a> {
    /// The case, complete and validated.
    pub case: &'a Case,
    /// Options of the linear engines.
    pub linear: &'a Options,
    /// Options of the three-dimensional engine alone.
    pub solid: &'a SolidOptions,
    /// Options of the nonlinear engine alone.
    pub nonlinear: &'a NonlinearOptions,
    /// Where a run that takes long is kept while it is under way.
    pub checkpoint: Option<&'a CheckpointFile>,
}

/// What an engine gives back.
#[derive(Clone, Debug)]
pub struct Simulation {
    /// Comparable values, SI.
    pub values: BTreeMap<Quantity, f64>,
    /// The run in the vocabulary of the results folder.
    pub result: Run,
    /// Time histories.
    pub series: Series,
    /// What the engine assumed, one sentence each.
    pub assumptions: Vec<String>,
    /// Warnings, one sentence each.
    pub notes: Vec<String>,
    /// States of the three-dimensional model at moments, where they were asked for.
    pub snapshots: Option<Snapshots>,
}

/// A finite-element engine.
pub trait Engine: Sync {
    /// Which one.
    fn id(&self) -> EngineId;

    /// What it refuses of a case whose input is valid; empty if it can run.
    fn refuses(&self, task: &Task<'_>) -> Vec<Refusal>;

    /// Whether it has the layers of a wall themselves instead of one material that stands for them.
    fn has_layers(&self) -> bool {
        false
    }

    /// Whether a run ends at the user's wish with what it has until then.
    fn stops(&self) -> bool {
        true
    }

    /// What a run takes.
    ///
    /// Errors: options out of range; a response longer than the limits.
    fn estimate(&self, task: &Task<'_>) -> Result<Estimate, FeError>;

    /// Time history of a case. Collapse is a result, not an error.
    ///
    /// Errors: no ground motion; something it does not model; options out of range; a model that cannot be built or solved; a
    /// checkpoint that cannot be written or belongs to another run; interrupted before there is anything to show.
    fn run(&self, task: &Task<'_>, progress: &dyn Progress) -> Result<Simulation, FeError>;
}

/// All engines, in the order of [`EngineId`].
pub const ALL: [&dyn Engine; 3] = [&Harmonic, &Solid, &Nonlinear];

/// The engine of an id.
pub fn engine(id: EngineId) -> &'static dyn Engine {
    ALL[id as usize]
}

/// One Fourier harmonic at a time.
struct Harmonic;

impl Engine for Harmonic {
    fn id(&self) -> EngineId {
        EngineId::Harmonic
    }

    fn refuses(&self, _: &Task<'_>) -> Vec<Refusal> {
        Vec::new()
    }

    fn stops(&self) -> bool {
        false
    }

    fn estimate(&self, task: &Task<'_>) -> Result<Estimate, FeError> {
        harmonic::estimate(task.case, task.linear)
    }

    fn run(&self, task: &Task<'_>, progress: &dyn Progress) -> Result<Simulation, FeError> {
        simulate_watched(task.case, task.linear, progress)
    }
}

/// Three-dimensional elements.
struct Solid;

impl Engine for Solid {
    fn id(&self) -> EngineId {
        EngineId::Solid
    }

    fn refuses(&self, task: &Task<'_>) -> Vec<Refusal> {
        match task.case.tank.shape {
            Shape::Cylinder { .. } => Vec::new(),
            Shape::Rectangle { .. } => vec![Refusal {
                place: Place::Shape,
                message: "the three-dimensional engine models upright cylinders".into(),
                found: String::new(),
                allowed: "\"cylinder\"".into(),
                help: "use --fe harmonic for a rectangular tank".into(),
            }],
        }
    }

    fn estimate(&self, task: &Task<'_>) -> Result<Estimate, FeError> {
        solid::estimate(task.case, task.linear, task.solid)
    }

    fn run(&self, task: &Task<'_>, progress: &dyn Progress) -> Result<Simulation, FeError> {
        solid::simulate(task.case, task.linear, task.solid, progress)
    }
}

/// Walls that yield and crack, in large rotations.
struct Nonlinear;

impl Engine for Nonlinear {
    fn id(&self) -> EngineId {
        EngineId::Nonlinear
    }

    fn refuses(&self, task: &Task<'_>) -> Vec<Refusal> {
        scope::refusals(task.case, task.nonlinear, Purpose::History)
    }

    fn has_layers(&self) -> bool {
        true
    }

    fn estimate(&self, task: &Task<'_>) -> Result<Estimate, FeError> {
        nonlinear::estimate(task.case, task.nonlinear)
    }

    fn run(&self, task: &Task<'_>, progress: &dyn Progress) -> Result<Simulation, FeError> {
        nonlinear::simulate(task.case, task.nonlinear, task.checkpoint, progress)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_id_has_its_engine() {
        assert_eq!(ALL.len(), EngineId::ALL.len());
        assert!(EngineId::ALL.iter().all(|&id| engine(id).id() == id));
    }

    #[test]
    fn an_engine_refuses_what_it_does_not_model() {
        let mut case = crate::harmonic::test_tanks::broad();
        let (linear, solid) = (Options::default(), SolidOptions::default());
        let nonlinear = NonlinearOptions::new(case.damping);
        let refusals = |case: &Case| {
            let task = Task {
                case,
                linear: &linear,
                solid: &solid,
                nonlinear: &nonlinear,
                checkpoint: None,
            };
            EngineId::ALL.map(|id| {
                engine(id)
                    .refuses(&task)
                    .into_iter()
                    .map(|r| r.place)
                    .collect::<Vec<_>>()
            })
        };
        assert_eq!(refusals(&case), [Vec::new(), Vec::new(), Vec::new()]);
        case.tank.shape = Shape::Rectangle {
            length: 3.0,
            breadth: 3.0,
            strip: false,
        };
        assert_eq!(refusals(&case), [Vec::new(), vec![Place::Shape], vec![Place::Shape]]);
    }
}
