//! The displacement liquid as first published, and the bulk modulus of a liquid.
//!
//! Source:    [B02, 5.3.1.4, 8.1]; rows `fluid-rank` and K6 of the verification manual
//! Goal:      a penalty acts, says what it does to the waves, and is refused beside a liquid that does not rotate
//! Model:     tank 8.1 on 6 × 16 × 6 elements, 2 s of a sine
//! Expected:  K_rot = 100 kPa raises the first frequency by about 8 %; under 2 kPa the swirl of the penalty lies among the waves
//! Tolerance: stated with each value

use std::path::{Path, PathBuf};

use results::Limit;
use serde_json::{Value, json};

use crate::compare::{stderr, tankcheck};

const TANK: &str = "examples/01_broad_tank/tank.json";

/// The tank with these values at paths, in a folder, with a record.
fn written(home: &Path, changes: &[(&str, Value)]) -> [PathBuf; 2] {
    let text = std::fs::read_to_string(Path::new(env!("CARGO_MANIFEST_DIR")).join(TANK)).expect("an example");
    let mut document: Value = serde_json::from_str(&text).expect("JSON");
    for (path, value) in changes {
        let mut place = &mut document;
        for key in path.split('.') {
            place = &mut place[key];
        }
        *place = value.clone();
    }
    let (tank, quake) = (home.join("tank.json"), home.join("quake.csv"));
    std::fs::write(&tank, document.to_string()).expect("writable");
    let lines: String =
        (0..100).map(|i| format!("{:.2},{:.5}\n", 0.02 * f64::from(i), (0.06 * f64::from(i)).sin())).collect();
    std::fs::write(&quake, format!("time_s,acceleration_m_s2\n{lines}")).expect("writable");
    [tank, quake]
}

/// The limits of a run of an engine.
fn limits(changes: &[(&str, Value)], engine: &[&str]) -> Vec<Limit> {
    let home = tempfile::tempdir().expect("a temporary folder");
    let [tank, quake] = written(home.path(), changes);
    let out = home.path().join("out");
    let [tank, quake, folder] = [&tank, &quake, &out].map(|p| p.to_str().expect("text"));
    let mut command = vec!["compare", tank, "--quake", quake, "--no-mesh-error", "--no-report", "--out", folder];
    command.extend(engine);
    let run = tankcheck(&command);
    assert!(matches!(run.status.code(), Some(0 | 1 | 4)), "{}", stderr(&run));
    results::read(&out).expect("results").runs.into_iter().flat_map(|run| run.limits).collect()
}

const PRINTED: [&str; 6] = ["--fe", "solid", "--liquid", "displacement", "--mesh", "6x16x6"];

fn of<'a>(limits: &'a [Limit], id: &str) -> &'a Limit {
    limits.iter().find(|limit| limit.id == id).unwrap_or_else(|| panic!("no limit {id}"))
}

#[test]
fn a_large_penalty_raises_the_waves() {
    let found = limits(&[("analysis.solid.rotation_penalty", json!("100 kPa"))], &PRINTED);
    let raised = of(&found, "rotation_penalty_raises_waves");
    // The rigid tank has 1.077 on 12 × 16 × 19; the coarser mesh resists a little more.
    assert!(!raised.holds && (1.06..1.12).contains(&raised.value), "{raised:?}");
    assert!(raised.note.contains("rotation_penalty"));
    // 3.8317/1.83 m √(100 kPa/2ρ)/2π, the mean of both densities in use: 14.81 rad/s at 1000 kg/m³.
    let swirl = of(&found, "rotation_modes_among_waves");
    assert!(swirl.holds && (swirl.limit * std::f64::consts::TAU / 14.81 - 1.0).abs() < 0.02, "{swirl:?}");
}

#[test]
fn a_small_penalty_has_modes_among_the_waves() {
    let found = limits(&[("analysis.solid.rotation_penalty", json!("2 kPa"))], &PRINTED);
    assert!(!of(&found, "rotation_modes_among_waves").holds);
}

#[test]
fn the_default_element_has_no_penalty_to_judge() {
    let found = limits(&[], &PRINTED);
    assert!(!found.iter().any(|limit| limit.id.starts_with("rotation_")));
}

#[test]
fn a_penalty_beside_a_potential_is_refused() {
    let home = tempfile::tempdir().expect("a temporary folder");
    let [tank, quake] = written(home.path(), &[("analysis.solid.rotation_penalty", json!("100 kPa"))]);
    let [tank, quake] = [&tank, &quake].map(|p| p.to_str().expect("text"));
    let run = tankcheck(&["compare", tank, "--quake", quake, "--fe", "solid"]);
    let text = stderr(&run);
    assert_eq!(run.status.code(), Some(2), "{text}");
    for word in ["analysis.solid.rotation_penalty", "potential", "--liquid displacement", "1 fault"] {
        assert!(text.contains(word), "{word}: {text}");
    }
    // With the liquid of the command line it runs.
    let run =
        tankcheck(&["modes", tank, "--fe", "solid", "--liquid", "displacement", "--mesh", "6x16x6", "--count", "1"]);
    assert_eq!(run.status.code(), Some(0), "{}", stderr(&run));
    let said = String::from_utf8_lossy(&run.stdout).into_owned();
    assert!(said.contains("raises the frequencies of the waves"), "{said}");
}

#[test]
fn values_out_of_range_are_refused_with_their_place() {
    for (path, value, word) in [
        ("analysis.solid.rotation_penalty", json!("0 kPa"), "1 Pa"),
        ("analysis.solid.rotation_penalty", json!(100), "unit"),
        ("liquid.bulk_modulus", json!("2.06 kPa"), "10 MPa"),
    ] {
        let home = tempfile::tempdir().expect("a temporary folder");
        let [tank, _] = written(home.path(), &[(path, value)]);
        let run = tankcheck(&["check", tank.to_str().expect("text")]);
        let text = stderr(&run);
        assert_eq!(run.status.code(), Some(2), "{text}");
        assert!(text.contains(path) && text.contains(word), "{word}: {text}");
    }
}

/// A liquid ten times softer than water: c = √(K/ρ) in the limit of compressibility.
#[test]
fn the_bulk_modulus_is_that_of_the_limit() {
    let found = limits(&[("liquid.bulk_modulus", json!("0.2 GPa"))], &["--fe", "harmonic"]);
    let soft = of(&found, "compressibility");
    let water = limits(&[], &["--fe", "harmonic"]);
    let water = of(&water, "compressibility");
    assert!(soft.limit < 0.33 * water.limit, "{soft:?} {water:?}");
    assert!(water.name.contains("c = 1435 m/s") && !soft.name.contains("1435"), "{} {}", water.name, soft.name);
}
