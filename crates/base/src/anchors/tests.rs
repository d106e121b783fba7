//! Tangent, rupture and refusals of anchors; their closed forms are rows of the verification manual (`base-anchors`).

use super::*;
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

/// The elongation grows on after an anchor has broken: its foot lifts by w₀ + ψ R, from rest and less the play.
#[test]
fn a_broken_anchor_would_stretch_on() {
    let (rocking, law) = bare(0.02);
    let played = Anchors {
        gap: 1e-3,
        rupture: Some(2e-3),
        ..bolts()
    };
    let ring = Ring::new(played, &rocking, &law).unwrap();
    let rest = law.turn(0.0, 0.0).centre;
    for (psi, centre) in [(5e-4, 1e-3), (-2e-3, 4e-3)] {
        let expected = centre + RADIUS * f64::abs(psi) - rest - 1e-3;
        assert!((ring.stretch(psi, centre) / expected - 1.0).abs() < 1e-12);
    }
    assert_eq!(ring.stretch(0.0, rest), 0.0);
}
