//! The tanks of `tanks.json`, built to fail in one named way each, and sound ones.
//!
//! A change is the name of a part ([`part`]), or an object whose keys are paths of the tank file. Keys that are not paths: `steel` and
//! `concrete` give courses from the base up, each by its thickness [mm] or by its keys; `accept` gives gaps besides those of the base tank.

use std::sync::LazyLock;

use results::VerdictStatus::{Fails, Holds, Incomplete};
use serde::Deserialize;

use super::*;

/// A row of the table.
#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
struct Row {
    name: &'static str,
    /// `fails`, `holds` or `incomplete` with the deciding method and the limit state that comes first, `input` with the path of the fault, or
    /// `not_assessed`.
    expect: Vec<&'static str>,
    why: &'static str,
    changes: Vec<Value>,
    #[serde(default)]
    open: Vec<&'static str>,
    /// Whether a ground motion is given.
    #[serde(default)]
    shaken: bool,
    /// Amplitude of the motion under which the harmonic engine runs [m/s²].
    run: Option<f64>,
}

/// All of them.
pub(super) fn tanks() -> &'static [Tank] {
    static ALL: LazyLock<Vec<Tank>> = LazyLock::new(|| {
        let rows: Vec<Row> = serde_json::from_str(include_str!("tanks.json")).expect("a table of tanks");
        rows.into_iter().map(tank).chain(concrete::tanks()).collect()
    });
    &ALL
}

/// The one of this name.
pub(super) fn named(name: &str) -> &'static Tank {
    tanks().iter().find(|tank| tank.name == name).unwrap_or_else(|| panic!("no tank {name}"))
}

fn tank(row: Row) -> Tank {
    let verdict = |status, of: &[&'static str]| Expected::Verdict(status, of[0], of.get(1).copied().unwrap_or(ANY));
    let expected = match row.expect.split_first() {
        Some((&"fails", of)) => verdict(Fails, of),
        Some((&"holds", of)) => verdict(Holds, of),
        Some((&"incomplete", of)) => verdict(Incomplete, of),
        Some((&"input", [path])) => Expected::Input(path),
        Some((&"not_assessed", [])) => Expected::NotAssessed,
        _ => panic!("{}: {:?}", row.name, row.expect),
    };
    let tank = Tank::new(row.name, row.why, expected, row.changes.iter().flat_map(changes).collect()).open(&row.open);
    match (row.run, row.shaken) {
        (Some(amplitude), _) => tank.run(amplitude),
        (None, true) => tank.shaken(),
        (None, false) => tank,
    }
}

fn changes(change: &Value) -> Vec<Value> {
    match change {
        Value::String(name) => vec![part(name)],
        Value::Object(paths) => paths.iter().map(|(path, value)| at(path, value)).collect(),
        other => panic!("{other} is no change"),
    }
}

/// A change that many tanks have.
fn part(name: &str) -> Value {
    match name {
        "only_ec8" => only_ec8(),
        "only_api" => only_api(),
        "unanchored" => unanchored(),
        "slim" => slim(),
        "concrete" => concrete(),
        "concrete_box" => concrete_box(),
        "decides" => engine::decides(),
        // Eurocode 8 alone under a spectrum of the user.
        "own_spectrum" => json!({
            "site": { "api650": null, "ec8": { "ground": null, "spectrum": null, "ag": null } },
            "tank": { "foundation": { "kind": "soil", "shear_wave_velocity": "500 m/s" } }
        }),
        _ => panic!("no part {name}"),
    }
}

/// The change of one key.
fn at(path: &str, value: &Value) -> Value {
    let list = || value.as_array().into_iter().flatten();
    match path {
        "steel" | "concrete" => {
            json!({ "tank": { "courses": list().map(|given| course(given, path)).collect::<Vec<_>>() } })
        }
        "accept" => accept(&list().filter_map(Value::as_str).collect::<Vec<_>>()),
        path => path.rsplit('.').fold(value.clone(), |inner, key| json!({ key: inner })),
    }
}

/// A course 2.5 m high, by its thickness [mm] or by its keys.
fn course(given: &Value, material: &str) -> Value {
    let mut course = json!({ "height": "2.5 m", "material": material });
    match given {
        Value::Object(_) => merge(&mut course, given),
        thickness => course["thickness"] = json!(format!("{thickness} mm")),
    }
    course
}
