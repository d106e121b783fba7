//! Tables of a study.

use tank::units::Dimension;

use crate::number::{Scale, count, fixed, percent, significant};
use crate::table::{Column, Table};
use crate::words::study::{self as words, heads};
use results::{Study, StudyCurve, StudyRule};

/// Most rows of faults.
const FAULTS: usize = 40;

/// Columns of the table of a study that have a column of their own.
const SHOWN: [&str; 3] = ["tank.radius", "tank.length", "liquid.fill_height"];
/// Most other columns of it that fit on a page of paper.
const GIVEN: usize = 6;

const NONE: &str = "–";

/// The farm with the governing checks.
pub(super) fn tanks(study: &Study) -> Table {
    let volume = |v: Option<f64>| v.map_or_else(|| NONE.into(), |v| fixed(v, 0));
    let period = |p: Option<f64>| p.map_or_else(|| NONE.into(), |p| significant(p, 3));
    let sampled = study.samples > 1;
    let length = Scale::of(Dimension::Length, study.tanks.iter().flat_map(|tank| tank.size).flatten());
    let size = |size: Option<f64>| size.map_or_else(|| NONE.into(), |v| length.given(v));
    let mut columns = vec![Column::words(heads::TANK), Column::words(heads::VERDICT)];
    if sampled {
        columns.push(Column::words(heads::SAMPLES));
    }
    columns.extend([
        Column::words(heads::GOVERNING),
        Column::words(heads::METHOD),
        Column::numbers(heads::UTILISATION, ""),
        Column::numbers(heads::size(study), length.symbol()),
        Column::numbers(heads::FILL, length.symbol()),
        Column::numbers(heads::IMPULSIVE, "s"),
        Column::numbers(heads::SLOSHING, "s"),
        Column::numbers(heads::VOLUME, "m³"),
    ]);
    let mut table = Table::new(columns);
    for tank in &study.tanks {
        let mut row = vec![tank.id.clone(), words::verdict(tank)];
        if sampled {
            row.push(words::samples(tank));
        }
        match &tank.governing {
            Some((method, check, value)) => row.extend([words::id(check), method.clone(), words::utilised(*value)]),
            None => row.extend([NONE.into(), NONE.into(), NONE.into()]),
        }
        row.extend([size(tank.size.map(|s| s[0])), size(tank.size.map(|s| s[1]))]);
        row.extend([period(tank.periods[0]), period(tank.periods[1]), volume(tank.volume)]);
        table.row(row);
    }
    table
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
    let mut columns = vec![Column::words(heads::TANK)];
    columns.extend(paths.iter().map(|path| Column::words(path)));
    let mut table = Table::new(columns);
    if paths.is_empty() {
        return table;
    }
    for tank in &study.tanks {
        let cell = |path: &&str| {
            let found = tank.given.iter().find(|(column, _)| column == path);
            found.map_or_else(|| NONE.into(), |(_, text)| text.clone())
        };
        let mut row = vec![tank.id.clone()];
        row.extend(paths.iter().map(cell));
        table.row(row);
    }
    table
}

/// The damage states, a way into them a row.
pub(super) fn states(study: &Study) -> Table {
    let mut table = Table::new(vec![
        Column::words(heads::STATE),
        Column::words(heads::DEMAND),
        Column::words(heads::KEY),
        Column::numbers(heads::LIMIT, ""),
        Column::numbers(heads::WAYS, ""),
        Column::words(heads::SOURCE),
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
            let demand = words::BY_WORSE.to_owned();
            table.row(vec![state.name.clone(), demand, NONE.into(), NONE.into(), count(state.by_worse), String::new()]);
        }
    }
    table
}

