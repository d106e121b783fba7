//! The march in time, and what a march leaves.

use super::basis::Place;
use super::expansion::{Liquid, Work};
use super::motion::{Drive, Motion};

/// Longest step times the highest circular frequency. Half of it changes a crest by less than a thousandth.
const STEP: f64 = 0.25;

/// Slope of the surface at which a march stops: third order is not one of such a surface.
const STEEP: f64 = 2.0;

/// Slope above which a wave may break: the crest of the highest standing wave in deep liquid has a right angle.
pub const BREAKING: f64 = 1.0;

/// Part of the depth that a trough may take.
const DRY: f64 = 0.95;

/// Values that a frame stores of each mode.
const KINDS: usize = 6;

/// Why a march stopped.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Reason {
    /// The slope of the surface reached 2: the wave breaks.
    Steep,
    /// A trough came near the floor.
    Dry,
    /// The expansion lost its convergence.
    Diverged,
}

/// Where and when a march stopped. What it has until then is a lower bound.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Stop {
    /// Why.
    pub reason: Reason,
    /// Time [s].
    pub time: f64,
    /// Place on the level at rest [m].
    pub place: Place,
}

/// Energies of the liquid in the frame of the tank [J].
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Energy {
    /// Work of the motion.
    pub input: f64,
    /// Kinetic energy.
    pub kinetic: f64,
    /// Potential energy.
    pub potential: f64,
    /// Work of damping.
    pub damped: f64,
}

impl Energy {
    /// Input less all that it became [J]; zero for exact arithmetic and step.
    pub fn rest(&self) -> f64 {
        self.input - self.kinetic - self.potential - self.damped
    }
}

/// One instant of a march: coefficients of the modes.
#[derive(Clone, Copy, Debug)]
pub struct Frame<'a> {
    /// Time [s].
    pub time: f64,
    /// Motion that the forces of this instant contain.
    pub motion: Motion,
    /// Elevation η [m].
    pub elevation: &'a [f64],
    /// η̇ [m/s].
    pub rate: &'a [f64],
    /// η̈ [m/s²].
    pub second: &'a [f64],
    /// The potential φ at the level at rest [m²/s].
    pub potential: &'a [f64],
    /// Its time derivative at rest in the tank [m²/s²].
    pub potential_rate: &'a [f64],
    /// Coefficients of ψ, the potential on the surface [m²/s].
    pub surface: &'a [f64],
}

/// A march: its instants, energies, and how it ended.
#[derive(Clone, Debug)]
pub struct Run {
    modes: usize,
    step: f64,
    motions: Vec<Motion>,
    values: Vec<f64>,
    /// Energies at each instant.
    pub energies: Vec<Energy>,
    /// Where it stopped before the end.
    pub stop: Option<Stop>,
    /// Largest mean elevation, in metres: the volume that the truncation creates over the area.
    pub volume_error: f64,
    /// Largest slope of the surface; above [`BREAKING`] what follows is a lower bound.
    pub slope: f64,
    /// When it first exceeded [`BREAKING`] [s].
    pub breaks: Option<f64>,
}

/// Marches from rest, or from the coefficients `start` of η and ψ, for `duration` [s] by the classical Runge-Kutta method.
///
/// * `carried`: the motion that forces and pressures contain at an instant, from the motion there. The engines leave the
///   horizontal acceleration out, whose part they take from the elastic wall; the waves always feel the whole motion.
pub fn run(
    liquid: &Liquid,
    drive: &dyn Drive,
    duration: f64,
    start: Option<(&[f64], &[f64])>,
    carried: fn(Motion) -> Motion,
) -> Run {
    let n = liquid.basis().modes().len();
    let fastest = liquid.omega().iter().fold(0.0_f64, |a, &b| a.max(b));
    let steps = (duration * fastest / STEP).ceil().max(1.0) as usize;
    march(liquid, drive, (steps, duration / steps as f64), start.unwrap_or((&vec![0.0; n], &vec![0.0; n])), carried)
}

/// Stages of the classical method: part of the step, weight, index of the motion.
const STAGES: [(f64, f64, usize); 4] =
    [(0.0, 1.0 / 6.0, 0), (0.5, 1.0 / 3.0, 1), (0.5, 1.0 / 3.0, 1), (1.0, 1.0 / 6.0, 2)];

