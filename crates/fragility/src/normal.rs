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

/// ln Φ(x), and its slope φ(x)/Φ(x).
pub fn ln_cdf_and_slope(x: f64) -> (f64, f64) {
    /// ln(2π)/2.
    const HALF_LN_2_PI: f64 = 0.918_938_533_204_672_8;
    let tail = ln_cdf(x);
    (tail, (-0.5 * x * x - HALF_LN_2_PI - tail).exp())
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
        // Quantiles of Wichura 1988 (algorithm AS 241) and its 16 digits.
        for (p, x) in
            [(0.25, -0.674_489_750_196_081_7), (0.001, -3.090_232_306_167_813_5), (1e-20, -9.262_340_089_798_408)]
        {
            assert!((quantile(p) - x).abs() < 1e-14 * (1.0 + x.abs()), "{p}: {}", quantile(p));
        }
        assert!((ln_cdf(-40.0) + 804.608_442).abs() < 1e-5);
        // Both branches meet.
        assert!((ln_cdf(-30.0) - ln_cdf(-29.999_999_9)).abs() < 1e-4);
        assert!((ln_cdf_and_slope(-40.0).1 - 40.0).abs() < 0.03);
        // φ(1)/Φ(1) of the same table.
        assert!((ln_cdf_and_slope(1.0).1 - 0.241_970_724_519_143 / 0.841_344_746_068_543).abs() < 1e-14);
    }
}
