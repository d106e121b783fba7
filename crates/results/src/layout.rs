//! Layout of the JSON files of results, for people who read them and for the differences that git shows.
//!
//! * What fits in [`SHORT`] bytes stands on one line.
//! * So does a row of a table up to [`ROW`] bytes: an element of a list, or an object without lists and objects in it.
//! * So do numbers, alone in lists and objects; a longer list of them fills lines of [`ROW`] bytes.
//! * Everything else has a line for each element or member, indented by two spaces.
//!
//! A parser reads the same document in any layout.

use std::fmt::Write;

use serde_json::Value;

/// Longest line of a container that people read item by item.
const SHORT: usize = 120;
/// Longest line of a row of a table, and of numbers: two profiles of about hundred numbers and their title.
const ROW: usize = 4000;

/// A document as text, with a line break at its end.
///
/// ```text
/// {
///   "name": "Broad tank",
///   "steps": [
///     {"symbol": "R", "name": "inner radius", "value": 1.83, "clause": "…"},
///     {"symbol": "H", "name": "liquid depth", "value": 1.525, "clause": "…"}
///   ]
/// }
/// ```
pub(crate) fn text(document: &Value) -> String {
    let mut text = String::new();
    put(document, 0, SHORT, &mut text);
    text.push('\n');
    text
}

/// Appends a value; its first line goes on where the text ends, its other lines are indented by `indent` and more.
fn put(value: &Value, indent: usize, width: usize, text: &mut String) {
    let numbers = only_numbers(value);
    let width = if numbers { ROW } else { width };
    let start = text.len();
    let line = text.rfind('\n').map_or(0, |at| at + 1);
    // One byte for the comma.
    if one_line(value, line + width - 1, text) {
        return;
    }
    text.truncate(start);
    match value {
        Value::Array(items) if numbers => fill(items, indent, text),
        Value::Array(items) => lines(['[', ']'], indent, items, text, |item, text| {
            put(item, indent + 2, ROW, text);
        }),
        Value::Object(map) => lines(['{', '}'], indent, map, text, |(key, member), text| {
            put_key(key, text);
            let width = if is_row(member) { ROW } else { SHORT };
            put(member, indent + 2, width, text);
        }),
        scalar => put_scalar(scalar, text),
    }
}

/// Whether a value is a number, or a list or an object of such values.
fn only_numbers(value: &Value) -> bool {
    match value {
        Value::Array(items) => items.iter().all(only_numbers),
        Value::Object(map) => map.values().all(only_numbers),
        other => other.is_number(),
    }
}

/// Whether a value is an object without lists and objects in it.
fn is_row(value: &Value) -> bool {
    let scalar = |member: &Value| !(member.is_array() || member.is_object());
    value.as_object().is_some_and(|map| map.values().all(scalar))
}

/// Appends a container, a line for each item.
fn lines<I: IntoIterator>(
    [open, close]: [char; 2],
    indent: usize,
    items: I,
    text: &mut String,
    put_item: impl Fn(I::Item, &mut String),
) {
    text.push(open);
    for (number, item) in items.into_iter().enumerate() {
        if number > 0 {
            text.push(',');
        }
        new_line(indent + 2, text);
        put_item(item, text);
    }
    new_line(indent, text);
    text.push(close);
}

/// Appends a list of numbers, and of lists and objects of them, whose items fill lines.
fn fill(items: &[Value], indent: usize, text: &mut String) {
    text.push('[');
    let mut end = 0;
    let mut item = String::new();
    for (number, value) in items.iter().enumerate() {
        if number > 0 {
            text.push(',');
        }
        item.clear();
        // Beside the item there are its indent and a comma.
        if !one_line(value, ROW - indent - 3, &mut item) {
            new_line(indent + 2, text);
            put(value, indent + 2, ROW, text);
            end = 0;
            continue;
        }
        // A space before it and a comma after it.
        if text.len() + item.len() + 2 > end {
            new_line(indent + 2, text);
            end = text.len() - (indent + 2) + ROW;
        } else {
            text.push(' ');
        }
        text.push_str(&item);
    }
    new_line(indent, text);
    text.push(']');
}

fn new_line(indent: usize, text: &mut String) {
    text.push('\n');
    text.extend(std::iter::repeat_n(' ', indent));
}

/// Appends a value on one line; false as soon as the text is longer than `limit`, with a part of the value.
fn one_line(value: &Value, limit: usize, text: &mut String) -> bool {
    match value {
        Value::Array(items) => {
            text.push('[');
            for (number, item) in items.iter().enumerate() {
                text.push_str(if number > 0 { ", " } else { "" });
                if !one_line(item, limit, text) {
                    return false;
                }
            }
            text.push(']');
        }
        Value::Object(map) => {
            text.push('{');
            for (number, (key, member)) in map.iter().enumerate() {
                text.push_str(if number > 0 { ", " } else { "" });
                put_key(key, text);
                if !one_line(member, limit, text) {
                    return false;
                }
            }
            text.push('}');
        }
        scalar => put_scalar(scalar, text),
    }
    text.len() <= limit
}

fn put_key(key: &str, text: &mut String) {
    // Escaped as JSON; writing to a string cannot fail.
    let _ = write!(text, "{}: ", Value::from(key));
}

fn put_scalar(scalar: &Value, text: &mut String) {
    let _ = write!(text, "{scalar}");
}

#[cfg(test)]
mod tests {
    use serde_json::json;

    use super::*;

    #[test]
    fn short_values_and_rows_stand_on_one_line() {
        let clause = "x".repeat(130);
        let document = json!({
            "name": "a \"b\"\n",
            "quantities": {"base_shear": {"value": 1.5, "unit": "N"}, "base_moment": {"value": 1e-7, "unit": clause}},
            "steps": [{"symbol": "R", "clause": clause}, {"symbol": "H", "path": [[-0.0, 1.0]]}],
            "empty": [{}, []],
        });
        let expected = format!(
            r#"{{
  "name": "a \"b\"\n",
  "quantities": {{
    "base_shear": {{"value": 1.5, "unit": "N"}},
    "base_moment": {{"value": 1e-7, "unit": "{clause}"}}
  }},
  "steps": [
    {{"symbol": "R", "clause": "{clause}"}},
    {{"symbol": "H", "path": [[-0.0, 1.0]]}}
  ],
  "empty": [{{}}, []]
}}
"#
        );
        assert_eq!(text(&document), expected);
    }

    /// No line is longer than allowed, and the document is the same.
    #[test]
    fn numbers_fill_lines() {
        let numbers: Vec<f64> = (0..2000).map(|i| f64::from(i) / 7.0).collect();
        let pairs: Vec<[f64; 2]> = numbers.iter().map(|x| [*x, -x]).collect();
        let cracks: Vec<Value> = numbers.iter().map(|x| json!({"cell": 1, "width": x})).collect();
        let sentences = vec!["s".repeat(70); 40];
        let document = json!({
            "a": numbers, "cycles": [pairs, pairs], "notes": sentences, "cracks": cracks,
            "shape": {"z": numbers, "wall": [1.0]},
        });
        let shown = text(&document);
        assert_eq!(serde_json::from_str::<Value>(&shown).expect("JSON"), document);
        let long: Vec<usize> = shown.lines().map(str::len).filter(|length| *length > SHORT).collect();
        let full = long.iter().filter(|length| **length > ROW - 60).count();
        assert!(full > 60 && full + 8 > long.len(), "{full} of {}", long.len());
        assert!(long.iter().all(|length| *length <= ROW), "{long:?}");
        assert_eq!(shown.lines().filter(|line| line.contains("sss")).count(), 40);
    }
}
