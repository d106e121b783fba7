//! `compare`, `check`, `report` and `diff` as commands: files, output and exit codes.

use std::collections::BTreeMap;
use std::path::{Path, PathBuf};
use std::process::{Command, Output};
use std::sync::LazyLock;

use crate::reproducible::{files, folder_of};

/// Runs tankcheck with the repository as working folder.
pub(crate) fn tankcheck(arguments: &[&str]) -> Output {
    Command::new(env!("CARGO_BIN_EXE_tankcheck"))
        .args(arguments)
        .current_dir(env!("CARGO_MANIFEST_DIR"))
        .output()
        .expect("tankcheck runs")
}

/// Standard error as text.
pub(crate) fn stderr(output: &Output) -> String {
    String::from_utf8_lossy(&output.stderr).into_owned()
}

fn stdout(output: &Output) -> String {
    String::from_utf8_lossy(&output.stdout).into_owned()
}

const TANK: &str = "examples/01_broad_tank/tank.json";
const QUAKE: &str = "examples/records/elcentro.csv";
/// A tank with site data.
const SITE: &str = "examples/05_oil_tank/tank.json";

fn path(path: &Path) -> &str {
    path.to_str().expect("a temporary path is text")
}

/// One run of the main command: its output, and a new folder with its files.
fn compared() -> (&'static Output, tempfile::TempDir) {
    static RUN: LazyLock<(Output, BTreeMap<PathBuf, Vec<u8>>)> = LazyLock::new(|| {
        let home = tempfile::tempdir().expect("a temporary folder");
        let out = home.path().join("out");
        let run = tankcheck(&["compare", TANK, "--quake", QUAKE, "--out", path(&out)]);
        assert!(matches!(run.status.code(), Some(0 | 1 | 4)), "{}", stderr(&run));
        (run, files(&out))
    });
    (&RUN.0, folder_of(&RUN.1))
}

#[test]
fn the_main_command_writes_report_results_series_and_figures() {
    let (run, folder) = compared();
    let out = folder.path();
    for file in ["report.html", "results.json", "series.csv"] {
        assert!(out.join(file).is_file(), "{file} is missing");
    }
    let figures = std::fs::read_dir(out.join("figures")).expect("figures/").count();
    assert!(figures >= 5, "only {figures} figures");
    let table = stdout(run);
    for word in ["Sloshing height", "housner", "ec8-2006", "api650-2020", "fe"] {
        assert!(table.contains(word), "`{word}` is missing in\n{table}");
    }
    assert!(stderr(run).contains("report.html"), "the last line gives the path of the report");
}

#[test]
fn results_are_the_same_in_every_run_but_for_the_volatile_fields() {
    let (_, first) = compared();
    let home = tempfile::tempdir().expect("a temporary folder");
    let second = home.path().join("b");
    tankcheck(&["compare", TANK, "--quake", QUAKE, "--out", path(&second)]);
    let read = |out: &Path| {
        let text = std::fs::read_to_string(out.join("results.json")).expect("results");
        let mut value: serde_json::Value = serde_json::from_str(&text).expect("JSON");
        value.as_object_mut().expect("an object").remove("volatile").expect("volatile fields");
        (value.to_string(), std::fs::read(out.join("series.csv")).expect("series"))
    };
    assert_eq!(read(first.path()), read(&second));
}

#[test]
fn quantities_carry_the_promised_ids_and_si_units() {
    let (_, folder) = compared();
    let text = std::fs::read_to_string(folder.path().join("results.json")).expect("results");
    let results: serde_json::Value = serde_json::from_str(&text).expect("JSON");
    let fe =
        results["methods"].as_array().and_then(|m| m.iter().find(|m| m["id"] == "fe")).expect("the engine is a method");
    for (id, unit) in [
        ("sloshing_period", "s"),
        ("sloshing_height", "m"),
        ("impulsive_period", "s"),
        ("impulsive_mass", "kg"),
        ("convective_mass", "kg"),
        ("base_shear", "N"),
        ("base_moment", "N*m"),
        ("overturning_moment", "N*m"),
        ("hoop_stress", "Pa"),
        ("axial_membrane_stress", "Pa"),
        ("bending_stress", "Pa"),
    ] {
        let quantity = &fe["quantities"][id];
        assert!(quantity["value"].as_f64().is_some_and(|v| v > 0.0), "{id}: {quantity}");
        assert_eq!(quantity["unit"], unit, "{id}");
    }
}

