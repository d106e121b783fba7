//! Rows of the mass matrix that are not assembled: a base that moves under a model whose motion is relative to it.
//!
//! ```text
//! M ü + B z̈ + C u̇ + f_int(u) = p − M ι a_g          Bᵀ ü + M_z z̈ + C_z ż + f_z = −Bᵀ_ι a_g
//!
//! ⎡ A      w_M B          ⎤ ⎡ δu ⎤   ⎡ r ⎤          S = A_z + w_M M_z − w_M² Bᵀ A⁻¹ B
//! ⎣ w_M Bᵀ  A_z + w_M M_z ⎦ ⎣ δz ⎦ = ⎣ s ⎦
//! ```
//!
//! A column of B is the inertia of everything under a unit acceleration of an unknown of the base: it joins that unknown to all others, and as
//! entries of the pattern it would be a clique over the model. So A has the unknowns z as its own, joined to nothing by mass, and every solution
//! with A is completed by S. Springs and dashpots of the base are elements like others.
//!
//! Source: block elimination (Golub & Van Loan 1996, section 3.2).

use super::{AnalysisError, failed};
use crate::linalg::{Cholesky, Matrix, Symmetric, dot};

/// The inertia of a moving base.
#[derive(Clone, Debug, PartialEq)]
pub struct Border {
    /// Equations of the unknowns z.
    pub unknowns: Vec<usize>,
    /// B: for each of them the inertia forces on all unknowns, zero on z; nothing of an unknown that z alone is joined to.
    pub columns: Vec<Vec<f64>>,
    /// M_z.
    pub own: Matrix,
}

impl Border {
    /// y ← y + `factor` times the products of B, Bᵀ and M_z with x.
    pub fn add_product(&self, factor: f64, x: &[f64], y: &mut [f64]) {
        for (k, (&e, column)) in self.unknowns.iter().zip(&self.columns).enumerate() {
            let own = self.unknowns.iter().enumerate().map(|(j, &other)| self.own.get(k, j) * x[other]);
            y[e] += factor * (dot(column, x) + own.sum::<f64>());
            let z = factor * x[e];
            if z != 0.0 {
                y.iter_mut().zip(column).for_each(|(y, b)| *y += z * b);
            }
        }
    }

    /// Takes the entries of z out of `b`.
    fn split(&self, b: &mut [f64]) -> Vec<f64> {
        self.unknowns.iter().map(|&e| std::mem::take(&mut b[e])).collect()
    }
}

/// A border with w_M A⁻¹ B and the factor of S.
pub(super) struct Bordered {
    weight: f64,
    along: Vec<Vec<f64>>,
    small: Cholesky,
}

impl Bordered {
    /// Completes the inverse `solve` of A = `effective`.
    ///
    /// Errors: those of `solve`; S that is not positive definite.
    pub(super) fn new(
        border: &Border,
        weight: f64,
        effective: &Symmetric,
        mut solve: impl FnMut(&[f64]) -> Result<Vec<f64>, AnalysisError>,
    ) -> Result<Bordered, AnalysisError> {
        let along = border.columns.iter().map(|column| {
            let scaled: Vec<f64> = column.iter().map(|b| weight * b).collect();
            if scaled.iter().all(|b| *b == 0.0) { Ok(scaled) } else { solve(&scaled) }
        });
        let along = along.collect::<Result<Vec<Vec<f64>>, AnalysisError>>()?;
        let count = border.unknowns.len();
        let mut small = Matrix::zeros(count, count);
        for (i, &row) in border.unknowns.iter().enumerate() {
            for (j, &column) in border.unknowns.iter().enumerate() {
                let mean = 0.5 * (dot(&border.columns[i], &along[j]) + dot(&border.columns[j], &along[i]));
                small.add(i, j, effective.get(row, column) + weight * (border.own.get(i, j) - mean));
            }
        }
        let small = Cholesky::factor(&small).map_err(failed("the effective tangent of the moving base"))?;
        Ok(Bordered { weight, along, small })
    }

    /// x of the whole system for `b`, by one solution with A.
    ///
    /// Errors: those of `solve`.
    pub(super) fn solve(
        &self,
        border: &Border,
        b: &[f64],
        x: &mut Vec<f64>,
        solve: impl FnOnce(&[f64], &mut Vec<f64>) -> Result<(), AnalysisError>,
    ) -> Result<(), AnalysisError> {
        let mut rest = b.to_vec();
        let mut s = border.split(&mut rest);
        solve(&rest, x)?;
        for (s, column) in s.iter_mut().zip(&border.columns) {
            *s -= self.weight * dot(column, x);
        }
        let z = self.small.solve_vector(&s);
        for (z, along) in z.iter().zip(&self.along) {
            x.iter_mut().zip(along).for_each(|(x, w)| *x -= z * w);
        }
        border.unknowns.iter().zip(z).for_each(|(&e, z)| x[e] = z);
        Ok(())
    }
}
