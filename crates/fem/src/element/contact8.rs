//! Contact of zero thickness between two faces of four nodes each: a liquid and its wall, or two blocks.
//!
//! ```text
//! gap at node a     g_a = n_a · (u_top,a − u_bottom,a)          n_a points from bottom to top
//! gap               g = Σ N_a g_a
//! traction          t = k_n g where closed (g < 0), r k_n g where open;  bonded: t = k_n g everywhere
//! force             f_top,a = n_a Σ_b A_ab g_b = −f_bottom,a,   A_ab = ∫ k N_a N_b dA
//! tangent           ∂f/∂u = A_ab n_a n_bᵀ with the signs of top and bottom
//! ```
//!
//! **Nodal normals.** On a curved wall two facets meet at a node. With the flat normal of each facet the node has two
//! different normals n₁, n₂; closing both gaps holds two components of the slip and locks the liquid to the wall along the
//! circumference. With one normal a node, taken from the exact geometry or averaged, a slip along the wall is free:
//! Σ N_a n_a · u_a vanishes identically for u_a ⟂ n_a.
//!
//! **Area.** dA comes from the chart of the face: r dθ dz on a cylinder, not the area of the flat facet, so that nodal areas
//! are those of the liquid behind it.
//!
//! **Initial gap.** g_a += g_0,a where the faces do not touch in the reference state.
//!
//! **Augmented Lagrangian.** With a multiplier λ_a (pressure, ≥ 0 where the joint may open) as history at each corner, the
//! gap in all formulas is g_a − λ_a/k_n, and after a solution λ_a ← max(0, λ_a − k_n g_a) (Uzawa): the penetration goes to
//! zero with the given penalty. [`crate::analysis::contact`] runs the passes.
//!
//! **Displaced particles.** The pressure of a liquid of displacements is that at a place; the particle there has p + s, s = −ρ g u_z. Such a
//! joint opens where that falls below zero, t = A (g − s/k_n) + s with s of the step before: a surface that sinks takes no liquid off the wall.
//!
//! **Partly closed faces** are cut at g = 0 (`contact8_area`). The moving boundary does not contribute to the tangent, as
//! the integrand vanishes there. The normals are those of the reference state (small rotations of the face).
//!
//! Penalty: k_n = 10² … 10³ max(K_liquid/h, E t/R²); measured effect in docs/theory/solid-and-contact.md.
//!
//! Source: dissertation, chapter 7; integration after Heinen and its improvement, theory document.

use nalgebra::Vector3;

use super::contact8_area::Gap;
pub use super::contact8_area::Integration;
use super::{
    Contact, Element, ElementError, Inspect, LocalMatrix, Motion, Response, Sample, Trial, not_negative, positive,
    require,
};
use crate::chart::Chart;
use crate::dofs::Dof;
use crate::mesh::Face;
use crate::shape::quad4;

const KIND: &str = "contact8";

/// Forces that the joint transmits.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ContactLaw {
    /// Normal penalty stiffness k_n [N/m³], > 0.
    pub normal_stiffness: f64,
    /// Tangential stiffness k_t [N/m³], ≥ 0 (0 for liquids). It acts on the whole face, open or closed.
    pub tangential_stiffness: f64,
    /// Behaviour of an open joint.
    pub opening: Opening,
    /// How partly closed faces are integrated.
    pub integration: Integration,
    /// Whether each corner keeps a multiplier, four history variables.
    pub augmented: bool,
    /// ρ g of a liquid on top [N/m³]: the joint opens by the pressure of the displaced particle; 0 by that at the place. Takes the place of the
    /// multipliers.
    pub relief: f64,
    /// Whether time steps take the force at their end.
    pub at_end: bool,
}

/// Behaviour of an open joint.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Opening {
    /// It cannot open: tension is transmitted like pressure.
    Bonded,
    /// Only the residual stiffness r k_n acts where g > 0; 0 ≤ r < 1, usually 1e-6.
    Unilateral {
        /// r.
        residual: f64,
    },
}

impl ContactLaw {
    /// Bonded normal to the face, free along it; k_n [N/m³].
    pub fn bonded(normal_stiffness: f64) -> ContactLaw {
        ContactLaw {
            normal_stiffness,
            tangential_stiffness: 0.0,
            opening: Opening::Bonded,
            integration: Integration::Clipped,
            augmented: false,
            relief: 0.0,
            at_end: false,
        }
    }

