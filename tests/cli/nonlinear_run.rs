//! `compare --fe nonlinear`: rejected input, checkpoints.

use std::path::Path;

use crate::compare::{stderr, tankcheck};

const TANK: &str = "examples/06_sandwich_strip/tank.json";
/// A tank for both linear engines.
const CYLINDER: &str = "examples/01_broad_tank/tank.json";
const QUAKE: &str = "examples/records/elcentro.csv";

fn text(path: &Path) -> &str {
    path.to_str().expect("a temporary path is text")
}

/// Runs a command that must be refused before anything is computed: exit code 2, all of `words`, no output folder.
fn refused(more: &[&str], out: &Path, words: &[&str]) {
    refused_for(TANK, more, out, words);
}

/// The same for another tank.
fn refused_for(tank: &str, more: &[&str], out: &Path, words: &[&str]) {
    let mut command = vec!["compare", tank, "--quake", QUAKE, "--out", text(out)];
    command.extend(more);
    let run = tankcheck(&command);
    let message = stderr(&run);
    assert_eq!(run.status.code(), Some(2), "{more:?}: {message}");
    for word in words {
        assert!(message.contains(word), "`{word}` is missing in: {message}");
    }
    assert_eq!(message.matches("error").count(), 1, "{message}");
    assert!(run.stdout.is_empty() && !out.exists(), "{more:?}");
}

#[test]
fn options_of_another_engine_are_refused() {
    let home = tempfile::tempdir().expect("a temporary folder");
    let out = home.path().join("out");
    for option in [&["--checkpoint", "x"][..], &["--resume"]] {
        refused(option, &out, &[option[0], "--fe nonlinear"]);
        let mut both = vec!["--fe", "both"];
        both.extend(option);
        refused_for(CYLINDER, &both, &out, &[option[0], "--fe nonlinear"]);
    }
    for option in [&["--mesh", "4x8x4"][..], &["--liquid", "potential"]] {
        let mut command = vec!["--fe", "nonlinear"];
        command.extend(option);
        refused(&command, &out, &[option[0], "--fe solid"]);
    }
    // A strip has a displacement liquid, a cylinder has not.
    let displacement = ["--fe", "nonlinear", "--liquid", "displacement"];
    refused_for(CYLINDER, &displacement, &out, &["displacement liquid", "strip", "--fe solid"]);
}

#[test]
fn a_place_for_the_checkpoint_is_looked_at_before_the_run() {
    let home = tempfile::tempdir().expect("a temporary folder");
    let out = home.path().join("out");
    let thesis = home.path().join("thesis.doc");
    std::fs::write(&thesis, "mine").expect("writable");
    for more in [&[][..], &["--resume"]] {
        let mut command = vec!["--fe", "nonlinear", "--checkpoint", text(&thesis)];
        command.extend(more);
        refused(&command, &out, &["thesis.doc", "is not a checkpoint"]);
    }
    assert_eq!(std::fs::read_to_string(&thesis).expect("untouched"), "mine");
    // Neither is the file of the second wall, nor that of a checkpoint that is being written.
    for name in ["out.checkpoint.theta_180", "out.checkpoint.part"] {
        let mine = home.path().join(name);
        std::fs::write(&mine, "mine").expect("writable");
        refused(&["--fe", "nonlinear"], &out, &[name, "is not a checkpoint"]);
        assert_eq!(std::fs::read_to_string(&mine).expect("untouched"), "mine");
        std::fs::remove_file(&mine).expect("writable");
    }
    refused(&["--fe", "nonlinear", "--checkpoint", text(home.path())], &out, &["is a folder"]);
    let nowhere = home.path().join("no_folder/x");
    refused(&["--fe", "nonlinear", "--checkpoint", text(&nowhere)], &out, &["does not exist", "no_folder"]);
}
