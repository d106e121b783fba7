//! Observables of a tank in three dimensions, as rows over the unknowns of its model.
//!
//! Signs and places as in the harmonic engine: tension positive, liquid pressure positive in compression, reactions positive
//! as inertia forces of a positive acceleration, values at θ = 0. Wall resultants are those of the two elements next to
//! θ = 0, averaged; under horizontal motion those of a cylinder vary with cos θ exactly, so that the mean divided by cos(π/N) is the
//! value at θ = 0. θ = 0 and 180° of a rectangle are the middles of the walls across the shaking.
//!
//! Stresses at the base are reactions: nodal force and moment of the clamped edge over its length, less the load applied at
//! the node (the inertia of the elements above).

mod reactions;

use std::collections::BTreeMap;

use fem::assembly::Assembler;
use fem::dofs::{Dof, KINDS};
use fem::element::Inspect;
use fem::element::reference_mass;
use fem::linalg::dot;

use super::model::TankModel;
use crate::coupled::SparseRow;
use tank::options::solid::Liquid;

/// A linear functional y = d · x + a · ẍ_total + b a_g over the unknowns of a model.
///
/// Potentials in `acceleration` multiply φ̈ of the whole motion.
#[derive(Clone, Debug, Default, PartialEq)]
pub(super) struct Row {
    /// d.
    pub displacement: SparseRow,
    /// a.
    pub acceleration: SparseRow,
    /// b: share of the held nodes, which follow the ground.
    pub held: f64,
}

impl Row {
    /// A row of displacements.
    pub(super) fn of_displacement(displacement: SparseRow) -> Row {
        Row { displacement, ..Row::default() }
    }

    /// factor × the row.
    pub(super) fn scaled(mut self, factor: f64) -> Row {
        let all = self.displacement.iter_mut().chain(&mut self.acceleration);
        all.for_each(|(_, c)| *c *= factor);
        self.held *= factor;
        self
    }
}

/// Σ c x over a sparse row.
pub(super) fn sparse_dot(row: &[(usize, f64)], x: &[f64]) -> f64 {
    row.iter().map(|&(i, c)| c * x[i]).sum()
}

fn sparse(row: &[f64]) -> SparseRow {
    let entries = row.iter().enumerate().filter(|(_, c)| **c != 0.0);
    entries.map(|(i, c)| (i, *c)).collect()
}

/// Field of a rigid motion of the ground, at every node in global components.
pub(super) type Field<'a> = &'a dyn Fn(usize) -> [f64; KINDS];

/// Natural coordinate of the Gauss points of a shell.
const GAUSS: f64 = 0.577_350_269_189_625_8;

/// Resultants of the wall.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Resultant {
    /// Hoop force n_φ.
    Hoop,
    /// Meridional force n_v.
    Axial,
    /// Meridional moment m_v.
    Moment,
    /// Moment m_φ along the circumference: the horizontal one of a plate.
    Around,
    /// Membrane shear n_φv.
    Shear,
    /// Twisting moment m_φv.
    Twist,
}

impl Resultant {
    fn name(self) -> &'static str {
        match self {
            Resultant::Hoop => "n_11",
            Resultant::Axial => "n_22",
            Resultant::Moment => "m_22",
            Resultant::Around => "m_11",
            Resultant::Shear => "n_12",
            Resultant::Twist => "m_12",
        }
    }
}

/// Makes rows of one tank for one direction of the ground motion.
pub(super) struct Observer<'a> {
    /// The tank.
    pub tank: &'a TankModel,
    /// Harmonic of the load: 1 along x, 0 along z, and of a rectangle 2 along y.
    pub harmonic: u32,
}

