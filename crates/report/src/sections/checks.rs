//! All checks of all methods with their utilisation.

use serde::Serialize;

use super::{Section, Source};
use crate::level::Level;
use crate::methods::excitation;
use crate::number::{Scale, utilisation};
use crate::words::{self, capital};
use files::error::Error;
use results::{Aside, Governing, Method, Verdict};
use tank::assessment::{Check, CheckStatus};

#[derive(Serialize)]
struct Group {
    title: String,
    excitation: &'static str,
    rows: Vec<Row>,
    /// Limit states that do not apply and are not among the rows, a sentence.
    absent: String,
}

/// A method that does not decide.
#[derive(Serialize)]
struct Other {
    title: String,
    excitation: &'static str,
    counts: String,
    governing: String,
    utilisation: String,
}

fn other(method: &Method) -> Other {
    let worst = Aside::of(method);
    Other {
        title: method.title.clone(),
        excitation: excitation(method),
        counts: words::verdict::counted(&worst.counts),
        governing: worst.governing.as_ref().map_or(String::new(), |g| capital(&g.check.name)),
        utilisation: (worst.governing.as_ref().and_then(|g| g.check.ratio())).map_or(String::new(), utilisation),
    }
}

/// A check.
#[derive(Serialize)]
pub(super) struct Row {
    name: String,
    clause: String,
    /// What there is to say about it.
    pub(super) note: String,
    demand: String,
    capacity: String,
    unit: &'static str,
    utilisation: String,
    width: f64,
    holds: bool,
    compared: bool,
    class: &'static str,
    sign: &'static str,
    status: &'static str,
}

/// In the title of an edition that is no longer in force.
const SUPERSEDED: &str = "superseded";

/// The row of a check.
pub(super) fn row(check: &Check, created: &str) -> Row {
    let values = [check.demand, check.capacity];
    let scale = Scale::of(check.dimension, values.into_iter().flatten());
    let text = |value: Option<f64>| value.map(|v| scale.text(v)).unwrap_or_default();
    let (class, sign) = if check.within_error { ("pending", "✓") } else { sign(check.status) };
    let place = words::verdict::place(check);
    let error = words::verdict::error(check);
    let approval = capital(&words::verdict::approval(check, created));
    let note = joined([approval, capital(&check.reason), capital(&check.note), place, capital(&error)]);
    Row {
        name: capital(&check.name),
        clause: check.clause.clone(),
        note,
        demand: text(check.demand),
        capacity: text(check.capacity),
        unit: check.demand.or(check.capacity).map_or("", |_| scale.symbol()),
        // That of an open check is for information.
        utilisation: check.ratio().or(check.utilisation).map(utilisation).unwrap_or_default(),
        width: check.ratio().map_or(0.0, bar_width),
        holds: check.holds(),
        compared: check.compared(),
        class,
        sign,
        status: words::verdict::result(check),
    }
}

/// Sentences as one text, without those that are empty.
fn joined<const N: usize>(sentences: [String; N]) -> String {
    sentences.into_iter().filter(|sentence| !sentence.is_empty()).collect::<Vec<_>>().join(". ")
}

/// The row of a check without what the cover says about it.
fn brief(check: &Check, verdict: &Verdict, created: &str) -> Row {
    let among = |gaps: &[Governing]| gaps.iter().any(|gap| gap.check == *check);
    let mut row = row(check, created);
    if check.status == CheckStatus::Fails || among(&verdict.missing) || among(&verdict.accepted) {
        // The cover has the reason where there is one, else all.
        row.note = match check.reason.as_str() {
            "" => String::new(),
            _ => joined([capital(&check.note), words::verdict::place(check), capital(&words::verdict::error(check))]),
        };
    }
    row
}

/// Length of a utilisation bar in percent of its track, on which 100 % utilisation lies at two thirds.
fn bar_width(utilisation: f64) -> f64 {
    if utilisation.is_finite() { (utilisation.max(0.0) * 200.0 / 3.0).min(100.0).round() } else { 100.0 }
}

/// Class of the colour and sign of a status.
fn sign(status: CheckStatus) -> (&'static str, &'static str) {
    match status {
        CheckStatus::Holds => ("yes", "✓"),
        CheckStatus::Fails => ("no-way", "✗"),
        CheckStatus::NotChecked => ("pending", "?"),
        CheckStatus::Accepted => ("pending", "!"),
        CheckStatus::NotApplicable => ("soft", "–"),
    }
}

/// Makes the section.
pub(super) fn make(source: &Source) -> Result<Option<Section>, Error> {
    let mut methods: Vec<_> = source.results.methods.iter().filter(|m| !m.checks.is_empty()).collect();
    // Editions in force come first.
    methods.sort_by_key(|m| m.title.contains(SUPERSEDED));
    // Below the full level: what decides, and one line for each other method; without a deciding one all of them.
    let (verdict, created) = (&source.results.verdict, &source.results.volatile.created);
    let decides = |m: &Method| verdict.decides(m);
    let all = source.level == Level::Full || !methods.iter().any(|m| decides(m));
    let applies = |c: &&Check| all || c.status != CheckStatus::NotApplicable;
    let groups: Vec<Group> = (methods.iter())
        .filter(|m| all || decides(m))
        .map(|m| Group {
            title: m.title.clone(),
            excitation: excitation(m),
            rows: (m.checks.iter().filter(applies))
                .map(|check| if all { row(check, created) } else { brief(check, verdict, created) })
                .collect(),
            absent: words::verdict::without(m.checks.iter().filter(|c| !applies(c))),
        })
        .collect();
    if groups.is_empty() {
        return Ok(None);
    }
    let others: Vec<Other> = (methods.iter().filter(|m| !all && !decides(m))).map(|m| other(m)).collect();
    let mut section = Section::new("checks");
    section.set("groups", &groups);
    section.set("brief", &!all);
    section.set("others", &others);
    Ok(Some(section))
}
