//! Implicit time integration: the generalised-α method and its special cases.
//!
//! ```text
//! M a_{n+1−α_m} + C v_{n+1−α_f} + f_int,{n+1−α_f} = p_{n+1−α_f}          x_{n+1−α} = (1 − α) x_{n+1} + α x_n
//! u₁ = u₀ + h v₀ + h² [(1/2 − β) a₀ + β a₁]          v₁ = v₀ + h [(1 − γ) a₀ + γ a₁]
//! ```
//!
//! | scheme | α_m | α_f | γ | β |
//! |---|---|---|---|---|
//! | generalised-α (Chung & Hulbert 1993), ρ_∞ = r | (2r − 1)/(r + 1) | r/(r + 1) | 1/2 − α_m + α_f | (1 − α_m + α_f)²/4 |
//! | HHT (Hilber, Hughes & Taylor 1977), −1/3 ≤ α ≤ 0 | 0 | −α | 1/2 − α | (1 − α)²/4 |
//! | Newmark (1959); the dissertation's (3.7), (3.8) with its α for γ | 0 | 0 | γ | β |
//! | trapezoidal rule | 0 | 0 | 1/2 | 1/4 |
//!
//! For constant matrices the acceleration is the unknown, and one product with K, M and C of the new acceleration carries
//! K u, K v, C v … on ([`super::transient`]). With a tangent K_T the displacement increment is the unknown:
//!
//! ```text
//! [(1 − α_m) M/(β h²) + (1 − α_f) (γ/(β h) C + K_T)] δu = r          δa = δu/(β h²)          δv = γ/(β h) δu
//! ```
//!
//! The internal force at the α point is the weighted sum of the forces at both ends, so that path-dependent materials are
//! evaluated at the ends of steps only.

use nalgebra::{Complex, Matrix3, Vector3};

use super::AnalysisError;
use crate::state::Fields;

/// Scheme without its step.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum TimeScheme {
    /// Trapezoidal rule (average acceleration): no numerical damping, period longer by (ω h)²/12.
    Trapezoidal,
    /// Newmark's two parameters; γ > 1/2 damps, to the first order only.
    Newmark {
        /// β.
        beta: f64,
        /// γ, the dissertation's α.
        gamma: f64,
    },
    /// Hilber, Hughes & Taylor.
    Hht {
        /// α, from −1/3 to 0.
        alpha: f64,
    },
    /// Chung & Hulbert.
    GeneralizedAlpha {
        /// Spectral radius ρ_∞ at infinite frequency, from 0 to 1.
        radius: f64,
    },
}

impl TimeScheme {
    /// The scheme with the step `h` [s].
    ///
    /// Errors: a step that is not positive, parameters out of range (Newmark: β > 0, γ ≥ 1/2, which is needed for
    /// stability).
    pub fn with_step(self, h: f64) -> Result<GeneralizedAlpha, AnalysisError> {
        let refuse = |found: String, allowed: &str| {
            Err(AnalysisError::Option { option: "time integration", found, allowed: allowed.into() })
        };
        if !(h > 0.0 && h.is_finite()) {
            return refuse(format!("step {h} s"), "a positive number");
        }
        let (alpha_m, alpha_f) = match self {
            TimeScheme::Trapezoidal => (0.0, 0.0),
            TimeScheme::Newmark { beta, gamma } => {
                if !(beta > 0.0 && beta <= 1.0 && (0.5..=1.5).contains(&gamma)) {
                    return refuse(format!("β = {beta}, γ = {gamma}"), "0 < β ≤ 1 and 1/2 ≤ γ ≤ 3/2");
                }
                return Ok(GeneralizedAlpha { h, alpha_m: 0.0, alpha_f: 0.0, beta, gamma });
            }
            TimeScheme::Hht { alpha } => {
                if !(-1.0 / 3.0..=0.0).contains(&alpha) {
                    return refuse(format!("α = {alpha}"), "−1/3 to 0");
                }
                (0.0, -alpha)
            }
            TimeScheme::GeneralizedAlpha { radius } => {
                if !(0.0..=1.0).contains(&radius) {
                    return refuse(format!("ρ_∞ = {radius}"), "0 to 1");
                }
                ((2.0 * radius - 1.0) / (radius + 1.0), radius / (radius + 1.0))
            }
        };
        Ok(GeneralizedAlpha {
            h,
            alpha_m,
            alpha_f,
            gamma: 0.5 - alpha_m + alpha_f,
            beta: 0.25 * (1.0 - alpha_m + alpha_f).powi(2),
        })
    }
}

/// Parameters of a step.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct GeneralizedAlpha {
    /// Step h [s].
    pub h: f64,
    /// α_m.
    pub alpha_m: f64,
    /// α_f.
    pub alpha_f: f64,
    /// β.
    pub beta: f64,
    /// γ.
    pub gamma: f64,
}

/// Weights of the matrices in the effective one.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Weights {
    /// Weight of M.
    pub mass: f64,
    /// Weight of C.
    pub damping: f64,
    /// Weight of K.
    pub stiffness: f64,
}

