//! The nodes and quadrilaterals of the picture.

use tank::{Case, Shape};

use crate::coupled::{Coupled, SparseRow};
use crate::linear::model::Model;

/// Meridians around a cylinder.
const SECTORS: usize = 48;
/// Lines of nodes over the breadth of a box.
const COLUMNS: usize = 5;
/// Distance of levels over the height of the wall below which one is left out.
const CLOSEST: f64 = 0.025;

/// Where a node lies: its level on the wall or its ring on the surface, and (cos θ, sin θ), of a box (± 1, 0); or on what moves with the base.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) enum Spot {
    Wall { level: usize, at: [f64; 2] },
    Surface { ring: usize, at: [f64; 2] },
    Rigid,
}

/// A quadrilateral of the wall.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Cell {
    /// Level at its lower edge.
    pub level: usize,
    /// (cos θ, sin θ) in its middle.
    pub at: [f64; 2],
    /// Thickness [m].
    pub thickness: f64,
}

/// Mesh of wall and surface.
pub(super) struct Mesh {
    pub round: bool,
    pub nodes: Vec<[f64; 3]>,
    pub spots: Vec<Spot>,
    pub wall: Vec<[usize; 4]>,
    pub cells: Vec<Cell>,
    pub surface: Vec<[usize; 4]>,
    /// The side walls of a box.
    pub sides: Vec<[usize; 4]>,
    /// Places of the levels among the nodes of the model's wall.
    pub levels: Vec<usize>,
    /// Their heights [m].
    pub heights: Vec<f64>,
    /// Radii of the rings, or distances from the middle of a box [m].
    pub radii: Vec<f64>,
}

impl Mesh {
    pub(super) fn of(case: &Case, model: &Model) -> Mesh {
        let rows = &model.horizontal.coupled.shape_rows;
        let levels = levels(case, &rows.z);
        let mut mesh = Mesh {
            round: matches!(case.tank.shape, Shape::Cylinder { .. }),
            nodes: Vec::new(),
            spots: Vec::new(),
            wall: Vec::new(),
            cells: Vec::new(),
            surface: Vec::new(),
            sides: Vec::new(),
            heights: levels.iter().map(|&i| rows.z[i]).collect(),
            levels,
            radii: rows.r.clone(),
        };
        match case.tank.shape {
            Shape::Cylinder { radius } => mesh.cylinder(case, radius),
            Shape::Rectangle { length, breadth, strip } => {
                mesh.walls(case, [0.5 * length, breadth]);
                if !strip {
                    mesh.sides([0.5 * length, 0.5 * breadth]);
                }
            }
        }
        mesh
    }

    fn push(&mut self, place: [f64; 3], spot: Spot) -> usize {
        self.nodes.push(place);
        self.spots.push(spot);
        self.nodes.len() - 1
    }

    fn thickness(&self, case: &Case, level: usize) -> f64 {
        case.tank.course_at(0.5 * (self.heights[level] + self.heights[level + 1])).thickness
    }

    fn cylinder(&mut self, case: &Case, radius: f64) {
        let direction = |k: f64| {
            let (s, c) = (std::f64::consts::TAU * k / SECTORS as f64).sin_cos();
            [c, s]
        };
        for (level, z) in self.heights.clone().into_iter().enumerate() {
            for k in 0..SECTORS {
                let at = direction(k as f64);
                self.push([radius * at[0], radius * at[1], z], Spot::Wall { level, at });
            }
        }
        let node = |level: usize, k: usize| level * SECTORS + k % SECTORS;
        for level in 0..self.heights.len() - 1 {
            let thickness = self.thickness(case, level);
            for k in 0..SECTORS {
                self.wall.push([node(level, k), node(level, k + 1), node(level + 1, k + 1), node(level + 1, k)]);
                self.cells.push(Cell { level, at: direction(k as f64 + 0.5), thickness });
            }
        }
        let z = case.liquid.fill_height;
        let mut rings: Vec<Vec<usize>> = Vec::new();
        for (ring, r) in self.radii.clone().into_iter().enumerate() {
            let count = if r > 0.0 { SECTORS } else { 1 };
            let own = (0..count).map(|k| {
                let at = direction(k as f64);
                self.push([r * at[0], r * at[1], z], Spot::Surface { ring, at })
            });
            rings.push(own.collect());
        }
        for pair in rings.windows(2) {
            let node = |ring: &[usize], k: usize| ring[k % ring.len()];
            let (inner, outer) = (&pair[0], &pair[1]);
            self.surface
                .extend((0..SECTORS).map(|k| [node(inner, k), node(outer, k), node(outer, k + 1), node(inner, k + 1)]));
        }
    }

