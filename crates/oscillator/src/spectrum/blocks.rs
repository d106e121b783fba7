//! Oscillators, their load in blocks of steps, and what a pass stores of a block.

use super::lanes::Lanes;
use super::peaks::larger;

/// Steps of a block.
pub(crate) const BLOCK: usize = 16;
/// Intervals per period for the search of extrema.
pub(crate) const INTERVALS: f64 = 16.0;

/// An oscillator: circular frequency [rad/s] > 0 and damping ratio 0 ≤ ξ < 1.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Oscillator {
    /// ω [rad/s].
    pub omega: f64,
    /// ξ.
    pub damping: f64,
}

impl Oscillator {
    /// κ = √(1 − ξ²).
    pub(crate) fn kappa(&self) -> f64 {
        ((1.0 - self.damping) * (1.0 + self.damping)).sqrt()
    }
}

/// The load of the oscillators. Its sign does not matter for maxima of absolute values, so p = a_g.
pub(crate) struct Loads<'a> {
    /// p at the samples.
    pub p: &'a [f64],
    /// Step [s].
    pub h: f64,
    /// Largest |p| and |dp/dt| of each block.
    pub blocks: Vec<(f64, f64)>,
}

impl<'a> Loads<'a> {
    pub(super) fn new(p: &'a [f64], h: f64) -> Loads<'a> {
        let steps = p.len().saturating_sub(1);
        let blocks = (0..steps)
            .step_by(BLOCK)
            .map(|first| {
                let part = &p[first..=(first + BLOCK).min(steps)];
                let slope = part.windows(2).fold(0.0, |m, p| larger((p[1] - p[0]).abs(), m)) / h;
                (part.iter().fold(0.0, |m, a| larger(a.abs(), m)), slope)
            })
            .collect();
        Loads { p, h, blocks }
    }

    /// Samples of a block, its first and its last one included.
    #[inline(always)]
    pub(crate) fn block(&self, block: usize) -> &'a [f64] {
        let first = block * BLOCK;
        &self.p[first..self.p.len().min(first + BLOCK + 1)]
    }
}

/// Stored data of a block.
#[derive(Clone, Copy, Default)]
pub(crate) struct Trace {
    /// State at its start: (y, y') or (x₁, x₂).
    pub start: [Lanes; 2],
    /// Bounds of |y|, |y'|, |A|.
    pub bound: [Lanes; 3],
    /// Soft oscillators: the part of the bounds that the samples do not include.
    pub slack: [Lanes; 3],
}
