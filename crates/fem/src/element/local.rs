//! Square matrix of one element.

use crate::linalg::Matrix;

/// Square matrix, column by column: entry (i, j) at `i + j n`.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct LocalMatrix {
    /// Number of rows.
    pub n: usize,
    /// Entries.
    pub data: Vec<f64>,
}

impl LocalMatrix {
    /// n × n zeros.
    pub fn zeros(n: usize) -> LocalMatrix {
        LocalMatrix { n, data: vec![0.0; n * n] }
    }

    /// Sets the size and all entries to zero, keeping the storage.
    pub fn reset(&mut self, n: usize) {
        self.n = n;
        self.data.clear();
        self.data.resize(n * n, 0.0);
    }

    /// Entry (i, j).
    pub fn get(&self, i: usize, j: usize) -> f64 {
        self.data[i + j * self.n]
    }

    /// Adds to entry (i, j).
    pub fn add(&mut self, i: usize, j: usize, value: f64) {
        self.data[i + j * self.n] += value;
    }

    /// Adds to entries (i, j) and (j, i).
    pub fn add_symmetric(&mut self, i: usize, j: usize, value: f64) {
        self.add(i, j, value);
        if i != j {
            self.add(j, i, value);
        }
    }

    /// Copies the lower triangle onto the upper one.
    pub fn mirror(&mut self) {
        for j in 0..self.n {
            for i in 0..j {
                self.data[i + j * self.n] = self.data[j + i * self.n];
            }
        }
    }

    /// As a general dense matrix.
    pub fn to_matrix(&self) -> Matrix {
        Matrix { rows: self.n, cols: self.n, data: self.data.clone() }
    }
}
