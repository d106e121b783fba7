//! What a resumed run needs of Newton's method.

use super::{Cost, Newton};
use crate::analysis::AnalysisError;
use crate::analysis::checkpoint::CheckpointError;
use crate::analysis::scheme::Weights;
use crate::assembly::Forces;
use crate::state::State;

/// See [`Newton::memory`].
#[derive(Clone, Debug, PartialEq)]
pub(in crate::analysis) struct Memory {
    pub reference: f64,
    pub viscous: Option<Vec<f64>>,
    pub kept: Option<(Weights, Vec<f64>)>,
    pub forces: Option<Forces>,
    pub cost: Cost,
}

impl Newton<'_> {
    /// The parts that the next steps depend on, besides the state: largest first energy, C_T, and the matrix that the kept
    /// factor was made of with its weights.
    pub(in crate::analysis) fn memory(&self) -> Memory {
        let weights = self.factor.as_ref().map(|(_, w)| *w);
        Memory {
            reference: self.reference,
            viscous: self.viscous.as_ref().map(|c| c.values.clone()),
            kept: weights.map(|w| (w, self.effective.values.clone())),
            forces: self.committed_at.is_some().then(|| self.committed.clone()),
            cost: self.cost,
        }
    }

    /// Restores what [`Newton::memory`] gave, for a state with the same committed fields.
    ///
    /// Errors: numbers that are not of this model; a matrix that cannot be factored.
    pub(in crate::analysis) fn recall(&mut self, memory: Memory, state: &State) -> Result<(), AnalysisError> {
        let of_this_model = |what, found: usize, allowed: usize| match found == allowed {
            true => Ok(()),
            false => Err(CheckpointError::Shape { what, found, allowed }),
        };
        let unknowns = self.model.dofs().len();
        let entries = |m: Option<usize>| m.unwrap_or(0);
        of_this_model(
            "tangent damping",
            entries(memory.viscous.as_ref().map(Vec::len)),
            entries(self.viscous.as_ref().map(|c| c.values.len())),
        )?;
        if let Some((_, values)) = &memory.kept {
            of_this_model("effective tangent", values.len(), self.effective.values.len())?;
        }
        if let Some(forces) = &memory.forces {
            let late = self.assembler.acts_at_end();
            of_this_model("internal forces", forces.internal.len(), unknowns)?;
            of_this_model("support forces", forces.support.len(), self.assembler.supports().len())?;
            let allowed = if late { unknowns } else { 0 };
            of_this_model("forces at the end of the step", forces.at_end.len(), allowed)?;
        }
        self.reference = memory.reference;
        self.cost = memory.cost;
        if let (Some(c), Some(values)) = (&mut self.viscous, memory.viscous) {
            c.values = values;
        }
        self.factor = None;
        if let Some((weights, values)) = memory.kept {
            self.effective.values = values;
            // A run keeps no tangent that it could not factor.
            let factor = self.symbolic.factor(&self.effective, self.kind);
            let factor = factor.map_err(|_| CheckpointError::Value {
                what: "a pivot of the effective tangent",
                found: 0.0,
                allowed: "a matrix that can be factored",
            })?;
            self.factor = Some((factor, weights));
        }
        if let Some(forces) = memory.forces {
            self.forces = forces;
            self.keep_forces(state);
        }
        Ok(())
    }
}
