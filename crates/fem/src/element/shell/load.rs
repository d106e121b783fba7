//! Loads on shells: pressure on faces, line loads on edges, nodal loads.
//!
//! ```text
//! f_a = ∫ p N_a (x,r × x,s) dr ds                                             positive along the normal
//! K_p(a, b) = ∫ p N_a (−skew(x,s) N_b,r + skew(x,r) N_b,s) dr ds              K = K_int − K_p
//! ```
//!
//! K_p is unsymmetric element by element and symmetric after assembly on a closed or edge-fixed surface with constant p;
//! its symmetric part is used. Dead loads take the reference geometry.

use std::collections::BTreeMap;

use nalgebra::Vector3;

use super::geometry::{base, blend};
use crate::dofs::{Dof, KINDS};
use crate::element::{Element, ElementError, Response, Trial};
use crate::model::Model;
use crate::shape::{gauss, quad4};

/// Forces [N] and moments [N m] at nodes, global components.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct NodalLoads(BTreeMap<usize, [f64; KINDS]>);

impl NodalLoads {
    /// No load.
    pub fn new() -> NodalLoads {
        NodalLoads::default()
    }

    /// Adds a force.
    pub fn force(&mut self, node: usize, force: [f64; 3]) {
        let to = self.0.entry(node).or_insert([0.0; KINDS]);
        (0..3).for_each(|i| to[i] += force[i]);
    }

    /// Adds a moment. On a smooth node only its part normal to the director acts.
    pub fn moment(&mut self, node: usize, moment: [f64; 3]) {
        let to = self.0.entry(node).or_insert([0.0; KINDS]);
        (0..3).for_each(|i| to[3 + i] += moment[i]);
    }

    /// Adds a dead pressure `pressure(position)` [Pa] on a face, positive along its normal (corners counter-clockwise).
    ///
    /// 2 × 2 points: exact for a pressure linear over the face. A liquid level belongs on an edge of the mesh.
    pub fn pressure(&mut self, nodes: &[usize; 4], positions: &[[f64; 3]; 4], pressure: impl Fn([f64; 3]) -> f64) {
        let x = positions.map(Vector3::from);
        for &(r, wr) in gauss::TWO {
            for &(s, ws) in gauss::TWO {
                let n = quad4::value(r, s);
                let [g_r, g_s] = base(&x, r, s);
                let p = pressure(blend(&n, &x).into());
                let force = g_r.cross(&g_s) * (p * wr * ws);
                for (&node, n) in nodes.iter().zip(n) {
                    self.force(node, (force * n).into());
                }
            }
        }
    }

    /// Adds a line load `force(position)` [N/m] along the edge from node `a` to `b`.
    pub fn edge_force(&mut self, nodes: [usize; 2], positions: [[f64; 3]; 2], force: impl Fn([f64; 3]) -> [f64; 3]) {
        let [a, b] = positions.map(Vector3::from);
        let length = (b - a).norm();
        for &(xi, w) in gauss::TWO {
            let n = [0.5 * (1.0 - xi), 0.5 * (1.0 + xi)];
            let value = Vector3::from(force((a * n[0] + b * n[1]).into())) * (0.5 * length * w);
            for (node, n) in nodes.into_iter().zip(n) {
                self.force(node, (value * n).into());
            }
        }
    }

    /// Load at a node.
    pub fn at(&self, node: usize) -> [f64; KINDS] {
        self.0.get(&node).copied().unwrap_or([0.0; KINDS])
    }

    /// Sum of all forces.
    pub fn resultant(&self) -> [f64; 3] {
        let mut sum = [0.0; 3];
        for load in self.0.values() {
            (0..3).for_each(|i| sum[i] += load[i]);
        }
        sum
    }

    /// The load over the unknowns; loads on supports are left out.
    pub fn vector(&self, model: &Model) -> Vec<f64> {
        model.vector(|node| self.at(node))
    }
}

/// Pressure that follows the deformed face; each particle of the face keeps its pressure.
#[derive(Clone, Debug, PartialEq)]
pub struct FollowerPressure {
    nodes: [usize; 4],
    x: [Vector3<f64>; 4],
    /// At the corners [Pa].
    pressure: [f64; 4],
    /// Forces on the undeformed face, which are subtracted.
    dead: Option<[f64; 12]>,
}

