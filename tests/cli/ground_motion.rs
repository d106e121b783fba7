//! Whether the records under which the engine decides stand for the spectrum of the site.
//!
//! Source:    the rule is linear in the records: of a set times s the factor is that of the set over s
//! Goal:      the factor of a set and of one record, a table in its place, two components; a failure that nobody accepts
//! Tolerance: 1e-8, the digits that a product loses

use std::fs;
use std::path::Path;

use serde_json::{Value, json};

use crate::compare::{stderr, tankcheck};

const TANK: &str = "examples/01_broad_tank/tank.json";

fn record(number: usize) -> String {
    let path = format!("examples/10_tank_farm/records/synthetic-{number:03}.csv");
    let path = fs::canonicalize(path).unwrap();
    path.to_str().unwrap().to_owned()
}

/// The tank without the gaps of its file but that of the records, decided by the engine.
fn tank(home: &Path) -> String {
    let text = fs::read_to_string(TANK).unwrap();
    let mut tank: Value = serde_json::from_str(&text).unwrap();
    tank.as_object_mut().unwrap().remove("record");
    tank["procedures"] = json!({ "decide": ["fe"] });
    tank["site"].as_object_mut().unwrap().remove("api650");
    tank["accepted"] = json!([
        { "check": "ground_motion", "reason": "as good as we have", "by": "J. Doe", "date": "2026-03-14" }
    ]);
    let path = home.join("tank.json");
    fs::write(&path, tank.to_string()).unwrap();
    path.to_str().unwrap().to_owned()
}

/// The check of a run with these arguments, and whether the gap was accepted.
fn check(home: &Path, arguments: &[&str]) -> (Value, String, Option<i32>) {
    let (tank, out) = (tank(home), home.join("out"));
    let base = ["compare", &tank, "--no-report", "--no-mesh-error", "--out", out.to_str().unwrap()];
    let run = tankcheck(&[&base[..], arguments].concat());
    assert!(matches!(run.status.code(), Some(0 | 1 | 4)), "{}", stderr(&run));
    let text = fs::read_to_string(out.join("results.json")).unwrap();
    let found: Value = serde_json::from_str(&text).unwrap();
    let methods = found["methods"].as_array().unwrap();
    let column = methods.iter().find(|m| m["id"] == "fe" && m["excitation"] == "record").unwrap();
    let checks = column["checks"].as_array().unwrap();
    let check = checks.iter().find(|c| c["id"] == "ground_motion").unwrap().clone();
    (check, stderr(&run), run.status.code())
}

/// A set file of three records.
fn set(home: &Path, factor: f64, across: Option<f64>) -> String {
    let entry = |i: usize| match across {
        None => json!({ "along": record(i) }),
        Some(_) => json!({ "along": record(i), "across": scaled(home, i, across.unwrap()) }),
    };
    let set = json!({ "name": "Three", "factor": factor, "records": [entry(1), entry(2), entry(3)] });
    let path = home.join("set.json");
    fs::write(&path, set.to_string()).unwrap();
    path.to_str().unwrap().to_owned()
}

/// A copy of a record times a factor.
fn scaled(home: &Path, number: usize, factor: f64) -> String {
    let text = fs::read_to_string(record(number)).unwrap();
    let line = |line: &str| match line.split_once(',').map(|(t, a)| (t, a.trim().parse::<f64>())) {
        Some((time, Ok(a))) if time.trim().parse::<f64>().is_ok() => format!("{time},{}", factor * a),
        _ => line.to_owned(),
    };
    let path = home.join(format!("across{number}.csv"));
    let lines: Vec<String> = text.lines().map(line).collect();
    fs::write(&path, lines.join("\n") + "\n").unwrap();
    path.to_str().unwrap().to_owned()
}

fn factor(check: &Value) -> f64 {
    check["demand"].as_f64().unwrap()
}

/// A weak set fails by its factor, whose inverse makes it hold; a failure is not accepted, and a table that it holds for changes nothing.
#[test]
fn a_weak_set_fails() {
    let home = tempfile::tempdir().unwrap();
    let home = home.path();
    let weak = set(home, 0.01, None);
    let (found, warnings, code) = check(home, &["--set", &weak]);
    assert_eq!((found["status"].as_str(), code), (Some("fails"), Some(1)));
    assert!(warnings.contains("`ground_motion` fails"), "{warnings}");
    let needed = factor(&found);
    assert!(needed > 1.0 && found["note"].as_str().unwrap().contains("too weak"), "{found}");
    let forty = set(home, 0.01 * needed / 40.0, None);
    let (found, ..) = check(home, &["--set", &forty]);
    assert!((factor(&found) / 40.0 - 1.0).abs() < 1e-8, "{found}");
    let table = home.join("weak.csv");
    fs::write(&table, "period_s,acceleration_g\n0,1e-6\n20,1e-6\n").unwrap();
    let (found, ..) = check(home, &["--set", &forty, "--target", table.to_str().unwrap()]);
    assert_eq!(found["status"], "fails");
    assert!((factor(&found) / 40.0 - 1.0).abs() < 1e-8, "{found}");
    let enough = set(home, 0.01 * needed * (1.0 + 1e-9), None);
    let (found, ..) = check(home, &["--set", &enough]);
    assert_eq!(found["status"], "holds");
    // The weaker component decides: half of the other one needs twice its factor.
    let both = set(home, 0.01 * needed, Some(0.5));
    let (found, ..) = check(home, &["--set", &both]);
    assert_eq!(found["status"], "fails");
    assert!((factor(&found) / 2.0 - 1.0).abs() < 1e-8, "{found}");
}

/// One record fails as a set does; strong enough, it is still one, which may be accepted.
#[test]
fn a_weak_record_fails() {
    let home = tempfile::tempdir().unwrap();
    let home = home.path();
    let of = |factor: f64| {
        let path = scaled(home, 1, factor);
        check(home, &["--quake", &path])
    };
    let (found, _, code) = of(0.01);
    assert_eq!((found["status"].as_str(), code), (Some("fails"), Some(1)));
    let needed = factor(&found);
    let (twice, ..) = of(0.02);
    assert!((factor(&twice) * 2.0 / needed - 1.0).abs() < 1e-6, "{twice}");
    let (found, ..) = of(0.01 * needed * (1.0 + 1e-6));
    assert_eq!(found["status"], "accepted");
    assert!(found["note"].as_str().unwrap().contains("one record is not enough"), "{found}");
}
