//! Newton's method for one load or time step, on the elements' own forces and tangents.
//!
//! ```text
//! r = p_α − M a_α − C v_α − (w f_int(u₁) + (1 − w) f_int(u₀))          w = 1 − α_f;  x_α = w x₁ + (1 − w) x₀
//! [w_M M + w_C C + w_K K_T] δu = r
//! ```
//!
//! [`super::scheme`] gives the weights: a static step has neither M nor C. The step has converged when
//!
//! ```text
//! |δu·r| ≤ 10⁻¹⁰ × first energy of the step        and        ‖r‖ ≤ 10⁻⁴ (‖f_int‖ + ‖M a‖ + ‖C v‖ + ‖p‖)
//! ```
//!
//! of which the first is the sharp one: a criterion of forces alone never passes for thin plates. A step with almost
//! no motion has no energy to compare with: there |δu·r| ≤ 10⁻²⁴ of the largest first energy so far is enough, or
//! 10⁻¹⁸ if iterations make it no smaller. History and rotations are committed on success only; after a failure the state is
//! the committed one, and [`load_path`] tries half the step.
//!
//! Aids, all in [`Options`]:
//!
//! * **Modified Newton**: the factor is kept as long as every iteration cuts ‖r‖ to a quarter, and recomputed when one
//!   does not. Linear elements are assembled once ([`crate::assembly::LinearPart`]).
//! * **Line search**: with g(s) = δu·r(u + s δu), s is looked for between 0.1 and 1 where |g(1)| > 0.8 |g(0)| and g has
//!   changed its sign or grown.
//! * **Initial stiffness**: a step that has failed is tried once more with the initial stiffness in place
//!   of K_T, which softening cannot make indefinite.
//! * **Zone** ([`super::zone`]): elements whose tangents are renewed after every slow iteration; those of the others when iterations stay slow
//!   all the same and the residual is outside. A step that has failed is tried again with those of the zone in every iteration, then with all of them, if no
//!   shorter one can take its place.
//!   A step has diverged once an increment does more work than the first one; then the last of these is left out. Iterations since the last factor correct it
//!   (`secant`), and the factor of another length of step is kept.
//! * **Tangent damping**: C_T = Σ a_K K_e⁺ of the last committed tangents, K_e⁺ the positive part of an element's.
//!
//! Source: Bathe 1996, section 8.4; Matthies & Strang 1979 (line search); criteria: theory manual.

use std::sync::Arc;

use super::border::{Border, Bordered};
use super::damping::Damping;
use super::rings::RingLayout;
use super::scheme::{LoadStep, Scheme, Weights};
use super::system::System;
use super::{AnalysisError, check_length};
use crate::assembly::{Assembler, Forces, Kept, LinearPart};
use crate::element::{ElementError, Want};
use crate::linalg::{Kind, Symbolic, Symmetric, dot};
use crate::model::Model;
use crate::progress::Progress;
use crate::state::{Fields, State};

mod iterate;
mod memory;
mod options;
mod path;
mod search;
mod secant;
mod solver;
mod zoned;

pub use options::{Criteria, Options};
pub use path::{LoadPath, lasting_path, load_path};
use zoned::{Renew, Zoned};

/// A step that has converged.
#[derive(Clone, Debug, Default, PartialEq)]
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
    #[error("divergence in iteration {iteration}: residual {residual:.2e}; worst at node {node} ({dof})")]
    Divergence {
        /// Iteration, from 1.
        iteration: usize,
        /// ‖r‖.
        residual: f64,
        /// Node of the largest component, or of the first that is not finite.
        node: usize,
        /// Its dof.
        dof: crate::dofs::Dof,
    },
    /// An element failed.
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

/// Cost of the steps so far.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Cost {
    /// Steps that converged.
    pub steps: u64,
    /// Steps that failed.
    pub failures: u64,
    /// Iterations (solves).
    pub iterations: u64,
    /// Evaluations of all elements.
    pub evaluations: u64,
    /// Factorisations; of a zone alone where there is one.
    pub factors: u64,
    /// Factorisations of what is outside of a zone.
    pub wholes: u64,
    /// Line searches.
    pub searches: u64,
    /// Products of the iterative solutions, where elements are not assembled.
    pub products: u64,
}

