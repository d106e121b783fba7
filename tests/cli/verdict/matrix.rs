//! `docs/verification/limit-states.md`: what each procedure asks of which kind of tank, generated from `codes::ALL`.
//!
//! `TANKCHECK_BLESS="reason"` writes the page.

use std::fmt::Write;
use std::path::Path;

use codes::time_history;
use tank::assessment::{LimitState, Requirement};
use tank::case::Case;

use super::*;

const PAGE: &str = "docs/verification/limit-states.md";

const HEADER: &str = "\
# Limit states

What each code procedure asks of a tank, and what of it is checked. This page is generated from the lists that the procedures
declare (`limit_states` in `codes/src`).

| column | meaning |
|---|---|
| limit state | Id as in `results.json` and in `accepted` of the tank file. |
| clause | Clause and edition. Clauses are recalled, not copied; the pages in `docs/theory` say which were compared with the text. |
| steel anchored … | Kind of tank: cylinder of steel, anchored or unanchored; anchored cylinder of concrete; anchored rectangle. |
| battery | Tanks of the tests (`tests/cli/verdict/`) in which this limit state must come first. |

| entry | meaning |
|---|---|
| checked | Required and checked. It ends as *not checked* where its input is missing. |
| **open** | Required and not implemented. The verdict is `incomplete`, unless the tank file accepts the gap with a reason. |
| asked | Whether it is required follows from an input, without which it is *not checked*. |
| – | Not required of this kind of tank. |

How the verdict follows from this: [`docs/verdict.md`](../verdict.md).
";

/// The kinds of tank.
fn kinds(home: &Path) -> Vec<(&'static str, Case)> {
    let kind = |title: &'static str, changes: Vec<Value>| {
        let tank = Tank::new(title, "", Expected::NotAssessed, changes);
        let path = home.join("tank.json");
        std::fs::write(&path, tank.json()).expect("writable");
        (title, read_tank(&path).expect("a good tank").case)
    };
    vec![
        kind("steel anchored", vec![]),
        kind("steel unanchored", vec![unanchored()]),
        kind("concrete anchored", vec![concrete()]),
        kind("rectangle", vec![concrete_box()]),
    ]
}

/// Names of the tanks in which a limit state of a method comes first.
fn covered(method: &str, state: &str) -> String {
    let first = |tank: &&Tank| {
        !tank.holds() && matches!(tank.expected, Expected::Verdict(_, m, first) if m == method && first == state)
    };
    let names: Vec<String> = battery::tanks().iter().filter(first).map(|tank| format!("`{}`", tank.name)).collect();
    names.join(", ")
}

fn page() -> String {
    let home = tempfile::tempdir().expect("a temporary folder");
    let kinds = kinds(home.path());
    let mut page = String::from(HEADER);
    for procedure in codes::ALL {
        let lists: Vec<Vec<LimitState>> = kinds.iter().map(|(_, case)| procedure.limit_states(case)).collect();
        let _ = writeln!(page, "\n## {} (`{}`)\n", procedure.label().title, procedure.id());
        let Some(longest) = lists.iter().max_by_key(|list| list.len()).filter(|list| !list.is_empty()) else {
            page.push_str(
                "Declares no limit states: its comparisons stand beside those of the deciding codes. Where `procedures.decide` names \
                 it, the verdict is at best `incomplete`.\n",
            );
            continue;
        };
        table(&mut page, procedure.id(), &kinds, (longest, &lists));
    }
    let decides = ["fe".to_owned()];
    let of_runs = |case: &Case| time_history::limit_states(case, &time_history::counted(case, &decides));
    let lists: Vec<Vec<LimitState>> = kinds.iter().map(|(_, case)| of_runs(case)).collect();
    page.push_str("\n## Finite-element runs under the record (`fe`, `fe-solid`, `fe-nonlinear`), both codes\n\n");
    page.push_str(
        "Of a run that decides alone (`procedures.decide: [\"fe\"]`): it has every limit state that the codes ask for. Where a code decides \
         beside it, or the codes decide, those that only the codes have are theirs. `fe-nonlinear` of a rectangle gives wave and base shear \
         alone.\n\n",
    );
    let mut all: Vec<LimitState> = Vec::new();
    for state in lists.iter().flatten() {
        if !all.iter().any(|known| known.id == state.id) {
            all.push(state.clone());
        }
    }
    table(&mut page, "fe", &kinds, (&all, &lists));
    page
}

/// The table of one method: its longest list, and that of each kind of tank.
fn table(
    page: &mut String,
    method: &str,
    kinds: &[(&str, Case)],
    (longest, lists): (&[LimitState], &[Vec<LimitState>]),
) {
    page.push_str("| limit state | name | clause |");
    for (title, _) in kinds {
        let _ = write!(page, " {title} |");
    }
    page.push_str(" battery |\n|---|---|---|");
    page.push_str(&"---|".repeat(kinds.len() + 1));
    page.push('\n');
    for state in longest {
        let _ = write!(page, "| `{}` | {} | {} |", state.id, state.name, state.clause);
        for list in lists {
            let entry = match list.iter().find(|s| s.id == state.id).map(|s| &s.requirement) {
                Some(Requirement::Required) => "checked",
                Some(Requirement::NotImplemented) => "**open**",
                Some(Requirement::Missing(_)) => "asked",
                Some(Requirement::NotApplicable(_)) => "–",
                None => "outside the scope",
            };
            let _ = write!(page, " {entry} |");
        }
        let _ = writeln!(page, " {} |", covered(method, state.id));
    }
}

