//! `tankcheck quake set` and `quake synth`.

use std::fs;
use std::path::Path;
use std::process::{Command, Output};

fn quake(folder: &Path, arguments: &[&str]) -> Output {
    Command::new(env!("CARGO_BIN_EXE_tankcheck")).arg("quake").args(arguments).current_dir(folder).output().unwrap()
}

fn json(output: &Output) -> serde_json::Value {
    serde_json::from_slice(&output.stdout)
        .unwrap_or_else(|e| panic!("{e}: {}", String::from_utf8_lossy(&output.stderr)))
}

/// A spectrum of the form of EN 1998-1, a_g S = 0.25 g, to 4 s.
fn spectrum() -> String {
    let mut text = String::from("period_s,acceleration_g\n");
    for i in 0..=400 {
        let t = 0.01 * f64::from(i);
        let shape = match t {
            t if t < 0.15 => 1.0 + 1.5 * t / 0.15,
            t if t < 0.5 => 2.5,
            t if t < 2.0 => 2.5 * 0.5 / t,
            t => 2.5 / (t * t),
        };
        text.push_str(&format!("{t:.2},{:.8}\n", 0.25 * shape));
    }
    text
}

/// Records made for the spectrum hold after the factor of the set, and with it exactly: the smallest ratio is then 0.9 or the mean peak 1.
#[test]
fn a_set_made_for_a_spectrum_holds_with_its_factor() {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path();
    fs::write(path.join("spectrum.csv"), spectrum()).unwrap();
    let made = quake(path, &["synth", "--target", "spectrum.csv", "--n", "3", "--seed", "5", "--out", "set"]);
    assert!(made.status.success(), "{}", String::from_utf8_lossy(&made.stderr));
    let set = ["set/synthetic-001.csv", "set/synthetic-002.csv", "set/synthetic-003.csv"];
    let ask = |files: &[&str]| {
        let rule = [
            "--rule",
            "en1998-1",
            "--target",
            "spectrum.csv",
            "--period",
            "0.225s",
            "--period",
            "1.2 s",
            "--format",
            "json",
        ];
        quake(path, &[&["set"], files, &rule].concat())
    };
    let found = json(&ask(&set));
    let number = |found: &serde_json::Value, key: &str| found[key].as_f64().unwrap();
    let factor = number(&found, "factor");
    assert!((0.7..1.3).contains(&factor), "{found}");
    for key in ["smallest_ratio", "mean_zero_period_ratio"] {
        assert!(number(&found, key) > 0.0);
    }
    assert_eq!(found["periods"].as_array().unwrap().len(), 2);
    let mut scaled = Vec::new();
    for (k, name) in set.iter().enumerate() {
        let text = fs::read_to_string(path.join(name)).unwrap();
        let mut lines = text.lines();
        let mut out = format!("{}\n", lines.next().unwrap());
        for line in lines {
            let (t, a) = line.split_once(',').unwrap();
            out.push_str(&format!("{t},{}\n", a.parse::<f64>().unwrap() * factor * (1.0 + 1e-9)));
        }
        let file = format!("scaled{k}.csv");
        fs::write(path.join(&file), out).unwrap();
        scaled.push(file);
    }
    let names: Vec<&str> = scaled.iter().map(String::as_str).collect();
    let output = ask(&names);
    let again = json(&output);
    assert_eq!((again["holds"].as_bool(), output.status.code()), (Some(true), Some(0)), "{again}");
    let (ratio, zero) = (number(&again, "smallest_ratio"), number(&again, "mean_zero_period_ratio"));
    assert!((ratio - 0.9).abs() < 1e-6 || (zero - 1.0).abs() < 1e-6, "{again}");
    // Two records are too few.
    let two = ask(&names[..2]);
    assert_eq!((json(&two)["holds"].as_bool(), two.status.code()), (Some(false), Some(1)));
}

/// What `quake set` rejects, `quake synth` says at once, with the duration that is long enough. The tank is 45 m wide: its sloshing period is about
/// 7.5 s, and 20 s hold less than three of them.
#[test]
fn a_set_that_is_too_short_for_its_tank() {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path();
    let tank = r#"{
  "name": "wide tank",
  "tank": { "shape": "cylinder", "radius": "22.5 m", "support": "unanchored",
    "courses": [ { "height": "18 m", "thickness": "16 mm", "material": "steel" } ] },
  "liquid": { "density": "870 kg/m3", "fill_height": "16.2 m" },
  "materials": { "steel": { "grade": "S355" } },
  "site": { "ec8": { "ground": "C", "spectrum": 1, "ag": "0.1 g" } }
}"#;
    fs::write(path.join("tank.json"), tank).unwrap();
    let make = |seconds: &str, out: &str| {
        let made = quake(
            path,
            &["synth", "--target", "tank.json", "--n", "3", "--duration", seconds, "--strong", "12", "--out", out],
        );
        assert!(made.status.success(), "{}", String::from_utf8_lossy(&made.stderr));
        (String::from_utf8(made.stdout).unwrap(), String::from_utf8(made.stderr).unwrap())
    };
    let set = |out: &str| {
        let files: Vec<String> = (1..=3).map(|k| format!("{out}/synthetic-{k:03}.csv")).collect();
        let mut arguments = vec!["set", "--target", "tank.json", "--format", "json"];
        arguments.extend(files.iter().map(String::as_str));
        json(&quake(path, &arguments))
    };
    let (_, message) = make("20", "short");
    assert!(message.contains("T0903") && message.contains("sloshing"), "{message}");
    let found = set("short");
    assert_eq!(found["holds"], false);
    // The period is that of the procedure that decides.
    assert_eq!(found["periods"][0]["period_of"], "EN 1998-4:2006");
    let duration = message.split("--duration ").nth(1).and_then(|rest| rest.split(';').next()).unwrap();
    let (said, message) = make(duration, "long");
    assert!(message.is_empty() && said.contains("holds for tank.json"), "{said}{message}");
    assert_eq!(set("long")["holds"], true);
}

#[test]
fn bad_input_of_a_set() {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path();
    fs::write(path.join("spectrum.csv"), spectrum()).unwrap();
    fs::write(path.join("a.csv"), "time_s,acceleration_m_s2\n0,0\n0.01,1\n0.02,x\n").unwrap();
    let refused = |arguments: &[&str], wanted: &str| {
        let output = quake(path, arguments);
        let said = String::from_utf8_lossy(&output.stderr).into_owned();
        assert_eq!(output.status.code(), Some(2), "{said}");
        assert!(output.stdout.is_empty() && said.contains(wanted), "{wanted} in {said}");
    };
    refused(&["set", "a.csv", "--target", "spectrum.csv", "--period", "1 s"], "a.csv:4");
    refused(&["set", "a.csv", "--target", "spectrum.csv"], "--period is missing");
    refused(&["set", "a.csv", "--target", "spectrum.csv", "--period", "3 s"], "the table ends at 4 s");
    refused(&["set", "a.csv", "--target", "spectrum.csv", "--period", "3"], "expected a time with its unit");
    refused(&["synth", "--target", "none.csv", "--out", "set"], "none.csv");
    refused(&["synth", "--target", "spectrum.csv", "--strong", "40", "--out", "set"], "--strong");
    assert!(!path.join("set").exists());
}
