//! Response and design spectra: linear with the tank's periods marked, and the four-way logarithmic plot.

use tank::units::Dimension;

use super::{Section, Source};
use crate::figure::chart::{Axis, Chart, Rule};
use crate::figure::{Figure, HALF, Room, WIDE, fourway};
use crate::level::Level;
use crate::number::{Scale, significant};
use crate::table::{Column, Table, columns, spread};
use crate::words::figures::spectra as words;
use files::error::Error;
use results::{Mode, SpectrumCurve};

/// Makes the section.
pub(super) fn make(source: &Source) -> Result<Option<Section>, Error> {
    let curves: Vec<&SpectrumCurve> =
        source.results.spectra.iter().filter(|c| c.period.len() > 1 && c.psa.len() == c.period.len()).collect();
    if curves.is_empty() {
        return Ok(None);
    }
    let mut section = Section::new("spectra");
    let mut figures = vec![linear(source, &curves)?];
    if source.level == Level::Full {
        figures.push(four_way(source, &curves)?);
    }
    section.set_figures("figures", figures);
    section.set("beside", &(source.level != Level::Full));
    section.set("at_periods", &at_periods(source, &curves));
    Ok(Some(section))
}

/// Palette class of the i-th curve.
fn class(i: usize) -> String {
    format!("k-s{}", i % 6 + 1)
}

/// A period of the tank.
struct Period {
    /// `c` of sloshing, `i` of structural modes.
    letter: char,
    /// Number of the mode.
    number: usize,
    /// Period [s].
    value: f64,
}

/// The tank's periods.
fn periods(source: &Source) -> Vec<Period> {
    let mut periods = Vec::new();
    if let Some(fe) = source.results.reference() {
        for (kind, letter, most) in [("sloshing", 'c', 2), ("structural", 'i', 1)] {
            // Numbers count what the motion excites first.
            let own = |m: &&Mode| m.kind == kind && m.harmonic == 1 && m.number <= most;
            periods.extend(fe.modes.iter().filter(own).map(|mode| Period {
                letter,
                number: mode.number,
                value: mode.period,
            }));
        }
    }
    if periods.is_empty() {
        for (id, letter) in [("sloshing_period", 'c'), ("impulsive_period", 'i')] {
            periods.extend(source.best(id).map(|value| Period { letter, number: 1, value }));
        }
    }
    periods
}

fn rules(source: &Source) -> Vec<Rule> {
    periods(source)
        .into_iter()
        .map(|p| Rule { x: p.value, label: format!("T_{}{} = {} s", p.letter, p.number, significant(p.value, 3)) })
        .collect()
}

fn linear(source: &Source, curves: &[&SpectrumCurve]) -> Result<Figure, Error> {
    let longest = periods(source).iter().map(|p| p.value).fold(0.0, f64::max);
    let data_end = curves.iter().filter_map(|c| c.period.last()).fold(0.0_f64, |m, t| m.max(*t));
    let end = (1.25 * longest).clamp(2.0_f64.min(data_end), data_end);
    let gravity = source.results.tank.gravity;
    let shown = |c: &SpectrumCurve| -> Vec<(f64, f64)> {
        let points = c.period.iter().zip(&c.psa);
        points.filter(|(t, _)| **t <= end).map(|(t, a)| (*t, a / gravity)).collect()
    };
    let values: Vec<f64> = curves.iter().flat_map(|c| shown(c)).map(|p| p.1).collect();
    let x = Axis::exact("Period T", Dimension::Time, (0.0, end), if source.level == Level::Full { 8 } else { 5 });
    let mut y = Axis::linear("Pseudo-acceleration", Dimension::Dimensionless, values.into_iter().chain([0.0]), 5);
    y.title = "Pseudo-acceleration PSA [g]".into();
    let mut chart = Chart::new(if source.level == Level::Full { WIDE } else { HALF }, x, y);
    chart.rules = rules(source);
    for (i, c) in curves.iter().enumerate() {
        chart.line(shown(c), class(i), c.title.clone());
    }
    let mut columns = columns!["Period" => "s"];
    columns.extend(curves.iter().map(|c| Column::numbers(&c.title, "g")));
    let mut table = Table::new(columns);
    let longest_curve = curves.iter().max_by_key(|c| c.period.len()).map_or(&[][..], |c| &c.period);
    for i in spread(longest_curve.len(), 40) {
        let t = longest_curve[i];
        let mut row = vec![significant(t, 3)];
        row.extend(curves.iter().map(|c| cell(at(&c.period, &c.psa, t).map(|a| a / gravity))));
        table.row(row);
    }
    Ok(chart
        .with_plot_height(if source.level == Level::Full { 190.0 } else { 100.0 })
        .figure("spectrum_linear", words::LINEAR, table)?
        .captioned(words::LINEAR_CAPTION)
        .described(words::linear(end, curves.len())))
}

