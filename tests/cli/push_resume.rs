//! `tankcheck push` killed, interrupted, resumed.

#![cfg(unix)]

use std::path::{Path, PathBuf};
use std::process::{Child, Command, Stdio};
use std::time::{Duration, SystemTime};

use results::{Push, read_push};

use super::bad_tank::has;

/// A small squat tank of steel with a checkpoint every second of computing.
const TANK: &str = r#"{
  "name": "small",
  "tank": {
    "shape": "cylinder", "radius": "4 m", "support": "anchored",
    "courses": [ { "height": "4 m", "thickness": "5 mm", "material": "steel" } ]
  },
  "liquid": { "density": "1000 kg/m3", "fill_height": "3.6 m" },
  "materials": { "steel": {
    "youngs_modulus": "210 GPa", "poisson_ratio": 0.3, "density": "7850 kg/m3", "yield_strength": "60 MPa",
    "behaviour": { "steel": { "tangent_modulus": "0 GPa", "kinematic_share": 1 } }
  } },
  "analysis": { "nonlinear": { "elements": { "height": 20, "circumference": 24 }, "checkpoint": "1 s" } }
}
"#;

/// Pushes the tank in `folder` into `out` there.
fn start(folder: &Path, out: &str, more: &[&str]) -> Child {
    std::fs::write(folder.join("tank.json"), TANK).expect("writable");
    Command::new(env!("CARGO_BIN_EXE_tankcheck"))
        .args(["push", "tank.json", "--imperfection", "0.5t", "--out", out])
        .args(more)
        .current_dir(folder)
        .stdout(Stdio::null())
        .stderr(Stdio::piped())
        .spawn()
        .expect("tankcheck runs")
}

/// Exit code and standard error.
fn end(run: Child) -> (Option<i32>, String) {
    let output = run.wait_with_output().expect("ends");
    let message = String::from_utf8_lossy(&output.stderr).into_owned();
    (output.status.code(), message)
}

/// Waits until a run has written a checkpoint, the first or another; false if it has come to its end before.
fn has_kept(run: &mut Child, checkpoint: &Path, before: Option<SystemTime>) -> bool {
    while written(checkpoint) == before {
        if run.try_wait().expect("known").is_some() {
            return false;
        }
        std::thread::sleep(Duration::from_millis(5));
    }
    true
}

fn written(checkpoint: &Path) -> Option<SystemTime> {
    checkpoint.metadata().and_then(|m| m.modified()).ok()
}

/// The fields that do not differ between identical runs.
fn results(folder: &Path, out: &str) -> Push {
    let push = read_push(&folder.join(out).join("push.json")).expect("readable");
    Push { volatile: Default::default(), ..push }
}

/// Contents of a folder.
fn entries(folder: &Path) -> Vec<String> {
    let names = std::fs::read_dir(folder).expect("readable");
    let mut names: Vec<String> =
        names.map(|e| e.expect("readable").file_name().to_string_lossy().into_owned()).collect();
    names.sort();
    names
}

/// Killed at several moments of both shells and resumed each time: the results equal those of an uninterrupted run, and no other
/// file is left. In every run `kill_battery` kills a pushover, and the engine's `a_resumed_pushover_is_the_uninterrupted_one` stops at every state.
#[test]
#[ignore = "slow: cargo test --test cli a_killed_pushover -- --ignored; last result in docs/verification/slow-tests.md"]
fn a_killed_pushover_goes_on() {
    let home = tempfile::tempdir().expect("a temporary folder");
    let home = home.path();
    let (code, message) = end(start(home, "whole", &[]));
    assert_eq!(code, Some(0), "{message}");
    has(&message, &["pushover: starts; a checkpoint every 1 s of computing"]);
    assert_eq!(entries(home), ["tank.json", "whole"]);
    let whole = results(home, "whole");
    assert_eq!(whole.shells.len(), 2);

    let checkpoint = home.join("part.checkpoint");
    let mut kills = 0;
    // Right after a checkpoint, between two, and while one may be written.
    for milliseconds in [0, 450, 990, 5, 700] {
        let before = written(&checkpoint);
        let mut run = start(home, "part", &["--resume"]);
        if !has_kept(&mut run, &checkpoint, before) {
            assert_eq!(end(run).0, Some(0));
            break;
        }
        std::thread::sleep(Duration::from_millis(milliseconds));
        if run.try_wait().expect("known").is_some() {
            assert_eq!(end(run).0, Some(0));
            break;
        }
        run.kill().expect("the run is under way");
        let (code, message) = end(run);
        assert_eq!(code, None, "{message}");
        kills += 1;
    }
    assert!(kills >= 2, "{kills} kills");
    if checkpoint.exists() {
        let (code, message) = end(start(home, "part", &["--resume"]));
        assert_eq!(code, Some(0), "{message}");
        has(&message, &["pushover: resumes from `part.checkpoint`"]);
    }
    assert_eq!(results(home, "part"), whole);
    assert_eq!(entries(home), ["part", "tank.json", "whole"]);
}

fn interrupt(run: &Child) {
    let sent = Command::new("kill").args(["-INT", &run.id().to_string()]).status();
    assert!(sent.expect("kill exists").success());
}

/// Ctrl-C keeps the finished part and prints how to continue; a checkpoint of another run is rejected and kept.
#[test]
fn an_interrupted_pushover_says_how_it_goes_on() {
    let home = tempfile::tempdir().expect("a temporary folder");
    let home = home.path();
    let checkpoint: PathBuf = home.join("mine");
    let named = ["--checkpoint", "mine"];
    let mut run = start(home, "part", &named);
    assert!(has_kept(&mut run, &checkpoint, None));
    // After the state at rest, which alone does not give results.
    let before = written(&checkpoint);
    assert!(has_kept(&mut run, &checkpoint, before));
    interrupt(&run);
    let (code, message) = end(run);
    assert_eq!(code, Some(3), "{message}");
    has(
        &message,
        &[
            "interrupted: writing the finished part",
            "incomplete: ",
            "checkpoint: mine; repeat the command with --resume to continue",
        ],
    );
    assert!(results(home, "part").incomplete);
    assert_eq!(entries(home), ["mine", "part", "tank.json"]);

    let sound = std::fs::read(&checkpoint).expect("readable");
    let refused = |more: &[&str], words: &[&str]| {
        let bytes = std::fs::read(&checkpoint).expect("readable");
        let mut all = vec!["--resume"];
        all.extend(named);
        all.extend(more);
        let (code, message) = end(start(home, "part", &all));
        assert_eq!(code, Some(2), "{message}");
        has(&message, words);
        assert_eq!(std::fs::read(&checkpoint).expect("kept"), bytes);
    };
    refused(&["--imperfection-at", "1 m"], &["mine cannot be used: of another run", "help: omit --resume"]);
    std::fs::write(&checkpoint, &sound[..sound.len() / 2]).expect("writable");
    refused(&[], &["`mine` is truncated", "remove --resume"]);
    std::fs::write(&checkpoint, "mine").expect("writable");
    refused(&[], &["`mine` is not a checkpoint"]);
    std::fs::write(&checkpoint, &sound).expect("writable");

    // Without --resume it starts over and reports it.
    let mut run = start(home, "part", &named);
    let before = written(&checkpoint);
    assert!(has_kept(&mut run, &checkpoint, before));
    interrupt(&run);
    let (code, message) = end(run);
    assert_eq!(code, Some(3), "{message}");
    has(&message, &["starts over and overwrites `mine`; use --resume to continue"]);
}
