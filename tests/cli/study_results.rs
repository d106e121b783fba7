//! `tankcheck study`: statistics, report, rule and cost of a merged study.

use std::fs;
use std::path::Path;

use serde_json::Value;

use crate::study::{STUDY, finished, folder, merged, planned, said, tankcheck};

fn json(path: &Path) -> Value {
    serde_json::from_str(&fs::read_to_string(path).unwrap()).unwrap()
}

/// Plans, runs and merges a study file in a folder.
fn done(path: &Path, study: &str, out: &str) -> Value {
    fs::write(path.join("study.json"), study).unwrap();
    for arguments in [&["study", "plan", "study.json", "--out", out][..], &["study", "run", out]] {
        let output = tankcheck(path, arguments);
        assert_eq!(output.status.code(), Some(0), "{}", said(&output));
    }
    merged(path, out);
    json(&path.join(out).join("fragility.json"))
}

/// The report has every tank, stands in one file, runs nothing, and is the same however the work was spread.
#[test]
fn the_report_is_deterministic() {
    let (folder, _) = finished();
    let path = folder.path();
    let page = fs::read_to_string(path.join("out/report.html")).unwrap();
    for wanted in ["two tanks", "<td>A</td>", "<td>B</td>", "id=\"fragility\"", "id=\"records\"", "rec3"] {
        assert!(page.contains(wanted), "{wanted}");
    }
    assert!(!page.contains("<script") && page.contains("default-src 'none'"));
    assert!(!page.contains(path.to_str().unwrap()), "no path of the machine");
    tankcheck(path, &["study", "plan", "study.json", "--out", "again"]);
    for shard in ["2/2", "1/2"] {
        tankcheck(path, &["study", "run", "again", "--shard", shard, "--jobs", "1"]);
    }
    merged(path, "again");
    for name in ["report.html", "fragility.json", "farm.csv", "tanks.csv"] {
        let of = |out: &str| fs::read(path.join(out).join(name)).unwrap();
        assert_eq!(of("out"), of("again"), "{name}");
    }
}

/// The three methods of one study, from its rows.csv. The crest of a wave grows faster than the record: the capacity of a record lies between two
/// levels, linear in logarithms; the curve of `capacities` is the median and deviation of their logarithms. The cloud is a line of least squares
/// through the logarithms of all rows, steeper than 1.
#[test]
fn three_methods() {
    let folder = folder();
    let path = folder.path();
    let damage = r#""damage": [ { "state": "DS1", "demand": "freeboard", "limit": 0.5 } ], "block": 5"#;
    let with = |method: &str| STUDY.replace("\"block\": 2", &format!("{damage}, \"method\": \"{method}\""));
    let levels = |study: String| {
        study.replace("\"0.1 g\", \"0.2 g\", \"0.4 g\", \"0.8 g\"", "\"0.01 g\", \"0.1 g\", \"1 g\", \"2.9 g\"")
    };
    let found = done(path, &levels(with("capacities")), "out");
    let curve = |found: &Value| found["curves"].as_array().unwrap()[0].clone();
    let capacities = curve(&found);
    assert_eq!(capacities["method"], "capacities", "{capacities}");
    let rows = fs::read_to_string(path.join("out/rows.csv")).unwrap();
    let lines: Vec<Vec<&str>> = rows.lines().map(|line| line.split(',').collect()).collect();
    let column = |name: &str| lines[0].iter().position(|c| *c == name).unwrap();
    let (tank, level, used) = (column("tank"), column("level"), column("fe.freeboard_utilisation"));
    let number = |line: &Vec<&str>, i: usize| line[i].parse::<f64>().unwrap();
    let record = column("record");
    let log = |line: &Vec<&str>| [number(line, level).ln(), (number(line, used) / 0.5).ln()];
    let of_a: Vec<&Vec<&str>> = lines[1..].iter().filter(|line| line[tank] == "A").collect();
    let logs: Vec<f64> = (0..5)
        .filter_map(|k| {
            let own = of_a.iter().filter(|line| line[record] == format!("rec{k}"));
            let rows: Vec<[f64; 2]> = own.map(|line| log(line)).collect();
            let pair = rows.windows(2).find(|pair| pair[0][1] < 0.0 && pair[1][1] >= 0.0)?;
            let [[x, y], [p, q]] = [pair[0], pair[1]];
            Some(x - y * (p - x) / (q - y))
        })
        .collect();
    assert_eq!(logs.len(), 5);
    let mean = logs.iter().sum::<f64>() / 5.0;
    let deviation = (logs.iter().map(|l| (l - mean).powi(2)).sum::<f64>() / 4.0).sqrt();
    // Kept digits: ten.
    assert!((capacities["median"].as_f64().unwrap() / mean.exp() - 1.0).abs() < 1e-7);
    assert!((capacities["dispersion"].as_f64().unwrap() - deviation).abs() < 1e-7);
    let cloud = curve(&done(path, &levels(with("cloud")), "out"));
    assert_eq!(cloud["method"], "cloud", "{cloud}");
    let points: Vec<[f64; 2]> = of_a.iter().map(|line| log(line)).collect();
    let centre = [0, 1].map(|i| points.iter().map(|p| p[i]).sum::<f64>() / points.len() as f64);
    let sum = |i: usize| points.iter().map(|p| (p[0] - centre[0]) * (p[i] - centre[i])).sum::<f64>();
    let slope = sum(1) / sum(0);
    assert!(slope > 1.05 && (cloud["cloud"]["slope"].as_f64().unwrap() - slope).abs() < 1e-7);
    let median = (centre[0] - centre[1] / slope).exp();
    assert!((cloud["median"].as_f64().unwrap() / median - 1.0).abs() < 1e-7);
    // Factors without a method are a cloud, and capacities of them are a fault.
    let factors = STUDY
        .replace("\"im\": \"PGA\", \"levels\": [\"0.1 g\", \"0.2 g\", \"0.4 g\", \"0.8 g\"]", "\"factors\": [0.5, 1]");
    assert_eq!(curve(&done(path, &factors, "factors"))["method"], "cloud");
    fs::write(path.join("study.json"), factors.replace("\"block\"", "\"method\": \"capacities\", \"block\"")).unwrap();
    let output = tankcheck(path, &["study", "plan", "study.json", "--out", "factors"]);
    assert_eq!(output.status.code(), Some(2));
    assert!(said(&output).contains("capacities without levels"), "{}", said(&output));
}

