//! The three-dimensional run: mesh, mode shapes, deformed shapes, maps of the wall, and the difference from the harmonic
//! engine.

use tank::Shape;
use tank::units::Dimension;

use super::{Section, Source, engine, overlay};
use crate::figure::perimeter::Perimeter;
use crate::figure::scene::{self, Face, Part};
use crate::figure::{Figure, map};
use crate::number::{Scale, count, fixed, percent, ratio, significant};
use crate::table::{Table, columns, spread};
use crate::words::figures::spatial as words;
use crate::words::{capital, labels};
use files::error::Error;
use results::{DeformedShape, EngineId, FE, Fields, Picture};

/// Part of the tank's largest dimension that the largest displacement drawn takes.
const SWING: f64 = 0.12;
/// Histories of both engines drawn over each other.
const OVERLAID: [overlay::Kind; 3] = [overlay::WAVE, overlay::BASE_SHEAR, overlay::BASE_MOMENT];

/// Makes the section.
pub(super) fn make(source: &Source) -> Result<Option<Section>, Error> {
    let results = source.results;
    let solid = results.beside(EngineId::Solid);
    let fields = solid.or(results.reference()).and_then(|fe| fe.fields.as_ref());
    if solid.is_none() && fields.is_none() {
        return Ok(None);
    }
    if fields.is_some_and(|fields| !sound(fields)) {
        return Err(Error::Report("fields: a face or a displacement without its node".into()));
    }
    let mut section = Section::new("spatial");
    section.set("difference", &difference(source));
    section.set("own_engine", &solid.is_some());
    if let Some(solid) = solid {
        engine::fill(&mut section, solid);
    }
    section.set_figures("overlays", overlays(source)?);
    let drawn = |draw: fn(&Fields) -> Vec<Figure>| fields.map_or(Vec::new(), draw);
    let round = matches!(results.tank.tank.shape, Shape::Cylinder { .. });
    let modes = |f: &Fields| numbered(&f.modes, |i, m| Some(mode(f, i, (m, round))));
    section.set_figures("mesh_figures", drawn(|f| vec![mesh(f)]));
    section.set_figures("mode_figures", fields.map_or(Vec::new(), modes));
    section.set_figures("moment_figures", drawn(|f| numbered(&f.moments, |i, m| Some(moment(f, i, m)))));
    let walls = match results.tank.tank.shape {
        Shape::Cylinder { .. } => None,
        Shape::Rectangle { length, breadth, .. } => Some(Perimeter { length: 0.5 * length, breadth: 0.5 * breadth }),
    };
    let maps = |f: &Fields| numbered(&f.maps, |i, m| map::figure(&format!("map_{}_{}", i + 1, m.id), m, walls));
    section.set_figures("map_figures", fields.map_or(Vec::new(), maps));
    Ok(Some(section))
}

/// Figures of a list, numbered from 0.
fn numbered<T>(list: &[T], draw: impl Fn(usize, &T) -> Option<Figure>) -> Vec<Figure> {
    list.iter().enumerate().filter_map(|(i, item)| draw(i, item)).collect()
}

/// Whether every face has its nodes and every displacement is one a node.
fn sound(fields: &Fields) -> bool {
    let nodes = fields.nodes.len();
    let shapes = fields.modes.iter().map(|m| &m.displacement);
    let mut shapes = shapes.chain(fields.moments.iter().map(|m| &m.displacement));
    fields.wall.iter().chain(&fields.surface).flatten().all(|&i| i < nodes) && shapes.all(|d| d.len() == nodes)
}

/// Quantities of both engines with their difference and the estimated error of the spatial mesh.
fn difference(source: &Source) -> Table {
    let results = source.results;
    let column = |id: &str| results.methods.iter().position(|m| m.id == id);
    let (Some(harmonic), Some(solid)) = (column(FE), column(EngineId::Solid.beside())) else { return Table::default() };
    let error = |id: &str| results.beside(EngineId::Solid).and_then(|fe| fe.mesh_error.get(id));
    let mut table = Table::new(columns![
        "Quantity", "Unit", "Harmonic" => "", "Three-dimensional" => "", "Difference" => "",
        labels::SPATIAL_MESH_ERROR => "",
    ]);
    for row in &results.comparison.rows {
        let cell = |i: usize| row.cells.get(i).copied().flatten();
        let (Some(a), Some(b)) = (cell(harmonic), cell(solid)) else { continue };
        let scale = Scale::of(row.dimension, [a.value, b.value]);
        table.row(vec![
            row.title.clone(),
            scale.symbol().into(),
            scale.text(a.value),
            scale.text(b.value),
            b.ratio.map_or("–".into(), |r| signed(r - 1.0)),
            error(&row.quantity).map_or("–".into(), |e| percent(*e)),
        ]);
    }
    table
}

/// A relative difference with its sign, in percent.
fn signed(difference: f64) -> String {
    let text = format!("{}\u{a0}%", fixed(100.0 * difference, 2));
    if difference > 0.0 { format!("+{text}") } else { text }
}

/// Histories of both engines.
fn overlays(source: &Source) -> Result<Vec<Figure>, Error> {
    let (Some(fe), Some(_)) = (source.results.reference(), source.results.beside(EngineId::Solid)) else {
        return Ok(Vec::new());
    };
    let second = overlay::Second {
        prefix: EngineId::Solid.prefix(),
        id: "both",
        title: "both engines",
        class: "k-fe-solid hist",
        names: ["harmonic", "three-dimensional"],
        rules: &[],
    };
    overlay::overlays(source, &fe.histories, &OVERLAID, &second)
}

