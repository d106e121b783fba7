//! `tankcheck study`: state in files, whatever happens between.

use std::collections::BTreeMap;
use std::fs;
use std::path::{Path, PathBuf};
use std::process::{Command, Output, Stdio};
use std::sync::LazyLock;
use std::time::Duration;

use crate::reproducible::{files, folder_of};

const TANK: &str = include_str!("../../examples/01_broad_tank/tank.json");

pub(crate) fn tankcheck(folder: &Path, arguments: &[&str]) -> Output {
    Command::new(env!("CARGO_BIN_EXE_tankcheck")).args(arguments).current_dir(folder).output().unwrap()
}

pub(crate) fn said(output: &Output) -> String {
    String::from_utf8_lossy(&output.stdout).into_owned() + &String::from_utf8_lossy(&output.stderr)
}

/// A record of two tones, 6 s long.
fn record(tone: f64) -> String {
    let mut text = String::from("time_s,acceleration_m_s2\n");
    for k in 0..600 {
        let t = 0.01 * f64::from(k);
        text.push_str(&format!("{t:.2},{:.6}\n", (6.3 * t).sin() + 0.5 * (tone * t).cos() * (-0.3 * t).exp()));
    }
    text
}

pub(crate) const STUDY: &str = r#"{
  "name": "two tanks",
  "tanks": [ { "template": "tank.json", "table": "farm.csv", "id": "tag" } ],
  "records": [ { "files": "rec*.csv" } ],
  "scales": { "im": "PGA", "levels": ["0.1 g", "0.2 g", "0.4 g", "0.8 g"] },
  "block": 2
}
"#;

/// Two tanks, five records, four levels: 6 tasks, 40 rows.
pub(crate) fn folder() -> tempfile::TempDir {
    let folder = tempfile::tempdir().unwrap();
    let write = |name: &str, text: &str| fs::write(folder.path().join(name), text).unwrap();
    write("tank.json", TANK);
    write("farm.csv", "tag,liquid.fill_height\nA,1.5 m\nB,1.2 m\n");
    for k in 0..5 {
        write(&format!("rec{k}.csv"), &record(11.0 + 7.0 * f64::from(k)));
    }
    write("study.json", STUDY);
    folder
}

pub(crate) fn planned() -> tempfile::TempDir {
    let folder = folder();
    let output = tankcheck(folder.path(), &["study", "plan", "study.json", "--out", "out"]);
    assert!(output.status.success(), "{}", said(&output));
    folder
}

/// The planned study with its results and merged rows, in a new folder, and the hash of the rows. It is run once, by two threads.
pub(crate) fn finished() -> (tempfile::TempDir, String) {
    static DONE: LazyLock<(BTreeMap<PathBuf, Vec<u8>>, String)> = LazyLock::new(|| {
        let folder = planned();
        let output = tankcheck(folder.path(), &["study", "run", "out", "--jobs", "2"]);
        assert_eq!(output.status.code(), Some(0), "{}", said(&output));
        let rows = merged(folder.path(), "out");
        (files(folder.path()), rows)
    });
    (folder_of(&DONE.0), DONE.1.clone())
}

/// Hash of the merged rows.
pub(crate) fn merged(folder: &Path, out: &str) -> String {
    let output = tankcheck(folder, &["study", "merge", out]);
    assert!(output.status.success(), "{}", said(&output));
    fs::read_to_string(folder.join(out).join("rows.sha256")).unwrap()
}

/// The files of the results of a study, sorted.
pub(crate) fn results(out: &Path) -> Vec<PathBuf> {
    let folders = fs::read_dir(out.join("results")).unwrap().map(|e| e.unwrap().path());
    let mut all: Vec<PathBuf> =
        folders.flat_map(|folder| fs::read_dir(folder).unwrap().map(|e| e.unwrap().path())).collect();
    all.sort();
    all
}