/// Marches a number of equal steps.
pub(super) fn march(
    liquid: &Liquid,
    drive: &dyn Drive,
    (steps, step): (usize, f64),
    start: (&[f64], &[f64]),
    carried: fn(Motion) -> Motion,
) -> Run {
    let n = liquid.basis().modes().len();
    let mut work = liquid.work();
    let (mut eta, mut psi) = (start.0.to_vec(), start.1.to_vec());
    let mut run = Run {
        modes: n,
        step,
        motions: Vec::with_capacity(steps + 1),
        values: Vec::with_capacity((steps + 1) * n * KINDS),
        energies: Vec::with_capacity(steps + 1),
        stop: None,
        volume_error: 0.0,
        slope: 0.0,
        breaks: None,
    };
    let [mut trial, mut rates, mut first, mut sum, mut before] = [(); 5].map(|()| [vec![0.0; n], vec![0.0; n]]);
    let mut differences = Differences::new(n);
    let mut last = [Motion::default(); 3];
    let (mut input, mut damped) = (0.0, 0.0);
    for i in 0..=steps {
        let time = i as f64 * step;
        let motions = drive.over(time, step);
        sum.iter_mut().for_each(|s| s.fill(0.0));
        let mut damped_rate = 0.0;
        for (stage, (part, weight, at)) in STAGES.into_iter().enumerate() {
            for j in 0..n {
                trial[0][j] = eta[j] + part * step * rates[0][j];
                trial[1][j] = psi[j] + part * step * rates[1][j];
            }
            let [rise, push] = &mut rates;
            liquid.rates((&trial[0], &trial[1]), &motions[at], &mut work, (rise, push));
            if stage == 0 {
                // A finished step: what it has, and whether the next may follow.
                first[0].copy_from_slice(&rates[0]);
                first[1].copy_from_slice(&rates[1]);
                if let Some(stop) = judge(liquid, &work, time, &eta) {
                    run.stop = Some(stop);
                    return run;
                }
                run.slope = run.slope.max(work.steepest.0.sqrt());
                if run.slope > BREAKING && run.breaks.is_none() {
                    run.breaks = Some(time);
                }
                run.volume_error = run.volume_error.max(eta[0].abs());
                if i > 0 {
                    input += step * given(liquid, [&before[0], &before[1]], [&eta, &rates[0]], (&last, step));
                }
                run.energies.push(Energy { input, damped, ..stored(liquid, &eta, &psi, &rates[0]) });
                let now = carried(drive.now(time));
                differences.push(liquid, (&eta, &psi), &first, (&motions[0], &now), &mut work, &mut run.values);
                run.motions.push(now);
                if i == steps {
                    return run;
                }
            }
            damped_rate += weight * lost(liquid, &trial, &rates);
            for f in 0..2 {
                for j in 0..n {
                    sum[f][j] += weight * rates[f][j];
                }
            }
        }
        before[0].copy_from_slice(&eta);
        before[1].copy_from_slice(&first[0]);
        last = motions;
        for j in 0..n {
            eta[j] += step * sum[0][j];
            psi[j] += step * sum[1][j];
        }
        damped += step * damped_rate;
    }
    run
}

/// Whether the surface is one that the expansion can carry on.
fn judge(liquid: &Liquid, work: &Work, time: f64, eta: &[f64]) -> Option<Stop> {
    let at = |point: usize| liquid.basis().places[point];
    if !eta.iter().all(|v| v.is_finite()) {
        return Some(Stop { reason: Reason::Diverged, time, place: at(work.steepest.1) });
    }
    // A linear wave of any height is one.
    if liquid.own.order == 1 {
        return None;
    }
    if work.steepest.0 > STEEP * STEEP {
        return Some(Stop { reason: Reason::Steep, time, place: at(work.steepest.1) });
    }
    if work.lowest.0 < -DRY * liquid.own.depth {
        return Some(Stop { reason: Reason::Dry, time, place: at(work.lowest.1) });
    }
    None
}

/// Kinetic and potential energy.
fn stored(liquid: &Liquid, eta: &[f64], psi: &[f64], rise: &[f64]) -> Energy {
    let own = liquid.own;
    let sum = |f: &dyn Fn(usize) -> f64| -> f64 { (0..eta.len()).map(|j| liquid.basis.norm[j] * f(j)).sum() };
    Energy {
        kinetic: 0.5 * own.density * sum(&|j| psi[j] * rise[j]),
        potential: 0.5 * own.density * own.gravity * sum(&|j| eta[j] * eta[j]),
        ..Energy::default()
    }
}

