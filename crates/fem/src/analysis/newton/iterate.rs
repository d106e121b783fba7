//! The iterations of one step.

use super::*;
use crate::assembly::Ask;

/// A factor serves as long as an iteration cuts ‖r‖ to this part.
const SLOW: f64 = 0.25;
/// ... with that of a zone, which costs about as much as one more iteration.
const SLOW_WITH_ZONE: f64 = 0.4;
/// A residual this small against the first one is that of a linear step.
const LINEAR: f64 = 1e-10;
/// ... and against the forces, rounding.
const ROUNDING: f64 = 1e-14;
/// Negligible shares of the largest first energy: at once, and if iterations do not reduce it.
const NOTHING: [f64; 2] = [1e-24, 1e-18];
/// An increment that does less work than this share of the largest first energy has not diverged.
const LITTLE: f64 = 1e-4;
/// Unknowns from which a second thread is worth its start.
const MANY: usize = 10_000;
/// Work |δu·r| of the increments of a step: the first, the last, and the one before.
struct Work {
    first: f64,
    last: f64,
    before: f64,
}

impl Work {
    const NONE: Work = Work { first: 0.0, last: f64::INFINITY, before: f64::INFINITY };

    /// Whether the last increment is negligible: against the first, or against the largest first one of all steps, `reference`.
    fn is_small(&self, criterion: f64, reference: f64) -> bool {
        self.last <= criterion * self.first
            || self.last <= NOTHING[0] * reference
            || (self.last <= NOTHING[1] * reference && self.last >= SLOW * self.before)
    }
}

/// So many iterations without a new smallest residual are a failure.
const PATIENCE: usize = 10;

