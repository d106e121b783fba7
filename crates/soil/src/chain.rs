//! A structure on cones with constant, real, positive coefficients.
//!
//! ```text
//! x = (x_s, x_b, ψ, θ₁)          deformation u = x_s − x_b − h ψ = b·x,   b = (1, −1, −h, 0)
//! M = diag(m, m_b, J_b + J_soil, M₁)
//! K = k b bᵀ + diag(0, K_x, K_θ, 0)          C = c b bᵀ + diag(0, C_x, 0, 0) + C_θ (e_ψ − e_θ)(e_ψ − e_θ)ᵀ
//! M ẍ + C ẋ + K x = −M (1, 1, 0, 0) a_g
//! ```
//!
//! θ₁ is the internal rotation of the rocking cone. Damping is not proportional: complex modes, or direct integration.
//!
//! Source: Meek & Wolf 1992.

use std::f64::consts::TAU;

use oscillator::newmark::Newmark;

use crate::C64;
use crate::disc::Impedance;
use crate::error::{SoilError, not_negative};
use crate::structure::{Effective, OnSoil};

/// Number of unknowns.
const N: usize = 4;
/// A square matrix, row by row.
pub type Square = [[f64; N]; N];

/// Matrices of a structure on cones.
#[derive(Clone, Debug, PartialEq)]
pub struct Chain {
    /// M [kg, kg m²].
    pub mass: Square,
    /// C.
    pub damping: Square,
    /// K.
    pub stiffness: Square,
    arm: f64,
    seed: Effective,
}

impl Chain {
    /// A structure on the cones of its disc. The hysteresis of the soil is left out.
    ///
    /// * `slab`: mass [kg] and moment of inertia about its own axis [kg m²] of the foundation; zeros for a massless one
    ///
    /// Errors: negative masses; no effective period to start from.
    pub fn new(on: &OnSoil, slab: [f64; 2]) -> Result<Chain, SoilError> {
        not_negative("mass of the slab [kg]", slab[0])?;
        not_negative("moment of inertia of the slab [kg m2]", slab[1])?;
        let cones = on.disc.cones();
        let h = on.structure.height;
        let b = [1.0, -1.0, -h, 0.0];
        let turn = [0.0, 0.0, 1.0, -1.0];
        let mut chain = Chain {
            mass: [[0.0; N]; N],
            damping: [[0.0; N]; N],
            stiffness: [[0.0; N]; N],
            arm: h,
            seed: on.effective(Impedance::Cone)?,
        };
        let inertia = [on.structure.mass, slab[0], slab[1] + cones.trapped_inertia, cones.internal_inertia];
        for i in 0..N {
            chain.mass[i][i] = inertia[i];
            for j in 0..N {
                chain.stiffness[i][j] = on.structure.stiffness() * b[i] * b[j];
                chain.damping[i][j] = on.structure.dashpot() * b[i] * b[j] + cones.rocking_dashpot * turn[i] * turn[j];
            }
        }
        chain.stiffness[1][1] += cones.stiffness.horizontal;
        chain.stiffness[2][2] += cones.stiffness.rocking;
        chain.damping[1][1] += cones.horizontal_dashpot;
        Ok(chain)
    }

    /// s² M + s C + K.
    pub fn dynamic(&self, s: C64) -> [[C64; N]; N] {
        let mut out = [[C64::new(0.0, 0.0); N]; N];
        for i in 0..N {
            for j in 0..N {
                out[i][j] = s * s * self.mass[i][j] + s * self.damping[i][j] + self.stiffness[i][j];
            }
        }
        out
    }

    /// Stiffness of the disc under a rotation: what the internal rotation, eliminated, leaves of row ψ of the ground alone [N m].
    pub fn rocking_impedance(on: &OnSoil, omega: f64) -> C64 {
        let cones = on.disc.cones();
        let c = C64::new(0.0, omega * cones.rocking_dashpot);
        let inner = c - omega * omega * cones.internal_inertia;
        C64::new(cones.stiffness.rocking, 0.0) + c - c * c / inner
    }

