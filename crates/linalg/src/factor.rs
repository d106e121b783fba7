//! Sparse factors of symmetric matrices.
//!
//! ```text
//! LLᵀ    positive definite
//! LDLᵀ   quasi-definite: a positive and a negative definite diagonal block; every order of pivots exists (Vanderbei 1995)
//! LBLᵀ   indefinite: pivots of one or two rows, Bunch & Kaufman (1977), chosen within supernodes
//! ```
//!
//! The inertia (numbers of positive and negative pivots) of K − σ M counts the eigenvalues below σ (Sylvester).

use std::sync::{Arc, Mutex};

use faer::dyn_stack::{MemBuffer, MemStack, StackReq};
use faer::perm::PermRef;
use faer::sparse::linalg::cholesky::{IntranodeLbltRef, LdltRef, LltRef, SymbolicCholesky, SymbolicCholeskyRaw};
use faer::sparse::{SparseColMatRef, SymbolicSparseColMatRef};
use faer::{Conj, Par, Side};

use super::dense::view_mut;
use super::{LinalgError, Matrix, Symbolic, Symmetric};

/// How a matrix is factored.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Kind {
    /// LLᵀ: positive definite.
    Definite,
    /// LDLᵀ without pivoting: quasi-definite.
    QuasiDefinite,
    /// LBLᵀ with pivoting inside supernodes: anything else. Rows and columns are scaled to a unit diagonal first.
    Indefinite,
}

/// Signs of the pivots.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Inertia {
    /// Positive pivots.
    pub positive: usize,
    /// Negative pivots.
    pub negative: usize,
}

/// Numeric factor of a matrix.
pub struct Factor {
    symbolic: Arc<Symbolic>,
    values: Vec<f64>,
    kind: Kind,
    pivots: Pivots,
    /// Working space of solves, reused.
    space: Mutex<Option<(usize, MemBuffer)>>,
    /// Working space of the factorisation, kept from the second one on: fresh pages cost more than a small factor.
    scratch: Option<MemBuffer>,
}

/// Additional data of a pivoted factor.
#[derive(Default)]
struct Pivots {
    /// Off-diagonal entry of each pivot of two rows, at its first row; zero elsewhere.
    couplings: Vec<f64>,
    forward: Vec<usize>,
    inverse: Vec<usize>,
    /// Scales of the rows.
    scale: Vec<f64>,
}

impl Factor {
    pub(super) fn new(symbolic: Arc<Symbolic>, matrix: &Symmetric, kind: Kind) -> Result<Factor, LinalgError> {
        let size = symbolic.pattern.size();
        let entries = symbolic.of_kind(kind)?.len_val();
        let mut values = Vec::new();
        values.try_reserve_exact(entries).map_err(|_| LinalgError::Memory { size })?;
        values.resize(entries, 0.0);
        let mut factor =
            Factor { symbolic, values, kind, pivots: Pivots::default(), space: Mutex::new(None), scratch: None };
        factor.fill(matrix)?;
        Ok(factor)
    }

    /// Factors other values on the same pattern into the same memory. After an error the factor must not be used.
    ///
    /// Errors: a pivot that is not positive (`Definite`), a zero pivot, not enough memory.
    pub fn refactor(&mut self, matrix: &Symmetric) -> Result<(), LinalgError> {
        let buffer = self.fill(matrix)?;
        self.scratch = Some(buffer);
        Ok(())
    }

