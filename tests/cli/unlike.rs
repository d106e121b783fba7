//! Values that stand side by side are those of the same place, the same base and the same plates.

use serde_json::{Value, json};

use crate::compare::{stderr, tankcheck};

const QUAKE: &str = "examples/records/elcentro.csv";

fn list<'a>(value: &'a Value, key: &str) -> &'a [Value] {
    value[key].as_array().map_or(&[], Vec::as_slice)
}

/// An example with changes.
fn example(name: &str, change: impl Fn(&mut Value)) -> String {
    let path = format!("{}/examples/{name}/tank.json", env!("CARGO_MANIFEST_DIR"));
    let text = std::fs::read_to_string(path).expect("an example");
    let mut tank: Value = serde_json::from_str(&text).expect("JSON");
    change(&mut tank);
    tank.to_string()
}

/// Results of a tank under El Centro.
fn results(tank: &str) -> Value {
    let home = tempfile::tempdir().expect("a temporary folder");
    let (file, out) = (home.path().join("tank.json"), home.path().join("out"));
    std::fs::write(&file, tank).expect("a tank");
    let [file, out] = [&file, &out].map(|path| path.to_str().expect("a temporary path is text").to_owned());
    let run = tankcheck(&["compare", &file, "--quake", QUAKE, "--out", &out, "--format", "json"]);
    serde_json::from_slice(&run.stdout).unwrap_or_else(|e| panic!("{e}: {}", stderr(&run)))
}

/// The hoop stress compared lies below the surface; between the procedures and the run no factor of history, modes, stress and height is below
/// 0.5 or above 2. What is larger has a name that is not a place: a rigid wall, the vertical motion, the factors of a code.
fn hoop_of_one_place(name: &str, height: f64) {
    // As the golden tests keep them.
    let kept = format!("{}/reports/{name}/results.json", env!("CARGO_MANIFEST_DIR"));
    let kept = std::fs::read_to_string(kept).expect("kept results");
    let results: Value = serde_json::from_str(&kept).expect("JSON");
    let fe = list(&results, "methods").iter().find(|m| m["id"] == "fe" && m["excitation"] == "record");
    let value = |id: &str| fe.expect("a run")["quantities"][id]["value"].as_f64().expect(id);
    let base = &results["runs"][0]["base"];
    let place = |id: &str| {
        let found = list(base, "quantities").iter().find(|q| q["id"] == id).expect("a quantity of the base");
        (found["value"].as_f64(), found["z"].as_f64().expect("a height"))
    };
    let (wall, rim) = (place("hoop_stress"), place("rim_hoop_stress"));
    assert_eq!(wall.0, Some(value("hoop_stress")));
    assert!(wall.1 <= height && rim.1 > height, "{name}: {wall:?} {rim:?}");
    let found = list(&results["comparison"], "attribution");
    let of_hoop: Vec<&Value> = found.iter().filter(|a| a["quantity"] == "hoop_stress").collect();
    assert!(of_hoop.len() >= 4, "{name}: {}", of_hoop.len());
    let places = ["uplift", "time_history", "modes", "impulsive_stress", "convective_stress", "place"];
    for a in of_hoop {
        for step in list(a, "steps") {
            let (id, factor) = (step["factor_id"].as_str().unwrap(), step["factor"].as_f64().unwrap());
            let what = format!("{name}: {id} of {} under {}: {factor}", a["method"], a["excitation"]);
            assert!(!places.contains(&id) || (0.5..=2.0).contains(&factor), "{what}");
        }
    }
}

#[test]
fn hoop_of_one_place_on_a_broad_and_a_slender_tank() {
    hoop_of_one_place("05_oil_tank", 15.0);
    hoop_of_one_place("09_slender_unanchored", 11.0);
}

/// A tank that corrodes, with vertical motion: the table of the base has the uplift of the sheet whose moment it takes, ground by ground.
#[test]
fn one_uplift_in_table_and_sheet() {
    let results = results(&example("05_oil_tank", |tank| {
        tank["tank"]["bottom"]["corrosion_allowance"] = json!("2 mm");
        tank["site"]["ec8"]["vertical"] = json!(true);
    }));
    let blocks = list(&results["parts"][0], "blocks");
    let grounds = blocks.iter().find(|block| block["id"] == "grounds").expect("a table");
    let methods = list(&results, "methods");
    let sheets = methods.iter().filter(|m| m["excitation"] == "site");
    let on_sheet: Vec<f64> = sheets
        .flat_map(|method| list(method, "steps"))
        .filter(|s| s["symbol"] == "w" && s["name"] == "largest uplift")
        .filter_map(|s| s["value"].as_f64())
        .collect();
    let in_table: Vec<f64> =
        { list(grounds, "rows").iter() }.filter_map(|row| row[2].as_f64()).map(|w| w.max(0.0)).collect();
    assert!(in_table.len() >= 3 && in_table.iter().any(|w| *w > 0.0), "{in_table:?}");
    for w in &in_table {
        assert!(on_sheet.iter().any(|s| (s / w - 1.0).abs() < 1e-9), "{in_table:?} {on_sheet:?}");
    }
}

