//! `--select`, `--no-report`, and the forms of test reports.

use std::path::Path;
use std::process::Output;

use engines::Integrator;
use fem::progress::Silent;
use oscillator::record::Record;
use results::{EngineId, Omittable};
use tank::case::GroundMotion;
use tankcheck::input::read_tank;
use tankcheck::job::Job;
use tankcheck::pipeline::{self, Outcome};

use crate::compare::tankcheck;

const TANK: &str = concat!(env!("CARGO_MANIFEST_DIR"), "/examples/05_oil_tank/tank.json");
const ANCHORED: &str = concat!(env!("CARGO_MANIFEST_DIR"), "/examples/01_broad_tank/tank.json");
const QUAKE: &str = concat!(env!("CARGO_MANIFEST_DIR"), "/examples/records/elcentro.csv");

fn compare(tank: &str, out: &str, more: &[&str]) -> Output {
    tankcheck(&[&["compare", tank, "--quake", QUAKE, "--quiet", "--out", out], more].concat())
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
            let method = method.filter(|m| m["id"] == id && m["excitation"] == excitation).collect::<Vec<_>>();
            let full = method[0]["quantities"][quantity["id"].as_str().unwrap()]["value"].as_f64().unwrap();
            assert!((value.as_f64().unwrap() / full - 1.0).abs() < 1e-5);
            compared += 1;
        }
    }
    assert!(compared > 30);
    // Every required check of the deciding methods.
    let counts = &whole["verdict"]["counts"];
    let required: u64 = ["holds", "fails", "not_checked", "accepted"].iter().map(|k| counts[k].as_u64().unwrap()).sum();
    let listed: usize = short["checks"].as_object().unwrap().values().map(|c| c.as_array().unwrap().len()).sum();
    assert_eq!(listed as u64, required);
}

#[test]
fn parts_by_name() {
    let found = json(&tankcheck(&["check", TANK, "--format", "json", "--select", "verdict,tank"]));
    let keys: Vec<&String> = found.as_object().unwrap().keys().collect();
    assert_eq!(keys, ["format", "name", "verdict", "tank"]);
    let unknown = tankcheck(&["check", TANK, "--format", "json", "--select", "verdikt"]);
    assert_eq!(unknown.status.code(), Some(2));
    let said = String::from_utf8_lossy(&unknown.stderr).into_owned();
    assert!(said.contains("found `verdikt`") && said.contains("quantities"), "{said}");
    let form = tankcheck(&["check", TANK, "--select", "verdict"]);
    assert_eq!(form.status.code(), Some(2));
}

#[test]
fn no_report_writes_the_same_numbers_alone() {
    let folder = tempfile::tempdir().unwrap();
    let path = |name: &str| folder.path().join(name).to_string_lossy().into_owned();
    let exists = |name: &str| folder.path().join(name).exists();
    compare(ANCHORED, &path("whole"), &["--no-mesh-error"]);
    let bare = compare(ANCHORED, &path("bare"), &["--no-mesh-error", "--no-report", "--format", "json"]);
    assert_eq!(json(&bare).get("not_computed"), None);
    assert!(!exists("bare/report.html") && !exists("bare/figures"));
    assert!(exists("bare/results.json") && exists("bare/series.csv"));
    let diff = json(&tankcheck(&["diff", &path("whole"), &path("bare"), "--format", "json"]));
    assert!(diff["moved"].as_array().unwrap().is_empty(), "{diff}");
    assert!(diff["changes"]["compared"].as_u64().unwrap() > 50);
}

