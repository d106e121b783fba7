//! Waves that reach a fixed roof, and the mass of a floating one on the waves.

use std::f64::consts::TAU;
use std::path::Path;

use serde_json::{Value, json};

use crate::compare::{stderr, tankcheck};

/// Results of `check` of an example with other values of its tank, its report, and the text on standard error.
fn checked(example: &str, liquid: Option<Value>, roof: Option<Value>) -> (Value, String, String) {
    let home = tempfile::tempdir().expect("a temporary folder");
    let root = Path::new(env!("CARGO_MANIFEST_DIR"));
    let text = std::fs::read_to_string(root.join(example)).expect("the example");
    let mut tank: Value = serde_json::from_str(&text).expect("JSON");
    if let Some(depth) = liquid {
        tank["liquid"]["fill_height"] = depth;
    }
    if let Some(roof) = roof {
        tank["tank"]["roof"] = roof;
    }
    let (file, out) = (home.path().join("tank.json"), home.path().join("out"));
    std::fs::write(&file, tank.to_string()).expect("written");
    let [file, folder] = [&file, &out].map(|p| p.to_str().expect("a temporary path is text"));
    let run = tankcheck(&["check", file, "--out", folder]);
    assert!(matches!(run.status.code(), Some(0 | 1 | 4)), "{}", stderr(&run));
    let read = |name: &str| std::fs::read_to_string(out.join(name)).expect("a result");
    (serde_json::from_str(&read("results.json")).expect("JSON"), read("report.html"), stderr(&run))
}

fn part(results: &Value) -> Option<&Value> {
    results["parts"].as_array()?.iter().find(|part| part["id"] == "roof_wave")
}

fn rows<'a>(part: &'a Value, table: &str) -> &'a [Value] {
    let blocks = part["blocks"].as_array().expect("a list");
    let found = blocks.iter().find(|block| block["kind"] == "table" && block["id"] == table).expect("the table");
    found["rows"].as_array().expect("a list")
}

fn close(found: &Value, wanted: f64) {
    let value = found.as_f64().expect("a number");
    assert!((value / wanted - 1.0).abs() < 1e-6, "{value} {wanted}");
}

/// The cone of 1.8 m over R = 11 m of example 12. Filled to 5 cm below the top of the wall the crests of its codes press on it, filled as it is they
/// stay below. The stopped mass has the acceleration on the method's own sheet.
#[test]
fn a_crest_above_the_freeboard_presses() {
    let example = "examples/12_water_tank/tank.json";
    assert!(part(&checked(example, None, None).0).is_none());
    let (results, report, said) = checked(example, Some(json!("9.95 m")), None);
    let part = part(&results).expect("the part");
    assert!(report.contains("Wave and roof") && said.contains("presses on the roof"), "{said}");
    let (freeboard, rise, radius) = (0.05, 1.8, 11.0);
    let methods = results["methods"].as_array().expect("a list");
    let method = methods.iter().find(|m| m["id"] == "ec8-2006" && m["excitation"] == "site").expect("the code");
    let value = |id: &str| method["quantities"][id]["value"].as_f64().expect("a number");
    let crest = value("sloshing_crest");
    assert!(crest > freeboard, "{crest}");
    let of_method = |row: &&Value| (row[1].as_f64().unwrap_or(0.0) / crest - 1.0).abs() < 1e-9;
    let row = rows(part, "at_rest").iter().find(of_method).expect("its row");
    close(&row[2], radius * (freeboard + rise) / (crest + rise));
    close(&row[3], 1000.0 * 9.80665 * (crest - freeboard));
    close(&row[4], 1.0 - freeboard / crest);
    close(&row[5], (1.0 - freeboard / crest) * value("convective_mass"));
    let steps = method["steps"].as_array().expect("a list");
    let a_i = steps.iter().find(|step| step["symbol"] == "A_i").and_then(|step| step["value"].as_f64());
    close(&row[6], (1.0 - freeboard / crest) * value("convective_mass") * a_i.expect("on the sheet"));
    let impact = &rows(part, "impact")[0];
    let [least, most] = [3, 4].map(|i| impact[i].as_f64().expect("a number"));
    assert!(least > 0.0 && most > 3.0 * least, "{least} {most}");
}

/// 400 t afloat on R = 20 m: ω² is that of the free surface over 1 + (m/ρ) k tanh kH, here of water.
#[test]
fn a_floating_roof_lengthens_the_periods() {
    let roof = json!({ "type": "floating", "mass": "400 t", "rim": "0.8 m" });
    let (results, report, said) = checked("examples/05_oil_tank/tank.json", None, Some(roof));
    let part = part(&results).expect("the part");
    assert!(report.contains("Modes under the floating roof") && said.contains("floating roof"), "{said}");
    let tank = &results["tank"];
    let number = |value: &Value| value.as_f64().expect("a number");
    let (depth, density) = (number(&tank["liquid"]["fill_height"]), number(&tank["liquid"]["density"]));
    let layer = 400e3 / (0.5 * TAU * 400.0) / density;
    for (row, root) in rows(part, "modes").iter().zip([1.841_183_781, 5.331_442_774]) {
        let k: f64 = root / 20.0;
        let free = (9.80665 * k * (k * depth).tanh()).sqrt();
        close(&row[1], TAU / free);
        close(&row[2], TAU / free * (1.0 + layer * k * (k * depth).tanh()).sqrt());
        assert!(number(&row[3]) > 0.0);
    }
}
