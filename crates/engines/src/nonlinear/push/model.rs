//! The shell of a pushover: one half of the wall between its planes of symmetry.
//!
//! Angles run from θ = 0, the compressed side, to π in a geometric series whose first element is a quarter of the last. Levels
//! follow the edge bending, of which √(R t) is the measure: 0.15 √(R t) at the base, 0.4 √(R t) at the joints of the courses and at
//! the surface, at most 1.3 √(R t), growing by 15 % an element. The wall is free at its top but for stiffening rings; a roof is mass without stiffness. At its
//! base the wall of an anchored tank is clamped, that of an unanchored one stands on its bottom (`bottom`).

use std::f64::consts::PI;
use std::sync::Arc;

use fem::assembly::{Assembler, order};
use fem::dofs::Dof;
use fem::element::shell::load::{FollowerPressure, NodalLoads};
use fem::element::shell::surface::{Normals, ShellCell, ShellSurface};
use fem::element::shell4::Axes;
use fem::element::wall::place::Build;
use fem::element::{Motion, Response, Trial, Want};
use fem::linalg::Symbolic;
use fem::mesh::grading::geometric;
use fem::model::{Builder, Model};
use nalgebra::{Matrix3, UnitQuaternion, Vector3};
use tank::Case;
use tank::{Behaviour, Course, Shape, Support};

use super::imperfection::Dent;
use super::load::Impulsive;
use crate::FeError;
use crate::checks::check_depth;
use crate::nonlinear::arcs::{cosine_shares, shares};
use crate::nonlinear::bottom::{self, Placed, Plate};
use crate::nonlinear::cylinder::mesh::enough_rows;
use crate::nonlinear::cylinder::section::row;
use crate::nonlinear::laws::unsupported;
use crate::solid::mesh::based_levels;
use crate::solid::ring::{Circle, add_beams, level_at};
use tank::options::nonlinear::NonlinearOptions;

/// Default number of sectors of the full circle.
pub(super) const SECTORS: u32 = 96;
/// Last over first element around the half circle.
const GRADING: f64 = 4.0;
/// Element length at the base over √(R t).
pub(super) const BASE: f64 = 0.15;

/// The model with its loads.
pub(super) struct PushModel {
    pub(super) model: Model,
    pub(super) assembler: Assembler,
    pub(super) symbolic: Arc<Symbolic>,
    /// Weight.
    pub(super) weight: Vec<f64>,
    /// Inertia forces of wall, fittings and roof under 1 m/s².
    pub(super) inertia: Vec<f64>,
    /// Pressure of the liquid at the wetted nodes.
    pub(super) wet: Vec<WetNode>,
    /// Nodes `rings[level][angle]`.
    pub(super) rings: Vec<Vec<usize>>,
    /// Elements `cells[level][sector]`.
    pub(super) cells: Vec<Vec<usize>>,
    pub(super) levels: Vec<f64>,
    pub(super) angles: Vec<f64>,
    /// The bottom of an unanchored tank.
    pub(super) bottom: Option<Placed>,
}

/// Forces of the liquid at a node.
#[derive(Clone, Debug)]
pub(super) struct WetNode {
    /// Displacement along the pressure: (unknown, coefficient).
    row: Vec<(usize, f64)>,
    /// Impulsive force of 1 m/s² [N], along the pressure.
    impulsive: f64,
    /// Hydrostatic force [N].
    rest: f64,
    /// Horizontal force along x of a force along the pressure, and its height [m].
    direction: f64,
    height: f64,
    /// Lever of a downward force about the axis through the centre [m]; 0 on the wall.
    lever: f64,
}

impl WetNode {
    /// A node of the bottom; its pressure is vertical.
    pub(super) fn on_bottom(row: Vec<(usize, f64)>, impulsive: f64, rest: f64, lever: f64) -> WetNode {
        WetNode { row, impulsive, rest, direction: 0.0, height: 0.0, lever }
    }

    /// Impulsive force at an acceleration: the liquid does not pull.
    fn force(&self, acceleration: f64) -> f64 {
        (acceleration * self.impulsive).max(-self.rest)
    }
}

