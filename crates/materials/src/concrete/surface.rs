//! Surface of plastic compression in crack axes: F, its normal and curvature. Components n, s, τ of plane stress.
//!
//! ```text
//! cone     F = √J2 + α I1 − k                             J2 = (σ_n² − σ_n σ_s + σ_s²)/3 + τ² ,  I1 = σ_n + σ_s
//! Kupfer   F = √(R² + δ²) − g(P)                          R = (σ_1 − σ_2)/2 ,  P = −(σ_1 + σ_2)/2
//!          g = (4 β P − 4 P²/f_c)/(4 β − 2)               P ≥ f_c/2
//!          g = f_c/2 + (P − f_c/2) (4 β − 4)/(4 β − 2)    P < f_c/2: its tangent
//! ```
//!
//! The parabola is the curve of Kupfer & Gerstle, σ_2 = f_c (1 + m r)/(1 + r)² with r = σ_1/σ_2 and m = 4 β − 1, written in P and R
//! (they print m = 3.65, β = 1.1625); β = f_bc/f_c. It ends in uniaxial compression; the tangent keeps tension inside, where cracks
//! come first. At σ_1 = σ_2 the curve has a corner, which δ = f_c/100 rounds: f_bc is then 0.5 % short. g is concave and R convex, so
//! that F is convex and associated flow dissipates.
//!
//! Source: Kupfer & Gerstle 1973, eq. of the biaxial envelope; Drucker & Prager 1952.

use crate::drucker_prager::Cone;

/// δ/f_c.
const ROUNDING: f64 = 0.01;

/// The surface.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) enum Surface {
    /// Drucker and Prager's cone.
    Cone(Cone),
    /// Kupfer and Gerstle's envelope: f_c [Pa] and β.
    Kupfer([f64; 2]),
}

impl Surface {
    /// A strength to compare with [Pa].
    #[inline]
    pub(super) fn scale(&self) -> f64 {
        match self {
            Surface::Cone(cone) => cone.k,
            Surface::Kupfer([f_c, _]) => 0.5 * f_c,
        }
    }

    /// √J2 or √(R² + δ²), and F [Pa].
    #[inline]
    pub(super) fn at(&self, t: &[f64; 3]) -> (f64, f64) {
        match *self {
            Surface::Cone(cone) => {
                let j2 = (t[0] * t[0] - t[0] * t[1] + t[1] * t[1]) / 3.0 + t[2] * t[2];
                let q = j2.sqrt();
                (q, q + cone.alpha * (t[0] + t[1]) - cone.k)
            }
            Surface::Kupfer([f_c, beta]) => {
                let (half, delta) = (0.5 * (t[0] - t[1]), ROUNDING * f_c);
                let q = (half * half + t[2] * t[2] + delta * delta).sqrt();
                (q, q - limit(f_c, beta, -0.5 * (t[0] + t[1])).0)
            }
        }
    }

    /// n = ∂F/∂σ (the third for engineering shear) and ∂n/∂σ [1/Pa], off the axis of the cone.
    pub(super) fn normal(&self, t: &[f64; 3], q: f64) -> ([f64; 3], [[f64; 3]; 3]) {
        // q² = σᵀ Q σ (+ δ²)
        const CONE: [[f64; 3]; 3] = [[1.0 / 3.0, -1.0 / 6.0, 0.0], [-1.0 / 6.0, 1.0 / 3.0, 0.0], [0.0, 0.0, 1.0]];
        const KUPFER: [[f64; 3]; 3] = [[0.25, -0.25, 0.0], [-0.25, 0.25, 0.0], [0.0, 0.0, 1.0]];
        let (form, push, bend) = match *self {
            Surface::Cone(cone) => (CONE, cone.alpha, 0.0),
            Surface::Kupfer([f_c, beta]) => {
                let (_, slope, curvature) = limit(f_c, beta, -0.5 * (t[0] + t[1]));
                (KUPFER, 0.5 * slope, -0.25 * curvature)
            }
        };
        let g: [f64; 3] = std::array::from_fn(|i| (form[i][0] * t[0] + form[i][1] * t[1] + form[i][2] * t[2]) / q);
        let mut n = g;
        n[0] += push;
        n[1] += push;
        let mut h = [[0.0; 3]; 3];
        for i in 0..3 {
            for j in 0..3 {
                h[i][j] = (form[i][j] - g[i] * g[j]) / q + if i < 2 && j < 2 { bend } else { 0.0 };
            }
        }
        (n, h)
    }

