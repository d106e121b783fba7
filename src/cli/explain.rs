//! `tankcheck explain`: what a code of an error or warning, a quantity, a check or a procedure means.
//!
//! Every text is where its subject is declared: [`Code`] for faults, [`Quantity`] and the tables of limit states for checks
//! ([`codes::meaning`]). This file only finds and prints them.

use std::collections::BTreeSet;
use std::fmt::Write;

use clap::ValueEnum;
use codes::limit_state::Part;
use codes::{meaning, time_history};
use files::code::Code;
use serde::Serialize;
use tank::assessment::LimitState;
use tank::case::Case;
use tank::{Bearing, Isolators, Quantity};

use crate::cli::init;
use crate::cli::{Global, print};
use crate::error::{EXIT_OK, Error};
use files::text;

/// Arguments.
#[derive(clap::Args)]
#[command(after_help = "\
Examples:
  tankcheck explain T0206
  tankcheck explain buckling_elastic
  tankcheck explain overturning_moment --format json
  tankcheck explain                # lists all")]
pub(crate) struct Args {
    /// Code of an error or warning (T0206), or id of a quantity, check or procedure as in results.json [default: lists all].
    #[arg(value_name = "ID")]
    id: Option<String>,
    /// Form of the output.
    #[arg(long, value_enum, default_value_t = Form::Human)]
    format: Form,
}

/// Form of the output.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
enum Form {
    /// For reading.
    Human,
    /// One object; a list of all, and of a quantity and a check with the same id.
    Json,
    /// A page of all, as docs/codes.md.
    Markdown,
}

/// What is explained.
#[derive(Clone, Debug, Serialize)]
pub(crate) struct Entry {
    /// error, warning, quantity, check, procedure.
    kind: &'static str,
    /// Stable id.
    pub id: String,
    /// The id in a few words.
    title: String,
    /// Heading under which it is listed.
    #[serde(skip)]
    chapter: &'static str,
    /// Sentences.
    meaning: String,
    /// Further facts: name and value.
    #[serde(skip_serializing_if = "Vec::is_empty")]
    facts: Vec<Fact>,
    /// What leads to it, or what mends it.
    #[serde(skip_serializing_if = "String::is_empty")]
    example: String,
}

/// A fact of an entry.
#[derive(Clone, Debug, Serialize)]
struct Fact {
    name: &'static str,
    value: String,
}

const QUANTITIES: &str = "Quantities";
const CHECKS: &str = "Checks and limit states";
const PROCEDURES: &str = "Procedures";

/// Everything that is explained, in the order of the page.
pub(crate) fn entries() -> Vec<Entry> {
    let faults = Code::ALL.into_iter().map(of_code);
    let quantities = Quantity::ALL.into_iter().map(of_quantity);
    let declared = declared();
    let checks = meaning::all().into_iter().flat_map(|(state, parts)| {
        let own = |(_, other): &&(&str, LimitState)| other.id == state.id;
        let own: Vec<&(&str, LimitState)> = declared.iter().filter(own).collect();
        let checks = [state.check()].into_iter().chain(parts);
        checks.map(|check| of_check(&check, state.id, &own)).collect::<Vec<_>>()
    });
    let procedures = codes::ALL.iter().map(|procedure| {
        let label = procedure.label();
        Entry {
            kind: "procedure",
            id: procedure.id().into(),
            title: label.title.into(),
            chapter: PROCEDURES,
            meaning: format!(
                "A code procedure; `procedures` of the tank file and --procedures name it. Short in tables: {}.",
                label.short
            ),
            facts: (!procedure.data().is_empty())
                .then(|| Fact { name: "site data", value: procedure.data().into() })
                .into_iter()
                .collect(),
            example: format!("tankcheck check tank.json --procedures {}", procedure.id()),
        }
    });
    faults.chain(quantities).chain(checks).chain(procedures).collect()
}

fn of_code(code: Code) -> Entry {
    Entry {
        kind: code.severity().word(),
        id: code.id().into(),
        title: code.title().into(),
        chapter: code.chapter(),
        meaning: code.explanation().into(),
        facts: Vec::new(),
        example: code.example().into(),
    }
}