/// Mean power of the motion over a step [W], by Gauss's rule of three points on the cubic of η and the parabola of the motion.
///
/// The stages of a step do not follow a motion that is faster than the step, as its end does.
fn given(
    liquid: &Liquid,
    before: [&[f64]; 2],
    after: [&[f64]; 2],
    ([start, middle, end], step): (&[Motion; 3], f64),
) -> f64 {
    let mut power = 0.0;
    for (s, weight) in [(-0.6_f64.sqrt(), 5.0 / 18.0), (0.0, 4.0 / 9.0), (0.6_f64.sqrt(), 5.0 / 18.0)] {
        let motion =
            Motion::combine([(0.5 * s * (s - 1.0), *start), (1.0 - s * s, *middle), (0.5 * s * (s + 1.0), *end)]);
        let part = 0.5 * (1.0 + s);
        for j in 0..before[0].len() {
            let curve = [before[0][j], step * before[1][j], after[0][j], step * after[1][j]];
            let push = motion.vertical * hermite(curve, part) + liquid.push(j, &motion);
            power -= weight * liquid.basis.norm[j] * push * hermite_slope(curve, part) / step;
        }
    }
    liquid.own.density * power
}

/// Power of damping [W].
fn lost(liquid: &Liquid, state: &[Vec<f64>; 2], rates: &[Vec<f64>; 2]) -> f64 {
    let own = liquid.own;
    let of = |j: usize| liquid.basis.norm[j] * 2.0 * own.damping * liquid.omega[j] * state[1][j] * rates[0][j];
    own.density * (0..state[0].len()).map(of).sum::<f64>()
}

/// Time derivatives of what is known as a function of η and ψ, by differences along their rates.
struct Differences {
    state: [Vec<f64>; 2],
    rates: [Vec<f64>; 2],
    second: Vec<f64>,
    orders: Vec<f64>,
    total: Vec<f64>,
    pushed: Vec<f64>,
}

impl Differences {
    fn new(n: usize) -> Differences {
        Differences {
            state: [vec![0.0; n], vec![0.0; n]],
            rates: [vec![0.0; n], vec![0.0; n]],
            second: vec![0.0; n],
            orders: vec![0.0; n],
            total: vec![0.0; n],
            pushed: vec![0.0; n],
        }
    }

    /// Appends the values of an instant.
    fn push(
        &mut self,
        liquid: &Liquid,
        (eta, psi): (&[f64], &[f64]),
        rates: &[Vec<f64>; 2],
        (felt, carried): (&Motion, &Motion),
        work: &mut Work,
        out: &mut Vec<f64>,
    ) {
        let n = eta.len();
        // Of this part of the fastest period truncation is 1e-7 of the derivative and rounding less. The state itself has been evaluated.
        let small = 1e-7 / liquid.omega.iter().fold(1e-3_f64, |a, &b| a.max(b));
        for j in 0..n {
            self.total[j] = psi[j] + work.orders[0][j] + work.orders[1][j];
            // The rate of ψ with the motion that this instant is to show.
            self.pushed[j] = rates[1][j] + liquid.push(j, felt) + felt.vertical * eta[j]
                - liquid.push(j, carried)
                - carried.vertical * eta[j];
            // Less what they are now.
            self.second[j] = -rates[0][j];
            self.orders[j] = -(work.orders[0][j] + work.orders[1][j]);
            self.state[0][j] = eta[j] + small * rates[0][j];
            self.state[1][j] = psi[j] + small * self.pushed[j];
        }
        let [rise, push] = &mut self.rates;
        liquid.rates((&self.state[0], &self.state[1]), carried, work, (rise, push));
        for j in 0..n {
            self.second[j] = (self.second[j] + rise[j]) / small;
            self.orders[j] = (self.orders[j] + work.orders[0][j] + work.orders[1][j]) / small;
        }
        out.extend_from_slice(eta);
        out.extend_from_slice(&rates[0]);
        out.extend_from_slice(&self.second);
        out.extend_from_slice(&self.total);
        out.extend((0..n).map(|j| self.pushed[j] + self.orders[j]));
        out.extend_from_slice(psi);
    }
}

impl Run {
    /// Number of instants.
    pub fn len(&self) -> usize {
        self.motions.len()
    }