    /// Factors; returns the working space.
    // Long: the three kinds side by side.
    fn fill(&mut self, matrix: &Symmetric) -> Result<MemBuffer, LinalgError> {
        let size = self.size();
        assert!(
            Arc::ptr_eq(&matrix.pattern, &self.symbolic.pattern) || matrix.pattern == self.symbolic.pattern,
            "the matrix is on the pattern analysed"
        );
        let symbolic = self.symbolic.of_kind(self.kind)?;
        let scratch = match self.kind {
            Kind::Definite => symbolic.factorize_numeric_llt_scratch::<f64>(Par::Seq, Default::default()),
            Kind::QuasiDefinite => symbolic.factorize_numeric_ldlt_scratch::<f64>(Par::Seq, Default::default()),
            Kind::Indefinite => symbolic.factorize_numeric_intranode_lblt_scratch::<f64>(Par::Seq, Default::default()),
        };
        // The pattern is that of the last time, and so is the size.
        let mut buffer = match self.scratch.take() {
            Some(kept) => kept,
            None => memory(scratch, size)?,
        };
        let stack = MemStack::new(&mut buffer);
        let pattern = &*self.symbolic.pattern;
        let places = SymbolicSparseColMatRef::new_checked(size, size, &pattern.starts, None, &pattern.rows);
        let view = |values| SparseColMatRef::new(places, values);
        match self.kind {
            Kind::Definite => {
                symbolic
                    .factorize_numeric_llt(
                        &mut self.values,
                        view(&matrix.values),
                        Side::Lower,
                        Default::default(),
                        Par::Seq,
                        stack,
                        Default::default(),
                    )
                    .map_err(|_| LinalgError::NotPositiveDefinite { pivot: 0, size })?;
            }
            Kind::QuasiDefinite => {
                symbolic
                    .factorize_numeric_ldlt(
                        &mut self.values,
                        view(&matrix.values),
                        Side::Lower,
                        Default::default(),
                        Par::Seq,
                        stack,
                        Default::default(),
                    )
                    .map_err(|_| LinalgError::Singular { size })?;
            }
            Kind::Indefinite => {
                let pivots = &mut self.pivots;
                pivots.scale = unit_diagonal(matrix);
                pivots.couplings.resize(size, 0.0);
                pivots.forward.resize(size, 0);
                pivots.inverse.resize(size, 0);
                let scaled = scaled(matrix, &pivots.scale);
                symbolic.factorize_numeric_intranode_lblt(
                    &mut self.values,
                    &mut pivots.couplings,
                    &mut pivots.forward,
                    &mut pivots.inverse,
                    view(&scaled),
                    Side::Lower,
                    Par::Seq,
                    stack,
                    Default::default(),
                );
            }
        }
        // A NaN passes the comparison of the pivots, and pivoting divides by zero without an error.
        if self.values.iter().all(|v| v.is_finite()) {
            Ok(buffer)
        } else if self.kind == Kind::Definite {
            Err(LinalgError::NotPositiveDefinite { pivot: 0, size })
        } else {
            Err(LinalgError::Singular { size })
        }
    }

    /// Number of unknowns.
    pub fn size(&self) -> usize {
        self.symbolic.pattern.size()
    }

    /// The symbolic phase.
    pub fn symbolic(&self) -> &Arc<Symbolic> {
        &self.symbolic
    }

    /// The analysis of this kind, which exists since the factor does.
    pub(super) fn analysis(&self) -> &SymbolicCholesky<usize> {
        self.symbolic.of_kind(self.kind).expect("the analysis was made before the factor")
    }

    /// B ← A⁻¹ B for all columns.
    ///
    /// Errors: not enough memory.
    pub fn solve(&self, b: &mut Matrix) -> Result<(), LinalgError> {
        if b.cols == 0 {
            return Ok(());
        }
        let symbolic = self.analysis();
        // Another thread that solves with the same factor creates its own working space.
        let mut held = self.space.try_lock().ok();
        let kept = held.as_mut().and_then(|h| h.take()).filter(|(columns, _)| *columns >= b.cols);
        let (columns, mut buffer) = match kept {
            Some(kept) => kept,
            None => {
                let scratch = symbolic.solve_in_place_scratch::<f64>(b.cols, Par::Seq);
                (b.cols, memory(scratch, self.size())?)
            }
        };
        self.scale_rows(b);
        let stack = MemStack::new(&mut buffer);
        let out = view_mut(b);
        match self.kind {
            Kind::Definite => {
                LltRef::new(symbolic, &self.values).solve_in_place_with_conj(Conj::No, out, Par::Seq, stack);
            }
            Kind::QuasiDefinite => {
                LdltRef::new(symbolic, &self.values).solve_in_place_with_conj(Conj::No, out, Par::Seq, stack);
            }
            Kind::Indefinite => {
                let p = &self.pivots;
                let permutation = PermRef::new_checked(&p.forward, &p.inverse, self.size());
                let factor = IntranodeLbltRef::new(symbolic, &self.values, &p.couplings, permutation);
                factor.solve_in_place_with_conj(Conj::No, out, Par::Seq, stack);
            }
        }
        self.scale_rows(b);
        if let Some(held) = held.as_mut() {
            **held = Some((columns, buffer));
        }
        Ok(())
    }

