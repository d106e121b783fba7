//! An unanchored tank whose engine lets it lift and slide.

use tank::demand::{Footing, FreeBase};
use tank::outside::Outside;

use super::*;
use crate::base_state::overstressed;
use crate::samples::bottom_plate;

fn free(base: FreeBase) -> Demands {
    let mut demands = shaken(5).demands(0.0, 0);
    demands.places[0].bending = None;
    demands.base = Some(base);
    demands
}

/// 0.05 rad of 0.20 rad; nothing is outside the model, though the wall pulls, and bending at the foot stays open.
#[test]
fn the_joint_is_judged_and_nothing_is_outside() {
    let mut case = steel_tank();
    case.tank.support = Support::Unanchored;
    let joint = |value| Peak { value, time: 2.0, theta: 0.0 };
    let lifts = |joint| FreeBase { lifts: true, joint, ..FreeBase::default() };
    let findings = assessed(&case, &free(lifts(Some(joint(0.05)))));
    let check = found(&findings, UPLIFT.id);
    assert_eq!((findings.outside, check.status), (None, CheckStatus::Holds));
    close(check.utilisation.unwrap(), 0.25, 1e-12);
    assert_eq!(found(&findings, "equivalent_stress_at_base").status, CheckStatus::NotChecked);
    let fails = assessed(&case, &free(lifts(Some(joint(0.21)))));
    assert_eq!(found(&fails, UPLIFT.id).status, CheckStatus::Fails);
    let elastic = assessed(&case, &free(lifts(None)));
    assert_eq!(found(&elastic, UPLIFT.id).status, CheckStatus::NotChecked);
    // A base that does not repeat holds nothing but the wave, and fails what it fails.
    let scatters = |value| FreeBase { scatters: true, ..lifts(Some(joint(value))) };
    let draw = assessed(&case, &free(scatters(0.05)));
    let holds = draw.checks.iter().filter(|check| check.status == CheckStatus::Holds);
    assert!(holds.clone().all(|check| check.limit_state == "freeboard"), "{holds:?}");
    assert_eq!(found(&draw, UPLIFT.id).status, CheckStatus::NotChecked);
    assert!(found(&draw, UPLIFT.id).reason.contains("does not repeat"));
    let draw = assessed(&case, &free(scatters(0.21)));
    assert_eq!(found(&draw, UPLIFT.id).status, CheckStatus::Fails);
    // Neither does one whose lifted side has lost its hoop force.
    let softened = |value| FreeBase { softened: true, ..lifts(Some(joint(value))) };
    let soft = assessed(&case, &free(softened(0.05)));
    assert!(soft.checks.iter().all(|check| !check.holds() || check.limit_state == "freeboard"), "{:?}", soft.checks);
    assert!(found(&soft, UPLIFT.id).reason.contains("--fe nonlinear"));
    assert_eq!(found(&assessed(&case, &free(softened(0.21))), UPLIFT.id).status, CheckStatus::Fails);
    // Above a foot that warps no compression holds, and all else is as it was.
    let warped = assessed(&case, &free(FreeBase { warps: true, ..lifts(Some(joint(0.05))) }));
    let compression = found(&warped, "buckling_elastic");
    assert!(compression.status == CheckStatus::NotChecked && compression.reason.contains("--fe nonlinear"));
    assert_eq!(
        (found(&warped, UPLIFT.id).status, found(&findings, "buckling_elastic").status),
        (CheckStatus::Holds, CheckStatus::Holds)
    );
    let rests = assessed(&case, &free(FreeBase::default()));
    assert_eq!((rests.outside, found(&rests, UPLIFT.id).status), (None, CheckStatus::NotApplicable));
}

/// A tank that moves further than the engine follows: nothing but the wave and anchors has a demand, whether or not the wall held down pulls.
#[test]
fn a_base_beyond_the_model_has_no_demands() {
    for (support, state) in [(Support::Unanchored, 0), (Support::Unanchored, 5), (Support::Anchored, 5)] {
        let mut case = steel_tank();
        case.tank.support = support;
        case.tank.anchors =
            (support == Support::Anchored).then_some(Anchors { count: 20, capacity: Some(1.0), ..Anchors::default() });
        let mut demands = shaken(state).demands(0.0, 0);
        demands.footing = Footing::Beyond { time: Some(3.25), reason: "the base turns by 0.06 rad".into() };
        let findings = assessed(&case, &demands);
        assert_eq!(findings.outside, Some(Outside::Uplift));
        for check in &findings.checks {
            let judged = ["freeboard", "anchorage"].contains(&check.limit_state.as_str());
            assert!(judged || !check.compared(), "{support:?}, {state}: {check:?}");
        }
        let open = found(&findings, UPLIFT.id);
        assert_eq!((open.status, open.demand), (CheckStatus::NotChecked, None));
        assert!(open.reason.contains("the base turns by 0.06 rad"), "{}", open.reason);
    }
}

