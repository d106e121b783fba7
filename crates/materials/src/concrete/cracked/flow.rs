//! Stress in given crack axes with plastic flow: six unknowns, semi-smooth Newton.
//!
//! ```text
//! x = (σ_n/E, σ_s/E, τ/E, λ, e_n, e_s)            all of the size of a strain
//!
//! (σ_n − ν σ_s)/E + λ n_n + e_n − a_n = 0          elastic + plastic + crack strain
//! (σ_s − ν σ_n)/E + λ n_s + e_s − a_s = 0
//!  τ/(β G)        + λ n_τ       − γ   = 0          β of the largest opening, this step's included
//!  F/E = 0  if λ + F/E > 0,  else  λ = 0           Drucker-Prager
//! (σ_i − t_i(e_i))/E = 0  if e_i + (σ_i − t_i(e_i))/E > 0,  else  e_i = 0
//! ```
//!
//! Steps are halved until the residual falls; several starts. The tangent is three columns of the inverse Jacobian.

use super::CrackedConcrete;
use super::local::{Problem, Solution};

type Vector = [f64; 6];
type Matrix = [[f64; 6]; 6];

impl CrackedConcrete {
    /// Stress with plastic flow, starting from a solution without it; `None` if no start converges.
    pub(super) fn with_flow(&self, problem: &Problem, elastic: Option<&Solution>) -> Option<Solution> {
        let inverse = 1.0 / self.young_modulus;
        let (a, axes) = (&problem.strain, &problem.axes);
        let mut starts = [[0.0; 6]; 4];
        let mut count = 0;
        let scale = self.surface.scale();
        let mut add = |stress: [f64; 3], e: [f64; 2]| {
            // Back to the cone along the ray, which keeps the first step short.
            let (q, f) = self.surface.at(&stress);
            let share = if f > 0.0 { (scale / (f + scale).max(1e-3 * q)).min(1.0) } else { 1.0 };
            let t = stress.map(|s| s * share * inverse);
            starts[count] = [t[0], t[1], t[2], 0.0, e[0], e[1]];
            count += 1;
        };
        let (nu, c) = (self.poisson_ratio, self.plane_modulus);
        let elastic_at = |e: [f64; 2]| {
            let x = [a[0] - e[0], a[1] - e[1]];
            [c * (x[0] + nu * x[1]), c * (x[1] + nu * x[0]), problem.beta * self.shear_modulus * a[2]]
        };
        if let Some(solution) = elastic {
            add(solution.stress, solution.opening);
        }
        add(elastic_at([0.0; 2]), [0.0; 2]);
        let largest = [0, 1].map(|i| axes[i].largest.min(a[i].max(0.0)));
        add(elastic_at(largest), largest);
        let all = [0, 1].map(|i| if axes[i].traction.is_some() { a[i].max(0.0) } else { 0.0 });
        add(elastic_at(all), all);
        starts[..count].iter().find_map(|start| self.newton(problem, *start))
    }

    fn newton(&self, problem: &Problem, start: Vector) -> Option<Solution> {
        let a = &problem.strain;
        let small = 1e-13 * (a[0].abs() + a[1].abs() + a[2].abs() + self.surface.scale() / self.young_modulus);
        let mut x = start;
        let (mut r, mut jacobian) = self.residual(problem, &x)?;
        let mut norm = length(&r);
        for _ in 0..40 {
            if norm <= small {
                return self.finish(problem, &x, jacobian);
            }
            let mut step = [[0.0]; 6];
            for i in 0..6 {
                step[i][0] = -r[i];
            }
            solve(jacobian, &mut step)?;
            let (mut share, mut best) = (1.0, None);
            for _ in 0..10 {
                let trial: Vector = std::array::from_fn(|i| x[i] + share * step[i][0]);
                if let Some((r_t, j_t)) = self.residual(problem, &trial) {
                    let n_t = length(&r_t);
                    if n_t < (1.0 - 1e-3 * share) * norm {
                        best = Some((trial, r_t, j_t, n_t));
                        break;
                    }
                }
                share *= 0.5;
            }
            (x, r, jacobian, norm) = best?;
        }
        None
    }

