//! Both walls and the liquid between them in one model: displacement elements, joined to the walls by contact elements.
//!
//! ```text
//!   wall at −L     liquid, one element across     wall at +L
//!     ┃│□□□□□□□□□□□□□□□□□□□□□□□□□□□□□□□□□│┃        │ contact8, one a wet element of the wall
//!     ┃│□□□□□□□□□□□□□□□□□□□□□□□□□□□□□□□□□│┃        □ fluid8 in plane motion: u_y = 0, the same at y = 0 and y = 1 m
//!     ┻┷━━━━━━━━━━━━━━━━━━━━━━━━━━━━━━━━━┷┻        bottom: u_z = 0, free along it
//! ```
//!
//! The liquid is linear, so that a cell of it is a [`SuperElement`] over two displacements of four nodes, assembled once. Walls are in axes of
//! their own ([`PlacedWall`]): the ground moves the second one by −a, and its contact elements turn its components.
//!
//! With elastic walls and bonded joints the motion is antisymmetric, and one wall under the record of either sign would be enough. Cracks and
//! open joints break the symmetry: the hydrostatic pressure bends the walls apart, the earthquake bends both to one side. The model therefore
//! always has both walls.
//!
//! Modes, and the frequencies that damping is fitted to, are those of the condensed liquid: among the modes of the elements there are hundreds
//! of circulations that the rotation penalty alone resists.
//!
//! Source: [B02, 5.2, 7.3 and 8.4].

use std::sync::Arc;

use fem::analysis::damping::{Damping, Rayleigh};
use fem::analysis::failed;
use fem::analysis::observable::{Observable, apply};
use fem::analysis::system::System;
use fem::assembly::Assembler;
use fem::chart::Chart;
use fem::dofs::{Dof, KINDS};
use fem::element::contact8::{Contact8, ContactLaw, Opening};
use fem::element::liquid_joint::RESIDUAL;
use fem::element::super_element::SuperElement;
use fem::element::{
    Element, Fluid8, FreeSurface, LiquidProperties, LocalMatrix, RotationPart, VolumePart, reference_mass,
    reference_stiffness,
};
use fem::linalg::{Matrix, Ordering, Symbolic};
use fem::mesh::{Face, Hexahedron};
use fem::model::{Builder, Model};
use fem::state::{Fields, State};

use super::contact::{self, JOINT, Touch};
use super::model::{LIQUID, StripModel, by_group};
use super::parameters::{Contact, LiquidMesh, StripError, StripTank};
use super::parts::{StripDamping, base_rows, coefficients};
use super::placed::PlacedWall;
use super::shell_wall::BREADTH;

/// Displacements of a node of the liquid that are free.
const PLANE: [Dof; 2] = [Dof::Ux, Dof::Uz];

/// The liquid between both walls.
pub struct Chain {
    /// The strip with the condensed, bonded liquid, of which the modes are.
    pub(super) closed: Box<StripModel>,
    /// Nodes of the liquid from −L to L, each column upwards.
    columns: Vec<Vec<usize>>,
    /// Their places [m].
    places: Vec<f64>,
    /// Numbers of the joints of the walls at L and −L, upwards.
    joints: [Vec<usize>; 2],
    /// Moments of the ground on the halves of the bottom next to them, in the axes of the walls.
    bottom: [Observable; 2],
    /// k_n [N/m³].
    pub penalty: f64,
    /// Whether joints open.
    pub opens: bool,
    /// Wet levels [m].
    pub heights: Vec<f64>,
    /// Length of the wall that belongs to each [m].
    pub shares: Vec<f64>,
}

/// A wet level of a wall at an instant.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct WetLevel {
    /// Pressure and gap there.
    pub touch: Touch,
    /// Vertical displacement of the liquid [m].
    pub rise: f64,
}

/// Properties of the elements.
fn properties(tank: &StripTank, mesh: &LiquidMesh) -> LiquidProperties {
    let liquid = &tank.liquid;
    let split = LiquidProperties::new(liquid.density, mesh.bulk_modulus, liquid.gravity, liquid.half_width);
    match mesh.rotation_penalty {
        None => split,
        Some(penalty) => {
            LiquidProperties { volume: VolumePart::OnePoint, rotation: RotationPart::Full(penalty), ..split }
        }
    }
}

