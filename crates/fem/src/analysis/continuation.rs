//! Static paths beyond limit points: displacement control and cylindrical arc length; where they lose stability.
//!
//! ```text
//! f_int(u) = p₀ + λ p ,  g(u) = 0                      unknowns u and λ
//! K_T δu_r = r ,  K_T δu_p = p ,  δu = δu_r + δλ δu_p          one factor, two right-hand sides
//!
//! displacement:  g = c · u − w                         δλ = (w − c · u − c · δu_r)/(c · δu_p)
//! arc length:    g = ‖Δu‖² − s²                        δλ = −(‖Δu‖² − s² + 2 Δu · δu_r)/(2 Δu · δu_p)
//! ```
//!
//! Δu is the increment since the committed state; the arc length takes translations only. The first step of an arc is
//! δλ = ± s/‖δu_p‖, with the sign that continues in the direction of the previous step. Constraint and equilibrium are
//! linearised together, so that the iteration is Newton's for both and no root has to be chosen.
//!
//! Where joints open and close, a step has converged only if their switches repeat, and a set that comes back after others halves the
//! increment ([`super::contact`]).
//!
//! The signs of the pivots of K_T at a committed state count its negative eigenvalues: none is a stable state, a change
//! at a maximum of λ is a limit point, any other a bifurcation. The eigenvector of the eigenvalue next to zero
//! ([`Continuation::lowest_mode`]) is the buckling mode there, and the shape of the most harmful imperfection.
//!
//! Source: Batoz & Dhatt 1979 (two right-hand sides), Crisfield 1981 (cylindrical arc length), Ramm 1981; steps after the
//! theory sheet of this project.

mod drive;

pub use drive::{Critical, Path, StepLength};

use std::sync::Arc;

use super::contact::switches;
use super::newton::{Criteria, StepFailure};
use super::{AnalysisError, check_length, failed};
use crate::assembly::{Ask, Assembler, Forces, Kept};
use crate::dofs::Dof;
use crate::element::Want;
use crate::linalg::{Factor, Kind, Matrix, Symbolic, Symmetric, dot};
use crate::model::Model;
use crate::state::State;

/// The quantity that a step prescribes.
#[derive(Clone, Debug, PartialEq)]
pub enum Constraint {
    /// c · u = value: row (equation, coefficient) as from [`Model::row`], and the value at the end of the step.
    Displacement(Vec<(usize, f64)>, f64),
    /// ‖Δu‖ = s over all translations, s > 0.
    Arc(f64),
    /// λ at the end of the step.
    Load(f64),
}

/// A committed state of a path.
#[derive(Clone, Debug, PartialEq)]
pub struct PathPoint {
    /// Load factor λ.
    pub factor: f64,
    /// Iterations of the step that led here.
    pub iterations: usize,
    /// Number of negative eigenvalues of K_T here, if watched.
    pub negative: Option<usize>,
}

/// State of a path besides its committed fields.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Memory {
    /// λ of the committed state.
    pub factor: f64,
    /// Increment of the last step, which gives the direction of the next; `None` before the first.
    pub last: Option<Vec<f64>>,
}

/// Path following of one model under p₀ + λ p.
pub struct Continuation<'a> {
    model: &'a Model,
    assembler: &'a Assembler,
    symbolic: &'a Arc<Symbolic>,
    constant: Vec<f64>,
    load: Vec<f64>,
    criteria: Criteria,
    kept: Option<Kept>,
    threads: usize,
    watch: bool,
    translations: Vec<usize>,
    tangent: Symmetric,
    factor: Option<Factor>,
    /// λ of the committed state.
    lambda: f64,
    /// Increment of the last step.
    last: Option<Vec<f64>>,
}