/// Five records of which three are computed: every share is bounded by m/5 and (m + 2)/5, every curve has bounds, a tank without a row is named.
#[test]
fn a_part_of_a_study_is_bounded() {
    let folder = planned();
    let path = folder.path();
    // Blocks of two records: tasks 1 to 3 are those of tank A; the second has two records.
    for task in ["1", "3"] {
        tankcheck(path, &["study", "run", "out", "--task", task]);
    }
    let output = tankcheck(path, &["study", "merge", "out", "--partial"]);
    assert!(output.status.success(), "{}", said(&output));
    let found = json(&path.join("out/fragility.json"));
    assert_eq!(found["missing_tasks"], 4);
    assert_eq!(found["without_rows"], serde_json::json!(["B"]));
    let curves = found["curves"].as_array().unwrap();
    assert_eq!(curves.len(), 3);
    let mut bounded = 0;
    for curve in curves {
        for point in curve["points"].as_array().unwrap() {
            let (n, exceed) = (point["n"].as_f64().unwrap(), point["exceed"].as_f64().unwrap());
            if point["missing"] == 2 {
                assert!((n - 3.0).abs() < 1e-12);
                let bounds = [0, 1].map(|i| point["bounds"][i].as_f64().unwrap());
                assert!((bounds[0] - exceed / 5.0).abs() < 1e-12 && (bounds[1] - (exceed + 2.0) / 5.0).abs() < 1e-12);
                bounded += 1;
            } else {
                // Not judged: nothing but what is missing.
                assert!((n + point["missing"].as_f64().unwrap() - 5.0).abs() < 1e-12, "{point}");
            }
        }
        assert!(curve["partial"]["missing"].as_u64().unwrap() >= 8, "{curve}");
    }
    assert!(bounded >= 4, "{found}");
    let page = fs::read_to_string(path.join("out/report.html")).unwrap();
    assert!(page.contains("4 of 6 tasks have no result") && page.contains("no result"), "{page}");
}