/// Faces with the displacements of wall and surface multiplied by a factor each.
fn faces(fields: &Fields, displacement: Option<&[[f64; 3]]>, wall: f64, surface: f64) -> Vec<Face> {
    let moved = |i: usize, factor: f64| {
        let (p, u) = (fields.nodes[i], displacement.map_or([0.0; 3], |d| d[i]));
        [0, 1, 2].map(|k| p[k] + factor * u[k])
    };
    let part = |list: &[[usize; 4]], part: Part, factor: f64| -> Vec<Face> {
        let face = |f: &[usize; 4]| Face { corners: f.map(|i| moved(i, factor)), part };
        list.iter().map(face).collect()
    };
    let mut all = part(&fields.wall, Part::Wall, wall);
    all.extend(part(&fields.surface, Part::Surface, surface));
    all
}

/// The undeformed tank as lines: rims of wall and surface, contours of the wall.
fn ghost(fields: &Fields) -> Vec<Vec<[f64; 3]>> {
    let mut edges = scene::rims(&fields.wall);
    edges.extend(scene::rims(&fields.surface));
    edges.extend(scene::contours(&fields.nodes, &fields.wall));
    edges.iter().map(|e| e.map(|i| fields.nodes[i]).to_vec()).collect()
}

/// Largest dimension of the tank [m].
fn dimension(fields: &Fields) -> f64 {
    (0..3)
        .map(|k| {
            let values = fields.nodes.iter().map(|p| p[k]);
            let (low, high) = values.fold((f64::INFINITY, f64::NEG_INFINITY), |(l, h), v| (l.min(v), h.max(v)));
            high - low
        })
        .fold(0.0, f64::max)
}

/// Largest displacement of the nodes that these faces use.
fn largest(faces: &[[usize; 4]], displacement: &[[f64; 3]]) -> f64 {
    let length = |i: &usize| displacement[*i].iter().map(|u| u * u).sum::<f64>().sqrt();
    faces.iter().flatten().map(length).fold(0.0, f64::max)
}

fn mesh(fields: &Fields) -> Figure {
    let (size, markup) = scene::draw(&faces(fields, None, 0.0, 0.0), &[], &[]);
    let mut table = Table::new(columns!["Drawn", "Number" => ""]);
    let numbers = [fields.nodes.len(), fields.wall.len(), fields.surface.len()];
    for (label, number) in labels::MESH.into_iter().zip(numbers) {
        table.row(vec![label.into(), count(number)]);
    }
    Figure::new("mesh_spatial", words::MESH, (size, markup), table)
        .described(words::mesh(&scene::eye(), [fields.wall.len(), fields.surface.len()]))
}

fn mode(fields: &Fields, index: usize, (mode, round): (&Picture, bool)) -> Figure {
    let unit = largest(&fields.wall, &mode.displacement).max(largest(&fields.surface, &mode.displacement));
    let factor = SWING * dimension(fields) / unit.max(f64::MIN_POSITIVE);
    let (size, markup) =
        scene::draw(&faces(fields, Some(&mode.displacement), factor, factor), &ghost(fields), &fields.nodes);
    let frequency = mode.omega / std::f64::consts::TAU;
    Figure::new(
        format!("mode_spatial_{}", index + 1),
        capital(&mode.title),
        (size, markup),
        displacements(fields, &mode.displacement, None),
    )
    .captioned(format!("{} Hz.", significant(frequency, 4)))
    .described(words::mode(
        frequency,
        round.then_some(mode.circumferential),
        &scene::eye(),
        [&fields.wall, &fields.surface].map(|f| largest(f, &mode.displacement) / unit.max(f64::MIN_POSITIVE)),
    ))
}

fn moment(fields: &Fields, index: usize, moment: &DeformedShape) -> Figure {
    // Walls move by millimetres where waves rise by decimetres: each has its own round factor.
    let factor = |part: &[[usize; 4]]| {
        let most = largest(part, &moment.displacement);
        scene::round_down(SWING * dimension(fields) / most.max(f64::MIN_POSITIVE))
    };
    let (wall, surface) = (factor(&fields.wall), factor(&fields.surface));
    let (size, markup) =
        scene::draw(&faces(fields, Some(&moment.displacement), wall, surface), &ghost(fields), &fields.nodes);
    let factors = words::factors(&factor_text(wall), &factor_text(surface));
    Figure::new(
        format!("moment_{}", index + 1),
        format!("{}, t = {} s", capital(&moment.title), fixed(moment.time, 3)),
        (size, markup),
        displacements(fields, &moment.displacement, Some(Dimension::Length)),
    )
    .captioned(words::moment(&factors))
    .described(words::moment_description(
        &scene::eye(),
        &factors,
        [&fields.wall, &fields.surface].map(|f| largest(f, &moment.displacement)),
    ))
}

/// A round factor without idle digits.
fn factor_text(factor: f64) -> String {
    if factor >= 10.0 {
        count(factor.round() as usize)
    } else {
        ratio(factor).trim_end_matches('0').trim_end_matches('.').into()
    }
}

/// Displacements of some nodes; without a dimension they are relative.
fn displacements(fields: &Fields, displacement: &[[f64; 3]], dimension: Option<Dimension>) -> Table {
    let scale = Scale::of(dimension.unwrap_or(Dimension::Dimensionless), displacement.iter().flatten().copied());
    let mut table = Table::new(columns![
        "x" => "m", "y" => "m", "z" => "m", "u_x" => scale.symbol(), "u_y" => scale.symbol(), "u_z" => scale.symbol(),
    ]);
    for i in spread(fields.nodes.len(), 24) {
        let place = fields.nodes[i].map(|x| fixed(x, 3));
        let moved = displacement[i].map(|u| scale.text(u));
        table.row(place.into_iter().chain(moved).collect());
    }
    table
}
