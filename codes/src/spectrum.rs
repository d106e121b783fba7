//! Response and design spectra.

use std::f64::consts::TAU;

use serde::{Deserialize, Serialize};

use crate::record::Record;
use crate::sdof::{self, History, Recurrence};

/// Maxima of one oscillator's response to a record.
///
/// `sd`, `sv`, `sa` are maxima of the continuous response, free vibration after the end of the record included; the
/// pseudo-values follow from `sd`:
///
/// ```text
/// PSV = ω S_d      PSA = ω² S_d      ω = 2π/T
/// ```
#[derive(Clone, Copy, Debug, Default, PartialEq, Serialize, Deserialize)]
pub struct Ordinates {
    /// Spectral displacement S_d = max |u|, relative to the ground [m].
    pub sd: f64,
    /// Pseudo-velocity ω S_d [m/s]; called "spectral velocity" in older texts.
    pub psv: f64,
    /// Pseudo-acceleration ω² S_d [m/s²].
    pub psa: f64,
    /// Relative velocity S_v = max |u̇| [m/s].
    pub sv: f64,
    /// Absolute acceleration S_a = max |ü + a_g| [m/s²].
    pub sa: f64,
}

impl Ordinates {
    /// No ordinates: an argument was out of its range.
    fn nan() -> Ordinates {
        let nan = f64::NAN;
        Ordinates {
            sd: nan,
            psv: nan,
            psa: nan,
            sv: nan,
            sa: nan,
        }
    }

    /// The rigid oscillator, T = 0: it moves with the ground.
    pub fn rigid(pga: f64) -> Ordinates {
        Ordinates {
            sd: 0.0,
            psv: 0.0,
            psa: pga,
            sv: 0.0,
            sa: pga,
        }
    }
}

/// How the oscillators of a spectrum are integrated.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Method {
    /// [`sdof::Recurrence`], maxima of the continuous response.
    Exact,
    /// [`sdof::duhamel`] with at least [`POINTS_PER_PERIOD`] Simpson points a period, maxima at these points.
    Duhamel,
    /// [`sdof::newmark`] with at least [`POINTS_PER_PERIOD`] steps a period, maxima at these points.
    Newmark,
}

/// Points a period of the two reference methods. A maximum lies at most (2π/64)²/8 = 0.12 % above the largest point.
pub const POINTS_PER_PERIOD: f64 = 64.0;

impl Method {
    /// How the maxima of this method are found, in words for the output.
    pub fn statement(self) -> &'static str {
        match self {
            Method::Exact => {
                "exact recurrence; maxima of the continuous response (between samples and in the free vibration after \
                 the end), within 1e-6"
            }
            Method::Duhamel => {
                "Duhamel integral, Simpson's rule; maxima over points at most T/64 apart, one period of free vibration \
                 included: up to 0.12 % below those of the continuous response"
            }
            Method::Newmark => {
                "Newmark's average acceleration with steps of at most T/64; maxima over these steps, one period of \
                 free vibration included: up to 0.12 % below those of the continuous response, period 0.08 % too long"
            }
        }
    }
}

/// Spectral ordinates over periods and damping ratios.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Spectrum {
    /// Periods [s], as asked for.
    pub periods: Vec<f64>,
    /// Damping ratios, as asked for.
    pub dampings: Vec<f64>,
    /// One row a damping ratio, one entry a period.
    pub ordinates: Vec<Vec<Ordinates>>,
}

/// Response spectra of `record` for all `periods` ≥ 0 [s] and damping ratios 0 ≤ ξ < 1.
///
/// Entries are NaN where an argument is out of its range.
pub fn spectrum(record: &Record, periods: &[f64], dampings: &[f64], method: Method) -> Spectrum {
    let entry = |period: f64, damping: f64| match method {
        Method::Exact => ordinates(record, period, damping),
        _ => by_history(record, period, damping, method),
    };
    Spectrum {
        periods: periods.to_vec(),
        dampings: dampings.to_vec(),
        ordinates: dampings
            .iter()
            .map(|&xi| periods.iter().map(|&t| entry(t, xi)).collect())
            .collect(),
    }
}

/// Ordinates by one of the reference methods: the record is refined to T/64, one period of silence added.
fn by_history(record: &Record, period: f64, damping: f64, method: Method) -> Ordinates {
    if !(period >= 0.0 && period.is_finite() && (0.0..1.0).contains(&damping)) {
        return Ordinates::nan();
    }
    if period == 0.0 {
        return Ordinates::rigid(record.pga());
    }
    let parts = (POINTS_PER_PERIOD * record.dt / period).ceil().max(1.0) as usize;
    let h = record.dt / parts as f64;
    let mut ground = Vec::with_capacity(record.acceleration.len() * parts);
    for pair in record.acceleration.windows(2) {
        ground.extend((0..parts).map(|j| pair[0] + (pair[1] - pair[0]) * (j as f64 / parts as f64)));
    }
    ground.extend(record.acceleration.last());
    let omega = TAU / period;
    let respond = |ground: &[f64]| match method {
        Method::Newmark => sdof::newmark(ground, h, omega, damping, 1),
        Method::Duhamel => sdof::duhamel(ground, h, omega, damping, 1),
        Method::Exact => sdof::exact(ground, h, omega, damping),
    };
    let history = respond(&ground);
    let free = free_vibration(&history, omega, damping, period / POINTS_PER_PERIOD);
    let mut o = Ordinates::default();
    for (&u, &v) in history.u.iter().zip(&history.v).chain(free.u.iter().zip(&free.v)) {
        o.sd = o.sd.max(u.abs());
        o.sv = o.sv.max(v.abs());
        o.sa = o.sa.max((omega * omega * u + 2.0 * damping * omega * v).abs());
    }
    (o.psv, o.psa) = (omega * o.sd, omega * omega * o.sd);
    o
}

