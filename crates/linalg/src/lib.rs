//! Plain `f64` linear algebra over faer; the only crate that uses faer, so that its generic code is compiled once.
//!
//! Everything but [`Fronts`] runs on the calling thread (`Par::Seq`): the systems of the harmonic engine are too small to gain from a
//! second one.

mod basis;
mod dense;
mod eigen;
mod factor;
mod fronts;
mod gmres;
mod lanczos;
mod minres;
mod noise;
mod ordering;
mod pencil;
mod sparse;
mod symbolic;
mod symmetric;

pub use dense::{Cholesky, product, transposed_product};
pub use eigen::{Eigen, generalized_eigen};
pub use factor::{Factor, Inertia, Kind};
pub use fronts::{Fronts, Keep};
pub use gmres::gmres;
pub use lanczos::{Modes, Search, modes};
pub use minres::{Iterations, Precondition, minres};
pub use ordering::Ordering;
pub use pencil::{Pencil, Shifted, Sparse, trusted};
pub use sparse::{SparseCholesky, Triplets};
pub use symbolic::Symbolic;
pub use symmetric::{Pattern, Symmetric};

/// Failure of a factorisation or of the eigenvalue solver.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
pub enum LinalgError {
    /// A pivot is not positive.
    #[error("not positive definite: pivot {pivot} of {size}")]
    NotPositiveDefinite {
        /// Number of the pivot, from 1 (0 if unknown).
        pivot: usize,
        /// Number of rows.
        size: usize,
    },
    /// A zero pivot.
    #[error("singular matrix ({size} unknowns)")]
    Singular {
        /// Number of rows.
        size: usize,
    },
    /// An order of elimination that does not list every unknown once.
    #[error("the order of elimination does not list each of the {size} unknowns once")]
    Order {
        /// Number of rows.
        size: usize,
    },
    /// An inertia count that disagrees with the eigenpairs found.
    #[error(
        "{found} eigenvalues found between {from:.6e} and {to:.6e} rad2/s2, but the signs of the pivots give {counted}"
    )]
    Count {
        /// Eigenpairs found.
        found: usize,
        /// Number by inertia.
        counted: usize,
        /// Lower end of the interval [rad²/s²].
        from: f64,
        /// Upper end [rad²/s²].
        to: f64,
    },
    /// A reduction without a pole.
    #[error("a reduction needs at least one pole")]
    Poles,
    /// Conjugate gradients without convergence.
    #[error("no convergence in {iterations} iterations: relative residual {residual:.1e}, allowed {allowed:.0e}")]
    Iteration {
        /// Iterations done.
        iterations: usize,
        /// Relative residual reached.
        residual: f64,
        /// Relative residual allowed.
        allowed: f64,
    },
    /// A stiffness in a row of an unknown that is to be condensed.
    #[error("entry ({row}, {column}) of the stiffness belongs to an unknown that is to be condensed, allowed: zero")]
    NotCondensable {
        /// Row of the entry.
        row: usize,
        /// Its column.
        column: usize,
    },
    /// A liquid without boundary condition or coupling.
    #[error("the liquid of unknown {unknown} is not coupled to a surface, a wall or a fixed potential")]
    UncoupledLiquid {
        /// One of its unknowns.
        unknown: usize,
    },
    /// Not enough memory, or indices that overflow.
    #[error("out of memory: {size} unknowns")]
    Memory {
        /// Number of rows.
        size: usize,
    },
    /// Eigenvalue iteration without convergence, or an eigenpair that fails its residual check.
    #[error("eigenpair {number} of {wanted}: relative residual {residual:.1e}, allowed {allowed:.0e}")]
    Eigen {
        /// Number of the pair, from 1, by ascending frequency.
        number: usize,
        /// How many are wanted.
        wanted: usize,
        /// Residual found (infinite without convergence).
        residual: f64,
        /// Residual allowed.
        allowed: f64,
    },
}

/// Dense matrix, column by column.
#[derive(Clone, Debug, PartialEq)]
pub struct Matrix {
    /// Number of rows.
    pub rows: usize,
    /// Number of columns.
    pub cols: usize,
    /// Entries, entry (i, j) at `i + j * rows`.
    pub data: Vec<f64>,
}

impl Matrix {
    /// Matrix of zeros.
    pub fn zeros(rows: usize, cols: usize) -> Matrix {
        Matrix { rows, cols, data: vec![0.0; rows * cols] }
    }

    /// Entry (i, j).
    pub fn get(&self, i: usize, j: usize) -> f64 {
        self.data[i + j * self.rows]
    }

    /// Adds to entry (i, j).
    pub fn add(&mut self, i: usize, j: usize, value: f64) {
        self.data[i + j * self.rows] += value;
    }

    /// Column j.
    pub fn column(&self, j: usize) -> &[f64] {
        &self.data[j * self.rows..(j + 1) * self.rows]
    }

    /// Column j, to be changed.
    pub fn column_mut(&mut self, j: usize) -> &mut [f64] {
        &mut self.data[j * self.rows..(j + 1) * self.rows]
    }

    /// y = A x.
    pub fn times(&self, x: &[f64]) -> Vec<f64> {
        let mut y = vec![0.0; self.rows];
        for (j, &xj) in x.iter().enumerate() {
            if xj != 0.0 {
                for (yi, aij) in y.iter_mut().zip(self.column(j)) {
                    *yi += aij * xj;
                }
            }
        }
        y
    }

    /// y = Aᵀ x.
    pub fn transposed_times(&self, x: &[f64]) -> Vec<f64> {
        (0..self.cols).map(|j| dot(self.column(j), x)).collect()
    }

    /// Rows `rows` and columns `cols` of the matrix, in that order.
    pub fn select(&self, rows: &[usize], cols: &[usize]) -> Matrix {
        let mut out = Matrix::zeros(rows.len(), cols.len());
        for (j, &from) in cols.iter().enumerate() {
            let column = self.column(from);
            for (value, &i) in out.column_mut(j).iter_mut().zip(rows) {
                *value = column[i];
            }
        }
        out
    }
}

/// Scalar product of two vectors of equal length.
pub fn dot(a: &[f64], b: &[f64]) -> f64 {
    a.iter().zip(b).map(|(x, y)| x * y).sum()
}
