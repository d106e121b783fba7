//! Super-element: a linear part of a structure, or a liquid, given by its condensed matrices.
//!
//! ```text
//! f_int = K u − p        M ü        C u̇        over any dofs of any nodes
//! ```
//!
//! A liquid condensed onto the normal displacements w of the wetted wall and sloshing amplitudes q has
//!
//! ```text
//! M = ⎡ M_a + Sᵀ c S   Sᵀ c ⎤     K = ⎡ 0  0 ⎤     C = ⎡ 0       0       ⎤
//!     ⎣ c S            c    ⎦         ⎣ 0  k ⎦         ⎣ 0  2 ξ_n ω_n c_n ⎦
//! ```
//!
//! and its ground-motion load −M ι a_g, ι = (1 along the motion, 0), follows from M as that of any element does: rows of
//! held dofs belong into the matrices. Amplitudes live on nodes of their own ([`Dof::Amplitude`]), whose position is of no
//! consequence.
//!
//! Components are along the axes of the nodes' frames ([`Element::own_axes`]), so that the radial displacement of a
//! cylindrical wall is one dof. Small displacements and rotations.
//!
//! Source: Guyan 1965; Craig & Bampton 1968; Morand & Ohayon 1995, chapter 5.

use super::{Element, ElementError, LocalMatrix, Response, Trial, require};
use crate::dofs::Dof;
use crate::linalg::Matrix;

const KIND: &str = "super_element";

/// Largest |a_ij − a_ji| that counts as rounding, relative to the largest entry.
const ASYMMETRY: f64 = 1e-9;

/// The element.
#[derive(Clone, Debug)]
pub struct SuperElement {
    nodes: Vec<usize>,
    dofs: Vec<Dof>,
    mass: Option<Matrix>,
    stiffness: Option<Matrix>,
    damping: Option<Matrix>,
}

impl SuperElement {
    /// Over `dofs[a]` of `nodes[a]`, node by node, without any matrix yet.
    ///
    /// Errors: lists of different length; those of [`SuperElement::over`].
    pub fn new(nodes: Vec<usize>, dofs: Vec<&'static [Dof]>) -> Result<SuperElement, ElementError> {
        let found = format_args!("{} nodes, dofs of {}", nodes.len(), dofs.len());
        require(nodes.len() == dofs.len(), KIND, "nodes", found, "as many lists of dofs as nodes")?;
        let own = |(node, dofs): (usize, &'static [Dof])| dofs.iter().map(move |&d| (node, d));
        let unknowns: Vec<(usize, Dof)> = nodes.into_iter().zip(dofs).flat_map(own).collect();
        SuperElement::over(&unknowns)
    }

    /// Over these dofs, in this order, without any matrix yet.
    ///
    /// Errors: no dof, a dof named twice.
    pub fn over(unknowns: &[(usize, Dof)]) -> Result<SuperElement, ElementError> {
        let mut sorted = unknowns.to_vec();
        sorted.sort_unstable();
        for pair in sorted.windows(2) {
            let (node, dof) = pair[0];
            let found = format_args!("{dof} of node {node} twice");
            require(pair[0] != pair[1], KIND, "dofs", found, "every dof once")?;
        }
        require(!unknowns.is_empty(), KIND, "dofs", "none", "one or more")?;
        // One local node a dof.
        Ok(SuperElement {
            nodes: unknowns.iter().map(|u| u.0).collect(),
            dofs: unknowns.iter().map(|u| u.1).collect(),
            mass: None,
            stiffness: None,
            damping: None,
        })
    }

    /// Number of local dofs.
    pub fn size(&self) -> usize {
        self.dofs.len()
    }

    /// With the mass matrix.
    ///
    /// Errors: wrong size, an entry that is not finite, a matrix that is not symmetric.
    pub fn with_mass(mut self, mass: Matrix) -> Result<SuperElement, ElementError> {
        self.mass = Some(self.checked("mass", mass)?);
        Ok(self)
    }

    /// With the stiffness matrix.
    ///
    /// Errors: as [`SuperElement::with_mass`].
    pub fn with_stiffness(mut self, stiffness: Matrix) -> Result<SuperElement, ElementError> {
        self.stiffness = Some(self.checked("stiffness", stiffness)?);
        Ok(self)
    }

    /// With the damping matrix.
    ///
    /// Errors: as [`SuperElement::with_mass`].
    pub fn with_damping(mut self, damping: Matrix) -> Result<SuperElement, ElementError> {
        self.damping = Some(self.checked("damping", damping)?);
        Ok(self)
    }

    /// Node and dof of every local dof.
    pub fn unknowns(&self) -> Vec<(usize, Dof)> {
        self.nodes.iter().copied().zip(self.dofs.iter().copied()).collect()
    }

    /// The matrix made symmetric to the last digit; rejected if it is not symmetric up to rounding.
    fn checked(&self, parameter: &'static str, mut a: Matrix) -> Result<Matrix, ElementError> {
        let n = self.size();
        let found = format_args!("{} × {}", a.rows, a.cols);
        require(a.rows == n && a.cols == n, KIND, parameter, found, "as many rows and columns as dofs")?;
        let largest = a.data.iter().fold(0.0_f64, |m, v| m.max(v.abs()));
        for j in 0..n {
            for i in 0..=j {
                let (upper, lower) = (a.get(i, j), a.get(j, i));
                // Also false if one is not a number.
                let good = (upper - lower).abs() <= ASYMMETRY * largest && largest.is_finite();
                let found = format_args!("{upper} in ({i}, {j}) and {lower} in ({j}, {i})");
                require(good, KIND, parameter, found, "a symmetric matrix of finite numbers")?;
                let mean = 0.5 * (upper + lower);
                a.data[i + j * n] = mean;
                a.data[j + i * n] = mean;
            }
        }
        Ok(a)
    }
}

fn copy(from: &Option<Matrix>, out: &mut LocalMatrix) {
    if let Some(a) = from {
        for (o, v) in out.data.iter_mut().zip(&a.data) {
            *o += v;
        }
    }
}

impl Element for SuperElement {
    crate::answers!(KIND, nodes; own_axes linear);

