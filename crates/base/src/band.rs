//! Symmetric banded systems: L D Lᵀ within the band, without pivoting.

/// Symmetric matrix with `half` off-diagonals on either side; the lower half is kept row by row.
#[derive(Clone, Debug)]
pub(crate) struct Band {
    half: usize,
    rows: Vec<f64>,
}

impl Band {
    pub(crate) fn new(size: usize, half: usize) -> Band {
        Band {
            half,
            rows: vec![0.0; size * (half + 1)],
        }
    }

    fn size(&self) -> usize {
        self.rows.len() / (self.half + 1)
    }

    fn at(&self, i: usize, j: usize) -> usize {
        i * (self.half + 1) + (j + self.half - i)
    }

    /// K_ij (j within the band, either half).
    pub(crate) fn get(&self, i: usize, j: usize) -> f64 {
        let (i, j) = (i.max(j), i.min(j));
        if i - j > self.half {
            0.0
        } else {
            self.rows[self.at(i, j)]
        }
    }

    /// Adds to K_ij of the lower half, j ≤ i; the upper half follows.
    pub(crate) fn add(&mut self, i: usize, j: usize, value: f64) {
        if j <= i {
            let at = self.at(i, j);
            self.rows[at] += value;
        }
    }

    /// Adds a symmetric block of consecutive unknowns from `first` on.
    pub(crate) fn add_block<const N: usize>(&mut self, first: usize, block: &[[f64; N]; N]) {
        for (a, row) in block.iter().enumerate() {
            let at = self.at(first + a, first);
            for (own, value) in self.rows[at..=at + a].iter_mut().zip(row) {
                *own += value;
            }
        }
    }

    /// Makes unknown `i` known: its row and column become those of the unit matrix.
    pub(crate) fn fix(&mut self, i: usize) {
        for j in i.saturating_sub(self.half)..=(i + self.half).min(self.size() - 1) {
            let at = self.at(i.max(j), i.min(j));
            self.rows[at] = if i == j { 1.0 } else { 0.0 };
        }
    }

    /// Factors in place and solves for `x` in place; false where a pivot is zero or not finite.
    pub(crate) fn solve(mut self, x: &mut [f64]) -> bool {
        let (n, half) = (self.size(), self.half);
        for i in 0..n {
            let first = i.saturating_sub(half);
            let (above, row) = self.rows.split_at_mut(i * (half + 1));
            let mut pivot = row[half];
            for j in first..i {
                // L_ij D_j for now; divided below.
                let other = &above[j * (half + 1)..(j + 1) * (half + 1)];
                let from = first.max(j.saturating_sub(half));
                let (own, rest) = (&row[from + half - i..j + half - i], &other[from + half - j..half]);
                let sum: f64 = own.iter().zip(rest).map(|(a, b)| a * b).sum();
                row[j + half - i] -= sum;
            }
            for j in first..i {
                let (at, diagonal) = (j + half - i, above[j * (half + 1) + half]);
                let scaled = row[at] / diagonal;
                pivot -= scaled * row[at];
                row[at] = scaled;
            }
            if pivot == 0.0 || !pivot.is_finite() {
                return false;
            }
            row[half] = pivot;
        }
        self.substitute(x);
        x.iter().all(|v| v.is_finite())
    }

    fn substitute(&self, x: &mut [f64]) {
        let n = self.size();
        for i in 0..n {
            for j in i.saturating_sub(self.half)..i {
                x[i] -= self.rows[self.at(i, j)] * x[j];
            }
        }
        for i in 0..n {
            x[i] /= self.rows[self.at(i, i)];
        }
        for i in (0..n).rev() {
            for j in i.saturating_sub(self.half)..i {
                x[j] -= self.rows[self.at(i, j)] * x[i];
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::Band;

    /// Second differences with 1 at both ends: −u″ = 2 on five points has the parabola x (6 − x) at x = 1 to 5.
    #[test]
    fn second_differences_give_a_parabola() {
        let mut band = Band::new(5, 2);
        for i in 0..5 {
            band.add(i, i, 2.0);
            if i > 0 {
                band.add(i, i - 1, -1.0);
            }
        }
        let mut x = [2.0; 5];
        assert!(band.solve(&mut x));
        for (i, value) in (1..=5).map(f64::from).zip(x) {
            assert!((value - i * (6.0 - i)).abs() < 1e-12, "{value}");
        }
    }

    #[test]
    fn a_zero_pivot_is_told() {
        let mut band = Band::new(2, 1);
        band.add(0, 0, 1.0);
        assert!(!band.solve(&mut [1.0, 1.0]));
    }
}
