//! Test reports: JUnit XML, SARIF 2.1.0 and annotations of GitHub workflows.
//!
//! | outcome | JUnit | SARIF | GitHub |
//! |---|---|---|---|
//! | holds | passed, with its text | – | – |
//! | fails | `failure` | `error` | `::error` |
//! | not checked | `error` | `warning` | `::warning` |
//! | warns, accepted | passed, with its text | `note` | `::notice` |
//!
//! A verdict that holds with accepted gaps warns; with `--strict` it and its gaps are not checked.
//! A runner of tests counts `skipped` as green, and the exit code is 4 where something required was not checked: hence `error`.

use std::collections::BTreeMap;
use std::fmt::Write;

use serde_json::json;
use tank::assessment::{Check, CheckStatus};

use crate::error::Error;
use files::code::{Code, Warning};
use files::text::{self, workflow_property, workflow_value, xml};
use report::words;
use results::{Method, Results, VerdictStatus};

/// How a finding ends.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Outcome {
    Holds,
    Fails,
    NotChecked,
    Warns,
}

/// A check, or a change.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct Finding {
    /// Method and excitation.
    pub group: String,
    /// Id within it.
    pub id: String,
    /// How it ends.
    pub outcome: Outcome,
    /// In words.
    pub message: String,
}

/// The verdict, the checks of the deciding methods (of all methods where none decides), and the warnings. What is not required of the tank is left out.
///
/// * `strict`: whether an accepted gap is one that was not checked
pub(crate) fn of_checks(results: &Results, strict: bool) -> Vec<Finding> {
    let decides = |m: &&Method| results.verdict.decides(m);
    let any = results.methods.iter().any(|m| decides(&m) && !m.checks.is_empty());
    let methods = results.methods.iter().filter(|m| !any || decides(m));
    let of = |method: &Method| -> Vec<Finding> {
        let group = format!("{}/{}", method.id, method.excitation.word());
        let required = method.checks.iter().filter(|c| c.status != CheckStatus::NotApplicable);
        required.map(|check| of_check(&group, check, (strict, &results.volatile.created))).collect()
    };
    let dated = words::verdict::dated_ahead(results).into_iter();
    let dated: Vec<Warning> = dated.map(|text| Warning::new(Code::Inconsistent, text)).collect();
    std::iter::once(of_verdict(results, strict))
        .chain(methods.flat_map(of))
        .chain(results.warnings.iter().map(of_warning))
        .chain(dated.iter().map(of_warning))
        .collect()
}

/// The verdict: no report is green where something required was not checked, or nothing decides.
fn of_verdict(results: &Results, strict: bool) -> Finding {
    let verdict = &results.verdict;
    let outcome = match verdict.status {
        VerdictStatus::Fails => Outcome::Fails,
        VerdictStatus::Holds if verdict.complete() => Outcome::Holds,
        VerdictStatus::Holds if !verdict.unfinished && !strict => Outcome::Warns,
        _ => Outcome::NotChecked,
    };
    Finding { group: "verdict".into(), id: "verdict".into(), outcome, message: words::verdict::headline(verdict) }
}

fn of_check(group: &str, check: &Check, (strict, created): (bool, &str)) -> Finding {
    let outcome = match check.status {
        CheckStatus::Fails => Outcome::Fails,
        CheckStatus::NotChecked => Outcome::NotChecked,
        CheckStatus::Accepted if strict => Outcome::NotChecked,
        CheckStatus::Accepted => Outcome::Warns,
        CheckStatus::Holds | CheckStatus::NotApplicable => Outcome::Holds,
    };
    let mut message = format!("{} ({}): {}", check.name, check.clause, words::verdict::result(check));
    if let Some(utilisation) = check.utilisation {
        let _ = write!(message, ", utilisation {utilisation:.3}");
    }
    for part in [&words::verdict::approval(check, created), &check.reason, &check.note] {
        if !part.is_empty() {
            let _ = write!(message, "; {part}");
        }
    }
    Finding { group: group.into(), id: check.id.clone(), outcome, message }
}

/// Group of warnings, whose ids are their codes.
const WARNINGS: &str = "warnings";

