//! `tankcheck ida`: files, resumed runs, rejected input.

use std::path::{Path, PathBuf};

use crate::compare::{stderr, tankcheck};

const TANK: &str = "examples/06_sandwich_strip/tank.json";

/// A second of shaking at 8 Hz, strong enough to crack the wall at full scale, and beside it the tank without free vibration after it.
fn record(folder: &Path) -> PathBuf {
    let tank = std::fs::read_to_string(TANK).expect("readable");
    let short = tank.replacen("\"nonlinear\": {", "\"nonlinear\": { \"after_record\": \"none\",", 1);
    assert_ne!(short, tank);
    std::fs::write(folder.join("strip.json"), short).expect("writable");
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
    let tank = record.with_file_name("strip.json");
    let [tank, record] = [&tank, record].map(|path| path.to_str().expect("a plain path"));
    let mut command = vec!["ida", tank, "--quake", record];
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
    assert!((moment / (1e4 * 2.57_f64.powi(3) / 6.0) - 1.0).abs() < 2.5e-3, "{moment}");
    assert!(rest["first_crack"].is_null() && rest["wave"].as_f64().expect("a number") < 1e-9);
    for name in ["ida.csv", "report.html", "figures/ida_wave.svg"] {
        assert!(parts.join(name).exists(), "{name}");
    }
    assert!(!parts.join("unfinished").exists());
    let resumed = run(&record, "0,1", &parts, &["--quiet", "--resume"]);
    assert_eq!(resumed.status.code(), Some(0), "{}", stderr(&resumed));
    let once = run(&record, "0,1", &whole, &["--quiet"]);
    assert_eq!(once.status.code(), Some(0), "{}", stderr(&once));
    assert_eq!(runs(&parts), runs(&whole));
    assert_eq!(runs(&whole).len(), 2);
    // Other scales keep the existing files.
    let other = run(&record, "0", &parts, &["--quiet", "--resume"]);
    assert_eq!(other.status.code(), Some(0), "{}", stderr(&other));
    assert_eq!(runs(&parts), runs(&whole));
    // Neither does a damaged checkpoint; the message gives the remedy.
    let work = parts.join("unfinished");
    std::fs::create_dir(&work).expect("writable");
    std::fs::write(work.join("work.json"), "").expect("writable");
    std::fs::write(work.join("checkpoint-0.5"), "nothing").expect("writable");
    let refused = run(&record, "0,0.5,1", &parts, &["--resume"]);
    assert_eq!(refused.status.code(), Some(2), "{}", stderr(&refused));
    let message = stderr(&refused);
    assert!(message.contains("checkpoint-0.5") && message.contains("remove the file"), "{message}");
    assert_eq!(runs(&parts), runs(&whole));
    // The page is complete in itself, and no folder of a comparison.
    let report = tankcheck(&["report", parts.to_str().expect("a plain path")]);
    assert_eq!(report.status.code(), Some(2), "{}", stderr(&report));
    assert!(stderr(&report).contains("tankcheck ida"), "{}", stderr(&report));
    let moved = runs(&whole)[1]["wall_displacement"].as_f64().expect("a number");
    assert!(moved > rest["wall_displacement"].as_f64().expect("a number"));
}

/// Runs the analysis at scale 0; returns its `ida.json`.
fn at_rest(pulse: &Path, out: &Path) -> String {
    let first = run(pulse, "0", out, &["--quiet"]);
    assert_eq!(first.status.code(), Some(0), "{}", stderr(&first));
    std::fs::read_to_string(out.join("ida.json")).expect("ida.json")
}

#[test]
fn another_analysis_is_not_resumed_and_nothing_is_lost() {
    let home = tempfile::tempdir().expect("a temporary folder");
    let (pulse, out) = (record(home.path()), home.path().join("out"));
    let before = at_rest(&pulse, &out);
    let text = std::fs::read_to_string(&pulse).expect("readable");
    std::fs::write(&pulse, text.replacen("0.01,", "0.01,-", 1)).expect("writable");
    let other = run(&pulse, "0", &out, &["--resume"]);
    assert_eq!(other.status.code(), Some(2), "{}", stderr(&other));
    assert!(stderr(&other).contains("another tank, record, option or version"), "{}", stderr(&other));
    assert_eq!(std::fs::read_to_string(out.join("ida.json")).expect("ida.json"), before);
}

