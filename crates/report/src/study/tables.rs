//! Tables of a study.

use tank::units::Dimension;

use crate::number::{Scale, count, fixed, percent, significant};
use crate::table::{Rows, Table, columns};
use crate::words::study as words;
use results::{Study, StudyCurve, StudyRule};

/// Most rows of faults.
const FAULTS: usize = 40;

/// Columns of the table of a study that have a column of their own.
const SHOWN: [&str; 3] = ["tank.radius", "tank.length", "liquid.fill_height"];
/// Most other columns of it that fit on a page of paper.
const GIVEN: usize = 6;

const NONE: &str = "–";

/// The dimension in plan.
fn size(study: &Study) -> &'static str {
    let round = |wanted: bool| study.tanks.iter().any(|tank| tank.round == wanted);
    match (round(true), round(false)) {
        (true, true) => "Radius or length",
        (false, true) => "Length",
        _ => "Radius",
    }
}

/// What curves are fitted to.
fn behind(study: &Study, curves: &[StudyCurve]) -> &'static str {
    match curves.iter().all(|curve| curve.method.ends_with("capacities")) {
        true if study.samples > 1 => "Records and samples",
        true => "Records",
        false => "Runs",
    }
}

/// A value; a dash without one.
fn dash<T>(value: Option<T>, text: impl FnOnce(T) -> String) -> String {
    value.map_or_else(|| NONE.to_owned(), text)
}

/// `0.41–0.52`; a dash without a band.
fn range(band: Option<[f64; 2]>, text: impl Fn(f64) -> String) -> String {
    dash(band, |[low, high]| words::range(&text(low), &text(high)))
}

/// The farm with the governing checks.
pub(super) fn tanks(study: &Study) -> Table {
    let length = Scale::of(Dimension::Length, study.tanks.iter().flat_map(|tank| tank.size).flatten());
    let mut rows = Rows::of(&study.tanks);
    rows.words("Tank", |tank| tank.id.clone());
    rows.words("Verdict", words::verdict);
    if study.samples > 1 {
        rows.words("Samples", words::samples);
    }
    rows.words("Governing check", |tank| dash(tank.governing.as_ref(), |(_, check, _)| words::id(check)));
    rows.words("Method", |tank| dash(tank.governing.as_ref(), |(method, ..)| method.clone()));
    rows.numbers("Utilised", "", |tank| dash(tank.governing.as_ref(), |(.., value)| words::utilised(*value)));
    rows.numbers(size(study), length.symbol(), |tank| dash(tank.size, |[plan, _]| length.given(plan)));
    rows.numbers("Fill height", length.symbol(), |tank| dash(tank.size, |[_, fill]| length.given(fill)));
    rows.numbers("Impulsive period", "s", |tank| dash(tank.periods[0], |t| significant(t, 3)));
    rows.numbers("Sloshing period", "s", |tank| dash(tank.periods[1], |t| significant(t, 3)));
    rows.numbers("Liquid", "m³", |tank| dash(tank.volume, |v| fixed(v, 0)));
    rows.table
}

/// Columns of the table of the study that have no column of their own.
fn columns_given(study: &Study) -> Vec<&str> {
    let mut paths: Vec<&str> = Vec::new();
    for (path, _) in study.tanks.iter().flat_map(|tank| &tank.given) {
        if !paths.contains(&path.as_str()) && !SHOWN.contains(&path.as_str()) {
            paths.push(path);
        }
    }
    paths
}

/// Columns of it that [`given`] has no room for.
pub(super) fn not_given(study: &Study) -> Vec<&str> {
    columns_given(study).into_iter().skip(GIVEN).collect()
}