fn of_warning(warning: &Warning) -> Finding {
    Finding {
        group: WARNINGS.into(),
        id: warning.code().map_or_else(|| "warning".into(), |code| code.id().into()),
        outcome: Outcome::Warns,
        message: warning.text().into(),
    }
}

/// The value of an attribute: a reader makes blanks of line feeds that are not references.
fn attribute(text: &str) -> String {
    xml(text).replace('\n', "&#10;").replace('\t', "&#9;")
}

/// JUnit XML: a suite a method.
pub(crate) fn junit(name: &str, findings: &[Finding]) -> String {
    let mut suites: BTreeMap<&str, Vec<&Finding>> = BTreeMap::new();
    for finding in findings {
        suites.entry(&finding.group).or_default().push(finding);
    }
    let count = |all: &[&Finding], outcome: Outcome| all.iter().filter(|f| f.outcome == outcome).count();
    let every: Vec<&Finding> = findings.iter().collect();
    let mut text = String::from("<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n");
    let _ = writeln!(
        text,
        "<testsuites name=\"{}\" tests=\"{}\" failures=\"{}\" errors=\"{}\">",
        attribute(name),
        every.len(),
        count(&every, Outcome::Fails),
        count(&every, Outcome::NotChecked)
    );
    for (group, all) in suites {
        let _ = writeln!(
            text,
            "  <testsuite name=\"{}\" tests=\"{}\" failures=\"{}\" errors=\"{}\" skipped=\"0\">",
            attribute(group),
            all.len(),
            count(&all, Outcome::Fails),
            count(&all, Outcome::NotChecked)
        );
        for finding in all {
            let (id, message) = (attribute(&finding.id), attribute(&finding.message));
            let _ = write!(text, "    <testcase classname=\"{}\" name=\"{id}\"", attribute(group));
            let _ = match finding.outcome {
                Outcome::Fails => writeln!(text, "><failure message=\"{message}\"/></testcase>"),
                Outcome::NotChecked => {
                    writeln!(text, "><error message=\"{message}\" type=\"not checked\"/></testcase>")
                }
                Outcome::Holds | Outcome::Warns => writeln!(text, "><system-out>{message}</system-out></testcase>"),
            };
        }
        text.push_str("  </testsuite>\n");
    }
    text.push_str("</testsuites>\n");
    text
}

/// SARIF 2.1.0: a rule a check, a result a finding that does not hold.
///
/// * `place`: the file that they are about
///
/// Errors: none in practice; JSON that cannot be written.
pub(crate) fn sarif(place: &str, findings: &[Finding]) -> Result<String, Error> {
    let told = || findings.iter().filter(|f| f.outcome != Outcome::Holds);
    // A warning is its code, which `tankcheck explain` knows.
    let rule_of = |f: &Finding| match f.group.as_str() {
        WARNINGS => f.id.clone(),
        group => format!("{group}/{}", f.id),
    };
    let rule = |id: &String| match Code::find(id) {
        Some(code) => json!({
            "id": id,
            "shortDescription": { "text": code.title() },
            "fullDescription": { "text": code.explanation() },
            "help": { "text": format!("tankcheck explain {id}") },
        }),
        None => json!({ "id": id }),
    };
    let mut rules: Vec<String> = Vec::new();
    for finding in told() {
        let rule = rule_of(finding);
        if !rules.contains(&rule) {
            rules.push(rule);
        }
    }
    let result = |finding: &Finding| {
        let level = match finding.outcome {
            Outcome::Fails => "error",
            Outcome::NotChecked => "warning",
            Outcome::Warns | Outcome::Holds => "note",
        };
        json!({
            "ruleId": rule_of(finding),
            "ruleIndex": rules.iter().position(|r| *r == rule_of(finding)),
            "level": level,
            "message": { "text": finding.message },
            "locations": [{ "physicalLocation": {
                "artifactLocation": { "uri": uri(place) }, "region": { "startLine": 1 } } }],
        })
    };
    let results: Vec<_> = told().map(result).collect();
    let document = json!({
        "$schema": "https://json.schemastore.org/sarif-2.1.0.json",
        "version": "2.1.0",
        "runs": [{
            "tool": { "driver": {
                "name": "tankcheck",
                "version": env!("CARGO_PKG_VERSION"),
                "rules": rules.iter().map(rule).collect::<Vec<_>>(),
            } },
            "results": results,
        }],
    });
    serde_json::to_string_pretty(&document)
        .map(|text| format!("{}\n", text::json(&text)))
        .map_err(|e| Error::report(e.to_string()))
}

