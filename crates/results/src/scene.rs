//! `scene.json`: what a three-dimensional viewer plays, from [`Snapshots`].
//!
//! ```text
//! nodes          f32, x y z of each [m]                 parts    u32, four nodes a cell: wall, surface, bottom, sides
//! displacement   i16, frames × nodes × 3                fields   i16, frames × nodes or frames × cells of their part
//! value          stored number · scale[frame]           modes    f32, nodes × 3, the longest displacement 1
//! ```
//!
//! All arrays are base64 of little-endian numbers, all units SI. The nodes are those of the parts, without the inside of the liquid; a half tank is
//! mirrored. The wave height is the vertical displacement of the surface; nodes of the surface alone have a scale of their own, since a wave may be a
//! thousand times as high as the wall moves. Frames that do not fit into [`MOST`] bytes are left out evenly, but for
//! those in which a displacement or a field is largest and those about the largest displacement of the wall.

mod mirror;

use std::fs::File;
use std::io::{BufWriter, Write};
use std::path::Path;

use files::error::{Error, describe};
use serde::Serialize;
use tank::Shape;

use super::base64::base64;
use super::{EngineId, Resultants, Snapshot, Snapshots, TankSummary};

/// Name of the file in a results folder.
pub const FILE: &str = "scene.json";
/// Format of the file.
pub const FORMAT: &str = "tankcheck-scene/2";
/// Bytes of the file, about.
pub const MOST: usize = 24_000_000;
/// Largest stored number.
const FULL: f64 = 32767.0;

/// Writes the scene of a run into an existing folder.
///
/// Errors: a file that cannot be written.
pub fn write(folder: &Path, tank: &TankSummary, (engine, snapshots): (EngineId, &Snapshots)) -> Result<(), Error> {
    let path = folder.join(FILE);
    let unwritten = |e: std::io::Error| Error::Unwritten { path: path.clone(), what: describe(&e) };
    // Straight into the file: its text would be there twice.
    let mut file = BufWriter::new(File::create(&path).map_err(unwritten)?);
    serde_json::to_writer(&mut file, &scene(tank, engine, snapshots, MOST)).map_err(|e| unwritten(e.into()))?;
    file.write_all(b"\n").and_then(|()| file.flush()).map_err(unwritten)
}

/// The document.
#[derive(Serialize)]
struct Scene {
    format: &'static str,
    engine: EngineId,
    length: Lengths,
    nodes: String,
    parts: Vec<Cells>,
    frames: Frames,
    times: Vec<f64>,
    scale: Vec<f64>,
    /// The same of the nodes that no other part than the surface has.
    #[serde(skip_serializing_if = "Vec::is_empty")]
    surface_scale: Vec<f64>,
    displacement: String,
    fields: Vec<Field>,
    modes: Vec<Shown>,
}

/// Main dimensions [m].
#[derive(Serialize)]
struct Lengths {
    #[serde(skip_serializing_if = "Option::is_none")]
    radius: Option<f64>,
    #[serde(skip_serializing_if = "Option::is_none")]
    length: Option<f64>,
    #[serde(skip_serializing_if = "Option::is_none")]
    breadth: Option<f64>,
    height: f64,
    fill: f64,
}

/// What was left out.
#[derive(Serialize)]
struct Frames {
    /// Every how many states there is a frame: 1 where none is left out, else a mean of those that are not about the largest displacement.
    kept_every: f64,
    /// States of the run.
    states: usize,
}

#[derive(Serialize)]
struct Cells {
    id: &'static str,
    cells: String,
    per_cell: usize,
}

#[derive(Serialize)]
struct Field {
    id: &'static str,
    title: &'static str,
    unit: &'static str,
    part: &'static str,
    at: &'static str,
    scale: Vec<f64>,
    values: String,
}

#[derive(Serialize)]
struct Shown {
    title: String,
    frequency: f64,
    displacement: String,
}

