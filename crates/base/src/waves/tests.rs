//! A wall that ovals: its period on springs, the rim that warps as its slow limit, and the round rim as its fast one.

use tank::{RimSupport, Shape};

use super::*;
use crate::curve::Curve;
use crate::march::Point;

/// Springs F = c w, c below the ground and above it, under the wall of a tank with R = 25 m and H = 9 m whose rim is free.
fn springs(slope: [f64; 2]) -> Rocking {
    let point = |uplift: f64| Point {
        uplift,
        hold_down: slope[usize::from(uplift > 0.0)] * uplift,
        axial_force: 0.0,
        rim_moment: 0.0,
        rotation: 0.0,
        plastic_rotation: 0.0,
        lifted_width: 0.0,
    };
    let curve = Curve::through([-1.0, -1e-5, 0.0, 1e-5, 1.0].map(point).to_vec());
    let steel = tank::reference::material(205e9, 0.3, 7850.0);
    let courses = [(2.5, 0.02), (2.5, 0.016), (5.0, 0.011)];
    let mut case = tank::reference::case(Shape::Cylinder { radius: 25.0 }, &courses, &steel, (1000.0, 9.0));
    case.tank.roof.holds = RimSupport::Free;
    let curves = [1e5, 1.5e5, 0.5e5].map(|p| (p, curve.clone()));
    Rocking::new(25.0, 1000.0, curves.to_vec()).unwrap().warping(Warping::of(&case))
}

fn walled(rocking: Rocking, damping: f64) -> (Rocking, Waves) {
    let (round, waves) = Waves::of(rocking, damping).unwrap();
    (round, waves.unwrap())
}

/// On even springs each wave has ω² = (K_n + 1/(1/c + H_n))/m_n and keeps its amplitude: steps of 1/200 of a period are off by (ω h)²/24 = 4e-5 of it.
#[test]
fn a_wave_has_its_period_and_keeps_its_amplitude() {
    let slope = 1e6;
    let (_, waves) = walled(springs([slope; 2]), 0.0);
    for n in [0, 1, 5] {
        let foot = 1.0 / (1.0 / slope + waves.warping.membrane(n));
        let period = std::f64::consts::TAU / ((waves.warping.ovalling(n) + foot) / waves.warping.mass(n)).sqrt();
        let step = period / 200.0;
        let mut ovals = waves.at_rest();
        ovals.place[n] = 1e-3;
        waves.response(&ovals, (0.0, 0.0)).unwrap();
        waves.end(&mut ovals, 0.0, step);
        ovals.velocity = [0.0; WAVES];
        for _ in 0..2000 {
            waves.begin(&mut ovals, step);
            waves.response(&ovals, (0.0, 0.0)).unwrap();
            waves.end(&mut ovals, 0.0, step);
        }
        // Ten periods: 4e-5 of 20 π is a phase of 0.0026, whose cosine is 1 − 3e-6.
        assert!((ovals.place[n] / 1e-3 - 1.0).abs() < 1e-4, "{n}: {}", ovals.place[n]);
        assert!(ovals.velocity[n].abs() < 0.01 * 1e-3 * std::f64::consts::TAU / period, "{n}: {}", ovals.velocity[n]);
    }
}

/// Held at a rotation under a suction, waves that are damped come to rest where the rim that warps has its equilibrium, on the side that lifts; at once
/// the base is that of a round rim. 1e-3 for half the panels and the table of pressures.
#[test]
fn slow_and_fast_are_the_rims_that_warp_and_stay_round() {
    let free = springs([1e7, 1e6]);
    let (round, waves) = walled(free.clone(), 0.5);
    for side in [1.0, -1.0] {
        let (psi, suction) = (side * 4e-4, side * 1e4);
        let mut ovals = waves.at_rest();
        let fast = waves.response(&ovals, (psi, suction)).unwrap();
        let wanted = round.at(4e-4, 1e4).unwrap().moment;
        assert!((side * fast.moment / wanted - 1.0).abs() < 1e-3, "{fast:?} {wanted}");
        let step = 5e-3;
        for _ in 0..20_000 {
            waves.begin(&mut ovals, step);
            waves.response(&ovals, (psi, suction)).unwrap();
            waves.end(&mut ovals, suction, step);
        }
        let slow = waves.response(&ovals, (psi, suction)).unwrap();
        let turn = free.at(4e-4, 1e4).unwrap();
        assert!((side * slow.moment / turn.moment - 1.0).abs() < 1e-3, "{slow:?} {turn:?}");
        let (centre, found) = ovals.foot(psi);
        assert!((centre / turn.centre - 1.0).abs() < 1e-3, "{centre} {turn:?}");
        for (a, b) in found.iter().zip(turn.waves) {
            assert!((a - b).abs() < 1e-3 * turn.waves[0].abs(), "{found:?} {turn:?}");
        }
        assert!(slow.moment.abs() < 0.98 * fast.moment.abs(), "{slow:?} {fast:?}");
    }
}

/// The derivative of the moment, that of a state close by: within 1 %.
#[test]
fn the_tangent_is_the_slope() {
    let (_, waves) = walled(springs([1e7, 1e6]), 0.0);
    let mut ovals = waves.at_rest();
    ovals.place[1] = 2e-3;
    let at = |psi: f64| waves.response(&ovals, (psi, 2e4)).unwrap();
    let slope = (at(4.001e-4).moment - at(3.999e-4).moment) / 2e-7;
    assert!((at(4e-4).tangent / slope - 1.0).abs() < 0.01, "{} {slope}", at(4e-4).tangent);
}

/// With steps of twice the limit of central differences for every wave it stays where damping takes it.
#[test]
fn a_wave_that_is_faster_than_the_steps_stays_bounded() {
    let (_, waves) = walled(springs([1e6; 2]), 0.02);
    let slowest = (0..WAVES).map(|n| (waves.warping.ovalling(n) / waves.warping.mass(n)).sqrt());
    let step = 4.0 / slowest.fold(f64::INFINITY, f64::min);
    let mut ovals = waves.at_rest();
    ovals.place = [1e-3; WAVES];
    for _ in 0..500 {
        waves.begin(&mut ovals, step);
        waves.response(&ovals, (0.0, 0.0)).unwrap();
        waves.end(&mut ovals, 0.0, step);
        // The first step starts without an acceleration, which adds its square to the amplitude: less than ω h.
        assert!(ovals.place.iter().all(|a| a.abs() < 1.5e-3), "{:?}", ovals.place);
    }
}