/// Constants of an analysis, and data kept from one step to the next.
pub struct Newton<'a> {
    model: &'a Model,
    assembler: &'a Assembler,
    symbolic: &'a Arc<Symbolic>,
    inertia: Option<Inertia<'a>>,
    options: Options,
    kind: Kind,
    linear: LinearPart,
    initial: Option<Symmetric>,
    tangent: Symmetric,
    effective: Symmetric,
    /// Factor of `effective`, and the weights in it.
    factor: Option<(solver::Solver, Weights)>,
    /// What the factor lacks of a moving base.
    bordered: Option<Bordered>,
    /// Where elements are not assembled.
    rings: Option<Arc<RingLayout>>,
    zoned: Option<Zoned>,
    secants: secant::Secants,
    /// C_T.
    viscous: Option<Symmetric>,
    /// Forces at the committed state, and the displacements they belong to.
    committed: Forces,
    committed_at: Option<Vec<f64>>,
    forces: Forces,
    /// Forces of evaluations that want the tangent alone.
    unused: Forces,
    /// Largest first energy of a step so far.
    reference: f64,
    cost: Cost,
    room: Room,
    kept: Option<Kept>,
    /// Threads that evaluate the elements.
    threads: usize,
}

/// Vectors kept from iteration to iteration.
#[derive(Default)]
struct Room {
    r: Vec<f64>,
    du: Vec<f64>,
    blend: Vec<f64>,
    parts: [Vec<f64>; 2],
    base: Option<Fields>,
}

/// Constant mass and damping; Rayleigh's a_K multiplies the given stiffness, not the tangent.
#[derive(Clone, Copy, Debug)]
pub struct Inertia<'a> {
    /// M.
    pub mass: &'a Symmetric,
    /// K of the damping.
    pub stiffness: &'a Symmetric,
    /// C; its modal part is rejected.
    pub damping: &'a Damping,
    /// A moving base.
    pub border: Option<&'a Border>,
}

impl<'a> From<&'a System> for Inertia<'a> {
    fn from(system: &'a System) -> Inertia<'a> {
        let System { mass, stiffness, damping, border, .. } = system;
        Inertia { mass, stiffness, damping, border: border.as_ref() }
    }
}

