//! The formulas as values, for the tests.

use super::*;
use tank::formula::evaluate;

/// Effective weights over the product weight and heights over the liquid level (module description).
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct EffectiveMasses {
    /// Impulsive weight W_i/W_p.
    pub w_i: f64,
    /// Convective weight W_c/W_p.
    pub w_c: f64,
    /// Height X_i/H of the impulsive force on the wall.
    pub x_i: f64,
    /// Height X_c/H of the convective force on the wall.
    pub x_c: f64,
    /// Height X_is/H of the impulsive force with base pressure.
    pub x_is: f64,
    /// Height X_cs/H of the convective force with base pressure.
    pub x_cs: f64,
}

/// Effective weights and heights for the ratio D/H > 0.
pub(crate) fn effective_masses(d_over_h: f64) -> EffectiveMasses {
    let of = |text| {
        let u = evaluate(ARGUMENT, &[("D", d_over_h), ("H", 1.0)]);
        evaluate(text, &[("D", d_over_h), ("H", 1.0), ("W_p", 1.0), ("u", u)])
    };
    let charts = charts(d_over_h);
    EffectiveMasses {
        w_i: of(charts.w_i),
        w_c: of(charts.w_c),
        x_i: of(charts.x_i),
        x_c: of(charts.x_c),
        x_is: of(charts.x_is),
        x_cs: of(charts.x_cs),
    }
}

/// Sloshing coefficient k of the 9th edition (figure E-4), in `T = k √D` with D in feet.
pub(crate) fn sloshing_coefficient_1993(d_over_h: f64) -> f64 {
    evaluate(COEFFICIENT_1993, &[("u", 3.67 / d_over_h)])
}

/// Sloshing period of the 9th edition [s]: `T = k √(D/0.3048 m)`.
pub(crate) fn sloshing_period_1993(diameter: f64, d_over_h: f64) -> f64 {
    let k = sloshing_coefficient_1993(d_over_h);
    evaluate(PERIOD_1993, &[("k", k), ("D", diameter)])
}

/// Sloshing coefficient K_s of the current annex (E.4.5.2).
pub(crate) fn sloshing_coefficient(d_over_h: f64) -> f64 {
    evaluate(COEFFICIENT, &[("H", 1.0), ("D", d_over_h)])
}

/// Sloshing period of the current annex [s]: `T_c = 1.8 K_s √D`, D in metres.
pub(crate) fn sloshing_period(diameter: f64, d_over_h: f64) -> f64 {
    let k_s = sloshing_coefficient(d_over_h);
    evaluate(PERIOD, &[("K_s", k_s), ("D", diameter)])
}

/// Impulsive period T_i [s], `None` outside figure E.1.
pub(crate) fn impulsive_period(diameter: f64, depth: f64, density: f64, thickness: f64, modulus: f64) -> Option<f64> {
    let terms = [
        ("C_i", impulsive_coefficient(depth / diameter)?),
        ("H", depth),
        ("ρ", density),
        ("t_u", thickness),
        ("D", diameter),
        ("E", modulus),
    ];
    Some(evaluate(IMPULSIVE_PERIOD, &terms))
}
