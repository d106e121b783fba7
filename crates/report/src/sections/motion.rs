//! Ground motion: acceleration, velocity, displacement, and the measures.

use super::histories::history;
use super::{Section, Source};
use crate::figure::Figure;
use crate::level::Level;
use crate::number::{count, fixed, significant};
use crate::table::{Column, Table, columns};
use crate::words::{self, capital, labels};
use files::error::Error;
use results::channel::Ground;
use results::{Channel, RecordSummary};

/// Direction of a second horizontal record.
const ACROSS: &str = "horizontal, y";

/// Makes the section.
pub(super) fn make(source: &Source) -> Result<Option<Section>, Error> {
    let records = &source.results.records;
    if records.is_empty() {
        return Ok(None);
    }
    let mut figures = Vec::new();
    for record in records {
        figures.extend(curves(source, record)?);
    }
    let mut section = Section::new("motion");
    let set = source.results.record_set.as_ref();
    section.set("one_of", &set.map_or_else(String::new, words::record_set::one_of));
    section.set("records", records);
    section.set("measures", &measures(source));
    section.set("beside", &(source.level != Level::Full));
    section.set_figures("figures", figures);
    Ok(Some(section))
}

fn curves(source: &Source, record: &RecordSummary) -> Result<Vec<Figure>, Error> {
    let mut figures = Vec::new();
    // The first is the acceleration.
    let drawn = if source.level == Level::Full { Ground::ALL.len() } else { 1 };
    for motion in Ground::ALL.into_iter().take(drawn) {
        let channel = match record.direction.as_str() {
            ACROSS => Channel::GroundY(motion),
            direction => Channel::Ground { motion, vertical: direction == "vertical" },
        };
        let id = channel.id();
        let Some(values) = source.column(&id) else { continue };
        let (title, dimension) = (channel.title(), channel.dimension());
        figures.extend(history(source, &id, &title, dimension, values, None, "k-ground")?);
    }
    Ok(figures)
}

fn measures(source: &Source) -> Table {
    let records = &source.results.records;
    let gravity = source.results.tank.gravity;
    let mut columns = columns!["Measure", "Unit"];
    columns.extend(records.iter().map(|r| Column::numbers(&capital(&r.direction), "")));
    let mut table = Table::new(columns);
    let mut add = |label: &str, unit: &str, of: &dyn Fn(&RecordSummary) -> String| {
        let mut row = vec![label.to_owned(), unit.to_owned()];
        row.extend(records.iter().map(of));
        table.row(row);
    };
    add("Peak acceleration", "m/s²", &|r| significant(r.pga, 4));
    add("Peak acceleration", "g", &|r| significant(r.pga / gravity, 4));
    add(labels::PEAK_AS_RECORDED, "g", &|r| significant(r.pga_as_recorded / gravity, 4));
    add("Peak velocity", "m/s", &|r| significant(r.pgv, 4));
    add("Peak displacement", "m", &|r| significant(r.pgd, 4));
    add("Arias intensity", "m/s", &|r| significant(r.arias, 4));
    add(labels::CUMULATIVE_VELOCITY, "m/s", &|r| significant(r.cav, 4));
    add("Significant duration D5–95", "s", &|r| significant(r.significant_duration, 4));
    add("Time step", "s", &|r| significant(r.dt, 4));
    // Duration over step says the same.
    if source.level == Level::Full {
        add("Samples", "", &|r| count(r.samples));
    }
    add("Duration", "s", &|r| fixed(r.dt * r.samples.saturating_sub(1) as f64, 2));
    if records.iter().any(|r| r.usable_period.is_some()) {
        add(words::record_set::heads::USABLE, "s", &|r| {
            let mark = if r.sloshing_beyond_usable { " ✗" } else { "" };
            r.usable_period.map_or("–".into(), |t| significant(t, 4) + mark)
        });
    }
    table
}
