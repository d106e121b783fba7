//! Results of the format before this one, `tankcheck-results/1`, brought into the form of this one.
//!
//! | was | is |
//! |---|---|
//! | `fe`, `fe_solid`, `fe_nonlinear` | `runs`, in this order |
//! | `series` of a run | `histories` |
//! | `nonlinear.end`, `nonlinear.events` of a run | `end`, `events` |
//!
//! No number changes.

use serde_json::{Map, Value, json};

/// The format that [`convert`] takes.
pub(crate) const FORMAT: &str = "tankcheck-results/1";

/// Results of the previous format in the present one. A value that is not an object is left unchanged, and reading reports it.
pub(crate) fn convert(mut results: Value) -> Value {
    let Value::Object(map) = &mut results else {
        return results;
    };
    map.insert("format".into(), super::FORMAT.into());
    let mut runs = Vec::new();
    for key in ["fe", "fe_solid", "fe_nonlinear"] {
        match map.remove(key) {
            None | Some(Value::Null) => {}
            Some(run) => runs.push(convert_run(run)),
        }
    }
    map.insert("runs".into(), Value::Array(runs));
    results
}

fn convert_run(mut run: Value) -> Value {
    let Value::Object(map) = &mut run else {
        return run;
    };
    let nonlinear = map.get_mut("nonlinear").and_then(Value::as_object_mut);
    let taken = |from: Option<&mut Map<String, Value>>| -> [Option<Value>; 2] {
        from.map_or([None, None], |n| ["end", "events"].map(|key| n.remove(key)))
    };
    let [end, events] = taken(nonlinear);
    map.insert("end".into(), end.unwrap_or_else(|| json!({ "kind": "completed" })));
    if let Some(events) = events {
        map.insert("events".into(), events);
    }
    if let Some(series) = map.remove("series") {
        map.insert("histories".into(), series);
    }
    run
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn runs_stand_in_one_list() {
        let old = json!({
            "format": FORMAT,
            "fe": { "engine": "harmonic", "series": [1.5] },
            "fe_nonlinear": {
                "engine": "nonlinear",
                "series": [],
                "nonlinear": { "end": { "kind": "left" }, "events": [2.5], "grid": 3 },
            },
            "verdict": 4,
        });
        let new = json!({
            "format": super::super::FORMAT,
            "runs": [
                { "engine": "harmonic", "end": { "kind": "completed" }, "histories": [1.5] },
                {
                    "engine": "nonlinear",
                    "end": { "kind": "left" },
                    "events": [2.5],
                    "histories": [],
                    "nonlinear": { "grid": 3 },
                },
            ],
            "verdict": 4,
        });
        assert_eq!(convert(old), new);
        assert_eq!(convert(json!({ "format": FORMAT, "fe": null }))["runs"], json!([]));
        assert_eq!(convert(json!(7)), json!(7));
    }
}