impl PushModel {
    /// Load at an acceleration, and its derivative there.
    pub(super) fn load(&self, acceleration: f64) -> (Vec<f64>, Vec<f64>) {
        let mut slope = self.inertia.clone();
        let mut load: Vec<f64> = slope.iter().map(|f| acceleration * f).collect();
        for node in &self.wet {
            let force = node.force(acceleration);
            let pulls = acceleration * node.impulsive < -node.rest;
            for &(e, c) in &node.row {
                load[e] += c * force;
                slope[e] += if pulls { 0.0 } else { c * node.impulsive };
            }
        }
        (load, slope)
    }

    /// Moment of the impulsive pressure on half of the bottom that presses the toe down [N m].
    pub(super) fn on_bottom(&self, acceleration: f64) -> f64 {
        self.wet.iter().map(|node| node.lever * node.force(acceleration)).sum()
    }

    /// Reaction [N] of an element of the ground under a node that is `up` above it [m].
    pub(super) fn ground_force(&self, element: usize, up: f64) -> f64 {
        let mut out = Response::sized(3);
        let rotations = [UnitQuaternion::identity()];
        let motion = Motion { values: &[0.0, 0.0, up], rotations: &rotations };
        let ground = &self.model.elements()[element];
        // Friction, which has a history, does not change the reaction.
        let (old, mut new) = (vec![0.0; ground.history_len()], vec![0.0; ground.history_len()]);
        match ground.respond(Trial { motion, old: &old, new: &mut new, want: Want::FORCE }, &mut out) {
            Ok(()) => -out.force[2],
            Err(_) => f64::NAN,
        }
    }

    /// Horizontal force of the liquid on the whole wall, and its moment about the base.
    pub(super) fn liquid(&self, acceleration: f64) -> (f64, f64) {
        // Two halves.
        self.wet.iter().fold((0.0, 0.0), |sum, node| {
            let force = 2.0 * node.direction * node.force(acceleration);
            (sum.0 + force, sum.1 + force * node.height)
        })
    }
}

/// A material of the wall that a pushover does not take.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
#[error(
    "materials.{material}.behaviour: found {found}, allowed steel with its yield strength: the capacity of a pushover is that of a \
         plate that yields"
)]
pub struct NoSteel {
    /// Its name in the file.
    pub material: String,
    /// Its behaviour, as users name it.
    pub found: &'static str,
}

impl NoSteel {
    /// The first of a tank: concrete, which fails in other ways than by a buckle, or an elastic wall, which never yields.
    pub fn of(case: &Case) -> Option<NoSteel> {
        let layers = case.tank.courses.iter().flat_map(Course::build_up);
        let mut materials = layers.map(|l| l.material);
        let other = materials.find(|m| !matches!(m.behaviour, Behaviour::Steel(_)))?;
        Some(NoSteel { found: other.behaviour.kind(), material: other.name })
    }
}

/// Input of the model.
pub(super) struct Plan<'a> {
    pub(super) case: &'a Case,
    pub(super) options: &'a NonlinearOptions,
    pub(super) radius: f64,
    pub(super) levels: Vec<f64>,
    pub(super) angles: Vec<f64>,
    pub(super) impulsive: Impulsive,
    /// The bottom of an unanchored tank.
    pub(super) plate: Option<Plate>,
    /// Whether the foot of an unanchored tank stays a plane ([`super::PushOptions::plane_foot`]).
    pub(super) plane: bool,
}

fn failed(error: impl std::fmt::Display) -> FeError {
    FeError::Analysis(error.to_string())
}

