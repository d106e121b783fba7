//! A body in its modes on isolators, two horizontal components.
//!
//! ```text
//! modes   ÿ_n + 2 ξ_n ω_n ẏ_n + ω_n² y_n = −A             A = a_g + d̈
//! base    M A + Σ m_n ÿ_n + ΔV + F(d, ḋ, history) = 0
//! ```
//!
//! y_n is the displacement of the effective mass m_n to the base, M all mass with the slab, d the displacement of the isolators, F their
//! force. The mass M − Σ m_n moves with the base. ΔV is what another model of the body exerts beyond its modes, given over time.
//!
//! Newmark's average acceleration: eliminating the modes leaves a vector equation in d,
//!
//! ```text
//! B (d − d*) + h + g = 0          |h| ≤ q
//! ```
//!
//! which has a closed solution on the circular yield surface; a damper with α ≠ 1 and a friction that depends on the velocity enter by
//! their secants, iterated.
//!
//! Source: Jadhav & Jangid 2004; Shrimali & Jangid 2002 (tank of lumped masses on isolators).

use oscillator::newmark::Newmark;

use crate::error::{SoilError, not_negative, positive};
use crate::isolator::{Isolator, Parts, Yield, yielding_force};

/// A mode of the body on a fixed base.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Mode {
    /// Effective mass m_n [kg].
    pub mass: f64,
    /// ω_n [rad/s].
    pub omega: f64,
    /// ξ_n.
    pub damping: f64,
}

/// What is given to a run.
#[derive(Clone, Debug)]
pub struct Run<'a> {
    /// Mass M of tank, liquid and slab [kg].
    pub mass: f64,
    /// Modes, in both directions alike.
    pub modes: &'a [Mode],
    /// Isolators.
    pub isolators: &'a [Isolator],
    /// Gravity [m/s²].
    pub gravity: f64,
    /// Time between samples [s].
    pub step: f64,
    /// Steps to a sample, at least 1.
    pub parts: usize,
    /// Ground acceleration along x and y at each sample [m/s²]; linear between.
    pub ground: &'a [[f64; 2]],
    /// Vertical ground acceleration at each sample [m/s²]; empty without.
    pub vertical: &'a [f64],
    /// ΔV at each sample [N]; empty without.
    pub more: &'a [[f64; 2]],
}

/// Histories at each step (not sample), both components.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct History {
    /// Displacement d of the isolators [m].
    pub displacement: Vec<[f64; 2]>,
    /// Force F of the isolators [N].
    pub force: Vec<[f64; 2]>,
    /// Acceleration A of the base [m/s²].
    pub acceleration: Vec<[f64; 2]>,
    /// Displacement y_n [m] and acceleration y_n'' + A [m/s²] of each mode.
    pub modes: Vec<Vec<ModeState>>,
    /// Energies at the end [J].
    pub energy: Energy,
}

/// State of a mode at an instant.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct ModeState {
    /// y_n [m].
    pub displacement: [f64; 2],
    /// ÿ_n + A [m/s²].
    pub acceleration: [f64; 2],
}

/// Energies [J].
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Energy {
    /// Input of the ground, −∫ a_g (M ḋ + Σ m_n ẏ_n) dt, and of ΔV, −∫ ΔV ḋ dt.
    pub input: f64,
    /// Kinetic, relative to the ground, and elastic in the modes.
    pub body: f64,
    /// Lost in the damping of the modes.
    pub viscous: f64,
    /// Work of the isolators, stored and lost.
    pub isolators: f64,
}

impl Energy {
    /// Deviation of the balance over the input.
    pub fn deviation(&self) -> f64 {
        (self.body + self.viscous + self.isolators - self.input) / self.input.abs().max(f64::MIN_POSITIVE)
    }
}

/// Displacement, velocity, acceleration.
#[derive(Clone, Copy, Debug, Default)]
struct Point {
    u: [f64; 2],
    v: [f64; 2],
    a: [f64; 2],
}

impl Point {
    fn take(&mut self, n: &Newmark, acceleration: [f64; 2]) {
        for c in 0..2 {
            let (u, v) = self.predict(n, c);
            self.u[c] = u + acceleration[c] / n.a0;
            self.v[c] = v + n.a7 * acceleration[c];
            self.a[c] = acceleration[c];
        }
    }

    fn predict(&self, n: &Newmark, c: usize) -> (f64, f64) {
        let (u, v, a) = (self.u[c], self.v[c], self.a[c]);
        (n.predict_displacement(u, v, a), n.predict_velocity(v, a))
    }
}

