//! A rigid slab under the wall, its translation and rotation as unknowns of the model, on the ground of the linear engines.
//!
//! ```text
//! unknowns   u relative to the slab, x and R ψ of its underside, R θ of the rocking cone
//! turn       u_r = (z + t) cos θ/R on the wall, y = −cos θ of the liquid's floor, for a unit of R ψ
//!
//! B_x = M ι          B_ψ = M turn          m, S, J: ιᵀ M ι, ιᵀ M turn, turnᵀ M turn, over held nodes as well
//! ```
//!
//! All motion of the model is relative to the slab, whose accelerations act on it as the ground's does ([`fem::analysis::border`]); springs and
//! dashpots are those of [`crate::linear::soil`], so that there is one law. The liquid over the turning floor is that of
//! [`HarmonicLiquid::with_floor`](fem::liquid::HarmonicLiquid::with_floor) under a surface that is held, as in the linear engines. On the whole circle
//! the slab moves along x and y; of half a tank it has half of everything.

use std::f64::consts::FRAC_PI_2;

use fem::analysis::border::Border;
use fem::analysis::march::{Quantity, Reaction};
use fem::dofs::{Dof, KINDS};
use fem::element::super_element::SuperElement;
use fem::linalg::{Matrix, dot};
use fem::liquid::WallLiquid;
use fem::model::{Builder, Model};
use tank::Case;

use super::elements::condense;
use super::mesh::Cells;
use super::model::{CylinderModel, first_sloshing};
use super::recorded::row;
use crate::FeError;
use crate::error::failed;
use crate::linear::soil::{self, Ground, Slab};

/// Group of springs and dashpots below the slab.
pub(super) const SLAB: &str = "slab";
/// Frequency of the spring that holds the internal rotation of the cone, over the first of sloshing, as in the linear engines.
const HELD: f64 = 0.1;

/// A slab on the ground, its nodes in a builder: those of x, R ψ and, of cones, R θ, for each direction.
pub(super) struct Founded {
    pub(super) slab: Slab,
    pub(super) ground: Ground,
    nodes: Vec<Vec<usize>>,
    copies: f64,
}

impl Founded {
    /// The slab on soil of a case, with the liquid over its floor that turns; none on rigid ground.
    ///
    /// Errors: soil out of range; those of the elements.
    pub(super) fn place(
        case: &Case,
        builder: &mut Builder,
        (cells, radius): (&Cells, f64),
        (liquid, operator): (&WallLiquid, bool),
    ) -> Result<Option<(Founded, WallLiquid)>, FeError> {
        let Some(found) = soil::founded(case)? else { return Ok(None) };
        let own = Founded::add(found, builder, (cells.half, radius, first_sloshing(liquid)))?;
        Ok(Some((own, condense(case, cells, operator, &[radius, 0.0])?)))
    }

    /// Adds the ground of a slab; `sloshing`: ω of the first sloshing mode [rad/s].
    ///
    /// Errors: those of the element.
    fn add(
        (slab, ground): (Slab, Ground),
        builder: &mut Builder,
        (half, radius, sloshing): (bool, f64, f64),
    ) -> Result<Founded, FeError> {
        let (copies, axes) = if half { (2.0, 1) } else { (1.0, 2) };
        let size = if ground.inner.is_some() { 3 } else { 2 };
        let [mut mass, mut stiffness, mut damping] = [(); 3].map(|()| Matrix::zeros(size, size));
        let scale = [1.0, 1.0 / radius];
        for (i, a) in scale.iter().enumerate() {
            for (j, b) in scale.iter().enumerate() {
                stiffness.add(i, j, a * b * ground.spring[i][j] / copies);
                damping.add(i, j, a * b * ground.dashpot[i][j] / copies);
            }
        }
        if let Some([inertia, dashpot]) = ground.inner {
            let share = 1.0 / (copies * radius * radius);
            mass.add(2, 2, share * inertia);
            stiffness.add(2, 2, share * inertia * (HELD * sloshing).powi(2));
            for (i, j, sign) in [(1, 1, 1.0), (2, 2, 1.0), (1, 2, -1.0), (2, 1, -1.0)] {
                damping.add(i, j, sign * share * dashpot);
            }
        }
        let mut nodes = Vec::new();
        for _ in 0..axes {
            let own: Vec<usize> = (0..size).map(|_| builder.node([0.0; 3])).collect();
            let unknowns: Vec<(usize, Dof)> = own.iter().map(|&n| (n, Dof::Amplitude)).collect();
            let element = SuperElement::over(&unknowns).and_then(|e| e.with_mass(mass.clone()));
            let element = element.and_then(|e| e.with_stiffness(stiffness.clone()));
            builder.element(SLAB, element.and_then(|e| e.with_damping(damping.clone())).map_err(failed)?);
            nodes.push(own);
        }
        Ok(Founded { slab, ground, nodes, copies })
    }
}

