//! Transfer functions: amplification of wave, base shear and overturning moment by frequency.

use tank::units::Dimension;

use super::{Section, Source};
use crate::figure::chart::{Axis, Chart, Line, Rule, titled};
use crate::figure::decimate::decimate;
use crate::figure::{Figure, Room, WIDE};
use crate::number::significant;
use crate::table::{Column, Table, spread};
use crate::words::transfer as words;
use files::error::Error;
use results::{Transfer, TransferFunction, TransferMode};

/// Height of the plots in user units.
const PLOT: f64 = 150.0;
/// Decades below the largest amplification that are drawn at most.
const DECADES: f64 = 5.0;
/// Modes of each kind that are marked.
const MARKED: usize = 3;

/// The transfer functions of an engine, its name and the class of its colour.
type Found<'a> = (&'a str, &'static str, &'a Transfer);

/// Makes the section.
pub(super) fn make(source: &Source) -> Result<Option<Section>, Error> {
    let runs = source.results.runs.iter().enumerate();
    let found: Vec<Found> = runs
        .filter_map(|(i, run)| Some((run.engine.name(), run.engine.figure_key(i), run.transfer.as_ref()?)))
        .collect();
    let Some((_, _, first)) = found.first() else {
        return Ok(None);
    };
    let figures = first
        .functions
        .iter()
        .map(|f| figure(&found, f))
        .collect::<Result<Vec<_>, _>>()?;
    let mut section = Section::new("transfer");
    section.set("peaks", &peaks(&found));
    section.set_figures("figures", figures.into_iter().flatten().collect());
    Ok(Some(section))
}

/// Amplification and its frequency [Hz], point by point.
fn amplification(transfer: &Transfer, function: &TransferFunction) -> Vec<(f64, f64)> {
    let points = transfer.frequency.iter().zip(&function.magnitude);
    points
        .map(|(f, h)| (*f, h / function.static_value.abs()))
        .filter(|(f, a)| f.is_finite() && *f > 0.0 && a.is_finite() && *a > 0.0)
        .collect()
}

/// The largest of a curve and its frequency [Hz].
fn largest(points: &[(f64, f64)]) -> Option<(f64, f64)> {
    let point = points.iter().max_by(|a, b| a.1.total_cmp(&b.1))?;
    Some((point.1, point.0))
}

/// Largest values, engine by engine.
fn peaks(found: &[Found]) -> Table {
    let mut table = Table::new(vec![
        Column::words("Quantity"),
        Column::words("Engine"),
        Column::words("Unit"),
        Column::numbers("Quasi-static", ""),
        Column::numbers("Largest", ""),
        Column::numbers("Amplification", ""),
        Column::numbers(words::FREQUENCY, "Hz"),
    ]);
    for (engine, _, transfer) in found {
        for function in &transfer.functions {
            let Some((ratio, frequency)) = largest(&amplification(transfer, function)) else {
                continue;
            };
            table.row(vec![
                function.title.clone(),
                (*engine).to_owned(),
                words::unit(&function.unit).into(),
                significant(function.static_value.abs(), 4),
                significant(ratio * function.static_value.abs(), 4),
                significant(ratio, 4),
                significant(frequency, 4),
            ]);
        }
    }
    table
}

/// Modes that are marked.
fn rules(modes: &[TransferMode]) -> Vec<Rule> {
    let kinds = ["sloshing", "structural"];
    let marked = modes
        .iter()
        .filter(|m| m.number <= MARKED && kinds.contains(&m.kind.as_str()));
    marked
        .map(|m| Rule {
            x: m.frequency,
            label: words::mode(m.kind == "sloshing", m.number),
        })
        .collect()
}

/// A quantity by frequency, a curve an engine; `None` without a point.
fn figure(found: &[Found], function: &TransferFunction) -> Result<Option<Figure>, Error> {
    let mut curves = Vec::new();
    for (engine, class, transfer) in found {
        let own = transfer.functions.iter().find(|f| f.id == function.id);
        let points = own.map_or_else(Vec::new, |f| amplification(transfer, f));
        if !points.is_empty() {
            curves.push((*engine, *class, points));
        }
    }
    let Some((highest, at)) = largest(&curves.iter().flat_map(|c| c.2.clone()).collect::<Vec<_>>()) else {
        return Ok(None);
    };
    let all = || curves.iter().flat_map(|c| &c.2);
    let lowest = all().map(|p| p.1).fold(f64::INFINITY, f64::min);
    let range = all().fold((f64::INFINITY, 0.0_f64), |(low, high), p| (low.min(p.0), high.max(p.0)));
    let floor = (lowest / 1.2).max(highest / 10f64.powf(DECADES));
    let x = Axis::log(words::FREQUENCY, Dimension::Frequency, range);
    let mut y = Axis::log(&function.title, Dimension::Dimensionless, (floor, 1.5 * highest)).by_decades();
    y.title = format!("{} {}", function.title, words::RATIO);
    let mut chart = Chart::new((WIDE, 0.0), x, y);
    let several = curves.len() > 1;
    for (engine, class, points) in &curves {
        chart.lines.push(Line {
            points: thinned(points, floor),
            class: format!("{class} thin"),
            label: if several { (*engine).into() } else { String::new() },
        });
    }
    let (_, _, first) = found[0];
    chart.rules = rules(&first.modes);
    let chart = chart.with_plot_height(PLOT);
    let unit = words::unit(&function.unit);
    let mut table = Table::new(vec![
        Column::numbers(words::FREQUENCY, "Hz"),
        Column::numbers(&titled(&function.title, unit), ""),
        Column::numbers("Phase", "rad"),
    ]);
    for i in spread(first.frequency.len(), 24) {
        table.row(vec![
            significant(first.frequency[i], 5),
            significant(function.magnitude[i], 4),
            significant(function.phase[i], 3),
        ]);
    }
    Ok(Some(Figure {
        id: format!("transfer_{}", function.id),
        title: function.title.clone(),
        caption: words::caption(function.static_value, unit, words::damping(first.damping)),
        description: words::description(&function.title, (highest, at), range),
        size: chart.size,
        markup: chart.draw()?,
        table,
        room: Room::Wide,
    }))
}

/// Points at equal distances of the logarithm with every peak between them, none below the floor.
fn thinned(points: &[(f64, f64)], floor: f64) -> Vec<(f64, f64)> {
    let x: Vec<f64> = points.iter().map(|p| p.0.log10()).collect();
    let y: Vec<f64> = points.iter().map(|p| p.1.max(floor).log10()).collect();
    let kept = decimate(&x, &y, (WIDE - 60.0) as usize);
    kept.into_iter().map(|(x, y)| (10f64.powf(x), 10f64.powf(y))).collect()
}
