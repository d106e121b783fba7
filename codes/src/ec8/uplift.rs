//! Unanchored walls: equilibrium of a ring that lifts off on one side.
//!
//! EN 1998-4 A.9 gives diagrams from finite-element studies that are not reproduced here. As an estimate the wall is in contact
//! over the half angle β with linearly varying compression of peak b; elsewhere it lifts and is held down by its weight w_t and
//! a constant pull w_L of the bottom plate. Equilibrium of force and moment gives, with x = M/(D²(w_t + w_L)),
//!
//! ```text
//! y = (b + w_L)/(w_t + w_L) = π (1 − cos β)/(sin β − β cos β)      x = (y/4)(β − sin β cos β)/(1 − cos β)
//! ```
//!
//! β = π: x = π/4, no uplift; β → 0: x → π/2, overturning (the limits of API 650's appendix E). The pull is that of a plate
//! strip with two plastic hinges under the liquid, `w_L = t_b √(p f_y)`, at most the liquid on a strip of 0.02 D.

use std::f64::consts::PI;

/// `w_L = t_b √(p f_y) ≤ 0.02 D p` [N/m].
///
/// * `pressure`: hydrostatic base pressure p [Pa]; `thickness`: t_b [m]; `yield_strength`: f_y [Pa]; `diameter`: D [m]
pub fn hold_down(pressure: f64, thickness: f64, yield_strength: f64, diameter: f64) -> f64 {
    (thickness * (pressure * yield_strength).sqrt()).min(0.02 * diameter * pressure)
}

/// Largest compression b [N/m]; none if x ≥ π/2, where the tank overturns, or if nothing holds down.
///
/// * `x`: M/(D²(w_t + w_L)); `weight`: w_t, `hold_down`: w_L [N/m]
pub fn compression(x: f64, weight: f64, hold_down: f64) -> Option<f64> {
    let sum = weight + hold_down;
    if x <= 0.25 * PI {
        // No uplift: M/(πR²) = 4M/(πD²) on top of the weight.
        return Some(weight + 4.0 / PI * x * sum);
    }
    if x.is_nan() || x >= 0.5 * PI {
        return None;
    }
    // x falls with β from π/2 to π/4; near β = 0 numerator and denominator cancel, x − π/2 there is below 1e-9 anyway.
    let (mut low, mut high) = (1e-3, PI);
    for _ in 0..100 {
        let middle = 0.5 * (low + high);
        if moment_ratio(middle) > x {
            low = middle;
        } else {
            high = middle;
        }
    }
    Some(force_ratio(0.5 * (low + high)) * sum - hold_down)
}

/// y(β).
fn force_ratio(beta: f64) -> f64 {
    PI * (1.0 - beta.cos()) / (beta.sin() - beta * beta.cos())
}

/// x(β).
fn moment_ratio(beta: f64) -> f64 {
    0.25 * force_ratio(beta) * (beta - beta.sin() * beta.cos()) / (1.0 - beta.cos())
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Published values of the curve (four decimals; API 650 figure E-5 in closed form), with w_L = 0: y = b/w_t.
    #[test]
    fn curve_values() {
        for (x, y) in [
            (0.8, 2.0195),
            (1.0, 2.3745),
            (1.2, 2.9882),
            (1.3, 3.5218),
            (1.4, 4.4660),
            (1.5, 6.9853),
            (1.54, 10.620),
            (1.56, 17.96),
        ] {
            let found = compression(x, 1.0, 0.0).unwrap();
            assert!((found - y).abs() < 6e-5f64.max(3e-4 * y), "{found} {y}");
        }
        assert_eq!(compression(0.5 * PI, 1.0, 0.0), None);
        assert_eq!(compression(f64::NAN, 1.0, 0.0), None);
    }

    /// Both pieces meet at x = π/4 for any split of the hold-down, and b grows with x.
    #[test]
    fn continuous_and_monotone() {
        for (w_t, w_l) in [(1.0, 0.0), (0.3, 0.7)] {
            let at = |x: f64| compression(x, w_t, w_l).unwrap();
            assert!((at(0.25 * PI + 1e-9) - at(0.25 * PI)).abs() < 1e-6);
            let mut before = 0.0;
            for i in 0..150 {
                let b = at(f64::from(i) * 0.01);
                assert!(b > before);
                before = b;
            }
        }
    }

    /// 99 t_b √(F_by G H) N/m with t in mm, F in MPa, H in m, G = 1, g = 9.81 (99.05); limit 196 G H D.
    #[test]
    fn hold_down_is_that_of_api_650() {
        let found = hold_down(9810.0 * 12.0, 0.008, 235e6, 40.0);
        assert!((found / (99.05 * 8.0 * (235.0f64 * 12.0).sqrt()) - 1.0).abs() < 1e-4);
        let capped = hold_down(9810.0 * 12.0, 0.08, 235e6, 4.0);
        assert!((capped / (196.2 * 12.0 * 4.0) - 1.0).abs() < 1e-12);
    }
}
