//! Pressure and stress over the height: profiles of the codes against the envelopes of the finite elements.

use std::collections::BTreeMap;

use tank::assessment::{Profile, TOTAL_HOOP};
use tank::units::Dimension;

use super::{Section, Source};
use crate::figure::chart::{Axis, Chart};
use crate::figure::{Figure, HALF};
use crate::level::Level;
use crate::methods::{Look, figure_order, look};
use crate::number::{Scale, fixed};
use crate::table::{Column, Table, columns, spread, spread_with_extremes};
use crate::words::{figures as words, labels};
use files::error::Error;
use results::Envelope;

/// Order of the quantities over the height; others follow by id.
const ORDER: [&str; 7] = [
    "pressure",
    "pressure_impulsive",
    "pressure_convective",
    "hoop_stress",
    "axial_membrane_stress",
    "bending_stress",
    "radial_displacement",
];

/// Those below the full level.
const HEADLINES: [&str; 2] = ["pressure", "axial_membrane_stress"];

/// Height of the plots in user units.
fn plot(level: Level) -> f64 {
    if level == Level::Full { 185.0 } else { 110.0 }
}

/// Content of one panel: the engine's envelope and the codes' profiles.
#[derive(Default)]
struct Group<'a> {
    envelope: Option<&'a Envelope>,
    profiles: Vec<(Look, &'a Profile)>,
    /// Profiles under the design spectrum of the site, drawn apart: another excitation.
    site: Vec<(Look, &'a Profile)>,
}

/// Makes the section.
pub(super) fn make(source: &Source) -> Result<Option<Section>, Error> {
    let mut groups: BTreeMap<(usize, &str), Group> = BTreeMap::new();
    let rank = |id: &str| ORDER.iter().position(|o| *o == id).unwrap_or(ORDER.len());
    if let Some(fe) = source.results.reference() {
        for envelope in fe.envelopes.iter().filter(|e| e.z.len() > 1) {
            let id = envelope.id.as_str();
            groups.entry((rank(id), id)).or_default().envelope = Some(envelope);
        }
    }
    for i in figure_order(source.results) {
        let method = &source.results.methods[i];
        for profile in method.profiles.iter().filter(|p| p.z.len() > 1) {
            // The engine has one seismic pressure; the codes call theirs the dynamic one.
            let id = match profile.id.as_str() {
                // Its figure stands beside the courses.
                TOTAL_HOOP => continue,
                "pressure_dynamic" => "pressure",
                id => id,
            };
            let group = groups.entry((rank(id), id)).or_default();
            let look = look(method);
            let list = if look.site { &mut group.site } else { &mut group.profiles };
            list.push((look, profile));
        }
    }
    let size = (source.results.tank.tank.wall_height(), plot(source.level));
    let (mut figures, mut site) = (Vec::new(), Vec::new());
    let full = source.level == Level::Full;
    for ((_, id), group) in &groups {
        if !full && !HEADLINES.contains(id) {
            continue;
        }
        if !group.profiles.is_empty() {
            figures.push(seismic(id, group.envelope, &group.profiles, size)?);
        }
        // With the static part: the section of the checks has what it amounts to.
        if let Some(envelope) = group.envelope.filter(|_| full || group.profiles.is_empty()) {
            figures.push(combined(envelope, size)?);
        }
        if !group.site.is_empty() && (full || figures.is_empty()) {
            site.push(seismic(&format!("{id}_site"), None, &group.site, size)?);
        }
    }
    if figures.is_empty() && site.is_empty() {
        return Ok(None);
    }
    let mut section = Section::new("profiles");
    section.set("has_fe", &(!source.results.runs.is_empty()));
    section.set("after", &source.results.runs.iter().any(|run| run.record_end.is_some()));
    section.set("has_codes", &groups.values().any(|g| !g.profiles.is_empty()));
    section.set_figures("figures", figures);
    section.set_figures("site_figures", site);
    Ok(Some(section))
}

/// Values beside their heights.
pub(super) fn pairs(values: &[f64], z: &[f64]) -> Vec<(f64, f64)> {
    values.iter().copied().zip(z.iter().copied()).collect()
}

fn band(envelope: &Envelope, offset: bool) -> Vec<(f64, f64)> {
    let shift = |i: usize| {
        if offset { envelope.static_.get(i).copied().unwrap_or(0.0) } else { 0.0 }
    };
    let side = |values: &[f64]| -> Vec<(f64, f64)> {
        values.iter().enumerate().map(|(i, v)| (v + shift(i), envelope.z.get(i).copied().unwrap_or(0.0))).collect()
    };
    let mut points = side(&envelope.max);
    points.extend(side(&envelope.min).into_iter().rev());
    points
}

/// The seismic part: profiles of the codes, and the engine's largest and smallest values where they are comparable.
///
/// * `height`, `plot`: of the wall [m], and of the plot in user units
fn seismic(
    id: &str,
    envelope: Option<&Envelope>,
    profiles: &[(Look, &Profile)],
    (height, plot): (f64, f64),
) -> Result<Figure, Error> {
    let (title, dimension) = match (envelope, profiles.first()) {
        (Some(e), _) => (e.title.clone(), e.dimension),
        (None, Some((_, p))) => (p.title.clone(), p.dimension),
        (None, None) => (String::new(), Dimension::Dimensionless),
    };
    let mut values: Vec<f64> = vec![0.0];
    if let Some(e) = envelope {
        values.extend(e.min.iter().chain(&e.max));
    }
    for (_, p) in profiles {
        values.extend(&p.values);
    }
    let mut chart = chart(&title, dimension, values, height);
    if let Some(e) = envelope {
        chart.band(band(e, false), "k-fe", labels::ENGINE_RANGE);
        for side in [&e.max, &e.min] {
            chart.line(pairs(side, &e.z), "k-fe thin", "");
        }
    }
    for (look, p) in profiles {
        chart.line(pairs(&p.values, &p.z), look.line_class(), look.label.clone());
    }
    Ok(chart
        .with_plot_height(plot)
        .figure(format!("profile_{id}"), words::seismic_part(&title), table(envelope, profiles, dimension))?
        .described(words::profiles(&title, envelope.is_some(), profiles.len())))
}

fn chart(title: &str, dimension: Dimension, values: Vec<f64>, height: f64) -> Chart {
    let x = Axis::linear(title, dimension, values, 5);
    let y = Axis::exact("Height z", Dimension::Length, (0.0, height), 5);
    Chart::new(HALF, x, y)
}

/// Static state and static plus seismic range of the finite elements.
fn combined(e: &Envelope, (height, plot): (f64, f64)) -> Result<Figure, Error> {
    let corners = band(e, true);
    let values: Vec<f64> = corners.iter().map(|c| c.0).chain(e.static_.iter().copied()).chain([0.0]).collect();
    let mut chart = chart(&e.title, e.dimension, values, height);
    chart.band(corners, "k-fe", labels::COMBINED_RANGE);
    chart.line(pairs(&e.static_, &e.z), "k-static", "static");
    for side in [&e.max, &e.min] {
        let points = e.static_.iter().zip(side.iter()).map(|(s, v)| s + v).collect::<Vec<_>>();
        chart.line(pairs(&points, &e.z), "k-fe thin", "");
    }
    let scale = Scale::of(e.dimension, e.static_.iter().chain(&e.min).chain(&e.max).copied());
    let mut table = Table::new(columns![
        "z" => "m", "Static" => scale.symbol(), "Seismic min" => scale.symbol(), "Seismic max" => scale.symbol(),
    ]);
    for i in spread_with_extremes(e.z.len(), 24, &[&e.static_, &e.min, &e.max]) {
        let value = |v: &[f64]| v.get(i).map_or("–".into(), |v| scale.text(*v));
        table.row(vec![fixed(e.z[i], 3), value(&e.static_), value(&e.min), value(&e.max)]);
    }
    let [title, description] = words::combined(e);
    Ok(chart.with_plot_height(plot).figure(format!("envelope_{}", e.id), title, table)?.described(description))
}

/// Values at the stations of the first profile; others interpolated.
fn table(envelope: Option<&Envelope>, profiles: &[(Look, &Profile)], dimension: Dimension) -> Table {
    let mut values: Vec<f64> = profiles.iter().flat_map(|(_, p)| p.values.iter().copied()).collect();
    if let Some(e) = envelope {
        values.extend(e.min.iter().chain(&e.max));
    }
    let scale = Scale::of(dimension, values);
    let mut columns = columns!["z" => "m"];
    if envelope.is_some() {
        columns.push(Column::numbers(labels::ENGINE_EXTREMES[0], scale.symbol()));
        columns.push(Column::numbers(labels::ENGINE_EXTREMES[1], scale.symbol()));
    }
    columns.extend(profiles.iter().map(|(l, _)| Column::numbers(&l.full_label(), scale.symbol())));
    let mut table = Table::new(columns);
    let stations = profiles.first().map_or(&[][..], |(_, p)| &p.z);
    for i in spread(stations.len(), 21) {
        let z = stations[i];
        let mut row = vec![fixed(z, 3)];
        let mut add = |zs: &[f64], values: &[f64]| {
            row.push(interpolate(zs, values, z).map_or("–".into(), |v| scale.text(v)));
        };
        if let Some(e) = envelope {
            add(&e.z, &e.min);
            add(&e.z, &e.max);
        }
        for (_, p) in profiles {
            add(&p.z, &p.values);
        }
        table.row(row);
    }
    table
}

fn interpolate(z: &[f64], values: &[f64], at: f64) -> Option<f64> {
    let upper = z.iter().position(|v| *v >= at - 1e-12)?;
    let value = *values.get(upper)?;
    if upper == 0 {
        return ((z[0] - at).abs() < 1e-9).then_some(value);
    }
    let (a, b) = (z[upper - 1], z[upper]);
    if b == a {
        return Some(value);
    }
    Some(values[upper - 1] + (value - values[upper - 1]) * (at - a) / (b - a))
}
