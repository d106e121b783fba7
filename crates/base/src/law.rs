//! The base's moment against rotation, bottom pressure and history.
//!
//! ```text
//! M_b = (1 − η) M(ψ, p_b) + η [k_∞ ψ + Σ_i clamp(k_i (ψ − s_i), ±m_i)]          k_i, m_i: M(ψ, 0) as a chain of chords
//! ```
//!
//! A table of the strips; between rotations monotone cubics, between bottom pressures straight lines. The other side is its mirror,
//! M(−ψ, p_b) = −M(ψ, −p_b).
//!
//! The loss of a cycle is that of strips which are lifted and set down twice, second time, around the circumference. Full springs lose
//! L₁ = 8 ∫₀^ψ M dψ − 4 M ψ in a cycle (Masing), so η = L/L₁.

use std::f64::consts::TAU;

use crate::error::BaseError;
use crate::halves::side_by_side;
use crate::march::Lifted;
use crate::model::Base;
use crate::response::Response;
use crate::rocking::{Rocking, Turn};
use crate::warp::WAVES;

/// Rotations of the table.
const ROTATIONS: usize = 40;
/// Bottom pressures of the table over the pressure at rest.
const SUCTIONS: [f64; 5] = [-0.5, -0.25, 0.0, 0.25, 0.5];
/// Springs with friction.
const SPRINGS: usize = 16;
/// Uplifts at which the loss of a strip is measured, over the largest.
const LOSSES: [f64; 4] = [0.1, 0.3, 0.6, 1.0];
/// The same up to the largest rotation of a law.
const MANY: [f64; 7] = [0.05, 0.12, 0.22, 0.35, 0.5, 0.75, 1.0];
/// Steps of a strip on its way up.
const WAY: usize = 24;

/// A spring with friction, against a rotation or against a displacement.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Spring {
    /// Stiffness k_i [N m], [N/m].
    pub stiffness: f64,
    /// Moment [N m] or force [N] at which it slips.
    pub limit: f64,
}

/// Moment against rotation.
#[derive(Clone, Debug)]
pub struct Law {
    rotations: Vec<f64>,
    /// Bottom pressures [Pa], rising.
    suctions: Vec<f64>,
    /// Turns by bottom pressure, then rotation.
    turns: Vec<Vec<Turn>>,
    /// Cubics by bottom pressure, then interval of rotations.
    cubics: Vec<Vec<Cubic>>,
    /// First place that is not below each of [`BINS`] even shares of the largest rotation.
    bins: Vec<usize>,
    initial: f64,
    springs: Vec<Spring>,
    linear: f64,
    /// Whether the foot has waves.
    warps: bool,
}

/// Even parts of the range of rotations in which the search of a place begins.
const BINS: usize = 256;

/// A moment between two rotations: its values and slopes there.
#[derive(Clone, Copy, Debug)]
struct Cubic {
    values: [f64; 2],
    slopes: [f64; 2],
}

impl Cubic {
    /// At a share t of the interval of width h, straight on beyond its end.
    fn at(&self, t: f64, h: f64) -> Response {
        let ([a, b], [first, last]) = (self.values, self.slopes);
        if t > 1.0 {
            return Response { moment: b + last * (t - 1.0) * h, tangent: last };
        }
        let (m, n) = (first * h, last * h);
        let (t2, t3) = (t * t, t * t * t);
        Response {
            moment: a * (1.0 - 3.0 * t2 + 2.0 * t3)
                + b * (3.0 * t2 - 2.0 * t3)
                + m * (t - 2.0 * t2 + t3)
                + n * (t3 - t2),
            tangent: ((b - a) * 6.0 * (t - t2) + m * (1.0 - 4.0 * t + 3.0 * t2) + n * (3.0 * t2 - 2.0 * t)) / h,
        }
    }
}

