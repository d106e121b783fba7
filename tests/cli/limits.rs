//! Runs beyond the limits are rejected at once, with the estimate and the limit; no model is built, no file is left.

use std::path::{Path, PathBuf};
use std::time::{Duration, Instant};

use crate::compare::{stderr, tankcheck};

const TANK: &str = "examples/01_broad_tank/tank.json";
const QUAKE: &str = "examples/records/elcentro.csv";

fn text(path: &Path) -> &str {
    path.to_str().expect("a temporary path is text")
}

/// The file of an example with some of its text replaced.
fn changed(home: &Path, example: &str, changes: &[(&str, &str)]) -> PathBuf {
    let mut tank = std::fs::read_to_string(Path::new(env!("CARGO_MANIFEST_DIR")).join(example)).expect("an example");
    for (from, to) in changes {
        assert!(tank.contains(from), "`{from}` is missing in {example}");
        tank = tank.replace(from, to);
    }
    let path = home.join("tank.json");
    std::fs::write(&path, tank).expect("writable");
    path
}

fn record(home: &Path, dt: f64) -> PathBuf {
    let path = home.join("record.csv");
    let lines: Vec<String> =
        (0..4).map(|k| format!("{},{}", f64::from(k) * dt, [0.0, 1.0, -1.0, 0.0][k as usize])).collect();
    std::fs::write(&path, format!("time_s,acceleration_m_s2\n{}\n", lines.join("\n"))).expect("writable");
    path
}

/// Runs a command that must be rejected before it computes: exit code 2, all of `words`, no files.
pub(crate) fn refused(command: &[&str], home: &Path, words: &[&str]) {
    let out = home.join("out");
    let mut command = command.to_vec();
    command.extend(["--out", text(&out)]);
    let started = Instant::now();
    let run = tankcheck(&command);
    let message = stderr(&run);
    assert_eq!(run.status.code(), Some(2), "{command:?}: {message}");
    for word in words {
        assert!(message.contains(word), "`{word}` is missing in: {message}");
    }
    assert_eq!(message.matches("error[T").count(), 1, "{message}");
    // Seconds, and minutes on a busy machine: the limit is for a command that computes what it should refuse.
    assert!(started.elapsed() < Duration::from_secs(600), "{command:?}");
    assert!(run.stdout.is_empty() && !out.exists(), "{command:?}");
}

/// A film of 1 µm: the mesh had one node at the wall, and the liquid's mesh was indexed beyond its end.
#[test]
fn a_film_on_the_bottom_has_no_mesh() {
    let home = tempfile::tempdir().expect("a temporary folder");
    let film = |example: &str, depth: &str| changed(home.path(), example, &[(depth, "\"fill_height\": \"1e-6 m\"")]);
    let tank = film(TANK, "\"fill_height\": \"1.525 m\"");
    for engine in ["harmonic", "solid", "both"] {
        let command = ["compare", text(&tank), "--quake", QUAKE, "--fe", engine];
        refused(&command, home.path(), &["liquid.fill_height", "found \"1e-6 m\"", "at least 1 mm"]);
    }
    let run = tankcheck(&["modes", text(&tank)]);
    assert_eq!(run.status.code(), Some(2), "{}", stderr(&run));
    let tank = film("examples/07_steel_cylinder/tank.json", "\"fill_height\": \"11 m\"");
    refused(&["compare", text(&tank), "--quake", QUAKE, "--fe", "nonlinear"], home.path(), &["liquid.fill_height"]);
    refused(&["push", text(&tank)], home.path(), &["liquid.fill_height"]);
}

