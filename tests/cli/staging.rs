//! A tank on a staging: what its keys refuse, and that no command treats it as one on the ground.

use serde_json::{Value, json};
use tankcheck::input::diagnostic::Source;
use tankcheck::input::tank::parse;

use crate::compare::{stderr, tankcheck};

const TANK: &str = "examples/15_elevated_tank/tank.json";
const RECORD: &str = "examples/records/elcentro.csv";

/// What the file with these changes is told.
fn fault(change: impl Fn(&mut Value)) -> String {
    let path = format!("{}/{TANK}", env!("CARGO_MANIFEST_DIR"));
    let mut tank: Value = serde_json::from_str(&std::fs::read_to_string(path).unwrap()).unwrap();
    change(&mut tank["tank"]);
    let source = Source::new("tank.json", tank.to_string());
    parse(&source).expect_err("a fault").render(&source, false)
}

#[test]
fn refused_keys() {
    for (key, value, expected) in [
        (
            "kind",
            json!("frame"),
            ["tank.staging.kind", "\"rc_frame\", \"ductile_rc_frame\", \"steel_frame\" or \"rc_shaft\""],
        ),
        ("stiffness", json!("17 kN"), ["tank.staging.stiffness", "17 kN"]),
        ("stiffness", json!("1 N/m"), ["tank.staging.stiffness", "at least 1 kN/m"]),
        ("mass", json!("-1 t"), ["tank.staging.mass", "must not be negative"]),
        ("height", json!("0 m"), ["tank.staging.height", "must be positive"]),
        ("floor_mass", json!("1e9 kg"), ["tank.staging.floor_mass", "too large"]),
        ("floor_centre", json!("-40 m"), ["tank.staging.floor_centre", "at least -30 m"]),
        ("columns", json!(2), ["tank.staging.columns", "a whole number from 3 to 200"]),
        ("bracing", json!(2), ["tank.staging", "bracing"]),
    ] {
        let found = fault(|tank| tank["staging"][key] = value.clone());
        for part in expected {
            assert!(found.contains(part), "{key}: {part} is not in\n{found}");
        }
    }
    for missing in ["kind", "stiffness", "mass", "height", "floor_mass"] {
        let found = fault(|tank| drop(tank["staging"].as_object_mut().unwrap().remove(missing)));
        assert!(found.contains(missing) && found.contains("missing"), "{missing}:\n{found}");
    }
}

/// Parts of a tank on the ground contradict a staging, each at its own place.
#[test]
fn parts_of_a_tank_on_the_ground() {
    for (key, value, message) in [
        ("support", json!("unanchored"), "the container is fixed to its staging"),
        ("foundation", json!({ "kind": "slab", "thickness": "1 m" }), "has no foundation of its own"),
        ("anchors", json!({ "count": 8 }), "anchors hold a tank on the ground"),
        (
            "bottom",
            json!({ "thickness": "8 mm", "material": "concrete" }),
            "the floor of the container is tank.staging.floor_mass",
        ),
        (
            "isolators",
            json!({ "kind": "elastomer", "stiffness": "1 MN/m", "damping": 0.1 }),
            "isolators are under the slab",
        ),
    ] {
        let found = fault(|tank| tank[key] = value.clone());
        assert!(found.contains(message) && found.contains(&format!("tank.{key}")), "{key}:\n{found}");
    }
    let found = fault(|tank| {
        let tank = tank.as_object_mut().unwrap();
        tank.remove("radius");
        tank.extend(
            [("shape", json!("rectangle")), ("length", json!("6 m")), ("strip", json!(true))]
                .map(|(k, v)| (k.into(), v)),
        );
    });
    assert!(found.contains("a staging carries a whole tank, not a strip"), "{found}");
    let found = fault(|tank| tank["staging"]["kind"] = json!("rc_shaft"));
    assert!(found.contains("a shaft has no columns"), "{found}");
}

/// Each command that needs a model of the tank says why it has none; nothing is written.
#[test]
fn commands_refuse() {
    let home = tempfile::tempdir().unwrap();
    let out = home.path().join("out").to_string_lossy().into_owned();
    let compare = |fe: &'static str| vec!["compare", TANK, "--quake", RECORD, "--fe", fe, "--out", &out];
    for arguments in [
        vec!["modes", TANK],
        vec!["modes", TANK, "--fe", "solid"],
        vec!["base", TANK],
        vec!["push", TANK, "--out", &out],
        vec!["ida", TANK, "--quake", RECORD, "--scale", "0.5,1", "--out", &out],
        compare("harmonic"),
        compare("solid"),
        compare("both"),
        compare("nonlinear"),
    ] {
        let output = tankcheck(&arguments);
        let text = stderr(&output);
        assert_eq!(output.status.code(), Some(2), "{arguments:?}: {text}");
        assert!(text.contains("not applicable: the tank stands on a staging"), "{arguments:?}: {text}");
        assert!(!std::path::Path::new(&out).exists(), "{arguments:?}");
    }
}

/// `check` has the values of IS 1893-2 alone and the reason of every other procedure; `compare` without an engine named runs none and warns.
#[test]
fn codes_alone() {
    let output = tankcheck(&["check", TANK]);
    let (text, warned) = (String::from_utf8(output.stdout.clone()).unwrap(), stderr(&output));
    assert_eq!(output.status.code(), Some(1), "{text}{warned}");
    for id in ["housner", "ec8-env", "ec8-2006", "api650-1993", "api650-2020"] {
        let reason = format!("{id}: not applicable, tank.staging: the tank stands on a staging");
        assert!(text.contains(&reason), "{reason}\n{text}");
    }
    assert!(!text.contains("No foundation"), "{text}");
    let home = tempfile::tempdir().unwrap();
    let out = home.path().join("out").to_string_lossy().into_owned();
    let output = tankcheck(&["compare", TANK, "--quake", RECORD, "--out", &out]);
    assert_eq!(output.status.code(), Some(1), "{}", stderr(&output));
    assert!(
        stderr(&output).contains("`tank.staging` is known to the procedure of IS 1893-2 alone"),
        "{}",
        stderr(&output)
    );
    let solved = tankcheck(&["check", TANK, "--solve", "fill_height"]);
    assert_eq!(solved.status.code(), Some(4), "{}{}", String::from_utf8_lossy(&solved.stdout), stderr(&solved));
}