/// Curves: of the tanks, or of the farm.
pub(super) fn curves(study: &Study, curves: &[StudyCurve]) -> Table {
    let of_tanks = curves.iter().any(|c| c.tank.is_some());
    let crossed = curves.iter().any(|c| c.common.is_some());
    let missing = curves.iter().any(|c| c.partial.is_some());
    let medians = curves.iter().flat_map(|c| c.fit.map(|fit| fit[0]));
    let scale = Scale::of(study.dimension, medians.chain(study.levels.iter().copied()));
    let unit = scale.symbol();
    let mut columns = Vec::new();
    if of_tanks {
        columns.push(Column::words(heads::TANK));
    }
    columns.extend([
        Column::words(heads::STATE),
        Column::numbers(heads::MEDIAN, unit),
        Column::numbers(heads::BAND, unit),
        Column::numbers(heads::DISPERSION, ""),
        Column::numbers(heads::BAND, ""),
        Column::numbers(heads::behind(study, curves), ""),
    ]);
    if crossed {
        columns.push(Column::numbers(heads::COMMON, unit));
    }
    if study.hazard {
        columns.push(Column::numbers(heads::RATE, "1/a"));
        columns.push(Column::numbers(heads::BEYOND, ""));
    }
    if missing {
        columns.push(Column::numbers(heads::PARTIAL, unit));
    }
    columns.push(Column::words(heads::REMARK));
    let mut table = Table::new(columns);
    for curve in curves {
        let range = |band: Option<[f64; 2]>, text: &dyn Fn(f64) -> String| {
            band.map_or_else(|| NONE.to_owned(), |[low, high]| words::range(&text(low), &text(high)))
        };
        let of = |value: Option<f64>, text: &dyn Fn(f64) -> String| value.map_or_else(|| NONE.to_owned(), text);
        let mut row = Vec::new();
        if of_tanks {
            row.push(curve.tank.clone().unwrap_or_default());
        }
        row.extend([
            curve.state.clone(),
            of(curve.fit.map(|f| f[0]), &|v| scale.text(v)),
            range(curve.median_band, &|v| scale.text(v)),
            of(curve.fit.map(|f| f[1]), &|v| fixed(v, 3)),
            range(curve.dispersion_band, &|v| fixed(v, 3)),
            count(curve.n),
        ]);
        if crossed {
            row.push(curve.common.map_or_else(
                || NONE.into(),
                |[median, dispersion]| words::common(&scale.text(median), &fixed(dispersion, 3)),
            ));
        }
        if study.hazard {
            row.push(of(curve.rate.map(|r| r[0]), &|v| significant(v, 2)));
            row.push(of(curve.rate.map(|r| r[1]), &percent));
        }
        if missing {
            let text = |curve: Option<f64>| curve.map(|median| scale.text(median));
            let [safe, reached] = curve.partial.unwrap_or_default();
            row.push(words::between(text(reached), text(safe)).unwrap_or_else(|| NONE.into()));
        }
        row.push(words::curves::remark(curve, &|v| scale.text(v), unit));
        table.row(row);
    }
    table
}

/// Losses of contents, a level a row.
pub(super) fn losses(study: &Study) -> Table {
    let scale = Scale::of(study.dimension, study.losses.iter().map(|l| l.im));
    let bounded = study.losses.iter().any(|loss| loss.bounds.is_some());
    let mut columns =
        vec![Column::numbers(&words::head(&study.im), scale.symbol()), Column::numbers(heads::EARTHQUAKES, "")];
    if bounded {
        columns.push(Column::numbers(heads::NOT_JUDGED, ""));
    }
    columns.push(Column::numbers(heads::ONE, ""));
    if bounded {
        columns.push(Column::numbers(heads::BOUNDS, ""));
    }
    columns.extend([Column::numbers(heads::INDEPENDENT, ""), Column::numbers(heads::MEAN_VOLUME, "m³")]);
    if bounded {
        columns.push(Column::numbers(heads::BOUNDS, "m³"));
    }
    columns.push(Column::numbers(heads::LARGEST_VOLUME, "m³"));
    let mut table = Table::new(columns);
    let volume = |v: f64| fixed(v, 0);
    for loss in &study.losses {
        let first = |values: &Vec<Option<f64>>| values.first().copied().flatten().map_or_else(|| NONE.into(), percent);
        let known = |v: Option<f64>| v.map_or_else(|| NONE.into(), &volume);
        let bounds = |bounds: Option<[f64; 2]>, text: &dyn Fn(f64) -> String| {
            bounded.then(|| bounds.map_or_else(|| NONE.into(), |[low, high]| words::range(&text(low), &text(high))))
        };
        let mut row = vec![scale.text(loss.im), count(loss.earthquakes)];
        row.extend(bounded.then(|| count(loss.not_judged)));
        row.push(first(&loss.at_least));
        row.extend(bounds(loss.bounds, &percent));
        row.extend([first(&loss.independent), known(loss.volume[0])]);
        row.extend(bounds(loss.volume_bounds, &volume));
        // With gaps it is the largest one that is known.
        row.push(match (bounded, loss.bounds) {
            (true, Some(_)) => words::between(loss.volume[1].map(&volume), None).unwrap_or_else(|| NONE.into()),
            _ => known(loss.volume[1]),
        });
        table.row(row);
    }
    table
}