#[test]
fn a_results_folder_equals_itself_and_a_changed_one_is_found() {
    let home = tempfile::tempdir().expect("a temporary folder");
    let (_, a) = compared();
    let (a, b) = (a.path(), home.path().join("b"));
    assert_eq!(tankcheck(&["diff", path(a), path(a)]).status.code(), Some(0));
    let refined = tankcheck(&["compare", TANK, "--quake", QUAKE, "--out", path(&b), "--refine", "0.5"]);
    assert!(matches!(refined.status.code(), Some(0 | 1 | 4)), "{}", stderr(&refined));
    let diff = tankcheck(&["diff", path(a), path(&b)]);
    assert_eq!(diff.status.code(), Some(1), "{}", stderr(&diff));
    assert!(stdout(&diff).contains("moved"));
    let bless = tankcheck(&["diff", path(a), path(&b), "--bless", "--reason", "another mesh"]);
    assert_eq!(bless.status.code(), Some(0), "{}", stderr(&bless));
    assert_eq!(tankcheck(&["diff", path(a), path(&b)]).status.code(), Some(0));
    assert!(std::fs::read_to_string(a.join("accepted.json")).expect("kept").contains("another mesh"));
    // Histories that are not kept are named; lost ones are a difference.
    let numbers = home.path().join("numbers");
    std::fs::create_dir(&numbers).expect("writable");
    std::fs::copy(a.join("results.json"), numbers.join("results.json")).expect("writable");
    let kept = tankcheck(&["diff", path(&numbers), path(a)]);
    assert_eq!(kept.status.code(), Some(0), "{}", stderr(&kept));
    assert!(stdout(&kept).contains("does not have it: time histories"), "{}", stdout(&kept));
    let lost = tankcheck(&["diff", path(a), path(&numbers), "--all"]);
    assert_eq!(lost.status.code(), Some(1));
    assert!(stdout(&lost).contains("series.csv: columns"), "{}", stdout(&lost));
}

/// Two tanks are said to be two before anything else; one tank is not, whatever else differs.
#[test]
fn a_diff_of_two_tanks_says_so_first() {
    let home = tempfile::tempdir().expect("a temporary folder");
    let folder = |name: &str| home.path().join(name);
    let run = |tank: &str, out: &str, more: &[&str]| {
        let out = folder(out);
        let run = tankcheck(&[&["check", tank, "--out", path(&out)], more].concat());
        assert!(matches!(run.status.code(), Some(0 | 1 | 4)), "{}", stderr(&run));
    };
    let text = std::fs::read_to_string(TANK).expect("a tank");
    let mut other: serde_json::Value = serde_json::from_str(&text).expect("JSON");
    other["liquid"]["density"] = "1001 kg/m3".into();
    let filled = home.path().join("filled.json");
    std::fs::write(&filled, other.to_string()).expect("writable");
    other["name"] = "Another tank".into();
    let named = home.path().join("named.json");
    std::fs::write(&named, other.to_string()).expect("writable");
    run(TANK, "a", &[]);
    run(TANK, "same", &["--quake", QUAKE]);
    run(path(&filled), "filled", &[]);
    run(path(&named), "named", &[]);
    let [a, same, filled, named] = ["a", "same", "filled", "named"].map(folder);
    let first = |old: &Path, new: &Path| {
        let diff = tankcheck(&["diff", path(old), path(new)]);
        stdout(&diff).lines().next().unwrap_or_default().to_owned()
    };
    for (new, parts) in [
        (&filled, &["two different tanks", "1 value of tank"][..]),
        (&named, &["two different tanks", "-> `Another tank`", "1 value of tank"]),
    ] {
        let line = first(&a, new);
        assert!(parts.iter().all(|part| line.contains(part)), "{line}");
        let json = tankcheck(&["diff", path(&a), path(new), "--format", "json"]);
        let json: serde_json::Value = serde_json::from_slice(&json.stdout).expect("JSON");
        assert_eq!(json["different_tanks"]["values"], 1);
        let csv = tankcheck(&["diff", path(&a), path(new), "--format", "csv"]);
        assert!(stderr(&csv).contains("two different tanks") && stdout(&csv).starts_with("path,"));
    }
    assert!(first(&filled, &named).contains("the same values"));
    assert!(!first(&a, &a).contains("two different"));
    assert!(!first(&a, &same).contains("two different"));
}

