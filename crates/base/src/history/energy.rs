//! Powers and energies of a run.

use super::modes::Motion;
use super::state::{Run, State};
use super::step::{dashpot, resist};
use crate::error::BaseError;

/// Energies [J].
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Energy {
    /// Input of the ground.
    pub input: f64,
    /// Lost in the damping of the modes.
    pub viscous: f64,
    /// Stored in the base.
    pub base_elastic: f64,
    /// Lost in loops of the base.
    pub base_hysteretic: f64,
    /// Lost in anchors that yield or break.
    pub anchors: f64,
    /// Radiated by the dashpot of the base.
    pub base_radiated: f64,
    /// Lost in friction, and the little that a plate dragged along the ground stores.
    pub friction: f64,
    /// Kinetic, and stored in the body.
    pub body: f64,
}

impl Energy {
    pub(super) fn total(&self) -> f64 {
        self.body
            + self.viscous
            + self.base_elastic
            + self.base_hysteretic
            + self.anchors
            + self.base_radiated
            + self.friction
    }
}

/// Powers, energies and forces of a state.
#[derive(Clone, Copy, Debug, Default)]
pub(super) struct Rates {
    pub(super) input: f64,
    pub(super) viscous: f64,
    pub(super) friction: f64,
    /// Moment of the dashpot of the base [N m].
    pub(super) radiated: f64,
    pub(super) body: f64,
    pub(super) moment: f64,
    pub(super) shear: f64,
    pub(super) psi: f64,
    pub(super) press: f64,
    pub(super) heave: f64,
    pub(super) drag: f64,
    /// Force of the dashpot along the ground [N].
    pub(super) dashed: f64,
    pub(super) slip: f64,
}

impl Rates {
    pub(super) fn of(run: &Run<'_>, state: &State, ground: f64) -> Result<Rates, BaseError> {
        let body = run.body;
        let (psi, s) = (state.psi, state.slip);
        let mut rates = Rates {
            psi: psi[0],
            press: state.lift.press,
            heave: state.heave[0],
            drag: state.drag,
            dashed: state.dashed,
            slip: s[0],
            ..Rates::default()
        };
        let Motion { energy, viscous, shift, turn } = state.modes.motion();
        rates.body = energy;
        rates.viscous = viscous;
        rates.body += psi[1] * turn
            + s[1] * shift
            + 0.5 * body.second_moment * psi[1] * psi[1]
            + 0.5 * body.mass * s[1] * s[1]
            + body.first_moment * psi[1] * s[1];
        rates.input = -ground * (shift + body.first_moment * psi[1] + body.mass * s[1]);
        rates.shear = state.shear;
        rates.friction = -rates.shear * s[1];
        if let Some(law) = run.law {
            // An anchor that broke at the end of the step holds no more.
            rates.moment = match run.ring {
                Some(_) => resist(run, law, state, (psi[0], state.pressure))?.moment + state.lift.response.moment,
                None => state.held,
            };
            if let Some(heave) = run.heave {
                rates.body += 0.5 * heave.mass() * state.heave[1] * state.heave[1];
            }
            rates.radiated = dashpot(run, law, psi[0]) * psi[1];
        }
        Ok(rates)
    }
}
