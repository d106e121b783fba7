//! `scene.json`: what a three-dimensional viewer plays, from [`Snapshots`].
//!
//! ```text
//! nodes          f32, x y z of each [m]                 parts    u32, four nodes a cell: wall, surface, bottom
//! displacement   i16, frames × nodes × 3                fields   i16, frames × nodes or frames × cells of their part
//! value          stored number · scale[frame]           modes    f32, nodes × 3, the longest displacement 1
//! ```
//!
//! All arrays are base64 of little-endian numbers, all units SI. The nodes are those of the parts, without the inside of the liquid; a half tank is
//! mirrored. The wave height is the vertical displacement of the surface. Frames that do not fit into [`MOST`] bytes are left out evenly, but for
//! those in which a displacement or a field is largest.

mod mirror;

use std::path::Path;

use files::error::Error;
use serde::Serialize;
use tank::Shape;

use super::base64::base64;
use super::{EngineId, Resultants, Snapshot, Snapshots, TankSummary, put};

/// Name of the file in a results folder.
pub const FILE: &str = "scene.json";
/// Format of the file.
pub const FORMAT: &str = "tankcheck-scene/1";
/// Bytes of the file, about.
pub const MOST: usize = 24_000_000;
/// Largest stored number.
const FULL: f64 = 32767.0;

/// Writes the scene of a run into an existing folder.
///
/// Errors: a file that cannot be written.
pub fn write(folder: &Path, tank: &TankSummary, (engine, snapshots): (EngineId, &Snapshots)) -> Result<(), Error> {
    let scene = scene(tank, engine, snapshots, MOST);
    let mut text = serde_json::to_string(&scene).map_err(|e| Error::Report(e.to_string()))?;
    text.push('\n');
    put(&folder.join(FILE), text.as_bytes())
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
    /// Every how many states there is a frame: 1 where none is left out, else a mean.
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

/// A field with its values, frame by frame.
type Found<'a> = (&'a Source, Vec<Vec<f64>>);

fn scene(tank: &TankSummary, engine: EngineId, snapshots: &Snapshots, most: usize) -> Scene {
    let whole = mirror::whole(snapshots);
    let snapshots = whole.as_ref().unwrap_or(snapshots);
    let nodes = used(snapshots);
    let shell: &[Source] = if matches!(tank.tank.shape, Shape::Cylinder { .. }) { &ROUND } else { &PLANE };
    let found: Vec<Found<'_>> = shell.iter().chain(&ALL).filter_map(|source| values(source, snapshots)).collect();
    let (kept_every, kept) = kept(snapshots, &nodes, &found, most);
    let taken = |values: &[Vec<f64>]| coded(kept.iter().map(|&i| values[i].iter().copied()));
    let fields = found.iter().map(|(source, values)| {
        let (scale, values) = taken(values);
        let title = source.title[usize::from(snapshots.whole)];
        Field { id: source.id, title, unit: source.unit, part: source.part, at: "cell", scale, values }
    });
    let fields = fields.collect();
    let (scale, displacement) =
        coded(kept.iter().map(|&i| nodes.iter().flat_map(move |&n| snapshots.states[i].displacement[n])));
    let single = |points: &[[f64; 3]]| floats(nodes.iter().flat_map(|&n| points[n]));
    let parts = [("wall", &snapshots.wall), ("surface", &snapshots.surface), ("bottom", &snapshots.bottom)];
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

/// Nodes of the parts, ascending.
fn used(snapshots: &Snapshots) -> Vec<usize> {
    let cells = snapshots.wall.iter().chain(&snapshots.surface).chain(&snapshots.bottom);
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
fn values<'a>(source: &'a Source, snapshots: &Snapshots) -> Option<Found<'a>> {
    let cells = if source.part == "bottom" { snapshots.bottom.len() } else { snapshots.wall.len() };
    let all: Vec<Vec<f64>> = snapshots.states.iter().map(|state| (source.of)(snapshots, state)).collect();
    let there = |values: &Vec<f64>| values.len() == cells && values.iter().all(|v| v.is_finite());
    (cells > 0 && !all.is_empty() && all.iter().all(there)).then_some((source, all))
}

/// Every how many states are kept, and which.
fn kept(snapshots: &Snapshots, nodes: &[usize], found: &[Found<'_>], most: usize) -> (f64, Vec<usize>) {
    let count = snapshots.states.len();
    let numbers = 3 * nodes.len() + found.iter().map(|(_, values)| values[0].len()).sum::<usize>();
    // Two bytes are 8/3 characters; a scale or a time has up to 24.
    let frame = 8 * numbers / 3 + 24 * (2 + found.len());
    let cells = snapshots.wall.len() + snapshots.surface.len() + snapshots.bottom.len();
    let fixed = 16 * nodes.len() * (1 + snapshots.modes.len()) + 22 * cells;
    let peaks = peaks(snapshots, nodes, found);
    let fit = (most.saturating_sub(fixed) / frame.max(1)).saturating_sub(peaks.len()).max(1);
    let every = (count as f64 / fit as f64).max(1.0);
    let even = (0..count.min(fit)).map(|i| ((i as f64 * every).round() as usize).min(count - 1));
    let mut kept: Vec<usize> = even.chain(peaks).collect();
    kept.sort_unstable();
    kept.dedup();
    (every, kept)
}

/// States in which the displacement of a part or a field is largest.
fn peaks(snapshots: &Snapshots, nodes: &[usize], found: &[Found<'_>]) -> Vec<usize> {
    let largest = |of: &dyn Fn(usize) -> f64| {
        let values = (0..snapshots.states.len()).map(|i| (i, of(i)));
        values.max_by(|a, b| a.1.total_cmp(&b.1)).map(|(i, _)| i)
    };
    let size = |values: &[f64]| values.iter().fold(0.0_f64, |m, v| m.max(v.abs()));
    let parts = [&snapshots.wall, &snapshots.surface, &snapshots.bottom].map(|cells| {
        let own = Snapshots { wall: cells.clone(), ..Snapshots::default() };
        used(&own)
    });
    let mut peaks = Vec::new();
    for own in parts.iter().filter(|own| !own.is_empty() && !nodes.is_empty()) {
        peaks.extend(largest(&|i| {
            let all = own.iter().map(|&n| size(&snapshots.states[i].displacement[n]));
            all.fold(0.0, f64::max)
        }));
    }
    peaks.extend(found.iter().filter_map(|(_, values)| largest(&|i| size(&values[i]))));
    peaks
}

/// Frames as 16-bit numbers, and the scale of each.
fn coded<V: Iterator<Item = f64>>(frames: impl Iterator<Item = V>) -> (Vec<f64>, String) {
    let (mut scales, mut bytes) = (Vec::new(), Vec::new());
    for frame in frames {
        let values: Vec<f64> = frame.collect();
        let scale = values.iter().fold(0.0_f64, |m, v| m.max(v.abs())) / FULL;
        let number = |v: f64| if scale > 0.0 { (v / scale).round().clamp(-FULL, FULL) as i16 } else { 0 };
        bytes.extend(values.into_iter().flat_map(|v| number(v).to_le_bytes()));
        scales.push(scale);
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
