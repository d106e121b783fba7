//! Ground motions of the verification tests, made by formula: no record needs to be at hand.

use oscillator::record::Record;

/// A record from its accelerations [m/s²].
pub(crate) fn record(dt: f64, acceleration: Vec<f64>) -> Record {
    Record { name: "made by formula".into(), dt, acceleration, processing: Vec::new() }
}

/// Broad-band motion of peak about 0.3 g: 120 sines from 0.15 to 20 Hz with scattered phases under a strong-motion
/// envelope, `duration` [s] long. Deterministic.
pub(crate) fn broad_band(dt: f64, duration: f64) -> Record {
    let mut seed = 12345_u64;
    let mut random = || {
        // Knuth's MMIX generator, upper bits.
        seed = seed.wrapping_mul(6364136223846793005).wrapping_add(1442695040888963407);
        (seed >> 11) as f64 / (1_u64 << 53) as f64
    };
    let waves: Vec<(f64, f64, f64)> = (0..120)
        .map(|i| {
            let f: f64 = 0.15 * (20.0_f64 / 0.15).powf((f64::from(i) + random()) / 120.0);
            // Kanai-Tajimi shape about 2.5 Hz.
            let r = f / 2.5;
            let shape = ((1.0 + r * r) / ((1.0 - r * r).powi(2) + 1.44 * r * r)).sqrt();
            (std::f64::consts::TAU * f, 0.28 * shape * f.sqrt(), std::f64::consts::TAU * random())
        })
        .collect();
    let samples = (duration / dt) as usize;
    let acceleration = (0..=samples).map(|k| {
        let t = k as f64 * dt;
        let envelope = (t / 2.0).min(1.0) * (-0.25 * (t - 6.0).max(0.0)).exp();
        envelope * waves.iter().map(|(w, a, p)| a * (w * t + p).sin()).sum::<f64>() / 2.0
    });
    record(dt, acceleration.collect())
}

/// Harmonic ground displacement u₀ sin Ωt that swells over `swell` [s]; its acceleration is the exact second derivative.
pub(crate) fn swelling_harmonic(dt: f64, duration: f64, amplitude: f64, omega: f64, swell: f64) -> Record {
    let samples = (duration / dt) as usize;
    let acceleration = (0..=samples).map(|k| {
        let t = k as f64 * dt;
        // e(t) = sin²(πt/2s) for t < s, and its derivatives.
        let w = std::f64::consts::PI / swell;
        let (e, e1, e2) = if t < swell {
            (0.5 * (1.0 - (w * t).cos()), 0.5 * w * (w * t).sin(), 0.5 * w * w * (w * t).cos())
        } else {
            (1.0, 0.0, 0.0)
        };
        let (s, c) = (omega * t).sin_cos();
        amplitude * (e2 * s + 2.0 * e1 * omega * c - e * omega * omega * s)
    });
    record(dt, acceleration.collect())
}

/// Acceleration that rises to `level` [m/s²] so slowly, with a smooth start and end over `rise` [s], that everything
/// follows statically; it stays there for `rest` [s] and falls as slowly.
pub(crate) fn slow_pulse(dt: f64, level: f64, rise: f64, rest: f64) -> Record {
    let samples = ((2.0 * rise + rest) / dt) as usize;
    let acceleration = (0..=samples).map(|k| {
        let t = k as f64 * dt;
        let s = (t / rise).min((2.0 * rise + rest - t) / rise).clamp(0.0, 1.0);
        // Fifth-order smooth step: first and second derivative vanish at both ends.
        level * s * s * s * (10.0 - 15.0 * s + 6.0 * s * s)
    });
    record(dt, acceleration.collect())
}