#[test]
fn the_report_is_rendered_again_from_the_folder_alone() {
    let (_, out) = compared();
    let out = out.path();
    let first = std::fs::read(out.join("report.html")).expect("a report");
    std::fs::remove_file(out.join("report.html")).expect("removable");
    let run = tankcheck(&["report", path(out)]);
    assert_eq!(run.status.code(), Some(0), "{}", stderr(&run));
    assert_eq!(first, std::fs::read(out.join("report.html")).expect("a report"));
}

#[test]
fn check_runs_the_codes_on_the_design_spectrum_alone() {
    let run = tankcheck(&["check", "examples/05_oil_tank/tank.json"]);
    assert!(matches!(run.status.code(), Some(0 | 1 | 4)), "{}", stderr(&run));
    let table = stdout(&run);
    assert!(table.contains("design spectrum of the site") && table.contains("ec8-2006"), "{table}");
}

/// Runs a command that must be rejected: exit code 2, a message with all of `words`, empty standard output, no
/// output folder.
fn refused(arguments: &[&str], out: &Path, words: &[&str]) {
    let run = tankcheck(arguments);
    let message = stderr(&run);
    assert_eq!(run.status.code(), Some(2), "{arguments:?}: {message}");
    for word in words {
        assert!(message.contains(word), "`{word}` is missing in: {message}");
    }
    assert!(run.stdout.is_empty(), "{arguments:?} printed {}", stdout(&run));
    assert!(!out.join("results.json").exists(), "{arguments:?} left results behind");
}

/// Foreign files in the place of results stop a run; others stay next to the results, run after run.
#[test]
fn files_of_others_are_never_touched() {
    let home = tempfile::tempdir().expect("a temporary folder");
    let command = ["check", SITE, "--out", path(home.path())];
    for name in ["report.html", "results.json", "figures/mine.svg"] {
        let mine = home.path().join(name);
        std::fs::create_dir_all(mine.parent().expect("a folder")).expect("writable");
        std::fs::write(&mine, "mine").expect("writable");
        let run = tankcheck(&command);
        let first = name.split('/').next().expect("a name");
        assert_eq!(run.status.code(), Some(2), "{}", stderr(&run));
        for word in [first, "--out", "did not"] {
            let word = if word == "did not" { "not in the manifest" } else { word };
            assert!(stderr(&run).contains(word), "`{word}` is missing in: {}", stderr(&run));
        }
        assert_eq!(std::fs::read_to_string(&mine).expect("left"), "mine");
        std::fs::remove_file(&mine).expect("writable");
    }
    std::fs::remove_dir(home.path().join("figures")).expect("empty");
    let mine = home.path().join("thesis.txt");
    std::fs::write(&mine, "mine").expect("writable");
    for _ in 0..2 {
        let run = tankcheck(&command);
        assert!(matches!(run.status.code(), Some(0 | 1 | 4)), "{}", stderr(&run));
        assert_eq!(std::fs::read_to_string(&mine).expect("left"), "mine");
    }
    // `report` replaces its own files alone; an edited result is nobody's to replace.
    let run = tankcheck(&["report", path(home.path())]);
    assert_eq!(run.status.code(), Some(0), "{}", stderr(&run));
    std::fs::write(home.path().join("report.html"), "signed").expect("writable");
    for command in [&command[..], &["report", path(home.path())]] {
        let run = tankcheck(command);
        assert_eq!(run.status.code(), Some(2), "{}", stderr(&run));
        assert!(stderr(&run).contains("`report.html` has changed"), "{}", stderr(&run));
    }
    assert_eq!(std::fs::read_to_string(home.path().join("report.html")).expect("left"), "signed");
}

