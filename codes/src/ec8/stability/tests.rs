//! Source:    equilibrium by hand, in each test
//! Goal:      overturning of a box and its anchors
//! Tolerance: 1e-9, closed forms

use super::*;
use crate::ec8::En2006;
use crate::ec8::example::{check, line, site};
use crate::procedure::Procedure;
use crate::samples::{concrete_rectangle, material};
use tank::assessment::Excitation;
use tank::case::{Case, Ec8Site};
use tank::{Anchors, Bottom};

fn near(found: f64, expected: f64) {
    assert!((found / expected - 1.0).abs() < 1e-9, "{found} instead of {expected}");
}

/// 2L = 5 m, b = 4 m, 2.5 m of water, walls 0.3 m × 3 m: 50 t and 2·(5 + 4)·0.9·2.5 = 40.5 t.
fn tank(vertical: bool, bottom: Option<f64>, support: Support) -> Case {
    let mut case = concrete_rectangle(4.0, false, Ec8Site { vertical, ..site() });
    case.tank.support = support;
    case.tank.bottom = bottom.map(|modulus| Bottom {
        corrosion: 0.0,
        subgrade_modulus: None,
        thickness: 0.4,
        sketch: None,
        projection: 0.0,
        width: None,
        material: material("bottom", modulus, 0.2, 2500.0),
    });
    case
}

#[test]
fn weight_with_and_without_the_liquid() {
    for (bottom, mass, symbol) in [(Some(30e9), 90_500.0, "M′"), (Some(210e9), 40_500.0, "M"), (None, 40_500.0, "M")]
    {
        let a = En2006.assess(&tank(false, bottom, Support::Unanchored), Excitation::Site).unwrap();
        let found = check(&a, "overturning");
        near(found.capacity.unwrap(), mass * 9.81 * 2.5);
        assert_eq!(found.demand, Some(line(&a, symbol)));
    }
    // a_vg = 0.9·1.2·0.25 g = 0.27 g: g − 0.081 g.
    let a = En2006.assess(&tank(true, Some(30e9), Support::Unanchored), Excitation::Site).unwrap();
    near(check(&a, "overturning").capacity.unwrap(), 90_500.0 * 9.81 * 0.919 * 2.5);
}

/// 18 anchors around 18 m of wall, 4 of them in a wall 4 m wide.
#[test]
fn anchors_take_the_rest() {
    let mut case = tank(false, None, Support::Anchored);
    let a = En2006.assess(&case, Excitation::Site).unwrap();
    let rest = line(&a, "M") - 40_500.0 * 9.81 * 2.5;
    let gap = check(&a, "anchorage");
    if rest <= 0.0 {
        assert_eq!(gap.status, CheckStatus::NotApplicable);
    } else {
        assert_eq!(gap.input.as_deref(), Some("tank.anchors"));
    }
    case.site.ec8 = Some(Ec8Site { ag: 1.5 * 9.81, vertical: false, ..site() });
    case.tank.anchors =
        Some(Anchors { count: 18, capacity: Some(300e3), attachment_capacity: None, ..Anchors::default() });
    let a = En2006.assess(&case, Excitation::Site).unwrap();
    let rest = line(&a, "M") - 40_500.0 * 9.81 * 2.5;
    assert!(rest > 0.0);
    near(check(&a, "anchorage").demand.unwrap(), rest / 5.0 / 4.0);
}
