//! Limits of validity of the linear theory and the values found.

use serde::Serialize;

use super::{Section, Source};
use crate::number::Scale;
use crate::words::capital;
use crate::words::sections::exceeded;
use files::error::Error;
use results::{Limit, Run};

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
pub(super) fn make(source: &Source) -> Result<Option<Section>, Error> {
    let results = source.results;
    let of = |(number, run): (usize, &Run)| -> Vec<(Limit, String)> {
        let name = match number {
            0 => String::new(),
            _ => format!(" ({})", run.engine.name()),
        };
        run.limits.iter().map(|limit| (limit.clone(), name.clone())).collect()
    };
    let runs = results.runs.iter().enumerate();
    let rows: Vec<Row> = runs
        .flat_map(of)
        .map(|(l, run)| {
            let scale = Scale::of(l.dimension, [l.value, l.limit]);
            Row {
                name: capital(&l.name) + &run,
                value: scale.text(l.value),
                limit: scale.text(l.limit),
                unit: scale.symbol(),
                holds: l.holds,
                note: l.note,
            }
        })
        .collect();
    if rows.is_empty() {
        return Ok(None);
    }
    let mut section = Section::new("limits");
    let broken = rows.iter().filter(|r| !r.holds).count();
    section.set("exceeded", &exceeded(broken));
    section.set("rows", &rows);
    Ok(Some(section))
}
