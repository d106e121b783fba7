//! JSON documents as trees that keep numbers as written.

use jsonc_parser::ast::Value;
use jsonc_parser::{CollectOptions, ParseOptions, parse_to_ast};

/// A JSON value; numbers keep their text.
#[derive(Clone, Debug, PartialEq)]
pub enum Json {
    /// `null`.
    Null,
    /// `true` or `false`.
    Bool(bool),
    /// A number as written.
    Number(String),
    /// A string, unescaped.
    Text(String),
    /// An array.
    List(Vec<Json>),
    /// An object, in the order of the file.
    Object(Vec<(String, Json)>),
}

impl Json {
    /// Reads JSON with comments and trailing commas; `None` if it is not that.
    pub fn parse(text: &str) -> Option<Json> {
        let options = ParseOptions {
            allow_comments: true,
            allow_trailing_commas: true,
            allow_loose_object_property_names: false,
            allow_missing_commas: false,
            allow_single_quoted_strings: false,
            allow_hexadecimal_numbers: false,
            allow_unary_plus_numbers: false,
        };
        let result = parse_to_ast(text, &CollectOptions::default(), &options).ok()?;
        result.value.map(Json::of)
    }

    fn of(value: Value) -> Json {
        match value {
            Value::StringLit(text) => Json::Text(text.value.into_owned()),
            Value::NumberLit(number) => Json::Number(number.value.to_owned()),
            Value::BooleanLit(value) => Json::Bool(value.value),
            Value::NullKeyword(_) => Json::Null,
            Value::Array(array) => Json::List(array.elements.into_iter().map(Json::of).collect()),
            Value::Object(object) => {
                let member = |p: jsonc_parser::ast::ObjectProp| (p.name.as_str().to_owned(), Json::of(p.value));
                Json::Object(object.properties.into_iter().map(member).collect())
            }
        }
    }

    /// Plain JSON on one line.
    pub fn print(&self) -> String {
        let mut out = String::new();
        self.write(&mut out);
        out
    }

    fn write(&self, out: &mut String) {
        match self {
            Json::Null => out.push_str("null"),
            Json::Bool(value) => out.push_str(if *value { "true" } else { "false" }),
            Json::Number(text) => out.push_str(text),
            Json::Text(text) => out.push_str(&quoted(text)),
            Json::List(items) => {
                out.push('[');
                for (i, item) in items.iter().enumerate() {
                    out.push_str(if i > 0 { "," } else { "" });
                    item.write(out);
                }
                out.push(']');
            }
            Json::Object(members) => {
                out.push('{');
                for (i, (key, value)) in members.iter().enumerate() {
                    out.push_str(if i > 0 { "," } else { "" });
                    out.push_str(&quoted(key));
                    out.push(':');
                    value.write(out);
                }
                out.push('}');
            }
        }
    }

    /// The same with the keys of every object in reverse order.
    pub fn reversed(&self) -> Json {
        match self {
            Json::List(items) => Json::List(items.iter().map(Json::reversed).collect()),
            Json::Object(members) => {
                Json::Object(members.iter().rev().map(|(k, v)| (k.clone(), v.reversed())).collect())
            }
            other => other.clone(),
        }
    }

    /// Applies `change` to every value with its key (of the nearest object), children first.
    pub fn each(&mut self, key: &str, change: &mut impl FnMut(&str, &mut Json)) {
        match self {
            Json::List(items) => items.iter_mut().for_each(|item| item.each(key, change)),
            Json::Object(members) => members.iter_mut().for_each(|(k, v)| v.each(k, change)),
            _ => {}
        }
        change(key, self);
    }

    /// Number of values.
    pub fn size(&self) -> usize {
        1 + match self {
            Json::List(items) => items.iter().map(Json::size).sum(),
            Json::Object(members) => members.iter().map(|(_, v)| v.size()).sum::<usize>(),
            _ => 0,
        }
    }

    /// The value with this number, itself being 0.
    pub fn nth(&mut self, n: usize) -> Option<&mut Json> {
        if n == 0 {
            return Some(self);
        }
        let mut left = n - 1;
        let children: Vec<&mut Json> = match self {
            Json::List(items) => items.iter_mut().collect(),
            Json::Object(members) => members.iter_mut().map(|(_, v)| v).collect(),
            _ => Vec::new(),
        };
        for child in children {
            let size = child.size();
            if left < size {
                return child.nth(left);
            }
            left -= size;
        }
        None
    }
}

fn quoted(text: &str) -> String {
    serde_json::to_string(text).expect("a string is JSON")
}
