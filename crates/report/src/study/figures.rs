//! Figures of a study.

use tank::units::Dimension;

use crate::figure::chart::{Axis, Chart, Line, Mark};
use crate::figure::{Figure, HALF};
use crate::number::{Scale, fixed, percent, significant};
use crate::table::{Column, Table, columns, spread};
use crate::words::study as words;
use files::error::Error;
use results::{Study, StudyCurve, StudyTrace};

/// Height of the plots in user units.
const PLOT: f64 = 150.0;
/// Classes of the states, from mild to severe.
const STATES: [&str; 6] = ["k-s4", "k-s6", "k-s3", "k-s5", "k-s2", "k-s1"];
/// Numbers of tanks of which the probability of at least as many is drawn.
const AT_LEAST: [usize; 4] = [1, 2, 5, 10];
/// Demand over limit from which on its axis is logarithmic: on a linear one the limit is then in the lowest fifth.
const FLAT: f64 = 5.0;
/// Rows of a table of data.
const ROWS: usize = 24;

fn class(state: usize) -> &'static str {
    STATES[state % STATES.len()]
}

fn intensity(study: &Study, ims: impl IntoIterator<Item = f64>) -> Axis {
    Axis::linear(&study.im, study.dimension, ims.into_iter().chain([0.0]), 6)
}

fn share(title: &str) -> Axis {
    Axis::exact(title, Dimension::Dimensionless, (0.0, 1.0), 5)
}

/// The curves of each tank, all states in one figure; the tanks whose worst state comes first, in the order of the study.
///
/// Errors: a drawing that fails.
pub(super) fn tanks(study: &Study, most: usize) -> Result<Vec<Figure>, Error> {
    let Some(worst) = study.states.last() else { return Ok(Vec::new()) };
    let mut first: Vec<(f64, &str)> = study
        .curves
        .iter()
        .filter(|c| c.state == worst.name)
        .filter_map(|c| {
            let lowest = c.fit.map(|fit| fit[0]).or(c.bounds[0]);
            Some((lowest.unwrap_or(f64::INFINITY), c.tank.as_deref()?))
        })
        .collect();
    first.sort_by(|a, b| a.0.total_cmp(&b.0));
    first.truncate(most);
    let chosen = |id: &str| first.iter().any(|(_, tank)| *tank == id);
    let of = |(number, tank): (usize, &results::StudyTank)| {
        let curves: Vec<&StudyCurve> =
            study.curves.iter().filter(|c| c.tank.as_deref() == Some(tank.id.as_str())).collect();
        figure(study, number, &tank.id, &curves)
    };
    let shown = study.tanks.iter().enumerate().filter(|(_, tank)| chosen(&tank.id));
    shown.map(of).collect()
}

fn figure(study: &Study, number: usize, tank: &str, curves: &[&StudyCurve]) -> Result<Figure, Error> {
    let ims = curves.iter().flat_map(|c| c.points.iter().map(|p| p.0));
    let lines = curves.iter().flat_map(|c| c.line.last().map(|p| p.0));
    let mut chart = Chart::new(HALF, intensity(study, ims.chain(lines)), share(words::PROBABILITY));
    for (state, curve) in curves.iter().enumerate() {
        let class = class(state);
        if !curve.band.is_empty() {
            let low = curve.band.iter().map(|(im, low, _)| (*im, *low));
            let high = curve.band.iter().rev().map(|(im, _, high)| (*im, *high));
            chart.band(low.chain(high).collect(), class, "");
        }
        let mut points = curve.line.clone();
        // Without a curve the legend still names the state of the points.
        if !points.is_empty() {
            points.insert(0, (0.0, 0.0));
        }
        chart.line(points, class, &curve.state);
        for at in counted(curve) {
            chart.mark(at, "", format!("own {class}"));
        }
    }
    Ok(chart
        .with_plot_height(PLOT)
        .figure(format!("study_tank_{}", number + 1), tank, data(study, curves))?
        .captioned(words::curves::caption(curves))
        .described(words::curves::description(tank, curves)))
}

