//! Pictures of a run: drawn mesh, modes, deformed shapes and maps of the wall at the moments of extreme response; and the
//! states for other programs.
//!
//! Levels of the wall and rings of the surface are left out evenly until at most `LEVELS` and `RINGS` are drawn.

use fem::assembly::local_values;
use fem::dofs::Dof;
use fem::element::Inspect;
use fem::element::shell::recovery::centre_resultants;
use tank::units::Dimension;

use super::model::TankModel;
use super::moments::{Histories, Moment};
use super::reduce::Space;
use super::spectrum::TankMode;
use crate::modes::Kind;
use results::{DeformedShape, DrawnMode, Fields, Picture, Resultants, Snapshot, Snapshots, WallMap};
use tank::options::solid::Liquid;

/// Most levels of wall nodes that are drawn.
const LEVELS: usize = 25;
/// Most rings of the surface that are drawn.
const RINGS: usize = 9;
/// Most rays that are drawn.
const RAYS: usize = 48;
/// Most lines of nodes that are drawn over half a side of a rectangle.
const LINES: usize = 7;
/// Digits kept: pictures need no more.
const DIGITS: usize = 6;

/// Parts of a tank that are drawn.
struct Drawing {
    /// Nodes of the model, wall level by level, then the surface from its middle.
    nodes: Vec<usize>,
    wall: Vec<[usize; 4]>,
    surface: Vec<[usize; 4]>,
}

/// At most `most` of 0 … count − 1, evenly, first and last among them.
fn thinned(count: usize, most: usize) -> Vec<usize> {
    if count <= most {
        return (0..count).collect();
    }
    (0..most).map(|k| (k * (count - 1) + (most - 1) / 2) / (most - 1)).collect()
}

impl Drawing {
    fn new(tank: &TankModel) -> Drawing {
        if !tank.is_round() {
            return Drawing::of_rectangle(tank);
        }
        let sectors = tank.division.sectors;
        // Rays must divide the circle.
        let step = (sectors.div_ceil(RAYS)..=sectors).find(|s| sectors.is_multiple_of(*s)).unwrap_or(1);
        let rays: Vec<usize> = (0..sectors).step_by(step).collect();
        let n = rays.len();
        let levels = thinned(tank.wall.rows.len(), LEVELS);
        let mut nodes = Vec::new();
        for &level in &levels {
            nodes.extend(rays.iter().map(|&s| tank.wall.rows[level][s]));
        }
        let mut wall = Vec::new();
        for l in 0..levels.len() - 1 {
            for s in 0..n {
                let next = (s + 1) % n;
                wall.push([l * n + s, l * n + next, (l + 1) * n + next, (l + 1) * n + s]);
            }
        }
        let start = nodes.len();
        let rings = thinned(tank.division.radii.len(), RINGS);
        nodes.push(tank.volume.surface_nodes[0]);
        for &ring in &rings[1..] {
            let first = 1 + (ring - 1) * sectors;
            nodes.extend(rays.iter().map(|&s| tank.volume.surface_nodes[first + s]));
        }
        let number = |ring: usize, s: usize| match ring {
            0 => start,
            ring => start + 1 + (ring - 1) * n + s % n,
        };
        let mut surface = Vec::new();
        for r in 0..rings.len() - 1 {
            for s in 0..n {
                surface.push([number(r, s), number(r + 1, s), number(r + 1, s + 1), number(r, s + 1)]);
            }
        }
        Drawing { nodes, wall, surface }
    }

