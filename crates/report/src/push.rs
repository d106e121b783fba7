//! The page of a pushover.

use tank::units::Dimension;
use tera::Context;

use super::Report;
use super::sections::{self, FigureView};
use super::template::Templates;
use crate::figure::chart::{Axis, Chart};
use crate::figure::{Figure, HALF, map};
use crate::frame::{self, Body, Cover, Page, Pair, Verdict};
use crate::number::{Scale, fixed, significant, with_unit};
use crate::style;
use crate::table::{Table, columns, spread};
use crate::words::capital;
use crate::words::push::{self as words, heads, shell_name};
use crate::words::sections::{heading, sentences};
use files::error::Error;
use results::{Push, PushBase, PushPoint, PushShell, PushStrip};

/// States in the table of the base.
const BASE_STATES: usize = 25;
/// Classes of the curves of the perfect and the imperfect shell.
const CLASSES: [&str; 2] = ["k-fe", "k-s2"];

/// The capacities, one line a shell.
pub fn summary(push: &Push) -> Table {
    let of = |dimension, value: fn(&PushShell) -> f64| Scale::of(dimension, push.shells.iter().map(value));
    let shear = of(Dimension::Force, |s| s.capacity.state.base_shear);
    let moment = of(Dimension::Moment, |s| s.capacity.state.base_moment);
    let stress = of(Dimension::Stress, |s| s.capacity.beam);
    let hoop = of(Dimension::Stress, |s| s.capacity.hoop);
    let pressure = of(Dimension::Stress, |s| s.capacity.pressure);
    let mut table = Table::new(columns![
        "Shell", "Capacity", "Base shear" => shear.symbol(), "Overturning moment" => moment.symbol(),
        "Buckle at" => "m", heads::ANGLE => "°", heads::COMPRESSION => stress.symbol(), heads::BEAM => stress.symbol(),
        "Hoop stress" => hoop.symbol(), "Pressure" => pressure.symbol(), "Plastic strain" => "%",
    ]);
    for shell in &push.shells {
        let c = &shell.capacity;
        table.row(vec![
            shell_name(shell),
            format!("{}{} g", if c.limit { "" } else { "≥ " }, significant(c.state.acceleration / push.gravity, 3)),
            shear.text(c.state.base_shear),
            moment.text(c.state.base_moment),
            fixed(c.height, 2),
            fixed(c.angle.to_degrees(), 0),
            stress.text(c.compression),
            stress.text(c.beam),
            hoop.text(c.hoop),
            pressure.text(c.pressure),
            fixed(100.0 * c.state.plastic_strain, 2),
        ]);
    }
    table
}

/// The base of an unanchored tank along the path of the perfect shell; `None` of an anchored one.
pub fn base(push: &Push) -> Option<Table> {
    let states: Vec<(f64, PushBase)> =
        push.shells.first()?.path.iter().filter_map(|p| Some((p.acceleration / push.gravity, p.base?))).collect();
    if states.is_empty() {
        return None;
    }
    let moment = Scale::of(Dimension::Moment, states.iter().map(|s| s.1.moment));
    let mut table = Table::new(columns![
        "Acceleration" => "g", "Rotation" => "mrad", "Moment" => moment.symbol(), heads::STRIPS => moment.symbol(),
        "Uplift" => "mm", "Toe" => "mm", "Lifted width" => "m", "Lifted angle" => "°", "Plastic rotation" => "rad",
    ]);
    for i in spread(states.len(), BASE_STATES) {
        let (acceleration, base) = &states[i];
        table.row(vec![
            significant(*acceleration, 3),
            fixed(1e3 * base.rotation, 3),
            moment.text(base.moment),
            base.strips.map_or("–".into(), |m| moment.text(m)),
            fixed(1e3 * base.uplift, 1),
            fixed(-1e3 * base.toe, 1),
            fixed(base.lifted_width, 2),
            fixed(base.lifted_angle.to_degrees(), 0),
            fixed(base.joint_rotation(), 3),
        ]);
    }
    Some(table)
}

