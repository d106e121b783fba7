//! What `compare` prints of its results: tables of quantities, CSV, the verdict.

use std::collections::BTreeMap;
use std::fmt::Write;

use files::code::Code;
use report::methods::{divided, divides, dividing};
use report::words::{self, terminal};
use results::nonlinear::End;
use results::{Channel, ComparisonRow, EngineId, Limit, Method, Results, Run, SeriesInfo};
use tank::assessment::{Check, CheckStatus, Excitation};
use tank::outside::Outside;
use tank::units;

use crate::cli::table::Table;
use crate::cli::terminal as stream;
use crate::cli::{checks, style};

/// Quantity × method for one excitation, values with their ratio to the engine.
pub(super) fn table(results: &Results, excitation: Excitation) -> String {
    let shown = |m: &Method| m.excitation == excitation && !m.quantities.is_empty();
    let columns: Vec<usize> = results.methods.iter().enumerate().filter(|(_, m)| shown(m)).map(|(i, _)| i).collect();
    let outside = results.methods.iter().filter(|m| m.excitation == excitation).filter_map(terminal::not_applicable);
    if columns.is_empty() {
        let lines: Vec<String> = outside.map(|line| line + "\n").collect();
        return if lines.is_empty() { String::new() } else { lines.concat() + "\n" };
    }
    let fe_here = columns.iter().any(|&i| results.methods[i].id == results::FE);
    let head = std::iter::once(terminal::corner(excitation, results.reference().is_some(), fe_here))
        .chain(columns.iter().map(|&i| results.methods[i].id.as_str()));
    let later_peaks = Later::of(results).filter(|_| excitation == Excitation::Record);
    let mut table = Table::new(head);
    for row in &results.comparison.rows {
        let values: Vec<f64> = columns.iter().filter_map(|&i| row.cells[i].map(|c| c.value)).collect();
        if values.is_empty() {
            continue;
        }
        let unit = units::column_unit(values, row.dimension);
        let cells = columns.iter().map(|&i| match row.cells[i] {
            None => "–".to_string(),
            Some(cell) => {
                let nonlinear = results.methods[i].id == EngineId::Nonlinear.beside();
                let later = |l: &Later| nonlinear && l.peaks.contains_key(&row.quantity);
                let mark = if later_peaks.as_ref().is_some_and(later) { "*" } else { "" };
                let value = units::significant(units::in_unit(cell.value, unit), 3);
                let ratio = cell.ratio.map_or(String::new(), |ratio| format!(" ({ratio:.2})"));
                let mark = match divides(row.dimension) && !divided(results, &results.methods[i]).is_empty() {
                    true => format!("{mark}†"),
                    false => mark.to_owned(),
                };
                let unusable = if cell.unusable { terminal::UNUSABLE } else { "" };
                let outside = if cell.outside { terminal::OUTSIDE } else { "" };
                format!("{value}{ratio}{mark}{unusable}{outside}")
            }
        });
        let title = format!("{} [{}]", row.title, unit.symbol);
        table.row(std::iter::once(title).chain(cells));
    }
    let mut text = format!("{}\n", table.fitted(stream::width()));
    marks(&mut text, results, excitation, &columns);
    let together = results.reference().and_then(|run| terminal::components(&run.directions));
    if let Some(line) = together.filter(|_| excitation == Excitation::Record && fe_here) {
        let _ = writeln!(text, "{line}");
    }
    for line in dividing(results, &columns) {
        let _ = writeln!(text, "{line}");
    }
    if let Some(later) = later_peaks {
        let _ = writeln!(text, "{}", terminal::later(&later.peaks, later.end, later.completed));
    }
    for line in outside {
        let _ = writeln!(text, "{line}");
    }
    // A blank line separates the table from what follows; the notes under a table end without one.
    if !text.ends_with("\n\n") {
        text.push('\n');
    }
    text
}

/// What the marks of the cells mean.
fn marks(text: &mut String, results: &Results, excitation: Excitation, columns: &[usize]) {
    let marked = |mark: fn(&results::Cell) -> bool| {
        let of = |row: &ComparisonRow| columns.iter().any(|&i| row.cells[i].as_ref().is_some_and(mark));
        results.comparison.rows.iter().any(of)
    };
    if marked(|c| c.unusable) {
        let _ = writeln!(text, "{}", terminal::unusable());
    }
    let open = |why: &Outside| {
        let of = |i: &usize| results.methods[*i].checks.iter();
        let is = |c: &Check| c.status == CheckStatus::NotChecked && c.limit_state == why.limit_state();
        columns.iter().flat_map(of).any(is)
    };
    // The column of the engine under the site's spectrum has no checks that give the reason.
    let plates = results.tank.tank.bends_as_plates();
    let alone = |why: &Outside| excitation == Excitation::Site && plates == (*why == Outside::Plates);
    for why in Outside::ALL.into_iter().filter(|why| marked(|c| c.outside) && (open(why) || alone(why))) {
        let _ = writeln!(text, "{}", terminal::outside(why));
    }
}