/// What the table of the study gives of each tank, besides radius and fill height; empty where it gives nothing else.
pub(super) fn given(study: &Study) -> Table {
    let mut paths = columns_given(study);
    paths.truncate(GIVEN);
    if paths.is_empty() {
        return Table::default();
    }
    let mut rows = Rows::of(&study.tanks);
    rows.words("Tank", |tank| tank.id.clone());
    for path in paths {
        rows.words(path, |tank| {
            let found = tank.given.iter().find(|(column, _)| column == path);
            dash(found, |(_, text)| text.clone())
        });
    }
    rows.table
}

/// The damage states, a way into them a row.
pub(super) fn states(study: &Study) -> Table {
    let mut table = Table::new(columns![
        "State", "Demand", "In rows.csv", "Begins at" => "", "Runs" => "", "Source",
    ]);
    for state in &study.states {
        for limit in &state.limits {
            table.row(vec![
                state.name.clone(),
                words::id(&limit.demand),
                limit.demand.clone(),
                significant(limit.limit, 3),
                count(limit.runs),
                limit.source.clone(),
            ]);
        }
        if state.by_worse > 0 {
            let demand = "only a worse state, or no equilibrium".to_owned();
            table.row(vec![state.name.clone(), demand, NONE.into(), NONE.into(), count(state.by_worse), String::new()]);
        }
    }
    table
}

/// Curves: of the tanks, or of the farm.
pub(super) fn curves(study: &Study, curves: &[StudyCurve]) -> Table {
    let medians = curves.iter().flat_map(|c| c.fit.map(|fit| fit[0]));
    let scale = Scale::of(study.dimension, medians.chain(study.levels.iter().copied()));
    let unit = scale.symbol();
    let mut rows = Rows::of(curves);
    if curves.iter().any(|c| c.tank.is_some()) {
        rows.words("Tank", |c| c.tank.clone().unwrap_or_default());
    }
    rows.words("State", |c| c.state.clone());
    rows.numbers("Median θ", unit, |c| dash(c.fit, |[median, _]| scale.text(median)));
    rows.numbers("5–95 %", unit, |c| range(c.median_band, |v| scale.text(v)));
    rows.numbers("Dispersion β", "", |c| dash(c.fit, |[_, dispersion]| fixed(dispersion, 3)));
    rows.numbers("5–95 %", "", |c| range(c.dispersion_band, |v| fixed(v, 3)));
    rows.numbers(behind(study, curves), "", |c| count(c.n));
    if curves.iter().any(|c| c.common.is_some()) {
        let common = |[median, dispersion]: [f64; 2]| words::common(&scale.text(median), &fixed(dispersion, 3));
        rows.numbers("θ; common β", unit, |c| dash(c.common, common));
    }
    if study.hazard {
        rows.numbers("Rate", "1/a", |c| dash(c.rate, |[rate, _]| significant(rate, 2)));
        rows.numbers("beyond the hazard curve", "", |c| dash(c.rate, |[_, share]| percent(share)));
    }
    if curves.iter().any(|c| c.partial.is_some()) {
        let text = |median: Option<f64>| median.map(|median| scale.text(median));
        rows.numbers("θ with missing runs", unit, |c| {
            let [safe, reached] = c.partial.unwrap_or_default();
            dash(words::between(text(reached), text(safe)), |range| range)
        });
    }
    rows.words("Remark", |c| words::curves::remark(c, &|v| scale.text(v), unit));
    rows.table
}

