//! From all unknowns to the free ones: held unknowns drop out, one elevation follows from the balance of volume.

use fem::linalg::Matrix;

/// Linear map x_all = T x_free.
#[derive(Clone, Debug)]
pub(super) struct Reduction {
    /// Index among all unknowns of each free one.
    keep: Vec<usize>,
    /// The unknown that follows from the others, x_e = Σ t_j x_j over all unknowns, t_e = 0.
    eliminated: Option<(usize, Vec<f64>)>,
}

impl Reduction {
    /// Keeps the unknowns that are not held. With `flux` q, the unknown `e` with the largest |q| among `candidates` follows from
    /// qᵀ x = 0.
    pub(super) fn new(held: &[bool], flux: Option<(&[f64], std::ops::Range<usize>)>) -> Reduction {
        let eliminated = flux.map(|(q, candidates)| {
            let e = candidates.max_by(|&a, &b| q[a].abs().total_cmp(&q[b].abs())).expect("the surface has unknowns");
            let t = q.iter().enumerate().map(|(j, v)| if j == e { 0.0 } else { -v / q[e] }).collect();
            (e, t)
        });
        let dependent = eliminated.as_ref().map(|(e, _)| *e);
        let keep = (0..held.len()).filter(|&i| !held[i] && Some(i) != dependent).collect();
        Reduction { keep, eliminated }
    }

    /// Number of free unknowns.
    pub(super) fn len(&self) -> usize {
        self.keep.len()
    }

    /// Free index of one of all unknowns.
    pub(super) fn index(&self, all: usize) -> Option<usize> {
        self.keep.binary_search(&all).ok()
    }

    /// Tᵀ a.
    pub(super) fn row(&self, a: &[f64]) -> Vec<f64> {
        match &self.eliminated {
            None => self.keep.iter().map(|&i| a[i]).collect(),
            Some((e, t)) => self.keep.iter().map(|&i| a[i] + t[i] * a[*e]).collect(),
        }
    }

    /// Tᵀ A T of a symmetric matrix.
    pub(super) fn matrix(&self, a: &Matrix) -> Matrix {
        let mut out = a.select(&self.keep, &self.keep);
        if let Some((e, t)) = &self.eliminated {
            let column = a.column(*e);
            for (j, &q) in self.keep.iter().enumerate() {
                for (i, &p) in self.keep.iter().enumerate() {
                    out.add(i, j, t[p] * column[q] + column[p] * t[q] + t[p] * column[*e] * t[q]);
                }
            }
        }
        out
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use fem::linalg::dot;

    #[test]
    fn elimination_keeps_the_quadratic_form() {
        let mut a = Matrix::zeros(4, 4);
        for i in 0..4 {
            for j in 0..4 {
                a.add(i, j, 1.0 / (1 + i + j) as f64);
            }
        }
        let q = [0.5, -1.0, 3.0, 2.0];
        let reduction = Reduction::new(&[true, false, false, false], Some((&q, 2..4)));
        assert_eq!(reduction.len(), 2);
        assert_eq!((reduction.index(1), reduction.index(2), reduction.index(3)), (Some(0), None, Some(1)));
        // x = (0, 2, x₂, −1) with qᵀ x = 0 gives x₂ = 4/3.
        let (all, free) = ([0.0, 2.0, 4.0 / 3.0, -1.0], [2.0, -1.0]);
        let found = dot(&free, &reduction.matrix(&a).times(&free));
        assert!((found - dot(&all, &a.times(&all))).abs() < 1e-14);
        let row = [7.0, 1.0, -2.0, 5.0];
        assert!((dot(&reduction.row(&row), &free) - dot(&row, &all)).abs() < 1e-14);
    }
}
