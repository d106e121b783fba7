//! Names of the modes of a round wall: circumferential and axial wave number.
//!
//! The radial displacement w(θ_s, z_l) of a mode is turned into its Fourier amplitudes level by level,
//!
//! ```text
//! c_n(z) = (2 − δ_n0)/N Σ_s w(θ_s, z) e^{−i n θ_s}                      n = 0 … N/2
//! ```
//!
//! The circumferential wave number is the n with the largest ∫ |c_n|² dz. The axial wave number counts half waves: one
//! more than the sign changes of the amplitude in its own phase, ignoring values smaller than a fifth of the largest.

use std::f64::consts::TAU;

/// Wave numbers of a mode.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Waves {
    /// Circumferential wave number n.
    pub circumferential: u32,
    /// Axial half waves.
    pub axial: u32,
    /// Share of ∫ w² dA that the wave number n holds.
    pub share: f64,
}

/// Amplitudes smaller than this part of the largest do not count as a wave.
const SMALL: f64 = 0.2;

/// Wave numbers of `radial[level][sector]` at ascending heights `z`; `None` if all are zero.
pub(super) fn classify(radial: &[Vec<f64>], z: &[f64]) -> Option<Waves> {
    let sectors = radial.first()?.len();
    let lengths: Vec<f64> =
        (0..z.len()).map(|l| 0.5 * (z[(l + 1).min(z.len() - 1)] - z[l.saturating_sub(1)])).collect();
    let amplitude = |level: &[f64], n: usize| -> (f64, f64) {
        let factor = if n == 0 || 2 * n == sectors { 1.0 } else { 2.0 } / sectors as f64;
        let (mut c, mut s) = (0.0, 0.0);
        for (k, w) in level.iter().enumerate() {
            let (sine, cosine) = (TAU * ((n * k) % sectors) as f64 / sectors as f64).sin_cos();
            c += w * cosine;
            s += w * sine;
        }
        (factor * c, factor * s)
    };
    let (mut best, mut total) = (None::<(f64, usize, Vec<_>)>, 0.0);
    for n in 0..=sectors / 2 {
        let line: Vec<(f64, f64)> = radial.iter().map(|level| amplitude(level, n)).collect();
        let mean = if n == 0 { 1.0 } else { 0.5 };
        let energy: f64 = line.iter().zip(&lengths).map(|((c, s), h)| mean * (c * c + s * s) * h).sum();
        total += energy;
        if energy > 0.0 && best.as_ref().is_none_or(|b| energy > b.0) {
            best = Some((energy, n, line));
        }
    }
    let (energy, n, line) = best?;
    let peak = line.iter().copied().fold((0.0, 0.0), |m, v| if v.0.hypot(v.1) > f64::hypot(m.0, m.1) { v } else { m });
    let norm = peak.0.hypot(peak.1);
    let phase = (peak.0 / norm, peak.1 / norm);
    let (mut changes, mut last) = (0, 0.0_f64);
    for (c, s) in &line {
        let value = c * phase.0 + s * phase.1;
        if value.abs() < SMALL * norm {
            continue;
        }
        changes += u32::from(last != 0.0 && value.signum() != last.signum());
        last = value;
    }
    Some(Waves { circumferential: n as u32, axial: changes + 1, share: energy / total })
}

#[cfg(test)]
mod tests {
    use super::*;

    fn field(n: f64, axial: impl Fn(f64) -> f64, phase: f64) -> (Vec<Vec<f64>>, Vec<f64>) {
        let z: Vec<f64> = (0..=40).map(|l| (f64::from(l) / 40.0).powf(1.3)).collect();
        let radial = z
            .iter()
            .map(|&z| (0..24).map(|s| axial(z) * (n * TAU * f64::from(s) / 24.0 + phase).cos()).collect())
            .collect();
        (radial, z)
    }

    #[test]
    fn waves_are_counted() {
        for n in 0..=12_u32 {
            for m in 1..=4_u32 {
                let half_waves = |z: f64| (f64::from(m) * std::f64::consts::PI * z).sin();
                let (radial, z) = field(f64::from(n), half_waves, if n == 0 || n == 12 { 0.0 } else { 0.7 });
                let found = classify(&radial, &z).unwrap();
                assert_eq!((found.circumferential, found.axial), (n, m));
                assert!((found.share - 1.0).abs() < 1e-12);
            }
        }
        // A cantilever's second mode has two half waves though the lower one is the smaller.
        let (radial, z) = field(3.0, |z| z * z * (z - 0.75) * 6.0, 0.0);
        assert_eq!(classify(&radial, &z).unwrap().axial, 2);
    }

    #[test]
    fn mixtures_and_rest() {
        let (mut radial, z) = field(2.0, |z| z, 0.3);
        let (other, _) = field(5.0, |z| 0.5 * z, 0.0);
        for (a, b) in radial.iter_mut().flatten().zip(other.iter().flatten()) {
            *a += b;
        }
        let found = classify(&radial, &z).unwrap();
        assert_eq!(found.circumferential, 2);
        assert!((found.share - 0.8).abs() < 1e-12);
        assert_eq!(classify(&vec![vec![0.0; 8]; 3], &[0.0, 0.5, 1.0]), None);
        assert_eq!(classify(&[], &[]), None);
    }
}
