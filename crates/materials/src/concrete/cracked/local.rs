//! Stress in given crack axes, without plastic flow.
//!
//! ```text
//! σ = C (a − e) ,  τ = β G γ          a = ε − ε_p in the axes; C of plane stress, normal components
//! e_i = 0  and σ_i ≤ t_i(0)           closed
//! σ_i = K_i e_i , K_i = t(m_i)/m_i    0 ≤ e_i ≤ m_i
//! σ_i = t_i(e_i)                      e_i > m_i
//! ```
//!
//! While no crack opens beyond its largest opening, this is a linear complementarity problem of two variables, and C
//! has positive minors: the solution is unique. One crack that opens further leaves one scalar equation, u = e +
//! t(e)/D, with the modulus D of the axis once the other crack is condensed: D = E/(1 − ν²) if it is closed, E ≤ D if
//! it is open. Two that open further need Newton's method in two variables.

use super::CrackedConcrete;
use crate::concrete::tension::Traction;

/// One crack direction.
#[derive(Clone, Copy, Debug)]
pub(super) struct Axis {
    /// Traction law of this crack; `None`: not allowed to crack in this step.
    pub traction: Option<Traction>,
    /// Largest opening so far, m.
    pub largest: f64,
    /// Traction at it, t(m) [Pa].
    pub at_largest: f64,
    /// ∂f/∂a, where the strength follows from this step's strain.
    pub gradient: [f64; 3],
}

impl Axis {
    /// A direction that does not crack in this step.
    pub(crate) const WHOLE: Axis = Axis { traction: None, largest: 0.0, at_largest: f64::INFINITY, gradient: [0.0; 3] };

    /// Stress [Pa] at which the closed crack opens.
    #[inline]
    fn limit(&self) -> f64 {
        match &self.traction {
            None => f64::INFINITY,
            Some(traction) if self.largest == 0.0 => traction.strength,
            Some(_) => 0.0,
        }
    }

    /// K = t(m)/m [Pa].
    #[inline]
    fn secant(&self) -> f64 {
        self.at_largest / self.largest
    }

    /// Traction and slope [Pa] at the opening e.
    #[inline]
    pub(crate) fn at(&self, e: f64) -> (f64, f64) {
        match &self.traction {
            None => (f64::INFINITY, 0.0),
            Some(_) if self.largest > 0.0 && e < self.largest => {
                let k = self.secant();
                (k * e.max(0.0), k)
            }
            Some(traction) => traction.at(e.max(0.0)),
        }
    }

    /// ∂t/∂f at the opening e.
    pub(crate) fn by_strength(&self, e: f64) -> f64 {
        match &self.traction {
            Some(traction) if e >= self.largest => traction.by_strength(e),
            _ => 0.0,
        }
    }
}

/// Input: strain and cracks in the axes.
#[derive(Clone, Copy, Debug)]
pub(super) struct Problem {
    /// Strain less old plastic strain.
    pub strain: [f64; 3],
    /// Cracks across n and s.
    pub axes: [Axis; 2],
    /// Old shear factor β.
    pub beta: f64,
    /// Whether the axes rotate with the strain: zero shear in them, and a coaxial stress.
    pub coaxial: bool,
}

impl Problem {
    /// Largest opening of both cracks so far.
    pub(crate) fn largest(&self) -> f64 {
        self.axes[0].largest.max(self.axes[1].largest)
    }
}

/// Result in the axes.
#[derive(Clone, Copy, Debug)]
pub(super) struct Solution {
    pub stress: [f64; 3],
    pub opening: [f64; 2],
    /// Plastic multiplier.
    pub multiplier: f64,
    /// Plastic strain of the step.
    pub flow: [f64; 3],
    /// New shear factor β.
    pub beta: f64,
    pub tangent: [[f64; 3]; 3],
}

#[derive(Clone, Copy, PartialEq)]
enum Status {
    Closed,
    Secant,
    Softening,
}

