//! Time steps of a linear system with one-sided joints, their force taken at the end of the step: dense matrices and sets of
//! open joints, to check the marches of `fem` on its joint elements with.
//!
//! ```text
//! M (v₁ − v₀) + h [K (x₀ + h/4 (v₀ + v₁)) + C (v₀ + v₁)/2 − p + Σ r_j F_j(x₁)] = 0 ,   x₁ = x₀ + h/2 (v₀ + v₁)
//!
//! joint    e = r·x closing of the joint,  F = k e            as long as the total force N + s·x + F ≥ 0
//!                                         F = −(N + s·x)     if tension: the joint is open
//! ```
//!
//! N is the force that presses the joint at x = 0 (its share of a static pressure), s·x its change by the motion itself (a liquid
//! particle that moves down gets under more pressure). With s the condition is that of the displaced particle; without, that
//! of the place in the tank, which is wrong near a surface that moves. s·x is taken at the beginning of the step.
//!
//! The trapezoidal rule on a stiff one-sided penalty gains energy at every touch and chatters endlessly. The force at the end
//! of the step never gains any (a closed spring loses ½ k (e₁ − e₀)² in each step, a closing or opening one more) and leaves
//! the smooth motion of a closed joint undamped: there it is a multiplier.
//!
//! Between two changes of the set everything is linear: the equation is solved for a set, the set taken from the result, until
//! it repeats.
//!
//! Source: Moreau 1999; Jean 1999 (θ = 1 for the joint, ½ for the rest).

use fem::analysis::AnalysisError;
use fem::linalg::{Cholesky, Matrix};

/// A sparse row: (unknown, coefficient).
pub type SparseRow = Vec<(usize, f64)>;

/// A one-sided joint.
#[derive(Clone, Debug, PartialEq)]
pub struct Joint {
    /// r: closing of the joint; positive where pressed more than at rest.
    pub closing: SparseRow,
    /// k [N/m], > 0.
    pub stiffness: f64,
    /// N [N], the force that presses the joint at rest.
    pub preload: f64,
    /// s: its change by the motion [N/m].
    pub relief: SparseRow,
}

/// Whether joints may open.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Opening {
    /// Never: F = k e.
    Bonded,
    /// Under tension.
    Unilateral,
}

/// A linear system with joints.
#[derive(Clone, Debug, PartialEq)]
pub struct Jointed {
    /// M, positive definite.
    pub mass: Matrix,
    /// C.
    pub damping: Matrix,
    /// K without the joints.
    pub stiffness: Matrix,
    /// Joints.
    pub joints: Vec<Joint>,
    /// Their behaviour.
    pub opening: Opening,
}

/// The end of a step.
#[derive(Clone, Copy, Debug)]
pub struct Moment<'a> {
    /// Number of the step, from 1.
    pub step: usize,
    /// Time [s].
    pub time: f64,
    /// x.
    pub displacement: &'a [f64],
    /// v.
    pub velocity: &'a [f64],
    /// Total force of each joint, N + s·x + F ≥ 0 (bonded: any sign) [N].
    pub contact: &'a [f64],
    /// Which joints are open.
    pub open: &'a [bool],
}

/// How a march went.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct MarchReport {
    /// Largest number of sets tried in a step.
    pub most_sets: usize,
    /// Steps in which a joint was open.
    pub steps_open: usize,
    /// Changes of the set from step to step.
    pub changes: usize,
}

/// x₁, v₁ and the force of each joint.
type End = (Vec<f64>, Vec<f64>, Vec<f64>);

/// Sets tried in one step until it has failed.
const SETS: usize = 60;

fn dot(row: &SparseRow, x: &[f64]) -> f64 {
    row.iter().map(|&(i, c)| c * x[i]).sum()
}