/// A matrix over the three displacements of the corners as one over [`PLANE`] of the places that the corners share.
fn in_plane(matrix: &LocalMatrix, corners: &[usize], places: usize) -> Matrix {
    let mut out = Matrix::zeros(2 * places, 2 * places);
    for (a, &p) in corners.iter().enumerate() {
        for (b, &q) in corners.iter().enumerate() {
            for (i, &row) in PLANE.iter().enumerate() {
                for (j, &column) in PLANE.iter().enumerate() {
                    out.add(2 * p + i, 2 * q + j, matrix.get(3 * a + row.index(), 3 * b + column.index()));
                }
            }
        }
    }
    out
}

/// Nodes of the liquid with its elements, and the nodal forces of its weight along [`PLANE`].
struct Liquid {
    columns: Vec<Vec<usize>>,
    places: Vec<f64>,
    weight: Vec<(usize, [f64; 2])>,
}

/// Corners of a cell among its four places: lower left, lower right, upper left, upper right.
const CELL: [usize; 8] = [0, 1, 1, 0, 2, 3, 3, 2];

/// Adds the liquid up to the level number `top`.
///
/// Errors: those of the elements.
fn liquid(builder: &mut Builder, tank: &StripTank, mesh: &LiquidMesh, top: usize) -> Result<Liquid, StripError> {
    let (half, levels) = (tank.liquid.half_width, &tank.levels[..=top]);
    let own = properties(tank, mesh);
    let place = |c: usize| half * (2.0 * c as f64 / mesh.columns as f64 - 1.0);
    let places: Vec<f64> = (0..=mesh.columns).map(place).collect();
    let mut columns = Vec::new();
    for &x in &places {
        let nodes: Vec<usize> = levels.iter().map(|&z| builder.node([x, 0.0, z])).collect();
        builder.hold(nodes[0], Dof::Uz);
        nodes.iter().for_each(|&n| builder.hold(n, Dof::Uy));
        columns.push(nodes);
    }
    let mut weight = Vec::new();
    for (x, side) in places.windows(2).zip(columns.windows(2)) {
        for (row, z) in levels.windows(2).enumerate() {
            let nodes = [side[0][row], side[1][row], side[0][row + 1], side[1][row + 1]];
            let corner = |k: usize| {
                let [x, z] = [x[CELL[k] % 2], z[CELL[k] / 2]];
                [x, if k % 4 < 2 { 0.0 } else { BREADTH }, z]
            };
            let chart = std::array::from_fn(corner);
            let cell = Fluid8::new(&Hexahedron { nodes: CELL.map(|k| nodes[k]), chart }, Chart::Cartesian, own)?;
            let mut stiffness = in_plane(&reference_stiffness(&cell)?, &CELL, 4);
            if row + 1 == top {
                let face = Face { nodes: [4, 5, 6, 7].map(|k| nodes[CELL[k]]), chart: [4, 5, 6, 7].map(|k| chart[k]) };
                let rho_g = tank.liquid.density * tank.liquid.gravity;
                let surface = match mesh.rotation_penalty {
                    None => FreeSurface::new(&face, Chart::Cartesian, rho_g)?,
                    Some(_) => FreeSurface::at_one_point(&face, Chart::Cartesian, rho_g)?,
                };
                let own = in_plane(&reference_stiffness(&surface)?, &CELL[4..], 4);
                stiffness.data.iter_mut().zip(&own.data).for_each(|(k, s)| *k += s);
            }
            let unknowns: Vec<(usize, Dof)> = nodes.iter().flat_map(|&n| PLANE.map(|dof| (n, dof))).collect();
            let element = SuperElement::over(&unknowns)?
                .with_mass(in_plane(&reference_mass(&cell), &CELL, 4))?
                .with_stiffness(stiffness)?;
            builder.element(LIQUID, element);
            let mut force = [0.0; 24];
            cell.body_force([0.0, 0.0, -tank.liquid.gravity], &mut force);
            weight.extend(CELL.iter().enumerate().map(|(k, &p)| (nodes[p], [force[3 * k], force[3 * k + 2]])));
        }
    }
    Ok(Liquid { columns, places, weight })
}

