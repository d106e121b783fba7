//! The modes of the body in a march: one array a quantity, and what a step of one length makes of them.

use super::body::{Body, BodyMode};
use super::scheme::{BEGIN, BETA, GAMMA};

/// Sums over the modes in a step: constant part, and the factors of A and ψ̈.
#[derive(Clone, Copy, Debug, Default)]
pub(super) struct Sums {
    pub(super) turn: [f64; 3],
    pub(super) shift: [f64; 3],
    pub(super) pressure: [f64; 3],
}

/// Motion of all modes, their forces, and the constants of a step.
#[derive(Clone, Debug)]
pub(super) struct Modes {
    /// Γ, Γ^ψ and the pressure at the rim of each.
    translation: Vec<f64>,
    rotation: Vec<f64>,
    pressure: Vec<f64>,
    /// ω² and 2 ξ ω.
    stiffness: Vec<f64>,
    damping: Vec<f64>,
    /// What velocity and acceleration at the beginning of the step add to the force without the accelerations of the step.
    by_velocity: Vec<f64>,
    by_acceleration: Vec<f64>,
    /// 1 over the inertia in a step.
    give: Vec<f64>,
    /// q, q̇, q̈.
    place: Vec<f64>,
    velocity: Vec<f64>,
    acceleration: Vec<f64>,
    /// The force without the accelerations of the step.
    force: Vec<f64>,
    /// Factors of A and ψ̈ in the sums of a step.
    factors: Sums,
    step: f64,
}

/// Sums of a state: energy, power of the damping, and Σ Γ q̇, Σ Γ^ψ q̇.
#[derive(Clone, Copy, Debug, Default)]
pub(super) struct Motion {
    pub(super) energy: f64,
    pub(super) viscous: f64,
    pub(super) shift: f64,
    pub(super) turn: f64,
}

impl Modes {
    /// At rest.
    ///
    /// * `h`: length of a step [s]
    /// * `rigid_pressure`: as in [`super::Run`]
    pub(super) fn new(body: &Body, h: f64, rigid_pressure: [f64; 2]) -> Modes {
        let end = 1.0 - BEGIN;
        let of = |value: fn(&BodyMode) -> f64| body.modes.iter().map(value).collect::<Vec<f64>>();
        let (stiffness, damping) = (of(|m| m.omega * m.omega), of(|m| 2.0 * m.damping * m.omega));
        let both = |value: &dyn Fn(f64, f64) -> f64| -> Vec<f64> {
            stiffness.iter().zip(&damping).map(|(k, c)| value(*k, *c)).collect()
        };
        let rest = vec![0.0; body.modes.len()];
        let mut modes = Modes {
            translation: of(|m| m.translation),
            rotation: of(|m| m.rotation),
            pressure: of(|m| m.pressure),
            by_velocity: both(&|k, c| c + end * k * h),
            by_acceleration: both(&|k, c| end * (c * h * (1.0 - GAMMA) + k * h * h * (0.5 - BETA))),
            give: both(&|k, c| 1.0 / (1.0 + end * (c * GAMMA * h + k * BETA * h * h))),
            stiffness,
            damping,
            place: rest.clone(),
            velocity: rest.clone(),
            acceleration: rest.clone(),
            force: rest,
            factors: Sums::default(),
            step: h,
        };
        modes.factors = modes.factors(body, rigid_pressure);
        modes
    }

    fn factors(&self, body: &Body, rigid_pressure: [f64; 2]) -> Sums {
        let mut sums = Sums {
            turn: [0.0, body.first_moment, body.second_moment],
            shift: [0.0, body.mass, body.first_moment],
            pressure: [0.0, rigid_pressure[0], rigid_pressure[1]],
        };
        for (i, give) in self.give.iter().enumerate() {
            for (way, row) in [&self.translation, &self.rotation].into_iter().enumerate() {
                let part = row[i] * give;
                sums.turn[way + 1] -= self.rotation[i] * part;
                sums.shift[way + 1] -= self.translation[i] * part;
                sums.pressure[way + 1] -= self.pressure[i] * part;
            }
        }
        sums
    }

    /// Sets the body in motion: the ground accelerates at once.
    pub(super) fn begin(&mut self, ground: f64) {
        let own = self.acceleration.iter_mut().zip(&self.translation);
        own.for_each(|(a, translation)| *a = -translation * ground);
    }

    /// Sums over the modes in the step that begins.
    pub(super) fn sums(&mut self) -> Sums {
        let n = self.place.len();
        let (x, v, a) = (&self.place[..n], &self.velocity[..n], &self.acceleration[..n]);
        let (k, c, d) = (&self.stiffness[..n], &self.by_velocity[..n], &self.by_acceleration[..n]);
        let force = &mut self.force[..n];
        for i in 0..n {
            force[i] = k[i] * x[i] + c[i] * v[i] + d[i] * a[i];
        }
        let (give, turn, shift) = (&self.give[..n], &self.rotation[..n], &self.translation[..n]);
        let pressure = &self.pressure[..n];
        let mut sums = self.factors;
        for i in 0..n {
            let part = force[i] * give[i];
            sums.turn[0] -= turn[i] * part;
            sums.shift[0] -= shift[i] * part;
            sums.pressure[0] -= pressure[i] * part;
        }
        sums
    }

    /// Moves to the end of the step with A and ψ̈, after [`Modes::sums`].
    pub(super) fn advance(&mut self, [a, b]: [f64; 2]) {
        let (n, h) = (self.place.len(), self.step);
        let (x, v, q) = (&mut self.place[..n], &mut self.velocity[..n], &mut self.acceleration[..n]);
        let (give, turn, shift) = (&self.give[..n], &self.rotation[..n], &self.translation[..n]);
        let force = &self.force[..n];
        for i in 0..n {
            let new = -(shift[i] * a + turn[i] * b + force[i]) * give[i];
            x[i] += h * v[i] + h * h * ((0.5 - BETA) * q[i] + BETA * new);
            v[i] += h * ((1.0 - GAMMA) * q[i] + GAMMA * new);
            q[i] = new;
        }
    }

    /// Takes over what a change of A over the last `rest` [s] of the step adds: `taken` is that of displacement and velocity, `jump` that of
    /// the acceleration [m/s²].
    pub(super) fn take(&mut self, rest: f64, taken: f64, jump: f64) {
        for i in 0..self.place.len() {
            let own = self.translation[i];
            self.place[i] += 0.5 * own * taken * rest * rest;
            self.velocity[i] += own * taken * rest;
            self.acceleration[i] += own * jump;
        }
    }

    /// Sums of the state.
    pub(super) fn motion(&self) -> Motion {
        let n = self.place.len();
        let (x, v, k, c) = (&self.place[..n], &self.velocity[..n], &self.stiffness[..n], &self.damping[..n]);
        let (turn, shift) = (&self.rotation[..n], &self.translation[..n]);
        let mut sums = Motion::default();
        for i in 0..n {
            let square = v[i] * v[i];
            sums.energy += 0.5 * (square + k[i] * x[i] * x[i]);
            sums.viscous += c[i] * square;
            sums.shift += shift[i] * v[i];
            sums.turn += turn[i] * v[i];
        }
        sums
    }
}
