//! The schema and the reference page agree with the reader.

use serde_json::{Value, json};

use super::small;
use crate::input::diagnostic::Source;
use crate::input::tank::{json_schema, markdown, parse};

/// Keys of the schema, each with its path in a file and its schema; lists and named objects have one item, called `steel`.
fn schema_keys() -> Vec<(Vec<String>, Value)> {
    fn walk(schema: &Value, root: &Value, path: &[String], all: &mut Vec<(Vec<String>, Value)>) {
        let below = |key: &str| [path, &[key.to_owned()]].concat();
        if let Some(Value::String(reference)) = schema.get("$ref") {
            let target = root.pointer(reference.trim_start_matches('#')).expect("a definition");
            walk(target, root, path, all);
        }
        for (key, property) in schema.get("properties").and_then(Value::as_object).into_iter().flatten() {
            all.push((below(key), property.clone()));
            walk(property, root, &below(key), all);
        }
        for option in schema.get("anyOf").and_then(Value::as_array).into_iter().flatten() {
            walk(option, root, path, all);
        }
        if let Some(item) = schema.get("items") {
            walk(item, root, &below("0"), all);
        }
        if let Some(item) = schema.get("additionalProperties").filter(|a| a.is_object()) {
            walk(item, root, &below("steel"), all);
        }
    }
    let schema = json_schema();
    let mut all = Vec::new();
    walk(&schema, &schema, &[], &mut all);
    all.retain(|(path, _)| path[0] != "$schema");
    all
}

/// Puts a value into a document; missing parents are created.
fn put(document: &mut Value, path: &[String], value: Value) {
    let [key, rest @ ..] = path else {
        *document = value;
        return;
    };
    match key.parse::<usize>() {
        Ok(_) => {
            if !document.is_array() {
                *document = json!([{}]);
            }
            put(&mut document[0], rest, value);
        }
        Err(_) => {
            if !document.is_object() {
                *document = json!({});
            }
            put(&mut document[key.as_str()], rest, value);
        }
    }
}

/// Path as messages write it.
fn shown(path: &[String]) -> String {
    let joined = path.join(".");
    joined.replace(".0.", "[0].").replace(".0", "[0]")
}

/// Faults of a file that stand at this path.
fn faults_at(document: &Value, path: &str) -> Vec<String> {
    match parse(&Source::new("tank.json", document.to_string())) {
        Ok(_) => Vec::new(),
        Err(faults) => {
            (faults.list().iter()).filter(|f| *f.path == *path).map(|f| format!("{path}: {}", f.message)).collect()
        }
    }
}

#[test]
fn schema_explains_every_key() {
    let keys = schema_keys();
    assert!(keys.len() > 200, "{}", keys.len());
    for (path, schema) in &keys {
        let text = schema["description"].as_str().unwrap_or_default();
        assert!(text.len() > 3, "{}: {schema}", shown(path));
        // A value that is not an object, a list or a word of a choice has an example.
        let scalar = schema.get("type").is_some_and(|t| t != "object" && t != "array") || schema.get("anyOf").is_some();
        let reported = path[0] == "measured";
        assert!(
            !scalar || schema.get("examples").is_some() || reported,
            "{} is without an example: {schema}",
            shown(path)
        );
    }
}

/// The reader accepts every example and every default of the schema within its limits.
#[test]
fn examples_and_defaults_of_the_schema_are_read() {
    let base: Value = serde_json::from_str(&small("")).expect("a document");
    let mut tried = 0;
    for (path, schema) in schema_keys() {
        let examples = schema.get("examples").and_then(Value::as_array).into_iter().flatten();
        for value in examples.chain(schema.get("default")) {
            let mut document = base.clone();
            put(&mut document, &path, value.clone());
            tried += 1;
            let found = faults_at(&document, &shown(&path));
            // These depend on other keys.
            let context = [
                "not apply to a",
                "unknown grade",
                "unknown material",
                "bars are outside",
                "exclude each other",
                "the roof is",
                "one site coefficient",
                "cannot read the table",
                "cannot read the record",
                "thinner than any",
                "thicker than any",
                "the liquid is higher",
                "annular plate",
                "anchors with",
                "applies to a strip alone",
                "applies to a displacement liquid alone",
            ];
            let own: Vec<&String> = found.iter().filter(|f| !context.iter().any(|c| f.contains(c))).collect();
            assert!(own.is_empty(), "{value}: {own:?}");
        }
    }
    assert!(tried > 150, "{tried}");
}

/// A number beyond a limit of the schema is a fault of the reader.
#[test]
fn limits_of_the_schema_are_those_of_the_reader() {
    let base: Value = serde_json::from_str(&small("")).expect("a document");
    let mut tried = 0;
    for (path, schema) in schema_keys() {
        let number = match schema.get("anyOf").and_then(|a| a.get(0)) {
            Some(number) => number,
            None => &schema,
        };
        let beyond = [
            ("minimum", -0.5, false),
            ("exclusiveMinimum", 0.0, false),
            ("maximum", 0.5, true),
            ("exclusiveMaximum", 0.0, true),
        ];
        for (keyword, step, up) in beyond {
            let Some(limit) = number.get(keyword).and_then(Value::as_f64) else { continue };
            let whole = number["type"] == "integer";
            let value = match (whole, up) {
                (true, true) => json!(limit as i64 + 1),
                (true, false) => json!(limit as i64 - 1),
                (false, _) => json!(limit + step),
            };
            let mut document = base.clone();
            put(&mut document, &path, value.clone());
            tried += 1;
            assert!(
                !faults_at(&document, &shown(&path)).is_empty(),
                "{}: {value} is beyond {keyword} {limit} and no fault",
                shown(&path)
            );
        }
    }
    assert!(tried > 60, "{tried}");
}

/// A joint between wall and base and one between plates are two choices.
#[test]
fn welds_of_the_annular_plate_are_those_of_the_reader() {
    let schema = json_schema();
    let weld = schema.pointer("/$defs/Bottom/properties/annular_weld/$ref");
    let name = weld.and_then(Value::as_str).expect("a choice");
    let words = schema.pointer(name.trim_start_matches('#')).expect("a definition");
    assert_eq!(words["enum"], json!(["butt", "lap"]));
}

/// The reference page has every key of the schema.
#[test]
fn reference_page_names_every_key() {
    let page = markdown();
    for (path, _) in schema_keys() {
        let key = path.last().expect("a key");
        let quantity = path.len() == 2 && path[0] == "measured";
        assert!(quantity || page.contains(&format!("| `{key}` |")), "{}", shown(&path));
    }
}
