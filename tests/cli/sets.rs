//! `compare` under a set of records, and records that do not reach the sloshing period.

use std::collections::BTreeMap;
use std::fs;
use std::path::Path;

use serde_json::Value;

use crate::compare::{stderr, tankcheck};

const TANK: &str = "examples/01_broad_tank/tank.json";
/// A tank with the site of EN 1998 and of API 650, which lifts.
const SITE: &str = "examples/05_oil_tank/tank.json";

/// A record of the farm of example 10.
fn record(number: usize) -> String {
    format!("examples/10_tank_farm/records/synthetic-{number:03}.csv")
}

fn set(count: usize) -> Vec<String> {
    (1..=count).flat_map(|i| ["--quake".to_owned(), record(i)]).collect()
}

/// Results of `compare` with these arguments.
fn results(arguments: &[&str], home: &Path) -> Value {
    let out = home.join("out");
    let all = [arguments, &["--out", out.to_str().unwrap()]].concat();
    let run = tankcheck(&all);
    assert!(matches!(run.status.code(), Some(0 | 1 | 4)), "{}", stderr(&run));
    let text = fs::read_to_string(out.join("results.json")).unwrap();
    serde_json::from_str(&text).unwrap()
}

fn with<'a>(first: &[&'a str], more: &'a [String]) -> Vec<&'a str> {
    first.iter().copied().chain(more.iter().map(String::as_str)).collect()
}

/// The column of the engine under the record.
fn engine(results: &Value) -> &Value {
    let methods = results["methods"].as_array().unwrap();
    let is = |m: &&Value| m["id"] == "fe" && m["excitation"] == "record";
    methods.iter().find(is).unwrap()
}

fn runs(results: &Value) -> &Vec<Value> {
    results["record_set"]["records"].as_array().unwrap()
}

/// Seven records: the design value is the mean of the values under each, and each is that of a run of its own (whose mesh follows its own
/// record: 1 % is what an engineer takes for the same number). The utilisations are means as well.
#[test]
fn seven_records_give_their_mean() {
    let home = tempfile::tempdir().unwrap();
    let records = set(7);
    let found = results(&with(&["compare", TANK, "--no-report", "--format", "json"], &records), home.path());
    let block = &found["record_set"];
    assert_eq!((block["combine"].as_str(), block["rule"].as_str()), (Some("mean"), Some("en1998-1")));
    assert_eq!(runs(&found).len(), 7);
    let mut seen = 0;
    for (quantity, value) in engine(&found)["quantities"].as_object().unwrap() {
        let each: Vec<f64> = runs(&found).iter().filter_map(|run| run["values"]["fe"][quantity].as_f64()).collect();
        if each.is_empty() {
            continue;
        }
        let mean = each.iter().sum::<f64>() / 7.0;
        let design = value["value"].as_f64().unwrap();
        assert!((design / mean - 1.0).abs() < 1e-8, "{quantity}: {design} {mean}");
        seen += 1;
    }
    assert!(seen >= 4, "{seen} quantities");
    let mut utilisations: BTreeMap<String, Vec<f64>> = BTreeMap::new();
    for run in runs(&found) {
        for (check, value) in run["utilisations"].as_object().unwrap() {
            utilisations.entry(check.clone()).or_default().push(value.as_f64().unwrap());
        }
    }
    let mut compared = 0;
    for check in engine(&found)["checks"].as_array().unwrap() {
        let (Some(each), Some(u)) = (utilisations.get(check["id"].as_str().unwrap()), check["utilisation"].as_f64())
        else {
            continue;
        };
        let mean = each.iter().sum::<f64>() / 7.0;
        assert!((u / mean - 1.0).abs() < 1e-8, "{check}");
        compared += 1;
    }
    assert!(compared >= 1, "no check compares");
    for number in [2, 5] {
        let name = record(number);
        let alone = results(&["compare", TANK, "--no-report", "--no-mesh-error", "--quake", &name], home.path());
        let own = &runs(&found)[number - 1]["values"]["fe"];
        for quantity in ["sloshing_height", "base_shear", "overturning_moment"] {
            let one = engine(&alone)["quantities"][quantity]["value"].as_f64().unwrap();
            let of_set = own[quantity].as_f64().unwrap();
            assert!((of_set / one - 1.0).abs() < 1e-2, "{quantity} {number}: {of_set} {one}");
        }
    }
}

