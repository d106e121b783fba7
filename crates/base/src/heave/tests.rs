//! Heave against a rigid block, direct integration, and a foot without mass.

use std::f64::consts::TAU;

use crate::heave::Step;
use crate::history::{Body, BodyMode, History, Run, march};
use crate::{Curve, Heave, Law, Point, Rocking};

const G: f64 = 9.81;
const RADIUS: f64 = 10.0;
/// Weight on the rim [N/m], that of the mass on the foot.
const WEIGHT: f64 = 15e3;
const MASS: f64 = TAU * RADIUS * WEIGHT / G;

/// A rim on springs [N/m²] that pulls by `pull` √(w/m) [N/m] where it is lifted.
fn rocking(spring: f64, pull: f64) -> Rocking {
    let places = (-80..=80).map(|i| 0.6 * (f64::from(i) / 80.0).powi(3));
    let point = |w: f64| Point {
        uplift: w,
        hold_down: if w < 0.0 { spring * w } else { pull * w.sqrt() },
        rotation: 0.0,
        rim_moment: 0.0,
        axial_force: 0.0,
        lifted_width: 0.0,
        plastic_rotation: 0.0,
    };
    let curve = Curve::through(places.map(point).collect());
    Rocking::new(RADIUS, WEIGHT, vec![(1e5, curve)]).unwrap()
}

fn run(body: &Body, law: &Law, heave: Option<&Heave>, ground: &[f64], step: f64) -> History {
    march(&Run {
        body,
        law: Some(law),
        ring: None,
        heave,
        waves: None,
        hysteretic: 0.0,
        dashpot: 0.0,
        friction: None,
        rigid_pressure: [0.0; 2],
        step,
        ground,
    })
    .unwrap()
}

fn peak(values: &[f64]) -> f64 {
    values.iter().fold(0.0, |m, v| f64::max(m, v.abs()))
}

/// A rigid body on hard ground, thrown up by a pulse, turns about its toe with ψ̈ = −W R/(J + m R²) (Housner 1963). 1 %: the toe is an arc, whose
/// moment is smaller by half a percent. The bounce dies out before.
#[test]
fn a_rigid_block_turns_about_its_toe() {
    let rocking = rocking(1e9, 0.0);
    let law = Law::new(&rocking, 2e-2).unwrap();
    let (first, second) = (2e6, 1.5e7);
    let body = Body { modes: Vec::new(), mass: 5e5, first_moment: first, second_moment: second };
    let step = 2e-4;
    let ground: Vec<f64> = (0..1500).map(|i| if i < 250 { 22.0 } else { 0.0 }).collect();
    let weight = TAU * RADIUS * WEIGHT;
    for (heave, inertia) in [
        (None, second),
        (Some(Heave::new(MASS, &rocking, &law).unwrap().damped(2e-3)), second + MASS * RADIUS * RADIUS),
    ] {
        let history = run(&body, &law, heave.as_ref(), &ground, step);
        // Three instants in the air.
        let at = |i: usize| history.rotation[i];
        let time = 250.0 * step;
        let found = (at(1250) - 2.0 * at(1000) + at(750)) / (time * time);
        let side = at(1000).signum();
        assert!(history.rotation[600..1300].iter().all(|psi| side * psi > 1e-3));
        let expected = -side * weight * RADIUS / inertia;
        assert!((found / expected - 1.0).abs() < 1e-2, "{found} {expected}");
        assert!(history.balance < 1e-3, "{}", history.balance);
    }
}

/// A mode on a rim whose forces are summed directly, by the method of Runge and Kutta at a tenth of the step.
///
/// Largest |ψ| and w₀.
fn direct(body: &Body, curve: &Curve, delay: f64, steps: usize, ground: impl Fn(f64) -> f64) -> [f64; 2] {
    const PLACES: usize = 120;
    let mode = body.modes[0];
    let cosines: Vec<f64> = (0..PLACES).map(|i| (TAU * (i as f64 + 0.5) / PLACES as f64).cos()).collect();
    let sums = |psi: f64, centre: f64| {
        let mut sums = [0.0; 2];
        for cos in &cosines {
            let force = curve.hold_down(centre + psi * RADIUS * cos) * TAU * RADIUS / PLACES as f64;
            sums[0] -= force + WEIGHT * TAU * RADIUS / PLACES as f64;
            sums[1] += force * RADIUS * cos;
        }
        sums
    };
    // q, ψ, w₀ and their rates.
    let rates = |t: f64, x: [f64; 6]| {
        let a = ground(t);
        let [load, moment] = sums(x[1], x[2]);
        // Damping τ K of w₀ − w₀(ψ, L): K and ∂w₀/∂ψ by differences.
        let d = 1e-7;
        let slope = (sums(x[1], x[2] + d)[0] - sums(x[1], x[2] - d)[0]) / (2.0 * d);
        let turn = (sums(x[1] + d, x[2])[0] - sums(x[1] - d, x[2])[0]) / (2.0 * d);
        let sinks = -turn / slope;
        let damped = delay * slope * (x[5] - sinks * x[4]);
        let force = 2.0 * mode.damping * mode.omega * x[3] + mode.omega * mode.omega * x[0];
        // q̈ = −f − Γ a − Γ^ψ ψ̈ in Γ^ψ q̈ + S a + J ψ̈ + M = 0.
        let rest = mode.rotation * (-force - mode.translation * a) + body.first_moment * a + moment + sinks * damped;
        let turning = -rest / (body.second_moment - mode.rotation * mode.rotation);
        let vibrating = -force - mode.translation * a - mode.rotation * turning;
        [x[3], x[4], x[5], vibrating, turning, (load + damped) / MASS]
    };
    let rest = {
        let (mut low, mut high) = (-0.1, 0.1);
        for _ in 0..200 {
            let middle = 0.5 * (low + high);
            if sums(0.0, middle)[0] > 0.0 { low = middle } else { high = middle }
        }
        low
    };
    let h = 1e-4;
    let mut x = [0.0, 0.0, rest, 0.0, 0.0, 0.0];
    let mut largest = [0.0_f64; 2];
    for i in 0..steps {
        let t = h * i as f64;
        let along = |k: [f64; 6], s: f64| -> [f64; 6] { std::array::from_fn(|i| x[i] + s * k[i]) };
        let a = rates(t, x);
        let b = rates(t + 0.5 * h, along(a, 0.5 * h));
        let c = rates(t + 0.5 * h, along(b, 0.5 * h));
        let d = rates(t + h, along(c, h));
        x = std::array::from_fn(|i| x[i] + h / 6.0 * (a[i] + 2.0 * b[i] + 2.0 * c[i] + d[i]));
        largest = [largest[0].max(x[1].abs()), largest[1].max(x[2])];
    }
    largest
}