fn cell(value: Option<f64>) -> String {
    value.map_or("–".into(), |v| significant(v, 4))
}

fn four_way(source: &Source, curves: &[&SpectrumCurve]) -> Result<Figure, Error> {
    let drawn: Vec<fourway::Curve> = curves
        .iter()
        .enumerate()
        .map(|(i, c)| fourway::Curve {
            points: c.period.iter().copied().zip(c.psv.iter().copied()).collect(),
            class: class(i),
            label: c.title.clone(),
        })
        .collect();
    let (size, markup) = fourway::draw(&drawn, rules(source), source.results.tank.gravity)?;
    let mut columns = columns!["Period" => "s"];
    for c in curves {
        columns.push(Column::numbers(&format!("PSV, {}", c.title), "m/s"));
        columns.push(Column::numbers(&format!("Sd, {}", c.title), "mm"));
    }
    let mut table = Table::new(columns);
    let longest = curves.iter().max_by_key(|c| c.period.len()).map_or(&[][..], |c| &c.period);
    for i in spread(longest.len(), 30) {
        let t = longest[i];
        let mut row = vec![significant(t, 3)];
        for c in curves {
            row.push(cell(at(&c.period, &c.psv, t)));
            row.push(cell(at(&c.period, &c.sd, t).map(|d| 1e3 * d)));
        }
        table.row(row);
    }
    let figure = Figure::new("spectrum_four_way", words::FOUR_WAY, (size, markup), table);
    // Its width is that of its decades.
    Ok(Figure { room: Room::Wide, ..figure }
        .captioned(words::FOUR_WAY_CAPTION)
        .described(words::four_way(curves.len())))
}

/// Value of a curve at `t`, linear between its points; `None` outside.
fn at(period: &[f64], values: &[f64], t: f64) -> Option<f64> {
    let upper = period.iter().position(|p| *p >= t)?;
    let last = *values.get(upper)?;
    if upper == 0 {
        return (period[0] == t).then_some(last);
    }
    let (a, b) = (period[upper - 1], period[upper]);
    let before = values[upper - 1];
    Some(before + (last - before) * (t - a) / (b - a))
}

/// Spectral values at the tank's periods.
fn at_periods(source: &Source, curves: &[&SpectrumCurve]) -> Table {
    let gravity = source.results.tank.gravity;
    let mut columns = columns!["Spectrum"];
    let periods = periods(source);
    for p in &periods {
        let head = format!("PSA at T{}{} = {} s", p.letter, p.number, significant(p.value, 3));
        columns.push(Column::numbers(&head, "g"));
    }
    let mut table = Table::new(columns);
    if periods.is_empty() {
        return table;
    }
    for c in curves {
        let scale = Scale::of(Dimension::Dimensionless, [0.1]);
        let mut row = vec![c.title.clone()];
        for p in &periods {
            row.push(at(&c.period, &c.psa, p.value).map_or("–".into(), |a| scale.text(a / gravity)));
        }
        table.row(row);
    }
    table
}
