//! A step by the method of Hilber, Hughes & Taylor.

/// Iterations of a step.
pub(super) const ITERATIONS: usize = 120;

/// −α of Hilber, Hughes & Taylor 1977: how much the forces at the beginning of a step weigh in its equilibrium. The trapezoidal rule (0) lets the rotation, which
/// has almost no inertia, oscillate from step to step. This weight halves that oscillation in each step and takes less than 1e-5 of the amplitude of a vibration
/// of 0.3 s per step of 1 ms.
pub(super) const BEGIN: f64 = 1.0 / 3.0;
/// γ and β of the method of second order.
pub(super) const GAMMA: f64 = 0.5 + BEGIN;
pub(super) const BETA: f64 = 0.25 * (1.0 + BEGIN) * (1.0 + BEGIN);

/// Velocity and displacement at the end of a step without the acceleration there.
pub(super) fn predicted(x: &[f64; 3], h: f64) -> [f64; 2] {
    [x[0] + h * x[1] + h * h * (0.5 - BETA) * x[2], x[1] + h * (1.0 - GAMMA) * x[2]]
}

/// A motion at the end of a step with the acceleration at the instant of the forces.
pub(super) fn moved(x: &[f64; 3], acceleration: f64, h: f64) -> [f64; 3] {
    let [place, velocity] = predicted(x, h);
    [place + BETA * h * h * acceleration, velocity + GAMMA * h * acceleration, acceleration]
}
