//! Limit states on the terminal and as CSV, shared by `compare` and `check`.

use std::fmt::Write;

use tank::assessment::{Check, CheckStatus};
use tank::units;

use crate::cli::style;
use crate::cli::table::{Mark, Table};
use crate::cli::terminal::width;
use files::text;
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
        let corner = format!("{} ({})", method.id, method.excitation.word());
        let placed = method.checks.iter().any(|check| check.time_s.is_some());
        let head = [corner.as_str(), "demand", "capacity", "ratio", "result"];
        let mut table = Table::new(head.into_iter().chain(placed.then_some("where and when")));
        let required = |check: &&Check| check.status != CheckStatus::NotApplicable;
        for check in method.checks.iter().filter(required) {
            let unit = units::column_unit(check.demand.into_iter().chain(check.capacity), check.dimension);
            let value = |value: Option<f64>| match value {
                Some(value) => units::significant(units::in_unit(value, unit), 3),
                None => "–".into(),
            };
            let name = match check.demand.is_some() && !unit.symbol.is_empty() {
                true => format!("{} [{}]", check.id, unit.symbol),
                false => check.id.clone(),
            };
            let cells = [
                name,
                value(check.demand),
                value(check.capacity),
                terminal::utilisation(check),
                words::verdict::result(check).to_owned(),
            ];
            let place = placed.then(|| words::verdict::place(check));
            let mark = match check.status {
                CheckStatus::Fails => Mark::Fails,
                CheckStatus::NotChecked | CheckStatus::Accepted => Mark::Open,
                _ => Mark::None,
            };
            table.marked(mark, cells.into_iter().chain(place));
        }
        let table = if placed { table.with_words() } else { table };
        let _ = writeln!(text, "{}", table.fitted(width()));
        let not: Vec<&str> =
            method.checks.iter().filter(|check| !required(check)).map(|check| check.id.as_str()).collect();
        if !not.is_empty() {
            let _ = writeln!(text, "  not required of this tank: {}", not.join(", "));
        }
        for (states, reason, status) in gaps(&method.checks) {
            let state = words::verdict::status(status);
            let _ = writeln!(text, "  {} {state}: {}", states.join(", "), style::sentence(reason));
        }
        text.push('\n');
    }
    text
}

/// Limit states without a comparison, those with the same reason together.
fn gaps(checks: &[Check]) -> Vec<(Vec<&str>, &str, CheckStatus)> {
    let mut found: Vec<(Vec<&str>, &str, CheckStatus)> = Vec::new();
    // Accepted gaps stand before everything else.
    let without = [CheckStatus::NotApplicable, CheckStatus::Accepted];
    let told = |c: &&Check| !c.reason.is_empty() && !without.contains(&c.status);
    for check in checks.iter().filter(told) {
        let state = check.limit_state.as_str();
        match found.iter_mut().find(|(_, reason, status)| *reason == check.reason && *status == check.status) {
            Some((states, ..)) if states.contains(&state) => {}
            Some((states, ..)) => states.push(state),
            None => found.push((vec![state], &check.reason, check.status)),
        }
    }
    found
}

/// All limit states of all methods, a second table after the quantities.
pub(crate) fn csv(results: &Results) -> String {
    let mut text = String::new();
    text.push_str("\nmethod,excitation,limit_state,check,status,demand,capacity,unit,utilisation,clause,reason,accepted_by,accepted_on,time_s,z_m,theta_rad,error\n");
    let number = |value: Option<f64>| value.map_or(String::new(), |v| format!("{v:?}"));
    for method in &results.methods {
        for check in &method.checks {
            let largest = check.demand.into_iter().chain(check.capacity).fold(0.0_f64, |m, v| m.max(v.abs()));
            let unit = style::unit(results, largest, check.dimension);
            let converted = |value: Option<f64>| number(value.map(|v| style::in_csv(v, unit).0));
            let approval = check.accepted.as_ref();
            let symbol = if unit.factor() == 1.0 { check.unit.as_str() } else { unit.text };
            let _ = writeln!(
                text,
                "{},{},{},{},{},{},{},{},{},{},{},{},{},{},{},{},{}",
                method.id,
                method.excitation.word(),
                check.limit_state,
                check.id,
                words::verdict::status(check.status),
                converted(check.demand),
                converted(check.capacity),
                symbol,
                number(check.utilisation),
                text::cell(&check.clause),
                text::cell(&check.reason),
                approval.map_or("".into(), |a| text::cell(&a.by)),
                approval.map_or("", |a| a.date.as_str()),
                number(check.time_s),
                number(check.z),
                number(check.theta),
                number(check.error)
            );
        }
    }
    text
}