    fn residual(&self, problem: &Problem, x: &Vector) -> Option<(Vector, Matrix)> {
        let (young, nu) = (self.young_modulus, self.poisson_ratio);
        let (a, axes) = (&problem.strain, &problem.axes);
        let stress = [young * x[0], young * x[1], young * x[2]];
        let (lambda, e) = (x[3], [x[4], x[5]]);
        let (q, f) = self.surface.at(&stress);
        if !q.is_finite() {
            return None;
        }
        let (mut n, mut h) = ([0.0; 3], [[0.0; 3]; 3]);
        // On the axis of the cone flow is negligible: cracks come first.
        if q > 1e-9 * self.surface.scale() {
            (n, h) = self.surface.normal(&stress, q);
        }
        let wider = if e[0] >= e[1] { 0 } else { 1 };
        let (mut beta, mut rate) = (problem.beta, 0.0);
        if e[wider] > problem.largest() {
            (beta, rate) = self.shear_factor(e[wider]);
        }
        let slip = 2.0 * (1.0 + nu) / beta;
        let mut r = [
            x[0] - nu * x[1] + lambda * n[0] + e[0] - a[0],
            x[1] - nu * x[0] + lambda * n[1] + e[1] - a[1],
            slip * x[2] + lambda * n[2] - a[2],
            0.0,
            0.0,
            0.0,
        ];
        let mut j = [[0.0; 6]; 6];
        j[0][0] = 1.0;
        j[0][1] = -nu;
        j[1][0] = -nu;
        j[1][1] = 1.0;
        j[2][2] = slip;
        for i in 0..3 {
            for k in 0..3 {
                j[i][k] += lambda * h[i][k] * young;
            }
            j[i][3] = n[i];
        }
        j[0][4] = 1.0;
        j[1][5] = 1.0;
        j[2][4 + wider] -= slip * x[2] * rate / beta;
        if lambda + f / young > 0.0 {
            r[3] = f / young;
            j[3][..3].copy_from_slice(&n);
        } else {
            r[3] = lambda;
            j[3][3] = 1.0;
        }
        for i in 0..2 {
            let (t, k) = axes[i].at(e[i]);
            let excess = (stress[i] - t) / young;
            if e[i] + excess > 0.0 {
                r[4 + i] = excess;
                j[4 + i][i] = 1.0;
                j[4 + i][4 + i] = -k / young;
            } else {
                r[4 + i] = e[i];
                j[4 + i][4 + i] = 1.0;
            }
        }
        Some((r, j))
    }

    /// The response at a zero of the residual.
    fn finish(&self, problem: &Problem, x: &Vector, jacobian: Matrix) -> Option<Solution> {
        let young = self.young_modulus;
        let stress = [young * x[0], young * x[1], young * x[2]];
        let opening = [x[4].max(0.0), x[5].max(0.0)];
        let multiplier = x[3].max(0.0);
        let (q, _) = self.surface.at(&stress);
        let n = if q > 1e-9 * self.surface.scale() { self.surface.normal(&stress, q).0 } else { [0.0; 3] };
        // J dx = da, and (∂t/∂f) df/E in the rows of cracks that open.
        let mut columns = [[0.0; 3]; 6];
        for i in 0..3 {
            columns[i][i] = 1.0;
        }
        for i in 0..2 {
            if jacobian[4 + i][i] != 0.0 {
                let by = problem.axes[i].by_strength(opening[i]) / young;
                columns[4 + i] = problem.axes[i].gradient.map(|g| by * g);
            }
        }
        solve(jacobian, &mut columns)?;
        let wide = opening[0].max(opening[1]);
        Some(Solution {
            stress,
            opening,
            multiplier,
            flow: n.map(|n| multiplier * n),
            beta: if wide > problem.largest() { self.shear_factor(wide).0 } else { problem.beta },
            tangent: std::array::from_fn(|i| columns[i].map(|v| young * v)),
        })
    }
}

fn length(r: &Vector) -> f64 {
    r.iter().map(|v| v * v).sum::<f64>().sqrt()
}

/// Solves A X = B in place by elimination with row exchange; `None` for a singular A.
fn solve<const M: usize>(mut a: Matrix, b: &mut [[f64; M]; 6]) -> Option<()> {
    for p in 0..6 {
        let pivot = (p..6).fold(p, |best, i| if a[i][p].abs() > a[best][p].abs() { i } else { best });
        let largest = a[pivot][p].abs();
        if largest.is_nan() || largest <= 1e-14 {
            return None;
        }
        a.swap(p, pivot);
        b.swap(p, pivot);
        let inverse = 1.0 / a[p][p];
        for i in p + 1..6 {
            let factor = a[i][p] * inverse;
            if factor != 0.0 {
                for k in p..6 {
                    a[i][k] -= factor * a[p][k];
                }
                for k in 0..M {
                    b[i][k] -= factor * b[p][k];
                }
            }
        }
    }
    for p in (0..6).rev() {
        for k in 0..M {
            let mut sum = b[p][k];
            for i in p + 1..6 {
                sum -= a[p][i] * b[i][k];
            }
            b[p][k] = sum / a[p][p];
        }
    }
    Some(())
}
