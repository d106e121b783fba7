//! Dense Cholesky factor and products.

use faer::dyn_stack::{MemBuffer, MemStack};
use faer::linalg::cholesky::llt::factor::{cholesky_in_place, cholesky_in_place_scratch};
use faer::linalg::matmul::matmul;
use faer::linalg::triangular_solve::{solve_lower_triangular_in_place, solve_upper_triangular_in_place};
use faer::{Accum, MatMut, MatRef, Par};

use super::{LinalgError, Matrix};

pub(super) fn view(a: &Matrix) -> MatRef<'_, f64> {
    MatRef::from_column_major_slice(&a.data, a.rows, a.cols)
}

pub(super) fn view_mut(a: &mut Matrix) -> MatMut<'_, f64> {
    MatMut::from_column_major_slice_mut(&mut a.data, a.rows, a.cols)
}

/// Cholesky factor L of a symmetric positive definite matrix A = L Lᵀ.
#[derive(Clone, Debug, PartialEq)]
pub struct Cholesky {
    /// L in the lower triangle; entries above the diagonal are not used.
    lower: Matrix,
}

impl Cholesky {
    /// Factors A, of which the lower triangle is read.
    ///
    /// Errors: a pivot that is not positive.
    pub fn factor(a: &Matrix) -> Result<Cholesky, LinalgError> {
        let size = a.rows;
        let mut lower = a.clone();
        let mut memory = MemBuffer::try_new(cholesky_in_place_scratch::<f64>(size, Par::Seq, Default::default()))
            .map_err(|_| LinalgError::Memory { size })?;
        cholesky_in_place(
            view_mut(&mut lower),
            Default::default(),
            Par::Seq,
            MemStack::new(&mut memory),
            Default::default(),
        )
        .map_err(|faer::linalg::cholesky::llt::factor::LltError::NonPositivePivot { index }| {
            LinalgError::NotPositiveDefinite { pivot: index + 1, size }
        })?;
        // A matrix with a NaN passes the comparison of the pivots.
        match (0..size).find(|&i| !lower.get(i, i).is_finite()) {
            Some(i) => Err(LinalgError::NotPositiveDefinite { pivot: i + 1, size }),
            None => Ok(Cholesky { lower }),
        }
    }

    /// Number of unknowns.
    pub fn size(&self) -> usize {
        self.lower.rows
    }

    /// B ← A⁻¹ B.
    pub fn solve(&self, b: &mut Matrix) {
        self.half_solve(b);
        self.half_solve_transposed(b);
    }

    /// x = A⁻¹ b for one vector.
    pub fn solve_vector(&self, b: &[f64]) -> Vec<f64> {
        let mut x = Matrix { rows: b.len(), cols: 1, data: b.to_vec() };
        self.solve(&mut x);
        x.data
    }

    /// B ← L⁻¹ B.
    pub fn half_solve(&self, b: &mut Matrix) {
        solve_lower_triangular_in_place(view(&self.lower), view_mut(b), Par::Seq);
    }

    /// B ← L⁻ᵀ B.
    pub fn half_solve_transposed(&self, b: &mut Matrix) {
        solve_upper_triangular_in_place(view(&self.lower).transpose(), view_mut(b), Par::Seq);
    }
}

/// A B.
pub fn product(a: &Matrix, b: &Matrix) -> Matrix {
    let mut out = Matrix::zeros(a.rows, b.cols);
    matmul(view_mut(&mut out), Accum::Replace, view(a), view(b), 1.0, Par::Seq);
    out
}

/// Aᵀ B.
pub fn transposed_product(a: &Matrix, b: &Matrix) -> Matrix {
    let mut out = Matrix::zeros(a.cols, b.cols);
    matmul(view_mut(&mut out), Accum::Replace, view(a).transpose(), view(b), 1.0, Par::Seq);
    out
}
