//! `tankcheck study`: clocks, scripts of schedulers, and a nonlinear study that is killed.

use std::fs;
use std::path::Path;
use std::process::{Command, Stdio};
use std::time::{Duration, SystemTime};

use crate::study::{finished, folder, merged, results, said, tankcheck};

/// A clock that is set back, or far ahead: the state of a study is in the contents of its files, and no time is read.
#[test]
fn the_clock_does_not_matter() {
    let (folder, whole) = finished();
    let path = folder.path();
    let year = Duration::from_secs(365 * 86_400);
    for (at, task) in [(SystemTime::UNIX_EPOCH, "1"), (SystemTime::now() + 30 * year, "2")] {
        for name in ["study.json", "tank.json", "farm.csv", "rec0.csv", "out/plan.json", "out/tasks.jsonl"] {
            let file = fs::File::options().append(true).open(path.join(name)).unwrap();
            file.set_modified(at).unwrap();
        }
        for file in results(&path.join("out")) {
            fs::File::options().append(true).open(file).unwrap().set_modified(at).unwrap();
        }
        let again = tankcheck(path, &["study", "run", "out"]);
        assert!(said(&again).contains("0 tasks computed, 6 kept"), "{}", said(&again));
        assert_eq!(merged(path, "out"), whole);
        // A result that is missing is computed beside files of another time.
        fs::remove_file(&results(&path.join("out"))[0]).unwrap();
        let again = tankcheck(path, &["study", "run", "out"]);
        assert!(said(&again).contains("1 tasks computed, 5 kept"), "{task}: {}", said(&again));
        assert_eq!(merged(path, "out"), whole);
    }
}

/// Runs a shell in the folder of a study, with the program and stubs of a scheduler on the path.
#[cfg(unix)]
fn shell(out: &Path, stubs: &Path, command: &str, environment: &[(&str, &str)]) -> std::process::Output {
    let program = Path::new(env!("CARGO_BIN_EXE_tankcheck")).parent().unwrap();
    let path = format!("{}:{}:{}", stubs.display(), program.display(), std::env::var("PATH").unwrap_or_default());
    Command::new("sh")
        .args(["-c", command])
        .current_dir(out)
        .env("PATH", path)
        .envs(environment.iter().copied())
        .output()
        .unwrap()
}

/// The written scripts, run by a shell: `hq` is a stub that starts one process for each number of its array, as the scheduler would; the array
/// elements of Slurm and PBS are started one by one. Each gives the rows of the local run.
#[cfg(unix)]
#[test]
fn the_written_scripts_run() {
    use std::os::unix::fs::PermissionsExt;
    let (folder, whole) = finished();
    let path = folder.path();
    let stubs = path.join("stubs");
    fs::create_dir(&stubs).unwrap();
    // hq submit --array A-B … -- command
    let hq = "#!/bin/sh\n[ \"$1 $2\" = 'submit --array' ] || exit 9\nfirst=${3%-*} last=${3#*-}\nwhile [ \"$1\" != -- ]; do shift; done\nshift\n\
              k=$first\nwhile [ \"$k\" -le \"$last\" ]; do HQ_TASK_ID=$k \"$@\" || exit; k=$((k + 1)); done\n";
    fs::write(stubs.join("hq"), hq).unwrap();
    fs::set_permissions(stubs.join("hq"), fs::Permissions::from_mode(0o755)).unwrap();
    let given = "--name='north farm'";
    for (engine, script, variable) in
        [("hq", "hq.sh", ""), ("slurm", "slurm.sh", "SLURM_ARRAY_TASK_ID"), ("pbs", "pbs.sh", "PBS_ARRAY_INDEX")]
    {
        let plan = tankcheck(
            path,
            &["study", "plan", "study.json", "--out", engine, "--for", engine, "--scheduler-args", given],
        );
        assert!(plan.status.success(), "{}", said(&plan));
        let out = path.join(engine);
        let text = fs::read_to_string(out.join(script)).unwrap();
        assert!(text.contains(given), "{text}");
        let syntax = shell(&out, &stubs, &format!("sh -n {script}"), &[]);
        assert!(syntax.status.success(), "{script}: {}", said(&syntax));
        let home = out.to_str().unwrap().to_owned();
        let elements: &[&str] = if variable.is_empty() { &[""] } else { &["1", "2", "3", "4", "5", "6"] };
        for element in elements {
            let environment = [(variable, *element), ("PBS_O_WORKDIR", home.as_str())];
            let environment: Vec<_> = environment.into_iter().filter(|(name, _)| !name.is_empty()).collect();
            let ran = shell(&out, &stubs, &format!("sh {script}"), &environment);
            assert!(ran.status.success(), "{script} {element}: {}", said(&ran));
        }
        assert_eq!(merged(path, engine), whole, "{engine}");
    }
}

