//! The imperfect wall: its deviations, and the response by waves around the tank.

use std::f64::consts::TAU;

use serde::Serialize;
use tank::units::Dimension;

use super::section::FigureView;
use super::{Section, Source};
use crate::figure::chart::{Axis, Chart};
use crate::figure::{Figure, HALF, WIDE, map};
use crate::number::{Scale, fixed, ratio};
use crate::table::{Rows, Table, columns, spread_with_extremes};
use crate::words::figures::around as words;
use crate::words::labels;
use files::error::Error;
use results::{Around, BaseAround, Run};

/// Height of the plots in user units.
const PLOT: f64 = 150.0;
/// Half the width of a bar, in waves.
const BAR: f64 = 0.32;
/// Points of the wave n = 1 in the figure of the base.
const POINTS: usize = 180;

/// What a run found.
#[derive(Serialize)]
struct Found {
    name: String,
    summary: String,
    table: Table,
    figures: Vec<FigureView>,
}

/// Makes the section.
pub(super) fn make(source: &Source) -> Result<Option<Section>, Error> {
    let runs = source.results.runs.iter();
    let imperfect: Vec<(&Run, &Around)> = runs.filter_map(|run| Some((run, run.around.as_ref()?))).collect();
    if imperfect.is_empty() {
        return Ok(None);
    }
    let mut section = Section::new("around");
    let mut found = Vec::new();
    for (number, (run, around)) in imperfect.into_iter().enumerate() {
        let figures = figures(run.engine.id(), number == 0, around)?;
        found.push(Found {
            name: words::engine(run.engine.name()),
            summary: words::summary(around),
            table: table(around),
            figures: figures.iter().map(FigureView::of).collect(),
        });
        section.figures.extend(figures);
    }
    section.set("found", &found);
    Ok(Some(section))
}

/// Amplitude of n = 1, to which the others are compared.
fn first(around: &Around, of: impl Fn(&results::WaveAround) -> Option<f64>) -> Option<f64> {
    around.waves.iter().find(|w| w.n == 1).and_then(of).filter(|v| *v > 0.0)
}

fn table(around: &Around) -> Table {
    let deviation = Scale::of(Dimension::Length, around.waves.iter().map(|w| w.deviation));
    let displacement = Scale::of(Dimension::Length, around.waves.iter().map(|w| w.displacement));
    let stress = Scale::of(Dimension::Stress, around.waves.iter().filter_map(|w| w.stress));
    let moved = first(around, |w| Some(w.displacement));
    let stressed = first(around, |w| w.stress);
    let share = |value: f64, of: Option<f64>| of.map_or("–".into(), |of| ratio(value / of));
    let mut rows = Rows::of(&around.waves);
    rows.numbers("n", "", |w| w.n.to_string());
    rows.numbers("Deviation", deviation.symbol(), |w| deviation.text(w.deviation));
    rows.numbers("Radial displacement", displacement.symbol(), |w| displacement.text(w.displacement));
    rows.numbers("over n = 1", "", |w| share(w.displacement, moved));
    rows.numbers("at z", "m", |w| fixed(w.z, 3));
    rows.numbers("at t", "s", |w| fixed(w.time, 2));
    if around.waves.iter().any(|w| w.stress.is_some()) {
        rows.numbers(labels::BASE_STRESS, stress.symbol(), |w| w.stress.map_or("–".into(), |s| stress.text(s)));
        rows.numbers("over n = 1", "", |w| w.stress.map_or("–".into(), |s| share(s, stressed)));
    }
    rows.table
}

