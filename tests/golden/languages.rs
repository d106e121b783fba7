//! A report in German and one in US units, as text, against their accepted ones: that of example 05 from its accepted
//! results, and that of a tank of API 650 whose input is in US units.
//!
//! After a reviewed change, `TANKCHECK_BLESS="reason" cargo test --test golden languages` writes them again.

use std::path::{Path, PathBuf};
use std::process::Command;

use report::Level;
use report::style::{self, Wish};
use tank::Language;

fn root() -> &'static Path {
    Path::new(env!("CARGO_MANIFEST_DIR"))
}

/// The texts of a page, one a line, without what differs between two runs.
fn text(html: &str) -> String {
    let mut html = html.to_owned();
    for (open, close) in [
        ("<style>", "</style>"),
        ("<dl class=\"pairs\" id=\"volatile\">", "</dl>"),
    ] {
        while let Some(at) = html.find(open) {
            let end = html[at..].find(close).map_or(html.len(), |e| at + e + close.len());
            html.replace_range(at..end, "");
        }
    }
    let mut out = String::new();
    for part in html.split('<') {
        let shown = part
            .split_once('>')
            .map_or(part, |(_, text)| text)
            .replace('\u{a0}', " ");
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

#[test]
fn german_report_of_the_oil_tank() {
    let _wish = style::wish(Wish {
        language: Some(Language::German),
        units: None,
    });
    let page = report::of_folder(&root().join("reports/05_oil_tank"), None, Level::Standard).expect("renders");
    accepted("german/05_oil_tank.txt", &text(&page.html));
}

#[test]
fn us_report_of_a_tank_in_us_units() {
    let home = tempfile::tempdir().expect("a temporary folder");
    let out: PathBuf = home.path().join("out");
    let run = Command::new(env!("CARGO_BIN_EXE_tankcheck"))
        .current_dir(root())
        .args(["check", "tests/golden/us/tank.json", "--quiet", "--out"])
        .arg(&out)
        .output()
        .expect("runs");
    assert!(
        matches!(run.status.code(), Some(0 | 1 | 4)),
        "{}",
        String::from_utf8_lossy(&run.stderr)
    );
    let html = std::fs::read_to_string(out.join("report.html")).expect("a report");
    accepted("us/report.txt", &text(&html));
}