impl Observer<'_> {
    fn row(&self, node: usize, dof: Dof) -> SparseRow {
        self.tank.model.row(node, dof)
    }

    /// Rigid motion of the ground with unit acceleration.
    pub(super) fn ground(&self) -> [f64; KINDS] {
        let mut field = [0.0; KINDS];
        let direction = match self.harmonic {
            1 => 0,
            // The motions of a rectangle that are odd about y = 0.
            2 if !self.tank.is_round() => 1,
            _ => 2,
        };
        field[direction] = 1.0;
        field
    }

    /// Wave height at the radius `r` (negative: at θ = 180°).
    pub(super) fn elevation(&self, r: f64) -> Row {
        let radii = &self.tank.division.radii;
        let line = &self.tank.lines[usize::from(r < 0.0)];
        let dof = match line.first() {
            Some(&n) if self.tank.model.dofs().equation(n, Dof::Eta).is_some() => Dof::Eta,
            _ => Dof::Uz,
        };
        let at = r.abs().min(radii[radii.len() - 1]);
        let upper = radii.partition_point(|x| *x < at).clamp(1, radii.len() - 1);
        let share = (at - radii[upper - 1]) / (radii[upper] - radii[upper - 1]);
        let mut out = SparseRow::new();
        for (ring, weight) in [(upper - 1, 1.0 - share), (upper, share)] {
            if weight != 0.0 {
                out.extend(self.row(line[ring], dof).into_iter().map(|(i, c)| (i, weight * c)));
            }
        }
        Row::of_displacement(out)
    }

    /// Wave height at the corner x, y > 0 of a rectangle: the highest node numbers in both directions of the surface's grid.
    pub(super) fn corner_elevation(&self) -> Row {
        let Some(&node) = self.tank.volume.surface_nodes.last() else { return Row::default() };
        let dof = match self.tank.model.dofs().equation(node, Dof::Eta) {
            Some(_) => Dof::Eta,
            None => Dof::Uz,
        };
        Row::of_displacement(self.row(node, dof))
    }

    /// Radial displacement of the wall at a level of its nodes.
    pub(super) fn radial_displacement(&self, level: usize) -> Row {
        Row::of_displacement(self.row(self.tank.wall.rows[level][0], Dof::Ux))
    }

    /// Sectors and their shares in a value at θ = 0.
    pub(super) fn middle(&self) -> Vec<(usize, f64)> {
        let share = 0.5 / self.tank.beside(self.harmonic);
        vec![(0, share), (self.tank.division.sectors - 1, share)]
    }

    /// Sectors and their shares in a value at θ [rad] of a cylinder: on the curve a cos θ + b sin θ through the centres of two of them.
    pub(super) fn at_angle(&self, theta: f64) -> Vec<(usize, f64)> {
        let count = self.tank.division.sectors;
        let step = std::f64::consts::TAU / count as f64;
        let place = theta.rem_euclid(std::f64::consts::TAU) / step - 0.5;
        let lower = place.floor();
        let share = |distance: f64| (step * distance).sin() / step.sin();
        let sector = |k: f64| (k.rem_euclid(count as f64) as usize).min(count - 1);
        vec![(sector(lower), share(lower + 1.0 - place)), (sector(lower + 1.0), share(place - lower))]
    }

    /// Sectors of the wall at θ = 0 of a rectangle, and their shares in a value at its corner: on the straight line through the centres of
    /// the last two.
    pub(super) fn corner(&self) -> Vec<(usize, f64)> {
        let y = &self.tank.division.breadth;
        let last = y.len() - 1;
        let Some(before) = last.checked_sub(2) else { return vec![(0, 1.0)] };
        let share = (y[last] - y[last - 1]) / (y[last] - y[before]);
        vec![(last - 1, 1.0 + share), (last - 2, -share)]
    }

    /// A combination Σ c × resultant of elements of a level of the wall, with shares, at the natural height s: from the centre (s = 0) or
    /// by the straight line through the Gauss points.
    fn within(
        &self,
        (level, s): (usize, f64),
        at: &[(usize, f64)],
        terms: &[(Resultant, f64)],
        out: &mut BTreeMap<usize, f64>,
    ) {
        let (wall, sectors) = (&self.tank.wall, self.tank.division.sectors);
        // The first sample of each name is that of the centre, then come the Gauss points at s = −A, −A, A, A.
        let slope = 0.25 * s / GAUSS;
        let weights = if s == 0.0 {
            [1.0, 0.0, 0.0, 0.0, 0.0]
        } else {
            [0.0, 0.25 - slope, 0.25 - slope, 0.25 + slope, 0.25 + slope]
        };
        for &(sector, share) in at {
            let element = &*self.tank.model.elements()[wall.elements[level * sectors + sector]];
            let samples = element.samples();
            for &(resultant, factor) in terms {
                let own = samples.iter().filter(|sample| sample.name == resultant.name());
                for (sample, weight) in own.zip(weights).filter(|(_, w)| *w != 0.0) {
                    for (i, c) in self.tank.model.spread(element, &sample.row) {
                        *out.entry(i).or_insert(0.0) += share * factor * weight * c;
                    }
                }
            }
        }
    }

    /// A resultant at the height z in a course whose elements are the levels `course`.
    ///
    /// Meridional force and moment are best at the centres of elements and linear between them. The hoop strain is best
    /// at nodes: n_φ = (n_φ − ν n_v) + ν n_v with the first part, E t ε_φ, from the element and the second from centres.
    pub(super) fn resultant(
        &self,
        course: &std::ops::Range<usize>,
        z: f64,
        (resultant, at): (Resultant, &[(usize, f64)]),
        poisson: f64,
    ) -> Row {
        let nodes = &self.tank.wall.z;
        let middle = |level: usize| 0.5 * (nodes[level] + nodes[level + 1]);
        let mut row = BTreeMap::new();
        let meridional = match resultant {
            Resultant::Hoop => (Resultant::Axial, poisson),
            other => (other, 1.0),
        };
        if course.len() == 1 {
            self.within((course.start, 0.0), at, &[meridional], &mut row);
        } else {
            let upper =
                course.clone().find(|&level| middle(level) >= z).unwrap_or(course.end - 1).max(course.start + 1);
            let share = (z - middle(upper - 1)) / (middle(upper) - middle(upper - 1));
            for (level, weight) in [(upper - 1, 1.0 - share), (upper, share)] {
                self.within((level, 0.0), at, &[(meridional.0, weight * meridional.1)], &mut row);
            }
        }
        if resultant == Resultant::Hoop {
            let tolerance = 1e-9 * nodes[nodes.len() - 1];
            let beside: Vec<usize> =
                course.clone().filter(|&l| nodes[l] <= z + tolerance && nodes[l + 1] >= z - tolerance).collect();
            for &level in &beside {
                let s = (2.0 * (z - middle(level)) / (nodes[level + 1] - nodes[level])).clamp(-1.0, 1.0);
                let share = 1.0 / beside.len() as f64;
                let terms = [(Resultant::Hoop, share), (Resultant::Axial, -poisson * share)];
                // Exactly at the centre the centre's own sample serves.
                self.within((level, s), at, &terms, &mut row);
            }
        }
        Row::of_displacement(row.into_iter().collect())
    }

    /// Hydrodynamic pressure on the wall at a level of the liquid's nodes: −ρ φ̈, or the pressure in the joint.
    pub(super) fn pressure(&self, level: usize) -> Row {
        let node = self.tank.volume.wall_nodes[level][0];
        match self.tank.liquid {
            Liquid::Potential => {
                Row { acceleration: scaled(self.row(node, Dof::Phi), -self.tank.density), ..Row::default() }
            }
            Liquid::Displacement => {
                // Nodes of wall and liquid lie together.
                let mut row = scaled(self.row(node, Dof::Ux), self.tank.joint);
                let wall = self.tank.wall.rows[level][0];
                row.extend(scaled(self.row(wall, Dof::Ux), -self.tank.joint));
                Row::of_displacement(row)
            }
        }
    }

    /// κᵀ M ẍ of a field κ over wall, roof and liquid.
    pub(super) fn inertia(&self, field: Field) -> Row {
        let tank = self.tank;
        let ground = self.ground();
        let acceleration = tank.assembler.inertia(&tank.model, field);
        let rigid = tank.model.vector(|_| ground);
        // Contribution of the held nodes alone: κᵀ M ι without the share of the unknowns.
        let whole = product(tank, field, &|_| ground);
        let held = whole - dot(&acceleration, &rigid);
        Row { acceleration: sparse(&acceleration), held, ..Row::default() }
    }
}

