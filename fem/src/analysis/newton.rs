//! Newton's method for one load or time step, on the elements' own forces and tangents.
//!
//! ```text
//! r = p_α − M a_α − C v_α − (w f_int(u₁) + (1 − w) f_int(u₀))          w = 1 − α_f;  x_α = w x₁ + (1 − w) x₀
//! [w_M M + w_C C + w_K K_T] δu = r
//! ```
//!
//! [`super::scheme`] gives the weights: a static step has none of M and C. The step has converged when
//!
//! ```text
//! |δu·r| ≤ 10⁻¹⁰ × first energy of the step        and        ‖r‖ ≤ 10⁻⁴ (‖f_int‖ + ‖M a‖ + ‖C v‖ + ‖p‖)
//! ```
//!
//! of which the first is the sharp one: a criterion of forces alone never passes for thin plates. History and rotations are
//! committed on success only; after a failure the state is the committed one, and [`load_path`] tries half the step.
//!
//! Source: Bathe 1996, section 8.4; criteria after the theory sheet of this project.

use std::sync::Arc;

use super::damping::Damping;
use super::scheme::{LoadStep, Scheme};
use super::{AnalysisError, check_length, failed};
use crate::assembly::Assembler;
use crate::element::{ElementError, Want};
use crate::linalg::{Factor, Kind, Symbolic, Symmetric, dot};
use crate::model::Model;
use crate::progress::Progress;
use crate::state::State;

/// When a step has converged, and when it has failed.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Criteria {
    /// Allowed |δu·r| relative to the first one of the step.
    pub energy: f64,
    /// Allowed ‖r‖ relative to the sum of the norms of the forces.
    pub force: f64,
    /// Iterations until the step has failed.
    pub iterations: usize,
}

impl Default for Criteria {
    fn default() -> Criteria {
        Criteria {
            energy: 1e-10,
            force: 1e-4,
            iterations: 25,
        }
    }
}

/// A step that has converged.
#[derive(Clone, Debug, PartialEq)]
pub struct StepReport {
    /// Iterations made.
    pub iterations: usize,
    /// ‖r‖ at the beginning of each, and at the end.
    pub residuals: Vec<f64>,
}

/// A step that has failed; the state is the committed one.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
pub enum StepFailure {
    /// The criteria were not met.
    #[error(
        "no convergence in {iterations} iterations: residual {residual:.2e}, allowed {allowed:.2e}; worst at node {node} ({dof})"
    )]
    NoConvergence {
        /// Iterations made.
        iterations: usize,
        /// Last ‖r‖ [N].
        residual: f64,
        /// Allowed.
        allowed: f64,
        /// Node of the largest component.
        node: usize,
        /// Its dof.
        dof: crate::dofs::Dof,
    },
    /// The residual or the increment is not finite, or has grown beyond measure.
    #[error("divergence in iteration {iteration}: residual {residual:.2e}")]
    Divergence {
        /// Iteration, from 1.
        iteration: usize,
        /// ‖r‖.
        residual: f64,
    },
    /// An element has no answer.
    #[error("element {number}: {source}")]
    Element {
        /// Number of the element.
        number: usize,
        /// The failure.
        source: ElementError,
    },
    /// The effective tangent cannot be factored.
    #[error(transparent)]
    Tangent(AnalysisError),
}

/// What is constant over the steps of an analysis.
pub struct Newton<'a> {
    model: &'a Model,
    assembler: &'a Assembler,
    symbolic: &'a Arc<Symbolic>,
    inertia: Option<Inertia<'a>>,
    criteria: Criteria,
    kind: Kind,
    tangent: Symmetric,
    effective: Symmetric,
    factor: Option<Factor>,
}

/// Constant mass and damping; Rayleigh's a_K multiplies the given stiffness, not the tangent.
#[derive(Clone, Copy, Debug)]
pub struct Inertia<'a> {
    /// M.
    pub mass: &'a Symmetric,
    /// K of the damping.
    pub stiffness: &'a Symmetric,
    /// C; its modal part is refused.
    pub damping: &'a Damping,
}