    fn scale_rows(&self, b: &mut Matrix) {
        if self.kind == Kind::Indefinite {
            for j in 0..b.cols {
                for (v, s) in b.column_mut(j).iter_mut().zip(&self.pivots.scale) {
                    *v *= s;
                }
            }
        }
    }

    /// A⁻¹ b.
    ///
    /// Errors: not enough memory.
    pub fn solve_vector(&self, b: &[f64]) -> Result<Vec<f64>, LinalgError> {
        let mut x = Matrix { rows: b.len(), cols: 1, data: b.to_vec() };
        self.solve(&mut x)?;
        Ok(x.data)
    }

    /// Signs of the pivots.
    pub fn inertia(&self) -> Inertia {
        let mut negative = 0;
        match (self.kind, self.analysis().raw()) {
            (Kind::Definite, _) => {}
            (_, SymbolicCholeskyRaw::Simplicial(s)) => {
                // The diagonal comes first in every column.
                let starts = &s.col_ptr()[..s.ncols()];
                negative = starts.iter().filter(|&&p| self.values[p] < 0.0).count();
            }
            (_, SymbolicCholeskyRaw::Supernodal(s)) => {
                for k in 0..s.n_supernodes() {
                    let (first, last) = (s.supernode_begin()[k], s.supernode_end()[k]);
                    let rows = last - first + s.nnz_per_super()[k];
                    let start = s.col_ptr_for_val()[k];
                    let diagonal = |j: usize| self.values[start + (j - first) * (rows + 1)];
                    let mut j = first;
                    while j < last {
                        let coupling = self.pivots.couplings.get(j).copied().unwrap_or(0.0);
                        if coupling == 0.0 {
                            negative += usize::from(diagonal(j) < 0.0);
                            j += 1;
                        } else {
                            let determinant = diagonal(j) * diagonal(j + 1) - coupling * coupling;
                            negative += match (determinant < 0.0, diagonal(j) < 0.0) {
                                (true, _) => 1,
                                (false, true) => 2,
                                (false, false) => 0,
                            };
                            j += 2;
                        }
                    }
                }
            }
        }
        Inertia { positive: self.size() - negative, negative }
    }
}

impl std::fmt::Debug for Factor {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        f.debug_struct("Factor")
            .field("size", &self.size())
            .field("kind", &self.kind)
            .field("entries", &self.values.len())
            .finish()
    }
}

fn memory(scratch: StackReq, size: usize) -> Result<MemBuffer, LinalgError> {
    MemBuffer::try_new(scratch).map_err(|_| LinalgError::Memory { size })
}

/// 1/√|a_ii|, rounded to a power of two so that scaling is exact; 1 where the diagonal is zero.
fn unit_diagonal(matrix: &Symmetric) -> Vec<f64> {
    let scale = |j: usize| {
        let d = matrix.values[matrix.pattern.starts[j]].abs();
        if d > 0.0 && d.is_finite() { (-0.5 * d.log2()).round().exp2() } else { 1.0 }
    };
    (0..matrix.size()).map(scale).collect()
}

/// D A D.
fn scaled(matrix: &Symmetric, scale: &[f64]) -> Vec<f64> {
    let pattern = &matrix.pattern;
    let mut out = matrix.values.clone();
    for j in 0..matrix.size() {
        for p in pattern.starts[j]..pattern.starts[j + 1] {
            out[p] *= scale[j] * scale[pattern.rows[p]];
        }
    }
    out
}