/// Ctrl-C leaves the complete results of an earlier run in place; the finished part is kept for `--resume`.
#[cfg(unix)]
#[test]
fn an_interrupted_analysis_does_not_replace_a_complete_one() {
    let home = tempfile::tempdir().expect("a temporary folder");
    let (pulse, out) = (record(home.path()), home.path().join("out"));
    let before = at_rest(&pulse, &out);
    let long = home.path().join("long.csv");
    let lines: String =
        (0..4000).map(|i| format!("{:.2},{:.6}\n", 0.01 * f64::from(i), 3.0 * (0.5 * f64::from(i)).sin())).collect();
    std::fs::write(&long, format!("time_s,acceleration_m_s2\n{lines}")).expect("writable");
    let [quake, folder] = [&long, &out].map(|p| p.to_str().expect("a plain path"));
    let child = std::process::Command::new(env!("CARGO_BIN_EXE_tankcheck"))
        .args(["ida", TANK, "--quake", quake, "--scale", "0.4,0.5,1", "--out", folder])
        .current_dir(env!("CARGO_MANIFEST_DIR"))
        .stdout(std::process::Stdio::null())
        .stderr(std::process::Stdio::piped())
        .spawn()
        .expect("tankcheck runs");
    while !out.join("unfinished/work.json").exists() {
        std::thread::sleep(std::time::Duration::from_millis(10));
    }
    std::thread::sleep(std::time::Duration::from_millis(300));
    let sent = std::process::Command::new("kill").args(["-INT", &child.id().to_string()]).status();
    assert!(sent.expect("kill exists").success());
    let output = child.wait_with_output().expect("ends");
    assert_eq!(output.status.code(), Some(3), "{}", stderr(&output));
    assert!(stderr(&output).contains("keeps the complete results"), "{}", stderr(&output));
    assert_eq!(std::fs::read_to_string(out.join("ida.json")).expect("ida.json"), before);
    let names: Vec<_> = std::fs::read_dir(home.path()).expect("readable").flatten().map(|e| e.file_name()).collect();
    assert_eq!(names.len(), 4, "{names:?}");
}

/// A rectangle that is not a strip.
#[test]
fn a_rectangle_that_is_no_strip_is_refused() {
    let home = tempfile::tempdir().expect("a temporary folder");
    let record = record(home.path());
    let (tank, out) = (home.path().join("tank.json"), home.path().join("out"));
    let strip = std::fs::read_to_string("examples/04_concrete_strip/tank.json").expect("readable");
    let whole = strip.replacen("\"strip\": true", "\"breadth\": \"4 m\"", 1);
    std::fs::write(&tank, whole).expect("writable");
    let [quake, folder, tank] = [&record, &out, &tank].map(|p| p.to_str().expect("a plain path"));
    let found = tankcheck(&["ida", tank, "--quake", quake, "--scale", "1", "--out", folder]);
    assert_eq!(found.status.code(), Some(2), "{}", stderr(&found));
    assert!(stderr(&found).contains("strips of long rectangular tanks"), "{}", stderr(&found));
    assert!(!out.exists());
}

/// A steel cylinder on a coarse mesh: without shaking the base moment is zero; shaken at twice the scale, the linear tank moves
/// twice as much, and plates of a low yield strength yield. A resumed analysis gives the numbers of an uninterrupted one.
#[test]
fn a_cylinder() {
    const TANK: &str = r#"{
      "name": "small cylinder",
      "tank": {
        "shape": "cylinder", "radius": "4 m", "support": "anchored",
        "courses": [ { "height": "4 m", "thickness": "8 mm", "material": "steel" } ]
      },
      "liquid": { "density": "1000 kg/m3", "fill_height": "3.6 m" },
      "materials": { "steel": {
        "youngs_modulus": "210 GPa", "poisson_ratio": 0.3, "density": "7850 kg/m3", "yield_strength": "60 MPa",
        "behaviour": { "steel": { "tangent_modulus": "2 GPa", "kinematic_share": 1 } }
      } },
      "analysis": { "nonlinear": { "elements": { "height": 8, "circumference": 16 }, "time_step": "2 ms", "after_record": "none" } }
    }"#;
    let home = tempfile::tempdir().expect("a temporary folder");
    let (tank, quake) = (home.path().join("tank.json"), home.path().join("short.csv"));
    std::fs::write(&tank, TANK).expect("writable");
    let mut text = String::from("time_s,acceleration_m_s2\n");
    for i in 0..=15 {
        let t = 0.01 * f64::from(i);
        text.push_str(&format!("{t:.2},{:.6}\n", 0.5 * (60.0 * t).sin()));
    }
    std::fs::write(&quake, text).expect("writable");
    let analysis = |scale: &str, out: &Path, more: &[&str]| {
        let [tank, quake, out] = [&tank, &quake, &out.to_path_buf()].map(|p| p.to_str().expect("plain").to_owned());
        let mut command: Vec<&str> =
            vec!["ida", &tank, "--quake", &quake, "--scale", scale, "--jobs", "2", "-o", &out, "--quiet"];
        command.extend(more);
        let run = tankcheck(&command);
        assert_eq!(run.status.code(), Some(0), "{}", stderr(&run));
    };
    let [parts, whole] = ["parts", "whole"].map(|name| home.path().join(name));
    analysis("0,1", &parts, &[]);
    analysis("0,1,2,40", &parts, &["--resume"]);
    analysis("0,1,2,40", &whole, &[]);
    let found = runs(&whole);
    assert_eq!(runs(&parts), found);
    let of = |i: usize, name: &str| found[i][name].as_f64().expect("a number");
    // Of ρ g H times the area of a lever of a metre.
    let scale = 1000.0 * 9.81 * 3.6 * 50.0;
    assert!(of(0, "base_moment") < 1e-6 * scale && of(0, "wave") < 1e-6);
    assert!(of(0, "wall_displacement") > 0.0 && of(0, "plastic_strain") == 0.0);
    // Geometric nonlinearity is below that.
    for name in ["base_moment", "wave"] {
        assert!((of(2, name) / of(1, name) - 2.0).abs() < 2e-2, "{name}");
    }
    assert!(of(3, "plastic_strain") > 0.0 && of(3, "hysteretic_energy") > 0.0);
    assert!(of(3, "base_moment") > of(2, "base_moment"));
    let csv = std::fs::read_to_string(whole.join("ida.csv")).expect("ida.csv");
    assert!(csv.starts_with("scale,") && csv.contains(",base_moment_nm,"));
}

