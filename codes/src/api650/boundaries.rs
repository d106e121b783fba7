//! Every check of both editions on either side of its limit.
//!
//! Source:    worked example of `example`: printed demands and capacities (see `tests1993`, `edition2020::tests`)
//! Goal:      the check holds just below a utilisation of 1, fails just above it, and prints that utilisation
//! Model:     one input is set so that demand over capacity is 1 − ε and 1 + ε by the printed numbers
//! Tolerance: ε = 2e-4; the printed numbers have five or six digits

use std::f64::consts::PI;

use super::edition1993::Api6501993;
use super::edition2020::Api6502020;
use super::example::{case, line};
use crate::procedure::Procedure;
use tank::assessment::{Assessment, CheckStatus, Excitation};
use tank::case::Case;
use tank::{Anchors, Support};

const EPSILON: f64 = 2e-4;

fn site(c: &mut Case) -> &mut tank::case::Api650Site {
    c.site.api650.as_mut().unwrap()
}

fn find<'a>(out: &'a Assessment, id: &str) -> &'a tank::assessment::Check {
    out.checks.iter().find(|c| c.id == id).unwrap_or_else(|| panic!("no check {id}: {:?}", out.notes))
}

/// `case_at(u)` is the example with the check utilised to u by hand.
fn limit(procedure: &dyn Procedure, id: &str, case_at: impl Fn(f64) -> Case) {
    for (u, holds) in [(0.5, true), (1.0 - EPSILON, true), (1.0 + EPSILON, false), (1.04, false), (2.0, false)] {
        let out = procedure.assess(&case_at(u), Excitation::Site).unwrap();
        let check = find(&out, id);
        let what = format!("{} {id} at {u}: {check:?}", procedure.id());
        assert_eq!(check.holds(), holds, "{what}");
        assert!((check.utilisation.unwrap() / u - 1.0).abs() < 0.8 * EPSILON, "{what}");
    }
}

fn anchored(capacity: f64) -> Case {
    let mut c = case();
    c.tank.support = Support::Anchored;
    c.tank.anchors =
        Some(Anchors { count: 60, capacity: Some(capacity), attachment_capacity: None, ..Anchors::default() });
    c
}

/// δ_s = 1.11743 m, 0.7 of it for SUG II; SUG III all of 0.42·30 m·1.5·0.42667/6.0069.
#[test]
fn freeboard_of_2020() {
    for (sug, demand) in [(2, 0.7 * 1.11743), (3, 0.42 * 30.0 * 1.5 * 0.426_667 / 6.0069)] {
        limit(&Api6502020, "freeboard", |u| {
            let mut c = case();
            site(&mut c).sug = sug;
            // Five courses reach the surface at 12 m; the sixth is the freeboard.
            c.tank.courses[5].height = demand / u;
            c
        });
    }
}

/// Table E.7: SUG II needs freeboard from S_DS = 0.33 g on, SUG III always, SUG I never.
#[test]
fn freeboard_of_2020_is_required_from_0_33_g_on() {
    for (sug, s_ds, required) in
        [(1, 0.9, false), (2, 0.33 - 1e-9, false), (2, 0.33, true), (2, 0.33 + 1e-9, true), (3, 0.05, true)]
    {
        let mut c = case();
        let s = site(&mut c);
        (s.sug, s.q, s.fa, s.fv, s.ss) = (sug, 1.0, Some(1.0), Some(1.0), s_ds);
        let out = Api6502020.assess(&c, Excitation::Site).unwrap();
        let check = find(&out, "freeboard");
        assert_eq!(check.compared(), required, "SUG {sug}, S_DS = {s_ds}");
        assert_eq!(check.reason.contains("no freeboard is required"), !required);
    }
}

/// σ_T = 141.10 MPa at the bottom against 1.33 S_d e, and against 0.9 F_y e; the joint efficiency enters both.
#[test]
fn hoop_stress_of_2020() {
    let with = |s_d: f64, f_y: f64, e: f64| {
        let mut c = case();
        site(&mut c).joint_efficiency = e;
        for course in &mut c.tank.courses {
            course.material.allowable_stress = Some(s_d);
            course.material.yield_strength = Some(f_y);
        }
        c
    };
    limit(&Api6502020, "hoop_stress", |u| with(141.10e6 / 1.33 / u, 1e9, 1.0));
    limit(&Api6502020, "hoop_stress", |u| with(1e9, 141.10e6 / 0.9 / u, 1.0));
    limit(&Api6502020, "hoop_stress", |u| with(157e6, 1e9, 141.10 / (1.33 * 157.0) / u));
}

