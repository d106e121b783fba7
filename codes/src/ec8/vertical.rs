//! Vertical ground motion of upright cylinders, EN 1998-4:2006 A.2.2 (rigid) and A.3.3 (breathing wall).
//!
//! ```text
//! p_vr = ρ H (1−ζ) A_v(t)                                    A_v from a_vg
//! p_vf = 0.815 f(γ) ρ H cos(πζ/2) A_vf(t)                    A_vf = S_ve(T_vd)
//! f(γ) = 1.0 (γ < 0.8)     1.078 + 0.274 ln γ (0.8 ≤ γ < 4)
//! f_vd = 1/(4R) √(2 E I₁(γ₁) s/(π ρ H (1−ν²) I₀(γ₁)))        γ₁ = π/(2γ)
//! ```
//!
//! Both pressures are axisymmetric: no shear, no moment, but hoop force and buckling. They are combined by SRSS. At γ = 0.8 f
//! jumps from 1.0 to 1.017, as the code has it. The expression of f is recalled.

use std::f64::consts::PI;

/// Damping ratio of the breathing mode: 3 % (stiff soil) to 6 % (soft soil) are in use (Scharf 1990); the lower is safe.
pub const BREATHING_DAMPING: f64 = 0.03;

/// Formula of `f(γ)`; none for γ ≥ 4, which the annex does not cover.
pub(super) fn breathing_factor(slenderness: f64) -> Option<&'static str> {
    if slenderness < 0.8 {
        Some("1")
    } else if slenderness < 4.0 {
        Some("1.078 + 0.274·ln(γ)")
    } else {
        None
    }
}

/// Formula of the frequency `f_vd` of the breathing mode [Hz] for its argument γ1; E, s, ν at z = H/3.
///
/// Derived: uniform membrane shell with rollers at the base; the liquid moves as `cos(πζ/2) I₀(πr/(2H))`.
pub(super) fn frequency(gamma_1: f64) -> &'static str {
    if gamma_1 < LARGE {
        "1/(4·R)·√(2·E·I₁(γ1)·s/(π·ρ·H·(1 - ν²)·I₀(γ1)))"
    } else {
        // I₁/I₀ where both overflow; the next term of the series is 1e-12 of it.
        "1/(4·R)·√(2·E·s·(1 - 1/(2·γ1) - 1/(8·γ1²) - 1/(8·γ1³))/(π·ρ·H·(1 - ν²)))"
    }
}

/// Argument from which the quotient of the Bessel functions is its asymptotic series.
const LARGE: f64 = 650.0;

/// `p_vr/(ρ H A_v) = 1 − ζ`.
pub fn rigid_pressure(zeta: f64) -> f64 {
    (1.0 - zeta).max(0.0)
}

/// `p_vf/(ρ H A_vf) = 0.815 f(γ) cos(πζ/2)`.
pub fn breathing_pressure(factor: f64, zeta: f64) -> f64 {
    if zeta >= 1.0 { 0.0 } else { 0.815 * factor * (0.5 * PI * zeta).cos() }
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;
    use tank::formula::evaluate;

    fn breathing_frequency(r: f64, h: f64, rho: f64, e: f64, nu: f64, s: f64) -> f64 {
        let gamma_1 = PI * r / (2.0 * h);
        let terms = [("R", r), ("H", h), ("ρ", rho), ("E", e), ("ν", nu), ("s", s), ("γ1", gamma_1)];
        evaluate(frequency(gamma_1), &terms)
    }

    fn factor(gamma: f64) -> Option<f64> {
        Some(evaluate(breathing_factor(gamma)?, &[("γ", gamma)]))
    }

    /// The two forms of the frequency meet where the Bessel functions near their overflow.
    #[test]
    fn shallow_liquid() {
        let at = |gamma_1: f64| breathing_frequency(1.0, PI / (2.0 * gamma_1), 1000.0, 210e9, 0.3, 0.01);
        let (below, above) = (at(LARGE * (1.0 - 1e-9)), at(LARGE * (1.0 + 1e-9)));
        assert!((below / above - 1.0).abs() < 2e-9, "{below} {above}");
        assert!(at(1e5).is_finite());
    }

    /// Worked example: R = 15 m, H = 12 m, ρ = 900, E = 210 GPa, s = 12 mm at H/3: 5.600 Hz, f = 1.0169.
    #[test]
    fn worked_example() {
        let f = breathing_frequency(15.0, 12.0, 900.0, 210e9, 0.3, 0.012);
        assert!((f - 5.600).abs() < 5e-4, "{f}");
        assert!((factor(0.8).unwrap() - 1.0169).abs() < 5e-5);
        assert_eq!(factor(0.7999), Some(1.0));
        assert_eq!(factor(4.0), None);
    }

    /// Printed values of the formula [rad/s], half the last digit; coupled finite elements give 175.8, 105.2, 45.9, 105.1.
    #[test]
    fn formula_values_beside_finite_elements() {
        for (r, h, rho, e, nu, s, omega) in [
            (1.83, 1.525, 1000.0, 69e9, 0.32, 0.00203, 180.4),
            (1.83, 5.0, 1000.0, 210e9, 0.3, 0.002, 109.4),
            (10.0, 10.0, 1000.0, 210e9, 0.3, 0.01, 47.1),
            (10.0, 3.0, 1000.0, 210e9, 0.3, 0.01, 104.2),
        ] {
            let found = 2.0 * PI * breathing_frequency(r, h, rho, e, nu, s);
            assert!((found - omega).abs() <= 0.05 + 1e-9, "{found} {omega}");
        }
    }

    /// γ → ∞: I₁/I₀ → γ₁/2 and f_vd → c/(4H), the quarter wave of a pipe closed below and open above, with Korteweg's
    /// c = √(E s/(2ρR(1−ν²))).
    #[test]
    fn slender_limit_is_the_wave_in_a_pipe() {
        let (r, h, rho, e, nu, s): (f64, f64, f64, f64, f64, f64) = (1.0, 200.0, 1000.0, 210e9, 0.3, 0.01);
        let c = (e * s / (2.0 * rho * r * (1.0 - nu * nu))).sqrt();
        let found = breathing_frequency(r, h, rho, e, nu, s);
        assert!((found / (c / (4.0 * h)) - 1.0).abs() < 1e-4);
    }

    proptest! {
        /// Scales with √E/size, falls with depth.
        #[test]
        fn scaling(r in 1.0f64..50.0, gamma in 0.2f64..3.9, k in 0.1f64..10.0) {
            let f = |r: f64, gamma: f64, e: f64| breathing_frequency(r, gamma * r, 1000.0, e, 0.3, 1e-3 * r);
            prop_assert!((f(k * r, gamma, 210e9) * k / f(r, gamma, 210e9) - 1.0).abs() < 1e-12);
            prop_assert!((f(r, gamma, 210e9 * k) / f(r, gamma, 210e9) / k.sqrt() - 1.0).abs() < 1e-12);
            prop_assert!(f(r, gamma * 1.05, 210e9) < f(r, gamma, 210e9));
        }
    }
}
