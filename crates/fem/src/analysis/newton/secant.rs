//! Secant updates of a kept factor: BFGS with few pairs.
//!
//! ```text
//! H ← (I − ρ s yᵀ) H (I − ρ y sᵀ) + ρ s sᵀ          ρ = 1/sᵀy
//! ```
//!
//! s is an increment, y = r(u) − r(u + s) what it took from the residual, H₀ the inverse that the factor stands for. Two loops over the pairs around one
//! solution apply H, which is symmetric and positive definite with H₀ as long as sᵀy > 0. A factor that is kept is that of an earlier state: the pairs tell what has
//! changed along the increments since, a point of the ground that has closed or a hinge that yields, at the price of products of vectors.
//!
//! Source: Matthies & Strang 1979; Nocedal 1980 (two loops).

use std::collections::VecDeque;

use crate::linalg::dot;

/// Pairs kept.
const MOST: usize = 4;
/// Least sᵀy of the work sᵀr(u) that the increment was to do: less says that the forces grow along it.
const CURVED: f64 = 0.05;

struct Pair {
    s: Vec<f64>,
    y: Vec<f64>,
    /// sᵀy.
    product: f64,
}

/// Pairs since the last factor.
#[derive(Default)]
pub(super) struct Secants {
    pairs: VecDeque<Pair>,
    /// Residual before the last increment; empty where that increment teaches nothing.
    before: Vec<f64>,
}

impl Secants {
    /// Forgets everything: the factor is another one.
    pub(super) fn clear(&mut self) {
        self.pairs.clear();
        self.before.clear();
    }

    /// Takes r before an increment.
    pub(super) fn begin(&mut self, r: &[f64]) {
        self.before.clear();
        self.before.extend_from_slice(r);
    }

    /// Learns from r after the increment `s`.
    pub(super) fn learn(&mut self, s: &[f64], r: &[f64]) {
        if self.before.len() != r.len() {
            return;
        }
        let work = dot(s, &self.before);
        let product = work - dot(s, r);
        // Neither is true of a number that is not one.
        if work > 0.0 && product > CURVED * work {
            let mut pair = match self.pairs.len() {
                MOST => self.pairs.pop_front(),
                _ => None,
            }
            .unwrap_or(Pair { s: Vec::new(), y: Vec::new(), product: 0.0 });
            pair.s.clear();
            pair.s.extend_from_slice(s);
            pair.y.clear();
            pair.y.extend(self.before.iter().zip(r).map(|(before, after)| before - after));
            pair.product = product;
            self.pairs.push_back(pair);
        }
        self.before.clear();
    }

    /// b ← (I − ρ y sᵀ) … b, from the last pair to the first; the coefficients are for [`Secants::after`].
    pub(super) fn ahead(&self, b: &mut [f64]) -> Vec<f64> {
        let step = |pair: &Pair| {
            let alpha = dot(&pair.s, b) / pair.product;
            b.iter_mut().zip(&pair.y).for_each(|(b, y)| *b -= alpha * y);
            alpha
        };
        self.pairs.iter().rev().map(step).collect()
    }

    /// x ← (I − ρ s yᵀ) x + ρ s sᵀb …, from the first pair to the last.
    pub(super) fn after(&self, x: &mut [f64], alphas: &[f64]) {
        for (pair, alpha) in self.pairs.iter().zip(alphas.iter().rev()) {
            let beta = alpha - dot(&pair.y, x) / pair.product;
            x.iter_mut().zip(&pair.s).for_each(|(x, s)| *x += beta * s);
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::linalg::Matrix;

    /// For a quadratic function and H₀ = I, pairs along the steps of steepest descent with exact searches are those of conjugate gradients: of four unknowns,
    /// four pairs make H the inverse, so that H A x = x to rounding at a condition of 10.
    #[test]
    fn four_pairs_are_the_inverse_of_four_unknowns() {
        let n = 4;
        let mut a = Matrix::zeros(n, n);
        for i in 0..n {
            a.add(i, i, 2.0 + 2.0 * i as f64);
            if i > 0 {
                a.add(i, i - 1, 0.7);
                a.add(i - 1, i, 0.7);
            }
        }
        let times = |x: &[f64]| -> Vec<f64> { (0..n).map(|i| (0..n).map(|j| a.get(i, j) * x[j]).sum()).collect() };
        let mut secants = Secants::default();
        let apply = |secants: &Secants, b: &[f64]| {
            let mut x = b.to_vec();
            let alphas = secants.ahead(&mut x);
            secants.after(&mut x, &alphas);
            x
        };
        let mut r = vec![1.0, -2.0, 0.5, 3.0];
        for _ in 0..n {
            let d = apply(&secants, &r);
            let ad = times(&d);
            let length = dot(&d, &r) / dot(&d, &ad);
            let s: Vec<f64> = d.iter().map(|d| length * d).collect();
            secants.begin(&r);
            r.iter_mut().zip(&ad).for_each(|(r, ad)| *r -= length * ad);
            secants.learn(&s, &r);
        }
        assert_eq!(secants.pairs.len(), n);
        let x = [0.3, -1.0, 2.0, 0.1];
        for (found, x) in apply(&secants, &times(&x)).iter().zip(&x) {
            assert!((found - x).abs() < 1e-12, "{found} {x}");
        }
    }

    /// An increment along which the forces grow, or one whose end is not a number, teaches nothing.
    #[test]
    fn pairs_without_curvature_are_left_out() {
        let mut secants = Secants::default();
        for after in [[1.0, 0.0], [2.0, 0.0], [f64::NAN, 0.0]] {
            secants.begin(&[1.0, 0.0]);
            secants.learn(&[1.0, 0.0], &after);
            assert!(secants.pairs.is_empty(), "{after:?}");
        }
    }
}
