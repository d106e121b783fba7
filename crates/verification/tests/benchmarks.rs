//! Source:    see each row of the verification manual
//! Goal:      every row that takes less than minutes holds its tolerance, and the committed manual agrees
//! Model:     a test a benchmark: its fast and tested parts, each run once
//! Expected:  closed forms, published benchmarks, independent assemblies: named in each row
//! Tolerance: per row, stated where the row is made
//!
//! `cargo test -p verification --test benchmarks -- PATTERN` runs the benchmarks of a name.

use std::path::Path;
use std::process::ExitCode;
use std::sync::Arc;

use libtest_mimic::{Arguments, Failed, Trial};
use verification::{ALL, Benchmark, Entry, Part, dissertation, manual};

fn main() -> ExitCode {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../docs/verification");
    let kept = match manual::read(&folder) {
        Ok(rows) => Arc::new(rows),
        Err(error) => {
            eprintln!("{error}");
            return ExitCode::FAILURE;
        }
    };
    let mut trials: Vec<Trial> = ALL
        .iter()
        .copied()
        .filter(|benchmark| benchmark.parts.iter().any(|part| part.pace().is_tested()))
        .map(|benchmark| {
            let kept = Arc::clone(&kept);
            Trial::test(benchmark.id, move || check(benchmark, &kept))
        })
        .collect();
    let gathered = Arc::clone(&kept);
    trials.push(Trial::test("the-dissertation-gathers-its-rows", move || gathers_its_rows(&gathered)));
    trials.push(Trial::test("ids-have-a-meaning", move || ids_have_a_meaning(&kept)));
    libtest_mimic::run(&Arguments::from_args(), trials).exit_code()
}

/// Runs the tested parts of a benchmark: every row holds, and is in the manual.
fn check(benchmark: &Benchmark, kept: &[Entry]) -> Result<(), Failed> {
    let mut fresh = Vec::new();
    for part in benchmark.parts {
        let (Part::Fast(rows) | Part::Tested(rows)) = part else { continue };
        let rows = rows()?;
        if rows.is_empty() {
            return Err("a part without rows".into());
        }
        fresh.extend(rows.iter().map(|row| Entry::of(row, benchmark.id, part.pace())));
    }
    let mut faults: Vec<String> = fresh
        .iter()
        .filter(|row| row.fails())
        .map(|row| format!("outside its tolerance: {row:?}, error {:+.2e}", row.error()))
        .collect();
    let kept = kept.iter().filter(|row| row.page == benchmark.id && row.pace.is_tested());
    faults.extend(differences(&fresh, &kept.collect::<Vec<_>>()));
    if faults.is_empty() { Ok(()) } else { Err(faults.join("\n").into()) }
}

/// Key of a row: words may repeat, with another source.
fn name(row: &Entry) -> [&str; 5] {
    [&row.id, &row.what, &row.kind, &row.source, row.pace.id()]
}

/// Where the committed rows of a page differ from fresh ones.
fn differences(fresh: &[Entry], kept: &[&Entry]) -> Vec<String> {
    let mut faults = Vec::new();
    for row in fresh {
        let fault = match kept.iter().find(|old| name(old) == name(row)) {
            None => "not in the manual".to_owned(),
            Some(old) if !old.same_as(row) || old.reference != row.reference || old.tolerance != row.tolerance => {
                format!("the manual has {:?}, now {:?}", old.computed, row.computed)
            }
            Some(_) => continue,
        };
        faults.push(format!("{} {}: {fault}", row.id, row.what));
    }
    for old in kept {
        if !fresh.iter().any(|row| name(old) == name(row)) {
            faults.push(format!("{} {}: in the manual, no longer computed", old.id, old.what));
        }
    }
    if !faults.is_empty() {
        faults.push("cargo run --release -p verification -- --slow --write docs/verification".into());
    }
    faults
}

/// The pages with printed numbers are those that the page of the dissertation gathers, and each of these rows can fail.
fn gathers_its_rows(kept: &[Entry]) -> Result<(), Failed> {
    let printed = || kept.iter().filter(|row| row.of_dissertation().is_some());
    let mut faults: Vec<String> = printed()
        .filter(|row| row.compares())
        .map(|row| format!("{} {}: a row beside a printed number that cannot fail", row.id, row.what))
        .collect();
    let gathered = |page: &str| page == dissertation::ID || dissertation::PAGES.contains(&page);
    faults.extend(
        printed().filter(|row| !gathered(&row.page)).map(|row| format!("{}: not in dissertation::PAGES", row.page)),
    );
    let without = |page: &&&str| !printed().any(|row| row.page == **page);
    faults.extend(dissertation::PAGES.iter().filter(without).map(|page| format!("{page}: no printed number")));
    faults.dedup();
    if faults.is_empty() { Ok(()) } else { Err(faults.join("\n").into()) }
}

/// Every id of a row of the manual is declared by its benchmark, and every declared id has rows.
fn ids_have_a_meaning(kept: &[Entry]) -> Result<(), Failed> {
    let mut faults = Vec::new();
    for benchmark in ALL {
        let rows = || kept.iter().filter(|row| row.page == benchmark.id);
        for (id, _) in benchmark.ids {
            if !rows().any(|row| row.id == *id) {
                faults.push(format!("{}: {id} is declared and has no row", benchmark.id));
            }
        }
        for row in rows() {
            if !benchmark.ids.iter().any(|(id, _)| *id == row.id) {
                faults.push(format!("{}: {} is not declared", benchmark.id, row.id));
            }
        }
    }
    if faults.is_empty() { Ok(()) } else { Err(faults.join("\n").into()) }
}