/// 40 steps over 12 m and the lower sides of the four joints below the surface; the fifth joint is at the surface.
#[test]
fn heights_of_the_profiles() {
    let c = case();
    let z = c.tank.profile_heights(12.0);
    let mut expected: Vec<f64> = (0..=40).map(|i| 0.3 * f64::from(i)).collect();
    expected.extend([2.4, 4.8, 7.2, 9.6].map(|joint| joint - 12e-6));
    expected.sort_by(f64::total_cmp);
    assert_eq!(z.len(), expected.len(), "{z:?}");
    assert!(z.iter().zip(&expected).all(|(z, e)| (z - e).abs() < 1e-9), "{z:?}");
}

/// Stress over allowable governs, not the largest stress: a second course with a fifth of the first one's strength.
#[test]
fn hoop_stress_of_2020_governs_where_the_steel_is_weak() {
    let mut c = case();
    let weak = &mut c.tank.courses[1].material;
    (weak.allowable_stress, weak.yield_strength) = (Some(31e6), Some(1e9));
    let out = Api6502020.assess(&c, Excitation::Site).unwrap();
    let check = out.checks.iter().find(|c| c.id == "hoop_stress").unwrap();
    assert!(check.note.starts_with("Course 2 "), "{}", check.note);
    let e = site(&mut c).joint_efficiency;
    assert!((check.capacity.unwrap() / (1.33 * 31e6 * e) - 1.0).abs() < 1e-12);
}

/// J = 0.81743 grows with F_a and F_v alike while A_v stays; the limit is 1.54.
#[test]
fn anchorage_ratio_of_2020() {
    limit(&Api6502020, "anchorage_ratio", |u| {
        let mut c = case();
        let k = 1.54 / 0.81743 * u;
        let s = site(&mut c);
        (s.fa, s.fv, s.av) = (Some(1.14 * k), Some(1.60 * k), Some(0.32148));
        c
    });
}

/// L = 0.01723·10 mm·√(235 MPa/(12 m·0.784267)) = 0.1723·√24.9702 = 0.86099 m, between 0.45 m and 0.035 D = 1.05 m.
#[test]
fn annulus_width_of_2020() {
    let with = |width: Option<f64>| {
        let mut c = case();
        c.tank.bottom.as_mut().unwrap().width = width;
        c
    };
    limit(&Api6502020, "annulus_width", |u| with(Some(0.86099 / u)));
    // Equality holds.
    let gap = Api6502020.assess(&with(None), Excitation::Site).unwrap();
    let needed = line(&gap, "L");
    for (width, holds) in [(needed, true), (needed.next_down(), false)] {
        let out = Api6502020.assess(&with(Some(width)), Excitation::Site).unwrap();
        assert_eq!(find(&out, "annulus_width").holds(), holds, "{width}");
    }
    let gap = find(&gap, "annulus_width");
    assert_eq!((gap.status, gap.input.as_deref()), (CheckStatus::NotChecked, Some("tank.bottom.width")));
    assert!(gap.reason.contains("860.99 mm"), "{}", gap.reason);
}

/// A tank that its weight alone keeps down needs no width: nearly empty, J_0 is small while L grows with 1/√H.
#[test]
fn annulus_width_of_2020_where_the_weight_suffices() {
    let mut c = case();
    c.liquid.fill_height = 2.0;
    c.tank.bottom.as_mut().unwrap().width = Some(0.1);
    let end = find(&Api6502020.assess(&c, Excitation::Site).unwrap(), "annulus_width").clone();
    assert_eq!(end.status, CheckStatus::NotApplicable, "{end:?}");
}

