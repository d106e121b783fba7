//! Parts of a tank of which its file says nothing: named, and what needs them is open; "none" is an answer.

use tank::assessment::CheckStatus;

use super::*;

/// Everything of the base tank and one part less.
fn results(changes: Vec<Value>) -> Results {
    let home = tempfile::tempdir().expect("a temporary folder");
    let changes = [vec![only_ec8()], changes].concat();
    let tank = Tank::new("unsaid", "", Expected::NotAssessed, changes);
    tank.results(home.path()).expect("the input is good")
}

fn status(results: &Results, id: &str) -> (CheckStatus, Option<String>) {
    let method = results.methods.iter().find(|m| m.id == "ec8-2006").expect("the code");
    let check = method.checks.iter().find(|c| c.limit_state == id).expect("the limit state");
    (check.status, check.input.clone())
}

fn unstated(results: &Results) -> Vec<&'static str> {
    results.verdict.unstated.iter().map(|part| part.key()).collect()
}

fn without(part: &str) -> Value {
    json!({ "tank": { part: null } })
}

#[test]
fn a_part_that_is_left_out_leaves_its_checks_open() {
    let bearing = || json!({ "site": { "ec8": { "bearing_capacity": "300 kPa" } } });
    let open = [bearing(), json!({ "accepted": [] })];
    let stated = results(open.to_vec());
    assert_eq!(unstated(&stated), ["pipes"]);
    for (part, state) in [("roof", "freeboard"), ("roof", "buckling_elastic_plastic"), ("foundation", "bearing")] {
        assert_eq!(status(&stated, state).0, CheckStatus::Holds, "{state}");
        let left_out = results([open.to_vec(), vec![without(part)]].concat());
        assert_eq!(unstated(&left_out), [part, "pipes"]);
        let expected = (CheckStatus::NotChecked, Some(format!("tank.{part}")));
        assert_eq!(status(&left_out, state), expected, "{part} {state}");
        assert_eq!(left_out.verdict.status, VerdictStatus::Incomplete);
    }
    // Of an anchored tank nothing turns on the plate; its anchors are missing.
    let bare = results(vec![without("bottom"), without("anchors")]);
    assert_eq!(unstated(&bare), ["bottom", "anchors", "pipes"]);
    let bare = results(vec![unanchored(), without("bottom")]);
    assert_eq!(unstated(&bare), ["bottom", "pipes"]);
    assert_eq!(status(&bare, "uplift").0, CheckStatus::Accepted);
    // A wall that fails fails without an answer.
    let fails = results(vec![without("roof"), wall(&[3.0; 4])]);
    assert_eq!(fails.verdict.status, VerdictStatus::Fails);
}

/// A tank without pipes has no limit state of them, in any code.
#[test]
fn none_is_an_answer() {
    let none = json!({ "tank": { "pipes": "none" }, "accepted": [] });
    let found = results(vec![none.clone()]);
    assert!(found.verdict.unstated.is_empty());
    assert_eq!(status(&found, "pipes").0, CheckStatus::NotApplicable);
    let home = tempfile::tempdir().expect("a temporary folder");
    let tank = Tank::new("none", "", Expected::NotAssessed, vec![only_api(), none]);
    let api = tank.results(home.path()).expect("the input is good");
    let method = api.methods.iter().find(|m| m.id == "api650-2020").expect("the code");
    let piping = method.checks.iter().find(|c| c.limit_state == "piping").expect("piping");
    assert_eq!(piping.status, CheckStatus::NotApplicable);
}