fn figures(engine: &str, with_map: bool, around: &Around) -> Result<Vec<Figure>, Error> {
    let mut out = Vec::new();
    if with_map {
        out.extend(map::figure("deviation", &around.map, None));
    }
    let displacements: Vec<(u32, f64)> = around.waves.iter().map(|w| (w.n, w.displacement)).collect();
    out.push(bars(&format!("waves_{engine}"), words::DISPLACEMENT, Dimension::Length, &displacements)?);
    let stresses: Vec<(u32, f64)> = around.waves.iter().filter_map(|w| Some((w.n, w.stress?))).collect();
    if !stresses.is_empty() {
        let id = format!("waves_stress_{engine}");
        out.push(bars(&id, words::STRESS, Dimension::Stress, &stresses)?);
    }
    if let Some(ring) = around.base.as_ref().filter(|b| sound(b)) {
        out.push(base(&format!("base_{engine}"), ring, first(around, |w| w.stress))?);
    }
    Ok(out)
}

/// Whether every angle has its values.
fn sound(base: &BaseAround) -> bool {
    base.theta.len() > 1 && base.min.len() == base.theta.len() && base.max.len() == base.theta.len()
}

/// Amplitudes by n.
fn bars(id: &str, title: &str, dimension: Dimension, values: &[(u32, f64)]) -> Result<Figure, Error> {
    let most = values.iter().map(|v| v.0).max().unwrap_or(1);
    let x = Axis::exact(words::WAVES, Dimension::Dimensionless, (-0.5, f64::from(most) + 0.5), 10);
    let y = Axis::linear(title, dimension, values.iter().map(|v| v.1).chain([0.0]), 5);
    let mut chart = Chart::new(HALF, x, y);
    for &(n, value) in values {
        let n = f64::from(n);
        chart.band(vec![(n - BAR, 0.0), (n + BAR, 0.0), (n + BAR, value), (n - BAR, value)], "k-fe", "");
    }
    let scale = Scale::of(dimension, values.iter().map(|v| v.1));
    let mut table = Table::new(columns!["n" => "", title => scale.symbol()]);
    for (n, value) in values {
        table.row(vec![n.to_string(), scale.text(*value)]);
    }
    Ok(chart.with_plot_height(PLOT).figure(id, title, table)?.described(words::bars(title)))
}

/// Range of the stress around the base, and that of the wave n = 1 alone.
fn base(id: &str, ring: &BaseAround, first: Option<f64>) -> Result<Figure, Error> {
    let side = |values: &[f64]| -> Vec<(f64, f64)> {
        let pairs = ring.theta.iter().copied().zip(values.iter().copied());
        // The circle is closed.
        let end = ring.theta.first().zip(values.first()).map(|(t, v)| (t + TAU, *v));
        pairs.chain(end).collect()
    };
    let x = Axis::around();
    let y = Axis::linear(words::STRESS, Dimension::Stress, ring.min.iter().chain(&ring.max).copied(), 5);
    let mut chart = Chart::new(WIDE, x, y);
    let mut corners = side(&ring.max);
    corners.extend(side(&ring.min).into_iter().rev());
    chart.band(corners, "k-fe", words::RANGE);
    for values in [&ring.max, &ring.min] {
        chart.line(side(values), "k-fe thin", "");
    }
    if let Some(first) = first {
        for (sign, label) in [(1.0, words::FIRST), (-1.0, "")] {
            let point = |k: usize| {
                let theta = TAU * k as f64 / POINTS as f64;
                (theta, sign * first * theta.cos().abs())
            };
            chart.line((0..=POINTS).map(point).collect(), "k-static", label);
        }
    }
    let scale = Scale::of(Dimension::Stress, ring.min.iter().chain(&ring.max).copied());
    let mut table = Table::new(columns!["θ" => "°", "Smallest" => scale.symbol(), "Largest" => scale.symbol()]);
    for i in spread_with_extremes(ring.theta.len(), 36, &[&ring.min, &ring.max]) {
        table.row(vec![fixed(ring.theta[i].to_degrees(), 1), scale.text(ring.min[i]), scale.text(ring.max[i])]);
    }
    Ok(chart.with_plot_height(PLOT).figure(id, words::BASE, table)?.described(words::base(ring)))
}
