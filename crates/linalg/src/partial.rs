//! Elimination of the first unknowns of a symmetric matrix, with what it leaves on the last ones.
//!
//! ```text
//! A = ⎡ E  Bᵀ ⎤ = ⎡ L   0 ⎤ ⎡ D     ⎤ ⎡ Lᵀ  Yᵀ ⎤        C = −B E⁻¹ Bᵀ
//!     ⎣ B  0  ⎦   ⎣ Y   1 ⎦ ⎣    C  ⎦ ⎣ 0   1  ⎦
//!
//! forward    y = L⁻¹ b_E ,  b_S − Y y = b_S − B E⁻¹ b_E
//! backward   x_E = L⁻ᵀ (D⁻¹ y − Yᵀ x_S)
//! ```
//!
//! Forward and backward together are one sweep down and one sweep up the factor, as many as a solution with all of A takes. The last
//! unknowns are factored with −d on their diagonal, d > 0, so that their block is negative definite whenever E is positive definite,
//! and d is added to C again: its error is that of a factor of a matrix with the diagonal d.
//!
//! The order of elimination is that of the unknowns. Source: Przemieniecki 1963 (substructures).

use std::sync::Arc;

use faer::sparse::linalg::cholesky::SymbolicCholeskyRaw;

use super::{Factor, Kind, LinalgError, Matrix, Pattern, Symbolic, Symmetric, transposed_product};

/// Columns of a factor that are used at a time.
const LANES: usize = 8;

/// A matrix whose first unknowns are eliminated.
pub struct Partial {
    /// E and B. Places of the block of the last unknowns are not used.
    pub matrix: Symmetric,
    eliminated: usize,
    symbolic: Arc<Symbolic>,
    factor: Option<Factor>,
}

impl Partial {
    /// For a pattern that has all places of the block of the last unknowns, those after the first `eliminated`.
    ///
    /// Errors: not enough memory.
    pub fn new(pattern: Arc<Pattern>, eliminated: usize) -> Result<Partial, LinalgError> {
        let symbolic = Arc::new(Symbolic::supernodal(pattern.clone())?);
        Ok(Partial {
            matrix: Symmetric::zeros(pattern),
            eliminated,
            symbolic,
            factor: None,
        })
    }

    /// Entries of the factor.
    pub fn entries(&self) -> usize {
        self.symbolic.entries()
    }

    /// Additions and multiplications of one factorisation.
    pub fn flops(&self) -> f64 {
        self.symbolic.flops()
    }

    /// Factors the values of `matrix`; returns the lower triangle of C. `scale` is d, of the size of the diagonal to which C will be added.
    ///
    /// Errors: a zero pivot, not enough memory; there is no factor then.
    pub fn factor(&mut self, scale: &[f64]) -> Result<Matrix, LinalgError> {
        let pattern = self.matrix.pattern.clone();
        for (j, d) in (self.eliminated..pattern.size()).zip(scale) {
            let column = pattern.starts[j]..pattern.starts[j + 1];
            self.matrix.values[column.clone()].fill(0.0);
            self.matrix.values[column.start] = -d;
        }
        let factor = match self.factor.take() {
            Some(mut factor) => factor.refactor(&self.matrix).map(|()| factor)?,
            None => self.symbolic.factor(&self.matrix, Kind::QuasiDefinite)?,
        };
        let mut left = self.trailing(&factor);
        for (j, d) in scale.iter().enumerate() {
            left.add(j, j, *d);
        }
        self.factor = Some(factor);
        Ok(left)
    }