#[test]
fn the_page_is_fresh() {
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join(PAGE);
    let page = page();
    if std::env::var_os("TANKCHECK_BLESS").is_some() {
        std::fs::write(&path, &page).expect("writable");
    }
    let committed = std::fs::read_to_string(&path).unwrap_or_default();
    assert!(
        committed == page,
        "{PAGE} is out of date; refresh it with\n\n    TANKCHECK_BLESS=\"reason\" cargo test --test cli verdict::matrix\n"
    );
}

/// A limit state of a procedure that decides by itself has a tank in which it comes first, but for hoop yielding: where it is reached,
/// the elastic-plastic collapse comes before it, and a missing yield strength opens it.
#[test]
fn each_limit_state_has_a_tank() {
    let home = tempfile::tempdir().expect("a temporary folder");
    let kinds = kinds(home.path());
    let mut bare = Vec::new();
    for (_, case) in &kinds {
        for procedure in codes::ALL.iter().filter(|p| p.decides(&case.site)) {
            for state in procedure.limit_states(case) {
                if covered(procedure.id(), state.id).is_empty() {
                    bare.push(format!("{}/{}", procedure.id(), state.id));
                }
            }
        }
    }
    assert!(bare.is_empty(), "{bare:?}");
}

/// Limit states of a code that a run answers under another id: strength of concrete walls, overturning, anchorage ratio, tension, attachment.
const ANSWERED_AS: [(&str, &str); 9] = [
    ("wall_tension_and_bending", "wall_strength"),
    ("wall_shear", "wall_strength"),
    ("crack_width", "wall_strength"),
    ("overturning", "uplift_tension"),
    ("upper_compression", "shell_compression"),
    ("anchorage_ratio", "uplift_tension"),
    ("anchor_tension", "anchorage"),
    ("bearing", "bearing_api"),
    ("pressure_hoop", "design_pressure"),
];

/// A run that decides alone has a check for every limit state that its code asks of the tank, and none of them is "not required" but where
/// nothing pulls, lifts or rises.
#[test]
fn a_run_that_decides_alone_answers_its_codes() {
    let home = tempfile::tempdir().expect("a temporary folder");
    let decides = json!({ "procedures": { "decide": ["fe"] } });
    let kinds = [
        ("steel anchored", vec![]),
        ("steel unanchored", vec![unanchored()]),
        ("concrete anchored", vec![concrete()]),
        ("broad box", vec![plates::broad()]),
        ("under pressure", vec![json!({ "site": { "api650": { "design_pressure": "1 kPa" } } })]),
    ];
    let spared = [
        ("anchorage", "does not pull"),
        ("anchor_attachment", "does not pull"),
        ("connections", "does not pull"),
        ("connections", "stays on the ground"),
        ("uplift_tension", "stays on the ground"),
        ("uplift", "stays on the ground"),
        ("annulus_width", "stays on the ground"),
        ("annular_weld", "thicker than 10 mm"),
        ("shell_support", "stands on the ground"),
        // E.7.6 is for self-anchored tanks.
        ("sliding", "E.7.6"),
    ];
    for (title, changes) in kinds {
        for (code, site) in [("ec8-2006", only_ec8()), ("api650-2020", only_api())] {
            let changes = [vec![decides.clone()], changes.clone(), vec![site, json!({ "accepted": [] })]].concat();
            let tank = Tank::new(title, "", Expected::NotAssessed, changes).run(0.1);
            let results = tank.results(home.path()).unwrap_or_else(|error| panic!("{title}: {error}"));
            let run = deciding(&results).find(|m| m.id == "fe").expect("the run decides");
            let path = home.path().join("tank.json");
            let case = read_tank(&path).expect("a good tank").case;
            let procedure = codes::ALL.iter().find(|p| p.id() == code).expect("a procedure");
            for state in procedure.limit_states(&case) {
                if matches!(state.requirement, Requirement::NotApplicable(_)) {
                    continue;
                }
                let renamed = ANSWERED_AS.iter().filter(|(id, _)| *id == state.id).map(|(_, id)| *id);
                let ids: Vec<&str> = renamed.chain([state.id]).collect();
                let checks = run.checks.iter().filter(|c| ids.contains(&c.limit_state.as_str()));
                let checks: Vec<_> = checks.collect();
                assert!(!checks.is_empty(), "{title}, {code}: {} has no check", state.id);
                for check in checks.iter().filter(|c| c.status == tank::assessment::CheckStatus::NotApplicable) {
                    let known = spared.iter().any(|(id, why)| *id == check.limit_state && check.reason.contains(why));
                    assert!(known, "{title}, {code}: {} is not asked: {}", check.id, check.reason);
                }
            }
        }
    }
}

/// Beside a code that decides, a run has no limit state that the code alone checks.
#[test]
fn a_run_beside_its_code_leaves_it_its_own() {
    let home = tempfile::tempdir().expect("a temporary folder");
    let (_, case) = kinds(home.path()).remove(0);
    let states = |decide: &[&str]| {
        let decide: Vec<String> = decide.iter().map(|id| (*id).to_owned()).collect();
        let list = time_history::limit_states(&case, &time_history::counted(&case, &decide));
        list.iter().map(|state| state.id).collect::<Vec<_>>()
    };
    for decide in [&[][..], &["ec8-2006", "fe"], &["api650-2020", "fe"]] {
        let found = states(decide);
        for id in ["anchor_count", "anchor_spacing", "shear_transfer", "snow"] {
            assert!(!found.contains(&id), "{decide:?}: {id}");
            assert!(states(&["fe"]).contains(&id), "{id}");
        }
    }
}
