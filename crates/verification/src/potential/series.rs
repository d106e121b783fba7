//! Closed forms of the liquid in a rigid cylinder: frequencies, masses, and the effect of sectors.

use std::f64::consts::PI;

use super::rigid::GRAVITY;

/// ω of the rigid cylinder: ω² = g λ/R tanh(λ H/R).
pub(super) fn sloshing(lambda: f64, radius: f64, depth: f64) -> f64 {
    (GRAVITY * lambda / radius * (lambda * depth / radius).tanh()).sqrt()
}

/// Convective mass over liquid mass, m = 1: 2 tanh(a)/(a (λ² − 1)), a = λ H/R.
pub(super) fn convective(lambda: f64, radius: f64, depth: f64) -> f64 {
    let a = lambda * depth / radius;
    2.0 * a.tanh() / (a * (lambda * lambda - 1.0))
}

/// First zeros of J_m', m = 1; the third and later ones matter for the impulsive mass only.
pub(super) const LAMBDA_1: [f64; 3] = [1.841_183_781_340_659, 5.331_442_773_525_033, 8.536_316_366_346_286];

/// m_i/m = 1 − Σ m_c,n, the zeros of J_1' by McMahon's expansion refined by Newton steps on the series.
pub(super) fn impulsive_share(radius: f64, depth: f64) -> f64 {
    // Terms fall as λ⁻³: 400 of them leave 10⁻⁶ of the sum's tail, λ_n ≈ (n + 1/4)π.
    let mut sum = 0.0;
    for n in 1..=400 {
        let lambda = match n {
            1..=3 => LAMBDA_1[n - 1],
            // McMahon: β = (n − 3/4)π … for J_1': β − 7/(8β), next term 10⁻⁴ at n = 4.
            _ => {
                let beta = (n as f64 - 0.25) * PI;
                beta - 7.0 / (8.0 * beta)
            }
        };
        sum += convective(lambda, radius, depth);
    }
    1.0 - sum
}

/// λ of harmonic m as a mesh of `sectors` linear elements sees it: J_ν'(λ) = 0 with
/// ν² = [2(1 − cos mΔ)/Δ²]/[(2 + cos mΔ)/3], Δ = 2π/sectors.
pub(super) fn sector_lambda(harmonic: f64, sectors: f64) -> f64 {
    let delta = 2.0 * PI / sectors;
    let c = (harmonic * delta).cos();
    let nu = (2.0 * (1.0 - c) / (delta * delta) / ((2.0 + c) / 3.0)).sqrt();
    // x J_ν'(x) Γ(ν+1) (2/x)^ν = Σ (ν + 2k) t_k, t_k = −t_{k−1} (x/2)²/(k (ν + k))
    let slope = |x: f64| {
        let (mut t, mut sum) = (1.0, nu);
        for k in 1..40 {
            let k = f64::from(k);
            t *= -0.25 * x * x / (k * (nu + k));
            sum += (nu + 2.0 * k) * t;
        }
        sum
    };
    let (mut low, mut high) = (nu, nu + 2.0);
    for _ in 0..60 {
        let middle = 0.5 * (low + high);
        if slope(middle) > 0.0 { low = middle } else { high = middle }
    }
    0.5 * (low + high)
}
