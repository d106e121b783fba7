//! Curves of the nonlinear run: loops, energies, envelopes over the height.

use tank::units::Dimension;

use crate::figure::chart::{Axis, Chart, Line, Rule};
use crate::figure::decimate::thin;
use crate::figure::{Figure, HALF};
use crate::number::{Scale, fixed, percent};
use crate::table::{Table, columns, spread};
use crate::words::figures::nonlinear as words;
use crate::words::{capital, labels};
use files::error::Error;
use results::nonlinear::{Loop, LoopAxis, Nonlinear};
use results::{Envelope, Run};

/// Height of the plots of loops in user units.
const LOOP: f64 = 190.0;
/// Part of a loop's extent below which points coincide: half a user unit.
const THIN: f64 = 0.5 / 300.0;
/// Points listed of a loop.
const LISTED: usize = 24;

/// Moment over curvature, force over displacement and the like; loops without extent are left out.
pub(super) fn loops(run: Option<&Nonlinear>) -> Result<Vec<Figure>, Error> {
    let mut figures = Vec::new();
    for (i, curve) in run.iter().flat_map(|run| &run.loops).enumerate() {
        figures.extend(one_loop(i, curve)?);
    }
    Ok(figures)
}

fn one_loop(index: usize, curve: &Loop) -> Result<Option<Figure>, Error> {
    let points = thin(&curve.points, THIN);
    let extent = |values: Vec<f64>| {
        let low = values.iter().copied().fold(f64::INFINITY, f64::min);
        let high = values.iter().copied().fold(f64::NEG_INFINITY, f64::max);
        (low, high)
    };
    let (x, y) = (extent(points.iter().map(|p| p.0).collect()), extent(points.iter().map(|p| p.1).collect()));
    if points.len() < 2 || x.1 <= x.0 || y.1 <= y.0 {
        return Ok(None);
    }
    let axis = |axis: &LoopAxis, range: (f64, f64), count| {
        Axis::linear(&capital(&axis.title), axis.dimension, [range.0, range.1, 0.0], count)
    };
    let (across, up) = (axis(&curve.x, x, 5), axis(&curve.y, y, 6));
    let mut chart = Chart::new(HALF, across, up);
    let zero = |points: Vec<(f64, f64)>| Line { points, class: "dg".into(), label: String::new() };
    // Where both quantities are zero: in the corner of the plot there is an axis already.
    chart.lines.push(zero(vec![(x.0.min(0.0), 0.0), (x.1.max(0.0), 0.0)]));
    chart.lines.push(zero(vec![(0.0, y.0.min(0.0)), (0.0, y.1.max(0.0))]));
    chart.line(points, "k-fe hist", "");
    let scales = (Scale::of(curve.x.dimension, [x.0, x.1]), Scale::of(curve.y.dimension, [y.0, y.1]));
    let mut table = Table::new(columns![
        &capital(&curve.x.title) => scales.0.symbol(), &capital(&curve.y.title) => scales.1.symbol(),
    ]);
    for i in spread(curve.points.len(), LISTED) {
        let [a, b] = curve.points[i];
        table.row(vec![scales.0.text(a), scales.1.text(b)]);
    }
    Ok(Some(
        chart
            .with_plot_height(LOOP)
            .figure(format!("loop_{}_{}", index + 1, curve.id), curve.title.clone(), table)?
            .captioned(words::extents(curve, x, y))
            .described(words::extents_description(curve, x, y)),
    ))
}

