//! The base of a tank that lifts or slides: values beside those of the wall held down, histories, loop, circumference, band, energies.

use std::f64::consts::TAU;

use tank::units::Dimension;

use super::motion_of_base::{self, Motion};
use super::{Section, Source};
use crate::figure::chart::{Axis, Chart};
use crate::figure::rocking::{self, Elevation, Position};
use crate::figure::{Figure, HALF};
use crate::level::Level;
use crate::number::{Scale, fixed, share, with_unit};
use crate::table::{Column, Table, columns, spread, spread_with_extremes};
use crate::words::uplift as words;
use files::error::Error;
use results::channel::Side;
use results::{BaseRun, Channel, Finding, GroundPlan};

/// Height of the plots in user units.
const PLOT: f64 = 150.0;
/// Place of the anchors among the energies.
const ANCHORS: usize = 4;

/// Makes the section.
pub(super) fn make(source: &Source) -> Result<Option<Section>, Error> {
    let Some(run) = source.results.reference().and_then(|run| run.base.as_ref()) else { return Ok(None) };
    let mut section = Section::new("base");
    section.set("values", &values(run, source.level));
    section.set("ground", &words::ground(run));
    section.set("band", &band(run));
    section.set("anchors", &run.anchors.as_ref().map(words::anchors));
    section.set("joint", &run.joint.as_ref().map(|j| words::joint(j, run.plastic_rotation_limit)));
    section.set("missed", &words::missed(run));
    section.set("energy", &energy(run));
    section.set("balance", &words::balance(run));
    section.set("assumptions", &run.assumptions);
    let full = source.level == Level::Full;
    section.set("full", &full);
    if !full {
        section.set_figures("figures", Vec::new());
        return Ok(Some(section));
    }
    let sides = Side::BOTH.map(Channel::Uplift);
    let figures = [
        over_time(source, 0, &sides)?,
        over_time(source, 1, &[Channel::BaseRotation])?,
        slips(source, run)?,
        Some(turning(run)?),
        Some(around(run)?),
        bolts(run)?,
        plan(source, run),
        positions(source, run),
    ];
    section.set_figures("figures", figures.into_iter().flatten().collect());
    Ok(Some(section))
}

/// What of the bottom is on the ground at the largest uplift.
fn plan(source: &Source, run: &BaseRun) -> Option<Figure> {
    let uplift = run.quantity("uplift").filter(|uplift| uplift.value.value > 0.0)?;
    let plan = rocking::Plan {
        radius: source.results.tank.tank.shape.half_length(),
        lifted: &run.lifted,
        ground: run.ground.as_ref().filter(|ground| ground.is_whole()),
    };
    let widest = run.lifted.iter().map(|p| p[1]).fold(0.0, f64::max);
    let (size, markup) = plan.draw();
    let scale = Scale::of(Dimension::Length, [widest]);
    let mut table = Table::new(columns!["θ" => "°", "Lifted width" => scale.symbol()]);
    let ground = plan.ground.map(|ground| (ground, pressed(ground)));
    let pressure = Scale::of(Dimension::Stress, ground.iter().map(|(_, most)| most.value));
    if ground.is_some() {
        let columns = words::PRESSURES.map(|title| Column::numbers(title, pressure.symbol()));
        table.columns.extend(columns);
    }
    for i in spread(run.lifted.len(), 25) {
        let [degrees, width] = run.lifted[i];
        let mut row = vec![fixed(degrees, 0), scale.text(width)];
        if let Some((ground, _)) = &ground {
            let along = along(ground, degrees);
            let last = along.last().copied().unwrap_or_default();
            let most = along.iter().copied().fold(0.0, f64::max);
            row.extend([last, most].map(|p| pressure.text(p)));
        }
        table.row(row);
    }
    let mut sentence = words::plan(plan.share(), uplift.time.unwrap_or_default(), widest);
    if let Some((ground, most)) = &ground {
        sentence.push(' ');
        sentence.push_str(&words::pressed(ground.rest, most, rocking::highest_colour(ground)));
    }
    (widest > 0.0).then(|| {
        Figure::new("base_plan", words::FIGURES[4], (size, markup), table)
            .captioned(sentence.clone())
            .described(sentence)
    })
}

/// The largest pressure of the ground.
fn pressed(ground: &GroundPlan) -> words::Pressed {
    let mut most = words::Pressed::default();
    for (degrees, row) in ground.degrees.iter().zip(&ground.pressure) {
        for (radius, value) in ground.radii.iter().zip(row) {
            if *value > most.value {
                most = words::Pressed {
                    value: *value,
                    degrees: *degrees,
                    inwards: ground.radii[ground.radii.len() - 1] - radius,
                };
            }
        }
    }
    most
}

