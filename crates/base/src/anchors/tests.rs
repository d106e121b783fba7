//! Anchors against closed forms.

use super::*;
use crate::history::{Body, BodyMode, Run, march};
use crate::{Curve, Point};

const RADIUS: f64 = 10.0;
const WEIGHT: f64 = 15e3;

/// A rim on hard ground without a plate that holds it down: K w where it presses, nothing where it is lifted. The toe is short.
fn bare(largest: f64) -> (Rocking, Law) {
    let point = |uplift: f64| Point {
        uplift,
        hold_down: 1e10 * uplift.min(0.0),
        rotation: 0.0,
        rim_moment: 0.0,
        axial_force: 0.0,
        lifted_width: 0.0,
        plastic_rotation: 0.0,
    };
    let pressed = (0..=60).map(|i| -0.05 * 0.8_f64.powi(i));
    let curve = Curve::through(pressed.chain([0.0, 0.1, 0.3, 0.6]).map(point).collect());
    let rocking = Rocking::new(RADIUS, WEIGHT, vec![(1e3, curve)]).unwrap();
    let law = Law::new(&rocking, largest).unwrap();
    (rocking, law)
}

fn bolts() -> Anchors {
    Anchors {
        count: 24,
        stiffness: 80e6,
        yield_force: 60e3,
        gap: 0.0,
        rupture: None,
    }
}

/// Stretched to 5 δ_y, released and stretched to 7 δ_y with a play of 1 mm: N_y is reached at g + δ_y, the way back is elastic, and the
/// plastic elongation is what went beyond. Exact to rounding.
#[test]
fn an_anchor_goes_its_cycle() {
    let anchors = Anchors { gap: 1e-3, ..bolts() };
    let (k, n) = (anchors.stiffness, anchors.yield_force);
    let elastic = n / k;
    assert_eq!(anchors.force(0.9e-3, 0.0, false), (0.0, 0.0));
    let (force, stiffness) = anchors.force(1e-3 + 0.5 * elastic, 0.0, false);
    assert!((force / n - 0.5).abs() < 1e-12 && stiffness == k);
    assert_eq!(anchors.force(1e-3 + 5.0 * elastic, 0.0, false), (n, 0.0));
    let plastic = 4.0 * elastic;
    let back = anchors.force(1e-3 + 4.25 * elastic, plastic, false).0;
    assert!((back / n - 0.25).abs() < 1e-9, "{back}");
    assert_eq!(anchors.force(1e-3 + 3.9 * elastic, plastic, false).0, 0.0);
    assert_eq!(anchors.force(1.0, plastic, true).0, 0.0);
}

/// All anchors yield and the foot turns about its toe: M = R (n N_y + W). The arc of the toe and the strips' own pull are less than 1 %.
#[test]
fn a_ring_that_yields_has_its_moment() {
    let (rocking, law) = bare(0.01);
    let ring = Ring::new(bolts(), &rocking, &law).unwrap();
    let mut state = ring.unstretched();
    let weight = std::f64::consts::TAU * RADIUS * WEIGHT;
    for psi in [5e-3, -5e-3] {
        let pull = ring.pull(psi, 0.0, &state);
        let moment = law.respond(psi, 0.0, 0.0, &[]).moment + pull.response.moment;
        let all = 24.0 * 60e3;
        // The one at the toe is slack.
        assert!(pull.total > 0.95 * all && pull.total <= all, "{pull:?}");
        let expected = psi.signum() * RADIUS * (all + weight);
        assert!((moment / expected - 1.0).abs() < 1e-2, "{moment} {expected}");
        let cost = ring.commit(psi, pull.centre, &mut state);
        assert!(cost.lost > 0.0 && !cost.breaks);
        state = ring.unstretched();
    }
}

/// The tangent is the slope of the moment.
#[test]
fn the_tangent_is_that_of_the_moment() {
    let (rocking, law) = bare(0.01);
    let ring = Ring::new(bolts(), &rocking, &law).unwrap();
    let state = ring.unstretched();
    for psi in [1.13e-4, 4.1e-4, -8.3e-4] {
        let h = 1e-8;
        let at = |psi: f64| ring.pull(psi, 0.0, &state).response;
        let slope = (at(psi + h).moment - at(psi - h).moment) / (2.0 * h);
        let found = at(psi).tangent;
        assert!((found / slope - 1.0).abs() < 1e-4, "{psi}: {found} {slope}");
    }
}

fn impulsive() -> Body {
    let (mass, height, omega) = (1.2e6_f64, 5.0, 25.0);
    Body {
        modes: vec![BodyMode {
            omega,
            damping: 0.02,
            translation: mass.sqrt(),
            rotation: height * mass.sqrt(),
            pressure: 0.0,
        }],
        mass,
        first_moment: mass * height,
        second_moment: mass * height * height,
    }
}

fn shaken(ring: &Ring, law: &Law, step: f64) -> crate::history::History {
    let n = (6.0 / step) as usize;
    let ground: Vec<f64> = (0..n)
        .map(|i| i as f64 * step)
        .map(|t| 2.5 * ((15.0 * t).sin() + (23.0 * t).sin()))
        .collect();
    march(&Run {
        body: &impulsive(),
        law: Some(law),
        ring: Some(ring),
        hysteretic: 0.0,
        dashpot: 0.0,
        friction: None,
        rigid_pressure: [0.0; 2],
        step,
        ground: &ground,
    })
    .unwrap()
}

/// Anchors that yield: the balance closes within 1e-3 of the input, the force never exceeds N_y, and the loss is N_y times what they stretch.
#[test]
fn the_energy_of_yielding_anchors_closes() {
    let (rocking, law) = bare(0.02);
    let ring = Ring::new(bolts(), &rocking, &law).unwrap();
    // A bare rim on rock asks for short steps: at 0.5 ms 0.0037 without anchors.
    let history = shaken(&ring, &law, 2.5e-4);
    let most = history.anchor_force.iter().copied().fold(0.0, f64::max);
    assert!(history.rotation.iter().all(|psi| psi.abs() < 0.02));
    assert_eq!(most, 60e3);
    assert!(history.balance < 1e-3, "{}", history.balance);
    let stretched: f64 = (ring.places().iter().zip(&history.bolts.plastic))
        .map(|((_, number), plastic)| number * plastic * 60e3)
        .sum();
    assert!((history.energy.anchors / stretched - 1.0).abs() < 1e-9);
    assert!(history.energy.anchors > 0.02 * history.energy.input);
}

/// Broken ones pull no more.
#[test]
fn anchors_break_at_their_elongation() {
    let (rocking, law) = bare(0.02);
    let short = Anchors {
        rupture: Some(2e-3),
        ..bolts()
    };
    let ring = Ring::new(short, &rocking, &law).unwrap();
    let mut state = ring.unstretched();
    let pull = ring.pull(3e-3, 0.0, &state);
    assert!(ring.commit(3e-3, pull.centre, &mut state).breaks);
    let broken = state.broken.iter().filter(|b| **b).count();
    assert!(broken > 0 && broken < state.broken.len());
    assert!(ring.pull(3e-3, 0.0, &state).total < pull.total);
}

#[test]
fn anchors_without_strength_are_refused() {
    let (rocking, law) = bare(0.001);
    for bad in [
        Anchors {
            yield_force: 0.0,
            ..bolts()
        },
        Anchors {
            stiffness: f64::NAN,
            ..bolts()
        },
        Anchors { gap: -1e-3, ..bolts() },
        Anchors { count: 0, ..bolts() },
    ] {
        assert!(Ring::new(bad, &rocking, &law).is_err(), "{bad:?}");
    }
}
