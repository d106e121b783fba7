//! Source:    see each row of the verification manual
//! Goal:      every fast row of `tankcheck verify` holds its tolerance, and the committed manual says the same
//! Model:     see the pages of the manual
//! Expected:  closed forms, published benchmarks, independent assemblies: named in each row
//! Tolerance: per row, stated where the row is made

use std::path::{Path, PathBuf};
use std::sync::OnceLock;

use tankcheck::verify::{self, Choice, Entry, Manual, Pace, manual};

fn fresh() -> &'static Manual {
    static MANUAL: OnceLock<Manual> = OnceLock::new();
    MANUAL.get_or_init(|| verify::run(Choice::default(), &|_| {}).expect("every topic runs"))
}

fn folder() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("docs/verification")
}

#[test]
fn every_row_holds() {
    let manual = fresh();
    let outside: Vec<String> = manual
        .rows
        .iter()
        .filter(|row| row.fails())
        .map(|row| format!("{row:?}, error {:+.2e}", row.error()))
        .collect();
    assert!(outside.is_empty(), "{}", outside.join("\n"));
    for id in [
        "F1", "F2", "F3", "F4", "F5", "F6", "F7", "F8", "F9", "F10", "F11", "F16", "F17",
    ] {
        assert!(manual.rows.iter().any(|row| row.id == id), "{id} is missing");
    }
}

#[test]
fn the_committed_manual_is_fresh() {
    let kept = manual::read(&folder()).expect("docs/verification/rows.json");
    let fast: Vec<&Entry> = kept.iter().filter(|row| row.pace == Pace::Fast).collect();
    let name = |row: &Entry| (row.page.clone(), row.id.clone(), row.what.clone(), row.kind.clone());
    let mut faults = Vec::new();
    for row in &fresh().rows {
        match fast.iter().find(|old| name(old) == name(row)) {
            None => faults.push(format!("{} {}: not in the manual", row.id, row.what)),
            Some(old) if !old.same_as(row) || old.reference != row.reference || old.tolerance != row.tolerance => {
                faults.push(format!(
                    "{} {}: {:?}, now {:?}",
                    row.id, row.what, old.computed, row.computed
                ));
            }
            Some(_) => {}
        }
    }
    for old in fast {
        if !fresh().rows.iter().any(|row| name(row) == name(old)) {
            faults.push(format!("{} {}: no longer computed", old.id, old.what));
        }
    }
    assert!(
        faults.is_empty(),
        "{}\n\ntankcheck verify --write docs/verification",
        faults.join("\n")
    );
}

#[test]
fn the_pages_are_those_of_the_rows() {
    let rows = manual::read(&folder()).expect("docs/verification/rows.json");
    for (name, text) in manual::files(&rows).expect("the manual renders") {
        let committed = std::fs::read_to_string(folder().join(&name)).unwrap_or_default();
        assert!(
            committed == text,
            "{name} is out of date: tankcheck verify --write docs/verification"
        );
    }
}

/// What the manual calls run by `cargo test` though `tankcheck verify` runs it with `--slow` alone is asserted in `fem`.
#[test]
fn tested_topics_are_tested() {
    let tests = [
        include_str!("../../crates/verification/tests/verification/shell.rs"),
        include_str!("../../crates/verification/tests/verification/dynamics.rs"),
    ]
    .concat();
    for call in [
        "shell::shell_large()",
        "shell::concrete_beams()",
        "dynamics::nonlinear()",
    ] {
        assert!(tests.contains(call), "{call} is not asserted");
    }
}