    /// Drawing of a rectangle: at most `LINES` lines of nodes over every half of a side, the corners and middles among them.
    fn of_rectangle(tank: &TankModel) -> Drawing {
        let division = &tank.division;
        let halves = [division.radii.len() - 1, division.breadth.len() - 1];
        // Lines over a whole side, from those of its half.
        let side = |half: usize| -> Vec<usize> {
            let own = thinned(half + 1, LINES);
            let left = own.iter().skip(1).rev().map(|k| half - k);
            left.chain(own.iter().map(|k| half + k)).collect()
        };
        let [x, y] = halves.map(side);
        let [length, breadth] = halves.map(|half| 2 * half);
        // As the ring of the wall runs: half of the front, left, back, right, half of the front.
        let middle = y.iter().position(|&j| j == halves[1]).unwrap_or(0);
        let mut rays: Vec<usize> = y[middle..].iter().map(|j| j - halves[1]).collect();
        let corner = halves[1];
        rays.extend(x.iter().skip(1).map(|i| corner + i));
        rays.extend(y.iter().skip(1).map(|j| corner + length + j));
        rays.extend(x.iter().skip(1).map(|i| corner + length + breadth + i));
        rays.extend(y[1..middle].iter().map(|j| corner + 2 * length + breadth + j));
        let n = rays.len();
        let levels = thinned(tank.wall.rows.len(), LEVELS);
        let mut nodes: Vec<usize> =
            (levels.iter()).flat_map(|&level| rays.iter().map(move |&s| tank.wall.rows[level][s])).collect();
        let quad = |l: usize, s: usize, next: usize| [l * n + s, l * n + next, (l + 1) * n + next, (l + 1) * n + s];
        let wall = (0..levels.len() - 1).flat_map(|l| (0..n).map(move |s| quad(l, s, (s + 1) % n))).collect();
        let start = nodes.len();
        nodes.extend(y.iter().flat_map(|j| x.iter().map(move |i| tank.volume.surface_nodes[i + (length + 1) * j])));
        let number = |i: usize, j: usize| start + i + x.len() * j;
        let surface = (0..y.len() - 1)
            .flat_map(|j| (0..x.len() - 1).map(move |i| (i, j)))
            .map(|(i, j)| [number(i, j), number(i + 1, j), number(i + 1, j + 1), number(i, j + 1)])
            .collect();
        Drawing { nodes, wall, surface }
    }

    fn displacement(&self, tank: &TankModel, x: &[f64]) -> Vec<[f64; 3]> {
        self.nodes.iter().map(|&node| displacement(tank, x, node)).collect()
    }
}

/// Displacement of a node: u, or the elevation on the surface of a potential liquid.
fn displacement(tank: &TankModel, x: &[f64], node: usize) -> [f64; 3] {
    let own = tank.model.at_node(x, node);
    [own[0], own[1], own[2] + own[Dof::Eta.index()]]
}

fn rounded(value: f64) -> f64 {
    format!("{value:.*e}", DIGITS - 1).parse().unwrap_or(value)
}

fn round_all(values: Vec<[f64; 3]>) -> Vec<[f64; 3]> {
    values.into_iter().map(|v| v.map(rounded)).collect()
}

/// Circumferential and axial wave number of a mode in words.
pub(super) fn title(tank: &TankModel, mode: &TankMode) -> String {
    if !tank.is_round() {
        let part = ["even in x and y", "along x", "along y", "odd in x and y"][mode.harmonic as usize % 4];
        return match mode.kind {
            Kind::Sloshing => format!("sloshing, {part}"),
            _ => format!("walls, {part}"),
        };
    }
    let waves = match mode.harmonic {
        0 => "axisymmetric".to_owned(),
        n => format!("cos {}θ", if n == 1 { String::new() } else { n.to_string() }),
    };
    match (mode.kind, mode.waves) {
        (Kind::Sloshing, _) => format!("sloshing, {waves}"),
        (_, Some(w)) => format!("wall, {waves}, {} half wave{}", w.axial, if w.axial == 1 { "" } else { "s" }),
        (_, None) => format!("wall, {waves}"),
    }
}

/// Pictures of `modes`, of the states at `moments` (title, time), and maps there.
pub(super) fn fields(
    tank: &TankModel,
    spaces: &[Space],
    histories: &Histories,
    modes: &[TankMode],
    moments: &[(String, f64)],
) -> Fields {
    let drawing = Drawing::new(tank);
    let positions = drawing.nodes.iter().map(|&n| tank.model.nodes()[n]).collect();
    let mut out = Fields {
        nodes: round_all(positions),
        wall: drawing.wall.clone(),
        surface: drawing.surface.clone(),
        ..Fields::default()
    };
    for mode in modes {
        let shape = drawing.displacement(tank, &mode.vector);
        let peak = shape.iter().map(|v| v.iter().map(|c| c * c).sum::<f64>().sqrt()).fold(0.0, f64::max);
        let scale = if peak > 0.0 { 1.0 / peak } else { 1.0 };
        out.modes.push(Picture {
            title: title(tank, mode),
            omega: mode.omega,
            circumferential: mode.harmonic,
            displacement: round_all(shape.into_iter().map(|v| v.map(|c| c * scale)).collect()),
        });
    }
    for (what, time) in moments {
        let moment = histories.at(tank, spaces, *time);
        out.moments.push(DeformedShape {
            title: what.clone(),
            time: moment.time,
            displacement: round_all(drawing.displacement(tank, &moment.displacement)),
        });
        out.maps.push(pressure_map(tank, &moment, what));
        let maps: &[StressMap] = if tank.is_round() { &[HOOP] } else { &[AROUND, UPWARDS] };
        out.maps.extend(maps.iter().map(|map| stress_map(tank, spaces, &moment, (map, what))));
    }
    out
}

