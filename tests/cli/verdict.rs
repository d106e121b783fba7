//! Tanks built to fail in one named way each, and sound ones: what the verdict says of them.
//!
//! Source:    statics by hand, in the reason of each tank
//! Goal:      no tank that its code does not let stand, and none of which something required is not known, gets `holds`; the limit
//!            state for which it was built comes first
//! Tolerance: none; the tanks are far from the limit
//!
//! All are changes of one tank ([`base`]), run through input and pipeline as `check` does, without a process of their own.

mod accepted;
mod battery;
mod concrete;
mod engine;
mod engine_bearing;
mod matrix;
mod open;
mod plates;
mod unsaid;

use std::path::Path;

use fem::progress::Silent;
use oscillator::record::Record;
use rayon::prelude::*;
use results::{EngineId, Method, Results, VerdictStatus};
use serde_json::{Value, json};
use tank::case::GroundMotion;
use tankcheck::input::read_tank;
use tankcheck::job::Job;

use crate::compare::tankcheck;

/// What must become of a tank.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Expected {
    /// A verdict, and the limit state that comes first in a deciding method: method, limit state.
    Verdict(VerdictStatus, &'static str, &'static str),
    /// Nothing was assessed.
    NotAssessed,
    /// The input is refused; the path of the fault in `tank.json`.
    Input(&'static str),
}

/// A tank of the battery.
#[derive(Clone)]
struct Tank {
    /// Name, unique; the matrix refers to it.
    name: &'static str,
    /// Why it must end so.
    why: &'static str,
    expected: Expected,
    /// Changes of the base tank, in this order.
    changes: Vec<Value>,
    /// Limit states that are not accepted.
    open: Vec<&'static str>,
    /// Whether a ground motion is given.
    record: bool,
    /// Amplitude of the ground motion [m/s²].
    amplitude: f64,
    /// Number of its samples, every 0.05 s, and its shape by the number of the sample.
    motion: (u32, fn(f64) -> f64),
    /// Engines that run under it.
    engines: &'static [EngineId],
}

impl Tank {
    fn new(name: &'static str, why: &'static str, expected: Expected, changes: Vec<Value>) -> Tank {
        Tank {
            name,
            why,
            expected,
            changes,
            open: Vec::new(),
            record: false,
            amplitude: 0.5,
            motion: (40, |k| (0.7 * k).sin()),
            engines: &[],
        }
    }

