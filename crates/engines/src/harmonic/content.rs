//! Frequency content of a record.
//!
//! ```text
//! ∫ a² dt = Σ |A_j|²/N · Δt        A_j: discrete Fourier transform of the samples, padded with zeros      (Parseval)
//! ```

use std::f64::consts::PI;

use oscillator::record::Record;

/// Frequency below which the given share of a record's energy ∫ a² dt lies [Hz]; 0 of a record of zeros.
///
/// * `share`: from 0 to 1
///
/// Check: a sine of 1 Hz and one of 10 Hz with a fifth of its amplitude have 1/1.04 of the energy at 1 Hz: shares below 0.9615 end there.
pub(super) fn frequency_of_share(record: &Record, share: f64) -> f64 {
    let size = record.acceleration.len().next_power_of_two().max(2);
    let mut values: Vec<(f64, f64)> = record.acceleration.iter().map(|&a| (a, 0.0)).collect();
    values.resize(size, (0.0, 0.0));
    transform(&mut values);
    // A real record: the upper half mirrors the lower one.
    let energy = |j: usize| {
        let twin = if j == 0 || j == size / 2 { 1.0 } else { 2.0 };
        twin * (values[j].0.powi(2) + values[j].1.powi(2))
    };
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

/// Discrete Fourier transform in place, of a power of two of complex numbers (Cooley & Tukey 1965).
fn transform(values: &mut [(f64, f64)]) {
    let size = values.len();
    let mut j = 0;
    for i in 1..size {
        let mut bit = size / 2;
        while j & bit != 0 {
            j ^= bit;
            bit /= 2;
        }
        j |= bit;
        if i < j {
            values.swap(i, j);
        }
    }
    let mut half = 1;
    while half < size {
        let turns: Vec<(f64, f64)> = (0..half)
            .map(|k| {
                let (sin, cos) = (-PI * k as f64 / half as f64).sin_cos();
                (cos, sin)
            })
            .collect();
        for block in values.chunks_exact_mut(2 * half) {
            let (low, high) = block.split_at_mut(half);
            for ((a, b), w) in low.iter_mut().zip(high).zip(&turns) {
                let turned = (b.0 * w.0 - b.1 * w.1, b.0 * w.1 + b.1 * w.0);
                *b = (a.0 - turned.0, a.1 - turned.1);
                *a = (a.0 + turned.0, a.1 + turned.1);
            }
        }
        half *= 2;
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn record(dt: f64, acceleration: Vec<f64>) -> Record {
        Record { name: "test".into(), dt, acceleration, processing: Vec::new() }
    }

    /// The transform against its definition, Σ a_n e^(−2πi jn/N): rounding of 16 terms.
    #[test]
    fn transform_is_its_definition() {
        let given: Vec<f64> = (0..16).map(|n| f64::from(n * n % 7) - 2.5).collect();
        let mut found: Vec<(f64, f64)> = given.iter().map(|&a| (a, 0.0)).collect();
        transform(&mut found);
        for (j, value) in found.iter().enumerate() {
            let angle = |n: usize| -2.0 * PI * (j * n) as f64 / 16.0;
            let real: f64 = given.iter().enumerate().map(|(n, a)| a * angle(n).cos()).sum();
            let imaginary: f64 = given.iter().enumerate().map(|(n, a)| a * angle(n).sin()).sum();
            assert!((value.0 - real).abs() < 1e-12 && (value.1 - imaginary).abs() < 1e-12, "{j}");
        }
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
