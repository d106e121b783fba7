//! Unanchored walls: equilibrium of a ring that lifts off on one side.
//!
//! EN 1998-4 A.9 gives diagrams from finite-element studies that are not reproduced here. As an estimate the wall is in contact
//! over the half angle β with linearly varying compression of peak b; elsewhere it lifts and is held down by its weight w_t and
//! a constant pull w_L of the bottom plate. Equilibrium of force and moment is the curve of API 650's figure E-5
//! ([`figure_e5`]): no uplift up to x = M/(D²(w_t + w_L)) = π/4, overturning at π/2. The pull is that of a plate
//! strip with two plastic hinges under the liquid, `w_L = t_b √(p f_y)`, at most the liquid on a strip of 0.02 D.

use std::f64::consts::PI;

use crate::api650::hold_down::figure_e5;

/// Pull of the bottom plate w_L [N/m]: hydrostatic base pressure p, thickness t_b, yield strength f_y, diameter D.
pub(super) const HOLD_DOWN: &str = "min(t_b·√(p·f_y), 0.02·D·p)";

/// How the largest compression N_u of the wall follows from x.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) enum Compression {
    /// No uplift: M/(πR²) = 4M/(πD²) on top of the weight.
    Linear,
    /// Uplift: (N_u + w_L)/(w_t + w_L) of the bearing arc.
    Arc(f64),
}

/// The compression; none if x ≥ π/2, where the tank overturns, or without hold-down.
///
/// * `x`: M/(D²(w_t + w_L))
pub(super) fn compression(x: f64) -> Option<Compression> {
    if x <= 0.25 * PI {
        return Some(Compression::Linear);
    }
    figure_e5(x).map(Compression::Arc)
}

#[cfg(test)]
mod tests {
    use super::*;
    use tank::formula::evaluate;

    fn hold_down(p: f64, t_b: f64, f_y: f64, d: f64) -> f64 {
        evaluate(HOLD_DOWN, &[("p", p), ("t_b", t_b), ("f_y", f_y), ("D", d)])
    }

    /// N_u for a given hold-down.
    fn compression(x: f64, w_t: f64, w_l: f64) -> Option<f64> {
        super::compression(x).map(|how| match how {
            Compression::Linear => w_t + 4.0 / PI * x * (w_t + w_l),
            Compression::Arc(y) => y * (w_t + w_l) - w_l,
        })
    }

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
