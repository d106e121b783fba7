//! The base of an unanchored tank under the moments of the codes: values on each ground, moment against rotation, the lifted plate.

use tank::Quantity;
use tank::units::Dimension;

use super::{Section, Source};
use crate::figure::chart::{Axis, Band, Chart, Line};
use crate::figure::{Figure, HALF, Room, WIDE};
use crate::number::{Scale, fixed, with_unit};
use crate::table::{Column, Table, spread};
use crate::words::standing as words;
use files::error::Error;
use results::{Method, Standing, StandingPlate};

/// Height of the plots in user units.
const PLOT: f64 = 150.0;
/// Classes of the curves, the softest ground first.
const CURVES: [&str; 4] = ["k-soft", "k-fe", "k-hard", "k-rock"];

/// Makes the section.
pub(super) fn make(source: &Source) -> Result<Option<Section>, Error> {
    let Some(standing) = &source.results.standing else {
        return Ok(None);
    };
    let methods = moments(source, standing);
    let governing = methods.iter().find(|(m, _)| m.id == standing.method);
    let label = governing.map_or(standing.method.as_str(), |(m, _)| m.label.as_str());
    let mut section = Section::new("standing");
    section.set("moment", &words::moment(standing, label));
    section.set("grounds", &grounds(standing));
    let mut figures = vec![turning(standing, &methods)?];
    if let Some(plate) = &standing.plate {
        figures.extend([lifted(plate)?, pressed(plate)?]);
    }
    section.set_figures("figures", figures);
    Ok(Some(section))
}

/// The procedures with a moment, under the excitation of the largest.
fn moments<'a>(source: &Source<'a>, standing: &Standing) -> Vec<(&'a Method, f64)> {
    let value = |m: &Method| m.quantities.get(Quantity::BaseMoment.id()).map(|v| v.value);
    let all = || source.results.methods.iter();
    let excitation = all()
        .find(|m| m.id == standing.method && value(m) == Some(standing.moment))
        .map(|m| m.excitation);
    let procedures = all().filter(|m| Some(m.excitation) == excitation && m.steps.iter().any(|s| !s.clause.is_empty()));
    procedures.filter_map(|m| Some((m, value(m)?))).collect()
}

fn grounds(standing: &Standing) -> Table {
    let [first, rest @ ..] = words::GROUNDS;
    let mut columns = vec![Column::words(first)];
    columns.extend(rest.map(|title| Column::numbers(title, "")));
    let mut table = Table::new(columns);
    for ground in &standing.grounds {
        let mut row = vec![words::ground(ground.modulus, ground.decides)];
        match &ground.values {
            Some(v) => row.extend([
                words::rotation(v.rotation),
                with_unit(v.uplift, Dimension::Length),
                with_unit(v.lifted_width, Dimension::Length),
                words::rotation(v.plastic_rotation),
                with_unit(v.toe_axial_stress, Dimension::Stress),
            ]),
            None => row.extend((1..words::GROUNDS.len()).map(|_| words::NONE.to_owned())),
        }
        table.row(row);
    }
    table
}

fn line(points: Vec<(f64, f64)>, class: &str, label: &str) -> Line {
    Line {
        points,
        class: class.into(),
        label: label.into(),
    }
}

/// Moment against rotation on each ground, with the moments of the codes.
fn turning(standing: &Standing, methods: &[(&Method, f64)]) -> Result<Figure, Error> {
    let curves: Vec<Vec<(f64, f64)>> = standing
        .grounds
        .iter()
        .map(|g| g.curve.iter().map(|p| (p[0], p[1])).collect())
        .collect();
    let all = || curves.iter().flatten();
    let end = all().map(|p| p.0).fold(0.0, f64::max);
    let x = Axis::linear(words::AXES[0], Dimension::Angle, all().map(|p| p.0).chain([0.0]), 5);
    let y = Axis::linear(
        words::AXES[1],
        Dimension::Moment,
        all().map(|p| p.1).chain(methods.iter().map(|m| m.1)).chain([0.0]),
        5,
    );
    let mut chart = Chart::new((WIDE, 0.0), x, y);
    // Between the first three, k/3, k and 3k.
    if let [soft, _, hard, ..] = curves.as_slice() {
        chart.bands.push(Band {
            points: soft.iter().chain(hard.iter().rev()).copied().collect(),
            class: "k-other".into(),
            label: String::new(),
        });
    }
    for (i, (ground, curve)) in standing.grounds.iter().zip(&curves).enumerate() {
        let class = CURVES[i.min(CURVES.len() - 1)];
        chart
            .lines
            .push(line(curve.clone(), class, &words::curve(ground.modulus)));
    }
    for (method, moment) in methods {
        let class = format!("{} thin", method.figure_key);
        chart
            .lines
            .push(line(vec![(0.0, *moment), (end, *moment)], &class, &method.label));
    }
    let scale = Scale::of(Dimension::Moment, all().map(|p| p.1));
    let mut table = Table::new(vec![
        Column::words(words::GROUNDS[0]),
        Column::numbers(words::AXES[0], "rad"),
        Column::numbers(words::AXES[1], scale.symbol()),
    ]);
    for (ground, curve) in standing.grounds.iter().zip(&curves) {
        for i in spread(curve.len(), 8) {
            let (rotation, moment) = curve[i];
            table.row(vec![
                words::curve(ground.modulus),
                fixed(rotation, 6),
                scale.text(moment),
            ]);
        }
    }
    let text = description_of(0, Dimension::Moment, all().map(|p| p.1));
    figure("standing_moment_rotation", 0, (chart, table), Room::Wide, ("", text))
}