/// Shells beside strips at the same rotation and acceleration; `None` of an anchored tank.
pub fn strips(push: &Push) -> Option<Table> {
    let path = &push.shells.first()?.path;
    let states: Vec<(PushBase, PushStrip)> = path.iter().filter_map(|p| Some((p.base?, p.base?.strip?))).collect();
    if states.is_empty() {
        return None;
    }
    let stress = Scale::of(Dimension::Stress, states.iter().map(|s| s.0.toe_stress));
    let mut table = Table::new(columns![
        "Rotation" => "mrad", "Uplift" => "mm", heads::OF_STRIPS => "mm", "Toe stress" => stress.symbol(),
        heads::OF_STRIPS => stress.symbol(), heads::PLATE => "rad", heads::OF_STRIPS => "rad", heads::WALL => "rad",
    ]);
    for i in spread(states.len(), BASE_STATES) {
        let (base, strip) = &states[i];
        table.row(vec![
            fixed(1e3 * base.rotation, 3),
            fixed(1e3 * base.uplift, 1),
            fixed(1e3 * strip.uplift, 1),
            stress.text(base.toe_stress),
            stress.text(strip.toe_stress),
            fixed(base.plastic_rotation, 3),
            fixed(strip.plastic_rotation, 3),
            fixed(base.wall_rotation, 3),
        ]);
    }
    Some(table)
}

/// The formulas, one line each.
pub fn limits(push: &Push) -> Table {
    let stress = Scale::of(Dimension::Stress, push.limits.iter().map(|l| l.stress));
    let mut table = Table::new(columns!["Formula", "Source", "Reached at", "Course" => "", "Limit" => stress.symbol()]);
    for limit in &push.limits {
        table.row(vec![
            limit.name.clone(),
            limit.source.clone(),
            limit.acceleration.map_or("beyond 10 g".into(), |a| format!("{} g", significant(a / push.gravity, 3))),
            limit.course.to_string(),
            stress.text(limit.stress),
        ]);
    }
    table
}

/// The paths: head with units, one line a state.
pub fn csv(push: &Push) -> String {
    use std::fmt::Write;
    let mut text = String::from(
        "shell,acceleration_m_s2,base_shear_n,base_moment_nm,top_m,bulge_m,compression_pa,compression_height_m,plastic_strain,\
         base_rotation,ground_moment_nm,uplift_m,lifted_width_m,plastic_rotation,wall_rotation,toe_stress_pa\n",
    );
    for shell in &push.shells {
        for p in &shell.path {
            let _ = write!(
                text,
                "{},{:.6},{:.6e},{:.6e},{:.6e},{:.6e},{:.6e},{:.4},{:.6e}",
                shell_name(shell),
                p.acceleration,
                p.base_shear,
                p.base_moment,
                p.top,
                p.bulge,
                p.compression,
                p.compression_height,
                p.plastic_strain
            );
            // The columns of the base are empty for an anchored tank.
            let _ = match p.base {
                Some(b) => writeln!(
                    text,
                    ",{:.6e},{:.6e},{:.6e},{:.4},{:.6e},{:.6e},{:.6e}",
                    b.rotation, b.moment, b.uplift, b.lifted_width, b.plastic_rotation, b.wall_rotation, b.toe_stress
                ),
                None => writeln!(text, ",,,,,,,"),
            };
        }
    }
    text
}

fn zero_and(values: impl Iterator<Item = f64>) -> Vec<f64> {
    values.chain([0.0]).collect()
}

