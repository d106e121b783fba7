//! German of what people read who write a tank file: help of its keys, faults, warnings, and what a search for a value has found.
//!
//! Source:    the schema, which has every key with its help, limits and words
//! Goal:      a key cannot come without its German, nor a fault or a warning that a wrong value makes
//! Remedy:    two lines in `crates/report/src/language/german/keys.txt` or `faults.txt`; `TANKCHECK_SHOW=folder` writes the texts with
//!            their German

use std::collections::BTreeSet;
use std::path::{Path, PathBuf};
use std::process::Command;

use files::code::Code;
use report::language::of_input;
use serde_json::{Value, json};
use tankcheck::input::diagnostic::Source;
use tankcheck::input::tank::{json_schema, parse};

fn root() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).into()
}

/// The texts that have no German.
fn without_german<'t>(texts: impl IntoIterator<Item = &'t str>) -> BTreeSet<&'t str> {
    texts.into_iter().filter(|text| !text.is_empty() && of_input(text).is_none()).collect()
}

/// Writes the texts with their German where someone looks at them.
fn show(name: &str, texts: &BTreeSet<String>) {
    let Ok(folder) = std::env::var("TANKCHECK_SHOW") else { return };
    let said = |text: &String| format!("{text}\n{}\n", of_input(text).unwrap_or_default());
    std::fs::write(Path::new(&folder).join(name), texts.iter().map(said).collect::<String>()).expect("writable");
}

/// Every description of a schema.
fn descriptions(schema: &Value) -> Vec<&str> {
    match schema {
        Value::Object(members) => {
            let own = members.get("description").and_then(Value::as_str);
            own.into_iter().chain(members.values().flat_map(descriptions)).collect()
        }
        Value::Array(items) => items.iter().flat_map(descriptions).collect(),
        _ => Vec::new(),
    }
}

#[test]
fn every_description_of_the_schema_is_german() {
    let schema = json_schema();
    let all = descriptions(&schema);
    assert!(all.len() > 600, "{}", all.len());
    let missing = without_german(all);
    assert!(
        missing.is_empty(),
        "{} without German:\n{}",
        missing.len(),
        missing.into_iter().collect::<Vec<_>>().join("\n")
    );
}

/// The texts with English words beside keys and quotations: an entry let its English through.
fn with_english(texts: &BTreeSet<String>) -> Vec<&String> {
    let words = [
        "the", "of", "and", "with", "is", "are", "not", "which", "least", "most", "or", "than", "without", "above",
        "below", "for",
    ];
    let plain = |text: &str| text.split('`').step_by(2).collect::<String>().split('"').step_by(2).collect::<String>();
    let parts = |c: char| !c.is_alphanumeric() && c != '_' && c != '-';
    texts.iter().filter(|text| plain(text).split(parts).any(|word| words.contains(&word))).collect()
}

#[test]
fn german_descriptions_have_no_english_words() {
    let schema = json_schema();
    let german: BTreeSet<String> = descriptions(&schema).into_iter().filter_map(of_input).collect();
    let found = with_english(&german);
    assert!(found.is_empty(), "{found:#?}");
}

/// Paths of the schema's keys, as steps through a document, each with its schema; lists and named objects have one item, `steel`.
fn keys(schema: &Value, root: &Value, path: &[String], all: &mut Vec<(Vec<String>, Value)>) {
    let below = |key: &str| [path, &[key.to_owned()]].concat();
    if let Some(Value::String(reference)) = schema.get("$ref") {
        keys(root.pointer(reference.trim_start_matches('#')).expect("a definition"), root, path, all);
    }
    for (key, property) in schema.get("properties").and_then(Value::as_object).into_iter().flatten() {
        all.push((below(key), property.clone()));
        keys(property, root, &below(key), all);
    }
    for option in schema.get("anyOf").and_then(Value::as_array).into_iter().flatten() {
        keys(option, root, path, all);
    }
    if let Some(item) = schema.get("items") {
        keys(item, root, &below("0"), all);
    }
    if let Some(item) = schema.get("additionalProperties").filter(|a| a.is_object()) {
        keys(item, root, &below("steel"), all);
    }
}

#[test]
fn every_key_has_a_german_name_in_the_form() {
    let names = std::fs::read_to_string(root().join("crates/desk/page/labels.js")).expect("the names");
    let schema = json_schema();
    let mut all = Vec::new();
    properties(&schema, &mut all);
    let named = |key: &str| [' ', '{'].iter().any(|before| names.contains(&format!("{before}{key}: ")));
    let missing: BTreeSet<&str> = all.into_iter().filter(|key| !named(key)).collect();
    assert!(missing.is_empty(), "without a German name in labels.js: {missing:?}");
}