/// Adds the joints of a wall to the nodes `face` of the liquid, and holds what neither of them has; their numbers.
///
/// Errors: a parameter of the law out of range.
fn joints(
    builder: &mut Builder,
    tank: &StripTank,
    wall: &PlacedWall,
    face: &[usize],
    law: ContactLaw,
) -> Result<Vec<usize>, StripError> {
    let mut numbers = Vec::new();
    for row in 0..face.len() - 1 {
        let [below, above] = [&wall.wet[row], &wall.wet[row + 1]];
        let edge = |level: &[usize]| [level[0], level[level.len() - 1]];
        let ([b0, b1], [a0, a1]) = (edge(below), edge(above));
        let [z0, z1] = [tank.levels[row], tank.levels[row + 1]];
        let bottom = [b0, b1, a1, a0];
        let chart = [[0.0, 0.0, z0], [0.0, BREADTH, z0], [0.0, BREADTH, z1], [0.0, 0.0, z1]];
        let top = [face[row], face[row], face[row + 1], face[row + 1]];
        // From the wall to the liquid.
        let normals = [[-wall.sign, 0.0, 0.0]; 4];
        let joint = Contact8::new(&Face { nodes: bottom, chart }, Chart::Cartesian, top, bottom, normals, law)?;
        let joint = if wall.sign < 0.0 { joint.with_mirrored_bottom() } else { joint };
        bottom.iter().for_each(|&n| builder.hold(n, Dof::Uy));
        numbers.push(builder.element(JOINT, joint));
    }
    Ok(numbers)
}

/// The law of the joints.
fn law(tank: &StripTank, mesh: &LiquidMesh, penalty: f64) -> ContactLaw {
    let bonded = ContactLaw::bonded(penalty).with_tangential(mesh.tangential);
    if !matches!(tank.contact, Contact::Joined { opens: true, .. }) {
        return bonded;
    }
    let law = ContactLaw { opening: Opening::Unilateral { residual: RESIDUAL }, ..bonded }.at_end();
    match mesh.at_place {
        true => law,
        false => law.of_displaced(tank.liquid.density * tank.liquid.gravity),
    }
}

/// Rayleigh's coefficients of every group. A ratio of the sloshing modes is that of the first: the mass of the liquid alone is damped.
fn groups(model: &Model, damping: StripDamping, closed: &StripModel) -> Vec<Rayleigh> {
    let [wall, rest] = coefficients(damping, closed.wall_frequency());
    let liquid = match damping {
        StripDamping::ByGroup { sloshing, .. } => {
            Rayleigh::mass_proportional(closed.tank.liquid.sloshing_frequency(0), sloshing)
        }
        StripDamping::Rayleigh(_) => rest,
    };
    by_group(model, [wall, liquid])
}

