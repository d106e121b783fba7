//! `tankcheck verify`: the self-test, its forms, and the options of the whole verification, which it refuses.

use std::collections::BTreeSet;
use std::process::{Command, Output};

use serde_json::Value;

fn verify(arguments: &[&str]) -> Output {
    let mut command = Command::new(env!("CARGO_BIN_EXE_tankcheck"));
    command.arg("verify").args(arguments).output().expect("tankcheck runs")
}

fn text(arguments: &[&str]) -> String {
    let output = verify(arguments);
    let message = String::from_utf8_lossy(&output.stderr);
    assert_eq!(output.status.code(), Some(0), "{arguments:?}: {message}");
    String::from_utf8(output.stdout).expect("UTF-8")
}

/// Every code and every engine has a row, and every row holds.
#[test]
fn every_code_and_engine_passes() {
    let found: Value = serde_json::from_str(&text(&["--format", "json"])).expect("JSON");
    let rows = found.as_array().expect("a list");
    assert!(rows.len() >= 20, "{} rows", rows.len());
    for row in rows {
        let number = |key: &str| row[key].as_f64().unwrap_or_else(|| panic!("{key}: {row}"));
        let (value, reference) = (number("computed"), number("reference"));
        let error = (value - reference) / reference.abs();
        assert!(row["holds"] == true && error.abs() <= number("tolerance"), "{row}");
        assert!(number("tolerance") <= 0.02 && (error - number("error")).abs() < 1e-12, "{row}");
        assert!(row["reference_source"].as_str().is_some_and(|source| source.len() > 5), "{row}");
    }
    let ids: BTreeSet<&str> = rows.iter().filter_map(|row| row["id"].as_str()).collect();
    let procedures = ::codes::ALL.iter().map(|procedure| procedure.id());
    for id in
        procedures.chain(["harmonic", "solid", "nonlinear strip", "nonlinear cylinder", "base", "soil", "isolators"])
    {
        assert!(ids.contains(id), "{id} has no row: {ids:?}");
    }
}

#[test]
fn the_list_has_every_row_with_its_source_in_every_form() {
    let listed: Value = serde_json::from_str(&text(&["--list", "--format", "json"])).expect("JSON");
    let listed = listed.as_array().expect("a list");
    assert!(listed.iter().all(|row| row.get("computed").is_none()));
    let csv = text(&["--list", "--format", "csv"]);
    assert_eq!(csv.lines().count(), listed.len() + 1, "{csv}");
    let human = text(&["--list"]);
    for row in listed {
        let [what, source] = ["what", "reference_source"].map(|key| row[key].as_str().expect("text"));
        assert!(human.contains(what) && human.contains(source) && csv.contains(what), "{row}");
    }
    let run = text(&[]);
    assert!(run.contains(&format!("\n{} rows, 0 outside their tolerance", listed.len())), "{run}");
    assert_eq!(text(&["--format", "csv"]).lines().count(), listed.len() + 1);
}

/// Pattern, slow rows, records and the manual belong to another program, which the help names.
#[test]
fn the_whole_verification_is_another_program() {
    for arguments in
        [&["shell-cook"][..], &["--slow"], &["--records", "."], &["--write", "manual"], &["--format", "html"]]
    {
        let output = verify(arguments);
        let message = String::from_utf8_lossy(&output.stderr);
        assert_eq!(output.status.code(), Some(2), "{arguments:?}: {message}");
        assert!(message.starts_with("error[T0101]: "), "{message}");
    }
    let help = text(&["--help"]);
    assert!(help.contains("cargo run --release -p verification") && help.contains("docs/verification"), "{help}");
}
