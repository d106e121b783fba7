//! Source:    the limit of `docs/theory/limit-states-of-runs.md`, tested apart from here
//! Goal:      what holds of a box, a channel and a strip
//! Tolerance: none

use tank::Shape;
use tank::assessment::CheckStatus;
use tank::case::Ec8Site;
use tank::demand::{Demands, Peak};
use tank::outside::Outside;

use super::super::Findings;
use super::{assessed, found};
use crate::samples::{case, course, material};

/// A box as broad as it is high is outside the model of cantilevers, and nothing but the freeboard holds; in an engine of plates, and of
/// a strip and a channel, the rest does.
#[test]
fn a_narrow_box_is_outside_the_model() {
    let found_by = |breadth: f64, strip: bool, plates: bool| {
        let concrete = material("concrete", 30e9, 0.2, 2500.0);
        let shape = Shape::Rectangle { length: 5.0, breadth, strip };
        let mut case = case(shape, vec![course(4.0, 0.3, concrete)], 3.0, None);
        case.site.ec8 =
            Some(Ec8Site { friction: Some(0.5), bearing_capacity: Some(1e6), ..crate::ec8::example::site() });
        // A hundredth of the weight, at the height of the wall.
        let force = 0.01 * (case.liquid_mass() + case.tank.wall_mass()) * case.gravity;
        let demands = Demands {
            times: vec![0.0, 1.0],
            states: vec![vec![0.0, force]],
            wave: Some(Peak { value: 0.1, ..Peak::default() }),
            base_shear: Some(vec![(0, 1.0)]),
            overturning_moment: Some(vec![(0, 4.0)]),
            plates,
            ..Demands::default()
        };
        assessed(&case, &demands)
    };
    let found_of = |breadth: f64, strip: bool| found_by(breadth, strip, false);
    let holding = |findings: &Findings| -> Vec<String> {
        let holds = findings.checks.iter().filter(|c| c.holds());
        holds.map(|c| c.limit_state.clone()).collect()
    };
    let narrow = found_of(5.0, false);
    assert_eq!(narrow.outside, Some(Outside::Plates));
    assert_eq!(holding(&narrow), ["freeboard"]);
    let open = found(&narrow, "plane_walls");
    assert_eq!(open.status, CheckStatus::NotChecked);
    assert!(open.reason.contains("1.25 heights"), "{}", open.reason);
    let plates = found_by(5.0, false, true);
    assert_eq!(plates.outside, None);
    assert_eq!(found(&plates, "plane_walls").status, CheckStatus::NotApplicable);
    assert_eq!(holding(&plates), ["freeboard", "sliding", "bearing"]);
    let broad = found_of(100.0, false);
    assert_eq!(broad.outside, None);
    assert_eq!(found(&broad, "plane_walls").status, CheckStatus::NotApplicable);
    assert_eq!(holding(&broad), ["freeboard", "sliding", "bearing"]);
    let strip = found_of(1.0, true);
    assert_eq!(strip.outside, None);
    assert!(strip.checks.iter().all(|c| c.limit_state != "plane_walls"));
    assert_eq!(holding(&strip), ["freeboard", "sliding", "bearing"]);
}
