//! Liquid with a separate face, joined to the wall.
//!
//! ```text
//! e = a − w at every wetted node         F = k e ≥ −s·x ,  k = k_n ∫ N dA of the node's shape function N
//! s·x = −ρ g ∫ N u_z dA        u_z of the particle at the wall under the sloshing amplitudes (k tanh kH = ω²/g in each mode)
//! ```
//!
//! a and w are the radial displacements of liquid and wall at the same nodes: one joint for every unknown of the face. The
//! hydrostatic pressure acts on the liquid's face, so that F is the total force. Law of the joints:
//! [`fem::element::liquid_joint`].

use std::collections::BTreeMap;

use fem::dofs::Dof;
use fem::element::liquid_joint::{JointPoint, LiquidJoint};
use fem::element::wall::place::{Footprint, PlacedWall};
use fem::linalg::Matrix;
use fem::liquid::WallLiquid;
use fem::model::{Builder, Model};
use fem::state::{Gather, State};

use crate::FeError;
use crate::error::failed;

/// Group of the joints.
pub(super) const JOINT: &str = "joint";

/// Input of the joints between liquid and wall.
pub(super) struct Join<'a> {
    pub footprint: &'a Footprint,
    pub wall: &'a PlacedWall,
    /// Wetted nodes of the wall and the liquid's nodes at the same places, level by level, the held ones of the base first.
    pub nodes: [&'a [usize]; 2],
    pub amplitudes: &'a [usize],
    pub liquid: &'a WallLiquid,
    pub gravity: f64,
    pub depth: f64,
    /// ρ g [N/m³].
    pub unit_weight: f64,
    /// k_n [N/m³].
    pub penalty: f64,
}

/// The joints of the wall.
pub(crate) struct Joints {
    /// k_n [N/m³].
    pub penalty: f64,
    /// Index of each joint's node among the wetted ones.
    pub numbers: Vec<usize>,
    /// Area of the wall that belongs to each joint [m²].
    pub areas: Vec<f64>,
    /// Height and angle of each joint.
    pub places: Vec<[f64; 2]>,
    elements: Vec<(usize, LiquidJoint)>,
}

impl Join<'_> {
    /// Adds a joint for every wetted node above the base.
    ///
    /// Errors: a penalty that is not positive.
    pub(super) fn add_to(&self, builder: &mut Builder) -> Result<Joints, FeError> {
        let [wall_nodes, face_nodes] = self.nodes;
        let number: BTreeMap<usize, usize> = wall_nodes.iter().enumerate().map(|(i, &n)| (n, i)).collect();
        let modes = self.liquid.omega().len();
        // ∫ N dA and ∫ N u_z dA of every node.
        let mut areas = vec![0.0; wall_nodes.len()];
        let mut rises = Matrix::zeros(modes, wall_nodes.len());
        let gauss = 1.0 / 3.0_f64.sqrt();
        for &cell in &self.footprint.cells {
            let nodes = self.wall.inner_cell(cell);
            let of = nodes.map(|n| number.get(&n).copied());
            let [Some(a), Some(b), Some(c), Some(d)] = of else { continue };
            let positions = nodes.map(|n| builder.position(n));
            for [x, y] in CORNERS {
                let (shape, area, at) = point([gauss * x, gauss * y], &positions);
                let theta = at[1].atan2(at[0]);
                let rise = rise(self.liquid, self.gravity, self.depth, &[at[2]], &[theta]);
                for (i, n) in [a, b, c, d].into_iter().zip(shape) {
                    areas[i] += n * area;
                    for j in 0..modes {
                        rises.add(j, i, n * area * rise.get(0, j));
                    }
                }
            }
        }
        let mut out = Joints {
            penalty: self.penalty,
            numbers: Vec::new(),
            areas: Vec::new(),
            places: Vec::new(),
            elements: Vec::new(),
        };
        let base = self.footprint.levels[0].len();
        for i in base..wall_nodes.len() {
            let mut unknowns = vec![(face_nodes[i], Dof::Ux), (wall_nodes[i], Dof::Ux)];
            unknowns.extend(self.amplitudes.iter().map(|&n| (n, Dof::Amplitude)));
            let point = JointPoint {
                closing: vec![(0, 1.0), (1, -1.0)],
                relief: (0..modes).map(|j| (2 + j, -self.unit_weight * rises.get(j, i))).collect(),
                stiffness: self.penalty * areas[i],
            };
            let joint = LiquidJoint::new(&unknowns, vec![point], true).map_err(failed)?;
            out.elements.push((builder.element(JOINT, joint.clone()), joint));
            let [x, y, z] = builder.position(wall_nodes[i]);
            out.places.push([z, y.atan2(x)]);
            out.numbers.push(i);
            out.areas.push(areas[i]);
        }
        Ok(out)
    }
}