/// Intensity and share of the runs in the state.
fn counted(curve: &StudyCurve) -> impl Iterator<Item = (f64, f64)> {
    // Single runs are ones and zeros, too many to be read.
    let single = curve.points.iter().all(|p| p.1 <= 1.0);
    let points = curve.points.iter().filter(move |p| p.1 > 0.0 && !single);
    points.map(|(im, n, exceed, _)| (*im, exceed / n))
}

/// Counts at intensities, one column a state.
fn data(study: &Study, curves: &[&StudyCurve]) -> Table {
    let ims: Vec<f64> =
        curves.iter().max_by_key(|c| c.points.len()).map_or_else(Vec::new, |c| c.points.iter().map(|p| p.0).collect());
    let scale = Scale::of(study.dimension, ims.iter().copied());
    let mut columns = columns![&study.im => scale.symbol()];
    columns.extend(curves.iter().map(|c| Column::numbers(&c.state, "")));
    let mut table = Table::new(columns);
    for i in spread(ims.len(), ROWS) {
        let mut row = vec![scale.text(ims[i])];
        row.extend(curves.iter().map(|curve| {
            curve
                .points
                .iter()
                .find(|p| p.0 == ims[i])
                .map_or_else(|| "–".into(), |p| words::curves::counted(p.1, p.2, p.3))
        }));
        table.row(row);
    }
    table
}

/// P(at least k tanks lost), and the volume lost.
///
/// Errors: a drawing that fails.
pub(super) fn losses(study: &Study) -> Result<Vec<Figure>, Error> {
    if study.losses.is_empty() {
        return Ok(Vec::new());
    }
    Ok(vec![at_least(study)?, volume(study)?])
}

fn at_least(study: &Study) -> Result<Figure, Error> {
    let losses = &study.losses;
    let most = study.tanks.len();
    let shown: Vec<usize> = AT_LEAST.into_iter().filter(|k| *k <= most).collect();
    let mut chart = Chart::new(HALF, intensity(study, losses.iter().map(|l| l.im)), share(words::PROBABILITY));
    let scale = Scale::of(study.dimension, losses.iter().map(|l| l.im));
    let mut columns = columns![&study.im => scale.symbol()];
    for (i, &k) in shown.iter().enumerate() {
        let of = |values: fn(&results::StudyLoss) -> &Vec<Option<f64>>| -> Vec<(f64, Option<f64>)> {
            let at = |l: &results::StudyLoss| (l.im, values(l).get(k - 1).copied().flatten());
            losses.iter().map(at).collect()
        };
        chart.lines.extend(broken(&of(|l| &l.at_least), class(i), &words::at_least(k)));
        let independent = if i == 0 { words::INDEPENDENT } else { "" };
        chart.lines.extend(broken(&of(|l| &l.independent), "k-ground thin dotted", independent));
        columns.push(Column::numbers(&words::at_least(k), ""));
        columns.push(Column::numbers(words::INDEPENDENT, ""));
    }
    let mut table = Table::new(columns);
    for loss in losses {
        let mut row = vec![scale.text(loss.im)];
        for &k in &shown {
            for values in [&loss.at_least, &loss.independent] {
                let value = values.get(k - 1).copied().flatten();
                row.push(value.map_or_else(|| "–".into(), percent));
            }
        }
        table.row(row);
    }
    Ok(chart
        .with_plot_height(PLOT)
        .figure("study_at_least", words::AT_LEAST, table)?
        .captioned(words::AT_LEAST_CAPTION)
        .described(words::AT_LEAST_DESCRIPTION))
}

/// A line with a gap at each missing value; only its first piece is labelled.
fn broken(points: &[(f64, Option<f64>)], class: &str, label: &str) -> Vec<Line> {
    let pieces = points.split(|(_, value)| value.is_none()).filter(|piece| !piece.is_empty());
    let line = |(i, piece): (usize, &[(f64, Option<f64>)])| Line {
        points: piece.iter().filter_map(|(x, y)| Some((*x, (*y)?))).collect(),
        class: class.into(),
        label: if i == 0 { label.into() } else { String::new() },
    };
    pieces.enumerate().map(line).collect()
}