    /// L D Lᵀ of the last unknowns.
    fn trailing(&self, factor: &Factor) -> Matrix {
        let (size, first) = (self.matrix.size(), self.eliminated);
        let left = size - first;
        // Lᵀ and D Lᵀ.
        let (mut upper, mut scaled) = (Matrix::zeros(left, left), Matrix::zeros(left, left));
        self.each_supernode(factor, |node| {
            let width = node.last - node.first;
            let height = width + node.below.len();
            for j in node.first.max(first)..node.last {
                let own = j - node.first;
                let column = &node.values[own * height..(own + 1) * height];
                let d = column[own];
                let mut put = |row: usize, l: f64| {
                    upper.add(j - first, row - first, l);
                    scaled.add(j - first, row - first, d * l);
                };
                put(j, 1.0);
                (own + 1..width).for_each(|i| put(node.first + i, column[i]));
                node.below.iter().zip(&column[width..]).for_each(|(&i, &l)| put(i, l));
            }
        });
        transposed_product(&upper, &scaled)
    }

    fn each_supernode<'a>(&self, factor: &'a Factor, mut see: impl FnMut(Supernode<'a>)) {
        let SymbolicCholeskyRaw::Supernodal(s) = factor.analysis().raw() else {
            unreachable!("the analysis has supernodes");
        };
        (0..s.n_supernodes()).for_each(|k| see(Supernode::of(factor, s, k)));
    }

    /// b ← (L⁻¹ b_E, b_S − B E⁻¹ b_E). Does nothing without a factor.
    pub fn forward(&self, b: &mut [f64]) {
        let Some(factor) = &self.factor else { return };
        let mut room: Vec<f64> = Vec::new();
        self.each_supernode(factor, |node| {
            if node.first >= self.eliminated {
                return;
            }
            let (width, columns) = (node.last - node.first, node.last.min(self.eliminated) - node.first);
            let height = width + node.below.len();
            room.clear();
            room.extend_from_slice(&b[node.first..node.last]);
            room.extend(node.below.iter().map(|_| 0.0));
            for j in 0..columns {
                let y = room[j];
                if y != 0.0 {
                    let column = &node.values[j * height + j + 1..(j + 1) * height];
                    room[j + 1..].iter_mut().zip(column).for_each(|(r, l)| *r -= l * y);
                }
            }
            b[node.first..node.last].copy_from_slice(&room[..width]);
            node.below.iter().zip(&room[width..]).for_each(|(&i, r)| b[i] += r);
        });
    }

    /// x ← (E⁻¹ (b_E − Bᵀ x_S), x_S) from what [`Partial::forward`] left in the first unknowns. Does nothing without a factor.
    pub fn backward(&self, x: &mut [f64]) {
        let Some(factor) = &self.factor else { return };
        let SymbolicCholeskyRaw::Supernodal(s) = factor.analysis().raw() else {
            return;
        };
        let mut room: Vec<f64> = Vec::new();
        for k in (0..s.n_supernodes()).rev() {
            let node = Supernode::of(factor, s, k);
            if node.first >= self.eliminated {
                continue;
            }
            let (width, columns) = (node.last - node.first, node.last.min(self.eliminated) - node.first);
            let height = width + node.below.len();
            room.clear();
            room.extend_from_slice(&x[node.first..node.last]);
            room.extend(node.below.iter().map(|&i| x[i]));
            for j in (0..columns).rev() {
                let column = &node.values[j * height + j..(j + 1) * height];
                room[j] = room[j] / column[0] - dot(&column[1..], &room[j + 1..]);
            }
            x[node.first..node.first + columns].copy_from_slice(&room[..columns]);
        }
    }
}

/// Columns `first..last` of a factor: their rows in the same order, then those `below`. D is on the diagonal.
struct Supernode<'a> {
    first: usize,
    last: usize,
    below: &'a [usize],
    values: &'a [f64],
}

impl<'a> Supernode<'a> {
    fn of(
        factor: &'a Factor,
        s: &'a faer::sparse::linalg::cholesky::supernodal::SymbolicSupernodalCholesky<usize>,
        k: usize,
    ) -> Supernode<'a> {
        let (first, last) = (s.supernode_begin()[k], s.supernode_end()[k]);
        let start = s.col_ptr_for_val()[k];
        let below = &s.row_idx()[s.col_ptr_for_row_idx()[k]..][..s.nnz_per_super()[k]];
        Supernode {
            first,
            last,
            below,
            values: &factor.values()[start..start + (last - first) * (last - first + below.len())],
        }
    }
}

