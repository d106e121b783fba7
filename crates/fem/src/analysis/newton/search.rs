//! Line search on the energy g(s) = δu·r(u + s δu).

use super::*;

/// |g(s)| is small enough at this part of |g(0)|.
const ENOUGH: f64 = 0.8;
/// Shortest part of the increment.
const SHORTEST: f64 = 0.1;
/// Evaluations at most.
const TRIES: usize = 5;

impl Newton<'_> {
    fn slope(&self) -> f64 {
        dot(&self.room.du, &self.room.r)
    }

    /// Whether a shorter step along the last increment is nearer to equilibrium.
    pub(super) fn overshoots(&self, g0: f64) -> bool {
        let g1 = self.slope();
        let enough = g1.abs() <= ENOUGH * g0.abs();
        let smaller = g1 * g0 > 0.0 && g1.abs() <= g0.abs();
        // A slope that is not a number overshoots.
        !(enough || smaller)
    }

    /// Looks for s from 0.1 to 1, leaves the trial state and r there and returns the scale of r.
    pub(super) fn search(
        &mut self,
        scheme: &dyn Scheme,
        state: &mut State,
        loads: [&[f64]; 2],
        g0: f64,
    ) -> Result<f64, StepFailure> {
        self.cost.searches += 1;
        let (mut low, mut high) = ((0.0, g0), (1.0, self.slope()));
        let mut best = (1.0, high.1.abs());
        let mut at = 1.0;
        let mut scale = 0.0;
        let mut full = self.room.du.clone();
        for _ in 0..TRIES {
            let crossing = low.0 + (high.0 - low.0) * low.1 / (low.1 - high.1);
            let bracketed = high.1 * low.1 < 0.0;
            let next = if bracketed && crossing.is_finite() { crossing } else { 0.5 * (low.0 + high.0) };
            at = next.clamp(SHORTEST, 1.0);
            scale = self.look(scheme, state, loads, &full, at)?;
            let g = dot(&full, &self.room.r);
            if g.abs() < best.1 || !best.1.is_finite() {
                best = (at, g.abs());
            }
            if g.abs() <= ENOUGH * g0.abs() || at <= SHORTEST {
                break;
            }
            if g * g0 > 0.0 && g.abs() <= g0.abs() {
                low = (at, g);
            } else {
                high = (at, g);
            }
        }
        if best.0 != at {
            scale = self.look(scheme, state, loads, &full, best.0)?;
        }
        std::mem::swap(&mut self.room.du, &mut full);
        Ok(scale)
    }

    /// State and r at u + s δu.
    fn look(
        &mut self,
        scheme: &dyn Scheme,
        state: &mut State,
        loads: [&[f64]; 2],
        full: &[f64],
        s: f64,
    ) -> Result<f64, StepFailure> {
        if let Some(base) = &self.room.base {
            state.trial.clone_from(base);
        }
        let part: Vec<f64> = full.iter().map(|d| s * d).collect();
        state.increment(self.model, &part);
        scheme.correct(&state.committed, &mut state.trial);
        self.evaluate(state, Want::FORCE, scheme.collocation().1)?;
        Ok(self.residual(scheme, state, loads))
    }
}
