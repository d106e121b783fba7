//! Source:    each run judged apart, and products by hand
//! Goal:      the worst of the properties of isolators, their displacement and tension
//! Tolerance: rounding

use tank::assessment::CheckStatus;
use tank::demand::Isolation;
use tank::{Bearing, Isolators};

use super::*;

/// The steel tank on bearings with room for 150 mm.
fn on_isolators(capacity: Option<f64>) -> Case {
    let mut case = steel_tank();
    case.tank.isolators = Some(Isolators {
        bearing: Bearing::Elastomer { stiffness: 1e8, damping: 0.1 },
        damper: None,
        slab_mass: 0.0,
        slab_thickness: 0.0,
        bounds: [0.6, 1.8],
        displacement_capacity: capacity,
    });
    case
}

fn moved(mut demands: Demands, displacement: f64, share: f64) -> Demands {
    let peak = |value| Peak { value, time: 4.0, theta: 1.0 };
    demands.isolation =
        Some(Isolation { displacement: peak(displacement), bearing_share: Some(peak(share)), bounds: Vec::new() });
    demands
}

/// Nominal, soft and stiff properties with other histories: each check is that of the run in which it is largest, and says which.
#[test]
fn each_check_is_the_worst_of_the_properties() {
    let case = on_isolators(Some(0.150));
    let runs = [(1.0, 1, 0.080, 0.4), (0.6, 2, 0.120, 0.7), (1.8, 3, 0.050, -0.1)];
    let of = |(_, seed, displacement, share)| moved(shaken(seed).demands(0.0, 0), displacement, share);
    let alone: Vec<Findings> = runs.iter().map(|run| assessed(&case, &of(*run))).collect();
    let mut demands = of(runs[0]);
    let bounds = runs[1..].iter().map(|run| (run.0, of(*run)));
    demands.isolation.as_mut().unwrap().bounds = bounds.collect();
    let together = assessed(&case, &demands);
    let mut governed = [0; 3];
    for check in together.checks.iter().filter(|check| check.compared()) {
        let ratios = alone.iter().map(|findings| found(findings, &check.id).ratio().unwrap());
        // Of equal ones the first, which is nominal.
        let worse = |worst: (usize, f64), next: (usize, f64)| if next.1 > worst.1 { next } else { worst };
        let (run, ratio) = ratios.enumerate().reduce(worse).unwrap();
        assert_eq!(check.ratio(), Some(ratio), "{}", check.id);
        governed[run] += 1;
        let factor = format!("the properties of the isolators times {}", runs[run].0);
        assert_eq!(check.note.contains(&factor), run > 0, "{}", check.note);
    }
    assert!(governed.iter().all(|count| *count > 0), "{governed:?}");
    // 1.2 × 120 mm of 150 mm; 1 + 0.1 of 1.
    let displacement = found(&together, "isolator_displacement");
    close(displacement.utilisation.unwrap(), 0.96, 1e-12);
    assert_eq!(displacement.status, CheckStatus::Holds);
    let tension = found(&together, "isolator_tension");
    close(tension.utilisation.unwrap(), 1.1, 1e-12);
    assert_eq!(tension.status, CheckStatus::Fails);
}

/// API 650 alone leaves the displacement open; so does EN 1998 without a capacity; the ground under the bearings is not judged.
#[test]
fn what_is_asked_of_isolators() {
    let run = || moved(shaken(1).demands(0.0, 0), 0.140, 0.5);
    let mut case = on_isolators(Some(0.150));
    case.site.api650 = Some(api_site());
    let findings = assessed(&case, &run());
    assert!(findings.checks.iter().all(|check| check.id != "isolator_displacement"));
    let tension = found(&findings, "isolator_tension");
    assert!(tension.clause.starts_with("ASCE 7-16"), "{}", tension.clause);
    let asked = limit_states(&case, &counted(&case, &[]));
    let mce = asked.iter().find(|state| state.id == "isolator_displacement_mce");
    assert!(mce.is_some_and(|state| state.requirement == Requirement::NotImplemented));
    let open = assessed(&on_isolators(None), &run());
    let displacement = found(&open, "isolator_displacement");
    let input = displacement.input.as_deref();
    assert_eq!((displacement.status, input), (CheckStatus::NotChecked, Some("tank.isolators.displacement_capacity")));
    assert!(open.checks.iter().all(|check| check.id != "bearing"));
    let fixed = assessed(&steel_tank(), &shaken(1).demands(0.0, 0));
    assert!(fixed.checks.iter().all(|check| !check.id.starts_with("isolator")));
}

/// Checks of an engine that holds the base still do not apply to a tank on isolators.
#[test]
fn a_base_held_still_says_nothing() {
    let mut case = on_isolators(Some(0.150));
    case.liquid.fill_height = 9.7;
    let mut fixed = steel_tank();
    fixed.liquid.fill_height = 9.7;
    let demands = shaken(1).demands(0.0, 0);
    let held = assessed(&fixed, &demands);
    assert_eq!(found(&held, "freeboard").status, CheckStatus::Fails);
    let findings = assessed(&case, &demands);
    for check in held.checks.iter().filter(|check| check.compared()) {
        let open = found(&findings, &check.id);
        assert_eq!((open.status, open.demand), (CheckStatus::NotChecked, None), "{}", open.id);
        assert!(open.reason.contains("holds the base still"), "{}", open.reason);
    }
    assert_eq!(found(&findings, "isolator_displacement").status, CheckStatus::NotChecked);
}
