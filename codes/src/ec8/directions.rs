//! Two horizontal components of the seismic action on an axisymmetric tank.
//!
//! The effects of E_x vary as cos θ around the tank, those of an equal E_y as sin θ:
//!
//! ```text
//! SRSS             √(E² cos² θ + E² sin² θ) = E                          at every θ: as one component
//! E_x + 0.3 E_y    E (cos θ + 0.3 sin θ) ≤ √(1 + 0.3²) E = 1.044 E        at tan θ = 0.3
//! 0.3 E_x + 0.3 E_y beside E_z             ≤ 0.3 √2 E   = 0.424 E        at θ = 45°
//! ```
//!
//! EN 1998-1 4.3.3.5.1 offers both rules; EN 1998-4 lets axisymmetric structures have one component (3.2 for silos; recalled), which is
//! the default here. With both, A_i and the sloshing accelerations are those of the worst angle (c_h), and beside E_z the share of them
//! is c_v = 0.3 √2/c_h.

use crate::sheet::Sheet;
use tank::case::Components;
use tank::units::Dimension::{Acceleration, Dimensionless};

const CLAUSE: &str = "EN 1998-1:2004 4.3.3.5";
const BOTH: &str = "√(1 + 0.3²)";

/// c_h: horizontal accelerations over those of one component.
pub(super) fn factor(components: Components) -> f64 {
    match components {
        Components::One => 1.0,
        Components::HundredThirty => (1.0_f64 + 0.3 * 0.3).sqrt(),
    }
}

/// c_v: share of the horizontal accelerations beside the full vertical one.
pub(super) fn beside_vertical(components: Components) -> f64 {
    match components {
        Components::One => 0.3,
        Components::HundredThirty => 0.3 * 2.0_f64.sqrt() / factor(components),
    }
}

/// Lines of c_h and c_v; none for one component.
pub(super) fn describe(sheet: &mut Sheet, components: Components, vertical: bool) {
    if components == Components::One {
        return;
    }
    let name = "two horizontal components E_x + 0.3·E_y at the worst angle";
    sheet.calc("c_h", name, BOTH, Dimensionless, CLAUSE);
    if vertical {
        let name = "share of both beside E_z, 0.3·E_x + 0.3·E_y at the worst angle";
        sheet.calc("c_v", name, "0.3·√(2)/c_h", Dimensionless, CLAUSE);
    }
}

/// The acceleration [m/s²] of both components, with its line; the given one for one component.
///
/// * `part`: of the response ("impulsive")
pub(super) fn line(sheet: &mut Sheet, components: Components, part: &str, acceleration: f64) -> f64 {
    if components == Components::One {
        return acceleration;
    }
    sheet.given(&[("A_x", acceleration, Acceleration)]);
    let name = format!("{part} acceleration of two horizontal components");
    sheet.calc("A_xy", &name, "c_h·A_x", Acceleration, CLAUSE)
}

/// What is assumed about the directions.
pub(super) fn assumption(components: Components) -> &'static str {
    match components {
        Components::One => {
            "One horizontal component, which EN 1998-4 allows for axisymmetric tanks; two equal ones by SRSS give the same at \
             every angle."
        }
        Components::HundredThirty => {
            "Two equal horizontal components, E_x + 0.3 E_y at the worst angle, 0.3 E_x + 0.3 E_y beside E_z (EN 1998-1 4.3.3.5)."
        }
    }
}

#[cfg(test)]
mod tests {
    use super::super::example::{line, oil_tank};
    use super::super::*;
    use super::*;
    use tank::case::Ec8Site;

    /// Largest of `a cos θ + b sin θ` over 36 000 angles; the maximum is flat, so 1e-4 rad beside it is 5e-9 below it.
    fn largest(a: f64, b: f64) -> f64 {
        let angles = (0..36_000).map(|i| f64::from(i) * std::f64::consts::PI / 18_000.0);
        angles.map(|t| a * t.cos() + b * t.sin()).fold(0.0, f64::max)
    }

    #[test]
    fn factors_are_the_worst_angle() {
        let both = Components::HundredThirty;
        assert!((factor(both) - largest(1.0, 0.3)).abs() < 1e-8);
        assert!((factor(both) * beside_vertical(both) - largest(0.3, 0.3)).abs() < 1e-8);
        let one = Components::One;
        assert!((factor(one) - largest(1.0, 0.0)).abs() < 1e-8 && beside_vertical(one) == 0.3);
    }

    /// Every horizontal demand and the wave grow by √1.09.
    #[test]
    fn the_oil_tank_under_two_components() {
        let assess = |components| {
            let mut case = oil_tank();
            case.site.ec8 = case.site.ec8.map(|site| Ec8Site { components, ..site });
            En2006.assess(&case, Excitation::Site).unwrap()
        };
        let (one, both) = (assess(Components::One), assess(Components::HundredThirty));
        for symbol in ["Q", "M", "M′", "d_max"] {
            let ratio = line(&both, symbol) / line(&one, symbol);
            assert!((ratio - 1.09_f64.sqrt()).abs() < 1e-12, "{symbol}: {ratio}");
        }
        assert!(both.assumptions.iter().any(|a| a.contains("E_x + 0.3 E_y")));
    }

    /// Pressure at the base: the larger one of c_h p_x + 0.3 p_z and 0.3 √2 p_x + p_z.
    #[test]
    fn the_vertical_component_joins() {
        let assess = |components, vertical| {
            let mut case = oil_tank();
            case.site.ec8 = case.site.ec8.map(|site| Ec8Site { components, vertical, ..site });
            En2006.assess(&case, Excitation::Site).unwrap()
        };
        let at_base = |out: &Assessment| {
            let profile = out.profiles.iter().find(|p| p.id == "pressure_dynamic");
            profile.expect("a profile").values[0]
        };
        let (x, both) = (at_base(&assess(Components::One, false)), assess(Components::HundredThirty, true));
        let z = line(&both, "p_v");
        let expected = (largest(1.0, 0.3) * x + 0.3 * z).max(largest(0.3, 0.3) * x + z);
        let found = at_base(&both);
        assert!((found / expected - 1.0).abs() < 1e-7, "{found} {expected}");
    }
}