/// Losses of contents, a level a row.
pub(super) fn losses(study: &Study) -> Table {
    let scale = Scale::of(study.dimension, study.losses.iter().map(|l| l.im));
    let bounded = study.losses.iter().any(|loss| loss.bounds.is_some());
    let volume = |v: f64| fixed(v, 0);
    let first = |values: &[Option<f64>]| dash(values.first().copied().flatten(), percent);
    let mut rows = Rows::of(&study.losses);
    rows.numbers(&study.im, scale.symbol(), |loss| scale.text(loss.im));
    rows.numbers("Earthquakes", "", |loss| count(loss.earthquakes));
    if bounded {
        rows.numbers("with gaps", "", |loss| count(loss.not_judged));
    }
    rows.numbers("At least one tank", "", |loss| first(&loss.at_least));
    if bounded {
        rows.numbers("Bounds", "", |loss| range(loss.bounds, percent));
    }
    rows.numbers("if independent", "", |loss| first(&loss.independent));
    rows.numbers("Mean loss", "m³", |loss| dash(loss.volume[0], volume));
    if bounded {
        rows.numbers("Bounds", "m³", |loss| range(loss.volume_bounds, volume));
    }
    // With gaps it is the largest one that is known.
    rows.numbers("Largest loss", "m³", |loss| match loss.bounds {
        Some(_) => dash(words::between(loss.volume[1].map(volume), None), |least| least),
        None => dash(loss.volume[1], volume),
    });
    rows.table
}

/// The rule at every period.
pub(super) fn rule(rule: &StudyRule) -> Table {
    let mut rows = Rows::of(&rule.rows);
    if rule.rows.iter().any(|row| !row.tank.is_empty()) {
        rows.words("Tank", |row| row.tank.clone());
    }
    rows.words("Period", |row| row.which.clone());
    rows.numbers("T", "s", |row| significant(row.period, 3));
    rows.numbers("Damping", "", |row| percent(row.damping));
    rows.numbers("Smallest mean/target", "", |row| fixed(row.smallest, 3));
    rows.numbers("Mean peak/target", "", |row| fixed(row.zero, 3));
    rows.numbers("Factor that just holds", "", |row| fixed(row.factor, 3));
    rows.words("Rule", |row| words::holds(row.holds).into());
    rows.table
}

/// The records.
pub(super) fn records(study: &Study) -> Table {
    let mut rows = Rows::of(&study.records);
    rows.words("Record", |record| record.id.clone());
    rows.numbers("Duration", "s", |record| fixed(record.duration[0], 1));
    rows.numbers("Step", "ms", |record| significant(1e3 * record.duration[1], 3));
    let peaks = [("PGA", Dimension::Acceleration), ("PGV", Dimension::Velocity), ("PGD", Dimension::Length)];
    for (i, (title, dimension)) in peaks.into_iter().enumerate() {
        let scale = Scale::of(dimension, study.records.iter().filter_map(|record| Some(record.peaks?[i])));
        rows.numbers(title, scale.symbol(), |record| dash(record.peaks, |peaks| scale.text(peaks[i])));
    }
    rows.numbers("Severity", "", |record| dash(record.severity, |s| fixed(s, 2)));
    rows.words("Rows in the worst state", |record| words::of(record.lost[0], record.lost[1]));
    rows.table
}

/// Why rows are not finished runs; the most frequent first.
pub(super) fn faults(study: &Study) -> Table {
    let mut table = Table::new(columns!["Status", "Rows" => "", "First of them", "Message"]);
    let mut faults: Vec<_> = study.faults.iter().collect();
    faults.sort_by_key(|fault| std::cmp::Reverse(fault.rows));
    for fault in faults.iter().take(FAULTS) {
        table.row(vec![fault.status.clone(), count(fault.rows), fault.first.join(", "), fault.message.clone()]);
    }
    table
}

/// What was not checked and why, a demand a row.
pub(super) fn gaps(study: &Study) -> Table {
    let mut table = Table::new(columns!["Tanks", "Demand", "Rows" => "", "Why, in the first of them"]);
    for gap in study.gaps.iter().take(FAULTS) {
        table.row(vec![words::basis::tanks(study, gap), words::id(&gap.demand), count(gap.rows), gap.reason.clone()]);
    }
    table
}

/// Tasks and rows.
pub(super) fn cost(study: &Study) -> Table {
    let mut table = Table::new(columns!["Work", "Number" => ""]);
    for (what, value) in words::basis::cost(study) {
        table.row(vec![what, value]);
    }
    table
}
