//! Response spectra of a record.
//!
//! [`ordinates`] and [`spectrum`] run the exact recurrence in a kernel for eight oscillators at a time and find the
//! maxima of the *continuous* response: between samples, and in the free vibration after the end of the record.
//! [`Method`] selects two reference methods.

mod blocks;
mod kernel;
mod lanes;
mod peaks;
mod soft;
mod stiff;

use std::f64::consts::TAU;

use serde::{Deserialize, Serialize};

use crate::record::Record;
use crate::sdof;
use peaks::{Maxima, State};

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
    /// From the largest ω²|u|, ω|u̇| and |ü + a_g|.
    fn from_scaled(omega: f64, maxima: Maxima) -> Ordinates {
        Ordinates {
            sd: maxima.y / (omega * omega),
            psv: maxima.y / omega,
            psa: maxima.y,
            sv: maxima.y1 / omega,
            sa: maxima.a,
        }
    }

    /// No ordinates: an argument was out of its range.
    fn nan() -> Ordinates {
        let nan = f64::NAN;
        Ordinates { sd: nan, psv: nan, psa: nan, sv: nan, sa: nan }
    }

    /// The rigid oscillator, T = 0: it moves with the ground.
    pub fn rigid(pga: f64) -> Ordinates {
        Ordinates { sd: 0.0, psv: 0.0, psa: pga, sv: 0.0, sa: pga }
    }
}

/// How the oscillators of a spectrum are integrated.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Method {
    /// [`sdof::Recurrence`], eight oscillators at a time.
    Exact,
    /// [`sdof::duhamel`], Simpson's rule with at least [`POINTS_PER_PERIOD`] parts a period.
    Duhamel,
    /// [`sdof::newmark`] with at least [`POINTS_PER_PERIOD`] steps a period.
    Newmark,
}

/// Points a period of the two reference methods.
pub const POINTS_PER_PERIOD: f64 = 64.0;

