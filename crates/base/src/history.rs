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
//! M(ψ, p_b) is the curve of the strips, which is elastic: it comes back the way it went; under a rim that ovals in time it also depends on where that is
//! ([`crate::Waves`]), whose energy counts to what the base stores. The parallel springs with friction (Iwan 1966)
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
mod friction;
mod modes;
mod scheme;
mod state;
mod step;

pub use body::{Body, BodyMode};
pub use energy::Energy;
use energy::Rates;
pub use friction::Friction;
use scheme::BEGIN;
pub use state::Run;
use state::State;
use step::step;

use crate::anchors::Bolts;
use crate::error::BaseError;
use crate::warp::WAVES;

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
    /// Displacement w₀ of the centre of the foot [m]; empty of a foot without mass under a wall that does not oval in time.
    pub centre: Vec<f64>,
    /// Waves of the foot from the side that the rotation lifts [m]; empty where they follow at once.
    pub waves: Vec<[f64; WAVES]>,
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
        let (centre, ring) = (run.heave.is_some() || run.waves.is_some(), run.ring.is_some());
        History {
            rotation: room(true),
            rotational_acceleration: room(true),
            slip: room(true),
            acceleration: room(true),
            pressure: room(true),
            moment: room(true),
            resistance: room(true),
            shear: room(true),
            centre: room(centre),
            waves: Vec::with_capacity(if run.waves.is_some() { run.ground.len() } else { 0 }),
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
        if let Some(ovals) = &state.ovals {
            let (centre, waves) = ovals.foot(state.psi[0]);
            self.centre.push(centre);
            self.waves.push(waves);
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
        March {
            history: History::of(&run),
            state: State::at_rest(&run),
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
        let rates = Rates::of(run, state, ground)?;
        if i > 0 {
            let mean = |f: fn(&Rates) -> f64| 0.5 * run.step * (f(before) + f(&rates));
            let (turn, way) = (state.psi[0] - before.psi, state.slip[0] - before.slip);
            // The work of a force over the step, not its mean power: contact opens and closes dashpots within a step.
            let work = |f: fn(&Rates) -> f64, way: f64| 0.5 * (f(before) + f(&rates)) * way;
            sums.input += mean(|r| r.input);
            sums.viscous += mean(|r| r.viscous) + work(|r| r.dashed, way) + state.damped;
            sums.friction += match state.along.is_empty() {
                true => mean(|r| r.friction),
                false => work(|r| r.drag, way),
            };
            sums.base_radiated += work(|r| r.radiated, turn);
            sums.base_hysteretic += run.hysteretic * state.lost;
            sums.anchors += state.cost;
            sums.base_elastic += work(|r| r.moment, turn)
                - work(|r| r.press, state.heave[0] - before.heave)
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
        history.balance = if self.largest > 0.0 { self.off / self.largest } else { 0.0 };
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

#[cfg(test)]
mod tests;
