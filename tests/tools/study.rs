//! Studies where another program is needed: file systems that are full or read-only (`unshare` of util-linux), HyperQueue and Snakemake (PyPI).
//!
//! HyperQueue listens on every interface, so its cluster starts in a network namespace of its own with nothing but `lo`.

use std::fs;
use std::path::Path;
use std::process::{Command, Output, Stdio};
use std::time::Duration;

const PROGRAM: &str = env!("CARGO_BIN_EXE_tankcheck");
const TANK: &str = include_str!("../../examples/01_broad_tank/tank.json");

fn tankcheck(folder: &Path, arguments: &[&str]) -> Output {
    let mut command = Command::new(PROGRAM);
    command.args(arguments).current_dir(folder).output().expect("the program starts")
}

fn said(output: &Output) -> String {
    String::from_utf8_lossy(&output.stdout).into_owned() + &String::from_utf8_lossy(&output.stderr)
}

/// A study of tanks × records tasks of two rows each, planned in `out`.
fn planned(tanks: usize, records: usize, out: &[&str]) -> tempfile::TempDir {
    let folder = tempfile::tempdir().expect("a temporary folder");
    let write = |name: &str, text: &str| fs::write(folder.path().join(name), text).expect("writable");
    write("tank.json", TANK);
    let rows: String = (0..tanks).map(|k| format!("T{k},{:.3} m\n", 1.0 + 0.05 * k as f64)).collect();
    write("farm.csv", &format!("tag,liquid.fill_height\n{rows}"));
    for k in 0..records {
        let at = |i: i32| {
            let t = 0.01 * f64::from(i);
            (6.3 * t).sin() + 0.5 * ((11.0 + 3.0 * k as f64) * t).cos() * (-0.3 * t).exp()
        };
        let lines: String = (0..400).map(|i| format!("{:.2},{:.6}\n", 0.01 * f64::from(i), at(i))).collect();
        write(&format!("rec{k}.csv"), &format!("time_s,acceleration_m_s2\n{lines}"));
    }
    write(
        "study.json",
        r#"{ "name": "many tasks", "tanks": [ { "template": "tank.json", "table": "farm.csv", "id": "tag" } ],
            "records": [ { "files": "rec*.csv" } ], "scales": { "im": "PGA", "levels": ["0.1 g", "0.4 g"] }, "block": 1 }"#,
    );
    for out in out {
        let plan = tankcheck(folder.path(), &["study", "plan", "study.json", "--out", out, "--for", "snakemake"]);
        assert!(plan.status.success(), "{}", said(&plan));
    }
    folder
}

/// The page of a small study.
pub(crate) fn page() -> String {
    let folder = planned(2, 3, &["out"]);
    for arguments in [["study", "run", "out"], ["study", "merge", "out"]] {
        let output = tankcheck(folder.path(), &arguments);
        assert!(output.status.success(), "{}", said(&output));
    }
    fs::read_to_string(folder.path().join("out/report.html")).expect("a page")
}

fn merged(folder: &Path, out: &str) -> String {
    let merge = tankcheck(folder, &["study", "merge", out]);
    assert!(merge.status.success(), "{}", said(&merge));
    fs::read_to_string(folder.join(out).join("rows.sha256")).expect("the hash")
}

/// A shell in namespaces of its own: mounts and network of the machine stay as they are.
fn apart(unshare: &Path, folder: &Path, script: &str) -> Output {
    Command::new(unshare)
        .args(["--mount", "--net", "--map-root-user", "sh", "-c", script])
        .current_dir(folder)
        .output()
        .expect("unshare starts")
}

/// A folder that cannot be written is one message before anything is computed, and nothing is lost.
pub(crate) fn a_read_only_folder_is_one_message(unshare: &Path) {
    let folder = planned(2, 2, &["out", "whole"]);
    let path = folder.path();
    tankcheck(path, &["study", "run", "whole"]);
    tankcheck(path, &["study", "run", "out", "--task", "1"]);
    let script =
        format!("mount --bind out out && mount -o remount,ro,bind out && cd . && exec {PROGRAM} study run out");
    let found = apart(unshare, path, &script);
    assert_eq!(found.status.code(), Some(3), "{}", said(&found));
    let text = said(&found);
    assert!(text.contains("cannot be written") && text.contains("ead-only"), "{text}");
    assert_eq!(text.matches("cannot be written").count(), 1, "{text}");
    let run = tankcheck(path, &["study", "run", "out"]);
    assert!(said(&run).contains("3 tasks computed, 1 kept"), "{}", said(&run));
    assert_eq!(merged(path, "out"), merged(path, "whole"));
}

