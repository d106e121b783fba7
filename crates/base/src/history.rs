//! A vibrating body on that base: rocking and sliding in time.
//!
//! ```text
//! modes      q̈_n + 2 ξ_n ω_n q̇_n + ω_n² q_n = −Γ_n A − Γ_n^ψ ψ̈                     A = a_g + s̈
//! moment     Σ Γ_n^ψ q̈_n + S A + J ψ̈ + M_b(ψ, history) + c_ψ ψ̇ = 0
//! shear      I = Σ Γ_n q̈_n + m A + S ψ̈ = −f          |f| ≤ μ N ,  N = W (1 + a_v/g)
//!            f = Σ_j clamp(k_j (s − s_j), ±m_j N/W)   of a plate dragged along the ground ([`crate::Drag`])
//! base       M_b = (1 − η) M(ψ, p_b) + η Σ_i clamp(k_i (ψ − s_i), ±m_i)
//! ```
//!
//! q_n are the modes of the body on a fixed base, ψ its rotation, s its slip; Γ_n^ψ, S and J are the rows of a rigid rotation. By
//! reciprocity the row of the moment is that of the excitation. Modes that are left out follow statically.
//!
//! M(ψ, p_b) is the curve of the strips, which is elastic: it comes back the way it went. The parallel springs with friction (Iwan 1966)
//! share its concave part and turn η of it into loops; η makes the loss of a cycle that of the strips.
//!
//! Hilber, Hughes and Taylor's method; the moment is one equation in ψ̈, solved by Newton's method. The balance
//!
//! ```text
//! ½ (Σ q̇² + 2 ψ̇ Σ Γ^ψ q̇ + 2 ṡ Σ Γ q̇ + J ψ̇² + m ṡ² + 2 S ψ̇ ṡ) + ½ Σ ω² q² + W_viscous + W_base + W_friction = −∫ a_g (Σ Γ q̇ + S ψ̇ + m ṡ) dt
//! ```
//!
//! is kept with the base's work split into what is stored, lost in loops and radiated.
//!
//! Source: Malhotra & Veletsos 1994 (rotational spring of a rocking tank); Iwan 1966; Hilber, Hughes & Taylor 1977.

mod along;
mod body;
mod energy;
mod modes;
mod scheme;

pub use along::Friction;
use along::{Way, translation};
pub use body::{Body, BodyMode};
use energy::Rates;
use modes::{Modes, Sums};
use scheme::{BEGIN, BETA, GAMMA, moved, predicted};

use crate::anchors::{Bolts, Ring};
use crate::error::BaseError;
use crate::heave::{Heave, Lift, Step};
use crate::law::{Law, Response};

/// What is given to a run.
#[derive(Clone, Debug)]
pub struct Run<'a> {
    /// The body.
    pub body: &'a Body,
    /// The base; none holds the body upright.
    pub law: Option<&'a Law>,
    /// Anchors on it.
    pub ring: Option<&'a Ring>,
    /// The mass that the foot lifts; none lifts it without inertia.
    pub heave: Option<&'a Heave>,
    /// Share η of the base's moment that is hysteretic.
    pub hysteretic: f64,
    /// Dashpot c_ψ of the closed base [N m s]; it opens with the contact.
    pub dashpot: f64,
    /// Friction; none keeps the body from sliding.
    pub friction: Option<Friction>,
    /// Rigid parts of the bottom pressure at the rim: per A [Pa s²/m] and per ψ̈ [Pa s²].
    pub rigid_pressure: [f64; 2],
    /// Time step [s].
    pub step: f64,
    /// Ground acceleration at each step [m/s²].
    pub ground: &'a [f64],
}

/// Histories at each step, and sums.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct History {
    /// Rotation ψ [rad].
    pub rotation: Vec<f64>,
    /// ψ̈ [rad/s²], linear between the instants of the forces.
    pub rotational_acceleration: Vec<f64>,
    /// Slip s [m].
    pub slip: Vec<f64>,
    /// A = a_g + s̈ [m/s²], s̈ linear between the instants of the forces.
    pub acceleration: Vec<f64>,
    /// Bottom pressure at the rim of the side to which a positive rotation leans [Pa].
    pub pressure: Vec<f64>,
    /// Moment of the base M_b [N m].
    pub moment: Vec<f64>,
    /// M_b + c_ψ ψ̇, which the inertia of the body balances [N m].
    pub resistance: Vec<f64>,
    /// Inertia force I [N].
    pub shear: Vec<f64>,
    /// Displacement w₀ of the centre of the foot [m]; empty of a foot without mass.
    pub centre: Vec<f64>,
    /// Pull of all anchors [N]; empty without them.
    pub pull: Vec<f64>,
    /// The same of the anchor that pulls most [N].
    pub anchor_force: Vec<f64>,
    /// Place of that anchor among those of the ring.
    pub anchor_place: Vec<usize>,
    /// Largest elongation of an anchor, also after it broke, play not counted [m].
    pub anchor_stretch: f64,
    /// Largest force of each anchor of the run [N], by its place in the ring.
    pub anchor_peaks: Vec<f64>,
    /// Whether all of the bottom slid at once.
    pub slid: bool,
    /// The anchors at the end.
    pub bolts: Bolts,
    /// Energies at the end [J].
    pub energy: Energy,
    /// Largest deviation of the balance over the largest input.
    pub balance: f64,
}

