//! Kept results of `ida`, `push`, nonlinear and opening runs, short ones in every test and full ones on request.
//!
//! A row of [`SHORT`] or [`FULL`] is a command and the folder of its results. The short ones are runs on coarse meshes of
//! `tests/golden/short/`; their reports are inspected and not kept. The full ones belong to the examples:
//!
//! ```text
//! cargo test --release --test golden kept::full -- --ignored --nocapture
//! ```
//!
//! Their last result stands in `docs/verification/kept-reports.md`. After a reviewed change TANKCHECK_BLESS="reason" accepts the
//! short ones, and with `--ignored` the full ones, as for the examples.

use std::collections::BTreeSet;
use std::path::Path;
use std::process::{Command, Output};
use std::time::Instant;

use rayon::prelude::*;
use results::numdiff;

use crate::accepted::{self, NUMBERS, root};
use crate::examples::examples;

/// A command whose results are kept.
struct Kept {
    /// Arguments, without the output folder.
    command: &'static [&'static str],
    /// Folder below the root.
    golden: &'static str,
    /// Words that its report must have.
    shows: &'static [&'static str],
}

impl Kept {
    /// Whether the report is kept: those of the full runs of `ida` and `push`.
    fn page(&self) -> bool {
        self.golden.starts_with("reports/") && self.command[0] != "compare"
    }
}

/// On coarse meshes, seconds in all.
const SHORT: [Kept; 4] = [
    Kept {
        command: &[
            "ida",
            "tests/golden/short/strip.json",
            "--quake",
            "tests/golden/short/pulse.csv",
            "--scale",
            "0,0.3,1",
        ],
        golden: "tests/golden/short/ida",
        shows: &["Moment of the section", "Base moment", "completed", "<svg"],
    },
    Kept {
        command: &[
            "compare",
            "tests/golden/short/strip.json",
            "--quake",
            "tests/golden/short/pulse.csv",
            "--fe",
            "nonlinear",
            "--procedures",
            "housner",
        ],
        golden: "tests/golden/short/nonlinear",
        shows: &["Nonlinear run", "Moment at the base", "First crack", "Balance of energies"],
    },
    Kept {
        command: &[
            "compare",
            "tests/golden/short/strip_opening.json",
            "--quake",
            "tests/golden/short/pulse.csv",
            "--fe",
            "nonlinear",
            "--procedures",
            "housner",
        ],
        golden: "tests/golden/short/opening",
        shows: &["Nonlinear run", "liquid separates from the wall", "Moment at the base"],
    },
    Kept {
        command: &["push", "tests/golden/short/cylinder.json", "--imperfection", "class-b"],
        golden: "tests/golden/short/push",
        shows: &["0.605", "<svg"],
    },
];

const ELCENTRO: &str = "examples/records/elcentro.csv";

/// Runs of the examples, from seconds to minutes each in the release profile.
const FULL: [Kept; 6] = [
    Kept {
        command: &[
            "ida",
            "examples/06_sandwich_strip/tank.json",
            "--quake",
            ELCENTRO,
            "--scale",
            "0..1.1",
            "--steps",
            "12",
        ],
        golden: "reports/06_sandwich_strip/ida",
        shows: &["Moment of the section"],
    },
    Kept {
        command: &["compare", "examples/06_sandwich_strip/tank.json", "--quake", ELCENTRO, "--fe", "nonlinear"],
        golden: "reports/06_sandwich_strip/nonlinear",
        shows: &["Moment at the base"],
    },
    Kept {
        command: &["compare", "examples/06_sandwich_strip/opening/tank.json", "--quake", ELCENTRO, "--fe", "nonlinear"],
        golden: "reports/06_sandwich_strip/opening",
        shows: &["Moment at the base"],
    },
    Kept {
        command: &["push", "examples/07_steel_cylinder/tank.json", "--imperfection", "class-b"],
        golden: "reports/07_steel_cylinder/push",
        shows: &["0.605"],
    },
    Kept {
        command: &[
            "compare",
            "examples/07_steel_cylinder/tank.json",
            "--quake",
            "examples/07_steel_cylinder/shaking.csv",
            "--fe",
            "nonlinear",
        ],
        golden: "reports/07_steel_cylinder/nonlinear",
        shows: &["Nonlinear run"],
    },
    Kept {
        command: &[
            "compare",
            "examples/08_concrete_cylinder/tank.json",
            "--quake",
            "examples/08_concrete_cylinder/record.csv",
            "--fe",
            "nonlinear",
        ],
        golden: "reports/08_concrete_cylinder/nonlinear",
        shows: &["Nonlinear run"],
    },
];

