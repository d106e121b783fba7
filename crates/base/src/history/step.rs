//! A step in time: what sticks or slides, the equilibrium of the moment, and the state at its end.

use super::along::{Way, translation};
use super::friction::Friction;
use super::modes::Sums;
use super::scheme::{BEGIN, BETA, GAMMA, ITERATIONS, moved, predicted};
use super::state::{Run, State};
use crate::error::BaseError;
use crate::heave::{Heave, Lift, Step};
use crate::law::Law;
use crate::response::Response;
use crate::waves::Waves;

/// Newton's iterations of a step, before an equilibrium is enclosed and halved.
const SWINGS: usize = 20;
/// Factor on a correction that does not enclose one.
const HASTE: f64 = 4.0;
/// Moves to the end of step `i`.
///
/// Errors: no equilibrium.
pub(super) fn step(run: &Run<'_>, state: &mut State, i: usize) -> Result<(), BaseError> {
    let h = run.step;
    // The ground at the instant of the forces.
    let ground = (1.0 - BEGIN) * run.ground[i] + BEGIN * run.ground[i - 1];
    let sums = state.modes.sums();
    if let (Some(waves), Some(ovals)) = (run.waves, &mut state.ovals) {
        waves.begin(ovals, h);
    }
    let limit = run.friction.as_ref().map(|f| (1.0 - BEGIN) * f.at(i) + BEGIN * f.at(i - 1));
    let shear = |[a, b]: [f64; 2]| sums.shift[0] + sums.shift[1] * a + sums.shift[2] * b;
    if let (Some(friction), Some(limit), false) = (&run.friction, limit, state.along.is_empty()) {
        let held = limit / (friction.coefficient * friction.weight);
        let found = drag(run, state, &sums, ground, (friction, held))?;
        state.shear = shear(found);
        return Ok(());
    }
    // Sticking, or sliding if friction does not hold: direction of the inertia force, A and ψ̈.
    let hold = |state: &State| -> Result<(f64, [f64; 2]), BaseError> {
        let stuck = accelerations(run, state, &sums, ground, Way::Stuck)?;
        match limit {
            Some(limit) if shear(stuck).abs() > limit => {
                let sliding = shear(stuck).signum();
                let found = accelerations(run, state, &sums, ground, Way::Sliding(sliding * limit))?;
                Ok((sliding, found))
            }
            _ => Ok((0.0, stuck)),
        }
    };
    let (sliding, found) = match (state.sliding, limit) {
        (0.0, _) | (_, None) => hold(state)?,
        (direction, Some(limit)) => {
            let force = Way::Sliding(direction * limit);
            (direction, accelerations(run, state, &sums, ground, force)?)
        }
    };
    let slipping = if sliding == 0.0 { 0.0 } else { found[0] - ground };
    // As the velocities of the modes.
    let acceleration = if sliding == 0.0 { 0.0 } else { (1.0 - GAMMA) * state.slipping + GAMMA * slipping };
    let velocity = state.slip[1] + h * acceleration;
    // The slip runs against the inertia force; it ends where it would turn round, and the body sticks or slides back at once.
    let turns = sliding != 0.0 && velocity * sliding > 0.0;
    let back = if turns { Some(hold(state)?) } else { None };
    advance(run, state, &sums, found)?;
    state.shear = shear(found);
    (state.sliding, state.slipping) = (sliding, slipping);
    state.slides = sliding != 0.0;
    match back {
        None => {
            let way = h * state.slip[1] + 0.5 * h * h * acceleration;
            state.slip = [state.slip[0] + way, velocity, acceleration];
        }
        Some((direction, found)) => {
            let time = (-state.slip[1] / acceleration).clamp(0.0, h);
            let rest = h - time;
            (state.sliding, state.slipping) = match direction == -sliding {
                true => (direction, found[0] - ground),
                false => (0.0, 0.0),
            };
            let new = state.slipping;
            let way = 0.5 * (state.slip[1] * time + new * rest * rest);
            state.slip = [state.slip[0] + way, new * rest, new];
            // The base of the modes moved on as before: they take the difference.
            state.modes.take(rest, acceleration - new, slipping - new);
        }
    }
    Ok(())
}