fn of_quantity(quantity: Quantity) -> Entry {
    let about = "The seismic part alone, largest absolute value over time and around the circumference.";
    let meaning = match quantity.is_response() {
        true => format!("{} {about}", quantity.meaning()),
        false => quantity.meaning().into(),
    };
    Entry {
        kind: "quantity",
        id: quantity.id().into(),
        title: quantity.title().into(),
        chapter: QUANTITIES,
        meaning,
        facts: vec![
            Fact { name: "symbol", value: quantity.symbol().into() },
            Fact { name: "unit", value: quantity.dimension().si_symbol().into() },
        ],
        example: String::new(),
    }
}

/// Limit states of all procedures and of the engines, each with who declares it.
fn declared() -> Vec<(&'static str, LimitState)> {
    let cases: Vec<Case> = init::cases();
    // No template stands on isolators.
    let isolated = cases.iter().map(|case| on_isolators(case.clone()));
    let cases: Vec<Case> = cases.iter().cloned().chain(isolated).collect();
    let mut all: Vec<(&'static str, LimitState)> = Vec::new();
    let mut add = |who: &'static str, states: Vec<LimitState>| {
        for state in states {
            let known =
                |(by, other): &(&str, LimitState)| *by == who && other.id == state.id && other.clause == state.clause;
            if !all.iter().any(known) {
                all.push((who, state));
            }
        }
    };
    for case in &cases {
        for procedure in codes::ALL {
            add(procedure.id(), procedure.limit_states(case));
        }
        add("engines", time_history::limit_states(case, &time_history::counted(case, &[])));
        // What a run has under a name of its own where it decides alone.
        let alone = time_history::counted(case, &[results::FE.to_owned()]);
        let known =
            |state: &LimitState| codes::ALL.iter().any(|p| p.limit_states(case).iter().any(|s| s.id == state.id));
        let mut alone = time_history::limit_states(case, &alone);
        alone.retain(|state| !known(state));
        add("engines", alone);
        let asked = time_history::ground_motion(case);
        add("engines", asked.map(|(state, _)| state).into_iter().collect());
    }
    all
}

fn on_isolators(mut case: Case) -> Case {
    case.tank.isolators = Some(Isolators {
        bearing: Bearing::Elastomer { stiffness: 1.0, damping: 0.0 },
        damper: None,
        slab_mass: 0.0,
        slab_thickness: 0.0,
        bounds: [1.0, 1.0],
        displacement_capacity: None,
    });
    case
}

