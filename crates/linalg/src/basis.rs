//! M-orthonormal bases that grow block by block.

use super::pencil::Pencil;
use super::{LinalgError, Matrix, dot, product, transposed_product};

/// A direction counts as new if at least this fraction of it is new; a smaller remainder is rounding.
const NEW: f64 = 1e-12;

/// Columns Q with Qᵀ M Q = I, and M Q.
pub(super) struct Basis<'a> {
    pub pencil: &'a dyn Pencil,
    pub q: Matrix,
    pub mq: Matrix,
}

/// Result of [`Basis::append`]: W = Q `old` + Q_new `new`.
pub(super) struct Appended {
    /// Coefficients on the columns that were there.
    pub old: Matrix,
    /// Coefficients on the columns appended, one row each.
    pub new: Matrix,
}

impl<'a> Basis<'a> {
    pub(crate) fn new(pencil: &'a dyn Pencil) -> Basis<'a> {
        let n = pencil.size();
        Basis { pencil, q: Matrix::zeros(n, 0), mq: Matrix::zeros(n, 0) }
    }

    pub(crate) fn len(&self) -> usize {
        self.q.cols
    }

    /// Appends the directions of W that are not in the basis yet. `noise` is the size (in the M-norm) below which a
    /// direction is rounding.
    pub(crate) fn append(&mut self, mut w: Matrix, noise: f64) -> Result<Appended, LinalgError> {
        let columns = w.cols;
        let mut old = Matrix::zeros(self.len(), columns);
        // Twice is enough (Kahan; Parlett 1998, 6.9).
        for _ in 0..2 {
            let along = transposed_product(&self.mq, &w);
            subtract(&mut w, &product(&self.q, &along));
            for (o, a) in old.data.iter_mut().zip(&along.data) {
                *o += a;
            }
        }
        let mut mw = self.pencil.mass(&w)?;
        let mut new_rows: Vec<Vec<f64>> = Vec::new();
        let first = self.len();
        for j in 0..columns {
            let before: f64 = (0..self.len().min(first)).map(|i| old.get(i, j).powi(2)).sum::<f64>()
                + dot(w.column(j), mw.column(j)).max(0.0);
            let mut along = vec![0.0; self.len() - first];
            for _ in 0..2 {
                for (k, sum) in along.iter_mut().enumerate() {
                    let c = dot(self.mq.column(first + k), w.column(j));
                    *sum += c;
                    axpy(-c, self.q.column(first + k), w.column_mut(j));
                    axpy(-c, self.mq.column(first + k), mw.column_mut(j));
                }
            }
            for (k, a) in along.iter().enumerate() {
                new_rows[k][j] = *a;
            }
            let length = dot(w.column(j), mw.column(j)).max(0.0).sqrt();
            if length.is_nan() || length <= noise.max(NEW * before.sqrt()) {
                continue;
            }
            let mut row = vec![0.0; columns];
            row[j] = length;
            new_rows.push(row);
            push(&mut self.q, w.column(j), 1.0 / length);
            push(&mut self.mq, mw.column(j), 1.0 / length);
        }
        let mut new = Matrix::zeros(new_rows.len(), columns);
        for (i, row) in new_rows.iter().enumerate() {
            for (j, &v) in row.iter().enumerate() {
                new.data[i + j * new.rows] = v;
            }
        }
        Ok(Appended { old, new })
    }

    /// Columns `first ..`, as a separate matrix.
    pub(crate) fn mass_columns(&self, first: usize) -> Matrix {
        let rows = self.mq.rows;
        Matrix { rows, cols: self.len() - first, data: self.mq.data[first * rows..].to_vec() }
    }

    /// Replaces the first `of` columns by their combinations Q Y.
    pub(crate) fn combine(&mut self, of: usize, y: &Matrix) {
        for matrix in [&mut self.q, &mut self.mq] {
            let rows = matrix.rows;
            let rest = matrix.data.split_off(of * rows);
            let head = Matrix { rows, cols: of, data: std::mem::take(&mut matrix.data) };
            matrix.data = product(&head, y).data;
            matrix.data.extend(rest);
            matrix.cols = matrix.data.len() / rows;
        }
    }
}

fn subtract(a: &mut Matrix, b: &Matrix) {
    for (x, y) in a.data.iter_mut().zip(&b.data) {
        *x -= y;
    }
}

fn axpy(factor: f64, x: &[f64], y: &mut [f64]) {
    for (y, x) in y.iter_mut().zip(x) {
        *y += factor * x;
    }
}

fn push(matrix: &mut Matrix, column: &[f64], factor: f64) {
    matrix.data.extend(column.iter().map(|v| v * factor));
    matrix.cols += 1;
}