/// A step of a plate that is dragged along the ground; A and ψ̈ in it.
///
/// * `held`: weight on the ground over that at rest
fn drag(
    run: &Run<'_>,
    state: &mut State,
    sums: &Sums,
    ground: f64,
    (friction, held): (&Friction, f64),
) -> Result<[f64; 2], BaseError> {
    state.dashpot = friction.delay * friction.drag(state.slip[0], held, &state.along).tangent;
    let found = accelerations(run, state, sums, ground, Way::Dragged(held))?;
    advance(run, state, sums, found)?;
    state.slipping = found[0] - ground;
    state.slip = moved(&state.slip, state.slipping, run.step);
    let answer = friction.drag(state.slip[0], held, &state.along);
    (state.drag, state.slides) = (answer.moment, answer.tangent == 0.0);
    // Spring and dashpot together hold no more than friction.
    let most = held * friction.most();
    state.dashed = (state.drag + state.dashpot * state.slip[1]).clamp(-most, most) - state.drag;
    friction.commit(state.slip[0], held, &mut state.along);
    Ok(found)
}

/// A and ψ̈ in a step.
fn accelerations(run: &Run<'_>, state: &State, sums: &Sums, ground: f64, way: Way) -> Result<[f64; 2], BaseError> {
    let h = run.step;
    let translation = |b: f64| translation(run, state, sums, (ground, way), b);
    let Some(law) = run.law else { return Ok([translation(0.0)[0], 0.0]) };
    let predicted = predicted(&state.psi, h);
    let psi = |b: f64| predicted[0] + BETA * h * h * b;
    let velocity = |b: f64| predicted[1] + GAMMA * h * b;
    let mut b = state.ahead;
    // A foot whose waves take time costs microseconds at each iteration; what is left of the moment does not add up, as the next step starts from that at
    // the place of this one.
    let settled = if run.waves.is_some() { 1e-5 } else { 1e-12 };
    let mut scale = run.waves.map_or(0.0, Waves::lifting);
    // Accelerations at which the base resists too little and too much; between them lies an equilibrium.
    let (mut low, mut high) = (f64::NEG_INFINITY, f64::INFINITY);
    let mut before: Option<(f64, f64)> = None;
    for iteration in 0..ITERATIONS {
        let [a, follows] = translation(b);
        let pressure = sums.pressure[0] + sums.pressure[1] * a + sums.pressure[2] * b;
        let mut response = resist(run, law, state, (psi(b), pressure))?;
        if let Some(heave) = run.heave {
            response = response.and(lift(run, (heave, law), state, (psi(b), pressure)).response);
        }
        let dashpot = dashpot(run, law, psi(b));
        let terms = [
            sums.turn[0],
            sums.turn[1] * a,
            sums.turn[2] * b,
            (1.0 - BEGIN) * (response.moment + dashpot * velocity(b)),
            BEGIN * state.moment,
        ];
        let residual: f64 = terms.iter().sum();
        scale = terms.iter().fold(scale, |s, t| s.max(t.abs()));
        if residual.abs() <= settled * scale {
            return Ok([a, b]);
        }
        if residual < 0.0 {
            low = b;
        } else {
            high = b;
        }
        let slope = sums.turn[2] + sums.turn[1] * follows;
        let tangent = slope + (1.0 - BEGIN) * (BETA * h * h * response.tangent.max(0.0) + GAMMA * h * dashpot);
        // The bottom pressure depends on ψ̈ and the dashpot on the contact, which the tangent does not know: the secant of the last two iterations does,
        // unless they lie on either side of a corner.
        let secant = before.map(|(b0, r0)| (residual - r0) / (b - b0));
        let steep = secant.filter(|s| (0.5 * tangent..=2.0 * tangent).contains(s));
        before = Some((b, residual));
        let mut next = b - residual / steep.unwrap_or(tangent);
        // What turns round is halved, what creeps is hastened.
        if iteration > SWINGS {
            next = if low.is_finite() && high.is_finite() { 0.5 * (low + high) } else { b + HASTE * (next - b) };
        }
        if !next.is_finite() {
            break;
        }
        let change = next - b;
        b = next;
        if (BETA * h * h * change).abs() < 1e-16 {
            return Ok([translation(b)[0], b]);
        }
    }
    Err(BaseError::Parameter {
        name: "rotation of the base",
        value: state.psi[0],
        allowed: "an equilibrium within the iterations of a step",
    })
}