impl Newton<'_> {
    /// Forces and tangent at the trial state; `on_force`: weight of the step's end in the forces of the scheme.
    pub(super) fn evaluate(&mut self, state: &mut State, want: Want, on_force: f64) -> Result<(), StepFailure> {
        self.cost.evaluations += 1;
        let ask = Ask {
            want,
            linear: Some(&self.linear),
            end_tangent: 1.0 / on_force,
            threads: self.threads,
            tangents: None,
        };
        self.assembler
            .answer_apart(
                self.model,
                state,
                ask,
                &mut self.tangent,
                self.zoned.as_mut().map(Zoned::apart),
                &mut self.forces,
                self.kept.as_mut(),
            )
            .map_err(|(number, source)| StepFailure::Element { number, source })
    }

    /// The committed state with the scheme's guess for the step.
    fn begin(&mut self, scheme: &dyn Scheme, state: &mut State) -> Result<(), StepFailure> {
        state.revert();
        self.secants.clear();
        if let Some(kept) = &mut self.kept {
            kept.clear();
        }
        if scheme.collocation().1 != 1.0 {
            self.committed_forces(state)?;
        }
        let guess = scheme.predict(&state.committed);
        if guess.iter().any(|g| *g != 0.0) {
            state.increment(self.model, &guess);
        }
        Ok(())
    }

    /// Forces and r at the trial state, on a shorter increment where the last one overshot; returns the sum of the norms of the
    /// terms of r.
    ///
    /// * `slope`: δu·r at the beginning of that increment
    fn balance(
        &mut self,
        scheme: &dyn Scheme,
        state: &mut State,
        loads: [&[f64]; 2],
        slope: Option<f64>,
        modified: bool,
    ) -> Result<f64, StepFailure> {
        scheme.correct(&state.committed, &mut state.trial);
        let want = if modified { Want::FORCE } else { Want::ALL };
        self.evaluate(state, want, scheme.collocation().1)?;
        let scale = self.residual(scheme, state, loads);
        let Some(slope) = slope.filter(|g0| self.options.line_search && self.overshoots(*g0)) else { return Ok(scale) };
        self.secants.clear();
        let scale = self.search(scheme, state, loads, slope)?;
        if !modified {
            self.evaluate(state, Want::ALL, scheme.collocation().1)?;
        }
        Ok(scale)
    }

    /// Renews the factor where the iteration asks for it: always, after a slow one if `modified`, or once if `initial`. Returns whether
    /// the zone remains to be factored with the next solution.
    fn refresh(
        &mut self,
        scheme: &dyn Scheme,
        state: &mut State,
        [modified, initial]: [bool; 2],
        residuals: &[f64],
    ) -> Result<bool, StepFailure> {
        if initial && self.zoned.is_none() {
            if residuals.len() == 1 {
                self.take_initial()?;
                self.refactor(scheme).map_err(StepFailure::Tangent)?;
            }
            return Ok(false);
        }
        let rate = if self.zoned.is_some() { SLOW_WITH_ZONE } else { SLOW };
        let slow = matches!(residuals, [.., before, now] if *now > rate * before);
        if self.zoned.is_some() {
            let renew = self.what_to_renew(scheme.weights(), slow);
            if renew != Renew::Nothing {
                self.secants.clear();
            }
            let renewed = self.renew(scheme, state, renew)?;
            self.secants.begin(&self.room.r);
            return Ok(renewed);
        }
        let current = self.factor.as_ref().is_some_and(|(_, w)| *w == scheme.weights());
        if !modified || !current || slow {
            if modified {
                self.evaluate(state, Want::ALL, scheme.collocation().1)?;
            }
            self.refactor(scheme).map_err(StepFailure::Tangent)?;
        }
        Ok(false)
    }

    /// Iterates from the committed state; `initial`: with the initial stiffness.
    pub(super) fn iterate(
        &mut self,
        scheme: &dyn Scheme,
        state: &mut State,
        loads: [&[f64]; 2],
        limit: usize,
        initial: bool,
    ) -> Result<StepReport, StepFailure> {
        let modified = self.options.modified || initial || self.zoned.is_some();
        let criteria = self.options.criteria;
        self.begin(scheme, state)?;
        let mut residuals: Vec<f64> = Vec::new();
        let mut work = Work::NONE;
        let mut slope = None;
        let (mut best, mut best_at) = (f64::INFINITY, 0);
        for iteration in 0..=limit {
            let scale = self.balance(scheme, state, loads, slope, modified)?;
            if self.zoned.is_some() && iteration > 0 {
                self.secants.learn(&self.room.du, &self.room.r);
            }
            let norm = dot(&self.room.r, &self.room.r).sqrt();
            residuals.push(norm);
            if !norm.is_finite() || norm > 1e8 * (residuals[0] + scale) {
                return Err(self.divergence(iteration, norm));
            }
            if norm <= ROUNDING * scale
                || (iteration > 0 && norm <= LINEAR * residuals[0])
                // Loads that are elements themselves (follower pressure) are part of the forces and vanish with them.
                || (work.is_small(criteria.energy, self.reference) && norm <= criteria.force * scale.max(residuals[0]))
            {
                return Ok(StepReport { iterations: iteration, residuals });
            }
            // The first increment of a thin shell bends it, and stretches it in second order: forces begin to fall after it.
            if iteration == 1 || norm < 0.9 * best {
                (best, best_at) = (norm, iteration);
            }
            if iteration == limit || (!initial && iteration >= best_at + PATIENCE) {
                return Err(self.no_convergence(iteration, norm, criteria.force * scale));
            }
            let renewed = self.refresh(scheme, state, [modified, initial], &residuals)?;
            self.solve(renewed).map_err(StepFailure::Tangent)?;
            let done = dot(&self.room.du, &self.room.r);
            work = Work { last: done.abs(), before: work.last, ..work };
            if !done.is_finite() {
                return Err(self.divergence(iteration, norm));
            }
            if iteration == 0 {
                work.first = work.last;
                self.reference = self.reference.max(work.first);
            }
            // Neither another tangent outside of the zone nor more iterations bring such a step back; a shorter one converges. The first increment of
            // a short step says little: a point that meets the ground within it does more work.
            if self.zoned.is_some() && iteration > 1 && work.last > work.first.max(LITTLE * self.reference) {
                return Err(self.divergence(iteration, norm));
            }
            slope = Some(done);
            if self.options.line_search {
                match &mut self.room.base {
                    Some(base) => base.clone_from(&state.trial),
                    None => self.room.base = Some(state.trial.clone()),
                }
            }
            state.increment(self.model, &self.room.du);
        }
        unreachable!("the last iteration returns")
    }

    /// r into its room; returns the sum of the norms of its terms.
    pub(super) fn residual(&mut self, scheme: &dyn Scheme, state: &State, [p0, p1]: [&[f64]; 2]) -> f64 {
        let (on_mass, on_force) = scheme.collocation();
        let norm = |x: &[f64]| dot(x, x).sqrt();
        let Room { r, blend, parts, .. } = &mut self.room;
        mix(on_force, p1, p0, r);
        let mut scale = norm(r);
        match on_force {
            1.0 => blend.clone_from(&self.forces.internal),
            w => {
                mix(w, &self.forces.internal, &self.committed.internal, blend);
                let ends = self.forces.at_end.iter().zip(&self.committed.at_end);
                for (b, (after, before)) in blend.iter_mut().zip(ends) {
                    *b += (1.0 - w) * (after - before);
                }
            }
        }
        scale += norm(blend);
        for (r, f) in r.iter_mut().zip(&*blend) {
            *r -= f;
        }
        let Some(inertia) = self.inertia else { return scale };
        if scheme.weights().damping == 0.0 {
            // A static step: no velocities.
            return scale;
        }
        let (model, assembler, viscous) = (self.model, self.assembler, self.viscous.as_ref());
        let fields = [&state.trial, &state.committed];
        let of_inertia = |blend: &mut Vec<f64>, part: &mut Vec<f64>| {
            mix(on_mass, &fields[0].a, &fields[1].a, blend);
            inertia.mass.add_product(1.0, blend, part);
            assembler.add_operator_mass(model, blend, part);
            if let Some(border) = inertia.border {
                border.add_product(1.0, blend, part);
            }
        };
        let of_damping = |blend: &mut Vec<f64>, part: &mut Vec<f64>| {
            mix(on_force, &fields[0].v, &fields[1].v, blend);
            inertia.damping.add_sparse_product(inertia.mass, inertia.stiffness, 1.0, blend, part);
            let c = inertia.damping.of_operators();
            assembler.add_operator_products(model, |_| [c.mass, c.stiffness], blend, part);
            if let Some(viscous) = viscous {
                viscous.add_product(1.0, blend, part);
            }
        };
        let [own, other] = parts;
        [&mut *own, &mut *other].into_iter().for_each(|part| {
            part.clear();
            part.resize(r.len(), 0.0);
        });
        if self.threads < 2 || r.len() < MANY {
            of_inertia(blend, own);
            of_damping(blend, other);
        } else {
            rayon::join(|| of_inertia(blend, own), || of_damping(&mut Vec::new(), other));
        }
        for part in [own, other] {
            scale += norm(part);
            r.iter_mut().zip(&*part).for_each(|(r, f)| *r -= f);
        }
        scale
    }

    /// Replaces the tangent by the initial stiffness.
    fn take_initial(&mut self) -> Result<(), StepFailure> {
        if self.initial.is_none() {
            let stiffness = self.assembler.stiffness(self.model);
            let failed = |source| StepFailure::Element { number: 0, source };
            self.initial = Some(stiffness.map_err(failed)?);
        }
        if let Some(k) = &self.initial {
            self.tangent.values.copy_from_slice(&k.values);
        }
        Ok(())
    }

    /// Factors the effective tangent.
    pub(super) fn refactor(&mut self, scheme: &dyn Scheme) -> Result<(), AnalysisError> {
        let w = scheme.weights();
        self.effective.values.fill(0.0);
        self.effective.add(w.stiffness, &self.tangent);
        if let Some(inertia) = self.inertia {
            inertia.add_to(&mut self.effective, w);
            if let Some(viscous) = &self.viscous {
                self.effective.add(w.damping, viscous);
            }
        }
        if w.mass == 0.0 && self.rings.is_none() && self.zoned.is_none() {
            // Unknowns without stiffness (potentials) rest in statics.
            let pattern = self.effective.pattern.clone();
            for &diagonal in &pattern.starts[..pattern.size()] {
                if self.effective.values[diagonal] == 0.0 {
                    self.effective.values[diagonal] = 1.0;
                }
            }
        }
        self.cost.factors += 1;
        self.factorise(w)
    }

    /// δu from r with the factor there is, or with that of the zone `renewed`.
    fn solve(&mut self, renewed: bool) -> Result<(), AnalysisError> {
        self.cost.iterations += 1;
        let (mut b, mut du) = (std::mem::take(&mut self.room.blend), std::mem::take(&mut self.room.du));
        b.clone_from(&self.room.r);
        let alphas = self.secants.ahead(&mut b);
        let solved = if renewed { self.renew_and_substitute(&b, &mut du) } else { self.back_substitute(&b, &mut du) };
        self.secants.after(&mut du, &alphas);
        (self.room.blend, self.room.du) = (b, du);
        solved
    }

    /// Node and dof of the largest component of r, or of the first that is not finite.
    fn worst(&self) -> (usize, crate::dofs::Dof) {
        let r = &self.room.r;
        let largest = || (0..r.len()).fold(0, |m, i| if r[i].abs() > r[m].abs() { i } else { m });
        let at = r.iter().position(|x| !x.is_finite()).unwrap_or_else(largest);
        self.model.dofs().unknown(at)
    }

    fn divergence(&self, iteration: usize, residual: f64) -> StepFailure {
        let (node, dof) = self.worst();
        StepFailure::Divergence { iteration, residual, node, dof }
    }

    fn no_convergence(&self, iterations: usize, residual: f64, allowed: f64) -> StepFailure {
        let (node, dof) = self.worst();
        StepFailure::NoConvergence { iterations, residual, allowed, node, dof }
    }
}

/// out = w x₁ + (1 − w) x₀.
fn mix(w: f64, x1: &[f64], x0: &[f64], out: &mut Vec<f64>) {
    out.clear();
    out.extend(x1.iter().zip(x0).map(|(a, b)| w * a + (1.0 - w) * b));
}
