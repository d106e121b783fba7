//! Results folders of the previous format are read, with the same numbers.

use results::{RESULTS_FILE, read, write};
use serde_json::{Map, Value, json};

use crate::sample::{Kind, sample};

/// A run as the previous format held it.
fn run_before(mut run: Value) -> Value {
    let map = run.as_object_mut().expect("a run");
    let take = |map: &mut Map<String, Value>, key: &str| map.shift_remove(key);
    let (end, events) = (take(map, "end"), take(map, "events"));
    if let Some(nonlinear) = map.get_mut("nonlinear").and_then(Value::as_object_mut) {
        nonlinear.insert("end".into(), end.expect("an end"));
        nonlinear.insert("events".into(), events.unwrap_or_else(|| json!([])));
    }
    let histories = take(map, "histories").expect("histories");
    map.insert("series".into(), histories);
    run
}

#[test]
fn results_of_the_previous_format_are_read() {
    for (kind, second) in [(Kind::Check, None), (Kind::Both, Some("fe_solid")), (Kind::Nonlinear, Some("fe_nonlinear"))]
    {
        let home = tempfile::tempdir().expect("a temporary folder");
        let (results, series) = sample(kind, "tank");
        write(home.path(), &results, &series).expect("writable");
        let expected = read(home.path()).expect("readable");
        let path = home.path().join(RESULTS_FILE);
        let text = std::fs::read_to_string(&path).expect("text");
        let mut value: Value = serde_json::from_str(&text).expect("JSON");
        let runs = value["runs"].take();
        let mut runs = runs.as_array().expect("a list").iter().cloned().map(run_before);
        let map = value.as_object_mut().expect("an object");
        map.shift_remove("runs");
        map.insert("format".into(), "tankcheck-results/1".into());
        // Formats 1 and 2 had one verdict over all methods, and checks with `holds` in place of a status.
        let failed = results.verdict.counts.fails;
        let verdict = json!({
            "holds": failed == 0, "checks": results.verdict.counts.compared(), "failed": failed,
            "governing": map["verdict"]["governing"],
        });
        map.insert("verdict".into(), verdict);
        map.insert("fe".into(), runs.next().unwrap_or(Value::Null));
        if let (Some(key), Some(run)) = (second, runs.next()) {
            map.insert(key.into(), run);
        }
        std::fs::write(&path, value.to_string()).expect("writable");
        // Who decided was not said.
        let mut expected = expected;
        expected.verdict.deciding.clear();
        assert_eq!(read(home.path()).expect("converted"), expected);
    }
}
