//! A liquid whose face has a displacement of its own, joined to the wall.
//!
//! ```text
//! e = a − w at four Gauss points of every wet element         F = k e ≥ −s·x ,  k = k_n times the length of the point
//! s·x = −ρ g u_z ,   u_z = Σ q_n sin(k_n L) sinh(k_n z)/sinh(k_n H)       vertical displacement of the particle at the wall
//! ```
//!
//! u_z leaves out what the deflection of the wall itself adds: millimetres against decimetres of waves that can part.

use std::sync::Arc;

use super::model::WALL_DOFS;
use super::{PENALTY, StripError, StripTank};
use crate::analysis::failed;
use crate::assembly::Assembler;
use crate::dofs::Dof;
use crate::element::fibre_beam::FibreBeam;
use crate::element::liquid_joint::{JointPoint, LiquidJoint};
use crate::linalg::{Kind, Ordering, Symbolic};
use crate::model::{Builder, Model};
use crate::shape::{gauss, line};
use crate::state::{Gather, State};

/// Group of the joints.
pub(super) const JOINT: &str = "joint";

/// The joints of a wall.
#[derive(Clone, Debug)]
pub struct Joints {
    /// k_n [N/m³].
    pub penalty: f64,
    /// Whether they open.
    pub opens: bool,
    /// Heights of the points [m], element after element.
    pub heights: Vec<f64>,
    /// Length of the wall that belongs to each [m].
    pub shares: Vec<f64>,
    /// Numbers in the model, and the elements.
    pub(crate) elements: Vec<(usize, LiquidJoint)>,
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

/// k_n = [`PENALTY`] p/w: pressure at the bottom over the largest deflection of the virgin wall under the pressure at rest.
///
/// Errors: those of the elements; a wall that carries nothing.
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
    let factor = Arc::new(symbolic.map_err(wrong())?)
        .factor(&stiffness, Kind::QuasiDefinite)
        .map_err(wrong())?;
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
    /// Between the nodes of wall, face and amplitudes.
    ///
    /// Errors: a penalty that is not positive.
    pub(super) fn add_to(
        builder: &mut Builder,
        tank: &StripTank,
        [wall, face, amplitudes]: [&[usize]; 3],
        penalty: f64,
        opens: bool,
    ) -> Result<Joints, StripError> {
        let liquid = &tank.liquid;
        let mut out = Joints {
            penalty,
            opens,
            heights: Vec::new(),
            shares: Vec::new(),
            elements: Vec::new(),
        };
        let weight = liquid.density * liquid.gravity;
        for e in 0..face.len() - 1 {
            let (from, to) = (tank.levels[e], tank.levels[e + 1]);
            let (length, wet) = (to - from, to.min(liquid.depth) - from);
            let mut unknowns: Vec<(usize, Dof)> = Vec::new();
            for nodes in [face, wall] {
                unknowns.extend(
                    nodes[e..=e + 1]
                        .iter()
                        .flat_map(|&n| WALL_DOFS.iter().map(move |&d| (n, d))),
                );
            }
            unknowns.extend(amplitudes.iter().map(|&n| (n, Dof::Amplitude)));
            let mut points = Vec::new();
            for &(x, w) in gauss::FOUR {
                let z = from + 0.5 * wet * (1.0 + x);
                let share = 0.5 * wet * w;
                let [shape, ..] = line::hermite(2.0 * (z - from) / length - 1.0, length);
                let rise = |n: usize| {
                    let k = liquid.wave_number(n);
                    (k * liquid.half_width).sin() * (k * z).sinh() / (k * liquid.depth).sinh()
                };
                points.push(JointPoint {
                    closing: (0..4).flat_map(|i| [(i, shape[i]), (4 + i, -shape[i])]).collect(),
                    relief: (0..amplitudes.len())
                        .map(|n| (8 + n, -weight * share * rise(n)))
                        .collect(),
                    stiffness: penalty * share,
                });
                out.heights.push(z);
                out.shares.push(share);
            }
            let joint = LiquidJoint::new(&unknowns, points, opens)?;
            out.elements.push((builder.element(JOINT, joint.clone()), joint));
        }
        Ok(out)
    }

    /// What all points do in the committed `state`.
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