/// Acceleration over a quantity of the state.
fn path_figure(
    push: &Push,
    id: &str,
    title: &str,
    dimension: Dimension,
    value: fn(&PushPoint) -> f64,
) -> Result<Figure, Error> {
    let points = || push.shells.iter().flat_map(|s| &s.path);
    let g = push.gravity;
    let x = Axis::linear(title, dimension, zero_and(points().map(value)), 5);
    let y =
        Axis::linear("acceleration [g]", Dimension::Dimensionless, zero_and(points().map(|p| p.acceleration / g)), 6);
    let mut chart = Chart::new(HALF, x, y);
    let mut table = Table::new(columns!["Shell", "Acceleration" => "g", title]);
    for (shell, class) in push.shells.iter().zip(CLASSES.iter().cycle()) {
        // The capacity is in the legend: points of shells that are alike lie side by side, and their labels over each other.
        let path = shell.path.iter().map(|p| (value(p), p.acceleration / g));
        chart.line(path.collect(), *class, words::capacity(push, shell));
        let best = &shell.capacity.state;
        chart.mark((value(best), best.acceleration / g), "", *class);
        for i in spread(shell.path.len(), 12) {
            let p = &shell.path[i];
            table.row(vec![shell_name(shell), significant(p.acceleration / g, 4), with_unit(value(p), dimension)]);
        }
    }
    Ok(chart
        .with_plot_height(190.0)
        .figure(id, capital(title), table)?
        .captioned(words::PATH)
        .described(words::path(title)))
}

/// Deformed meridians of one shell near the base.
fn meridian_figure(push: &Push, number: usize, shell: &PushShell) -> Result<Figure, Error> {
    // Four times the lowest course, or the whole wall.
    let top = shell.meridians.first().map_or(0.0, |m| m.z.last().copied().unwrap_or(0.0));
    let part = (6.0 * shell.capacity.height).max(0.15 * top).min(top);
    let below = |z: f64| z <= part * (1.0 + 1e-9);
    let shown = || shell.meridians.iter().flat_map(|m| m.z.iter().zip(&m.w).filter(|(z, _)| below(**z)));
    let x = Axis::linear("radial displacement", Dimension::Length, zero_and(shown().map(|(_, w)| *w)), 5);
    let y = Axis::exact("height", Dimension::Length, (0.0, part), 6);
    let mut chart = Chart::new(HALF, x, y);
    let mut table = Table::new(columns!["State", "Height", "Radial displacement"]);
    for (meridian, class) in shell.meridians.iter().zip(["k-static", "k-fe", "k-s2"]) {
        let points: Vec<(f64, f64)> =
            meridian.z.iter().zip(&meridian.w).filter(|(z, _)| below(**z)).map(|(z, w)| (*w, *z)).collect();
        for i in spread(points.len(), 15) {
            table.row(vec![
                meridian.title.clone(),
                with_unit(points[i].1, Dimension::Length),
                with_unit(points[i].0, Dimension::Length),
            ]);
        }
        chart.line(
            points,
            class,
            format!("{}, {} g", meridian.title, significant(meridian.acceleration / push.gravity, 3)),
        );
    }
    Ok(chart
        .with_plot_height(240.0)
        .figure(format!("push_meridian_{number}"), words::meridian(shell), table)?
        .captioned(words::MERIDIAN)
        .described(words::MERIDIAN_DESCRIPTION))
}

/// The foot of an unanchored tank around half of the circumference, beside that of the strips.
fn foot_figure(number: usize, shell: &PushShell, gravity: f64) -> Result<Figure, Error> {
    let shown = || shell.feet.iter().flat_map(|foot| foot.w.iter().chain(&foot.strips));
    let x = Axis::exact(words::FOOT_AXES[0], Dimension::Dimensionless, (0.0, 180.0), 6);
    let y = Axis::linear(words::FOOT_AXES[1], Dimension::Length, zero_and(shown().copied()), 6);
    let mut chart = Chart::new(HALF, x, y);
    let mut table = Table::new(columns!["State", "Angle" => "°", "Uplift", words::OF_STRIPS]);
    let classes = [("k-static", "k-static"), ("k-fe", "k-s2"), ("k-s3", "k-s4")];
    for (foot, (own, strips)) in shell.feet.iter().zip(classes) {
        let degrees = || foot.theta.iter().map(|theta| theta.to_degrees());
        let state = format!("{}, {} g", foot.title, significant(foot.acceleration / gravity, 3));
        chart.line(degrees().zip(foot.w.iter().copied()).collect(), own, state.clone());
        if !foot.strips.is_empty() {
            chart.line(degrees().zip(foot.strips.iter().copied()).collect(), strips, words::strips_of(&state));
        }
        for i in spread(foot.w.len(), 13) {
            table.row(vec![
                foot.title.clone(),
                fixed(foot.theta[i].to_degrees(), 0),
                with_unit(foot.w[i], Dimension::Length),
                foot.strips.get(i).map_or("–".into(), |w| with_unit(*w, Dimension::Length)),
            ]);
        }
    }
    Ok(chart
        .with_plot_height(240.0)
        .figure(format!("push_foot_{number}"), words::foot(shell), table)?
        .captioned(words::FOOT)
        .described(words::FOOT_DESCRIPTION))
}

