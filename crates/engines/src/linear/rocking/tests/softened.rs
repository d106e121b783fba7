//! A squat tank under a motion that takes the hoop force from its lifted side.

use tank::RimSupport;

use super::*;

/// R = 25 m, 9 m of water, plate of 10 mm, under bursts that grow with `peak`: 3.7 is 0.6 g.
fn squat(holds: RimSupport, peak: f64) -> Case {
    let mut case = test_tanks::case(
        Shape::Cylinder { radius: 25.0 },
        &[(2.5, 0.02), (2.5, 0.016), (5.0, 0.011)],
        (205e9, 0.3, 7850.0),
        (1000.0, 9.0),
    );
    let steel = Material { yield_strength: Some(250e6), ..case.tank.courses[0].material.clone() };
    case.tank.roof.holds = holds;
    test_tanks::on_ground(&mut case, 0.01, steel, 1e8);
    case.ground_motion = oil(0.0, 1e8, peak).ground_motion;
    case
}

/// Under a free rim the run exceeds the limit of its strips, 0.35 of the pressure at rest (0.65 · 0.536), names the nonlinear engine, and its demands
/// hold nothing. Under a round rim there is no such limit.
#[test]
fn a_squat_tank_under_a_free_rim_exceeds_its_limit() {
    for (holds, exceeds) in [(RimSupport::Free, true), (RimSupport::Round, false)] {
        let run = crate::linear::simulate(&squat(holds, 3.7), &Options::default()).unwrap();
        let base = run.result.base.as_ref().unwrap();
        assert!(base.quantity("uplift").unwrap().value.value > 1e-3, "{holds:?}");
        let limit = run.result.limits.iter().find(|limit| limit.id == "base_suction");
        let demands = run.demands.as_ref().unwrap().base.as_ref().unwrap();
        assert_eq!(limit.is_some(), exceeds, "{holds:?}");
        let Some(limit) = limit else { continue };
        assert!(
            demands.softened && !limit.holds && limit.value > 0.45 && (limit.limit - 0.348).abs() < 1e-3,
            "{limit:?}"
        );
        assert!(limit.note.contains("--fe nonlinear"), "{}", limit.note);
    }
}

/// Beyond half of the pressure at rest the curves of the strips end under every rim: the run says so, and its demands hold nothing.
#[test]
fn a_pressure_beyond_the_curves_is_a_limit() {
    for (peak, exceeds) in [(2.5, false), (6.0, true)] {
        let run = crate::linear::simulate(&squat(RimSupport::Round, peak), &Options::default()).unwrap();
        let limit = run.result.limits.iter().find(|limit| limit.id == "base_curves");
        let demands = run.demands.as_ref().unwrap().base.as_ref().unwrap();
        assert_eq!((limit.is_some(), demands.softened), (exceeds, exceeds), "{peak}");
        assert!(limit.is_none_or(|limit| !limit.holds && limit.value > 0.5 && limit.note.contains("--fe nonlinear")));
    }
}
