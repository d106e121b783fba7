//! Shares of the nodes of a half circle in what is spread over the circumference: hats on ascending angles.

/// ∫ cos θ N_k dθ of the hats on ascending angles.
pub(super) fn cosine_shares(angles: &[f64]) -> Vec<f64> {
    let mut out = vec![0.0; angles.len()];
    for (i, ends) in angles.windows(2).enumerate() {
        let (a, b) = (ends[0], ends[1]);
        // ∫ cos θ (θ − a)/(b − a) dθ and the rest.
        let rising = b.sin() + (b.cos() - a.cos()) / (b - a);
        let all = b.sin() - a.sin();
        out[i] += all - rising;
        out[i + 1] += rising;
    }
    out
}

/// Lengths of the hats themselves [rad].
pub(super) fn shares(angles: &[f64]) -> Vec<f64> {
    let mut out = vec![0.0; angles.len()];
    for (i, ends) in angles.windows(2).enumerate() {
        out[i] += 0.5 * (ends[1] - ends[0]);
        out[i + 1] += 0.5 * (ends[1] - ends[0]);
    }
    out
}

#[cfg(test)]
mod tests {
    use std::f64::consts::PI;

    use super::*;

    #[test]
    fn shares_add_up() {
        let angles: Vec<f64> = (0..=9).map(|k| PI * (f64::from(k) / 9.0).powf(1.3)).collect();
        let cosine = cosine_shares(&angles);
        assert!(cosine.iter().sum::<f64>().abs() < 1e-12);
        let second: f64 = cosine.iter().zip(&angles).map(|(c, a)| c * a.cos()).sum();
        // ∫ cos² = π/2, by hats.
        assert!((second / (0.5 * PI) - 1.0).abs() < 0.02, "{second}");
        assert!((shares(&angles).iter().sum::<f64>() - PI).abs() < 1e-12);
    }
}
