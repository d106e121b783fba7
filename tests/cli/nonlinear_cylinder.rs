//! `compare --fe nonlinear` of a cylinder, as a command: to its end, interrupted, resumed.

#![cfg(unix)]

use std::path::{Path, PathBuf};
use std::process::{Child, Command, Stdio};
use std::time::Duration;

use results::nonlinear::End;
use results::{EngineId, Results, read};

use super::bad_tank::has;

/// A small tank of concrete on a coarse mesh, with a checkpoint every second of computing.
const TANK: &str = r#"{
  "name": "small",
  "tank": {
    "shape": "cylinder", "radius": "5 m", "support": "anchored",
    "courses": [ { "height": "5 m", "layers": [
      { "kind": "shell", "thickness": "15 cm", "material": "concrete", "reinforcement": [
        { "direction": "hoop", "area": "5 cm2/m", "from_outer": "4 cm", "material": "bars" },
        { "direction": "vertical", "area": "5 cm2/m", "from_inner": "4 cm", "material": "bars" }
      ] }
    ] } ]
  },
  "liquid": { "density": "1000 kg/m3", "fill_height": "4.5 m" },
  "materials": {
    "concrete": { "grade": "C30/37", "behaviour": { "concrete": { "tensile_strength": "0.4 MPa", "crack_spacing": "15 cm" } } },
    "bars": { "grade": "BSt500" }
  },
  "analysis": { "nonlinear": {
    "elements": { "height": 4, "circumference": 8 }, "time_step": "5 ms", "integration": { "concrete": "midpoint 8" },
    "checkpoint": "1 s", "after_record": "none"
  } }
}
"#;

/// The tank, and shaking that grows for five seconds, in steps of 0.02 s.
fn files(folder: &Path) -> [PathBuf; 2] {
    let [tank, record] = ["tank.json", "record.csv"].map(|name| folder.join(name));
    std::fs::write(&tank, TANK).expect("writable");
    let line = |i: i32| {
        let time = 0.02 * f64::from(i);
        format!("{time:.2},{:.5}\n", time.min(5.0) * (9.0 * time).sin())
    };
    let lines: String = (0..=SAMPLES).map(line).collect();
    std::fs::write(&record, format!("time_s,acceleration_m_s2\n{lines}")).expect("writable");
    [tank, record]
}

/// Steps of the record.
const SAMPLES: i32 = 400;

fn start(folder: &Path, out: &str, more: &[&str]) -> Child {
    let [tank, record] = files(folder);
    Command::new(env!("CARGO_BIN_EXE_tankcheck"))
        .args(["compare".as_ref(), tank.as_os_str(), "--quake".as_ref(), record.as_os_str()])
        .args(["--fe", "nonlinear", "--no-mesh-error", "--out", out])
        .args(more)
        .current_dir(folder)
        .stdout(Stdio::piped())
        .stderr(Stdio::piped())
        .spawn()
        .expect("tankcheck runs")
}

/// Exit code and standard error.
fn end(run: Child) -> (Option<i32>, String) {
    let output = run.wait_with_output().expect("ends");
    (output.status.code(), String::from_utf8_lossy(&output.stderr).into_owned())
}

/// A linear peak after the end of the nonlinear run is marked.
fn marked(whole: &Results, table: &str) {
    let fe = whole.reference().expect("the linear engine");
    let late = fe.histories.iter().any(|s| s.id.starts_with("wave_height") && s.time > 8.0);
    let row = table.lines().find(|l| l.starts_with("Sloshing height")).expect("a row");
    assert_eq!(row.ends_with('*'), late, "{table}");
    assert_eq!(table.contains("fe-nonlinear ends at 8.00 s"), late, "{table}");
}

fn results(folder: &Path, out: &str) -> (Results, String) {
    let out = folder.join(out);
    let series = std::fs::read_to_string(out.join("series.csv")).expect("series");
    (read(&out).expect("results"), series)
}

#[test]
fn resumed_is_uninterrupted() {
    let home = tempfile::tempdir().expect("a temporary folder");
    let home = home.path();
    let output = start(home, "whole", &[]).wait_with_output().expect("ends");
    let (code, message) = (output.status.code(), String::from_utf8_lossy(&output.stderr));
    assert!(matches!(code, Some(0 | 1 | 4)), "{code:?} {message}");
    has(&message, &["nonlinear run of 8 s: starts", "report: whole/report.html"]);
    assert!(!home.join("whole.checkpoint").exists());
    let (whole, series) = results(home, "whole");
    marked(&whole, &String::from_utf8_lossy(&output.stdout));
    let run = whole.beside(EngineId::Nonlinear).expect("a nonlinear run");
    assert_eq!(run.end, End::Completed);
    assert!(run.events.iter().any(|e| e.kind == results::nonlinear::EventKind::FirstCrack), "{:?}", run.events);

    // Interrupted as soon as there is a checkpoint.
    let mut part = start(home, "part", &[]);
    let checkpoint = home.join("part.checkpoint");
    while !checkpoint.exists() {
        assert!(part.try_wait().expect("known").is_none(), "done before the first checkpoint: {:?}", end(part));
        std::thread::sleep(Duration::from_millis(20));
    }
    let sent = Command::new("kill").args(["-INT", &part.id().to_string()]).status();
    assert!(sent.expect("kill exists").success());
    let (code, message) = end(part);
    assert_eq!(code, Some(3), "{message}");
    has(
        &message,
        &[
            "interrupted: writing the finished part",
            "checkpoint: part.checkpoint; repeat the command with --resume to continue",
        ],
    );
    let (unfinished, _) = results(home, "part");
    assert!(unfinished.verdict.unfinished);

    // A spoiled one is refused before the run, and kept.
    let sound = std::fs::read(&checkpoint).expect("readable");
    std::fs::write(&checkpoint, &sound[..sound.len() / 2]).expect("writable");
    let (code, message) = end(start(home, "part", &["--resume"]));
    assert_eq!(code, Some(2), "{message}");
    has(&message, &["part.checkpoint", "truncated", "remove --resume to start over"]);
    assert!(!message.contains("resumes from"), "{message}");
    std::fs::write(&checkpoint, &sound).expect("writable");
    // So is that of another input.
    let other = TANK.replace("5 ms", "4 ms");
    std::fs::write(home.join("other.json"), other).expect("writable");
    let refused = Command::new(env!("CARGO_BIN_EXE_tankcheck"))
        .args(["compare", "other.json", "--quake", "record.csv", "--fe", "nonlinear", "--no-mesh-error"])
        .args(["--out", "part", "--resume"])
        .current_dir(home)
        .output()
        .expect("tankcheck runs");
    let message = String::from_utf8_lossy(&refused.stderr);
    assert_eq!(refused.status.code(), Some(2), "{message}");
    has(&message, &["part.checkpoint cannot be used: of another run", "help: omit --resume"]);
    assert_eq!(std::fs::read(&checkpoint).expect("kept"), sound);

    let (code, message) = end(start(home, "part", &["--resume"]));
    assert!(matches!(code, Some(0 | 1 | 4)), "{code:?} {message}");
    has(&message, &["resumes from `part.checkpoint`"]);
    assert!(!checkpoint.exists());
    let (resumed, again) = results(home, "part");
    assert_eq!(again, series);
    assert_eq!(resumed.runs, whole.runs);
    assert_eq!(resumed.verdict, whole.verdict);
}
