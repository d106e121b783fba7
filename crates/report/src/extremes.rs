//! Tables of extremes of both signs and at both sides.

use crate::number::{Scale, fixed, significant};
use crate::table::{Column, Table, columns};
use results::nonlinear::{At, TwoSided};

/// A table of one run, or of several with their scales; empty without extremes.
pub(crate) fn table<'a>(runs: impl Iterator<Item = (Option<f64>, &'a [TwoSided])>) -> Table {
    let runs: Vec<(Option<f64>, &[TwoSided])> = runs.filter(|(_, list)| !list.is_empty()).collect();
    if runs.is_empty() {
        return Table::default();
    }
    let scaled = runs.iter().any(|(scale, _)| scale.is_some());
    let mut columns = Vec::new();
    if scaled {
        columns.push(Column::numbers("Scale", ""));
    }
    columns.extend(columns![
        "Quantity", "Unit", "At rest" => "", "Smallest" => "", "Time of the smallest" => "s", "Largest" => "",
        "Time of the largest" => "s",
    ]);
    let mut table = Table::new(columns);
    for (factor, list) in runs {
        for found in list {
            let min = found.min.map(|m| m.value);
            let scale =
                Scale::of(found.dimension, [Some(found.rest), min, Some(found.max.value)].into_iter().flatten());
            let time = |at: Option<At>| at.and_then(|a| a.time).map_or("–".into(), |t| fixed(t, 3));
            let mut row: Vec<String> = Vec::new();
            if scaled {
                row.push(factor.map_or("–".into(), |f| significant(f, 4)));
            }
            row.extend([
                crate::words::capital(&found.title),
                scale.symbol().into(),
                scale.text(found.rest),
                min.map_or("–".into(), |v| scale.text(v)),
                time(found.min),
                scale.text(found.max.value),
                time(Some(found.max)),
            ]);
            table.row(row);
        }
    }
    table
}
