//! Limits of validity of the linear theory: what was tested and what was found.

use serde::Serialize;

use super::{Section, Source};
use crate::number::Scale;
use crate::words::capital;
use files::error::Error;

#[derive(Serialize)]
struct Row {
    name: String,
    value: String,
    limit: String,
    unit: &'static str,
    holds: bool,
    note: String,
}

/// Makes the section.
pub fn make(source: &Source) -> Result<Option<Section>, Error> {
    let results = source.results;
    let limits = results.fe.iter().flat_map(|fe| &fe.limits).map(|l| (l, ""));
    let spatial = results.fe_solid.iter().flat_map(|fe| &fe.limits);
    let nonlinear = results.fe_nonlinear.iter().flat_map(|fe| &fe.limits);
    let rows: Vec<Row> = limits
        .chain(spatial.map(|l| (l, " (three-dimensional)")))
        .chain(nonlinear.map(|l| (l, " (nonlinear)")))
        .map(|(l, run)| {
            let scale = Scale::of(l.dimension, [l.value, l.limit]);
            Row {
                name: capital(&l.name) + run,
                value: scale.text(l.value),
                limit: scale.text(l.limit),
                unit: scale.symbol(),
                holds: l.holds,
                note: l.note.clone(),
            }
        })
        .collect();
    if rows.is_empty() {
        return Ok(None);
    }
    let mut section = Section::new("limits");
    section.set("broken", &rows.iter().filter(|r| !r.holds).count());
    section.set("rows", &rows);
    Ok(Some(section))
}