fn of_check(check: &Part, state: &str, declared: &[&(&'static str, LimitState)]) -> Entry {
    let unit = match check.dimension.si_symbol() {
        "" => "–",
        unit => unit,
    };
    let mut facts = vec![
        Fact { name: "demand", value: check.demand.into() },
        Fact { name: "capacity", value: check.capacity.into() },
        Fact { name: "unit", value: unit.into() },
    ];
    if check.id != state {
        facts.push(Fact { name: "limit state", value: state.into() });
    }
    let clause =
        |(who, state): &&(&str, LimitState)| Fact { name: "clause", value: format!("{} ({who})", state.clause) };
    facts.extend(declared.iter().map(clause));
    Entry {
        kind: "check",
        id: check.id.into(),
        title: check.name.into(),
        chapter: CHECKS,
        meaning: "Demand over capacity is the utilisation; above 1 the check fails.".into(),
        facts,
        example: String::new(),
    }
}

/// Runs the subcommand; returns the exit code.
pub(crate) fn run(args: Args, _: &Global) -> Result<u8, Error> {
    let all = entries();
    let Some(id) = &args.id else {
        print(&match args.format {
            Form::Human => list(&all),
            Form::Json => json(&all)?,
            Form::Markdown => page(&all),
        })?;
        return Ok(EXIT_OK);
    };
    // A quantity and the check of it may have one id.
    let found: Vec<&Entry> = all.iter().filter(|e| e.id.eq_ignore_ascii_case(id.trim())).collect();
    if found.is_empty() {
        return Err(unknown(id, &all));
    }
    let each = |form: fn(&Entry) -> String| found.iter().map(|e| form(e)).collect::<Vec<_>>().join("\n");
    print(&match (args.format, &found[..]) {
        (Form::Human, _) => each(human),
        (Form::Json, [one]) => json(one)?,
        (Form::Json, _) => json(&found)?,
        (Form::Markdown, _) => each(markdown),
    })?;
    Ok(EXIT_OK)
}

fn json(value: &impl Serialize) -> Result<String, Error> {
    let text = serde_json::to_string_pretty(value).map_err(|e| Error::report(e.to_string()))?;
    Ok(format!("{text}\n"))
}

/// Most suggestions.
const SUGGESTIONS: usize = 4;

fn unknown(id: &str, all: &[Entry]) -> Error {
    let wanted = id.trim().to_lowercase().replace(['-', ' '], "_");
    // To the id, or to one of its words: "bukling" is in buckling_elastic.
    let apart = |word: &str| {
        let apart = strsim::damerau_levenshtein(&wanted, word);
        (apart * 3 <= word.chars().count()).then_some(apart)
    };
    let distance = |entry: &Entry| {
        let id = entry.id.to_lowercase();
        let holds = (wanted.len() > 2 && id.contains(&wanted)).then_some(0);
        let word = id.split('_').filter_map(apart).min().map(|apart| apart + 1);
        holds.into_iter().chain(apart(&id)).chain(word).min()
    };
    let mut near: Vec<(usize, &Entry)> =
        all.iter().filter_map(|entry| distance(entry).map(|distance| (distance, entry))).collect();
    near.sort_by_key(|(distance, _)| *distance);
    // A quantity and the check of it may have one id.
    let mut ids = BTreeSet::new();
    near.retain(|(_, entry)| ids.insert(entry.id.clone()));
    let near: Vec<String> =
        near.iter().take(SUGGESTIONS).map(|(_, entry)| format!("`{}` ({})", entry.id, entry.title)).collect();
    let help = match near.is_empty() {
        true => "`tankcheck explain` lists all".to_owned(),
        false => format!("did you mean {}?", near.join(", ")),
    };
    Error::input(
        Code::UnknownId,
        format!(
            "ID: found `{}`, expected a code such as T0206, or the id of a quantity, check or procedure\n  help: {help}",
            text::line(id)
        ),
    )
}

/// Widest line of text [characters].
const WIDTH: usize = 90;

/// The text in lines of at most [`WIDTH`], each after `indent`.
fn wrapped(out: &mut String, indent: &str, text: &str) {
    let mut line = String::new();
    for word in text.split_whitespace() {
        if !line.is_empty() && indent.chars().count() + line.chars().count() + 1 + word.chars().count() > WIDTH {
            let _ = writeln!(out, "{indent}{line}");
            line.clear();
        }
        if !line.is_empty() {
            line.push(' ');
        }
        line.push_str(word);
    }
    if !line.is_empty() {
        let _ = writeln!(out, "{indent}{line}");
    }
}

fn human(entry: &Entry) -> String {
    let mut out = match entry.kind {
        "error" | "warning" => format!("{}[{}]: {}\n\n", entry.kind, entry.id, entry.title),
        kind => format!("{kind} {}: {}\n\n", entry.id, entry.title),
    };
    let wide = entry.facts.iter().map(|fact| fact.name.len()).max().unwrap_or(0);
    for fact in &entry.facts {
        let mut lines = String::new();
        wrapped(&mut lines, &" ".repeat(wide + 4), &fact.value);
        let _ = writeln!(out, "  {:<wide$}  {}", fact.name, lines.trim());
    }
    if !entry.facts.is_empty() {
        out.push('\n');
    }
    wrapped(&mut out, "", &entry.meaning);
    if !entry.example.is_empty() {
        out.push('\n');
        for line in entry.example.lines() {
            let _ = writeln!(out, "    {line}");
        }
    }
    out
}

fn list(all: &[Entry]) -> String {
    let mut out = String::new();
    for part in all.chunk_by(|a, b| a.chapter == b.chapter) {
        let wide = part.iter().map(|entry| entry.id.len()).max().unwrap_or(0);
        let gap = if out.is_empty() { "" } else { "\n" };
        let _ = writeln!(out, "{gap}{}", part.first().map_or("", |entry| entry.chapter));
        for entry in part {
            let _ = writeln!(out, "  {:<wide$}  {}", entry.id, entry.title);
        }
    }
    out
}

const PAGE: &str = "\
# Codes, quantities and checks

Every error and warning has a code, which does not change; `tankcheck explain ID` prints what stands here. This page is generated
(`tankcheck explain --format markdown`).

Some rules are recalled from secondary sources and were not compared with the printed standard; `docs/theory/` marks each. Those that
decide limits or demands are EN 1998-4 2.3.3.1 (damping), 3.2 (one horizontal component), A.9 and A.10.3; API 650 5.12.3, E.1, E.4.3,
E.4.6.2, E.6.2.1.2, E.6.2.3 and table E.8; ASCE 7 chapters 16 and 21. Where a standard prints a limit in two units that differ by
rounding (13 mm (1/2 in.), 3 m (10 ft)), the less demanding value counts.
";

fn page(all: &[Entry]) -> String {
    let mut out = String::from(PAGE);
    let mut chapter = "";
    for entry in all {
        if entry.chapter != chapter {
            let _ = writeln!(out, "\n## {}", entry.chapter);
            chapter = entry.chapter;
        }
        let _ = write!(out, "\n{}", markdown(entry));
    }
    out
}

fn markdown(entry: &Entry) -> String {
    let mut out = format!("### `{}` {}\n\n{}\n", entry.id, entry.title, entry.meaning);
    if !entry.facts.is_empty() {
        out.push('\n');
    }
    for fact in &entry.facts {
        let _ = writeln!(out, "- {}: {}", fact.name, fact.value);
    }
    if !entry.example.is_empty() {
        let _ = write!(out, "\n```text\n{}\n```\n", entry.example);
    }
    out
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn ids_of_a_kind_are_unique_and_explained() {
        let all = entries();
        let ids: BTreeSet<_> = all.iter().map(|entry| (entry.kind, entry.id.to_lowercase())).collect();
        assert_eq!(ids.len(), all.len());
        for entry in &all {
            assert!(!entry.meaning.is_empty() && !entry.title.is_empty(), "{entry:?}");
        }
    }

    #[test]
    fn every_check_names_the_clauses_that_ask_for_it() {
        // Those of the superseded edition of API 650 declare no limit states.
        let undeclared = ["stability"];
        for entry in entries().iter().filter(|entry| entry.kind == "check") {
            let clauses = entry.facts.iter().filter(|fact| fact.name == "clause").count();
            assert!(clauses > 0 || undeclared.contains(&entry.id.as_str()), "{}", entry.id);
        }
    }

    #[test]
    fn unknown_ids_get_the_nearest_ones() {
        let all = entries();
        let help = |id: &str| unknown(id, &all).to_string();
        assert!(help("bukling_elastic").contains("`buckling_elastic`"), "{}", help("bukling_elastic"));
        assert!(help("bukling").contains("`buckling_elastic`"), "{}", help("bukling"));
        assert!(help("shear").contains("`base_shear`"));
        assert!(help("T0026").contains("T0206"));
        assert_eq!(help("hoop").matches("`hoop_stress`").count(), 1, "{}", help("hoop"));
        assert!(help("xyzzy").contains("lists all"));
    }

    #[test]
    fn lines_are_wrapped() {
        for entry in entries() {
            for line in human(&entry).lines().filter(|line| !line.starts_with("    ")) {
                assert!(line.chars().count() <= WIDTH.max(entry.title.len() + entry.id.len() + 16), "{line}");
            }
        }
    }
}
