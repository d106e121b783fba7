//! Effective masses, their heights and the periods: closed forms of the charts, common to both editions.
//!
//! With the nominal diameter D, the design liquid level H and the product weight W_p = ρ g π D² H/4:
//!
//! ```text
//! W_i/W_p = tanh(0.866 D/H)/(0.866 D/H)        D/H ≥ 1.333        1 − 0.218 D/H     below
//! W_c/W_p = 0.230 (D/H) tanh(3.67 H/D)
//!
//! X_i/H   = 0.375                              D/H ≥ 1.333        0.500 − 0.094 D/H below       ringwall (EBP)
//! X_c/H   = 1 − (cosh u − 1)/(u sinh u)        u = 3.67 H/D
//!
//! X_is/H  = 0.375 [1 + 1.333 (v/tanh v − 1)]   D/H ≥ 1.333        0.500 + 0.060 D/H below       slab (IBP)
//! X_cs/H  = 1 − (cosh u − 1.937)/(u sinh u)    v = 0.866 D/H
//!
//! T = k √D[ft],  k = 0.578/√tanh(3.67 H/D)     T_c = 1.8 K_s √D[m],  K_s = 0.578/√tanh(3.68 H/D)
//! ```
//!
//! The names are those of the current annex; the 9th edition calls `W_i, W_c, X_i, X_c` `W_1, W_2, X_1, X_2` and prints
//! them as charts only. The threshold is one of D/H, not H/D. At it the branches differ by less than 0.1 %. `W_i + W_c`
//! is not `W_p` (1.013 at the threshold), and 1.937 is API's: exact theory has 2.
//!
//! The functions evaluate the formulas that the calculation sheets print.
//!
//! Sources: API 650, 12th edition, E.4.5, E.6.1.1, E.6.1.2; 9th edition, figures E-2, E-3, E-4.

use crate::ec8::simplified;

/// Ratio D/H that parts squat from slender tanks.
pub const SQUAT: f64 = 1.333;

/// Formulas of weights [N] and heights [m] with D, H, W_p and, for the convective part, `u = 3.67 H/D`.
#[derive(Clone, Copy, Debug)]
pub(super) struct Charts {
    pub w_i: &'static str,
    pub w_c: &'static str,
    pub x_i: &'static str,
    pub x_c: &'static str,
    pub x_is: &'static str,
    pub x_cs: &'static str,
}

/// Argument u of the convective part.
pub(super) const ARGUMENT: &str = "3.67·H/D";

/// The formulas of a ratio D/H.
pub(super) fn charts(d_over_h: f64) -> Charts {
    let (w_i, x_i, x_is) = if d_over_h >= SQUAT {
        ("W_p·tanh(0.866·D/H)/(0.866·D/H)", "0.375·H", "0.375·(1 + 1.333·(0.866·D/H/tanh(0.866·D/H) - 1))·H")
    } else {
        ("W_p·(1 - 0.218·D/H)", "(0.5 - 0.094·D/H)·H", "(0.5 + 0.06·D/H)·H")
    };
    // From D/H = 1/80 on cosh and sinh are one to the last digit, before they overflow.
    let (x_c, x_cs) = if 3.67 / d_over_h < 300.0 {
        ("H·(1 - (cosh(u) - 1)/(u·sinh(u)))", "H·(1 - (cosh(u) - 1.937)/(u·sinh(u)))")
    } else {
        ("H·(1 - 1/u)", "H·(1 - 1/u)")
    };
    Charts { w_i, w_c: "W_p·0.23·D/H·tanh(3.67·H/D)", x_i, x_c, x_is, x_cs }
}

/// Sloshing coefficient k of the 9th edition, with u.
pub(super) const COEFFICIENT_1993: &str = "0.578/√(tanh(u))";
/// Sloshing period of the 9th edition [s], with k and D: `1.811 k √D`.
pub(super) const PERIOD_1993: &str = "k·√(D/0.3048 m)";
/// Sloshing coefficient K_s of the current annex.
pub(super) const COEFFICIENT: &str = "0.578/√(tanh(3.68·H/D))";
/// Sloshing period of the current annex [s], with K_s, and D in metres.
///
/// The printed 1.8 is 0.6 % below the 1.811 of the form in feet; it is kept, so that printed examples agree.
pub(super) const PERIOD: &str = "1.8·K_s·√(D)";
/// Impulsive period T_i [s].
///
/// ```text
/// T_i = C_i H √ρ / (√2000 √(t_u/D) √E)      ρ in kg/m³, t_u in mm, D in m, E in MPa
///     = C_i H √ρ / (√(2 t_u/D) √E)          in SI
/// ```
///
/// The factor √2000 turns mm/D into t/R. The American form has 27.8 with ρ in lb/ft³, although some printings have
/// lb/in³.
pub(super) const IMPULSIVE_PERIOD: &str = "C_i·H·√(ρ)/√(2·t_u/D·E)";

