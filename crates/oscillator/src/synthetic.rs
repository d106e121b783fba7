//! Synthetic accelerograms whose response spectrum follows a target (Gasparini & Vanmarcke 1976).
//!
//! ```text
//! a(t) = I(t) Σ A_k cos(2π f_k t + φ_k)        φ_k uniform; f_k = k Δf
//! A_k ← A_k · S_target(1/f_k)/S(1/f_k)          repeated; S is the response spectrum of a
//! I(t)  0 to 1 within the rise, 1 during the strong part, then falling as a cosine
//! ```
//!
//! After each step a straight line is subtracted from a, so that velocity and displacement of the ground end at zero. EN 1998-1:2004
//! 3.2.3.1.2(3) asks for a strong part of at least 10 s.

use std::f64::consts::{PI, TAU};

use crate::record::Record;
use crate::spectrum::{Method, spectrum};

/// What a synthetic record is to be.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Wanted {
    /// Duration [s].
    pub duration: f64,
    /// Duration of the strong part [s].
    pub strong: f64,
    /// Time step [s].
    pub dt: f64,
    /// Damping ratio of the target.
    pub damping: f64,
    /// Longest period that follows the target [s].
    pub longest: f64,
    /// Corrections of the amplitudes.
    pub steps: usize,
}

/// Rise before the strong part over what is left of the duration.
const RISE: f64 = 0.2;
/// Shortest period that follows the target, in time steps: shorter ones are not resolved.
const SHORTEST: f64 = 3.0;
/// Samples after which a recurrence restarts.
const BLOCK: usize = 64;
/// Largest correction of an amplitude in a step.
const CORRECTION: f64 = 3.0;

impl Wanted {
    fn envelope(&self, t: f64) -> f64 {
        let rest = self.duration - self.strong;
        let (rise, end) = (RISE * rest, RISE * rest + self.strong);
        if t < rise {
            (t / rise).powi(2)
        } else if t <= end {
            1.0
        } else {
            0.5 * (1.0 + (PI * (t - end) / (self.duration - end)).cos())
        }
    }
}

/// A record whose spectrum follows `target` [m/s²] over the period [s].
///
/// * `draw`: random numbers from 0 to 1, one for the phase of each cosine
///
/// `None` for durations, steps or targets that are not positive.
pub fn synthetic(
    name: &str,
    wanted: &Wanted,
    target: impl Fn(f64) -> f64,
    mut draw: impl FnMut() -> f64,
) -> Option<Record> {
    let positive = [wanted.duration, wanted.strong, wanted.dt, wanted.longest];
    if positive.iter().any(|v| !(*v > 0.0 && v.is_finite())) || wanted.strong >= wanted.duration {
        return None;
    }
    let count = (wanted.duration / wanted.dt).round() as usize + 1;
    let df = 1.0 / wanted.duration;
    let highest = 1.0 / (SHORTEST * wanted.dt);
    let lowest = 1.0 / wanted.longest;
    let frequencies: Vec<f64> =
        (1..).map(|k| f64::from(k) * df).skip_while(|f| *f < 0.999 * lowest).take_while(|f| *f <= highest).collect();
    let phases: Vec<f64> = frequencies.iter().map(|_| TAU * draw()).collect();
    let periods: Vec<f64> = frequencies.iter().map(|f| 1.0 / f).collect();
    let goal: Vec<f64> = periods.iter().map(|&t| target(t)).collect();
    if goal.iter().any(|g| !(*g > 0.0 && g.is_finite())) {
        return None;
    }
    // White noise of amplitude A per line has a response of about A √(π f/(4 ξ Δf)); the steps correct the rest.
    let mut amplitudes: Vec<f64> =
        frequencies.iter().zip(&goal).map(|(f, g)| g / (PI * f / (4.0 * wanted.damping * df)).sqrt() * 0.5).collect();
    let mut record = Record { name: name.into(), dt: wanted.dt, acceleration: Vec::new(), processing: Vec::new() };
    for step in 0..=wanted.steps {
        record.acceleration = sum(&frequencies, &amplitudes, &phases, wanted, count);
        balance(&mut record.acceleration);
        if step == wanted.steps {
            break;
        }
        let found = spectrum(&record, &periods, &[wanted.damping], Method::Exact);
        for ((amplitude, goal), found) in amplitudes.iter_mut().zip(&goal).zip(&found.ordinates[0]) {
            *amplitude *= (goal / found.psa).clamp(1.0 / CORRECTION, CORRECTION);
        }
    }
    Some(record)
}