    /// Pressure only, residual stiffness 1e-6 k_n where open; k_n [N/m³].
    pub fn unilateral(normal_stiffness: f64) -> ContactLaw {
        ContactLaw { opening: Opening::Unilateral { residual: 1e-6 }, ..ContactLaw::bonded(normal_stiffness) }
    }

    /// The same with a tangential stiffness k_t [N/m³].
    pub fn with_tangential(self, tangential_stiffness: f64) -> ContactLaw {
        ContactLaw { tangential_stiffness, ..self }
    }

    /// The same next to a liquid of displacements on top, which leaves where the pressure of the displaced particle falls below zero.
    ///
    /// * `weight_density`: ρ g [N/m³]
    pub fn of_displaced(self, weight_density: f64) -> ContactLaw {
        ContactLaw { relief: weight_density, ..self }
    }

    /// The same with the force at the end of a time step, which never gains energy at a touch.
    pub fn at_end(self) -> ContactLaw {
        ContactLaw { at_end: true, ..self }
    }

    /// The same with multipliers.
    pub fn augmented(self) -> ContactLaw {
        ContactLaw { augmented: true, ..self }
    }

    fn check(&self) -> Result<(), ElementError> {
        let check = |good, parameter, found: f64, allowed| require(good, KIND, parameter, found, allowed);
        check(positive(self.normal_stiffness), "normal_stiffness", self.normal_stiffness, "> 0")?;
        check(not_negative(self.tangential_stiffness), "tangential_stiffness", self.tangential_stiffness, "≥ 0")?;
        check(not_negative(self.relief), "relief", self.relief, "≥ 0")?;
        match self.opening {
            Opening::Unilateral { residual } => {
                check((0.0..1.0).contains(&residual), "residual", residual, "from 0 to below 1")
            }
            _ => Ok(()),
        }
    }
}

/// The element. Its local nodes are the four of the top, then the four of the bottom.
#[derive(Clone, Debug, PartialEq)]
pub struct Contact8 {
    nodes: [usize; 8],
    chart: Chart,
    corners: [[f64; 3]; 4],
    normals: [Vector3<f64>; 4],
    law: ContactLaw,
    /// Signs of the bottom's components along the axes of the top.
    bottom: [f64; 3],
}

impl Contact8 {
    /// Joint on `face`, whose chart coordinates give place and area.
    ///
    /// * `top`, `bottom`: nodes of both sides in the order of the face's corners
    /// * `normals`: unit normal at each corner, global Cartesian, from bottom to top; one a node for all faces that meet
    ///   there
    ///
    /// Errors: a parameter out of range, a normal that is not a unit vector, a face without area.
    pub fn new(
        face: &Face,
        chart: Chart,
        top: [usize; 4],
        bottom: [usize; 4],
        normals: [[f64; 3]; 4],
        law: ContactLaw,
    ) -> Result<Contact8, ElementError> {
        law.check()?;
        for normal in normals {
            let length = Vector3::from(normal).norm();
            // Normals are given to working accuracy; another length scales the penalty by its square.
            let found = format_args!("{normal:?} of length {length}");
            require((length - 1.0).abs() <= 1e-9, KIND, "normal", found, "unit vectors")?;
        }
        let mut nodes = [0; 8];
        nodes[..4].copy_from_slice(&top);
        nodes[4..].copy_from_slice(&bottom);
        let element =
            Contact8 { nodes, chart, corners: face.chart, normals: normals.map(Vector3::from), law, bottom: [1.0; 3] };
        let mut least = f64::INFINITY;
        Gap::whole(|r, s, _| least = least.min(element.area_factor(r, s)));
        if least.is_nan() || least <= 0.0 {
            return Err(ElementError::Jacobian { kind: KIND, determinant: least, nodes: nodes.to_vec() });
        }
        Ok(element)
    }

    /// The same joint where the bottom face belongs to a wall whose x axis is reversed.
    pub fn with_mirrored_bottom(mut self) -> Contact8 {
        self.bottom[0] = -1.0;
        self
    }

    /// Area of the face [m²].
    pub fn area(&self) -> f64 {
        let mut sum = 0.0;
        Gap::whole(|r, s, w| sum += w * self.area_factor(r, s));
        sum
    }

    /// Gap at the four corners [m] for the values of the element's dofs; negative where pressed.
    pub fn gaps(&self, values: &[f64]) -> [f64; 4] {
        std::array::from_fn(|a| self.normals[a].dot(&self.jump(values, a)))
    }

