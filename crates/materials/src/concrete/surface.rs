//! Drucker-Prager cone in crack axes: F = √J2 + α I1 − k, its normal and curvature.
//!
//! Components n, s, τ of plane stress: J2 = (σ_n² − σ_n σ_s + σ_s²)/3 + τ², I1 = σ_n + σ_s.

use crate::drucker_prager::Cone;

/// √J2 and F [Pa].
#[inline]
pub(super) fn at(cone: &Cone, t: &[f64; 3]) -> (f64, f64) {
    let j2 = (t[0] * t[0] - t[0] * t[1] + t[1] * t[1]) / 3.0 + t[2] * t[2];
    let q = j2.sqrt();
    (q, q + cone.alpha * (t[0] + t[1]) - cone.k)
}

/// n = ∂F/∂σ (the third for engineering shear) and ∂n/∂σ [1/Pa], off the axis.
pub(super) fn normal(cone: &Cone, t: &[f64; 3], q: f64) -> ([f64; 3], [[f64; 3]; 3]) {
    // J2 = ½ σᵀ Q σ
    const Q: [[f64; 3]; 3] = [
        [2.0 / 3.0, -1.0 / 3.0, 0.0],
        [-1.0 / 3.0, 2.0 / 3.0, 0.0],
        [0.0, 0.0, 2.0],
    ];
    let g: [f64; 3] = std::array::from_fn(|i| (Q[i][0] * t[0] + Q[i][1] * t[1] + Q[i][2] * t[2]) / (2.0 * q));
    let mut n = g;
    n[0] += cone.alpha;
    n[1] += cone.alpha;
    let mut h = [[0.0; 3]; 3];
    for i in 0..3 {
        for j in 0..3 {
            h[i][j] = (0.5 * Q[i][j] - g[i] * g[j]) / q;
        }
    }
    (n, h)
}

#[cfg(test)]
mod tests {
    use super::*;

    /// F = 0 at −f_c and at (−f_bc, −f_bc).
    #[test]
    fn calibration() {
        let cone = Cone::of_strengths(35.0, 1.16 * 35.0).unwrap();
        assert!(at(&cone, &[-35.0, 0.0, 0.0]).1.abs() < 1e-12);
        assert!(at(&cone, &[-40.6, -40.6, 0.0]).1.abs() < 1e-12);
    }

    #[test]
    fn normal_is_the_gradient() {
        let cone = Cone::of_strengths(1.0, 1.16).unwrap();
        let t = [-0.7, 0.1, 0.3];
        let (n, h) = normal(&cone, &t, at(&cone, &t).0);
        for i in 0..3 {
            let (mut up, mut down) = (t, t);
            (up[i], down[i]) = (t[i] + 1e-6, t[i] - 1e-6);
            assert!(((at(&cone, &up).1 - at(&cone, &down).1) / 2e-6 - n[i]).abs() < 1e-8);
            let (a, b) = (
                normal(&cone, &up, at(&cone, &up).0).0,
                normal(&cone, &down, at(&cone, &down).0).0,
            );
            assert!((0..3).all(|j| ((a[j] - b[j]) / 2e-6 - h[j][i]).abs() < 1e-8));
        }
    }
}