/// I(t) Σ A cos(2π f t + φ), each cosine by a recurrence that restarts every [`BLOCK`] samples to limit rounding.
fn sum(frequencies: &[f64], amplitudes: &[f64], phases: &[f64], wanted: &Wanted, count: usize) -> Vec<f64> {
    let mut values = vec![0.0; count];
    for ((f, a), phase) in frequencies.iter().zip(amplitudes).zip(phases) {
        let turn = (TAU * f * wanted.dt).sin_cos();
        for (block, part) in values.chunks_mut(BLOCK).enumerate() {
            let start = (TAU * f * wanted.dt * (block * BLOCK) as f64 + phase).sin_cos();
            let (mut s, mut c) = start;
            for value in part {
                *value += a * c;
                (s, c) = (s * turn.1 + c * turn.0, c * turn.1 - s * turn.0);
            }
        }
    }
    for (k, value) in values.iter_mut().enumerate() {
        *value *= wanted.envelope(k as f64 * wanted.dt);
    }
    values
}

/// Subtracts the straight line with which velocity and displacement end at zero, by the rule of [`Record::motion`].
fn balance(values: &mut [f64]) {
    let ends = |of: &dyn Fn(usize) -> f64| {
        let (mut v, mut d) = (0.0, 0.0);
        for k in 1..values.len() {
            let (a0, a1) = (of(k - 1), of(k));
            d += v + (2.0 * a0 + a1) / 6.0;
            v += 0.5 * (a0 + a1);
        }
        [v, d]
    };
    let last = (values.len().max(2) - 1) as f64;
    let of_record = ends(&|k| values[k]);
    let (constant, slope) = (ends(&|_| 1.0), ends(&|k| k as f64 / last));
    let determinant = constant[0] * slope[1] - constant[1] * slope[0];
    let (c, s) = (
        (of_record[0] * slope[1] - of_record[1] * slope[0]) / determinant,
        (constant[0] * of_record[1] - constant[1] * of_record[0]) / determinant,
    );
    for (k, value) in values.iter_mut().enumerate() {
        *value -= c + s * k as f64 / last;
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    const WANTED: Wanted = Wanted { duration: 25.0, strong: 12.0, dt: 0.01, damping: 0.05, longest: 5.0, steps: 12 };

    /// Fractional parts of k² times the golden ratio, which fill 0 to 1 evenly (Weyl 1916); k starts at the seed.
    fn phases(seed: u32) -> impl FnMut() -> f64 {
        let mut k = f64::from(seed) * 977.0;
        move || {
            k += 1.0;
            (k * k * 0.618_033_988_749_894_9).fract()
        }
    }

    /// Plateau and falling branches of an elastic spectrum of EN 1998-1.
    fn target(t: f64) -> f64 {
        match t {
            t if t < 0.15 => 3.0 * (1.0 + 1.5 * t / 0.15),
            t if t < 0.5 => 7.5,
            t if t < 2.0 => 7.5 * 0.5 / t,
            t => 7.5 / (t * t),
        }
    }

    /// One record scatters around its target; the mean of seven stays within 10 % of it from 0.05 s to 4 s, what EN 1998-1 asks of a set.
    #[test]
    fn the_mean_of_seven_follows_the_target() {
        let set: Vec<Record> = (0..7).map(|seed| synthetic("s", &WANTED, target, phases(seed)).unwrap()).collect();
        let periods: Vec<f64> = (0..80).map(|i| 0.05 * 80.0_f64.powf(f64::from(i) / 79.0)).collect();
        for (i, &t) in periods.iter().enumerate() {
            let of = |r: &Record| spectrum(r, &periods, &[0.05], Method::Exact).ordinates[0][i].psa;
            let mean = set.iter().map(of).sum::<f64>() / 7.0;
            assert!((mean / target(t) - 1.0).abs() < 0.10, "{t}: {mean} {}", target(t));
        }
    }

    #[test]
    fn the_ground_comes_to_rest_and_a_seed_is_a_record() {
        let one = synthetic("s", &WANTED, target, phases(7)).unwrap();
        let measures = one.measures();
        assert!(measures.final_velocity.abs() < 1e-9 * measures.pgv);
        assert!(measures.final_displacement.abs() < 1e-9 * measures.pgd);
        assert_eq!(one, synthetic("s", &WANTED, target, phases(7)).unwrap());
        let other = synthetic("s", &WANTED, target, phases(8)).unwrap();
        assert_ne!(one.acceleration, other.acceleration);
    }

    #[test]
    fn what_is_not_positive_is_refused() {
        assert!(synthetic("s", &Wanted { dt: 0.0, ..WANTED }, target, phases(1)).is_none());
        assert!(synthetic("s", &Wanted { strong: 30.0, ..WANTED }, target, phases(1)).is_none());
        assert!(synthetic("s", &WANTED, |_| f64::NAN, phases(1)).is_none());
    }
}
