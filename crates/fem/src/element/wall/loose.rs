//! The layer of a wall that carries no tension, as an element of its own.
//!
//! A layer that opens and closes is a one-sided joint: a scheme that takes the mean of its force over a step gains energy whenever the
//! faces touch or part within the step (the layer is much stiffer than any step resolves), and without damping of the relative motion the
//! energy stays. So time steps take its force at their end ([`Contact::acts_at_end`]), those of the shells as ever. Mass, weight,
//! damping and internal state remain the [`Wall`]'s.

use super::{KIND, Wall};
use crate::dofs::Dof;
use crate::element::{Buckling, Contact, Element, ElementError, LocalMatrix, Motion, Response, Trial};

/// The layer.
#[derive(Clone)]
pub struct LooseLayer {
    wall: Wall,
}

impl Wall {
    /// The wall without the stresses of its layer, and these as an element of their own if the layer carries no tension.
    pub fn part_loose(mut self) -> (Wall, Option<LooseLayer>) {
        if self.layer.material().law.is_linear() {
            return (self, None);
        }
        let loose = LooseLayer { wall: self.clone() };
        self.loose = true;
        (self, Some(loose))
    }
}

impl Element for LooseLayer {
    crate::answers!(KIND, wall.nodes, Dof::SHELL; massless contact buckling);

    fn mass(&self, _out: &mut LocalMatrix) {}

    fn respond(&self, trial: Trial<'_>, out: &mut Response) -> Result<(), ElementError> {
        self.wall.respond_layer(&trial.motion, trial.want, out)
    }
}

impl Contact for LooseLayer {
    fn switches(&self, motion: Motion<'_>, _history: &[f64], see: &mut dyn FnMut(bool)) {
        let (u, _) = self.wall.faces(&motion);
        let face = Motion { values: &u, rotations: motion.rotations };
        self.wall.layer.switches(face, &[], see);
    }

    fn acts_at_end(&self) -> bool {
        true
    }
}

impl Buckling for LooseLayer {
    fn geometric_stiffness(&self, values: &[f64], out: &mut LocalMatrix) -> Result<(), ElementError> {
        self.wall.layer_geometric_stiffness(values, out)
    }
}