/// The rule of the study file is that of `quake set`, asked at plan time, and the report shows it.
#[test]
fn the_rule_is_asked_at_plan_time() {
    let folder = folder();
    let path = folder.path();
    fs::write(path.join("target.csv"), "period_s,acceleration_g\n0,0.1\n1,0.1\n20,0.05\n").unwrap();
    let study = STUDY.replace("\"block\": 2", "\"rule\": { \"target\": \"target.csv\", \"periods\": \"0.3 s\" }");
    fs::write(path.join("study.json"), &study).unwrap();
    let output = tankcheck(path, &["study", "plan", "study.json", "--out", "out"]);
    assert!(output.status.success(), "{}", said(&output));
    assert!(said(&output).contains("EN 1998-1"), "{}", said(&output));
    let plan = json(&path.join("out/plan.json"));
    let row = &plan["rule"]["rows"][0];
    let mut set: Vec<String> = (0..5).map(|k| format!("rec{k}.csv")).collect();
    set.splice(0..0, ["quake", "set"].map(String::from));
    set.extend(["--target", "target.csv", "--period", "0.3s", "--format", "json"].map(String::from));
    let set: Vec<&str> = set.iter().map(String::as_str).collect();
    let output = tankcheck(path, &set);
    let wanted: Value = serde_json::from_slice(&output.stdout).unwrap();
    // The means are summed in another order.
    for key in ["smallest_ratio", "factor", "mean_zero_period_ratio"] {
        let [a, b] = [&row[key], &wanted[key]].map(|v| v.as_f64().unwrap());
        assert!((a - b).abs() <= 1e-12 * b.abs(), "{key}: {a} {b}");
    }
    assert_eq!(row["holds"], wanted["holds"]);
    // A table that ends too early, and a rule without records, are faults.
    fs::write(path.join("target.csv"), "period_s,acceleration_g\n0,0.1\n0.4,0.1\n").unwrap();
    let text = said(&tankcheck(path, &["study", "plan", "study.json", "--out", "out"]));
    assert!(text.contains("ends at 0.4 s"), "{text}");
    let none = study.replace("\"records\": [ { \"files\": \"rec*.csv\" } ],", "");
    fs::write(path.join("study.json"), none.replace("target.csv", "site")).unwrap();
    let text = said(&tankcheck(path, &["study", "plan", "study.json", "--out", "out"]));
    assert!(text.contains("a rule without records"), "{text}");
}

/// The pilot leaves results that the run keeps, and `status` tells the size on the disk.
#[test]
fn the_pilot_is_kept() {
    let folder = folder();
    let path = folder.path();
    let output = tankcheck(path, &["study", "plan", "study.json", "--out", "out", "--pilot"]);
    assert!(output.status.success(), "{}", said(&output));
    let text = said(&output);
    assert!(text.contains("anchored") && text.contains("1 of 6 tasks") && text.contains("on disk"), "{text}");
    let before = tankcheck(path, &["study", "status", "out", "--format", "json"]);
    let before: Value = serde_json::from_slice(&before.stdout).unwrap();
    assert_eq!((&before["done"], &before["running"]), (&1.into(), &0.into()));
    assert!(before["bytes"].as_u64().unwrap() > 1000);
    let run = tankcheck(path, &["study", "run", "out"]);
    assert!(said(&run).contains("5 tasks computed, 1 kept"), "{}", said(&run));
    // At most 3 KB a row.
    let after: Value =
        serde_json::from_slice(&tankcheck(path, &["study", "status", "out", "--format", "json"]).stdout).unwrap();
    assert!(after["bytes"].as_u64().unwrap() < 3 * 1024 * after["rows"].as_u64().unwrap(), "{after}");
}

/// A Latin hypercube with a beta distribution is planned, and another number of samples keeps the results of the first ones.
#[test]
fn more_samples_keep_the_results_of_the_first() {
    let folder = folder();
    let path = folder.path();
    let study = |n: u32| {
        format!(
            r#"{{ "name": "samples", "tanks": [ {{ "files": "tank.json" }} ], "engine": "harmonic",
                "records": [ {{ "files": "rec0.csv" }} ], "scales": {{ "factors": [0.1] }},
                "sample": {{ "n": {n}, "seed": 3, "method": "latin", "parameters": [
                  {{ "path": "liquid.fill_height", "beta": {{ "of": "1.8 m", "mean": 0.7, "cov": 0.2, "max": 0.98 }} }} ] }} }}"#
        )
    };
    done(path, &study(4), "out");
    fs::write(path.join("study.json"), study(8)).unwrap();
    let output = tankcheck(path, &["study", "plan", "study.json", "--out", "out"]);
    assert!(said(&output).contains("4 of them have a result"), "{}", said(&output));
    let wrong = study(4).replace("\"cov\": 0.2", "\"cov\": 0.9");
    fs::write(path.join("study.json"), wrong).unwrap();
    let text = said(&tankcheck(path, &["study", "plan", "study.json", "--out", "out"]));
    assert!(text.contains("no beta distribution"), "{text}");
}
