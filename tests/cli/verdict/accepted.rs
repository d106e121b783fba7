//! Tanks that hold with accepted gaps: amber everywhere, and 4 with `--strict`.

use super::*;

/// The sound tank of both codes, whose gaps are accepted, and a tank of EN 1998-4 with all gaps closed but one.
fn written(home: &Path) -> String {
    let path = home.join("tank.json");
    let tank = Tank::new("gaps", "", Expected::NotAssessed, vec![only_ec8()]);
    std::fs::write(&path, tank.json()).expect("writable");
    path.to_str().expect("a temporary path is text").to_owned()
}

fn run(arguments: &[&str]) -> (Option<i32>, String) {
    let output = tankcheck(arguments);
    (output.status.code(), String::from_utf8_lossy(&output.stdout).into_owned())
}

/// Gaps first with who, when and why; the headline says how many, and how many limit states were checked.
#[test]
fn gaps_stand_before_everything_else() {
    let home = tempfile::tempdir().expect("a temporary folder");
    let path = written(home.path());
    let (code, text) = run(&["check", &path]);
    assert_eq!(code, Some(0));
    let first = text.lines().next().expect("a line");
    assert!(first.starts_with("Accepted without a check"), "{first}");
    let sliding = text.lines().find(|line| line.contains("sliding (ec8-2006)")).expect("the gap");
    for part in ["J. Doe", "2026-03-14", "checked apart in the statics of the tank"] {
        assert!(sliding.contains(part), "{sliding}");
    }
    let headline = text.lines().find(|line| line.starts_with("Holds")).expect("a headline");
    assert!(headline.starts_with("Holds, with 4 gaps accepted: "), "{headline}");
    assert!(headline.contains("required limit states were checked"), "{headline}");
    let (code, json) = run(&["check", &path, "--format", "json"]);
    assert_eq!(code, Some(0));
    let found: Value = serde_json::from_str(&json).expect("JSON");
    let gaps = found["verdict"]["accepted"].as_array().expect("a list");
    assert_eq!(gaps.len(), 4);
    assert_eq!(found["verdict"]["headline"], headline);
    for gap in gaps {
        assert_eq!((&gap["by"], &gap["date"]), (&json!("J. Doe"), &json!("2026-03-14")));
    }
}

/// Test reports, the table of a batch and the exit code say the same.
#[test]
fn no_form_is_green() {
    let home = tempfile::tempdir().expect("a temporary folder");
    let path = written(home.path());
    let (code, text) = run(&["check", &path, "--format", "sarif"]);
    let sarif: Value = serde_json::from_str(&text).expect("JSON");
    let results = sarif["runs"][0]["results"].as_array().expect("results").clone();
    let level = |results: &[Value], rule: &str| {
        let found = results.iter().find(|r| r["ruleId"] == rule);
        found.map(|r| r["level"].as_str().unwrap_or_default().to_owned())
    };
    assert_eq!((code, level(&results, "verdict/verdict")), (Some(0), Some("note".into())));
    assert!(text.contains("accepted by J. Doe on 2026-03-14"));
    let (code, text) = run(&["check", &path, "--format", "sarif", "--strict"]);
    let sarif: Value = serde_json::from_str(&text).expect("JSON");
    let results = sarif["runs"][0]["results"].as_array().expect("results").clone();
    assert_eq!((code, level(&results, "verdict/verdict")), (Some(4), Some("warning".into())));
    let (code, text) = run(&["check", &path, "--format", "github"]);
    assert_eq!(code, Some(0));
    assert!(text.contains("::notice") && text.contains("Holds, with 4 gaps accepted"), "{text}");
    let (code, text) = run(&["check", &path, "--format", "junit", "--strict"]);
    assert_eq!(code, Some(4));
    assert!(text.contains("errors=\"5\""), "{text}");
    let table = home.path().join("table.csv");
    std::fs::write(&table, "tag,liquid.fill_height\nA,8 m\n").expect("writable");
    let table = table.to_str().expect("text");
    for (arguments, expected) in [(vec![], 0), (vec!["--strict"], 4)] {
        let (code, text) = run(&[vec!["check", &path, "--table", table], arguments].concat());
        assert_eq!(code, Some(expected));
        assert!(text.contains(",holds_with_gaps,"), "{text}");
    }
    let (code, _) = run(&["check", &path, "--solve", "fill_height", "--strict"]);
    assert_eq!(code, Some(4));
}

/// The first page of the report lists the gaps, with who accepts them and why, behind an amber verdict and before all figures.
#[test]
fn the_first_page_lists_the_gaps() {
    let home = tempfile::tempdir().expect("a temporary folder");
    let path = written(home.path());
    let out = home.path().join("out");
    let (code, _) = run(&["check", &path, "--out", out.to_str().expect("text")]);
    assert_eq!(code, Some(0));
    let html = std::fs::read_to_string(out.join("report.html")).expect("a report");
    let verdict = html.find("class=\"verdict open\"").expect("an amber verdict");
    let block = &html[verdict..];
    let order =
        ["Deciding", "The governing check", "Accepted without a check", "Accepted by J. Doe on 2026-03-14", "<figure"];
    let places = order.map(|text| block.find(text).expect(text));
    assert!(places.is_sorted(), "{places:?}");
}

/// A gap that is accepted on a day after that of the results: named beside the gap, in the report and as a warning; on the same day or
/// before, not. The day is that of `SOURCE_DATE_EPOCH`, 1 000 000 000 s being 2001-09-09.
#[test]
fn an_acceptance_of_a_later_day_is_named() {
    let home = tempfile::tempdir().expect("a temporary folder");
    let path = home.path().join("tank.json");
    let out = home.path().join("out");
    for (date, later) in [("2001-09-08", false), ("2001-09-09", false), ("2001-09-10", true), ("2099-01-01", true)] {
        let gaps: Vec<Value> = ACCEPTED
            .map(|id| {
                let mut gap = gap(id);
                gap["date"] = json!(if id == "sliding" { date } else { "2000-01-01" });
                gap
            })
            .to_vec();
        let tank = Tank::new("dated", "", Expected::NotAssessed, vec![only_ec8(), json!({ "accepted": gaps })]);
        std::fs::write(&path, tank.json()).expect("writable");
        let run = |arguments: &[&str]| {
            let output = std::process::Command::new(env!("CARGO_BIN_EXE_tankcheck"))
                .arg("check")
                .arg(&path)
                .args(arguments)
                .env("SOURCE_DATE_EPOCH", "1000000000")
                .output()
                .expect("tankcheck runs");
            assert_eq!(output.status.code(), Some(0));
            [output.stdout, output.stderr].map(|text| String::from_utf8_lossy(&text).into_owned())
        };
        let [said, warned] = run(&["--out", out.to_str().expect("text")]);
        let mark = "a date after that of these results";
        assert_eq!(said.matches(mark).count(), usize::from(later), "{date}: {said}");
        let warning = format!("`sliding` is dated {date}, after the day of these results, 2001-09-09");
        assert_eq!(warned.contains(&warning), later, "{date}: {warned}");
        let html = std::fs::read_to_string(out.join("report.html")).expect("a report");
        assert_eq!(html.contains(mark), later, "{date}");
        let [junit, _] = run(&["--format", "junit"]);
        assert_eq!(junit.contains("is dated"), later, "{date}");
    }
}
