//! Damage limitation of the oil tank and of walls that are not metal shells.
//!
//! Source:    worked example of `example`: wave and pressures as in `boundaries`
//! Goal:      both parts on either side of their limit and at equality; q = 1; missing input
//! Tolerance: 3e-4, the printed numbers have five digits

use std::f64::consts::PI;

use super::super::En2006;
use super::super::example::{check, oil_tank, site};
use crate::Procedure;
use crate::samples::concrete_rectangle;
use tank::assessment::{Assessment, CheckStatus, Excitation};
use tank::case::{Case, Ec8Site};

const EPSILON: f64 = 3e-4;

fn with(mut case: Case, reduction: f64, q: f64) -> Case {
    case.site.ec8 = Some(Ec8Site { reduction_factor: Some(reduction), behaviour_factor: q, ..case.site.ec8.unwrap() });
    case
}

fn assess(case: &Case) -> Assessment {
    En2006.assess(case, Excitation::Site).unwrap()
}

/// Equality, and both sides of the limit: `case_at(capacity)` sets the capacity [SI].
fn limit(id: &str, demand: f64, case_at: impl Fn(f64) -> Case) {
    for (u, holds) in [(0.5, true), (1.0 - EPSILON, true), (1.0 + EPSILON, false), (2.0, false)] {
        let out = assess(&case_at(demand / u));
        let found = check(&out, id);
        assert_eq!(found.holds(), holds, "{u}: {found:?}");
        assert_eq!(found.limit_state, "damage_limitation");
        assert!((found.utilisation.unwrap() / u - 1.0).abs() < 0.8 * EPSILON, "{found:?}");
    }
}

/// 0.5·d, d = R S_e(T_con)/g as in the check of the ultimate limit state.
#[test]
fn freeboard() {
    let t_con = (1.60 - 0.08 / 3.0) * 15.0_f64.sqrt();
    let s_de = 0.101_533_5 * (3.370_999 + (t_con - 6.0) / 4.0 * (1.0 - 3.370_999));
    let d_max = 15.0 * s_de * (2.0 * PI / t_con).powi(2) / 9.81;
    limit("damage_freeboard", 0.5 * d_max, |freeboard| {
        let mut c = with(oil_tank(), 0.5, 1.0);
        // Five courses reach the surface at 12 m; the sixth is the freeboard.
        c.tank.courses[5].height = freeboard;
        c
    });
}

/// p_DL = 105.948 + ν (83.736 + 1.8144) kPa = 148.723 kPa for ν = 0.5 and 140.168 kPa for ν = 0.4 at the base; times R/s = 15 m/14 mm:
/// 159.35 and 150.18 MPa. q = 1.5 reduces the checks of the ultimate limit state and not these.
#[test]
fn hoop() {
    for (reduction, q, pressure) in [(0.5, 1.0, 148_723.0), (0.4, 1.0, 140_168.0), (0.5, 1.5, 148_723.0)] {
        let case_at = |f_y: f64| {
            let mut c = with(oil_tank(), reduction, q);
            // The other courses do not yield.
            for (k, course) in c.tank.courses.iter_mut().enumerate() {
                course.material.yield_strength = Some(if k == 0 { f_y } else { 1e12 });
            }
            c
        };
        limit("damage_hoop", pressure * 15.0 / 0.014, case_at);
        let demand = check(&assess(&case_at(1e9)), "damage_hoop").demand.unwrap();
        assert!(check(&assess(&case_at(demand)), "damage_hoop").holds());
        assert!(!check(&assess(&case_at(demand.next_down())), "damage_hoop").holds());
    }
}

/// A weak upper course governs; ν q > 1 is noted.
#[test]
fn governing_course_and_note() {
    let mut c = with(oil_tank(), 0.5, 1.0);
    c.tank.courses[2].thickness = 0.005;
    let out = assess(&c);
    assert!(check(&out, "damage_hoop").note.starts_with("course 3 at z = 4.8 m"));
    let noted = |reduction: f64, q: f64| {
        let notes = assess(&with(oil_tank(), reduction, q)).notes;
        notes.iter().any(|n| n.contains("exceeds 1"))
    };
    assert!(!noted(0.5, 1.5) && !noted(1.0, 1.0) && noted(0.7, 1.5));
}

#[test]
fn what_is_missing_is_said() {
    for case in [oil_tank(), concrete_rectangle(1.0, true, site())] {
        let out = assess(&case);
        let gap = check(&out, "damage_limitation");
        assert_eq!((gap.status, gap.input.as_deref()), (CheckStatus::NotChecked, Some("site.ec8.reduction_factor")));
    }
    // Concrete of unknown strength: the freeboard is compared, the crack width is not.
    let out = assess(&with(concrete_rectangle(1.0, true, site()), 0.5, 1.0));
    assert!(check(&out, "damage_freeboard").compared());
    let gap = check(&out, "damage_limitation");
    assert_eq!((gap.status, gap.input.as_deref()), (CheckStatus::NotChecked, Some("materials.concrete.grade")));
    // No yield strength.
    let mut c = with(oil_tank(), 0.5, 1.0);
    c.tank.courses[1].material.yield_strength = None;
    let out = assess(&c);
    assert!(check(&out, "damage_limitation").reason.contains("yield_strength"));
}
