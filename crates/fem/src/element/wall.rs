//! Wall of two shells with a layer between them, on one footprint.
//!
//! ```text
//!   inner shell   layer   outer shell         director, from the inner to the outer shell
//!   ───●───────▌░░░░░░░░▐───────●───          ●  reference surfaces, which carry all unknowns
//!      I       c_I    c_O       O
//!
//! faces of the layer   u_face = u + c w ,  w = d − D = (R − 1) D       c > 0 along the director: c_I > 0, c_O < 0
//! pull-back            δu_face = δu + c P θ ,  P = −skew(d)
//!                      f_u += f_face ,  f_θ += c d × f_face
//!                      K += Tᵀ K_face T + c [½ (f dᵀ + d fᵀ) − (f · d) 1] at every node        T = [1, c P]
//! ```
//!
//! The layer is a [`Solid8`] between the faces, so that it adds no unknowns: the wall's dofs are those of its two
//! [`Shell4`], inner nodes first. The last block of K is the second derivative of the energy along exp(skew θ) R, as in the
//! shell: the tangent is symmetric everywhere, and rigid rotations of any size leave the layer unstrained. A layer that is
//! stiff along its normal only transmits no shear: the shells bend side by side and E I adds. For composite action it must
//! be a core or isotropic. Membrane locking of the shells, shear flexibility and base conditions are theirs.
//!
//! **Mass of the layer.** It hangs on its faces: by the consistent matrix of the solid, half on each shell
//! ([`LayerMass::Halves`]), or wholly on one face. Either way it is pulled back with the lever c, and its weight with it. (A
//! layer without shear stiffness cannot carry its weight by itself.)
//!
//! **Layer without tension.** Where it goes into a model its stresses are an element of their own ([`LooseLayer`]), whose force
//! time steps take at their end.
//!
//! **Fewer layers.** One shell is a [`Shell4`]. Two shells bonded directly are two [`Shell4`] on one reference surface, one
//! of them with an eccentric section: a perfect bond adds no unknowns either. Two shells that may separate without a layer are
//! not offered: give the joint a thickness. [`place`] puts all three into a model.
//!
//! Source: dissertation, section 6.3.2 (its face displacements linearised; here with finite rotations).

use nalgebra::{Matrix3, UnitQuaternion, Vector3};

use super::shell::director::add_turn_block;
use super::shell::director::turned;
use super::shell4::{SIZE as SHELL_SIZE, Shell4};
use super::solid8::{Elastic, Kinematics, Solid8};
use super::{Contact, Element, ElementError, LocalMatrix, Motion, Response, Stage, Trial, Want, require};
use crate::dofs::Dof;

mod abilities;
mod loose;
pub mod place;

pub use loose::LooseLayer;

/// Kind, as users name it.
const KIND: &str = "wall";
/// Number of local dofs: eight nodes with six.
pub const SIZE: usize = 48;
/// Resultants of the inner shell, in [`RESULTANTS`]' order.
const INNER: [&str; 8] =
    ["inner_n_11", "inner_n_22", "inner_n_12", "inner_m_11", "inner_m_22", "inner_m_12", "inner_q_1", "inner_q_2"];
/// Resultants of the outer shell.
const OUTER: [&str; 8] =
    ["outer_n_11", "outer_n_22", "outer_n_12", "outer_m_11", "outer_m_22", "outer_m_12", "outer_q_1", "outer_q_2"];

/// Which face carries the mass of the layer.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Default)]
pub enum LayerMass {
    /// Both, by the consistent mass of the solid between them.
    #[default]
    Halves,
    /// The inner shell's.
    Inner,
    /// The outer shell's.
    Outer,
}

/// The layer of a wall.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Layer {
    /// Law, density and element damping.
    pub material: Elastic,
    /// Strain measure; Green-Lagrange with finite rotations.
    pub kinematics: Kinematics,
    /// Which part carries its mass.
    pub mass: LayerMass,
}

/// The element.
#[derive(Clone)]
pub struct Wall {
    nodes: [usize; 8],
    inner: Shell4,
    outer: Shell4,
    layer: Solid8,
    mass: LayerMass,
    directors: [Vector3<f64>; 8],
    /// c at each node [m].
    lever: [f64; 8],
    /// The stresses of the layer are those of a [`LooseLayer`].
    loose: bool,
}

