//! `tankcheck study`: sets of files with one commit point, results that belong to their tasks, and what `plan` refuses.

use std::fs;
use std::path::Path;
use std::process::{Child, Command, Stdio};
use std::time::{Duration, Instant};

use crate::study::{STUDY, finished, folder, merged, planned, results, said, tankcheck};

fn json(path: &Path) -> serde_json::Value {
    serde_json::from_str(&fs::read_to_string(path).unwrap()).unwrap()
}

fn start(folder: &Path, arguments: &[&str]) -> Child {
    Command::new(env!("CARGO_BIN_EXE_tankcheck"))
        .args(arguments)
        .current_dir(folder)
        .stdout(Stdio::null())
        .stderr(Stdio::piped())
        .spawn()
        .unwrap()
}

/// Whether the merged files are of one merge: rows of the tasks that `fragility.json` does not count as missing, with their hash, in the report too.
fn one_set(out: &Path) -> u64 {
    let rows = fs::read_to_string(out.join("rows.csv")).unwrap();
    let missing = json(&out.join("fragility.json"))["missing_tasks"].as_u64().unwrap();
    let sums = Command::new("sha256sum").arg("-c").arg("rows.sha256").current_dir(out).output().unwrap();
    assert!(sums.status.success(), "{}", said(&sums));
    // The first task has two records at four levels.
    assert_eq!(rows.lines().count() as u64, 41 - 8 * missing);
    let page = fs::read_to_string(out.join("report.html")).unwrap();
    assert_eq!(page.contains("tasks have no result"), missing > 0);
    missing
}

#[test]
fn merges_at_once_are_one_after_the_other() {
    let (folder, whole) = finished();
    let path = folder.path();
    for round in 0..4 {
        let both = [0, 1, 2].map(|_| start(path, &["study", "merge", "out", "--quiet"]));
        for merge in both {
            let output = merge.wait_with_output().unwrap();
            assert!(output.status.success(), "{round}: {}", said(&output));
        }
        assert_eq!(one_set(&path.join("out")), 0);
        assert_eq!(fs::read_to_string(path.join("out/rows.sha256")).unwrap(), whole);
    }
    let check = tankcheck(path, &["study", "check", "out"]);
    assert_eq!(check.status.code(), Some(0), "{}", said(&check));
    let hidden = fs::read_dir(path.join("out")).unwrap().flatten();
    assert_eq!(hidden.filter(|e| e.file_name().to_string_lossy().starts_with('.')).count(), 0);
}

/// A merge with one task more or less over the files of the other is killed at any moment: the files are those of one of both.
#[test]
fn a_killed_merge_leaves_one_set() {
    let (folder, _) = finished();
    let path = folder.path();
    let out = path.join("out");
    let merge = ["study", "merge", "out", "--partial", "--quiet"];
    let first = json_lines(&out.join("tasks.jsonl"))[0]["key"].as_str().unwrap().to_owned();
    let file = out.join("results").join(&first[..2]).join(format!("{first}.jsonl"));
    let kept = fs::read(&file).unwrap();
    let began = Instant::now();
    merged(path, "out");
    let usual = began.elapsed();
    let kills = 12;
    let mut seen = [0, 0];
    for k in 0..kills {
        match k % 2 {
            0 => fs::remove_file(&file).unwrap(),
            _ => fs::write(&file, &kept).unwrap(),
        }
        let mut child = start(path, &merge);
        std::thread::sleep(usual.mul_f64((f64::from(k) * 0.618).fract()));
        child.kill().unwrap();
        child.wait().unwrap();
        // Any command that reads the folder finishes the moves of a killed one.
        tankcheck(path, &["study", "status", "out"]);
        seen[one_set(&out) as usize] += 1;
        let check = tankcheck(path, &["study", "check", "out"]);
        assert_eq!(check.status.code(), Some(0), "{k}: {}", said(&check));
    }
    println!("{seen:?} of {kills} merges with no and one missing task, usual time {usual:?}");
    fs::write(&file, &kept).unwrap();
    merged(path, "out");
    assert_eq!(one_set(&out), 0);
}

fn json_lines(path: &Path) -> Vec<serde_json::Value> {
    let text = fs::read_to_string(path).unwrap();
    text.lines().map(|line| serde_json::from_str(line).unwrap()).collect()
}

