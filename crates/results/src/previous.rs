//! Results of earlier formats in the form of this one.
//!
//! | format | was | is |
//! |---|---|---|
//! | 1 | `fe`, `fe_solid`, `fe_nonlinear` | `runs`, in this order |
//! | 1 | `series` of a run | `histories` |
//! | 1 | `nonlinear.end`, `nonlinear.events` of a run | `end`, `events` |
//! | 1, 2 | `verdict.holds`, `checks`, `failed` | `verdict.status`, `counts`; all methods decided |
//! | 1, 2 | `verdict.incomplete` | `verdict.unfinished` |
//! | 1 to 3 | `isolation`, `soil`, `tilt`, `transfer` of a run | its part of this name in `parts` |
//! | 1 to 3 | `standing` | the part of this name in `parts` |
//!
//! No number changes. A check of an earlier format says `holds` in place of `status`; [`tank::check::Check`] reads both.

mod parts;

use serde_json::{Map, Value, json};

/// The formats that [`convert`] takes.
pub(crate) const FORMATS: [&str; 3] = ["tankcheck-results/1", "tankcheck-results/2", "tankcheck-results/3"];

/// Results of an earlier format in the present one. A value that is not an object is left unchanged, and reading reports it.
pub(crate) fn convert(mut results: Value) -> Value {
    let Value::Object(map) = &mut results else { return results };
    let format = map.insert("format".into(), super::FORMAT.into());
    let is = |known: &str| format.as_ref().and_then(Value::as_str) == Some(known);
    if let Some(Value::Object(verdict)) = map.get_mut("verdict").filter(|_| !is(FORMATS[2])) {
        convert_verdict(verdict);
    }
    if is(FORMATS[0]) {
        collect_runs(map);
    }
    parts::standing(map);
    let tank = map.get("tank").cloned().unwrap_or_default();
    let height = serde_json::from_value::<super::TankSummary>(tank).ok().map(|found| found.tank.wall_height());
    let runs = map.get_mut("runs").and_then(Value::as_array_mut);
    let runs = runs.into_iter().flatten().filter_map(Value::as_object_mut);
    runs.for_each(|run| parts::collect(run, height));
    results
}

fn convert_verdict(verdict: &mut Map<String, Value>) {
    let mut flag = |key: &str| verdict.remove(key).and_then(|v| v.as_bool()).unwrap_or_default();
    let (holds, unfinished) = (flag("holds"), flag("incomplete"));
    let mut number = |key: &str| verdict.remove(key).and_then(|v| v.as_u64()).unwrap_or_default();
    let (checks, fails) = (number("checks"), number("failed"));
    let status = match () {
        () if fails > 0 => "fails",
        () if checks == 0 => "not_assessed",
        () if holds => "holds",
        () => "incomplete",
    };
    let counts = json!({
        "holds": checks.saturating_sub(fails), "fails": fails, "not_checked": 0, "not_applicable": 0, "accepted": 0,
    });
    verdict.insert("status".into(), status.into());
    verdict.insert("counts".into(), counts);
    verdict.insert("unfinished".into(), unfinished.into());
}

fn collect_runs(map: &mut Map<String, Value>) {
    let mut runs = Vec::new();
    for key in ["fe", "fe_solid", "fe_nonlinear"] {
        match map.remove(key) {
            None | Some(Value::Null) => {}
            Some(run) => runs.push(convert_run(run)),
        }
    }
    map.insert("runs".into(), Value::Array(runs));
}

fn convert_run(mut run: Value) -> Value {
    let Value::Object(map) = &mut run else { return run };
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
            "format": FORMATS[0],
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
        assert_eq!(convert(json!({ "format": FORMATS[0], "fe": null }))["runs"], json!([]));
        assert_eq!(convert(json!(7)), json!(7));
    }

    /// Numbers of a tilt test and of transfer functions as format 3 had them, found under their ids.
    #[test]
    fn subjects_of_a_run_are_parts() {
        let tilt = json!({
            "angle": 0.1, "base_shear": 5.0, "base_moment": 7.0, "overturning_moment": 8.0, "r": [0.0, 2.0], "surface": [0.0, -0.2],
            "lines": [{ "id": "pressure", "title": "p", "dimension": "stress", "z": [0.0, 3.0], "low": [4.0, 1.0], "high": [2.0, 0.5] }],
            "notes": ["Tilted."],
        });
        let transfer = json!({
            "damping": "as_engine", "frequency": [0.5, 1.0],
            "modes": [{ "kind": "sloshing", "number": 1, "frequency": 0.6, "damping": 0.005 }],
            "functions": [{
                "id": "base_shear", "title": "V", "unit": "n_per_m_s2", "static_value": -2.0, "magnitude": [3.0, 8.0], "phase": [0.1, 0.2],
            }],
        });
        let new = convert(json!({ "format": FORMATS[2], "runs": [{ "tilt": tilt, "transfer": transfer }] }));
        let parts: Vec<crate::Part> = serde_json::from_value(new["runs"][0]["parts"].clone()).unwrap();
        let [transfer, tilt] = &parts[..] else { panic!("{parts:?}") };
        assert_eq!(transfer.cell("peaks", "base_shear", "static"), Some(-2.0));
        assert_eq!(transfer.cell("peaks", "base_shear", "amplification"), Some(4.0));
        assert_eq!(transfer.cell("modes", "sloshing", "frequency"), Some(0.6));
        let phases = transfer.table("transfer").unwrap().column("base_shear_phase_rad");
        assert_eq!(phases, [0.1, 0.2]);
        assert_eq!(tilt.value("base_moment").unwrap().value.value, 7.0);
        assert_eq!(tilt.value("rise").unwrap().value.value, 0.2);
        assert_eq!(tilt.line("pressure", "high").unwrap(), [[2.0, 0.0], [0.5, 3.0]]);
    }

    #[test]
    fn the_verdict_has_a_status() {
        for (holds, incomplete, checks, failed, status) in [
            (true, false, 4, 0, "holds"),
            (false, false, 4, 1, "fails"),
            (false, true, 4, 0, "incomplete"),
            (true, false, 0, 0, "not_assessed"),
        ] {
            let verdict = json!({ "holds": holds, "incomplete": incomplete, "checks": checks, "failed": failed });
            let new = convert(json!({ "format": FORMATS[1], "runs": [1], "verdict": verdict }));
            assert_eq!(new["verdict"]["status"], status);
            assert_eq!(new["verdict"]["counts"]["fails"], failed);
            assert_eq!(new["verdict"]["unfinished"], incomplete);
            assert_eq!(new["runs"], json!([1]));
        }
    }
}