/// Pressure at a node of a potential liquid under the whole motion, without the hydrostatic part.
fn potential_pressure(tank: &TankModel, moment: &Moment, node: usize) -> f64 {
    let phi = tank.model.at_node(&moment.acceleration, node)[Dof::Phi.index()];
    tank.density * (tank.gravity * moment.mean_elevation - phi)
}

/// Pressure on the wall at a level of the liquid's nodes, without the hydrostatic part: that of the potential, or that in
/// the joint between a displacement liquid and the wall.
fn wall_pressure(tank: &TankModel, moment: &Moment, level: usize, sector: usize) -> f64 {
    let node = tank.volume.wall_nodes[level][sector];
    match tank.liquid {
        Liquid::Potential => potential_pressure(tank, moment, node),
        Liquid::Displacement => {
            // Nodes of wall and liquid lie together, level by level.
            let liquid = displacement(tank, &moment.displacement, node);
            let wall = displacement(tank, &moment.displacement, tank.wall.rows[level][sector]);
            let (sine, cosine) = (std::f64::consts::TAU * sector as f64 / tank.division.sectors as f64).sin_cos();
            tank.joint * ((liquid[0] - wall[0]) * cosine + (liquid[1] - wall[1]) * sine)
        }
    }
}

/// Pressures in the cells of the liquid, without the hydrostatic part: means of the nodes' potential, or −K div u of a
/// displacement liquid.
fn cell_pressures(tank: &TankModel, moment: &Moment) -> Vec<f64> {
    match tank.liquid {
        Liquid::Potential => {
            let mean = |nodes: &[usize; 8]| nodes.iter().map(|&n| 0.125 * potential_pressure(tank, moment, n)).sum();
            tank.volume.cells.iter().map(|cell| mean(&cell.nodes)).collect()
        }
        Liquid::Displacement => {
            let liquid = tank.model.elements().iter().filter(|e| e.kind() == "fluid8");
            liquid
                .map(|element| {
                    let local = local_values(&tank.model, &**element, &moment.displacement);
                    let samples = element.samples();
                    let sample = samples.iter().find(|sample| sample.name == "pressure");
                    sample.map_or(0.0, |sample| sample.row.iter().zip(&local).map(|(c, v)| c * v).sum())
                })
                .collect()
        }
    }
}

fn pressure_map(tank: &TankModel, moment: &Moment, what: &str) -> WallMap {
    let levels = thinned(tank.division.liquid.len(), LEVELS);
    let sectors = tank.division.sectors;
    let mut values = Vec::new();
    for s in 0..sectors {
        for &l in &levels {
            let z = tank.division.liquid[l];
            let hydrostatic = tank.density * tank.gravity * (tank.depth - z).max(0.0);
            let seismic = wall_pressure(tank, moment, l, s);
            values.push(rounded(hydrostatic + seismic));
        }
    }
    WallMap {
        id: "pressure".into(),
        title: format!("Pressure on the wall, {what}"),
        time: Some(moment.time),
        dimension: Dimension::Stress,
        theta: angles(tank, 0.0),
        z: levels.iter().map(|&l| rounded(tank.division.liquid[l])).collect(),
        values,
    }
    .closed(tank)
}