/// Pressures of the ground from the axis to the wall at the angle of the plan that is next to this one [°].
fn along(ground: &GroundPlan, degrees: f64) -> &[f64] {
    let angle = if degrees > 180.0 { 360.0 - degrees } else { degrees };
    let off = |i: &usize| (ground.degrees[*i] - angle).abs();
    let nearest = (0..ground.degrees.len()).min_by(|a, b| off(a).total_cmp(&off(b)));
    nearest.map_or(&[], |i| &ground.pressure[i])
}

/// Slip over time; none of a tank that does not slide.
fn slips(source: &Source, run: &BaseRun) -> Result<Option<Figure>, Error> {
    if !run.quantity("slip").is_some_and(|slip| slip.value.value > 0.0) {
        return Ok(None);
    }
    let motion = Motion {
        id: "base_slip",
        title: words::SLIP[0],
        axis: words::SLIP[1],
        channels: &[Channel::Slip],
        labels: words::SIDES,
    };
    motion_of_base::over_time(source, &motion)
}

/// The tank at eight instants from the zero of the rotation before its largest one to the second zero after it.
fn positions(source: &Source, run: &BaseRun) -> Option<Figure> {
    const PARTS: usize = 8;
    let time = &source.series.time;
    let column = |channel: Channel| source.column(&channel.id()).filter(|c| c.len() > 2 && c.len() <= time.len());
    let rotation = column(Channel::BaseRotation)?;
    let [front, back] = Side::BOTH.map(|side| column(Channel::Uplift(side)));
    let (front, back) = (front?, back?);
    let last = rotation.len().min(front.len()).min(back.len()) - 1;
    let peak = (0..=last).max_by(|&i, &j| rotation[i].abs().total_cmp(&rotation[j].abs()))?;
    let turns = |i: usize| rotation[i] * rotation[i + 1] <= 0.0;
    let from = (0..peak).rev().find(|&i| turns(i)).unwrap_or(0);
    let mut zeros = (peak..last).filter(|&i| turns(i)).map(|i| i + 1);
    let to = zeros.nth(1).unwrap_or(last);
    let at = |values: &[f64], place: f64| {
        let i = (place as usize).min(last - 1);
        values[i] + (place - i as f64) * (values[i + 1] - values[i])
    };
    let found: Vec<Position> = (0..PARTS)
        .map(|k| from as f64 + (to - from) as f64 * (k as f64 + 0.5) / PARTS as f64)
        .map(|place| Position { time: at(time, place), rim: [at(front, place), at(back, place)] })
        .collect();
    let tank = &source.results.tank;
    let elevation = Elevation {
        radius: tank.tank.shape.half_length(),
        wall: tank.tank.wall_height(),
        depth: tank.liquid.fill_height,
    };
    // Lifted width by uplift, from the circumference at the largest one.
    let mut widths: Vec<(f64, f64)> = run.around.iter().zip(&run.lifted).map(|(w, l)| (w[1], l[1])).collect();
    widths.sort_by(|a, b| a.0.total_cmp(&b.0));
    let width = |uplift: f64| {
        let above = widths.partition_point(|p| p.0 < uplift).min(widths.len().saturating_sub(1));
        widths.get(above).map_or(0.0, |p| p.1)
    };
    let (size, markup) = rocking::positions(&elevation, &found, &width);
    let scale = Scale::of(Dimension::Length, found.iter().flat_map(|p| p.rim));
    let [when, right, left] = words::POSITIONS;
    let mut table = Table::new(columns![when => "s", right => scale.symbol(), left => scale.symbol()]);
    for position in &found {
        let [front, back] = position.rim.map(|w| scale.text(w));
        table.row(vec![fixed(position.time, 3), front, back]);
    }
    let caption = words::cycle(rocking::factor(&elevation, &found));
    let description = words::description(words::FIGURES[5], Dimension::Length, found.iter().flat_map(|p| p.rim));
    Some(
        Figure::new("base_positions", words::FIGURES[5], (size, markup), table)
            .captioned(caption)
            .described(description),
    )
}

fn text(quantity: &Finding) -> String {
    match quantity.value.dimension {
        Dimension::Angle => words::rotation(quantity.value.value),
        dimension => with_unit(quantity.value.value, dimension),
    }
}