impl<'a> Newton<'a> {
    /// For the steps of one analysis; `inertia` is needed by time steps.
    ///
    /// Errors: modal damping, which is not a sparse matrix.
    pub fn new(
        model: &'a Model,
        assembler: &'a Assembler,
        symbolic: &'a Arc<Symbolic>,
        inertia: Option<Inertia<'a>>,
        criteria: Criteria,
    ) -> Result<Newton<'a>, AnalysisError> {
        if inertia.is_some_and(|i| i.damping.modal.is_some()) {
            return Err(AnalysisError::Option {
                option: "Newton's method",
                found: "modal damping".into(),
                allowed: "Rayleigh damping, by group, dashpots".into(),
            });
        }
        Ok(Newton {
            model,
            assembler,
            symbolic,
            inertia,
            criteria,
            kind: Kind::QuasiDefinite,
            tangent: Symmetric::zeros(assembler.pattern().clone()),
            effective: Symmetric::zeros(assembler.pattern().clone()),
            factor: None,
        })
    }

    /// One step from the committed state under the loads `p0` at its beginning and `p1` at its end. On success the state is
    /// committed, else reverted.
    ///
    /// Errors: no convergence, divergence, an element without an answer, a singular tangent.
    pub fn step(
        &mut self,
        scheme: &dyn Scheme,
        state: &mut State,
        p0: &[f64],
        p1: &[f64],
    ) -> Result<StepReport, StepFailure> {
        let result = self.iterate(scheme, state, p0, p1);
        match result {
            Ok(_) => state.commit(),
            Err(_) => state.revert(),
        }
        result
    }

    fn respond(&mut self, state: &mut State, want: Want) -> Result<Vec<f64>, StepFailure> {
        self.assembler
            .respond(self.model, state, want, &mut self.tangent)
            .map_err(|(number, source)| StepFailure::Element { number, source })
    }

    fn iterate(
        &mut self,
        scheme: &dyn Scheme,
        state: &mut State,
        p0: &[f64],
        p1: &[f64],
    ) -> Result<StepReport, StepFailure> {
        let (on_mass, on_force) = scheme.collocation();
        state.revert();
        let held = if on_force == 1.0 {
            None
        } else {
            Some(self.respond(state, Want::FORCE)?)
        };
        let guess = scheme.predict(&state.committed);
        if guess.iter().any(|g| *g != 0.0) {
            state.increment(self.model, &guess);
        }
        let mut residuals = Vec::new();
        let (mut first, mut energy) = (0.0_f64, f64::INFINITY);
        for iteration in 0..=self.criteria.iterations {
            scheme.correct(&state.committed, &mut state.trial);
            let force = self.respond(state, Want::ALL)?;
            let (r, scale) = self.residual(state, [on_mass, on_force], &force, held.as_deref(), [p0, p1]);
            let norm = dot(&r, &r).sqrt();
            residuals.push(norm);
            if !norm.is_finite() || norm > 1e8 * (residuals[0] + scale) {
                return Err(StepFailure::Divergence {
                    iteration,
                    residual: norm,
                });
            }
            // Nothing to do: in equilibrium to rounding.
            let rounding = norm <= 1e-14 * scale;
            if rounding || (energy <= self.criteria.energy * first && norm <= self.criteria.force * scale) {
                return Ok(StepReport {
                    iterations: iteration,
                    residuals,
                });
            }
            if iteration == self.criteria.iterations {
                return Err(self.no_convergence(&r, norm, self.criteria.force * scale));
            }
            let du = self.solve(scheme, &r).map_err(StepFailure::Tangent)?;
            energy = dot(&du, &r).abs();
            if iteration == 0 {
                first = energy;
            }
            state.increment(self.model, &du);
        }
        unreachable!("the last iteration returns")
    }

    /// r, and the sum of the norms of what it is made of.
    fn residual(
        &self,
        state: &State,
        [on_mass, on_force]: [f64; 2],
        force: &[f64],
        held: Option<&[f64]>,
        [p0, p1]: [&[f64]; 2],
    ) -> (Vec<f64>, f64) {
        let blend = |w: f64, x1: &[f64], x0: &[f64]| -> Vec<f64> {
            x1.iter().zip(x0).map(|(a, b)| w * a + (1.0 - w) * b).collect()
        };
        let norm = |x: &[f64]| dot(x, x).sqrt();
        let mut r = blend(on_force, p1, p0);
        let internal = blend(on_force, force, held.unwrap_or(force));
        let mut scale = norm(&r) + norm(&internal);
        for (r, f) in r.iter_mut().zip(&internal) {
            *r -= f;
        }
        if let Some(inertia) = self.inertia {
            let a = blend(on_mass, &state.trial.a, &state.committed.a);
            let v = blend(on_force, &state.trial.v, &state.committed.v);
            let parts = [
                inertia.mass.times(&a),
                inertia.damping.times(inertia.mass, inertia.stiffness, &v),
            ];
            for part in parts {
                scale += norm(&part);
                for (r, f) in r.iter_mut().zip(&part) {
                    *r -= f;
                }
            }
        }
        (r, scale)
    }

    /// Solves with the effective tangent.
    fn solve(&mut self, scheme: &dyn Scheme, r: &[f64]) -> Result<Vec<f64>, AnalysisError> {
        let w = scheme.weights();
        self.effective.values.fill(0.0);
        self.effective.add(w.stiffness, &self.tangent);
        if let Some(inertia) = self.inertia {
            let c = &inertia.damping.rayleigh;
            self.effective.add(w.mass + w.damping * c.mass, inertia.mass);
            self.effective.add(w.damping * c.stiffness, inertia.stiffness);
            if let Some(sparse) = &inertia.damping.sparse {
                self.effective.add(w.damping, sparse);
            }
        }
        let what = "the effective tangent";
        // Taken out, so that a factor that failed is not used again.
        let factor = match self.factor.take() {
            Some(mut factor) => factor.refactor(&self.effective).map(|()| factor),
            None => self.symbolic.factor(&self.effective, self.kind),
        };
        let factor = self.factor.insert(factor.map_err(failed(what))?);
        factor.solve_vector(r).map_err(failed(what))
    }

    fn no_convergence(&self, r: &[f64], residual: f64, allowed: f64) -> StepFailure {
        let worst = (0..r.len()).fold(0, |m, i| if r[i].abs() > r[m].abs() { i } else { m });
        let (node, dof) = self.model.dofs().unknown(worst);
        StepFailure::NoConvergence {
            iterations: self.criteria.iterations,
            residual,
            allowed,
            node,
            dof,
        }
    }
}