    /// The walls at x = ± `half` of a box `breadth` broad.
    fn walls(&mut self, case: &Case, [half, breadth]: [f64; 2]) {
        for side in [1.0, -1.0] {
            let (first, at) = (self.nodes.len(), [side, 0.0]);
            for (level, z) in self.heights.clone().into_iter().enumerate() {
                for k in 0..COLUMNS {
                    // From the right to the left seen from inside, so that the outer face is counter-clockwise.
                    let y = side * breadth * (k as f64 / (COLUMNS - 1) as f64 - 0.5);
                    self.push([side * half, y, z], Spot::Wall { level, at });
                }
            }
            let node = |level: usize, k: usize| first + level * COLUMNS + k;
            for level in 0..self.heights.len() - 1 {
                let thickness = self.thickness(case, level);
                for k in 0..COLUMNS - 1 {
                    self.wall.push([node(level, k), node(level, k + 1), node(level + 1, k + 1), node(level + 1, k)]);
                    self.cells.push(Cell { level, at, thickness });
                }
            }
        }
        let z = case.liquid.fill_height;
        let radii = self.radii.clone();
        let mirrored = radii.iter().enumerate().skip(1).rev().map(|(ring, r)| (ring, -1.0, *r));
        let own = radii.iter().enumerate().map(|(ring, r)| (ring, 1.0, *r));
        let lines: Vec<(usize, f64, f64)> = mirrored.chain(own).collect();
        let first = self.nodes.len();
        for &(ring, side, r) in &lines {
            for k in 0..COLUMNS {
                let y = breadth * (k as f64 / (COLUMNS - 1) as f64 - 0.5);
                self.push([side * r, y, z], Spot::Surface { ring, at: [side, 0.0] });
            }
        }
        let node = |line: usize, k: usize| first + line * COLUMNS + k;
        for line in 0..lines.len() - 1 {
            self.surface.extend(
                (0..COLUMNS - 1).map(|k| [node(line, k), node(line + 1, k), node(line + 1, k + 1), node(line, k + 1)]),
            );
        }
    }

    /// The walls at y = ± `across` of a box, which the model takes as rigid.
    fn sides(&mut self, [half, across]: [f64; 2]) {
        let (foot, top) = (0.0, self.heights.last().copied().unwrap_or_default());
        for side in [1.0, -1.0] {
            // The outer face is counter-clockwise.
            let corners = [[side * half, foot], [-side * half, foot], [-side * half, top], [side * half, top]];
            let cell = corners.map(|[x, z]| self.push([x, side * across, z], Spot::Rigid));
            self.sides.push(cell);
        }
    }

    /// Displacement of every node in a vector of one harmonic.
    pub(super) fn shape(&self, coupled: &Coupled, vector: &[f64]) -> Vec<[f64; 3]> {
        let rows = &coupled.shape_rows;
        let value = |row: &SparseRow| row.iter().map(|&(i, c)| c * vector[i]).sum::<f64>();
        let node = |spot: &Spot| match *spot {
            Spot::Wall { level, at: [c, s] } => {
                let i = self.levels[level];
                let [u, v] = rows.tangential[i].each_ref().map(value);
                let [even, odd] = if coupled.harmonic == 0 { [1.0, 0.0] } else { [c, s] };
                let (out, around) = (value(&rows.wall[i]) * even, v * odd);
                [out * c - around * s, out * s + around * c, u * even]
            }
            Spot::Surface { ring, at } => {
                let even = if coupled.harmonic == 0 { 1.0 } else { at[0] };
                [0.0, 0.0, elevation(coupled, self.radii[ring]).map_or(0.0, value) * even]
            }
            Spot::Rigid => [0.0; 3],
        };
        self.spots.iter().map(node).collect()
    }
}

/// Row of the elevation at a radius of the mesh.
pub(super) fn elevation(coupled: &Coupled, r: f64) -> Option<&SparseRow> {
    let rows = &coupled.shape_rows;
    let same = |other: f64| (other - r).abs() <= 1e-9 * r.max(1e-9);
    let place = rows.r.iter().position(|other| same(*other));
    place.and_then(|i| rows.surface.get(i)).or_else(|| rows.closing.as_ref().filter(|c| same(c.0)).map(|c| &c.1))
}

/// Places of the levels that are drawn: joints of courses, the level of the liquid and the ends; others not closer than a share of the height.
fn levels(case: &Case, z: &[f64]) -> Vec<usize> {
    let height = case.tank.wall_height();
    let joints = case.tank.courses.iter().scan(0.0, |top, course| {
        *top += course.height;
        Some(*top)
    });
    let fixed: Vec<f64> = joints.chain([0.0, case.liquid.fill_height]).collect();
    let held = |place: f64| fixed.iter().any(|other| (other - place).abs() <= 2e-6 * height);
    let mut kept: Vec<usize> = Vec::new();
    for (i, &place) in z.iter().enumerate() {
        let before = kept.last().map_or(f64::NEG_INFINITY, |k| z[*k]);
        if held(place) || i + 1 == z.len() || place - before >= CLOSEST * height {
            kept.push(i);
        }
    }
    kept
}