impl Law {
    /// The law up to a rotation [rad].
    ///
    /// Errors: no equilibrium of the base.
    pub fn new(rocking: &Rocking, largest: f64) -> Result<Law, BaseError> {
        let rotations: Vec<f64> = (0..=ROTATIONS).map(|j| largest * (j as f64 / ROTATIONS as f64).powi(3)).collect();
        let suctions = SUCTIONS.map(|share| share * rocking.pressure()).to_vec();
        let turns = side_by_side(&suctions, |&suction| {
            let mut row: Vec<Turn> = Vec::with_capacity(rotations.len());
            for &psi in &rotations {
                row.push(rocking.near(psi, suction, row.last())?);
            }
            Ok(row)
        })?;
        let slopes: Vec<Vec<f64>> = turns.iter().map(|row| slopes(&rotations, row)).collect();
        let cubics = turns.iter().zip(&slopes).map(|(row, slopes)| {
            let between =
                |j: usize| Cubic { values: [row[j].moment, row[j + 1].moment], slopes: [slopes[j], slopes[j + 1]] };
            (0..ROTATIONS).map(between).collect()
        });
        let bin = |i: usize| rotations.partition_point(|r| *r < largest * (i as f64 / BINS as f64));
        let rest = &turns[SUCTIONS.len() / 2];
        let (springs, linear) = springs(&rotations, rest);
        Ok(Law {
            cubics: cubics.collect(),
            bins: (0..=BINS).map(bin).collect(),
            initial: slopes[SUCTIONS.len() / 2][0],
            rotations,
            suctions,
            turns,
            springs,
            linear,
            warps: rocking.warps(),
        })
    }

    /// Its springs.
    pub fn springs(&self) -> &[Spring] {
        &self.springs
    }

    /// Rotations of its table [rad].
    pub(crate) fn rotations(&self) -> &[f64] {
        &self.rotations
    }

    /// Bottom pressures of its table [Pa].
    pub(crate) fn suctions(&self) -> &[f64] {
        &self.suctions
    }

    /// The base at a bottom pressure and a rotation of its table, by their places.
    pub(crate) fn tabled(&self, suction: usize, rotation: usize) -> &Turn {
        &self.turns[suction][rotation]
    }

    /// Largest rotation of the table [rad].
    pub fn largest(&self) -> f64 {
        self.rotations[ROTATIONS]
    }

    /// dM/dψ before any uplift [N m].
    pub fn initial(&self) -> f64 {
        self.initial
    }

    /// Largest rotation at rest pressure without uplift [rad]: up to it the rim stays on the ground.
    pub fn first_uplift(&self) -> f64 {
        let rest = &self.turns[SUCTIONS.len() / 2];
        let after = rest.partition_point(|t| t.uplift <= 0.0);
        if after == 0 {
            return 0.0;
        }
        let Some(next) = rest.get(after) else { return self.largest() };
        let last = &rest[after - 1];
        let share = -last.uplift / (next.uplift - last.uplift);
        last.rotation + share * (next.rotation - last.rotation)
    }

    pub(crate) fn places(&self, psi: f64, suction: f64) -> (usize, usize, f64) {
        let bin = (psi / self.largest() * BINS as f64).clamp(0.0, BINS as f64) as usize;
        // Rounding may put the bin beyond ψ.
        let from = self.bins[bin.saturating_sub(1)];
        let after = |r: &&f64| **r < psi;
        let j = (from + self.rotations[from..].iter().take_while(after).count()).clamp(1, ROTATIONS);
        let s = suction.clamp(self.suctions[0], self.suctions[SUCTIONS.len() - 1]);
        let below = self.suctions.iter().filter(|v| **v < s).count();
        let k = below.clamp(1, SUCTIONS.len() - 1);
        let share = (s - self.suctions[k - 1]) / (self.suctions[k] - self.suctions[k - 1]);
        (j, k, share)
    }

    /// M(ψ, p_b) and its slope; straight on beyond the table.
    pub(crate) fn curve(&self, psi: f64, suction: f64) -> Response {
        if psi < 0.0 {
            let mirrored = self.curve(-psi, -suction);
            return Response { moment: -mirrored.moment, ..mirrored };
        }
        let (j, k, share) = self.places(psi, suction);
        let h = self.rotations[j] - self.rotations[j - 1];
        let t = (psi - self.rotations[j - 1]) / h;
        let at = |level: usize| self.cubics[level][j - 1].at(t, h);
        let (low, high) = (at(k - 1), at(k));
        Response {
            moment: low.moment + share * (high.moment - low.moment),
            tangent: low.tangent + share * (high.tangent - low.tangent),
        }
    }

    /// M_b and its slope; `slips` are those of the springs.
    pub fn respond(&self, psi: f64, suction: f64, hysteretic: f64, slips: &[f64]) -> Response {
        let curve = self.curve(psi, suction);
        curve.and(self.loops(psi, curve, hysteretic, slips))
    }

    /// What the springs add to M_b and its slope.
    ///
    /// * `curve`: M(ψ, p_b)
    pub(crate) fn loops(&self, psi: f64, curve: Response, hysteretic: f64, slips: &[f64]) -> Response {
        if hysteretic == 0.0 {
            return Response::default();
        }
        let (mut moment, mut tangent) = (self.linear * psi, self.linear);
        for (spring, slip) in self.springs.iter().zip(slips) {
            let trial = spring.stiffness * (psi - slip);
            moment += trial.clamp(-spring.limit, spring.limit);
            if trial.abs() < spring.limit {
                tangent += spring.stiffness;
            }
        }
        Response { moment: hysteretic * (moment - curve.moment), tangent: hysteretic * (tangent - curve.tangent) }
    }