/// A tank stated anchored whose anchors or foundation are "none": what needs them says so, in each code and in a run, in place of "missing".
#[test]
fn a_part_that_the_file_denies_is_not_said_to_be_missing() {
    let home = tempfile::tempdir().expect("a temporary folder");
    let of = |part: &str| json!({ "tank": { part: "none" }, "accepted": [] });
    let alone = json!({ "procedures": { "decide": ["fe"] } });
    let strong = json!({ "site": { "ec8": { "ag": "0.4 g" }, "api650": { "ss": 1.2, "s1": 0.4, "bearing_capacity": "300 kPa" } } });
    for (part, method, states) in [
        ("anchors", "ec8-2006", &["anchorage", "anchor_count", "anchor_spacing"][..]),
        ("anchors", "api650-2020", &["anchor_tension", "anchor_attachment", "anchor_count", "anchor_spacing"]),
        ("anchors", "fe", &["anchorage", "anchor_count", "anchor_spacing"]),
        ("foundation", "api650-2020", &["shell_support", "bearing"]),
    ] {
        let mut changes = vec![of(part), strong.clone()];
        changes.extend((method == "fe").then(|| alone.clone()));
        let tank = Tank::new("denied", "", Expected::NotAssessed, changes).run(2.0);
        let results = tank.results(home.path()).expect("the input is good");
        let site =
            |m: &&Method| m.id == method && (method == "fe" || m.excitation == tank::assessment::Excitation::Site);
        let column = results.methods.iter().find(site).expect("the method");
        for state in states {
            let check = column.checks.iter().find(|c| c.limit_state == *state).expect(state);
            assert_eq!(check.status, CheckStatus::NotChecked, "{method} {state}");
            let said = format!("`tank.{part}` is \"none\", and `tank.support` is \"anchored\"");
            assert!(
                check.reason.contains(&said) && !check.reason.contains("missing"),
                "{method} {state}: {}",
                check.reason
            );
            assert_eq!(check.input.as_deref(), Some(format!("tank.{part}").as_str()), "{method} {state}");
        }
    }
    // A self-anchored shell on the ground has no concrete under it.
    let on_ground = vec![only_api(), unanchored(), of("foundation")];
    let tank = Tank::new("on-ground", "", Expected::NotAssessed, on_ground);
    let results = tank.results(home.path()).expect("the input is good");
    let api = results.methods.iter().find(|m| m.id == "api650-2020").expect("the code");
    let support = api.checks.iter().find(|c| c.limit_state == "shell_support").expect("a limit state");
    assert_eq!(support.status, CheckStatus::NotApplicable);
}

/// Another word, a number or a list is not an answer; the message says what is.
#[test]
fn other_words_are_refused() {
    let home = tempfile::tempdir().expect("a temporary folder");
    for (part, value) in [
        ("roof", json!("flat")),
        ("roof", json!("None")),
        ("foundation", json!(0)),
        ("bottom", json!([])),
        ("anchors", json!(false)),
        ("pipes", json!("")),
    ] {
        let mut change = json!({ "tank": {} });
        change["tank"][part] = value;
        let tank = Tank::new("word", "", Expected::NotAssessed, vec![change]);
        let error = tank.results(home.path()).expect_err("no answer");
        assert!(error.contains(&format!("tank.{part}")) && error.contains("\"none\" or an object"), "{error}");
    }
}

/// The summary says so on the terminal and in the report; a column of a table describes a part that the template says is not there.
#[test]
fn silence_is_named() {
    let home = tempfile::tempdir().expect("a temporary folder");
    let path = home.path().join("tank.json");
    let changes = vec![only_ec8(), without("roof"), without("foundation")];
    let tank = Tank::new("silent", "", Expected::NotAssessed, changes);
    std::fs::write(&path, tank.json()).expect("writable");
    let (tank, out) = (path.to_str().expect("text"), home.path().join("out"));
    let output = tankcheck(&["check", tank, "--out", out.to_str().expect("text")]);
    let text = String::from_utf8_lossy(&output.stdout).into_owned();
    assert_eq!(output.status.code(), Some(4));
    assert!(text.contains("No roof, no foundation, no pipes stated"), "{text}");
    let html = std::fs::read_to_string(out.join("report.html")).expect("a report");
    assert!(html.contains("No roof, no foundation, no pipes stated"));
    let answered = Tank::new("answered", "", Expected::NotAssessed, vec![only_ec8()]);
    std::fs::write(&path, answered.json()).expect("writable");
    let table = home.path().join("table.csv");
    std::fs::write(&table, "tank.roof.mass,tank.roof.snow,tank.pipes\n5 t,none,\n,,none\n").expect("writable");
    let output = tankcheck(&["check", tank, "--table", table.to_str().expect("text")]);
    assert_eq!(output.status.code(), Some(0), "{}", String::from_utf8_lossy(&output.stderr));
}
