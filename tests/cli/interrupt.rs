//! Ctrl-C in every command that can run long: 130 if no results are kept, 3 if the finished part is kept; no partial files.
#![cfg(unix)]

use std::io::Read;
use std::path::Path;
use std::process::{Child, Command, ExitStatus, Stdio};
use std::time::{Duration, Instant};

const TANK: &str = "examples/01_broad_tank/tank.json";
const QUAKE: &str = "examples/records/elcentro.csv";

fn begin(arguments: &[&str]) -> Child {
    Command::new(env!("CARGO_BIN_EXE_tankcheck"))
        .args(arguments)
        .current_dir(env!("CARGO_MANIFEST_DIR"))
        .stdout(Stdio::null())
        .stderr(Stdio::piped())
        .spawn()
        .expect("tankcheck runs")
}

/// Ctrl-C once the process listens: it has a second thread then, the one that waits for signals.
fn interrupt(run: &Child) {
    let started = Instant::now();
    let tasks = format!("/proc/{}/task", run.id());
    while Path::new(&tasks).is_dir()
        && std::fs::read_dir(&tasks).map_or(2, Iterator::count) < 2
        && started.elapsed() < Duration::from_secs(120)
    {
        std::thread::sleep(Duration::from_millis(2));
    }
    std::thread::sleep(Duration::from_millis(300));
    let sent = Command::new("kill").args(["-INT", &run.id().to_string()]).status();
    assert!(sent.expect("kill exists").success());
}

/// Waits for the end, at most twenty minutes: seconds, but for a busy machine.
fn end(mut run: Child) -> (ExitStatus, String) {
    let started = Instant::now();
    loop {
        if let Some(status) = run.try_wait().expect("a child") {
            let mut text = String::new();
            if let Some(mut messages) = run.stderr.take() {
                messages.read_to_string(&mut text).expect("text");
            }
            return (status, text);
        }
        if started.elapsed() > Duration::from_secs(1200) {
            let _ = run.kill();
            panic!("does not end after Ctrl-C");
        }
        std::thread::sleep(Duration::from_millis(20));
    }
}

/// Files and folders in a folder.
fn entries(folder: &Path) -> usize {
    std::fs::read_dir(folder).map_or(0, Iterator::count)
}

/// A record of many samples.
fn long_record(home: &Path) -> String {
    let path = home.join("long.csv");
    let mut text = String::from("acceleration_g\n");
    for k in 0..400_000 {
        text.push_str(&format!("{:.5}\n", 0.1 * (0.07 * f64::from(k)).sin()));
    }
    std::fs::write(&path, text).expect("writable");
    path.to_str().expect("text").into()
}

#[test]
fn commands_that_keep_nothing_end_with_130() {
    let home = tempfile::tempdir().expect("a temporary folder");
    let long = long_record(home.path());
    let out = home.path().join("out");
    let out = out.to_str().expect("text");
    for command in [
        &["spectrum", &long, "--dt", "0.005", "--points", "40000"][..],
        &["modes", TANK, "--refine", "12"],
        &["compare", TANK, "--quake", &long, "--dt", "0.005", "--integrator", "newmark", "--out", out],
    ] {
        let run = begin(command);
        interrupt(&run);
        let (status, message) = end(run);
        assert_eq!(status.code(), Some(130), "{command:?}: {message}");
        let left: Vec<_> = std::fs::read_dir(home.path()).expect("readable").flatten().collect();
        assert_eq!(left.len(), 1, "{command:?} leaves {left:?}");
    }
}

/// The first Ctrl-C keeps the finished part (3), if there is one; the second (130) is not sent here.
#[test]
fn commands_that_keep_what_is_done_end_with_3() {
    let home = tempfile::tempdir().expect("a temporary folder");
    let path = |name: &str| home.path().join(name).to_str().expect("text").to_owned();
    let (ida, push) = (path("ida"), path("push"));
    for command in [
        &[
            "ida",
            "examples/06_sandwich_strip/tank.json",
            "--quake",
            QUAKE,
            "--scale",
            "0..1",
            "--steps",
            "9",
            "--out",
            &ida,
        ][..],
        &["push", "examples/07_steel_cylinder/tank.json", "--out", &push],
    ] {
        let before = entries(home.path());
        let run = begin(command);
        // Before it has its folder a command has nothing to keep, and ends with 130.
        let started = Instant::now();
        while entries(home.path()) == before && started.elapsed() < Duration::from_secs(120) {
            std::thread::sleep(Duration::from_millis(2));
        }
        interrupt(&run);
        let (status, message) = end(run);
        assert_eq!(status.code(), Some(3), "{command:?}: {message}");
        assert!(message.contains("interrupted"), "{command:?}: {message}");
        let litter = std::fs::read_dir(home.path())
            .expect("readable")
            .flatten()
            .filter(|e| e.file_name().to_string_lossy().contains("partial"))
            .count();
        assert_eq!(litter, 0, "{command:?}");
    }
}
