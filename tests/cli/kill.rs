//! `kill -9` at random moments: the next run works, resumed results equal those of an uninterrupted run bit by bit, and no other
//! files are left.
//!
//! One kill of each command in every `cargo test`; the battery is `TANKCHECK_KILLS=200 cargo test --release --test cli kill_battery`.
//! Half of the kills strike at any moment of the run, half while its results are written.

#![cfg(unix)]

use std::path::{Path, PathBuf};
use std::process::{Child, Command, Stdio};
use std::time::{Duration, Instant};

/// The run to kill.
struct Scenario {
    name: &'static str,
    /// The command line in a folder that has `tank.json`, `strip.json`, `shell.json`, `record.csv`.
    command: &'static [&'static str],
    /// Its output folder.
    out: &'static str,
    /// The command that resumes a killed run.
    resume: Option<&'static str>,
    /// Share of the kills.
    share: u32,
}

const SCENARIOS: &[Scenario] = &[
    Scenario {
        name: "compare",
        command: &["compare", "tank.json", "--quake", "record.csv", "--out", "out"],
        out: "out",
        resume: None,
        share: 3,
    },
    Scenario {
        name: "nonlinear compare",
        command: &["compare", "strip.json", "--quake", "record.csv", "--fe", "nonlinear", "--out", "nonlinear"],
        out: "nonlinear",
        resume: Some("--resume"),
        share: 3,
    },
    Scenario {
        name: "ida",
        command: &["ida", "strip.json", "--quake", "record.csv", "--scale", "0.3,0.6,1", "--jobs", "2", "--out", "ida"],
        out: "ida",
        resume: Some("--resume"),
        share: 3,
    },
    Scenario {
        name: "push",
        command: &["push", "shell.json", "--imperfection", "class-b", "--out", "push"],
        out: "push",
        resume: Some("--resume"),
        share: 3,
    },
    Scenario { name: "report", command: &["report", "out"], out: "out", resume: None, share: 2 },
];

/// Options of a steel cylinder on a coarse mesh.
const SHELL: &str =
    r#""elements": { "height": 8, "circumference": 8 }, "integration": { "steel": "gauss 3" }, "checkpoint": "1 s""#;

/// Numbers between 0 and 1, the same in every run (Knuth's linear congruential generator, TAOCP 3.3.4, line 26).
struct Dice(u64);

impl Dice {
    fn throw(&mut self) -> f64 {
        self.0 = self.0.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        (self.0 >> 11) as f64 / (1u64 << 53) as f64
    }
}

fn start(home: &Path, command: &[&str], resume: Option<&str>) -> Child {
    Command::new(env!("CARGO_BIN_EXE_tankcheck"))
        .args(command)
        .args(resume)
        .arg("--quiet")
        .current_dir(home)
        .stdout(Stdio::null())
        .stderr(Stdio::piped())
        .spawn()
        .expect("tankcheck runs")
}

/// Waits for the end of a run that must work.
fn works(run: Child, what: &str) {
    let output = run.wait_with_output().expect("ends");
    let message = String::from_utf8_lossy(&output.stderr);
    // A check may fail: that is not a failure of the program.
    assert!(matches!(output.status.code(), Some(0 | 1 | 4)), "{what}: {:?} {message}", output.status);
}

/// Everything below a folder: name and content, without the fields that differ between identical runs.
fn contents(folder: &Path) -> Vec<(String, String)> {
    let mut found = Vec::new();
    let mut open = vec![folder.to_path_buf()];
    while let Some(next) = open.pop() {
        for entry in std::fs::read_dir(&next).expect("readable").flatten() {
            let path = entry.path();
            if path.is_dir() {
                open.push(path);
                continue;
            }
            let name = path.strip_prefix(folder).expect("below").to_string_lossy().into_owned();
            let text = match name.as_str() {
                // Hold time and command line.
                "manifest.json" | "report.html" => String::new(),
                _ => std::fs::read_to_string(&path).expect("text"),
            };
            found.push((name, without_volatile(&text)));
        }
    }
    found.sort();
    found
}

fn without_volatile(text: &str) -> String {
    match serde_json::from_str::<serde_json::Value>(text) {
        Ok(serde_json::Value::Object(mut object)) => {
            object.remove("volatile");
            serde_json::Value::Object(object).to_string()
        }
        _ => text.to_owned(),
    }
}

/// Names in a folder, hidden ones included.
fn names(folder: &Path) -> Vec<String> {
    let mut names: Vec<String> = std::fs::read_dir(folder)
        .expect("readable")
        .flatten()
        .map(|e| e.file_name().to_string_lossy().into_owned())
        .collect();
    names.sort();
    names
}