/// Coefficient C_i of the impulsive period (figure E.1) for H/D, linear between H/D = 0.15 and 1.5; `None` outside.
///
/// Figure E.1 is the curve of EN 1998-4:2006 table A.2, which has it in numbers.
pub fn impulsive_coefficient(h_over_d: f64) -> Option<f64> {
    let (first, last) = simplified::LIMITS;
    let gamma = 2.0 * h_over_d;
    // Rounding of a ratio at the ends of the figure must not put a tank outside of it.
    if !(first * (1.0 - 1e-12)..=last * (1.0 + 1e-12)).contains(&gamma) {
        return None;
    }
    simplified::table(gamma.clamp(first, last)).map(|row| row.impulsive_period)
}

#[cfg(test)]
mod values;
#[cfg(test)]
pub(crate) use values::*;

#[cfg(test)]
mod tests {
    use super::*;
    use crate::samples::close;
    use proptest::prelude::*;

    /// D = 30 m, H = 12 m, ρ = 900 kg/m³, E = 210 GPa, t_u = 11.680 mm; half of the last printed digit.
    #[test]
    fn worked_example() {
        let m = effective_masses(2.5);
        let w_p = 74_890.2;
        // W_p is printed to 0.05, so the products carry 0.05·0.45 in addition to their own 0.05.
        close(m.w_i * w_p, 33_692.2, 0.08);
        close(m.w_c * w_p, 38_721.0, 0.08);
        close(m.x_i * 12.0, 4.500, 5e-4);
        close(m.x_c * 12.0, 6.88687, 5e-6);
        close(m.x_is * 12.0, 11.83482, 5e-6);
        close(m.x_cs * 12.0, 10.61393, 5e-6);
        close(sloshing_period(30.0, 2.5), 6.0069, 5e-5);
        close(impulsive_coefficient(0.4).unwrap(), 6.767, 5e-4);
        close(impulsive_period(30.0, 12.0, 900.0, 0.011680, 210e9).unwrap(), 0.1905, 5e-5);
        // 9th edition, same tank.
        close(m.w_i, 0.44989, 5e-6);
        close(m.w_c, 0.51704, 5e-6);
        close(m.x_c, 0.57391, 5e-6);
        close(sloshing_coefficient_1993(2.5), 0.60954, 5e-6);
        close(sloshing_period_1993(30.0, 2.5), 6.0472, 5e-5);
    }

    /// The dissertation's tank (D = 3.66 m, H = 1.525 m): the closed charts and its readings. The worst
    /// reading is W1/WT = 0.5, 7 % above the closed form 0.466.
    #[test]
    fn chart_readings_of_the_dissertation() {
        let d_over_h = 3.66 / 1.525;
        let m = effective_masses(d_over_h);
        for (value, closed, digits, reading) in [
            (m.w_i, 0.466, 5e-4, 0.5),
            (m.w_c, 0.5025, 5e-5, 0.5),
            (m.x_i, 0.375, 5e-4, 0.39),
            (m.x_c, 0.579, 5e-4, 0.59),
            (sloshing_coefficient_1993(d_over_h), 0.6058, 5e-5, 0.6),
        ] {
            close(value, closed, digits);
            assert!((reading / value - 1.0).abs() < 0.08, "reading {reading}, closed {value}");
        }
        // Its first sloshing frequency, 3.02 rad/s with k = 0.6 and the foot rounded to 0.305 m; 2.993 with the closed k.
        close(std::f64::consts::TAU / (0.6 * (3.66f64 / 0.305).sqrt()), 3.023, 5e-4);
        close(std::f64::consts::TAU / sloshing_period_1993(3.66, d_over_h), 2.993, 1.0e-3);
    }