/// A path as a relative URI (RFC 3986).
fn uri(path: &str) -> String {
    let mut out = String::new();
    for byte in path.replace('\\', "/").bytes() {
        match byte {
            b'a'..=b'z' | b'A'..=b'Z' | b'0'..=b'9' | b'-' | b'.' | b'_' | b'~' | b'/' => out.push(char::from(byte)),
            other => {
                let _ = write!(out, "%{other:02X}");
            }
        }
    }
    out
}

/// Annotations of GitHub workflows, a line each: no text of the user begins one.
pub(crate) fn github(place: &str, findings: &[Finding]) -> String {
    let mut text = String::new();
    for finding in findings {
        let word = match finding.outcome {
            Outcome::Holds => continue,
            Outcome::Fails => "error",
            Outcome::NotChecked => "warning",
            Outcome::Warns => "notice",
        };
        let title = workflow_property(&format!("{} {}", finding.group, finding.id));
        let _ = writeln!(
            text,
            "::{word} file={},title={title}::{}",
            workflow_property(place),
            workflow_value(&finding.message)
        );
    }
    text
}

#[cfg(test)]
mod tests {
    use super::*;

    fn findings() -> Vec<Finding> {
        let finding = |id: &str, outcome, message: &str| Finding {
            group: "ec8/site".into(),
            id: id.into(),
            outcome,
            message: message.into(),
        };
        vec![
            finding("freeboard", Outcome::Holds, "0.5"),
            finding("buckling", Outcome::Fails, "σ < \"R\" & 110 %\nline"),
            finding("sliding", Outcome::NotChecked, "no friction"),
        ]
    }

    #[test]
    fn junit_is_xml_with_the_right_counts() {
        let text = junit("a <b> & \u{1}", &findings());
        let document = roxmltree::Document::parse(&text).unwrap();
        let suite = document.descendants().find(|n| n.has_tag_name("testsuite")).unwrap();
        let counts = ["tests", "failures", "errors", "skipped"].map(|name| suite.attribute(name).unwrap());
        // What was not checked is as red as the exit code.
        assert_eq!(counts, ["3", "1", "1", "0"]);
        let error = document.descendants().find(|n| n.has_tag_name("error")).unwrap();
        assert_eq!(error.attribute("message"), Some("no friction"));
        let passed = document.descendants().find(|n| n.has_tag_name("system-out")).unwrap();
        assert_eq!(passed.text(), Some("0.5"));
        let failure = document.descendants().find(|n| n.has_tag_name("failure")).unwrap();
        assert_eq!(failure.attribute("message"), Some("σ < \"R\" & 110 %\nline"));
    }

    #[test]
    fn sarif_has_a_rule_for_every_result() {
        let text = sarif("my tank.json", &findings()).unwrap();
        let document: serde_json::Value = serde_json::from_str(&text).unwrap();
        let run = &document["runs"][0];
        let results = run["results"].as_array().unwrap();
        assert_eq!(results.len(), 2);
        for result in results {
            let rule = &run["tool"]["driver"]["rules"][result["ruleIndex"].as_u64().unwrap() as usize];
            assert_eq!(rule["id"], result["ruleId"]);
        }
        let place = &results[0]["locations"][0]["physicalLocation"]["artifactLocation"]["uri"];
        assert_eq!(place, "my%20tank.json");
    }

    #[test]
    fn annotations_stay_on_their_lines() {
        let text = github("a:b.json", &findings());
        assert_eq!(text.lines().count(), 2);
        assert!(
            text.starts_with("::error file=a%3Ab.json,title=ec8/site buckling::σ < \"R\" & 110 %25%0Aline\n"),
            "{text}"
        );
    }
}
