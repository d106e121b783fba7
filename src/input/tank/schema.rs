//! The JSON Schema of `tank.json` and `study.json`, draft 2020-12, written from the declarations of their keys.

use serde_json::{Map, Value, json};
use tank::Quantity;
use tank::units::Dimension;

use super::keys::TankFile;
use super::read::FromNode;
use super::shape::{Book, KeyInfo, Object, Shape};
use super::values::pattern;
use tank::keys::Limits;

/// The JSON Schema of `tank.json`, draft 2020-12.
pub fn json_schema() -> Value {
    of::<TankFile>("tank.json", "TankFile", conditions)
}

/// The JSON Schema of a file whose top level is the object `name`.
///
/// * `conditions`: requirements between keys
pub(in crate::input) fn of<T: FromNode>(
    title: &str,
    name: &str,
    conditions: impl Fn(&mut Map<String, Value>),
) -> Value {
    let mut book = Book::default();
    T::shape(&mut book);
    let mut definitions = Map::new();
    for object in &book.objects {
        let schema = object_schema(object, &mut definitions);
        definitions.insert(object.name.into(), schema);
    }
    for choice in &book.choices {
        let words: Vec<&str> = choice.words.iter().map(|(word, _)| *word).collect();
        let meanings: Vec<Value> =
            choice.words.iter().map(|(word, meaning)| json!({ "const": word, "description": meaning })).collect();
        let schema = json!({ "description": choice.help, "type": "string", "enum": words, "oneOf": meanings });
        definitions.insert(choice.name.into(), schema);
    }
    conditions(&mut definitions);
    let mut root = Map::new();
    root.insert("$schema".into(), "https://json-schema.org/draft/2020-12/schema".into());
    root.insert("title".into(), title.into());
    if let Some(Value::Object(file)) = definitions.remove(name) {
        root.extend(file);
    }
    // Editors find the schema by this key of the document; the reader skips it.
    if let Some(properties) = root.get_mut("properties").and_then(Value::as_object_mut) {
        properties
            .insert("$schema".into(), json!({ "description": "Where editors find this schema.", "type": "string" }));
    }
    definitions.sort_keys();
    root.insert("$defs".into(), definitions.into());
    root.into()
}

/// Requirements between keys.
fn conditions(definitions: &mut Map<String, Value>) {
    let mut add = |name: &str, keyword: &str, rule: Value| {
        if let Some(Value::Object(object)) = definitions.get_mut(name) {
            object.insert(keyword.into(), rule);
        }
    };
    // A course is of one material or of layers.
    add("Course", "oneOf", json!([{ "required": ["thickness", "material"] }, { "required": ["layers"] }]));
    // Without the user's spectrum each code needs its values of the site; only the zone method needs nothing else.
    add(
        "Site",
        "allOf",
        json!([{
            "if": { "not": { "required": ["spectrum"] } },
            "then": { "properties": {
                "ec8": { "required": ["ground", "spectrum", "ag"] },
                "api650": {
                    "anyOf": [{ "required": ["ss", "s1", "site_class", "sug", "tl"] }, { "required": ["zone_factor"] }]
                },
            } },
        }]),
    );
    add("Api650", "anyOf", json!([{ "required": ["sug"] }, { "required": ["zone_factor"] }]));
    add(
        "Spectrum",
        "oneOf",
        json!([
            { "required": ["table", "unit"] },
            { "required": ["file"] },
            { "required": ["ag", "soil_factor", "tb", "tc", "td"] },
        ]),
    );
    // The required dimensions depend on the shape.
    let shape_is = |word: &str| json!({ "properties": { "shape": { "const": word } }, "required": ["shape"] });
    add(
        "Tank",
        "allOf",
        json!([
            { "if": shape_is("cylinder"), "then": { "required": ["radius"] } },
            { "if": shape_is("rectangle"),
              "then": { "required": ["length"], "anyOf": [{ "required": ["breadth"] }, { "required": ["strip"] }] } },
        ]),
    );
}

fn object_schema(object: &Object, definitions: &mut Map<String, Value>) -> Value {
    let properties: Map<String, Value> =
        object.keys.iter().map(|key| (key.name.into(), key_schema(key, definitions))).collect();
    let required: Vec<&str> = object.keys.iter().filter(|k| k.required).map(|k| k.name).collect();
    let mut schema = json!({ "description": object.help, "type": "object", "properties": properties });
    if !required.is_empty() {
        schema["required"] = required.into();
    }
    schema["additionalProperties"] = false.into();
    schema
}

fn key_schema(key: &KeyInfo, definitions: &mut Map<String, Value>) -> Value {
    let mut schema = value_schema(&key.shape, key.limits, definitions);
    schema["description"] = key.description().into();
    if let Some(default) = &key.default {
        schema["default"] = value(default, &key.shape);
    }
    if !key.example.is_empty() {
        let examples = match &key.shape {
            Shape::Pattern { examples, .. } if !examples.contains(&key.example.as_str()) => {
                let own = [key.example.as_str()];
                own.iter().chain(*examples).map(|e| value(e, &key.shape)).collect()
            }
            Shape::Pattern { examples, .. } => examples.iter().map(|e| value(e, &key.shape)).collect(),
            _ => vec![value(&key.example, &key.shape)],
        };
        // The words of a choice are their own examples.
        if !matches!(key.shape, Shape::Choice(_)) {
            schema["examples"] = examples.into();
        }
    }
    schema
}

