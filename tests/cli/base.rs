//! `tankcheck base` through the command line.

use serde_json::{Value, json};

use crate::compare::{stderr, tankcheck};

const TANK: &str = "examples/05_oil_tank/tank.json";

fn changed(home: &std::path::Path, change: impl FnOnce(&mut Value)) -> String {
    let text = std::fs::read_to_string(TANK).expect("an example");
    let mut tank: Value = serde_json::from_str(&text).expect("JSON");
    change(&mut tank);
    let file = home.join("tank.json");
    std::fs::write(&file, tank.to_string()).expect("writable");
    file.to_str().expect("a temporary path is text").to_owned()
}

fn computed(arguments: &[&str]) -> Value {
    let run = tankcheck(&[&["base"], arguments, &["--format", "json"]].concat());
    assert_eq!(run.status.code(), Some(0), "{}", stderr(&run));
    serde_json::from_slice(&run.stdout).expect("JSON")
}

fn number(value: &Value) -> f64 {
    value.as_f64().expect("a number")
}

/// The promised fields; more uplift holds more, and the wall's weight is what the rim carries at rest.
#[test]
fn strip_and_moment_are_printed() {
    let found = computed(&[TANK, "--uplift", "1mm,10mm,50mm", "--rotation", "5e-4,1e-3"]);
    let strip = found["strip"].as_array().expect("a list");
    assert_eq!(strip.len(), 3);
    for key in [
        "uplift_m",
        "hold_down_N_per_m",
        "rotation_rad",
        "rim_moment_Nm_per_m",
        "axial_force_N_per_m",
        "lifted_width_m",
        "plastic_rotation_rad",
    ] {
        assert!(strip.iter().all(|p| p[key].is_f64()), "{key}");
    }
    assert!(strip.windows(2).all(|p| number(&p[1]["hold_down_N_per_m"]) > number(&p[0]["hold_down_N_per_m"])));
    let weight = number(&found["wall_weight_N_per_m"]);
    assert!((number(&found["rest"]["hold_down_N_per_m"]) / weight + 1.0).abs() < 1e-6);
    let turns = found["moment_rotation"].as_array().expect("a list");
    for key in ["rotation_rad", "moment_Nm", "uplift_m", "toe_force_N_per_m", "toe_stress_Pa"] {
        assert!(turns.iter().all(|t| t[key].is_f64()), "{key}");
    }
    assert_eq!(found["band"].as_array().map(Vec::len), Some(3));
    assert_eq!(found["modulus_origin"], "assumed");
}

/// The foundation's modulus is used, an elastic plate holds more than one that yields, suction lowers the moment.
#[test]
fn ground_plate_and_pressure_count() {
    let home = tempfile::tempdir().expect("a temporary folder");
    let file = changed(home.path(), |tank| {
        tank["tank"]["foundation"] = json!({ "kind": "soil", "stiffness": "1e9 N/m3" });
    });
    let rotation = ["--rotation", "1e-3", "--uplift", "50mm"];
    let own = computed(&[&[file.as_str()], &rotation[..]].concat());
    assert_eq!(own["modulus_origin"], "given");
    assert!((number(&own["modulus_N_per_m3"]) / 1e9 - 1.0).abs() < 1e-12);
    let elastic = computed(&[&[file.as_str(), "--elastic"], &rotation[..]].concat());
    let force = |v: &Value| number(&v["strip"][0]["hold_down_N_per_m"]);
    assert!(force(&elastic) > force(&own));
    let sucked = computed(&[&[file.as_str(), "--bottom-pressure", "40 kPa"], &rotation[..]].concat());
    let moment = |v: &Value| number(&v["moment_rotation"][0]["moment_Nm"]);
    assert!(moment(&sucked) < moment(&own));
}