/// The rule at every period.
pub(super) fn rule(rule: &StudyRule) -> Table {
    let named = rule.rows.iter().any(|row| !row.tank.is_empty());
    let mut columns = Vec::new();
    if named {
        columns.push(Column::words(heads::TANK));
    }
    columns.extend([
        Column::words(heads::PERIOD),
        Column::numbers("T", "s"),
        Column::numbers(heads::DAMPING, ""),
        Column::numbers(heads::SMALLEST, ""),
        Column::numbers(heads::ZERO, ""),
        Column::numbers(heads::FACTOR, ""),
        Column::words(heads::RULE),
    ]);
    let mut table = Table::new(columns);
    for row in &rule.rows {
        let mut cells = Vec::new();
        if named {
            cells.push(row.tank.clone());
        }
        cells.extend([
            row.which.clone(),
            significant(row.period, 3),
            percent(row.damping),
            fixed(row.smallest, 3),
            fixed(row.zero, 3),
            fixed(row.factor, 3),
            words::holds(row.holds).into(),
        ]);
        table.row(cells);
    }
    table
}

/// The records.
pub(super) fn records(study: &Study) -> Table {
    let peaks = |i: usize| study.records.iter().filter_map(move |r| r.peaks.map(|p| p[i]));
    let scales = [
        Scale::of(Dimension::Acceleration, peaks(0)),
        Scale::of(Dimension::Velocity, peaks(1)),
        Scale::of(Dimension::Length, peaks(2)),
    ];
    let mut table = Table::new(vec![
        Column::words(words::RECORD),
        Column::numbers(heads::DURATION, "s"),
        Column::numbers(heads::STEP, "ms"),
        Column::numbers("PGA", scales[0].symbol()),
        Column::numbers("PGV", scales[1].symbol()),
        Column::numbers("PGD", scales[2].symbol()),
        Column::numbers(heads::SEVERITY, ""),
        Column::words(heads::LOST),
    ]);
    for record in &study.records {
        let peak = |i: usize| record.peaks.map_or_else(|| NONE.into(), |p| scales[i].text(p[i]));
        table.row(vec![
            record.id.clone(),
            fixed(record.duration[0], 1),
            significant(1e3 * record.duration[1], 3),
            peak(0),
            peak(1),
            peak(2),
            record.severity.map_or_else(|| NONE.into(), |s| fixed(s, 2)),
            words::of(record.lost[0], record.lost[1]),
        ]);
    }
    table
}

/// Why rows are not finished runs; the most frequent first.
pub(super) fn faults(study: &Study) -> Table {
    let mut table = Table::new(vec![
        Column::words(heads::STATUS),
        Column::numbers(heads::ROWS, ""),
        Column::words(heads::FIRST),
        Column::words(heads::MESSAGE),
    ]);
    let mut faults: Vec<_> = study.faults.iter().collect();
    faults.sort_by_key(|fault| std::cmp::Reverse(fault.rows));
    for fault in faults.iter().take(FAULTS) {
        table.row(vec![fault.status.clone(), count(fault.rows), fault.first.join(", "), fault.message.clone()]);
    }
    table
}

/// What was not checked and why, a demand a row.
pub(super) fn gaps(study: &Study) -> Table {
    let mut table = Table::new(vec![
        Column::words(heads::TANKS),
        Column::words(heads::DEMAND),
        Column::numbers(heads::ROWS, ""),
        Column::words(heads::WHY),
    ]);
    for gap in study.gaps.iter().take(FAULTS) {
        table.row(vec![words::basis::tanks(study, gap), words::id(&gap.demand), count(gap.rows), gap.reason.clone()]);
    }
    table
}

/// Tasks and rows.
pub(super) fn cost(study: &Study) -> Table {
    let mut table = Table::new(vec![Column::words(heads::WHAT), Column::numbers(heads::COUNT, "")]);
    for (what, value) in words::basis::cost(study) {
        table.row(vec![what, value]);
    }
    table
}