fn description_of(number: usize, dimension: Dimension, values: impl Iterator<Item = f64>) -> String {
    crate::words::uplift::description(words::FIGURES[number], dimension, values)
}

fn figure(
    id: &str,
    number: usize,
    (chart, table): (Chart, Table),
    room: Room,
    (caption, description): (&str, String),
) -> Result<Figure, Error> {
    let chart = chart.with_plot_height(PLOT);
    Ok(Figure {
        id: id.into(),
        title: words::FIGURES[number].into(),
        caption: caption.into(),
        description,
        size: chart.size,
        markup: chart.draw()?,
        table,
        room,
    })
}

/// A chart over the distance from the wall, which stands at the right end, and the table of its points.
fn across(plate: &StandingPlate, axis: usize, value: fn(&[f64; 3]) -> f64, dimension: Dimension) -> (Chart, Table) {
    let values = || plate.points.iter().map(value);
    let x = Axis::linear(
        words::AXES[2],
        Dimension::Length,
        plate.points.iter().map(|p| p[0]).chain([0.0]),
        5,
    );
    let y = Axis::linear(words::AXES[axis], dimension, values().chain([0.0]), 5);
    let scale = Scale::of(dimension, values());
    let mut table = Table::new(vec![
        Column::numbers(words::AXES[2], "m"),
        Column::numbers(words::AXES[axis], scale.symbol()),
    ]);
    for i in spread(plate.points.len(), 24) {
        table.row(vec![fixed(plate.points[i][0], 3), scale.text(value(&plate.points[i]))]);
    }
    (Chart::new((HALF, 0.0), x, y), table)
}

/// The plate, its yielded parts and the ground without load.
fn lifted(plate: &StandingPlate) -> Result<Figure, Error> {
    let (mut chart, table) = across(plate, 3, |p| p[1], Dimension::Length);
    let points: Vec<(f64, f64)> = plate.points.iter().map(|p| (p[0], p[1])).collect();
    let ends = [points.first(), points.last()]
        .into_iter()
        .flatten()
        .map(|p| (p.0, 0.0));
    chart.lines.push(line(ends.collect(), "k-ground thin", words::LEVEL));
    chart.lines.push(line(points.clone(), "k-fe", words::PLATE[0]));
    for (i, [from, to]) in plate.yielded.iter().enumerate() {
        let inside = |p: &&(f64, f64)| p.0 <= *from && p.0 >= *to;
        let part = points.iter().filter(inside).copied().collect();
        chart
            .lines
            .push(line(part, "k-yielded", if i == 0 { words::PLATE[1] } else { "" }));
    }
    let text = description_of(1, Dimension::Length, points.iter().map(|p| p.1));
    let caption = words::plate(plate);
    figure("standing_plate", 1, (chart, table), Room::Half, (&caption, text))
}

/// The pressure of the ground.
fn pressed(plate: &StandingPlate) -> Result<Figure, Error> {
    let (mut chart, table) = across(plate, 4, |p| p[2], Dimension::Stress);
    let points: Vec<(f64, f64)> = plate.points.iter().map(|p| (p[0], p[2])).collect();
    let (Some(first), Some(last)) = (points.first(), points.last()) else {
        return figure("standing_pressure", 2, (chart, table), Room::Half, ("", String::new()));
    };
    let closed = [(first.0, 0.0)]
        .into_iter()
        .chain(points.iter().copied())
        .chain([(last.0, 0.0)]);
    chart.bands.push(Band {
        points: closed.collect(),
        class: "k-other".into(),
        label: String::new(),
    });
    chart.lines.push(line(points.clone(), "k-ground", ""));
    let text = description_of(2, Dimension::Stress, points.iter().map(|p| p.1));
    figure("standing_pressure", 2, (chart, table), Room::Half, ("", text))
}