/// A disk that fills up while a study runs: what was written before stays whole, the message names the file, and with room the rest is computed.
pub(crate) fn a_full_disk_loses_nothing(unshare: &Path) {
    let folder = planned(4, 4, &["out", "whole"]);
    let path = folder.path();
    tankcheck(path, &["study", "run", "whole"]);
    fs::create_dir(path.join("kept")).expect("writable");
    // Room for the plan and a few results: pages of 4 KB.
    let script = format!(
        "mkdir small && mount -t tmpfs -o size=48k tmpfs small && cp out/plan.json out/tasks.jsonl small/; \
         {PROGRAM} study run small --jobs 1; echo \"exit $?\"; {PROGRAM} study status small --format json; cp -r small/. kept/"
    );
    let found = apart(unshare, path, &script);
    let text = said(&found);
    assert!(text.contains("exit 3") && text.contains("cannot be written") && text.contains("o space"), "{text}");
    let status = text.find("{\n").map(|at| &text[at..]).expect("a status");
    let status: serde_json::Value =
        serde_json::Deserializer::from_str(status).into_iter().next().expect("a status").expect("JSON");
    let done = status["done"].as_u64().expect("a number");
    assert!((1..16).contains(&done) && status["damaged"] == 0, "{status}");
    let run = tankcheck(path, &["study", "run", "kept"]);
    let wanted = format!("{} tasks computed, {done} kept", 16 - done);
    assert!(said(&run).contains(&wanted), "{wanted}: {}", said(&run));
    assert_eq!(merged(path, "kept"), merged(path, "whole"));
}

/// 100 tasks by HyperQueue: killed with server, worker and tasks after a few, submitted again in a new cluster; the rows are those of local threads.
pub(crate) fn hyperqueue_is_killed_and_resumed(python: &Path) {
    let folder = planned(10, 10, &["out", "hq"]);
    let path = folder.path();
    tankcheck(path, &["study", "run", "out"]);
    let whole = merged(path, "out");
    let script = r#"
import os, sys
from hyperqueue import Job, LocalCluster
from hyperqueue.cluster import WorkerConfig
program = sys.argv[1]
with LocalCluster() as cluster:
    cluster.start_worker(WorkerConfig(cores=2))
    client = cluster.client()
    job = Job()
    for k in range(1, 101):
        job.program([program, "study", "run", "hq", "--task", str(k), "--quiet"], cwd=os.getcwd())
    client.wait_for_jobs([client.submit(job)])
"#;
    fs::write(path.join("cluster.py"), script).expect("writable");
    let start = || {
        use std::os::unix::process::CommandExt;
        let command = format!("ip link set lo up 2>/dev/null; exec {} cluster.py {PROGRAM}", python.display());
        Command::new("unshare")
            .args(["--net", "--map-root-user", "sh", "-c", &command])
            .current_dir(path)
            .process_group(0)
            .stdout(Stdio::null())
            .stderr(Stdio::piped())
            .spawn()
            .expect("the cluster starts")
    };
    let count = || -> u64 {
        let status = tankcheck(path, &["study", "status", "hq", "--format", "json"]);
        let status: serde_json::Value = serde_json::from_slice(&status.stdout).expect("JSON");
        assert_eq!((&status["damaged"], &status["failed"]), (&0.into(), &0.into()), "{status}");
        status["done"].as_u64().expect("a number")
    };
    let mut cluster = start();
    let mut done = 0;
    for _ in 0..600 {
        std::thread::sleep(Duration::from_millis(100));
        done = count();
        if done >= 5 || cluster.try_wait().expect("a process").is_some() {
            break;
        }
    }
    // Server and worker are threads of one process; its group has the tasks.
    let group = format!("-{}", cluster.id());
    Command::new("kill").args(["-9", "--", &group]).status().expect("kill starts");
    let ended = cluster.wait_with_output().expect("a process");
    assert!((5..100).contains(&done), "{done} done: {}", said(&ended));
    let again = start().wait_with_output().expect("a process");
    assert!(again.status.success(), "{}", said(&again));
    assert_eq!(count(), 100);
    assert_eq!(merged(path, "hq"), whole);
}

