//! Nonlinear time histories: static start, earthquake, steps that are cut and grow again.
//!
//! ```text
//! M ü + C u̇ + f_int(u) = p_c − Σ_k M ι_k a_k(t) + Σ p_j f_j(t)
//! ```
//!
//! 1. **Static start**: the constant loads p_c (weight, hydrostatic pressure) and the free strains of the elements are applied in load steps
//!    with the committed history ([`Stage`](crate::element::Stage)); then u̇ = 0. Unknowns without stiffness (potentials) rest meanwhile.
//! 2. **Steps** on the nominal grid; a step that does not converge is halved, down to 2⁻⁶, with the ground motion linear
//!    inside it; ten steps that converge double it back. An unconverged step is never accepted.
//!    With [`Adaptive`], nominal steps are joined to longer ones where little moves, up to the distance of the samples.
//! 3. **End**: completed, interrupted, stopped by an observer, or collapsed: no equilibrium with the shortest step, with time,
//!    place and reason. The record until then is kept in every case.
//!
//! Where the load jumps (a record that does not begin or end with zero), the acceleration jumps by M⁻¹ Δp.
//!
//! # Energy
//!
//! From step to step, with x̄ the mean and Δx the increment over the step,
//!
//! ```text
//! E_in = Σ p̄·Δu      E_int = Σ f̄·Δu      E_damp = Σ (C v̄)·Δu      E_kin = ½ v·M v
//! E_num = Σ −h (γ−½) Δa·M v̄ + h² (β−γ/2) ā·M Δa + (½−α_m) Δa·M Δu + (½−α_f) (C Δv + Δf − Δp)·Δu
//! E_in − E_kin − E_int − E_damp − E_num = Σ r·Δu
//! ```
//!
//! E_num is the dissipation of the scheme, an identity of generalised-α for any f_int; it vanishes for the trapezoidal
//! rule. The remainder is the work of the residuals left by Newton's method: the balance closes if and only if the steps
//! are converged. E_hyst is summed from the elements, independently, and is a part of E_int.
//!
//! Source: Chung & Hulbert 1993; the identity follows from the two update formulas and the equation of motion.

use std::path::PathBuf;

use super::checkpoint::CheckpointError;
use super::motion::Grid;
use super::newton::{Cost, LoadPath, Options, StepFailure};
use super::scheme::TimeScheme;
use super::transient::Load;
use super::{AnalysisError, check_length};
use crate::assembly::Forces;
use crate::dofs::Dof;
use crate::progress::Progress;
use crate::state::State;

mod driver;
mod energy;
mod observer;
mod problem;
mod stride;

pub use energy::{Balance, Energies};
pub use observer::{Quantity, QuantityObserver, Range, Reaction};
pub use problem::Problem;
pub use stride::Adaptive;

/// How a march is done.
#[derive(Clone, Debug)]
pub struct Settings {
    /// Scheme.
    pub scheme: TimeScheme,
    /// Samples and nominal steps.
    pub grid: Grid,
    /// Constant load p_c; without one there is no static start, and free strains do not act.
    pub constant: Vec<f64>,
    /// Load steps of the static start.
    pub load_steps: usize,
    /// A committed state in equilibrium with p_c to start from instead.
    pub start: Option<State>,
    /// Newton's method.
    pub newton: Options,
    /// A nominal step is halved so often at most.
    pub halvings: u32,
    /// Steps that must converge before a cut step is doubled.
    pub recovery: usize,
    /// Longer steps where little moves; `None` for nominal steps throughout.
    pub adaptive: Option<Adaptive>,
    /// Threads that evaluate the elements; no result depends on their number.
    pub threads: usize,
    /// Where to keep checkpoints.
    pub checkpoint: Option<Checkpoint>,
}

impl Settings {
    /// Generalised-α with ρ_∞ = 0.9 from rest, on one thread.
    pub fn new(grid: Grid) -> Settings {
        Settings {
            scheme: TimeScheme::GeneralizedAlpha { radius: 0.9 },
            grid,
            constant: Vec::new(),
            load_steps: 5,
            start: None,
            newton: Options::default(),
            halvings: 6,
            recovery: 10,
            adaptive: None,
            threads: 1,
            checkpoint: None,
        }
    }
}

/// Checkpoints of a march.
#[derive(Clone, Debug, PartialEq)]
pub struct Checkpoint {
    /// File.
    pub path: PathBuf,
    /// Written after so many nominal steps (0: never)
    pub steps: usize,
    /// and after so many seconds (infinite: never), and when the march is interrupted or has come to its end.
    pub seconds: f64,
    /// Key of the input: a hash of the data of model, loads and settings.
    pub key: String,
    /// Continue from the file if it exists.
    pub resume: bool,
}

/// What an observer sees: the start, and every committed step.
#[derive(Clone, Copy)]
pub struct Instant<'a> {
    /// The problem.
    pub problem: Problem<'a>,
    /// Time [s].
    pub time: f64,
    /// Number of the grid's sample, if it is one.
    pub sample: Option<usize>,
    /// The committed state.
    pub state: &'a State,
    /// Internal forces there.
    pub forces: &'a Forces,
    /// Ground acceleration [m/s²].
    pub ground: [f64; 3],
    /// Energies.
    pub energies: Energies,
    /// Iterations of the step.
    pub iterations: usize,
    /// Length of the step [s]; 0 at the start.
    pub step: f64,
}