/// Three records: the worst of each quantity and check. Under a site, `--fit` scales the set so that the rule just holds, with the same factor
/// that `quake set` prints for the set as it is.
#[test]
fn three_records_give_their_worst_and_one_factor() {
    let home = tempfile::tempdir().unwrap();
    let records = set(3);
    // `quake set` reads records as they are: a tank that scales none.
    let text = fs::read_to_string(SITE).unwrap();
    let mut tank: Value = serde_json::from_str(&text).unwrap();
    tank.as_object_mut().unwrap().remove("record");
    fs::write(home.path().join("tank.json"), tank.to_string()).unwrap();
    let tank = home.path().join("tank.json").to_str().unwrap().to_owned();
    let base = ["compare", &tank, "--fe", "none", "--format", "json"];
    let found = results(&with(&base, &records), home.path());
    assert_eq!(found["record_set"]["combine"], "worst");
    let methods = found["methods"].as_array().unwrap();
    let column = methods.iter().find(|m| m["id"] == "ec8-2006" && m["excitation"] == "record").unwrap();
    for (quantity, value) in column["quantities"].as_object().unwrap() {
        let each = runs(&found).iter().filter_map(|run| run["values"]["ec8-2006"][quantity].as_f64());
        if let Some(largest) = each.reduce(f64::max) {
            assert!((value["value"].as_f64().unwrap() / largest - 1.0).abs() < 1e-8, "{quantity}");
        }
    }
    let compatibility = &found["record_set"]["compatibility"];
    let periods = compatibility["periods"].as_array().unwrap();
    let which: Vec<&str> = periods.iter().map(|p| p["which"].as_str().unwrap()).collect();
    assert_eq!(which, ["impulsive", "sloshing"]);
    let names: Vec<String> = (1..=3).map(record).collect();
    let asked = tankcheck(&with(&["quake", "set", "--target", &tank, "--format", "json"], &names));
    let asked: Value = serde_json::from_slice(&asked.stdout).unwrap();
    let factor = asked["factor"].as_f64().unwrap();
    assert!((compatibility["factor"].as_f64().unwrap() / factor - 1.0).abs() < 1e-8);
    let fitted = results(&with(&[&base[..], &["--fit"]].concat(), &records), home.path());
    let set = &fitted["record_set"];
    assert!((set["factor"].as_f64().unwrap() / factor - 1.0).abs() < 1e-8);
    assert_eq!(set["compatibility"]["holds"], true);
    assert!((set["compatibility"]["factor"].as_f64().unwrap() - 1.0).abs() < 1e-8);
    let peak = |found: &Value| runs(found)[0]["peaks"][0].as_f64().unwrap();
    assert!((peak(&fitted) / peak(&found) / factor - 1.0).abs() < 1e-8);
}

/// The report has the section with a figure for each period and each governing quantity; a set file says the same as the options.
#[test]
fn a_set_file_and_its_report() {
    let home = tempfile::tempdir().unwrap();
    let folder = home.path();
    for i in 1..=3 {
        fs::copy(record(i), folder.join(format!("r{i}.csv"))).unwrap();
    }
    let text = r#"{ "name": "Three", "code": "en1998-1", "combine": "worst", "factor": 2,
        "records": [ { "along": "r1.csv", "name": "one" }, { "along": "r2.csv", "scale": 0.5 }, { "along": "r3.csv" } ] }"#;
    fs::write(folder.join("set.json"), text).unwrap();
    let file = folder.join("set.json");
    let arguments = ["compare", SITE, "--fe", "none", "--set", file.to_str().unwrap()];
    let found = results(&arguments, folder);
    let ids: Vec<&str> = runs(&found).iter().map(|r| r["id"].as_str().unwrap()).collect();
    assert_eq!(ids, ["one", "r2", "r3"]);
    let plain = results(&with(&["compare", SITE, "--fe", "none", "--no-report"], &set(3)), &folder.join("plain"));
    for (i, factor) in [2.0, 1.0, 2.0].into_iter().enumerate() {
        let peak = |found: &Value| runs(found)[i]["peaks"][0].as_f64().unwrap();
        assert!((peak(&found) / peak(&plain) / factor - 1.0).abs() < 1e-8);
    }
    let page = fs::read_to_string(folder.join("out/report.html")).unwrap();
    for part in ["id=\"record_set\"", "fig-set_spectrum_impulsive", "fig-set_spectrum_sloshing", "fig-set_base_shear"] {
        assert!(page.contains(part), "{part}");
    }
    let schema = tankcheck(&["schema", "--set"]);
    let schema: Value = serde_json::from_slice(&schema.stdout).unwrap();
    assert!(schema["properties"]["records"].is_object(), "{schema}");
}