    /// u_top − u_bottom at corner `a` [m].
    fn jump(&self, values: &[f64], a: usize) -> Vector3<f64> {
        Vector3::from_fn(|i, _| values[3 * a + i] - self.bottom[i] * values[12 + 3 * a + i])
    }

    /// s_a = −ρ g u_z at the corners of the top: change of the pressure of a particle by its own motion [Pa].
    fn relief(&self, values: &[f64]) -> [f64; 4] {
        std::array::from_fn(|a| -self.law.relief * values[3 * a + 2])
    }

    /// g_a − λ_a/k_n.
    fn shifted_gaps(&self, values: &[f64], history: &[f64]) -> [f64; 4] {
        let mut gaps = self.gaps(values);
        for (g, lambda) in gaps.iter_mut().zip(history) {
            *g -= lambda / self.law.normal_stiffness;
        }
        gaps
    }

    /// Chart coordinates at (r, s).
    fn chart_at(&self, r: f64, s: f64) -> [f64; 3] {
        let n = quad4::value(r, s);
        std::array::from_fn(|k| (0..4).map(|a| n[a] * self.corners[a][k]).sum())
    }

    /// dA/(dr ds): the length of the cross product of both tangents of the face in the chart's orthonormal base.
    fn area_factor(&self, r: f64, s: f64) -> f64 {
        let slopes = quad4::slope(r, s);
        let mut tangents =
            [0, 1].map(|d| Vector3::from_fn(|k, _| (0..4).map(|a| slopes[a][d] * self.corners[a][k]).sum::<f64>()));
        if self.chart == Chart::Cylindrical {
            let radius = self.chart_at(r, s)[0];
            for tangent in &mut tangents {
                tangent[1] *= radius;
            }
        }
        tangents[0].cross(&tangents[1]).norm()
    }

    /// ∫ N_a N_b dA over the whole face.
    fn whole(&self) -> [[f64; 4]; 4] {
        let mut sum = [[0.0; 4]; 4];
        Gap::whole(|r, s, w| self.add_products(r, s, w, &mut sum));
        sum
    }

    fn add_products(&self, r: f64, s: f64, weight: f64, sum: &mut [[f64; 4]; 4]) {
        let n = quad4::value(r, s);
        let area = weight * self.area_factor(r, s);
        for a in 0..4 {
            for b in 0..4 {
                sum[a][b] += area * n[a] * n[b];
            }
        }
    }

    /// A_ab = ∫ k N_a N_b dA with k = k_n where closed and r k_n where open [N/m].
    fn normal_matrix(&self, gaps: [f64; 4]) -> [[f64; 4]; 4] {
        let mut matrix = self.whole();
        let k_n = self.law.normal_stiffness;
        if let Opening::Unilateral { residual } = self.law.opening {
            let mut closed = [[0.0; 4]; 4];
            Gap(gaps).closed(self.law.integration, |r, s, w| self.add_products(r, s, w, &mut closed));
            for a in 0..4 {
                for b in 0..4 {
                    matrix[a][b] = residual * matrix[a][b] + (1.0 - residual) * closed[a][b];
                }
            }
        }
        matrix.map(|row| row.map(|x| k_n * x))
    }

    /// Adds value · x yᵀ between nodes a and b, with the signs of top and bottom.
    fn add_pair(&self, [a, b]: [usize; 2], block: impl Fn(usize, usize) -> f64, out: &mut LocalMatrix) {
        for j in 0..3 {
            for i in 0..3 {
                let value = block(i, j);
                for (row, sign_row) in [(3 * a + i, 1.0), (12 + 3 * a + i, -self.bottom[i])] {
                    for (column, sign_column) in [(3 * b + j, 1.0), (12 + 3 * b + j, -self.bottom[j])] {
                        out.add(row, column, sign_row * sign_column * value);
                    }
                }
            }
        }
    }

    /// 1 − n_a n_aᵀ.
    fn tangential_projector(&self, a: usize) -> nalgebra::Matrix3<f64> {
        nalgebra::Matrix3::identity() - self.normals[a] * self.normals[a].transpose()
    }
}

impl Element for Contact8 {
    crate::answers!(KIND, nodes, Dof::TRANSLATIONS; massless contact inspect);

    fn history_len(&self) -> usize {
        if self.law.augmented || self.law.relief > 0.0 { 4 } else { 0 }
    }