/// The slab of a model.
pub(crate) struct MovingSlab {
    /// The slab, and the ground below it.
    pub slab: Slab,
    /// See [`MovingSlab::slab`].
    pub ground: Ground,
    /// Its motion along x, and on the whole circle along y.
    axes: Vec<Axis>,
    radius: f64,
}

/// Motion of a slab along one direction.
struct Axis {
    /// Equations of the translation and of R ψ.
    unknowns: [usize; 2],
    /// Share of held nodes in base shear and base moment under R ψ̈ = 1.
    held: [f64; 2],
    /// Inertia forces on the liquid's unknowns of a floor that turns with R ψ̈ = 1.
    floor: Vec<f64>,
}

/// Unit motions of everything above the slab in one direction, 0 or 1.
#[derive(Clone, Copy)]
struct Unit {
    direction: usize,
    radius: f64,
    /// Height of the bottom plate over the centre of rotation [m]; none of a translation.
    over: Option<f64>,
}

impl Unit {
    /// Global components at a place.
    fn at(&self, [x, y, z]: [f64; 3]) -> [f64; KINDS] {
        let mut field = [0.0; KINDS];
        let Some(over) = self.over else {
            field[self.direction] = 1.0;
            return field;
        };
        field[self.direction] = (z + over) / self.radius;
        field[Dof::Uz.index()] = -[x, y][self.direction] / self.radius;
        let (axis, turn) = if self.direction == 0 { (Dof::Ry, 1.0) } else { (Dof::Rx, -1.0) };
        field[axis.index()] = turn / self.radius;
        field
    }

    fn field<'a>(&'a self, model: &'a Model) -> impl Fn(usize) -> [f64; KINDS] + 'a {
        move |node| self.at(model.nodes()[node])
    }

    /// Radial displacements of the wetted nodes.
    fn radial(&self, tank: &CylinderModel) -> Vec<f64> {
        let along = |&node: &usize| {
            let [x, y, z] = tank.model.nodes()[node];
            [x, y][self.direction] / x.hypot(y) * self.over.map_or(1.0, |over| (z + over) / self.radius)
        };
        tank.wetted.iter().map(along).collect()
    }
}

impl MovingSlab {
    /// Makes the slab of `tank` move; `over_floor`: its liquid with the ring of the foot and the centre of its floor among the unknowns.
    pub(super) fn install(tank: &mut CylinderModel, founded: Founded, over_floor: &WallLiquid) {
        let Founded { slab, ground, nodes, copies } = founded;
        let radius = tank.radius;
        let mut border = Border { unknowns: Vec::new(), columns: Vec::new(), own: Matrix::zeros(0, 0) };
        let mut blocks = Vec::new();
        let mut axes = Vec::new();
        for (direction, nodes) in nodes.iter().enumerate() {
            let equation = |&node: &usize| tank.model.dofs().equation(node, Dof::Amplitude);
            let all: Vec<usize> = nodes.iter().filter_map(equation).collect();
            let unknowns = [all[0], all[1]];
            let (floor, on_floor) = over_floor_turning(tank, over_floor, direction);
            let [along, turn, plate] =
                [None, Some(slab.thickness), Some(0.0)].map(|over| Unit { direction, radius, over });
            let between = |a: &Unit, b: &Unit| {
                tank.assembler.inertia_between(&tank.model, a.field(&tank.model), b.field(&tank.model))
            };
            let of_floor = |unit: &Unit| dot(&unit.radial(tank), &floor[..tank.wetted.len()]);
            // M turn on the unknowns.
            let mut turned = tank.assembler.inertia(&tank.model, turn.field(&tank.model));
            for (force, equation) in floor.iter().zip(tank.liquid_unknowns()) {
                equation.into_iter().for_each(|e| turned[e] += force);
            }
            let mass = between(&along, &along);
            let first = between(&along, &turn) + of_floor(&along);
            let second = between(&turn, &turn) + 2.0 * of_floor(&turn) + on_floor;
            let above = between(&plate, &turn) + of_floor(&plate);
            let free = |unit: &Unit| dot(&tank.model.vector(unit.field(&tank.model)), &turned);
            let held = [copies * (first - free(&along)), copies * radius * (above - free(&plate))];
            let (t, own) = (slab.thickness, slab.mass() / copies);
            let inertia = (slab.inertia() + ground.trapped_inertia) / (copies * radius * radius);
            let coupling = first + 0.5 * t * own / radius;
            blocks.push([mass + own, coupling, second + inertia]);
            // Nothing but the slab is joined to the cone.
            let apart = vec![vec![0.0; turned.len()]; all.len() - 2];
            border.unknowns.extend(all);
            border.columns.extend([tank.system.inertia[direction].clone(), turned].into_iter().chain(apart));
            axes.push(Axis { unknowns, held, floor });
        }
        let mut own = Matrix::zeros(border.unknowns.len(), border.unknowns.len());
        let stride = border.unknowns.len() / axes.len().max(1);
        for (k, ([mass, coupling, second], axis)) in blocks.into_iter().zip(&axes).enumerate() {
            for (i, j, value) in [(0, 0, mass), (0, 1, coupling), (1, 0, coupling), (1, 1, second)] {
                own.add(stride * k + i, stride * k + j, value);
            }
            let ground = &mut tank.system.inertia[k];
            (ground[axis.unknowns[0]], ground[axis.unknowns[1]]) = (mass, coupling);
        }
        tank.system.border = Some(Border { own, ..border });
        tank.slab = Some(MovingSlab { slab, ground, axes, radius });
    }

