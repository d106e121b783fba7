//! Every example against its accepted results in `reports/`.
//!
//! An example is a tank file `examples/NN_name/tank.json` (results in `reports/NN_name`) or `tank_X.json` (results in
//! `reports/NN_name/X`), shaken by the folder's own `record.csv` or by `examples/records/elcentro.csv`. The last tank file of a folder
//! keeps its report, too.
//! After a reviewed change, `TANKCHECK_BLESS="reason" cargo test --test golden` replaces what moved.

use std::path::{Path, PathBuf};
use std::process::Command;

use rayon::prelude::*;

use crate::accepted::{self, root};

/// One tank file, its record or its set of records, and its accepted results, relative to the root of the repository.
pub(crate) struct Example {
    tank: PathBuf,
    /// `--quake` or `--set`.
    option: &'static str,
    record: PathBuf,
    pub(crate) golden: String,
    /// Whether its report is kept.
    pub(crate) page: bool,
}

/// A path below the root, relative to it: it goes into the report as part of the command line.
fn relative(path: &Path) -> PathBuf {
    path.strip_prefix(root()).expect("below the root").to_path_buf()
}

pub(crate) fn examples() -> Vec<Example> {
    let root = root();
    let mut folders: Vec<PathBuf> = std::fs::read_dir(root.join("examples"))
        .expect("examples/ exists")
        .map(|entry| entry.expect("readable").path())
        .filter(|path| path.join("README.md").exists() && !path.ends_with("records"))
        .collect();
    folders.sort();
    let mut examples = Vec::new();
    for folder in folders {
        let name = folder.file_name().expect("a folder has a name").to_string_lossy().into_owned();
        let own = folder.join("record.csv");
        let record = if own.exists() { own } else { root.join("examples/records/elcentro.csv") };
        let mut tanks: Vec<PathBuf> = std::fs::read_dir(&folder)
            .expect("readable")
            .map(|entry| entry.expect("readable").path())
            .filter(|path| path.extension().is_some_and(|e| e == "json"))
            // A study and its template have an accepted result of their own.
            .filter(|path| path.file_name().is_some_and(|n| n.to_string_lossy().starts_with("tank")))
            .collect();
        tanks.sort();
        for tank in &tanks {
            let stem = tank.file_stem().expect("a file has a stem").to_string_lossy().into_owned();
            let golden = match stem.strip_prefix("tank_") {
                Some(variant) => format!("reports/{name}/{variant}"),
                None => format!("reports/{name}"),
            };
            // A set of records stands beside the first tank, with results of its own.
            let set = folder.join("set.json");
            if set.exists() && stem == "tank" {
                examples.push(Example {
                    tank: relative(tank),
                    option: "--set",
                    record: relative(&set),
                    golden: format!("reports/{name}_set"),
                    page: false,
                });
            }
            examples.push(Example {
                tank: relative(tank),
                option: "--quake",
                record: relative(&record),
                golden,
                page: tanks.last() == Some(tank),
            });
        }
    }
    examples
}

#[test]
fn examples_give_their_accepted_results() {
    let examples = examples();
    assert!(examples.len() >= 9, "only {} example files found", examples.len());
    let faults: Vec<String> = examples.par_iter().flat_map(faults).collect();
    assert!(
        faults.is_empty(),
        "{}\n\nIf the change is right and reviewed: TANKCHECK_BLESS=\"reason\" cargo test --test golden",
        faults.join("\n")
    );
}

/// What is wrong with an example.
fn faults(example: &Example) -> Vec<String> {
    let home = tempfile::tempdir().expect("a temporary folder");
    let out = home.path().join("out");
    let run = compare(example, &out);
    let code = run.status.code();
    if matches!(code, Some(0 | 1 | 4)) {
        return accepted::check(&example.golden, &out, example.page);
    }
    vec![format!("{}: exit code {code:?}\n{}", example.tank.display(), text(&run.stderr))]
}

/// Runs the command of an example in the root of the repository.
fn compare(example: &Example, out: &Path) -> std::process::Output {
    Command::new(env!("CARGO_BIN_EXE_tankcheck"))
        .current_dir(root())
        .arg("compare")
        .arg(&example.tank)
        .arg(example.option)
        .arg(&example.record)
        .arg("--out")
        .arg(out)
        .output()
        .expect("tankcheck runs")
}

fn text(bytes: &[u8]) -> String {
    String::from_utf8_lossy(bytes).into_owned()
}