impl Wall {
    /// A wall of two shells whose corners lie opposite each other, numbered counter-clockwise seen against the directors,
    /// which point from the inner to the outer shell.
    ///
    /// * `faces`: distances from each reference surface to the layer's face, along the inner shell's director and against
    ///   the outer's [m]; half a thickness for centred sections, 0 for a thin liner
    ///
    /// Errors: a layer without thickness somewhere, a material out of range, a distance that is not finite.
    pub fn new(inner: Shell4, outer: Shell4, faces: [f64; 2], layer: &Layer) -> Result<Wall, ElementError> {
        let mut lever = [faces[0]; 8];
        lever[4..].fill(-faces[1]);
        for face in faces {
            require(face.is_finite(), KIND, "distance of a face", face, "finite")?;
        }
        let pick = |a: usize| if a < 4 { (&inner, a) } else { (&outer, a - 4) };
        let nodes = std::array::from_fn(|a| pick(a).0.nodes()[pick(a).1]);
        let directors: [Vector3<f64>; 8] = std::array::from_fn(|a| pick(a).0.directors()[pick(a).1]);
        let face = std::array::from_fn(|a| {
            let (shell, corner) = pick(a);
            (shell.corners()[corner] + directors[a] * lever[a]).into()
        });
        let layer_solid = Solid8::new(nodes, face, layer.material, layer.kinematics).map_err(|error| match error {
            ElementError::Jacobian { determinant, nodes, .. } => ElementError::NoAnswer {
                kind: KIND,
                reason: format!(
                    "the layer between nodes {nodes:?} has no thickness (Jacobian determinant {determinant:.3e}): the \
                     outer shell must lie in the direction of the directors, farther than both distances to its faces"
                ),
            },
            other => other,
        })?;
        Ok(Wall { nodes, inner, outer, layer: layer_solid, mass: layer.mass, directors, lever, loose: false })
    }

    /// The inner shell.
    pub fn inner(&self) -> &Shell4 {
        &self.inner
    }

    /// The outer shell.
    pub fn outer(&self) -> &Shell4 {
        &self.outer
    }

    /// The layer.
    pub fn layer(&self) -> &Solid8 {
        &self.layer
    }

    /// The faces' displacements [m] and the present directors.
    fn faces(&self, motion: &Motion<'_>) -> ([f64; 24], [Vector3<f64>; 8]) {
        let mut u = [0.0; 24];
        let mut d = self.directors;
        for a in 0..8 {
            let w = turned(&motion.rotations[a], &self.directors[a]);
            d[a] += w;
            for i in 0..3 {
                u[3 * a + i] = motion.values[6 * a + i] + self.lever[a] * w[i];
            }
        }
        (u, d)
    }

    /// c P of each node.
    fn pull(&self, d: &[Vector3<f64>; 8]) -> [Matrix3<f64>; 8] {
        std::array::from_fn(|a| -d[a].cross_matrix() * self.lever[a])
    }

    /// Adds Tᵀ A T of a matrix over the faces.
    fn add_pulled(&self, face: &LocalMatrix, d: &[Vector3<f64>; 8], out: &mut LocalMatrix) {
        let pull = self.pull(d);
        for b in 0..8 {
            for a in 0..8 {
                let k = Matrix3::from_fn(|i, j| face.get(3 * a + i, 3 * b + j));
                let (left, right) = (pull[a].transpose() * k, k * pull[b]);
                let both = pull[a].transpose() * right;
                for j in 0..3 {
                    for i in 0..3 {
                        out.add(6 * a + i, 6 * b + j, k[(i, j)]);
                        out.add(6 * a + 3 + i, 6 * b + j, left[(i, j)]);
                        out.add(6 * a + i, 6 * b + 3 + j, right[(i, j)]);
                        out.add(6 * a + 3 + i, 6 * b + 3 + j, both[(i, j)]);
                    }
                }
            }
        }
    }

    /// Adds Tᵀ f of forces on the faces.
    fn add_force(&self, face: &[f64], d: &[Vector3<f64>; 8], out: &mut [f64]) {
        for a in 0..8 {
            let f = Vector3::from_column_slice(&face[3 * a..3 * a + 3]);
            let moment = d[a].cross(&f) * self.lever[a];
            for i in 0..3 {
                out[6 * a + i] += f[i];
                out[6 * a + 3 + i] += moment[i];
            }
        }
    }

    /// The shells with the place of their dofs.
    fn shells(&self) -> [(&Shell4, usize); 2] {
        [(&self.inner, 0), (&self.outer, 1)]
    }

