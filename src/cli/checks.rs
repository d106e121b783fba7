//! Limit states on the terminal and as CSV, shared by `compare` and `check`.

use std::fmt::Write;

use tank::assessment::CheckStatus;
use tank::units;

use crate::cli::table::Table;
use report::words::{self, terminal};
use results::{Method, Results};

/// The limit states of the deciding methods, worst first.
pub(crate) fn tables(results: &Results) -> String {
    let decides = |m: &&Method| {
        let mut deciding = results.verdict.deciding.iter();
        deciding.any(|d| d.method == m.id && d.excitation == m.excitation)
    };
    let mut text = String::new();
    for method in results.methods.iter().filter(decides) {
        let corner = format!("{} ({})", method.id, terminal::excitation(method.excitation));
        let placed = method.checks.iter().any(|check| check.time_s.is_some());
        let head = [corner.as_str(), "demand", "capacity", "ratio", "result"];
        let mut table = Table::new(head.into_iter().chain(placed.then_some("where and when")));
        for check in &method.checks {
            let unit = units::column_unit(check.demand.into_iter().chain(check.capacity), check.dimension);
            let value = |value: Option<f64>| match value {
                Some(value) => units::significant(units::in_unit(value, unit), 3),
                None => "–".into(),
            };
            let name = match check.compared() && !unit.symbol.is_empty() {
                true => format!("{} [{}]", check.limit_state, unit.symbol),
                false => check.limit_state.clone(),
            };
            let cells = [
                name,
                value(check.demand),
                value(check.capacity),
                terminal::utilisation(check),
                words::verdict::result(check).to_owned(),
            ];
            let place = placed.then(|| words::verdict::place(check));
            table.row(cells.into_iter().chain(place));
        }
        let _ = writeln!(text, "{table}");
        let reasons = method.checks.iter().filter(|c| !c.reason.is_empty());
        for check in reasons.filter(|c| c.status != CheckStatus::NotApplicable) {
            let state = words::verdict::status(check.status);
            let _ = writeln!(text, "  {} {state}: {}", check.limit_state, check.reason);
        }
        text.push('\n');
    }
    text
}

/// All limit states of all methods, a second table after the quantities.
pub(crate) fn csv(results: &Results) -> String {
    let mut text = String::new();
    text.push_str("\nmethod,excitation,limit_state,check,status,demand,capacity,unit,utilisation,clause,reason,time_s,z_m,theta_rad,error\n");
    let number = |value: Option<f64>| value.map_or(String::new(), |v| format!("{v:e}"));
    let quoted = |text: &str| format!("\"{}\"", text.replace('"', "\"\""));
    for method in &results.methods {
        for check in &method.checks {
            let _ = writeln!(
                text,
                "{},{},{},{},{},{},{},{},{},{},{},{},{},{},{}",
                method.id,
                terminal::excitation(method.excitation),
                check.limit_state,
                check.id,
                words::verdict::status(check.status),
                number(check.demand),
                number(check.capacity),
                check.unit,
                number(check.utilisation),
                quoted(&check.clause),
                quoted(&check.reason),
                number(check.time_s),
                number(check.z),
                number(check.theta),
                number(check.error)
            );
        }
    }
    text
}