/// Largest values of the base; below the full level without the rows of a slip that is zero.
fn values(run: &BaseRun, level: Level) -> Table {
    let [name, with, time, angle, height, held, ratio] = words::VALUES;
    let mut table = Table::new(columns![
        name, with => "", time => "s", angle => "", height => "", held => "", ratio => "",
    ]);
    let none = || words::NONE.to_owned();
    let slides = level == Level::Full || run.quantity("slip").is_some_and(|slip| slip.value.value > 0.0);
    for quantity in run.quantities.iter().filter(|quantity| slides || !quantity.id.starts_with("slip")) {
        let fixed_base = run.held.get(&quantity.id).copied();
        let mut value = text(quantity);
        if quantity.id == "plastic_rotation" && quantity.value.value > run.plastic_rotation_limit {
            value = words::beyond(&value, run.plastic_rotation_limit);
        }
        table.row(vec![
            words::quantity(&quantity.id).into(),
            value,
            quantity.time.map_or_else(none, |t| fixed(t, 3)),
            quantity.degrees.map_or_else(none, |d| fixed(d, 0)),
            quantity.z.map_or_else(none, |z| fixed(z, 2)),
            fixed_base.map_or_else(none, |v| with_unit(v, quantity.value.dimension)),
            fixed_base.map_or_else(none, |v| fixed(quantity.value.value / v, 3)),
        ]);
    }
    table.caption = words::TABLES[0].into();
    table
}

fn band(run: &BaseRun) -> Table {
    let [first, rest @ ..] = words::BAND;
    let mut columns = columns![first];
    columns.extend(rest.map(|title| Column::numbers(title, "")));
    let mut table = Table::new(columns);
    let value = |id: &str| run.quantity(id).map_or(0.0, |q| q.value.value);
    let own = results::BaseBand {
        modulus: run.modulus,
        uplift: value("uplift"),
        base_rotation: value("base_rotation"),
        plastic_rotation: value("plastic_rotation"),
        toe_axial_stress: value("toe_axial_stress"),
        slip: value("slip"),
        base_shear: value("base_shear"),
        spread: run.spread,
    };
    let mut rows: Vec<&results::BaseBand> = run.band.iter().chain([&own]).collect();
    rows.sort_by(|a, b| a.modulus.total_cmp(&b.modulus));
    for row in rows {
        table.row(vec![
            with_unit(row.modulus, Dimension::Subgrade),
            with_unit(row.uplift, Dimension::Length),
            words::rotation(row.base_rotation),
            words::rotation(row.plastic_rotation),
            with_unit(row.toe_axial_stress, Dimension::Stress),
            with_unit(row.slip, Dimension::Length),
            with_unit(row.base_shear, Dimension::Force),
            row.spread.map_or(words::NONE.into(), |spread| words::spread(&spread)),
        ]);
    }
    table.caption = words::TABLES[1].into();
    table
}

fn energy(run: &BaseRun) -> Table {
    let e = &run.energy;
    let all = [e.input, e.viscous, e.base_elastic, e.base_hysteretic, e.anchors, e.base_radiated, e.friction, e.body];
    let scale = Scale::of(Dimension::Energy, all);
    let mut table = Table::new(columns![
        crate::words::labels::ENERGY_AT_END, "Value" => scale.symbol(), words::SHARE => "",
    ]);
    for (i, (label, value)) in words::ENERGIES.into_iter().zip(all).enumerate() {
        if i == ANCHORS && run.anchors.is_none() {
            continue;
        }
        let share = if e.input == 0.0 { words::NONE.into() } else { share(value / e.input) };
        table.row(vec![label.into(), scale.text(value), share]);
    }
    table.caption = words::TABLES[2].into();
    table
}

/// Curves over time; `None` without columns.
fn over_time(source: &Source, number: usize, channels: &[Channel]) -> Result<Option<Figure>, Error> {
    let id = channels.first().map_or(String::new(), |channel| format!("base_{}", channel.id()));
    let motion =
        Motion { id: &id, title: words::FIGURES[number], axis: words::AXES[number], channels, labels: words::SIDES };
    motion_of_base::over_time(source, &motion)
}

