//! `tankcheck fragility`: the contract of its JSON, and refusals.

use std::fs;
use std::path::Path;
use std::process::{Command, Output};

fn fragility(folder: &Path, arguments: &[&str]) -> Output {
    Command::new(env!("CARGO_BIN_EXE_tankcheck")).arg("fragility").args(arguments).current_dir(folder).output().unwrap()
}

fn json(output: &Output) -> serde_json::Value {
    serde_json::from_slice(&output.stdout)
        .unwrap_or_else(|e| panic!("{e}: {}", String::from_utf8_lossy(&output.stderr)))
}

const STRIPES: &str =
    "im,n,exceed\n0.1,40,0\n0.2,40,1\n0.3,40,5\n0.4,40,11\n0.5,40,18\n0.6,40,24\n0.8,40,33\n1.0,40,38\n";

fn written(files: &[(&str, &str)]) -> tempfile::TempDir {
    let folder = tempfile::tempdir().unwrap();
    for (name, text) in files {
        fs::write(folder.path().join(name), text).unwrap();
    }
    folder
}

/// Median and dispersion are those of two optimisers outside this program; the risk under λ = 1e-4 im^-2.5 is k₀ θ^-k exp(k²β²/2).
#[test]
fn the_contract() {
    let folder = written(&[("s.csv", STRIPES), ("h.csv", "im,rate\n0.1,3.1622776601683795e-2\n1,1e-4\n")]);
    let output =
        fragility(folder.path(), &["--stripes", "s.csv", "--hazard", "h.csv", "--im", "PGA", "--format", "json"]);
    assert_eq!(output.status.code(), Some(0));
    let curve = &json(&output)["curves"][0];
    let number = |key: &str| curve[key].as_f64().unwrap();
    assert!((number("median") - 0.519_144).abs() < 1e-6 && (number("dispersion") - 0.454_259).abs() < 1e-6);
    assert_eq!((curve["n"].as_u64(), curve["status"].as_str()), (Some(320), Some("fitted")));
    assert_eq!((curve["method"].as_str(), curve["im"].as_str()), (Some("stripes"), Some("PGA")));
    let (theta, beta) = (number("median"), number("dispersion"));
    let exact = 1e-4 * theta.powf(-2.5) * (0.5 * (2.5 * beta).powi(2)).exp();
    assert!((curve["risk"]["annual_rate"].as_f64().unwrap() / exact - 1.0).abs() < 1e-6);
}

#[test]
fn the_same_input_gives_the_same_bytes() {
    let folder = written(&[("s.csv", STRIPES)]);
    let run = || fragility(folder.path(), &["--stripes", "s.csv", "--format", "json"]).stdout;
    assert_eq!(run(), run());
}

#[test]
fn data_without_a_curve() {
    let folder = written(&[("s.csv", "im,n,exceed\n0.1,5,0\n0.2,5,5\n")]);
    let output = fragility(folder.path(), &["--stripes", "s.csv", "--format", "json"]);
    assert_eq!(output.status.code(), Some(4));
    let curve = &json(&output)["curves"][0];
    assert_eq!(curve["status"], "not_identifiable");
    assert!(curve["median"].is_null() && curve["dispersion"].is_null() && curve["reason"].is_string());
}

#[test]
fn bad_tables_are_refused_with_every_fault() {
    let told = |text: &str, wanted: &[&str]| {
        let folder = written(&[("s.csv", text)]);
        let output = fragility(folder.path(), &["--stripes", "s.csv"]);
        let said = String::from_utf8_lossy(&output.stderr).into_owned();
        assert_eq!(output.status.code(), Some(2), "{said}");
        assert!(output.stdout.is_empty());
        for wanted in wanted {
            assert!(said.contains(wanted), "{wanted} in {said}");
        }
    };
    told("", &["too few"]);
    told("im,n\n0.1,5\n", &["`exceed` is missing"]);
    told("im,n,exceed,rate\n0.1,5,1,2\n", &["unexpected column `rate`"]);
    told(
        "im,n,exceed\n-0.1,5,1\n0.2,2.5,1\n0.3,5,6\n0.4,5,nan\n",
        &["s.csv:2:1", "s.csv:3:5", "s.csv:4:1", "s.csv:5:7"],
    );
    told("im,n,im\n0.1,5,1\n", &["occurs twice"]);
    let folder = written(&[("s.csv", STRIPES), ("h.csv", "im,rate\n0.1,1e-2\n0.2,2e-2\n")]);
    let output = fragility(folder.path(), &["--stripes", "s.csv", "--hazard", "h.csv"]);
    assert_eq!(output.status.code(), Some(2));
    assert!(String::from_utf8_lossy(&output.stderr).contains("does not fall"));
}

#[test]
fn capacities_and_clouds() {
    let capacities = "im\n0.31\n0.38\n0.42\n0.47\n0.55\n0.58\n0.66\n0.74\n0.9\n1.1\n";
    // ln edp = ln im ± 0.2: the median of a limit 1 is 1, β = 0.2 √(n/(n − 2)).
    let mut cloud = String::from("im,edp,collapsed\n");
    for k in 1..=10 {
        let im = 0.2 * f64::from(k);
        for sign in [-0.2_f64, 0.2] {
            cloud.push_str(&format!("{im},{},0\n", im * sign.exp()));
        }
    }
    let folder = written(&[("c.csv", capacities), ("d.csv", &cloud)]);
    let found = json(&fragility(folder.path(), &["--capacities", "c.csv", "--format", "json"]));
    assert!((found["curves"][0]["median"].as_f64().unwrap() - 0.569_468).abs() < 1e-6);
    assert!((found["curves"][0]["dispersion"].as_f64().unwrap() - 0.394_104).abs() < 1e-6);
    let found = json(&fragility(folder.path(), &["--cloud", "d.csv", "--limit", "DS1=1", "--format", "json"]));
    let curve = &found["curves"][0];
    assert!((curve["median"].as_f64().unwrap() - 1.0).abs() < 1e-9);
    assert!((curve["dispersion"].as_f64().unwrap() - 0.2 * (20.0_f64 / 18.0).sqrt()).abs() < 1e-9);
    let output = fragility(folder.path(), &["--capacities", "c.csv", "--im-max", "0.8", "--censored", "3"]);
    assert_eq!(output.status.code(), Some(2), "capacities beyond the end of scaling");
}
