//! Bearing of circles and rectangles.
//!
//! Source:    kern of the circle R/4 and of the rectangle B/6; half circle in contact; numerical integration of the pressure
//! Goal:      pressure on either side of the kern, the governing combination, the limit from both sides, the missing resistance
//! Tolerance: 1e-6 for closed forms, 1e-4 for the integration with 400 strips

use std::f64::consts::PI;

use super::super::En2006;
use super::super::example::{check, line, site};
use super::{circle, segment};
use crate::Procedure;
use crate::samples::{close, concrete_rectangle};
use tank::Support;
use tank::assessment::{CheckStatus, Excitation};
use tank::case::{Case, Ec8Site};

fn with(mut case: Case, resistance: f64, ag: f64, vertical: bool) -> Case {
    case.site.ec8 = Some(Ec8Site { bearing_capacity: Some(resistance), ag: ag * 9.81, vertical, ..site() });
    case
}

/// Whole circle: e = R/4 and σ R²/N = 2/π. Half circle: N = ⅔ σ R², M = π/8 σ R³, e = 3π/16 R. Small segment: the triangle's tip carries all,
/// e → R.
#[test]
fn segments_in_closed_form() {
    close(circle(0.25), 2.0 / PI, 1e-6);
    let (e, n) = segment(0.5 * PI);
    close(e, 3.0 * PI / 16.0, 1e-12);
    close(n, 2.0 / 3.0, 1e-12);
    close(circle(3.0 * PI / 16.0), 1.5, 1e-9);
    assert!(circle(0.99) > 100.0 && circle(1.0).is_infinite());
}

/// Pressure integrated over strips of the circle gives back force and moment.
#[test]
fn pressure_carries_force_and_moment() {
    for e in [0.3, 0.45, 0.7, 0.85] {
        let sigma = circle(e);
        // Neutral axis by its own bisection on the moment of the strips.
        let sums = |edge: f64| {
            let n = 4000;
            let h = (1.0 - edge) / f64::from(n);
            (0..n).fold((0.0, 0.0), |(force, moment), i| {
                let y = edge + (f64::from(i) + 0.5) * h;
                let d = sigma * (y - edge) / (1.0 - edge) * 2.0 * (1.0 - y * y).sqrt() * h;
                (force + d, moment + d * y)
            })
        };
        let (mut low, mut high) = (-1.0, 1.0);
        for _ in 0..60 {
            let edge = 0.5 * (low + high);
            if sums(edge).0 > 1.0 { low = edge } else { high = edge }
        }
        let (force, moment) = sums(0.5 * (low + high));
        close(force, 1.0, 1e-4);
        close(moment / e, 1.0, 1e-3);
    }
}

/// The oil tank: N = 7 775 607.7 kg·9.81, M′ of the sheet; 0.25 g gives e beyond R/4, 0.1 g within.
#[test]
fn oil_tank() {
    for (ag, within) in [(0.25, false), (0.1, true)] {
        let case = with(super::super::example::oil_tank(), 1e9, ag, false);
        let a = En2006.assess(&case, Excitation::Site).unwrap();
        let normal = 7_775_607.7 * 9.81;
        let e = line(&a, "M′") / normal / 15.0;
        assert_eq!(e <= 0.25, within, "{e}");
        let mean = normal / (PI * 225.0);
        let expected = if within { mean * (1.0 + 4.0 * e) } else { mean * PI * circle(e) };
        let demand = check(&a, "bearing").demand.unwrap();
        close(demand / expected, 1.0, 1e-6);
        for (resistance, holds) in [(demand * 0.999, false), (demand * 1.001, true)] {
            let case = with(super::super::example::oil_tank(), resistance, ag, false);
            let a = En2006.assess(&case, Excitation::Site).unwrap();
            assert_eq!(check(&a, "bearing").holds(), holds);
        }
    }
}

/// Vertical motion: every combination is at most the governing one.
#[test]
fn vertical_motion_never_relieves() {
    let demand = |vertical| {
        let case = with(super::super::example::oil_tank(), 1e9, 0.1, vertical);
        check(&En2006.assess(&case, Excitation::Site).unwrap(), "bearing").demand.unwrap()
    };
    assert!(demand(true) > demand(false));
}

/// Strip 5 m long: N = 17 000 kg·9.81 = 166.77 kN per metre, W = 25/6 m²; beyond the kern the triangle 3 (B/2 − e).
#[test]
fn strip() {
    for ag in [0.02, 0.25] {
        let case = with(concrete_rectangle(1.0, true, site()), 1e9, ag, false);
        let a = En2006.assess(&case, Excitation::Site).unwrap();
        let (normal, moment) = (166_770.0, line(&a, "M′"));
        let e = moment / normal;
        let expected =
            if e <= 5.0 / 6.0 { normal / 5.0 + moment / (25.0 / 6.0) } else { 2.0 * normal / (3.0 * (2.5 - e)) };
        let bearing = check(&a, "bearing");
        close(bearing.demand.unwrap() / expected, 1.0, 1e-6);
    }
    // The resultant leaves the base: a tank that stands fails, one that is held to a foundation is not decided.
    let mut case = with(concrete_rectangle(1.0, true, site()), 1e9, 3.0, false);
    for (support, status) in [(Support::Unanchored, CheckStatus::Fails), (Support::Anchored, CheckStatus::NotChecked)] {
        case.tank.support = support;
        let out = En2006.assess(&case, Excitation::Site).unwrap();
        assert_eq!(check(&out, "bearing").status, status, "{support:?}");
    }
}

#[test]
fn resistance_is_asked_for() {
    let a = En2006.assess(&oil_tank_without(), Excitation::Site).unwrap();
    let gap = check(&a, "bearing");
    assert_eq!((gap.status, gap.input.as_deref()), (CheckStatus::NotChecked, Some("site.ec8.bearing_capacity")));
}

fn oil_tank_without() -> Case {
    super::super::example::oil_tank()
}
