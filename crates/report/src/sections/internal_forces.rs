//! Internal forces at stations of the wall: largest values and histories.

use tank::units::Dimension;

use super::histories::record_end;
use super::{Section, Source};
use crate::figure::Figure;
use crate::figure::chart::{Axis, Chart};
use crate::number::{Scale, fixed, significant};
use crate::table::{Column, Table, columns};
use crate::words::internal_forces as words;
use files::error::Error;
use results::channel::OnWall;
use results::{Run, SeriesInfo};

/// Stations that are drawn at most; all stand in the table and in `series.csv`.
const MOST: usize = 4;
/// Height of the plots in user units.
const PLOT: f64 = 120.0;
/// Classes of the three curves of a figure.
const CLASSES: [&str; 3] = ["k-s1", "k-s2", "k-s3"];

/// The histories of a station.
struct Station<'a> {
    /// Height [m] and angle [°].
    place: (f64, f64),
    forces: Vec<(OnWall, &'a SeriesInfo)>,
}

/// Makes the section.
pub(super) fn make(source: &Source) -> Result<Option<Section>, Error> {
    let all: Vec<(&Run, Vec<Station>)> = source.results.runs.iter().map(|run| (run, stations(run))).collect();
    let Some((first, drawn)) = all.iter().find(|(_, stations)| !stations.is_empty()) else { return Ok(None) };
    let prefix = if source.results.reference().is_some_and(|run| run.engine == first.engine) {
        ""
    } else {
        first.engine.prefix()
    };
    let mut figures = Vec::new();
    for station in drawn.iter().take(MOST) {
        for part in [&OnWall::FORCES[..3], &OnWall::FORCES[3..]] {
            figures.extend(figure(source, prefix, station, part)?);
        }
    }
    let mut section = Section::new("internal_forces");
    section.set("undrawn", &words::undrawn(drawn.len().saturating_sub(MOST)));
    section.set("peaks", &peaks(&all));
    section.set_figures("figures", figures);
    Ok(Some(section))
}

/// The stations of a run in their order.
fn stations(run: &Run) -> Vec<Station<'_>> {
    let mut all: Vec<Station> = Vec::new();
    for info in &run.histories {
        let Some((what, z, degrees)) = info.channel().and_then(results::Channel::force_at) else { continue };
        let place = (z, degrees);
        match all.iter_mut().find(|station| station.place == place) {
            Some(station) => station.forces.push((what, info)),
            None => all.push(Station { place, forces: vec![(what, info)] }),
        }
    }
    all
}

/// Largest seismic values with the static ones, a row each.
fn peaks(all: &[(&Run, Vec<Station>)]) -> Table {
    let infos = |what: OnWall| {
        let stations = all.iter().flat_map(|(_, stations)| stations);
        let forces = stations.flat_map(|station| &station.forces);
        forces.filter(move |(own, _)| *own == what).map(|(_, info)| *info)
    };
    let scales: Vec<Scale> = OnWall::FORCES
        .iter()
        .map(|&what| Scale::of(what.dimension(), infos(what).flat_map(|i| [i.peak, i.static_value])))
        .collect();
    let mut columns = columns!["Engine", "z" => "m", "θ" => "°", words::PART];
    for (&what, scale) in OnWall::FORCES.iter().zip(&scales) {
        columns.push(Column::numbers(words::symbol(what), scale.symbol()));
    }
    let mut table = Table::new(columns);
    for (run, stations) in all {
        for station in stations {
            let mut add = |part: &str, of: fn(&SeriesInfo) -> f64| {
                let mut row = vec![
                    run.engine.name().to_owned(),
                    fixed(station.place.0, 3),
                    significant(station.place.1, 5),
                    part.to_owned(),
                ];
                for (what, scale) in OnWall::FORCES.iter().zip(&scales) {
                    let info = station.forces.iter().find(|(own, _)| own == what);
                    row.push(info.map_or("–".into(), |(_, info)| scale.text(of(info))));
                }
                table.row(row);
            };
            add(words::SEISMIC, |info| info.peak);
            add("at rest", |info| info.static_value);
        }
    }
    table
}

/// Histories of forces of one dimension at a station; `None` without samples.
fn figure(source: &Source, prefix: &str, station: &Station, part: &[OnWall]) -> Result<Option<Figure>, Error> {
    let time = &source.series.time;
    let curves: Vec<(OnWall, &SeriesInfo, &[f64])> = station
        .forces
        .iter()
        .filter(|(what, _)| part.contains(what))
        .filter_map(|&(what, info)| Some((what, info, source.column(&format!("{prefix}{}", info.id))?)))
        .filter(|(_, _, values)| values.len() >= 2 && values.len() <= time.len())
        .collect();
    let (Some(&first), Some(end)) = (part.first(), curves.iter().map(|(_, _, v)| time[v.len() - 1]).next()) else {
        return Ok(None);
    };
    let dimension: Dimension = first.dimension();
    let [title, axis] = words::figure(dimension == Dimension::LineForce, station.place);
    let all = || curves.iter().flat_map(|(_, _, values)| values.iter().copied());
    let y = Axis::linear(&axis, dimension, all().chain([0.0]), 5);
    let mut chart = Chart::over_time(time[0], end, y);
    let scale = Scale::of(dimension, all());
    let mut table = Table::new(columns!["Quantity", words::SEISMIC => scale.symbol(), "Time" => "s"]);
    for ((what, info, values), class) in curves.iter().zip(CLASSES) {
        chart.history(time, values, format!("{class} hist"), words::symbol(*what));
        table.row(vec![info.title.clone(), scale.text(info.peak), fixed(info.time, 3)]);
    }
    chart.rules = record_end(source, end).into_iter().collect();
    let peak = curves.iter().map(|(_, info, _)| info.peak).fold(0.0, f64::max);
    Ok(Some(
        chart
            .with_plot_height(PLOT)
            .figure(format!("forces_{}_{}_{}", station.place.0, station.place.1, first.id()), &title, table)?
            .described(words::description(&title, dimension, peak, end)),
    ))
}