/// A field of the states.
struct Source {
    id: &'static str,
    /// Title of seismic values and of whole ones.
    title: [&'static str; 2],
    unit: &'static str,
    part: &'static str,
    of: fn(&Snapshots, &Snapshot) -> Vec<f64>,
}

/// A stress from the resultants of each quadrilateral of the wall and its thickness.
fn stress(all: &Snapshots, state: &Snapshot, of: fn(&Resultants, f64) -> f64) -> Vec<f64> {
    state.resultants.iter().zip(&all.thickness).map(|(r, t)| of(r, *t)).collect()
}

/// Fields of a cylinder.
const ROUND: [Source; 2] = [
    Source {
        id: "hoop_stress",
        title: ["Seismic hoop stress", "Hoop stress with the static state"],
        unit: "Pa",
        part: "wall",
        of: |all, state| stress(all, state, |r, t| r.n_phi / t),
    },
    Source {
        id: "axial_stress",
        title: ["Seismic axial membrane stress", "Axial membrane stress with the static state"],
        unit: "Pa",
        part: "wall",
        of: |all, state| stress(all, state, |r, t| r.n_v / t),
    },
];

/// Fields of plane walls.
const PLANE: [Source; 2] = [
    Source {
        id: "bending_stress",
        title: [
            "Seismic vertical bending stress, outer face",
            "Vertical bending stress with the static state, outer face",
        ],
        unit: "Pa",
        part: "wall",
        of: |all, state| stress(all, state, |r, t| 6.0 * r.m_v / (t * t)),
    },
    Source {
        id: "horizontal_bending_stress",
        title: [
            "Seismic horizontal bending stress, outer face",
            "Horizontal bending stress with the static state, outer face",
        ],
        unit: "Pa",
        part: "wall",
        of: |all, state| stress(all, state, |r, t| 6.0 * r.m_phi / (t * t)),
    },
];

/// Fields of all tanks.
const ALL: [Source; 3] = [
    Source {
        id: "pressure",
        title: ["Seismic pressure on the wall"; 2],
        unit: "Pa",
        part: "wall",
        of: |_, state| state.on_wall.clone(),
    },
    Source {
        id: "crack_opening",
        title: ["Opening strain of the widest crack"; 2],
        unit: "1",
        part: "wall",
        of: |_, state| state.cracks.clone(),
    },
    Source {
        id: "ground_pressure",
        title: ["Pressure of the ground under the bottom"; 2],
        unit: "Pa",
        part: "bottom",
        of: |all, state| {
            let at = |node: usize| state.ground.get(node).copied().unwrap_or(0.0);
            all.bottom.iter().map(|cell| 0.25 * cell.iter().map(|node| at(*node)).sum::<f64>()).collect()
        },
    },
];

/// A field that a run has.
struct Found<'a> {
    source: &'a Source,
    /// Number of its cells.
    cells: usize,
    /// State in which it is largest.
    peak: usize,
}

