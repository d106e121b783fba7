//! All checks of all methods with their utilisation.

use serde::Serialize;

use super::summary::bar_width;
use super::{Section, Source};
use crate::methods::excitation;
use crate::number::{Scale, percent};
use crate::words::capital;
use files::error::Error;

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
}

/// Makes the section.
pub(super) fn make(source: &Source) -> Result<Option<Section>, Error> {
    let groups: Vec<Group> = source
        .results
        .methods
        .iter()
        .filter(|m| !m.checks.is_empty())
        .map(|m| Group {
            title: m.title.clone(),
            excitation: excitation(m),
            rows: m
                .checks
                .iter()
                .map(|c| {
                    let scale = Scale::of(c.dimension, [c.demand, c.capacity]);
                    Row {
                        name: capital(&c.name),
                        clause: c.clause.clone(),
                        note: c.note.clone(),
                        demand: scale.text(c.demand),
                        capacity: scale.text(c.capacity),
                        unit: scale.symbol(),
                        utilisation: percent(c.utilisation),
                        width: bar_width(c.utilisation),
                        holds: c.holds,
                    }
                })
                .collect(),
        })
        .collect();
    if groups.is_empty() {
        return Ok(None);
    }
    let mut section = Section::new("checks");
    section.set("groups", &groups);
    Ok(Some(section))
}