/// The names of all properties of a schema.
fn properties<'s>(schema: &'s Value, all: &mut Vec<&'s str>) {
    match schema {
        Value::Object(members) => {
            let own = members.get("properties").and_then(Value::as_object);
            all.extend(own.into_iter().flat_map(|own| own.keys().map(String::as_str)));
            members.values().for_each(|value| properties(value, all));
        }
        Value::Array(items) => items.iter().for_each(|item| properties(item, all)),
        _ => {}
    }
}

/// Puts a value into a document; missing parents are made.
fn put(document: &mut Value, path: &[String], value: Value) {
    let [key, rest @ ..] = path else {
        *document = value;
        return;
    };
    if key == "0" {
        if document.as_array().is_none_or(|items| items.is_empty()) {
            *document = json!([{}]);
        }
        put(&mut document[0], rest, value);
    } else {
        if !document.is_object() {
            *document = json!({});
        }
        put(&mut document[key.as_str()], rest, value);
    }
}

/// Values that some keys cannot have.
fn wrong() -> Vec<Value> {
    let mut all = vec![json!(null), json!(true), json!([]), json!({}), json!([0, 1]), json!([[0, 1], [1, 2]])];
    all.extend([-1.0, 0.0, 0.3, 3.0, 1e9].map(Value::from));
    let texts = [
        "",
        "none",
        "abc",
        "1.5 mm",
        "50 m",
        "-3 m",
        "2 kg",
        "1e12 MPa",
        "10 m/s",
        "1e30 s",
        "3 qq",
        "1,5 m",
        "9999 degC",
        "500 deg",
        "1/2 in",
        "inf m",
        "1 kN",
        "simpson 4",
        "simpson 9999",
        "S235",
        "peak wav",
    ];
    all.extend(texts.map(Value::from));
    all
}

/// Adds the texts of the faults or of the warnings of a file.
fn faults(text: &str, texts: &mut BTreeSet<String>) {
    let faults = match parse(&Source::new("tank.json", text)) {
        Err(faults) => faults,
        Ok(file) => {
            texts.extend(file.warnings.iter().map(|warning| warning.text().to_owned()));
            return texts.extend(file.remarks);
        }
    };
    for fault in faults.list() {
        // The keys of an object, in a list.
        let keys = fault.code == Code::UnknownKey;
        let allowed = if keys { "" } else { &*fault.allowed };
        let help = fault.help.as_deref().unwrap_or_default();
        texts.extend([fault.message.as_str(), allowed, help].map(str::to_owned));
    }
}

/// Adds the texts of the faults of an example in which one value is another: each key of the schema has its own examples and its words, which do
/// not all go with the tank, and `others`.
fn spoiled(example: &str, others: &[Value]) -> BTreeSet<String> {
    let schema = json_schema();
    let mut all = Vec::new();
    keys(&schema, &schema, &[], &mut all);
    // The quantities that can be measured have the same keys.
    all.retain(|(path, _)| path[0] != "measured" || path.get(1).is_none_or(|quantity| quantity == "sloshing_height"));
    let file = root().join("examples").join(example).join("tank.json");
    let tank: Value = serde_json::from_str(&std::fs::read_to_string(file).expect("an example")).expect("JSON");
    let mut texts = BTreeSet::new();
    for (path, key) in &all {
        let target = key["$ref"].as_str().and_then(|r| schema.pointer(r.trim_start_matches('#')));
        let own = [Some(key), target].into_iter().flatten();
        let examples = own.flat_map(|k| [&k["examples"], &k["enum"]]).filter_map(Value::as_array).flatten();
        for value in others.iter().chain(examples) {
            let mut changed = tank.clone();
            put(&mut changed, path, value.clone());
            faults(&changed.to_string(), &mut texts);
        }
    }
    texts
}

