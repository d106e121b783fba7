//! Statics of a model whose joints open and close.
//!
//! ```text
//! r = p − f_int(u) ,   K_T δu = r                    the elements' own one-sided forces and tangents (semi-smooth Newton)
//! accepted when all switches of the elements repeat and ‖r‖ ≤ 10⁻¹⁰ (‖p‖ + ‖f_int‖),
//!               or ≤ 10⁻⁶ of that and no longer falling: the rounding of stiff elements
//! augmented Lagrangian: solve, λ ← max(0, λ − k_n g), solve again; 2 to 4 passes, or until the penetration is small
//! ```
//!
//! A residual alone may pass at the wrong set (an open joint carries almost no force), so the set is checked as well. Each
//! pass starts from the last solution. If Newton's method runs between two sets for ever, the step is halved along δu.
//!
//! Use: static solutions with [`crate::element::contact8`] where it may open; benchmarks use them. The engines take that
//! element bonded in linear analyses, and [`crate::element::liquid_joint`] in time.
//!
//! Source: Alart & Curnier 1991; Hüeber & Wohlmuth 2005 (active set as semi-smooth Newton); Simo & Laursen 1992 (augmented).

use std::sync::Arc;

use super::{AnalysisError, check_length, failed};
use crate::assembly::Assembler;
use crate::element::Want;
use crate::linalg::{Kind, Symbolic, Symmetric, dot};
use crate::model::Model;
use crate::state::{Gather, State};

/// When to stop.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ContactSettings {
    /// Newton iterations of one pass until it has failed.
    pub iterations: usize,
    /// Largest number of updates of the multipliers; 0 for the penalty alone.
    pub passes: usize,
    /// Penetration below which no update is made [m].
    pub penetration: f64,
}

impl Default for ContactSettings {
    fn default() -> ContactSettings {
        ContactSettings { iterations: 50, passes: 0, penetration: 0.0 }
    }
}

/// A state in equilibrium.
#[derive(Clone, Debug, PartialEq)]
pub struct ContactReport {
    /// Iterations of each pass.
    pub iterations: Vec<usize>,
    /// Largest penetration after each pass [m].
    pub penetration: Vec<f64>,
    /// Switches that are on: closed corners, pressed points of layers.
    pub closed: usize,
    /// Switches that are off.
    pub open: usize,
}

/// Finds the equilibrium under the forces `load` (one an equation) from the committed state and commits it.
///
/// Errors: a load of wrong length, no equilibrium or no repeating set (the state is reverted), an element that fails,
/// a singular tangent.
pub fn settle(
    model: &Model,
    assembler: &Assembler,
    symbolic: &Arc<Symbolic>,
    state: &mut State,
    load: &[f64],
    settings: &ContactSettings,
) -> Result<ContactReport, AnalysisError> {
    check_length("load", load.len(), model.dofs().len())?;
    let mut tangent = Symmetric::zeros(assembler.pattern().clone());
    let mut report = ContactReport { iterations: Vec::new(), penetration: Vec::new(), closed: 0, open: 0 };
    for pass in 0..=settings.passes {
        let found = balance(model, assembler, symbolic, state, load, settings, &mut tangent);
        let (iterations, set) = match found {
            Ok(found) => found,
            Err(error) => {
                state.revert();
                return Err(error);
            }
        };
        state.commit();
        report.iterations.push(iterations);
        report.closed = set.iter().filter(|on| **on).count();
        report.open = set.len() - report.closed;
        let penetration = worst_penetration(model, state);
        report.penetration.push(penetration);
        if pass == settings.passes || penetration <= settings.penetration {
            break;
        }
        augment(model, state);
    }
    Ok(report)
}

/// Iterations and set of one pass; the trial state is in equilibrium.
fn balance(
    model: &Model,
    assembler: &Assembler,
    symbolic: &Arc<Symbolic>,
    state: &mut State,
    load: &[f64],
    settings: &ContactSettings,
    tangent: &mut Symmetric,
) -> Result<(usize, Vec<bool>), AnalysisError> {
    let norm = |x: &[f64]| dot(x, x).sqrt();
    let (mut previous, mut seen, mut last) = (None, Vec::new(), f64::INFINITY);
    for iteration in 0..=settings.iterations {
        let force = assembler
            .respond(model, state, Want::ALL, tangent)
            .map_err(|(number, source)| AnalysisError::Element { number, source })?;
        let r: Vec<f64> = load.iter().zip(&force).map(|(p, f)| p - f).collect();
        let set = switches(model, state);
        let repeats = previous.as_ref() == Some(&set);
        let (rest, scale) = (norm(&r), norm(load) + norm(&force));
        let rounding = rest <= 1e-6 * scale && rest > 0.3 * last;
        if repeats && (rest <= 1e-10 * scale || rounding) {
            return Ok((iteration, set));
        }
        last = rest;
        // A set that comes back after others is a cycle: go half way.
        let cycle = !repeats && seen.contains(&set);
        seen.push(set.clone());
        previous = Some(set);
        let factor = symbolic.factor(tangent, Kind::QuasiDefinite).map_err(failed("the tangent with contact"))?;
        let mut du = factor.solve_vector(&r).map_err(failed("the tangent with contact"))?;
        if cycle {
            du.iter_mut().for_each(|d| *d *= 0.5);
        }
        state.increment(model, &du);
    }
    let found = format!("no equilibrium with a repeating set in {} iterations", settings.iterations);
    Err(AnalysisError::option("contact", found, "fewer; smaller load steps, or a smaller penalty"))
}

/// Switches of all elements at the trial state; none in a model without joints.
pub(super) fn switches(model: &Model, state: &State) -> Vec<bool> {
    let mut out = Vec::new();
    let mut gather = Gather::default();
    for (e, element) in model.elements().iter().enumerate() {
        if let Some(joint) = element.contact() {
            let motion = gather.motion(model, &state.trial, &**element);
            joint.switches(motion, &state.old[state.history(e)], &mut |on| out.push(on));
        }
    }
    out
}

fn worst_penetration(model: &Model, state: &State) -> f64 {
    let mut gather = Gather::default();
    let mut worst = 0.0_f64;
    for element in model.elements() {
        if let Some(joint) = element.contact() {
            let motion = gather.motion(model, &state.committed, &**element);
            worst = worst.max(joint.penetration(motion));
        }
    }
    worst
}

/// Updates the multipliers of all elements at the committed state.
fn augment(model: &Model, state: &mut State) {
    let mut gather = Gather::default();
    for (e, element) in model.elements().iter().enumerate() {
        if let Some(joint) = element.contact() {
            let range = state.history(e);
            let motion = gather.motion(model, &state.committed, &**element);
            joint.augment(motion, &mut state.old[range]);
        }
    }
    state.revert();
}