impl GeneralizedAlpha {
    /// Weights if the acceleration is the unknown: (1 − α_m) M + (1 − α_f) (γ h C + β h² K).
    pub fn acceleration_weights(&self) -> Weights {
        Weights {
            mass: 1.0 - self.alpha_m,
            damping: (1.0 - self.alpha_f) * self.gamma * self.h,
            stiffness: (1.0 - self.alpha_f) * self.beta * self.h * self.h,
        }
    }

    /// Local error of the displacement of a step in h² Δa, Δa the increment of the acceleration.
    ///
    /// The accelerations of the scheme are those at δ h after the instant, δ = α_m − α_f, so that its Taylor series misses that of
    /// the displacement by h³ u⃛ (β − 1/6 + δ/2). For Newmark's method the estimate of Zienkiewicz & Xie 1991.
    pub fn local_error(&self) -> f64 {
        self.beta - 1.0 / 6.0 + 0.5 * (self.alpha_m - self.alpha_f)
    }

    /// Amplification matrix of (u, h v, h² a) for ü + 2 ξ ω u̇ + ω² u = 0, x = ω h.
    pub fn amplification(&self, x: f64, damping: f64) -> Matrix3<f64> {
        let (am, af, b, g) = (self.alpha_m, self.alpha_f, self.beta, self.gamma);
        let (c, k) = (2.0 * damping * x, x * x);
        // Rows of u₁ and h v₁ without the new acceleration, and their coefficients of it.
        let u = Vector3::new(1.0, 1.0, 0.5 - b);
        let v = Vector3::new(0.0, 1.0, 1.0 - g);
        let weight = (1.0 - am) + (1.0 - af) * (g * c + b * k);
        let old = Vector3::new(af * k, af * c, am);
        let a = -(old + (1.0 - af) * (k * u + c * v)) / weight;
        let (u, v) = (u + b * a, v + g * a);
        Matrix3::from_rows(&[u.transpose(), v.transpose(), a.transpose()])
    }

    /// Numerical damping ratio and relative lengthening of the period of an undamped oscillator with x = ω h, from the
    /// principal roots |λ| e^{±iφ}: −ln|λ|/φ and x/φ − 1.
    pub fn spectral_properties(&self, x: f64) -> (f64, f64) {
        let principal = self
            .amplification(x, 0.0)
            .complex_eigenvalues()
            .iter()
            .copied()
            .filter(|l: &Complex<f64>| l.im > 0.0)
            .fold(Complex::new(0.0, 0.0), |m, l| if l.norm() > m.norm() { l } else { m });
        let phase = principal.arg();
        (-principal.norm().ln() / phase, x / phase - 1.0)
    }

    /// Spectral radius of the amplification matrix of an undamped oscillator with x = ω h.
    pub fn spectral_radius(&self, x: f64) -> f64 {
        let roots = self.amplification(x, 0.0).complex_eigenvalues();
        roots.iter().map(|l| l.norm()).fold(0.0, f64::max)
    }
}

/// A load or time step as seen by Newton's method.
pub trait Scheme {
    /// First guess of the trial fields.
    ///
    /// Returns the increment of the unknowns that the guess makes, so that rotations can follow.
    fn predict(&self, committed: &Fields) -> Vec<f64>;

    /// Weights of M, C and K_T in the effective tangent of the displacement increment.
    fn weights(&self) -> Weights;

    /// Weight of the trial state in the inertia force, and in all other forces: 1 − α_m, 1 − α_f.
    fn collocation(&self) -> (f64, f64);

    /// Velocity and acceleration of the trial state that belong to its displacement increment since `committed`.
    fn correct(&self, committed: &Fields, trial: &mut Fields);
}

impl Scheme for GeneralizedAlpha {
    fn predict(&self, committed: &Fields) -> Vec<f64> {
        let h = self.h;
        let guess = |(v, a): (&f64, &f64)| h * v + 0.5 * h * h * a;
        committed.v.iter().zip(&committed.a).map(guess).collect()
    }

    fn weights(&self) -> Weights {
        let (b, h) = (self.beta, self.h);
        Weights {
            mass: (1.0 - self.alpha_m) / (b * h * h),
            damping: (1.0 - self.alpha_f) * self.gamma / (b * h),
            stiffness: 1.0 - self.alpha_f,
        }
    }

    fn collocation(&self) -> (f64, f64) {
        (1.0 - self.alpha_m, 1.0 - self.alpha_f)
    }

    fn correct(&self, committed: &Fields, trial: &mut Fields) {
        let (b, g, h) = (self.beta, self.gamma, self.h);
        for i in 0..committed.u.len() {
            let (v0, a0) = (committed.v[i], committed.a[i]);
            let du = trial.u[i] - committed.u[i];
            let a1 = (du - h * v0) / (b * h * h) - (0.5 / b - 1.0) * a0;
            trial.a[i] = a1;
            trial.v[i] = v0 + h * ((1.0 - g) * a0 + g * a1);
        }
    }
}

/// A static step.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct LoadStep;

impl Scheme for LoadStep {
    fn predict(&self, committed: &Fields) -> Vec<f64> {
        vec![0.0; committed.u.len()]
    }

    fn weights(&self) -> Weights {
        Weights { mass: 0.0, damping: 0.0, stiffness: 1.0 }
    }

    fn collocation(&self) -> (f64, f64) {
        (1.0, 1.0)
    }

    fn correct(&self, _committed: &Fields, _trial: &mut Fields) {}
}
