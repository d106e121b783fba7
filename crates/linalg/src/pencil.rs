//! The pencil K x = ω² M x for eigenvalue solvers and reductions: products with K and M, and solves with K + s M.
//!
//! [`Pencil`] is implemented by [`Sparse`] (K and M assembled), and by the verification program where M is known only through the potential
//! of a liquid.

use std::sync::Arc;

use super::noise::Noise;
use super::{Factor, Kind, LinalgError, Matrix, Symbolic, Symmetric, dot};

/// K x = ω² M x with K and M symmetric, M positive semi-definite.
pub trait Pencil {
    /// Number of unknowns.
    fn size(&self) -> usize;

    /// K X.
    fn stiffness(&self, x: &Matrix) -> Matrix;

    /// |K| |x|, the size of the terms whose sum is K x, one entry per unknown. Rounding leaves K x uncertain
    /// by about 10⁻¹⁶ of it.
    fn stiffness_terms(&self, x: &[f64]) -> Vec<f64>;

    /// M X.
    ///
    /// Errors: not enough memory.
    fn mass(&self, x: &Matrix) -> Result<Matrix, LinalgError>;

    /// Factors K + s M [s in rad²/s²]: definite for s ≥ 0 if K is, indefinite for s < 0.
    ///
    /// Errors: K + s M singular, or not positive definite though s ≥ 0; not enough memory.
    fn shifted(&self, s: f64) -> Result<Box<dyn Shifted + '_>, LinalgError>;

    /// Number of eigenvalues ω² below `sigma` [rad²/s²] (Sylvester's law of inertia), infinite ones not counted.
    ///
    /// Errors: `sigma` is an eigenvalue; not enough memory.
    fn count_below(&self, sigma: f64) -> Result<usize, LinalgError> {
        Ok(self.shifted(-sigma)?.below())
    }
}

/// K + s M, factored.
pub trait Shifted {
    /// B ← (K + s M)⁻¹ B.
    ///
    /// Errors: not enough memory.
    fn solve(&self, b: &mut Matrix) -> Result<(), LinalgError>;

    /// Number of eigenvalues ω² below −s.
    fn below(&self) -> usize;
}

/// K and M assembled on one pattern.
#[derive(Debug)]
pub struct Sparse<'a> {
    stiffness: &'a Symmetric,
    mass: &'a Symmetric,
    symbolic: Arc<Symbolic>,
}

impl<'a> Sparse<'a> {
    /// K and M on the pattern of `symbolic`.
    pub fn new(stiffness: &'a Symmetric, mass: &'a Symmetric, symbolic: Arc<Symbolic>) -> Sparse<'a> {
        Sparse { stiffness, mass, symbolic }
    }
}

impl Pencil for Sparse<'_> {
    fn size(&self) -> usize {
        self.stiffness.size()
    }

    fn stiffness(&self, x: &Matrix) -> Matrix {
        self.stiffness.times_block(x)
    }

    fn stiffness_terms(&self, x: &[f64]) -> Vec<f64> {
        self.stiffness.terms(x)
    }

    fn mass(&self, x: &Matrix) -> Result<Matrix, LinalgError> {
        Ok(self.mass.times_block(x))
    }

    fn shifted(&self, s: f64) -> Result<Box<dyn Shifted + '_>, LinalgError> {
        let mut sum = self.stiffness.clone();
        sum.add(s, self.mass);
        if s >= 0.0 {
            Ok(Box::new(self.symbolic.factor(&sum, Kind::Definite)?))
        } else {
            Ok(Box::new(trusted(&self.symbolic, &sum)?))
        }
    }
}

/// Largest backward error of a factor without pivoting that is trusted; pivots that are large enough leave about
/// 10⁻¹⁵.
const BACKWARD: f64 = 1e-12;
/// The same with pivoting, which is limited to supernodes.
const BACKWARD_PIVOTED: f64 = 1e-9;

/// LDLᵀ, or LBLᵀ if the pivots of the first are too small for a test vector. Errors: the matrix is
/// singular to rounding, so that both fail; not enough memory.
pub fn trusted(symbolic: &Arc<Symbolic>, matrix: &Symmetric) -> Result<Factor, LinalgError> {
    match symbolic.factor(matrix, Kind::QuasiDefinite) {
        Ok(factor) if backward_error(&factor, matrix)? <= BACKWARD => return Ok(factor),
        Ok(_) | Err(LinalgError::Singular { .. }) => {}
        Err(other) => return Err(other),
    }
    let factor = symbolic.factor(matrix, Kind::Indefinite)?;
    if backward_error(&factor, matrix)? <= BACKWARD_PIVOTED {
        Ok(factor)
    } else {
        Err(LinalgError::Singular { size: matrix.size() })
    }
}

/// ‖b − A x‖/‖|A| |x|‖ for the solution x of a system with an arbitrary right-hand side.
fn backward_error(factor: &Factor, matrix: &Symmetric) -> Result<f64, LinalgError> {
    let mut rest = Noise::new().block(matrix.size(), 1).data;
    let x = factor.solve_vector(&rest)?;
    matrix.add_product(-1.0, &x, &mut rest);
    let terms = matrix.terms(&x);
    let error = (dot(&rest, &rest) / dot(&terms, &terms)).sqrt();
    Ok(if error.is_nan() { f64::INFINITY } else { error })
}

impl Shifted for Factor {
    fn solve(&self, b: &mut Matrix) -> Result<(), LinalgError> {
        Factor::solve(self, b)
    }

    fn below(&self) -> usize {
        self.inertia().negative
    }
}
