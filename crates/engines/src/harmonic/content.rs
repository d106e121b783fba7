//! Frequency content of a record.
//!
//! ```text
//! ∫ a² dt = Σ |A_j|²/N · Δt        A_j: discrete Fourier transform of the samples, padded with zeros      (Parseval)
//! ```

use fourier::Transforms;
use oscillator::record::Record;

/// Frequency below which the given share of a record's energy ∫ a² dt lies [Hz]; 0 of a record of zeros.
///
/// * `share`: from 0 to 1
///
/// Check: a sine of 1 Hz and one of 10 Hz with a fifth of its amplitude have 1/1.04 of the energy at 1 Hz: shares below 0.9615 end there.
pub(super) fn frequency_of_share(record: &Record, share: f64) -> f64 {
    let size = record.acceleration.len().next_power_of_two().max(2);
    let mut values = record.acceleration.clone();
    values.resize(size, 0.0);
    let transform = Transforms::new(size).forward;
    let mut lines = transform.make_output_vec();
    transform.process(&mut values, &mut lines).expect("buffers were made by the plan");
    // A real record: the upper half mirrors the lower one.
    let energy = |j: usize| lines[j].norm_sqr() * if j == 0 || j == size / 2 { 1.0 } else { 2.0 };
    let total: f64 = (0..=size / 2).map(energy).sum();
    if total.is_nan() || total <= 0.0 {
        return 0.0;
    }
    let mut sum = 0.0;
    let last = (0..=size / 2).find(|&j| {
        sum += energy(j);
        sum >= share * total
    });
    last.unwrap_or(size / 2) as f64 / (size as f64 * record.dt)
}

#[cfg(test)]
mod tests {
    use std::f64::consts::PI;

    use super::*;

    fn record(dt: f64, acceleration: Vec<f64>) -> Record {
        Record { name: "test".into(), dt, acceleration, processing: Vec::new() }
    }

    /// 1 Hz with amplitude 1, 10 Hz with 0.2: 1/1.04 of the energy lies at 1 Hz. 40.96 s at 0.01 s are 4096 samples; lines are
    /// 0.024 Hz apart, and leakage of the sines, not periodic in them, moves a few lines.
    #[test]
    fn shares_of_two_sines() {
        let at = |t: f64| (2.0 * PI * t).sin() + 0.2 * (20.0 * PI * t).sin();
        let two = record(0.01, (0..4096).map(|k| at(0.01 * f64::from(k))).collect());
        assert!((frequency_of_share(&two, 0.5) - 1.0).abs() < 0.1);
        assert!((frequency_of_share(&two, 0.94) - 1.0).abs() < 0.2);
        assert!((frequency_of_share(&two, 0.98) - 10.0).abs() < 0.1);
    }

    /// Compressing the time axis raises the content in proportion; a record of zeros has none.
    #[test]
    fn scales_with_time() {
        let values: Vec<f64> = (0..300).map(|k| (0.37 * f64::from(k)).sin() * (0.011 * f64::from(k)).cos()).collect();
        let (slow, fast) = (record(0.02, values.clone()), record(0.01, values));
        assert!((frequency_of_share(&fast, 0.99) / frequency_of_share(&slow, 0.99) - 2.0).abs() < 1e-12);
        assert_eq!(frequency_of_share(&record(0.01, vec![0.0; 20]), 0.99), 0.0);
    }
}
