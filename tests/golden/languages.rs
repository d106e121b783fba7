//! A report in German and one in US units, as text, against their accepted ones: that of example 05, and that of a tank of
//! API 650 whose input is in US units.
//!
//! After a reviewed change, `TANKCHECK_BLESS="reason" cargo test --test golden languages` writes them again.

use std::path::Path;
use std::process::Command;

use report::Level;
use report::style::{self, Wish};
use tank::Language;

use crate::accepted::{lasting, root};

/// The texts of a page, one a line, without what differs between two runs.
fn text(html: &str) -> String {
    let mut html = lasting(html);
    while let Some(at) = html.find("<style>") {
        let end = html[at..].find("</style>").map_or(html.len(), |e| at + e);
        html.replace_range(at..end, "");
    }
    let mut out = String::new();
    for part in html.split('<') {
        let shown = part.split_once('>').map_or(part, |(_, text)| text).replace('\u{a0}', " ");
        let shown = shown.split_whitespace().collect::<Vec<_>>().join(" ");
        if !shown.is_empty() {
            out.push_str(&shown);
            out.push('\n');
        }
    }
    out
}

/// Compares a text with its accepted one, line by line.
fn accepted(name: &str, found: &str) {
    let path = root().join("tests/golden").join(name);
    if std::env::var("TANKCHECK_BLESS").is_ok() {
        std::fs::write(&path, found).expect("writable");
        return;
    }
    let kept = std::fs::read_to_string(&path).unwrap_or_else(|e| panic!("{}: {e}", path.display()));
    let differs = |(old, new): &(&str, &str)| old != new;
    let first = kept.lines().zip(found.lines()).find(differs);
    assert!(
        kept == found,
        "{name} differs, first {first:?}; {} lines for {}. If the change is right and reviewed: TANKCHECK_BLESS=\"reason\" cargo test --test golden languages",
        found.lines().count(),
        kept.lines().count()
    );
}

/// Runs a command in the root of the repository.
fn run(command: &[&str], out: &Path) {
    let run = Command::new(env!("CARGO_BIN_EXE_tankcheck"))
        .current_dir(root())
        .args(command)
        .args(["--quiet", "--out"])
        .arg(out)
        .output()
        .expect("runs");
    let message = String::from_utf8_lossy(&run.stderr);
    assert!(matches!(run.status.code(), Some(0 | 1 | 4)), "{message}");
}

#[test]
fn german_report_of_the_oil_tank() {
    let home = tempfile::tempdir().expect("a temporary folder");
    let tank = "examples/05_oil_tank/tank.json";
    let out = home.path().join("out");
    run(&["compare", tank, "--quake", "examples/records/elcentro.csv"], &out);
    let _wish = style::wish(Wish { language: Some(Language::German), units: None });
    let page = report::of_folder(&out, None, Level::Standard).expect("renders");
    accepted("german/05_oil_tank.txt", &text(&page.html));
}

#[test]
fn us_report_of_a_tank_in_us_units() {
    let home = tempfile::tempdir().expect("a temporary folder");
    let out = home.path().join("out");
    run(&["check", "tests/golden/us/tank.json"], &out);
    let html = std::fs::read_to_string(out.join("report.html")).expect("a report");
    accepted("us/report.txt", &text(&html));
}
