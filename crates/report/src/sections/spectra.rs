//! Response and design spectra: linear with the tank's periods marked, and the four-way logarithmic plot.

use tank::units::Dimension;

use super::{Section, Source};
use crate::figure::chart::{Axis, Chart, Line, Rule};
use crate::figure::{Figure, Room, WIDE, fourway};
use crate::number::{Scale, percent, plain, significant};
use crate::table::{Column, Table, spread};
use files::error::Error;
use results::SpectrumCurve;

/// Makes the section.
pub fn make(source: &Source) -> Result<Option<Section>, Error> {
    let curves: Vec<&SpectrumCurve> = source
        .results
        .spectra
        .iter()
        .filter(|c| c.period.len() > 1 && c.psa.len() == c.period.len())
        .collect();
    if curves.is_empty() {
        return Ok(None);
    }
    let mut section = Section::new("spectra", "Spectra");
    let figures = vec![linear(source, &curves)?, four_way(source, &curves)?];
    section.set_figures("figures", figures);
    section.set("at_periods", &at_periods(source, &curves));
    Ok(Some(section))
}

/// Palette class of the i-th curve; design spectra draw thinner and dashed.
fn class(curve: &SpectrumCurve, i: usize) -> String {
    let site = if curve.id.contains("site") { " site" } else { "" };
    format!("k-s{}{site}", i % 6 + 1)
}

/// The tank's periods with their symbols.
fn periods(source: &Source) -> Vec<(String, f64)> {
    let mut periods = Vec::new();
    if let Some(fe) = &source.results.fe {
        for (kind, letter, most) in [("sloshing", "c", 2), ("structural", "i", 1)] {
            let modes = fe.modes.iter().filter(|m| m.kind == kind && m.harmonic == 1);
            for mode in modes.take(most) {
                periods.push((format!("T_{letter}{}", mode.number), mode.period));
            }
        }
    }
    if periods.is_empty() {
        for (id, name) in [("sloshing_period", "T_c1"), ("impulsive_period", "T_i1")] {
            periods.extend(source.best(id).map(|t| (name.to_owned(), t)));
        }
    }
    periods
}

fn rules(source: &Source) -> Vec<Rule> {
    periods(source)
        .into_iter()
        .map(|(name, x)| Rule {
            x,
            label: format!("{name} = {} s", significant(x, 3)),
        })
        .collect()
}

fn linear(source: &Source, curves: &[&SpectrumCurve]) -> Result<Figure, Error> {
    let longest = periods(source).iter().map(|p| p.1).fold(0.0, f64::max);
    let data_end = curves
        .iter()
        .filter_map(|c| c.period.last())
        .fold(0.0_f64, |m, t| m.max(*t));
    let end = (1.25 * longest).clamp(2.0_f64.min(data_end), data_end);
    let gravity = source.results.tank.gravity;
    let shown = |c: &SpectrumCurve| -> Vec<(f64, f64)> {
        let points = c.period.iter().zip(&c.psa);
        points
            .filter(|(t, _)| **t <= end)
            .map(|(t, a)| (*t, a / gravity))
            .collect()
    };
    let values: Vec<f64> = curves.iter().flat_map(|c| shown(c)).map(|p| p.1).collect();
    let x = Axis::exact("Period T", Dimension::Time, (0.0, end), 8);
    let mut y = Axis::linear(
        "Pseudo-acceleration",
        Dimension::Dimensionless,
        values.into_iter().chain([0.0]),
        5,
    );
    y.title = "Pseudo-acceleration PSA [g]".into();
    let mut chart = Chart::new((WIDE, 0.0), x, y);
    chart.rules = rules(source);
    for (i, c) in curves.iter().enumerate() {
        chart.lines.push(Line {
            points: shown(c),
            class: class(c, i),
            label: c.title.clone(),
        });
    }
    let chart = chart.with_plot_height(190.0);
    let mut columns = vec![Column::numbers("Period", "s")];
    columns.extend(curves.iter().map(|c| Column::numbers(&c.title, "g")));
    let mut table = Table::new(columns);
    let longest_curve = curves
        .iter()
        .max_by_key(|c| c.period.len())
        .map_or(&[][..], |c| &c.period);
    for i in spread(longest_curve.len(), 40) {
        let t = longest_curve[i];
        let mut row = vec![significant(t, 3)];
        row.extend(
            curves
                .iter()
                .map(|c| cell(at(&c.period, &c.psa, t).map(|a| a / gravity))),
        );
        table.row(row);
    }
    Ok(Figure {
        id: "spectrum_linear".into(),
        title: "Pseudo-acceleration spectra".into(),
        caption: "Vertical lines: periods of the tank (c sloshing, i structural).".into(),
        titled: false,
        description: format!(
            "Pseudo-acceleration over period up to {} s for {} spectra.",
            plain(end, 2),
            curves.len()
        ),
        size: chart.size,
        markup: chart.draw()?,
        table,
        room: Room::Wide,
    })
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
            class: class(c, i),
            label: c.title.clone(),
        })
        .collect();
    let (size, markup) = fourway::draw(&drawn, rules(source), source.results.tank.gravity)?;
    let mut columns = vec![Column::numbers("Period", "s")];
    for c in curves {
        columns.push(Column::numbers(&format!("PSV, {}", c.title), "m/s"));
        columns.push(Column::numbers(&format!("Sd, {}", c.title), "mm"));
    }
    let mut table = Table::new(columns);
    let longest = curves
        .iter()
        .max_by_key(|c| c.period.len())
        .map_or(&[][..], |c| &c.period);
    for i in spread(longest.len(), 30) {
        let t = longest[i];
        let mut row = vec![significant(t, 3)];
        for c in curves {
            row.push(cell(at(&c.period, &c.psv, t)));
            row.push(cell(at(&c.period, &c.sd, t).map(|d| 1e3 * d)));
        }
        table.row(row);
    }
    Ok(Figure {
        id: "spectrum_four_way".into(),
        title: "Four-way logarithmic spectra".into(),
        caption: "Pseudo-velocity upwards; falling lines of equal displacement, rising lines of equal \
                  pseudo-acceleration."
            .into(),
        titled: false,
        description: format!("Tripartite plot of {} spectra on logarithmic axes.", curves.len()),
        size,
        markup,
        table,
        room: Room::Wide,
    })
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
    let mut columns = vec![Column::words("Spectrum"), Column::numbers("Damping", "")];
    let periods = periods(source);
    for (name, t) in &periods {
        columns.push(Column::numbers(
            &format!("PSA at {} = {} s", name.replace('_', ""), significant(*t, 3)),
            "g",
        ));
    }
    let mut table = Table::new(columns);
    if periods.is_empty() {
        return table;
    }
    for c in curves {
        let scale = Scale::of(Dimension::Dimensionless, [0.1]);
        let mut row = vec![c.title.clone(), percent(c.damping)];
        for (_, t) in &periods {
            row.push(at(&c.period, &c.psa, *t).map_or("–".into(), |a| scale.text(a / gravity)));
        }
        table.row(row);
    }
    table
}
