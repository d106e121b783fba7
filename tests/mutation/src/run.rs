//! Runs the tests once per mutant and reports the outcomes by module.

use std::collections::{BTreeMap, BTreeSet};
use std::io::{BufRead, BufReader, Write};
use std::os::unix::process::ExitStatusExt;
use std::path::Path;
use std::process::{Command, Stdio};
use std::time::Instant;

use serde_json::Value;

use crate::sample::{self, module};

/// Limit of a mutant's address space [KiB].
const MEMORY: u64 = 8 << 20;
/// SIGXCPU, sent when the limit of CPU time is reached, and SIGKILL after it.
const OUT_OF_TIME: [i32; 2] = [24, 9];
/// Limit of the CPU time of a process: so many times what its tests take without a mutant (as cargo-mutants), at least
/// 2 s.
const TIMES: f64 = 5.0;
const LEAST_SECONDS: f64 = 2.0;
/// A test that takes longer [s] runs in a separate process, after the quick ones.
const SLOW: f64 = 0.25;
/// Cases of a property test that does not set its own number.
const CASES: &str = "16";

/// A test of one of the binaries.
struct Test {
    binary: String,
    name: String,
    /// Time without a mutant [s].
    seconds: f64,
}

enum End {
    Passed,
    Failed(String),
    Timeout,
}

fn command(directory: &Path, binary: &str, arguments: &[&str], seconds: f64, mutant: &str) -> Command {
    let seconds = (TIMES * seconds).max(LEAST_SECONDS).ceil();
    let mut c = Command::new("sh");
    c.current_dir(directory)
        .arg("-c")
        .arg(format!("ulimit -c 0; ulimit -t {seconds}; ulimit -v {MEMORY}; exec \"$0\" \"$@\""))
        .arg(binary)
        .arg("--test-threads=1")
        .args(arguments)
        .env("MUTANT", mutant)
        .env("PROPTEST_CASES", CASES)
        .env("PROPTEST_RNG_SEED", "1982")
        .env("PROPTEST_DISABLE_FAILURE_PERSISTENCE", "1")
        .env("PROPTEST_MAX_SHRINK_ITERS", "0")
        .env("RUST_BACKTRACE", "0")
        .stdin(Stdio::null())
        .stdout(Stdio::piped())
        .stderr(Stdio::null());
    c
}

/// Runs to the end. A failure carries the test that ran last.
fn spawn(mut c: Command) -> Result<End, String> {
    let out = c.output().map_err(|e| format!("tests: {e}"))?;
    Ok(match out.status.signal() {
        Some(s) if OUT_OF_TIME.contains(&s) => End::Timeout,
        _ if out.status.success() => End::Passed,
        _ => {
            let text = String::from_utf8_lossy(&out.stdout);
            let last = text.lines().filter_map(|l| l.strip_prefix("test ")?.split(" ...").next()).next_back();
            End::Failed(last.unwrap_or_default().to_string())
        }
    })
}

/// Runs all tests with a switch that no mutant has; they must pass. Writes their times to `path`, or reads them from an existing
/// file.
fn measure(path: &Path, directory: &Path, binaries: &[&str], arguments: &[String]) -> Result<Vec<Test>, String> {
    if !path.exists() {
        let mut text = String::new();
        for binary in binaries {
            let list: Vec<&str> = arguments.iter().map(String::as_str).collect();
            // An hour: the duration of the tests is not known yet.
            let mut child = command(directory, binary, &list, 3600.0 / TIMES, "9999999")
                .spawn()
                .map_err(|e| format!("{binary}: {e}"))?;
            let out = child.stdout.take().ok_or("no output of the tests")?;
            let mut begin = Instant::now();
            for line in BufReader::new(out).lines() {
                let line = line.map_err(|e| format!("{binary}: {e}"))?;
                let seconds = begin.elapsed().as_secs_f64();
                begin = Instant::now();
                if let Some((name, "ok")) = line.strip_prefix("test ").and_then(|l| l.split_once(" ... ")) {
                    text.push_str(&format!("{binary}\t{name}\t{seconds:.3}\n"));
                }
            }
            if !child.wait().map_err(|e| e.to_string())?.success() {
                return Err(format!("{binary}: a test fails without any mutant"));
            }
        }
        std::fs::write(path, text).map_err(|e| format!("{}: {e}", path.display()))?;
    }
    let text = std::fs::read_to_string(path).map_err(|e| format!("{}: {e}", path.display()))?;
    let tests: Vec<Test> = text
        .lines()
        .filter_map(|l| {
            let mut fields = l.split('\t');
            Some(Test {
                binary: fields.next()?.to_string(),
                name: fields.next()?.to_string(),
                seconds: fields.next()?.parse().ok()?,
            })
        })
        .collect();
    let total: f64 = tests.iter().map(|t| t.seconds).sum();
    println!("{} tests, {total:.1} s without a mutant", tests.len());
    Ok(tests)
}

/// Modules of a path, without the file names that do not count.
fn modules(file: &str) -> Vec<&str> {
    let inner = file.split_once("/src/").map_or(file, |(_, rest)| rest);
    inner.trim_end_matches(".rs").split('/').filter(|part| *part != "mod" && *part != "lib").collect()
}

/// How many modules a test shares with the mutant's file.
fn nearness(file: &str, test: &str) -> usize {
    let (file, test) = (modules(file), test.split("::"));
    file.iter().zip(test).take_while(|(a, b)| **a == *b).count()
}