impl<'a> Continuation<'a> {
    /// From λ = 0.
    ///
    /// * `constant`: p₀, `load`: p over the unknowns [N, N m]
    ///
    /// Errors: loads of wrong length.
    pub fn new(
        model: &'a Model,
        assembler: &'a Assembler,
        symbolic: &'a Arc<Symbolic>,
        constant: &[f64],
        load: &[f64],
        criteria: Criteria,
    ) -> Result<Continuation<'a>, AnalysisError> {
        let n = model.dofs().len();
        check_length("constant load", constant.len(), n)?;
        check_length("load", load.len(), n)?;
        let is_translation = |&e: &usize| matches!(model.dofs().unknown(e).1, Dof::Ux | Dof::Uy | Dof::Uz);
        Ok(Continuation {
            model,
            assembler,
            symbolic,
            constant: constant.to_vec(),
            load: load.to_vec(),
            criteria,
            kept: None,
            threads: 1,
            watch: false,
            translations: (0..n).filter(is_translation).collect(),
            tangent: Symmetric::zeros(assembler.pattern().clone()),
            factor: None,
            lambda: 0.0,
            last: None,
        })
    }

    /// The same with geometric stiffness from extrapolated stresses
    /// ([`Mixed`](crate::element::Mixed)); a step that fails is tried again without.
    pub fn with_extrapolated_stresses(mut self) -> Continuation<'a> {
        self.kept = Some(Kept::new(self.model));
        self
    }

    /// The same with the elements evaluated on `threads` threads; no result depends on their number.
    pub fn on_threads(mut self, threads: usize) -> Continuation<'a> {
        self.threads = threads;
        self
    }

    /// The same, counting the negative eigenvalues at every committed state.
    pub fn with_watch(mut self) -> Continuation<'a> {
        self.watch = true;
        self
    }

    /// λ of the committed state.
    pub fn factor(&self) -> f64 {
        self.lambda
    }

    /// The data that the next step needs besides the committed state.
    pub fn memory(&self) -> Memory {
        Memory { factor: self.lambda, last: self.last.clone() }
    }

    /// Restores the data of [`Continuation::memory`]: from the same committed state the path continues bit for bit.
    ///
    /// Errors: an increment of wrong length.
    pub fn recall(&mut self, memory: Memory) -> Result<(), AnalysisError> {
        if let Some(last) = &memory.last {
            check_length("increment of the last step", last.len(), self.model.dofs().len())?;
        }
        self.lambda = memory.factor;
        self.last = memory.last;
        Ok(())
    }

    /// One step from the committed state. On success the state is committed, else reverted.
    ///
    /// Errors: no convergence, divergence, an element that fails, a singular tangent.
    pub fn step(&mut self, state: &mut State, constraint: &Constraint) -> Result<PathPoint, StepFailure> {
        let mut result = self.iterate(state, constraint);
        if result.is_err()
            && let Some(kept) = self.kept.take()
        {
            result = self.iterate(state, constraint);
            self.kept = Some(kept);
        }
        match result {
            Ok((lambda, iterations)) => {
                self.lambda = lambda;
                self.last = Some(self.increment(state));
                state.commit();
                let negative = if self.watch { Some(self.negative()?) } else { None };
                Ok(PathPoint { factor: lambda, iterations, negative })
            }
            Err(failure) => {
                state.revert();
                Err(failure)
            }
        }
    }

    /// Eigenpair of K_T of the committed state whose eigenvalue is next to zero: (φᵀ K_T φ/φᵀ φ, φ with its largest entry 1).
    ///
    /// Errors: an element that fails, a singular tangent.
    pub fn lowest_mode(&mut self, state: &mut State) -> Result<(f64, Vec<f64>), StepFailure> {
        state.revert();
        self.respond(state, false)?;
        let n = self.model.dofs().len();
        let factor = self.factorise().map_err(StepFailure::Tangent)?;
        // Any vector that no symmetry of a structure makes orthogonal to a mode.
        let mut x: Vec<f64> = (0..n).map(|i| 1.0 + (1.7 * i as f64).sin()).collect();
        for _ in 0..60 {
            let y = factor.solve_vector(&x).map_err(|e| StepFailure::Tangent(failed("the tangent")(e)))?;
            let size = y.iter().fold(0.0_f64, |m, v| if v.abs() > m.abs() { *v } else { m });
            let next: Vec<f64> = y.iter().map(|v| v / size).collect();
            let change = next.iter().zip(&x).map(|(a, b)| (a - b).abs()).fold(0.0, f64::max);
            x = next;
            if change < 1e-8 {
                break;
            }
        }
        let value = dot(&self.tangent.times(&x), &x) / dot(&x, &x);
        Ok((value, x))
    }

    fn increment(&self, state: &State) -> Vec<f64> {
        let (new, old) = (&state.trial.u, &state.committed.u);
        new.iter().zip(old).map(|(a, b)| a - b).collect()
    }

    /// Forces and, in `tangent`, K_T at the trial state.
    fn respond(&mut self, state: &mut State, mixed: bool) -> Result<Vec<f64>, StepFailure> {
        let kept = if mixed { self.kept.as_mut() } else { None };
        let ask = Ask { threads: self.threads, ..Ask::now(Want::ALL, None) };
        let mut forces = Forces::default();
        self.assembler
            .answer(self.model, state, ask, &mut self.tangent, &mut forces, kept)
            .map_err(|(number, source)| StepFailure::Element { number, source })?;
        Ok(forces.internal)
    }

    fn factorise(&mut self) -> Result<&Factor, AnalysisError> {
        // Taken out, so that a factor that failed is not used again.
        let factor = match self.factor.take() {
            Some(mut factor) => factor.refactor(&self.tangent).map(|()| factor),
            None => self.symbolic.factor(&self.tangent, Kind::QuasiDefinite),
        };
        Ok(self.factor.insert(factor.map_err(failed("the tangent"))?))
    }

    /// Negative eigenvalues of the tangent last assembled.
    fn negative(&mut self) -> Result<usize, StepFailure> {
        Ok(self.factorise().map_err(StepFailure::Tangent)?.inertia().negative)
    }

    fn iterate(&mut self, state: &mut State, constraint: &Constraint) -> Result<(f64, usize), StepFailure> {
        state.revert();
        if let Some(kept) = &mut self.kept {
            kept.clear();
        }
        let n = self.model.dofs().len();
        let mut lambda = self.lambda;
        let (mut first, mut energy) = (0.0_f64, f64::INFINITY);
        let (mut start, mut largest) = (f64::INFINITY, 0.0_f64);
        let norm = |x: &[f64]| dot(x, x).sqrt();
        let mut sets: Vec<Vec<bool>> = Vec::new();
        for iteration in 0..=self.criteria.iterations {
            let force = self.respond(state, true)?;
            let set = switches(self.model, state);
            let repeats = sets.last().is_none_or(|last| *last == set);
            let cycle = !repeats && sets.contains(&set);
            sets.push(set);
            let applied: Vec<f64> = self.constant.iter().zip(&self.load).map(|(c, p)| c + lambda * p).collect();
            let r: Vec<f64> = applied.iter().zip(&force).map(|(p, f)| p - f).collect();
            let rest = norm(&r);
            largest = largest.max(rest);
            // Loads that are elements themselves (follower pressure) are part of the internal force and vanish with it.
            let scale = (norm(&applied) + norm(&force)).max(largest);
            if !rest.is_finite() || rest > 1e8 * start {
                return Err(self.divergence(iteration, rest, &r));
            }
            let settled = energy <= self.criteria.energy * first && rest <= self.criteria.force * scale;
            if iteration > 0 && settled && repeats {
                return Ok((lambda, iteration));
            }
            if iteration == self.criteria.iterations {
                let (node, dof) = self.worst(&r);
                return Err(StepFailure::NoConvergence {
                    iterations: iteration,
                    residual: rest,
                    allowed: self.criteria.force * scale,
                    node,
                    dof,
                });
            }
            if iteration == 1 {
                start = rest + scale;
            }
            let mut both = Matrix::zeros(n, 2);
            both.column_mut(0).copy_from_slice(&r);
            both.column_mut(1).copy_from_slice(&self.load);
            let factor = self.factorise().map_err(StepFailure::Tangent)?;
            factor.solve(&mut both).map_err(|e| StepFailure::Tangent(failed("the tangent")(e)))?;
            let (du_r, du_p) = (both.column(0), both.column(1));
            let d_lambda = self.load_step(state, constraint, lambda, du_r, du_p, iteration);
            if !d_lambda.is_finite() {
                return Err(self.divergence(iteration, rest, &r));
            }
            let d_lambda = if cycle { 0.5 * d_lambda } else { d_lambda };
            let part = if cycle { 0.5 } else { 1.0 };
            let du: Vec<f64> = du_r.iter().zip(du_p).map(|(a, b)| part * a + d_lambda * b).collect();
            energy = dot(&du, &r).abs() + (d_lambda * dot(&du, &self.load)).abs();
            if iteration == 0 {
                first = energy;
            }
            lambda += d_lambda;
            state.increment(self.model, &du);
        }
        unreachable!("the last iteration returns")
    }

    /// Node and dof of the largest component of r, or of the first that is not finite.
    fn worst(&self, r: &[f64]) -> (usize, Dof) {
        let size = |i: usize| if r[i].is_finite() { r[i].abs() } else { f64::INFINITY };
        let worst = (0..r.len()).fold(0, |m, i| if size(i) > size(m) { i } else { m });
        self.model.dofs().unknown(worst)
    }

    fn divergence(&self, iteration: usize, residual: f64, r: &[f64]) -> StepFailure {
        let (node, dof) = self.worst(r);
        StepFailure::Divergence { iteration, residual, node, dof }
    }

    /// δλ that keeps the linearised constraint.
    fn load_step(
        &self,
        state: &State,
        constraint: &Constraint,
        lambda: f64,
        du_r: &[f64],
        du_p: &[f64],
        iteration: usize,
    ) -> f64 {
        match constraint {
            Constraint::Load(value) => value - lambda,
            Constraint::Displacement(row, value) => {
                let along = |x: &[f64]| row.iter().map(|&(e, c)| c * x[e]).sum::<f64>();
                (value - along(&state.trial.u) - along(du_r)) / along(du_p)
            }
            &Constraint::Arc(s) => {
                let product = |a: &[f64], b: &[f64]| self.translations.iter().map(|&i| a[i] * b[i]).sum::<f64>();
                if iteration == 0 {
                    let onward = self.last.as_ref().map_or(1.0, |last| product(last, du_p));
                    return (s / product(du_p, du_p).sqrt()).copysign(onward);
                }
                let d = self.increment(state);
                let gap = product(&d, &d) - s * s;
                -(gap + 2.0 * product(&d, du_r)) / (2.0 * product(&d, du_p))
            }
        }
    }
}