fn scene(tank: &TankSummary, engine: EngineId, snapshots: &Snapshots, most: usize) -> Scene {
    let whole = mirror::whole(snapshots);
    let snapshots = whole.as_ref().unwrap_or(snapshots);
    let nodes = used(snapshots);
    let shell: &[Source] = if matches!(tank.tank.shape, Shape::Cylinder { .. }) { &ROUND } else { &PLANE };
    let found: Vec<Found<'_>> = shell.iter().chain(&ALL).filter_map(|source| field(source, snapshots)).collect();
    let (kept_every, kept) = kept(snapshots, &nodes, &found, most);
    let fields = found.iter().map(|Found { source, .. }| {
        let (scale, values) = coded(&kept, |i, frame| frame.extend((source.of)(snapshots, &snapshots.states[i])));
        let title = source.title[usize::from(snapshots.whole)];
        Field { id: source.id, title, unit: source.unit, part: source.part, at: "cell", scale, values }
    });
    let fields = fields.collect();
    let fixed = used(&Snapshots { surface: Vec::new(), ..meshes(snapshots) });
    let apart: Vec<bool> = nodes.iter().map(|n| fixed.binary_search(n).is_err()).collect();
    let group = |number: usize| usize::from(apart[number / 3]);
    let ([scale, mut surface_scale], displacement) = grouped(&kept, group, |i, frame| {
        let own = &snapshots.states[i].displacement;
        nodes.iter().for_each(|&n| frame.extend_from_slice(&own[n]));
    });
    if !apart.contains(&true) {
        surface_scale.clear();
    }
    let single = |points: &[[f64; 3]]| floats(nodes.iter().flat_map(|&n| points[n]));
    let parts = [
        ("wall", &snapshots.wall),
        ("surface", &snapshots.surface),
        ("bottom", &snapshots.bottom),
        ("sides", &snapshots.sides),
    ];
    let of_part =
        |(id, cells): (&'static str, &Vec<[usize; 4]>)| Cells { id, cells: places(&nodes, cells), per_cell: 4 };
    let modes = snapshots.modes.iter().map(|mode| Shown {
        title: mode.title.clone(),
        frequency: mode.frequency,
        displacement: single(&mode.displacement),
    });
    Scene {
        format: FORMAT,
        engine,
        length: lengths(tank),
        nodes: single(&snapshots.nodes),
        parts: parts.into_iter().filter(|(_, cells)| !cells.is_empty()).map(of_part).collect(),
        frames: Frames { kept_every, states: snapshots.states.len() },
        times: kept.iter().map(|&i| snapshots.states[i].time).collect(),
        scale,
        surface_scale,
        displacement,
        fields,
        modes: modes.collect(),
    }
}

fn lengths(tank: &TankSummary) -> Lengths {
    let (radius, sides) = match tank.tank.shape {
        Shape::Cylinder { radius } => (Some(radius), None),
        Shape::Rectangle { length, breadth, .. } => (None, Some((length, breadth))),
    };
    let (length, breadth) = sides.unzip();
    Lengths { radius, length, breadth, height: tank.tank.wall_height(), fill: tank.liquid.fill_height }
}

/// The cells alone.
fn meshes(of: &Snapshots) -> Snapshots {
    let Snapshots { wall, surface, bottom, sides, .. } = of;
    let (wall, surface, bottom, sides) = (wall.clone(), surface.clone(), bottom.clone(), sides.clone());
    Snapshots { wall, surface, bottom, sides, ..Snapshots::default() }
}

/// Nodes of the parts, ascending.
fn used(snapshots: &Snapshots) -> Vec<usize> {
    let cells = snapshots.wall.iter().chain(&snapshots.surface).chain(&snapshots.bottom).chain(&snapshots.sides);
    let mut nodes: Vec<usize> = cells.flatten().copied().collect();
    nodes.sort_unstable();
    nodes.dedup();
    nodes
}

/// Cells by the places of their nodes among `nodes`.
fn places(nodes: &[usize], cells: &[[usize; 4]]) -> String {
    let place = |node: &usize| nodes.partition_point(|n| n < node) as u32;
    let bytes: Vec<u8> = cells.iter().flatten().flat_map(|node| place(node).to_le_bytes()).collect();
    base64(&bytes)
}

/// A field whose values are there and are numbers.
fn field<'a>(source: &'a Source, snapshots: &Snapshots) -> Option<Found<'a>> {
    let cells = if source.part == "bottom" { snapshots.bottom.len() } else { snapshots.wall.len() };
    let (mut peak, mut largest) = (0, -1.0);
    for (i, state) in snapshots.states.iter().enumerate() {
        let values = (source.of)(snapshots, state);
        let size = size(&values);
        if cells == 0 || values.len() != cells || !size.is_finite() {
            return None;
        }
        if size > largest {
            (peak, largest) = (i, size);
        }
    }
    (largest >= 0.0).then_some(Found { source, cells, peak })
}

/// Largest absolute value; not a number where one of them is not.
fn size(values: &[f64]) -> f64 {
    let mut largest = 0.0_f64;
    for v in values {
        largest = if v.abs() <= largest { largest } else { v.abs() };
        if v.is_nan() {
            return f64::NAN;
        }
    }
    largest
}

/// Share of the frames that follow each other about the largest displacement of the wall, where not all fit.
const CLOSE: usize = 3;