#[test]
fn a_file_in_place_of_the_output_folder_is_refused() {
    let home = tempfile::tempdir().expect("a temporary folder");
    let out = home.path().join("out");
    std::fs::write(&out, "mine").expect("writable");
    refused(&["compare", TANK, "--quake", QUAKE, "--out", path(&out)], &out, &["is a file"]);
}

#[cfg(unix)]
#[test]
fn a_read_only_output_folder_is_refused() {
    use std::os::unix::fs::PermissionsExt;
    let home = tempfile::tempdir().expect("a temporary folder");
    let out = home.path().join("out");
    std::fs::create_dir(&out).expect("writable");
    std::fs::set_permissions(&out, std::fs::Permissions::from_mode(0o555)).expect("own folder");
    refused(&["compare", TANK, "--quake", QUAKE, "--out", path(&out)], &out, &["read-only"]);
}

/// No file may grow beyond 8 KiB, as on a full disk: no new files are left, the old results stay, and the exit code is that of
/// missing results, not that of bad input.
#[cfg(unix)]
#[test]
fn results_that_cannot_be_written_leave_the_old_ones() {
    let home = tempfile::tempdir().expect("a temporary folder");
    let out = home.path().join("out");
    let limited = |limit: &str| {
        let script = format!("trap '' XFSZ; ulimit -f {limit}; exec \"$@\"");
        let command = [env!("CARGO_BIN_EXE_tankcheck"), "check", SITE, "--out", path(&out)];
        Command::new("bash")
            .args(["-c", &script, "bash"])
            .args(command)
            .current_dir(env!("CARGO_MANIFEST_DIR"))
            .output()
            .expect("bash runs")
    };
    let run = limited("8");
    assert_eq!(run.status.code(), Some(3), "{}", stderr(&run));
    assert!(stderr(&run).contains("cannot be written"), "{}", stderr(&run));
    assert_eq!(std::fs::read_dir(home.path()).expect("readable").count(), 0);
    let run = limited("unlimited");
    assert!(matches!(run.status.code(), Some(0 | 1 | 4)), "{}", stderr(&run));
    let before = std::fs::read(out.join("results.json")).expect("results");
    let run = limited("8");
    assert_eq!(run.status.code(), Some(3), "{}", stderr(&run));
    assert_eq!(std::fs::read(out.join("results.json")).expect("results"), before);
    assert!(
        std::fs::read_dir(&out).expect("readable").flatten().all(|e| !e.file_name().to_string_lossy().starts_with('.'))
    );
}

#[test]
fn compare_without_a_record_says_how_to_give_one() {
    let home = tempfile::tempdir().expect("a temporary folder");
    let out = home.path().join("out");
    refused(&["compare", "examples/02_perspex_model_tank/tank.json", "--out", path(&out)], &out, &["--quake"]);
}

#[test]
fn an_unknown_procedure_is_refused_with_the_known_ones() {
    let home = tempfile::tempdir().expect("a temporary folder");
    let out = home.path().join("out");
    refused(
        &["compare", TANK, "--quake", QUAKE, "--procedures", "ec9", "--out", path(&out)],
        &out,
        &["ec9", "ec8-2006", "housner"],
    );
}

#[test]
fn diff_of_something_else_is_refused() {
    let home = tempfile::tempdir().expect("a temporary folder");
    refused(&["diff", path(home.path()), path(home.path())], home.path(), &["results.json", "no such file"]);
    refused(&["diff", "no_folder", path(home.path())], home.path(), &["no_folder"]);
}
