//! Modal damping in a time step, without forming its matrix.
//!
//! ```text
//! A = A_s + w W D Wᵀ        A⁻¹ = A_s⁻¹ − Z S⁻¹ Wᵀ A_s⁻¹        Z = A_s⁻¹ W        S = (w D)⁻¹ + Wᵀ Z
//! ```
//!
//! with W = M Φ and w the weight of C in A (Sherman, Morrison & Woodbury).

use nalgebra::{DMatrix, DVector, Dyn, LU};

use crate::analysis::damping::ModalPart;
use crate::analysis::{AnalysisError, failed};
use crate::linalg::{Factor, LinalgError, Matrix};

pub(super) struct LowRank<'a> {
    part: &'a ModalPart,
    z: Matrix,
    /// Factor of S, which is not definite where rates of both signs occur.
    s: LU<f64, Dyn, Dyn>,
    /// Wᵀ v and Wᵀ a at the beginning of the step, Wᵀ a at its end, record after record.
    wv: Vec<f64>,
    wa: Vec<f64>,
    next: Vec<f64>,
}

impl<'a> LowRank<'a> {
    /// For the factor of A_s and the weight of C in A.
    pub(super) fn new(
        part: &'a ModalPart,
        weight: f64,
        factor: &Factor,
        columns: usize,
    ) -> Result<LowRank<'a>, AnalysisError> {
        let mut z = part.momenta.clone();
        factor.solve(&mut z).map_err(failed("modal damping"))?;
        let m = part.rates.len();
        let mut s = DMatrix::zeros(m, m);
        for j in 0..m {
            s.set_column(j, &DVector::from_vec(part.momenta.transposed_times(z.column(j))));
            s[(j, j)] += 1.0 / (weight * part.rates[j]);
        }
        let s = s.lu();
        if !s.is_invertible() {
            return Err(failed("modal damping")(LinalgError::NotPositiveDefinite { pivot: 0, size: m }));
        }
        let zero = || vec![0.0; m * columns];
        Ok(LowRank { part, z, s, wv: zero(), wa: zero(), next: zero() })
    }

    fn rank(&self) -> usize {
        self.part.rates.len()
    }

    fn project_into(momenta: &Matrix, x: &[f64], out: &mut [f64]) {
        for (x, out) in x.chunks(momenta.rows).zip(out.chunks_mut(momenta.cols)) {
            out.copy_from_slice(&momenta.transposed_times(x));
        }
    }

    /// Takes the velocity.
    pub(super) fn set_velocity(&mut self, v: &[f64]) {
        Self::project_into(&self.part.momenta, v, &mut self.wv);
    }

    /// Takes the acceleration.
    pub(super) fn set_acceleration(&mut self, a: &[f64]) {
        Self::project_into(&self.part.momenta, a, &mut self.wa);
    }

    /// Takes the acceleration at the end of the step.
    pub(super) fn set_next(&mut self, a: &[f64]) {
        Self::project_into(&self.part.momenta, a, &mut self.next);
    }

    /// right ← right − W D Wᵀ (v + `weight` a) of record `c`.
    pub(super) fn subtract_force(&self, c: usize, weight: f64, right: &mut [f64]) {
        let m = self.rank();
        for (j, d) in self.part.rates.iter().enumerate() {
            let factor = d * (self.wv[c * m + j] + weight * self.wa[c * m + j]);
            for (r, w) in right.iter_mut().zip(self.part.momenta.column(j)) {
                *r -= factor * w;
            }
        }
    }

    /// y ← y + factor W D Wᵀ x.
    pub(super) fn add_product(&self, factor: f64, x: &[f64], y: &mut [f64]) {
        let projected = self.part.momenta.transposed_times(x);
        for (j, (p, d)) in projected.iter().zip(&self.part.rates).enumerate() {
            for (y, w) in y.iter_mut().zip(self.part.momenta.column(j)) {
                *y += factor * d * p * w;
            }
        }
    }

    /// A_s⁻¹ r → A⁻¹ r, column by column.
    pub(super) fn correct(&self, x: &mut Matrix) {
        for c in 0..x.cols {
            let projected = DVector::from_vec(self.part.momenta.transposed_times(x.column(c)));
            let factors = self.s.solve(&projected).expect("S was found invertible");
            for (j, f) in factors.iter().enumerate() {
                for (x, z) in x.column_mut(c).iter_mut().zip(self.z.column(j)) {
                    *x -= f * z;
                }
            }
        }
    }

    /// Carries record `c` to the end of the step (weights h, h²(½ − β), h²β, h(1 − γ), hγ); returns twice the work done on
    /// the damping.
    pub(super) fn advance(&mut self, c: usize, [h, b0, b1, g0, g1]: [f64; 5]) -> f64 {
        let m = self.rank();
        let mut loss = 0.0;
        for (j, d) in self.part.rates.iter().enumerate() {
            let k = c * m + j;
            let (a0, a1) = (self.wa[k], self.next[k]);
            let du = h * self.wv[k] + b0 * a0 + b1 * a1;
            let dv = g0 * a0 + g1 * a1;
            loss += d * du * (2.0 * self.wv[k] + dv);
            self.wv[k] += dv;
            self.wa[k] = a1;
        }
        loss
    }
}
