//! Newton's part of a checkpoint: the data that the next steps need besides the state.

use super::Newton;
use super::zoned::{NO_PIVOT, restore_weights, save_weights};
use crate::analysis::AnalysisError;
use crate::analysis::checkpoint::{CheckpointError, Reader, Writer};
use crate::state::State;

impl Newton<'_> {
    /// Writes the largest first energy, the costs, C_T, the matrices of the kept factors with their weights, and the forces at the
    /// committed state.
    pub(in crate::analysis) fn save(&self, to: &mut Writer) {
        to.number(self.reference);
        let c = &self.cost;
        for count in [c.steps, c.failures, c.iterations, c.evaluations, c.factors, c.searches, c.products, c.wholes] {
            to.count(count as usize);
        }
        to.count(usize::from(self.viscous.is_some()));
        self.viscous.iter().for_each(|c| to.numbers(&c.values));
        to.count(usize::from(self.factor.is_some()));
        if let Some((_, w)) = &self.factor {
            save_weights(to, *w);
            to.numbers(&self.effective.values);
            if let Some(zoned) = &self.zoned {
                zoned.save(to);
            }
        }
        self.zoned.iter().for_each(|zoned| zoned.save_spare(to));
        to.count(usize::from(self.committed_at.is_some()));
        if self.committed_at.is_some() {
            to.numbers(&self.committed.internal);
            to.numbers(&self.committed.support);
            to.numbers(&self.committed.at_end);
        }
    }

    /// Reads the data of [`Newton::save`], for a state with the same committed fields.
    ///
    /// Errors: the end of the payload; numbers of another model; a matrix that cannot be factored.
    pub(in crate::analysis) fn restore(&mut self, from: &mut Reader, state: &State) -> Result<(), AnalysisError> {
        self.reference = from.number()?;
        let c = &mut self.cost;
        for count in [
            &mut c.steps,
            &mut c.failures,
            &mut c.iterations,
            &mut c.evaluations,
            &mut c.factors,
            &mut c.searches,
            &mut c.products,
            &mut c.wholes,
        ] {
            *count = from.count()? as u64;
        }
        let found = from.count()?;
        let allowed = usize::from(self.viscous.is_some());
        if found != allowed {
            let what = "matrices of tangent damping";
            return Err(CheckpointError::Shape { what, found, allowed }.into());
        }
        if let Some(c) = &mut self.viscous {
            from.numbers_into("tangent damping", &mut c.values)?;
        }
        self.factor = None;
        if from.count()? != 0 {
            let weights = restore_weights(from)?;
            from.numbers_into("effective tangent", &mut self.effective.values)?;
            if let Some(zoned) = &mut self.zoned {
                zoned.restore(from)?;
            }
            self.factorise(weights).map_err(|_| NO_PIVOT)?;
        }
        if self.zoned.is_some() {
            self.restore_spare(from)?;
        }
        if from.count()? != 0 {
            let unknowns = self.model.dofs().len();
            let late = if self.assembler.acts_at_end() { unknowns } else { 0 };
            let forces = &mut self.forces;
            for (what, values, length) in [
                ("internal forces", &mut forces.internal, unknowns),
                ("support forces", &mut forces.support, self.assembler.supports().len()),
                ("forces at the end of the step", &mut forces.at_end, late),
            ] {
                values.resize(length, 0.0);
                from.numbers_into(what, values)?;
            }
            self.keep_forces(state);
        }
        Ok(())
    }
}
