//! The tank: the input as a datasheet, courses, masses, deformability.

use serde::Serialize;
use tank::units::Dimension;
use tank::{BarDirection, LayerKind, Shape, Support};

use super::{Section, Source, datasheet};
use crate::figure::{Figure, sketch};
use crate::level::Level;
use crate::number::{Scale, plain, significant};
use crate::table::{Table, columns};
use crate::words::labels::tank as words;
use crate::words::sections::deformability;
use crate::words::{capital, figures};
use files::error::Error;
use results::TankSummary;

#[derive(Serialize)]
struct Deformability {
    parameter: String,
    note: String,
}

/// The sketch to scale, for the cover.
pub(crate) fn sketch(summary: &TankSummary) -> Figure {
    let (size, markup, exaggeration) = sketch::draw(summary);
    let (plan, support) = (plan(summary.tank.shape), support(summary.tank.support));
    Figure::new("sketch", "Tank", (size, markup), courses(summary))
        .captioned(figures::sketch(exaggeration, summary.tank.staging.is_some()))
        .described(figures::sketch_description(plan, support, &summary.tank, &summary.liquid))
}

fn plan(shape: Shape) -> &'static str {
    match shape {
        Shape::Cylinder { .. } => "upright cylinder",
        Shape::Rectangle { strip: true, .. } => words::STRIP,
        Shape::Rectangle { .. } => "rectangle",
    }
}

fn support(support: Support) -> &'static str {
    match support {
        Support::Anchored => "anchored",
        Support::Unanchored => words::ON_GROUND,
    }
}

/// Makes the section.
pub(super) fn make(source: &Source) -> Result<Option<Section>, Error> {
    let mut section = of(&source.results.tank, source.level == Level::Full);
    let courses = datasheet::courses(source.results);
    section.set("groups", &datasheet::groups(source.results));
    section.set("forces", &courses.is_some());
    if let Some(table) = courses {
        section.set("courses", &table);
    }
    section.set_figures("figures", datasheet::hoop(source)?.into_iter().collect());
    let sketch = super::summary::crowded(source.results).then(|| sketch(&source.results.tank));
    section.set_figures("sketch", sketch.into_iter().collect());
    Ok(Some(section))
}

/// The section of a tank.
///
/// * `full`: whether there are parameters on which nothing rests
pub(crate) fn of(summary: &TankSummary, full: bool) -> Section {
    let tank = &summary.tank;
    let mut section = Section::new("tank");
    let (plan, support) = (plan(tank.shape), support(tank.support));
    let mut facts = Table::new(columns!["Property", "Value" => "", "Unit"]);
    let mut fact = |label: &str, value: f64, dimension| {
        let scale = Scale::of(dimension, [value]);
        facts.row(vec![label.into(), scale.given(value), scale.symbol().into()]);
    };
    fact("Liquid mass", summary.liquid_mass, Dimension::Mass);
    fact("Liquid density", summary.liquid.density, Dimension::Density);
    fact("Wall mass", summary.wall_mass, Dimension::Mass);
    if tank.insulation.is_some() {
        fact(words::INSULATION, tank.insulation_mass(), Dimension::Mass);
    }
    if tank.roof.mass > 0.0 {
        fact("Roof mass", tank.roof.mass, Dimension::Mass);
        if let Some(snow) = tank.roof.snow.filter(|snow| snow.mass > 0.0) {
            fact(words::SNOW_MASS, snow.mass, Dimension::Mass);
        }
        if tank.roof.on_columns > 0.0 {
            fact(words::ROOF_ON_WALL, tank.roof.on_wall(), Dimension::Mass);
        }
        fact(words::ROOF_HEIGHT, tank.roof_height(), Dimension::Length);
    }
    if tank.roof.afloat > 0.0 {
        fact(words::FLOATING_ROOF, tank.roof.afloat, Dimension::Mass);
    }
    fact("Freeboard", tank.wall_height() - summary.liquid.fill_height - tank.roof.rim, Dimension::Length);
    if let Some(parameter) = &summary.deformability {
        fact(words::DEFORMABILITY, parameter.corrected, Dimension::Dimensionless);
    }
    fact(words::GRAVITY, summary.gravity, Dimension::Acceleration);
    if let Some(bottom) = &tank.bottom {
        fact(words::BOTTOM_PLATE, bottom.thickness, Dimension::Length);
    }
    if let Some(anchors) = &tank.anchors {
        fact(words::ANCHORS, f64::from(anchors.count), Dimension::Dimensionless);
        if let Some(capacity) = anchors.capacity {
            fact(words::ANCHOR_CAPACITY, capacity, Dimension::Force);
        }
    }
    facts.caption = words::MASSES.into();
    section.set("plan", &capital(plan));
    section.set("support", support);
    section.set("facts", &facts);
    section.set("courses", &courses(summary));
    section.set("forces", &false);
    section.set("groups", &[(); 0]);
    for figures in ["figures", "sketch"] {
        section.set_figures(figures, Vec::new());
    }
    let mut more = layers(summary);
    more.extend(carried(summary));
    section.set("layers", &more);
    let parameter: Vec<Deformability> = summary
        .deformability
        .iter()
        .filter(|_| full)
        .map(|d| Deformability {
            parameter: deformability(&significant(d.as_printed, 4), &significant(d.corrected, 4)),
            note: d.note.clone(),
        })
        .collect();
    section.set("deformability", &parameter);
    section
}