/// Largest size of a vector in a history.
pub fn peak(history: &[[f64; 2]]) -> f64 {
    history.iter().fold(0.0, |most: f64, v| most.max(v[0].hypot(v[1])))
}

/// Runs the body on its isolators from rest.
///
/// Errors: values outside their range; effective masses above the mass; a vertical acceleration of another length; no isolator; an
/// iteration of secants without convergence.
pub fn march(run: &Run<'_>) -> Result<History, SoilError> {
    check(run)?;
    let n = Newmark::average_acceleration(run.step / run.parts as f64);
    let laws: Vec<Parts> = run.isolators.iter().map(|i| i.parts(run.mass, run.gravity)).collect();
    let mut state = State {
        base: Point::default(),
        modes: vec![Point::default(); run.modes.len()],
        slips: vec![[0.0; 2]; laws.len()],
    };
    let first = run.ground.first().copied().unwrap_or_default();
    state.modes.iter_mut().for_each(|m| m.a = [0.0; 2]);
    // At rest with no force in the isolators the base keeps still in space: d̈ = −a_g, A = 0, ÿ = 0.
    state.base.a = first.map(|a| -a);
    let mut history = History { modes: vec![Vec::new(); run.modes.len()], ..History::default() };
    let mut last = Instant::at_rest(first);
    history.push(&state, &last);
    for (i, pair) in run.ground.windows(2).enumerate() {
        for part in 1..=run.parts {
            let f = part as f64 / run.parts as f64;
            let between = |a: f64, b: f64| a + (b - a) * f;
            let ground = [between(pair[0][0], pair[1][0]), between(pair[0][1], pair[1][1])];
            let vertical = match run.vertical {
                [] => 0.0,
                a => between(a[i], a[i + 1]),
            };
            let more = match run.more {
                [] => [0.0; 2],
                v => [0, 1].map(|c| between(v[i][c], v[i + 1][c])),
            };
            let before = state.clone();
            let now = advance(run, &laws, &n, &mut state, (ground, more), 1.0 + vertical / run.gravity)?;
            history.energy.add(run, &before, &last, &state, &now);
            last = now;
            history.push(&state, &last);
        }
    }
    history.energy.body = body_energy(run, &state);
    Ok(history)
}

fn check(run: &Run<'_>) -> Result<(), SoilError> {
    positive("mass on the isolators [kg]", run.mass)?;
    positive("gravity [m/s2]", run.gravity)?;
    positive("time step [s]", run.step)?;
    positive("number of isolators", run.isolators.len() as f64)?;
    positive("steps to a sample", run.parts as f64)?;
    for mode in run.modes {
        not_negative("effective mass [kg]", mode.mass)?;
        positive("frequency of a mode [rad/s]", mode.omega)?;
        not_negative("damping ratio of a mode", mode.damping)?;
    }
    let moving: f64 = run.modes.iter().map(|m| m.mass).sum();
    not_negative("mass less the effective masses of the modes [kg]", run.mass - moving)?;
    if !run.more.is_empty() && run.more.len() != run.ground.len() {
        return Err(SoilError::Value {
            what: "samples of the further force",
            found: run.more.len() as f64,
            expected: "as many as of the horizontal acceleration",
        });
    }
    if !run.vertical.is_empty() && run.vertical.len() != run.ground.len() {
        return Err(SoilError::Value {
            what: "samples of the vertical acceleration",
            found: run.vertical.len() as f64,
            expected: "as many as of the horizontal acceleration",
        });
    }
    run.isolators.iter().try_for_each(Isolator::check)
}

#[derive(Clone, Debug)]
struct State {
    base: Point,
    modes: Vec<Point>,
    slips: Vec<[f64; 2]>,
}

/// Ground and forces of an instant.
#[derive(Clone, Copy, Debug)]
struct Instant {
    ground: [f64; 2],
    force: [f64; 2],
    more: [f64; 2],
}

impl Instant {
    fn at_rest(ground: [f64; 2]) -> Instant {
        Instant { ground, force: [0.0; 2], more: [0.0; 2] }
    }
}

impl History {
    fn push(&mut self, state: &State, now: &Instant) {
        let base = [0, 1].map(|c| now.ground[c] + state.base.a[c]);
        self.displacement.push(state.base.u);
        self.force.push(now.force);
        self.acceleration.push(base);
        for (mode, point) in self.modes.iter_mut().zip(&state.modes) {
            mode.push(ModeState { displacement: point.u, acceleration: [0, 1].map(|c| base[c] + point.a[c]) });
        }
    }
}

