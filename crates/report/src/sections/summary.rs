//! First page: verdict, governing check, key figures, the three headline quantities.

use files::code::{Code, Warning as Warned};
use serde::Serialize;
use tank::Quantity;
use tank::assessment::Excitation;
use tank::units::Dimension;

use super::{Section, Source};
use crate::figure::Figure;
use crate::figure::bars::{Bar, bars};
use crate::frame::{self, Pair};
use crate::methods::{divided, divides, dividing, excitation, figure_order, look};
use crate::number::{Scale, fixed, utilisation, with_unit};
use crate::words::{self, capital};
use files::error::Error;
use results::compare::unusable;
use results::{Aside, Deciding, FE, Limit, Overruled, Results, VerdictStatus};

/// Headline quantities: sloshing height, base moment, membrane stresses.
const HEADLINES: [Quantity; 4] =
    [Quantity::SloshingHeight, Quantity::BaseMoment, Quantity::HoopStress, Quantity::AxialMembraneStress];

#[derive(Serialize)]
struct Verdict {
    class: &'static str,
    sign: &'static str,
    headline: String,
    /// Accepted gaps, before everything else.
    accepted: Vec<Missing>,
    /// Parts of the tank of which nothing is said, at most one line.
    unstated: String,
    /// What no method verifies, at most one line.
    outside: &'static str,
    /// Methods that decide.
    deciding: String,
    missing: Vec<Missing>,
    supply: &'static str,
    /// Checks under the record that do not decide, at most one line.
    record: Vec<String>,
}

#[derive(Serialize)]
struct Missing {
    name: String,
    method: String,
    reason: String,
    /// Who accepts the gap, and when; empty where nobody does.
    approval: String,
}

#[derive(Serialize)]
struct Governing {
    name: String,
    method: String,
    clause: String,
    demand: String,
    capacity: String,
    unit: &'static str,
    utilisation: String,
    width: f64,
    holds: bool,
    note: String,
}

#[derive(Serialize)]
struct Warning {
    name: String,
    found: String,
    note: String,
}

/// Makes the section.
pub(super) fn make(source: &Source) -> Result<Option<Section>, Error> {
    let results = source.results;
    let mut section = Section::new("summary");
    section.set("name", &results.name);
    section.set("subtitle", words::summary::subtitle(source.fe().is_some()));
    section.set("verdict", &verdict(results));
    section.set("governing", &governing(results).into_iter().collect::<Vec<_>>());
    section.set("facts", &facts(source));
    section.set("warnings", &warnings(results));
    let (input, unusual): (Vec<Warned>, Vec<Warned>) = unusual(results).into_iter().partition(words::verdict::of_input);
    section.set("input", &input);
    section.set("unusual", &unusual);
    section.set("has_fe", &source.fe().is_some());
    let mut cells = results.comparison.rows.iter().flat_map(|row| row.cells.iter().flatten());
    section.set("outside", &cells.any(|cell| cell.outside));
    section.set("project", &frame::document(results.project.as_ref()));
    section.set("signatures", &frame::signatures(results.project.as_ref()));
    section.set("standards", &standards(results));
    section.set_figures("sketch", vec![super::tank::sketch(&source.results.tank)]);
    section.set_figures("site_figures", headline_figures(results, true));
    section.set_figures("figures", headline_figures(results, false));
    section.set("base", &base(results));
    Ok(Some(section))
}

fn verdict(results: &Results) -> Verdict {
    let v = &results.verdict;
    let (class, sign) = match v.status {
        _ if v.unfinished => ("fail", "✗"),
        VerdictStatus::Holds if !v.complete() || !v.overruled.is_empty() => ("open", "!"),
        VerdictStatus::Holds if v.counts.within_error > 0 => ("open", "✓"),
        VerdictStatus::Holds => ("ok", "✓"),
        VerdictStatus::Fails => ("fail", "✗"),
        VerdictStatus::Incomplete => ("open", "?"),
        VerdictStatus::NotAssessed => ("none", "–"),
    };
    let input = v.missing.iter().any(|gap| gap.check.input.is_some());
    let open = together(&v.missing);
    Verdict {
        class,
        sign,
        headline: words::verdict::headline(v),
        accepted: (v.accepted.iter().map(|gap| missing(gap, &results.volatile.created))).collect(),
        outside: words::verdict::outside(results),
        unstated: words::verdict::unstated(v),
        deciding: deciding(results),
        supply: match (open.is_empty(), input) {
            (true, _) => "",
            (false, true) => words::verdict::SUPPLY,
            (false, false) => words::verdict::ACCEPT,
        },
        missing: open,
        record: (v.overruled.iter().map(overruled))
            .chain(v.record.iter().map(|aside| record(aside, results.record_set.is_some())))
            .collect(),
    }
}