/// Without a bottom plate, and for J above 1.54, there is no width to check.
#[test]
fn annulus_width_of_2020_without_a_value() {
    let end = |c: &Case| find(&Api6502020.assess(c, Excitation::Site).unwrap(), "annulus_width").clone();
    let mut c = case();
    c.tank.bottom = None;
    assert_eq!(end(&c).input.as_deref(), Some("tank.bottom"));
    let mut c = case();
    c.tank.bottom.as_mut().unwrap().width = Some(2.0);
    let s = site(&mut c);
    (s.fa, s.fv, s.av) = (Some(2.28), Some(3.20), Some(0.32148));
    let gap = end(&c);
    assert!(!gap.compared() && gap.reason.contains("not stable"), "{gap:?}");
}

/// Consequences of the anchorage ratio: uplift from 0.785, compression up to 1.54.
#[test]
fn anchorage_ratio_of_2020_decides_the_state() {
    let at = |j: f64| {
        let mut c = case();
        let k = j / 0.81743;
        let s = site(&mut c);
        (s.fa, s.fv, s.av) = (Some(1.14 * k), Some(1.60 * k), Some(0.32148));
        Api6502020.assess(&c, Excitation::Site).unwrap()
    };
    for (j, lifts, compressed) in
        [(0.785 - 1e-4, false, true), (0.785 + 1e-4, true, true), (1.54 - 1e-4, true, true), (1.54 + 1e-4, true, false)]
    {
        let out = at(j);
        let has = |symbol: &str| out.steps.iter().any(|s| s.symbol == symbol);
        assert!((line(&out, "J") - j).abs() < 2e-5, "{j}");
        assert_eq!(has("y_u"), lifts && compressed, "y_u at J = {j}");
        assert_eq!(has("σ_c"), compressed, "σ_c at J = {j}");
        let state = &find(&out, "anchorage_ratio").note;
        let expected = match (lifts, compressed) {
            (false, _) => "does not lift",
            (true, true) => "self-anchored if",
            (true, false) => "not self-anchored",
        };
        assert!(state.contains(expected), "{state}");
    }
}

/// σ_c = 5.8928 MPa lifting against 0.5 F_ty.
#[test]
fn shell_compression_of_2020() {
    limit(&Api6502020, "shell_compression", |u| {
        let mut c = case();
        for course in &mut c.tank.courses {
            course.material.yield_strength = Some(2.0 * 5.8928e6 / u);
        }
        c
    });
}

/// Anchored, the whole ring bears: σ_c = 5.6024 MPa with A_i as if self-anchored.
#[test]
fn shell_compression_of_2020_anchored() {
    limit(&Api6502020, "shell_compression", |u| {
        let mut c = anchored(1e9);
        let s = site(&mut c);
        (s.fa, s.fv, s.av) = (Some(1.14), Some(1.60), Some(0.47 * 0.684));
        s.ss *= 4.0 / 3.5;
        for course in &mut c.tank.courses {
            course.material.yield_strength = Some(2.0 * 5.6024e6 / u);
        }
        c
    });
}

/// M_s = 103 962.1 kNm grows with F_a and F_v alike; 2 M_s against 15 m·(74 890.2 + 544.3 + 1 045.1 + 343.35 + 5 000) kN
/// = 1 227 344 kNm, with W_f = 7850·9.81·0.010·π·225 = 544.3 kN.
#[test]
fn foundation_of_2020() {
    let w_f = 7850.0 * 9.81 * 0.010 * PI * 225.0;
    let weights = 74_890.2e3 + w_f + 1_045.1e3 + 343.35e3;
    let with = |weight: Option<f64>, k: f64| {
        let mut c = case();
        let s = site(&mut c);
        s.foundation_weight = weight;
        (s.fa, s.fv, s.av) = (Some(1.14 * k), Some(1.60 * k), Some(0.32148));
        c
    };
    let k = 15.0 * (weights + 5e6) / (2.0 * 103_962.1e3);
    limit(&Api6502020, "foundation", |u| with(Some(5e6), k * u));
    // Twice the moment needs so much more foundation.
    limit(&Api6502020, "foundation", |u| with(Some((2.0 * k * 2.0 * 103_962.1e3 / 15.0) / u - weights), 2.0 * k));
    // As soon as the resisting moment is 2 M_s, it holds.
    let at = |weight: f64| {
        let out = Api6502020.assess(&with(Some(weight), k), Excitation::Site).unwrap();
        find(&out, "foundation").clone()
    };
    let any = at(0.0);
    let needed = (any.demand.unwrap() - any.capacity.unwrap()) / 15.0;
    let mut weight = needed * (1.0 - 1e-13);
    assert!(!at(needed * (1.0 - 1e-12)).holds());
    while !at(weight).holds() {
        weight = weight.next_up();
    }
    let limit = at(weight);
    assert!(limit.capacity >= limit.demand && (weight / needed - 1.0).abs() < 1e-12, "{limit:?}");
    // Anchored tanks alike; without the weight it is asked for.
    let mut c = with(None, 1.0);
    for support in [Support::Unanchored, Support::Anchored] {
        c.tank.support = support;
        let out = Api6502020.assess(&c, Excitation::Site).unwrap();
        let gap = find(&out, "foundation");
        assert_eq!(gap.status, CheckStatus::NotChecked);
        assert_eq!(gap.input.as_deref(), Some("site.api650.foundation_weight"));
    }
}

