//! Every example against its accepted report in `reports/`.
//!
//! An example is a tank file `examples/NN_name/tank.json` (report in `reports/NN_name`) or `tank_X.json` (report in
//! `reports/NN_name/X`), shaken by the folder's own `record.csv` or by `examples/records/elcentro.csv`.
//! After a reviewed change, `TANKCHECK_BLESS="reason" cargo test --test golden` rewrites the reports.

use std::path::{Path, PathBuf};
use std::process::Command;

use results::numdiff;

/// One tank file, its record or its set of records, and its accepted report, relative to the root of the repository.
struct Example {
    tank: PathBuf,
    /// `--quake` or `--set`.
    option: &'static str,
    record: PathBuf,
    golden: PathBuf,
}

/// Root of the repository.
fn root() -> &'static Path {
    Path::new(env!("CARGO_MANIFEST_DIR"))
}

/// A path below the root, relative to it: it goes into the report as part of the command line.
fn relative(path: &Path) -> PathBuf {
    path.strip_prefix(root()).expect("below the root").to_path_buf()
}

fn examples() -> Vec<Example> {
    let root = root();
    let mut folders: Vec<PathBuf> = std::fs::read_dir(root.join("examples"))
        .expect("examples/ exists")
        .map(|entry| entry.expect("readable").path())
        .filter(|path| path.join("README.md").exists() && !path.ends_with("records"))
        .collect();
    folders.sort();
    let mut examples = Vec::new();
    for folder in folders {
        let name = folder.file_name().expect("a folder has a name").to_owned();
        let own = folder.join("record.csv");
        let record = if own.exists() {
            own
        } else {
            root.join("examples/records/elcentro.csv")
        };
        let mut tanks: Vec<PathBuf> = std::fs::read_dir(&folder)
            .expect("readable")
            .map(|entry| entry.expect("readable").path())
            .filter(|path| path.extension().is_some_and(|e| e == "json"))
            // A study and its template have an accepted result of their own.
            .filter(|path| {
                path.file_name()
                    .is_some_and(|n| n.to_string_lossy().starts_with("tank"))
            })
            .collect();
        tanks.sort();
        for tank in tanks {
            let stem = tank
                .file_stem()
                .expect("a file has a stem")
                .to_string_lossy()
                .into_owned();
            let golden = root.join("reports").join(&name);
            let golden = match stem.strip_prefix("tank_") {
                Some(variant) => golden.join(variant),
                None => golden,
            };
            // A set of records stands beside the first tank, with a report of its own.
            let set = folder.join("set.json");
            if set.exists() && stem == "tank" {
                examples.push(Example {
                    tank: relative(&tank),
                    option: "--set",
                    record: relative(&set),
                    golden: relative(&root.join("reports").join(format!("{}_set", name.to_string_lossy()))),
                });
            }
            examples.push(Example {
                tank: relative(&tank),
                option: "--quake",
                record: relative(&record),
                golden: relative(&golden),
            });
        }
    }
    examples
}

#[test]
fn examples_give_their_accepted_reports() {
    let examples = examples();
    assert!(examples.len() >= 9, "only {} example files found", examples.len());
    let bless = std::env::var("TANKCHECK_BLESS").ok();
    let mut faults = Vec::new();
    for example in &examples {
        let home = tempfile::tempdir().expect("a temporary folder");
        let out = home.path().join("out");
        let run = compare(example, &out);
        let code = run.status.code();
        if !matches!(code, Some(0 | 1 | 4)) {
            faults.push(format!(
                "{}: exit code {code:?}\n{}",
                example.tank.display(),
                text(&run.stderr)
            ));
            continue;
        }
        if let Some(reason) = &bless {
            accept(&out, &example.golden, reason);
            // A second run into its final place, so that the report shows the command line a reader types.
            compare(example, &example.golden);
        }
        match numdiff::folders(&root().join(&example.golden), &out, &numdiff::Options::default()) {
            Err(error) => faults.push(format!("{}: {error}", example.golden.display())),
            Ok(report) => {
                for moved in report.moved.iter().take(10) {
                    faults.push(format!(
                        "{}: {}: {} -> {} ({:.1e})",
                        example.golden.display(),
                        moved.path,
                        moved.old,
                        moved.new,
                        moved.change
                    ));
                }
            }
        }
    }
    assert!(
        faults.is_empty(),
        "{}\n\nIf the change is right and reviewed: TANKCHECK_BLESS=\"reason\" cargo test --test golden",
        faults.join("\n")
    );
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

fn accept(out: &Path, golden: &Path, reason: &str) {
    let status = Command::new(env!("CARGO_BIN_EXE_tankcheck"))
        .current_dir(root())
        .args(["diff", "--quiet", "--bless", "--reason", reason, "--format", "csv"])
        .arg(golden)
        .arg(out)
        .stdout(std::process::Stdio::null())
        .status()
        .expect("tankcheck runs");
    assert!(status.success(), "cannot accept {}", golden.display());
}

fn text(bytes: &[u8]) -> String {
    String::from_utf8_lossy(bytes).into_owned()
}