/// A brittle wall almost without damping, shaken until the time integration gains energy: the run ends there, and its row is marked
/// in table, csv, json and report. Its moments stay within the section's capacity (the yield moment is 91 kNm/m); without the stop
/// it gave bars at 650 MPa and more than 700 kNm/m. A wall with strong softening is marked by its bars, and its run continues.
#[test]
fn a_run_that_leaves_its_model_is_marked() {
    let home = tempfile::tempdir().expect("a temporary folder");
    let text = std::fs::read_to_string(TANK).expect("readable");
    let coarse = text.replacen("\"height\": 40", "\"height\": 20", 1);
    let brittle = coarse.replacen("\"fracture_energy\": \"140 N/m\"", "\"brittle\": true", 1);
    assert!(coarse != text && brittle != coarse);
    let quake = home.path().join("sine.csv");
    let mut record = String::from("time_s,acceleration_m_s2\n");
    for i in 0..=30 {
        let t = 0.02 * f64::from(i);
        let a = 1.5 * 9.80665 * (16.0 * std::f64::consts::PI * t).sin() * (t / 0.5).min(1.0);
        record.push_str(&format!("{t:.2},{a:.6}\n"));
    }
    std::fs::write(&quake, record).expect("writable");
    let (tank, out) = (home.path().join("tank.json"), home.path().join("out"));
    std::fs::write(&tank, brittle).expect("writable");
    let [tank, quake, folder] = [&tank, &quake, &out].map(|p| p.to_str().expect("plain").to_owned());
    let run = tankcheck(&["ida", &tank, "--quake", &quake, "--scale", "0,1", "-o", &folder]);
    assert_eq!(run.status.code(), Some(0), "{}", stderr(&run));
    let found = runs(&out);
    assert!(found[0]["departures"].is_null());
    let marked = &found[1];
    let ids: Vec<&str> =
        marked["departures"].as_array().expect("marked").iter().map(|d| d["id"].as_str().expect("an id")).collect();
    assert!(ids.contains(&"stored_energy"), "{ids:?}");
    let number = |name: &str| marked[name].as_f64().expect("a number");
    assert!(marked["collapse"].is_null());
    for name in ["base_moment", "section_moment"] {
        assert!((80e3..130e3).contains(&number(name)), "{name} {}", number(name));
    }
    // The reaction is the sum of its parts; ten digits are kept.
    let part = |name: &str| marked["moment_parts"][name].as_f64().expect("a number");
    let sum = part("section") + part("damping") + part("inertia") + part("load");
    assert!((part("reaction") - sum).abs() < 1e-9 * sum.abs());
    assert!((part("reaction").abs() / number("base_moment") - 1.0).abs() < 1e-9);
    let table = String::from_utf8_lossy(&run.stdout).into_owned();
    let page = std::fs::read_to_string(out.join("report.html")).expect("a report");
    let csv = std::fs::read_to_string(out.join("ida.csv")).expect("ida.csv");
    let row = csv.lines().last().expect("a row");
    assert!(row.contains(" stored_energy,"), "{row}");
    for text in [&table, &page] {
        assert!(text.contains("left the model at"), "{text}");
        assert_eq!(text.matches("completed").count(), 1, "scale 0 alone");
    }
    assert!(stderr(&run).contains("gains energy"), "{}", stderr(&run));
    assert!(page.contains("gains energy") && page.contains("Runs that left the model"));
}