fn scaled(row: SparseRow, factor: f64) -> SparseRow {
    row.into_iter().map(|(i, c)| (i, factor * c)).collect()
}

/// aᵀ M b of two fields, held nodes included.
fn product(tank: &TankModel, a: Field, b: Field) -> f64 {
    let mut sum = 0.0;
    for element in tank.model.elements().iter().filter(|e| e.has_mass()) {
        let values = |field: Field| -> Vec<f64> {
            let mut out = Vec::new();
            for (k, &node) in element.nodes().iter().enumerate() {
                let global = field(node);
                out.extend(element.dofs(k).iter().map(|d| global[d.index()]));
            }
            out
        };
        let m = reference_mass(&**element).to_matrix();
        sum += dot(&values(a), &m.times(&values(b)));
    }
    sum
}

/// Rotation about the y axis through the centre of the base: u_x = z, u_z = −x.
pub(super) fn tilt(position: [f64; 3]) -> [f64; KINDS] {
    let mut field = [0.0; KINDS];
    (field[0], field[2], field[4]) = (position[2], -position[0], 1.0);
    field
}

/// Load of gravity and hydrostatic pressure on the unknowns of the wall, downwards and outwards.
pub(super) fn static_load(tank: &TankModel, assembler: &Assembler) -> Vec<f64> {
    let mut load = assembler.body_force(&tank.model, [0.0, 0.0, -tank.gravity]);
    let dofs = tank.model.dofs();
    let wall_nodes = tank.wall.rows.len() * tank.division.sectors;
    for (e, f) in load.iter_mut().enumerate() {
        // The liquid's own weight is in its pressure.
        if dofs.unknown(e).0 >= wall_nodes {
            *f = 0.0;
        }
    }
    let mut pressure = fem::element::shell::load::NodalLoads::new();
    for face in &tank.wall.faces {
        let positions = face.nodes.map(|n| tank.model.nodes()[n]);
        let weight = tank.density * tank.gravity;
        pressure.pressure(&face.nodes, &positions, |p| weight * (tank.depth - p[2]).max(0.0));
    }
    for (f, p) in load.iter_mut().zip(pressure.vector(&tank.model)) {
        *f += p;
    }
    load
}
