//! Maxima of the continuous response within a step.
//!
//! Everything is scaled by the frequency: φ = ωt, and
//!
//! ```text
//! y = ω² u     y' = ω u̇     y'' = ü     A = y + 2ξ y'  (absolute acceleration)     y'' + 2ξ y' + y = p
//! ```
//!
//! with p linear in a step, so that y is a line plus a decaying oscillation. The oscillation has the amplitude
//!
//! ```text
//! R² = x₁² + x₂²,   x₁ = y − p + 2ξ σ,   x₂ = (y' − σ + ξ x₁)/√(1 − ξ²),   σ = dp/dφ
//! ```
//!
//! at the start of the step, and R bounds every derivative of the oscillation with respect to φ, in y as in y' and A.
//!
//! # How a maximum between two points is found
//!
//! A quantity f ∈ {y, y', A} is known at the ends of an interval Δφ with two derivatives. It exceeds the larger end by
//! at most
//!
//! ```text
//! (Δφ²/8) max|f''| ≤ (Δφ²/8) (max(|f₀''|, |f₁''|) + (Δφ²/8) R)
//! ```
//!
//! (error of linear interpolation, applied to f and to f''). Only where this could exceed the largest value so far, the
//! extrema of the cubic through (f, f') at both ends are located, and the quintic through (f, f', f'') is evaluated
//! there. With Δφ ≤ 2π/16 its error is Δφ⁶/46080 R = 8e-8 R; the place is wrong by at most 0.008 Δφ³ = 5e-4, which
//! changes the value, flat there, by 1.2e-7 R.

use super::kernel::{LANES, Lanes, any, lanes, larger};

/// Scaled state of the lanes at one time.
#[derive(Clone, Copy)]
pub struct State {
    pub y: Lanes,
    pub y1: Lanes,
    /// y''.
    pub y2: Lanes,
    /// y'''.
    pub y3: Lanes,
}

/// Largest |y|, |y'| and |A| so far.
#[derive(Clone, Copy)]
pub struct Maxima {
    pub y: Lanes,
    pub y1: Lanes,
    pub a: Lanes,
}

impl State {
    /// Completes y and y' under the load `p` with the slope `sigma` = dp/dφ.
    #[inline(always)]
    pub fn new(y: Lanes, y1: Lanes, p: &Lanes, sigma: &Lanes, two_xi: &Lanes) -> State {
        let y2 = lanes(|i| p[i] - y[i] - two_xi[i] * y1[i]);
        let y3 = lanes(|i| sigma[i] - y1[i] - two_xi[i] * y2[i]);
        State { y, y1, y2, y3 }
    }

    /// A and its first two derivatives.
    #[inline(always)]
    fn absolute(&self, two_xi: &Lanes) -> [Lanes; 3] {
        [
            lanes(|i| self.y[i] + two_xi[i] * self.y1[i]),
            lanes(|i| self.y1[i] + two_xi[i] * self.y2[i]),
            lanes(|i| self.y2[i] + two_xi[i] * self.y3[i]),
        ]
    }
}

impl Maxima {
    pub const NONE: Maxima = Maxima {
        y: [0.0; LANES],
        y1: [0.0; LANES],
        a: [0.0; LANES],
    };

    /// Takes the values at one time.
    #[inline(always)]
    pub fn take(&mut self, y: &Lanes, y1: &Lanes, two_xi: &Lanes) {
        self.y = lanes(|i| larger(self.y[i], y[i].abs()));
        self.y1 = lanes(|i| larger(self.y1[i], y1[i].abs()));
        self.a = lanes(|i| larger(self.a[i], (y[i] + two_xi[i] * y1[i]).abs()));
    }

    /// Takes the end `s1` of an interval of length `phi` = Δφ ≤ 2π/16 and what lies between; `r` bounds R.
    #[inline(always)]
    pub fn take_interval(&mut self, s0: &State, s1: &State, phi: &Lanes, r: &Lanes, two_xi: &Lanes) {
        self.take(&s1.y, &s1.y1, two_xi);
        between(&mut self.y, [&s0.y, &s0.y1, &s0.y2], [&s1.y, &s1.y1, &s1.y2], phi, r);
        between(&mut self.y1, [&s0.y1, &s0.y2, &s0.y3], [&s1.y1, &s1.y2, &s1.y3], phi, r);
        let (a0, a1) = (s0.absolute(two_xi), s1.absolute(two_xi));
        between(&mut self.a, a0.each_ref(), a1.each_ref(), phi, r);
    }