    /// Whether it stopped before its first instant.
    pub fn is_empty(&self) -> bool {
        self.motions.is_empty()
    }

    /// Step [s].
    pub fn step(&self) -> f64 {
        self.step
    }

    /// Time of the last instant [s].
    pub fn end(&self) -> f64 {
        self.step * self.len().saturating_sub(1) as f64
    }

    /// An instant; `index` below [`Run::len`].
    pub fn frame(&self, index: usize) -> Frame<'_> {
        let n = self.modes;
        let part = |kind: usize| &self.values[(index * KINDS + kind) * n..(index * KINDS + kind + 1) * n];
        Frame {
            time: index as f64 * self.step,
            motion: self.motions[index],
            elevation: part(0),
            rate: part(1),
            second: part(2),
            potential: part(3),
            potential_rate: part(4),
            surface: part(5),
        }
    }

    /// All instants.
    pub fn frames(&self) -> impl Iterator<Item = Frame<'_>> {
        (0..self.len()).map(|i| self.frame(i))
    }

    /// Elevation at a place and each instant [m].
    pub fn wave(&self, liquid: &Liquid, place: Place) -> Vec<f64> {
        let values = liquid.values(place);
        self.frames().map(|f| product(&values, f.elevation)).collect()
    }

    /// Elevation at a place and a time by the cubic of the instants before and after it [m]; the ends beyond them.
    pub fn wave_at(&self, values: &[f64], time: f64) -> f64 {
        let Some(last) = self.len().checked_sub(1) else { return 0.0 };
        let place = (time / self.step).clamp(0.0, last as f64);
        let first = (place.floor() as usize).min(last.saturating_sub(1));
        let s = place - first as f64;
        let (a, b) = (self.frame(first), self.frame((first + 1).min(last)));
        let [p, v] = [product(values, a.elevation), self.step * product(values, a.rate)];
        let [q, w] = [product(values, b.elevation), self.step * product(values, b.rate)];
        hermite([p, v, q, w], s)
    }

    /// Highest and lowest elevation at a place, each with its time [s] and [m].
    pub fn extremes(&self, liquid: &Liquid, place: Place) -> [(f64, f64); 2] {
        let values = liquid.values(place);
        let mut out = [(0.0, 0.0); 2];
        for i in 1..self.len() {
            let (a, b) = (self.frame(i - 1), self.frame(i));
            let curve = [
                product(&values, a.elevation),
                self.step * product(&values, a.rate),
                product(&values, b.elevation),
                self.step * product(&values, b.rate),
            ];
            for part in 1..=8 {
                let s = f64::from(part) / 8.0;
                let wave = hermite(curve, s);
                let time = a.time + s * self.step;
                if wave > out[0].1 {
                    out[0] = (time, wave);
                }
                if wave < out[1].1 {
                    out[1] = (time, wave);
                }
            }
        }
        out
    }

    /// Largest rest of the energies over the largest of kinetic and potential energy.
    pub fn energy_error(&self) -> f64 {
        let largest = self.energies.iter().fold(0.0_f64, |a, e| a.max(e.kinetic + e.potential));
        let rest = self.energies.iter().fold(0.0_f64, |a, e| a.max(e.rest().abs()));
        if largest > 0.0 { rest / largest } else { 0.0 }
    }
}

impl Liquid {
    /// Values of all modes at a place.
    pub fn values(&self, place: Place) -> Vec<f64> {
        (0..self.basis.modes().len()).map(|j| self.basis.at(j, place)[0]).collect()
    }
}

/// Cubic between two values and their slopes, at the part s of the step.
fn hermite([p, v, q, w]: [f64; 4], s: f64) -> f64 {
    let (s2, s3) = (s * s, s * s * s);
    (2.0 * s3 - 3.0 * s2 + 1.0) * p + (s3 - 2.0 * s2 + s) * v + (3.0 * s2 - 2.0 * s3) * q + (s3 - s2) * w
}

/// Its derivative by s.
fn hermite_slope([p, v, q, w]: [f64; 4], s: f64) -> f64 {
    let s2 = s * s;
    6.0 * (s2 - s) * p + (3.0 * s2 - 4.0 * s + 1.0) * v + 6.0 * (s - s2) * q + (3.0 * s2 - 2.0 * s) * w
}

pub(super) fn product(a: &[f64], b: &[f64]) -> f64 {
    a.iter().zip(b).map(|(a, b)| a * b).sum()
}