/// Parts that need no envelopes, histories and second mesh come from a run without them. The folder says what it has not, and no command takes it
/// for whole results.
#[test]
fn a_folder_of_selected_parts_says_what_it_has_not() {
    let folder = tempfile::tempdir().unwrap();
    let path = |name: &str| folder.path().join(name).to_string_lossy().into_owned();
    let said = |output: &Output| String::from_utf8_lossy(&output.stderr).into_owned();
    let select = |parts| ["--no-report", "--format", "json", "--select", parts];
    compare(ANCHORED, &path("whole"), &[]);
    // Whole results are not replaced without a word.
    std::fs::create_dir(folder.path().join("kept")).unwrap();
    for name in ["results.json", "series.csv"] {
        std::fs::copy(folder.path().join("whole").join(name), folder.path().join("kept").join(name)).unwrap();
    }
    compare(ANCHORED, &path("bare"), &["--no-report"]);
    let output = compare(ANCHORED, &path("bare"), &select("quantities,checks"));
    let warnings = said(&output);
    let first = warnings.lines().find(|line| line.starts_with("warning[T0913]: ")).expect("a warning");
    for part in ["envelopes", "histories", "mesh error"] {
        assert!(first.contains(part), "{first}");
    }
    let short = json(&output);
    assert!(short["quantities"].is_array() && short["checks"].is_object());
    let text = std::fs::read_to_string(folder.path().join("bare/results.json")).unwrap();
    let bare: serde_json::Value = serde_json::from_str(&text).unwrap();
    let left = bare["not_computed"].as_array().unwrap();
    let parts: Vec<&str> = left.iter().map(|left| left["part"].as_str().unwrap()).collect();
    assert_eq!(parts, ["envelopes", "histories", "mesh_error"]);
    assert!(left.iter().all(|left| left["text"].as_str().unwrap().ends_with('.')));
    assert!(!folder.path().join("bare/series.csv").exists());
    // What is printed is what the whole run prints.
    let whole = compare(ANCHORED, &path("other"), &select("quantities,checks,verdict,methods"));
    let whole = json(&whole);
    assert!(short["quantities"] == whole["quantities"] && short["checks"] == whole["checks"]);
    let verdict = json(&compare(ANCHORED, &path("other"), &select("verdict,not_computed")));
    assert_eq!(verdict["verdict"], whole["verdict"]);
    assert_eq!(verdict["not_computed"].as_array().map(Vec::len), Some(2));
    // No report of it, and no golden folder; a comparison says what it leaves out.
    let report = tankcheck(&["report", &path("bare")]);
    assert_eq!(report.status.code(), Some(2));
    assert!(said(&report).contains("envelopes") && said(&report).contains("without --select"), "{}", said(&report));
    let diff = tankcheck(&["diff", &path("kept"), &path("bare")]);
    let told = String::from_utf8_lossy(&diff.stdout).into_owned();
    assert!(told.contains("same") && told.contains("not compared"), "{told}");
    assert_eq!(diff.status.code(), Some(0));
    let bless = tankcheck(&["diff", &path("kept"), &path("bare"), "--bless", "--reason", "faster"]);
    assert_eq!(bless.status.code(), Some(2));
    assert!(said(&bless).contains("envelopes"), "{}", said(&bless));
    assert!(folder.path().join("kept/series.csv").exists());
}

/// Every number of a run of selected parts has the bits of the whole run: anchored, with a vertical record, lifted on its bottom, by direct
/// integration, on isolators and on soil.
#[test]
fn selected_parts_have_the_bits_of_the_whole_run() {
    let all = [Omittable::Envelopes, Omittable::Histories, Omittable::Grounds, Omittable::MeshError];
    let examples: [(&str, bool, bool); 6] = [
        ("01_broad_tank", false, false),
        ("01_broad_tank", true, false),
        ("01_broad_tank", false, true),
        ("05_oil_tank", false, false),
        ("11_slab_tank/tank_soil.json", false, false),
        ("11_slab_tank/tank_isolated.json", false, false),
    ];
    for (example, vertical, newmark) in examples {
        let mut job = job(example, vertical);
        job.linear.mesh_error = false;
        if newmark {
            job.linear.integrator = Integrator::Newmark;
        }
        let whole = alone(&job);
        job.without = all.to_vec();
        let selected = alone(&job);
        assert!(selected.series.time.is_empty() && !whole.series.time.is_empty());
        let left = selected.results.not_computed.clone();
        let moves = whole.results.runs[0].base.is_some();
        assert_eq!(left.len(), if moves { 4 } else { 3 }, "{example}");
        assert!(left.iter().all(|left| !selected.results.has(left.part)), "{example}");
        let [whole, selected] =
            [whole, selected].map(|found| serde_json::to_value(found.results.without(&left)).unwrap());
        same(&whole, &selected, example);
    }
}

/// Runs the job on a new thread. Each thread caches curves of strips, and results from cached curves differ by rounding.
fn alone(job: &Job) -> Outcome {
    std::thread::scope(|scope| scope.spawn(|| pipeline::run(job, &Silent).unwrap()).join().unwrap())
}

/// Panics at the first place where two documents differ; numbers are compared bit by bit.
fn same(a: &serde_json::Value, b: &serde_json::Value, path: &str) {
    use serde_json::Value::{Array, Object};
    match (a, b) {
        (Array(x), Array(y)) if x.len() == y.len() => {
            for (i, (x, y)) in x.iter().zip(y).enumerate() {
                same(x, y, &format!("{path}[{i}]"));
            }
        }
        (Object(x), Object(y)) if x.keys().eq(y.keys()) => {
            for (key, x) in x {
                same(x, &y[key], &format!("{path}.{key}"));
            }
        }
        _ => assert_eq!(a, b, "{path}"),
    }
}

