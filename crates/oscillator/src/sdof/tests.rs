//! Closed forms, and the three methods against each other.

use super::*;
use proptest::prelude::*;

/// e^{M h} of the first-order system of (u, v, p, ṗ), by scaling and squaring of its Taylor series: an independent
/// formulation of the step.
fn by_matrix_exponential(omega: f64, damping: f64, h: f64) -> [[f64; 4]; 4] {
    type M = [[f64; 4]; 4];
    fn mul(x: &M, y: &M) -> M {
        std::array::from_fn(|i| std::array::from_fn(|j| (0..4).map(|k| x[i][k] * y[k][j]).sum()))
    }
    let rate =
        [[0.0, 1.0, 0.0, 0.0], [-omega * omega, -2.0 * damping * omega, 1.0, 0.0], [0.0, 0.0, 0.0, 1.0], [0.0; 4]];
    let norm = (omega * omega + 2.0 * damping * omega + 2.0) * h;
    let squarings = norm.log2().ceil().max(0.0) as i32 + 4;
    let scale = h / 2f64.powi(squarings);
    let scaled: M = rate.map(|row| row.map(|x| x * scale));
    let mut sum: M = std::array::from_fn(|i| std::array::from_fn(|j| f64::from(u8::from(i == j))));
    let mut term = sum;
    for k in 1..20 {
        term = mul(&term, &scaled).map(|row| row.map(|x| x / f64::from(k)));
        for i in 0..4 {
            for j in 0..4 {
                sum[i][j] += term[i][j];
            }
        }
    }
    for _ in 0..squarings {
        sum = mul(&sum, &sum);
    }
    sum
}

/// Compares u₁ and v₁ from unit states and loads; the scale of each coefficient is its largest possible size.
fn step_error(omega: f64, damping: f64, h: f64) -> f64 {
    let r = Recurrence::new(omega, damping, h);
    let m = by_matrix_exponential(omega, damping, h);
    let w = f64::max(omega, 1.0 / h);
    let expected = [
        (r.a, m[0][0], 1.0),
        (r.b, m[0][1], 1.0 / w),
        (r.c, m[0][2] - m[0][3] / h, 1.0 / (w * w)),
        (r.d, m[0][3] / h, 1.0 / (w * w)),
        (r.a_v, m[1][0], w),
        (r.b_v, m[1][1], 1.0),
        (r.c_v, m[1][2] - m[1][3] / h, 1.0 / w),
        (r.d_v, m[1][3] / h, 1.0 / w),
    ];
    expected
        .iter()
        .map(|(got, want, scale)| (got - want).abs() / scale)
        // Unlike `f64::max`, this keeps a NaN.
        .fold(0.0, |m: f64, e| if m.is_nan() || e <= m { m } else { e })
}

#[test]
fn step_equals_the_matrix_exponential() {
    // 1e-12: the exponential itself loses about 2^squarings · 1e-16.
    for damping in [0.0, 1e-4, 0.005, 0.05, 0.5, 0.999_999, 1.0, 1.000_001, 1.18, 1.999, 2.0, 5.0] {
        for h in [1e-5, 1e-3, 0.01, 0.09, 0.11, 0.3, 0.5, 0.99, 1.0, 1.01, 2.0, 6.0] {
            let error = step_error(1.0, damping, h);
            assert!(error < 1e-12, "xi {damping}, omega h {h}: {error:e}");
            let error = step_error(37.0, damping, h / 37.0);
            assert!(error < 1e-12, "omega 37, xi {damping}, omega h {h}: {error:e}");
        }
    }
}

#[test]
fn free_mass_is_integrated_twice() {
    // ω = 0: u₁ = u₀ + h v₀ + h²(p₀/3 + p₁/6), v₁ = v₀ + h (p₀ + p₁)/2.
    let h = 0.02;
    let (u, v) = Recurrence::new(0.0, 0.0, h).step(0.3, -0.7, 2.0, 5.0);
    assert!((u - (0.3 - 0.7 * h + h * h * (2.0 / 3.0 + 5.0 / 6.0))).abs() < 1e-16);
    assert!((v - (-0.7 + h * 3.5)).abs() < 1e-16);
}

/// Closed solution for a_g = sin Ωt from rest.
fn harmonic(omega: f64, damping: f64, frequency: f64, t: f64) -> f64 {
    // u = A sin Ωt + B cos Ωt + e^{−ξωt}(C sin ω_d t + D cos ω_d t)
    let (p, q) = (omega * omega - frequency * frequency, 2.0 * damping * omega * frequency);
    let (a, b) = (-p / (p * p + q * q), q / (p * p + q * q));
    let omega_d = omega * (1.0 - damping * damping).sqrt();
    let d = -b;
    let c = (-frequency * a + damping * omega * d) / omega_d;
    let e = (-damping * omega * t).exp();
    a * (frequency * t).sin() + b * (frequency * t).cos() + e * (c * (omega_d * t).sin() + d * (omega_d * t).cos())
}

fn worst_against_harmonic(history: &History, h: f64) -> (f64, f64) {
    let closed = |k: usize| harmonic(3.0, 0.01, 2.0, k as f64 * h);
    let error = history.u.iter().enumerate().map(|(k, u)| (u - closed(k)).abs()).fold(0.0, f64::max);
    (error, (0..history.u.len()).map(|k| closed(k).abs()).fold(0.0, f64::max))
}

