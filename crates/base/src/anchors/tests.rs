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
    Anchors { count: 24, stiffness: 80e6, yield_force: 60e3, gap: 0.0, rupture: None }
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
    let short = Anchors { rupture: Some(2e-3), ..bolts() };
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
        Anchors { yield_force: 0.0, ..bolts() },
        Anchors { stiffness: f64::NAN, ..bolts() },
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
    let played = Anchors { gap: 1e-3, rupture: Some(2e-3), ..bolts() };
    let ring = Ring::new(played, &rocking, &law).unwrap();
    let rest = law.turn(0.0, 0.0).centre;
    for (psi, centre) in [(5e-4, 1e-3), (-2e-3, 4e-3)] {
        let expected = centre + RADIUS * f64::abs(psi) - rest - 1e-3;
        assert!((ring.stretch(psi, centre) / expected - 1.0).abs() < 1e-12);
    }
    assert_eq!(ring.stretch(0.0, rest), 0.0);
}

/// Every anchor counts once: Σ 1 = n, Σ s = 0 and Σ s² = n/2 (n > 2) of n evenly spaced ones, an odd number as an even one.
#[test]
fn every_anchor_counts_once() {
    let (rocking, law) = bare(0.001);
    for count in [3, 4, 7, 24, 25] {
        let ring = Ring::new(Anchors { count, ..bolts() }, &rocking, &law).unwrap();
        let sum = |f: fn(f64) -> f64| ring.places().iter().map(|(s, number)| number * f(*s)).sum::<f64>();
        let n = count as f64;
        let found = [sum(|_| 1.0), sum(|s| s), sum(|s| s * s)];
        for (found, exact) in found.iter().zip([n, 0.0, n / 2.0]) {
            assert!((found - exact).abs() < 1e-12 * n, "{count}: {found} {exact}");
        }
    }
}

/// A ring that is lifted evenly by g + δ: nothing up to g, then n k δ; beyond the yield the rest stays, and n N_y times it is lost.
#[test]
fn the_gap_is_closed_before_an_anchor_pulls() {
    let (rocking, law) = bare(0.02);
    let (gap, Anchors { stiffness, .. }) = (2e-3, bolts());
    let ring = Ring::new(Anchors { gap, ..bolts() }, &rocking, &law).unwrap();
    let rest = law.turn(0.0, 0.0).centre;
    let mut state = ring.unstretched();
    let total = |stretch: f64, state: &Bolts| {
        let forces = ring.forces(0.0, rest + stretch, state);
        forces.zip(ring.places()).map(|(force, (_, number))| number * force).sum::<f64>()
    };
    assert_eq!(total(0.99 * gap, &state), 0.0);
    let own = 0.5e-3;
    assert!((total(gap + own, &state) / (24.0 * stiffness * own) - 1.0).abs() < 1e-9);
    let stored = ring.stored(0.0, rest + gap + own, &state);
    assert!((stored / (24.0 * 0.5 * stiffness * own * own) - 1.0).abs() < 1e-9);
    // It yields at N_y/k = 0.75 mm; 1 mm stays.
    let cost = ring.commit(0.0, rest + gap + 0.75e-3 + 1e-3, &mut state);
    assert!(!cost.breaks && (cost.lost / (24.0 * 60e3 * 1e-3) - 1.0).abs() < 1e-9);
    assert!(state.plastic.iter().all(|p| (p / 1e-3 - 1.0).abs() < 1e-9));
    assert_eq!(total(gap + 0.99e-3, &state), 0.0);
}

/// A base with play turns as far as the play without its anchors, and pulls less than one without beyond it.
#[test]
fn play_delays_the_pull_of_a_turning_base() {
    let (rocking, law) = bare(0.02);
    let played = Ring::new(Anchors { gap: 5e-3, ..bolts() }, &rocking, &law).unwrap();
    let tight = Ring::new(bolts(), &rocking, &law).unwrap();
    let pull = |ring: &Ring, psi: f64| ring.pull(psi, 0.0, &ring.unstretched()).total;
    // The heel lifts by at most 2 R ψ.
    let early = 0.9 * 5e-3 / (2.0 * RADIUS);
    assert!(pull(&played, early) == 0.0 && pull(&tight, early) > 0.0);
    assert!(pull(&played, 1e-3) > 0.0 && pull(&played, 1e-3) < pull(&tight, 1e-3));
}
