//! The interface of an engine: refusals, estimate, run.

use std::collections::BTreeMap;

use fem::progress::Progress;
use results::{EngineId, Omittable, Run, Series, Snapshots};
use tank::case::GroundMotion;
use tank::demand::Demands;
use tank::refusal::Refusal;
use tank::{Case, Quantity};

use crate::FeError;
use crate::checkpoint::CheckpointFile;
use crate::estimate::Estimate;
use crate::spectral::ModalUnits;
use tank::options::LinearOptions as Options;
use tank::options::nonlinear::NonlinearOptions;
use tank::options::solid::SolidOptions;

/// Input of an engine: a case and the options of all engines; each reads its own.
#[derive(Clone, Copy, Debug)]
pub struct Task<'a> {
    /// The case, complete and validated.
    pub case: &'a Case,
    /// Options of the linear engines.
    pub linear: &'a Options,
    /// Options of the three-dimensional engine; the others keep states as often as it does.
    pub solid: &'a SolidOptions,
    /// Options of the nonlinear engine alone.
    pub nonlinear: &'a NonlinearOptions,
    /// Checkpoint of a long run.
    pub checkpoint: Option<&'a CheckpointFile>,
    /// Parts of the results that nobody needs; an engine may compute them all the same.
    pub without: &'a [Omittable],
}

/// Output of an engine.
#[derive(Clone, Debug)]
pub struct Simulation {
    /// Comparable values, SI.
    pub values: BTreeMap<Quantity, f64>,
    /// The run in the vocabulary of the results folder.
    pub result: Run,
    /// Time histories.
    pub series: Series,
    /// Assumptions, one sentence each.
    pub assumptions: Vec<String>,
    /// Warnings, one sentence each.
    pub notes: Vec<String>,
    /// States of the model at given times, if requested: of the three-dimensional engine, a nonlinear cylinder, a bottom plate that lifts.
    pub snapshots: Option<Snapshots>,
    /// What limit states compare with capacities; none of an engine or a tank that does not give it.
    pub demands: Option<Demands>,
    /// The response to horizontal motion mode by mode, of a linear engine.
    pub units: Option<ModalUnits>,
    /// Notes and assumptions of the wall held down, whose modes [`units`](Simulation::units) are; none where they are those of the run.
    pub of_modes: Option<(Vec<String>, Vec<String>)>,
    /// The modes on a second mesh, with the length of its elements over those of the run.
    pub second: Option<(f64, ModalUnits)>,
    /// The motion of the slab under a tank on isolators, in place of that of the ground.
    pub slab_motion: Option<GroundMotion>,
}

impl Simulation {
    /// A run of which nothing but values and demands is used.
    pub(crate) fn unreported(engine: EngineId, values: BTreeMap<Quantity, f64>, demands: Demands) -> Simulation {
        Simulation {
            values,
            result: Run::new(engine),
            series: Series::default(),
            assumptions: Vec::new(),
            notes: Vec::new(),
            snapshots: None,
            demands: Some(demands),
            units: None,
            of_modes: None,
            second: None,
            slab_motion: None,
        }
    }
}

/// A finite-element engine.
pub trait Engine: Sync {
    /// Its id.
    fn id(&self) -> EngineId;

    /// Refusals of a valid case; empty if the engine can run it.
    fn refuses(&self, task: &Task<'_>) -> Vec<Refusal>;

    /// Whether it models the layers of a wall, not one equivalent material.
    fn has_layers(&self) -> bool {
        false
    }

    /// Whether an interrupted run keeps its results so far.
    fn stops(&self) -> bool {
        true
    }

    /// Memory and time of a run.
    ///
    /// Errors: options out of range; a response longer than the limits.
    fn estimate(&self, task: &Task<'_>) -> Result<Estimate, FeError>;

    /// Time history of a case. Collapse is a result, not an error.
    ///
    /// Errors: no ground motion; something it does not model; options out of range; a model that cannot be built or solved; a
    /// checkpoint that cannot be written or belongs to another run; interrupted before there are results.
    fn run(&self, task: &Task<'_>, progress: &dyn Progress) -> Result<Simulation, FeError>;
}