impl FollowerPressure {
    /// Pressure [Pa], positive along the normal of the face with corners at `positions` [m].
    pub fn new(nodes: [usize; 4], positions: [[f64; 3]; 4], pressure: f64) -> FollowerPressure {
        FollowerPressure::varying(nodes, positions, [pressure; 4])
    }

    /// The same with its values at the corners, bilinear between them.
    pub fn varying(nodes: [usize; 4], positions: [[f64; 3]; 4], pressure: [f64; 4]) -> FollowerPressure {
        FollowerPressure { nodes, x: positions.map(Vector3::from), pressure, dead: None }
    }

    /// Only the change by deformation: its forces less those on the undeformed face, which belong to a load that is applied
    /// in steps.
    pub fn without_dead_part(mut self) -> FollowerPressure {
        self.dead = None;
        self.dead = Some(self.force(&[0.0; 12]));
        self
    }

    /// Nodal forces, and K_p (unsymmetric; row i, column j at `[i][j]`), at the displacements `u`.
    pub fn force_and_tangent(&self, u: &[f64]) -> ([f64; 12], [[f64; 12]; 12]) {
        (self.force(u), self.tangent(u))
    }

    /// Nodal forces at the displacements `u`.
    fn force(&self, u: &[f64]) -> [f64; 12] {
        let mut force = [0.0; 12];
        self.over_points(u, |weight, n, _, [g_r, g_s]| {
            let normal = g_r.cross(&g_s) * weight;
            for a in 0..4 {
                for i in 0..3 {
                    force[3 * a + i] += n[a] * normal[i];
                }
            }
        });
        for (f, d) in force.iter_mut().zip(self.dead.iter().flatten()) {
            *f -= d;
        }
        force
    }

    fn tangent(&self, u: &[f64]) -> [[f64; 12]; 12] {
        let mut tangent = [[0.0; 12]; 12];
        self.over_points(u, |weight, n, slope, [g_r, g_s]| {
            let (skew_r, skew_s) = (g_r.cross_matrix() * weight, g_s.cross_matrix() * weight);
            for b in 0..4 {
                let turn = skew_r * slope[b][1] - skew_s * slope[b][0];
                for (a, n) in n.iter().enumerate() {
                    for i in 0..3 {
                        for j in 0..3 {
                            tangent[3 * a + i][3 * b + j] += n * turn[(i, j)];
                        }
                    }
                }
            }
        });
        tangent
    }

    /// Hands over each integration point at the displacements `u`: pressure times weight, shape functions, their slopes, tangents of the surface.
    fn over_points(&self, u: &[f64], mut take: impl FnMut(f64, &[f64; 4], &[[f64; 2]; 4], [Vector3<f64>; 2])) {
        let x: [Vector3<f64>; 4] =
            std::array::from_fn(|a| self.x[a] + Vector3::from_column_slice(&u[3 * a..3 * a + 3]));
        for &(r, wr) in gauss::TWO {
            for &(s, ws) in gauss::TWO {
                let (n, slope) = (quad4::value(r, s), quad4::slope(r, s));
                let pressure: f64 = n.iter().zip(&self.pressure).map(|(n, p)| n * p).sum();
                take(pressure * wr * ws, &n, &slope, base(&x, r, s));
            }
        }
    }
}

impl Element for FollowerPressure {
    crate::answers!("follower_pressure", nodes, Dof::TRANSLATIONS; massless);

    fn respond(&self, Trial { motion, want, .. }: Trial<'_>, out: &mut Response) -> Result<(), ElementError> {
        if want.force {
            let force = self.force(motion.values);
            out.force.iter_mut().zip(force).for_each(|(own, force)| *own -= force);
        }
        if want.tangent {
            let tangent = self.tangent(motion.values);
            for i in 0..12 {
                for j in 0..12 {
                    out.tangent.add(i, j, -0.5 * (tangent[i][j] + tangent[j][i]));
                }
            }
        }
        Ok(())
    }
}