#[test]
fn rows_of_every_tank_record_and_scale() {
    let (folder, _) = finished();
    let rows = fs::read_to_string(folder.path().join("out/rows.csv")).unwrap();
    let lines: Vec<Vec<&str>> = rows.lines().map(|line| line.split(',').collect()).collect();
    assert_eq!(lines.len(), 41);
    assert!(lines.iter().all(|line| line.len() == lines[0].len()));
    let column = |name: &str| lines[0].iter().position(|c| *c == name).unwrap_or_else(|| panic!("no {name} in {rows}"));
    assert_eq!(["tank", "sample", "record"].map(column), [0, 1, 2]);
    // PGA is the level; the wave of a linear engine is proportional to it.
    let (pga, wave) = (column("pga_m_s2"), column("fe.sloshing_height_m"));
    let number = |line: usize, column: usize| lines[line][column].parse::<f64>().unwrap();
    for block in (1..41).step_by(4) {
        assert!((number(block, pga) / 0.980665 - 1.0).abs() < 1e-8);
        for k in 1..4 {
            let factor = number(block + k, pga) / number(block, pga);
            let waves = number(block + k, wave) / number(block, wave);
            assert!((waves / factor - 1.0).abs() < 1e-8);
        }
    }
    let fragility = fs::read_to_string(folder.path().join("out/fragility.json")).unwrap();
    let fragility: serde_json::Value = serde_json::from_str(&fragility).unwrap();
    let curves = fragility["curves"].as_array().unwrap();
    assert_eq!(curves.len(), 6);
    for curve in curves {
        for key in ["damage_state", "method", "im", "median", "dispersion", "n", "status"] {
            assert!(curve.get(key).is_some(), "{curve}");
        }
    }
}

/// A row is what `compare` gives for the same tank under the same scaled record: exactly for the codes, within 1 % for the engine, whose mesh
/// follows the record in `compare` and 20 Hz in a study.
#[test]
fn a_row_is_what_compare_gives() {
    let (folder, _) = finished();
    let rows = fs::read_to_string(folder.path().join("out/rows.csv")).unwrap();
    let head: Vec<&str> = rows.lines().next().unwrap().split(',').collect();
    let row: Vec<&str> = rows.lines().nth(3).unwrap().split(',').collect();
    let scaled = TANK.replace("\"scale_to\": \"0.5 g\"", "\"scale_to\": \"0.4 g\"").replace("1.525 m", "1.5 m");
    assert!(scaled.contains("0.4 g") && scaled.contains("1.5 m"));
    fs::write(folder.path().join("scaled.json"), scaled).unwrap();
    let output = tankcheck(
        folder.path(),
        &["compare", "scaled.json", "--quake", "rec0.csv", "--no-mesh-error", "--format", "csv", "--out", "one"],
    );
    let csv = String::from_utf8_lossy(&output.stdout).into_owned();
    let mut compared = 0;
    for line in csv.lines() {
        let cells: Vec<&str> = line.split(',').collect();
        let [method, "record", quantity, value, ..] = cells[..] else { continue };
        let key = format!("{method}.{quantity}_");
        let Some(column) = head.iter().position(|c| c.starts_with(&key)) else { continue };
        // The checks follow the values in the same table.
        let Ok(wanted) = value.parse::<f64>() else { continue };
        let found: f64 = row[column].parse().unwrap();
        let tolerance = if method == "fe" { 1e-2 } else { 1e-8 };
        assert!((found / wanted - 1.0).abs() < tolerance, "{key}: {found} {wanted}");
        compared += 1;
    }
    assert!(compared > 15, "{compared} values compared: {}", said(&output));
}

#[test]
fn shards_threads_and_torn_files_give_the_same_rows() {
    let (folder, whole) = finished();
    let path = folder.path();
    tankcheck(path, &["study", "plan", "study.json", "--out", "shards"]);
    let refused = tankcheck(path, &["study", "merge", "shards"]);
    assert_eq!(refused.status.code(), Some(2));
    assert!(said(&refused).contains("6 of 6 tasks have no result"), "{}", said(&refused));
    for shard in ["3/3", "1/3", "2/3"] {
        tankcheck(path, &["study", "run", "shards", "--shard", shard, "--jobs", "1"]);
    }
    assert_eq!(merged(path, "shards"), whole);
    // Half a file, and one with a changed number, are computed again; nothing else is.
    let files = results(&path.join("out"));
    assert_eq!(files.len(), 6);
    let bytes = fs::read(&files[0]).unwrap();
    fs::write(&files[0], &bytes[..bytes.len() / 2]).unwrap();
    let text = fs::read_to_string(&files[1]).unwrap();
    fs::write(&files[1], text.replacen("\"factor\":", "\"factor\":1", 1)).unwrap();
    let status = tankcheck(path, &["study", "status", "out", "--format", "json"]);
    let status: serde_json::Value = serde_json::from_slice(&status.stdout).unwrap();
    assert_eq!((&status["done"], &status["damaged"]), (&4.into(), &2.into()));
    let again = tankcheck(path, &["study", "run", "out"]);
    assert!(said(&again).contains("2 tasks computed, 4 kept"), "{}", said(&again));
    assert_eq!(merged(path, "out"), whole);
}