/// A body of one mode that rocks and lands several times, against direct integration without tables: 1 % of rotation and heave. The tables of M(ψ)
/// are within 0.1 %, and a difference grows with every landing.
#[test]
fn heave_follows_direct_integration() {
    let rocking = rocking(1e7, 120e3);
    let law = Law::new(&rocking, 8e-3).unwrap();
    let (mass, arm, omega) = (1.5e6, 4.0, 25.0);
    let body = Body {
        modes: vec![BodyMode {
            omega,
            damping: 0.02,
            translation: f64::sqrt(mass),
            rotation: f64::sqrt(mass) * arm,
            pressure: 0.0,
        }],
        mass,
        first_moment: mass * arm,
        second_moment: mass * arm * arm + 1e7,
    };
    let motion = |t: f64| 1.5 * ((9.0 * t).sin() + 0.7 * (14.0 * t).sin());
    let delay = 1e-3;
    let heave = Heave::new(MASS, &rocking, &law).unwrap().damped(delay);
    let ground: Vec<f64> = (0..=1500).map(|i| motion(1e-3 * f64::from(i))).collect();
    let history = run(&body, &law, Some(&heave), &ground, 1e-3);
    let lifted = history.centre.iter().fold(0.0, |m, w| f64::max(m, *w));
    let [psi, centre] = direct(&body, rocking.curve(), delay, 15_000, motion);
    let found = peak(&history.rotation);
    assert!(found < law.largest() && lifted > 5e-3, "{found} {lifted}");
    assert!((found / psi - 1.0).abs() < 1e-2, "{found} {psi}");
    assert!((lifted / centre - 1.0).abs() < 1e-2, "{lifted} {centre}");
    assert!(history.balance < 1e-3, "{}", history.balance);
    // The inertia matters here.
    let without = run(&body, &law, None, &ground, 1e-3);
    assert!((peak(&without.rotation) / psi - 1.0).abs() > 5e-2);
    // A gram does not.
    let gram = Heave::new(1e-3, &rocking, &law).unwrap();
    let light = run(&body, &law, Some(&gram), &ground, 1e-3);
    for (a, b) in light.rotation.iter().zip(&without.rotation) {
        assert!((a - b).abs() < 1e-6 * psi, "{a} {b}");
    }
}

/// What presses on the strips goes straight on where nothing of the rim is on the ground any more, and where it is driven into it.
#[test]
fn the_table_goes_straight_on_beyond_its_ends() {
    let rocking = rocking(1e9, 120e3);
    let law = Law::new(&rocking, 2e-2).unwrap();
    let heave = Heave::new(MASS, &rocking, &law).unwrap();
    let load = |place: f64| {
        let step = Step { place, give: 0.0, before: 0.0, length: 1e-3 };
        heave.lift(&law, 1e-2, 0.0, step).load
    };
    for [a, b, c] in [[1.0, 1.5, 2.0], [-1.0, -1.5, -2.0]].map(|places| places.map(load)) {
        assert!(((c - b) / (b - a) - 1.0).abs() < 1e-9, "{a} {b} {c}");
    }
    assert!(load(1.0) < 0.0 && load(-1.0) > 0.0 && load(2.0) < load(1.0));
}

/// A block that has come to rest stores nothing: its damping has taken what the ground gave. 5 %: the straight lines of the tables are 1 %, and the steps at
/// landings, of which half as long ones halve the rest.
#[test]
fn at_rest_the_damping_has_the_energy_of_the_ground() {
    let rocking = rocking(1e8, 20e3);
    let law = Law::new(&rocking, 2e-2).unwrap();
    let body = Body { modes: Vec::new(), mass: 5e5, first_moment: 2e6, second_moment: 1.5e7 };
    let ground: Vec<f64> = (0..40_000).map(|i| if i < 200 { 15.0 } else { 0.0 }).collect();
    let heave = Heave::new(MASS, &rocking, &law).unwrap().damped(5e-3);
    let energy = run(&body, &law, Some(&heave), &ground, 2.5e-4).energy;
    assert!(energy.input > 0.0 && (energy.viscous / energy.input - 1.0).abs() < 5e-2, "{energy:?}");
}
