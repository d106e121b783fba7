//! Events, maps, cracks, loops and energies of a run.

use std::f64::consts::{PI, TAU};

use fem::analysis::march::Run;
use tank::Behaviour;
use tank::Case;
use tank::units::{Dimension, display, significant};

use super::model::CylinderModel;
use super::points::{Happening, Look};
use super::recorded::{BASE_SHEAR, BELLY_FRONT};
use super::watch::Watch;
use results::nonlinear::{CellMap, Columns, CrackPicture, Energies, Event, EventKind, Loop, LoopAxis, WallGrid};

/// Points of a loop or a curve of energy at most.
const POINTS: usize = 1500;

/// A place in words; the angle from −180° to 360°, rounding below 0 taken for 0.
pub(super) fn place(theta: f64, z: f64) -> String {
    let theta = if theta < -1e-9 && theta > -PI { theta + TAU } else { theta };
    format!("θ = {}°, z = {}", significant(theta.to_degrees().abs(), 3), display(z, Dimension::Length))
}

/// Middle of a cell.
fn middle(tank: &CylinderModel, cell: usize) -> String {
    let columns = tank.cells.columns();
    let (row, column) = (cell / columns, cell % columns);
    let theta = (column as f64 + 0.5) * tank.cells.angle();
    place(theta, 0.5 * (tank.cells.z[row] + tank.cells.z[row + 1]))
}

pub(super) fn events(tank: &CylinderModel, watch: &Watch<'_>) -> Vec<Event> {
    let first = |&(what, time, cell): &(Happening, f64, usize)| {
        let (kind, title) = match what {
            Happening::Crack => (EventKind::FirstCrack, "first crack"),
            Happening::Yield => (EventKind::FirstYield, "first yielding of a plate"),
            Happening::BarYield => (EventKind::FirstBarYield, "first yielding of a bar"),
            Happening::Tears => (EventKind::AboveStrength, "a plate exceeds its tensile strength"),
            Happening::BarRupture => (EventKind::BarRupture, "a bar exceeds its rupture strain"),
            Happening::Crushing => (EventKind::Crushing, "concrete reaches its compressive strength"),
        };
        let note = if time == 0.0 { "In the static state.".into() } else { String::new() };
        Event { kind, title: title.into(), time, place: middle(tank, cell), note }
    };
    let mut out: Vec<Event> = watch.seen.first.iter().map(first).collect();
    out.extend(parting(watch, tank));
    let separation = watch.separation.result();
    if let Some(first) = separation.places.iter().filter(|p| p.below_trough).min_by(|a, b| a.first.total_cmp(&b.first))
    {
        let [x, y, z] = tank.model.nodes()[tank.wetted[first.number]];
        out.push(Event {
            kind: EventKind::LowPressure,
            title: "pressure below atmospheric; the liquid separates".into(),
            time: first.first,
            place: place(y.atan2(x), z),
            note: format!(
                "Lowest pressure there {} at {:.2} s, at the displaced particle.",
                display(first.pressure, Dimension::Stress),
                first.time
            ),
        });
    }
    out.sort_by(|a, b| a.time.total_cmp(&b.time));
    out
}

/// When the liquid separates from the wall, where it may.
fn parting(watch: &Watch<'_>, tank: &CylinderModel) -> Option<Event> {
    let (openings, joints) = (watch.openings.as_ref()?.places(), tank.joints.as_ref()?);
    let first = openings.iter().min_by(|a, b| a.first.total_cmp(&b.first))?;
    let widest = openings.iter().max_by(|a, b| a.widest.total_cmp(&b.widest))?;
    let lowest = openings.iter().map(|p| p.height).fold(f64::INFINITY, f64::min);
    let [at, widest_at] = [first, widest].map(|p| {
        let [z, theta] = joints.places[p.number];
        place(theta, z)
    });
    let length = |x: f64| display(x, Dimension::Length);
    Some(Event {
        kind: EventKind::Separation,
        title: "the liquid separates from the wall".into(),
        time: first.first,
        place: at,
        note: format!(
            "Down to z = {}; widest {} at {widest_at} after {:.2} s; open there in {} % of the samples.",
            length(lowest),
            length(widest.widest),
            widest.time,
            significant(100.0 * widest.share, 2)
        ),
    })
}