/// Moment against rotation, with the backbone on both sides.
fn turning(run: &BaseRun) -> Result<Figure, Error> {
    let mirrored = run.backbone.iter().rev().map(|p| (-p[0], -p[1]));
    let backbone: Vec<(f64, f64)> = mirrored.chain(run.backbone.iter().map(|p| (p[0], p[1]))).collect();
    let cycles: Vec<(f64, f64)> = run.cycles.iter().map(|p| (p[0], p[1])).collect();
    let both = || backbone.iter().chain(&cycles);
    let x = Axis::linear(words::AXES[1], Dimension::Angle, both().map(|p| p.0), 5);
    let y = Axis::linear(words::AXES[2], Dimension::Moment, both().map(|p| p.1), 5);
    let mut chart = Chart::new(HALF, x, y);
    let curves = [(cycles.clone(), "k-fe thin", words::LOOP[0]), (backbone.clone(), "k-other", words::LOOP[1])];
    for (points, class, label) in curves {
        chart.line(points, class, label);
    }
    let scale = Scale::of(Dimension::Moment, run.backbone.iter().map(|p| p[1]));
    let mut table = Table::new(columns![words::AXES[1] => "rad", words::LOOP[1] => scale.symbol()]);
    for i in spread(run.backbone.len(), 16) {
        table.row(vec![fixed(run.backbone[i][0], 6), scale.text(run.backbone[i][1])]);
    }
    let description = words::description(words::FIGURES[2], Dimension::Moment, cycles.iter().map(|p| p.1));
    let chart = chart.with_plot_height(PLOT);
    Ok(chart.figure("base_moment_rotation", words::FIGURES[2], table)?.described(description))
}

/// Uplift around the circumference.
fn around(run: &BaseRun) -> Result<Figure, Error> {
    let points: Vec<(f64, f64)> = run.around.iter().map(|p| (p[0].to_radians(), p[1])).collect();
    let x = Axis::around();
    let y = Axis::linear(words::AXES[0], Dimension::Length, points.iter().map(|p| p.1).chain([0.0]), 5);
    let mut chart = Chart::new(HALF, x, y);
    chart.line(points.clone(), "k-fe", "");
    let scale = Scale::of(Dimension::Length, points.iter().map(|p| p.1));
    let mut table = Table::new(columns!["θ" => "°", words::AXES[0] => scale.symbol()]);
    let uplifts: Vec<f64> = points.iter().map(|p| p.1).collect();
    for i in spread_with_extremes(run.around.len(), 25, &[&uplifts]) {
        table.row(vec![fixed(run.around[i][0], 0), scale.text(run.around[i][1])]);
    }
    let description = words::description(words::FIGURES[3], Dimension::Length, points.iter().map(|p| p.1));
    Ok(chart.with_plot_height(PLOT).figure("base_around", words::FIGURES[3], table)?.described(description))
}

/// Largest force of the anchors around the circumference, beside the force at which one yields; `None` without anchors.
fn bolts(run: &BaseRun) -> Result<Option<Figure>, Error> {
    let Some(anchors) = run.anchors.as_ref().filter(|a| !a.forces.is_empty()) else { return Ok(None) };
    // The rim is symmetric about the direction of the motion: places stand from 0 to 180°.
    let half = anchors.forces.iter().map(|p| (p[0], p[1]));
    let mirrored = anchors.forces.iter().rev().map(|p| (360.0 - p[0], p[1]));
    let points: Vec<(f64, f64)> = half.chain(mirrored).map(|(a, f)| (a.to_radians(), f)).collect();
    let yields = [(0.0, anchors.yield_force), (TAU, anchors.yield_force)];
    let forces = points.iter().chain(&yields).map(|p| p.1).chain([0.0]);
    let y = Axis::linear(words::AXES[4], Dimension::Force, forces, 5);
    let mut chart = Chart::new(HALF, Axis::around(), y);
    let lines = [(points.clone(), "k-fe"), (yields.to_vec(), "k-other")];
    for ((points, class), label) in lines.into_iter().zip(words::BOLTS) {
        chart.line(points, class, label);
    }
    let scale = Scale::of(Dimension::Force, anchors.forces.iter().map(|p| p[1]));
    let mut table = Table::new(columns!["θ" => "°", words::AXES[4] => scale.symbol()]);
    let values: Vec<f64> = anchors.forces.iter().map(|p| p[1]).collect();
    for i in spread_with_extremes(anchors.forces.len(), 25, &[&values]) {
        let [angle, force] = anchors.forces[i];
        table.row(vec![fixed(angle, 0), scale.text(force)]);
    }
    let description = words::description(words::FIGURES[6], Dimension::Force, points.iter().map(|p| p.1));
    Ok(Some(chart.with_plot_height(PLOT).figure("base_bolts", words::FIGURES[6], table)?.described(description)))
}