/// The tests in the order they run for a mutant of `file`: the quick ones in one process, the nearest first, then the slow
/// ones one by one. All of them run unless one fails.
fn groups<'a>(tests: &'a [Test], file: &str) -> Vec<Vec<&'a Test>> {
    let mut quick: BTreeMap<(bool, &str), Vec<&Test>> = BTreeMap::new();
    let mut slow: Vec<&Test> = Vec::new();
    for t in tests {
        if t.seconds > SLOW {
            slow.push(t);
        } else {
            let far = nearness(file, &t.name) == 0;
            quick.entry((far, &t.binary)).or_default().push(t);
        }
    }
    slow.sort_by(|a, b| {
        let near = |t: &Test| nearness(file, &t.name);
        near(b).cmp(&near(a)).then(a.seconds.total_cmp(&b.seconds))
    });
    quick.into_values().chain(slow.into_iter().map(|t| vec![t])).collect()
}

/// Outcome of one mutant: caught, missed, or out of time.
fn outcome(directory: &Path, tests: &[Test], file: &str, mutant: usize) -> Result<(&'static str, String), String> {
    for group in groups(tests, file) {
        let mut list = vec!["--exact"];
        list.extend(group.iter().map(|t| t.name.as_str()));
        let seconds = group.iter().map(|t| t.seconds).sum();
        match spawn(command(directory, &group[0].binary, &list, seconds, &mutant.to_string()))? {
            End::Passed => {}
            End::Failed(test) => return Ok(("caught", test)),
            End::Timeout => return Ok(("timeout", group[0].name.clone())),
        }
    }
    Ok(("missed", String::new()))
}

fn append(path: &Path) -> Result<std::fs::File, String> {
    std::fs::OpenOptions::new().create(true).append(true).open(path).map_err(|e| format!("{}: {e}", path.display()))
}

fn state(path: &Path) -> Result<BTreeMap<usize, String>, String> {
    let text = std::fs::read_to_string(path).map_err(|e| format!("{}: {e}", path.display()))?;
    let value: Value = serde_json::from_str(&text).map_err(|e| format!("{}: {e}", path.display()))?;
    let skipped = value["skipped"].as_object().ok_or("no `skipped` in the state")?;
    Ok(skipped.iter().filter_map(|(id, why)| Some((id.parse().ok()?, why.as_str()?.to_string()))).collect())
}

/// Lines `id outcome seconds test` of a run, the last of an id counts.
fn outcomes(path: &Path) -> BTreeMap<usize, String> {
    let text = std::fs::read_to_string(path).unwrap_or_default();
    text.lines()
        .filter_map(|l| {
            let mut fields = l.split('\t');
            Some((fields.next()?.parse().ok()?, fields.next()?.to_string()))
        })
        .collect()
}

/// Runs the mutants of the sample in its order; those with a line in `out` are not run again.
pub fn run(
    sample: &Path,
    state_path: &Path,
    out: &Path,
    tests: &Path,
    directory: &Path,
    binaries: &[&str],
    arguments: &[String],
) -> Result<(), String> {
    let mutants = sample::read(sample)?;
    let skipped = state(state_path)?;
    let done: BTreeSet<usize> = outcomes(out).into_keys().collect();
    let tests = measure(tests, directory, binaries, arguments)?;
    let mut file = append(out)?;
    for m in &mutants {
        if skipped.contains_key(&m.id) || done.contains(&m.id) {
            continue;
        }
        let begin = Instant::now();
        let (outcome, test) = outcome(directory, &tests, &m.file, m.id)?;
        let seconds = begin.elapsed().as_secs_f64();
        writeln!(file, "{}\t{outcome}\t{seconds:.1}\t{test}", m.id).map_err(|e| e.to_string())?;
        if outcome != "caught" {
            println!("{outcome:8} {} {}", m.id, m.name);
        }
    }
    Ok(())
}

/// Prints the table by module and the mutants that were not caught, in Markdown.
pub fn report(sample: &Path, state_path: &Path, out: &Path) -> Result<(), String> {
    let mutants = sample::read(sample)?;
    let (skipped, outcomes) = (state(state_path)?, outcomes(out));
    let mut table: BTreeMap<String, [usize; 6]> = BTreeMap::new();
    let mut missed = Vec::new();
    for m in &mutants {
        let column = match (skipped.get(&m.id).map(String::as_str), outcomes.get(&m.id).map(String::as_str)) {
            (Some(why), _) if why.starts_with("unviable") => 3,
            (Some(_), _) => 4,
            (_, Some("caught")) => 0,
            (_, Some("timeout")) => 1,
            (_, Some(_)) => {
                missed.push(m);
                2
            }
            (_, None) => 5,
        };
        for row in [module(&m.file), "all".into()] {
            table.entry(row).or_default()[column] += 1;
        }
    }
    println!("| module | sampled | caught | timeout | missed | unviable | not switchable | not run | score |");
    println!("|---|---|---|---|---|---|---|---|---|");
    let total = table.remove("all");
    for (name, [caught, timeout, missed, unviable, other, left]) in
        table.into_iter().chain(total.map(|t| ("all".into(), t)))
    {
        let run = caught + timeout + missed;
        let score = match run {
            0 => "–".to_string(),
            _ => format!("{:.1} %", 100.0 * (caught + timeout) as f64 / run as f64),
        };
        let sampled = run + unviable + other + left;
        println!("| {name} | {sampled} | {caught} | {timeout} | {missed} | {unviable} | {other} | {left} | {score} |");
    }
    println!("\nMissed:\n");
    for m in missed {
        println!("- {} `{}`", m.id, m.name);
    }
    println!("\nNot switchable:\n");
    for m in &mutants {
        if let Some(why) = skipped.get(&m.id).filter(|w| !w.starts_with("unviable")) {
            println!("- {} `{}` ({why})", m.id, m.name);
        }
    }
    Ok(())
}
