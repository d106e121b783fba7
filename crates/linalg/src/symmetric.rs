//! Sparse symmetric matrices: a pattern that is shared, and values.

use std::sync::Arc;

use super::Matrix;

/// Places of the lower triangle of a sparse symmetric matrix, column by column with ascending rows. Every diagonal place
/// exists.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Pattern {
    /// Start of each column in `rows`, with the number of places at the end.
    pub starts: Vec<usize>,
    /// Row of each place.
    pub rows: Vec<usize>,
}

impl Pattern {
    /// The pattern of matrices that couple all unknowns within each clique (the unknowns of an element).
    pub fn from_cliques<'a>(size: usize, cliques: impl Iterator<Item = &'a [usize]> + Clone) -> Pattern {
        // Bucket the pairs by column, then sort and dedupe each column.
        let mut counts = vec![1usize; size + 1];
        counts[size] = 0;
        for clique in cliques.clone() {
            for &j in clique {
                counts[j] += clique.iter().filter(|&&i| i > j).count();
            }
        }
        let mut starts = vec![0; size + 1];
        for j in 0..size {
            starts[j + 1] = starts[j] + counts[j];
        }
        let mut rows = vec![0; starts[size]];
        let mut next = starts.clone();
        for (j, place) in next.iter_mut().enumerate().take(size) {
            rows[*place] = j;
            *place += 1;
        }
        for clique in cliques {
            for &j in clique {
                for &i in clique.iter().filter(|&&i| i > j) {
                    rows[next[j]] = i;
                    next[j] += 1;
                }
            }
        }
        let mut packed = Vec::with_capacity(rows.len() / 4);
        let mut packed_starts = vec![0; size + 1];
        for j in 0..size {
            let column = &mut rows[starts[j]..starts[j + 1]];
            column.sort_unstable();
            packed.extend(column.chunk_by(|a, b| a == b).map(|same| same[0]));
            packed_starts[j + 1] = packed.len();
        }
        packed.shrink_to_fit();
        Pattern { starts: packed_starts, rows: packed }
    }

    /// Number of rows and columns.
    pub fn size(&self) -> usize {
        self.starts.len() - 1
    }

    /// Number of places in the lower triangle.
    pub fn places(&self) -> usize {
        self.rows.len()
    }

    /// Place of entry (i, j), i ≥ j, if it exists.
    pub fn place(&self, i: usize, j: usize) -> Option<usize> {
        let (first, last) = (self.starts[j], self.starts[j + 1]);
        self.rows[first..last].binary_search(&i).ok().map(|k| first + k)
    }
}

/// Sparse symmetric matrix.
#[derive(Clone, Debug, PartialEq)]
pub struct Symmetric {
    /// Places.
    pub pattern: Arc<Pattern>,
    /// Value at each place.
    pub values: Vec<f64>,
}

impl Symmetric {
    /// Zeros on a pattern.
    pub fn zeros(pattern: Arc<Pattern>) -> Symmetric {
        Symmetric { values: vec![0.0; pattern.places()], pattern }
    }

    /// Number of rows.
    pub fn size(&self) -> usize {
        self.pattern.size()
    }

    /// Entry (i, j), zero where there is no place.
    pub fn get(&self, i: usize, j: usize) -> f64 {
        let (i, j) = if i >= j { (i, j) } else { (j, i) };
        self.pattern.place(i, j).map_or(0.0, |p| self.values[p])
    }

    /// y ← y + factor A x.
    pub fn add_product(&self, factor: f64, x: &[f64], y: &mut [f64]) {
        let pattern = &*self.pattern;
        for j in 0..self.size() {
            let (first, last) = (pattern.starts[j], pattern.starts[j + 1]);
            let xj = factor * x[j];
            // The diagonal comes first.
            let mut sum = self.values[first] * x[j];
            for (&i, &a) in pattern.rows[first + 1..last].iter().zip(&self.values[first + 1..last]) {
                y[i] += a * xj;
                sum += a * x[i];
            }
            y[j] += factor * sum;
        }
    }

    /// A x.
    pub fn times(&self, x: &[f64]) -> Vec<f64> {
        let mut y = vec![0.0; x.len()];
        self.add_product(1.0, x, &mut y);
        y
    }

    /// A X. The matrix is read once for up to four columns.
    pub fn times_block(&self, x: &Matrix) -> Matrix {
        let mut y = Matrix::zeros(x.rows, x.cols);
        let mut j = 0;
        while j + 4 <= x.cols {
            self.add_four(&x.data[j * x.rows..], &mut y.data[j * x.rows..]);
            j += 4;
        }
        for j in j..x.cols {
            self.add_product(1.0, x.column(j), y.column_mut(j));
        }
        y
    }

