//! Measured values belong to a ground motion: under another one they are listed apart, never in rows, ratios and bars.

use std::path::Path;

use serde_json::{Value, json};

use crate::compare::{stderr, tankcheck};

const TANK: &str = "examples/01_broad_tank/tank.json";
const QUAKE: &str = "examples/records/elcentro.csv";

/// Results of the tank of example 01 with `motion` for its measured wave, and the text on standard error.
fn compared(motion: Option<Value>, quake: &[&str]) -> (Value, String, String) {
    let home = tempfile::tempdir().expect("a temporary folder");
    let root = Path::new(env!("CARGO_MANIFEST_DIR"));
    let text = std::fs::read_to_string(root.join(TANK)).expect("the example");
    let mut tank: Value = serde_json::from_str(&text).expect("JSON");
    let wave = &mut tank["measured"]["sloshing_height"];
    match motion {
        Some(motion) => wave["motion"] = motion,
        None => {
            wave.as_object_mut().expect("an object").remove("motion");
        }
    }
    let (file, out) = (home.path().join("tank.json"), home.path().join("out"));
    std::fs::write(&file, tank.to_string()).expect("written");
    let [file, folder] = [&file, &out].map(|p| p.to_str().expect("a temporary path is text"));
    // Without a record there are the codes alone.
    let command = if quake.is_empty() { "check" } else { "compare" };
    let run = tankcheck(&[&[command, file, "--out", folder], quake].concat());
    assert!(matches!(run.status.code(), Some(0 | 1 | 4)), "{}", stderr(&run));
    let read = |name: &str| std::fs::read_to_string(out.join(name)).expect("a result");
    let results = serde_json::from_str(&read("results.json")).expect("JSON");
    (results, read("report.html"), stderr(&run))
}

fn has_column(results: &Value) -> bool {
    let methods = results["methods"].as_array().expect("a list");
    methods.iter().any(|m| m["id"] == "measured")
}

/// Why the wave is apart; none if it is compared.
fn why(results: &Value) -> Option<Value> {
    let apart = results["comparison"]["measured_apart"].as_array()?;
    let wave = apart.iter().find(|a| a["value"]["quantity"] == "sloshing_height")?;
    Some(wave["reason"].clone())
}

/// The record of the example is another processing (0.319 g) than that of the test (0.348 g).
#[test]
fn under_another_record_a_measured_value_is_listed_apart() {
    let named = json!({ "peak": "0.348 g", "step": "0.02 s", "applied_peak": "0.5 g", "applied_step": "0.0115 s" });
    let (results, report, said) = compared(Some(named), &["--quake", QUAKE]);
    assert!(!has_column(&results));
    let reason = why(&results).expect("apart");
    assert_eq!(reason["why"], "other_motion");
    let differs = reason["differs"].as_array().expect("a list");
    assert_eq!((differs.len(), &differs[0]["key"]), (1, &json!("peak")));
    assert!(report.contains("Measured, not compared") && report.contains("peak of the record"));
    assert!(said.contains("measured, not compared: sloshing height"), "{said}");
    // Published values give no ratio either: they do not name a motion. Nothing of them is in the rows.
    let published = results["comparison"]["published_apart"].as_array().expect("a list");
    let quantities = results["comparison"]["published"].as_array().expect("a list");
    assert_eq!(published.len(), quantities.len());
    for (reason, value) in published.iter().zip(quantities) {
        assert_eq!(reason.is_null(), value["quantity"] == "sloshing_period", "{value}");
    }
    let columns = results["methods"].as_array().expect("a list").len();
    for row in results["comparison"]["rows"].as_array().expect("a list") {
        assert_eq!(row["cells"].as_array().expect("a list").len(), columns);
    }
}

#[test]
fn under_its_own_record_it_is_a_column() {
    let named = json!({ "peak": "0.3188 g", "step": "0.02 s", "duration": "31.18 s" });
    let (results, _, _) = compared(Some(named), &["--quake", QUAKE]);
    assert!(has_column(&results) && why(&results).is_none());
}

#[test]
fn without_a_named_motion_or_without_a_record_it_is_apart() {
    let (results, report, _) = compared(None, &["--quake", QUAKE]);
    assert_eq!(why(&results).expect("apart")["why"], "not_named");
    assert!(report.contains("does not say under which ground motion it was measured"));
    let named = json!({ "peak": "0.348 g", "step": "0.02 s" });
    let (results, _, _) = compared(Some(named), &[]);
    assert!(!has_column(&results));
    assert_eq!(why(&results).expect("apart")["why"], "no_record");
}