    /// Energy dissipated by a flow λ n at the stress σ, both in the axes: σ : n λ; k λ on the cone, since F + k is homogeneous.
    pub(super) fn dissipation(&self, stress: &[f64; 3], flow: &[f64; 3], multiplier: f64) -> f64 {
        match self {
            Surface::Cone(cone) => cone.k * multiplier,
            Surface::Kupfer(_) => (0..3).map(|i| stress[i] * flow[i]).sum(),
        }
    }

    /// Plastic strain through the thickness: the trace of n is 3 α on the cone; none on an envelope of plane stress, which leaves it open.
    pub(super) fn through_thickness(&self, flow: &[f64; 3], multiplier: f64) -> f64 {
        match self {
            Surface::Cone(cone) => 3.0 * cone.alpha * multiplier - flow[0] - flow[1],
            Surface::Kupfer(_) => 0.0,
        }
    }
}

/// g, g′ and g″ at P.
#[inline]
fn limit(f_c: f64, beta: f64, p: f64) -> (f64, f64, f64) {
    let under = 4.0 * beta - 2.0;
    let x = p - 0.5 * f_c;
    let slope = (4.0 * beta - 4.0) / under;
    if x <= 0.0 {
        return (0.5 * f_c + slope * x, slope, 0.0);
    }
    let bend = 8.0 / (f_c * under);
    (0.5 * f_c + slope * x - 0.5 * bend * x * x, slope - bend * x, -bend)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn surfaces() -> [Surface; 2] {
        [Surface::Cone(Cone::of_strengths(1.0, 1.16).unwrap()), Surface::Kupfer([1.0, 1.1625])]
    }

    /// F = 0 at −f_c and at (−f_bc, −f_bc).
    #[test]
    fn calibration() {
        let cone = Surface::Cone(Cone::of_strengths(35.0, 1.16 * 35.0).unwrap());
        assert!(cone.at(&[-35.0, 0.0, 0.0]).1.abs() < 1e-12);
        assert!(cone.at(&[-40.6, -40.6, 0.0]).1.abs() < 1e-12);
    }

    /// On the curve of Kupfer and Gerstle F is the rounding √(R² + δ²) − R alone.
    #[test]
    fn envelope_of_kupfer_and_gerstle() {
        let surface = surfaces()[1];
        for i in 0..=20 {
            let r = f64::from(i) / 20.0;
            let f = (1.0 + 3.65 * r) / (1.0 + r).powi(2);
            let half = 0.5 * f * (1.0 - r);
            let rounding = (half * half + 1e-4).sqrt() - half;
            let (_, found) = surface.at(&[-f, -r * f, 0.0]);
            assert!((found - rounding).abs() < 1e-12, "{r}: {found} {rounding}");
        }
    }

    #[test]
    fn normal_is_the_gradient() {
        for surface in surfaces() {
            for t in [[-0.7, 0.1, 0.3], [-0.9, -0.6, 0.2]] {
                let (n, h) = surface.normal(&t, surface.at(&t).0);
                for i in 0..3 {
                    let (mut up, mut down) = (t, t);
                    (up[i], down[i]) = (t[i] + 1e-6, t[i] - 1e-6);
                    assert!(((surface.at(&up).1 - surface.at(&down).1) / 2e-6 - n[i]).abs() < 1e-8);
                    let (a, b) =
                        (surface.normal(&up, surface.at(&up).0).0, surface.normal(&down, surface.at(&down).0).0);
                    assert!((0..3).all(|j| ((a[j] - b[j]) / 2e-6 - h[j][i]).abs() < 1e-8));
                }
            }
        }
    }
}