/// `kill -9` at moments spread over the run; what was finished is kept, and the rows are those of an undisturbed run.
#[cfg(unix)]
#[test]
fn killed_workers_lose_nothing() {
    let (folder, whole) = finished();
    let path = folder.path();
    tankcheck(path, &["study", "plan", "study.json", "--out", "killed"]);
    for k in 1..=20_u64 {
        let mut child = Command::new(env!("CARGO_BIN_EXE_tankcheck"))
            .args(["study", "run", "killed", "--jobs", "2", "--quiet"])
            .current_dir(path)
            .stdout(Stdio::null())
            .stderr(Stdio::null())
            .spawn()
            .unwrap();
        std::thread::sleep(Duration::from_millis(13 * k % 170 + 5));
        child.kill().unwrap();
        child.wait().unwrap();
    }
    let end = tankcheck(path, &["study", "run", "killed"]);
    assert_eq!(end.status.code(), Some(0), "{}", said(&end));
    assert_eq!(merged(path, "killed"), whole);
}

/// Two runners in one folder at once compute some tasks twice, and write the same bytes.
#[test]
fn two_runners_at_once_do_not_disturb_each_other() {
    let (folder, whole) = finished();
    let path = folder.path();
    tankcheck(path, &["study", "plan", "study.json", "--out", "both"]);
    let start = || {
        Command::new(env!("CARGO_BIN_EXE_tankcheck"))
            .args(["study", "run", "both", "--jobs", "1", "--quiet"])
            .current_dir(path)
            .spawn()
            .unwrap()
    };
    let (mut one, mut other) = (start(), start());
    assert!(one.wait().unwrap().success() && other.wait().unwrap().success());
    assert_eq!(merged(path, "both"), whole);
    // No temporary file is left.
    assert!(results(&path.join("both")).iter().all(|file| file.extension().is_some_and(|e| e == "jsonl")));
}

#[test]
fn faults_are_told_all_at_once() {
    let folder = folder();
    let path = folder.path();
    let write = |name: &str, text: &str| fs::write(path.join(name), text).unwrap();
    write("farm.csv", "tag,liquid.fill_height\nA,1.5 m\nB,-1 m\nC,1.2 kg\n");
    write("rec1.csv", "time_s,acceleration_m_s2\n0,0\n0.01,nan\n");
    let output = tankcheck(path, &["study", "plan", "study.json", "--out", "out"]);
    let text = said(&output);
    assert_eq!(output.status.code(), Some(2), "{text}");
    for wanted in ["farm.csv:3", "farm.csv:4", "rec1.csv:3"] {
        assert!(text.contains(wanted), "{wanted} in {text}");
    }
    assert!(!path.join("out").exists());
    write("study.json", &STUDY.replace("PGA", "PGX").replace("\"0.2 g\"", "\"0.2 m\"").replace("rec*", "none*"));
    let text = said(&tankcheck(path, &["study", "plan", "study.json", "--out", "out"]));
    for wanted in ["unknown intensity measure", "no file matches"] {
        assert!(text.contains(wanted), "{wanted} in {text}");
    }
    // A name that occurs twice is told with both rows, together with the other faults of the table, which have one summary.
    write("farm.csv", "tag,liquid.fill_height\nA,1.5 m\nB,-1 m\nA,1.2 kg\n");
    write("study.json", STUDY);
    let text = said(&tankcheck(path, &["study", "plan", "study.json", "--out", "out"]));
    for wanted in ["named `A`", "farm.csv:2 and", "column `tag`", "farm.csv:3:"] {
        assert!(text.contains(wanted), "{wanted} in {text}");
    }
    write("farm.csv", "tag,liquid.fill_height\nA,1.5 m\nB,-1 m\nC,1.2 kg\n");
    let text = said(&tankcheck(path, &["study", "plan", "study.json", "--out", "out"]));
    assert_eq!(text.matches("faults in").count(), 1, "{text}");
    assert!(text.contains("2 faults in"), "{text}");
    write("study.json", &STUDY.replace("\"0.2 g\"", "\"0.2 m\""));
    assert!(said(&tankcheck(path, &["study", "plan", "study.json"])).contains("study.json:5"));
}