    fn dofs(&self, node: usize) -> &'static [Dof] {
        let own = self.dofs[node].index();
        Dof::slice(own..own + 1)
    }

    fn mass(&self, out: &mut LocalMatrix) {
        copy(&self.mass, out);
    }

    fn has_mass(&self) -> bool {
        self.mass.is_some()
    }

    fn respond(&self, Trial { motion, want, .. }: Trial<'_>, out: &mut Response) -> Result<(), ElementError> {
        if want.force
            && let Some(k) = &self.stiffness
        {
            for (j, &u) in motion.values.iter().enumerate().filter(|(_, u)| **u != 0.0) {
                for (f, k) in out.force.iter_mut().zip(k.column(j)) {
                    *f += k * u;
                }
            }
        }
        if want.tangent {
            copy(&self.stiffness, &mut out.tangent);
        }
        Ok(())
    }

    fn damping(&self, out: &mut LocalMatrix) -> bool {
        copy(&self.damping, out);
        self.damping.is_some()
    }
}

#[cfg(test)]
mod tests {
    use nalgebra::Rotation3;

    use super::*;
    use crate::assembly::Assembler;
    use crate::element::Want;
    use crate::element::spring::{Direction, PointMass, Spring};
    use crate::model::Builder;

    fn matrix(n: usize, of: impl Fn(usize, usize) -> f64) -> Matrix {
        let data = (0..n * n).map(|k| of(k % n, k / n)).collect();
        Matrix { rows: n, cols: n, data }
    }