/// Angles of the nodes of the wall (`offset` 0) or of the centres of its elements (½) seen from the middle of the tank.
fn angles(tank: &TankModel, offset: f64) -> Vec<f64> {
    let sectors = tank.division.sectors;
    if tank.is_round() {
        let angle = |s: usize| rounded(std::f64::consts::TAU * (s as f64 + offset) / sectors as f64);
        return (0..sectors).map(angle).collect();
    }
    let nodes = tank.model.nodes();
    let angle = |s: usize| {
        let [p, q] = [s, (s + 1) % sectors].map(|s| nodes[tank.wall.rows[0][s]]);
        let [x, y] = [0, 1].map(|k| p[k] + offset * (q[k] - p[k]));
        rounded(y.atan2(x).rem_euclid(std::f64::consts::TAU))
    };
    (0..sectors).map(angle).collect()
}

/// A stress over the developed wall: a resultant, and what divides it.
struct StressMap {
    id: &'static str,
    title: &'static str,
    resultant: &'static str,
    /// Area, or section modulus of a length of wall, for its thickness.
    section: fn(f64) -> f64,
}

const HOOP: StressMap =
    StressMap { id: "hoop_stress", title: "Hoop membrane stress", resultant: "n_11", section: |t| t };
const AROUND: StressMap = StressMap {
    id: "horizontal_bending_stress",
    title: "Horizontal bending stress, outer face",
    resultant: "m_11",
    section: |t| t * t / 6.0,
};
const UPWARDS: StressMap = StressMap {
    id: "bending_stress",
    title: "Vertical bending stress, outer face",
    resultant: "m_22",
    section: |t| t * t / 6.0,
};

fn stress_map(tank: &TankModel, spaces: &[Space], moment: &Moment, (map, what): (&StressMap, &str)) -> WallMap {
    let sectors = tank.division.sectors;
    let whole: Vec<f64> = moment.displacement.iter().zip(&spaces[0].statics).map(|(u, s)| u + s).collect();
    let levels = thinned(tank.wall.thickness.len(), LEVELS);
    let mut values = Vec::new();
    for s in 0..sectors {
        for &l in &levels {
            let element = &*tank.model.elements()[tank.wall.elements[l * sectors + s]];
            let local = local_values(&tank.model, element, &whole);
            let force: f64 = element
                .samples()
                .iter()
                .find(|sample| sample.name == map.resultant)
                .map_or(0.0, |sample| sample.row.iter().zip(&local).map(|(c, v)| c * v).sum());
            values.push(rounded(force / (map.section)(tank.wall.thickness[l])));
        }
    }
    let middle = |&l: &usize| rounded(0.5 * (tank.wall.z[l] + tank.wall.z[l + 1]));
    WallMap {
        id: map.id.into(),
        title: format!("{}, {what}", map.title),
        time: Some(moment.time),
        dimension: Dimension::Stress,
        theta: angles(tank, 0.5),
        z: levels.iter().map(middle).collect(),
        values,
    }
    .closed(tank)
}

/// Closing of a map of four walls, whose angles are not evenly spaced.
trait Closed {
    /// With its first column once more at its end.
    fn closed(self, tank: &TankModel) -> Self;
}

impl Closed for WallMap {
    fn closed(mut self, tank: &TankModel) -> WallMap {
        if let (false, Some(first)) = (tank.is_round(), self.theta.first()) {
            self.theta.push(first + std::f64::consts::TAU);
            self.values.extend_from_within(..self.z.len());
        }
        self
    }
}

/// Nodes, cells and modes of pictures, still without a state: all nodes, or those of wall and surface.
fn drawn(tank: &TankModel, inside: bool, modes: &[TankMode]) -> (Snapshots, Vec<usize>) {
    let top: Vec<[usize; 4]> = tank.volume.cells.iter().filter_map(|cell| upper_face(tank, &cell.nodes)).collect();
    let wall: Vec<[usize; 4]> = tank.wall.faces.iter().map(|f| f.nodes).collect();
    let mut nodes: Vec<usize> = match inside {
        true => (0..tank.model.nodes().len()).collect(),
        false => wall.iter().chain(&top).flatten().copied().collect(),
    };
    nodes.sort_unstable();
    nodes.dedup();
    let own = |cells: &[[usize; 4]]| -> Vec<[usize; 4]> {
        cells.iter().map(|cell| cell.map(|node| nodes.partition_point(|n| *n < node))).collect()
    };
    let sectors = tank.division.sectors;
    let drawn = modes.iter().map(|mode| {
        let shape = nodes.iter().map(|&node| displacement(tank, &mode.vector, node)).collect();
        DrawnMode::new(title(tank, mode), mode.omega, shape)
    });
    let out = Snapshots {
        nodes: nodes.iter().map(|&n| tank.model.nodes()[n]).collect(),
        liquid: if inside { tank.volume.cells.iter().map(|c| c.nodes).collect() } else { Vec::new() },
        wall: own(&wall),
        thickness: (0..wall.len()).map(|face| tank.wall.thickness[face / sectors]).collect(),
        surface: own(&top),
        modes: drawn.collect(),
        ..Snapshots::default()
    };
    (out, nodes)
}