fn courses(summary: &TankSummary) -> Table {
    let courses = &summary.tank.courses;
    let height = Scale::of(Dimension::Length, courses.iter().map(|c| c.height));
    let thickness = Scale::of(Dimension::Length, courses.iter().map(|c| c.thickness));
    let modulus = Scale::of(Dimension::Stress, courses.iter().map(|c| c.material.youngs_modulus));
    let density = Scale::of(Dimension::Density, courses.iter().map(|c| c.material.density));
    // Without any, the unit of those of metals.
    const USUAL: f64 = 200e6;
    let yields: Vec<f64> = courses.iter().filter_map(|c| c.material.yield_strength).collect();
    let strength = match yields.as_slice() {
        [] => Scale::of(Dimension::Stress, [USUAL]),
        some => Scale::of(Dimension::Stress, some.iter().copied()),
    };
    let mut table = Table::new(columns![
        "Course" => "", "Height" => height.symbol(), "Thickness" => thickness.symbol(), "Material",
        "Young’s modulus" => modulus.symbol(), "Poisson’s ratio" => "", "Density" => density.symbol(),
        "Yield strength" => strength.symbol(),
    ]);
    for (i, c) in courses.iter().enumerate() {
        table.row(vec![
            format!("{}", i + 1),
            height.given(c.height),
            thickness.given(c.thickness),
            c.material.name.clone(),
            modulus.given(c.material.youngs_modulus),
            plain(c.material.poisson_ratio, 3),
            density.given(c.material.density),
            c.material.yield_strength.map_or("–".into(), |f| strength.given(f)),
        ]);
    }
    table.caption = words::COURSES.into();
    table
}

/// Rings and attachments; no table without them.
fn carried(summary: &TankSummary) -> Option<Table> {
    let tank = &summary.tank;
    if tank.rings.is_empty() && tank.attachments.is_empty() {
        return None;
    }
    let height = Scale::of(Dimension::Length, tank.carried().map(|(_, z)| z));
    let mass = Scale::of(Dimension::Mass, tank.carried().map(|(mass, _)| mass));
    let area = Scale::of(Dimension::Area, tank.rings.iter().map(|ring| ring.area));
    let inertia = Scale::of(Dimension::SecondMoment, tank.rings.iter().map(|ring| ring.inertia));
    let mut table = Table::new(columns![
        words::COMPONENT, "Height" => height.symbol(), "Mass" => mass.symbol(), "A" => area.symbol(), "I" => inertia.symbol(), "Material",
    ]);
    let mut masses = tank.carried();
    for (ring, (own, z)) in tank.rings.iter().zip(masses.by_ref()) {
        table.row(vec![
            words::RING.into(),
            height.given(z),
            mass.text(own),
            area.given(ring.area),
            inertia.given(ring.inertia),
            ring.material.name.clone(),
        ]);
    }
    for (one, (own, z)) in tank.attachments.iter().zip(masses) {
        let dash = || "–".to_owned();
        table.row(vec![one.name.clone(), height.given(z), mass.given(own), dash(), dash(), dash()]);
    }
    table.caption = words::CARRIED.into();
    Some(table)
}

/// Layers and bars of layered courses: no table, or one or two.
fn layers(summary: &TankSummary) -> Vec<Table> {
    let courses = &summary.tank.courses;
    let all = || {
        let courses = courses.iter().enumerate();
        courses.flat_map(|(i, c)| c.layers.iter().enumerate().map(move |(j, l)| (i + 1, j + 1, l)))
    };
    let thickness = Scale::of(Dimension::Length, all().map(|(_, _, l)| l.thickness));
    let modulus = Scale::of(Dimension::Stress, all().map(|(_, _, l)| l.material.youngs_modulus));
    let density = Scale::of(Dimension::Density, all().map(|(_, _, l)| l.material.density));
    let mut table = Table::new(columns![
        "Course" => "", "Layer" => "", "Kind", "Thickness" => thickness.symbol(), "Material", "Behaviour",
        "Modulus" => modulus.symbol(), "Density" => density.symbol(),
    ]);
    for (course, layer, l) in all() {
        table.row(vec![
            course.to_string(),
            layer.to_string(),
            match l.kind {
                LayerKind::Shell => "shell".into(),
                LayerKind::Interlayer => "interlayer".into(),
            },
            thickness.given(l.thickness),
            l.material.name.clone(),
            l.material.behaviour.kind().into(),
            modulus.given(l.material.youngs_modulus),
            density.given(l.material.density),
        ]);
    }
    table.caption = words::LAYERS.into();
    let bars = || all().flat_map(|(i, j, l)| l.reinforcement.iter().map(move |b| (i, j, b)));
    let area = Scale::of(Dimension::LineArea, bars().map(|(_, _, b)| b.area));
    let depth = Scale::of(Dimension::Length, bars().map(|(_, _, b)| b.depth));
    let mut steel = Table::new(columns![
        "Course" => "", "Layer" => "", "Direction", "Area" => area.symbol(), words::BAR_DEPTH => depth.symbol(),
        "Material",
    ]);
    for (course, layer, b) in bars() {
        steel.row(vec![
            course.to_string(),
            layer.to_string(),
            match b.direction {
                BarDirection::Hoop => "hoop".into(),
                BarDirection::Vertical => "vertical".into(),
            },
            area.given(b.area),
            depth.given(b.depth),
            b.material.name.clone(),
        ]);
    }
    steel.caption = words::BARS.into();
    let mut tables = Vec::new();
    tables.extend(all().next().map(|_| table));
    tables.extend(bars().next().map(|_| steel));
    tables
}
