//! Eight-node solid: the layer between two shells, and the general brick.
//!
//! Total Lagrangian, trilinear, 2 × 2 × 2 points, global Cartesian displacements.
//!
//! ```text
//! H = ∂u/∂X,  F = 1 + H,  E = ½ (H + Hᵀ + Hᵀ H),  S = S(E)          (linear: E = ½ (H + Hᵀ), F = 1)
//! f_a  = ∫ F S g_a dV₀                                               g_a = ∂N_a/∂X
//! K_ab = ∫ B_aᵀ D B_b + (g_a · S g_b) 1 dV₀                          B_a δu_a = sym(Fᵀ (δu_a ⊗ g_a))
//! M_ab = ∫ ρ₀ N_a N_b dV₀ 1
//! C_e  = a_M M_e + a_K K_e(u = 0)                                    element Rayleigh damping, initial stiffness
//! ```
//!
//! Numbering of [`crate::shape::hex8`]; collapsed bricks (wedges) are allowed. The layer's normal is that of the surfaces
//! t = const, ∂X/∂r × ∂X/∂s.
//!
//! For the isotropic law the integrand of the material stiffness is λ h_a h_bᵀ + μ h_b h_aᵀ + μ (g_a · g_b) F Fᵀ with
//! h_a = F g_a. At rest F = 1, and everything follows from the 24 × 24 matrix A = ∫ g_a g_bᵀ dV₀:
//! K_ab = λ A_ab + μ A_abᵀ + μ tr(A_ab) 1. That is the fast path of linear kinematics and of the reference state.
//!
//! Limits: thin bricks lock in bending; one brick through the depth of a cantilever gives 1/(1 + (l/h)²/2) of the
//! deflection (l length of a brick, h depth, ν = 0).
//!
//! Source: dissertation, section 6.3.1 and (6.10)-(6.30), its factors ½ in (6.21) and the current metric in (6.25)
//! corrected (docs/theory/solid-and-contact.md).

mod abilities;
mod kernels;
mod material;

pub use material::Elastic;

use kernels::{add_isotropic_stiffness, add_stiffness, displacement_gradient, tensor, voigt};
use nalgebra::{Matrix3, Vector3};

use super::solid8_law::dyad;
use super::{Contact, Element, ElementError, LocalMatrix, Response, Trial, not_negative, require};
use crate::dofs::Dof;
use crate::shape::hex8::CORNERS;

/// Kind, as users name it.
const KIND: &str = "solid8";
/// Points of the 2 × 2 × 2 rule; the weights are 1.
const POINTS: usize = 8;
const A2: f64 = 0.577_350_269_189_625_8;
/// Shape functions at the points: `VALUES[q][a]`. Point q lies towards corner q.
const VALUES: [[f64; 8]; POINTS] = tabulate().0;
/// Their derivatives in (r, s, t): `SLOPES[q][a]`.
const SLOPES: [[[f64; 3]; 8]; POINTS] = tabulate().1;

const fn tabulate() -> ([[f64; 8]; POINTS], [[[f64; 3]; 8]; POINTS]) {
    let (mut values, mut slopes) = ([[0.0; 8]; POINTS], [[[0.0; 3]; 8]; POINTS]);
    let mut q = 0;
    while q < POINTS {
        let mut a = 0;
        while a < 8 {
            let c = CORNERS[a];
            let r = 1.0 + c[0] * A2 * CORNERS[q][0];
            let s = 1.0 + c[1] * A2 * CORNERS[q][1];
            let t = 1.0 + c[2] * A2 * CORNERS[q][2];
            values[q][a] = 0.125 * r * s * t;
            slopes[q][a] = [0.125 * c[0] * s * t, 0.125 * c[1] * r * t, 0.125 * c[2] * r * s];
            a += 1;
        }
        q += 1;
    }
    (values, slopes)
}

/// Strain measure of a solid.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Kinematics {
    /// Small displacements.
    Linear,
    /// Green-Lagrange strain, total Lagrangian.
    GreenLagrange,
}

/// The element.
#[derive(Clone, Debug, PartialEq)]
pub struct Solid8 {
    nodes: [usize; 8],
    coordinates: [[f64; 3]; 8],
    material: Elastic,
    kinematics: Kinematics,
}

/// One integration point in the reference state.
#[derive(Clone, Copy)]
struct Point {
    /// ∂N_a/∂X [1/m].
    gradients: [[f64; 3]; 8],
    /// Weight times Jacobian determinant [m³].
    volume: f64,
    /// Unit normal of the layer.
    normal: Vector3<f64>,
}