/// 5.8e13 bytes for the free vibration after a record of 3 ps.
#[test]
fn a_record_of_picoseconds_is_refused() {
    let home = tempfile::tempdir().expect("a temporary folder");
    for dt in [1e-12, 1e-9, 1e-7] {
        let record = record(home.path(), dt);
        refused(&["compare", TANK, "--quake", text(&record)], home.path(), &["found a step of", "at least 0.00001 s"]);
    }
    // The same by the time axis.
    let tank = changed(home.path(), TANK, &[("\"time_factor\": 0.57735", "\"time_factor\": 0.001")]);
    let short = record(home.path(), 1e-4);
    refused(
        &["compare", text(&tank), "--quake", text(&short)],
        home.path(),
        &["the time step of the record is out of range", "at least 0.00001 s"],
    );
    let strip = "examples/06_sandwich_strip/tank.json";
    let record = record(home.path(), 1e-9);
    refused(
        &["compare", strip, "--quake", text(&record), "--fe", "nonlinear"],
        home.path(),
        &["found a step of", "at least 0.00001 s"],
    );
}

#[test]
fn gravity_of_nothing_is_refused() {
    let home = tempfile::tempdir().expect("a temporary folder");
    let tank = changed(home.path(), TANK, &[("\"liquid\": {", "\"gravity\": \"1e-9 m/s2\", \"liquid\": {")]);
    let run = tankcheck(&["compare", text(&tank), "--quake", QUAKE, "--out", text(&home.path().join("out"))]);
    let message = stderr(&run);
    assert_eq!(run.status.code(), Some(2), "{message}");
    for word in ["gravity", "too small", "at least 0.1 m/s2"] {
        assert!(message.contains(word), "`{word}` is missing in: {message}");
    }
}

#[test]
fn every_engine_is_held_to_the_memory_and_says_what_fits() {
    let home = tempfile::tempdir().expect("a temporary folder");
    let fine = changed(
        home.path(),
        "examples/08_concrete_cylinder/tank.json",
        &[("\"height\": 40, \"circumference\": 100", "\"height\": 160, \"circumference\": 400")],
    );
    let few = ["more than the allowed", "MiB", "help: ", "raise --memory-limit"];
    let refuse = |command: &[&str], words: &[&str]| {
        let words: Vec<&str> = few.iter().chain(words).copied().collect();
        refused(command, home.path(), &words);
    };
    let limit = ["--memory-limit", "300"];
    let cylinder = ["compare", text(&fine), "--quake", QUAKE, "--fe", "nonlinear"];
    refuse(&[&cylinder[..], &limit].concat(), &["nonlinear run", "give `analysis.nonlinear.elements`"]);
    let ida = ["ida", text(&fine), "--quake", QUAKE, "--scale", "0.5,1", "--jobs", "2"];
    refuse(&[&ida[..], &limit].concat(), &["nonlinear run", "2 runs, 2 at a time"]);
    let harmonic = ["compare", TANK, "--quake", QUAKE, "--refine", "16", "--memory-limit", "300"];
    refuse(&harmonic, &["harmonic run", "condensed liquid", "use --refine"]);
    let solid = ["compare", TANK, "--quake", QUAKE, "--fe", "solid", "--mesh", "24x32x40", "--memory-limit", "60"];
    refuse(&solid, &["three-dimensional run", "24x32x40 elements", "use --mesh"]);
    let steel = "examples/07_steel_cylinder/tank.json";
    refuse(
        &["push", steel, "--memory-limit", "20"],
        &["pushover", "x 96 elements", "give `analysis.nonlinear.elements`"],
    );
}