    /// At rest (all gaps zero) the tangent of a unilateral joint is that of the bonded one: the reference state is closed.
    fn respond(&self, Trial { motion, old, new, want }: Trial<'_>, out: &mut Response) -> Result<(), ElementError> {
        let relieved = self.law.relief > 0.0;
        match relieved {
            true => new.copy_from_slice(&self.relief(motion.values)),
            false => new.copy_from_slice(old),
        }
        let gaps = self.shifted_gaps(motion.values, old);
        let normal = if gaps == [0.0; 4] {
            self.whole().map(|row| row.map(|x| self.law.normal_stiffness * x))
        } else {
            self.normal_matrix(gaps)
        };
        let mut add_force = |a: usize, force: Vector3<f64>| {
            for i in 0..3 {
                out.force[3 * a + i] += force[i];
                out.force[12 + 3 * a + i] -= self.bottom[i] * force[i];
            }
        };
        if want.force && relieved {
            // t = A (g − s/k_n) + s: the whole traction of the closed joint, s of the open one.
            for (a, row) in self.whole().iter().enumerate() {
                let sum: f64 = row.iter().zip(old).map(|(m, s)| m * s).sum();
                add_force(a, sum * self.normals[a]);
            }
        }
        if want.force {
            for a in 0..4 {
                let sum: f64 = (0..4).map(|b| normal[a][b] * gaps[b]).sum();
                add_force(a, sum * self.normals[a]);
            }
        }
        if want.tangent {
            for a in 0..4 {
                for b in 0..4 {
                    let (na, nb) = (&self.normals[a], &self.normals[b]);
                    self.add_pair([a, b], |i, j| normal[a][b] * na[i] * nb[j], &mut out.tangent);
                }
            }
        }
        if self.law.tangential_stiffness > 0.0 {
            let whole = self.whole();
            for a in 0..4 {
                for b in 0..4 {
                    let block = self.tangential_projector(a)
                        * self.tangential_projector(b)
                        * (self.law.tangential_stiffness * whole[a][b]);
                    if want.force {
                        add_force(a, block * self.jump(motion.values, b));
                    }
                    if want.tangent {
                        self.add_pair([a, b], |i, j| block[(i, j)], &mut out.tangent);
                    }
                }
            }
        }
        Ok(())
    }
}

impl Contact for Contact8 {
    fn acts_at_end(&self) -> bool {
        self.law.at_end
    }

    /// Corners of a joint that may open: closed or open.
    fn switches(&self, motion: Motion<'_>, history: &[f64], see: &mut dyn FnMut(bool)) {
        if self.law.opening != Opening::Bonded {
            let gaps = self.shifted_gaps(motion.values, history);
            gaps.iter().for_each(|&g| see(g <= 0.0));
        }
    }

    fn augment(&self, motion: Motion<'_>, history: &mut [f64]) {
        if self.law.relief > 0.0 {
            return;
        }
        let gaps = self.gaps(motion.values);
        for (lambda, g) in history.iter_mut().zip(gaps) {
            let next = *lambda - self.law.normal_stiffness * g;
            *lambda = match self.law.opening {
                Opening::Bonded => next,
                Opening::Unilateral { .. } => next.max(0.0),
            };
        }
    }

    /// Largest penetration at the corners [m], ≥ 0.
    fn penetration(&self, motion: Motion<'_>) -> f64 {
        self.gaps(motion.values).iter().fold(0.0, |m, g| m.max(-g))
    }
}

impl Inspect for Contact8 {
    /// `gap` [m] and `contact_pressure` −k_n g [Pa] (pressed: positive; of the bonded joint) at the 2 × 2 points.
    fn samples(&self) -> Vec<Sample> {
        let mut samples = Vec::new();
        Gap::whole(|r, s, _| {
            let n = quad4::value(r, s);
            let mut gap = vec![0.0; 24];
            for a in 0..4 {
                for i in 0..3 {
                    gap[3 * a + i] = n[a] * self.normals[a][i];
                    gap[12 + 3 * a + i] = -n[a] * self.bottom[i] * self.normals[a][i];
                }
            }
            let position = self.chart.position(self.chart_at(r, s));
            let pressure = gap.iter().map(|c| -self.law.normal_stiffness * c).collect();
            for (name, row) in [("gap", gap), ("contact_pressure", pressure)] {
                samples.push(Sample { name, position, row, of_acceleration: false });
            }
        });
        samples
    }
}

#[cfg(test)]
mod tests;
