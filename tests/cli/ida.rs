//! `tankcheck ida`: what it writes, how it goes on, what it refuses.

use std::path::{Path, PathBuf};

use crate::compare::{stderr, tankcheck};

const TANK: &str = "examples/06_sandwich_strip/tank.json";

/// A second of shaking at 8 Hz, strong enough to crack the wall at full scale.
fn record(folder: &Path) -> PathBuf {
    let path = folder.join("pulse.csv");
    let mut text = String::from("time_s,acceleration_m_s2\n");
    for i in 0..=100 {
        let t = 0.01 * f64::from(i);
        text.push_str(&format!("{t:.2},{:.6}\n", 6.0 * (50.0 * t).sin()));
    }
    std::fs::write(&path, text).expect("writable");
    path
}

fn run(record: &Path, scale: &str, out: &Path, more: &[&str]) -> std::process::Output {
    let mut command = vec!["ida", TANK, "--quake"];
    command.push(record.to_str().expect("a plain path"));
    command.extend(["--scale", scale, "--jobs", "2", "--out"]);
    command.push(out.to_str().expect("a plain path"));
    command.extend(more);
    tankcheck(&command)
}

fn runs(out: &Path) -> Vec<serde_json::Value> {
    let text = std::fs::read_to_string(out.join("ida.json")).expect("ida.json");
    let value: serde_json::Value = serde_json::from_str(&text).expect("JSON");
    value["runs"].as_array().expect("runs").clone()
}

/// At scale 0 the wall stands still under weight and pressure: γ H³/6 with 10 kN/m³ and 2.57 m, and no crack. A resumed
/// analysis holds the same numbers as one in a single go.
#[test]
fn runs_are_written_and_resumed() {
    let home = tempfile::tempdir().expect("a temporary folder");
    let record = record(home.path());
    let [parts, whole] = ["parts", "whole"].map(|name| home.path().join(name));
    let first = run(&record, "0", &parts, &["--quiet"]);
    assert_eq!(first.status.code(), Some(0), "{}", stderr(&first));
    let rest = &runs(&parts)[0];
    let moment = rest["base_moment"].as_f64().expect("a number");
    // 9.80665 instead of 9.81 m/s²: 3.4e-4; the mesh: 2e-3 as row C10.
    assert!(
        (moment / (1e4 * 2.57_f64.powi(3) / 6.0) - 1.0).abs() < 2.5e-3,
        "{moment}"
    );
    assert!(rest["first_crack"].is_null() && rest["wave"].as_f64().expect("a number") < 1e-9);
    for name in ["ida.csv", "report.html", "figures/ida_wave.svg"] {
        assert!(parts.join(name).exists(), "{name}");
    }
    assert!(!parts.join("ida.partial.json").exists());
    let resumed = run(&record, "0,1", &parts, &["--quiet", "--resume"]);
    assert_eq!(resumed.status.code(), Some(0), "{}", stderr(&resumed));
    let once = run(&record, "0,1", &whole, &["--quiet"]);
    assert_eq!(once.status.code(), Some(0), "{}", stderr(&once));
    assert_eq!(runs(&parts), runs(&whole));
    assert_eq!(runs(&whole).len(), 2);
    let moved = runs(&whole)[1]["wall_displacement"].as_f64().expect("a number");
    assert!(moved > rest["wall_displacement"].as_f64().expect("a number"));
}

#[test]
fn another_analysis_is_not_resumed_and_nothing_is_lost() {
    let home = tempfile::tempdir().expect("a temporary folder");
    let pulse = record(home.path());
    let out = home.path().join("out");
    let first = run(&pulse, "0", &out, &["--quiet"]);
    assert_eq!(first.status.code(), Some(0), "{}", stderr(&first));
    let before = std::fs::read_to_string(out.join("ida.json")).expect("ida.json");
    let text = std::fs::read_to_string(&pulse).expect("readable");
    std::fs::write(&pulse, text.replacen("0.01,", "0.01,-", 1)).expect("writable");
    let other = run(&pulse, "0", &out, &["--resume"]);
    assert_eq!(other.status.code(), Some(2), "{}", stderr(&other));
    assert!(
        stderr(&other).contains("another tank, record, option or version"),
        "{}",
        stderr(&other)
    );
    assert_eq!(std::fs::read_to_string(out.join("ida.json")).expect("ida.json"), before);
}

#[test]
fn a_tank_that_is_no_strip_is_refused() {
    let home = tempfile::tempdir().expect("a temporary folder");
    let record = record(home.path());
    let out = home.path().join("out");
    let quake = record.to_str().expect("a plain path");
    let folder = out.to_str().expect("a plain path");
    let tank = "examples/01_broad_tank/tank.json";
    let found = tankcheck(&["ida", tank, "--quake", quake, "--scale", "1", "--out", folder]);
    assert_eq!(found.status.code(), Some(2), "{}", stderr(&found));
    assert!(
        stderr(&found).contains("strips of long rectangular tanks"),
        "{}",
        stderr(&found)
    );
    assert!(!out.exists());
}