/// One value of a tank is wrong, is missing, or stands where it does not apply: in tanks of steel, of concrete and of a strip.
#[test]
fn faults_and_warnings_are_german() {
    let wrong = wrong();
    let others = ["08_concrete_cylinder", "06_sandwich_strip", "09_slender_unanchored"];
    let mut texts = std::thread::scope(|scope| {
        let rest = scope.spawn(|| others.iter().flat_map(|example| spoiled(example, &[])).collect::<BTreeSet<_>>());
        let mut texts = spoiled("05_oil_tank", &wrong);
        texts.extend(rest.join().expect("no panic"));
        texts
    });
    let small = r#"{ "name": "t", "tank": { "shape": "cylinder", "radius": "10 m", "support": "anchored", "courses": [
        { "height": "8 m", "thickness": "10 mm", "material": "steel" } ] }, "liquid": { "density": "1000 kg/m3", "fill_height": "7 m" },
        "materials": { "steel": { "grade": "S235" } } }"#;
    for (from, to) in [
        ("\"10 m\"", "10 m"),
        ("\"10 m\"", "10m"),
        ("\"10 m\"", "'10 m'"),
        ("\"10 m\"", "NaN"),
        ("\"10 m\"", "1e999"),
        ("\"10 m\"", "032"),
        ("\"10 m\"", "True"),
        ("\"10 m\"", "abc"),
        ("\"10 m\"", ""),
        ("\"10 m\",", "\"10 m\""),
        ("\"radius\":", "\"radius\""),
        ("\"radius\":", "\"radius\"::"),
        ("\"radius\":", "radius:"),
        ("\"radius\":", "\"radios\":"),
        ("\"radius\": \"10 m\",", "\"radius\": \"10 m\",,"),
        ("\"radius\"", "\"shape\""),
        ("\"S235\" } } }", "\"S235\" } } } {}"),
        ("\"S235\" } } }", "\"S235\" } }"),
        ("\"S235\" } } }", "\"S235\" } } ]"),
        ("\"S235\" } } }", "\"S235"),
        ("\"steel\" } ]", "\"steel\" }"),
        ("{ \"name\"", "/* { \"name\""),
        ("{ \"name\": \"t\",", ""),
        ("\"8 m\"", "\"5 m\""),
        ("\"grade\": \"S235\"", "\"grade\": \"S236\""),
        ("\"grade\": \"S235\"", ""),
        ("\"material\": \"steel\"", "\"material\": \"A36\""),
        (
            "\"material\": \"steel\"",
            "\"layers\": [{ \"kind\": \"interlayer\", \"thickness\": \"3 mm\", \"material\": \"steel\" }]",
        ),
    ] {
        faults(&small.replacen(from, to, 1), &mut texts);
    }
    for word in [
        "diameter",
        "soil",
        "piles",
        "isolated",
        "floating",
        "cone_roof",
        "height",
        "level",
        "pga",
        "width",
        "thickness",
        "material",
        "legs",
        "wind_girder",
        "cladding",
        "snow",
        "ladder",
        "nozzles",
        "temperature",
        "corrosion",
        "design_pressure",
        "wind_speed",
        "joint_efficiency",
    ] {
        faults(&small.replacen("\"radius\"", &format!("\"{word}\""), 1), &mut texts);
    }
    for text in ["", "// nothing", "[]", "1", &"[".repeat(500)] {
        faults(text, &mut texts);
    }
    show("faults.txt", &texts);
    assert!(texts.len() > 500, "{}", texts.len());
    let missing = without_german(texts.iter().map(String::as_str));
    assert!(
        missing.is_empty(),
        "{} without German:\n{}",
        missing.len(),
        missing.into_iter().collect::<Vec<_>>().join("\n")
    );
    let german: BTreeSet<String> = texts.iter().filter_map(|text| of_input(text)).collect();
    let english = with_english(&german);
    assert!(english.is_empty(), "{english:#?}");
}

/// What `--solve` has found, for each of its variables, where a value holds and where none does.
#[test]
fn found_values_are_german() {
    let mut texts = BTreeSet::new();
    for (example, variable) in [
        ("05_oil_tank", "fill_height"),
        ("05_oil_tank", "thickness:1"),
        ("05_oil_tank", "thickness:7"),
        ("05_oil_tank", "ag"),
        ("05_oil_tank", "ss"),
        ("12_water_tank", "fill_height"),
        ("12_water_tank", "ag"),
    ] {
        let tank = root().join("examples").join(example).join("tank.json");
        let run = Command::new(env!("CARGO_BIN_EXE_tankcheck"))
            .arg("check")
            .arg(tank)
            .args(["--solve", variable])
            .output()
            .expect("runs");
        let out = String::from_utf8(run.stdout).expect("UTF-8");
        texts.extend(out.lines().filter(|line| line.contains(" evaluations from ")).map(str::to_owned));
    }
    show("found.txt", &texts);
    assert_eq!(texts.len(), 7, "{texts:#?}");
    let missing = without_german(texts.iter().map(String::as_str));
    assert!(missing.is_empty(), "{missing:#?}");
}