impl Method {
    /// How the ordinates of this method come about, in words for the output.
    pub fn statement(self) -> &'static str {
        match self {
            Method::Exact => {
                "exact for acceleration that is linear between samples; maxima of the continuous response, between \
                 samples and in the free vibration after the end, within 1e-6"
            }
            Method::Duhamel => {
                "Duhamel's integral by Simpson's rule, parts of at most T/64; maxima of the continuous response, between \
                 points and in the free vibration after the end, within 1e-6"
            }
            Method::Newmark => {
                "Newmark's average acceleration, steps of at most T/64, which lengthens periods by up to 0.08 %; maxima \
                 between steps and in the free vibration after the end included"
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
/// Period 0 is the rigid oscillator. Entries are NaN where an argument is out of its range.
pub fn spectrum(record: &Record, periods: &[f64], dampings: &[f64], method: Method) -> Spectrum {
    let pairs: Vec<(f64, f64)> = dampings.iter().flat_map(|&xi| periods.iter().map(move |&t| (t, xi))).collect();
    let entries = match method {
        Method::Exact => exact(record, &pairs),
        _ => pairs.iter().map(|&(t, xi)| by_history(record, t, xi, method)).collect(),
    };
    let row = |i: usize| entries[i * periods.len()..(i + 1) * periods.len()].to_vec();
    Spectrum {
        periods: periods.to_vec(),
        dampings: dampings.to_vec(),
        ordinates: (0..dampings.len()).map(row).collect(),
    }
}

/// Spectral ordinates of `record` at `period` ≥ 0 [s] and damping ratio 0 ≤ `damping` < 1. Period 0 is the rigid
/// oscillator.
///
/// NaN where an argument is out of its range. For many periods [`spectrum`] is several times faster.
pub fn ordinates(record: &Record, period: f64, damping: f64) -> Ordinates {
    exact(record, &[(period, damping)])[0]
}

/// Ordinates at pairs of period and damping ratio, by the kernel.
fn exact(record: &Record, pairs: &[(f64, f64)]) -> Vec<Ordinates> {
    let oscillates = |&(period, damping): &(f64, f64)| admissible(period, damping) && period > 0.0;
    let oscillators: Vec<blocks::Oscillator> = pairs
        .iter()
        .filter(|pair| oscillates(pair))
        .map(|&(period, damping)| blocks::Oscillator { omega: TAU / period, damping })
        .collect();
    let maxima = kernel::maxima(&record.acceleration, record.dt, &oscillators);
    let mut computed = oscillators.iter().zip(maxima);
    let pga = record.pga();
    pairs
        .iter()
        .map(|pair| match oscillates(pair).then(|| computed.next()).flatten() {
            Some((oscillator, maxima)) => Ordinates::from_scaled(oscillator.omega, maxima),
            None if admissible(pair.0, pair.1) => Ordinates::rigid(pga),
            None => Ordinates::nan(),
        })
        .collect()
}

fn admissible(period: f64, damping: f64) -> bool {
    period >= 0.0 && period.is_finite() && (0.0..1.0).contains(&damping)
}

/// Ordinates by one of the reference methods, on the record refined to T/64. The maxima between points are found by
/// [`peaks`], as in the kernel.
fn by_history(record: &Record, period: f64, damping: f64, method: Method) -> Ordinates {
    if !admissible(period, damping) {
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
    let history = match method {
        Method::Newmark => sdof::newmark(&ground, h, omega, damping, 1),
        Method::Duhamel => sdof::duhamel(&ground, h, omega, damping, 1),
        Method::Exact => sdof::exact(&ground, h, omega, damping),
    };
    let phi = omega * h;
    let mut m = Maxima::default();
    for k in 1..ground.len() {
        let sigma = (ground[k - 1] - ground[k]) / phi;
        let state = |k: usize| {
            let (y, y1) = (omega * omega * history.u[k], omega * history.v[k]);
            State::new(y, y1, -ground[k], sigma, damping)
        };
        let (s0, s1) = (state(k - 1), state(k));
        let (x1, x2) = s0.oscillation(-ground[k - 1], sigma, damping);
        m.take_interval(&s0, &s1, phi, x1.abs() + x2.abs(), damping);
    }
    if let (Some(u), Some(v)) = (history.u.last(), history.v.last()) {
        m.take_free_vibration(omega * omega * u, omega * v, damping);
    }
    Ordinates::from_scaled(omega, m)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::sdof::Recurrence;

    fn record(dt: f64, acceleration: Vec<f64>) -> Record {
        Record { name: "test".into(), dt, acceleration, processing: vec![] }
    }

    /// An arbitrary record of noise under an envelope.
    fn noise(dt: f64, samples: usize) -> Record {
        let mut seed = 2024u64;
        let acceleration = (0..samples)
            .map(|k| {
                seed = seed.wrapping_mul(6364136223846793005).wrapping_add(1442695040888963407);
                let x = k as f64 / samples as f64;
                ((seed >> 33) as f64 / f64::from(1u32 << 31) - 0.5) * 20.0 * x * (-6.0 * x).exp()
            })
            .collect();
        record(dt, acceleration)
    }

    /// Maxima over points 2000 to a period and to a step, by the scalar recurrence: slow and obvious.
    fn by_brute_force(record: &Record, period: f64, damping: f64) -> [f64; 3] {
        let omega = TAU / period;
        let parts = (2000.0 * record.dt / period).ceil().max(8.0) as usize;
        let step = Recurrence::new(omega, damping, record.dt / parts as f64);
        let (mut u, mut v, mut m) = (0.0, 0.0, [0.0f64; 3]);
        let silence = (0.55 * period / record.dt).ceil() as usize;
        let mut ground = record.acceleration.clone();
        let end = ground.len();
        ground.extend(std::iter::repeat_n(0.0, silence + 1));
        for k in 0..ground.len() - 1 {
            // The acceleration drops to zero right after the last sample.
            let (a0, a1) = if k + 1 == end { (0.0, 0.0) } else { (ground[k], ground[k + 1]) };
            for j in 0..parts {
                let at = |j: usize| a0 + (a1 - a0) * (j as f64 / parts as f64);
                (u, v) = step.step(u, v, -at(j), -at(j + 1));
                let a = omega * omega * u + 2.0 * damping * omega * v;
                m = [m[0].max(u.abs()), m[1].max(v.abs()), m[2].max(a.abs())];
            }
        }
        m
    }

    /// Steepest slope of the acceleration.
    fn slope(record: &Record) -> f64 {
        record.acceleration.windows(2).fold(0.0, |m: f64, p| m.max((p[1] - p[0]).abs())) / record.dt
    }

    #[test]
    fn maxima_are_those_of_the_continuous_response() {
        // Brute force lies below the maximum by h²/8 |f''| at most, with 2000 points a period and 8 a step; the bound
        // on f'' follows from the equation of motion. The kernel's own error is below 3e-7 R.
        let dampings = [0.0, 0.005, 0.05, 0.3, 0.9];
        for (dt, samples) in [(0.02, 300), (0.005, 1000)] {
            let r = noise(dt, samples);
            let periods = [0.001, 0.004, 0.013, 0.02, 0.031, 0.05, 0.1, 0.15, 0.17, 0.3, 0.5, 0.9, 2.0, 5.0, 20.0];
            let all = spectrum(&r, &periods, &dampings, Method::Exact);
            for (xi, row) in dampings.iter().zip(&all.ordinates) {
                for (t, o) in periods.iter().zip(row) {
                    let slow = by_brute_force(&r, *t, *xi);
                    let (w, c) = (TAU / t, 2.0 * xi * TAU / t);
                    let relative = o.sa + r.pga();
                    let jerk = slope(&r) + c * relative + w * w * o.sv;
                    let h = f64::min(t / 2000.0, dt / 8.0);
                    for (name, fast, slow, curvature) in [
                        ("sd", o.sd, slow[0], relative),
                        ("sv", o.sv, slow[1], jerk),
                        ("sa", o.sa, slow[2], w * w * relative + c * jerk),
                    ] {
                        let error = fast / slow - 1.0;
                        let below = h * h / 8.0 * curvature / slow;
                        let what = format!("{name} dt {dt} T {t} xi {xi}: {fast} {slow} {error:e}");
                        assert!((-1e-6..1e-6 + below).contains(&error), "{what}");
                    }
                }
            }
        }
    }

    #[test]
    fn one_at_a_time_equals_many() {
        let r = noise(0.01, 500);
        let periods: Vec<f64> = (0..37).map(|k| 0.01 * 1.25f64.powi(k)).collect();
        let all = spectrum(&r, &periods, &[0.02, 0.1], Method::Exact);
        for (xi, row) in [0.02, 0.1].iter().zip(&all.ordinates) {
            for (t, o) in periods.iter().zip(row) {
                let single = ordinates(&r, *t, *xi);
                for (a, b) in [(o.sd, single.sd), (o.sv, single.sv), (o.sa, single.sa)] {
                    // Groups differ in the number of parts a step is examined in.
                    assert!((a / b - 1.0).abs() < 1e-6, "T {t} xi {xi}: {o:?} {single:?}");
                }
            }
        }
    }

    #[test]
    fn the_three_methods_agree() {
        // Duhamel differs by Simpson's rule, (2π/64)⁴/2880 = 3e-8 of the static response in every part; Newmark's
        // period is 0.08 % too long, which moves a spectrum of noise by several times that.
        let r = noise(0.02, 600);
        let periods = [0.05, 0.2, 0.7, 2.5, 9.0];
        let exact = spectrum(&r, &periods, &[0.02, 0.2], Method::Exact);
        let duhamel = spectrum(&r, &periods, &[0.02, 0.2], Method::Duhamel);
        let newmark = spectrum(&r, &periods, &[0.02, 0.2], Method::Newmark);
        for i in 0..2 {
            for (k, period) in periods.iter().enumerate() {
                let (e, d, n) = (exact.ordinates[i][k], duhamel.ordinates[i][k], newmark.ordinates[i][k]);
                for (e, d, n) in [(e.sd, d.sd, n.sd), (e.sv, d.sv, n.sv), (e.sa, d.sa, n.sa), (e.psa, d.psa, n.psa)] {
                    assert!(d <= e * (1.0 + 1e-6) && d >= e * (1.0 - 2.5e-3), "T {}: {e} {d}", periods[k]);
                    assert!((n / e - 1.0).abs() < 2e-2, "T {period}: {e} {n}");
                }
            }
        }
    }

    #[test]
    fn harmonic_at_resonance() {
        // a_g = sin ωt with ω = 2π for n periods, no damping: u = (t cos ωt − sin ωt/ω)/(2ω), peak at the end n/(2ω)
        // and at n − 1/2 … ; 1000 samples a period make the load short by (ωh)²/12 = 3e-6.
        let r = record(1e-3, (0..=10_000).map(|k| (TAU * 1e-3 * f64::from(k)).sin()).collect());
        let o = ordinates(&r, 1.0, 0.0);
        // Free vibration continues with u = 10/(2ω), v = 0.
        assert!((o.sd / (10.0 / (2.0 * TAU)) - 1.0).abs() < 1e-5, "{o:?}");
    }

    #[test]
    fn long_periods_tend_to_the_ground_displacement() {
        // A pulse that comes to rest: sine of one period, 2 s; the ground moves to Ω⁻¹ · 2 s and stays. For T → ∞ the
        // oscillator stays where it was, u = −d, and swings back later.
        let r = record(0.01, (0..=200).map(|k| (std::f64::consts::PI * 0.01 * f64::from(k)).sin()).collect());
        let d = r.measures().pgd;
        let o = ordinates(&r, 1e6, 0.0);
        assert!((o.sd / d - 1.0).abs() < 1e-6, "{} {d}", o.sd);
        assert!(o.psa < 1e-9 && o.sv > 0.0);
        assert!((o.sv / r.measures().pgv - 1.0).abs() < 1e-6);
    }

    #[test]
    fn linear_in_the_record() {
        let r = noise(0.01, 400);
        let mut doubled = r.clone();
        doubled.acceleration.iter_mut().for_each(|a| *a *= -2.0);
        for t in [0.02, 0.3, 4.0] {
            let (a, b) = (ordinates(&r, t, 0.05), ordinates(&doubled, t, 0.05));
            assert!((b.sd / a.sd - 2.0).abs() < 1e-12 && (b.sa / a.sa - 2.0).abs() < 1e-12);
        }
    }

    #[test]
    fn short_records() {
        for samples in 0..4 {
            let r = record(0.01, vec![1.0; samples]);
            for t in [0.001, 0.5] {
                let o = ordinates(&r, t, 0.05);
                assert!(o.sd.is_finite() && o.sa.is_finite(), "{samples} {t} {o:?}");
            }
        }
        assert_eq!(ordinates(&record(0.01, vec![0.0; 100]), 0.5, 0.05).sd, 0.0);
    }

    #[test]
    fn limits_of_the_period() {
        let r = record(0.02, vec![0.0, 0.4, -1.1, 0.3, 0.7, -0.2, 0.0]);
        assert_eq!(ordinates(&r, 0.0, 0.05), Ordinates::rigid(1.1));
        // T → 0: the oscillator follows the ground; the kinks excite Δ(slope)/ω³ ω², here 1e-2 relative at 1 ms.
        let stiff = ordinates(&r, 1e-3, 0.05);
        assert!((stiff.sa - 1.1).abs() < 0.02 * 1.1 && (stiff.psa - 1.1).abs() < 0.02 * 1.1, "{stiff:?}");
        assert!(ordinates(&r, -1.0, 0.05).sd.is_nan() && ordinates(&r, f64::NAN, 0.05).sd.is_nan());
    }

    #[test]
    fn step_of_ground_acceleration_doubles() {
        // a_g = 1 for 4.2 s, a whole number of periods, no damping: max |u| = 2/ω², max |u̇| = 1/ω, max |ü + a_g| = 2.
        let r = record(0.01, vec![1.0; 421]);
        for period in [0.012, 0.1, 0.7, 2.1] {
            let omega = TAU / period;
            let o = ordinates(&r, period, 0.0);
            // Interpolation between points at most T/16 apart, see `peaks`.
            let tolerance = 3e-7;
            for (value, exact) in [(o.psa, 2.0), (o.sv * omega, 1.0), (o.sa, 2.0)] {
                assert!((value / exact - 1.0).abs() < tolerance, "T {period}: {o:?}");
            }
        }
    }
}