/// One template for anchored and unanchored tanks: the cell `null` removes the anchors. The same table is one of `check`.
#[test]
fn a_cell_removes_an_object_of_the_template() {
    let folder = folder();
    let path = folder.path();
    let write = |name: &str, text: &str| fs::write(path.join(name), text).unwrap();
    assert!(tankcheck(path, &["init", "--out", "anchored.json"]).status.success());
    write("study.json", &STUDY.replace("tank.json", "anchored.json"));
    let table = |cell: &str| format!("tag,tank.support,tank.anchors\nA,,\nB,unanchored,{cell}\n");
    write("farm.csv", &table(""));
    let text = said(&tankcheck(path, &["study", "plan", "study.json", "--out", "out"]));
    assert!(text.contains("column `tank.anchors` with the cell null"), "{text}");
    write("farm.csv", &table("null"));
    let output = tankcheck(path, &["study", "plan", "study.json", "--out", "out"]);
    assert!(output.status.success(), "{}", said(&output));
    let output = tankcheck(path, &["check", "anchored.json", "--table", "farm.csv"]);
    let text = String::from_utf8(output.stdout).unwrap();
    let line = |tag: &str| text.lines().find(|line| line.starts_with(tag)).unwrap_or_default().to_owned();
    assert!(line("A,").contains("holds"), "{text}");
    assert!(line("B,").contains("unanchored,null"), "{text}");
    // An item of a list has no name to be removed by.
    write("farm.csv", "tag,tank.courses[0]\nA,null\n");
    let text = said(&tankcheck(path, &["study", "plan", "study.json", "--out", "out"]));
    assert!(text.contains("only keys of objects"), "{text}");
}

#[test]
fn a_file_that_changed_since_the_plan_is_not_computed() {
    let folder = planned();
    let path = folder.path();
    tankcheck(path, &["study", "run", "out", "--task", "1"]);
    fs::write(path.join("farm.csv"), "tag,liquid.fill_height\nA,1.5 m\nB,1.3 m\n").unwrap();
    let output = tankcheck(path, &["study", "run", "out"]);
    let text = said(&output);
    assert_eq!(output.status.code(), Some(2), "{text}");
    assert!(text.contains("the tank `B` changed since the plan"), "{text}");
    // A new plan keeps what is unchanged: the tank A.
    tankcheck(path, &["study", "plan", "study.json", "--out", "out"]);
    let text = said(&tankcheck(path, &["study", "run", "out"]));
    assert!(text.contains("5 tasks computed, 1 kept"), "{text}");
    // So is a finished study: its rows would not be those of the files.
    fs::write(path.join("farm.csv"), "tag,liquid.fill_height\nA,1.6 m\nB,1.3 m\n").unwrap();
    for (command, code) in [("run", 2), ("merge", 2), ("status", 0)] {
        let output = tankcheck(path, &["study", command, "out"]);
        let text = said(&output);
        assert_eq!(output.status.code(), Some(code), "{command}: {text}");
        assert!(text.contains("the tank `A` changed since the plan"), "{command}: {text}");
    }
    // A file that is faulty now is refused with its place, with `--quiet` too.
    fs::write(path.join("farm.csv"), "tag,liquid.fill_height\nA,-1.6 m\nB,1.3 m\n").unwrap();
    let output = tankcheck(path, &["study", "merge", "out", "--quiet"]);
    let text = said(&output);
    assert_eq!(output.status.code(), Some(2), "{text}");
    assert!(text.contains("faulty since the plan"), "{text}");
    assert!(text.contains("farm.csv:2"), "{text}");
    // Where the input is not at hand, results are merged, and that is said.
    fs::remove_file(path.join("farm.csv")).unwrap();
    let output = tankcheck(path, &["study", "merge", "out"]);
    let text = said(&output);
    assert_eq!(output.status.code(), Some(0), "{text}");
    assert!(text.contains("is not compared with its plan"), "{text}");
}