/// One step: new state, force of the isolators.
fn advance(
    run: &Run<'_>,
    laws: &[Parts],
    n: &Newmark,
    state: &mut State,
    (ground, more): ([f64; 2], [f64; 2]),
    press: f64,
) -> Result<Instant, SoilError> {
    // ÿ_n = s_n − r_n A with s_n, r_n of the step; the base then carries M_e A + g.
    let rate = |m: &Mode| 1.0 / (1.0 + 2.0 * n.a7 * m.damping * m.omega + m.omega * m.omega / n.a0);
    let own = |m: &Mode, p: &Point, c: usize| {
        let (u, v) = p.predict(n, c);
        -(2.0 * m.damping * m.omega * v + m.omega * m.omega * u) * rate(m)
    };
    let carried = run.mass - run.modes.iter().map(|m| m.mass * rate(m)).sum::<f64>();
    let inertia = [0, 1].map(|c| {
        let modal: f64 = run.modes.iter().zip(&state.modes).map(|(m, p)| m.mass * own(m, p, c)).sum();
        carried * ground[c] + modal + more[c]
    });
    let start = [0, 1].map(|c| state.base.predict(n, c));
    let old = state.base.u;
    let (mut d, slips) = (state.base.u, state.slips.clone());
    let velocity = |d: [f64; 2]| [0, 1].map(|c| start[c].1 + n.a1 * (d[c] - start[c].0));
    let mut speed = state.base.v[0].hypot(state.base.v[1]);
    // Laws that depend on the speed by other than a constant dashpot are taken by their secant.
    let iterates = laws.iter().any(|l| {
        l.damper.is_some_and(|(_, alpha)| alpha != 1.0)
            || matches!(l.yields, Yield::Friction(f, _) if f.fast != f.slow && f.rate > 0.0)
    });
    const STEPS: usize = 200;
    let mut change = 0.0;
    for _ in 0..STEPS {
        let viscous: f64 = laws.iter().map(|l| l.viscous + secant(l, speed)).sum();
        let linear: f64 = laws.iter().map(|l| l.linear * stretch(l, press)).sum();
        // B d + h(d) = rhs.
        let stiffness = n.a0 * carried + n.a1 * viscous + linear;
        let rhs = [0, 1].map(|c| {
            let (u, v) = start[c];
            n.a0 * carried * u + viscous * (n.a1 * u - v) - inertia[c]
        });
        d = balance(stiffness, rhs, laws, &slips, |l| strength(l, speed, press), d);
        let v = velocity(d);
        let new = v[0].hypot(v[1]);
        // In displacement, over the way of the step and a nanometre.
        change = (new - speed).abs() * n.h / ((d[0] - old[0]).hypot(d[1] - old[1]) + 1e-9);
        speed = if iterates { 0.5 * (speed + new) } else { new };
        if !iterates || change < 1e-10 {
            change = 0.0;
            break;
        }
    }
    if change.is_nan() || change > 1e-4 {
        let what = "isolator that depends on the velocity";
        return Err(SoilError::Iteration { what, steps: STEPS, change });
    }
    let v = velocity(d);
    let force = resist(laws, &mut state.slips, (d, v), speed, press);
    let acceleration = [0, 1].map(|c| n.a0 * (d[c] - start[c].0));
    for (mode, point) in run.modes.iter().zip(&mut state.modes) {
        let modal = [0, 1].map(|c| own(mode, point, c) - rate(mode) * (ground[c] + acceleration[c]));
        point.take(n, modal);
    }
    state.base.take(n, acceleration);
    Ok(Instant { ground, force, more })
}

/// Force of the isolators at a displacement [m] and a velocity [m/s]; their slips move on.
fn resist(laws: &[Parts], slips: &mut [[f64; 2]], (d, v): ([f64; 2], [f64; 2]), speed: f64, press: f64) -> [f64; 2] {
    let viscous: f64 = laws.iter().map(|l| l.viscous + secant(l, speed)).sum();
    let mut force = [0, 1].map(|c| viscous * v[c]);
    for (law, slip) in laws.iter().zip(slips) {
        let linear = law.linear * stretch(law, press);
        force = [0, 1].map(|c| force[c] + linear * d[c]);
        if law.stick > 0.0 {
            let (part, moved) = yielding_force(law.stick, strength(law, speed, press), d, *slip);
            force = [0, 1].map(|c| force[c] + part[c]);
            *slip = moved;
        }
    }
    force
}

/// Secant of a damper at a speed; below a micrometre a second that of this speed.
fn secant(law: &Parts, speed: f64) -> f64 {
    law.damper.map_or(0.0, |(c, alpha)| c * speed.max(1e-6).powf(alpha - 1.0))
}