/// The model of both walls.
///
/// Errors: those of the elements, and of the strip with the condensed liquid.
// Long: as of the condensed liquid.
pub(super) fn model(tank: &StripTank, mesh: &LiquidMesh, damping: StripDamping) -> Result<StripModel, StripError> {
    let bonded = StripTank { mesh: None, contact: Contact::Bonded, ..tank.clone() };
    let closed = StripModel::new(&bonded, damping)?;
    let top = tank.levels.partition_point(|z| *z < tank.liquid.depth * (1.0 - 1e-9));
    let (penalty, opens) = match tank.contact {
        Contact::Joined { opens, penalty: Some(given) } => (given, opens),
        Contact::Joined { opens, penalty: None } => (contact::penalty(tank)?, opens),
        Contact::Bonded => (contact::penalty(tank)?, false),
    };
    let mut builder = Builder::new();
    let mut walls = Vec::new();
    for sign in [1.0, -1.0] {
        walls.push(PlacedWall::add_to(&mut builder, tank, sign)?);
    }
    let Liquid { columns, places, weight: own_weight } = liquid(&mut builder, tank, mesh, top)?;
    let law = law(tank, mesh, penalty);
    let mut numbers = [Vec::new(), Vec::new()];
    for ((wall, face), numbers) in walls.iter().zip([&columns[columns.len() - 1], &columns[0]]).zip(&mut numbers) {
        *numbers = joints(&mut builder, tank, wall, face, law)?;
        wall.stand(&mut builder, tank)?;
    }
    let model = builder.build()?;
    let assembler = Assembler::new(&model);
    let symbolic = Symbolic::new(assembler.pattern().clone(), &Ordering::MinimumDegree);
    let symbolic = Arc::new(symbolic.map_err(failed("the strip"))?);
    let mut system = System::new(&model, &assembler)?;
    let groups = groups(&model, damping, &closed);
    system.damping = Damping::by_group(&assembler, &model, &groups, false)?;
    for wall in &mut walls {
        wall.base = base_rows(&model, &wall.feet, tank, &groups)?;
        wall.carried = wall.base.each_ref().map(|row| row.total_ground(&system.influence));
    }
    let bottom = bottom(&model, &system, &columns, &places, &groups)?;
    // The second wall moves against its own axis.
    let against = walls[1].owned.clone();
    let along = |node: usize| {
        let mut field = [0.0; KINDS];
        field[0] = if against.contains(&node) { -1.0 } else { 1.0 };
        field
    };
    system.influence[0] = model.vector(along);
    system.inertia[0] = assembler.inertia(&model, along);
    let weight = assembler.body_force(&model, [0.0, 0.0, -tank.liquid.gravity]);
    let pressure = in_order(&model, &own_weight);
    let heights = tank.levels[..=top].to_vec();
    let length = |i: usize| if i == 0 || i > top { 0.0 } else { heights[i] - heights[i - 1] };
    let shares = (0..=top).map(|i| 0.5 * (length(i) + length(i + 1))).collect();
    Ok(StripModel {
        model,
        assembler,
        symbolic,
        system,
        modes: closed.modes.clone(),
        wall_mode: closed.wall_mode,
        ratios: closed.ratios.clone(),
        weight,
        pressure,
        walls,
        face: Vec::new(),
        joints: None,
        liquid: closed.liquid.clone(),
        tank: tank.clone(),
        amplitudes: Vec::new(),
        chain: Some(Chain {
            closed: Box::new(closed),
            columns,
            places,
            joints: numbers,
            bottom,
            penalty,
            opens,
            heights,
            shares,
        }),
    })
}

/// Nodal forces along [`PLANE`] as a load.
fn in_order(model: &Model, forces: &[(usize, [f64; 2])]) -> Vec<f64> {
    let mut out = vec![0.0; model.dofs().len()];
    for (node, force) in forces {
        for (dof, f) in PLANE.into_iter().zip(force) {
            if let Some(e) = model.dofs().equation(*node, dof) {
                out[e] += f;
            }
        }
    }
    out
}

/// Moments of the ground on both halves of the bottom about y, in the axes of their walls; their part of the ground is that along the tank's axes.
///
/// Errors: those of the elements.
fn bottom(
    model: &Model,
    system: &System,
    columns: &[Vec<usize>],
    places: &[f64],
    groups: &[Rayleigh],
) -> Result<[Observable; 2], StripError> {
    let half = |sign: f64| -> Result<Observable, StripError> {
        let field = |node: usize| {
            let mut out = [0.0; KINDS];
            if let Some(c) = columns.iter().position(|column| column[0] == node) {
                out[Dof::Uz.index()] = -(sign * places[c]).max(0.0);
            }
            out
        };
        let row = Observable::reaction(model, "moment of the bottom", field, |e| groups[model.group_of(e)])?;
        Ok(Observable { ground: row.total_ground(&system.influence), ..row })
    };
    Ok([half(1.0)?, half(-1.0)?])
}

impl Chain {
    /// Joints of every wall in the model.
    pub fn joint_numbers(&self) -> &[Vec<usize>; 2] {
        &self.joints
    }

    /// Column of the liquid at the wall number `wall`.
    fn face(&self, wall: usize) -> &[usize] {
        &self.columns[if wall == 0 { self.columns.len() - 1 } else { 0 }]
    }