fn volume(study: &Study) -> Result<Figure, Error> {
    let losses = &study.losses;
    let y = Axis::linear(
        "volume [m³]",
        Dimension::Dimensionless,
        losses.iter().flat_map(|l| l.volume).flatten().chain([0.0]),
        5,
    );
    let mut chart = Chart::new(HALF, intensity(study, losses.iter().map(|l| l.im)), y);
    for (i, label) in words::VOLUMES.into_iter().enumerate() {
        let points: Vec<(f64, Option<f64>)> = losses.iter().map(|l| (l.im, l.volume[i])).collect();
        chart.lines.extend(broken(&points, ["k-s1", "k-s3"][i], label));
    }
    let scale = Scale::of(study.dimension, losses.iter().map(|l| l.im));
    let mut table = Table::new(columns![
        &study.im => scale.symbol(), words::VOLUMES[0] => "m³", words::VOLUMES[1] => "m³",
    ]);
    let known = |volume: Option<f64>| volume.map_or_else(|| "–".into(), |v| fixed(v, 0));
    for loss in losses {
        table.row(vec![scale.text(loss.im), known(loss.volume[0]), known(loss.volume[1])]);
    }
    Ok(chart
        .with_plot_height(PLOT)
        .figure("study_volume", "Volume of the liquid of lost tanks", table)?
        .described(words::VOLUME_DESCRIPTION))
}

/// The demands of single records.
///
/// Errors: a drawing that fails.
pub(super) fn traces(study: &Study) -> Result<Vec<Figure>, Error> {
    let of = |(number, trace): (usize, &StudyTrace)| scattered(study, number, trace);
    study.traces.iter().enumerate().map(of).collect()
}

fn scattered(study: &Study, number: usize, trace: &StudyTrace) -> Result<Figure, Error> {
    let points = || trace.records.iter().flat_map(|(_, points)| points.iter().copied());
    let end = points().map(|p| p.0).fold(0.0, f64::max);
    let highest = points().map(|p| p.1).fold(1.0, f64::max);
    let lowest = points().map(|p| p.1).fold(1.0, f64::min);
    // A few points far above the limit flatten all others on a linear axis.
    let logarithmic = highest > FLAT && lowest > 0.0;
    let y = match logarithmic {
        true => Axis::log(words::RATIO, Dimension::Dimensionless, (0.8 * lowest, 1.25 * highest)),
        false => Axis::linear(words::RATIO, Dimension::Dimensionless, points().map(|p| p.1).chain([0.0, 1.0]), 5),
    };
    let mut chart = Chart::new(HALF, intensity(study, points().map(|p| p.0)), y);
    chart.line(vec![(0.0, 1.0), (end, 1.0)], "k-s3", words::LIMIT);
    for (i, (_, points)) in trace.records.iter().enumerate() {
        chart.line(points.clone(), "k-ground thin", if i == 0 { "one record" } else { "" });
        chart.marks.extend(points.iter().map(|&at| Mark { at, label: String::new(), class: "own k-s2".into() }));
    }
    let scale = Scale::of(study.dimension, points().map(|p| p.0));
    let mut table = Table::new(columns!["Record", &study.im => scale.symbol(), words::RATIO => ""]);
    let all: Vec<(&str, (f64, f64))> =
        trace.records.iter().flat_map(|(id, points)| points.iter().map(|p| (id.as_str(), *p))).collect();
    for i in spread(all.len(), 8 * ROWS) {
        let (id, (im, ratio)) = all[i];
        table.row(vec![id.into(), scale.text(im), significant(ratio, 3)]);
    }
    Ok(chart
        .with_plot_height(PLOT)
        .figure(format!("study_records_{}", number + 1), words::trace(trace), table)?
        .captioned(words::trace_caption(trace, logarithmic))
        .described(words::trace_description(trace)))
}