    /// Y ← Y + A X for the first four columns of length `size` in `x` and `y`. Values of one row are contiguous
    /// during the product.
    fn add_four(&self, x: &[f64], y: &mut [f64]) {
        let (n, pattern) = (self.size(), &*self.pattern);
        let rows: Vec<[f64; 4]> = (0..n).map(|i| [0, 1, 2, 3].map(|c| x[i + c * n])).collect();
        let mut sums = vec![[0.0; 4]; n];
        for j in 0..n {
            let (first, last) = (pattern.starts[j], pattern.starts[j + 1]);
            let xj = rows[j];
            let mut sum = xj.map(|v| self.values[first] * v);
            for (&i, &a) in pattern.rows[first + 1..last].iter().zip(&self.values[first + 1..last]) {
                for c in 0..4 {
                    sums[i][c] += a * xj[c];
                    sum[c] += a * rows[i][c];
                }
            }
            for c in 0..4 {
                sums[j][c] += sum[c];
            }
        }
        for (i, sum) in sums.iter().enumerate() {
            for c in 0..4 {
                y[i + c * n] += sum[c];
            }
        }
    }

    /// |A| |x|: the size of the terms whose sum is A x.
    pub fn terms(&self, x: &[f64]) -> Vec<f64> {
        let mut y = vec![0.0; x.len()];
        for j in 0..self.size() {
            for p in self.pattern.starts[j]..self.pattern.starts[j + 1] {
                let (i, a) = (self.pattern.rows[p], self.values[p].abs());
                y[i] += a * x[j].abs();
                if i != j {
                    y[j] += a * x[i].abs();
                }
            }
        }
        y
    }

    /// A ← A + factor B, on the same pattern.
    ///
    /// Panics if the patterns differ.
    pub fn add(&mut self, factor: f64, other: &Symmetric) {
        assert!(
            Arc::ptr_eq(&self.pattern, &other.pattern) || self.pattern == other.pattern,
            "matrices of one model share their pattern"
        );
        for (a, b) in self.values.iter_mut().zip(&other.values) {
            *a += factor * b;
        }
    }

    /// The part with rows and columns `keep` (ascending), on a separate pattern.
    pub fn submatrix(&self, keep: &[usize]) -> Symmetric {
        let mut position = vec![usize::MAX; self.size()];
        for (k, &i) in keep.iter().enumerate() {
            position[i] = k;
        }
        let mut starts = vec![0; keep.len() + 1];
        let (mut rows, mut values) = (Vec::new(), Vec::new());
        for (k, &j) in keep.iter().enumerate() {
            for p in self.pattern.starts[j]..self.pattern.starts[j + 1] {
                let i = position[self.pattern.rows[p]];
                if i != usize::MAX {
                    rows.push(i);
                    values.push(self.values[p]);
                }
            }
            starts[k + 1] = rows.len();
        }
        Symmetric { pattern: Arc::new(Pattern { starts, rows }), values }
    }

    /// The rectangular block with the given rows and columns (disjoint sets), as (row, column, value) within the block.
    pub fn block(&self, rows: &[usize], cols: &[usize]) -> Vec<(usize, usize, f64)> {
        let mut row_of = vec![usize::MAX; self.size()];
        let mut col_of = vec![usize::MAX; self.size()];
        for (k, &i) in rows.iter().enumerate() {
            row_of[i] = k;
        }
        for (k, &j) in cols.iter().enumerate() {
            col_of[j] = k;
        }
        let mut out = Vec::new();
        for j in 0..self.size() {
            for p in self.pattern.starts[j]..self.pattern.starts[j + 1] {
                let (i, v) = (self.pattern.rows[p], self.values[p]);
                if v == 0.0 {
                    continue;
                }
                if row_of[i] != usize::MAX && col_of[j] != usize::MAX {
                    out.push((row_of[i], col_of[j], v));
                } else if row_of[j] != usize::MAX && col_of[i] != usize::MAX {
                    out.push((row_of[j], col_of[i], v));
                }
            }
        }
        out
    }

    /// The full matrix, for tests and small systems.
    pub fn to_dense(&self) -> Matrix {
        let mut out = Matrix::zeros(self.size(), self.size());
        for j in 0..self.size() {
            for p in self.pattern.starts[j]..self.pattern.starts[j + 1] {
                let (i, v) = (self.pattern.rows[p], self.values[p]);
                out.add(i, j, v);
                if i != j {
                    out.add(j, i, v);
                }
            }
        }
        out
    }
}
