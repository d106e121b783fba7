//! Sparse factors of symmetric matrices: one symbolic phase a pattern, one numeric phase a set of values.
//!
//! ```text
//! LLᵀ    positive definite          LDLᵀ   quasi-definite, no pivoting
//! LBLᵀ   indefinite, Bunch-Kaufman pivoting within supernodes
//! ```
//!
//! The inertia (numbers of positive and negative pivots) of K − σ M counts the eigenvalues below σ (Sylvester).

use std::sync::Arc;

use faer::dyn_stack::{MemBuffer, MemStack};
use faer::perm::PermRef;
use faer::sparse::linalg::cholesky::{
    CholeskySymbolicParams, LdltRef, LltRef, SymbolicCholesky, SymmetricOrdering, factorize_symbolic_cholesky,
};
use faer::sparse::{SparseColMatRef, SymbolicSparseColMatRef};
use faer::{Conj, Par, Side};

use super::dense::view_mut;
use super::{LinalgError, Matrix, Pattern, Symmetric};

/// How a matrix is factored.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Kind {
    /// LLᵀ: positive definite.
    Definite,
    /// LDLᵀ without pivoting: quasi-definite.
    QuasiDefinite,
}

/// Order in which unknowns are eliminated: `order[k]` is the k-th.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Ordering {
    /// Minimum degree, on the matrix alone.
    MinimumDegree,
    /// A given order.
    Given(Vec<usize>),
}

/// The symbolic phase for one pattern.
#[derive(Debug)]
pub struct Symbolic {
    pattern: Arc<Pattern>,
    symbolic: SymbolicCholesky<usize>,
}

impl Symbolic {
    /// Analyses a pattern.
    ///
    /// Errors: not enough memory.
    pub fn new(pattern: Arc<Pattern>, ordering: &Ordering) -> Result<Symbolic, LinalgError> {
        let size = pattern.size();
        let view = SymbolicSparseColMatRef::new_checked(size, size, &pattern.starts, None, &pattern.rows);
        let inverse: Vec<usize>;
        let order = match ordering {
            Ordering::MinimumDegree => SymmetricOrdering::Amd,
            Ordering::Given(order) => {
                let mut inv = vec![0; size];
                for (k, &i) in order.iter().enumerate() {
                    inv[i] = k;
                }
                inverse = inv;
                SymmetricOrdering::Custom(PermRef::new_checked(order, &inverse, size))
            }
        };
        let symbolic = factorize_symbolic_cholesky(view, Side::Lower, order, CholeskySymbolicParams::default())
            .map_err(|_| LinalgError::Memory { size })?;
        Ok(Symbolic { pattern, symbolic })
    }

    /// Entries of the factor; 8 bytes each.
    pub fn entries(&self) -> usize {
        self.symbolic.len_val()
    }

    /// Factors a matrix on the pattern.
    ///
    /// Errors: a pivot that is not positive (`Definite`) or zero, not enough memory.
    pub fn factor(self: &Arc<Self>, matrix: &Symmetric, kind: Kind) -> Result<Factor, LinalgError> {
        let size = self.pattern.size();
        let memory = |_| LinalgError::Memory { size };
        let singular = LinalgError::NotPositiveDefinite { pivot: 0, size };
        let mut values = Vec::new();
        values
            .try_reserve_exact(self.symbolic.len_val())
            .map_err(|_| LinalgError::Memory { size })?;
        values.resize(self.symbolic.len_val(), 0.0);
        let pattern = &*self.pattern;
        let view = SparseColMatRef::new(
            SymbolicSparseColMatRef::new_checked(size, size, &pattern.starts, None, &pattern.rows),
            &matrix.values,
        );
        match kind {
            Kind::Definite => {
                let scratch = self
                    .symbolic
                    .factorize_numeric_llt_scratch::<f64>(Par::Seq, Default::default());
                let mut buffer = MemBuffer::try_new(scratch).map_err(memory)?;
                self.symbolic
                    .factorize_numeric_llt(
                        &mut values,
                        view,
                        Side::Lower,
                        Default::default(),
                        Par::Seq,
                        MemStack::new(&mut buffer),
                        Default::default(),
                    )
                    .map_err(|_| singular.clone())?;
            }
            Kind::QuasiDefinite => {
                let scratch = self
                    .symbolic
                    .factorize_numeric_ldlt_scratch::<f64>(Par::Seq, Default::default());
                let mut buffer = MemBuffer::try_new(scratch).map_err(memory)?;
                self.symbolic
                    .factorize_numeric_ldlt(
                        &mut values,
                        view,
                        Side::Lower,
                        Default::default(),
                        Par::Seq,
                        MemStack::new(&mut buffer),
                        Default::default(),
                    )
                    .map_err(|_| singular.clone())?;
            }
        }
        if !values.iter().all(|v| v.is_finite()) {
            return Err(singular);
        }
        Ok(Factor {
            symbolic: self.clone(),
            values,
            kind,
        })
    }
}

/// Numeric factor of a matrix.
#[derive(Debug)]
pub struct Factor {
    symbolic: Arc<Symbolic>,
    values: Vec<f64>,
    kind: Kind,
}

impl Factor {
    /// Number of unknowns.
    pub fn size(&self) -> usize {
        self.symbolic.pattern.size()
    }

    /// B ← A⁻¹ B, all columns at once.
    ///
    /// Errors: not enough memory.
    pub fn solve(&self, b: &mut Matrix) -> Result<(), LinalgError> {
        let symbolic = &self.symbolic.symbolic;
        let scratch = symbolic.solve_in_place_scratch::<f64>(b.cols, Par::Seq);
        let mut buffer = MemBuffer::try_new(scratch).map_err(|_| LinalgError::Memory { size: self.size() })?;
        let stack = MemStack::new(&mut buffer);
        match self.kind {
            Kind::Definite => {
                LltRef::new(symbolic, &self.values).solve_in_place_with_conj(Conj::No, view_mut(b), Par::Seq, stack)
            }
            Kind::QuasiDefinite => {
                LdltRef::new(symbolic, &self.values).solve_in_place_with_conj(Conj::No, view_mut(b), Par::Seq, stack)
            }
        }
        Ok(())
    }

    /// A⁻¹ b.
    ///
    /// Errors: not enough memory.
    pub fn solve_vector(&self, b: &[f64]) -> Result<Vec<f64>, LinalgError> {
        let mut x = Matrix {
            rows: b.len(),
            cols: 1,
            data: b.to_vec(),
        };
        self.solve(&mut x)?;
        Ok(x.data)
    }
}