/// Peaks of the linear run after the end of the nonlinear one.
struct Later {
    /// End of the nonlinear run [s].
    end: f64,
    /// Whether that is the end of the record.
    completed: bool,
    /// Quantity → time of the linear peak [s].
    peaks: BTreeMap<String, f64>,
}

impl Later {
    /// `None` without a nonlinear run, or where no linear peak is later.
    fn of(results: &Results) -> Option<Later> {
        let (linear, nonlinear) = (results.reference()?, results.beside(EngineId::Nonlinear)?);
        let run = nonlinear.nonlinear.as_ref()?;
        let end = *run.energies.time.last()?;
        let mut peaks = BTreeMap::new();
        for row in &results.comparison.rows {
            let own = |s: &&SeriesInfo| Channel::compared(&s.id).is_some_and(|q| q.id() == row.quantity);
            let histories = linear.histories.iter().filter(own);
            if let Some(highest) = histories.max_by(|a, b| a.peak.abs().total_cmp(&b.peak.abs()))
                && highest.time > end
            {
                peaks.insert(row.quantity.clone(), highest.time);
            }
        }
        let completed = nonlinear.end == End::Completed;
        (!peaks.is_empty()).then_some(Later { end, completed, peaks })
    }
}

/// Quantities and checks, a value a line.
pub(super) fn csv(results: &Results) -> String {
    let mut text = String::from("method,excitation,quantity,value,unit,ratio_to_fe,usable\n");
    for row in &results.comparison.rows {
        for (method, cell) in results.methods.iter().zip(&row.cells) {
            let Some(cell) = cell else { continue };
            let excitation = method.excitation.word();
            let ratio = cell.ratio.map_or(String::new(), |r| format!("{r:.6}"));
            let usable = if cell.unusable || cell.outside { "no" } else { "yes" };
            let unit = style::unit(results, cell.value, row.dimension);
            let (value, unit) = style::in_csv(cell.value, unit);
            let _ = writeln!(text, "{},{excitation},{},{value:?},{unit},{ratio},{usable}", method.id, row.quantity);
        }
    }
    text.push_str(&checks::csv(results));
    text
}

/// Accepted gaps: who, when and why; empty without one.
pub(super) fn accepted(results: &Results) -> String {
    let gaps = &results.verdict.accepted;
    let mut text = String::new();
    if gaps.is_empty() {
        return text;
    }
    let _ = writeln!(text, "{} ({}):", words::verdict::GAPS, gaps.len());
    for gap in gaps {
        let check = &gap.check;
        let approval = words::verdict::approval(check, &results.volatile.created);
        let _ = writeln!(text, "  {} ({}), {approval}: {}", check.limit_state, gap.method, check.reason);
    }
    style::sentence(&text) + "\n"
}

/// Checks, verdict and exceeded limits.
pub(super) fn verdict(results: &Results) -> String {
    checks::tables(results) + &style::sentence(&sentences(results))
}

/// Verdict and exceeded limits.
fn sentences(results: &Results) -> String {
    let mut text = String::new();
    let verdict = &results.verdict;
    let _ = writeln!(text, "{}", words::verdict::headline(verdict));
    let unstated = words::verdict::unstated(verdict);
    if !unstated.is_empty() {
        let _ = writeln!(text, "  {unstated}");
    }
    let outside = words::verdict::outside(results);
    if !outside.is_empty() {
        let _ = writeln!(text, "  {outside}");
    }
    for warning in results.warnings.iter().filter(|w| words::verdict::of_input(w)) {
        let _ = writeln!(text, "  unusual: {}", warning.text());
    }
    let _ = writeln!(text, "  deciding: {}", words::verdict::deciding(results));
    for line in words::verdict::recalled(results) {
        let _ = writeln!(text, "  {line}");
    }
    for code in &verdict.overruled {
        let governing = code.checks.governing.as_ref().map(terminal::governing);
        let governing = governing.map(|g| format!("; governing: {g}")).unwrap_or_default();
        let _ = writeln!(text, "{}{governing}", words::verdict::overruled(code));
    }
    if let Some(governing) = &verdict.governing {
        let _ = writeln!(text, "  governing: {}", terminal::governing(governing));
    }
    if let Some(aside) = &verdict.record {
        let governing = aside.governing.as_ref().map(terminal::governing);
        let governing = governing.map(|g| format!("; governing: {g}")).unwrap_or_default();
        let _ = writeln!(text, "{}{governing}", words::verdict::record(aside, results.record_set.is_some()));
    }
    // A limit that several engines exceed is printed once.
    let mut told: Vec<&str> = Vec::new();
    for run in &results.runs {
        let exceeded: Vec<&Limit> = run.limits.iter().filter(|l| !l.holds).collect();
        for limit in exceeded.iter().filter(|l| !told.contains(&l.id.as_str())) {
            let _ = writeln!(text, "{}: {}", Code::LimitExceeded.head(), terminal::exceeded(limit));
        }
        told.extend(exceeded.iter().map(|l| l.id.as_str()));
    }
    if results.runs.iter().any(Run::parted) {
        let _ = writeln!(text, "{}: {}", Code::LiquidParted.head(), words::verdict::LIQUID_PARTED);
    }
    text
}
