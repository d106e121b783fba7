//! The structure on cones integrated directly: what its complex mode, and the body in its modes, are compared with.

use oscillator::newmark::Newmark;

use super::*;

impl Chain {
    /// Deformation u of the structure [m] at each sample, by Newmark's average acceleration.
    ///
    /// * `ground`: acceleration [m/s²], linear between samples `h` [s] apart; `parts` ≥ 1 steps to a sample
    ///
    /// Inertia-free unknowns (a massless slab) follow from their springs and dashpots in the same step.
    pub(crate) fn march(&self, ground: &[f64], h: f64, parts: usize) -> Vec<f64> {
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
