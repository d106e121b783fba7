//! Generalised symmetric eigenproblem K x = ω² M x, accurate at its low end.
//!
//! ```text
//! K = L Lᵀ        A = L⁻¹ M L⁻ᵀ        A y = μ y        ω² = 1/μ        x = ω L⁻ᵀ y      (xᵀ M x = 1)
//! ```
//!
//! K mixes the gravity stiffness of a liquid surface with the stiffness of a shell, up to 10¹² times larger. Dividing
//! by K, not by M, makes the sloshing modes the *largest* eigenvalues μ, which are exact to rounding. Frequencies far
//! above the lowest lose digits: the error of μ is about 10⁻¹⁶ n μ₁, so that ω has six digits up to about 10⁴ ω₁.

use faer::dyn_stack::{MemBuffer, MemStack};
use faer::linalg::evd::{ComputeEigenvectors, self_adjoint_evd, self_adjoint_evd_scratch};
use faer::{Col, Par};

use super::dense::{view, view_mut};
use super::{Cholesky, LinalgError, Matrix, product};

/// Largest allowed residual ‖A y − μ y‖/μ of a pair that is returned; the relative error of ω² is at most that.
const RESIDUAL: f64 = 1e-6;

/// Circular frequencies and mode shapes.
#[derive(Clone, Debug, PartialEq)]
pub struct Eigen {
    /// ω [rad/s], ascending.
    pub omega: Vec<f64>,
    /// Modes x_j column by column, with x_jᵀ M x_j = 1.
    pub vectors: Matrix,
}

/// The lowest modes of K x = ω² M x: those that double precision resolves to six digits, at most `count` of them.
///
/// K must be positive definite, M positive semi-definite.
///
/// Errors: K not positive definite; not even the lowest pair passes the residual check.
pub fn generalized_eigen(k: &Matrix, m: &Matrix, count: Option<usize>) -> Result<Eigen, LinalgError> {
    let size = k.rows;
    let factor = Cholesky::factor(k)?;
    let operator = inverse_operator(&factor, m);
    let (mu, y) = symmetric_eigen(&operator)?;
    let wanted = count.unwrap_or(size).min(size);
    let modes: Vec<usize> = (0..wanted).map(|i| size - 1 - i).collect();
    let all: Vec<usize> = (0..size).collect();
    let mut vectors = y.select(&all, &modes);
    let image = product(&operator, &vectors);
    let mut omega = Vec::with_capacity(wanted);
    for (j, &mode) in modes.iter().enumerate() {
        let residual = relative_residual(mu[mode], vectors.column(j), image.column(j));
        if residual > RESIDUAL || residual.is_nan() {
            if j > 0 {
                break;
            }
            return Err(LinalgError::Eigen { number: j + 1, wanted, residual, allowed: RESIDUAL });
        }
        omega.push((1.0 / mu[mode]).sqrt());
    }
    vectors.cols = omega.len();
    vectors.data.truncate(size * omega.len());
    factor.half_solve_transposed(&mut vectors);
    for (j, &w) in omega.iter().enumerate() {
        vectors.column_mut(j).iter_mut().for_each(|v| *v *= w);
        orient(vectors.column_mut(j));
    }
    Ok(Eigen { omega, vectors })
}

/// L⁻¹ M L⁻ᵀ, symmetric to the last digit.
fn inverse_operator(factor: &Cholesky, m: &Matrix) -> Matrix {
    let mut half = m.clone();
    factor.half_solve(&mut half);
    let mut operator = Matrix::zeros(m.rows, m.rows);
    for j in 0..m.rows {
        for i in 0..m.rows {
            operator.data[j + i * m.rows] = half.data[i + j * m.rows];
        }
    }
    factor.half_solve(&mut operator);
    for j in 0..m.rows {
        for i in 0..j {
            let mean = 0.5 * (operator.get(i, j) + operator.get(j, i));
            operator.data[i + j * m.rows] = mean;
            operator.data[j + i * m.rows] = mean;
        }
    }
    operator
}

/// All eigenvalues (ascending) and orthonormal eigenvectors of a symmetric matrix.
pub(super) fn symmetric_eigen(a: &Matrix) -> Result<(Vec<f64>, Matrix), LinalgError> {
    let size = a.rows;
    let scratch = self_adjoint_evd_scratch::<f64>(size, ComputeEigenvectors::Yes, Par::Seq, Default::default());
    let mut buffer = MemBuffer::try_new(scratch).map_err(|_| LinalgError::Memory { size })?;
    let mut values = Col::<f64>::zeros(size);
    let mut vectors = Matrix::zeros(size, size);
    self_adjoint_evd(
        view(a),
        values.as_diagonal_mut(),
        Some(view_mut(&mut vectors)),
        Par::Seq,
        MemStack::new(&mut buffer),
        Default::default(),
    )
    .map_err(|_| LinalgError::Eigen { number: 0, wanted: size, residual: f64::INFINITY, allowed: RESIDUAL })?;
    Ok((values.iter().copied().collect(), vectors))
}

/// ‖A y − μ y‖/μ for a normalised y; infinite unless μ > 0.
fn relative_residual(mu: f64, y: &[f64], image: &[f64]) -> f64 {
    if mu <= 0.0 || mu.is_nan() {
        return f64::INFINITY;
    }
    let square: f64 = y.iter().zip(image).map(|(y, a)| (a - mu * y).powi(2)).sum();
    square.sqrt() / mu
}

/// The sign of a mode is arbitrary; its largest component is made positive so that results repeat.
pub(super) fn orient(x: &mut [f64]) {
    let peak = x.iter().fold(0.0_f64, |m, v| if v.abs() > m.abs() { *v } else { m });
    if peak < 0.0 {
        x.iter_mut().for_each(|v| *v = -*v);
    }
}