/// Gaps, those of a method with the same reason in one line.
fn together(gaps: &[results::Governing]) -> Vec<Missing> {
    let mut all: Vec<Missing> = Vec::new();
    for gap in gaps.iter().map(|gap| missing(gap, "")) {
        let same = |m: &&mut Missing| m.method == gap.method && m.reason == gap.reason;
        match all.iter_mut().find(same) {
            Some(same) => same.name = format!("{}, {}", same.name, gap.name),
            None => all.push(gap),
        }
    }
    all
}

/// The deciding methods by their titles.
fn deciding(results: &Results) -> String {
    let titled = |d: &Deciding| {
        let method = results.methods.iter().find(|m| m.id == d.method);
        let title = method.map_or(d.method.as_str(), |m| m.title.as_str());
        format!("{title} ({})", d.excitation.word())
    };
    match results.verdict.deciding.as_slice() {
        [] => words::verdict::deciding(&results.verdict),
        some => some.iter().map(titled).collect::<Vec<_>>().join("; "),
    }
}

fn missing(gap: &results::Governing, created: &str) -> Missing {
    Missing {
        name: capital(&gap.check.name),
        method: gap.method.clone(),
        reason: gap.check.reason.clone(),
        approval: words::verdict::approval(&gap.check, created),
    }
}

/// Checks under the record and the governing one.
fn record(aside: &Aside, set: bool) -> String {
    governed(words::verdict::record(aside, set), aside)
}

fn overruled(code: &Overruled) -> String {
    governed(words::verdict::overruled(code), &code.checks)
}

/// A sentence and the check that governs.
fn governed(sentence: String, aside: &Aside) -> String {
    match &aside.governing {
        Some(check) => format!("{sentence}; governing: {}", words::terminal::governing(check)),
        None => sentence,
    }
}

fn governing(results: &Results) -> Option<Governing> {
    let governing = results.verdict.governing.as_ref()?;
    let check = &governing.check;
    let (demand, capacity) = check.demand.zip(check.capacity)?;
    let ratio = check.ratio()?;
    let scale = Scale::of(check.dimension, [demand, capacity]);
    let method = results.methods.iter().find(|m| m.id == governing.method && m.excitation == governing.excitation);
    Some(Governing {
        name: capital(&check.name),
        method: method.map_or(governing.method.clone(), |m| format!("{}, {}", m.title, excitation(m))),
        clause: check.clause.clone(),
        demand: scale.text(demand),
        capacity: scale.text(capacity),
        unit: scale.symbol(),
        utilisation: utilisation(ratio),
        width: bar_width(ratio),
        holds: check.holds(),
        note: [check.note.clone(), words::verdict::place(check), words::verdict::within_error(check)]
            .into_iter()
            .filter(|part| !part.is_empty())
            .collect::<Vec<_>>()
            .join("; "),
    })
}

/// Length of a utilisation bar in percent of its track, on which 100 % utilisation lies at two thirds.
pub(super) fn bar_width(utilisation: f64) -> f64 {
    if utilisation.is_finite() { (utilisation.max(0.0) * 200.0 / 3.0).min(100.0).round() } else { 100.0 }
}