/// The foot at the end of a step at a rotation [rad] and a bottom pressure [Pa].
fn lift(run: &Run<'_>, (heave, law): (&Heave, &Law), state: &State, (psi, pressure): (f64, f64)) -> Lift {
    let h = run.step;
    let give = BETA * h * h / heave.mass();
    let step = Step {
        place: predicted(&state.heave, h)[0] + give * BEGIN * state.lift.press,
        give: give * (1.0 - BEGIN),
        before: state.lift.load,
        length: h,
    };
    heave.lift(law, psi, pressure, step)
}

/// Dashpot of the base at a rotation [rad]: it opens with the contact [N m s].
pub(super) fn dashpot(run: &Run<'_>, law: &Law, psi: f64) -> f64 {
    if run.dashpot == 0.0 { 0.0 } else { run.dashpot * law.contact(psi) }
}

/// Moment of strips and anchors at a rotation [rad] and a bottom pressure [Pa].
///
/// Errors: no equilibrium of a foot whose waves take time.
pub(super) fn resist(
    run: &Run<'_>,
    law: &Law,
    state: &State,
    (psi, pressure): (f64, f64),
) -> Result<Response, BaseError> {
    let strips = match (run.waves, &state.ovals) {
        (Some(waves), Some(ovals)) if psi.abs() <= law.largest() => {
            let loops = law.loops(psi, law.curve(psi, pressure), run.hysteretic, &state.springs);
            waves.response(ovals, (psi, pressure))?.and(loops)
        }
        _ => law.respond(psi, pressure, run.hysteretic, &state.springs),
    };
    Ok(match run.ring {
        None => strips,
        Some(ring) => strips.and(ring.pull(psi, pressure, &state.bolts).response),
    })
}

/// Moves to the end of the step with these accelerations.
///
/// Errors: as [`resist`].
fn advance(run: &Run<'_>, state: &mut State, sums: &Sums, [a, b]: [f64; 2]) -> Result<(), BaseError> {
    let h = run.step;
    state.modes.advance([a, b]);
    let turned = state.psi[0];
    state.ahead = 2.0 * b - state.psi[2];
    state.psi = moved(&state.psi, b, h);
    let turned = state.psi[0] - turned;
    state.pressure = sums.pressure[0] + sums.pressure[1] * a + sums.pressure[2] * b;
    if let Some(law) = run.law {
        let mut moment = resist(run, law, state, (state.psi[0], state.pressure))?.moment;
        // Beyond its law a run counts no more but for how far it turns.
        state.ovals = state.ovals.take().filter(|_| state.psi[0].abs() <= law.largest());
        if let (Some(waves), Some(ovals)) = (run.waves, &mut state.ovals) {
            waves.end(ovals, state.pressure, h);
        }
        if let Some(heave) = run.heave {
            let lift = lift(run, (heave, law), state, (state.psi[0], state.pressure));
            moment += lift.response.moment;
            let force = (1.0 - BEGIN) * lift.press + BEGIN * state.lift.press;
            let before = state.heave[0];
            state.heave = moved(&state.heave, force / heave.mass(), h);
            state.lift = lift;
            state.damped = (lift.load - lift.press) * (state.heave[0] - before - lift.sinks * turned);
        }
        state.held = moment;
        state.moment = moment + dashpot(run, law, state.psi[0]) * state.psi[1];
        state.lost = law.commit(state.psi[0], &mut state.springs);
        if let Some(ring) = run.ring {
            state.cost = 0.0;
            // Where one breaks the others take its share, and may break with it.
            loop {
                let pull = ring.pull(state.psi[0], state.pressure, &state.bolts);
                let cost = ring.commit(state.psi[0], pull.centre, &mut state.bolts);
                state.cost += cost.lost;
                if !cost.breaks {
                    break;
                }
            }
        }
    }
    Ok(())
}