impl CrackedConcrete {
    /// Stress without plastic flow; `None` if the cracks do not converge.
    pub(super) fn without_flow(&self, problem: &Problem) -> Option<Solution> {
        let Problem { strain: a, axes, .. } = problem;
        let (nu, c) = (self.poisson_ratio, self.plane_modulus);
        let mut status = [Status::Closed; 2];
        for _ in 0..12 {
            let e = self.openings(problem, status)?;
            let x = [a[0] - e[0], a[1] - e[1]];
            let stress = [c * (x[0] + nu * x[1]), c * (x[1] + nu * x[0])];
            let mut settled = true;
            for i in 0..2 {
                let next = match status[i] {
                    Status::Closed if stress[i] > axes[i].limit() * (1.0 + 1e-13) => {
                        if axes[i].largest > 0.0 {
                            Status::Secant
                        } else {
                            Status::Softening
                        }
                    }
                    Status::Secant if e[i] < 0.0 => Status::Closed,
                    Status::Secant if e[i] > axes[i].largest * (1.0 + 1e-12) => Status::Softening,
                    Status::Softening if axes[i].largest > 0.0 && e[i] < axes[i].largest => Status::Secant,
                    Status::Softening if e[i] <= 0.0 => Status::Closed,
                    same => same,
                };
                settled &= next == status[i];
                status[i] = next;
            }
            if settled {
                return self.elastic_tangent(problem, status, e, stress);
            }
        }
        None
    }

    /// Openings of cracks of given status.
    fn openings(&self, problem: &Problem, status: [Status; 2]) -> Option<[f64; 2]> {
        let Problem { strain: a, axes, .. } = problem;
        let (nu, c) = (self.poisson_ratio, self.plane_modulus);
        let mut e = [0.0; 2];
        match status {
            [Status::Closed, Status::Closed] => {}
            [Status::Secant, Status::Secant] => {
                // (c + K_i) e_i + ν c e_j = c (a_i + ν a_j)
                let (d_0, d_1) = (c + axes[0].secant(), c + axes[1].secant());
                let (r_0, r_1) = (c * (a[0] + nu * a[1]), c * (a[1] + nu * a[0]));
                let det = d_0 * d_1 - (nu * c) * (nu * c);
                e = [(r_0 * d_1 - nu * c * r_1) / det, (r_1 * d_0 - nu * c * r_0) / det];
            }
            [Status::Softening, Status::Softening] => return self.both_soften(problem),
            _ => {
                // One is condensed: the closed one, or the one on its secant if the other softens.
                let i = match status {
                    [Status::Softening, _] | [Status::Secant, Status::Closed] => 0,
                    _ => 1,
                };
                let j = 1 - i;
                if status[j] == Status::Closed {
                    let u = a[i] + nu * a[j];
                    e[i] = self.opening(&axes[i], status[i], u, c)?;
                } else {
                    // K e_j = c (a_j − e_j + ν (a_i − e_i))
                    let k = axes[j].secant();
                    let d = c * (1.0 - nu * nu * c / (c + k));
                    let u = a[i] + c * nu * k * a[j] / ((c + k) * d);
                    e[i] = self.opening(&axes[i], status[i], u, d)?;
                    e[j] = c * (a[j] + nu * (a[i] - e[i])) / (c + k);
                }
            }
        }
        Some(e)
    }

    /// Opening of one crack with σ = D (u − e).
    fn opening(&self, axis: &Axis, status: Status, u: f64, d: f64) -> Option<f64> {
        Some(match status {
            Status::Softening => axis.traction.as_ref()?.opened(u, d, axis.largest).0,
            _ => d * u / (d + axis.secant()),
        })
    }