/// The written array script under a Slurm of one node: tasks and their supervisors are killed after a few, the job is cancelled and submitted again. What
/// was finished is kept, and the rows are those of local threads.
pub(crate) fn a_slurm_array_is_killed_and_resumed(node: &Path) {
    let folder = planned(4, 4, &["out", "slurm"]);
    let path = folder.path();
    tankcheck(path, &["study", "run", "out"]);
    let whole = merged(path, "out");
    let plan = tankcheck(path, &["study", "plan", "study.json", "--out", "slurm", "--for", "slurm"]);
    assert!(plan.status.success(), "{}", said(&plan));
    let script = r#"
done_of() { tankcheck study status . --format json | sed -n 's/^ *"done": \([0-9]*\).*/\1/p'; }
first=$(sbatch --parsable slurm.sh)
for _ in $(seq 600); do [ "$(done_of)" -ge 3 ] && break; sleep 0.1; done
kill -9 $(pidof slurmstepd tankcheck)
scancel "$first"
while squeue --noheader | grep -q .; do sleep 0.2; done
echo "done $(done_of)"
sbatch --wait slurm.sh
echo "exit $?"
sacct=$(scontrol show job | grep -c 'JobState=COMPLETED')
echo "completed $sacct"
"#;
    let folder_of_program = Path::new(PROGRAM).parent().expect("a folder").display();
    let found = Command::new(node)
        .args(["sh", "-c", script])
        .current_dir(path.join("slurm"))
        .env("PATH", format!("{folder_of_program}:{}", std::env::var("PATH").unwrap_or_default()))
        .output()
        .expect("the node starts");
    let text = said(&found);
    let done = text.split("done ").nth(1).and_then(|rest| rest.lines().next());
    let done: u64 = done.and_then(|number| number.parse().ok()).unwrap_or_else(|| panic!("{text}"));
    assert!((3..16).contains(&done) && text.contains("exit 0"), "{text}");
    assert_eq!(merged(path, "slurm"), whole, "{text}");
    // One log for the array, and nothing in it.
    let logs = fs::read_dir(path.join("slurm")).expect("a folder").filter(|entry| {
        let name = entry.as_ref().expect("an entry").file_name();
        name.to_string_lossy().ends_with(".log")
    });
    assert!(logs.count() <= 2, "{text}");
}

/// The rows as pandas reads them from rows.parquet and from rows.csv: the same columns, words and numbers.
pub(crate) fn pandas_reads_the_rows(python: &Path) {
    let folder = planned(2, 2, &["out"]);
    let path = folder.path();
    tankcheck(path, &["study", "run", "out"]);
    merged(path, "out");
    let script = r#"
import pandas
table, columns = pandas.read_csv("out/rows.csv"), pandas.read_parquet("out/rows.parquet")
extra = [name for name in columns.columns if name.endswith("_ending")]
assert list(columns.columns.drop(extra)) == list(table.columns), columns.columns
for name in table.columns:
    of = name.removesuffix("_utilisation") + "_ending"
    if of in extra:
        words = pandas.to_numeric(table[name], errors="coerce").isna() & table[name].notna()
        assert columns[of].notna().equals(words) and columns[of][words].equals(table[name][words])
        numbers = pandas.to_numeric(table[name], errors="coerce")
    else:
        numbers = table[name]
    if pandas.api.types.is_numeric_dtype(columns[name]):
        assert (columns[name].astype(float).fillna(-1) == numbers.astype(float).fillna(-1)).all(), name
    else:
        assert (columns[name].fillna("") == numbers.fillna("").astype(str)).all(), name
print(len(table), "rows")
"#;
    let found = Command::new(python).args(["-c", script]).current_dir(path).output().expect("python starts");
    assert!(said(&found).contains("8 rows"), "{}", said(&found));
}

/// The written Snakefile computes and merges a study.
pub(crate) fn snakemake_runs_the_written_rule(snakemake: &Path) {
    let folder = planned(2, 2, &["out", "snake"]);
    let path = folder.path();
    tankcheck(path, &["study", "run", "out"]);
    let whole = merged(path, "out");
    let folder_of_program = Path::new(PROGRAM).parent().expect("a folder").display();
    let found = Command::new(snakemake)
        .args(["-j", "2", "--quiet", "all"])
        .current_dir(path.join("snake"))
        .env("PATH", format!("{folder_of_program}:{}", std::env::var("PATH").unwrap_or_default()))
        .env("HOME", path)
        .output()
        .expect("snakemake starts");
    assert!(found.status.success(), "{}", said(&found));
    assert_eq!(fs::read_to_string(path.join("snake/rows.sha256")).expect("the hash"), whole);
}