/// The upper face of a cell below the surface at rest.
fn upper_face(tank: &TankModel, cell: &[usize; 8]) -> Option<[usize; 4]> {
    let upper = [cell[4], cell[5], cell[6], cell[7]];
    let level = tank.depth * (1.0 - 1e-9);
    upper.iter().all(|&n| tank.model.nodes()[n][2] >= level).then_some(upper)
}

/// Seismic pressure in the middle of every face of the wall: between the levels of the liquid, a mean of both sides; 0 above the surface at rest.
fn pressures_on_faces(tank: &TankModel, moment: &Moment) -> Vec<f64> {
    let (z, sectors) = (&tank.division.liquid, tank.division.sectors);
    let at: Vec<Vec<f64>> =
        (0..z.len()).map(|level| (0..sectors).map(|s| wall_pressure(tank, moment, level, s)).collect()).collect();
    let face = |k: usize| {
        let (row, sector) = (k / sectors, k % sectors);
        let middle = 0.5 * (tank.wall.z[row] + tank.wall.z[row + 1]);
        if middle > tank.depth {
            return 0.0;
        }
        let upper = z.partition_point(|level| *level < middle).clamp(1, z.len() - 1);
        let share = (middle - z[upper - 1]) / (z[upper] - z[upper - 1]);
        let side = |s: usize| at[upper - 1][s] + share * (at[upper][s] - at[upper - 1][s]);
        0.5 * (side(sector) + side((sector + 1) % sectors))
    };
    (0..tank.wall.faces.len()).map(face).collect()
}

/// The states every `interval` [s] up to `end` [s]. A potential liquid has displacements at its surface only.
///
/// * `inside`: whether they hold the inside of the liquid
pub(super) fn snapshots(
    tank: &TankModel,
    spaces: &[Space],
    histories: &Histories,
    modes: &[TankMode],
    (interval, end, inside): (f64, f64, bool),
) -> Snapshots {
    let (mut out, nodes) = drawn(tank, inside, modes);
    let mut time = 0.0;
    while time <= end {
        let moment = histories.at(tank, spaces, time);
        let u = nodes.iter().map(|&node| displacement(tank, &moment.displacement, node)).collect();
        let pressure = if inside { cell_pressures(tank, &moment) } else { Vec::new() };
        let resultants = centre_resultants(&tank.model, &tank.wall.elements, &moment.displacement)
            .into_iter()
            .map(|(_, r)| Resultants {
                n_phi: r[0],
                n_v: r[1],
                n_phi_v: r[2],
                m_phi: r[3],
                m_v: r[4],
                m_phi_v: r[5],
                q_v: r[7],
            })
            .collect();
        out.states.push(Snapshot {
            time: moment.time,
            displacement: u,
            pressure,
            on_wall: pressures_on_faces(tank, &moment),
            resultants,
            ..Snapshot::default()
        });
        time += interval;
    }
    out
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn thinning_keeps_the_ends() {
        assert_eq!(thinned(4, 9), vec![0, 1, 2, 3]);
        let kept = thinned(37, 25);
        assert_eq!((kept[0], kept[24], kept.len()), (0, 36, 25));
        assert!(kept.windows(2).all(|w| w[1] > w[0]));
    }

    #[test]
    fn six_digits_are_kept() {
        assert_eq!(rounded(1.234_567_89e-7), 1.234_57e-7);
        assert_eq!(rounded(0.0), 0.0);
    }
}
