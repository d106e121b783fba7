//! Records as engineers have them: every `expected.json` below `tests/records/`, with its files.
//!
//! An entry has a `file` beside it, or its `text`; `args` of `quake info`; and `want`: `read` (samples, `dt` [s], `pga` [m/s²], `low_cut` [Hz]),
//! `refuse` (words, of which the message has one), either of them where both are given, or `roundtrip` (`quake convert`, then `quake info`).
//! An entry more is a case more.

use std::path::{Path, PathBuf};
use std::process::Output;

use serde_json::Value;

use crate::compare::{stderr, tankcheck};

/// Relative difference of numbers where the entry does not give one: half the last digit of a sample.
const TOLERANCE: f64 = 2e-6;

fn quake(command: &str, file: &Path, more: &[String]) -> Output {
    let file = file.to_str().expect("a path of text");
    let mut arguments = vec!["quake", command, file];
    arguments.extend(more.iter().map(String::as_str));
    tankcheck(&arguments)
}

/// What is wrong with the facts of a record.
fn misread(found: &Value, want: &Value) -> Option<String> {
    let tolerance = want["tol"].as_f64().unwrap_or(TOLERANCE);
    for (key, name) in [("samples", "samples"), ("dt", "dt"), ("pga", "pga"), ("low_cut", "low_cut_frequency_hz")] {
        let Some(wanted) = want[key].as_f64() else { continue };
        let read = found[name].as_f64().unwrap_or(f64::NAN);
        let allowed = if key == "pga" { tolerance } else { 1e-9 };
        let near = (read - wanted).abs() <= allowed * wanted;
        if !near {
            return Some(format!("{key} {read}, expected {wanted}"));
        }
    }
    None
}

/// What is wrong with a case.
fn fault(folder: &Path, case: &Value, home: &Path) -> Option<String> {
    let text = |value: &Value| value.as_str().expect("text").to_owned();
    let args: Vec<String> = case["args"].as_array().expect("args").iter().map(text).collect();
    let want = case["want"].as_object().expect("want");
    let file = match case["text"].as_str() {
        Some(content) => {
            let file = home.join("inline.txt");
            std::fs::write(&file, content).expect("written");
            file
        }
        None => folder.join(text(&case["file"])),
    };
    let json =
        |file: &Path, args: &[String]| quake("info", file, &[args, &["--format".into(), "json".into()]].concat());
    let read = |run: &Output, want: &Value| match run.status.code() {
        Some(0) => misread(&serde_json::from_slice(&run.stdout).expect("JSON"), want),
        code => Some(format!("exit {code:?}: {}", stderr(run))),
    };
    if let Some(want) = want.get("roundtrip") {
        let out = home.join("out.csv");
        let _ = std::fs::remove_file(&out);
        let written =
            quake("convert", &file, &[&args[..], &["--out".into(), out.to_str().expect("text").into()]].concat());
        if !written.status.success() {
            return Some(stderr(&written));
        }
        return read(&json(&file, &args), want).or_else(|| read(&json(&out, &[]), want));
    }
    let run = json(&file, &args);
    let refused = |words: &Value| {
        let message = stderr(&run).to_lowercase();
        let named = words.as_array().expect("words").iter().any(|word| message.contains(&text(word).to_lowercase()));
        let right = run.status.code() == Some(2) && run.stdout.is_empty() && named;
        (!right).then(|| format!("exit {:?}: {message}", run.status.code()))
    };
    let outcomes: Vec<Option<String>> =
        [want.get("read").map(|want| read(&run, want)), want.get("refuse").map(refused)]
            .into_iter()
            .flatten()
            .collect();
    match outcomes.iter().any(Option::is_none) {
        true => None,
        false => Some(outcomes.into_iter().flatten().collect::<Vec<_>>().join("\n")),
    }
}

fn lists() -> Vec<PathBuf> {
    let records = Path::new(concat!(env!("CARGO_MANIFEST_DIR"), "/tests/records"));
    let folders = std::fs::read_dir(records).expect("tests/records").map(|entry| entry.expect("an entry").path());
    let mut all: Vec<PathBuf> =
        folders.map(|folder| folder.join("expected.json")).filter(|list| list.is_file()).collect();
    all.sort();
    all
}

#[test]
fn records_of_the_field_are_read_or_refused_with_the_reason() {
    let home = tempfile::tempdir().expect("a temporary folder");
    let (mut cases, mut wrong) = (0, Vec::new());
    for list in lists() {
        let folder = list.parent().expect("a folder").to_path_buf();
        let all: Vec<Value> = serde_json::from_str(&std::fs::read_to_string(&list).expect("readable")).expect("JSON");
        for case in &all {
            cases += 1;
            if let Some(what) = fault(&folder, case, home.path()) {
                let name = case["file"].as_str().or(case["kind"].as_str()).unwrap_or("?");
                wrong.push(format!("{}: {name} {}: {what}", folder.display(), case["args"]));
            }
        }
    }
    assert!(cases >= 26, "{cases} cases");
    assert!(wrong.is_empty(), "{} of {cases} cases:\n{}", wrong.len(), wrong.join("\n\n"));
}