    /// Both printings of the impulsive period: √2000 with SI units, 27.8 with ft, lb/ft³, in, psi.
    #[test]
    fn unit_forms_of_the_impulsive_period() {
        let (d, h, rho, t, e) = (30.0, 12.0, 900.0, 0.01168, 210e9);
        let c_i = impulsive_coefficient(h / d).unwrap();
        let si = c_i * h * f64::sqrt(rho) / (f64::sqrt(2000.0) * f64::sqrt(t * 1e3 / d) * f64::sqrt(e / 1e6));
        close(impulsive_period(d, h, rho, t, e).unwrap(), si, 1e-15);
        let (ft, inch, lb, psi) = (0.3048, 0.0254, 0.453_592_37, 6_894.757_293_168);
        let us = c_i * (h / ft) * (rho / lb * ft * ft * ft).sqrt()
            / (27.8 * (t / inch / (d / ft)).sqrt() * (e / psi).sqrt());
        // 27.8 has three digits: exact 27.80 ± 0.2 %.
        close(us / si, 1.0, 2e-3);
    }

    /// A published 13th-edition calculation: H = 3.3 m, D = 5 m, t_u = 10 mm, ρ = 1830, E = 199 GPa, C_i = 6.14 read from
    /// the figure, T_i = 0.031 s (printed to 0.0005).
    #[test]
    fn published_impulsive_period() {
        close(impulsive_period(5.0, 3.3, 1830.0, 0.010, 199e9).unwrap(), 0.031, 5e-4);
        close(impulsive_coefficient(3.3 / 5.0).unwrap(), 6.14, 0.05);
    }

    /// A published calculation sheet (scribd.com/document/374148451): D = 62 ft, H = 47.1667 ft, K_s = 0.580143178, T_c = 4.568051951 s
    /// in the form with feet, of which the metric form has 1.8/1.8113 (√0.3048).
    #[test]
    fn published_sloshing_period() {
        let d_over_h = 62.0 / 47.166_666_67;
        close(sloshing_coefficient(d_over_h), 0.580_143_178, 5e-9);
        let feet = sloshing_period(62.0 * 0.3048, d_over_h) / (1.8 * f64::sqrt(0.3048));
        close(feet, 4.568_051_951, 5e-8);
    }

    /// Against potential flow of a rigid tank. The tolerances are how far the standard's closed forms (Housner's
    /// approximations) stray from it, rounded up; they catch a swapped branch or arm (a factor of 1.2 to 6), no more.
    #[test]
    fn masses_agree_with_potential_flow() {
        use crate::mechanical::{Plan, convective, impulsive};
        for d_over_h in [0.8, 1.0, 1.3, 1.5, 2.0, 3.0, 4.0, 6.0] {
            let (m, gamma) = (effective_masses(d_over_h), 2.0 / d_over_h);
            let (i, c) = (impulsive(Plan::Circle, gamma), convective(Plan::Circle, gamma, 1));
            for (name, value, exact, tolerance) in [
                ("W_i", m.w_i, i.mass, 0.05),
                ("W_c", m.w_c, c.mass, 0.013),
                ("X_c", m.x_c, c.lever, 0.002),
                ("X_cs", m.x_cs, c.lever_with_base, 0.05),
                ("X_i", m.x_i, i.lever, 0.09),
                ("X_is", m.x_is, i.lever_with_base, 0.15),
            ] {
                assert!((value / exact - 1.0).abs() < tolerance, "{name} at D/H {d_over_h}: {value} {exact}");
            }
        }
    }

    #[test]
    fn branches_meet_at_the_threshold() {
        let (below, above) = (effective_masses(SQUAT * (1.0 - 1e-12)), effective_masses(SQUAT));
        for (b, a) in [(below.w_i, above.w_i), (below.x_i, above.x_i), (below.x_is, above.x_is)] {
            assert!((b / a - 1.0).abs() < 1e-3, "{b} {a}");
        }
        close(above.w_i + above.w_c, 1.013, 1e-3);
    }

    #[test]
    fn impulsive_coefficient_ends_with_its_figure() {
        assert_eq!(impulsive_coefficient(0.149), None);
        assert_eq!(impulsive_coefficient(1.501), None);
        assert_eq!(impulsive_coefficient(0.15), Some(9.28));
        assert_eq!(impulsive_coefficient(1.5), Some(7.03));
    }

    proptest! {
        #[test]
        fn masses_are_parts_and_heights_are_ordered(d_over_h in 0.2..20.0f64) {
            let m = effective_masses(d_over_h);
            prop_assert!(m.w_i > 0.0 && m.w_i < 1.0 && m.w_c > 0.0 && m.w_c < 1.0);
            prop_assert!((m.w_i + m.w_c - 1.0).abs() < 0.16);
            prop_assert!(m.x_is > m.x_i && m.x_cs > m.x_c);
            let more = effective_masses(d_over_h * 1.02);
            prop_assert!(more.w_i < m.w_i && more.w_c > m.w_c);
        }
    }
}