/// Lower edge of course 2, z = 2.4 m, 12 mm thick. χ_i = 0.56957 and χ_c = 0.676762 by integration of the pressure series with a
/// separate script; W_a = 1 144.62 kN with a moment of 8 784.4 kNm about z.
///
/// M_zi = 0.244286·(33 692.2·4.5·0.56957 + 8 784.4) = 23 241 kNm, M_zc = 0.066590·38 721.0·6.88687·0.676762 = 12 017 kNm,
/// M_z = 26 164 kNm; σ = (12 144.8 N/m·1.128592 + 1.273·26 164 kNm/900 m²)/12 mm = 4.2262 MPa.
/// G H_z D²/t² = 0.9·9.6·900/144 = 54: F_C = 83 GPa·12 mm/30 m = 33.2 MPa.
#[test]
fn upper_compression_of_2020() {
    let out = Api6502020.assess(&case(), Excitation::Site).unwrap();
    for (symbol, value, tolerance) in [
        ("χ_i", 0.56957, 1e-5),
        ("χ_c", 0.676762, 1e-6),
        ("W_a", 1_144.62e3, 5.0),
        ("M_z", 26_164e3, 1e3),
        ("σ_cz", 4.22622e6, 50.0),
        ("G·H_z·D²/t²", 54.0, 1e-9),
        ("F_Cz", 33.2e6, 1.0),
    ] {
        assert!((line(&out, symbol) - value).abs() <= tolerance, "{symbol} {}", line(&out, symbol));
    }
    assert!(find(&out, "upper_compression").note.starts_with("course 2 at z = 2.4 m"));
    limit(&Api6502020, "upper_compression", |u| {
        let mut c = case();
        for course in &mut c.tank.courses {
            course.material.yield_strength = Some(2.0 * 4.22622e6 / u);
        }
        c
    });
}

/// A course of half the thickness governs where it stands; equality holds; anchored tanks alike; one course has none above it.
#[test]
fn upper_compression_of_2020_governs_where_the_shell_is_weak() {
    let end = |c: &Case| find(&Api6502020.assess(c, Excitation::Site).unwrap(), "upper_compression").clone();
    let mut c = case();
    c.tank.courses[3].thickness = 0.004;
    assert!(end(&c).note.starts_with("course 4 at z = 7.2 m"), "{:?}", end(&c));
    let mut c = anchored(1e9);
    let demand = end(&c).demand.unwrap();
    for (limit, holds) in [(demand, true), (demand.next_down(), false)] {
        for course in &mut c.tank.courses {
            course.material.yield_strength = Some(2.0 * limit);
        }
        assert_eq!(end(&c).holds(), holds);
    }
    c.tank.courses[2].material.yield_strength = None;
    // On the branch of thick shells the yield strength is needed: 0.9·7.2·900/t² < 44 from t = 11.5 mm.
    c.tank.courses[2].thickness = 0.014;
    assert_eq!(end(&c).status, CheckStatus::NotChecked);
    c.tank.courses.truncate(1);
    c.tank.courses[0].height = 14.4;
    let out = Api6502020.assess(&c, Excitation::Site).unwrap();
    assert!(out.checks.iter().all(|check| check.id != "upper_compression"));
    let states = Api6502020.limit_states(&c);
    let state = states.iter().find(|s| s.id == "upper_compression").unwrap();
    assert!(matches!(state.requirement, tank::assessment::Requirement::NotApplicable(_)));
}

