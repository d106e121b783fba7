//! Sliding of cylinders and rectangles, anchored and unanchored.
//!
//! Source:    worked example of `example`: Q from its printed parts, masses as printed
//! Goal:      resistance with and without vertical motion, the limit from both sides and at equality, the missing friction
//! Tolerance: 3e-4, the printed numbers have five digits; ratios of the sheet's own numbers 1e-12

use super::super::example::{check, line, oil_tank, site};
use super::super::{En2006, Env1998};
use crate::Procedure;
use crate::samples::concrete_rectangle;
use tank::Support;
use tank::assessment::{CheckStatus, Excitation};
use tank::case::{Case, Ec8Site};

const EPSILON: f64 = 3e-4;
/// m + m_w + m_r of the oil tank [kg].
const MASS: f64 = 7_634_070.0 + 106_537.7 + 35_000.0;

fn with(mut case: Case, friction: f64, vertical: bool) -> Case {
    case.site.ec8 = Some(Ec8Site { friction: Some(friction), vertical, ..case.site.ec8.unwrap() });
    case
}

/// Q = Q_i + Q_c = 35 677.4 kN + 1 523.8 kN·0.9869604·(1 − 0.023373·2.370999/3.370999) (annex A of EN 1998-1 beyond 4 s)
///   = 35 677.4 + 1 479.2 = 37 156.6 kN
/// N_Ed = 7 775 607.7 kg·9.81 m/s² = 76 278.7 kN, so that μ = 0.48712 is needed.
#[test]
fn oil_tank_slides_below_a_friction_of_0_487() {
    let (shear, normal) = (37_156.6e3, 76_278.7e3);
    for support in [Support::Anchored, Support::Unanchored] {
        for (u, holds) in [(0.5, true), (1.0 - EPSILON, true), (1.0 + EPSILON, false), (2.0, false)] {
            let mut case = with(oil_tank(), shear / normal / u, false);
            case.tank.support = support;
            let a = En2006.assess(&case, Excitation::Site).unwrap();
            let sliding = check(&a, "sliding");
            assert_eq!(sliding.holds(), holds, "{u}: {sliding:?}");
            assert!((sliding.utilisation.unwrap() / u - 1.0).abs() < 0.8 * EPSILON, "{sliding:?}");
        }
    }
}

/// The friction that carries exactly Q holds, the next smaller number does not.
#[test]
fn equality_holds() {
    let at = |friction: f64| {
        let a = En2006.assess(&with(oil_tank(), friction, false), Excitation::Site).unwrap();
        check(&a, "sliding").clone()
    };
    let any = at(0.4);
    let normal = any.capacity.unwrap() / 0.4;
    let needed = any.demand.unwrap() / normal;
    let mut friction = needed * (1.0 - 4.0 * f64::EPSILON);
    while !at(friction).holds() {
        friction = friction.next_up();
    }
    assert!((friction / needed - 1.0).abs() <= 4.0 * f64::EPSILON, "{friction} {needed}");
    let (limit, below) = (at(friction), at(friction * (1.0 - 4.0 * f64::EPSILON)));
    assert!(limit.utilisation.unwrap() <= 1.0 && below.utilisation.unwrap() > 1.0);
}

/// a_vg = 0.9·2.943 = 2.6487 m/s²: N_Ed = 7 775 607.7·(9.81 − 0.3·2.6487) = 70 100.1 kN. With a_gR = 0.8 g,
/// a_vg = 0.9·1.2·0.8 g = 0.864 g and 0.3 E_x + E_z governs: 7 775 607.7·0.136 g/0.3 = 34 579.7 kN. Beyond 1 g the tank floats.
#[test]
fn vertical_motion_lightens_the_tank() {
    for (ag, normal) in
        [(0.25, Some(MASS * (9.81 - 0.3 * 2.6487))), (0.8, Some(MASS * 0.136 * 9.81 / 0.3)), (1.0, None)]
    {
        let mut case = with(oil_tank(), 0.4, true);
        case.site.ec8.as_mut().unwrap().ag = ag * 9.81;
        let a = En2006.assess(&case, Excitation::Site).unwrap();
        let sliding = check(&a, "sliding");
        match normal {
            Some(normal) => {
                let found = sliding.capacity.unwrap();
                assert!((found / (0.4 * normal) - 1.0).abs() < 1e-5, "{ag}: {found} {normal}");
                assert!((line(&a, "N_Ed") * 0.4 / found - 1.0).abs() < 1e-12);
            }
            None => assert!(sliding.utilisation.is_none() && !sliding.holds(), "{sliding:?}"),
        }
    }
}

/// Strip, 5 m × 2.5 m of water, two walls 0.3 m × 3 m of 2500 kg/m³: N_Ed = (12 500 + 4 500) kg·9.81 = 166.77 kN per metre.
#[test]
fn strip() {
    let case = with(concrete_rectangle(1.0, true, site()), 0.5, false);
    for procedure in [&En2006 as &dyn Procedure, &Env1998] {
        let a = procedure.assess(&case, Excitation::Site).unwrap();
        let sliding = check(&a, "sliding");
        assert!((sliding.capacity.unwrap() - 0.5 * 17_000.0 * 9.81).abs() < 1e-6, "{sliding:?}");
        assert_eq!(sliding.demand, Some(line(&a, "Q")));
    }
}

#[test]
fn friction_is_asked_for() {
    for case in [oil_tank(), concrete_rectangle(1.0, true, site())] {
        let a = En2006.assess(&case, Excitation::Site).unwrap();
        let gap = check(&a, "sliding");
        assert_eq!((gap.status, gap.input.as_deref()), (CheckStatus::NotChecked, Some("site.ec8.friction")));
        assert!(a.steps.iter().all(|s| s.symbol != "N_Ed"));
    }
}