    /// The same tank with these limit states not accepted.
    fn open(self, open: &[&'static str]) -> Tank {
        Tank { open: open.to_vec(), ..self }
    }

    /// Whether its verdict must be that it holds.
    fn holds(&self) -> bool {
        matches!(self.expected, Expected::Verdict(VerdictStatus::Holds, ..))
    }

    /// The same tank under a ground motion.
    fn shaken(self) -> Tank {
        Tank { record: true, ..self }
    }

    /// The same tank in the harmonic engine under a ground motion of this amplitude [m/s²].
    fn run(self, amplitude: f64) -> Tank {
        Tank { amplitude, engines: &[EngineId::Harmonic], ..self.shaken() }
    }

    fn json(&self) -> String {
        let mut file = base();
        for change in &self.changes {
            merge(&mut file, change);
        }
        if let Some(accepted) = file["accepted"].as_array_mut() {
            accepted.retain(|gap| !self.open.iter().any(|id| gap["check"] == *id));
        }
        file.to_string()
    }

    /// Results of the procedures, or the refusal of the input.
    fn results(&self, home: &Path) -> Result<Results, String> {
        let path = home.join("tank.json");
        std::fs::write(&path, self.json()).expect("writable");
        let tank = read_tank(&path).map_err(|error| error.to_string())?;
        let (decide, site) = (&tank.decision.decide, &tank.case.site);
        let procedures = tankcheck::pipeline::procedures::select_procedures(&tank.procedures, decide, site)
            .map_err(|error| error.to_string())?;
        let mut job = Job { engines: self.engines.to_vec(), ..Job::of(tank, procedures) };
        if self.record {
            let (samples, shape) = self.motion;
            let horizontal = Record {
                name: "pulse".into(),
                dt: 0.05,
                acceleration: (0..samples).map(|k| self.amplitude * shape(f64::from(k))).collect(),
                processing: Vec::new(),
            };
            job.raw_records = vec![horizontal.clone()];
            job.case.ground_motion = Some(GroundMotion { horizontal, transverse: None, vertical: None });
        }
        let outcome = tankcheck::pipeline::run(&job, &Silent).map_err(|error| error.to_string())?;
        Ok(outcome.results)
    }

    /// What is wrong with the verdict on it; none if all is as expected.
    fn fault(&self, home: &Path) -> Option<String> {
        let found = self.results(home);
        let wrong = |what: String| Some(format!("{}: {what}; expected {:?}: {}", self.name, self.expected, self.why));
        match (self.expected, found) {
            (Expected::Input(path), Err(error)) => {
                if error.contains(path) {
                    None
                } else {
                    wrong(error)
                }
            }
            (Expected::Input(_), Ok(results)) => wrong(format!("the verdict {:?}", results.verdict.status)),
            (_, Err(error)) => wrong(error),
            (Expected::NotAssessed, Ok(results)) => match results.verdict.status {
                VerdictStatus::NotAssessed => None,
                status => wrong(format!("the verdict {status:?}")),
            },
            (Expected::Verdict(status, method, first), Ok(results)) => {
                let deciding = deciding(&results).find(|m| m.id == method);
                let checks = deciding.map(|m| m.checks.as_slice()).unwrap_or_default();
                let found = checks.first().map_or("no check", |check| check.limit_state.as_str());
                // Of a sound tank the one with the largest utilisation.
                let found = match status {
                    VerdictStatus::Holds => {
                        let holds = checks.iter().find(|check| check.compared());
                        holds.map_or("no comparison", |check| check.limit_state.as_str())
                    }
                    _ => found,
                };
                let same = first == ANY || found == first;
                match results.verdict.status == status && same {
                    true => None,
                    false => wrong(format!("{:?}, {found} first", results.verdict.status)),
                }
            }
        }
    }
}

/// Any limit state with a comparison.
const ANY: &str = "";

fn deciding(results: &Results) -> impl Iterator<Item = &Method> {
    let decides = |m: &&Method| {
        let mut deciding = results.verdict.deciding.iter();
        deciding.any(|d| d.method == m.id && d.excitation == m.excitation)
    };
    results.methods.iter().filter(decides)
}

/// Limit states that no procedure implements for a cylinder, or that are for pipes, ground and records: accepted in the base tank.
const ACCEPTED: [&str; 16] = [
    "wall_tension_and_bending",
    "wall_shear",
    "crack_width",
    "uplift",
    "sliding",
    "bearing",
    "pipes",
    "damage_limitation",
    "upper_compression",
    "annulus_width",
    "anchor_attachment",
    "foundation",
    "piping",
    "connections",
    "shell_support",
    "ground_motion",
];

/// An accepted gap.
fn gap(check: &str) -> Value {
    json!({
        "check": check,
        "reason": "checked apart in the statics of the tank",
        "by": "J. Doe",
        "date": "2026-03-14"
    })
}

/// A sound tank: steel cylinder of 10 m radius and height with four courses, anchored, 8.5 m of water (83.4 kPa at the bottom), weak
/// earthquakes of both codes; what is not implemented is accepted.
fn base() -> Value {
    let mut file = json!({
        "name": "battery",
        "tank": {
            "shape": "cylinder",
            "radius": "10 m",
            "support": "anchored",
            "internals": "none",
            "adjacent_structures": "none",
            "roof": "none",
            "foundation": "none",
            "bottom": { "thickness": "8 mm", "material": "steel" },
            "anchors": { "count": 40, "capacity": "200 kN" }
        },
        "liquid": { "density": "1000 kg/m3", "fill_height": "8.5 m" },
        "materials": {
            "steel": {
                "youngs_modulus": "210 GPa",
                "poisson_ratio": 0.3,
                "density": "7850 kg/m3",
                "yield_strength": "235 MPa",
                "allowable_stress": "137 MPa"
            },
            "concrete": { "youngs_modulus": "33 GPa", "poisson_ratio": 0.2, "density": "2500 kg/m3" }
        },
        "site": {
            "ec8": { "ground": "B", "spectrum": 1, "ag": "0.1 g" },
            "api650": { "ss": 0.3, "s1": 0.1, "site_class": "C", "sug": 3, "tl": 4.0 }
        },
        "accepted": ACCEPTED.map(gap)
    });
    merge(&mut file, &wall(&[14.0, 12.0, 10.0, 10.0]));
    file
}

/// Merges a change into a file: objects key by key, `null` removes a key, all else replaces.
pub(crate) fn merge(file: &mut Value, change: &Value) {
    match (file, change) {
        (Value::Object(file), Value::Object(change)) => {
            for (key, value) in change {
                match value {
                    Value::Null => {
                        file.remove(key);
                    }
                    _ => merge(file.entry(key.clone()).or_insert(Value::Null), value),
                }
            }
        }
        (file, change) => *file = change.clone(),
    }
}

/// A wall of courses 2.5 m high.
///
/// * `thicknesses`: from the base up [mm]
fn courses(thicknesses: &[f64], material: &str) -> Value {
    let course = |t: &f64| json!({ "height": "2.5 m", "thickness": format!("{t} mm"), "material": material });
    json!({ "tank": { "courses": thicknesses.iter().map(course).collect::<Vec<_>>() } })
}

/// Courses of steel [mm].
fn wall(thicknesses: &[f64]) -> Value {
    courses(thicknesses, "steel")
}

/// Eurocode 8 alone.
fn only_ec8() -> Value {
    json!({ "site": { "api650": null } })
}

/// API 650 alone.
fn only_api() -> Value {
    json!({ "site": { "ec8": null } })
}

fn unanchored() -> Value {
    json!({ "tank": { "support": "unanchored", "anchors": null } })
}

/// Anchors of another capacity [kN].
fn anchors(capacity: f64) -> Value {
    json!({ "tank": { "anchors": { "capacity": format!("{capacity} kN") } } })
}

fn filled(metres: f64) -> Value {
    json!({ "liquid": { "fill_height": format!("{metres} m") } })
}

/// A cylinder of 3 m radius with strong anchors.
fn slim() -> Value {
    let mut tank = wall(&[6.0, 5.0, 4.0, 4.0]);
    merge(&mut tank, &json!({ "tank": { "radius": "3 m" } }));
    merge(&mut tank, &anchors(2000.0));
    tank
}

/// Walls of concrete, 25 cm.
fn concrete() -> Value {
    courses(&[250.0; 4], "concrete")
}

/// A box 20 m x 10 m of concrete, 40 cm, 5 m high, 4 m of water.
fn concrete_box() -> Value {
    let mut tank = courses(&[400.0; 2], "concrete");
    let shape = json!({ "shape": "rectangle", "radius": null, "length": "20 m", "breadth": "10 m", "anchors": null });
    for (key, value) in shape.as_object().into_iter().flatten() {
        // As they are: null removes a key of the base tank.
        tank["tank"][key] = value.clone();
    }
    merge(&mut tank, &filled(4.0));
    tank
}

/// More accepted gaps than those of the base tank.
fn accept(more: &[&str]) -> Value {
    let all = ACCEPTED.iter().chain(more);
    json!({ "accepted": all.map(|check| gap(check)).collect::<Vec<_>>() })
}

/// Runs all tanks that must hold, or all that must not.
fn each(holds: bool, least: usize) {
    let tanks: Vec<&Tank> = battery::tanks().iter().filter(|tank| tank.holds() == holds).collect();
    assert!(tanks.len() >= least, "{}", tanks.len());
    let fault = |tank: &&Tank| tank.fault(tempfile::tempdir().expect("a temporary folder").path());
    let faults: Vec<String> = tanks.par_iter().filter_map(fault).collect();
    assert!(faults.is_empty(), "{}", faults.join("\n"));
}

#[test]
fn each_failing_tank_fails_in_its_way() {
    each(false, 150);
}

#[test]
fn sound_tanks_hold() {
    each(true, 40);
}

#[test]
fn names_are_unique() {
    let names: Vec<&str> = battery::tanks().iter().map(|tank| tank.name).collect();
    let unique: std::collections::BTreeSet<_> = names.iter().collect();
    assert_eq!(unique.len(), names.len());
}

/// A misspelt gap is no gap: the limit state stays open, and a warning names the entry.
#[test]
fn an_unused_acceptance_is_named() {
    let home = tempfile::tempdir().expect("a temporary folder");
    let tank =
        Tank::new("misspelt", "", Expected::NotAssessed, vec![only_ec8(), accept(&["slidding"])]).open(&["sliding"]);
    let results = tank.results(home.path()).expect("the input is good");
    assert_eq!(results.verdict.status, VerdictStatus::Incomplete);
    let named = results.warnings.iter().any(|warning| warning.contains("`slidding`"));
    assert!(named, "{:?}", results.warnings);
}

/// A code of the site that fails is named where the user lets another one decide; one that holds is not.
#[test]
fn a_code_that_fails_and_does_not_decide_is_named() {
    let home = tempfile::tempdir().expect("a temporary folder");
    let path = home.path().join("tank.json");
    let decide = |id: &str| json!({ "procedures": { "decide": [id] } });
    let sound = battery::named("sound-both-codes");
    let mut shaken = sound.clone();
    shaken.changes.push(json!({ "site": { "ec8": { "ag": "0.6 g" } } }));
    for (tank, id, other, named) in [
        (&shaken, "api650-2020", "ec8-2006", true),
        (sound, "api650-2020", "ec8-2006", false),
        (sound, "ec8-2006", "api650-2020", false),
    ] {
        let mut tank = tank.clone();
        tank.changes.push(decide(id));
        std::fs::write(&path, tank.json()).expect("writable");
        let path = path.to_str().expect("a temporary path is text");
        let text = tankcheck(&["check", path]).stdout;
        let line = format!("Not deciding by `procedures.decide`: {other} (site)");
        assert_eq!(String::from_utf8_lossy(&text).contains(&line), named, "{} {id}", tank.name);
        let json: Value =
            serde_json::from_slice(&tankcheck(&["check", path, "--format", "json"]).stdout).expect("JSON");
        let overruled = json["verdict"]["overruled"].as_array().expect("a list");
        assert_eq!(overruled.iter().any(|code| code["method"] == other), named);
    }
}

/// Exit codes of the four verdicts and of bad input.
#[test]
fn exit_codes() {
    let home = tempfile::tempdir().expect("a temporary folder");
    let path = home.path().join("tank.json");
    for (name, code) in [
        ("sound-both-codes", 0),
        ("hoop-bottom-course", 1),
        ("behaviour-factor-out-of-range", 2),
        ("anchors-missing", 4),
        ("superseded-codes-only", 4),
    ] {
        std::fs::write(&path, battery::named(name).json()).expect("writable");
        let output = tankcheck(&["check", path.to_str().expect("a temporary path is text")]);
        assert_eq!(output.status.code(), Some(code), "{name}");
    }
}