/// V = √((8 569.71 + 0.244286 W_f)² + 2 578.44²) kN against μ (W_s + W_r + W_f + W_p)(1 − 0.4 A_v).
#[test]
fn sliding_of_2020() {
    let w_f = 7850.0 * 9.81 * 0.010 * PI * 225.0;
    let v = (8_569.71e3 + 0.244286 * w_f).hypot(2_578.44e3);
    let weight = (1_045.1e3 + 343.35e3 + w_f + 74_890.2e3) * (1.0 - 0.4 * 0.32148);
    for (u, holds) in [(0.9, true), (1.0 - EPSILON, true), (1.0 + EPSILON, false), (1.04, false), (2.0, false)] {
        let mut c = case();
        site(&mut c).friction = v / weight / u;
        let out = Api6502020.assess(&c, Excitation::Site).unwrap();
        let check = find(&out, "sliding");
        assert_eq!(check.holds(), holds, "{check:?}");
        assert!((check.utilisation.unwrap() / u - 1.0).abs() < 0.8 * EPSILON, "{check:?}");
    }
    // 0.4 is the most that counts: beyond it the resistance stays.
    let at = |friction: f64| {
        let mut c = case();
        site(&mut c).friction = friction;
        let out = Api6502020.assess(&c, Excitation::Site).unwrap();
        let noted = out.notes.iter().any(|n| n.contains("taken as 0.4"));
        (find(&out, "sliding").capacity.unwrap(), noted)
    };
    let (capacity, noted) = at(0.4);
    assert!((capacity / (0.4 * weight) - 1.0).abs() < 1e-5 && !noted);
    assert_eq!(at(0.4 + 1e-9), (capacity, true));
    assert_eq!(at(0.8), (capacity, true));
}

/// w_AB = 48 968.7 N/m, 60 anchors.
#[test]
fn anchor_tension_of_2020() {
    limit(&Api6502020, "anchor_tension", |u| {
        let mut c = anchored(48_968.7 * PI * 30.0 / 60.0 / u);
        let s = site(&mut c);
        (s.fa, s.fv, s.av) = (Some(1.14), Some(1.60), Some(0.47 * 0.684));
        s.ss *= 4.0 / 3.5;
        c
    });
}

/// 3 P_AB = 3·48 968.7 N/m·π·30 m/60 = 230.76 kN.
#[test]
fn anchor_attachment_of_2020() {
    let with = |capacity: Option<f64>| {
        let mut c = anchored(1e9);
        let s = site(&mut c);
        (s.fa, s.fv, s.av) = (Some(1.14), Some(1.60), Some(0.47 * 0.684));
        s.ss *= 4.0 / 3.5;
        c.tank.anchors.as_mut().unwrap().attachment_capacity = capacity;
        c
    };
    limit(&Api6502020, "anchor_attachment", |u| with(Some(3.0 * 48_968.7 * PI * 30.0 / 60.0 / u)));
    let at = |capacity: Option<f64>| {
        let out = Api6502020.assess(&with(capacity), Excitation::Site).unwrap();
        find(&out, "anchor_attachment").clone()
    };
    // Equality holds.
    let force = at(Some(1e6)).demand.unwrap();
    assert!(at(Some(force)).holds() && !at(Some(force.next_down())).holds());
    let gap = at(None);
    assert_eq!((gap.status, gap.input.as_deref()), (CheckStatus::NotChecked, Some("tank.anchors.attachment_capacity")));
    // A weak earthquake does not pull.
    let mut c = with(Some(1e6));
    let s = site(&mut c);
    (s.ss, s.s1) = (0.01, 0.01);
    let out = Api6502020.assess(&c, Excitation::Site).unwrap();
    assert_eq!(find(&out, "anchor_attachment").status, CheckStatus::NotApplicable);
}

