//! Newmark's coefficients, shared by the single oscillator and the finite-element integrator.
//!
//! Newmark's relations over a step h, with the parameters β and γ,
//!
//! ```text
//! u₁ = u₀ + h u̇₀ + h² [(1/2 − β) ü₀ + β ü₁]
//! u̇₁ = u̇₀ + h [(1 − γ) ü₀ + γ ü₁]
//! ```
//!
//! turn M ü₁ + C u̇₁ + K u₁ = P₁ into a system for u₁, or for ü₁:
//!
//! ```text
//! [K + a₀ M + a₁ C] u₁ = P₁ + M (a₀ u₀ + a₂ u̇₀ + a₃ ü₀) + C (a₁ u₀ + a₄ u̇₀ + a₅ ü₀)
//! ü₁ = a₀ (u₁ − u₀) − a₂ u̇₀ − a₃ ü₀
//! u̇₁ = u̇₀ + a₆ ü₀ + a₇ ü₁
//!
//! [M + a₇ C + (1/a₀) K] ü₁ = P₁ − C (u̇₀ + a₆ ü₀) − K (u₀ + h u̇₀ + (a₃/a₀) ü₀)
//! ```
//!
//! The average acceleration method (β = 1/4, γ = 1/2) is stable for every step, is free of numerical damping, and
//! lengthens the period T by the relative amount (ω h)²/12: 0.8 % at h = T/20.
//!
//! Source: Newmark 1959; names a₀ … a₇ after Bathe 1996, table 9.4.

/// The coefficients a₀ … a₇ of one step length.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Newmark {
    /// Step h [s].
    pub h: f64,
    /// β.
    pub beta: f64,
    /// γ.
    pub gamma: f64,
    /// a₀ = 1/(β h²) [1/s²].
    pub a0: f64,
    /// a₁ = γ/(β h) [1/s].
    pub a1: f64,
    /// a₂ = 1/(β h) [1/s].
    pub a2: f64,
    /// a₃ = 1/(2β) − 1.
    pub a3: f64,
    /// a₄ = γ/β − 1.
    pub a4: f64,
    /// a₅ = h/2 (γ/β − 2) [s].
    pub a5: f64,
    /// a₆ = h (1 − γ) [s].
    pub a6: f64,
    /// a₇ = γ h [s].
    pub a7: f64,
}

impl Newmark {
    /// Coefficients for the step `h` > 0 [s] and the parameters β > 0 and γ.
    pub fn new(h: f64, beta: f64, gamma: f64) -> Newmark {
        Newmark {
            h,
            beta,
            gamma,
            a0: 1.0 / (beta * h * h),
            a1: gamma / (beta * h),
            a2: 1.0 / (beta * h),
            a3: 0.5 / beta - 1.0,
            a4: gamma / beta - 1.0,
            a5: 0.5 * h * (gamma / beta - 2.0),
            a6: h * (1.0 - gamma),
            a7: gamma * h,
        }
    }

    /// Average acceleration (trapezoidal rule): β = 1/4, γ = 1/2.
    pub fn average_acceleration(h: f64) -> Newmark {
        Newmark::new(h, 0.25, 0.5)
    }

    /// Predicted displacement u₀ + h u̇₀ + h² (1/2 − β) ü₀, to which β h² ü₁ is added.
    pub fn predict_displacement(&self, u: f64, v: f64, a: f64) -> f64 {
        u + self.h * v + self.a3 / self.a0 * a
    }

    /// Predicted velocity u̇₀ + (1 − γ) h ü₀, to which γ h ü₁ is added.
    pub fn predict_velocity(&self, v: f64, a: f64) -> f64 {
        v + self.a6 * a
    }

    /// One step of a single oscillator ü + 2 ξ ω u̇ + ω² u = p₁ from (u, u̇, ü): the new (u, u̇, ü).
    pub fn step(&self, omega: f64, damping: f64, state: [f64; 3], load: f64) -> [f64; 3] {
        let [u, v, a] = state;
        let (k, c) = (omega * omega, 2.0 * damping * omega);
        let (u1, v1) = (self.predict_displacement(u, v, a), self.predict_velocity(v, a));
        let a1 = (load - c * v1 - k * u1) / (1.0 + self.a7 * c + k / self.a0);
        [u1 + a1 / self.a0, v1 + self.a7 * a1, a1]
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Both forms of the step in the module's text, written independently, give the same state.
    #[test]
    fn displacement_and_acceleration_forms_agree() {
        let (omega, damping, load) = (7.0, 0.03, 1.7);
        let [u, v, a] = [0.2, -0.4, 0.9];
        for (beta, gamma) in [(0.25, 0.5), (1.0 / 6.0, 0.5), (0.3025, 0.6)] {
            let n = Newmark::new(0.05, beta, gamma);
            let (k, c) = (omega * omega, 2.0 * damping * omega);
            let rhs = load + (n.a0 * u + n.a2 * v + n.a3 * a) + c * (n.a1 * u + n.a4 * v + n.a5 * a);
            let u1 = rhs / (k + n.a0 + n.a1 * c);
            let a1 = n.a0 * (u1 - u) - n.a2 * v - n.a3 * a;
            let v1 = v + n.a6 * a + n.a7 * a1;
            let got = n.step(omega, damping, [u, v, a], load);
            for (g, e) in got.iter().zip([u1, v1, a1]) {
                assert!((g - e).abs() < 1e-13, "{g} {e}");
            }
        }
    }

    /// Free vibration: over one step the phase of the average acceleration method is 2 arctan(ω h/2) and the amplitude
    /// stays (eigenvalues of its amplification matrix, Hughes 1987).
    #[test]
    fn average_acceleration_turns_by_twice_the_arctangent() {
        let (omega, h): (f64, f64) = (2.0, 0.1);
        let n = Newmark::average_acceleration(h);
        let phase = 2.0 * (omega * h / 2.0).atan();
        let mut s = [1.0, 0.0, -omega * omega];
        for i in 1..=500 {
            s = n.step(omega, 0.0, s, 0.0);
            assert!((s[0] - (phase * f64::from(i)).cos()).abs() < 1e-11);
        }
    }
}
