//! First page: verdict, every check that fails or is open, accepted gaps, key figures.

use files::code::{Code, Warning as Warned};
use serde::Serialize;
use tank::assessment::{Check, CheckStatus};
use tank::units::Dimension;

use super::checks::{Row, row};
use super::{Section, Source};
use crate::frame::{self, Pair};
use crate::methods::look;
use crate::number::{fixed, with_unit};
use crate::words::{self, capital};
use files::error::Error;
use results::compare::unusable;
use results::{Aside, Deciding, Limit, Method, Overruled, Results, VerdictStatus};

#[derive(Serialize)]
struct Verdict {
    class: &'static str,
    sign: &'static str,
    headline: String,
    /// Parts of the tank of which nothing is said, at most one line.
    unstated: String,
    /// What no method verifies, at most one line.
    outside: &'static str,
    /// Methods that decide.
    deciding: String,
    /// What can be done about open checks.
    supply: &'static str,
    /// Checks under the record that do not decide, at most one line.
    record: Vec<String>,
}

/// A check of a deciding method.
#[derive(Serialize)]
struct Judged {
    method: String,
    row: Row,
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
    let (title, judged) = judged(results);
    section.set("judged_title", title);
    section.set("judged", &judged);
    let created = &results.volatile.created;
    section.set("accepted_title", words::verdict::GAPS);
    section.set("accepted", &(results.verdict.accepted.iter()).map(|g| of(results, g, created)).collect::<Vec<_>>());
    section.set("facts", &facts(source));
    section.set("warnings", &warnings(results));
    let (input, unusual): (Vec<Warned>, Vec<Warned>) = unusual(results).into_iter().partition(words::verdict::of_input);
    section.set("input", &input);
    section.set("unusual", &unusual);
    section.set("project", &frame::document(results.project.as_ref()));
    section.set("signatures", &frame::signatures(results.project.as_ref()));
    section.set("standards", &standards(results));
    let sketch = if crowded(results) { None } else { Some(super::tank::sketch(&results.tank)) };
    section.set_figures("sketch", sketch.into_iter().collect());
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
    Verdict {
        class,
        sign,
        headline: words::verdict::headline(v),
        outside: words::verdict::outside(results),
        unstated: words::verdict::unstated(v),
        deciding: deciding(results),
        supply: match (v.missing.is_empty(), input) {
            (true, _) => "",
            (false, true) => words::verdict::SUPPLY,
            (false, false) => words::verdict::ACCEPT,
        },
        record: (v.overruled.iter().map(overruled))
            .chain(v.record.iter().map(|aside| record(aside, results.record_set.is_some())))
            .collect(),
    }
}

/// Rows of checks and warnings beside which the sketch stands on the first page.
const ROOM: usize = 9;

/// Whether the first page is full without the sketch, which then stands in the datasheet.
pub(super) fn crowded(results: &Results) -> bool {
    judged(results).1.len() + results.verdict.accepted.len() + warnings(results).len() + unusual(results).len() > ROOM
}

/// Title and rows of the checks that fail, the largest utilisation first, and of those that are open; where none fails, the governing one
/// comes first.
fn judged(results: &Results) -> (&'static str, Vec<Judged>) {
    let v = &results.verdict;
    let mut failing: Vec<(&Method, &Check)> = (results.methods.iter().filter(|m| v.decides(m)))
        .flat_map(|m| m.checks.iter().map(move |check| (m, check)))
        .filter(|(_, check)| check.status == CheckStatus::Fails)
        .collect();
    let ratio = |check: &Check| check.ratio().unwrap_or(f64::INFINITY);
    failing.sort_by(|a, b| ratio(b.1).total_cmp(&ratio(a.1)));
    let failing: Vec<Judged> = failing.iter().map(|(m, check)| judge(look(m).label, check, "")).collect();
    let fails = !failing.is_empty();
    let governing = v.governing.iter().filter(|_| !fails).map(|g| of(results, g, ""));
    let rows = failing.into_iter().chain(governing).chain(v.missing.iter().map(|g| of(results, g, ""))).collect();
    (words::verdict::judged(fails, !v.missing.is_empty()), rows)
}

/// A check with the method that it belongs to.
fn of(results: &Results, found: &results::Governing, created: &str) -> Judged {
    let method = results.methods.iter().find(|m| m.id == found.method && m.excitation == found.excitation);
    judge(method.map_or_else(|| found.method.clone(), |m| look(m).label), &found.check, created)
}

fn judge(method: String, check: &Check, created: &str) -> Judged {
    let mut row = row(check, created);
    // The reason why a check is open or accepted counts, not how it is computed.
    if !check.reason.is_empty() {
        let said = [words::verdict::approval(check, created), check.reason.clone()].map(|text| capital(&text));
        row.note = said.into_iter().filter(|text| !text.is_empty()).collect::<Vec<_>>().join(". ");
    }
    Judged { method, row }
}

/// The deciding methods by their titles.
fn deciding(results: &Results) -> String {
    let titled = |d: &Deciding| {
        let method = results.methods.iter().find(|m| m.id == d.method);
        let title = method.map_or(d.method.as_str(), |m| m.title.as_str());
        format!("{title} ({})", d.excitation.word())
    };
    match results.verdict.deciding.as_slice() {
        [] => words::verdict::deciding(results),
        some => some.iter().map(titled).collect::<Vec<_>>().join("; "),
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
