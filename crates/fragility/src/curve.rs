//! The lognormal curve.

use serde::{Deserialize, Serialize};

use crate::normal;

/// P(im) = Φ(ln(im/θ)/β).
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub struct Lognormal {
    /// Median θ, in the unit of the intensity.
    pub median: f64,
    /// Dispersion β, standard deviation of ln im.
    pub dispersion: f64,
}

impl Lognormal {
    /// Probability at an intensity.
    pub fn probability(&self, im: f64) -> f64 {
        if im > 0.0 { normal::cdf((im / self.median).ln() / self.dispersion) } else { 0.0 }
    }

    /// The intensity at which the probability is `p`.
    pub fn quantile(&self, p: f64) -> f64 {
        self.median * (self.dispersion * normal::quantile(p)).exp()
    }

    /// Mean of the capacity, θ exp(β²/2).
    pub fn mean(&self) -> f64 {
        self.median * (0.5 * self.dispersion.powi(2)).exp()
    }

    /// Standard deviation of the capacity, mean √(exp β² − 1).
    pub fn standard_deviation(&self) -> f64 {
        self.mean() * self.dispersion.powi(2).exp_m1().sqrt()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn moments_and_quantiles() {
        let curve = Lognormal { median: 0.5, dispersion: 0.4 };
        assert!((curve.probability(0.5) - 0.5).abs() < 1e-15);
        assert!((curve.probability(curve.quantile(0.16)) - 0.16).abs() < 1e-9);
        // Moments by quadrature over the quantiles, midpoints of 2·10⁵ equal shares; the tails beyond lose 1e-4.
        let n = 200_000;
        let at = |i: usize| curve.quantile((i as f64 + 0.5) / n as f64);
        let mean = (0..n).map(at).sum::<f64>() / n as f64;
        let square = (0..n).map(|i| (at(i) - mean).powi(2)).sum::<f64>() / n as f64;
        assert!((mean / curve.mean() - 1.0).abs() < 1e-4);
        assert!((square.sqrt() / curve.standard_deviation() - 1.0).abs() < 1e-3);
    }
}