/// A static path that was followed.
#[derive(Clone, Debug, PartialEq)]
pub struct LoadPath {
    /// Load factor reached: 1 at the end.
    pub factor: f64,
    /// (load factor, iterations) of every step.
    pub steps: Vec<(f64, usize)>,
    /// Why the path ended before 1.
    pub failure: Option<StepFailure>,
}

/// Smallest part of the nominal step that is tried.
const SMALLEST: f64 = 1.0 / 64.0;

/// Applies `constant` + λ `load`, λ from 0 to 1 in `steps` nominal steps; a step that fails is halved, down to 1/64, and after
/// four steps that converge the length is doubled again up to the nominal one. `each` sees every committed state.
///
/// Interrupted or at a limit point, it returns how far it came.
///
/// Errors: loads of wrong length, no step.
pub fn load_path(
    newton: &mut Newton<'_>,
    state: &mut State,
    constant: &[f64],
    load: &[f64],
    steps: usize,
    progress: &dyn Progress,
    mut each: impl FnMut(f64, &State),
) -> Result<LoadPath, AnalysisError> {
    let n = newton.model.dofs().len();
    check_length("constant load", constant.len(), n)?;
    check_length("load", load.len(), n)?;
    if steps == 0 {
        return Err(AnalysisError::Option {
            option: "load steps",
            found: "0".into(),
            allowed: "1 or more".into(),
        });
    }
    let at = |factor: f64| -> Vec<f64> { constant.iter().zip(load).map(|(c, p)| c + factor * p).collect() };
    progress.stage("load steps", steps as u64);
    let mut path = LoadPath {
        factor: 0.0,
        steps: Vec::new(),
        failure: None,
    };
    let nominal = 1.0 / steps as f64;
    let (mut part, mut easy, mut told) = (1.0, 0, 0);
    while path.factor < 1.0 - 1e-12 && !progress.interrupted() {
        let next = (path.factor + part * nominal).min(1.0);
        match newton.step(&LoadStep, state, &at(path.factor), &at(next)) {
            Ok(report) => {
                path.factor = next;
                path.steps.push((next, report.iterations));
                each(next, state);
                easy += 1;
                if easy == 4 && part < 1.0 {
                    (part, easy) = (2.0 * part, 0);
                }
                let done = (next * steps as f64 + 1e-9) as u64;
                progress.advance(done - told);
                told = done;
            }
            Err(_) if part > SMALLEST => (part, easy) = (0.5 * part, 0),
            Err(failure) => {
                path.failure = Some(failure);
                break;
            }
        }
    }
    Ok(path)
}

#[cfg(test)]
mod tests;
