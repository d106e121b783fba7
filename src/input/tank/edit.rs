//! The text of a tank file with another value, all else as it was: comments, order, layout.

use jsonc_parser::ParseOptions;
use jsonc_parser::cst::{CstInputValue, CstNode, CstObject, CstRootNode};
use serde_json::Value;

use super::syntax;
use super::variant::{Step, steps};

/// The text with a value at a path (`tank.courses[0].thickness`). Objects on the way that are missing are added; an index one beyond the end
/// appends. Without a value, the key or item is removed.
///
/// Errors, in words: the text is not JSON, or the path leads nowhere.
pub fn edited(text: &str, path: &str, value: Option<&Value>) -> Result<String, String> {
    if !text.trim().is_empty() {
        syntax::check_tokens(text).map_err(|fault| fault.message)?;
    }
    let steps = steps(path).ok_or_else(|| format!("`{path}` is not a path"))?;
    let root = CstRootNode::parse(text, &ParseOptions::default()).map_err(|e| format!("the text is not valid: {e}"))?;
    let top = match root.value() {
        None => root.object_value_or_set(),
        Some(_) => root.object_value().ok_or("the text is not an object")?,
    };
    match value {
        Some(value) => set(&CstNode::from(top), &steps, value, path)?,
        None => remove(&CstNode::from(top), &steps),
    }
    Ok(root.to_string())
}

fn set(node: &CstNode, steps: &[Step], value: &Value, path: &str) -> Result<(), String> {
    let nowhere = || Err(format!("`{path}` leads through a value that is neither an object nor a list"));
    let Some((step, rest)) = steps.split_first() else { return nowhere() };
    match (step, node.as_object(), node.as_array()) {
        (Step::Key(key), Some(object), _) => member(&object, key, rest, value, path),
        (Step::Index(index), _, Some(list)) => {
            let items = list.elements();
            match items.get(*index) {
                Some(item) if rest.is_empty() => {
                    replace(item, written(value));
                    Ok(())
                }
                Some(item) => set(item, rest, value, path),
                None if items.len() == *index => {
                    list.append(built(rest, value));
                    Ok(())
                }
                None => Err(format!("`{path}`: found index {index}, expected 0 to {}", items.len())),
            }
        }
        _ => nowhere(),
    }
}

/// Puts a value in the place of another.
fn replace(node: &CstNode, value: CstInputValue) {
    macro_rules! as_one_of {
        ($($kind:ident)+) => {
            $(if let Some(node) = node.$kind() {
                node.replace_with(value);
                return;
            })+
        };
    }
    as_one_of!(as_object as_array as_string_lit as_number_lit as_boolean_lit as_null_keyword as_word_lit);
}

fn member(object: &CstObject, key: &str, rest: &[Step], value: &Value, path: &str) -> Result<(), String> {
    match object.get(key) {
        Some(member) if rest.is_empty() => {
            member.set_value(written(value));
            Ok(())
        }
        Some(member) => match member.value() {
            // A part that the file says is not there becomes one.
            Some(there) if there.as_object().is_some() || there.as_array().is_some() => set(&there, rest, value, path),
            _ => {
                member.set_value(built(rest, value));
                Ok(())
            }
        },
        None => {
            object.append(key, built(rest, value));
            Ok(())
        }
    }
}

/// A value within the objects and lists that the rest of a path asks for.
fn built(rest: &[Step], value: &Value) -> CstInputValue {
    let whole = rest.iter().rev().fold(value.clone(), |inner, step| match step {
        Step::Key(key) => Value::Object([(key.clone(), inner)].into_iter().collect()),
        Step::Index(_) => Value::Array(vec![inner]),
    });
    written(&whole)
}

/// A value on one line; the library writes a number as it is given.
fn written(value: &Value) -> CstInputValue {
    CstInputValue::Number(line(value))
}

fn line(value: &Value) -> String {
    let list = |items: Vec<String>, (open, close): (&str, &str)| match items.as_slice() {
        [] => format!("{}{}", open.trim(), close.trim()),
        items => format!("{open}{}{close}", items.join(", ")),
    };
    match value {
        Value::Object(members) => {
            let member = |(key, value): (&String, &Value)| format!("{}: {}", Value::from(key.as_str()), line(value));
            list(members.iter().map(member).collect(), ("{ ", " }"))
        }
        Value::Array(items) => list(items.iter().map(line).collect(), ("[", "]")),
        plain => plain.to_string(),
    }
}

