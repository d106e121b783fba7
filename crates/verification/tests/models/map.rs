//! Source:    `dissertation::map`, `docs/verification/rows.json`
//! Goal:      `docs/theory/dissertation.md` is the map of the dissertation, and each of its commands can run
//! Model:     none
//! Expected:  the page, byte for byte; patterns with rows that hold; files, packages and pages that exist
//! Tolerance: none

use std::path::{Path, PathBuf};
use std::process::Command;

use verification::dissertation::map::{self, Shown};
use verification::{Entry, Pattern, manual};

fn root() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("../..")
}

fn rows() -> Vec<Entry> {
    manual::read(&root().join("docs/verification")).expect("docs/verification/rows.json")
}

#[test]
fn the_page_is_the_map() {
    let path = root().join("docs/theory/dissertation.md");
    let wanted = map::page(&rows());
    if std::env::var_os("TANKCHECK_BLESS").is_some() {
        std::fs::write(&path, wanted).expect("writable");
        return;
    }
    let committed = std::fs::read_to_string(&path).unwrap_or_default();
    assert!(committed == wanted, "TANKCHECK_BLESS=\"reason\" cargo test --workspace --test models map");
}

#[test]
fn every_line_has_a_command_that_can_run() {
    let rows = rows();
    for line in map::lines() {
        let commands = line.shown.iter().filter(|shown| !matches!(shown, Shown::Page(_))).count();
        assert!(commands > 0, "{}: no command", line.system);
        for shown in line.shown {
            can_run(*shown, &rows).unwrap_or_else(|fault| panic!("{}: {fault}", line.system));
        }
    }
}

fn can_run(shown: Shown, rows: &[Entry]) -> Result<(), String> {
    match shown {
        Shown::Rows(text) => {
            let pattern = Pattern::new(text).ok_or(format!("`{text}` is neither an id nor a page"))?;
            let mut judged = rows.iter().filter(|row| pattern.selects(row) && !row.compares()).peekable();
            judged.peek().ok_or(format!("`{text}` has no row that can fail"))?;
            judged.find(|row| row.fails()).map_or(Ok(()), |row| Err(format!("{} fails", row.what)))
        }
        Shown::Run(arguments) => {
            let mut files = arguments.split(' ').filter(|word| word.contains('/'));
            files.find(|file| !root().join(file).exists()).map_or(Ok(()), |file| Err(format!("{file} does not exist")))
        }
        Shown::Test(arguments) => {
            let package = arguments.split(' ').nth(1).unwrap_or_default();
            let found = [package.to_owned(), format!("crates/{package}")]
                .iter()
                .any(|folder| root().join(folder).join("Cargo.toml").exists());
            found.then_some(()).ok_or(format!("{package} is not a package"))
        }
        Shown::Page(page) => {
            let path = root().join(format!("docs/theory/{page}"));
            path.exists().then_some(()).ok_or(format!("{} does not exist", path.display()))
        }
    }
}

/// Codes 1 and 4 are verdicts: a check that fails, and a tank about which no code decides.
#[test]
#[ignore = "slow: cargo build && cargo test --workspace --test models every_run -- --ignored; last result in docs/verification/slow-tests.md"]
fn every_run_of_the_map_finishes() {
    let program = root().join("target/debug/tankcheck");
    for shown in map::lines().flat_map(|line| line.shown) {
        let Shown::Run(arguments) = shown else { continue };
        let home = tempfile::tempdir().expect("a temporary folder");
        let mut command = Command::new(&program);
        command.current_dir(root()).args(arguments.split(' ')).arg("-q");
        if arguments.starts_with("compare") || arguments.starts_with("ida") {
            command.arg("--out").arg(home.path().join("out"));
        }
        let found = command.output().expect("the program is built");
        let code = found.status.code();
        assert!(matches!(code, Some(0 | 1 | 4)), "{arguments}: {code:?} {}", String::from_utf8_lossy(&found.stderr));
    }
}