#[test]
fn harmonic_ground_motion() {
    let h = 0.01;
    let ground: Vec<f64> = (0..=6000).map(|k| (2.0 * k as f64 * h).sin()).collect();
    let (error, amplitude) = worst_against_harmonic(&exact(&ground, h, 3.0, 0.01), h);
    // Linear interpolation of sin 2t: the load is short by h²/12 · 4 on average, 3.3e-5 relative, so ≈ 1.0e-5 m.
    assert!((amplitude - 0.3077).abs() < 5e-5, "{amplitude}");
    assert!(error > 0.9e-5 && error < 1.1e-5, "{error:e}");
    let (error, _) = worst_against_harmonic(&newmark(&ground, h, 3.0, 0.01, 1), h);
    assert!(error > 3.6e-4 && error < 4.0e-4, "{error:e}");
}

/// An arbitrary record with kinks.
fn rough_record() -> Vec<f64> {
    let mut seed = 12345u64;
    (0..400)
        .map(|k| {
            seed = seed.wrapping_mul(6364136223846793005).wrapping_add(1442695040888963407);
            let noise = (seed >> 33) as f64 / f64::from(1u32 << 31) - 0.5;
            noise * (k as f64 / 100.0) * (-(k as f64) / 100.0).exp()
        })
        .collect()
}

fn difference(x: &History, y: &History, omega: f64) -> f64 {
    let peak = x.u.iter().fold(0.0, |m: f64, u| m.max(u.abs()));
    let du = x.u.iter().zip(&y.u).map(|(a, b)| (a - b).abs()).fold(0.0, f64::max);
    let dv = x.v.iter().zip(&y.v).map(|(a, b)| (a - b).abs()).fold(0.0, f64::max);
    f64::max(du, dv / omega) / peak
}

#[test]
fn the_three_methods_agree() {
    let ground = rough_record();
    for damping in [0.0, 0.005, 0.05, 0.4] {
        for period in [0.05, 0.3, 2.0, 15.0] {
            let omega = std::f64::consts::TAU / period;
            let reference = exact(&ground, 0.02, omega, damping);
            let integral = duhamel(&ground, 0.02, omega, damping, 64);
            let error = difference(&reference, &integral, omega);
            // Simpson's error is (ωh/n)⁴/2880 of the static response in every part; without damping it may add up.
            let bound = 10.0 * (omega * 0.02 / 64.0).powi(4) / 2880.0 + 1e-11;
            assert!(error < bound, "Duhamel, T {period}, xi {damping}: {error:e} against {bound:e}");
            let n = (omega * 0.02 / 5e-4).ceil().max(100.0);
            let stepped = newmark(&ground, 0.02, omega, damping, n as usize);
            let error = difference(&reference, &stepped, omega);
            // The period error (ωh)²/12 adds up to the phase error ωt (ωh)²/12; added to it are the h²/12 of the
            // load in soft oscillators and the rounding of differences u₁ − u₀, 1e-16/(ωh)².
            let bound = 2.0 * omega * 8.0 * (omega * 0.02 / n).powi(2) / 12.0 + 1e-7;
            assert!(error < bound, "Newmark, T {period}, xi {damping}: {error:e} against {bound:e}");
        }
    }
}

#[test]
fn duhamel_equals_the_convolution_as_written() {
    // The integral of the textbook, recomputed term by term at every t.
    let ground = &rough_record()[..120];
    let (h, omega, damping, n) = (0.02, 17.0, 0.03, 32);
    let omega_d = omega * f64::sqrt(1.0 - damping * damping);
    let history = duhamel(ground, h, omega, damping, n);
    for k in [0, 1, 7, 60, 119] {
        let t = k as f64 * h;
        let integrand = |step: usize, fraction: f64| {
            let a = ground[step] + (ground[step + 1] - ground[step]) * fraction;
            let lag = t - (step as f64 + fraction) * h;
            a * (-damping * omega * lag).exp() * (omega_d * lag).sin()
        };
        let mut sum = 0.0;
        for step in 0..k {
            for j in 0..n {
                let (x0, x1) = (j as f64 / n as f64, (j + 1) as f64 / n as f64);
                sum += (integrand(step, x0) + 4.0 * integrand(step, 0.5 * (x0 + x1)) + integrand(step, x1)) * h
                    / (6 * n) as f64;
            }
        }
        assert!((history.u[k] + sum / omega_d).abs() < 1e-14, "{k}");
    }
}

proptest! {
    #[test]
    fn one_step_is_two_half_steps(
        omega in 0.0f64..400.0, damping in 0.0f64..3.0, h in 1e-4f64..0.1,
        u in -1.0f64..1.0, v in -1.0f64..1.0, p0 in -1.0f64..1.0, p1 in -1.0f64..1.0,
    ) {
        let (u1, v1) = Recurrence::new(omega, damping, h).step(u, v, p0, p1);
        let half = Recurrence::new(omega, damping, h / 2.0);
        let middle = 0.5 * (p0 + p1);
        let (um, vm) = half.step(u, v, p0, middle);
        let (u2, v2) = half.step(um, vm, middle, p1);
        let w = omega.max(1.0);
        prop_assert!((u1 - u2).abs() < 1e-12 && (v1 - v2).abs() < 1e-12 * w, "{u1} {u2}, {v1} {v2}");
    }
}