fn remove(node: &CstNode, steps: &[Step]) {
    let Some((step, rest)) = steps.split_first() else { return };
    match (step, node.as_object(), node.as_array()) {
        (Step::Key(key), Some(object), _) => match object.get(key) {
            Some(member) if rest.is_empty() => member.remove(),
            Some(member) => {
                if let Some(inner) = member.value() {
                    remove(&inner, rest);
                }
            }
            None => {}
        },
        (Step::Index(index), _, Some(list)) => match list.elements().get(*index) {
            Some(item) if rest.is_empty() => item.clone().remove(),
            Some(item) => remove(item, rest),
            None => {}
        },
        _ => {}
    }
}

#[cfg(test)]
mod tests {
    use serde_json::json;

    use super::*;

    const TEXT: &str = r#"// The tank of the harbour.
{
  "name": "T1", // as on the drawing
  "tank": {
    "radius": "20 m",
    "courses": [
      { "height": "2 m", "thickness": "25 mm" }, /* lowest */
      { "height": "2 m", "thickness": "21 mm" },
    ],
    "roof": "none"
  }
}
"#;

    fn with(path: &str, value: Value) -> String {
        edited(TEXT, path, Some(&value)).unwrap()
    }

    /// Nothing else of the text moves: the expected texts are made by replacing in the text.
    #[test]
    fn a_value_is_replaced_and_all_else_stays() {
        assert_eq!(with("tank.radius", json!("21 m")), TEXT.replace("\"20 m\"", "\"21 m\""));
        let thinner = TEXT.replace("\"21 mm\"", "\"19 mm\"");
        assert_eq!(with("tank.courses[1].thickness", json!("19 mm")), thinner);
        let anew =
            TEXT.replace(r#"{ "height": "2 m", "thickness": "25 mm" }"#, r#"{ "height": "3 m", "a": [1, true] }"#);
        assert_eq!(with("tank.courses[0]", json!({ "height": "3 m", "a": [1, true] })), anew);
        let roof = TEXT.replace(r#""roof": "none""#, r#""roof": { "mass": "5 t" }"#);
        assert_eq!(with("tank.roof.mass", json!("5 t")), roof);
    }

    #[test]
    fn keys_and_items_are_added_where_they_are_missing() {
        let text = with("liquid.density", json!("870 kg/m3"));
        assert!(
            text.contains("// as on the drawing") && text.contains(r#""liquid": { "density": "870 kg/m3" }"#),
            "{text}"
        );
        let text = with("tank.courses[2]", json!({ "height": "1 m" }));
        assert!(text.contains("\n      { \"height\": \"1 m\" }"), "{text}");
        assert!(text.contains("/* lowest */"));
        let text = with("materials[\"A 36\"].density", json!("7850 kg/m3"));
        assert!(text.contains(r#""materials": { "A 36": { "density": "7850 kg/m3" } }"#), "{text}");
        assert_eq!(edited("", "name", Some(&json!("x"))).unwrap().trim(), "{\n  \"name\": \"x\"\n}");
    }

    #[test]
    fn keys_and_items_are_removed() {
        let text = edited(TEXT, "tank.courses[0]", None).unwrap();
        assert!(!text.contains("25 mm") && text.contains("21 mm"), "{text}");
        let text = edited(TEXT, "name", None).unwrap();
        assert!(!text.contains("\"T1\"") && text.contains("// The tank of the harbour."), "{text}");
        assert_eq!(edited(TEXT, "tank.nothing.there", None).unwrap(), TEXT);
    }

    #[test]
    fn what_leads_nowhere_is_refused() {
        for (text, path) in
            [(TEXT, "tank.courses[7]"), (TEXT, "tank.courses.x"), (TEXT, ".."), ("[1]", "a"), ("{\"a\": ", "a")]
        {
            assert!(edited(text, path, Some(&json!(1))).is_err(), "{path}");
        }
        let deep = "[".repeat(100_000);
        assert!(edited(&format!("{{\"a\": {deep}"), "a", Some(&json!(1))).is_err());
    }
}