/// A sample whose tank is not possible is a row, not the end of the study.
#[test]
fn impossible_samples_are_rows() {
    let folder = folder();
    let path = folder.path();
    let sampled = r#"{
      "name": "samples",
      "tanks": [ { "files": "tank.json" } ],
      "records": [ { "files": "rec0.csv" } ],
      "sample": { "n": 8, "seed": 3, "parameters": [
        { "path": "liquid.fill_height", "uniform": { "low": "1 m", "high": "3 m" } } ] },
      "scales": { "factors": [0.1] }
    }"#;
    fs::write(path.join("study.json"), sampled).unwrap();
    tankcheck(path, &["study", "plan", "study.json", "--out", "out"]);
    let output = tankcheck(path, &["study", "run", "out"]);
    assert_eq!(output.status.code(), Some(0), "{}", said(&output));
    merged(path, "out");
    let rows = fs::read_to_string(path.join("out/rows.csv")).unwrap();
    let count = |word: &str| rows.lines().filter(|line| line.contains(word)).count();
    assert_eq!(count(",ok,") + count(",refused,"), 8);
    assert!(count(",ok,") > 0 && count(",refused,") > 0, "{rows}");
}

#[cfg(unix)]
#[test]
fn a_folder_that_cannot_be_written_loses_nothing() {
    use std::os::unix::fs::symlink;
    let folder = planned();
    let path = folder.path();
    // A full disk: every write to /dev/full fails with ENOSPC; as the folder of results it is no folder.
    if !Path::new("/dev/full").exists() {
        return;
    }
    symlink("/dev/full", path.join("out/results")).unwrap();
    let output = tankcheck(path, &["study", "run", "out"]);
    assert_eq!(output.status.code(), Some(3), "{}", said(&output));
    assert!(said(&output).contains("cannot be written"), "{}", said(&output));
    fs::remove_file(path.join("out/results")).unwrap();
    assert_eq!(tankcheck(path, &["study", "run", "out"]).status.code(), Some(0));
}

#[test]
fn codes_alone_and_design_spectra() {
    let folder = folder();
    let path = folder.path();
    let study = STUDY.replace("\"block\": 2", "\"engine\": \"none\"");
    fs::write(path.join("study.json"), &study).unwrap();
    tankcheck(path, &["study", "plan", "study.json", "--out", "codes"]);
    tankcheck(path, &["study", "run", "codes"]);
    merged(path, "codes");
    let rows = fs::read_to_string(path.join("codes/rows.csv")).unwrap();
    assert_eq!(rows.lines().count(), 41);
    assert!(!rows.contains("fe.") && rows.contains("housner.base_shear_N"));
}

