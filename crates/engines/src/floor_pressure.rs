//! Pressure of the impulsive liquid on the bottom of a rigid cylinder.
//!
//! ```text
//! p_b(r) cos θ a ,   p_b(r) = ρ Σ 2 (−1)^n/(H α_n²) I₁(α_n r)/I₁′(α_n R) ,   α_n = (2 n + 1) π/(2 H)
//! ```
//!
//! Source: Haroun & Housner 1981 (series).

use std::f64::consts::PI;

use tank::Case;

/// Impulsive pressure on the bottom at θ = 0 at the distance r from the axis [Pa per m/s²].
pub fn impulsive_pressure(case: &Case, radius: f64, r: f64) -> f64 {
    let depth = case.liquid.fill_height;
    let mut sum = 0.0;
    for n in 0..200 {
        let alpha = (2.0 * f64::from(n) + 1.0) * PI / (2.0 * depth);
        // Beyond it the terms are below 1e-4 of the first and exp overflows soon.
        if alpha * radius > 300.0 {
            break;
        }
        let sign = if n % 2 == 0 { 1.0 } else { -1.0 };
        let (own, _) = bessel(alpha * r);
        let (_, slope) = bessel(alpha * radius);
        sum += sign * 2.0 / (depth * alpha * alpha) * own / slope;
    }
    case.liquid.density * sum
}

/// I₁(x) and I₁′(x) by their power series, all of whose terms are positive.
fn bessel(x: f64) -> (f64, f64) {
    let quarter = 0.25 * x * x;
    let (mut term, mut k) = (0.5, 0.0);
    let (mut over_x, mut slope) = (term, term);
    loop {
        k += 1.0;
        term *= quarter / (k * (k + 1.0));
        over_x += term;
        slope += (2.0 * k + 1.0) * term;
        if (2.0 * k + 1.0) * term <= 1e-17 * slope {
            return (x * over_x, slope);
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// I₁(1) = 0.565159, I₁′(1) = I₀(1) − I₁(1) = 0.700907 (Abramowitz & Stegun 1964, table 9.8).
    #[test]
    fn bessel_function() {
        let (value, slope) = bessel(1.0);
        assert!((value - 0.565_159_1).abs() < 1e-7 && (slope - 0.700_906_8).abs() < 1e-7);
    }

    /// A deep tank: the liquid at the bottom moves with it, p = ρ r a.
    #[test]
    fn a_deep_liquid_is_rigid_at_its_bottom() {
        let mut case = tank::reference::broad(1000.0);
        let radius = case.tank.shape.half_length();
        case.liquid.fill_height = 10.0 * radius;
        for r in [0.3, 0.7, 1.0] {
            let p = impulsive_pressure(&case, radius, r * radius);
            assert!((p / (1000.0 * r * radius) - 1.0).abs() < 0.01, "{r}: {p}");
        }
    }
}
