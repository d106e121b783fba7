//! The scatter of a set of records and its spectrum, on the terminal.

use std::fmt::Write;

use tank::units;

use crate::cli::table::Table;
use files::text;
use report::words::record_set as words;
use results::{Compatibility, FE, RecordSet, Results, SetQuantity};

/// Design values with their scatter, the check of the spectrum; empty of results of one record.
pub(super) fn of(results: &Results) -> String {
    let Some(set) = &results.record_set else { return String::new() };
    let mut said = String::new();
    let _ = writeln!(said, "{}", words::design(set));
    let _ = writeln!(said, "{}", scatter(set));
    match &set.compatibility {
        Some(found) => said.push_str(&spectrum(set, found)),
        None => {
            let _ = writeln!(said, "{}", words::no_target(set));
        }
    }
    said.push('\n');
    said
}

/// Quantities of the engine, or of all methods without one.
fn scatter(set: &RecordSet) -> Table {
    let engine = set.quantities.iter().any(|q| q.method == FE);
    let shown: Vec<&SetQuantity> = set.quantities.iter().filter(|q| !engine || q.method == FE).collect();
    let mut table = Table::new(["quantity", "method", "design", "mean", "CoV", "smallest", "largest", "under"]);
    for row in shown {
        let s = &row.scatter;
        let unit = units::column_unit([s.design, s.min, s.max], row.dimension);
        let number = |value: f64| units::significant(units::in_unit(value, unit), 3);
        table.row([
            format!("{} [{}]", row.title, unit.symbol),
            row.method.clone(),
            number(s.design),
            number(s.mean),
            s.cov.map_or("–".into(), |cov| format!("{:.0} %", 100.0 * cov)),
            number(s.min),
            number(s.max),
            text::line(&s.max_record).into_owned(),
        ]);
    }
    table
}

fn spectrum(set: &RecordSet, found: &Compatibility) -> String {
    let mut table = Table::new(["period", "T [s]", "damping", "smallest mean/target", "at [s]", ""]);
    for period in &found.periods {
        table.row([
            period.which.clone(),
            format!("{:.4}", period.period),
            format!("{:.1} %", 100.0 * period.damping),
            format!("{:.4}", period.smallest_ratio),
            format!("{:.4}", period.at_period),
            if period.holds { "holds" } else { "fails" }.to_owned(),
        ]);
    }
    let mut said = table.to_string();
    for line in words::compatibility(set, found) {
        let _ = write!(said, "\n{line}");
    }
    said.push('\n');
    said
}