impl History {
    /// Empty, with room for a run.
    fn of(run: &Run<'_>) -> History {
        let room = |kept: bool| Vec::with_capacity(if kept { run.ground.len() } else { 0 });
        let (heave, ring) = (run.heave.is_some(), run.ring.is_some());
        History {
            rotation: room(true),
            rotational_acceleration: room(true),
            slip: room(true),
            acceleration: room(true),
            pressure: room(true),
            moment: room(true),
            resistance: room(true),
            shear: room(true),
            centre: room(heave),
            pull: room(ring),
            anchor_force: room(ring),
            anchor_place: Vec::with_capacity(if ring { run.ground.len() } else { 0 }),
            ..History::default()
        }
    }

    /// Adds a step.
    fn push(&mut self, run: &Run<'_>, state: &State, rates: &Rates) {
        self.rotation.push(state.psi[0]);
        self.rotational_acceleration.push(state.psi[2]);
        self.slip.push(state.slip[0]);
        self.slid |= state.slides;
        self.acceleration.push(state.slipping);
        self.pressure.push(state.pressure);
        self.moment.push(rates.moment);
        self.resistance.push(state.moment);
        self.shear.push(rates.shear);
        if run.heave.is_some() {
            self.centre.push(state.heave[0]);
        }
        if let Some(ring) = run.ring {
            let pull = ring.pull(state.psi[0], state.pressure, &state.bolts);
            let peaks = &mut self.anchor_peaks;
            peaks.resize(ring.places().len(), 0.0);
            let (mut place, mut force) = (0, 0.0);
            let forces = ring.forces(state.psi[0], pull.centre, &state.bolts);
            for ((i, found), peak) in forces.enumerate().zip(peaks) {
                *peak = peak.max(found);
                if found > force {
                    (place, force) = (i, found);
                }
            }
            self.anchor_stretch = self.anchor_stretch.max(ring.stretch(state.psi[0], pull.centre));
            self.pull.push(pull.total);
            self.anchor_force.push(force);
            self.anchor_place.push(place);
        }
    }
}

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

struct State {
    modes: Modes,
    psi: [f64; 3],
    slip: [f64; 3],
    /// Direction of the inertia force that friction balances, 0 while the body sticks.
    sliding: f64,
    /// Slips of the springs of the base.
    springs: Vec<f64>,
    /// Loss of the springs in the last step [J].
    lost: f64,
    /// Displacement, velocity and acceleration of the centre of the foot, and what presses on it.
    heave: [f64; 3],
    lift: Lift,
    /// What the damping of the foot loses in the last step [J].
    damped: f64,
    /// Anchors, and their loss in the last step [J].
    bolts: Bolts,
    cost: f64,
    pressure: f64,
    /// Moment of the base, without and with its dashpot [N m].
    held: f64,
    moment: f64,
    /// Inertia force [N].
    shear: f64,
    /// s̈ at the instant of the forces [m/s²].
    slipping: f64,
    /// Slips of the springs along the ground, and their force [N].
    along: Vec<f64>,
    drag: f64,
    /// The dashpot along the ground in this step [N s/m], and its force [N].
    dashpot: f64,
    dashed: f64,
    /// Whether all of the bottom slides.
    slides: bool,
}

/// Newton's iterations of a step, before an equilibrium is enclosed and halved.
const SWINGS: usize = 20;
/// Factor on a correction that does not enclose one.
const HASTE: f64 = 4.0;
/// Iterations of a step.
const ITERATIONS: usize = 120;

/// Marches through the ground motion from rest.
///
/// Errors: no equilibrium.
pub fn march(run: &Run<'_>) -> Result<History, BaseError> {
    let mut march = March::new(run.clone());
    march.to(run.ground.len())?;
    Ok(march.history())
}