/// One message, with the place, the found value and what is allowed.
#[test]
fn bad_sets() {
    let home = tempfile::tempdir().unwrap();
    let folder = home.path();
    fs::write(folder.join("nan.csv"), "time_s,acceleration_m_s2\n0,0\n0.01,nan\n0.02,1\n").unwrap();
    let nan = folder.join("nan.csv").to_str().unwrap().to_owned();
    fs::copy(record(1), folder.join("copy.csv")).unwrap();
    let copy = folder.join("copy.csv").to_str().unwrap().to_owned();
    let [a, b, c, d] = [1, 2, 3, 4].map(record);
    let refused = |arguments: &[&str], wanted: &[&str]| {
        let out = folder.join("none");
        let fixed = ["compare", SITE, "--out", out.to_str().unwrap()];
        let engine: &[&str] = if arguments.contains(&"--fe") { &[] } else { &["--fe", "none"] };
        let run = tankcheck(&[&fixed[..], engine, arguments].concat());
        let said = stderr(&run);
        assert_eq!(run.status.code(), Some(2), "{said}");
        for part in wanted {
            assert!(said.contains(part), "`{part}` in {said}");
        }
        let closing = said.matches("; nothing was computed").count();
        let faults = [said.matches("error[T").count(), said.matches("error: ").count()];
        assert_eq!(faults, [1, closing], "{said}");
        assert!(!out.exists(), "nothing is written");
    };
    let quake = "--quake";
    refused(&[quake, &a, quake, &b, "--combine", "mean"], &["found 2 records", "3 or more"]);
    refused(&[quake, &a, quake, &b], &["found 2 records", "3 or more"]);
    let three = [quake, &a, quake, &b, quake, &c];
    refused(&[&three[..], &["--combine", "mean"]].concat(), &["found 3 records", "7 or more", "4.3.3.4.3"]);
    refused(&[&three[..], &["--quake-y", &d]].concat(), &["--quake-y: found 1 files beside 3"]);
    refused(&[quake, &a, quake, &b, quake, &copy], &["twice", "copy.csv", "synthetic-001.csv"]);
    refused(&[quake, &a, quake, &b, quake, "missing.csv"], &["missing.csv"]);
    refused(&[quake, &a, quake, &b, quake, &nan], &["nan.csv:3"]);
    refused(&[quake, &a, "--combine", "worst"], &["--combine applies to a set"]);
    refused(&[&three[..], &["--fe", "nonlinear"]].concat(), &["one linear engine"]);
    let target = folder.join("short.csv");
    fs::write(&target, "period_s,acceleration_g\n0,0.2\n1,0.2\n").unwrap();
    refused(&[&three[..], &["--fit", "--target", target.to_str().unwrap()]].concat(), &["short.csv", "ends at 1 s"]);
    let file = folder.join("set.json");
    let asks = |text: &str, wanted: &[&str]| {
        fs::write(&file, text).unwrap();
        refused(&["--set", file.to_str().unwrap()], wanted);
    };
    asks(
        r#"{ "records": [ { "along": "copy.csv" }, { "along": "none.csv" }, { "along": "nan.csv" } ] }"#,
        &["set.json:1:", "no such file"],
    );
    asks(r#"{ "records": [ { "along": "copy.csv" } ] }"#, &["set.json:1:", "3"]);
    let across = format!(
        r#"{{ "records": [ {{ "along": "copy.csv" }}, {{ "along": "{0}/{b}" }}, {{ "along": "{0}/{c}", "up": "{0}/{d}" }} ] }}"#,
        env!("CARGO_MANIFEST_DIR")
    );
    asks(&across, &["different components", "x, vertical"]);
    asks(r#"{ "rekords": [] }"#, &["rekords"]);
}

/// A converted record whose filter ends at 0.2 Hz: the sloshing period of 7 s is beyond its 5 s. Terminal, report and results say so, for a single
/// record and for a set; a corner at 0.1 Hz reaches 10 s.
#[test]
fn a_record_that_does_not_reach_the_sloshing_period() {
    let home = tempfile::tempdir().unwrap();
    let folder = home.path();
    let filtered = |number: usize, corner: f64| {
        let text = fs::read_to_string(record(number)).unwrap();
        let path = folder.join(format!("filtered{number}.csv"));
        fs::write(&path, format!("# low-cut filter: {corner} Hz\n{text}")).unwrap();
        path.to_str().unwrap().to_owned()
    };
    let short = filtered(1, 0.2);
    let out = folder.join("out");
    let ask = |arguments: &[&str]| {
        let fixed = ["compare", SITE, "--fe", "none", "--out", out.to_str().unwrap()];
        let run = tankcheck(&[&fixed[..], arguments].concat());
        let text = fs::read_to_string(out.join("results.json")).unwrap();
        let page = fs::read_to_string(out.join("report.html")).unwrap();
        (stderr(&run), serde_json::from_str::<Value>(&text).unwrap(), page)
    };
    let (said, found, page) = ask(&["--quake", &short]);
    assert!(said.contains("usable up to periods of 5.000\u{a0}s"), "{said}");
    assert_eq!(found["records"][0]["usable_period"], 5.0);
    assert_eq!(found["records"][0]["sloshing_beyond_usable"], true);
    assert!(page.contains("usable up to periods"), "the report is silent");
    let long = filtered(2, 0.1);
    let (said, found, page) = ask(&["--quake", &long]);
    assert!(!said.contains("usable up to") && !page.contains("usable up to"), "{said}");
    assert!(found["records"][0]["sloshing_beyond_usable"].is_null());
    let (said, found, _) = ask(&["--quake", &short, "--quake", &long, "--quake", &record(3)]);
    assert_eq!(said.matches("usable up to").count(), 1, "{said}");
    let flags: Vec<bool> = runs(&found).iter().map(|r| r["sloshing_beyond_usable"] == true).collect();
    assert_eq!(flags, [true, false, false]);
    let usable: Vec<Option<f64>> = runs(&found).iter().map(|r| r["usable_period"].as_f64()).collect();
    assert_eq!(usable, [Some(5.0), Some(10.0), None]);
}

/// Every row of a study has the usable period of its record, and says whether the tank's sloshing period is longer.
#[test]
fn rows_of_a_study_say_whether_the_record_reaches_the_sloshing_period() {
    let home = tempfile::tempdir().unwrap();
    let folder = home.path();
    let text = fs::read_to_string(record(1)).unwrap();
    for (name, corner) in
        [("short", "# low-cut filter: 0.2 Hz\n"), ("long", "# low-cut filter: 0.1 Hz\n"), ("unknown", "")]
    {
        fs::write(folder.join(format!("{name}.csv")), format!("{corner}{text}")).unwrap();
    }
    fs::copy(SITE, folder.join("tank.json")).unwrap();
    let study = r#"{ "name": "Corners", "engine": "none", "scales": { "factors": [0.5, 1] },
        "tanks": [ { "files": "tank.json" } ],
        "records": [ { "files": "long.csv" }, { "files": "short.csv" }, { "files": "unknown.csv" } ] }"#;
    fs::write(folder.join("study.json"), study).unwrap();
    let out = folder.join("out").to_str().unwrap().to_owned();
    let file = folder.join("study.json").to_str().unwrap().to_owned();
    for arguments in
        [vec!["study", "plan", &file, "--out", &out], vec!["study", "run", &out], vec!["study", "merge", &out]]
    {
        let run = tankcheck(&arguments);
        assert!(run.status.success(), "{}", stderr(&run));
    }
    let rows = fs::read_to_string(folder.join("out/rows.csv")).unwrap();
    let mut lines = rows.lines();
    let head: Vec<&str> = lines.next().unwrap().split(',').collect();
    let column = |name: &str| head.iter().position(|h| *h == name).unwrap_or_else(|| panic!("{name} in {head:?}"));
    let [record, usable, beyond] = ["record", "usable_period_s", "sloshing_beyond_usable"].map(column);
    let found: Vec<[&str; 3]> = lines
        .map(|line| {
            let cells: Vec<&str> = line.split(',').collect();
            [cells[record], cells[usable], cells[beyond]]
        })
        .collect();
    let wanted = [["long", "10", "no"], ["short", "5", "yes"], ["unknown", "", ""]];
    assert_eq!(found.len(), 6, "{rows}");
    for row in wanted {
        assert_eq!(found.iter().filter(|r| **r == row).count(), 2, "{row:?} in {found:?}");
    }
}

/// Three components each: the runs of the set are those of `compare` with the same three files.
#[test]
fn sets_of_three_components() {
    let home = tempfile::tempdir().unwrap();
    let mut arguments = vec!["compare".to_owned(), TANK.into(), "--no-report".into(), "--no-mesh-error".into()];
    for k in 1..=3 {
        let of = |option: &str, number: usize| [option.to_owned(), record(number)];
        arguments.extend(of("--quake", k));
        arguments.extend(of("--quake-y", k % 3 + 4));
        // The same file does not stand for two components.
        let text = fs::read_to_string(record(7)).unwrap();
        let up = home.path().join(format!("up{k}.csv"));
        fs::write(&up, format!("# vertical {k}\n{text}")).unwrap();
        arguments.extend(["--vertical".to_owned(), up.to_str().unwrap().to_owned()]);
    }
    let all: Vec<&str> = arguments.iter().map(String::as_str).collect();
    let found = results(&all, home.path());
    let own = &runs(&found)[1];
    assert_eq!(own["files"].as_array().unwrap().len(), 3);
    let one = [&all[..4], &["--quake", all[11], "--quake-y", all[13], "--vertical", all[15]][..]].concat();
    let alone = results(&one, home.path());
    for quantity in ["sloshing_height", "base_shear", "hoop_stress"] {
        let single = engine(&alone)["quantities"][quantity]["value"].as_f64().unwrap();
        let of_set = own["values"]["fe"][quantity].as_f64().unwrap();
        assert!((of_set / single - 1.0).abs() < 1e-2, "{quantity}: {of_set} {single}");
    }
}

/// A tank that overturns under one of its records: the set has no design value of forces and uplift, which the other record has, and its wall is not
/// checked. The wave hardly depends on the base.
#[test]
fn a_record_that_overturns_the_tank() {
    let home = tempfile::tempdir().unwrap();
    let path = |name: &str| home.path().join(name).to_str().unwrap().to_owned();
    let tank = fs::read_to_string(SITE).unwrap();
    // With friction it slides away from under the violent one.
    let held = r#""support": "unanchored", "foundation": { "kind": "soil", "friction": 0 }"#;
    let bare = tank.replace(r#""record": { "scale_to": "0.173 g" },"#, "").replace(r#""support": "unanchored""#, held);
    assert!(bare.contains(held) && !bare.contains("scale_to"));
    fs::write(path("tank.json"), bare).unwrap();
    let record = fs::read_to_string(record(1)).unwrap();
    for (name, factor) in [("weak.csv", 0.4), ("violent.csv", 8.0), ("still.csv", 0.01)] {
        let scaled: Vec<String> = (record.lines().enumerate())
            .map(|(i, line)| match line.split_once(',') {
                Some((time, a)) if i > 0 => format!("{time},{}", factor * a.parse::<f64>().unwrap()),
                _ => line.to_owned(),
            })
            .collect();
        fs::write(path(name), scaled.join("\n")).unwrap();
    }
    let (tank, weak, violent) = (path("tank.json"), path("weak.csv"), path("violent.csv"));
    let still = path("still.csv");
    let found = results(
        &[
            "compare",
            &tank,
            "--quake",
            &weak,
            "--quake",
            &violent,
            "--quake",
            &still,
            "--no-report",
            "--format",
            "json",
        ],
        home.path(),
    );
    let [stands, overturns, rests] = &runs(&found)[..] else { panic!("three records") };
    assert_eq!(rests["values"]["fe"]["uplift"], 0.0);
    for quantity in ["base_shear", "uplift", "hoop_stress"] {
        assert!(stands["values"]["fe"][quantity].is_number(), "{quantity}");
        assert!(overturns["values"]["fe"][quantity].is_null(), "{quantity}");
        assert!(engine(&found)["quantities"][quantity].is_null(), "{quantity}");
    }
    assert!(engine(&found)["quantities"]["sloshing_height"]["value"].is_number());
    let exceeded = overturns["limits_exceeded"].as_array().unwrap();
    assert!(exceeded.iter().any(|limit| limit == "base_rotation"), "{exceeded:?}");
    let checks = engine(&found)["checks"].as_array().unwrap();
    let of = |id: &str| checks.iter().find(|check| check["id"] == id).unwrap();
    for id in ["uplift_tension", "hoop_yield", "buckling_elastic", "sliding"] {
        assert_eq!(of(id)["status"], "not_checked", "{id}");
    }
    let reason = of("hoop_yield")["reason"].as_str().unwrap();
    assert!(reason.contains("record violent: uplift cannot be computed"), "{reason}");
}
