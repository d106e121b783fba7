//! The one shape of an engine: what it refuses of a case, what a run of it takes, the run.

use std::collections::BTreeMap;

use fem::progress::Progress;
use results::{EngineId, Run, Series, Snapshots};
use tank::refusal::Refusal;
use tank::{Case, Quantity};

use crate::FeError;
use crate::estimate::Estimate;
use crate::nonlinear::CheckpointFile;
use tank::options::LinearOptions as Options;
use tank::options::nonlinear::NonlinearOptions;
use tank::options::solid::SolidOptions;

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
