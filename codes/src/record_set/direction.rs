//! The maximum of an oscillator's response over all horizontal directions.
//!
//! ```text
//! max over θ and t of |u_x(t) cos θ + u_y(t) sin θ| = max over t of √(u_x² + u_y²)
//! ```

use std::f64::consts::TAU;

use oscillator::record::Record;
use oscillator::sdof;

/// Points a period. The peak of a sine of p points a period through three of them is right to (2π/p)⁴/384: 2e-6 for 40, 3e-5 for the
/// 20 that a motion of half the oscillator's period has.
const POINTS: f64 = 40.0;

/// Pseudo-accelerations [m/s²] of two components together, at periods > 0 [s].
pub(super) fn maxima(along: &Record, across: &Record, periods: &[f64], damping: f64) -> Vec<f64> {
    let duration = along.duration().max(across.duration());
    periods
        .iter()
        .map(|&period| {
            let omega = TAU / period;
            let parts = (POINTS * along.dt / period).ceil().max(1.0);
            let h = along.dt / parts;
            // Half a period of free vibration after the motion holds its largest swing.
            let count = ((duration + 0.5 * period) / h).ceil() as usize + 1;
            let response = |record: &Record| response(record, h, count, omega, damping);
            let (x, y) = (response(along), response(across));
            let both: Vec<f64> = x.iter().zip(&y).map(|(x, y)| x.hypot(*y)).collect();
            omega * omega * peak(&both)
        })
        .collect()
}

/// Largest value ≥ 0 of a history: of the parabolas through each local maximum and its neighbours.
fn peak(values: &[f64]) -> f64 {
    let samples = values.iter().fold(0.0_f64, |m, &v| m.max(v));
    values.windows(3).fold(samples, |m, three| {
        let (before, after) = (three[0] - three[1], three[2] - three[1]);
        let curvature = before + after;
        if before > 0.0 || after > 0.0 || curvature == 0.0 {
            return m;
        }
        m.max(three[1] - (after - before).powi(2) / (8.0 * curvature))
    })
}

/// Displacements at `count` points h apart [m]: under the record, then in free vibration from its last sample.
fn response(record: &Record, h: f64, count: usize, omega: f64, damping: f64) -> Vec<f64> {
    let within = (record.duration() / h).round() as usize + 1;
    let ground: Vec<f64> = (0..within).map(|k| at(record, k as f64 * h)).collect();
    let driven = sdof::exact(&ground, h, omega, damping);
    let mut u = driven.u;
    if let (Some(&u0), Some(&v0)) = (u.last(), driven.v.last()) {
        let (decay, omega_d) = (damping * omega, omega * (1.0 - damping * damping).sqrt());
        let free = (1..).map(|k| {
            let t = f64::from(k) * h;
            let (sin, cos) = (omega_d * t).sin_cos();
            (-decay * t).exp() * (u0 * cos + (v0 + decay * u0) / omega_d * sin)
        });
        u.extend(free.take(count.saturating_sub(within)));
    }
    u
}

/// Acceleration at a time from 0 to the last sample, linear between samples.
fn at(record: &Record, time: f64) -> f64 {
    let place = time / record.dt;
    let Some(last) = record.acceleration.len().checked_sub(1) else { return 0.0 };
    let before = (place.floor() as usize).min(last);
    let (a, b) = (record.acceleration[before], record.acceleration[(before + 1).min(last)]);
    a + (b - a) * (place - before as f64).min(1.0)
}
