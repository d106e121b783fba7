//! An output folder never loses files of an earlier run without a word.

use std::path::Path;
use std::process::{Command, Output};

fn tankcheck(folder: &Path, args: &[&str]) -> (Option<i32>, String) {
    let mut command = Command::new(env!("CARGO_BIN_EXE_tankcheck"));
    let Output { status, stderr, .. } = command.current_dir(folder).args(args).output().unwrap();
    (status.code(), String::from_utf8(stderr).unwrap())
}

/// Names in a folder, sorted.
fn names(folder: &Path) -> Vec<String> {
    let mut names: Vec<String> = std::fs::read_dir(folder)
        .unwrap()
        .map(|entry| entry.unwrap().file_name().to_string_lossy().into_owned())
        .collect();
    names.sort();
    names
}

const RECORD: &str = "time_s,acceleration_m_s2\n0,0\n0.02,1\n0.04,0.5\n0.06,-1\n0.08,0\n0.10,0.2\n0.12,0\n0.14,0.1\n0.16,0\n0.18,0.1\n0.2,0\n";

const COMPARE: [&str; 7] = ["compare", "tank.json", "--quake", "r.csv", "--no-mesh-error", "--out", "out"];

#[test]
fn what_an_earlier_run_left_is_kept_or_named() {
    let home = tempfile::tempdir().unwrap();
    let out = home.path().join("out");
    let run = |args: &[&str]| {
        let (code, message) = tankcheck(home.path(), args);
        assert!(matches!(code, Some(0 | 1 | 4)), "{args:?} {code:?}: {message}");
        message
    };
    std::fs::write(home.path().join("r.csv"), RECORD).unwrap();
    run(&["init", "--out", "tank.json"]);
    run(&["check", "tank.json", "--out", "out"]);
    // More files than before: nothing to say.
    let message = run(&COMPARE);
    assert!(!message.contains("T0913"), "{message}");
    let whole = names(&out);
    assert!(["report.html", "series.csv", "figures"].iter().all(|name| whole.iter().any(|n| n == name)), "{whole:?}");
    // The codes alone do not replace a run of an engine, nor does another kind of run.
    for args in [
        &["check", "tank.json", "--out", "out"][..],
        &["ida", "tank.json", "--quake", "r.csv", "--scale", "1", "--out", "out"],
        &["push", "tank.json", "--out", "out"],
        &["quake", "synth", "--target", "tank.json", "--n", "1", "--out", "out"],
    ] {
        let (code, message) = tankcheck(home.path(), args);
        assert_eq!(code, Some(2), "{args:?}: {message}");
        assert_eq!(names(&out), whole, "{args:?}");
    }
    let message = run(&["check", "tank.json"]);
    assert!(!message.contains("T0602"), "{message}");
    // A run without the record: what it replaces is said before it runs.
    std::fs::write(out.join("report.pdf"), "mine").unwrap();
    let message = run(&["compare", "tank.json", "--no-mesh-error", "--out", "out"]);
    let first = message.lines().find(|line| line.starts_with("warning[T0913]: ")).expect("a warning");
    assert!(
        first.contains("the run under the record") && first.contains("--out") && !first.contains("report.pdf"),
        "{first}"
    );
    // Of the user, and not in the manifest: it stays.
    assert_eq!(std::fs::read_to_string(out.join("report.pdf")).unwrap(), "mine");
    run(&COMPARE);
    // Fewer files: they are named.
    let message = run(&[&COMPARE[..], &["--no-report"]].concat());
    let line = message.lines().find(|line| line.starts_with("warning[T0913]: ")).expect("a warning");
    assert!(line.contains("report.html") && line.contains("figures"), "{line}");
    assert!(!out.join("report.html").exists() && out.join("series.csv").exists());
    // Units in the heads of the histories.
    let series = std::fs::read_to_string(out.join("series.csv")).unwrap();
    let head = series.lines().next().unwrap();
    assert!(head.starts_with("time_s,") && head.contains(",base_shear [N],"), "{head}");
    assert!(head.contains("ground_acceleration [m/s2]"), "{head}");
}