/// Watches a march. Closures that take an [`Instant`] are observers without memory.
pub trait Observe {
    /// Sees the start and every committed step.
    fn see(&mut self, now: &Instant<'_>);

    /// A reason to stop, asked for after every step.
    fn stop(&self) -> Option<String> {
        None
    }

    /// Writes its data to a checkpoint.
    fn save(&self, _to: &mut super::checkpoint::Writer) {}

    /// Reads it back.
    ///
    /// Errors: a payload that is not its own.
    fn restore(&mut self, _from: &mut super::checkpoint::Reader) -> Result<(), CheckpointError> {
        Ok(())
    }
}

impl<F: FnMut(&Instant<'_>)> Observe for F {
    fn see(&mut self, now: &Instant<'_>) {
        self(now);
    }
}

/// No equilibrium could be found.
#[derive(Clone, Debug, PartialEq)]
pub struct Collapse {
    /// Time of the last equilibrium [s].
    pub time: f64,
    /// Part of the constant loads that was carried, if it was the static start that failed.
    pub load_factor: Option<f64>,
    /// Node and dof of the largest residual.
    pub worst: Option<(usize, Dof)>,
    /// Element that failed.
    pub element: Option<usize>,
    /// The failure of the shortest step.
    pub failure: StepFailure,
}

impl Collapse {
    fn new(time: f64, load_factor: Option<f64>, failure: StepFailure) -> Collapse {
        let worst = match &failure {
            StepFailure::NoConvergence { node, dof, .. } | StepFailure::Divergence { node, dof, .. } => {
                Some((*node, *dof))
            }
            _ => None,
        };
        let element = match &failure {
            StepFailure::Element { number, .. } => Some(*number),
            _ => None,
        };
        Collapse { time, load_factor, worst, element, failure }
    }
}

/// How a march ended.
#[derive(Clone, Debug, PartialEq)]
pub enum Outcome {
    /// At the end of the grid.
    Completed,
    /// By the user.
    Interrupted,
    /// By an observer.
    Stopped {
        /// Its reason.
        reason: String,
    },
    /// Without equilibrium.
    Collapsed(Collapse),
}

/// A march that came to an end.
#[derive(Clone, Debug)]
pub struct Run {
    /// How it ended.
    pub outcome: Outcome,
    /// Time of the last committed state [s].
    pub time: f64,
    /// The last committed state.
    pub state: State,
    /// Static start; `None` if a state was given or the run was resumed.
    pub statics: Option<LoadPath>,
    /// Energies at the samples.
    pub balance: Balance,
    /// Steps, iterations, factorisations.
    pub cost: Cost,
    /// Number of times that a step was halved.
    pub cuts: u64,
    /// Shortest step taken [s].
    pub shortest: f64,
    /// Longest step taken [s].
    pub longest: f64,
    /// Number of long steps that were taken back for their error, or did not converge.
    pub refused: u64,
}

/// Marches `problem` through `load`.
///
/// Errors: vectors of wrong length, parameters out of range, modal damping, loads that are not finite, a checkpoint that
/// cannot be written or is not of this analysis. Non-convergence is an [`Outcome`], not an error.
pub fn march(
    problem: Problem<'_>,
    load: &Load,
    settings: &Settings,
    observers: &mut [&mut dyn Observe],
    progress: &dyn Progress,
) -> Result<Run, AnalysisError> {
    check(problem, load, settings)?;
    driver::Driver::new(problem, load, settings)?.run(observers, progress)
}

fn check(problem: Problem<'_>, load: &Load, settings: &Settings) -> Result<(), AnalysisError> {
    let n = problem.system.size();
    if !settings.constant.is_empty() {
        check_length("constant load", settings.constant.len(), n)?;
    }
    for (force, _) in &load.forces {
        check_length("nodal forces", force.len(), n)?;
    }
    if let Some(start) = &settings.start {
        check_length("state of the start", start.committed.u.len(), n)?;
    }
    settings.scheme.with_step(settings.grid.h())?;
    let refuse =
        |option, found: String, allowed: &str| Err(AnalysisError::Option { option, found, allowed: allowed.into() });
    if settings.halvings > 20 {
        return refuse("halvings", settings.halvings.to_string(), "0 to 20");
    }
    if let Some(Adaptive { tolerance }) = settings.adaptive
        && !(tolerance > 0.0 && tolerance.is_finite())
    {
        return refuse("tolerance of the step", tolerance.to_string(), "a positive number");
    }
    if settings.load_steps == 0 {
        return refuse("load steps", "0".into(), "1 or more");
    }
    let values = settings.constant.iter().chain(load.forces.iter().flat_map(|(p, _)| p));
    if let Some(value) = values.into_iter().find(|p| !p.is_finite()) {
        return refuse("loads", value.to_string(), "finite numbers");
    }
    let motions = load.ground.iter().flatten().chain(load.forces.iter().map(|(_, m)| m));
    for motion in motions {
        if let Some(i) = (0..=motion.last()).find(|&i| !motion.at(i).is_finite()) {
            return Err(AnalysisError::NotFinite {
                time: settings.grid.time(i),
                cause: "a record or time function that is not finite",
            });
        }
    }
    Ok(())
}

#[cfg(test)]
mod tests;