    /// Moment of the bottom next to wall number `wall` [N]; `ground`: acceleration of the ground along the axes of the tank [m/s²].
    pub fn bottom_moment(&self, wall: usize, fields: &Fields, ground: [f64; 3]) -> f64 {
        let row = &self.bottom[wall];
        let carried: f64 = row.ground.iter().zip(ground).map(|(c, a)| c * a).sum();
        apply(&row.displacement, &fields.u)
            + apply(&row.velocity, &fields.v)
            + apply(&row.acceleration, &fields.a)
            + carried
    }

    /// The wet levels of wall number `wall` in the committed `state`.
    pub fn look(&self, strip: &StripModel, wall: usize, state: &State) -> Vec<WetLevel> {
        let (model, u, own) = (&strip.model, &state.committed.u, &strip.walls[wall]);
        let rho_g = strip.tank.liquid.density * strip.tank.liquid.gravity;
        let relieved = strip.tank.mesh.is_some_and(|mesh| self.opens && !mesh.at_place);
        let levels = self.face(wall).iter().zip(&own.wet);
        levels
            .map(|(&node, wet)| {
                let at = model.at_node(u, node);
                let moved: f64 = wet.iter().map(|&n| model.at_node(u, n)[Dof::Ux.index()]).sum();
                let gap = moved / wet.len() as f64 - own.sign * at[Dof::Ux.index()];
                let rise = at[Dof::Uz.index()];
                let relief = if relieved { -rho_g * rise } else { 0.0 };
                let shifted = gap - relief / self.penalty;
                let open = self.opens && shifted > 0.0;
                let touch = Touch {
                    pressure: if open { -relief } else { -self.penalty * gap },
                    gap: if open { shifted } else { 0.0 },
                    penetration: (-gap).max(0.0),
                };
                WetLevel { touch, rise }
            })
            .collect()
    }

    /// Elevation of the surface at the wall at L as a row over the unknowns.
    pub(super) fn elevation(&self, model: &Model) -> Vec<(usize, f64)> {
        let face = self.face(0);
        model.row(face[face.len() - 1], Dof::Uz)
    }

    /// Elevation of the surface at `lines` places from the middle to wall number `wall` [m].
    pub fn surface(&self, strip: &StripModel, wall: usize, u: &[f64], lines: usize) -> Vec<f64> {
        let half = strip.tank.liquid.half_width;
        let (sign, cells) = (strip.walls[wall].sign, (self.places.len() - 1) as f64);
        let rise = |column: usize| {
            let nodes = &self.columns[column];
            strip.model.at_node(u, nodes[nodes.len() - 1])[Dof::Uz.index()]
        };
        let at = |i: usize| {
            let x = sign * half * i as f64 / (lines - 1) as f64;
            let place = (0.5 * (x / half + 1.0) * cells).clamp(0.0, cells);
            let left = (place as usize).min(self.places.len() - 2);
            let part = place - left as f64;
            (1.0 - part) * rise(left) + part * rise(left + 1)
        };
        (0..lines).map(at).collect()
    }

    /// Mean settlement of the surface [m].
    pub fn settlement(&self, strip: &StripModel, u: &[f64]) -> f64 {
        let rises = self.columns.iter().map(|nodes| strip.model.at_node(u, nodes[nodes.len() - 1])[Dof::Uz.index()]);
        let rises: Vec<f64> = rises.collect();
        -rises.windows(2).map(|pair| 0.5 * (pair[0] + pair[1])).sum::<f64>() / (rises.len() - 1) as f64
    }

    /// Wall whose node this is, if it is one of a wall.
    pub fn wall_of(&self, strip: &StripModel, node: usize) -> Option<usize> {
        strip.walls.iter().position(|wall| wall.owned.contains(&node))
    }

    /// Mass of the liquid in a translation along x [kg per m].
    pub fn liquid_mass(&self, strip: &StripModel) -> f64 {
        let first = self.columns[0][0];
        let last = self.columns[self.columns.len() - 1].iter().copied().max().unwrap_or(first);
        let field = |node: usize| {
            let mut out = [0.0; KINDS];
            out[0] = f64::from((first..=last).contains(&node));
            out
        };
        strip.assembler.inertia_between(&strip.model, field, field)
    }
}