    /// Both cracks beyond their largest opening: one sweep of single cracks, then Newton's method; sweeps if that fails.
    fn both_soften(&self, problem: &Problem) -> Option<[f64; 2]> {
        let Problem { strain: a, axes, .. } = problem;
        let (nu, c) = (self.poisson_ratio, self.plane_modulus);
        let single = |i: usize, e_j: f64| {
            let u = a[i] + nu * (a[1 - i] - e_j);
            Some(axes[i].traction.as_ref()?.opened(u, c, axes[i].largest).0)
        };
        let mut e = [axes[0].largest, axes[1].largest];
        e[0] = single(0, e[1])?;
        e[1] = single(1, e[0])?;
        let start = e;
        let small = 1e-14 * (a[0].abs() + a[1].abs());
        for _ in 0..20 {
            let [(t_0, k_0), (t_1, k_1)] = [axes[0].at(e[0]), axes[1].at(e[1])];
            let x = [a[0] - e[0], a[1] - e[1]];
            let r = [c * (x[0] + nu * x[1]) - t_0, c * (x[1] + nu * x[0]) - t_1];
            let det = (c + k_0) * (c + k_1) - (nu * c) * (nu * c);
            let step = [(r[0] * (c + k_1) - nu * c * r[1]) / det, (r[1] * (c + k_0) - nu * c * r[0]) / det];
            e = [e[0] + step[0], e[1] + step[1]];
            if !(e[0] > -1.0 && e[0] < 1.0 && e[1] > -1.0 && e[1] < 1.0) {
                break;
            }
            if step[0].abs() + step[1].abs() < small {
                return Some(e);
            }
        }
        e = start;
        for _ in 0..200 {
            let next = single(0, e[1])?;
            let other = single(1, next)?;
            let change = (next - e[0]).abs() + (other - e[1]).abs();
            e = [next, other];
            if change < small {
                return Some(e);
            }
        }
        None
    }

    /// The tangent: (C_oo + k) de = C_o da − ∂t/∂f df over the open cracks o, dσ = C (da − de).
    fn elastic_tangent(
        &self,
        problem: &Problem,
        status: [Status; 2],
        opening: [f64; 2],
        normal: [f64; 2],
    ) -> Option<Solution> {
        let (nu, c) = (self.poisson_ratio, self.plane_modulus);
        let axes = &problem.axes;
        // de_i/da_j, j = n, s, nt
        let mut de = [[0.0; 3]; 2];
        let rate = |i: usize| {
            let mut row = if i == 0 { [c, nu * c, 0.0] } else { [nu * c, c, 0.0] };
            if status[i] == Status::Softening {
                let by = axes[i].by_strength(opening[i]);
                for j in 0..3 {
                    row[j] -= by * axes[i].gradient[j];
                }
            }
            row
        };
        let slope = |i: usize| match status[i] {
            Status::Secant => axes[i].secant(),
            _ => axes[i].traction.as_ref().map_or(0.0, |t| t.at(opening[i]).1),
        };
        match status.map(|s| s != Status::Closed) {
            [false, false] => {}
            [true, true] => {
                let (d_0, d_1) = (c + slope(0), c + slope(1));
                let det = d_0 * d_1 - (nu * c) * (nu * c);
                if det.abs() < 1e-9 * c * c {
                    return None;
                }
                let (r_0, r_1) = (rate(0), rate(1));
                for j in 0..3 {
                    de[0][j] = (r_0[j] * d_1 - nu * c * r_1[j]) / det;
                    de[1][j] = (r_1[j] * d_0 - nu * c * r_0[j]) / det;
                }
            }
            [first, _] => {
                let i = if first { 0 } else { 1 };
                let d = c + slope(i);
                de[i] = rate(i).map(|r| r / d);
            }
        }
        let mut tangent = [[0.0; 3]; 3];
        for j in 0..3 {
            let x_0 = f64::from(u8::from(j == 0)) - de[0][j];
            let x_1 = f64::from(u8::from(j == 1)) - de[1][j];
            tangent[0][j] = c * (x_0 + nu * x_1);
            tangent[1][j] = c * (x_1 + nu * x_0);
        }
        let gamma = problem.strain[2];
        let largest = problem.largest();
        let (mut beta, g) = (problem.beta, self.shear_modulus);
        tangent[2][2] = beta * g;
        let wider = if opening[0] >= opening[1] { 0 } else { 1 };
        if status[wider] == Status::Softening && opening[wider] > largest {
            let (value, rate) = self.shear_factor(opening[wider]);
            beta = value;
            tangent[2] = de[wider].map(|d| g * gamma * rate * d);
            tangent[2][2] += beta * g;
        }
        Some(Solution {
            stress: [normal[0], normal[1], beta * g * gamma],
            opening,
            multiplier: 0.0,
            flow: [0.0; 3],
            beta,
            tangent,
        })
    }
}
