//! The body along the ground: stuck, sliding, or on a plate that is dragged.

use super::modes::Sums;
use super::scheme::{BEGIN, BETA, GAMMA, ITERATIONS, predicted};
use super::state::{Run, State};

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
        let terms =
            [constant, mass * (ground + c), turning * b, (1.0 - BEGIN) * along, BEGIN * (state.drag + state.dashed)];
        let residual: f64 = terms.iter().sum();
        stiff = if slides { 0.0 } else { share * answer.tangent + (1.0 - BEGIN) * state.dashpot * GAMMA * h };
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
