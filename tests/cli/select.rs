//! `--select`, `--no-report`, and the forms of test reports.

use std::process::{Command, Output};

const TANK: &str = concat!(env!("CARGO_MANIFEST_DIR"), "/examples/05_oil_tank/tank.json");
const QUAKE: &str = concat!(env!("CARGO_MANIFEST_DIR"), "/examples/records/elcentro.csv");

fn tankcheck(arguments: &[&str]) -> Output {
    Command::new(env!("CARGO_BIN_EXE_tankcheck"))
        .args(arguments)
        .output()
        .unwrap()
}

fn json(output: &Output) -> serde_json::Value {
    serde_json::from_slice(&output.stdout)
        .unwrap_or_else(|e| panic!("{e}: {}", String::from_utf8_lossy(&output.stderr)))
}

/// What a script reads of a check fits in 5 KB; everything is there on request, with the same numbers.
#[test]
fn the_short_form_is_short_and_true() {
    let short = tankcheck(&["check", TANK, "--format", "json"]);
    assert!(short.stdout.len() <= 5 * 1024, "{} bytes", short.stdout.len());
    let short = json(&short);
    let whole = json(&tankcheck(&["check", TANK, "--format", "json", "--select", "all"]));
    assert_eq!(short["verdict"]["status"], whole["verdict"]["status"]);
    let mut compared = 0;
    for quantity in short["quantities"].as_array().unwrap() {
        for (column, value) in quantity["values"].as_object().unwrap() {
            let (id, excitation) = column.split_once('/').unwrap();
            let method = whole["methods"].as_array().unwrap().iter();
            let method = method
                .filter(|m| m["id"] == id && m["excitation"] == excitation)
                .collect::<Vec<_>>();
            let full = method[0]["quantities"][quantity["id"].as_str().unwrap()]["value"]
                .as_f64()
                .unwrap();
            assert!((value.as_f64().unwrap() / full - 1.0).abs() < 1e-5);
            compared += 1;
        }
    }
    assert!(compared > 30);
    // Every required check of the deciding methods.
    let counts = &whole["verdict"]["counts"];
    let required: u64 = ["holds", "fails", "not_checked", "accepted"]
        .iter()
        .map(|k| counts[k].as_u64().unwrap())
        .sum();
    let listed: usize = short["checks"]
        .as_object()
        .unwrap()
        .values()
        .map(|c| c.as_array().unwrap().len())
        .sum();
    assert_eq!(listed as u64, required);
}

#[test]
fn parts_by_name() {
    let found = json(&tankcheck(&[
        "check",
        TANK,
        "--format",
        "json",
        "--select",
        "verdict,tank",
    ]));
    let keys: Vec<&String> = found.as_object().unwrap().keys().collect();
    assert_eq!(keys, ["format", "name", "verdict", "tank"]);
    let unknown = tankcheck(&["check", TANK, "--format", "json", "--select", "verdikt"]);
    assert_eq!(unknown.status.code(), Some(2));
    let said = String::from_utf8_lossy(&unknown.stderr).into_owned();
    assert!(
        said.contains("found `verdikt`") && said.contains("quantities"),
        "{said}"
    );
    let form = tankcheck(&["check", TANK, "--select", "verdict"]);
    assert_eq!(form.status.code(), Some(2));
}

#[test]
fn no_report_writes_the_same_numbers_alone() {
    let folder = tempfile::tempdir().unwrap();
    let path = |name: &str| folder.path().join(name).to_string_lossy().into_owned();
    let run = |out: &str, more: &[&str]| {
        let mut arguments = vec![
            "compare",
            TANK,
            "--quake",
            QUAKE,
            "--no-mesh-error",
            "--quiet",
            "--out",
            out,
        ];
        arguments.extend(more);
        tankcheck(&arguments)
    };
    run(&path("whole"), &[]);
    let output = run(
        &path("bare"),
        &["--no-report", "--format", "json", "--select", "quantities,checks"],
    );
    assert!(json(&output)["quantities"].is_array());
    assert!(!folder.path().join("bare/report.html").exists() && !folder.path().join("bare/figures").exists());
    assert!(folder.path().join("bare/results.json").exists() && folder.path().join("bare/series.csv").exists());
    let diff = json(&tankcheck(&["diff", &path("whole"), &path("bare"), "--format", "json"]));
    assert!(diff["changes"]["quantities"].as_array().unwrap().is_empty(), "{diff}");
    assert!(diff["changes"]["compared"].as_u64().unwrap() > 50);
}

