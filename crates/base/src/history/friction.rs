//! Friction under the bottom.

use crate::law::Spring;
use crate::response::Response;

/// Share of its limit below which a spring sticks. One that has slipped stands at its limit but for rounding, which must not decide
/// whether the dashpot beside it acts in the next step.
const STUCK: f64 = 1.0 - 1e-9;

/// Friction under the bottom.
#[derive(Clone, Debug, PartialEq)]
pub struct Friction {
    /// Coefficient μ.
    pub coefficient: f64,
    /// Weight W of tank and liquid [N].
    pub weight: f64,
    /// Vertical ground acceleration over g at each step; empty without.
    pub vertical: Vec<f64>,
    /// The bottom plate on the ground as springs that slip at μ W altogether ([`crate::Drag`]); empty where all of it sticks or slides.
    pub springs: Vec<Spring>,
    /// What a dashpot along the ground resists with per velocity, over the stiffness of the springs that stick [s].
    pub delay: f64,
}

impl Friction {
    /// Largest force at a step [N]; none where the vertical motion lifts everything.
    pub(super) fn at(&self, i: usize) -> f64 {
        let vertical = self.vertical.get(i).copied().unwrap_or(0.0);
        (self.coefficient * self.weight * (1.0 + vertical)).max(0.0)
    }

    /// What all springs hold at rest [N].
    pub(super) fn most(&self) -> f64 {
        self.springs.iter().map(|spring| spring.limit).sum()
    }

    /// Force of the springs at a slip [m] and its derivative; `held` is the pressure on the ground over that at rest.
    pub(super) fn drag(&self, slip: f64, held: f64, slips: &[f64]) -> Response {
        let mut response = Response::default();
        for (spring, own) in self.springs.iter().zip(slips) {
            let (trial, limit) = (spring.stiffness * (slip - own), held * spring.limit);
            response.moment += trial.clamp(-limit, limit);
            if trial.abs() < STUCK * limit {
                response.tangent += spring.stiffness;
            }
        }
        response
    }

    /// Lets the springs slip to where the body is [m].
    pub(super) fn commit(&self, slip: f64, held: f64, slips: &mut [f64]) {
        for (spring, own) in self.springs.iter().zip(slips) {
            let trial = spring.stiffness * (slip - *own);
            let over = trial.abs() - held * spring.limit;
            if over > 0.0 {
                *own += over / spring.stiffness * trial.signum();
            }
        }
    }
}
