//! Modes that dashpots couple: exact propagation of all of them together.
//!
//! A dashpot of coefficient c between the ground and the displacement b·x adds c b bᵀ to the damping matrix, which is then not diagonal in
//! the modes: D = Σ c (Φᵀ b)(Φᵀ b)ᵀ. With z = (ω_j Y_j, Ẏ_j), so that the entries are frequencies,
//!
//! ```text
//! ż = A z + G a(t)        A = [0 Ω; −Ω −(2 ξ Ω + D)]        G = [0; −Γ]
//! ```
//!
//! and for a that is linear over the step h the next state follows from one exponential of A, G and the ramp of a:
//!
//! ```text
//! exp [h A  h G  0; 0  0  1; 0  0  0] = [E P Q; …]        z(h) = E z + P a_0 + Q (a_1 − a_0)
//! ```
//!
//! exact like the recurrence of a lone mode. D is positive semidefinite, so that the step is stable for any h. Source: Van Loan 1978
//! (exponential of a block matrix); scaling and squaring of the power series.

use super::ModalBasis;
use crate::linalg::{Matrix, dot, product};

/// Terms of the power series: 2⁻² to the 16th over 16! is below 1e-23.
const TERMS: usize = 16;
/// Largest sum of a column that the power series is used for.
const SMALL: f64 = 0.25;

/// A step of all modes.
pub(super) struct Propagator {
    /// E, P and Q side by side, 2 m × (2 m + 6).
    step: Matrix,
    next: Vec<f64>,
}

impl Propagator {
    /// Propagator over a step `h` [s] of modes with these ratios and the coupling of the basis.
    pub(super) fn new(basis: &ModalBasis, ratios: &[f64], coupling: &Matrix, h: f64) -> Propagator {
        let m = basis.len();
        let size = 2 * m + 6;
        let mut whole = Matrix::zeros(size, size);
        // Loads of the size of frequencies keep the series short.
        let largest = basis.participation.iter().flatten().fold(0.0, |g: f64, p| g.max(p.abs()));
        let unit = if largest > 0.0 { largest } else { 1.0 };
        for (j, (&omega, &ratio)) in basis.omega.iter().zip(ratios).enumerate() {
            whole.add(j, m + j, h * omega);
            whole.add(m + j, j, -h * omega);
            whole.add(m + j, m + j, -2.0 * h * ratio * omega);
            for i in 0..m {
                whole.add(m + i, m + j, -h * coupling.get(i, j));
            }
            for (axis, g) in basis.participation[j].iter().enumerate() {
                whole.add(m + j, 2 * m + axis, -h * g / unit);
            }
        }
        for axis in 0..3 {
            whole.add(2 * m + axis, 2 * m + 3 + axis, 1.0);
        }
        let all = exponential(&whole);
        let mut step = Matrix::zeros(2 * m, size);
        for j in 0..size {
            let factor = if j < 2 * m { 1.0 } else { unit };
            for (to, from) in step.column_mut(j).iter_mut().zip(all.column(j)) {
                *to = factor * from;
            }
        }
        Propagator { step, next: vec![0.0; 2 * m] }
    }

    /// The state (ω Y, Ẏ) at the end of a step over which the ground acceleration goes from a_0 to a_1.
    pub(super) fn advance(&mut self, state: &mut [f64], ground: &[(f64, f64); 3]) {
        self.next.fill(0.0);
        let ramp = ground.iter().map(|(a, _)| *a).chain(ground.iter().map(|(a, b)| b - a));
        for (j, x) in state.iter().copied().chain(ramp).enumerate().filter(|(_, x)| *x != 0.0) {
            for (y, e) in self.next.iter_mut().zip(self.step.column(j)) {
                *y += x * e;
            }
        }
        state.copy_from_slice(&self.next);
    }
}

/// e^A by scaling and squaring of the power series.
fn exponential(a: &Matrix) -> Matrix {
    let n = a.cols;
    let norm = (0..n).fold(0.0_f64, |m, j| m.max(a.column(j).iter().map(|v| v.abs()).sum()));
    let squarings = (norm / SMALL).log2().ceil().max(0.0) as i32;
    let mut scaled = a.clone();
    let factor = 0.5_f64.powi(squarings);
    scaled.data.iter_mut().for_each(|v| *v *= factor);
    // Horner's rule: 1 + A (1 + A/2 (1 + A/3 (…))).
    let identity = |sum: &mut Matrix| (0..n).for_each(|i| sum.add(i, i, 1.0));
    let mut sum = Matrix::zeros(n, n);
    identity(&mut sum);
    for k in (1..=TERMS).rev() {
        sum = product(&scaled, &sum);
        sum.data.iter_mut().for_each(|v| *v /= k as f64);
        identity(&mut sum);
    }
    for _ in 0..squarings {
        sum = product(&sum, &sum);
    }
    sum
}

impl ModalBasis {
    /// The same with dashpots to the ground: each a row b over the unknowns and a coefficient c, whose force −c b·ẋ acts on b·x.
    pub fn with_dashpots<'a>(mut self, dashpots: impl IntoIterator<Item = (&'a [f64], f64)>) -> ModalBasis {
        let m = self.len();
        for (row, coefficient) in dashpots {
            let own: Vec<f64> = (0..m).map(|j| dot(row, self.vectors.column(j))).collect();
            let coupling = self.coupling.get_or_insert_with(|| Matrix::zeros(m, m));
            for (j, b) in own.iter().enumerate() {
                for (to, a) in coupling.column_mut(j).iter_mut().zip(&own) {
                    *to += coefficient * a * b;
                }
            }
        }
        self
    }

    /// D v, the dashpots' part of the damping forces per unit of modal mass.
    pub(super) fn coupled(&self, velocities: &[f64]) -> Vec<f64> {
        match &self.coupling {
            Some(coupling) => coupling.times(velocities),
            None => vec![0.0; velocities.len()],
        }
    }
}