/// What a lifting base, the checks and a second engine need counts: a tank that is not anchored used 134 MiB under a limit of 40, and two engines were each held
/// to the whole limit.
#[test]
fn what_runs_beside_counts() {
    let home = tempfile::tempdir().expect("a temporary folder");
    let oil = "examples/05_oil_tank/tank.json";
    let beyond = ["more than the allowed 90 MiB", "help: "];
    let limit = ["--memory-limit", "90"];
    for command in [
        &["compare", oil, "--quake", QUAKE][..],
        &["compare", oil, "--quake", QUAKE, "--no-mesh-error"],
        &["compare", "examples/09_slender_unanchored/tank.json", "--quake", QUAKE],
        &["compare", TANK, "--quake", QUAKE, "--refine", "4"],
        &["compare", TANK, "--quake", QUAKE, "--fe", "both", "--mesh", "12x16x20"],
    ] {
        refused(&[command, &limit].concat(), home.path(), &beyond);
    }
    let solid = tankcheck(&[
        "compare",
        TANK,
        "--quake",
        QUAKE,
        "--fe",
        "solid",
        "--mesh",
        "12x16x20",
        "--no-mesh-error",
        "--memory-limit",
        "90",
        "--out",
        text(&home.path().join("solid")),
    ]);
    assert_eq!(solid.status.code(), Some(0), "{}", stderr(&solid));
}

/// Tasks of a study that run at a time are held to the limit together; fewer fit.
#[test]
fn tasks_at_a_time_are_held_to_the_memory() {
    let folder = crate::study::planned();
    let run = |arguments: &[&str]| {
        let output = crate::study::tankcheck(folder.path(), &[&["study", "run", "out"], arguments].concat());
        (output.status.code(), crate::study::said(&output))
    };
    let (code, text) = run(&["--jobs", "6", "--memory-limit", "60"]);
    assert_eq!(code, Some(2), "{text}");
    assert!(text.contains("more than the allowed 60 MiB") && text.contains("use --jobs "), "{text}");
    let (code, text) = run(&["--jobs", "2", "--memory-limit", "60"]);
    assert_eq!(code, Some(0), "{text}");
}

/// Before a nonlinear run of any command its size, memory and time stand on standard error, however short it is; nothing with
/// --quiet.
#[test]
fn nonlinear_runs_are_announced_with_their_estimate() {
    let home = tempfile::tempdir().expect("a temporary folder");
    let pulse = "tests/golden/short/pulse.csv";
    let strip = "tests/golden/short/strip.json";
    let commands: [&[&str]; 3] = [
        &["compare", strip, "--quake", pulse, "--fe", "nonlinear", "--procedures", "housner"],
        &["ida", strip, "--quake", pulse, "--scale", "0,0.1", "--jobs", "2"],
        &["push", "tests/golden/short/cylinder.json"],
    ];
    for (k, command) in commands.into_iter().enumerate() {
        let run = ["nonlinear run: ", "nonlinear run: ", "pushover: "][k];
        let out = home.path().join(k.to_string());
        for quiet in [false, true].into_iter().take(if k == 0 { 2 } else { 1 }) {
            let mut command = command.to_vec();
            command.extend(["--out", text(&out)]);
            command.extend(quiet.then_some("--quiet"));
            let said = stderr(&tankcheck(&command));
            let found = said.lines().find(|line| line.starts_with(run) && line.contains(" MiB, about "));
            assert_eq!(found.is_some(), !quiet, "{command:?}: {said}");
            assert!(k != 1 || quiet || said.contains("2 runs, 2 at a time"), "{said}");
        }
    }
}

/// Limits of the tank file hold for every engine; the option of the command line is laid over them.
#[test]
fn the_limit_of_the_tank_file_holds() {
    let home = tempfile::tempdir().expect("a temporary folder");
    let tank =
        changed(home.path(), TANK, &[("\"analysis\": {", "\"analysis\": { \"solid\": { \"memory_limit\": 20 },")]);
    let command = ["compare", text(&tank), "--quake", QUAKE, "--refine", "8"];
    refused(&command, home.path(), &["allowed 20 MiB"]);
}

/// 64 points in a period of 1 ns.
#[test]
fn a_spectrum_that_refines_without_end_is_refused() {
    for method in ["newmark", "duhamel"] {
        let run = tankcheck(&["spectrum", QUAKE, "--periods", "1e-9,1", "--method", method]);
        let message = stderr(&run);
        assert_eq!(run.status.code(), Some(2), "{message}");
        assert!(message.contains("spectrum") && message.contains("help: "), "{message}");
    }
}