/// The balance of energies over time.
pub(super) fn energies(run: Option<&Nonlinear>, marks: &[(f64, String)]) -> Result<Vec<Figure>, Error> {
    let Some(energies) = run.map(|run| &run.energies).filter(|e| e.time.len() > 1) else { return Ok(Vec::new()) };
    let time = &energies.time;
    let values: [&[f64]; 6] = [
        &energies.input,
        &energies.internal,
        &energies.hysteretic,
        &energies.damping,
        &energies.kinetic,
        &energies.numerical,
    ];
    let curves: Vec<(&str, String, &[f64])> = (1..)
        .zip(labels::NONLINEAR_ENERGIES)
        .zip(values)
        .map(|((index, label), values)| (label, format!("k-s{index}"), values))
        .collect();
    let whole = |v: &[f64]| v.len() == time.len() && v.iter().all(|x| x.is_finite());
    if !curves.iter().all(|(_, _, v)| whole(v)) {
        return Err(Error::Report("nonlinear: energies without a value for each time".into()));
    }
    let most = |v: &[f64]| v.iter().fold(0.0_f64, |m, x| m.max(x.abs()));
    let largest = curves.iter().map(|(_, _, v)| most(v)).fold(0.0, f64::max);
    if largest == 0.0 {
        return Ok(Vec::new());
    }
    let scale = Scale::of(Dimension::Energy, [largest]);
    let end = time.len() - 1;
    let extent = curves.iter().flat_map(|(_, _, v)| v.iter().copied());
    let y = Axis::linear("Energy", Dimension::Energy, extent.chain([0.0]), 6);
    let mut chart = Chart::over_time(time[0], time[end], y);
    // Lines along zero add nothing to the table.
    for (label, class, values) in curves.iter().filter(|(_, _, v)| most(v) > 1e-4 * largest) {
        chart.history(time, values, format!("{class} thin"), *label);
    }
    chart.rules = Rule::all(marks);
    let input = energies.input[end];
    let mut table = Table::new(columns![
        "Energy", labels::AT_END[0] => scale.symbol(), "Largest" => scale.symbol(), labels::AT_END[1] => "",
    ]);
    for (label, _, values) in curves {
        let share = if input == 0.0 { "–".into() } else { percent(values[end] / input) };
        table.row(vec![capital(label), scale.text(values[end]), scale.text(most(values)), share]);
    }
    Ok(vec![
        chart
            .with_plot_height(170.0)
            .figure("energies", words::ENERGIES, table)?
            .captioned(words::energies(energies.error))
            .described(words::energies_description(
                time[end],
                input,
                [energies.damping[end], energies.hysteretic[end], energies.numerical[end]],
            )),
    ])
}

/// Envelopes over the height at θ = 0 of both engines.
pub(super) fn envelopes(linear: Option<&Run>, nonlinear: &Run) -> Result<Vec<Figure>, Error> {
    let mut figures = Vec::new();
    for envelope in &nonlinear.envelopes {
        let first = linear.and_then(|fe| fe.envelopes.iter().find(|e| e.id == envelope.id && sound(e)));
        if sound(envelope) {
            figures.extend(one_envelope(first, envelope)?);
        }
    }
    Ok(figures)
}

/// Whether it has two heights at least and a value at each.
fn sound(envelope: &Envelope) -> bool {
    let whole = |v: &[f64]| v.len() == envelope.z.len() && v.iter().all(|x| x.is_finite());
    envelope.z.len() > 1 && whole(&envelope.min) && whole(&envelope.max)
}

fn one_envelope(linear: Option<&Envelope>, nonlinear: &Envelope) -> Result<Option<Figure>, Error> {
    let sides = |e: &Envelope| -> [Vec<(f64, f64)>; 2] {
        [&e.min, &e.max].map(|v| v.iter().copied().zip(e.z.iter().copied()).collect())
    };
    let runs = [(linear, "k-fe", "linear"), (Some(nonlinear), "k-fe-nonlinear", "nonlinear")];
    let all = || runs.iter().filter_map(|(e, _, _)| *e);
    let values: Vec<f64> = all().flat_map(|e| e.min.iter().chain(&e.max).copied()).collect();
    if values.iter().all(|v| *v == 0.0) {
        return Ok(None);
    }
    let top = all().flat_map(|e| e.z.iter().copied()).fold(0.0, f64::max);
    let x = Axis::linear(&nonlinear.title, nonlinear.dimension, values.iter().copied().chain([0.0]), 5);
    let y = Axis::exact("Height z", Dimension::Length, (0.0, top), 6);
    let mut chart = Chart::new(HALF, x, y);
    for (envelope, class, label) in runs {
        for (side, points) in envelope.iter().flat_map(|e| sides(e)).enumerate() {
            chart.line(points, class, if side == 0 { label } else { "" });
        }
    }
    let scale = Scale::of(nonlinear.dimension, values.iter().copied());
    let mut table = Table::new(columns!["z" => "m", "Smallest" => scale.symbol(), "Largest" => scale.symbol()]);
    table.caption = "Nonlinear".into();
    for i in spread(nonlinear.z.len(), LISTED).into_iter().rev() {
        table.row(vec![fixed(nonlinear.z[i], 3), scale.text(nonlinear.min[i]), scale.text(nonlinear.max[i])]);
    }
    let most = |e: &Envelope| e.min.iter().chain(&e.max).fold(0.0_f64, |m, v| m.max(v.abs()));
    let [caption, description] = words::envelope(nonlinear, most(nonlinear), linear.map(most));
    Ok(Some(
        chart
            .with_plot_height(LOOP)
            .figure(format!("envelope_nonlinear_{}", nonlinear.id), nonlinear.title.clone(), table)?
            .captioned(caption)
            .described(description),
    ))
}
