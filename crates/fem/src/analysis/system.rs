//! Matrices and loads of a linear model.
//!
//! The load of a ground acceleration a_k along axis k is −(M ι_k) a_k, where M ι_k is taken over **all** dofs, the held
//! ones too: a consistent mass matrix couples free dofs with those at the supports, and a potential with walls that do
//! not move relative to the ground.

use super::AnalysisError;
use super::border::Border;
use super::damping::Damping;
use crate::assembly::Assembler;
use crate::linalg::{Symmetric, dot};
use crate::model::Model;

/// Linear system M ẍ + C ẋ + K x = −Σ (M ι_k) a_k(t) + p(t).
#[derive(Clone, Debug)]
pub struct System {
    /// M; it may be indefinite where potentials are unknowns, only the effective matrices need be quasi-definite.
    pub mass: Symmetric,
    /// K.
    pub stiffness: Symmetric,
    /// C.
    pub damping: Damping,
    /// ι_k: the unknowns in a unit translation along x, y, z.
    pub influence: [Vec<f64>; 3],
    /// M ι_k, held dofs included.
    pub inertia: [Vec<f64>; 3],
    /// A moving base below, whose rows of M are not in `mass`.
    pub border: Option<Border>,
}

impl System {
    /// Mass and stiffness of a model in its reference state, without damping.
    ///
    /// Errors: those of the elements.
    pub fn new(model: &Model, assembler: &Assembler) -> Result<System, AnalysisError> {
        let stiffness = assembler.stiffness(model).map_err(|source| AnalysisError::Element { number: 0, source })?;
        Ok(System {
            mass: assembler.mass(model),
            stiffness,
            damping: Damping::none(),
            influence: [0, 1, 2].map(|k| model.vector(|_| unit(k))),
            inertia: [0, 1, 2].map(|k| assembler.inertia(model, |_| unit(k))),
            border: None,
        })
    }

    /// A system of given matrices in which no held dof carries mass: M ι_k = M · ι_k.
    pub fn from_matrices(mass: Symmetric, stiffness: Symmetric, influence: [Vec<f64>; 3]) -> System {
        let inertia = [0, 1, 2].map(|k| mass.times(&influence[k]));
        System { mass, stiffness, damping: Damping::none(), influence, inertia, border: None }
    }

    /// With damping.
    pub fn with_damping(mut self, damping: Damping) -> System {
        self.damping = damping;
        self
    }

    /// Number of unknowns.
    pub fn size(&self) -> usize {
        self.stiffness.size()
    }

    /// Participation factors Γ = φᵀ M ι_k of a mode with φᵀ M φ = 1; their squares are the effective masses.
    pub fn participation(&self, mode: &[f64]) -> [f64; 3] {
        [0, 1, 2].map(|k| dot(mode, &self.inertia[k]))
    }
}

/// Unit translation along x, at any node.
#[cfg(test)]
pub(crate) fn unit_x(_node: usize) -> [f64; crate::dofs::KINDS] {
    unit(0)
}

/// Global components of a unit translation along axis `k`. The surface of a potential liquid rises with the tank, so that
/// its elevation relative to it, on which gravity acts, stays zero.
pub(crate) fn unit(k: usize) -> [f64; crate::dofs::KINDS] {
    let mut out = [0.0; crate::dofs::KINDS];
    out[k] = 1.0;
    if k == 2 {
        out[crate::dofs::Dof::Eta.index()] = 1.0;
    }
    out
}