#[test]
fn bad_input_has_one_message() {
    let home = tempfile::tempdir().expect("a temporary folder");
    let said = |change: &dyn Fn(&mut Value), arguments: &[&str], words: &str| {
        let file = changed(home.path(), change);
        let run = tankcheck(&[&["base", file.as_str()], arguments].concat());
        assert_eq!(run.status.code(), Some(2), "{words}: {}", stderr(&run));
        assert!(stderr(&run).contains(words), "{words}: {}", stderr(&run));
        assert!(run.stdout.is_empty());
    };
    let keep = |_: &mut Value| {};
    said(&keep, &["--uplift", "50 kg"], "--uplift");
    said(&keep, &["--uplift", "50 m"], "--uplift");
    said(&keep, &["--uplift", "5"], "the unit is missing after `5`\n  help: ");
    said(&keep, &["--rotation=-1e-3"], "--rotation");
    said(&keep, &["--bottom-pressure", "1 MPa"], "--bottom-pressure");
    said(&|t| t["tank"]["bottom"] = Value::Null, &[], "tank.bottom");
    let with = |key: &'static str, value: Value| {
        move |t: &mut Value| {
            t["tank"]["foundation"] = json!({ "kind": "soil" });
            t["tank"]["foundation"][key] = value.clone();
        }
    };
    said(&with("friction", json!(-0.1)), &[], "tank.foundation.friction");
    said(&with("stiffness", json!("1 N/m3")), &[], "tank.foundation.stiffness");
    said(&with("shear_wave_velocity", json!("5 m/s")), &[], "tank.foundation.shear_wave_velocity");
    // Rock of 3 km/s: more than the largest stiffness.
    said(&with("shear_wave_velocity", json!("3000 m/s")), &[], "these waves give the ground under the rim");
    said(&with("thickness", json!("0.5 m")), &[], "tank.foundation.thickness");
    said(&|t| t["tank"]["bottom"]["annular_thickness"] = json!("9 mm"), &[], "tank.bottom.annular_thickness");
}

/// Heads are explained, anchors are named as left out, and a rotation without numbers has its reason. Soft ground, in which the rim sinks far,
/// has its numbers.
#[test]
fn what_is_left_out_or_missing_is_said() {
    let home = tempfile::tempdir().expect("a temporary folder");
    let file = changed(home.path(), |tank| {
        tank["tank"]["foundation"] = json!({ "kind": "soil", "stiffness": "1 MN/m3" });
        tank["tank"]["support"] = json!("anchored");
        tank["tank"]["anchors"] = json!({ "count": 36, "capacity": "120 kN" });
    });
    let run = tankcheck(&["base", &file, "--uplift", "50mm", "--rotation", "1e-3"]);
    assert_eq!(run.status.code(), Some(0), "{}", stderr(&run));
    assert!(stderr(&run).contains("`tank.anchors` are left out"), "{}", stderr(&run));
    let text = String::from_utf8_lossy(&run.stdout);
    for part in ["hold-down: pull of the plate on the wall", "toe stress: axial compression"] {
        assert!(text.contains(part), "`{part}` is missing in {text}");
    }
    assert!(!text.contains("–"), "{text}");
    let run = tankcheck(&["base", &file, "--uplift", "50mm", "--rotation", "0.05"]);
    let text = String::from_utf8_lossy(&run.stdout);
    for line in text.lines().filter(|line| line.contains("– / ")) {
        assert!(text.contains("– on ground of "), "{line} has no reason in {text}");
    }
}

/// Under a free rim strips hold up to 0.397 of the pressure at rest, 128 kPa (0.75 · 0.529, the eigenvalue of the waves); a round rim has no such limit.
#[test]
fn suction_beyond_what_strips_hold_is_a_limit() {
    let home = tempfile::tempdir().expect("a temporary folder");
    for (holds, pressure, kept) in
        [("free", "40 kPa", Some(true)), ("free", "60 kPa", Some(false)), ("round", "60 kPa", None)]
    {
        let file = changed(home.path(), |tank| tank["tank"]["roof"]["holds"] = json!(holds));
        let given = ["base", &file, "--bottom-pressure", pressure, "--rotation", "1e-3", "--format", "json"];
        let run = tankcheck(&given);
        assert_eq!(run.status.code(), Some(0), "{}", stderr(&run));
        let found: Value = serde_json::from_slice(&run.stdout).expect("JSON");
        let limit = &found["bottom_pressure_limit"];
        assert_eq!(limit["holds"].as_bool(), kept, "{limit}");
        assert_eq!(stderr(&run).contains("`tankcheck push` has shells"), kept == Some(false), "{}", stderr(&run));
        if kept.is_some() {
            assert!((number(&limit["limit"]) - 0.397).abs() < 2e-3, "{limit}");
        }
    }
}