/// A plan and the list of its tasks belong together.
#[test]
fn a_plan_is_one_set() {
    let folder = planned();
    let path = folder.path();
    let tasks = path.join("out/tasks.jsonl");
    let before = fs::read_to_string(&tasks).unwrap();
    let less: String = before.lines().rev().map(|line| format!("{line}\n")).collect();
    fs::write(&tasks, &less).unwrap();
    for command in ["run", "merge", "status", "check"] {
        let output = tankcheck(path, &["study", command, "out"]);
        assert_eq!(output.status.code(), Some(2), "{command}: {}", said(&output));
        assert!(said(&output).contains("plan again"), "{}", said(&output));
    }
    fs::remove_file(&tasks).unwrap();
    // Plans at once: each is whole.
    let all = [0, 1, 2].map(|_| start(path, &["study", "plan", "study.json", "--out", "out", "--quiet"]));
    for plan in all {
        let output = plan.wait_with_output().unwrap();
        assert!(output.status.success(), "{}", said(&output));
    }
    assert_eq!(fs::read_to_string(&tasks).unwrap(), before);
    assert_eq!(tankcheck(path, &["study", "run", "out"]).status.code(), Some(0));
    merged(path, "out");
    // A table that was edited is not overwritten, and `check` names it.
    fs::write(path.join("out/rows.csv"), "mine").unwrap();
    let check = tankcheck(path, &["study", "check", "out"]);
    assert_eq!(check.status.code(), Some(3));
    assert!(said(&check).contains("rows.csv was changed"), "{}", said(&check));
    let output = tankcheck(path, &["study", "merge", "out"]);
    assert_eq!(output.status.code(), Some(2), "{}", said(&output));
    assert!(said(&output).contains("`rows.csv` has changed"), "{}", said(&output));
    assert_eq!(fs::read_to_string(path.join("out/rows.csv")).unwrap(), "mine");
}

/// A result copied over that of another task, and a pipe in the place of one: told by `status`, `check` and `merge`, and computed again by `run`.
#[cfg(unix)]
#[test]
fn a_result_of_another_task_is_damaged() {
    let (folder, whole) = finished();
    let path = folder.path();
    let out = path.join("out");
    let files = results(&out);
    fs::copy(&files[0], &files[3]).unwrap();
    fs::remove_file(&files[1]).unwrap();
    assert!(Command::new("mkfifo").arg(&files[1]).status().unwrap().success());
    let began = Instant::now();
    let status = tankcheck(path, &["study", "status", "out", "--format", "json"]);
    let status: serde_json::Value = serde_json::from_slice(&status.stdout).unwrap();
    assert_eq!((&status["done"], &status["damaged"]), (&4.into(), &2.into()));
    let check = tankcheck(path, &["study", "check", "out"]);
    assert_eq!(check.status.code(), Some(3), "{}", said(&check));
    let key = files[3].file_stem().unwrap().to_string_lossy().into_owned();
    for wanted in [key.as_str(), "is the result of another task", "found a named pipe"] {
        assert!(said(&check).contains(wanted), "{wanted}: {}", said(&check));
    }
    let merge = tankcheck(path, &["study", "merge", "out"]);
    assert_eq!(merge.status.code(), Some(2));
    assert!(said(&merge).contains("2 of 6 tasks") && said(&merge).contains(&key), "{}", said(&merge));
    let partial = tankcheck(path, &["study", "merge", "out", "--partial"]);
    assert!(said(&partial).contains("2 of them have a damaged one"), "{}", said(&partial));
    assert!(began.elapsed() < Duration::from_secs(60));
    let run = tankcheck(path, &["study", "run", "out"]);
    assert!(said(&run).contains("2 tasks computed, 4 kept"), "{}", said(&run));
    assert!(said(&run).contains("damaged results, computed again: 2"), "{}", said(&run));
    assert_eq!(merged(path, "out"), whole);
    let check = tankcheck(path, &["study", "check", "out", "--format", "json"]);
    let check: serde_json::Value = serde_json::from_slice(&check.stdout).unwrap();
    assert_eq!((&check["sound"], &check["damaged"]), (&6.into(), &serde_json::json!([])));
}

/// A study of four samples of the tanks of the table.
fn sampled(path: &str, low: &str, high: &str) -> String {
    let sample = format!(
        r#""sample": {{ "n": 4, "parameters": [
    {{ "path": {path:?}, "uniform": {{ "low": {low:?}, "high": {high:?} }} }} ] }},
  "block": 5"#
    );
    STUDY.replace("\"block\": 2", &sample).replace("rec*", "rec0")
}