impl Jointed {
    /// Marches `steps` steps of `h` [s] from x = v = 0 under `load(t)`, taken in the middle of each step (t from 0; one entry an
    /// unknown); `each` sees the end of every step.
    ///
    /// Errors: sizes that differ, a step that is not positive, an effective matrix that is not positive definite, a set of
    /// open joints that does not repeat.
    pub fn march(
        &self,
        h: f64,
        steps: usize,
        load: &dyn Fn(f64) -> Vec<f64>,
        mut each: impl FnMut(Moment<'_>),
    ) -> Result<MarchReport, AnalysisError> {
        let n = self.mass.rows;
        for (option, found) in [
            ("rows of the damping matrix", self.damping.rows),
            ("rows of the stiffness matrix", self.stiffness.rows),
            ("load", load(0.0).len()),
        ] {
            if found != n {
                return Err(AnalysisError::Option {
                    option,
                    found: format!("{found} entries"),
                    allowed: format!("{n}, one an equation"),
                });
            }
        }
        if !(h > 0.0 && h.is_finite()) {
            return Err(AnalysisError::Option { option: "time step", found: format!("{h} s"), allowed: "> 0".into() });
        }
        let mut base = self.mass.clone();
        for ((m, c), k) in base.data.iter_mut().zip(&self.damping.data).zip(&self.stiffness.data) {
            *m += 0.5 * h * c + 0.25 * h * h * k;
        }
        let mut factor: Option<(Vec<bool>, Cholesky)> = None;
        let (mut x, mut v) = (vec![0.0; n], vec![0.0; n]);
        let mut open = vec![false; self.joints.len()];
        let mut report = MarchReport::default();
        for step in 1..=steps {
            let time = h * step as f64;
            // Everything but the joints, with v₁ left out.
            let p = load(time - 0.5 * h);
            let half: Vec<f64> = x.iter().zip(&v).map(|(x, v)| x + 0.25 * h * v).collect();
            let (elastic, viscous, momentum) =
                (self.stiffness.times(&half), self.damping.times(&v), self.mass.times(&v));
            let right: Vec<f64> = (0..n).map(|i| momentum[i] + h * (p[i] - elastic[i] - 0.5 * viscous[i])).collect();
            let pressed: Vec<f64> = self.joints.iter().map(|j| j.preload + dot(&j.relief, &x)).collect();
            let before = open.clone();
            let (tried, (x1, v1, mut contact)) =
                self.close(&base, h, time, [&x, &v], &right, &pressed, &mut open, &mut factor)?;
            if !x1.iter().chain(&v1).all(|u| u.is_finite()) {
                return Err(AnalysisError::NotFinite { time, cause: "the load, or a stiffness that is not positive" });
            }
            (x, v) = (x1, v1);
            for (force, &is_open) in contact.iter_mut().zip(&open) {
                if is_open {
                    *force = 0.0;
                }
            }
            report.most_sets = report.most_sets.max(tried);
            report.steps_open += usize::from(open.contains(&true));
            report.changes += usize::from(before != open);
            each(Moment { step, time, displacement: &x, velocity: &v, contact: &contact, open: &open });
        }
        Ok(report)
    }

    /// End of a step, x₁ and v₁ with the force of each joint, on the set of open joints that repeats; the number of sets tried.
    #[expect(clippy::too_many_arguments, reason = "the step's own values, with which its caller continues")]
    fn close(
        &self,
        base: &Matrix,
        h: f64,
        time: f64,
        [x, v]: [&Vec<f64>; 2],
        right: &[f64],
        pressed: &[f64],
        open: &mut Vec<bool>,
        factor: &mut Option<(Vec<bool>, Cholesky)>,
    ) -> Result<(usize, End), AnalysisError> {
        let n = right.len();
        let mut tried = 0;
        loop {
            tried += 1;
            if tried > SETS {
                return Err(AnalysisError::Option {
                    option: "one-sided joints",
                    found: format!("no repeating set of open joints in {SETS} trials at t = {time:.4} s"),
                    allowed: "a smaller time step".into(),
                });
            }
            if factor.as_ref().is_none_or(|(set, _)| *set != *open) {
                *factor = Some((open.clone(), self.factor(base, h, open)?));
            }
            let Some((_, solver)) = &*factor else { continue };
            let mut b = right.to_vec();
            for ((joint, &is_open), pressed) in self.joints.iter().zip(&*open).zip(pressed) {
                let force = if is_open {
                    -pressed
                } else {
                    joint.stiffness * (dot(&joint.closing, x) + 0.5 * h * dot(&joint.closing, v))
                };
                joint.closing.iter().for_each(|&(i, c)| b[i] -= h * force * c);
            }
            let v1 = solver.solve_vector(&b);
            let x1: Vec<f64> = (0..n).map(|i| x[i] + 0.5 * h * (v[i] + v1[i])).collect();
            let total = |(joint, pressed): (&Joint, &f64)| pressed + joint.stiffness * dot(&joint.closing, &x1);
            let contact: Vec<f64> = self.joints.iter().zip(pressed).map(total).collect();
            let set: Vec<bool> = match self.opening {
                Opening::Bonded => vec![false; contact.len()],
                Opening::Unilateral => contact.iter().map(|&f| f < 0.0).collect(),
            };
            if set == *open {
                return Ok((tried, (x1, v1, contact)));
            }
            *open = set;
        }
    }

    /// Factor of M + h/2 C + h²/4 K + h²/2 Σ_closed k r rᵀ.
    fn factor(&self, base: &Matrix, h: f64, open: &[bool]) -> Result<Cholesky, AnalysisError> {
        let mut a = base.clone();
        for (joint, _) in self.joints.iter().zip(open).filter(|(_, open)| !**open) {
            let weight = 0.5 * h * h * joint.stiffness;
            for &(j, cj) in &joint.closing {
                for &(i, ci) in &joint.closing {
                    a.add(i, j, weight * ci * cj);
                }
            }
        }
        Cholesky::factor(&a)
            .map_err(|source| AnalysisError::Linalg { what: "the effective matrix of a step with joints", source })
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn scalar(value: f64) -> Matrix {
        let mut m = Matrix::zeros(1, 1);
        m.add(0, 0, value);
        m
    }

    /// A ball of 2 kg above (x < 0) or on (x > 0) a floor of stiffness k.
    fn ball(k: f64, preload: f64) -> Jointed {
        Jointed {
            mass: scalar(2.0),
            damping: scalar(0.0),
            stiffness: scalar(0.0),
            joints: vec![Joint { closing: vec![(0, 1.0)], stiffness: k, preload, relief: Vec::new() }],
            opening: Opening::Unilateral,
        }
    }

    /// Lifted by a force, the ball rises as in free flight, falls back when the force ends, and never gains energy, whatever
    /// the penalty and the step.
    #[test]
    fn a_ball_bounces_without_gaining_energy() {
        let weight = 2.0 * 9.81;
        for (k, h) in [(1e4, 1e-3), (1e6, 1e-3), (1e8, 1e-3), (1e6, 5e-3), (1e6, 2.5e-4)] {
            // x = 0 at rest: pressed by the weight, which is the preload. Lift of 30 N for 0.2 s.
            let system = ball(k, weight);
            let lift = 30.0;
            let steps = (2.0 / h) as usize;
            let mut highest = 0.0_f64;
            let mut after = f64::INFINITY;
            let report = system
                .march(h, steps, &|t| vec![if t < 0.2 { -lift } else { 0.0 }], |m| {
                    let (x, v) = (m.displacement[0], m.velocity[0]);
                    highest = highest.max(-x);
                    if m.time > 0.2 + h {
                        let spring = if m.open[0] { 0.0 } else { 0.5 * k * (x + weight / k).powi(2) };
                        let energy = v * v - weight * x + spring;
                        assert!(energy <= after + 1e-9 * weight, "k {k:e} h {h}: {energy} after {after}");
                        after = energy;
                    }
                })
                .unwrap();
            // Upwards y: the floor pushes until it is unloaded at y = W/k, m ÿ = P − k y; then a = P/m − g up to 0.2 s; then
            // flight.
            let omega = (k / 2.0_f64).sqrt();
            let released = (1.0 - weight / lift).acos() / omega;
            let speed = lift / (2.0 * omega) * (omega * released).sin();
            let (a, t) = ((lift - weight) / 2.0, 0.2 - released);
            let end = speed + a * t;
            let exact = weight / k + speed * t + 0.5 * a * t * t + end * end / (2.0 * 9.81);
            // The release is damped by ω h or, unresolved, not seen: its speed moves the height by 0.3 s times as much. The top
            // of the flight falls between two steps: ½ g (h/2)².
            let allowed = 0.35 * speed * (omega * h).min(1.0) + 1.3 * h * h;
            assert!((highest - exact).abs() < allowed, "k {k:e} h {h}: {highest} {exact} {allowed}");
            assert!(report.steps_open > 0 && report.changes > 0);
        }
    }

    /// Free vibration of a plain spring: the part without joints is the trapezoidal rule.
    #[test]
    fn the_smooth_part_keeps_its_energy() {
        let mut system = ball(1.0, 0.0);
        system.joints.clear();
        system.stiffness = scalar(50.0);
        let mut energies = Vec::new();
        system
            .march(0.02, 500, &|t| vec![if t < 0.3 { 1.0 } else { 0.0 }], |m| {
                energies.push(m.velocity[0].powi(2) + 25.0 * m.displacement[0].powi(2))
            })
            .unwrap();
        let (first, last) = (energies[20], energies[499]);
        assert!((last / first - 1.0).abs() < 1e-12);
    }

    #[test]
    fn sizes_and_steps_are_checked() {
        let system = ball(1e4, 1.0);
        assert!(system.march(0.0, 1, &|_| vec![0.0], |_| {}).is_err());
        assert!(system.march(0.1, 1, &|_| vec![0.0; 2], |_| {}).is_err());
        let mut bad = ball(1.0, 0.0);
        bad.mass = scalar(-1.0);
        assert!(bad.march(0.1, 1, &|_| vec![0.0], |_| {}).is_err());
    }
}
