//! A motion of the base over time, of a tank that lifts, stands on soil or on isolators.

use super::Source;
use super::histories::record_end;
use crate::figure::Figure;
use crate::figure::chart::{Axis, Chart};
use crate::number::{Scale, fixed};
use crate::table::{Column, Table, columns, spread_with_extremes};
use crate::words::uplift as words;
use files::error::Error;
use results::Channel;

/// What is drawn.
pub(super) struct Motion<'a> {
    /// Id of the figure.
    pub id: &'a str,
    /// Its title.
    pub title: &'a str,
    /// Title of the axis upwards.
    pub axis: &'a str,
    /// At most two histories of one dimension.
    pub channels: &'a [Channel],
    /// Legend of two of them.
    pub labels: [&'a str; 2],
}

/// Curves over time; `None` without columns.
pub(super) fn over_time(source: &Source, motion: &Motion<'_>) -> Result<Option<Figure>, Error> {
    let time = &source.series.time;
    let found = motion.channels.iter().filter_map(|channel| source.column(&channel.id()));
    let columns: Vec<&[f64]> = found.filter(|c| c.len() > 1 && c.len() <= time.len()).collect();
    let (Some(first), Some(channel)) = (columns.first(), motion.channels.first()) else { return Ok(None) };
    let dimension = channel.dimension();
    let all = || columns.iter().flat_map(|c| c.iter().copied());
    let end = time[first.len() - 1];
    let y = Axis::linear(motion.axis, dimension, all().chain([0.0]), 5);
    let mut chart = Chart::over_time(time[0], end, y);
    let scale = Scale::of(dimension, all());
    let mut table = Table::new(columns![words::AXES[3] => "s"]);
    let looks = ["k-fe hist", "k-other hist"].into_iter().zip(motion.labels);
    for ((column, channel), (class, label)) in columns.iter().zip(motion.channels).zip(looks) {
        chart.history(time, column, class, if columns.len() > 1 { label } else { "" });
        table.columns.push(Column::numbers(&channel.title(), scale.symbol()));
    }
    chart.rules = record_end(source, end).into_iter().collect();
    for k in spread_with_extremes(first.len(), 24, &columns) {
        let values = columns.iter().map(|c| c.get(k).map_or(words::NONE.into(), |v| scale.text(*v)));
        table.row(std::iter::once(fixed(time[k], 3)).chain(values).collect());
    }
    Ok(Some(chart.with_plot_height(110.0).figure(motion.id, motion.title, table)?.described(words::description(
        motion.title,
        dimension,
        all(),
    ))))
}