pub(super) fn grid(tank: &CylinderModel) -> WallGrid {
    WallGrid {
        columns: Columns::Sectors { radius: tank.radius, edges: tank.cells.edges(), mirrored: tank.cells.half },
        z: tank.cells.z.clone(),
        surface: tank.depth,
    }
}

/// Lowest yield strength of all bars [Pa].
fn bar_strength(case: &Case) -> Option<f64> {
    let bars = case.tank.courses.iter().flat_map(|c| c.build_up());
    let bars = bars.flat_map(|layer| layer.reinforcement);
    let strengths = bars.filter_map(|bar| match bar.material.behaviour {
        Behaviour::Reinforcement(bar) => Some(bar.yield_strength),
        _ => None,
    });
    strengths.min_by(f64::total_cmp)
}

/// Id, title and note of the maps of the wall.
const MAPS: [[&str; 3]; 7] = [
    [
        "utilisation",
        "Utilisation of the plate, largest over time",
        "Von Mises stress over the yield stress, hardening included; 1: yielding.",
    ],
    [
        "plastic_strain",
        "Plastic strain of the plate at the end",
        "Accumulated equivalent plastic strain, the largest over the thickness.",
    ],
    ["crack_width_inner", "Largest crack width, inner face", CRACKS],
    ["crack_width_outer", "Largest crack width, outer face", CRACKS],
    [
        "compression",
        "Compression of the concrete over its strength, largest over time",
        "Smallest principal stress over the uniaxial strength; above 1 under biaxial compression.",
    ],
    [
        "bar_stress",
        "Stress of the bars, largest over time",
        "Tension or compression, the larger, of all bars of a cell; the mark is their yield strength.",
    ],
    ["bar_plastic_strain", "Plastic strain of the bars at the end", "Accumulated, the largest of all bars of a cell."],
];
const CRACKS: &str = "Crack strain times the length over which a crack is smeared; the widest so far.";
/// Id, title and note of the maps of a liquid that leaves the wall.
const GAP: [&str; 3] = [
    "separation",
    "Largest gap between liquid and wall",
    "Widest gap at the corners of the cell; 0 where the liquid has stayed in contact.",
];
const LOW_PRESSURE: [&str; 3] = [
    "separation",
    "Share of the time in which the liquid separates from the wall",
    "Pressure of the displaced particle below zero, under the lowest surface.",
];

pub(super) fn maps(case: &Case, tank: &CylinderModel, watch: &Watch<'_>, worst: &Look, last: &Look) -> Vec<CellMap> {
    let map = |[id, title, note]: [&str; 3], dimension, values: &[f64], mark| {
        let text = |text: &str| text.to_owned();
        CellMap { id: text(id), title: text(title), dimension, values: values.to_vec(), mark, note: text(note) }
    };
    let number = Dimension::Dimensionless;
    let [inner, outer] = &worst.crack_width;
    let of_wall = [
        (number, &worst.utilisation, Some(1.0)),
        (number, &last.plastic_strain, None),
        (Dimension::Length, inner, None),
        (Dimension::Length, outer, None),
        (number, &worst.compression, Some(1.0)),
        (Dimension::Stress, &worst.bar_stress, bar_strength(case)),
        (number, &last.bar_plastic_strain, None),
    ];
    let of_wall = MAPS.into_iter().zip(of_wall).filter(|(_, (_, values, _))| !values.is_empty());
    let mut out: Vec<CellMap> =
        of_wall.map(|(text, (dimension, values, mark))| map(text, dimension, values, mark)).collect();
    if let (Some(openings), Some(joints)) = (&watch.openings, &tank.joints) {
        let gaps = around_nodes(tank, joints.numbers.iter().copied().zip(openings.widest()));
        out.push(map(GAP, Dimension::Length, &gaps, None));
    }
    let found = watch.separation.result();
    if found.places.iter().any(|p| p.below_trough) {
        let parted = found.places.iter().filter(|p| p.below_trough);
        let share = around_nodes(tank, parted.map(|p| (p.number, p.share)));
        out.push(map(LOW_PRESSURE, number, &share, None));
    }
    out
}

