//! Boxes whose walls bend as plates or as cantilevers, in the harmonic engine under a record.

use results::VerdictStatus::{Holds, Incomplete};
use serde_json::json;

use super::engine::tank;
use super::*;

/// What no engine checks of a box, accepted.
const OPEN: &[&str] = &["wall_strength", "anchorage", "plane_walls"];

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

/// Tanks that must not hold.
pub(super) fn failing() -> Vec<Tank> {
    vec![tank(
        "engine-box-plates",
        "5 m broad and 4 m high: plates held at three sides; that cannot be accepted",
        (Incomplete, "plane_walls"),
        vec![only_ec8(), of_breadth(5.0), accept(OPEN)],
    )]
}

/// Tanks that hold.
pub(super) fn sound() -> Vec<Tank> {
    vec![tank(
        "engine-sound-channel",
        "100 m broad and 4 m high: cantilevers",
        (Holds, ANY),
        vec![only_ec8(), broad(), accept(OPEN)],
    )]
}

/// Whether cells of the finite elements are marked, by quantity, and whether the breadth keeps its limit.
fn marks(tank: Tank) -> (Vec<(String, bool)>, bool) {
    let home = tempfile::tempdir().expect("a temporary folder");
    let results = tank.results(home.path()).expect("the input is good");
    let column = results.methods.iter().position(|m| m.id == "fe");
    let column = column.expect("a column of the finite elements");
    let cell = |row: &results::ComparisonRow| Some((row.quantity.clone(), row.cells.get(column)?.as_ref()?.outside));
    let limit = results.runs[0].limits.iter().find(|l| l.id == "breadth_against_height");
    let holds = limit.expect("a limit of the breadth").holds;
    (results.comparison.rows.iter().filter_map(cell).collect(), holds)
}

/// All that the wall makes is marked, what the liquid makes is not; nothing of a channel.
#[test]
fn the_numbers_of_plates_are_marked() {
    let named = |name| {
        let all = [failing(), sound()].concat();
        all.into_iter().find(|tank| tank.name == name).expect("a tank")
    };
    let (found, holds) = marks(named("engine-box-plates"));
    assert!(!holds);
    let marked = |id: &str| found.iter().find(|(quantity, _)| quantity == id).map(|found| found.1);
    for id in ["impulsive_period", "base_shear", "base_moment", "overturning_moment"] {
        assert_eq!(marked(id), Some(true), "{id}");
    }
    for id in ["sloshing_period", "sloshing_height"] {
        assert_eq!(marked(id), Some(false), "{id}");
    }
    let (found, holds) = marks(named("engine-sound-channel"));
    assert!(holds && found.iter().all(|(_, outside)| !outside), "{found:?}");
}
