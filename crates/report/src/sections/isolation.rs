//! A tank on isolators: values beside those on a fixed base, displacement, loop, bounds, energies.

use tank::units::Dimension;

use super::motion_of_base::{self, Motion};
use super::{Section, Source};
use crate::figure::chart::{Axis, Chart, Line};
use crate::figure::{Figure, HALF, Room};
use crate::number::{Scale, fixed, percent, with_unit};
use crate::table::{Column, Table, spread};
use crate::words::{isolation as words, labels, uplift};
use files::error::Error;
use results::{BaseQuantity, Channel, IsolationRun};

/// Makes the section.
pub(super) fn make(source: &Source) -> Result<Option<Section>, Error> {
    let Some(run) = source.results.reference().and_then(|run| run.isolation.as_ref()) else {
        return Ok(None);
    };
    let mut section = Section::new("isolation");
    section.set("isolators", &words::isolators(run));
    section.set("values", &values(run));
    section.set("band", &band(run));
    section.set("energy", &energy(run));
    section.set("balance", &words::balance(run));
    section.set("assumptions", &run.assumptions);
    let figures = [over_time(source)?, Some(cycles(run)?)];
    section.set_figures("figures", figures.into_iter().flatten().collect());
    Ok(Some(section))
}

fn text(quantity: &BaseQuantity) -> String {
    let value = quantity.value.value;
    match quantity.id.as_str() {
        "effective_damping" => percent(value),
        "bearing_share" if value < 0.0 => words::tension(&fixed(value, 2)),
        "bearing_share" => fixed(value, 2),
        _ => with_unit(value, quantity.value.dimension),
    }
}

fn values(run: &IsolationRun) -> Table {
    let [name, with, time, held, ratio] = words::VALUES;
    let mut table = Table::new(vec![
        Column::words(name),
        Column::numbers(with, ""),
        Column::numbers(time, "s"),
        Column::numbers(held, ""),
        Column::numbers(ratio, ""),
    ]);
    let none = || words::NONE.to_owned();
    for quantity in &run.quantities {
        let still = run.fixed.get(&quantity.id).copied();
        table.row(vec![
            words::quantity(&quantity.id).into(),
            text(quantity),
            quantity.time.map_or_else(none, |t| fixed(t, 3)),
            still.map_or_else(none, |v| with_unit(v, quantity.value.dimension)),
            still.map_or_else(none, |v| fixed(quantity.value.value / v, 3)),
        ]);
    }
    table.caption = words::TABLES[0].into();
    table
}

fn band(run: &IsolationRun) -> Table {
    let [first, rest @ ..] = words::BAND;
    let mut columns = vec![Column::words(first)];
    columns.extend(rest.map(|title| Column::numbers(title, "")));
    let mut table = Table::new(columns);
    for row in &run.band {
        table.row(vec![
            words::bound(row.factor),
            with_unit(row.isolator_displacement, Dimension::Length),
            with_unit(row.isolator_force, Dimension::Force),
            with_unit(row.effective_period, Dimension::Time),
            percent(row.effective_damping),
            with_unit(row.base_shear, Dimension::Force),
            with_unit(row.sloshing_height, Dimension::Length),
        ]);
    }
    table.caption = words::TABLES[1].into();
    table
}

fn energy(run: &IsolationRun) -> Table {
    let e = &run.energy;
    let all = [e.input, e.viscous, e.isolators, e.body];
    let scale = Scale::of(Dimension::Energy, all);
    let mut table = Table::new(vec![
        Column::words(labels::ENERGY_AT_END),
        Column::numbers("Value", scale.symbol()),
        Column::numbers(words::SHARE, ""),
    ]);
    for (label, value) in words::ENERGIES.into_iter().zip(all) {
        let share = if e.input == 0.0 {
            words::NONE.into()
        } else {
            percent(value / e.input)
        };
        table.row(vec![label.into(), scale.text(value), share]);
    }
    table.caption = words::TABLES[2].into();
    table
}

/// Displacement over time; `None` without its column.
fn over_time(source: &Source) -> Result<Option<Figure>, Error> {
    let motion = Motion {
        id: "isolator_displacement",
        title: words::FIGURES[0],
        axis: words::AXES[0],
        channels: &[Channel::IsolatorDisplacement, Channel::IsolatorDisplacementY],
        labels: words::COMPONENTS,
    };
    motion_of_base::over_time(source, &motion)
}

/// Force against displacement.
fn cycles(run: &IsolationRun) -> Result<Figure, Error> {
    let points: Vec<(f64, f64)> = run.cycles.iter().map(|p| (p[0], p[1])).collect();
    let x = Axis::linear(words::AXES[0], Dimension::Length, points.iter().map(|p| p.0), 5);
    let y = Axis::linear(words::AXES[1], Dimension::Force, points.iter().map(|p| p.1), 5);
    let mut chart = Chart::new((HALF, 0.0), x, y);
    let [displacement, force] = [
        Scale::of(Dimension::Length, points.iter().map(|p| p.0)),
        Scale::of(Dimension::Force, points.iter().map(|p| p.1)),
    ];
    let mut table = Table::new(vec![
        Column::numbers(words::AXES[0], displacement.symbol()),
        Column::numbers(words::AXES[1], force.symbol()),
    ]);
    for i in spread(points.len(), 24) {
        table.row(vec![displacement.text(points[i].0), force.text(points[i].1)]);
    }
    let description = uplift::description(words::FIGURES[1], Dimension::Force, points.iter().map(|p| p.1));
    chart.lines.push(Line {
        points,
        class: "k-fe thin".into(),
        label: String::new(),
    });
    let chart = chart.with_plot_height(150.0);
    Ok(Figure {
        id: "isolator_loop".into(),
        title: words::FIGURES[1].into(),
        caption: String::new(),
        description,
        size: chart.size,
        markup: chart.draw()?,
        table,
        room: Room::Half,
    })
}