impl<'a> Plan<'a> {
    /// Errors: a tank that is not a cylinder, or is unanchored without a bottom plate of steel; an option out of range.
    pub(super) fn new(case: &'a Case, options: &'a NonlinearOptions, plane: bool) -> Result<Plan<'a>, FeError> {
        let Shape::Cylinder { radius } = case.tank.shape else {
            return unsupported("a pushover is for cylinders (shape cylinder); this tank is a rectangle");
        };
        if let Some(no_steel) = NoSteel::of(case) {
            return unsupported(no_steel.to_string());
        }
        check_depth(case)?;
        let sectors = options.elements.map_or(SECTORS, |e| e.circumference);
        if sectors < 8 || sectors % 2 == 1 {
            return Err(FeError::option(
                "analysis.nonlinear.elements.circumference",
                sectors.to_string(),
                "an even number for a pushover, whose model is half the wall; 8 or more",
            ));
        }
        let depth = case.liquid.fill_height;
        let rows = |refine: f64| based_levels(&case.tank, depth, BASE, refine);
        let levels = options.elements.map_or_else(|| rows(1.0), |e| enough_rows(rows, e.height as usize));
        let angles = geometric(0.0, PI, (sectors / 2) as usize, GRADING).map_err(failed)?;
        let impulsive = Impulsive::new(case, radius, &levels)?;
        let plate = match case.tank.support {
            Support::Anchored => None,
            Support::Unanchored => {
                let plate = Plate::of(case, radius, options.bottom_mesh)?;
                // As on the shells, whose liquid does not pull.
                Some(Plate { base: plate.base.clone().without_pull(), ..plate })
            }
        };
        Ok(Plan { plate, plane, case, options, radius, levels, angles, impulsive })
    }

    /// The model, with its imperfection.
    pub(super) fn build(&self, imperfection: Option<&Dent>) -> Result<PushModel, FeError> {
        let case = self.case;
        let (levels, angles) = (&self.levels, &self.angles);
        let mut builder = Builder::new();
        let (rings, normals) = self.nodes(&mut builder, imperfection);
        let mut corners = self.wall_cells(&rings)?;
        let pressed: Vec<[usize; 4]> = corners.iter().map(|c| c.nodes).collect();
        let of_wall = corners.len();
        let plates = match (&self.plate, &case.tank.bottom) {
            (Some(plate), Some(bottom)) => {
                let nodes = plate.nodes(&mut builder, angles, &rings[0]);
                let (cells, bending) = plate.cells(bottom, &nodes, &self.options.integration)?;
                corners.extend(cells);
                Some((plate, nodes, bending))
            }
            _ => None,
        };
        let normal = |cell: usize, node: usize| if cell < of_wall { normals[node] } else { Vector3::z() };
        let surface =
            ShellSurface { normals: Normals::Exact(&normal), axes: Axes::HOOP_Z, ..ShellSurface::new(corners) };
        let placed = surface.place(&mut builder).map_err(failed)?;
        let mut dead = NodalLoads::new();
        self.hydrostatic(&mut builder, &pressed, &mut dead);
        self.hold(&mut builder, &rings);
        let sectors = angles.len() - 1;
        let bottom = match plates {
            Some((plate, rings, bending)) => {
                let follower = self.options.follower_pressure;
                let ground = plate.place(&mut builder, angles, &rings, [follower, true, false], &mut dead)?;
                if plate.friction.is_none() {
                    bottom::hold::keep_in_place(&mut builder, angles, &rings[plate.foot], &case.tank.courses[0])?;
                }
                if self.plane {
                    bottom::hold::keep_plane(&mut builder, angles, &rings[plate.foot])?;
                }
                let own = &placed.elements[of_wall..];
                let at = |nodes: &Vec<usize>| nodes.iter().map(|n| -dead.at(*n)[Dof::Uz.index()]).collect();
                let rest = rings.iter().map(at).collect();
                Some(Placed {
                    cells: own.chunks(sectors).map(<[usize]>::to_vec).collect(),
                    rings,
                    ground,
                    rest,
                    bending,
                })
            }
            None => None,
        };
        add_beams(&case.tank, levels, |level| self.circle(&rings[level]), "ring", &mut builder)?;
        let carried = self.carried(&rings);
        let model = builder.build().map_err(failed)?;
        let assembler = Assembler::new(&model);
        let symbolic =
            Arc::new(Symbolic::new(assembler.pattern().clone(), &order(&model, assembler.pattern())).map_err(failed)?);
        let mut weight = dead.vector(&model);
        if self.options.self_weight {
            add(&mut weight, &assembler.body_force(&model, [0.0, 0.0, -case.gravity]));
            add(&mut weight, &carried.0.vector(&model));
        }
        let mut inertia = assembler.body_force(&model, [1.0, 0.0, 0.0]);
        add(&mut inertia, &carried.1.vector(&model));
        let mut wet = self.wet(&model, &rings);
        if let (Some(plate), Some(bottom)) = (&self.plate, &bottom) {
            wet.extend(on_bottom(plate, &model, angles, &bottom.rings));
        }
        Ok(PushModel {
            bottom,
            cells: placed.elements[..of_wall].chunks(sectors).map(<[usize]>::to_vec).collect(),
            rings,
            levels: levels.clone(),
            angles: angles.clone(),
            model,
            assembler,
            symbolic,
            weight,
            inertia,
            wet,
        })
    }

    /// Adds the nodes of the wall, ring by ring from the base; with the normal of each.
    fn nodes(&self, builder: &mut Builder, imperfection: Option<&Dent>) -> (Vec<Vec<usize>>, Vec<Vector3<f64>>) {
        let mut normals = Vec::new();
        let mut rings = Vec::with_capacity(self.levels.len());
        for (l, &z) in self.levels.iter().enumerate() {
            let ring = self.angles.iter().enumerate().map(|(k, &angle)| {
                let (s, c) = angle.sin_cos();
                let perfect = (Vector3::zeros(), Vector3::new(c, s, 0.0));
                let (offset, normal) = imperfection.map_or(perfect, |d| d.at((l, k), angle, z));
                let place = Vector3::new(self.radius * c, self.radius * s, z) + offset;
                let node = builder.node(place.into());
                builder.frame(node, Matrix3::new(c, s, 0.0, -s, c, 0.0, 0.0, 0.0, 1.0));
                normals.push(normal);
                node
            });
            rings.push(ring.collect::<Vec<usize>>());
        }
        (rings, normals)
    }

    /// Shells between the rings of the wall.
    ///
    /// Errors: a wall of two shells; laws that shells do not have.
    fn wall_cells(&self, rings: &[Vec<usize>]) -> Result<Vec<ShellCell>, FeError> {
        let (case, angles) = (self.case, &self.angles);
        let mut joints = Vec::new();
        for course in &case.tank.courses {
            joints.push(joints.last().copied().unwrap_or(0.0) + course.height);
        }
        let mut cells = Vec::new();
        let length = self.radius * (angles[1] - angles[0]);
        for (z, pair) in self.levels.windows(2).zip(rings.windows(2)) {
            let middle = 0.5 * (z[0] + z[1]);
            let course = joints.iter().position(|top| middle < *top).unwrap_or(joints.len() - 1);
            let layers = case.tank.courses[course].build_up();
            let Build::Shell(leaf) = row(&layers, [length, z[1] - z[0]], &self.options.integration, None)?.build else {
                return unsupported("a pushover supports walls of one shell, not of two with an interlayer");
            };
            for k in 0..angles.len() - 1 {
                cells.push(ShellCell {
                    nodes: [pair[0][k], pair[0][k + 1], pair[1][k + 1], pair[1][k]],
                    section: leaf.section.clone(),
                    group: "wall".into(),
                });
            }
        }
        Ok(cells)
    }

    /// ρ g (H − z), bilinear over every element.
    fn hydrostatic(&self, builder: &mut Builder, cells: &[[usize; 4]], dead: &mut NodalLoads) {
        let liquid = &self.case.liquid;
        for &nodes in cells {
            let positions = nodes.map(|n| builder.position(n));
            let at = |z: f64| liquid.density * self.case.gravity * (liquid.fill_height - z).max(0.0);
            let pressure = positions.map(|p| at(p[2]));
            if pressure.iter().all(|p| *p <= 0.0) {
                continue;
            }
            let change = FollowerPressure::varying(nodes, positions, pressure);
            if self.options.follower_pressure && self.plate.is_none() {
                builder.element("pressure", change);
            } else if self.options.follower_pressure {
                // Applied in steps, as contact needs them.
                dead.pressure(&nodes, &positions, |p| at(p[2]));
                builder.element("pressure", change.without_dead_part());
            } else {
                dead.pressure(&nodes, &positions, |p| at(p[2]));
            }
        }
    }

    fn hold(&self, builder: &mut Builder, rings: &[Vec<usize>]) {
        let free_foot = usize::from(self.plate.is_some());
        for ring in &rings[free_foot..] {
            for &node in ring.first().into_iter().chain(ring.last()) {
                builder.hold(node, Dof::Uy);
                builder.hold(node, Dof::Ry);
            }
        }
        // The bottom holds its own.
        if self.plate.is_some() {
            return;
        }
        for &node in &rings[0] {
            for dof in [Dof::Ux, Dof::Uy, Dof::Uz, Dof::Rx, Dof::Ry] {
                builder.hold(node, dof);
            }
        }
    }

    /// The nodes of a level.
    fn circle(&self, nodes: &[usize]) -> Circle {
        Circle { nodes: nodes.to_vec(), angles: self.angles.clone(), half: true, radius: self.radius }
    }

    /// Weights of roof, rings and attachments, and their inertia forces under 1 m/s² along x, over the halves of the levels of nodes next to
    /// them.
    fn carried(&self, rings: &[Vec<usize>]) -> (NodalLoads, NodalLoads) {
        let tank = &self.case.tank;
        let roof = (tank.roof.mass, tank.roof.on_wall(), tank.roof_height(), rings.len() - 1);
        let fittings = tank.carried().map(|(mass, height)| (mass, mass, height, level_at(&self.levels, height)));
        let (mut weight, mut inertia) = (NodalLoads::new(), NodalLoads::new());
        for (mass, weighs, height, level) in std::iter::once(roof).chain(fittings).filter(|(mass, ..)| *mass > 0.0) {
            let (per_angle, lever) = (mass / (2.0 * PI), height - self.levels[level]);
            let around = rings[level].iter().zip(shares(&self.angles)).zip(cosine_shares(&self.angles));
            for ((&node, share), cosine) in around {
                weight.force(node, [0.0, 0.0, -weighs / (2.0 * PI) * share * self.case.gravity]);
                // The moment m d presses the level with (m d)/(π R²) cos θ.
                let tilt = mass * lever / (PI * self.radius) * cosine;
                inertia.force(node, [per_angle * share, 0.0, -tilt]);
            }
        }
        (weight, inertia)
    }

    fn wet(&self, model: &Model, rings: &[Vec<usize>]) -> Vec<WetNode> {
        let liquid = &self.case.liquid;
        let (levels, angles) = (&self.levels, &self.angles);
        let mut out = Vec::new();
        for (l, ring) in rings.iter().enumerate().filter(|(l, _)| self.impulsive.line[*l] > 0.0) {
            // ∫ ρ g (H − z) N_l dz between the middles of the two elements next to the level.
            let half = |a: f64, b: f64, share: f64| {
                let head = liquid.fill_height - (a + share * (b - a));
                0.5 * (b - a) * liquid.density * self.case.gravity * head.max(0.0)
            };
            let below = if l > 0 { half(levels[l - 1], levels[l], 2.0 / 3.0) } else { 0.0 };
            let above = if l + 1 < levels.len() { half(levels[l], levels[l + 1], 1.0 / 3.0) } else { 0.0 };
            let all = angles.iter().zip(cosine_shares(angles)).zip(shares(angles));
            for (&node, ((angle, cosine), share)) in ring.iter().zip(all) {
                let part = |dof, c: f64| model.row(node, dof).into_iter().map(move |(e, own)| (e, c * own));
                let radial = part(Dof::Ux, angle.cos()).chain(part(Dof::Uy, angle.sin())).collect();
                out.push(WetNode {
                    row: radial,
                    impulsive: self.impulsive.line[l] * self.radius * cosine,
                    rest: (below + above) * self.radius * share,
                    direction: angle.cos(),
                    height: levels[l],
                    lever: 0.0,
                });
            }
        }
        out
    }
}

/// Pressure of the liquid at the nodes of the plate.
fn on_bottom(plate: &Plate, model: &Model, angles: &[f64], rings: &[Vec<usize>]) -> Vec<WetNode> {
    let mut out = Vec::new();
    let all = rings.iter().zip(plate.wet_areas()).zip(&plate.impulsive).zip(&plate.radii);
    for (((ring, area), p), radius) in all.filter(|(((_, area), _), _)| *area > 0.0) {
        let shares = cosine_shares(angles).into_iter().zip(shares(angles));
        for ((&node, (cosine, share)), angle) in ring.iter().zip(shares).zip(angles) {
            let down = model.row(node, Dof::Uz).into_iter().map(|(e, c)| (e, -c)).collect();
            let rest = plate.base.pressure * area * share;
            out.push(WetNode::on_bottom(down, p * area * cosine, rest, radius * angle.cos()));
        }
    }
    out
}

fn add(to: &mut [f64], what: &[f64]) {
    to.iter_mut().zip(what).for_each(|(a, b)| *a += b);
}