fn facts(source: &Source) -> Vec<Pair> {
    let summary = &source.results.tank;
    let mut facts = frame::tank(summary);
    let mut add = |label: &str, value: String| facts.push(Pair::new(label, value));
    if let Some(set) = &source.results.record_set {
        add("Records", words::summary::records(set));
    } else if let Some(record) = source.results.records.first() {
        add(words::summary::PEAK_GROUND_ACCELERATION, format!("{}\u{a0}g", fixed(record.pga / summary.gravity, 3)));
    }
    if let Some(t) = source.best("sloshing_period") {
        add(words::summary::FIRST_SLOSHING, with_unit(t, Dimension::Time));
    }
    if let Some(t) = source.best("impulsive_period") {
        add(words::summary::IMPULSIVE, with_unit(t, Dimension::Time));
    }
    facts
}

/// The base that is free to move, of the first engine under the record.
fn base(results: &Results) -> Vec<Pair> {
    let run = |m: &&results::Method| m.id == FE && m.excitation == Excitation::Record;
    let Some(method) = results.methods.iter().find(run) else { return Vec::new() };
    let of = |quantity: &Quantity| {
        let value = method.quantities.get(quantity.id())?;
        Some(Pair::new(quantity.title(), with_unit(value.value, value.dimension)))
    };
    Quantity::OF_BASE.iter().filter_map(of).collect()
}

fn warnings(results: &Results) -> Vec<Warning> {
    // A limit that several engines exceed is listed once.
    let broken = |run: &'_ results::Run| run.limits.clone().into_iter().filter(|l| !l.holds);
    let first: Vec<Limit> = results.reference().into_iter().flat_map(broken).collect();
    let others = results.runs.iter().skip(1).flat_map(broken);
    let others: Vec<Limit> = others.filter(|l| first.iter().all(|f| f.id != l.id)).collect();
    first
        .iter()
        .chain(&others)
        .map(|l| Warning { name: capital(&l.name), found: words::summary::exceeded(l), note: capital(&l.note) })
        .collect()
}

/// Warnings about the input and about values that are not to be used.
fn unusual(results: &Results) -> Vec<Warned> {
    let unusable = unusable(results);
    let unusable = unusable.iter().map(|found| Warned::new(Code::Unusable, words::verdict::unusable(found)));
    let beyond = words::record_set::beyond(results);
    let beyond = beyond.iter().map(|line| Warned::new(Code::UnusualRecord, capital(line) + "."));
    results.warnings.iter().cloned().chain(beyond).chain(unusable).collect()
}

/// Titles of the deciding procedures, with their editions.
fn standards(results: &Results) -> Vec<String> {
    let mut titles: Vec<String> = Vec::new();
    for method in results.methods.iter().filter(|m| results.verdict.decides(m)) {
        if !titles.contains(&method.title) {
            titles.push(method.title.clone());
        }
    }
    titles
}

/// Bars under the record, or under the spectrum of the site: design values and those of a record are not drawn side by side.
fn headline_figures(results: &Results, site: bool) -> Vec<Figure> {
    let order: Vec<usize> = figure_order(results)
        .into_iter()
        .filter(|&i| look(&results.methods[i]).site == site && results.methods[i].beyond_scope.is_none())
        .collect();
    let mut figures = Vec::new();
    let freeboard = results.tank.freeboard();
    let dividing = dividing(results, &order).join(" ");
    for quantity in HEADLINES {
        let Some(row) = results.comparison.rows.iter().find(|r| r.quantity == quantity.id()) else { continue };
        let values: Vec<Bar> = order
            .iter()
            .filter_map(|&i| {
                let cell = row.cells.get(i).copied().flatten()?;
                Some(Bar {
                    look: look(results.methods.get(i)?),
                    value: cell.value,
                    ratio: cell.ratio,
                    outside: cell.outside,
                    overtops: quantity == Quantity::SloshingHeight && cell.value > freeboard,
                    divided: divides(row.dimension) && !divided(results, results.methods.get(i)?).is_empty(),
                })
            })
            .collect();
        let by = if values.iter().any(|bar| bar.divided) { dividing.as_str() } else { "" };
        figures.extend(bars(
            &format!("bars_{}{}", row.quantity, if site { "_site" } else { "" }),
            (&row.title, by),
            row.dimension,
            &values,
            row.cells.iter().flatten().map(|c| c.value),
        ));
    }
    figures
}