/// A value as a user writes it, as JSON.
fn value(written: &str, shape: &Shape) -> Value {
    let bare = match shape {
        Shape::Quantity(dimension) => *dimension == Dimension::Dimensionless,
        Shape::Conventional(..) | Shape::Whole | Shape::Bool => true,
        _ => false,
    };
    let parsed = bare.then(|| serde_json::from_str(written).ok()).flatten();
    parsed.unwrap_or_else(|| written.into())
}

fn value_schema(shape: &Shape, limits: Limits, definitions: &mut Map<String, Value>) -> Value {
    match shape {
        Shape::Object(name) | Shape::Choice(name) => reference(name),
        Shape::Quantity(Dimension::Dimensionless) => {
            let percentage = json!({ "type": "string", "pattern": pattern(Dimension::Dimensionless) });
            json!({ "anyOf": [number("number", limits), percentage] })
        }
        Shape::Quantity(dimension) => {
            let name = format!("{dimension:?}");
            let units: Vec<&str> = dimension.units().map(|u| u.text).collect();
            definitions.entry(name.as_str()).or_insert_with(|| {
                json!({
                    "description": format!("{} with its unit: {}.", capitalized(dimension.noun()), units.join(", ")),
                    "type": "string",
                    "pattern": pattern(*dimension),
                    "examples": [dimension.example()],
                })
            });
            reference(&name)
        }
        Shape::Conventional(dimension, _) => {
            let quantity = json!({ "type": "string", "pattern": pattern(*dimension) });
            json!({ "anyOf": [number("number", limits), quantity] })
        }
        Shape::Whole => match limits.bounded() || !limits.values.is_empty() {
            true => number("integer", limits),
            false => number("integer", Limits::from(0.0)),
        },
        Shape::Bool => json!({ "type": "boolean" }),
        Shape::Text => json!({ "type": "string" }),
        Shape::Pattern { patterns, .. } => match patterns.as_slice() {
            [] => json!({ "type": "string" }),
            [one] => json!({ "type": "string", "pattern": one }),
            all => {
                let all: Vec<Value> = all.iter().map(|p| json!({ "pattern": p })).collect();
                json!({ "type": "string", "anyOf": all })
            }
        },
        Shape::List(item) => {
            let (fewest, most) = limits.items;
            let mut schema = json!({ "type": "array", "items": value_schema(item, limits, definitions) });
            if fewest > 0 {
                schema["minItems"] = fewest.into();
            }
            if most < usize::MAX {
                schema["maxItems"] = most.into();
            }
            schema
        }
        Shape::Named(item) => {
            json!({ "type": "object", "additionalProperties": value_schema(item, Limits::ANY, definitions) })
        }
        Shape::Either(word, other) => {
            let mut ways = vec![json!({ "const": word })];
            match value_schema(other, limits, definitions) {
                // A second word stands beside the first.
                Value::Object(mut rest) if matches!(other.as_ref(), Shape::Either(..)) => {
                    ways.extend(
                        rest.remove("anyOf")
                            .as_mut()
                            .and_then(Value::as_array_mut)
                            .into_iter()
                            .flat_map(std::mem::take),
                    );
                }
                rest => ways.push(rest),
            }
            json!({ "anyOf": ways })
        }
        Shape::Measured(object) => measured(object, definitions),
    }
}

/// An object for each quantity, whose `value` is of its dimension; a period may be given as a frequency.
fn measured(object: &str, definitions: &mut Map<String, Value>) -> Value {
    let properties: Map<String, Value> = Quantity::ALL
        .into_iter()
        .map(|quantity| {
            let dimension = quantity.dimension();
            let mut value = match dimension {
                Dimension::Time => {
                    let patterns = [Dimension::Time, Dimension::Frequency, Dimension::AngularFrequency];
                    let patterns = patterns.map(|d| json!({ "pattern": pattern(d) }));
                    json!({ "type": "string", "anyOf": patterns })
                }
                dimension => value_schema(&Shape::Quantity(dimension), Limits::ANY, definitions),
            };
            value["description"] = format!("{} with its unit.", capitalized(dimension.noun())).into();
            value["examples"] = [dimension.example()].into_iter().collect();
            let mut schema = reference(object);
            schema["description"] = quantity.title().into();
            schema["properties"] = json!({ "value": value });
            (quantity.id().to_owned(), schema)
        })
        .collect();
    json!({ "type": "object", "properties": properties, "additionalProperties": false })
}

/// A bare number within limits.
fn number(kind: &str, limits: Limits) -> Value {
    let mut schema = json!({ "type": kind });
    if !limits.values.is_empty() {
        schema["enum"] = limits.values.iter().map(|v| plain(*v)).collect();
        return schema;
    }
    let ends = [
        (limits.low, if limits.low_allowed { "minimum" } else { "exclusiveMinimum" }),
        (limits.high, if limits.high_allowed { "maximum" } else { "exclusiveMaximum" }),
    ];
    for (end, keyword) in ends {
        if end.is_finite() {
            schema[keyword] = plain(end);
        }
    }
    schema
}

/// A number, without a decimal point where it is whole.
fn plain(number: f64) -> Value {
    serde_json::from_str(&number.to_string()).unwrap_or_else(|_| number.into())
}

fn reference(name: &str) -> Value {
    json!({ "$ref": format!("#/$defs/{name}") })
}

/// The text with a capital letter.
fn capitalized(text: &str) -> String {
    let mut letters = text.chars();
    let first = letters.next().map(|c| c.to_uppercase().to_string());
    first.unwrap_or_default() + letters.as_str()
}