/// Σ a b, in [`LANES`] sums.
fn dot(a: &[f64], b: &[f64]) -> f64 {
    let mut sums = [0.0; LANES];
    let (left, right) = (a.chunks_exact(LANES), b.chunks_exact(LANES));
    let rest: f64 = left.remainder().iter().zip(right.remainder()).map(|(a, b)| a * b).sum();
    for (a, b) in left.zip(right) {
        for (sum, (a, b)) in sums.iter_mut().zip(a.iter().zip(b)) {
            *sum += a * b;
        }
    }
    sums.iter().sum::<f64>() + rest
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A chain of blocks with a coupling of everything to the last unknowns.
    fn matrix(size: usize, eliminated: usize) -> Symmetric {
        let mut cliques: Vec<Vec<usize>> = (0..size - 2).map(|i| vec![i, i + 1, i + 2]).collect();
        cliques.push((eliminated - 3..size).collect());
        cliques.push((eliminated..size).chain([0, 5]).collect());
        let pattern = Arc::new(Pattern::from_cliques(size, cliques.iter().map(Vec::as_slice)));
        let mut a = Symmetric::zeros(pattern.clone());
        for j in 0..size {
            for p in pattern.starts[j]..pattern.starts[j + 1] {
                let i = pattern.rows[p];
                a.values[p] = match i == j {
                    true => 40.0 + (j as f64).sin(),
                    false => ((3 * i + 7 * j) as f64).cos(),
                };
            }
        }
        a
    }

    /// Eliminating the first unknowns, solving for the last ones and going back is solving the whole: rounding alone.
    #[test]
    fn substructure_is_the_whole() {
        let (size, eliminated) = (60, 47);
        let a = matrix(size, eliminated);
        let b: Vec<f64> = (0..size).map(|i| (1.7 * i as f64).sin()).collect();
        let order = super::super::Ordering::MinimumDegree;
        let whole = Arc::new(Symbolic::new(a.pattern.clone(), &order).unwrap());
        let expected = whole.factor(&a, Kind::Definite).unwrap().solve_vector(&b).unwrap();
        let mut partial = Partial::new(a.pattern.clone(), eliminated).unwrap();
        let left = size - eliminated;
        let scale: Vec<f64> = (eliminated..size).map(|i| a.get(i, i)).collect();
        // The second time into the same memory.
        for _ in 0..2 {
            partial.matrix.values.copy_from_slice(&a.values);
            let c = partial.factor(&scale).unwrap();
            let mut x = b.clone();
            partial.forward(&mut x);
            let all: Vec<usize> = (0..left).collect();
            let pattern = Arc::new(Pattern::from_cliques(left, std::iter::once(all.as_slice())));
            let mut s = Symmetric::zeros(pattern.clone());
            for j in 0..left {
                for i in j..left {
                    let value = a.get(eliminated + i, eliminated + j) + c.get(i, j);
                    s.values[pattern.place(i, j).unwrap()] = value;
                }
            }
            let symbolic = Arc::new(Symbolic::new(pattern, &super::super::Ordering::Given(all)).unwrap());
            let last = symbolic.factor(&s, Kind::Definite).unwrap();
            let solved = last.solve_vector(&x[eliminated..]).unwrap();
            x[eliminated..].copy_from_slice(&solved);
            partial.backward(&mut x);
            for (x, e) in x.iter().zip(&expected) {
                assert!((x - e).abs() < 1e-14, "{x} {e}");
            }
        }
    }

    #[test]
    fn sums_in_lanes() {
        let a: Vec<f64> = (0..21).map(f64::from).collect();
        let expected: f64 = a.iter().map(|x| x * x).sum();
        assert!((dot(&a, &a) - expected).abs() < 1e-12);
    }
}