/// A run as far as it has come: it can be looked at and go on.
pub struct March<'a> {
    run: Run<'a>,
    state: State,
    /// Accelerations of the body are those at the instants of the forces, without the ground.
    history: History,
    sums: Energy,
    before: Rates,
    /// Largest input, and deviation of the balance from it.
    largest: f64,
    off: f64,
}

impl<'a> March<'a> {
    /// At rest, before the first step.
    pub fn new(run: Run<'a>) -> March<'a> {
        let state = State {
            modes: Modes::new(run.body, run.step, run.rigid_pressure),
            psi: [0.0; 3],
            slip: [0.0; 3],
            sliding: 0.0,
            springs: vec![0.0; run.law.map_or(0, |law| law.springs().len())],
            lost: 0.0,
            heave: [run.heave.map_or(0.0, Heave::rest), 0.0, 0.0],
            lift: Lift::default(),
            damped: 0.0,
            bolts: run.ring.map_or_else(Bolts::default, Ring::unstretched),
            cost: 0.0,
            pressure: 0.0,
            held: 0.0,
            moment: 0.0,
            shear: 0.0,
            slipping: 0.0,
            along: vec![0.0; run.friction.as_ref().map_or(0, |f| f.springs.len())],
            drag: 0.0,
            dashpot: 0.0,
            dashed: 0.0,
            slides: false,
        };
        March {
            history: History::of(&run),
            state,
            sums: Energy::default(),
            before: Rates::default(),
            largest: 0.0,
            off: 0.0,
            run,
        }
    }

    /// Rotation ψ of the steps so far [rad].
    pub fn rotation(&self) -> &[f64] {
        &self.history.rotation
    }

    /// Goes on until so many steps are done, at most those of the ground motion.
    ///
    /// Errors: no equilibrium.
    pub fn to(&mut self, steps: usize) -> Result<(), BaseError> {
        let done = self.history.rotation.len();
        for i in done..steps.min(self.run.ground.len()) {
            self.step(i)?;
        }
        Ok(())
    }

    fn step(&mut self, i: usize) -> Result<(), BaseError> {
        let (run, state, sums, before) = (&self.run, &mut self.state, &mut self.sums, &self.before);
        let ground = run.ground[i];
        if i == 0 {
            state.modes.begin(ground);
        } else {
            step(run, state, i)?;
        }
        let rates = Rates::of(run, state, ground);
        if i > 0 {
            let mean = |f: fn(&Rates) -> f64| 0.5 * run.step * (f(before) + f(&rates));
            sums.input += mean(|r| r.input);
            sums.viscous += mean(|r| r.viscous) + state.damped;
            sums.friction += match state.along.is_empty() {
                true => mean(|r| r.friction),
                false => 0.5 * (before.drag + rates.drag) * (state.slip[0] - before.slip),
            };
            sums.base_radiated += mean(|r| r.radiated);
            sums.base_hysteretic += run.hysteretic * state.lost;
            sums.anchors += state.cost;
            sums.base_elastic += 0.5 * (before.moment + rates.moment) * (state.psi[0] - before.psi)
                - 0.5 * (before.press + rates.press) * (state.heave[0] - before.heave)
                - state.damped
                - run.hysteretic * state.lost
                - state.cost;
        }
        sums.body = rates.body;
        self.largest = self.largest.max(sums.input.abs());
        self.off = self.off.max((sums.total() - sums.input).abs());
        self.history.push(run, state, &rates);
        self.before = rates;
        Ok(())
    }

    /// The steps so far.
    pub fn history(self) -> History {
        let mut history = self.history;
        at_ends(&mut history.rotational_acceleration);
        at_ends(&mut history.acceleration);
        for (acceleration, ground) in history.acceleration.iter_mut().zip(self.run.ground) {
            *acceleration += ground;
        }
        history.bolts = self.state.bolts;
        history.energy = self.sums;
        history.balance = if self.largest > 0.0 {
            self.off / self.largest
        } else {
            0.0
        };
        history
    }
}

/// The values of an acceleration at the ends of the steps, from those at the instants of the forces, t − h/3.
fn at_ends(values: &mut [f64]) {
    for i in 1..values.len() {
        let next = values.get(i + 1).copied().unwrap_or(values[i]);
        values[i] += BEGIN * (next - values[i]);
    }
}

fn step(run: &Run<'_>, state: &mut State, i: usize) -> Result<(), BaseError> {
    let h = run.step;
    // The ground at the instant of the forces.
    let ground = (1.0 - BEGIN) * run.ground[i] + BEGIN * run.ground[i - 1];
    let sums = state.modes.sums();
    let limit = run
        .friction
        .as_ref()
        .map(|f| (1.0 - BEGIN) * f.at(i) + BEGIN * f.at(i - 1));
    let shear = |[a, b]: [f64; 2]| sums.shift[0] + sums.shift[1] * a + sums.shift[2] * b;
    if let (Some(friction), Some(limit), false) = (&run.friction, limit, state.along.is_empty()) {
        let held = limit / (friction.coefficient * friction.weight);
        state.dashpot = friction.delay * friction.drag(state.slip[0], held, &state.along).tangent;
        let found = accelerations(run, state, &sums, ground, Way::Dragged(held))?;
        advance(run, state, &sums, found);
        let slipping = found[0] - ground;
        state.slip = moved(&state.slip, slipping, h);
        let answer = friction.drag(state.slip[0], held, &state.along);
        (state.drag, state.slides) = (answer.moment, answer.tangent == 0.0);
        // Spring and dashpot together hold no more than friction.
        let most = held * friction.most();
        state.dashed = (state.drag + state.dashpot * state.slip[1]).clamp(-most, most) - state.drag;
        friction.commit(state.slip[0], held, &mut state.along);
        (state.shear, state.slipping) = (shear(found), slipping);
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
    let acceleration = match sliding == 0.0 {
        true => 0.0,
        false => (1.0 - GAMMA) * state.slipping + GAMMA * slipping,
    };
    let velocity = state.slip[1] + h * acceleration;
    // The slip runs against the inertia force; it ends where it would turn round, and the body sticks or slides back at once.
    let turns = sliding != 0.0 && velocity * sliding > 0.0;
    let back = if turns { Some(hold(state)?) } else { None };
    advance(run, state, &sums, found);
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

/// A and ψ̈ in a step.
fn accelerations(run: &Run<'_>, state: &State, sums: &Sums, ground: f64, way: Way) -> Result<[f64; 2], BaseError> {
    let h = run.step;
    let translation = |b: f64| translation(run, state, sums, (ground, way), b);
    let Some(law) = run.law else {
        return Ok([translation(0.0)[0], 0.0]);
    };
    let predicted = predicted(&state.psi, h);
    let psi = |b: f64| predicted[0] + BETA * h * h * b;
    let velocity = |b: f64| predicted[1] + GAMMA * h * b;
    let mut b = state.psi[2];
    let mut scale = 0.0_f64;
    // Accelerations at which the base resists too little and too much; between them lies an equilibrium.
    let (mut low, mut high) = (f64::NEG_INFINITY, f64::INFINITY);
    let mut before: Option<(f64, f64)> = None;
    for iteration in 0..ITERATIONS {
        let [a, follows] = translation(b);
        let pressure = sums.pressure[0] + sums.pressure[1] * a + sums.pressure[2] * b;
        let mut response = resist(run, law, state, (psi(b), pressure));
        if let Some(heave) = run.heave {
            let lifted = lift(run, (heave, law), state, (psi(b), pressure)).response;
            response.moment += lifted.moment;
            response.tangent += lifted.tangent;
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
        if residual.abs() <= 1e-12 * scale {
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
            next = if low.is_finite() && high.is_finite() {
                0.5 * (low + high)
            } else {
                b + HASTE * (next - b)
            };
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
fn dashpot(run: &Run<'_>, law: &Law, psi: f64) -> f64 {
    match run.dashpot == 0.0 {
        true => 0.0,
        false => run.dashpot * law.contact(psi),
    }
}

/// Moment of strips and anchors at a rotation [rad] and a bottom pressure [Pa].
fn resist(run: &Run<'_>, law: &Law, state: &State, (psi, pressure): (f64, f64)) -> Response {
    let strips = law.respond(psi, pressure, run.hysteretic, &state.springs);
    match run.ring.map(|ring| ring.pull(psi, pressure, &state.bolts).response) {
        None => strips,
        Some(anchors) => Response {
            moment: strips.moment + anchors.moment,
            tangent: strips.tangent + anchors.tangent,
        },
    }
}

/// Moves to the end of the step with these accelerations.
fn advance(run: &Run<'_>, state: &mut State, sums: &Sums, [a, b]: [f64; 2]) {
    let h = run.step;
    state.modes.advance([a, b]);
    let turned = state.psi[0];
    state.psi = moved(&state.psi, b, h);
    let turned = state.psi[0] - turned;
    state.pressure = sums.pressure[0] + sums.pressure[1] * a + sums.pressure[2] * b;
    if let Some(law) = run.law {
        let mut moment = resist(run, law, state, (state.psi[0], state.pressure)).moment;
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
}

#[cfg(test)]
mod tests;