/// Ten records at eight scales of a strip whose walls crack, one task for each record: killed five times, then finished by two workers at once. Short records
/// keep it small; the walls crack at the upper scales.
#[test]
#[ignore = "slow: cargo test --test cli study_machines -- --ignored; last result in docs/verification/slow-tests.md"]
fn a_nonlinear_study_is_killed_and_resumed() {
    let folder = folder();
    let path = folder.path();
    let example = Path::new(env!("CARGO_MANIFEST_DIR")).join("examples/06_sandwich_strip/tank.json");
    // Coarser than the example, and without its free vibration: the same study in seconds.
    let mut strip = fs::read_to_string(example).unwrap();
    for (of, to) in [
        ("\"height\": 40", "\"height\": 20"),
        ("\"midpoint 20\"", "\"midpoint 8\""),
        ("\"time_step\": \"2.5 ms\"", "\"time_step\": \"5 ms\", \"after_record\": \"none\""),
    ] {
        assert!(strip.contains(of), "{of}");
        strip = strip.replace(of, to);
    }
    fs::write(path.join("strip.json"), strip).unwrap();
    for k in 0..10 {
        let mut text = String::from("time_s,acceleration_m_s2\n");
        for i in 0..=40 {
            let t = 0.01 * f64::from(i);
            let a = 6.0 * ((40.0 + 3.0 * f64::from(k)) * t).sin();
            text.push_str(&format!("{t:.2},{a:.6}\n"));
        }
        fs::write(path.join(format!("pulse{k}.csv")), text).unwrap();
    }
    let study = r#"{ "name": "strips", "tanks": [ { "files": "strip.json" } ], "records": [ { "files": "pulse*.csv" } ],
        "scales": { "im": "PGA", "levels": ["0.5 m/s2", "1 m/s2", "1.5 m/s2", "2 m/s2", "3 m/s2", "4 m/s2", "5 m/s2", "6 m/s2"] },
        "engine": "nonlinear", "block": 1 }"#;
    fs::write(path.join("study.json"), study).unwrap();
    for out in ["serial", "killed"] {
        let plan = tankcheck(path, &["study", "plan", "study.json", "--out", out]);
        assert!(said(&plan).contains("80"), "{}", said(&plan));
    }
    let run = tankcheck(path, &["study", "run", "serial", "--jobs", "1"]);
    assert_eq!(run.status.code(), Some(0), "{}", said(&run));
    let whole = merged(path, "serial");
    let start = |shard: &str| {
        Command::new(env!("CARGO_BIN_EXE_tankcheck"))
            .args(["study", "run", "killed", "--jobs", "1", "--quiet", "--shard", shard])
            .current_dir(path)
            .stdout(Stdio::null())
            .stderr(Stdio::null())
            .spawn()
            .unwrap()
    };
    for k in 0..5_u64 {
        let mut both = [start("1/2"), start("2/2")];
        std::thread::sleep(Duration::from_millis(700 + 900 * k));
        for child in &mut both {
            child.kill().unwrap();
            child.wait().unwrap();
        }
    }
    let mut both = [start("1/2"), start("2/2")];
    for child in &mut both {
        assert!(child.wait().unwrap().success());
    }
    assert_eq!(merged(path, "killed"), whole);
    let rows = fs::read_to_string(path.join("killed/rows.csv")).unwrap();
    assert_eq!(rows.lines().count(), 81);
    assert!(rows.contains(",ok,"), "{rows}");
}
