//! Longer steps where little moves.
//!
//! ```text
//! e(h) = |β − 1/6 + (α_m − α_f)/2| h² ‖a₁ − a₀‖        of the translations, in the Euclidean norm
//! e(h) ≤ ε U        U = max ‖u − u(0)‖ so far
//! ```
//!
//! e is the local error of the displacements of a step; it grows with h³. A long step is s nominal ones, where s is a link of a chain of divisors
//! of the number of nominal steps between two samples (4: 1, 2, 4; 5: 1, 5; 12: 1, 2, 4, 12): every sample is met, and no
//! step is longer than the distance of the samples. A record is linear between them, so that no peak of it can be lost; where
//! another time function (a vertical record of another step) bends or jumps within a long step, nominal ones are taken.
//!
//! * A long step whose error exceeds ε U is taken back and repeated with the next shorter one.
//! * A step grows after `recovery` steps in succession, half a period of an oscillation of twenty steps, whose error would stay below ε U/2 if they were
//!   the next longer ones.
//! * The nominal step is never taken back: it is the user's choice, and failure to converge alone cuts it.
//!
//! A nominal step of a twentieth of a period leaves 2.6·10⁻³ of an amplitude (ρ_∞ = 0.9): with ε = 10⁻³ long steps are less
//! accurate, relative to the largest displacement, than nominal ones in no phase.
//!
//! Source: Zienkiewicz & Xie 1991, extended to the shifted accelerations of generalised-α
//! ([`GeneralizedAlpha::local_error`]).

use super::problem::Problem;
use crate::analysis::checkpoint::{CheckpointError, Reader, Writer};
use crate::analysis::motion::Motion;
use crate::analysis::scheme::GeneralizedAlpha;
use crate::analysis::transient::Load;
use crate::dofs::Dof;
use crate::state::State;

/// Longer steps where little moves.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Adaptive {
    /// ε: allowed local error of a long step relative to the largest displacement so far.
    pub tolerance: f64,
}

impl Adaptive {
    /// ε = 10⁻³.
    pub const DEFAULT: Adaptive = Adaptive { tolerance: 1e-3 };
}

/// Chooses the number of nominal steps in a step.
pub(super) struct Strides {
    tolerance: f64,
    recovery: usize,
    /// Numbers of nominal steps, each a divisor of the next.
    chain: Vec<usize>,
    /// Place in the chain.
    at: usize,
    /// Steps in succession that could have been longer.
    calm: usize,
    /// Translations, and their values at the start.
    moving: Vec<usize>,
    rest: Vec<f64>,
    /// Largest ‖u − u(0)‖ of the committed states.
    largest: f64,
    /// Long steps not accepted.
    pub refused: u64,
}

/// Divisors of `n`, each a divisor of the next, by the smallest prime factors.
fn chain(n: usize) -> Vec<usize> {
    let (mut out, mut rest) = (vec![1], n);
    let mut product = 1;
    while rest > 1 {
        let prime = (2..=rest).find(|p| rest.is_multiple_of(*p)).unwrap_or(rest);
        rest /= prime;
        product *= prime;
        out.push(product);
    }
    out
}

impl Strides {
    pub(super) fn new(adaptive: Adaptive, sub_steps: usize, recovery: usize, problem: Problem<'_>) -> Strides {
        let dofs = problem.model.dofs();
        let translation = |e: &usize| matches!(dofs.unknown(*e).1, Dof::Ux | Dof::Uy | Dof::Uz);
        Strides {
            tolerance: adaptive.tolerance,
            recovery,
            chain: chain(sub_steps),
            at: 0,
            calm: 0,
            moving: (0..dofs.len()).filter(translation).collect(),
            rest: Vec::new(),
            largest: 0.0,
            refused: 0,
        }
    }

    /// Notes the state of the start.
    pub(super) fn begin(&mut self, state: &State) {
        self.rest = self.moving.iter().map(|&e| state.committed.u[e]).collect();
    }

