//! Histories of two runs drawn over each other.

use super::{Source, histories};
use crate::figure::Figure;
use crate::figure::chart::{Axis, Chart, Rule};
use crate::number::Scale;
use crate::table::{Table, columns};
use crate::words::{figures as words, labels};
use files::error::Error;
use results::{Channel, SeriesInfo};

/// The run that is drawn over the first one's.
pub(super) struct Second<'a> {
    /// Prefix of its columns in `series.csv`.
    pub prefix: &'a str,
    /// Beginning of the figures' ids.
    pub id: &'a str,
    /// Rest of the titles, after the quantity.
    pub title: &'a str,
    /// Palette class.
    pub class: &'a str,
    /// Names of the first and of this run, in legends and tables.
    pub names: [&'a str; 2],
    /// Moments worth a vertical line: time [s] and short label.
    pub rules: &'a [(f64, String)],
}

/// Whether a history is of a kind.
pub(super) type Kind = fn(Channel) -> bool;

/// Waves.
pub(super) const WAVE: Kind = Channel::is_wave;
/// The base shear.
pub(super) const BASE_SHEAR: Kind = |channel| channel == Channel::BaseShear;
/// The moment above the base plate.
pub(super) const BASE_MOMENT: Kind = |channel| channel == Channel::BaseMoment;

/// One figure for the first history of `infos` of each kind that the second run has too.
pub(super) fn overlays(
    source: &Source,
    infos: &[SeriesInfo],
    kinds: &[Kind],
    second: &Second,
) -> Result<Vec<Figure>, Error> {
    let mut figures = Vec::new();
    for kind in kinds {
        let shown = |s: &&SeriesInfo| {
            s.channel().is_some_and(kind) && source.column(&format!("{}{}", second.prefix, s.id)).is_some()
        };
        if let Some(info) = infos.iter().find(shown) {
            figures.extend(overlay(source, info, second)?);
        }
    }
    Ok(figures)
}

/// One history of both runs; `None` if a column is missing or empty.
fn overlay(source: &Source, info: &SeriesInfo, second: &Second) -> Result<Option<Figure>, Error> {
    let columns = (source.column(&info.id), source.column(&format!("{}{}", second.prefix, info.id)));
    let (Some(first), Some(other)) = columns else { return Ok(None) };
    let time = &source.series.time;
    // An interrupted run ends before the record does, and each has its own free vibration after it.
    let end = time.len().min(first.len());
    let run = other.iter().take(time.len()).take_while(|v| v.is_finite()).count();
    let common = end.min(run);
    if common < 2 {
        return Ok(None);
    }
    let values = first[..end].iter().chain(&other[..run]).copied();
    let (low, high) = values.fold((0.0_f64, 0.0_f64), |(l, h), v| (l.min(v), h.max(v)));
    let y = Axis::linear(&info.title, info.dimension, [1.05 * low, 1.05 * high], 5);
    let mut chart = Chart::over_time(time[0], time[end.max(run) - 1], y);
    let peak = |v: &[f64]| v.iter().fold(0.0_f64, |m, x| m.max(x.abs()));
    let mut both = [(first, end, "k-fe hist", second.names[0]), (other, run, second.class, second.names[1])];
    // The larger one behind: a dense history hides the one under it.
    both.sort_by(|a, b| peak(&b.0[..b.1]).total_cmp(&peak(&a.0[..a.1])));
    for (values, n, class, label) in both {
        chart.history(time, &values[..n], class, label);
    }
    chart.rules = Rule::all(second.rules);
    chart.rules.extend(histories::record_end(source, time[end.max(run) - 1]));
    let apart = (0..common).map(|i| (first[i] - other[i]).abs()).fold(0.0, f64::max);
    let largest = peak(&first[..end]);
    let scale = Scale::of(info.dimension, [largest]);
    let mut table = Table::new(columns!["Value", &info.title => scale.symbol()]);
    let [a, b] = second.names;
    table.row(vec![format!("largest sample, {a}"), scale.text(largest)]);
    table.row(vec![format!("largest sample, {b}"), scale.text(peak(&other[..run]))]);
    table.row(vec![labels::SAMPLE_DIFFERENCE.into(), scale.text(apart)]);
    let stopped = (run < end).then(|| time[run - 1]);
    Ok(Some(
        chart
            .with_plot_height(96.0)
            .figure(format!("{}_{}", second.id, info.id), format!("{}, {}", info.title, second.title), table)?
            .captioned(words::overlay(apart / largest.max(f64::MIN_POSITIVE), b, stopped))
            .described(words::overlay_description(info, second.names, [largest, peak(&other[..run])])),
    ))
}
