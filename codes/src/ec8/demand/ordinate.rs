//! The accelerations of an action with their factors, for the attribution of differences.

use tank::factor::Factor;
use tank::ingredients::Ordinate;

use super::{Demand, Source};
use crate::ec8::spectrum::{Branch, ElasticSpectrum, EnvSpectrum, damping_correction, damping_correction_env};

impl Demand<'_> {
    /// An acceleration [m/s²] that this action gives at a period [s] and damping ratio, divided by `q`.
    pub(in crate::ec8) fn ordinate(&self, value: f64, period: f64, damping: f64, q: f64) -> Ordinate {
        let ordinate = Ordinate::at(period, damping, value);
        let importance = self.site.map_or(1.0, |site| site.importance);
        match &self.source {
            Source::Record { .. } => ordinate,
            Source::En(s) => ordinate.split(&[
                (Factor::LongPeriod, long_period(s, period, damping)),
                (Factor::Importance, importance),
                (Factor::BehaviourFactor, 1.0 / q),
            ]),
            // The user's table has no branches.
            Source::Table(_) => ordinate.split(&[(Factor::Importance, importance), (Factor::BehaviourFactor, 1.0 / q)]),
            Source::Env(s) => ordinate.split(&[
                (Factor::LongPeriod, long_period_env(s, period, damping)),
                (Factor::Importance, importance),
                (Factor::BehaviourFactor, 1.0 / q),
            ]),
        }
    }
}

/// The elastic spectrum beyond T_D over its branch of constant velocity continued; 1 up to T_D.
pub(crate) fn long_period(s: &ElasticSpectrum, period: f64, damping: f64) -> f64 {
    let constant_velocity = 2.5 * s.ag * s.soil * damping_correction(damping) * s.corners[1] / period;
    beyond(s.horizontal_with_branch(period, damping), constant_velocity)
}

/// [`long_period`] of the pre-standard.
fn long_period_env(s: &EnvSpectrum, period: f64, damping: f64) -> f64 {
    let constant_velocity = 2.5 * s.ag * s.soil * damping_correction_env(damping) * s.corners[1] / period;
    beyond(s.horizontal_with_branch(period, damping), constant_velocity)
}

fn beyond((value, branch): (f64, Branch), constant_velocity: f64) -> f64 {
    match branch {
        Branch::ConstantDisplacement | Branch::Continued | Branch::AnnexA => value / constant_velocity,
        _ => 1.0,
    }
}
