//! A liquid whose face has its own displacement, joined to the wall.
//!
//! ```text
//! e = a − w at every wet level         F = k e ≥ −s·x ,  k = k_n ∫ N dz of the level's hat function N
//! s·x = −ρ g ∫ N u_z dz ,   u_z = Σ q_n sin(k_n L) sinh(k_n z)/sinh(k_n H)       vertical displacement of the particle at the wall
//! ```
//!
//! The face is linear between the levels: one joint for every unknown of it. With a cubic face and joints at its Gauss points
//! the set of closed points is not clear any more, and Newton's method runs round among several.
//!
//! u_z leaves out the part of the deflection of the wall itself: millimetres against decimetres of waves that can separate.

use std::sync::Arc;

use fem::analysis::failed;
use fem::assembly::Assembler;
use fem::dofs::Dof;
use fem::element::fibre_beam::FibreBeam;
use fem::element::liquid_joint::{JointPoint, LiquidJoint, PENALTY};
use fem::linalg::{Kind, Ordering, Symbolic};
use fem::model::{Builder, Model};
use fem::shape::gauss;
use fem::state::{Gather, State};

use super::parameters::{StripError, StripTank};
use super::parts::WALL_DOFS;

/// Group of the joints.
pub(super) const JOINT: &str = "joint";

/// The joints of a wall.
#[derive(Clone, Debug)]
pub struct Joints {
    /// k_n [N/m³].
    pub penalty: f64,
    /// Whether they open.
    pub opens: bool,
    /// Heights of the joints [m], upwards.
    pub heights: Vec<f64>,
    /// Length of the wall that belongs to each [m].
    pub shares: Vec<f64>,
    /// Mean pressure at rest on it [Pa].
    pub at_rest: Vec<f64>,
    /// Numbers in the model, and the elements.
    pub elements: Vec<(usize, LiquidJoint)>,
}

/// A point of a joint at an instant.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Touch {
    /// Whole pressure on the wall [Pa].
    pub pressure: f64,
    /// Distance of liquid and wall [m]; 0 as long as they touch.
    pub gap: f64,
    /// By how much the penalty gives way [m].
    pub penetration: f64,
}

/// Nodes of the liquid's face: one at each level up to the first at or above the surface.
pub(super) fn face(builder: &mut Builder, tank: &StripTank) -> Vec<usize> {
    let wet = tank.levels.partition_point(|z| *z < tank.liquid.depth * (1.0 - 1e-9));
    let levels = &tank.levels[..=wet.min(tank.levels.len() - 1)];
    let nodes: Vec<usize> = levels.iter().map(|&z| builder.node([0.0, 0.0, z])).collect();
    builder.hold(nodes[0], Dof::Ux);
    nodes
}

/// k_n = [`PENALTY`] p/w: pressure at the bottom over the largest deflection of the initial wall under the pressure at rest.
///
/// Errors: those of the elements; a wall without pressure.
pub(super) fn penalty(tank: &StripTank) -> Result<f64, StripError> {
    let mut builder = Builder::new();
    let wall: Vec<usize> = tank.levels.iter().map(|&z| builder.node([0.0, 0.0, z])).collect();
    for dof in [Dof::Ux, Dof::Uz, Dof::Ry] {
        builder.hold(wall[0], dof);
    }
    for (ends, section) in wall.windows(2).zip(&tank.sections) {
        FibreBeam::add_to(&mut builder, "wall", [ends[0], ends[1]], section.clone(), tank.options)?;
    }
    let model = builder.build()?;
    let assembler = Assembler::new(&model);
    let stiffness = assembler.stiffness(&model)?;
    let symbolic = Symbolic::new(assembler.pattern().clone(), &Ordering::MinimumDegree);
    let wrong = || failed("the wall under the pressure at rest");
    let factor = Arc::new(symbolic.map_err(wrong())?).factor(&stiffness, Kind::QuasiDefinite).map_err(wrong())?;
    let hydrostatic = tank.liquid.on_wall(&tank.levels, 0).hydrostatic;
    let mut load = vec![0.0; model.dofs().len()];
    for (pair, &node) in hydrostatic.chunks_exact(2).zip(&wall) {
        for (&force, &dof) in pair.iter().zip(WALL_DOFS) {
            if let Some(e) = model.dofs().equation(node, dof) {
                load[e] += force;
            }
        }
    }
    let u = factor.solve_vector(&load).map_err(wrong())?;
    let deflections = wall.iter().map(|&n| model.at_node(&u, n)[Dof::Ux.index()].abs());
    let pressure = tank.liquid.density * tank.liquid.gravity * tank.liquid.depth;
    Ok(PENALTY * pressure / deflections.fold(0.0, f64::max))
}

