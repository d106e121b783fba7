//! Static tilt test: resultants, surface, and both sides over the height.

use tank::units::Dimension;

use super::{Section, Source};
use crate::figure::chart::{Axis, Chart, Line};
use crate::figure::{Figure, HALF, Room};
use crate::number::{Scale, fixed, significant, with_unit};
use crate::table::{Column, Table, spread};
use crate::words::{figures, labels};
use files::error::Error;
use results::{Tilt, TiltLine};

/// Height of the plots in user units.
const PLOT: f64 = 185.0;

/// Makes the section.
pub(super) fn make(source: &Source) -> Result<Option<Section>, Error> {
    let runs = source.results.runs.iter();
    let found: Vec<(&str, &Tilt)> = runs
        .filter_map(|run| Some((run.engine.name(), run.tilt.as_ref()?)))
        .collect();
    let Some((_, first)) = found.first() else {
        return Ok(None);
    };
    let mut section = Section::new("tilt");
    section.set("resultants", &resultants(&found));
    section.set("notes", &first.notes);
    let height = source.results.tank.tank.wall_height();
    let drawn = first.lines.iter().filter(|line| line.z.len() > 1);
    let figures = drawn.map(|line| side_by_side(line, height)).collect::<Result<_, _>>()?;
    section.set_figures("figures", figures);
    Ok(Some(section))
}

fn resultants(found: &[(&str, &Tilt)]) -> Table {
    let mut columns = vec![Column::words("Quantity")];
    columns.extend(found.iter().map(|(name, _)| Column::numbers(name, "")));
    let mut table = Table::new(columns);
    let mut add = |label: &str, of: &dyn Fn(&Tilt) -> String| {
        let mut row = vec![label.to_owned()];
        row.extend(found.iter().map(|(_, tilt)| of(tilt)));
        table.row(row);
    };
    let largest = |values: &[f64]| values.iter().fold(0.0, |m: f64, v| m.max(v.abs()));
    add("Angle", &|t| format!("{}°", significant(t.angle.to_degrees(), 4)));
    add("Base shear", &|t| with_unit(t.base_shear, Dimension::Force));
    add(labels::MOMENT_ABOVE, &|t| with_unit(t.base_moment, Dimension::Moment));
    add(labels::MOMENT_BELOW, &|t| {
        with_unit(t.overturning_moment, Dimension::Moment)
    });
    add(labels::SURFACE_RISE, &|t| {
        with_unit(largest(&t.surface), Dimension::Length)
    });
    table
}

/// Both sides of the tank.
fn side_by_side(line: &TiltLine, height: f64) -> Result<Figure, Error> {
    let values = || line.low.iter().chain(&line.high).copied();
    let x = Axis::linear(&line.title, line.dimension, values().chain([0.0]), 5);
    let y = Axis::exact("Height z", Dimension::Length, (0.0, height), 5);
    let mut chart = Chart::new((HALF, 0.0), x, y).with_plot_height(PLOT);
    let sides = [
        (&line.low, "k-fe", labels::LOW_SIDE),
        (&line.high, "k-other", labels::HIGH_SIDE),
    ];
    for (values, class, label) in sides {
        chart.lines.push(Line {
            points: values.iter().copied().zip(line.z.iter().copied()).collect(),
            class: class.into(),
            label: label.into(),
        });
    }
    let scale = Scale::of(line.dimension, values());
    let mut table = Table::new(vec![
        Column::numbers("z", "m"),
        Column::numbers(labels::LOW_SIDE, scale.symbol()),
        Column::numbers(labels::HIGH_SIDE, scale.symbol()),
    ]);
    for i in spread(line.z.len(), 24) {
        let value = |v: &[f64]| v.get(i).map_or("–".into(), |v| scale.text(*v));
        table.row(vec![fixed(line.z[i], 3), value(&line.low), value(&line.high)]);
    }
    let [title, description] = figures::tilted(&line.title, line.dimension, values());
    Ok(Figure {
        id: format!("tilt_{}", line.id),
        title,
        caption: String::new(),
        description,
        size: chart.size,
        markup: chart.draw()?,
        table,
        room: Room::Half,
    })
}