fn tankcheck(command: &[&str], out: &Path) -> Output {
    Command::new(env!("CARGO_BIN_EXE_tankcheck"))
        .current_dir(root())
        .args(command)
        .arg("--quiet")
        .arg("--out")
        .arg(out)
        .output()
        .expect("tankcheck runs")
}

/// Runs a row and compares: what is wrong.
fn check(kept: &Kept) -> Vec<String> {
    let home = tempfile::tempdir().expect("a temporary folder");
    let out = home.path().join("out");
    let clock = Instant::now();
    let run = tankcheck(kept.command, &out);
    println!("{}: {:.1} s", kept.golden, clock.elapsed().as_secs_f64());
    let fault = |what: String| format!("{}: {what}", kept.golden);
    // 1: a check of the tank fails; 3: the wall collapses.
    if !matches!(run.status.code(), Some(0 | 1 | 3 | 4)) {
        return vec![fault(format!("exit code {:?}\n{}", run.status.code(), String::from_utf8_lossy(&run.stderr)))];
    }
    let page = std::fs::read_to_string(out.join("report.html")).expect("a report");
    let missing = kept.shows.iter().filter(|words| !page.contains(**words));
    let missing = missing.map(|words| fault(format!("`{words}` is missing in the report")));
    missing.chain(accepted::check(kept.golden, &out, kept.page())).collect()
}

fn all_hold(kept: &[Kept]) {
    let faults: Vec<String> = kept.par_iter().flat_map(check).collect();
    assert!(
        faults.is_empty(),
        "{}\n\nIf the change is right and reviewed: TANKCHECK_BLESS=\"reason\" and the same command",
        faults.join("\n")
    );
}

#[test]
fn short_runs_give_their_kept_numbers() {
    all_hold(&SHORT);
}

/// Half an hour of processor time.
#[test]
#[ignore = "slow: cargo test --release --test golden kept::full -- --ignored --nocapture; last result in docs/verification/kept-reports.md"]
fn full_runs_give_their_kept_numbers() {
    all_hold(&FULL);
}

/// A folder of `reports/` for each run, with its numbers; reports, with their figures inside, of one run of each example and of `ida`
/// and `push`.
#[test]
fn reports_hold_numbers_and_pages_alone() {
    let (mut found, mut pages) = (BTreeSet::new(), BTreeSet::new());
    let mut folders = vec![root().join("reports")];
    while let Some(folder) = folders.pop() {
        for entry in std::fs::read_dir(&folder).expect("readable") {
            let path = entry.expect("readable").path();
            let name = path.file_name().expect("a name").to_string_lossy().into_owned();
            let place = folder.strip_prefix(root()).expect("below").display().to_string();
            if path.is_dir() {
                folders.push(path);
            } else if NUMBERS.contains(&name.as_str()) {
                assert!(found.insert(place), "{}: two kinds of results", folder.display());
            } else {
                assert_eq!(name, "report.html", "{place}");
                let html = std::fs::read_to_string(&path).expect("text");
                assert!(html.contains("</svg>") && !html.contains("figures/"), "{place}");
                pages.insert(place);
            }
        }
    }
    let examples = examples();
    let runs = examples.iter().map(|e| (e.golden.clone(), e.page));
    let runs: Vec<(String, bool)> = runs.chain(FULL.iter().map(|k| (k.golden.into(), k.page()))).collect();
    assert_eq!(found, runs.iter().map(|run| run.0.clone()).collect());
    assert_eq!(pages, runs.into_iter().filter_map(|run| run.1.then_some(run.0)).collect());
}

/// The numbers of `ida` and `push` are compared like those of `compare`: a changed number is found, volatile fields are ignored.
#[test]
fn a_moved_number_is_found() {
    for (golden, file) in [("tests/golden/short/ida", "ida.json"), ("tests/golden/short/push", "push.json")] {
        let golden = root().join(golden);
        let home = tempfile::tempdir().expect("a temporary folder");
        let text = std::fs::read_to_string(golden.join(file)).expect("kept");
        let mut value: serde_json::Value = serde_json::from_str(&text).expect("JSON");
        value["volatile"]["created"] = "another day".into();
        let write = |value: &serde_json::Value| {
            std::fs::write(home.path().join(file), value.to_string()).expect("writable");
            numdiff::folders(&golden, home.path(), &numdiff::Options::default()).expect("comparable")
        };
        assert!(write(&value).moved.is_empty());
        let number = match file {
            "ida.json" => &mut value["runs"][1]["section_moment"],
            _ => &mut value["shells"][0]["path"][1]["acceleration"],
        };
        *number = (number.as_f64().expect("a number") * (1.0 + 1e-5)).into();
        let moved = write(&value).moved;
        assert_eq!(moved.len(), 1, "{moved:?}");
    }
}