/// Whether results are being written: a staging folder holds files.
fn writes(home: &Path, out: &str) -> bool {
    [home.to_path_buf(), home.join(out)].iter().any(|folder| {
        let staging = |name: &String| name.starts_with('.') && name.ends_with(".partial");
        let list =
            || Some(std::fs::read_dir(folder).ok()?.flatten().map(|e| e.file_name().to_string_lossy().into_owned()));
        let filled =
            |name: String| std::fs::read_dir(folder.join(name).join("files")).is_ok_and(|mut f| f.next().is_some());
        list().is_some_and(|mut all| all.any(|name| staging(&name) && filled(name)))
    })
}

/// Kills a run: at a moment of its usual duration, or while it writes. Whether it was still alive.
fn kill(mut run: Child, home: &Path, out: &str, usual: Duration, dice: &mut Dice) -> bool {
    let began = Instant::now();
    if dice.throw() < 0.5 {
        std::thread::sleep(usual.mul_f64(dice.throw()));
    } else {
        while !writes(home, out) && began.elapsed() < 4 * usual && run.try_wait().expect("known").is_none() {
            std::thread::sleep(Duration::from_micros(200));
        }
        std::thread::sleep(Duration::from_micros((30_000.0 * dice.throw()) as u64));
    }
    let alive = run.try_wait().expect("known").is_none();
    run.kill().expect("can be killed");
    run.wait().expect("ends");
    alive
}

/// The files that the commands read.
fn inputs(home: &Path) {
    let root = Path::new(env!("CARGO_MANIFEST_DIR"));
    let read = |path: &str| std::fs::read_to_string(root.join(path)).expect("readable");
    let strip = read("examples/06_sandwich_strip/tank.json");
    let found = strip.matches("\"nonlinear\": {").count();
    assert_eq!(found, 1, "a block of options");
    let strip = strip.replacen("\"nonlinear\": {", "\"nonlinear\": { \"checkpoint\": \"1 s\",", 1);
    let mut record = String::from("time_s,acceleration_m_s2\n");
    for i in 0..=250 {
        let t = 0.01 * f64::from(i);
        record.push_str(&format!("{t:.2},{:.6}\n", 5.0 * (50.0 * t).sin()));
    }
    let files = [
        ("tank.json", read("examples/01_broad_tank/tank.json")),
        ("strip.json", strip),
        ("shell.json", crate::push::with_nonlinear(SHELL)),
        ("record.csv", record),
    ];
    for (name, text) in files {
        std::fs::write(home.join(name), text).expect("writable");
    }
}

#[test]
fn kill_battery() {
    let kills: u32 = match std::env::var("TANKCHECK_KILLS") {
        Ok(text) => text.parse().expect("TANKCHECK_KILLS is a number"),
        Err(_) => 4,
    };
    let shares: u32 = SCENARIOS.iter().map(|s| s.share).sum();
    let mut dice = Dice(1982);
    let home = tempfile::tempdir().expect("a temporary folder");
    let home: PathBuf = home.path().to_path_buf();
    inputs(&home);
    for scenario in SCENARIOS {
        let out = home.join(scenario.out);
        let began = Instant::now();
        works(start(&home, scenario.command, None), scenario.name);
        let usual = began.elapsed();
        let (expected, around) = (contents(&out), names(&home));
        let wanted = (kills * scenario.share).div_ceil(shares);
        let (mut struck, mut tries) = (0, 0);
        while struck < wanted && tries < 4 * wanted {
            // Half of the time over the results of an earlier run, half into a new folder.
            if scenario.resume.is_some() || (scenario.name == "compare" && dice.throw() < 0.5) {
                std::fs::remove_dir_all(&out).expect("writable");
            }
            // A chain: a resumed run is killed as well.
            let links = if scenario.resume.is_some() { 3 } else { 1 };
            for link in 0..links {
                let resume = scenario.resume.filter(|_| link > 0);
                let alive = kill(start(&home, scenario.command, resume), &home, scenario.out, usual, &mut dice);
                struck += u32::from(alive);
                tries += 1;
                if !alive || struck >= wanted {
                    break;
                }
            }
            let what = format!("{} after {struck} kills", scenario.name);
            works(start(&home, scenario.command, scenario.resume), &what);
            assert_eq!(names(&home), around, "{what}: other files are left");
            let found = contents(&out);
            let list = |all: &[(String, String)]| all.iter().map(|f| f.0.clone()).collect::<Vec<_>>();
            assert_eq!(list(&found), list(&expected), "{what}");
            for ((name, a), (_, b)) in found.iter().zip(&expected) {
                let differs = a.lines().zip(b.lines()).find(|(a, b)| a != b);
                assert!(a == b, "{what}: {name} differs: {differs:?}");
            }
        }
        println!("{}: {struck} of {tries} runs were killed alive, usual time {usual:?}", scenario.name);
    }
}