    /// Lets the springs slip to where ψ moves them; returns what they lose, without the factor η [J].
    pub fn commit(&self, psi: f64, slips: &mut [f64]) -> f64 {
        let mut lost = 0.0;
        for (spring, slip) in self.springs.iter().zip(slips) {
            let trial = spring.stiffness * (psi - *slip);
            let over = trial.abs() - spring.limit;
            if over > 0.0 {
                let moved = over / spring.stiffness;
                *slip += moved * trial.signum();
                lost += spring.limit * moved;
            }
        }
        lost
    }

    /// Share of the initial stiffness that a rotation leaves, at rest pressure.
    pub fn contact(&self, psi: f64) -> f64 {
        (self.curve(psi.abs(), 0.0).tangent / self.initial()).clamp(0.0, 1.0)
    }

    /// The base at a rotation and a bottom pressure, linear between the table's places: uplift and toe belong to the sides that ψ
    /// lifts and presses.
    pub fn turn(&self, psi: f64, suction: f64) -> Turn {
        let (psi, suction) = if psi < 0.0 { (-psi, -suction) } else { (psi, suction) };
        let (j, k, share) = self.places(psi, suction);
        let t = (psi - self.rotations[j - 1]) / (self.rotations[j] - self.rotations[j - 1]);
        let mix = |f: &dyn Fn(&Turn) -> f64| {
            let at = |level: usize| {
                let (a, b) = (&self.turns[level][j - 1], &self.turns[level][j]);
                f(a) + t * (f(b) - f(a))
            };
            at(k - 1) + share * (at(k) - at(k - 1))
        };
        Turn {
            rotation: psi,
            moment: mix(&|t| t.moment),
            centre: mix(&|t| t.centre),
            uplift: mix(&|t| t.uplift),
            toe_force: mix(&|t| t.toe_force),
            pull: mix(&|t| t.pull),
            waves: if self.warps { std::array::from_fn(|n| mix(&|t| t.waves[n])) } else { [0.0; WAVES] },
        }
    }

    /// dw₀/d|ψ| of the centre of the foot [m/rad], that of the table's straight lines.
    pub(crate) fn sinks(&self, psi: f64, suction: f64) -> f64 {
        let (psi, suction) = if psi < 0.0 { (-psi, -suction) } else { (psi, suction) };
        let (j, k, share) = self.places(psi, suction);
        let step = self.rotations[j] - self.rotations[j - 1];
        let at = |level: usize| (self.turns[level][j].centre - self.turns[level][j - 1].centre) / step;
        at(k - 1) + share * (at(k) - at(k - 1))
    }

    /// Share η of the moment that is hysteretic, so that a cycle to `psi` loses what the strips lose; 0 of an elastic plate.
    ///
    /// Errors: no equilibrium of a strip.
    pub fn hysteretic(&self, base: &Base, psi: f64) -> Result<f64, BaseError> {
        if psi <= self.first_uplift() {
            return Ok(0.0);
        }
        let losses = Losses::up_to(base, self.turn(psi, 0.0).uplift, &LOSSES)?;
        Ok(self.share(base, &losses, psi))
    }

    /// What strips lose up to the largest rotation, for [`Law::share`] of many rotations.
    ///
    /// Errors: no equilibrium of a strip.
    pub fn losses(&self, base: &Base) -> Result<Losses, BaseError> {
        Losses::up_to(base, self.turn(self.largest(), 0.0).uplift, &MANY)
    }

    /// [`Law::hysteretic`] with losses that are known.
    pub fn share(&self, base: &Base, losses: &Losses, psi: f64) -> f64 {
        if !base.yields() || psi <= self.first_uplift() {
            return 0.0;
        }
        let turn = self.turn(psi, 0.0);
        let n = 180;
        let lost: f64 = (0..n)
            .map(|i| {
                // Every place is lifted by one of the two turns.
                losses.at(turn.rim(base.radius, TAU / 4.0 * (f64::from(i) + 0.5) / f64::from(n)))
            })
            .sum::<f64>()
            * TAU
            * base.radius
            / f64::from(n);
        let work = self.work(psi);
        let full = 8.0 * work - 4.0 * self.curve(psi, 0.0).moment * psi;
        if full > 0.0 { (lost / full).clamp(0.0, 1.0) } else { 0.0 }
    }