    /// Takes the free vibration from the state y, y' on.
    ///
    /// e^{−ξφ} (α cos κφ + β sin κφ), κ = √(1 − ξ²), has its first extremum where tan κφ = f'/(ακ + ξβ) in (0, π]; all
    /// later ones are smaller.
    pub fn take_free_vibration(&mut self, y: &Lanes, y1: &Lanes, xi: &Lanes) {
        for i in 0..LANES {
            let (xi, kappa) = (xi[i], ((1.0 - xi[i]) * (1.0 + xi[i])).sqrt());
            let peak = |f: f64, slope: f64| {
                let beta = (slope + xi * f) / kappa;
                let angle = slope.atan2(f * kappa + xi * beta).rem_euclid(std::f64::consts::PI);
                let (sin, cos) = angle.sin_cos();
                ((-xi * angle / kappa).exp() * (f * cos + beta * sin)).abs()
            };
            let y2 = -y[i] - 2.0 * xi * y1[i];
            let y3 = -y1[i] - 2.0 * xi * y2;
            self.y[i] = larger(self.y[i], peak(y[i], y1[i]));
            self.y1[i] = larger(self.y1[i], peak(y1[i], y2));
            self.a[i] = larger(self.a[i], peak(-y2, -y3));
        }
    }
}

/// Raises `m` to the maximum of |f| between two points, each given with f, f', f''.
#[inline(always)]
fn between(m: &mut Lanes, f0: [&Lanes; 3], f1: [&Lanes; 3], phi: &Lanes, r: &Lanes) {
    let bound = lanes(|i| {
        let e = phi[i] * phi[i] / 8.0;
        larger(f0[0][i].abs(), f1[0][i].abs()) + e * (larger(f0[2][i].abs(), f1[2][i].abs()) + e * r[i])
    });
    if any(|i| bound[i] > m[i]) {
        for i in 0..LANES {
            if bound[i] > m[i] {
                let at = |f: [&Lanes; 3]| [f[0][i], f[1][i] * phi[i], f[2][i] * phi[i] * phi[i]];
                m[i] = larger(m[i], extremum(at(f0), at(f1)));
            }
        }
    }
}

/// Largest |f| at the extrema inside (0, 1), from f, f', f'' at 0 and 1; 0 if there is none.
fn extremum([f0, d0, c0]: [f64; 3], [f1, d1, c1]: [f64; 3]) -> f64 {
    // Derivative of the cubic: d₀ + 2 b x + 3 c x².
    let rise = f1 - f0;
    let b = 3.0 * rise - 2.0 * d0 - d1;
    let c = d0 + d1 - 2.0 * rise;
    let root = b * b - 3.0 * c * d0;
    if root < 0.0 {
        return 0.0;
    }
    let q = -(b + root.sqrt().copysign(b));
    let mut m = 0.0;
    for x in [d0 / q, q / (3.0 * c)] {
        if x > 0.0 && x < 1.0 {
            let x2 = x * x;
            let x3 = x2 * x;
            let h3 = x3 * (10.0 + x * (-15.0 + 6.0 * x));
            let h1 = x + x3 * (-6.0 + x * (8.0 - 3.0 * x));
            let h4 = x3 * (-4.0 + x * (7.0 - 3.0 * x));
            let h2 = 0.5 * x2 * (1.0 + x * (-3.0 + x * (3.0 - x)));
            let h5 = 0.5 * x3 * (1.0 + x * (-2.0 + x));
            m = larger(m, (f0 + h3 * rise + h1 * d0 + h4 * d1 + h2 * c0 + h5 * c1).abs());
        }
    }
    m
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn extremum_of_a_sine() {
        // Intervals of 2π/16 at all phases: the peak 1 of sin is found to 2e-7.
        let phi = std::f64::consts::TAU / 16.0;
        for k in 0..100 {
            let t0 = std::f64::consts::FRAC_PI_2 - phi * (0.005 + 0.99 * f64::from(k) / 100.0);
            let at = |t: f64| [t.sin(), phi * t.cos(), -phi * phi * t.sin()];
            let m = extremum(at(t0), at(t0 + phi));
            assert!((m - 1.0).abs() < 2e-7, "{k}: {m}");
        }
    }

    #[test]
    fn extrema_of_a_parabola_and_a_line() {
        assert_eq!(extremum([0.0, 1.0, 0.0], [1.0, 1.0, 0.0]), 0.0);
        // f = x − x²: peak 1/4 at 1/2.
        assert!((extremum([0.0, 1.0, -2.0], [0.0, -1.0, -2.0]) - 0.25).abs() < 1e-15);
        // Two extrema with slopes of one sign at the ends: f = x (x − 0.5)², peak at 1/6.
        let f = |x: f64| x * (x - 0.5) * (x - 0.5);
        let m = extremum([0.0, 0.25, -2.0], [0.25, 1.25, 4.0]);
        assert!((m - f(1.0 / 6.0)).abs() < 1e-15, "{m}");
    }
}
