//! Sparse Cholesky factor of a symmetric positive definite matrix.

use faer::dyn_stack::{MemBuffer, MemStack};
use faer::sparse::linalg::cholesky::{
    CholeskySymbolicParams, LltRef, SymbolicCholesky, SymmetricOrdering, factorize_symbolic_cholesky,
};
use faer::sparse::{SparseColMatRef, SymbolicSparseColMatRef};
use faer::{Conj, Par, Side};

use super::dense::view_mut;
use super::{LinalgError, Matrix};

/// Entries of a square symmetric matrix while it is being assembled; several for one place are added.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Triplets {
    size: usize,
    entries: Vec<(usize, usize, f64)>,
}

impl Triplets {
    /// An empty matrix with `size` rows.
    pub fn new(size: usize) -> Triplets {
        Triplets { size, entries: Vec::new() }
    }

    /// Number of rows.
    pub fn size(&self) -> usize {
        self.size
    }

    /// Adds to entry (i, j). Entries above the diagonal are ignored: the matrix is symmetric.
    pub fn add(&mut self, i: usize, j: usize, value: f64) {
        if i >= j {
            self.entries.push((j, i, value));
        }
    }

    /// The full matrix, for tests and small systems.
    pub fn to_dense(&self) -> Matrix {
        let mut out = Matrix::zeros(self.size, self.size);
        for &(j, i, value) in &self.entries {
            out.add(i, j, value);
            if i != j {
                out.add(j, i, value);
            }
        }
        out
    }

    /// Compressed columns of the lower triangle: column starts, row indices, values.
    fn compress(&self) -> (Vec<usize>, Vec<usize>, Vec<f64>) {
        let mut sorted = self.entries.clone();
        sorted.sort_by_key(|&(j, i, _)| (j, i));
        let (mut start, mut row, mut value) = (vec![0; self.size + 1], Vec::new(), Vec::<f64>::new());
        let mut last = None;
        for (j, i, v) in sorted {
            if last == Some((j, i)) {
                *value.last_mut().expect("an entry precedes its duplicate") += v;
            } else {
                row.push(i);
                value.push(v);
                start[j + 1] += 1;
                last = Some((j, i));
            }
        }
        for j in 0..self.size {
            start[j + 1] += start[j];
        }
        (start, row, value)
    }
}

/// Cholesky factor of a sparse matrix, with a minimum-degree order (plane meshes with one unknown per node).
#[derive(Debug)]
pub struct SparseCholesky {
    symbolic: SymbolicCholesky<usize>,
    values: Vec<f64>,
}

impl SparseCholesky {
    /// Factors the matrix.
    ///
    /// Errors: a pivot that is not positive, or not enough memory.
    pub fn factor(matrix: &Triplets) -> Result<SparseCholesky, LinalgError> {
        let size = matrix.size;
        let memory = |_| LinalgError::Memory { size };
        let (start, row, value) = matrix.compress();
        let pattern = SymbolicSparseColMatRef::new_checked(size, size, &start, None, &row);
        let symbolic = factorize_symbolic_cholesky(
            pattern,
            Side::Lower,
            SymmetricOrdering::Amd,
            CholeskySymbolicParams::default(),
        )
        .map_err(|_| LinalgError::Memory { size })?;
        let mut values = vec![0.0; symbolic.len_val()];
        let scratch = symbolic.factorize_numeric_llt_scratch::<f64>(Par::Seq, Default::default());
        let mut buffer = MemBuffer::try_new(scratch).map_err(memory)?;
        symbolic
            .factorize_numeric_llt(
                &mut values,
                SparseColMatRef::new(pattern, &value),
                Side::Lower,
                Default::default(),
                Par::Seq,
                MemStack::new(&mut buffer),
                Default::default(),
            )
            .map_err(|_| LinalgError::NotPositiveDefinite { pivot: 0, size })?;
        if values.iter().all(|v| v.is_finite()) {
            Ok(SparseCholesky { symbolic, values })
        } else {
            Err(LinalgError::NotPositiveDefinite { pivot: 0, size })
        }
    }

    /// Number of unknowns.
    pub fn size(&self) -> usize {
        self.symbolic.nrows()
    }

    /// Entries of the factor.
    pub fn entries(&self) -> usize {
        self.values.len()
    }

    /// B ← A⁻¹ B for all columns.
    ///
    /// Errors: not enough memory.
    pub fn solve(&self, b: &mut Matrix) -> Result<(), LinalgError> {
        let scratch = self.symbolic.solve_in_place_scratch::<f64>(b.cols, Par::Seq);
        let mut buffer = MemBuffer::try_new(scratch).map_err(|_| LinalgError::Memory { size: self.size() })?;
        LltRef::new(&self.symbolic, &self.values).solve_in_place_with_conj(
            Conj::No,
            view_mut(b),
            Par::Seq,
            MemStack::new(&mut buffer),
        );
        Ok(())
    }
}