/// Stiffness of a pendulum follows the weight.
fn stretch(law: &Parts, press: f64) -> f64 {
    match law.yields {
        Yield::Constant(_) => 1.0,
        Yield::Friction(..) => press.max(0.0),
    }
}

fn strength(law: &Parts, speed: f64, press: f64) -> f64 {
    match law.yields {
        Yield::Constant(q) => q,
        Yield::Friction(friction, weight) => friction.at(speed) * weight * press.max(0.0),
    }
}

/// d of B d + Σ h_i(d) = rhs. One yielding law has a closed solution: while it sticks linear, else h points along rhs − B s. Several are
/// taken in turn, each with the others' last force.
fn balance(
    stiffness: f64,
    rhs: [f64; 2],
    laws: &[Parts],
    slips: &[[f64; 2]],
    strength: impl Fn(&Parts) -> f64,
    start: [f64; 2],
) -> [f64; 2] {
    let yielding: Vec<usize> = (0..laws.len()).filter(|&i| laws[i].stick > 0.0).collect();
    let one = |i: usize, rhs: [f64; 2]| {
        let (law, s) = (&laws[i], slips[i]);
        let d = [0, 1].map(|c| (rhs[c] + law.stick * s[c]) / (stiffness + law.stick));
        let size = law.stick * (d[0] - s[0]).hypot(d[1] - s[1]);
        let q = strength(law);
        if size <= q {
            return d;
        }
        let drive = [0, 1].map(|c| rhs[c] - stiffness * s[c]);
        let length = drive[0].hypot(drive[1]);
        [0, 1].map(|c| (rhs[c] - q * drive[c] / length) / stiffness)
    };
    match yielding[..] {
        [] => rhs.map(|r| r / stiffness),
        [i] => one(i, rhs),
        _ => {
            // A Newton step on all, from the last displacement; h is piecewise smooth and monotone, so it settles in a few steps.
            let mut d = start;
            for _ in 0..100 {
                let mut residual = [0, 1].map(|c| stiffness * d[c] - rhs[c]);
                let mut k = [[stiffness, 0.0], [0.0, stiffness]];
                for &i in &yielding {
                    let (law, q) = (&laws[i], strength(&laws[i]));
                    let (h, _) = yielding_force(law.stick, q, d, slips[i]);
                    residual = [0, 1].map(|c| residual[c] + h[c]);
                    let e = [d[0] - slips[i][0], d[1] - slips[i][1]];
                    let length = e[0].hypot(e[1]);
                    let slides = law.stick * length > q;
                    for a in 0..2 {
                        for b in 0..2 {
                            let same = if a == b { 1.0 } else { 0.0 };
                            k[a][b] += if slides {
                                q / length * (same - e[a] * e[b] / (length * length))
                            } else {
                                law.stick * same
                            };
                        }
                    }
                }
                let det = k[0][0] * k[1][1] - k[0][1] * k[1][0];
                let step = [
                    (k[1][1] * residual[0] - k[0][1] * residual[1]) / det,
                    (k[0][0] * residual[1] - k[1][0] * residual[0]) / det,
                ];
                d = [d[0] - step[0], d[1] - step[1]];
                if step[0].hypot(step[1]) <= 1e-14 * (1e-6 + d[0].hypot(d[1])) {
                    break;
                }
            }
            d
        }
    }
}

impl Energy {
    /// Work of a step by the trapezoidal rule, in which the balance of the method is exact for linear parts.
    fn add(&mut self, run: &Run<'_>, from: &State, last: &Instant, to: &State, now: &Instant) {
        for c in 0..2 {
            let ground = 0.5 * (last.ground[c] + now.ground[c]);
            let way = to.base.u[c] - from.base.u[c];
            self.isolators += 0.5 * (last.force[c] + now.force[c]) * way;
            self.input -= (ground * run.mass + 0.5 * (last.more[c] + now.more[c])) * way;
            for ((mode, a), b) in run.modes.iter().zip(&from.modes).zip(&to.modes) {
                let way = b.u[c] - a.u[c];
                self.input -= ground * mode.mass * way;
                self.viscous += mode.mass * mode.damping * mode.omega * (a.v[c] + b.v[c]) * way;
            }
        }
    }
}

fn body_energy(run: &Run<'_>, state: &State) -> f64 {
    let mut sum = 0.0;
    for c in 0..2 {
        let base = state.base.v[c];
        sum += 0.5 * run.mass * base * base;
        for (mode, p) in run.modes.iter().zip(&state.modes) {
            let (u, v) = (p.u[c], p.v[c]);
            sum += mode.mass * (0.5 * v * v + v * base + 0.5 * (mode.omega * u).powi(2));
        }
    }
    sum
}
