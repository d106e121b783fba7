//! The nonlinear cylinder at rising scales of its record: linear while it is weak, marked where the theory ends.

use super::*;
use crate::nonlinear::Incremental;
use results::IdaRun;
use results::nonlinear::{At, TwoSided};

fn curve(case: &Case, own: &NonlinearOptions, scales: &[f64]) -> Vec<IdaRun> {
    let tank = Incremental::new(case, own, &Silent).unwrap();
    tank.run(scales, 2, &|_| None, &Silent, |_| {}).unwrap()
}

fn extreme<'a>(list: &'a [TwoSided], title: &str) -> &'a TwoSided {
    list.iter().find(|e| e.title == title).unwrap()
}

/// Weak shaking of an elastic tank: the wave is proportional to the scale, and what rises at θ = 0 falls at θ = 180° (the liquid
/// is linear, the wall nearly so: its deflections are 1e-4 of the radius, 1 % is generous). Two hundred times as strong, waves pass
/// the freeboard of 0.3 m and 0.2 R = 0.37 m, for 200 × 2.4 mm = 0.47 m.
#[test]
fn scales_are_linear_until_their_limits_are_marked() {
    let case = shaken(elastic(), 0.05, 60);
    let runs = curve(&case, &options(&case, 8, 16), &[1.0, 2.0, 200.0]);
    assert_eq!(runs.iter().map(|r| r.scale).collect::<Vec<_>>(), [1.0, 2.0, 200.0]);
    assert!((runs[1].wave / runs[0].wave - 2.0).abs() < 0.02);
    for run in &runs[..2] {
        let [front, back] = ["θ = 0°", "θ = 180°"].map(|side| {
            let found = extreme(&run.extremes, &format!("Wave height at the wall, {side}"));
            let At { value: least, .. } = found.min.unwrap();
            (least, found.max.value)
        });
        assert!((front.1 + back.0).abs() < 0.01 * run.wave, "{front:?} {back:?}");
        assert!((front.0 + back.1).abs() < 0.01 * run.wave, "{front:?} {back:?}");
        assert!((run.wave / front.1.max(back.1) - 1.0).abs() < 1e-9);
        assert!(run.open_share.is_none());
    }
    let waves = |run: &IdaRun| run.exceeded().filter(|l| l.id.starts_with("wave")).count();
    assert_eq!(runs.iter().map(waves).collect::<Vec<_>>(), [0, 0, 2]);
    // Bonded liquid: the strong run has suction under the trough, and it is marked.
    assert!(runs[2].exceeded().any(|l| l.id == "suction" && l.value < 0.0));
    // The same numbers as one history.
    let single = simulate(&case, &options(&case, 8, 16), None, &Silent).unwrap();
    let moment = single.values[&Quantity::BaseMoment];
    assert!((runs[0].base_moment / moment - 1.0).abs() < 1e-9);
    assert_eq!(single.result.nonlinear.unwrap().extremes, runs[0].extremes);
}

/// A wall that cracks: the widest crack of a scale is that of one of its halves, and the open share of a liquid that may leave
/// the wall is a share.
#[test]
fn cracks_and_gaps_have_their_sides() {
    let case = shaken(cracking(), 1.0, 25);
    let own = NonlinearOptions { contact: Contact::Opening, ..options(&case, 6, 16) };
    let runs = curve(&case, &own, &[0.0, 20.0]);
    let shares: Vec<f64> = runs.iter().map(|r| r.open_share.unwrap()).collect();
    assert!(shares[0] == 0.0 && (0.0..1.0).contains(&shares[1]) && shares[1] > 0.0, "{shares:?}");
    let widest = |run: &IdaRun| {
        let cracks = run.extremes.iter().filter(|e| e.title.contains("crack width"));
        let all: Vec<f64> = cracks.map(|e| e.max.value).collect();
        assert_eq!(all.len(), 4, "two faces in two halves");
        all.into_iter().fold(0.0, f64::max)
    };
    assert!(runs[1].first_crack.is_some() && widest(&runs[1]) > 1e-6);
    assert!(widest(&runs[0]) < widest(&runs[1]));
    let limit = runs[1].limits.iter().find(|l| l.id == "crack_width").unwrap();
    assert_eq!(limit.value, widest(&runs[1]));
    assert!(runs[1].limits.iter().all(|l| l.id != "suction"));
}
