//! What of the tangent is renewed where a zone changes ([`crate::analysis::zone`]).

use std::sync::Arc;

use super::solver::{Solver, WHAT};
use super::{Newton, StepFailure};
use crate::analysis::checkpoint::{CheckpointError, Reader, Writer};
use crate::analysis::scheme::{Scheme, Weights};
use crate::analysis::zone::Zone;
use crate::analysis::zone::solver::ZoneSolver;
use crate::analysis::{AnalysisError, failed};
use crate::assembly::{Apart, Ask, Assembler};
use crate::element::Want;
use crate::linalg::{Keep, Symmetric};
use crate::state::State;

/// Part of the residual outside of the zone from which an iteration is slow by what is outside, if the zone has just been renewed: its tangent is that of
/// an earlier state, where the wall has yielded since.
const STALE: f64 = 0.5;
/// Slow iterations in succession, each with the zone renewed, after which the tangent outside of it is renewed too: most are slow by the points that meet
/// the ground and leave it in turn, and full Newton is as slow.
const SLUGGISH: usize = 8;

/// Tangents of a zone and what decides about them.
pub(super) struct Zoned {
    pub(super) zone: Arc<Zone>,
    /// Tangents of its elements.
    pub(super) own: Symmetric,
    /// The effective tangent with them.
    pub(super) whole: Symmetric,
    /// Slow iterations in succession.
    slow: usize,
    /// What is renewed in every iteration.
    pub(super) always: Renew,
    spare: Option<Spare>,
}

/// The factor of another length of step, whose zone is renewed before it is used again: steps that are halved come back to their length, and
/// the tangent outside of the zone serves both.
struct Spare {
    solver: Box<ZoneSolver>,
    weights: Weights,
    /// What it is the factor of, but for the zone.
    effective: Symmetric,
}

/// What an iteration renews.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Renew {
    Nothing,
    Zone,
    Whole,
}

impl Zoned {
    pub(super) fn new(zone: Arc<Zone>, assembler: &Assembler) -> Zoned {
        let zeros = || Symmetric::zeros(assembler.pattern().clone());
        Zoned { zone, own: zeros(), whole: zeros(), slow: 0, always: Renew::Nothing, spare: None }
    }

    /// Joins the tangents of the zone to those outside.
    pub(super) fn join(&mut self, effective: &Symmetric, w: Weights) {
        self.whole.values.copy_from_slice(&effective.values);
        self.whole.add(w.stiffness, &self.own);
    }

    pub(super) fn apart(&mut self) -> Apart<'_> {
        Apart { elements: self.zone.elements(), tangent: &mut self.own }
    }

    /// The residual corrects what a rounded factor leaves, as it does with that of an earlier state. Without inertia a thin wall is too badly
    /// conditioned for that, and a step that has failed gets no rounded factor.
    pub(super) fn keep(&self, w: Weights) -> Keep {
        if w.mass > 0.0 && self.always == Renew::Nothing { Keep::Single } else { Keep::Double }
    }

    pub(super) fn save(&self, to: &mut Writer) {
        to.numbers(&self.own.values);
        to.count(self.slow);
    }

    /// Errors: the end of the payload, numbers of another model.
    pub(super) fn restore(&mut self, from: &mut Reader) -> Result<(), CheckpointError> {
        from.numbers_into("tangent of the zone", &mut self.own.values)?;
        self.slow = from.count()?;
        Ok(())
    }

    pub(super) fn save_spare(&self, to: &mut Writer) {
        to.count(usize::from(self.spare.is_some()));
        if let Some(spare) = &self.spare {
            save_weights(to, spare.weights);
            to.numbers(&spare.effective.values);
        }
    }
}

/// A run keeps no tangent that it could not factor.
pub(super) const NO_PIVOT: CheckpointError = CheckpointError::Value {
    what: "a pivot of the effective tangent",
    found: 0.0,
    allowed: "a matrix that can be factored",
};

pub(super) fn save_weights(to: &mut Writer, w: Weights) {
    to.numbers(&[w.mass, w.damping, w.stiffness]);
}

pub(super) fn restore_weights(from: &mut Reader) -> Result<Weights, CheckpointError> {
    let mut w = [0.0; 3];
    from.numbers_into("weights", &mut w)?;
    Ok(Weights { mass: w[0], damping: w[1], stiffness: w[2] })
}