/// Friction caps the shear at what API allows; held in place the tank would have 9 MN: it slides, and the check fails.
#[test]
fn a_tank_that_slides_is_judged_by_the_shear_of_the_held_one() {
    let mut case = steel_tank();
    case.tank.support = Support::Unanchored;
    case.site.api650 = Some(api_site());
    let mass = std::f64::consts::PI * (R * R * 8.5 * 1000.0 + 2.0 * R * 7850.0 * (5.0 * 0.014 + 5.0 * 0.008));
    let held = 1.1 * 0.4 * mass * 9.81;
    let mut demands = Demands {
        times: vec![0.0, 1.0],
        states: vec![vec![0.0, 0.9 * 0.4 * mass * 9.81], vec![0.0, held]],
        base_shear: Some(vec![(0, 1.0)]),
        ..Demands::default()
    };
    assert_eq!(found(&assessed(&case, &demands), "sliding_api").status, CheckStatus::Holds);
    demands.base = Some(FreeBase { held_shear: Some(vec![(1, 1.0)]), ..FreeBase::default() });
    let findings = assessed(&case, &demands);
    let check = found(&findings, "sliding_api");
    assert_eq!(check.status, CheckStatus::Fails);
    close(check.demand.unwrap(), held, 1e-12);
}

/// An anchor that yields fails its check, though the wall pulls with less than its strength: the ground that is relieved pulls it, too. One that
/// stays elastic is judged by its own force where that is larger.
#[test]
fn an_anchor_is_judged_by_its_own_force() {
    let mut case = steel_tank();
    case.tank.anchors = Some(Anchors { count: 20, capacity: Some(1e9), ..Anchors::default() });
    let on_springs = |value| FreeBase { anchor: Some(Peak { value, time: 2.0, theta: 1.5 }), ..FreeBase::default() };
    let findings = assessed(&case, &free(on_springs(1.01e9)));
    let check = found(&findings, "anchorage");
    assert_eq!((check.status, check.time_s), (CheckStatus::Fails, Some(2.0)));
    close(check.demand.unwrap(), 1.01e9, 1e-12);
    let findings = assessed(&case, &free(on_springs(0.5e9)));
    let check = found(&findings, "anchorage");
    assert_eq!(check.status, CheckStatus::Holds);
    close(check.utilisation.unwrap(), 0.5, 1e-12);
}

/// Anchors that break: nothing of wall and base holds, what fails does.
#[test]
fn nothing_holds_where_anchors_break() {
    let mut case = steel_tank();
    case.tank.anchors = Some(Anchors { count: 20, capacity: Some(1.0), ..Anchors::default() });
    let anchor = Some(Peak { value: 2.0, ..Peak::default() });
    let of = |broken| FreeBase { lifts: true, anchor, broken, ..FreeBase::default() };
    let holding = |broken| -> Vec<String> {
        let findings = assessed(&case, &free(of(broken)));
        assert_eq!(found(&findings, "anchorage").status, CheckStatus::Fails);
        let holds = findings.checks.iter().filter(|check| check.holds());
        holds.map(|check| check.id.clone()).collect()
    };
    assert!(holding(0).len() > 1);
    assert_eq!(holding(20), ["freeboard"]);
}

/// Anchors that are overstressed while the engine holds the wall down: its compression does not hold, and keeps its numbers. By an engine that
/// lets it lift on them it may.
#[test]
fn compression_does_not_hold_where_anchors_fail() {
    let mut case = steel_tank();
    let status = |case: &Case, base: Option<FreeBase>| {
        let demands = Demands { base, ..shaken(5).demands(0.0, 0) };
        let mut findings = assessed(case, &demands);
        if demands.base.is_none() {
            overstressed(&mut findings.checks);
        }
        let check = found(&findings, "equivalent_stress");
        (found(&findings, "anchorage").status, check.status, check.demand.is_some())
    };
    let mut of = |capacity: f64, base| {
        case.tank.anchors = Some(Anchors { count: 20, capacity: Some(capacity), ..Anchors::default() });
        status(&case, base)
    };
    assert_eq!(of(1e9, None), (CheckStatus::Holds, CheckStatus::Holds, true));
    assert_eq!(of(1.0, None), (CheckStatus::Fails, CheckStatus::NotChecked, true));
    let lifts = Some(FreeBase::default());
    assert_eq!(of(1.0, lifts), (CheckStatus::Fails, CheckStatus::Holds, true));
}

/// A plate thicker than the lowest course: the joint of an engine that leaves the wall elastic does not hold, and fails where it fails.
#[test]
fn a_joint_does_not_hold_where_the_wall_yields_first() {
    let mut case = steel_tank();
    case.tank.support = Support::Unanchored;
    let mut bottom = bottom_plate(steel());
    let mut status = |thickness: f64, value: f64, elastic_wall: bool| {
        bottom.thickness = thickness;
        case.tank.bottom = Some(bottom.clone());
        let joint = Some(Peak { value, ..Peak::default() });
        let base = FreeBase { lifts: true, joint, elastic_wall, ..FreeBase::default() };
        found(&assessed(&case, &free(base)), UPLIFT.id).status
    };
    assert_eq!(status(0.010, 0.05, true), CheckStatus::Holds);
    assert_eq!(status(0.016, 0.05, true), CheckStatus::NotChecked);
    assert_eq!(status(0.016, 0.05, false), CheckStatus::Holds);
    assert_eq!(status(0.016, 0.25, true), CheckStatus::Fails);
}