const CORNERS: [[f64; 2]; 4] = [[-1.0, -1.0], [1.0, -1.0], [1.0, 1.0], [-1.0, 1.0]];

/// Bilinear shape functions, area of a quarter and position at the point (ξ, η).
fn point([x, y]: [f64; 2], positions: &[[f64; 3]; 4]) -> ([f64; 4], f64, [f64; 3]) {
    let (mut shape, mut at) = ([0.0; 4], [0.0; 3]);
    let mut tangents = [nalgebra::Vector3::zeros(); 2];
    for (i, ([a, b], p)) in CORNERS.into_iter().zip(positions).enumerate() {
        shape[i] = 0.25 * (1.0 + a * x) * (1.0 + b * y);
        let p = nalgebra::Vector3::from(*p);
        tangents[0] += 0.25 * a * (1.0 + b * y) * p;
        tangents[1] += 0.25 * b * (1.0 + a * x) * p;
        for (sum, p) in at.iter_mut().zip(p.iter()) {
            *sum += shape[i] * p;
        }
    }
    // Weights of the rule are 1.
    (shape, tangents[0].cross(&tangents[1]).norm(), at)
}

impl Joints {
    /// Heights of the joints [m].
    pub(crate) fn heights(&self) -> Vec<f64> {
        self.places.iter().map(|p| p[0]).collect()
    }

    /// Gap and penetration of each joint in the committed `state` [m].
    pub(crate) fn look(&self, model: &Model, state: &State) -> impl Iterator<Item = (f64, f64)> {
        let mut gather = Gather::default();
        let mut out = Vec::with_capacity(self.places.len());
        for (e, joint) in &self.elements {
            let motion = gather.motion(model, &state.committed, joint);
            let seen = joint.look(motion.values, &state.old[state.history(*e)]);
            out.extend(seen.into_iter().map(|p| (p.gap, p.closing.max(0.0))));
        }
        out.into_iter()
    }
}

/// Vertical displacement of the particles at the wall under unit sloshing amplitudes: that of each mode decays from the surface
/// as sinh kz/sinh kH, with ω² = g k tanh kH.
pub(super) fn rise(liquid: &WallLiquid, gravity: f64, depth: f64, heights: &[f64], angles: &[f64]) -> Matrix {
    let mut out = Matrix::zeros(heights.len(), liquid.omega().len());
    for (j, omega) in liquid.omega().iter().enumerate() {
        let k = wave_number(omega * omega / gravity, depth);
        for rim in liquid.rim() {
            let top = rim.row[liquid.wall() + j];
            if top == 0.0 {
                continue;
            }
            for (i, (&z, &theta)) in heights.iter().zip(angles).enumerate() {
                // sinh kz/sinh kH without overflow.
                let decay = (k * (z - depth)).exp() * (1.0 - (-2.0 * k * z).exp()) / (1.0 - (-2.0 * k * depth).exp());
                out.add(i, j, top * (f64::from(rim.harmonic) * theta).cos() * decay);
            }
        }
    }
    out
}

/// k of k tanh kH = `ratio`.
fn wave_number(ratio: f64, depth: f64) -> f64 {
    let mut k = ratio.max((ratio / depth).sqrt());
    for _ in 0..60 {
        let t = (k * depth).tanh();
        let next = k - (k * t - ratio) / (t + k * depth * (1.0 - t * t));
        if (next / k - 1.0).abs() < 1e-14 {
            return next;
        }
        k = next;
    }
    k
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn wave_numbers() {
        for (ratio, depth) in [(0.1, 2.0), (1.0, 1.0), (30.0, 5.0), (1e-3, 0.5)] {
            let k = wave_number(ratio, depth);
            assert!((k * (k * depth).tanh() / ratio - 1.0).abs() < 1e-12);
        }
    }
}
