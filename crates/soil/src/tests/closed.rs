//! Isolated bodies against closed forms under a constant acceleration of the ground.

use super::{ground, pendulum, rubber};
use crate::isolated::{History, Mode, Run, march};
use crate::isolator::{Friction, Isolator};

const MASS: f64 = 2e5;
const GRAVITY: f64 = 10.0;

/// The response to a ground that accelerates by `a` along x and −2a along y.
fn pushed(modes: &[Mode], isolators: &[Isolator], a: f64, step: f64, samples: usize) -> History {
    march(&Run {
        mass: MASS,
        modes,
        isolators,
        gravity: GRAVITY,
        step,
        parts: 2,
        ground: &vec![[a, -2.0 * a]; samples],
        vertical: &[],
        more: &[],
    })
    .unwrap()
}

fn close(found: f64, wanted: f64, tolerance: f64) {
    assert!((found / wanted - 1.0).abs() < tolerance, "{found}, not {wanted}");
}

/// The first peak of an oscillator after a step of the load: (a/ω²) (1 + exp(−π ξ/√(1 − ξ²))). A rigid body on elastomer, and a mode on an isolator that
/// does not move; 400 steps to a period.
#[test]
fn step_responses() {
    let (omega, xi, a) = (5.0, 0.1, 1.5);
    let wanted = |xi: f64| 1.0 + (-std::f64::consts::PI * xi / (1.0_f64 - xi * xi).sqrt()).exp();
    let peak = |values: &[[f64; 2]], c: usize| values.iter().fold(0.0_f64, |most, v| most.max(v[c].abs()));
    let step = std::f64::consts::TAU / omega / 200.0;
    let elastomer = |stiffness, damping| Isolator::Elastomer { stiffness, damping };
    let found = pushed(&[], &[elastomer(MASS * omega * omega, xi)], a, step, 150);
    let mode = Mode { mass: 1e5, omega, damping: xi };
    let fixed = pushed(&[mode], &[elastomer(1e14, 0.0)], a, step, 150);
    let of_mode: Vec<[f64; 2]> = fixed.modes[0].iter().map(|m| m.displacement).collect();
    for c in 0..2 {
        let share = [1.0, 2.0][c] * a / (omega * omega);
        close(peak(&found.displacement, c), share * wanted(xi), 1e-3);
        close(peak(&of_mode, c), share * wanted(xi), 1e-3);
    }
}

/// A block slides under a − μ g along the push, √5 a for both components; rubber beyond yielding has the force K₂ d + Q.
#[test]
fn sliding_blocks() {
    let flat = Isolator::FrictionPendulum { radius: 1e9, friction: Friction::constant(0.06), slip: 1e-9 };
    let a = 1.0;
    let found = pushed(&[], &[flat], a, 0.001, 1001);
    let size = |v: &[f64; 2]| v[0].hypot(v[1]);
    let way = 0.5 * (5.0_f64.sqrt() * a - 0.6);
    close(size(found.displacement.last().unwrap()), way, 1e-3);
    close(size(found.force.last().unwrap()), 0.06 * MASS * GRAVITY, 1e-6);
    assert!(found.displacement.last().unwrap()[0] < 0.0);

    // Rate 0.06 − 0.03 e^{−50 v}: at a metre a second the friction is the fast one, and half of what falls is left at ln 2/50 m/s.
    let falls = Isolator::FrictionPendulum {
        radius: 1e9,
        friction: Friction { fast: 0.06, slow: 0.03, rate: 50.0 },
        slip: 1e-9,
    };
    let found = pushed(&[], &[falls], a, 1e-3, 40);
    let step = 5e-4;
    for i in [3, 10, 20, 70] {
        let along = |i: usize| size(&found.displacement[i]);
        let speed = (along(i + 1) - along(i - 1)) / (2.0 * step);
        let wanted = (0.06 - 0.03 * (-50.0 * speed).exp()) * MASS * GRAVITY;
        close(size(&found.force[i]), wanted, 1e-2);
    }

    // Until it turns, rubber is pushed along one line.
    let found = pushed(&[], &[rubber(1.0)], 2.0, 0.001, 200);
    for (d, f) in found.displacement.iter().zip(&found.force).skip(1) {
        let d = size(d);
        let wanted = if d < 5e5 / 5.4e7 { 6e7 * d } else { 6e6 * d + 5e5 };
        close(size(f), wanted, 1e-9);
    }
}

/// A damper alone reaches the speed at which C v^α = M a.
#[test]
fn terminal_speeds() {
    for exponent in [0.5, 1.0, 2.0] {
        let damper = Isolator::Damper { coefficient: 4e5, exponent };
        let found = pushed(&[], &[damper], 1.0, 0.02, 2000);
        let [.., before, last] = found.displacement[..] else { return };
        let speed = (last[0] - before[0]).hypot(last[1] - before[1]) / 0.01;
        close(speed, (0.5 * 5.0_f64.sqrt()).powf(1.0 / exponent), 1e-6);
    }
}

/// M A + Σ m_n ÿ_n + F = 0 and ÿ_n + A = −2 ξ_n ω_n ẏ_n − ω_n² y_n at each step, with the velocity of the trapezoidal rule; two yielding laws beside each
/// other, shaken along both axes.
#[test]
fn forces_are_in_equilibrium() {
    let mode = |mass, omega, damping| Mode { mass, omega, damping };
    let modes = [mode(6e4, 25.0, 0.05), mode(5e4, 3.0, 0.3)];
    let found = march(&Run {
        mass: MASS,
        modes: &modes,
        isolators: &[rubber(0.2), pendulum(0.06, 0.0)],
        gravity: GRAVITY,
        step: 0.01,
        parts: 2,
        ground: &ground(),
        vertical: &[],
        more: &[],
    })
    .unwrap();
    let most = found.force.iter().fold(0.0_f64, |most, f| most.max(f[0].hypot(f[1])));
    assert!(most > 1e5 && found.modes.len() == 2);
    for c in 0..2 {
        let mut velocities = [0.0; 2];
        for i in 1..found.force.len() {
            let a = found.acceleration[i][c];
            let mut sum = MASS * a + found.force[i][c];
            for ((m, states), velocity) in modes.iter().zip(&found.modes).zip(&mut velocities) {
                let [before, now] = [i - 1, i].map(|i| states[i].displacement[c]);
                *velocity = 2.0 * (now - before) / 0.005 - *velocity;
                let wanted = -2.0 * m.damping * m.omega * *velocity - m.omega * m.omega * now;
                assert!((states[i].acceleration[c] - wanted).abs() < 1e-7, "{i}: {wanted}");
                sum += m.mass * (states[i].acceleration[c] - a);
            }
            assert!(sum.abs() < 1e-7 * most, "{i}: {sum} {most}");
        }
    }
}