/// The job of an example under the record, with it upwards too.
fn job(example: &str, vertical: bool) -> Job {
    let name = if example.ends_with(".json") { example.into() } else { format!("{example}/tank.json") };
    let tank = read_tank(&Path::new(env!("CARGO_MANIFEST_DIR")).join("examples").join(name)).unwrap();
    let record = Record {
        name: "two tones".into(),
        dt: 0.02,
        acceleration: (0..200).map(|k| 3.5 * (0.11 * f64::from(k)).sin() + 2.0 * (0.43 * f64::from(k)).cos()).collect(),
        processing: Vec::new(),
    };
    let all = pipeline::procedures::select_procedures(&[], &[], &tank.case.site).unwrap();
    let mut job = Job { engines: vec![EngineId::Harmonic], raw_records: vec![record.clone(); 2], ..Job::of(tank, all) };
    job.case.ground_motion =
        Some(GroundMotion { horizontal: record.clone(), transverse: None, vertical: vertical.then_some(record) });
    job
}

/// A change of one course: verdict, quantities and checks come first, calculation lines on request.
#[test]
fn the_first_screen_of_a_difference() {
    let folder = tempfile::tempdir().unwrap();
    let text = std::fs::read_to_string(TANK).unwrap();
    let changed = folder.path().join("tank.json");
    std::fs::write(&changed, text.replacen("\"thickness\": \"8 mm\"", "\"thickness\": \"10 mm\"", 1)).unwrap();
    let (old, new) = (folder.path().join("old"), folder.path().join("new"));
    let path = |p: &std::path::Path| p.to_string_lossy().into_owned();
    tankcheck(&["check", TANK, "--quiet", "--out", &path(&old)]);
    tankcheck(&["check", &path(&changed), "--quiet", "--procedures", "ec8-2006,housner", "--out", &path(&new)]);
    let output = tankcheck(&["diff", &path(&old), &path(&new)]);
    assert_eq!(output.status.code(), Some(1));
    let said = String::from_utf8_lossy(&output.stdout).into_owned();
    let at = |what: &str| said.find(what).unwrap_or_else(|| panic!("no {what} in {said}"));
    // What was changed, then what follows for the checks, then the numbers.
    assert!(at("verdict") < at("input    tank.courses[5].thickness: 8 mm -> 10 mm"));
    assert!(at("input ") < at("hoop_stress") && at("hoop_stress") < at("wall_mass"));
    assert!(said.lines().count() <= 52, "{said}");
    assert!(said.contains("only in the old results: api650-1993/site"));
    assert!(!said.contains("methods["), "calculation lines stand on the first screen: {said}");
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
    let errors = report(TANK, "github").lines().filter(|l| l.starts_with("::error ")).count();
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
    assert_eq!(output.status.code(), Some(4), "{}", String::from_utf8_lossy(&output.stderr));
    let document = roxmltree::Document::parse(&text).unwrap();
    let error = document.descendants().find(|n| n.has_tag_name("error")).unwrap();
    assert_eq!(error.parent().unwrap().attribute("name"), Some("verdict"));
}

/// A code takes the base as fixed: of the tank of example 11 on isolators it holds nothing, of the same tank without them its freeboard and more. Scripts
/// see why in the warnings.
#[test]
fn no_code_holds_for_a_tank_on_isolators() {
    let example = Path::new(env!("CARGO_MANIFEST_DIR")).join("examples/11_slab_tank/tank_isolated.json");
    let isolated = std::fs::read_to_string(example).unwrap();
    let isolated = isolated.replace("\"decide\": [\"fe\"]", "\"decide\": [\"ec8-2006\"]");
    let start = isolated.find("\"isolators\"").unwrap();
    let end = start + isolated[start..].find('}').unwrap() + 1;
    let fixed = [isolated[..start].trim_end().trim_end_matches(','), &isolated[end..]].concat();
    let home = tempfile::tempdir().unwrap();
    let checked = |text: &str| {
        let path = home.path().join("tank.json");
        std::fs::write(&path, text).unwrap();
        let found = json(&tankcheck(&["check", path.to_str().unwrap(), "--format", "json"]));
        let checks = found["checks"].as_object().unwrap().values();
        let checks = checks.flat_map(|checks| checks.as_array().unwrap().clone());
        let statuses = checks.map(|check| (check["id"].clone(), check["status"].clone()));
        (statuses.collect::<Vec<_>>(), found["warnings"].to_string())
    };
    let (statuses, warnings) = checked(&isolated);
    assert!(statuses.iter().all(|(_, status)| status != "holds"), "{statuses:?}");
    assert!(statuses.iter().any(|(_, status)| status == "not_checked"));
    assert!(warnings.contains("take the base as fixed"), "{warnings}");
    let (statuses, warnings) = checked(&fixed);
    let freeboard = statuses.iter().find(|(id, _)| id == "freeboard").unwrap();
    assert_eq!(freeboard.1, "holds");
    assert!(!warnings.contains("take the base as fixed"), "{warnings}");
}
