//! Symmetric banded systems: L D Lᵀ within the band, without pivoting.
//!
//! Column by column, each taking its part from those after it at once: with a band that is known when the program is built, the sums of a column do not
//! wait for each other.

/// Off-diagonals on either side.
const HALF: usize = 5;
/// The diagonal and what stands below it.
const COLUMN: usize = HALF + 1;

/// Symmetric matrix with at most [`HALF`] off-diagonals on either side; the lower half is kept column by column.
#[derive(Clone, Debug)]
pub(crate) struct Band {
    size: usize,
    /// K_jj, K_j+1,j …; as many columns of zeros follow as the band is wide.
    columns: Vec<[f64; COLUMN]>,
}

impl Band {
    pub(crate) fn new(size: usize) -> Band {
        Band { size, columns: vec![[0.0; COLUMN]; size + HALF] }
    }

    /// Makes all of it zero.
    #[inline(always)]
    pub(crate) fn clear(&mut self) {
        self.columns.fill([0.0; COLUMN]);
    }

    /// K_ij, either half.
    pub(crate) fn get(&self, i: usize, j: usize) -> f64 {
        let (i, j) = (i.max(j), i.min(j));
        self.columns[j].get(i - j).copied().unwrap_or(0.0)
    }

    /// Adds to K_ij of the lower half, j ≤ i ≤ j + [`HALF`]; the upper half follows.
    pub(crate) fn add(&mut self, i: usize, j: usize, value: f64) {
        if j <= i {
            self.columns[j][i - j] += value;
        }
    }

    /// Adds a symmetric block of consecutive unknowns from `first` on, of which the lower half is read.
    #[inline(always)]
    pub(crate) fn add_block<const N: usize>(&mut self, first: usize, block: &[[f64; N]; N]) {
        for (b, column) in self.columns[first..first + N].iter_mut().enumerate() {
            for (own, row) in column.iter_mut().zip(&block[b..]) {
                *own += row[b];
            }
        }
    }

    /// Makes unknown `i` known: its row and column become those of the unit matrix.
    #[inline(always)]
    pub(crate) fn fix(&mut self, i: usize) {
        for (away, column) in self.columns[i.saturating_sub(HALF)..i].iter_mut().rev().enumerate() {
            column[away + 1] = 0.0;
        }
        self.columns[i] = [0.0; COLUMN];
        self.columns[i][0] = 1.0;
    }

    /// Factors in place and solves for `x` in place; false where a pivot is zero or not finite. The matrix is used up.
    #[inline(always)]
    pub(crate) fn solve(&mut self, x: &mut [f64]) -> bool {
        for i in 0..self.size {
            // Columns of zeros follow the last one.
            let Some([column, after @ ..]) = self.columns[i..].first_chunk_mut::<COLUMN>() else { return false };
            let pivot = column[0];
            if pivot == 0.0 || !pivot.is_finite() {
                return false;
            }
            let below = *column;
            for own in &mut column[1..] {
                *own /= pivot;
            }
            for (c, other) in after.iter_mut().enumerate() {
                for r in c..HALF {
                    other[r - c] -= column[r + 1] * below[c + 1];
                }
            }
        }
        self.substitute(x);
        x.iter().all(|v| v.is_finite())
    }

    #[inline(always)]
    fn substitute(&self, x: &mut [f64]) {
        for i in 0..self.size {
            let own = x[i];
            for (x, l) in x[i + 1..].iter_mut().zip(&self.columns[i][1..]) {
                *x -= l * own;
            }
        }
        for (x, column) in x.iter_mut().zip(&self.columns) {
            *x /= column[0];
        }
        for i in (0..self.size).rev() {
            let mut own = x[i];
            for (r, l) in self.columns[i].iter().enumerate().skip(1).rev() {
                own -= l * x.get(i + r).copied().unwrap_or(0.0);
            }
            x[i] = own;
        }
    }
}

#[cfg(test)]
mod tests {
    use super::Band;

    /// Second differences with 1 at both ends: −u″ = 2 on five points has the parabola x (6 − x) at x = 1 to 5.
    #[test]
    fn second_differences_give_a_parabola() {
        let mut band = Band::new(5);
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

    /// A full band, indefinite as contact makes it: K x for an x that is known gives x again.
    #[test]
    fn a_full_band_gives_the_solution() {
        let n = 23;
        let mut band = Band::new(n);
        for i in 0..n {
            for j in i.saturating_sub(5)..=i {
                let sign = if i % 3 == 0 { -1.0 } else { 1.0 };
                let value = if i == j { 20.0 * sign } else { 1.0 / (1 + i + 2 * j) as f64 - 0.3 };
                band.add(i, j, value);
            }
        }
        let wanted: Vec<f64> = (0..n).map(|i| (i as f64 - 7.5) / 3.0).collect();
        let mut x: Vec<f64> = (0..n).map(|i| (0..n).map(|j| band.get(i, j) * wanted[j]).sum()).collect();
        // The fifth unknown is given: its row and column are those of the unit matrix.
        for i in (0..n).filter(|i| *i != 4) {
            x[i] -= band.get(i, 4) * wanted[4];
        }
        x[4] = wanted[4];
        band.fix(4);
        assert!(band.solve(&mut x));
        for (found, wanted) in x.iter().zip(&wanted) {
            assert!((found - wanted).abs() < 1e-12, "{found} {wanted}");
        }
    }

    #[test]
    fn a_zero_pivot_is_told() {
        let mut band = Band::new(2);
        band.add(0, 0, 1.0);
        assert!(!band.solve(&mut [1.0, 1.0]));
    }
}
