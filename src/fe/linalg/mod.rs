//! Plain `f64` linear algebra over faer: the only module that names it, so that it is compiled once.

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
        Matrix {
            rows,
            cols,
            data: vec![0.0; rows * cols],
        }
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
}
