//! All checks of all methods with their utilisation.

use serde::Serialize;

use super::summary::bar_width;
use super::{Section, Source};
use crate::methods::excitation;
use crate::number::{Scale, utilisation};
use crate::words::{self, capital};
use files::error::Error;
use tank::assessment::{Check, CheckStatus};

#[derive(Serialize)]
struct Group {
    title: String,
    excitation: &'static str,
    rows: Vec<Row>,
}

#[derive(Serialize)]
struct Row {
    name: String,
    clause: String,
    note: String,
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

fn row(check: &Check) -> Row {
    let values = [check.demand, check.capacity];
    let scale = Scale::of(check.dimension, values.into_iter().flatten());
    let text = |value: Option<f64>| value.map(|v| scale.text(v)).unwrap_or_default();
    let (class, sign) = match check.within_error {
        true => ("pending", "✓"),
        false => sign(check.status),
    };
    let place = words::verdict::place(check);
    let error = words::verdict::error(check);
    let remarks = [capital(&check.reason), capital(&check.note), place, capital(&error)];
    let remarks: Vec<String> = remarks.into_iter().filter(|r| !r.is_empty()).collect();
    Row {
        name: capital(&check.name),
        clause: check.clause.clone(),
        note: remarks.join(". "),
        demand: text(check.demand),
        capacity: text(check.capacity),
        unit: if check.compared() { scale.symbol() } else { "" },
        utilisation: check.ratio().map(utilisation).unwrap_or_default(),
        width: check.ratio().map_or(0.0, bar_width),
        holds: check.holds(),
        compared: check.compared(),
        class,
        sign,
        status: words::verdict::result(check),
    }
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
    let groups: Vec<Group> = (methods.into_iter())
        .map(|m| Group {
            title: m.title.clone(),
            excitation: excitation(m),
            rows: m.checks.iter().map(row).collect(),
        })
        .collect();
    if groups.is_empty() {
        return Ok(None);
    }
    let mut section = Section::new("checks");
    section.set("groups", &groups);
    Ok(Some(section))
}