/// What no draw mends is a fault of the study file; a value that is not possible is a row of it.
#[test]
fn plan_refuses_what_no_sample_mends() {
    let folder = folder();
    let path = folder.path();
    let plan = |text: &str| {
        fs::write(path.join("study.json"), text).unwrap();
        tankcheck(path, &["study", "plan", "study.json", "--out", "out"])
    };
    for (parameter, low, high, wanted) in [
        ("liquid.fil_height", "1 m", "1.4 m", "unknown key"),
        ("liquid.fill_height", "1 kg", "2 kg", "a unit of a mass, not of a length"),
        ("liquid.fill_height", "1", "2", "without"),
        ("liquid.fill_height", "1 parsec", "2 parsec", "unit"),
        ("tank.courses[7].thickness", "1 mm", "2 mm", "found index 7"),
        ("tank.courses", "1 mm", "2 mm", "expected one value"),
        ("tank.courses[0", "1 mm", "2 mm", "not a path"),
        ("tank.support", "1 m", "2 m", ""),
        ("tank.radius.inner", "1 m", "2 m", "does not have the key"),
        ("liquid.fill_height", "40 m", "50 m", "no sample of the tank `A` is possible"),
        ("liquid.density", "-2 kg/m3", "-1 kg/m3", "no sample of the tank `A` is possible"),
    ] {
        let output = plan(&sampled(parameter, low, high));
        let text = said(&output);
        assert_eq!(output.status.code(), Some(2), "{parameter}: {text}");
        assert!(text.contains(wanted) && text.contains("tank `A`"), "{parameter}: {text}");
        assert!(text.contains("study.json:7"), "{parameter}: {text}");
        assert!(!path.join("out").exists());
    }
    // Some are possible, some are not, in a table and from another folder.
    let output = plan(&sampled("liquid.fill_height", "1 m", "3 m"));
    assert!(output.status.success(), "{}", said(&output));
    let output = tankcheck(path, &["study", "run", path.join("out").to_str().unwrap()]);
    assert_eq!(output.status.code(), Some(0), "{}", said(&output));
    merged(path, "out");
    let rows = fs::read_to_string(path.join("out/rows.csv")).unwrap();
    assert!(rows.contains(",refused,") && rows.contains(",ok,"), "{rows}");
    assert!(!rows.contains(path.to_str().unwrap()) && !rows.contains("farm.csv"), "{rows}");
}

/// Names, patterns, pipes and arguments of schedulers have their limits, told by `plan`.
#[cfg(unix)]
#[test]
fn plan_refuses_what_has_no_bound() {
    let folder = folder();
    let path = folder.path();
    let plan = |arguments: &[&str]| {
        let began = Instant::now();
        let output = tankcheck(path, &[&["study", "plan", "study.json", "--out", "out"], arguments].concat());
        assert_eq!(output.status.code(), Some(2), "{}", said(&output));
        assert!(began.elapsed() < Duration::from_secs(20), "{:?}", began.elapsed());
        said(&output)
    };
    for (pattern, wanted) in [
        ("/**/*", "too many files"),
        ("/**/*.none", "too many files and folders"),
        ("/*/*/*/*/*/*/*.none", "file"),
        ("**/**/**/none", "no file matches"),
    ] {
        fs::write(path.join("study.json"), STUDY.replace("rec*.csv", pattern)).unwrap();
        let text = plan(&[]);
        assert!(text.contains(wanted) && text.contains("study.json:4"), "{pattern}: {text}");
    }
    fs::write(path.join("study.json"), STUDY).unwrap();
    for arguments in ["--time=1\nrm -rf x", "a\rb", "\u{1b}[2J"] {
        let text = plan(&["--for", "slurm", "--scheduler-args", arguments]);
        assert!(text.contains("--scheduler-args") && text.contains("one line"), "{text}");
    }
    for (tag, wanted) in [("x".repeat(300), "has 300 characters"), (String::new(), "is empty")] {
        fs::write(path.join("farm.csv"), format!("tag,liquid.fill_height\nA,1.5 m\n{tag},1.2 m\n")).unwrap();
        let text = plan(&[]);
        assert!(text.contains(wanted) && text.contains("farm.csv:3") && text.contains("1 to 200"), "{text}");
    }
    fs::remove_file(path.join("farm.csv")).unwrap();
    assert!(Command::new("mkfifo").arg(path.join("farm.csv")).status().unwrap().success());
    assert!(plan(&[]).contains("not a regular file"));
}