const ORIGIN: Point = Point { gradients: [[0.0; 3]; 8], volume: 0.0, normal: Vector3::new(0.0, 0.0, 0.0) };

impl Solid8 {
    /// Nodes and their coordinates [m] in the order of [`crate::shape::hex8`].
    ///
    /// Errors: a parameter out of range, a Jacobian determinant that is not positive.
    pub fn new(
        nodes: [usize; 8],
        coordinates: [[f64; 3]; 8],
        material: Elastic,
        kinematics: Kinematics,
    ) -> Result<Solid8, ElementError> {
        material.law.check(KIND)?;
        for (parameter, found) in [
            ("density", material.density),
            ("damping_mass", material.damping_mass),
            ("damping_stiffness", material.damping_stiffness),
        ] {
            require(not_negative(found), KIND, parameter, found, "≥ 0")?;
        }
        let element = Solid8 { nodes, coordinates, material, kinematics };
        for slopes in &SLOPES {
            let determinant = element.jacobian(slopes).determinant();
            if determinant.is_nan() || determinant <= 0.0 {
                return Err(ElementError::Jacobian { kind: KIND, determinant, nodes: nodes.to_vec() });
            }
        }
        Ok(element)
    }

    /// Material.
    pub fn material(&self) -> &Elastic {
        &self.material
    }

    /// Volume in the reference state [m³].
    pub fn volume(&self) -> f64 {
        self.points().iter().map(|p| p.volume).sum()
    }

    /// Row i: ∂X/∂ξⁱ.
    #[inline]
    fn jacobian(&self, slopes: &[[f64; 3]; 8]) -> Matrix3<f64> {
        let mut j = [[0.0; 3]; 3];
        for a in 0..8 {
            for i in 0..3 {
                for k in 0..3 {
                    j[i][k] += slopes[a][i] * self.coordinates[a][k];
                }
            }
        }
        Matrix3::new(j[0][0], j[0][1], j[0][2], j[1][0], j[1][1], j[1][2], j[2][0], j[2][1], j[2][2])
    }

    #[inline]
    fn points(&self) -> [Point; POINTS] {
        let mut points = [ORIGIN; POINTS];
        for (point, slopes) in points.iter_mut().zip(&SLOPES) {
            let j = self.jacobian(slopes);
            let row = |i: usize| Vector3::new(j[(i, 0)], j[(i, 1)], j[(i, 2)]);
            let (g1, g2, g3) = (row(0), row(1), row(2));
            // Cofactors: the contravariant base is their quotient by the determinant.
            let (c1, c2, c3) = (g2.cross(&g3), g3.cross(&g1), g1.cross(&g2));
            let determinant = g1.dot(&c1);
            let inverse = 1.0 / determinant;
            for (gradient, slope) in point.gradients.iter_mut().zip(slopes) {
                for k in 0..3 {
                    gradient[k] = inverse * (slope[0] * c1[k] + slope[1] * c2[k] + slope[2] * c3[k]);
                }
            }
            point.volume = determinant;
            point.normal = c3 / c3.norm();
        }
        points
    }

    /// Volumes of the points, for the mass.
    #[inline]
    fn volumes(&self) -> [f64; POINTS] {
        let mut volumes = [0.0; POINTS];
        for (volume, slopes) in volumes.iter_mut().zip(&SLOPES) {
            *volume = self.jacobian(slopes).determinant();
        }
        volumes
    }

    /// Stiffness at rest of an isotropic element, from A = ∫ g_a g_bᵀ dV₀.
    fn isotropic_stiffness(&self, lambda: f64, mu: f64, out: &mut LocalMatrix) {
        let mut outer = [[0.0; 24]; 24];
        for point in &self.points() {
            let g = point.gradients.as_flattened();
            for j in 0..24 {
                let scaled = point.volume * g[j];
                // Columns of node b need the rows of the nodes a ≥ b only.
                let first = 3 * (j / 3);
                for (sum, gi) in outer[j][first..].iter_mut().zip(&g[first..]) {
                    *sum += scaled * gi;
                }
            }
        }
        for b in 0..8 {
            for a in b..8 {
                // outer[column][row]
                let trace = mu * (0..3).map(|i| outer[3 * b + i][3 * a + i]).sum::<f64>();
                for j in 0..3 {
                    for i in 0..3 {
                        let mut value = lambda * outer[3 * b + j][3 * a + i] + mu * outer[3 * b + i][3 * a + j];
                        if i == j {
                            value += trace;
                        }
                        out.data[3 * a + i + 24 * (3 * b + j)] = value;
                        out.data[3 * b + j + 24 * (3 * a + i)] = value;
                    }
                }
            }
        }
    }

