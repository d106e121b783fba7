//! "Not implemented" of `docs/theory/eurocode8.md` and `docs/theory/api650.md`: the limit states that the procedures declare and leave
//! open, by construction.
//!
//! `TANKCHECK_BLESS="reason"` writes both sections.

use std::collections::BTreeMap;
use std::fmt::Write;
use std::path::Path;

use tank::assessment::Requirement;

use super::*;

/// Procedures and their pages.
const PAGES: [(&str, &str); 2] = [("ec8-2006", "docs/theory/eurocode8.md"), ("api650-2020", "docs/theory/api650.md")];
const BEGIN: &str =
    "<!-- generated from the declared limit states: TANKCHECK_BLESS=\"reason\" cargo test --test cli verdict::open -->";
const END: &str = "<!-- end of the generated part -->";
const HEADING: &str = "## Not implemented";

/// Tanks in which something is open, with what opens it.
fn kinds() -> Vec<(&'static str, Vec<Value>)> {
    let tank = |value: Value| json!({ "tank": value });
    let steel_box = || vec![concrete_box(), wall(&[150.0; 2]), unanchored()];
    let other = |family: &str| json!({ "materials": { "steel": { "family": family } } });
    let bare = json!({
        "tank": { "internals": null, "adjacent_structures": null, "roof": { "mass": "30 t" }, "support": "unanchored", "anchors": null },
        "materials": { "steel": { "youngs_modulus": "200 GPa", "density": "7800 kg/m3" } },
        "site": {
            "ec8": { "ground": "D" },
            "api650": { "asce7": 2016, "site_class": "D", "s1": 0.25, "ss": 0.5 }
        }
    });
    let soft = json!({ "kind": "soil", "shear_wave_velocity": "80 m/s" });
    vec![
        ("an anchored tank of steel", vec![]),
        ("a self-anchored tank of steel", vec![unanchored()]),
        ("a wall of concrete", vec![concrete()]),
        ("a wall of polymer", vec![other("polymer")]),
        ("a wall of another metal", vec![other("other_metal")]),
        ("a wall of another material", vec![other("other")]),
        ("an unanchored box of metal", steel_box()),
        ("a vacuum", vec![tank(json!({ "pressure": { "vacuum": "0.1 kPa" } }))]),
        ("equipment within the liquid", vec![tank(json!({ "internals": "present" }))]),
        (
            "columns under the roof",
            vec![tank(json!({ "roof": { "mass": "30 t", "shell_share": 0.5, "snow": "none" } }))],
        ),
        ("connected structures", vec![tank(json!({ "adjacent_structures": "present" }))]),
        ("shear waves below 100 m/s", vec![tank(json!({ "foundation": soft }))]),
        ("a tank file without an answer", vec![bare]),
    ]
}

/// The generated part of a page.
fn section(id: &str, home: &Path) -> String {
    let procedure = codes::ALL.iter().find(|p| p.id() == id).expect("a procedure");
    let mut open: BTreeMap<&str, (String, String, Vec<&str>)> = BTreeMap::new();
    let mut asked: BTreeMap<&str, (String, String)> = BTreeMap::new();
    for (title, changes) in kinds() {
        let tank = Tank::new(title, "", Expected::NotAssessed, changes);
        let path = home.join("tank.json");
        std::fs::write(&path, tank.json()).expect("writable");
        let case = read_tank(&path).unwrap_or_else(|error| panic!("{title}: {error}")).case;
        for state in procedure.limit_states(&case) {
            match state.requirement {
                Requirement::NotImplemented => {
                    let row = open.entry(state.id).or_insert((state.name.into(), state.clause, Vec::new()));
                    row.2.push(title);
                }
                Requirement::Missing(input) => {
                    asked.insert(state.id, (state.name.into(), input));
                }
                Requirement::Required | Requirement::NotApplicable(_) => {}
            }
        }
    }
    let mut text =
        String::from("Open limit states: the verdict is `incomplete` unless the tank file accepts the gap.\n\n");
    text.push_str("| limit state | requirement | clause | open for |\n|---|---|---|---|\n");
    for (id, (name, clause, titles)) in open {
        let _ = writeln!(text, "| `{id}` | {name} | {clause} | {} |", titles.join(", "));
    }
    text.push_str("\nOpen until the tank file answers:\n\n| limit state | requirement | key |\n|---|---|---|\n");
    for (id, (name, input)) in asked {
        let _ = writeln!(text, "| `{id}` | {name} | `{input}` |");
    }
    text
}

/// What stands between the marks, and around them.
fn parts(page: &str) -> Option<(&str, &str, &str)> {
    let (before, rest) = page.split_once(BEGIN)?;
    let (inside, after) = rest.split_once(END)?;
    Some((before, inside, after))
}

#[test]
fn the_pages_name_what_is_open() {
    let home = tempfile::tempdir().expect("a temporary folder");
    for (id, page) in PAGES {
        let path = Path::new(env!("CARGO_MANIFEST_DIR")).join(page);
        let committed = std::fs::read_to_string(&path).expect("a page");
        let (before, inside, after) = parts(&committed).unwrap_or_else(|| panic!("{page}: no {BEGIN}"));
        let wanted = format!("\n{}", section(id, home.path()));
        if std::env::var_os("TANKCHECK_BLESS").is_some() {
            std::fs::write(&path, format!("{before}{BEGIN}{wanted}{END}{after}")).expect("writable");
            continue;
        }
        assert_eq!(inside, wanted, "{page}: TANKCHECK_BLESS=\"reason\" writes it");
        assert!(before.trim_end().ends_with(HEADING), "{page}: the part stands under {HEADING}");
    }
}

/// Nothing else on the pages is said not to be implemented, covered or checked: it would be a limit state.
#[test]
fn nothing_is_left_out_in_prose() {
    for (_, page) in PAGES {
        let path = Path::new(env!("CARGO_MANIFEST_DIR")).join(page);
        let committed = std::fs::read_to_string(&path).expect("a page");
        let (before, _, after) = parts(&committed).unwrap_or_else(|| panic!("{page}: no {BEGIN}"));
        for words in ["not implemented", "not covered", "not checked", "not examined", "is left out of the check"] {
            for text in [before, after] {
                let text = text.to_lowercase();
                let heading = HEADING.to_lowercase();
                let found = text.replace(&heading, "").find(words).map(|at| at.to_string());
                assert_eq!(found, None, "{page}: `{words}`");
            }
        }
    }
}