    /// A force or moment on the base, with what the motion of the slab adds at held nodes.
    ///
    /// * `direction`: 0 or 1; `moment`: whether it is the moment of that direction
    pub(super) fn carry(
        &self,
        reaction: Reaction,
        tank: &CylinderModel,
        (direction, moment): (usize, bool),
    ) -> Reaction {
        let ground = reaction.carried(&tank.system.influence);
        let share = |(axis, along): (&Axis, f64)| {
            let [translation, turn] = axis.unknowns;
            [(translation, along), (turn, axis.held[usize::from(moment)])]
        };
        let own = self.axes.iter().zip(ground).enumerate().filter(|(k, _)| *k == direction);
        reaction.with_acceleration(own.flat_map(|(_, own)| share(own)).collect())
    }

    /// What the rim of the wall adds to the elevation of the surface over the level at an angle [rad]: it goes down by R ψ at θ = 0.
    pub(super) fn rim(&self, theta: f64) -> impl Iterator<Item = (usize, f64)> + '_ {
        let axes = self.axes.iter().enumerate();
        axes.map(move |(k, axis)| (axis.unknowns[1], (theta - k as f64 * FRAC_PI_2).cos()))
    }

    /// Translation [m] and rotation [rad] along x.
    pub(super) fn motion(&self) -> [Quantity; 2] {
        let unknowns = self.axes.first().map_or([0; 2], |axis| axis.unknowns);
        [
            row("translation of the slab", vec![(unknowns[0], 1.0)]),
            row("rotation of the slab", vec![(unknowns[1], 1.0 / self.radius)]),
        ]
    }

    /// Adds the accelerations of the slab to those of the wetted nodes in `a`, at the heights z and in the directions (cos θ, sin θ) given;
    /// returns the forces of the turning floor on the liquid's unknowns.
    pub(super) fn accelerate(
        &self,
        fields: &[f64],
        a: &mut [f64],
        places: impl Iterator<Item = (f64, [f64; 2])>,
    ) -> Vec<f64> {
        let moves: Vec<[f64; 2]> = self.axes.iter().map(|axis| axis.unknowns.map(|e| fields[e])).collect();
        for (a, (z, direction)) in a.iter_mut().zip(places) {
            for ([along, turn], c) in moves.iter().zip(direction) {
                *a += c * (along + (z + self.slab.thickness) / self.radius * turn);
            }
        }
        let mut out = vec![0.0; self.axes.first().map_or(0, |axis| axis.floor.len())];
        for (axis, [_, turn]) in self.axes.iter().zip(&moves) {
            out.iter_mut().zip(&axis.floor).for_each(|(f, own)| *f += turn * own);
        }
        out
    }
}

/// Inertia forces of a floor that turns with y = −cos θ (direction 0) or −sin θ on the unknowns of the liquid, and on the floor itself.
fn over_floor_turning(tank: &CylinderModel, liquid: &WallLiquid, direction: usize) -> (Vec<f64>, f64) {
    let (wetted, around) = (tank.wetted.len(), tank.footprint.levels[0].len());
    let wall = liquid.wall();
    let mut motion = vec![0.0; wall + liquid.omega().len()];
    for (y, &node) in motion[wetted..wetted + around].iter_mut().zip(&tank.wetted) {
        let [a, b, _] = tank.model.nodes()[node];
        *y = -[a, b][direction] / a.hypot(b);
    }
    let still = vec![0.0; motion.len()];
    let force = liquid.forces(&motion, &still);
    let own = dot(&motion, &force);
    (force[..wetted].iter().chain(&force[wall..]).copied().collect(), own)
}