    /// F and the strain in Voigt's order at a point.
    fn strain(&self, point: &Point, values: &[f64]) -> (Matrix3<f64>, [f64; 6]) {
        let h = displacement_gradient(point, values);
        match self.kinematics {
            Kinematics::GreenLagrange => {
                let e = 0.5 * (h + h.transpose() + h.transpose() * h);
                (Matrix3::identity() + h, voigt(&e))
            }
            Kinematics::Linear => (Matrix3::identity(), voigt(&(0.5 * (h + h.transpose())))),
        }
    }

    /// Strain along the layer's normal at the 2 × 2 × 2 points; positive where the layer is stretched.
    pub fn normal_strains(&self, values: &[f64]) -> [f64; 8] {
        self.points().map(|point| {
            let (_, strain) = self.strain(&point, values);
            dyad(&point.normal).iter().zip(strain).map(|(p, e)| p * e).sum()
        })
    }

    /// Stiffness at rest.
    fn rest_stiffness(&self, out: &mut LocalMatrix) {
        match self.material.law.lame() {
            Some((lambda, mu)) => self.isotropic_stiffness(lambda, mu, out),
            None => {
                for point in &self.points() {
                    let (_, moduli) = self.material.law.stress(&[0.0; 6], &point.normal);
                    add_stiffness(point, &Matrix3::identity(), &moduli, &[0.0; 6], out);
                }
            }
        }
    }
}

impl Element for Solid8 {
    crate::answers!(KIND, nodes, Dof::TRANSLATIONS; inspect buckling);

    fn mass(&self, out: &mut LocalMatrix) {
        let volumes = self.volumes().map(|v| v * self.material.density);
        for b in 0..8 {
            for a in b..8 {
                let mut m = 0.0;
                for q in 0..POINTS {
                    m += volumes[q] * VALUES[q][a] * VALUES[q][b];
                }
                for i in 0..3 {
                    out.data[3 * a + i + 24 * (3 * b + i)] = m;
                    out.data[3 * b + i + 24 * (3 * a + i)] = m;
                }
            }
        }
    }

    fn has_mass(&self) -> bool {
        self.material.density > 0.0
    }

    fn respond(&self, Trial { motion, want, .. }: Trial<'_>, out: &mut Response) -> Result<(), ElementError> {
        let nonlinear = self.kinematics == Kinematics::GreenLagrange;
        let at_rest = motion.values.iter().all(|&v| v == 0.0);
        let quick = at_rest || (!nonlinear && self.material.law.is_linear());
        if want.tangent && quick {
            self.rest_stiffness(&mut out.tangent);
        }
        if at_rest || (quick && !want.force) {
            return Ok(());
        }
        for point in &self.points() {
            let (f, strain) = self.strain(point, motion.values);
            let (stress, moduli) = self.material.law.stress(&strain, &point.normal);
            if want.force {
                let first_piola = f * tensor(&stress) * point.volume;
                for (force, g) in out.force.as_chunks_mut::<3>().0.iter_mut().zip(&point.gradients) {
                    let part = first_piola * Vector3::from(*g);
                    for i in 0..3 {
                        force[i] += part[i];
                    }
                }
            }
            if want.tangent && !quick {
                // Small displacements have no geometric stiffness.
                let stress = if nonlinear { stress } else { [0.0; 6] };
                match self.material.law.lame() {
                    Some(constants) => add_isotropic_stiffness(point, &f, constants, &stress, &mut out.tangent),
                    None => add_stiffness(point, &f, &moduli, &stress, &mut out.tangent),
                }
            }
        }
        Ok(())
    }

    fn damping(&self, out: &mut LocalMatrix) -> bool {
        let (mass, stiffness) = (self.material.damping_mass, self.material.damping_stiffness);
        if mass == 0.0 && stiffness == 0.0 {
            return false;
        }
        let mut part = LocalMatrix::zeros(24);
        self.mass(&mut part);
        self.rest_stiffness(out);
        for (c, m) in out.data.iter_mut().zip(&part.data) {
            *c = mass * m + stiffness * *c;
        }
        true
    }

    fn body_force(&self, acceleration: [f64; 3], out: &mut [f64]) {
        for (volume, values) in self.volumes().iter().zip(&VALUES) {
            for a in 0..8 {
                for i in 0..3 {
                    out[3 * a + i] += volume * self.material.density * values[a] * acceleration[i];
                }
            }
        }
    }

    /// Layers only.
    fn contact(&self) -> Option<&dyn Contact> {
        let law = &self.material.law;
        (law.only_between_shells() || !law.is_linear()).then_some(self as &dyn Contact)
    }
}

#[cfg(test)]
mod tests;