/// The first tank of example 10, computed again: its curves are the accepted ones. The tolerance is that of the golden reports; bands of resamples
/// follow the counts, and are compared through them.
#[test]
fn one_tank_of_the_farm_gives_its_accepted_curves() {
    let example = Path::new(env!("CARGO_MANIFEST_DIR")).join("examples/10_tank_farm");
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path();
    let study = example.join("study.json");
    let plan = tankcheck(path, &["study", "plan", study.to_str().unwrap(), "--out", "farm"]);
    assert!(plan.status.success(), "{}", said(&plan));
    assert!(said(&plan).contains("1120"), "{}", said(&plan));
    let run = tankcheck(path, &["study", "run", "farm", "--task", "1"]);
    assert_eq!(run.status.code(), Some(0), "{}", said(&run));
    let merge = tankcheck(path, &["study", "merge", "farm", "--partial"]);
    assert!(merge.status.success(), "{}", said(&merge));
    let read = |file: &Path| -> serde_json::Value { serde_json::from_str(&fs::read_to_string(file).unwrap()).unwrap() };
    let (found, accepted) = (read(&path.join("farm/fragility.json")), read(&example.join("expected/fragility.json")));
    let curves = found["curves"].as_array().unwrap();
    assert_eq!(curves.len(), 3, "one tank, three states");
    for curve in curves {
        let same = |other: &&serde_json::Value| {
            other["tank"] == curve["tank"] && other["damage_state"] == curve["damage_state"]
        };
        let other = accepted["curves"].as_array().unwrap().iter().find(same).unwrap();
        for key in ["status", "n", "points", "unchecked", "reason", "bounds"] {
            assert_eq!(curve[key], other[key], "{key} of {curve}");
        }
        for key in ["median", "dispersion"] {
            match (curve[key].as_f64(), other[key].as_f64()) {
                (Some(a), Some(b)) => assert!((a / b - 1.0).abs() < 1e-6, "{key}: {a} {b}"),
                (a, b) => assert_eq!(a, b),
            }
        }
    }
}

/// Where a code leaves a tank no capacity, its utilisation is infinite; `merge` accepts that.
#[test]
fn a_tank_without_any_capacity_is_merged() {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path();
    let example = Path::new(env!("CARGO_MANIFEST_DIR")).join("examples/05_oil_tank/tank.json");
    let tank = fs::read_to_string(example).unwrap();
    let shaken = tank.replace(r#""ag": "0.12 g""#, r#""ag": "2.4 g""#);
    assert_ne!(shaken, tank);
    fs::write(path.join("tank.json"), shaken).unwrap();
    let study = r#"{ "name": "none left", "tanks": [{ "files": "tank.json" }], "engine": "none" }"#;
    fs::write(path.join("study.json"), study).unwrap();
    for command in
        [&["study", "plan", "study.json", "--out", "out"][..], &["study", "run", "out"], &["study", "merge", "out"]]
    {
        let output = tankcheck(path, command);
        assert!(output.status.success(), "{command:?}: {}", said(&output));
    }
    let tanks = fs::read_to_string(path.join("out/tanks.csv")).unwrap();
    assert!(tanks.lines().nth(1).unwrap().starts_with("tank,0,fails,ec8-2006,sliding,,"), "{tanks}");
    let page = fs::read_to_string(path.join("out/report.html")).unwrap();
    assert!(page.contains("no capacity is left"));
}

/// `init --study` says which commands make what its file names and compute it; they run as written, and what is there is not made again.
#[test]
fn the_starter_runs_as_written() {
    let folder = tempfile::tempdir().unwrap();
    let home = folder.path();
    let started = tankcheck(home, &["init", "--study", "--out", "study.json"]);
    assert!(started.status.success(), "{}", said(&started));
    let text = String::from_utf8_lossy(&started.stderr).into_owned();
    let commands: Vec<Vec<&str>> = text
        .lines()
        .filter_map(|line| line.trim().strip_prefix("tankcheck "))
        .map(|c| c.split(' ').collect())
        .collect();
    assert_eq!(commands.len(), 5, "{text}");
    // They are those of the file's own comment.
    let file = fs::read_to_string(home.join("study.json")).unwrap();
    for command in &commands {
        assert!(file.contains(&format!("//   tankcheck {}\n", command.join(" "))), "{command:?}");
        let run = tankcheck(home, command);
        assert!(matches!(run.status.code(), Some(0 | 1 | 4)), "{command:?}: {}", said(&run));
    }
    let rows = fs::read_to_string(home.join("farm/rows.csv")).unwrap();
    // One tank under seven records at twelve levels.
    assert_eq!(rows.lines().filter(|line| !line.starts_with('#')).count(), 1 + 7 * 12, "{rows}");
    assert!(home.join("farm/report.html").is_file());
    let again = tankcheck(home, &["init", "--study", "--out", "study.json", "--force"]);
    let text = String::from_utf8_lossy(&again.stderr).into_owned();
    assert!(!text.contains("tankcheck init") && !text.contains("synth") && text.contains("study run farm/"), "{text}");
}