impl<'a> Newton<'a> {
    /// Full Newton for the steps of one analysis; `inertia` is needed by time steps.
    ///
    /// Errors: modal damping, which is not a sparse matrix; a linear element without a stiffness.
    pub fn new(
        model: &'a Model,
        assembler: &'a Assembler,
        symbolic: &'a Arc<Symbolic>,
        inertia: Option<Inertia<'a>>,
        criteria: Criteria,
    ) -> Result<Newton<'a>, AnalysisError> {
        Newton::with_options(model, assembler, symbolic, inertia, Options::plain(criteria))
    }

    /// The same with aids.
    ///
    /// Errors: as [`Newton::new`]; tangent damping that is negative or of more groups than there are; a zone on a moving base.
    pub fn with_options(
        model: &'a Model,
        assembler: &'a Assembler,
        symbolic: &'a Arc<Symbolic>,
        inertia: Option<Inertia<'a>>,
        options: Options,
    ) -> Result<Newton<'a>, AnalysisError> {
        if inertia.is_some_and(|i| i.damping.modal.is_some()) {
            return Err(AnalysisError::option(
                "Newton's method",
                "modal damping",
                "Rayleigh damping, by group, dashpots, damping matrices of super-elements",
            ));
        }
        let given = &options.tangent_damping;
        if given.len() > model.groups().len() || given.iter().any(|a| !(*a >= 0.0 && a.is_finite())) {
            return Err(AnalysisError::option(
                "tangent damping",
                format!("{given:?} for {} groups", model.groups().len()),
                "a finite a_K ≥ 0 a group",
            ));
        }
        if options.zone.is_some() && inertia.is_some_and(|i| i.border.is_some()) {
            return Err(AnalysisError::option("Newton's method", "a zone on a moving base", "one of the two"));
        }
        let viscous = given.iter().any(|a| *a != 0.0) && inertia.is_some();
        let zoned = options.zone.clone().map(|zone| Zoned::new(zone, assembler));
        let rings = match assembler.has_operators() && zoned.is_none() {
            true => Some(Arc::new(RingLayout::new(model, assembler)?)),
            false => None,
        };
        let mut newton = Newton {
            model,
            assembler,
            symbolic,
            inertia,
            options,
            kind: Kind::QuasiDefinite,
            linear: assembler
                .linear_part(model)
                .map_err(|(number, source)| AnalysisError::Element { number, source })?,
            initial: None,
            tangent: Symmetric::zeros(assembler.pattern().clone()),
            effective: Symmetric::zeros(assembler.pattern().clone()),
            factor: None,
            bordered: None,
            rings,
            zoned,
            secants: secant::Secants::default(),
            viscous: None,
            committed: Forces::default(),
            committed_at: None,
            forces: Forces::default(),
            unused: Forces::default(),
            reference: 0.0,
            cost: Cost::default(),
            room: Room::default(),
            kept: None,
            threads: 1,
        };
        if viscous {
            let state = State::new(model);
            newton.viscous = Some(newton.tangent_damping(&state)?);
        }
        Ok(newton)
    }

    /// The same with geometric stiffness from extrapolated stresses
    /// ([`Mixed`](crate::element::Mixed)); a step that fails is tried again without.
    pub fn with_extrapolated_stresses(mut self) -> Newton<'a> {
        self.kept = Some(Kept::new(self.model));
        self
    }

    /// The same with the elements evaluated on `threads` threads; no result depends on their number.
    pub fn on_threads(mut self, threads: usize) -> Newton<'a> {
        self.threads = threads;
        self
    }

    /// Cost of the steps so far.
    pub fn cost(&self) -> Cost {
        self.cost
    }

    /// C_T of the last committed step.
    pub fn viscous(&self) -> Option<&Symmetric> {
        self.viscous.as_ref()
    }

    /// Internal forces at the committed state; evaluated if they are not those of the last step.
    ///
    /// Errors: an element that fails.
    pub fn committed_forces(&mut self, state: &mut State) -> Result<&Forces, StepFailure> {
        let known = self.committed_at.as_ref().is_some_and(|u| *u == state.committed.u);
        if !known {
            state.revert();
            self.evaluate(state, Want::FORCE, 1.0)?;
            state.revert();
            self.keep_forces(state);
        }
        Ok(&self.committed)
    }

    fn keep_forces(&mut self, state: &State) {
        std::mem::swap(&mut self.committed, &mut self.forces);
        let at = self.committed_at.get_or_insert_with(Vec::new);
        at.clear();
        at.extend_from_slice(&state.committed.u);
    }

    /// One step from the committed state under the loads `p0` at its beginning and `p1` at its end. On success the state is
    /// committed, else reverted.
    ///
    /// Errors: no convergence, divergence, an element that fails, a singular tangent.
    pub fn step(
        &mut self,
        scheme: &dyn Scheme,
        state: &mut State,
        p0: &[f64],
        p1: &[f64],
    ) -> Result<StepReport, StepFailure> {
        let tried = self.attempt(scheme, state, [p0, p1], true);
        self.conclude(tried, state)
    }

    /// The same without commit: on success the trial state is the result, for [`Newton::conclude`] or [`Newton::take_back`].
    ///
    /// * `last`: no shorter step can take its place
    pub(super) fn attempt(
        &mut self,
        scheme: &dyn Scheme,
        state: &mut State,
        loads: [&[f64]; 2],
        last: bool,
    ) -> Result<StepReport, StepFailure> {
        let limit = self.options.criteria.iterations;
        let mut result = self.iterate(scheme, state, loads, limit, false);
        // Few that have failed converge with other tangents, and those at the price of two steps of half the length.
        if self.zoned.is_some() && result.is_err() && last {
            self.set_aside();
            // Most steps that fail pass from one set of points to another that their tangents do not know.
            for what in [Renew::Zone, Renew::Whole] {
                let diverged = matches!(result, Err(StepFailure::Divergence { .. }));
                if result.is_ok() || (diverged && what == Renew::Whole) {
                    break;
                }
                self.factor = None;
                self.renew_always(what);
                result = self.iterate(scheme, state, loads, limit, false);
            }
            self.renew_always(Renew::Nothing);
            // Not in the precision that a resumed run would have it in.
            self.factor = None;
            return result;
        }
        if self.zoned.is_some() {
            return result;
        }
        if result.is_err()
            && let Some(kept) = self.kept.take()
        {
            self.factor = None;
            result = self.iterate(scheme, state, loads, limit, false);
            self.kept = Some(kept);
        }
        if result.is_err() && self.options.initial_stiffness > 0 {
            self.factor = None;
            let limit = self.options.initial_stiffness;
            result = self.iterate(scheme, state, loads, limit, true);
            self.factor = None;
        }
        result
    }

    /// Returns to the committed state from a step that has converged.
    pub(super) fn take_back(&mut self, state: &mut State) {
        state.revert();
        self.cost.failures += 1;
    }

    /// Commits what [`Newton::attempt`] found, or returns to the committed state if it has failed.
    pub(super) fn conclude(
        &mut self,
        mut result: Result<StepReport, StepFailure>,
        state: &mut State,
    ) -> Result<StepReport, StepFailure> {
        if result.is_ok() && self.viscous.is_some() {
            match self.tangent_damping(state) {
                Ok(viscous) => self.viscous = Some(viscous),
                Err(AnalysisError::Element { number, source }) => {
                    result = Err(StepFailure::Element { number, source });
                }
                Err(other) => result = Err(StepFailure::Tangent(other)),
            }
        }
        match result {
            Ok(_) => {
                state.commit();
                self.keep_forces(state);
                self.cost.steps += 1;
            }
            Err(_) => {
                state.revert();
                self.cost.failures += 1;
            }
        }
        result
    }

    /// Σ a_K K_e⁺ at the trial state.
    fn tangent_damping(&self, state: &State) -> Result<Symmetric, AnalysisError> {
        let coefficients = &self.options.tangent_damping;
        let of = |e: usize| coefficients.get(self.model.group_of(e)).copied().unwrap_or(0.0);
        let mut out = Symmetric::zeros(self.assembler.pattern().clone());
        self.assembler
            .add_positive_tangent(self.model, state, of, &mut out)
            .map_err(|(number, source)| AnalysisError::Element { number, source })?;
        Ok(out)
    }

    /// Adds M⁻¹ `force` to the committed acceleration: the effect of a jump of the loads. M may be singular (rotations without
    /// inertia): (M + ε K) Δa = Δp with ε = 10⁻⁶ h²/4 is solved and refined once against M.
    ///
    /// Errors: no inertia was given, a matrix that cannot be factored.
    pub fn accelerate(&mut self, state: &mut State, force: &[f64], h: f64) -> Result<(), AnalysisError> {
        let inertia =
            self.inertia.ok_or(AnalysisError::option("Newton's method", "no mass", "a mass matrix for time steps"))?;
        let rest = |a: &[f64]| {
            let mut rest = force.to_vec();
            inertia.mass.add_product(-1.0, a, &mut rest);
            let minus = |_| [-1.0, 0.0];
            self.assembler.add_operator_products(self.model, minus, a, &mut rest);
            if let Some(border) = inertia.border {
                border.add_product(-1.0, a, &mut rest);
            }
            rest
        };
        let [a, correction] = self.regular_mass(0.25e-6 * h * h, force, rest)?;
        for (total, (a, d)) in state.committed.a.iter_mut().zip(a.iter().zip(&correction)) {
            *total += a + d;
        }
        state.revert();
        Ok(())
    }
}

#[cfg(test)]
mod tests;
