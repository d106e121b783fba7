//! ACI 350.3, IS 1893-2 and national data on the command line: who asks for them, who decides, what is refused.

use serde_json::{Value, json};
use tankcheck::input::diagnostic::Source;
use tankcheck::input::tank::parse;
use tankcheck::job::Job;
use tankcheck::pipeline::procedures::{decide, select_procedures};

/// A basin of concrete with this site and these procedures.
fn tank(site: &Value, procedures: &Value) -> String {
    json!({
        "name": "basin",
        "tank": {
            "shape": "rectangle", "length": "18 m", "breadth": "9 m", "support": "anchored",
            "courses": [{ "height": "5 m", "thickness": "40 cm", "material": "concrete" }],
            "roof": "none", "foundation": "none", "pipes": "none"
        },
        "liquid": { "density": "1000 kg/m3", "fill_height": "4 m" },
        "materials": {
            "concrete": { "family": "concrete", "youngs_modulus": "25 GPa", "poisson_ratio": 0.2, "density": "2400 kg/m3" }
        },
        "site": site,
        "procedures": procedures
    })
    .to_string()
}

/// Ids of the methods, and the verdict.
fn decided(site: &Value, procedures: &Value) -> (Vec<String>, results::Verdict) {
    let text = tank(site, procedures);
    let source = Source::new("tank.json", &text);
    let file = parse(&source).unwrap_or_else(|faults| panic!("{}", faults.render(&source, false)));
    let selected = select_procedures(&file.procedures, &file.decision.decide, &file.case.site).expect("known");
    let (methods, verdict) = decide(&Job::of(file, selected)).expect("computed");
    (methods.into_iter().map(|method| method.id).collect(), verdict)
}

fn asce() -> Value {
    json!({ "ss": 1.0, "s1": 0.4, "site_class": "C", "sug": 2, "tl": 8 })
}

/// Site data of API 650 bring no ACI 350.3; it runs where it is named, and decides only where `decide` names it.
#[test]
fn aci_runs_where_it_is_named() {
    let site = json!({ "ec8": { "ground": "C", "spectrum": 1, "ag": "0.2 g" }, "api650": asce() });
    let (methods, verdict) = decided(&site, &json!({}));
    assert!(methods.iter().all(|id| id != "aci350-2006"), "{methods:?}");
    assert!(verdict.recalled.is_empty());
    let (methods, verdict) = decided(&site, &json!({ "run": ["ec8-2006", "api650-2020", "aci350-2006"] }));
    assert!(methods.iter().any(|id| id == "aci350-2006"), "{methods:?}");
    assert!(verdict.deciding.iter().all(|d| d.method != "aci350-2006") && verdict.recalled.is_empty());
    let (_, verdict) = decided(&site, &json!({ "decide": ["aci350-2006"] }));
    assert_eq!(verdict.recalled, ["aci350-2006"]);
    let headline = report::words::verdict::headline(&verdict);
    assert!(headline.starts_with("Incomplete: "), "{headline}");
    assert!(headline.ends_with("; on clauses recalled, not compared with the code: aci350-2006"), "{headline}");
}

/// IS 1893-2 runs with its site data and does not decide; with the user's R nothing of it is recalled.
#[test]
fn is_runs_with_its_site() {
    let of = |factor: Value| json!({ "is1893": { "zone": "IV", "soil": "medium", "response_reduction": factor } });
    let plain = json!({ "is1893": { "zone": "IV", "soil": "medium" } });
    let (methods, verdict) = decided(&plain, &json!({}));
    assert!(methods.iter().any(|id| id == "is1893-2014"), "{methods:?}");
    assert!(verdict.deciding.is_empty(), "{:?}", verdict.deciding);
    let (_, verdict) = decided(&plain, &json!({ "decide": ["is1893-2014"] }));
    assert_eq!(verdict.recalled, ["is1893-2014"]);
    let (_, verdict) = decided(&of(json!(2.0)), &json!({ "decide": ["is1893-2014"] }));
    assert!(verdict.recalled.is_empty());
    let (methods, _) = decided(&json!({ "ec8": { "ground": "C", "spectrum": 1, "ag": "0.2 g" } }), &json!({}));
    assert!(methods.iter().all(|id| id != "is1893-2014" && id != "national"), "{methods:?}");
}