/// One period of free vibration from the last state of a history.
fn free_vibration(history: &History, omega: f64, damping: f64, h: f64) -> History {
    let step = Recurrence::new(omega, damping, h);
    let (mut u, mut v) = (
        history.u.last().copied().unwrap_or(0.0),
        history.v.last().copied().unwrap_or(0.0),
    );
    let mut free = History::default();
    for _ in 0..POINTS_PER_PERIOD as usize {
        (u, v) = step.step(u, v, 0.0, 0.0);
        free.u.push(u);
        free.v.push(v);
    }
    free
}

/// Spectral ordinates of `record` at `period` ≥ 0 [s] and `damping` ratio ≥ 0. Period 0 is the rigid oscillator.
///
/// NaN where an argument is negative or not finite.
pub fn ordinates(record: &Record, period: f64, damping: f64) -> Ordinates {
    if !(period >= 0.0 && period.is_finite() && damping >= 0.0 && damping.is_finite()) {
        return Ordinates::nan();
    }
    if period == 0.0 {
        return Ordinates::rigid(record.pga());
    }
    let omega = TAU / period;
    let sub_steps = (64.0 * record.dt / period).ceil().max(1.0) as usize;
    let step = Recurrence::new(omega, damping, record.dt / sub_steps as f64);
    let (mut u, mut v) = (0.0, 0.0);
    let (mut sd, mut sv) = (0.0f64, 0.0f64);
    let mut sa = 0.0f64;
    let mut advance = |a0: f64, a1: f64| {
        for j in 0..sub_steps {
            let at = |j: usize| a0 + (a1 - a0) * (j as f64 / sub_steps as f64);
            (u, v) = step.step(u, v, -at(j), -at(j + 1));
            (sd, sv) = (sd.max(u.abs()), sv.max(v.abs()));
            sa = sa.max((omega * omega * u + 2.0 * damping * omega * v).abs());
        }
    };
    for pair in record.acceleration.windows(2) {
        advance(pair[0], pair[1]);
    }
    for _ in 0..(period / record.dt).ceil() as usize {
        advance(0.0, 0.0);
    }
    Ordinates {
        sd,
        psv: omega * sd,
        psa: omega * omega * sd,
        sv,
        sa,
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn record(dt: f64, acceleration: Vec<f64>) -> Record {
        Record {
            name: "test".into(),
            dt,
            acceleration,
            processing: vec![],
        }
    }

    #[test]
    fn limits_of_the_period() {
        let r = record(0.02, vec![0.0, 0.4, -1.1, 0.3, 0.7, -0.2, 0.0]);
        assert_eq!(ordinates(&r, 0.0, 0.05), Ordinates::rigid(1.1));
        // T → 0: the oscillator follows the ground; the kinks excite Δ(slope)/ω³ ω², here 1e-2 relative at 1 ms.
        let stiff = ordinates(&r, 1e-3, 0.05);
        assert!(
            (stiff.sa - 1.1).abs() < 0.02 * 1.1 && (stiff.psa - 1.1).abs() < 0.02 * 1.1,
            "{stiff:?}"
        );
        assert!(ordinates(&r, -1.0, 0.05).sd.is_nan() && ordinates(&r, f64::NAN, 0.05).sd.is_nan());
    }

    #[test]
    fn step_of_ground_acceleration_doubles() {
        // a_g = 1 for 4.2 s, a whole number of periods, no damping: max |u| = 2/ω², max |u̇| = 1/ω, max |ü + a_g| = 2.
        let r = record(0.01, vec![1.0; 421]);
        for period in [0.012, 0.1, 0.7, 2.1] {
            let omega = TAU / period;
            let o = ordinates(&r, period, 0.0);
            // Samples 64 to a period, or the record's own: (ωh)²/8 below the peak at most.
            let h = f64::min(0.01, period / 64.0);
            let tolerance = (omega * h).powi(2) / 8.0 + 1e-12;
            for (value, exact) in [(o.psa, 2.0), (o.sv * omega, 1.0), (o.sa, 2.0)] {
                assert!(
                    value <= exact * (1.0 + 1e-12) && value > exact * (1.0 - 1.5 * tolerance),
                    "T {period}: {o:?}"
                );
            }
        }
    }
}