    /// ∫₀^ψ M dψ at rest pressure [J].
    pub fn work(&self, psi: f64) -> f64 {
        let n = 400;
        let h = psi / f64::from(n);
        (0..n).map(|i| self.curve(h * (f64::from(i) + 0.5), 0.0).moment * h).sum()
    }
}

/// Loss of the second cycle of a strip between rest and uplifts [J/m], by uplift [m].
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Losses(Vec<(f64, f64)>);

impl Losses {
    /// Up to an uplift [m], at shares of it; none of a plate that does not yield.
    fn up_to(base: &Base, largest: f64, shares: &[f64]) -> Result<Losses, BaseError> {
        if base.yields() { losses(base, largest, shares).map(Losses) } else { Ok(Losses::default()) }
    }

    fn at(&self, uplift: f64) -> f64 {
        loss_at(&self.0, uplift)
    }
}

fn losses(base: &Base, largest: f64, shares: &[f64]) -> Result<Vec<(f64, f64)>, BaseError> {
    let strip = base.strip(base.pressure)?;
    let rest = Lifted::at_rest(&strip, base.weight)?;
    let low = rest.uplift();
    let lifted: Vec<f64> = shares.iter().map(|share| share * largest).collect();
    let cycles = side_by_side(&lifted, |&high| {
        if high <= low.max(0.0) {
            return Ok(None);
        }
        let mut state = rest.clone();
        let mut loss = 0.0;
        for _ in 0..2 {
            loss = 0.0;
            for (from, to) in [(low, high), (high, low)] {
                let mut before = state.point().hold_down;
                for i in 1..=WAY {
                    let w = from + (to - from) * i as f64 / WAY as f64;
                    state.lift_to(w)?;
                    let force = state.point().hold_down;
                    loss += 0.5 * (before + force) * (to - from) / WAY as f64;
                    before = force;
                }
            }
        }
        Ok(Some((high, loss.max(0.0))))
    })?;
    let cycles = cycles.into_iter().flatten();
    Ok([(0.0, 0.0)].into_iter().chain(cycles).collect())
}

fn loss_at(losses: &[(f64, f64)], uplift: f64) -> f64 {
    let after = losses.partition_point(|l| l.0 < uplift);
    match (after.checked_sub(1).map(|i| losses[i]), losses.get(after)) {
        (Some((w0, l0)), Some((w1, l1))) => l0 + (l1 - l0) * (uplift - w0) / (w1 - w0),
        (Some((_, last)), None) => last,
        _ => 0.0,
    }
}

fn springs(rotations: &[f64], rest: &[Turn]) -> (Vec<Spring>, f64) {
    // Chords between every few places of the table.
    let stride = ROTATIONS / SPRINGS;
    let nodes: Vec<usize> = (0..=ROTATIONS).filter(|j| j % stride == 0 && *j > 0).collect();
    let mut chords: Vec<(f64, f64)> = Vec::new();
    let mut last = 0;
    for j in nodes {
        let slope = (rest[j].moment - rest[last].moment) / (rotations[j] - rotations[last]);
        chords.push((rotations[j], slope));
        last = j;
    }
    // Rising slopes have no spring: the curve is concave but for the stiffening of the membrane.
    for i in 1..chords.len() {
        chords[i].1 = chords[i].1.min(chords[i - 1].1);
    }
    let springs = chords
        .windows(2)
        .filter(|c| c[0].1 > c[1].1)
        .map(|c| Spring { stiffness: c[0].1 - c[1].1, limit: (c[0].1 - c[1].1) * c[0].0 })
        .collect();
    (springs, chords.last().map_or(0.0, |c| c.1))
}

/// Slopes of monotone cubics (Fritsch & Butland 1984).
fn slopes(rotations: &[f64], row: &[Turn]) -> Vec<f64> {
    let secants: Vec<(f64, f64)> = (1..row.len())
        .map(|j| {
            let h = rotations[j] - rotations[j - 1];
            (h, (row[j].moment - row[j - 1].moment) / h)
        })
        .collect();
    let mut slopes = vec![secants[0].1];
    slopes.extend(secants.windows(2).map(|s| {
        let ((h, a), (k, b)) = (s[0], s[1]);
        if a * b <= 0.0 { 0.0 } else { 3.0 * (h + k) / ((2.0 * k + h) / a + (k + 2.0 * h) / b) }
    }));
    slopes.push(secants[secants.len() - 1].1);
    slopes
}

#[cfg(test)]
mod tests;
