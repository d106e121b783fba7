//! The body along the ground: stuck, sliding, or on a plate that is dragged.

use super::modes::Sums;
use super::scheme::{BEGIN, BETA, GAMMA, ITERATIONS, predicted};
use super::state::{Run, State};
use crate::law::{Response, Spring};

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

/// How the body moves along the ground in a step.
#[derive(Clone, Copy)]
pub(super) enum Way {
    Stuck,
    /// Under this shear [N].
    Sliding(f64),
    /// On springs whose limits are this many times those at rest.
    Dragged(f64),
}

/// A in a step and its derivative by ψ̈, where ψ̈ is known.
pub(super) fn translation(run: &Run<'_>, state: &State, sums: &Sums, (ground, way): (f64, Way), b: f64) -> [f64; 2] {
    let [constant, mass, turning] = sums.shift;
    let (held, friction) = match (way, &run.friction) {
        (Way::Sliding(force), _) => return [(force - constant - turning * b) / mass, -turning / mass],
        (Way::Dragged(held), Some(friction)) => (held, friction),
        _ => return [ground, 0.0],
    };
    let h = run.step;
    let [place, velocity] = predicted(&state.slip, h);
    let share = (1.0 - BEGIN) * BETA * h * h;
    let most = held * friction.most();
    // Mass and springs resist the more, the larger s̈ is: one root.
    let mut c = state.slip[2];
    let (mut low, mut high) = (f64::NEG_INFINITY, f64::INFINITY);
    let mut stiff = 0.0;
    for _ in 0..ITERATIONS {
        let answer = friction.drag(place + BETA * h * h * c, held, &state.along);
        let along = answer.moment + state.dashpot * (velocity + GAMMA * h * c);
        let slides = along.abs() > most;
        let along = along.clamp(-most, most);
        let terms = [
            constant,
            mass * (ground + c),
            turning * b,
            (1.0 - BEGIN) * along,
            BEGIN * (state.drag + state.dashed),
        ];
        let residual: f64 = terms.iter().sum();
        stiff = match slides {
            true => 0.0,
            false => share * answer.tangent + (1.0 - BEGIN) * state.dashpot * GAMMA * h,
        };
        let scale = terms.iter().fold(0.0, |m: f64, t| m.max(t.abs()));
        if residual.abs() <= 1e-13 * scale {
            break;
        }
        if residual < 0.0 {
            low = c;
        } else {
            high = c;
        }
        let mut next = c - residual / (mass + stiff);
        if !(low..=high).contains(&next) {
            next = 0.5 * (low + high);
        }
        if next == c {
            break;
        }
        c = next;
    }
    [ground + c, -turning / (mass + stiff)]
}