    /// Nominal steps in a long step.
    pub(super) fn now(&self) -> usize {
        self.chain[self.at]
    }

    /// Nominal steps in the step from nominal step `step`: one unless all time functions are linear over a long step.
    pub(super) fn next(&self, step: usize, load: &Load) -> usize {
        let wanted = self.now();
        if wanted == 1 || !step.is_multiple_of(wanted) {
            return 1;
        }
        let straight = |m: &Motion| {
            let (a, b) = (m.interval(step).0, m.interval(step + wanted - 1).1);
            let line = |k: usize| a + k as f64 / wanted as f64 * (b - a);
            let near = |x: f64, y: f64| (x - y).abs() <= 1e-9 * (a.abs() + b.abs());
            (0..wanted).all(|k| {
                let (x, y) = m.interval(step + k);
                near(x, line(k)) && near(y, line(k + 1))
            })
        };
        let ground = load.ground.iter().flatten();
        let linear = ground.chain(load.forces.iter().map(|(_, m)| m)).all(straight);
        if linear { wanted } else { 1 }
    }

    /// e(h) of the trial state.
    pub(super) fn error(&self, scheme: &GeneralizedAlpha, state: &State) -> f64 {
        let (before, after) = (&state.committed.a, &state.trial.a);
        let square: f64 = self.moving.iter().map(|&e| (after[e] - before[e]).powi(2)).sum();
        scheme.local_error().abs() * scheme.h * scheme.h * square.sqrt()
    }

    /// Whether a long step must be repeated with shorter ones.
    pub(super) fn too_long(&self, error: f64) -> bool {
        error > self.tolerance * self.largest
    }

    /// A shorter step after one that was not accepted.
    pub(super) fn shrink(&mut self) {
        self.at = self.at.saturating_sub(1);
        self.calm = 0;
        self.refused += 1;
    }

    /// Nominal steps again: one has been cut.
    pub(super) fn reset(&mut self) {
        (self.at, self.calm) = (0, 0);
    }

    /// Takes in a committed step that had this error and ends at nominal step `end`; a longer one may follow.
    pub(super) fn accept(&mut self, error: f64, end: usize, state: &State) {
        let u = &state.committed.u;
        let away = self.moving.iter().zip(&self.rest).map(|(&e, r)| (u[e] - r).powi(2));
        self.largest = self.largest.max(away.sum::<f64>().sqrt());
        let Some(&next) = self.chain.get(self.at + 1) else { return };
        let growth = (next as f64 / self.now() as f64).powi(3);
        if error * growth <= 0.5 * self.tolerance * self.largest {
            self.calm += 1;
        } else {
            self.calm = 0;
        }
        if self.calm >= self.recovery && end.is_multiple_of(next) {
            self.at += 1;
            self.calm = 0;
        }
    }

    pub(super) fn save(&self, to: &mut Writer) {
        for count in [self.at, self.calm, self.refused as usize] {
            to.count(count);
        }
        to.number(self.largest);
        to.numbers(&self.rest);
    }

    pub(super) fn restore(&mut self, from: &mut Reader) -> Result<(), CheckpointError> {
        let last = self.chain.len() as u64 - 1;
        self.at = from.count_within("the length of the step", 0..=last, "a link of the chain")? as usize;
        self.calm = from.count()?;
        self.refused = from.count()? as u64;
        self.largest = from.number()?;
        self.rest = vec![0.0; self.moving.len()];
        from.numbers_into("displacements of the start", &mut self.rest)
    }
}

#[cfg(test)]
mod tests {
    use super::chain;

    #[test]
    fn chains_divide() {
        assert_eq!(chain(1), [1]);
        assert_eq!(chain(5), [1, 5]);
        assert_eq!(chain(4), [1, 2, 4]);
        assert_eq!(chain(12), [1, 2, 4, 12]);
    }
}