impl Joints {
    /// Between the nodes of the wall at each level, of the face and of the amplitudes.
    ///
    /// Errors: a penalty that is not positive.
    pub(super) fn add_to(
        builder: &mut Builder,
        tank: &StripTank,
        wall: &[Vec<usize>],
        [face, amplitudes]: [&[usize]; 2],
        penalty: f64,
        opens: bool,
    ) -> Result<Joints, StripError> {
        let liquid = &tank.liquid;
        let mut out = Joints {
            penalty,
            opens,
            heights: Vec::new(),
            shares: Vec::new(),
            at_rest: Vec::new(),
            elements: Vec::new(),
        };
        let weight = liquid.density * liquid.gravity;
        let rise = |n: usize, z: f64| {
            let k = liquid.wave_number(n);
            (k * liquid.half_width).sin() * (k * z).sinh() / (k * liquid.depth).sinh()
        };
        // ∫ N dz, ∫ N p₀ dz and ∫ N u_z dz of every level.
        let mut shares = vec![0.0; face.len()];
        let mut forces = vec![0.0; face.len()];
        let mut rises = vec![vec![0.0; amplitudes.len()]; face.len()];
        for e in 0..face.len() - 1 {
            let (from, to) = (tank.levels[e], tank.levels[e + 1]);
            let wet = to.min(liquid.depth) - from;
            for &(x, w) in gauss::FIVE {
                let (z, dz) = (from + 0.5 * wet * (1.0 + x), 0.5 * wet * w);
                let upper = (z - from) / (to - from);
                for (i, shape) in [(e, 1.0 - upper), (e + 1, upper)] {
                    shares[i] += dz * shape;
                    forces[i] += dz * shape * weight * (liquid.depth - z);
                    for (n, sum) in rises[i].iter_mut().enumerate() {
                        *sum += dz * shape * rise(n, z);
                    }
                }
            }
        }
        for (i, (share, rises)) in shares.into_iter().zip(&rises).enumerate().skip(1) {
            out.heights.push(tank.levels[i]);
            out.shares.push(share);
            out.at_rest.push(forces[i] / share);
            let mut unknowns = vec![(face[i], Dof::Ux)];
            unknowns.extend(wall[i].iter().map(|&n| (n, Dof::Ux)));
            let own = unknowns.len();
            unknowns.extend(amplitudes.iter().map(|&n| (n, Dof::Amplitude)));
            let mut closing = vec![(0, 1.0)];
            closing.extend((1..own).map(|k| (k, -1.0 / wall[i].len() as f64)));
            let point = JointPoint {
                closing,
                relief: rises.iter().enumerate().map(|(n, r)| (own + n, -weight * r)).collect(),
                stiffness: penalty * share,
            };
            let joint = LiquidJoint::new(&unknowns, vec![point], opens)?;
            out.elements.push((builder.element(JOINT, joint.clone()), joint));
        }
        Ok(out)
    }

    /// States of all points in the committed `state`.
    pub fn look(&self, model: &Model, state: &State) -> Vec<Touch> {
        let mut gather = Gather::default();
        let mut out = Vec::with_capacity(self.heights.len());
        for (e, joint) in &self.elements {
            let motion = gather.motion(model, &state.committed, joint);
            for point in joint.look(motion.values, &state.old[state.history(*e)]) {
                out.push(Touch {
                    pressure: point.force / self.shares[out.len()],
                    gap: point.gap,
                    penetration: point.closing.max(0.0),
                });
            }
        }
        out
    }
}
