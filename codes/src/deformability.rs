//! Deformability parameter of the dissertation, eq. (3.1), and its correction. Information only: the verification
//! does not depend on it.
//!
//! The dissertation prints, after Bettin, Urrutia-Galicia and Gebbeken (2000), with tank height H, wall thickness h and
//! radius R, "with rising K the probability of failure rises":
//!
//! ```text
//! K = √(H/R) · √(h/R)                                                                                  (3.1)
//! ```
//!
//! As printed a thicker wall raises K and with it the probability of failure, which cannot be. The dissertation does not
//! derive K and does not evaluate it, so the definition in the report of 2000 is unknown; the derivation below is ours.
//! With thickness s and liquid depth H, a liquid pressure `p = ρ a H` (a: g for the static state, the response
//! acceleration for the dynamic one) widens the wall by
//!
//! ```text
//! w/R = p R/(E s) = (ρ a R/E) · (H/R)(R/s) = (ρ a R/E) · K′²         K′ = √(H/R) · √(R/s) = √(H/s)
//! ```
//!
//! and the period of the first impulsive mode (EN 1998-4 A.3.2.2, `T = C(H/R) √ρ H/(√(s/R) √E)`) is
//!
//! ```text
//! T √(E/ρ)/R = C √(H/R) · K′                      C √(H/R) = 5.5, 6.4, 7.4, 8.8, 12.2 at H/R = 0.5, 1, 1.5, 2, 3
//! ```
//!
//! Deflection and period grow with K′: the second root of (3.1) is most likely upside down. A deformable wall is not yet a
//! failing one: its accelerations also depend on where T lies in the spectrum, and buckling on the axial force.

use crate::sheet::{number, with_unit};
use tank::Shape;
use tank::case::Case;
use tank::units::Dimension::Length;

/// Deformability parameter, as printed and as it should be.
#[derive(Clone, Debug, PartialEq)]
pub struct Deformability {
    /// `√(H_T/R) √(s/R)` with the tank's height, as printed.
    pub as_printed: f64,
    /// `√(H/R) √(R/s)` with the liquid's depth.
    pub corrected: f64,
    /// Remark for the report.
    pub note: String,
}

/// K as printed in the dissertation's eq. (3.1).
///
/// * `height`: height of the tank [m]; `radius`: R [m]; `thickness`: s [m]
pub fn as_printed(height: f64, radius: f64, thickness: f64) -> f64 {
    (height / radius).sqrt() * (thickness / radius).sqrt()
}

/// K′, which grows with the deflection and the period of the filled wall.
///
/// * `depth`: liquid depth H [m]; `radius`: R [m]; `thickness`: s [m]
pub fn corrected(depth: f64, radius: f64, thickness: f64) -> f64 {
    (depth / radius).sqrt() * (radius / thickness).sqrt()
}

/// The parameter of a cylinder with the thickness of its lowest course; none for rectangles, for which it is not defined.
pub fn of(case: &Case) -> Option<Deformability> {
    let Shape::Cylinder { radius } = case.tank.shape else { return None };
    let thickness = case.tank.course_at(0.0).thickness;
    let depth = case.liquid.fill_height;
    let printed = as_printed(case.tank.wall_height(), radius, thickness);
    let corrected = corrected(depth, radius, thickness);
    Some(Deformability {
        as_printed: printed,
        corrected,
        note: format!(
            "Eq. (3.1) of Brüggemann 2002 as printed, √(H_T/R)·√(s/R) = {}, means that failure grows more probable with a thicker wall, which \
             cannot be. Deflection and period of the filled wall grow with √(H/R)·√(R/s) = {} instead (our derivation: the \
             hoop strain is (ρ·a·R/E)·H/s); (3.1) is given without one. With s = {} of the lowest course; \
             information only, no check rests on it.",
            number(printed),
            number(corrected),
            with_unit(thickness, Length)
        ),
    })
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::housner::statics::{Base, Ring, Wall};
    use proptest::prelude::*;

    /// Tank 8.1: H_T = 1.83 m, H = 1.525 m, R = 1.83 m, s = 2.03 mm, by hand.
    #[test]
    fn broad_tank() {
        assert!((as_printed(1.83, 1.83, 2.03e-3) - 0.03331).abs() < 0.5e-5);
        assert!((corrected(1.525, 1.83, 2.03e-3) - 27.409).abs() < 0.5e-3);
    }

    /// Coefficients of the period in the module's table: C of EN 1998-4 table A.2 times √(H/R).
    #[test]
    fn period_coefficients() {
        for (ratio, c, product) in
            [(0.5, 7.74, 5.5), (1.0, 6.36, 6.4), (1.5, 6.06, 7.4), (2.0, 6.21, 8.8), (3.0, 7.03, 12.2_f64)]
        {
            let ratio: f64 = ratio;
            assert!((c * ratio.sqrt() - product).abs() < 0.051);
        }
    }

    proptest! {
        /// The solved wall (bending included) follows K′² and not K²: a thicker wall deflects less. A hinged base keeps the
        /// bending zone short: the largest deflection stays within −20 … +7 % of the membrane value at the base,
        /// w/R = (γ R/E) K′² (it lies a little higher, where the pressure is less; e^−π = 4 % is the edge's overshoot).
        #[test]
        fn deflection_follows_the_derived_parameter(
            radius in 1.0..30.0f64, ratio in 0.5..3.0f64, slenderness in 300.0..2000.0f64, thicker in 1.1..3.0f64,
        ) {
            let (gamma, modulus, depth) = (9810.0, 210e9, ratio * radius);
            let largest = |s: f64| {
                let ring = Ring { height: depth, thickness: s, youngs_modulus: modulus, poisson_ratio: 0.3 };
                let wall = Wall::solve(radius, &[ring], gamma, depth, Base::Hinged).unwrap();
                (0..=2000).map(|i| wall.at(depth * f64::from(i) / 2000.0).displacement).fold(0.0, f64::max) / radius
            };
            let thin = radius / slenderness;
            let thick = thicker * thin;
            prop_assert!(largest(thin) > largest(thick));
            prop_assert!(corrected(depth, radius, thin) > corrected(depth, radius, thick));
            prop_assert!(as_printed(depth, radius, thin) < as_printed(depth, radius, thick));
            let membrane = gamma * radius / modulus * corrected(depth, radius, thin).powi(2);
            let share = largest(thin) / membrane;
            prop_assert!(share > 0.8 && share < 1.07, "{share}");
        }
    }
}