fn figures(push: &Push) -> Result<Vec<Figure>, Error> {
    let mut out = vec![
        path_figure(push, "push_bulge", words::BULGE, Dimension::Length, |p| p.bulge)?,
        path_figure(push, "push_compression", words::COMPRESSION, Dimension::Stress, |p| p.compression)?,
    ];
    for (number, shell) in push.shells.iter().enumerate() {
        out.push(meridian_figure(push, number, shell)?);
        if !shell.feet.is_empty() {
            out.push(foot_figure(number, shell, push.gravity)?);
        }
    }
    for (number, shell) in push.shells.iter().enumerate() {
        let deviation = shell.imperfection.as_ref().and_then(|i| i.map.as_ref());
        for (id, map) in [("push_imperfection", deviation), ("push_plastic", Some(&shell.plastic))] {
            if let Some(mut figure) = map.and_then(|m| map::figure(&format!("{id}_{number}"), m, None)) {
                figure.title = format!("{}, {}", figure.title, shell_name(shell));
                figure.caption = words::MAP.into();
                out.push(figure);
            }
        }
    }
    Ok(out)
}

/// The first page.
fn cover(push: &Push) -> Cover {
    let mut facts = push.tank.as_ref().map_or_else(Vec::new, frame::tank);
    facts.extend(words::facts(push).into_iter().map(|(l, v)| Pair::new(l, v)));
    let sketch = push.tank.as_ref().map(|tank| FigureView::of(&sections::sketch(tank)));
    Cover {
        name: push.name.clone(),
        subtitle: heading("push").into(),
        project: frame::document(push.project.as_ref()),
        signatures: frame::signatures(push.project.as_ref()),
        verdict: Verdict {
            class: if push.incomplete { "fail" } else { "none" },
            sign: if push.incomplete { "✗" } else { "–" },
            headline: words::headline(push),
            lines: words::lines(push),
        },
        warnings: push.doubts.iter().map(|doubt| doubt.to_string()).collect(),
        facts,
        sketch: sketch.into_iter().collect(),
    }
}

/// The page with its figures.
///
/// Errors: a template or a drawing that fails.
pub fn report(push: &Push) -> Result<Report, Error> {
    let _style = style::of(push.project.as_ref());
    let figures = figures(push)?;
    let templates = Templates::new(None)?;
    let css = format!("{}{}", templates.css("figure.css"), templates.css("fields.css"));
    let views: Vec<FigureView> = figures.iter().map(FigureView::of).collect();
    let ends: Vec<String> = push.shells.iter().map(words::end).collect();
    let base = base(push);
    let mut context = Context::new();
    context.insert("words", &sentences("push"));
    context.insert("summary", &summary(push));
    context.insert("base", &base);
    context.insert("strips", &strips(push));
    let joint = push.joint.as_ref().map(|j| capital(&words::joint(j, push.gravity)));
    context.insert("joint", &joint);
    context.insert("limits", &limits(push));
    context.insert("ends", &ends);
    context.insert("model", &super::facts(&push.model));
    context.insert("assumptions", &push.assumptions);
    context.insert("figures", &views);
    let mut body = Body::new(&templates, cover(push), push.tank.as_ref())?;
    for part in words::PARTS {
        if part.0 != "base" || base.is_some() {
            body.part("push.html", part, &mut context)?;
        }
    }
    body.provenance(&push.files, &push.format, &push.volatile)?;
    let project = push.project.as_ref();
    let page = Page { name: &push.name, running: "pushover", project, parts: &body.parts, css: &css };
    Report::of(&page, body.figures.iter().chain(&figures), &templates)
}