    /// The part of a motion that concerns a shell.
    fn part<'a>(motion: &Motion<'a>, shell: usize) -> Motion<'a> {
        Motion {
            values: &motion.values[SHELL_SIZE * shell..SHELL_SIZE * (shell + 1)],
            rotations: &motion.rotations[4 * shell..4 * shell + 4],
        }
    }

    /// The shell's part of the history.
    fn slots(&self, shell: usize) -> std::ops::Range<usize> {
        let first = self.inner.history_len();
        match shell {
            0 => 0..first,
            _ => first..first + self.outer.history_len(),
        }
    }

    /// Adds the response of the layer.
    fn respond_layer(&self, motion: &Motion<'_>, want: Want, out: &mut Response) -> Result<(), ElementError> {
        let (u, d) = self.faces(motion);
        let mut part = Response::sized(24);
        let face = Motion { values: &u, rotations: &[UnitQuaternion::identity(); 8] };
        // The diagonal block needs the force.
        let needed = Want { force: true, tangent: want.tangent };
        self.layer.respond(Trial { motion: face, old: &[], new: &mut [], want: needed }, &mut part)?;
        if want.force {
            self.add_force(&part.force, &d, &mut out.force);
        }
        if want.tangent {
            self.add_pulled(&part.tangent, &d, &mut out.tangent);
            for a in 0..8 {
                let f = Vector3::from_column_slice(&part.force[3 * a..3 * a + 3]) * self.lever[a];
                add_turn_block(&mut out.tangent, a, &f, &d[a]);
            }
        }
        Ok(())
    }

    /// The mass of the layer on its faces.
    fn face_mass(&self) -> LocalMatrix {
        let mut solid = LocalMatrix::zeros(24);
        self.layer.mass(&mut solid);
        let first = match self.mass {
            LayerMass::Halves => return solid,
            LayerMass::Inner => 0,
            LayerMass::Outer => 4,
        };
        let mut moved = LocalMatrix::zeros(24);
        for b in 0..8 {
            for a in 0..8 {
                let m = solid.get(3 * a, 3 * b);
                for i in 0..3 {
                    moved.add(3 * (first + a % 4) + i, 3 * (first + b % 4) + i, m);
                }
            }
        }
        moved
    }
}

/// Adds the matrix of a shell to its block.
fn add_block(shell: usize, part: &LocalMatrix, out: &mut LocalMatrix) {
    let at = SHELL_SIZE * shell;
    for j in 0..SHELL_SIZE {
        for i in 0..SHELL_SIZE {
            out.add(at + i, at + j, part.get(i, j));
        }
    }
}

impl Element for Wall {
    crate::answers!(KIND, nodes, Dof::SHELL; contact inspect buckling);

    fn history_len(&self) -> usize {
        self.inner.history_len() + self.outer.history_len()
    }

    fn init_history(&self, slots: &mut [f64]) {
        for (shell, i) in self.shells() {
            shell.init_history(&mut slots[self.slots(i)]);
        }
    }

    fn stage(&self, stage: Stage, history: &mut [f64]) {
        for (shell, i) in self.shells() {
            shell.stage(stage, &mut history[self.slots(i)]);
        }
    }

    fn mass(&self, out: &mut LocalMatrix) {
        for (shell, i) in self.shells() {
            let mut part = LocalMatrix::zeros(SHELL_SIZE);
            shell.mass(&mut part);
            add_block(i, &part, out);
        }
        if self.layer.has_mass() {
            self.add_pulled(&self.face_mass(), &self.directors, out);
        }
    }

    fn has_mass(&self) -> bool {
        self.inner.has_mass() || self.outer.has_mass() || self.layer.has_mass()
    }

    fn respond(&self, Trial { motion, old, new, want }: Trial<'_>, out: &mut Response) -> Result<(), ElementError> {
        let mut part = Response::default();
        for (shell, i) in self.shells() {
            part.reset(SHELL_SIZE);
            let slots = self.slots(i);
            shell.respond(
                Trial { motion: Wall::part(&motion, i), old: &old[slots.clone()], new: &mut new[slots], want },
                &mut part,
            )?;
            if want.force {
                let to = &mut out.force[SHELL_SIZE * i..];
                to.iter_mut().zip(&part.force).for_each(|(f, p)| *f += p);
            }
            if want.tangent {
                add_block(i, &part.tangent, &mut out.tangent);
            }
        }
        match self.loose {
            true => Ok(()),
            false => self.respond_layer(&motion, want, out),
        }
    }

    fn damping(&self, out: &mut LocalMatrix) -> bool {
        let mut face = LocalMatrix::zeros(24);
        let damped = self.layer.damping(&mut face);
        if damped {
            self.add_pulled(&face, &self.directors, out);
        }
        damped
    }

    fn body_force(&self, acceleration: [f64; 3], out: &mut [f64]) {
        for (shell, i) in self.shells() {
            shell.body_force(acceleration, &mut out[SHELL_SIZE * i..SHELL_SIZE * (i + 1)]);
        }
        if self.layer.has_mass() {
            let field: Vec<f64> = (0..24).map(|k| acceleration[k % 3]).collect();
            let weight = self.face_mass().to_matrix().times(&field);
            self.add_force(&weight, &self.directors, out);
        }
    }
}

impl Contact for Wall {
    fn switches(&self, motion: Motion<'_>, _history: &[f64], see: &mut dyn FnMut(bool)) {
        if self.loose {
            return;
        }
        let (u, _) = self.faces(&motion);
        let face = Motion { values: &u, rotations: motion.rotations };
        self.layer.switches(face, &[], see);
    }
}

#[cfg(test)]
mod tests;
