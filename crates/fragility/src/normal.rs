//! The standard normal distribution.

use std::f64::consts::{PI, SQRT_2};

use statrs::function::erf;

/// φ(x).
pub fn density(x: f64) -> f64 {
    (-0.5 * x * x).exp() / (2.0 * PI).sqrt()
}

/// Φ(x); accurate in the lower tail.
pub fn cdf(x: f64) -> f64 {
    0.5 * libm::erfc(-x / SQRT_2)
}

/// Φ⁻¹(p), 0 < p < 1.
pub fn quantile(p: f64) -> f64 {
    let x = -SQRT_2 * erf::erfc_inv(2.0 * p);
    // The inverse has ten digits; a step of Newton's method doubles them.
    let step = (cdf(x) - p) / density(x);
    if step.is_finite() { x - step } else { x }
}

/// ln Φ(x), also where Φ(x) underflows: −x²/2 − ln(−x √2π) + ln(1 − 1/x² + 3/x⁴ − 15/x⁶) (Abramowitz & Stegun 26.2.12).
pub fn ln_cdf(x: f64) -> f64 {
    if x > -30.0 {
        return cdf(x).ln();
    }
    let s = 1.0 / (x * x);
    -0.5 * x * x - (-x * (2.0 * PI).sqrt()).ln() + (1.0 - s * (1.0 - 3.0 * s * (1.0 - 5.0 * s))).ln()
}

/// φ(x)/Φ(x), the slope of ln Φ.
pub fn hazard(x: f64) -> f64 {
    (-0.5 * x * x - 0.5 * (2.0 * PI).ln() - ln_cdf(x)).exp()
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Abramowitz & Stegun table 26.1: Φ(1), Φ(2), Φ(−3); 26.2.12 far in the tail: ln Φ(−40) = −804.608442…
    #[test]
    fn values() {
        assert!((cdf(1.0) - 0.841_344_746_068_543).abs() < 1e-14);
        assert!((cdf(2.0) - 0.977_249_868_051_821).abs() < 1e-14);
        assert!((cdf(-3.0) - 0.001_349_898_031_630_095).abs() < 1e-16);
        // Φ⁻¹ loses what Φ rounds: 1e-16 over φ(2).
        assert!((quantile(0.977_249_868_051_821) - 2.0).abs() < 1e-13);
        assert!((ln_cdf(-40.0) + 804.608_442).abs() < 1e-5);
        // Both branches meet.
        assert!((ln_cdf(-30.0) - ln_cdf(-29.999_999_9)).abs() < 1e-4);
        assert!((hazard(-40.0) - 40.0).abs() < 0.03);
    }
}