impl Newton<'_> {
    /// Reads what [`Zoned::save_spare`] has written, and factors it.
    ///
    /// Errors: the end of the payload, numbers of another model, a matrix that cannot be factored.
    pub(super) fn restore_spare(&mut self, from: &mut Reader) -> Result<(), AnalysisError> {
        let found = from.count()?;
        let Some(zoned) = &mut self.zoned else { return Ok(()) };
        zoned.spare = None;
        if found == 0 {
            return Ok(());
        }
        let weights = restore_weights(from)?;
        let mut effective = Symmetric::zeros(self.assembler.pattern().clone());
        from.numbers_into("effective tangent", &mut effective.values)?;
        let (zone, keep) = (zoned.zone.clone(), zoned.keep(weights));
        let shares = self.shares(weights);
        let mut solver = ZoneSolver::new(&zone, keep, self.threads).map_err(failed(WHAT))?;
        solver.renew_outside(&effective, &shares).map_err(|_| NO_PIVOT)?;
        if let Some(zoned) = &mut self.zoned {
            zoned.spare = Some(Spare { solver: Box::new(solver), weights, effective });
        }
        Ok(())
    }

    /// Exchanges the factor for the spare one if these weights are not its own; whether it is theirs now.
    fn exchange(&mut self, weights: Weights) -> bool {
        let Some(zoned) = &mut self.zoned else { return false };
        if zoned.always != Renew::Nothing
            || weights.mass == 0.0
            || self.factor.as_ref().is_some_and(|(_, w)| *w == weights)
        {
            return false;
        }
        let before = zoned.spare.take();
        self.set_aside();
        let Some(spare) = before else { return false };
        let found = spare.weights == weights;
        self.effective = spare.effective;
        self.factor = Some((Solver::Zone(spare.solver), spare.weights));
        found
    }

    /// Sets the factor aside as the spare one. A static step drops it and starts from its own tangents.
    pub(super) fn set_aside(&mut self) {
        let Some(zoned) = &mut self.zoned else { return };
        if let Some((Solver::Zone(solver), weights)) = self.factor.take()
            && weights.mass > 0.0
        {
            let none = Symmetric::zeros(self.assembler.pattern().clone());
            zoned.spare = Some(Spare { solver, weights, effective: std::mem::replace(&mut self.effective, none) });
        }
    }

    /// What the next increment needs under these weights; `slow`: the factor has not served the last one.
    pub(super) fn what_to_renew(&mut self, weights: Weights, slow: bool) -> Renew {
        let exchanged = self.exchange(weights);
        let current = self.factor.as_ref().is_some_and(|(_, w)| *w == weights);
        let Some(zoned) = &mut self.zoned else { return Renew::Nothing };
        zoned.slow = if slow { zoned.slow + 1 } else { 0 };
        let stale = zoned.slow > SLUGGISH || (zoned.slow > 1 && zoned.zone.share_outside(&self.room.r) > STALE);
        let renew = if !current || zoned.always == Renew::Whole || stale {
            Renew::Whole
        } else if slow || exchanged || zoned.always == Renew::Zone {
            Renew::Zone
        } else {
            Renew::Nothing
        };
        if renew == Renew::Whole {
            zoned.slow = 0;
        }
        renew
    }

    /// Takes the tangents at the trial state; whether the zone remains to be factored with the next solution.
    pub(super) fn renew(&mut self, scheme: &dyn Scheme, state: &mut State, renew: Renew) -> Result<bool, StepFailure> {
        let on_force = scheme.collocation().1;
        match renew {
            Renew::Nothing => Ok(false),
            Renew::Whole => {
                self.cost.wholes += 1;
                // Its tangents are those in a checkpoint.
                let before = self.factor.take();
                self.evaluate(state, Want::ALL, on_force)?;
                self.factor = before;
                self.refactor(scheme).map_err(StepFailure::Tangent)?;
                Ok(false)
            }
            Renew::Zone => {
                self.cost.evaluations += 1;
                self.cost.factors += 1;
                let Some(zoned) = &mut self.zoned else { return Ok(false) };
                let zone = zoned.zone.clone();
                let ask = Ask {
                    want: Want::TANGENT,
                    linear: Some(&self.linear),
                    end_tangent: 1.0 / on_force,
                    threads: self.threads,
                    tangents: Some(zone.elements()),
                };
                let (tangent, unused) = (&mut self.tangent, &mut self.unused);
                let before = self.factor.take();
                self.assembler
                    .answer_apart(self.model, state, ask, tangent, Some(zoned.apart()), unused, None)
                    .map_err(|(number, source)| StepFailure::Element { number, source })?;
                self.factor = before;
                Ok(true)
            }
        }
    }

    /// Factors the zone with the tangents there are, and x = A⁻¹ b.
    pub(super) fn renew_and_substitute(&mut self, b: &[f64], x: &mut Vec<f64>) -> Result<(), AnalysisError> {
        let (Some((Solver::Zone(solver), w)), Some(zoned)) = (&mut self.factor, &mut self.zoned) else {
            return self.back_substitute(b, x);
        };
        zoned.join(&self.effective, *w);
        let own = Some((w.stiffness, &zoned.own));
        solver.keep_as(zoned.keep(*w), false);
        let factored = solver.renew_zone(own).map_err(failed(WHAT));
        if factored.is_err() {
            self.factor = None;
            return factored;
        }
        self.back_substitute(b, x)
    }

    /// What the iterations of an attempt renew whether they are slow or not.
    pub(super) fn renew_always(&mut self, what: Renew) {
        if let Some(zoned) = &mut self.zoned {
            zoned.always = what;
        }
    }
}
