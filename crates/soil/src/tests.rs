//! Isolators beside each other, and those that depend on the velocity.

mod closed;
mod ground;

use crate::isolated::{History, Mode, Run, march, peak};
use crate::isolator::{Friction, Isolator};

const MODES: [Mode; 1] = [Mode { mass: 6e5, omega: 25.0, damping: 0.02 }];

/// A pulse that decays, 10 s at 10 ms, along both axes.
fn ground() -> Vec<[f64; 2]> {
    let at = |t: f64, w: f64| 4.0 * (w * t).sin() * (-0.3 * t).exp();
    (0..1000)
        .map(|i| {
            let t = 0.01 * f64::from(i);
            [at(t, 6.0), 0.6 * at(t, 4.3)]
        })
        .collect()
}

fn run(isolators: &[Isolator], vertical: &[f64]) -> Result<History, crate::SoilError> {
    march(&Run {
        mass: 1e6,
        modes: &MODES,
        isolators,
        gravity: 9.81,
        step: 0.01,
        parts: 4,
        ground: &ground(),
        vertical,
        more: &[],
    })
}

fn rubber(share: f64) -> Isolator {
    Isolator::LeadRubber { strength: 5e5 * share, initial_stiffness: 6e7 * share, yielded_stiffness: 6e6 * share }
}

fn pendulum(slow: f64, rate: f64) -> Isolator {
    Isolator::FrictionPendulum { radius: 2.0, friction: Friction { fast: 0.06, slow, rate }, slip: 1e-3 }
}

fn apart(a: &History, b: &History) -> f64 {
    let most = peak(&a.displacement);
    let pairs = a.displacement.iter().zip(&b.displacement);
    pairs.fold(0.0_f64, |m, (x, y)| m.max((x[0] - y[0]).hypot(x[1] - y[1]))) / most
}

/// Bearings of the same kind act as one of their sum: the Newton steps of several against the closed step of one.
#[test]
fn two_halves_are_a_whole() {
    let whole = run(&[rubber(1.0)], &[]).unwrap();
    let halves = run(&[rubber(0.25), rubber(0.75)], &[]).unwrap();
    assert!(apart(&whole, &halves) < 1e-9, "{}", apart(&whole, &halves));
}

/// A damper of α = 1 is the dashpot of an elastomer: c = 2 ξ √(K M).
#[test]
fn a_linear_damper_is_a_dashpot() {
    let stiffness = 6e6;
    let elastomer = |damping| Isolator::Elastomer { stiffness, damping };
    let damper = Isolator::Damper { coefficient: 0.2 * (stiffness * 1e6_f64).sqrt(), exponent: 1.0 };
    let one = run(&[elastomer(0.1)], &[]).unwrap();
    let two = run(&[elastomer(0.0), damper], &[]).unwrap();
    assert!(apart(&one, &two) < 1e-12);
}

/// The secants of dampers and of friction leave the balance of energy at rounding: forces of a step are those of its equation.
#[test]
fn isolators_that_depend_on_the_velocity_keep_the_balance() {
    let damper = |exponent| Isolator::Damper { coefficient: 3e5, exponent };
    for isolators in [
        vec![rubber(1.0), damper(0.5)],
        vec![rubber(1.0), damper(1.7)],
        vec![pendulum(0.03, 50.0)],
        vec![pendulum(0.03, 50.0), damper(0.4)],
    ] {
        let found = run(&isolators, &[]).unwrap();
        // The iterated speed is settled to 1e-10 of a step.
        assert!(found.energy.deviation().abs() < 1e-7, "{isolators:?} {:?}", found.energy);
        assert!(peak(&found.displacement) > 0.01);
    }
}

/// Without a difference between fast and slow friction the rate has no effect; less friction at rest moves the base further.
#[test]
fn friction_that_falls_at_rest_moves_the_base_further() {
    let constant = run(&[pendulum(0.06, 0.0)], &[]).unwrap();
    let same = run(&[pendulum(0.06, 50.0)], &[]).unwrap();
    assert_eq!(constant.displacement, same.displacement);
    let falls = run(&[pendulum(0.03, 50.0)], &[]).unwrap();
    assert!(peak(&falls.displacement) >= peak(&constant.displacement));
}

/// A pendulum's force follows its weight: a constant upward acceleration of the ground is more gravity.
#[test]
fn a_vertical_acceleration_adds_to_the_weight() {
    let heavy = run(&[pendulum(0.06, 0.0)], &vec![0.1 * 9.81; 1000]).unwrap();
    let Isolator::FrictionPendulum { friction, .. } = pendulum(0.06, 0.0) else { return };
    let stiffer = Isolator::FrictionPendulum {
        radius: 2.0 / 1.1,
        friction: Friction::constant(1.1 * friction.fast),
        slip: 1.1e-3,
    };
    let same = run(&[stiffer], &[]).unwrap();
    // The elastic slip of the stick: 1.1 μ N over the same stiffness.
    assert!(apart(&heavy, &same) < 1e-9, "{}", apart(&heavy, &same));
    assert!(run(&[pendulum(0.06, 0.0)], &[0.0; 3]).is_err());
}

#[test]
fn impossible_runs_are_errors() {
    assert!(run(&[], &[]).is_err());
    assert!(run(&[pendulum(0.07, 50.0)], &[]).is_err());
}
