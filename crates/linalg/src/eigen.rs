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
            return Err(LinalgError::Eigen {
                number: j + 1,
                wanted,
                residual,
                allowed: RESIDUAL,
            });
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
    .map_err(|_| LinalgError::Eigen {
        number: 0,
        wanted: size,
        residual: f64::INFINITY,
        allowed: RESIDUAL,
    })?;
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

#[cfg(test)]
mod tests {
    use super::*;
    use crate::dot;

    /// Chain of n unit masses and springs, fixed at one end: ω_j = 2 sin((2j−1)π/(2(2n+1))) (Rayleigh 1894).
    fn chain(n: usize, stiffness: f64) -> (Matrix, Matrix) {
        let (mut k, mut m) = (Matrix::zeros(n, n), Matrix::zeros(n, n));
        for i in 0..n {
            m.add(i, i, 1.0);
            k.add(i, i, if i + 1 < n { 2.0 * stiffness } else { stiffness });
            if i > 0 {
                k.add(i, i - 1, -stiffness);
                k.add(i - 1, i, -stiffness);
            }
        }
        (k, m)
    }

    #[test]
    fn chain_frequencies() {
        let n = 40;
        let (k, m) = chain(n, 1.0);
        let eigen = generalized_eigen(&k, &m, None).unwrap();
        assert_eq!(eigen.omega.len(), n);
        for (j, omega) in eigen.omega.iter().enumerate() {
            let exact = 2.0 * ((2 * j + 1) as f64 * std::f64::consts::FRAC_PI_2 / (2 * n + 1) as f64).sin();
            assert!((omega / exact - 1.0).abs() < 1e-12, "mode {}: {omega} {exact}", j + 1);
            for i in 0..=j {
                let product = dot(eigen.vectors.column(i), &m.times(eigen.vectors.column(j)));
                assert!((product - f64::from(i == j)).abs() < 1e-11);
            }
        }
    }

    /// A soft chain and one 10¹² times stiffer: the soft frequencies keep their digits.
    #[test]
    fn low_modes_survive_a_stiff_neighbour() {
        let n = 20;
        let (soft, unit) = chain(n, 10.0);
        let (stiff, _) = chain(n, 1e13);
        let (mut k, mut m) = (Matrix::zeros(2 * n, 2 * n), Matrix::zeros(2 * n, 2 * n));
        for j in 0..n {
            for i in 0..n {
                k.add(i, j, soft.get(i, j));
                k.add(n + i, n + j, stiff.get(i, j));
                m.add(i, j, unit.get(i, j));
                m.add(n + i, n + j, unit.get(i, j));
            }
            // Weak inertial coupling keeps the two from being solved apart.
            m.add(j, n + j, 0.1);
            m.add(n + j, j, 0.1);
        }
        let eigen = generalized_eigen(&k, &m, Some(5)).unwrap();
        // The stiff chain moves as if held, so the low modes are those of the soft chain alone.
        let alone = generalized_eigen(&soft, &unit, Some(5)).unwrap();
        for (found, expected) in eigen.omega.iter().zip(&alone.omega) {
            assert!((found / expected - 1.0).abs() < 1e-10, "{found} {expected}");
        }
    }

    /// Two chains 10¹⁸ apart in stiffness: the stiff one is beyond double precision and is omitted, not returned
    /// wrong.
    #[test]
    fn modes_beyond_double_precision_are_left_out() {
        let n = 6;
        let (soft, unit) = chain(n, 1.0);
        let (stiff, _) = chain(n, 1e18);
        let (mut k, mut m) = (Matrix::zeros(2 * n, 2 * n), Matrix::zeros(2 * n, 2 * n));
        for j in 0..n {
            for i in 0..n {
                k.add(i, j, soft.get(i, j));
                k.add(n + i, n + j, stiff.get(i, j));
                m.add(i, j, unit.get(i, j));
                m.add(n + i, n + j, unit.get(i, j));
            }
            m.add(j, n + j, 0.3);
            m.add(n + j, j, 0.3);
        }
        let eigen = generalized_eigen(&k, &m, Some(2 * n)).unwrap();
        assert!((n..2 * n).contains(&eigen.omega.len()), "{:?}", eigen.omega);
        let alone = generalized_eigen(&soft, &unit, None).unwrap();
        for (found, expected) in eigen.omega.iter().zip(&alone.omega) {
            assert!((found / expected - 1.0).abs() < 1e-6, "{found} {expected}");
        }
    }

    #[test]
    fn indefinite_stiffness_is_rejected() {
        let (k, m) = chain(4, -1.0);
        assert!(matches!(
            generalized_eigen(&k, &m, None),
            Err(LinalgError::NotPositiveDefinite { .. })
        ));
    }
}
