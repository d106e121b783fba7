//! A tank on a slab on soil: effective period and damping by definition, motion of the slab, results beside those on a fixed base.

use tank::Quantity;
use tank::units::Dimension;

use super::motion_of_base::{self, Motion};
use super::{Section, Source};
use crate::figure::Figure;
use crate::number::{fixed, percent, with_unit};
use crate::table::{Column, Table};
use crate::words::soil as words;
use files::error::Error;
use results::{Channel, SoilRun};

/// Makes the section.
pub(super) fn make(source: &Source) -> Result<Option<Section>, Error> {
    let Some(run) = source.results.reference().and_then(|run| run.soil.as_ref()) else {
        return Ok(None);
    };
    let mut section = Section::new("soil");
    section.set("ground", &words::ground(run));
    section.set("cones", &cones(run));
    section.set("effective", &effective(run));
    section.set("values", &values(run));
    section.set("fixed", &beside(run));
    section.set("assumptions", &run.assumptions);
    let figures = [
        over_time(source, 0, Channel::FoundationTranslation)?,
        over_time(source, 1, Channel::FoundationRotation)?,
    ];
    section.set_figures("figures", figures.into_iter().flatten().collect());
    Ok(Some(section))
}

fn cones(run: &SoilRun) -> Table {
    let [motion, stiffness, dashpot, inertia] = words::CONES;
    let mut table = Table::new(vec![
        Column::words(motion),
        Column::numbers(stiffness, ""),
        Column::numbers(dashpot, ""),
        Column::numbers(inertia, ""),
    ]);
    for row in words::cones(run) {
        table.row(row.into());
    }
    table.caption = words::TABLES[0].into();
    table
}

fn effective(run: &SoilRun) -> Table {
    let [name, period, ratio, damping] = words::EFFECTIVE;
    let mut table = Table::new(vec![
        Column::words(name),
        Column::numbers(period, "s"),
        Column::numbers(ratio, ""),
        Column::numbers(damping, ""),
    ]);
    table.row(vec![
        words::FIXED.into(),
        fixed(run.fixed_period, 4),
        fixed(1.0, 3),
        percent(run.fixed_damping),
    ]);
    for mode in &run.effective {
        table.row(vec![
            words::definition(mode).into(),
            fixed(mode.period, 4),
            fixed(mode.period / run.fixed_period, 3),
            mode.damping.map_or(words::NONE.into(), percent),
        ]);
    }
    table.caption = words::TABLES[1].into();
    table
}

fn values(run: &SoilRun) -> Table {
    let [name, value, time] = words::MOTION;
    let mut table = Table::new(vec![
        Column::words(name),
        Column::numbers(value, ""),
        Column::numbers(time, "s"),
    ]);
    for quantity in run.quantities.iter().filter(|q| q.time.is_some()) {
        let text = match quantity.value.dimension {
            Dimension::Angle => format!("{:.2e} rad", quantity.value.value),
            dimension => with_unit(quantity.value.value, dimension),
        };
        let time = quantity.time.map_or(words::NONE.into(), |t| fixed(t, 3));
        table.row(vec![words::quantity(&quantity.id).into(), text, time]);
    }
    table.caption = words::TABLES[2].into();
    table
}

fn beside(run: &SoilRun) -> Table {
    let [name, soil, held, ratio] = words::BESIDE;
    let mut table = Table::new(vec![
        Column::words(name),
        Column::numbers(soil, ""),
        Column::numbers(held, ""),
        Column::numbers(ratio, ""),
    ]);
    for row in &run.beside {
        let title = Quantity::from_id(&row.id).map_or(row.id.clone(), |q| q.title().into());
        table.row(vec![
            title,
            with_unit(row.soil.value, row.soil.dimension),
            with_unit(row.fixed.value, row.fixed.dimension),
            fixed(row.soil.value / row.fixed.value, 3),
        ]);
    }
    table.caption = words::TABLES[3].into();
    table
}

/// A history of the slab; `None` without its column.
fn over_time(source: &Source, number: usize, channel: Channel) -> Result<Option<Figure>, Error> {
    let motion = Motion {
        id: &channel.id(),
        title: words::FIGURES[number],
        axis: words::AXES[number],
        channels: &[channel],
        labels: [""; 2],
    };
    motion_of_base::over_time(source, &motion)
}
