//! Caughey's damping series through given ratios.
//!
//! ```text
//! C = M Σ_k a_k (M⁻¹ K)^k        ξ(ω) = 1/2 Σ_k a_k ω^(2k−1),  k = 0 … n − 1
//! ```
//!
//! The n coefficients follow from n pairs (ω_i, ξ_i). ξ ω is a polynomial in ω² of degree n − 1, so that Lagrange's form gives the ratios
//! without the coefficients, which are ill-conditioned:
//!
//! ```text
//! ξ(ω) = 1/ω Σ_i ξ_i ω_i Π_{j≠i} (ω² − ω_j²)/(ω_i² − ω_j²)
//! ```
//!
//! Two pairs are Rayleigh damping. Beyond the outermost pairs the series grows without bound, of whatever sign: there a mode has the
//! ratio of the nearest pair, which is damping by modes of the same kind (it keeps the modes uncoupled) but not the series. Source: Caughey
//! 1960; Clough & Penzien 1993, section 12-5.

use super::damping::DampingError;

/// Most pairs.
pub const MOST: usize = 6;

/// The series, by its pairs.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Caughey {
    /// (circular frequency [rad/s], ratio), ascending; the first `count` of them.
    pairs: [(f64, f64); MOST],
    count: usize,
}

impl Caughey {
    /// The series through `pairs` (circular frequency [rad/s], ratio), in any order.
    ///
    /// Errors: fewer than two pairs or more than [`MOST`]; a frequency that is not positive, equal frequencies; a ratio outside 0 to 1.
    pub fn fit(pairs: &[(f64, f64)]) -> Result<Caughey, DampingError> {
        let refuse =
            |found: String, allowed: &str| DampingError { option: "Caughey damping", found, allowed: allowed.into() };
        let count = pairs.len();
        if !(2..=MOST).contains(&count) {
            return Err(refuse(format!("{count} pairs"), "2 to 6 pairs"));
        }
        for &(omega, ratio) in pairs {
            if !(omega > 0.0 && omega.is_finite()) {
                return Err(refuse(format!("circular frequency {omega} rad/s"), "a positive number"));
            }
            if !(0.0..1.0).contains(&ratio) {
                return Err(refuse(format!("damping ratio {ratio}"), "0 to 1"));
            }
        }
        let mut all = [(0.0, 0.0); MOST];
        all[..count].copy_from_slice(pairs);
        all[..count].sort_by(|a, b| a.0.total_cmp(&b.0));
        match all[..count].windows(2).find(|w| w[1].0 - w[0].0 <= 1e-6 * w[1].0) {
            Some(same) => Err(refuse(format!("two pairs at {} rad/s", same[0].0), "different frequencies")),
            None => Ok(Caughey { pairs: all, count }),
        }
    }

    /// Its pairs, ascending.
    pub fn pairs(&self) -> &[(f64, f64)] {
        &self.pairs[..self.count]
    }

    /// Ratio at ω [rad/s].
    pub fn ratio(&self, omega: f64) -> f64 {
        let pairs = self.pairs();
        let (low, high) = (pairs[0], pairs[self.count - 1]);
        if omega <= low.0 {
            return low.1;
        }
        if omega >= high.0 {
            return high.1;
        }
        let term = |i: usize| {
            let (w, ratio) = pairs[i];
            let others = pairs.iter().enumerate().filter(|(j, _)| *j != i);
            let weight = others.map(|(_, &(o, _))| (omega - o) * (omega + o) / ((w - o) * (w + o)));
            ratio * w * weight.product::<f64>()
        };
        (0..pairs.len()).map(term).sum::<f64>() / omega
    }
}

#[cfg(test)]
mod tests {
    use super::super::damping::Rayleigh;
    use super::*;

    /// At its pairs the ratio is exact; two pairs are Rayleigh damping between them: 1e-12, rounding.
    #[test]
    fn two_pairs_are_rayleigh() {
        let pairs = [(30.0, 0.05), (4.0, 0.02)];
        let (caughey, rayleigh) = (Caughey::fit(&pairs).unwrap(), Rayleigh::fit(pairs[0], pairs[1], false).unwrap());
        for omega in [4.0, 5.5, 11.0, 20.0, 29.9, 30.0] {
            assert!((caughey.ratio(omega) - rayleigh.ratio(omega)).abs() < 1e-12);
        }
        assert_eq!((caughey.ratio(1.0), caughey.ratio(1e3)), (0.02, 0.05));
    }

    /// Coefficients a_k = 0.4, 3e−3, −2e−7 given, the ratios of their series at three frequencies as pairs: the same series between them.
    #[test]
    fn a_series_is_found_again() {
        let series = |w: f64| 0.5 * (0.4 / w + 3e-3 * w - 2e-7 * w.powi(3));
        let caughey = Caughey::fit(&[3.0, 20.0, 70.0].map(|w| (w, series(w)))).unwrap();
        for omega in [3.0, 7.0, 13.0, 20.0, 41.0, 69.0, 70.0] {
            assert!((caughey.ratio(omega) - series(omega)).abs() < 1e-12, "{omega}");
        }
    }

    /// The matrix of the series on a chain of three masses: φᵀ C φ = 2 ξ ω at its modes, with C from powers of M⁻¹ K. The eigenvalues of
    /// k/m [[2, −1, 0], [−1, 2, −1], [0, −1, 2]] are 2 − √2, 2 and 2 + √2.
    #[test]
    fn the_matrix_has_the_ratios_in_its_modes() {
        let k = [[2.0, -1.0, 0.0], [-1.0, 2.0, -1.0], [0.0, -1.0, 2.0]];
        let root = 2.0_f64.sqrt();
        let omegas = [2.0 - root, 2.0, 2.0 + root].map(f64::sqrt);
        let modes = [[0.5, root / 2.0, 0.5], [root / 2.0, 0.0, -root / 2.0], [0.5, -root / 2.0, 0.5]];
        let a = [0.02, 0.01, 0.004];
        let times = |x: [f64; 3]| k.map(|row| row.iter().zip(x).map(|(k, x)| k * x).sum::<f64>());
        let damped = |x: [f64; 3]| {
            let (one, two) = (times(x), times(times(x)));
            [0, 1, 2].map(|i| a[0] * x[i] + a[1] * one[i] + a[2] * two[i])
        };
        let ratio = |w: f64| 0.5 * (a[0] / w + a[1] * w + a[2] * w.powi(3));
        let caughey = Caughey::fit(&[0.7, 1.2, 1.9].map(|w| (w, ratio(w)))).unwrap();
        for (omega, mode) in omegas.into_iter().zip(modes) {
            let own: f64 = damped(mode).iter().zip(mode).map(|(c, x)| c * x).sum();
            assert!((own / (2.0 * omega) - caughey.ratio(omega)).abs() < 1e-12, "{omega}");
        }
    }

    #[test]
    fn what_is_not_admissible() {
        for pairs in
            [&[(1.0, 0.02)][..], &[(1.0, 0.02), (1.0, 0.03)], &[(0.0, 0.02), (1.0, 0.03)], &[(1.0, 1.2), (2.0, 0.03)]]
        {
            assert!(Caughey::fit(pairs).is_err());
        }
    }
}
