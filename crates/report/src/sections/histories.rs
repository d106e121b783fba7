//! Time histories with their maxima marked.

use tank::units::Dimension;

use super::{Section, Source};
use crate::figure::Figure;
use crate::figure::chart::{Axis, Chart, Rule};
use crate::level::Level;
use crate::number::{Scale, fixed};
use crate::table::{Table, columns};
use crate::words::{after_record, figures, labels, sections};
use files::error::Error;
use results::channel::{OnWall, Side};
use results::{Channel, SeriesInfo};

/// Histories in the table of peaks below the full level.
const LISTED: usize = 8;

/// Histories drawn at most; the rest stands in the table of peaks and in `series.csv`.
fn most(level: Level) -> usize {
    match level {
        Level::Full => 9,
        _ => 4,
    }
}

/// Place of a history among those that come first.
fn rank(info: &SeriesInfo) -> usize {
    match info.channel() {
        Some(Channel::BaseShear) => 0,
        Some(Channel::BaseMoment) => 1,
        Some(Channel::OverturningMoment) => 2,
        Some(channel) if channel.is_wave() => 3,
        Some(channel) if channel.on_wall() == Some(OnWall::Axial) => 4,
        _ => 5,
    }
}

fn is_ground(info: &SeriesInfo) -> bool {
    matches!(info.channel(), Some(Channel::Ground { .. } | Channel::GroundY(_)))
}

/// Whether it is an internal force at a station; these have a separate section.
fn is_force(info: &SeriesInfo) -> bool {
    info.channel().and_then(Channel::force_at).is_some()
}

/// Whether it is of a base that lifts or slides, or of isolators; these have a separate section.
fn is_base(info: &SeriesInfo) -> bool {
    matches!(
        info.channel(),
        Some(
            Channel::BaseRotation
                | Channel::Uplift(_)
                | Channel::PlasticRotation(_)
                | Channel::ToeStress
                | Channel::Slip
                | Channel::AnchorForce
                | Channel::FoundationTranslation
                | Channel::FoundationRotation
        )
    ) || info.id.starts_with("isolator_")
}

/// Makes the section.
pub(super) fn make(source: &Source) -> Result<Option<Section>, Error> {
    let Some(fe) = source.results.reference() else { return Ok(None) };
    let own = |s: &&SeriesInfo| !is_ground(s) && !is_force(s) && !is_base(s);
    let mut infos: Vec<&SeriesInfo> = fe.histories.iter().filter(own).collect();
    infos.sort_by_key(|s| rank(s));
    if infos.is_empty() {
        return Ok(None);
    }
    let (mut drawn, mut shown_ids) = (Vec::new(), Vec::new());
    // The side away from the motion has its largest value in the table.
    let facing: Vec<&SeriesInfo> = infos.iter().copied().filter(|info| !info.id.contains(Side::Back.id())).collect();
    for info in facing.iter().take(most(source.level)) {
        let Some(values) = source.column(&info.id) else { continue };
        let id = format!("history_{}", info.id);
        let figure = history(source, &id, &info.title, info.dimension, values, Some(info), "k-fe")?;
        shown_ids.extend(figure.iter().map(|_| info.id.as_str()));
        drawn.extend(figure);
    }
    let mut table = Table::new(columns![
        "History", "Unit", labels::LARGEST[0] => "", "Time" => "s", "Static value" => "",
    ]);
    let listed = match source.level {
        Level::Full => infos.len(),
        _ => LISTED,
    };
    // Below the full level a figure has the numbers of its history.
    let own = |info: &&&SeriesInfo| source.level == Level::Full || !shown_ids.contains(&info.id.as_str());
    for info in infos.iter().take(listed).filter(own) {
        let scale = Scale::of(info.dimension, [info.peak]);
        table.row(vec![
            info.title.clone(),
            scale.symbol().into(),
            scale.text(info.peak),
            fixed(info.time, 3),
            if info.static_value == 0.0 { "–".into() } else { scale.text(info.static_value) },
        ]);
    }
    let mut section = Section::new("histories");
    let (shown, listed) = (drawn.len(), listed.min(infos.len()));
    section.set("undrawn", &sections::undrawn(shown, listed, infos.len()));
    section.set("after", &after_record::sentence(fe, source.series.time.last().copied()));
    section.set("peaks", &table);
    section.set_figures("figures", drawn);
    Ok(Some(section))
}

/// A vertical line where the record ends, if a history goes on until `end` [s].
pub(super) fn record_end(source: &Source, end: f64) -> Option<Rule> {
    let found = source.results.runs.iter().find_map(|run| run.record_end)?;
    (found < end).then(|| Rule { x: found, label: labels::RECORD_END.into() })
}

/// Places of the smallest and the largest value; of equal ones the first.
fn extremes(values: &[f64]) -> (usize, usize) {
    let extreme = |better: fn(&f64, &f64) -> bool| {
        (0..values.len()).fold(0, |best, i| if better(&values[i], &values[best]) { i } else { best })
    };
    (extreme(f64::lt), extreme(f64::gt))
}

/// A history as a figure, its largest absolute value marked; `None` if the column is empty.
pub(super) fn history(
    source: &Source,
    id: &str,
    title: &str,
    dimension: Dimension,
    values: &[f64],
    info: Option<&SeriesInfo>,
    class: &str,
) -> Result<Option<Figure>, Error> {
    let time = &source.series.time;
    let n = time.len().min(values.len());
    if n < 2 {
        return Ok(None);
    }
    let (time, values) = (&time[..n], &values[..n]);
    let (lowest, highest) = extremes(values);
    let sampled = if -values[lowest] > values[highest] { lowest } else { highest };
    // The engine reports the peak between samples; its sign is that of the nearest sample.
    let (time_of_peak, peak) = match info {
        Some(info) if info.peak.is_finite() => {
            let nearest = time.partition_point(|t| *t < info.time).min(n - 1);
            (info.time, info.peak.copysign(values[nearest]))
        }
        _ => (time[sampled], values[sampled]),
    };
    let scale = Scale::of(dimension, [peak]);

    let extent = [values[lowest], values[highest], peak, 0.0].map(|v| 1.12 * v);
    let y = Axis::linear(title, dimension, extent, 5);
    let mut chart = Chart::over_time(time[0], time[n - 1], y);
    if source.level != Level::Full {
        chart = chart.halved();
    }
    chart.history(time, values, format!("{class} hist"), "");
    chart.rules = record_end(source, time[n - 1]).into_iter().collect();
    if chart.x.holds(time_of_peak) {
        chart.mark((time_of_peak, peak), figures::peak(peak, dimension, time_of_peak), "peak");
    }
    let mut table = Table::new(columns!["Extreme", title => scale.symbol(), "Time" => "s"]);
    for (label, value, at) in [
        ("largest sample", values[highest], time[highest]),
        ("smallest sample", values[lowest], time[lowest]),
        (labels::LARGEST[1], peak.abs(), time_of_peak),
    ] {
        table.row(vec![label.into(), scale.text(value), fixed(at, 3)]);
    }
    let static_value = info.map_or(0.0, |i| i.static_value);
    let between = peak.abs() > 1.02 * values[sampled].abs();
    Ok(Some(
        chart
            .with_plot_height(if source.level == Level::Full { 96.0 } else { 56.0 })
            .figure(id, title, table)?
            .captioned(figures::history(static_value, dimension, between))
            .described(figures::history_description(
                title,
                dimension,
                time[n - 1],
                (values[highest], time[highest]),
                (values[lowest], time[lowest]),
            )),
    ))
}
