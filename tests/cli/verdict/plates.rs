//! Boxes whose walls bend as plates or as cantilevers, under a record.

use results::VerdictStatus::Holds;
use serde_json::json;

use super::engine::tank;
use super::*;

/// What no engine checks of a box, accepted.
const OPEN: &[&str] =
    &["wall_strength", "anchorage", "anchor_count", "anchor_spacing", "other_direction", "plane_walls"];

/// A box of concrete, 20 m long, with walls 4 m high and 3 m of water.
///
/// * `breadth`: its breadth [m]
fn of_breadth(breadth: f64) -> Value {
    let mut tank = concrete_box();
    let course = json!({ "height": "2 m", "thickness": "400 mm", "material": "concrete" });
    tank["tank"]["courses"] = json!([course, course]);
    tank["tank"]["breadth"] = json!(format!("{breadth} m"));
    merge(&mut tank, &filled(3.0));
    tank
}

/// A channel, 100 m broad.
pub(super) fn broad() -> Value {
    of_breadth(100.0)
}

/// What each engine makes of them: the one of plates is inside its model, and says so.
#[test]
fn the_walls_of_a_box_are_plates_in_three_dimensions() {
    let home = tempfile::tempdir().expect("a temporary folder");
    let coarse = json!({ "analysis": { "solid": { "mesh": "4x8x6" } } });
    let run = |breadth: f64, engines: &'static [EngineId]| {
        let changes = vec![only_ec8(), of_breadth(breadth), accept(OPEN), coarse.clone()];
        let tank = Tank { engines, ..tank("box", "", (Holds, ANY), changes) };
        tank.results(home.path())
    };
    let refused = run(5.0, &[EngineId::Harmonic]).expect_err("cantilevers");
    assert!(refused.contains("1.25 heights") && refused.contains("--fe solid"), "{refused}");
    let found = run(5.0, &[EngineId::Solid]).expect("plates");
    let inside = |results: &Results| {
        let rows = &results.comparison.rows;
        rows.iter().flat_map(|row| row.cells.iter().flatten()).all(|cell| !cell.outside)
    };
    assert!(inside(&found));
    let fe = found
        .methods
        .iter()
        .find(|m| m.id == "fe" && m.excitation == tank::assessment::Excitation::Record)
        .expect("a column of the finite elements");
    let check = |id: &str| fe.checks.iter().find(|c| c.limit_state == id).expect("a limit state").status;
    assert_eq!(check("plane_walls"), tank::assessment::CheckStatus::NotApplicable);
    assert!(fe.checks.iter().any(|c| c.limit_state == "freeboard" && c.compared()));
    assert!(found.runs[0].limits.iter().all(|l| l.id != "breadth_against_height"));
    let channel = run(100.0, &[EngineId::Harmonic]).expect("cantilevers");
    let limit = channel.runs[0].limits.iter().find(|l| l.id == "breadth_against_height");
    assert!(limit.expect("a limit of the breadth").holds && inside(&channel));
}
