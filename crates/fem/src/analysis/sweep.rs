//! Products of several symmetric matrices of one pattern with the same vectors, in one sweep.
//!
//! A step of direct integration needs K a and M a (and C a). The pattern is read once for all of them, with 32-bit
//! indices and the values of one place side by side; several vectors go together in lanes of eight.

use crate::linalg::Symmetric;

const LANES: usize = 8;

/// `S` symmetric matrices of one pattern.
#[derive(Clone, Debug)]
pub struct Sweep<const S: usize> {
    starts: Vec<u32>,
    rows: Vec<u32>,
    values: Vec<[f64; S]>,
    x: Vec<[f64; LANES]>,
    y: Vec<[[f64; LANES]; S]>,
}

impl<const S: usize> Sweep<S> {
    /// Matrices of one pattern with fewer than 2³² places.
    ///
    /// Panics if the patterns differ.
    pub fn new(matrices: [&Symmetric; S]) -> Sweep<S> {
        let pattern = &matrices[0].pattern;
        assert!(matrices.iter().all(|m| m.pattern == *pattern), "matrices of one model share their pattern");
        assert!(pattern.places() < u32::MAX as usize, "places are counted in 32 bits");
        Sweep {
            starts: pattern.starts.iter().map(|&s| s as u32).collect(),
            rows: pattern.rows.iter().map(|&r| r as u32).collect(),
            values: (0..pattern.places()).map(|p| std::array::from_fn(|s| matrices[s].values[p])).collect(),
            x: Vec::new(),
            y: Vec::new(),
        }
    }

    /// Number of rows.
    pub fn size(&self) -> usize {
        self.starts.len() - 1
    }

    /// `out[s]` ← A_s X for every matrix and every column of X (column by column, `columns` of them).
    pub fn apply(&mut self, x: &[f64], columns: usize, out: [&mut [f64]; S]) {
        if columns == 1 {
            return self.apply_one(x, out);
        }
        let n = self.size();
        self.x.resize(n, [0.0; LANES]);
        self.y.resize(n, [[0.0; LANES]; S]);
        let mut out = out;
        for first in (0..columns).step_by(LANES) {
            let count = LANES.min(columns - first);
            for lane in 0..count {
                for (row, value) in self.x.iter_mut().zip(&x[(first + lane) * n..]) {
                    row[lane] = *value;
                }
            }
            self.apply_lanes();
            for (s, out) in out.iter_mut().enumerate() {
                for lane in 0..count {
                    for (value, row) in out[(first + lane) * n..].iter_mut().zip(&self.y) {
                        *value = row[s][lane];
                    }
                }
            }
        }
    }

    fn apply_one(&self, x: &[f64], mut out: [&mut [f64]; S]) {
        for y in &mut out {
            y.fill(0.0);
        }
        for j in 0..self.size() {
            let (first, last) = (self.starts[j] as usize, self.starts[j + 1] as usize);
            let xj = x[j];
            // The diagonal comes first.
            let mut sum = self.values[first].map(|v| v * xj);
            for (&i, value) in self.rows[first + 1..last].iter().zip(&self.values[first + 1..last]) {
                let i = i as usize;
                let xi = x[i];
                for s in 0..S {
                    out[s][i] += value[s] * xj;
                    sum[s] += value[s] * xi;
                }
            }
            for s in 0..S {
                out[s][j] += sum[s];
            }
        }
    }

    fn apply_lanes(&mut self) {
        self.y.fill([[0.0; LANES]; S]);
        for j in 0..self.starts.len() - 1 {
            let (first, last) = (self.starts[j] as usize, self.starts[j + 1] as usize);
            let xj = self.x[j];
            let mut sum = self.values[first].map(|v| xj.map(|x| v * x));
            for (&i, value) in self.rows[first + 1..last].iter().zip(&self.values[first + 1..last]) {
                let xi = self.x[i as usize];
                let y = &mut self.y[i as usize];
                for s in 0..S {
                    for lane in 0..LANES {
                        y[s][lane] += value[s] * xj[lane];
                        sum[s][lane] += value[s] * xi[lane];
                    }
                }
            }
            for s in 0..S {
                for lane in 0..LANES {
                    self.y[j][s][lane] += sum[s][lane];
                }
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use std::sync::Arc;

    use super::*;
    use crate::linalg::Pattern;

    #[test]
    fn equals_the_single_products() {
        let cliques: [&[usize]; 4] = [&[0, 2, 5], &[2, 1, 3], &[3, 0, 4], &[5, 6]];
        let pattern = Arc::new(Pattern::from_cliques(7, cliques.into_iter()));
        let matrix = |phase: f64| {
            let mut a = Symmetric::zeros(pattern.clone());
            for (k, v) in a.values.iter_mut().enumerate() {
                *v = (k as f64 + phase).sin();
            }
            a
        };
        let (a, b) = (matrix(0.3), matrix(1.7));
        let mut sweep = Sweep::new([&a, &b]);
        for columns in [1, 3, 8, 11] {
            let x: Vec<f64> = (0..7 * columns).map(|i| (i as f64 * 0.7).cos()).collect();
            let (mut ya, mut yb) = (vec![9.0; x.len()], vec![9.0; x.len()]);
            sweep.apply(&x, columns, [&mut ya, &mut yb]);
            for c in 0..columns {
                let range = c * 7..(c + 1) * 7;
                for (matrix, y) in [(&a, &ya), (&b, &yb)] {
                    for (f, e) in y[range.clone()].iter().zip(matrix.times(&x[range.clone()])) {
                        assert!((f - e).abs() < 1e-14, "{f} {e}");
                    }
                }
            }
        }
    }
}