/// A change of one course: verdict, quantities and checks come first, calculation lines on request.
#[test]
fn the_first_screen_of_a_difference() {
    let folder = tempfile::tempdir().unwrap();
    let text = std::fs::read_to_string(TANK).unwrap();
    let changed = folder.path().join("tank.json");
    std::fs::write(
        &changed,
        text.replacen("\"thickness\": \"8 mm\"", "\"thickness\": \"10 mm\"", 1),
    )
    .unwrap();
    let (old, new) = (folder.path().join("old"), folder.path().join("new"));
    let path = |p: &std::path::Path| p.to_string_lossy().into_owned();
    tankcheck(&["check", TANK, "--quiet", "--out", &path(&old)]);
    tankcheck(&[
        "check",
        &path(&changed),
        "--quiet",
        "--procedures",
        "ec8-2006,housner",
        "--out",
        &path(&new),
    ]);
    let output = tankcheck(&["diff", &path(&old), &path(&new)]);
    assert_eq!(output.status.code(), Some(1));
    let said = String::from_utf8_lossy(&output.stdout).into_owned();
    let at = |what: &str| said.find(what).unwrap_or_else(|| panic!("no {what} in {said}"));
    // What was changed, then what follows for the checks, then the numbers.
    assert!(at("verdict") < at("input    tank.courses[5].thickness: 8 mm -> 10 mm"));
    assert!(at("input ") < at("hoop_stress") && at("hoop_stress") < at("wall_mass"));
    assert!(said.lines().count() <= 45, "{said}");
    assert!(said.contains("only in the old results: api650-1993/site"));
    assert!(
        !said.contains("methods["),
        "calculation lines stand on the first screen: {said}"
    );
    let all = tankcheck(&["diff", &path(&old), &path(&new), "--all"]);
    assert!(String::from_utf8_lossy(&all.stdout).contains("methods"));
}

#[test]
fn test_reports() {
    let report =
        |tank: &str, form: &str| String::from_utf8(tankcheck(&["check", tank, "--format", form]).stdout).unwrap();
    let text = report(TANK, "junit");
    let document = roxmltree::Document::parse(&text).unwrap();
    let counts = json(&tankcheck(&["check", TANK, "--format", "json"]))["verdict"]["counts"].clone();
    let number = |tag: &str| document.descendants().filter(|n| n.has_tag_name(tag)).count() as u64;
    // One failure more than failing checks: the verdict.
    let fails = counts["fails"].as_u64().unwrap() + 1;
    assert_eq!(number("failure"), fails);
    assert_eq!(number("error"), counts["not_checked"].as_u64().unwrap());
    assert_eq!(number("skipped"), 0);
    let sarif: serde_json::Value = serde_json::from_str(&report(TANK, "sarif")).unwrap();
    assert_eq!(sarif["version"], "2.1.0");
    let errors = report(TANK, "github")
        .lines()
        .filter(|l| l.starts_with("::error "))
        .count();
    assert_eq!(errors as u64, fails);
}

/// A tank that nothing decides on has no green report: its verdict is an error, though every comparison holds.
#[test]
fn nothing_decided_is_not_green() {
    let folder = tempfile::tempdir().unwrap();
    let tank = folder.path().join("tank.json");
    let example = concat!(env!("CARGO_MANIFEST_DIR"), "/examples/04_concrete_strip/tank.json");
    std::fs::copy(example, &tank).unwrap();
    let output = tankcheck(&["check", tank.to_str().unwrap(), "--quake", QUAKE, "--format", "junit"]);
    let text = String::from_utf8(output.stdout).unwrap();
    assert_eq!(
        output.status.code(),
        Some(4),
        "{}",
        String::from_utf8_lossy(&output.stderr)
    );
    let document = roxmltree::Document::parse(&text).unwrap();
    let error = document.descendants().find(|n| n.has_tag_name("error")).unwrap();
    assert_eq!(error.parent().unwrap().attribute("name"), Some("verdict"));
}