/// Every how many states are kept, and which.
fn kept(snapshots: &Snapshots, nodes: &[usize], found: &[Found<'_>], most: usize) -> (f64, Vec<usize>) {
    let count = snapshots.states.len();
    let numbers = 3 * nodes.len() + found.iter().map(|found| found.cells).sum::<usize>();
    // Two bytes are 8/3 characters; a scale or a time has up to 24.
    let frame = 8 * numbers / 3 + 24 * (3 + found.len());
    let cells = snapshots.wall.len() + snapshots.surface.len() + snapshots.bottom.len() + snapshots.sides.len();
    let fixed = 16 * nodes.len() * (1 + snapshots.modes.len()) + 22 * cells;
    let mut peaks = moved(snapshots);
    peaks.extend(found.iter().map(|found| found.peak));
    let fit = (most.saturating_sub(fixed) / frame.max(1)).saturating_sub(peaks.len()).max(1);
    // The motion of the wall is seen as it is in a part; the rest is thinner for it.
    let close = if count > fit { fit / CLOSE } else { 0 };
    let first = closest(snapshots, close, peaks.first().copied().unwrap_or_default());
    let rest = (fit - close).max(1);
    let every = (count as f64 / rest as f64).max(1.0);
    let even = (0..count.min(rest)).map(|i| ((i as f64 * every).round() as usize).min(count - 1));
    let mut kept: Vec<usize> = even.chain(first..(first + close).min(count)).chain(peaks).collect();
    kept.sort_unstable();
    kept.dedup();
    (every, kept)
}

/// The first of `close` states that follow each other: about `peak`, or where an engine has its states closer than there.
fn closest(snapshots: &Snapshots, close: usize, peak: usize) -> usize {
    let last = snapshots.states.len().saturating_sub(close);
    let span = |first: usize| {
        let ends =
            [first, first + close.saturating_sub(1)].map(|i| snapshots.states.get(i).map_or(0.0, |state| state.time));
        ends[1] - ends[0]
    };
    let about = peak.saturating_sub(close / 2).min(last);
    let densest = (0..=last).min_by(|a, b| span(*a).total_cmp(&span(*b)));
    densest.filter(|first| span(*first) < 0.75 * span(about)).unwrap_or(about)
}

/// States in which the displacement of each part is largest.
fn moved(snapshots: &Snapshots) -> Vec<usize> {
    let parts = [&snapshots.wall, &snapshots.surface, &snapshots.bottom];
    let parts = parts.into_iter().filter(|cells| !cells.is_empty()).map(|cells| {
        let own = used(&Snapshots { wall: cells.clone(), ..Snapshots::default() });
        let (mut peak, mut largest) = (0, -1.0);
        for (i, state) in snapshots.states.iter().enumerate() {
            let size = own.iter().map(|&n| size(&state.displacement[n])).fold(0.0, f64::max);
            if size > largest {
                (peak, largest) = (i, size);
            }
        }
        peak
    });
    if snapshots.states.is_empty() { Vec::new() } else { parts.collect() }
}

/// Frames as 16-bit numbers, and the scale of each; `values` appends those of a state.
fn coded(kept: &[usize], values: impl Fn(usize, &mut Vec<f64>)) -> (Vec<f64>, String) {
    let ([scale], text) = grouped(kept, |_| 0, values);
    (scale, text)
}

/// The same with a scale for each group of numbers; `group` is that of the place of a number in its frame.
fn grouped<const N: usize>(
    kept: &[usize],
    group: impl Fn(usize) -> usize,
    values: impl Fn(usize, &mut Vec<f64>),
) -> ([Vec<f64>; N], String) {
    let (mut scales, mut bytes, mut frame) = ([const { Vec::new() }; N], Vec::new(), Vec::new());
    for &i in kept {
        frame.clear();
        values(i, &mut frame);
        let mut largest = [0.0_f64; N];
        for (number, value) in frame.iter().enumerate() {
            let own = &mut largest[group(number)];
            *own = if value.is_nan() || own.is_nan() { f64::NAN } else { own.max(value.abs()) };
        }
        let steps = largest.map(|size| size / FULL);
        let per_step = steps.map(|step| if step > 0.0 { 1.0 / step } else { 0.0 });
        for (number, value) in frame.iter().enumerate() {
            // At most 32767, but for the rounding of the quotient.
            let stored = (value * per_step[group(number)]).round().clamp(-FULL, FULL) as i16;
            bytes.extend_from_slice(&stored.to_le_bytes());
        }
        scales.iter_mut().zip(steps).for_each(|(all, step)| all.push(step));
    }
    (scales, base64(&bytes))
}

/// Numbers of single precision.
fn floats(values: impl Iterator<Item = f64>) -> String {
    let bytes: Vec<u8> = values.flat_map(|v| (v as f32).to_le_bytes()).collect();
    base64(&bytes)
}

#[cfg(test)]
mod tests;