    /// Radial dofs of a ring whose nodes have frames, one of them held, with one amplitude: matrices and ground-motion load
    /// as they follow by hand.
    #[test]
    fn radial_dofs_in_frames_with_an_amplitude() {
        let count = 5;
        let mut builder = Builder::new();
        for k in 0..count {
            let angle = 1.1 * k as f64;
            let node = builder.node([angle.cos(), angle.sin(), 0.0]);
            let frame = Rotation3::from_axis_angle(&nalgebra::Vector3::z_axis(), -angle);
            builder.frame(node, frame.into_inner());
            let spring = Spring::to_ground(node, Direction::Translation([0.0, 0.0, 1.0]), 1.0).unwrap();
            builder.element("springs", spring);
        }
        builder.hold(2, Dof::Ux);
        let amplitude = builder.node([0.0; 3]);
        let mut unknowns: Vec<(usize, Dof)> = (0..count).map(|k| (k, Dof::Ux)).collect();
        unknowns.push((amplitude, Dof::Amplitude));
        let of = |i: usize, j: usize| (1 + i + j) as f64 + if i == j { 10.0 } else { 0.0 };
        let part = SuperElement::over(&unknowns).unwrap();
        let part = part.with_mass(matrix(6, of)).unwrap();
        let part = part.with_stiffness(matrix(6, |i, j| 2.0 * of(i, j))).unwrap();
        builder.element("liquid", part);
        let model = builder.build().unwrap();
        let assembler = Assembler::new(&model);
        let (k, m) = assembler.stiffness_and_mass(&model).unwrap();
        let equation = |i: usize| model.dofs().equation(unknowns[i].0, unknowns[i].1);
        for i in 0..6 {
            for j in 0..6 {
                if let (Some(a), Some(b)) = (equation(i), equation(j)) {
                    assert_eq!(m.get(a, b), of(i, j));
                    assert_eq!(k.get(a, b), 2.0 * of(i, j));
                }
            }
        }
        // A translation along x has the radial parts cos θ; the held node's share is in, the amplitude rests.
        let inertia = assembler.inertia(&model, crate::analysis::system::unit_x);
        for i in (0..6).filter(|&i| i != 2) {
            let expected: f64 = (0..count).map(|j| of(i, j) * (1.1 * j as f64).cos()).sum();
            let found = inertia[equation(i).unwrap()];
            assert!((found - expected).abs() < 1e-13, "{i}: {found} {expected}");
        }
    }

    /// Two masses on springs, their upper half given as a super-element: the same matrices.
    #[test]
    fn part_of_a_structure() {
        let x = Direction::Translation([1.0, 0.0, 0.0]);
        let build = |condensed: bool| {
            let mut builder = Builder::new();
            builder.nodes(&[[0.0; 3], [1.0, 0.0, 0.0]]);
            for node in 0..2 {
                builder.hold(node, Dof::Uy);
                builder.hold(node, Dof::Uz);
            }
            builder.element("a", Spring::to_ground(0, x, 5.0).unwrap());
            builder.element("a", PointMass::new(0, 2.0).unwrap());
            if condensed {
                let part = SuperElement::over(&[(0, Dof::Ux), (1, Dof::Ux)]).unwrap();
                let part = part.with_stiffness(matrix(2, |i, j| if i == j { 3.0 } else { -3.0 }));
                let part = part.unwrap().with_mass(matrix(2, |i, j| f64::from(i == 1 && j == 1)));
                builder.element("b", part.unwrap());
            } else {
                builder.element("b", Spring::between(0, 1, x, 3.0).unwrap());
                builder.element("b", PointMass::new(1, 1.0).unwrap());
            }
            builder.build().unwrap()
        };
        let (part, whole) = (build(true), build(false));
        let (a, b) = (Assembler::new(&part), Assembler::new(&whole));
        assert_eq!(a.stiffness_and_mass(&part).unwrap(), b.stiffness_and_mass(&whole).unwrap());
        let mut state = crate::state::State::new(&part);
        state.trial.u = vec![0.3, -0.1];
        let mut tangent = crate::linalg::Symmetric::zeros(a.pattern().clone());
        let force = a.respond(&part, &mut state, Want::ALL, &mut tangent).unwrap();
        assert!((force[0] - (1.5 + 1.2)).abs() < 1e-14 && (force[1] + 1.2).abs() < 1e-14);
    }

    #[test]
    fn bad_parameters_are_rejected() {
        assert!(SuperElement::over(&[]).is_err());
        assert!(SuperElement::over(&[(0, Dof::Ux), (1, Dof::Ux), (0, Dof::Ux)]).is_err());
        let two = || SuperElement::over(&[(0, Dof::Eta), (0, Dof::Amplitude)]).unwrap();
        assert!(two().with_mass(Matrix::zeros(3, 3)).is_err());
        assert!(two().with_mass(matrix(2, |i, j| (i as f64) - (j as f64))).is_err());
        assert!(two().with_damping(matrix(2, |_, _| f64::NAN)).is_err());
    }
}