/// One message with path and what is allowed, and no output, for a joint that cannot be.
#[test]
fn a_joint_that_cannot_be_is_refused() {
    let refused = |name: &str, joint: &Value| {
        let home = tempfile::tempdir().expect("a temporary folder");
        let file = home.path().join("tank.json");
        std::fs::write(&file, example(name, |tank| tank["tank"]["wall_base"] = joint.clone())).expect("a tank");
        let run = tankcheck(&["check", file.to_str().expect("a temporary path is text")]);
        assert_eq!(run.status.code(), Some(2), "{joint}");
        let text = stderr(&run);
        assert_eq!(text.matches("error[").count(), 1, "{text}");
        assert!(text.contains("tank.wall_base"), "{text}");
        text
    };
    const CONCRETE: &str = "08_concrete_cylinder";
    let sliding = |key: &str, value: Value| json!({ "kind": "sliding", key: value });
    let text = refused(CONCRETE, &json!({ "kind": "sliding" }));
    assert!(text.contains("stiffness or friction"), "{text}");
    assert!(refused(CONCRETE, &json!({ "kind": "glued" })).contains("hinged"));
    refused(CONCRETE, &json!({ "kind": "fixed", "friction": 0.4 }));
    refused(CONCRETE, &json!({ "kind": "hinged", "stiffness": "2 MN/m2" }));
    refused(CONCRETE, &sliding("stiffness", json!("-3 MN/m2")));
    refused(CONCRETE, &sliding("friction", json!(3)));
    refused(CONCRETE, &json!({ "friction": 0.4 }));
    let text = refused("05_oil_tank", &json!({ "kind": "hinged" }));
    assert!(text.contains("metal"), "{text}");
    refused("04_concrete_strip", &json!({ "kind": "hinged" }));
}

/// Bars stand for methods whose scope the tank is in: none of API 650 for a wall of concrete.
#[test]
fn no_bars_beyond_a_scope() {
    let concrete = results(&example("08_concrete_cylinder", |tank| {
        tank["analysis"].take();
        tank.as_object_mut().expect("a tank").remove("analysis");
    }));
    for method in list(&concrete, "methods") {
        let id = method["id"].as_str().expect("an id");
        let computed = method["status"]["kind"] == "computed";
        assert_eq!(method["beyond_scope"].is_string(), computed && id.starts_with("api650"), "{id}");
    }
}

/// Values divided by R_w or q stand beside elastic ones: each is marked where it stands, with the factors; periods, masses and waves are
/// not divided, nor is anything under the record.
#[test]
fn divided_values_are_marked() {
    let home = tempfile::tempdir().expect("a temporary folder");
    let out = home.path().join("out");
    let tank = "examples/05_oil_tank/tank.json";
    let run = tankcheck(&["compare", tank, "--quake", QUAKE, "--out", out.to_str().expect("text")]);
    let said = String::from_utf8_lossy(&run.stdout).into_owned();
    let html = std::fs::read_to_string(out.join("report.html")).expect("a report");
    for text in [&said, &html] {
        for line in [
            "Values with †, API 650 annex E: divided by R_wi = 3.5, R_wc = 2.",
            "Values with †, EN 1998-4:2006: divided by q = 1.5.",
        ] {
            assert!(text.contains(line), "{line}");
        }
    }
    let tables: Vec<&str> = said.split("\n\n").collect();
    let row = |table: &str, title: &str| {
        let mut lines = tables.iter().filter(|t| t.lines().next().is_some_and(|head| head.contains(table)));
        let lines = lines.next().expect("a table").lines();
        lines.filter(|line| line.starts_with(title)).map(str::to_owned).collect::<String>()
    };
    // Columns under the site: housner, both of Eurocode, both of API, the engine with the spectrum of Eurocode.
    assert_eq!(row("site", "Base shear").matches('†').count(), 4, "{said}");
    assert_eq!(row("site", "Sloshing height").matches('†').count(), 0);
    assert_eq!(row("record", "Base shear").matches('†').count(), 0);
    // Elastic spectra are not divided.
    let elastic = example("05_oil_tank", |tank| tank["site"]["ec8"]["behaviour_factor"] = json!(1.0));
    let file = home.path().join("elastic.json");
    std::fs::write(&file, elastic).expect("writable");
    let run = tankcheck(&["check", file.to_str().expect("text")]);
    let said = String::from_utf8_lossy(&run.stdout).into_owned();
    assert!(said.contains("divided by R_wi") && !said.contains("divided by q"), "{said}");
}

/// A box and a cylinder of concrete whose wall is clamped to its floor: the summary says that the floor is not verified; no other tank.
#[test]
fn the_floor_is_named() {
    let home = tempfile::tempdir().expect("a temporary folder");
    let said = |name: &str, change: &dyn Fn(&mut Value)| {
        let (file, out) = (home.path().join("tank.json"), home.path().join("out"));
        std::fs::write(&file, example(name, change)).expect("writable");
        let [file, place] = [&file, &out].map(|path| path.to_str().expect("text").to_owned());
        let run = tankcheck(&["check", &file, "--out", &place]);
        let text = String::from_utf8_lossy(&run.stdout).into_owned();
        let html = std::fs::read_to_string(out.join("report.html")).unwrap_or_else(|e| panic!("{e}: {}", stderr(&run)));
        let words = "The floor is not part of this verification";
        assert_eq!(text.contains(words), html.contains(words), "{name}");
        text.contains(words)
    };
    let site = json!({ "ec8": { "ground": "B", "spectrum": 1, "ag": "0.1 g" } });
    let sited = |tank: &mut Value| tank["site"] = site.clone();
    let hinged = |tank: &mut Value| {
        tank["site"] = site.clone();
        tank["tank"]["wall_base"] = json!({ "kind": "hinged" });
    };
    assert!(said("04_concrete_strip", &sited));
    assert!(said("08_concrete_cylinder", &sited));
    assert!(!said("08_concrete_cylinder", &hinged));
    assert!(!said("05_oil_tank", &|_| {}));
}
