//! The beta distribution on an interval, from its mean and standard deviation.
//!
//! ```text
//! m = (μ − low)/(high − low)    v = (σ/(high − low))²    t = m (1 − m)/v − 1    α = m t    β = (1 − m) t
//! ```

use statrs::function::beta::beta_reg;

/// A beta distribution on an interval.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Beta {
    low: f64,
    high: f64,
    alpha: f64,
    beta: f64,
}

impl Beta {
    /// From mean and standard deviation.
    ///
    /// `None` where the interval has no such distribution: a mean outside it, or a deviation of √((μ − low)(high − μ)) or more.
    pub fn new([low, high]: [f64; 2], mean: f64, deviation: f64) -> Option<Beta> {
        let width = high - low;
        let (m, v) = ((mean - low) / width, (deviation / width).powi(2));
        let t = m * (1.0 - m) / v - 1.0;
        let (alpha, beta) = (m * t, (1.0 - m) * t);
        (alpha > 0.0 && beta > 0.0 && alpha.is_finite() && beta.is_finite() && width > 0.0).then_some(Beta {
            low,
            high,
            alpha,
            beta,
        })
    }

    /// The value below which a share `u` of the probability lies, 0 < u < 1.
    pub fn quantile(&self, u: f64) -> f64 {
        let (mut a, mut b) = (0.0_f64, 1.0_f64);
        // The distribution function grows: 60 halvings are exact to 1e-18 of the interval.
        for _ in 0..60 {
            let x = 0.5 * (a + b);
            if x > 0.0 && x < 1.0 && beta_reg(self.alpha, self.beta, x) < u { a = x } else { b = x }
        }
        self.low + 0.5 * (a + b) * (self.high - self.low)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// α = 2, β = 3 has the mean 0.4 and the variance 0.04, and I_x(2, 3) = 6x² − 8x³ + 3x⁴ (integral of 12 x (1 − x)²).
    #[test]
    fn a_polynomial_distribution() {
        let beta = Beta::new([0.0, 1.0], 0.4, 0.2).unwrap();
        assert!((beta.alpha - 2.0).abs() < 1e-12 && (beta.beta - 3.0).abs() < 1e-12);
        for x in [0.05_f64, 0.3, 0.5, 0.9] {
            let u = 6.0 * x.powi(2) - 8.0 * x.powi(3) + 3.0 * x.powi(4);
            assert!((beta.quantile(u) - x).abs() < 1e-10);
        }
    }

    /// The arcsine distribution, α = β = ½: I_x = (2/π) arcsin √x, here on [8, 12].
    #[test]
    fn the_arcsine_distribution_on_an_interval() {
        let beta = Beta::new([8.0, 12.0], 10.0, 4.0 / 8.0_f64.sqrt()).unwrap();
        let x: f64 = 0.2;
        let u = 2.0 / std::f64::consts::PI * x.sqrt().asin();
        assert!((beta.quantile(u) - (8.0 + 4.0 * x)).abs() < 1e-9);
    }

    #[test]
    fn impossible_moments() {
        assert_eq!(Beta::new([0.0, 1.0], 1.2, 0.1), None);
        assert_eq!(Beta::new([0.0, 1.0], 0.5, 0.5), None);
        assert_eq!(Beta::new([1.0, 1.0], 1.0, 0.1), None);
    }
}