/// National data run beside their spectrum.
#[test]
fn national_data_run_with_their_spectrum() {
    let site = json!({
        "spectrum": { "table": [[0, 0.3], [0.1, 0.75], [0.6, 0.75], [10, 0.05]], "unit": "g", "damping": "5 %" },
        "national": { "code": "a code", "impulsive_reduction": 2.0 }
    });
    let (methods, verdict) = decided(&site, &json!({ "decide": ["national"] }));
    assert!(methods.iter().any(|id| id == "national"), "{methods:?}");
    assert!(verdict.counts.compared() == 1 && verdict.recalled.is_empty(), "{:?}", verdict.counts);
}

/// What a wrong site is told: path, what was found, what is allowed.
#[test]
fn refusals() {
    for (site, expected) in [
        (
            json!({ "is1893": { "zone": "VI", "soil": "hard" } }),
            ["site.is1893.zone", "\"II\", \"III\", \"IV\" or \"V\""],
        ),
        (json!({ "is1893": { "zone": "II" } }), ["site.is1893", "soil"]),
        (
            json!({ "is1893": { "zone": "II", "soil": "hard", "response_reduction": 0.5 } }),
            ["site.is1893.response_reduction", "at least 1, at most 8"],
        ),
        (
            json!({ "national": { "code": "x", "impulsive_reduction": 2 } }),
            ["spectrum", "for the factors of site.national"],
        ),
        (
            json!({ "national": { "code": "x", "impulsive_reduction": 2, "sloshing_factor": 3 } }),
            ["site.national.sloshing_factor", "at least 1, at most 2"],
        ),
    ] {
        let text = tank(&site, &json!({}));
        let source = Source::new("tank.json", &text);
        let found = parse(&source).expect_err("a fault").render(&source, false);
        for part in expected {
            assert!(found.contains(part), "{part} is not in\n{found}");
        }
    }
}

/// Where nothing can run the reason of each procedure stands before the verdict.
#[test]
fn a_procedure_that_does_not_run_says_why() {
    let home = tempfile::tempdir().unwrap();
    let path = home.path().join("tank.json");
    let site = json!({ "is1893": { "zone": "IV", "soil": "medium" } });
    std::fs::write(&path, tank(&site, &json!({ "run": ["aci350-2006"], "decide": ["aci350-2006"] }))).unwrap();
    let output = crate::compare::tankcheck(&["check", path.to_str().unwrap()]);
    let text = String::from_utf8(output.stdout).unwrap();
    assert_eq!(output.status.code(), Some(4), "{text}");
    assert!(text.contains("aci350-2006: not applicable") && text.contains("`site.api650` is not given"), "{text}");
}

/// Site data of IS 1893-2 alone: its values are there, and the verdict says how it decides. A deciding procedure lists its recalled clauses. An id
/// without its edition is completed.
#[test]
fn what_the_terminal_says() {
    let home = tempfile::tempdir().unwrap();
    let path = home.path().join("tank.json");
    let site = json!({ "is1893": { "zone": "IV", "soil": "medium" } });
    let run = |procedures: &Value| {
        std::fs::write(&path, tank(&site, procedures)).unwrap();
        let output = crate::compare::tankcheck(&["check", path.to_str().unwrap()]);
        [output.stdout, output.stderr].map(|text| String::from_utf8(text).unwrap())
    };
    let [text, _] = run(&json!({}));
    let line = "no method decides: name one in `procedures.decide`; computed for the site: `is1893-2014`";
    assert!(text.contains(line) && !text.contains("no anchors"), "{text}");
    let [text, _] = run(&json!({ "decide": ["is1893-2014"] }));
    assert!(text.contains("recalled: is1893-2014 has these clauses from memory"), "{text}");
    assert!(text.contains("IS 1893-2:2014 table 2"), "{text}");
    let [text, _] = run(&json!({ "decide": ["aci350-2006"] }));
    assert!(text.contains("deciding: aci350-2006 (site)") && !text.contains("(record)"), "{text}");
    let [_, fault] = run(&json!({ "run": ["aci350"] }));
    assert!(fault.contains("did you mean \"aci350-2006\"?"), "{fault}");
}
