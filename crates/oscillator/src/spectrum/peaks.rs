//! Maxima of the continuous response between two points.
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

/// Scaled state at one time.
#[derive(Clone, Copy, Debug)]
pub(crate) struct State {
    pub y: f64,
    pub y1: f64,
    /// y''.
    pub y2: f64,
    /// y'''.
    pub y3: f64,
}

/// Largest |y|, |y'| and |A| so far.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub(crate) struct Maxima {
    pub y: f64,
    pub y1: f64,
    pub a: f64,
}

/// The larger of two numbers, without the rules of `f64::max` for NaN.
#[inline(always)]
pub(crate) fn larger(a: f64, b: f64) -> f64 {
    if a > b { a } else { b }
}

impl State {
    /// Completes y and y' under the load `p` with the slope `sigma` = dp/dφ.
    #[inline]
    pub(crate) fn new(y: f64, y1: f64, p: f64, sigma: f64, xi: f64) -> State {
        let y2 = p - y - 2.0 * xi * y1;
        State { y, y1, y2, y3: sigma - y1 - 2.0 * xi * y2 }
    }

    /// R² of the oscillation about the line of the load, (x₁, x₂) being its state.
    #[inline]
    pub(crate) fn oscillation(&self, p: f64, sigma: f64, xi: f64) -> (f64, f64) {
        let x1 = self.y - p + 2.0 * xi * sigma;
        (x1, (self.y1 - sigma + xi * x1) / ((1.0 - xi) * (1.0 + xi)).sqrt())
    }

    /// A and its first two derivatives.
    #[inline]
    fn absolute(&self, xi: f64) -> [f64; 3] {
        let c = 2.0 * xi;
        [self.y + c * self.y1, self.y1 + c * self.y2, self.y2 + c * self.y3]
    }
}

impl Maxima {
    /// Includes the values at one time.
    #[inline]
    pub(crate) fn take(&mut self, y: f64, y1: f64, xi: f64) {
        self.y = larger(y.abs(), self.y);
        self.y1 = larger(y1.abs(), self.y1);
        self.a = larger((y + 2.0 * xi * y1).abs(), self.a);
    }

    /// Includes the interval of length `phi` = Δφ ≤ 2π/16 that ends at `s1`; `r` ≥ R.
    #[inline]
    pub(crate) fn take_interval(&mut self, s0: &State, s1: &State, phi: f64, r: f64, xi: f64) {
        self.take(s1.y, s1.y1, xi);
        between(&mut self.y, [s0.y, s0.y1, s0.y2], [s1.y, s1.y1, s1.y2], phi, r);
        between(&mut self.y1, [s0.y1, s0.y2, s0.y3], [s1.y1, s1.y2, s1.y3], phi, r);
        between(&mut self.a, s0.absolute(xi), s1.absolute(xi), phi, r);
    }

    /// Includes the free vibration from the state y, y'.
    ///
    /// e^{−ξφ} (α cos κφ + β sin κφ), κ = √(1 − ξ²), has its first extremum where tan κφ = f'/(ακ + ξβ) in [0, π); all
    /// later ones are smaller.
    pub(crate) fn take_free_vibration(&mut self, y: f64, y1: f64, xi: f64) {
        let kappa = ((1.0 - xi) * (1.0 + xi)).sqrt();
        let peak = |f: f64, slope: f64| {
            let beta = (slope + xi * f) / kappa;
            let angle = slope.atan2(f * kappa + xi * beta).rem_euclid(std::f64::consts::PI);
            let (sin, cos) = angle.sin_cos();
            ((-xi * angle / kappa).exp() * (f * cos + beta * sin)).abs()
        };
        let y2 = -y - 2.0 * xi * y1;
        let y3 = -y1 - 2.0 * xi * y2;
        self.y = larger(peak(y, y1), self.y);
        self.y1 = larger(peak(y1, y2), self.y1);
        self.a = larger(peak(-y2, -y3), self.a);
    }
}

/// Raises `m` to the maximum of |f| between two points, each given with f, f', f''.
#[inline]
fn between(m: &mut f64, f0: [f64; 3], f1: [f64; 3], phi: f64, r: f64) {
    let e = phi * phi / 8.0;
    let bound = larger(f0[0].abs(), f1[0].abs()) + e * (larger(f0[2].abs(), f1[2].abs()) + e * r);
    if bound > *m {
        let scaled = |f: [f64; 3]| [f[0], f[1] * phi, f[2] * phi * phi];
        *m = larger(extremum(scaled(f0), scaled(f1)), *m);
    }
}

/// Largest |f| at the extrema inside (0, 1), from f, f', f'' at 0 and 1; else 0.
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
            m = larger((f0 + h3 * rise + h1 * d0 + h4 * d1 + h2 * c0 + h5 * c1).abs(), m);
        }
    }
    m
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Under p + σφ the oscillator follows the line p − 2ξσ + σφ plus R e^{−ξφ} cos(κφ − ψ): its state (x₁, x₂) is
    /// R e^{−ξφ} (cos, −sin)(κφ − ψ).
    #[test]
    fn oscillation_beside_a_rising_load() {
        let (xi, sigma, radius, psi) = (0.1f64, 0.7, 2.0, 0.4);
        let kappa = (1.0 - xi * xi).sqrt();
        for phi in [0.0, 0.3, 1.7, 4.0] {
            let (angle, decay) = (kappa * phi - psi, (-xi * phi).exp());
            let x = radius * decay * angle.cos();
            let slope = radius * decay * (-xi * angle.cos() - kappa * angle.sin());
            let p = 1.3 + sigma * phi;
            let state = State::new(p - 2.0 * xi * sigma + x, sigma + slope, p, sigma, xi);
            let (x1, x2) = state.oscillation(p, sigma, xi);
            assert!((x1 - x).abs() < 1e-14, "{phi}: {x1} {x}");
            assert!((x2 + radius * decay * angle.sin()).abs() < 1e-14, "{phi}: {x2}");
            // y″ is that of the oscillation: x″ = −x − 2ξx′; y‴ its derivative.
            let second = -x - 2.0 * xi * slope;
            assert!((state.y2 - second).abs() < 1e-14);
            assert!((state.y3 - (-slope - 2.0 * xi * second)).abs() < 1e-14);
        }
    }

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

    #[test]
    fn free_vibration() {
        // y = cos φ with φ₀ = −1: the peak 1 is ahead; undamped, y' = −sin φ reaches 1 later.
        let mut m = Maxima::default();
        m.take_free_vibration(1f64.cos(), 1f64.sin(), 0.0);
        assert!((m.y - 1.0).abs() < 1e-15 && (m.y1 - 1.0).abs() < 1e-15 && (m.a - 1.0).abs() < 1e-15);
        // From rest at y = 1 with damping: the largest A is that of the start, the largest y' e^{−ξφ} at tan κφ = κ/ξ.
        let (xi, mut m) = (0.2f64, Maxima::default());
        m.take_free_vibration(1.0, 0.0, xi);
        let kappa = (1.0 - xi * xi).sqrt();
        let angle = (kappa / xi).atan();
        assert!((m.y1 - (-xi * angle / kappa).exp() * angle.sin() / kappa).abs() < 1e-15, "{m:?}");
    }
}
