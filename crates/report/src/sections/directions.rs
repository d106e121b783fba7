//! Two horizontal components: extremes along x, along y, and of both together.

use serde::Serialize;

use super::{Section, Source};
use crate::number::{Scale, fixed, ratio};
use crate::table::{Table, columns};
use crate::words::capital;
use files::error::Error;
use results::{Directional, Run};

/// Extremes of a run.
#[derive(Serialize)]
struct Of {
    /// Name of the engine; empty for the first.
    name: String,
    table: Table,
}

/// Makes the section.
pub(super) fn make(source: &Source) -> Result<Option<Section>, Error> {
    let runs: Vec<Of> = (source.results.runs.iter().enumerate())
        .filter(|(_, run)| !run.directions.is_empty())
        .map(|(number, run)| Of { name: name(number, run), table: table(&run.directions) })
        .collect();
    if runs.is_empty() {
        return Ok(None);
    }
    let mut section = Section::new("directions");
    section.set("runs", &runs);
    Ok(Some(section))
}

fn name(number: usize, run: &Run) -> String {
    match number {
        0 => String::new(),
        _ => capital(run.engine.name()),
    }
}

fn table(all: &[Directional]) -> Table {
    let mut table = Table::new(columns![
        "Quantity", "Unit", "x" => "", "y" => "", "SRSS" => "", "Resultant" => "", "SRSS/resultant" => "",
        "Direction" => "°", "Time" => "s",
    ]);
    for one in all {
        let scale = Scale::of(one.dimension, [one.resultant]);
        let place = one.z.filter(|_| !one.id.contains("_z_"));
        table.row(vec![
            place.map_or_else(|| one.title.clone(), |z| format!("{}, z = {} m", one.title, fixed(z, 2))),
            scale.symbol().into(),
            scale.text(one.x),
            scale.text(one.y),
            scale.text(one.srss()),
            scale.text(one.resultant),
            if one.resultant > 0.0 { ratio(one.srss() / one.resultant) } else { "–".into() },
            fixed(one.theta.to_degrees(), 0),
            fixed(one.time, 3),
        ]);
    }
    table
}