/// 5.12.3 prints 3 m (10 ft) and 10 ft = 3.048 m is the larger: π·30 m/n needs 30.9 anchors; 31 stand 3.040 m apart. D = 10 ft·n/π is at
/// the limit.
#[test]
fn anchor_spacing_of_2020() {
    let at = |count: u32, radius: f64| {
        let mut c = anchored(1e9);
        c.tank.anchors.as_mut().unwrap().count = count;
        c.tank.shape = tank::Shape::Cylinder { radius };
        let out = Api6502020.assess(&c, Excitation::Site).unwrap();
        find(&out, "anchor_spacing").clone()
    };
    for (count, spacing, holds) in [(31, 3.040, true), (30, PI, false), (1, 30.0 * PI, false)] {
        let check = at(count, 15.0);
        assert_eq!(check.holds(), holds, "{check:?}");
        assert!((check.demand.unwrap() - spacing).abs() < 5e-4, "{check:?}");
    }
    for (u, holds) in [(1.0 - 1e-9, true), (1.0 + 1e-9, false)] {
        assert_eq!(at(60, u * 0.5 * 3.048 * 60.0 / PI).holds(), holds, "{u}");
    }
    // Without anchors both limit states ask for them.
    let mut c = anchored(1e9);
    c.tank.anchors = None;
    let out = Api6502020.assess(&c, Excitation::Site).unwrap();
    for id in ["anchor_attachment", "anchor_spacing"] {
        assert_eq!(find(&out, id).input.as_deref(), Some("tank.anchors"), "{id}");
    }
}

/// x = M/(D² (w_t + w_L)) = 40.445 MNm/(900 m²·(14 732.3 + 49 874.8) N/m) in zone 3; the limit is 1/0.637.
#[test]
fn stability_of_1993() {
    let x = 40.445e6 / (900.0 * (14_732.3 + 49_874.8));
    limit(&Api6501993, "stability", |u| {
        let mut c = case();
        let zone = 0.30 / 0.637 / x * u;
        // Table E-2 ends at 1: the rest by the importance, up to 1.5.
        let importance = zone.max(1.0);
        site(&mut c).zone_factor = Some(zone / importance);
        site(&mut c).importance_1993 = importance;
        c
    });
}

/// f = 71 939 N/m/14 mm against 0.5 F_ty.
#[test]
fn shell_compression_of_1993() {
    limit(&Api6501993, "shell_compression", |u| {
        let mut c = case();
        for course in &mut c.tank.courses {
            course.material.yield_strength = Some(2.0 * 71_939.0 / 0.014 / u);
        }
        c
    });
}

/// Tension of the anchors 1.273·40.445 MNm/900 m² − 14 732.3 N/m.
#[test]
fn anchor_tension_of_1993() {
    let w_ab = 1.273 * 40.445e6 / 900.0 - 14_732.3;
    limit(&Api6501993, "anchor_tension", |u| anchored(w_ab * PI * 30.0 / 60.0 / u));
}

/// The factors of the zone method are admissible up to the ends of their tables, and no further.
#[test]
fn factors_of_1993_at_their_limits() {
    let fault = |edit: &dyn Fn(&mut tank::case::Api650Site)| {
        let mut c = case();
        edit(site(&mut c));
        Api6501993.assess(&c, Excitation::Site).map(|_| ()).map_err(|e| e.to_string())
    };
    for z in [0.0, 1.0] {
        assert_eq!(fault(&|s| s.zone_factor = Some(z)), Ok(()));
    }
    for z in [-1e-9, 1.0 + 1e-9, f64::NAN] {
        assert!(fault(&|s| s.zone_factor = Some(z)).unwrap_err().contains("zone_factor"));
    }
    for (soil, good) in [(1.0, true), (2.0, true), (1.0 - 1e-9, false), (2.0 + 1e-9, false)] {
        assert_eq!(fault(&|s| s.soil_factor = soil).is_ok(), good, "{soil}");
    }
    for (i, good) in [(1.0, true), (1.5, true), (1.0 - 1e-9, false), (1.5 + 1e-9, false)] {
        assert_eq!(fault(&|s| s.importance_1993 = i).is_ok(), good, "{i}");
    }
    // A note for values between the zones of table E-2, none for its own.
    for (z, noted) in [
        (0.0, false),
        (0.075, false),
        (0.15, false),
        (0.20, false),
        (0.30, false),
        (0.40, false),
        (0.10, true),
        (0.35, true),
    ] {
        let mut c = case();
        site(&mut c).zone_factor = Some(z);
        let out = Api6501993.assess(&c, Excitation::Site).unwrap();
        assert_eq!(out.notes.iter().any(|n| n.contains("table E-2")), noted, "{z}");
    }
}