/// Largest value of the wetted nodes at each cell's corners, from (number of the node, value).
fn around_nodes(tank: &CylinderModel, values: impl Iterator<Item = (usize, f64)>) -> Vec<f64> {
    let columns = tank.cells.columns();
    let around = tank.footprint.levels[0].len();
    let mut out = vec![0.0_f64; tank.cells.rows() * columns];
    for (number, value) in values {
        let (level, k) = (number / around, number % around);
        // The whole circle closes on itself.
        let before = k.checked_sub(1).or((!tank.cells.half).then(|| columns - 1));
        for row in [level.checked_sub(1), Some(level)].into_iter().flatten() {
            for column in [before, Some(k)].into_iter().flatten() {
                if row < tank.cells.rows() && column < columns {
                    let own = &mut out[row * columns + column];
                    *own = own.max(value);
                }
            }
        }
    }
    out
}

pub(super) fn pictures(watch: &Watch<'_>, last: &Look, time: f64) -> Vec<CrackPicture> {
    let extreme = watch.seen.extreme.as_ref();
    let rest = watch.seen.rest.as_ref().map(|l| ("static state", 0.0, l));
    let extreme = extreme.map(|k| ("largest base moment", k.time, &k.look));
    let extreme = extreme.filter(|e| e.1 > 0.0);
    let all = rest.into_iter().chain(extreme).chain([("end of the run", time, last)]);
    let mut out = Vec::new();
    for (title, time, look) in all {
        for (face, name) in ["inner face", "outer face"].into_iter().enumerate() {
            // Only where the wall has concrete at all.
            if !look.crack_width[face].is_empty() {
                out.push(CrackPicture {
                    title: title.into(),
                    face: name.into(),
                    time,
                    cracks: look.cracks[face].clone(),
                });
            }
        }
    }
    out
}

/// Stride that leaves at most [`POINTS`] of `n` points.
fn stride(n: usize) -> usize {
    n.div_ceil(POINTS).max(1)
}

fn paired(x: &[f64], y: &[f64]) -> Vec<[f64; 2]> {
    let n = x.len().min(y.len());
    x.iter().zip(y).step_by(stride(n)).map(|(x, y)| [*x, *y]).collect()
}

pub(super) fn loops(watch: &Watch<'_>) -> Vec<Loop> {
    let axis = |title: &str, dimension| LoopAxis { title: title.into(), dimension };
    let mut out = Vec::new();
    for (side, angle) in [(0, 0), (1, 180)] {
        let meridian = &watch.seen.sides[side];
        out.push(Loop {
            id: format!("moment_curvature_theta_{angle}"),
            title: format!("Base of the wall, θ = {angle}°: meridional moment over curvature of the lowest cell"),
            x: axis("Curvature", Dimension::Curvature),
            y: axis("Moment", Dimension::LineMoment),
            points: paired(&meridian.curvature, &meridian.moment),
        });
    }
    let h = &watch.recorder.histories;
    out.push(Loop {
        id: "shear_displacement".into(),
        title: "Base shear over the radial displacement of the wall, θ = 0°, at a third of its levels".into(),
        x: axis("Displacement", Dimension::Length),
        y: axis("Base shear", Dimension::Force),
        points: paired(&h[BELLY_FRONT], &h[BASE_SHEAR]),
    });
    out
}

pub(super) fn energies(run: &Run, watch: &Watch<'_>) -> Energies {
    let samples = &run.balance.samples;
    let copies = watch.copies();
    let every = stride(samples.len());
    let column = |f: &dyn Fn(&fem::analysis::march::Energies) -> f64| -> Vec<f64> {
        samples.iter().step_by(every).map(|e| copies * f(e)).collect()
    };
    let times = &watch.recorder.times;
    Energies {
        time: times.iter().take(samples.len()).step_by(every).copied().collect(),
        input: column(&|e| e.input),
        kinetic: column(&|e| e.kinetic),
        internal: column(&|e| e.internal),
        damping: column(&|e| e.damping),
        numerical: column(&|e| e.numerical),
        hysteretic: column(&|e| e.hysteretic),
        error: run.balance.error(),
    }
}