    /// The mode of the structure: T = 2π/|s|, ξ = −Re s/|s|, s a root of det(s² M + s C + K).
    ///
    /// Errors: no convergence from the effective period.
    pub fn complex_mode(&self) -> Result<Effective, SoilError> {
        const STEPS: usize = 200;
        let omega = TAU / self.seed.period;
        let xi = self.seed.damping.min(0.9);
        let mut last = C64::new(-xi * omega, omega * (1.0 - xi * xi).sqrt());
        let scale = self.determinant(C64::new(0.0, omega)).norm();
        let f = |s: C64| self.determinant(s) / scale;
        let mut s = last * 1.001;
        let mut before = f(last);
        let mut change = f64::INFINITY;
        for _ in 0..STEPS {
            let value = f(s);
            let slope = value - before;
            if slope.norm() == 0.0 {
                change = 0.0;
                break;
            }
            let step = value * (s - last) / slope;
            (last, before) = (s, value);
            s -= step;
            change = step.norm() / s.norm();
            if change < 1e-13 {
                break;
            }
        }
        if change.is_nan() || change > 1e-9 {
            let what = "complex mode of the structure on cones";
            return Err(SoilError::Iteration { what, steps: STEPS, change });
        }
        Ok(Effective { period: TAU / s.norm(), damping: -s.re / s.norm() })
    }

    fn determinant(&self, s: C64) -> C64 {
        let mut a = self.dynamic(s);
        let mut det = C64::new(1.0, 0.0);
        for k in 0..N {
            let pivot = (k..N).max_by(|&i, &j| a[i][k].norm().total_cmp(&a[j][k].norm()));
            let pivot = pivot.unwrap_or(k);
            if pivot != k {
                a.swap(pivot, k);
                det = -det;
            }
            det *= a[k][k];
            if a[k][k].norm() == 0.0 {
                return C64::new(0.0, 0.0);
            }
            for i in k + 1..N {
                let factor = a[i][k] / a[k][k];
                for j in k..N {
                    let top = a[k][j];
                    a[i][j] -= factor * top;
                }
            }
        }
        det
    }

    /// Deformation u of the structure [m] at each sample, by Newmark's average acceleration.
    ///
    /// * `ground`: acceleration [m/s²], linear between samples `h` [s] apart; `parts` ≥ 1 steps to a sample
    ///
    /// Inertia-free unknowns (a massless slab) follow from their springs and dashpots in the same step.
    pub fn march(&self, ground: &[f64], h: f64, parts: usize) -> Vec<f64> {
        let parts = parts.max(1);
        let step = Newmark::average_acceleration(h / parts as f64);
        let mut effective = self.stiffness;
        for i in 0..N {
            for j in 0..N {
                effective[i][j] += step.a0 * self.mass[i][j] + step.a1 * self.damping[i][j];
            }
        }
        let (mut x, mut v, mut a) = ([0.0; N], [0.0; N], [0.0; N]);
        // Masses start with −a_g; unknowns without inertia have no acceleration to start from.
        let first = ground.first().copied().unwrap_or(0.0);
        (a[0], a[1]) = (-first, if self.mass[1][1] > 0.0 { -first } else { 0.0 });
        let mut out = Vec::with_capacity(ground.len());
        out.push(0.0);
        for pair in ground.windows(2) {
            for part in 1..=parts {
                let load = pair[0] + (pair[1] - pair[0]) * part as f64 / parts as f64;
                let mut rhs = [0.0; N];
                for i in 0..N {
                    if i < 2 {
                        rhs[i] -= self.mass[i][i] * load;
                    }
                    for j in 0..N {
                        rhs[i] += self.mass[i][j] * (step.a0 * x[j] + step.a2 * v[j] + step.a3 * a[j]);
                        rhs[i] += self.damping[i][j] * (step.a1 * x[j] + step.a4 * v[j] + step.a5 * a[j]);
                    }
                }
                let new = solve(effective, rhs);
                for i in 0..N {
                    let acceleration = step.a0 * (new[i] - x[i]) - step.a2 * v[i] - step.a3 * a[i];
                    v[i] += step.a6 * a[i] + step.a7 * acceleration;
                    a[i] = acceleration;
                    x[i] = new[i];
                }
            }
            out.push(x[0] - x[1] - self.arm * x[2]);
        }
        out
    }
}

/// Gauss without exchange of rows: the effective matrix of a step is positive definite.
fn solve(mut a: Square, mut b: [f64; N]) -> [f64; N] {
    for k in 0..N {
        for i in k + 1..N {
            let factor = a[i][k] / a[k][k];
            for j in k..N {
                a[i][j] -= factor * a[k][j];
            }
            b[i] -= factor * b[k];
        }
    }
    for k in (0..N).rev() {
        let known: f64 = (k + 1..N).map(|j| a[k][j] * b[j]).sum();
        b[k] = (b[k] - known) / a[k][k];
    }
    b
}
