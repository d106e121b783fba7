//! The strip of layered shells beside that of fibres, as a tank and its options give them.

use tank::ConcreteLaw;
use tank::options::nonlinear::{Damping, MassProportionalAt};
use tank::refusal::Place;

use super::*;
use crate::nonlinear::scope::{Purpose, refusals};

fn shells(case: &Case, elements: u32) -> NonlinearOptions {
    NonlinearOptions { wall: StripWall::Shell, ..options(case, elements) }
}

/// Liner and interlayer inside the reinforced concrete.
fn sandwich(peak: f64) -> Case {
    let mut case = reinforced(peak);
    let mut concrete = case.tank.courses[0].build_up().remove(0);
    // Fibres have no shear; a cracked layer keeps some of its own.
    if let Behaviour::Concrete(law) = &mut concrete.material.behaviour {
        law.shear_retention = 0.1;
    }
    let of = |kind, thickness, behaviour, (youngs_modulus, density)| Layer {
        kind,
        thickness,
        material: Material { name: "other".into(), youngs_modulus, density, behaviour, ..concrete.material.clone() },
        reinforcement: Vec::new(),
    };
    let normal =
        Behaviour::Interlayer(tank::Interlayer { e_normal: 3e9, e_parallel: 0.0, shear_modulus: 0.0, tension: true });
    let layers = vec![
        of(LayerKind::Shell, 0.006, Behaviour::Elastic, (210e9, 8000.0)),
        of(LayerKind::Interlayer, 0.05, normal, (3e9, 1500.0)),
        concrete,
    ];
    case.tank.courses = vec![Course::layered(3.0, layers)];
    case
}

/// A thousandth of an earthquake: both are elastic. Shells give way in shear, 1.5 % of the deflection at rest (γ H³/6 over 5/6 G t), so that
/// the frequency is 0.7 % lower and the response at 5 % damping differs by at most δω/(2 ξ ω) = 7 %; the wave hardly feels the wall.
#[test]
fn small_motion_is_that_of_fibres() {
    let case = sandwich(3e-3);
    let [fibre, shell] = [options(&case, 20), shells(&case, 20)].map(|own| run(&case, &own));
    assert_eq!(shell.result.end, End::Completed);
    for (quantity, tolerance) in [
        (Quantity::SloshingPeriod, 1e-3),
        (Quantity::ImpulsivePeriod, 1e-2),
        (Quantity::ConvectiveMass, 1e-3),
        (Quantity::ImpulsiveMass, 1e-2),
        (Quantity::SloshingHeight, 5e-3),
        (Quantity::BaseShear, 7e-2),
        (Quantity::BaseMoment, 7e-2),
        (Quantity::OverturningMoment, 7e-2),
    ] {
        let (a, b) = (shell.values[&quantity], fibre.values[&quantity]);
        assert!((a / b - 1.0).abs() < tolerance, "{}: {a} {b}", quantity.id());
    }
    let balance = shell.result.mass_balance.iter().map(|b| b.error.abs());
    assert!(balance.fold(0.0, f64::max) < 1e-2);
    // At rest: the cantilever under the pressure; the weight of the wall, 26 kN/m, stands on 0.55 mm, half of the layer on the faces: 0.6 %.
    let entry = |s: &Simulation, id: &str| s.result.histories.iter().find(|h| h.id == id).unwrap().static_value;
    let gamma = DENSITY * G;
    for (id, reference, tolerance) in [
        ("wall_moment_base_theta_0", -gamma * DEPTH.powi(3) / 6.0, 1e-2),
        ("wall_shear_base_theta_180", -gamma * DEPTH * DEPTH / 2.0, 1e-6),
        ("wall_displacement_theta_0", entry(&fibre, "wall_displacement_theta_0"), 2e-2),
    ] {
        let found = entry(&shell, id);
        assert!((found / reference - 1.0).abs() < tolerance, "{id}: {found} {reference}");
    }
    // Sign and size of the moment of the section and of its curvature. A shell has the curvature of its middle, a beam that of its lower
    // Gauss point, and both fall as (1 − z/H)³ at rest; 2 %: half of the layer's weight on the faces is 0.6 %.
    let element = 3.0 / 20.0;
    let lower = 0.5 * (1.0 - 1.0 / 3f64.sqrt()) * element;
    let higher = ((DEPTH - 0.5 * element) / (DEPTH - lower)).powi(3);
    let loops = |s: &Simulation| nonlinear(s).loops.iter().map(|l| l.points[0]).collect::<Vec<_>>();
    for (a, b) in loops(&shell).iter().zip(loops(&fibre)) {
        // The other loop is that of deflection and base shear.
        let shear = (b[1].abs() / (0.5 * gamma * DEPTH * DEPTH) - 1.0).abs() < 1e-3;
        let share = if shear { 1.0 } else { higher };
        for (x, y) in a.iter().zip(b) {
            assert!((x / (y * share) - 1.0).abs() < 2e-2, "{a:?} {b:?}");
        }
    }
}

/// Cracks and bars of the concrete leaf are seen; energy adds up.
#[test]
fn cracks_and_bars() {
    let case = sandwich(6.0);
    let found = run(&case, &shells(&case, 12));
    let n = nonlinear(&found);
    assert_eq!(found.result.end, End::Completed, "{:?}", found.result.end);
    let map = |id: &str| n.maps.iter().find(|m| m.id == id).unwrap();
    let (width, stress) = (map("crack_width"), map("bar_stress"));
    assert!(width.values[0] > 0.0 && width.values[n.grid.cells() - 1] == 0.0);
    assert!(stress.values[0] > 10e6);
    assert!(map("crack_depth").values.iter().all(|share| (0.0..=1.0).contains(share)));
    assert!(n.energies.error < 1e-3, "{}", n.energies.error);
}

/// A layer without tension between elastic leaves, hardly damped: the scheme gained energy where it closes and opens within a step, and
/// the run stopped. It ends, energy adds up, and half the step gives the same peaks: the wave does not feel the fill (1 %); touches come at other
/// moments of the step, so that the moment is less sharp (10 %).
#[test]
fn a_loose_fill_neither_gains_energy_nor_stops() {
    let mut case = sandwich(3.0);
    let layers = &mut case.tank.courses[0].layers;
    layers[2].material.behaviour = Behaviour::Elastic;
    layers[2].reinforcement.clear();
    if let Behaviour::Interlayer(fill) = &mut layers[1].material.behaviour {
        fill.tension = false;
    }
    let damping = Damping::MassProportional { ratio: 0.022, at: MassProportionalAt::Frequency(2.39) };
    let [long, short] = [2.5e-3, 1.25e-3].map(|step| {
        let own = NonlinearOptions { damping, time_step: Some(step), ..shells(&case, 12) };
        let found = run(&case, &own);
        assert_eq!(found.result.end, End::Completed, "{:?}", found.result.end);
        let energies = &nonlinear(&found).energies;
        assert!(energies.error < 1e-3, "{}", energies.error);
        found
    });
    for (quantity, tolerance) in [(Quantity::SloshingHeight, 1e-2), (Quantity::BaseMoment, 0.1)] {
        let (a, b) = (long.values[&quantity], short.values[&quantity]);
        assert!((a / b - 1.0).abs() < tolerance, "{}: {a} {b}", quantity.id());
    }
}

/// Contact that opens: walls of shells and of fibres have one joint at each level. Nothing opens at rest or under small motion.
#[test]
fn contact_that_opens() {
    let case = sandwich(3e-3);
    let [fibre, shell] = [options(&case, 12), shells(&case, 12)].map(|own| {
        let own = NonlinearOptions { contact: Contact::Opening, ..own };
        assert!(refusals(&case, &own, Purpose::History).is_empty());
        run(&case, &own)
    });
    assert_eq!(shell.result.end, End::Completed);
    // As without contact: shells give way in shear.
    for (quantity, tolerance) in [(Quantity::SloshingHeight, 5e-3), (Quantity::BaseShear, 7e-2)] {
        let (a, b) = (shell.values[&quantity], fibre.values[&quantity]);
        assert!((a / b - 1.0).abs() < tolerance, "{}: {a} {b}", quantity.id());
    }
    for run in [&fibre, &shell] {
        let open = run.result.histories.iter().filter(|h| h.id.starts_with("open"));
        let peaks: Vec<f64> = open.map(|h| h.peak).collect();
        assert!(!peaks.is_empty() && peaks.iter().all(|share| *share == 0.0), "{peaks:?}");
    }
}

/// Laws of shells alone are refused of fibres and taken of shells, and the other way round.
#[test]
fn laws() {
    for (law, of_fibres, of_shells) in [
        (ConcreteLaw::Cracked, true, true),
        (ConcreteLaw::Uniaxial, true, false),
        (ConcreteLaw::PlasticFracturing, false, true),
        (ConcreteLaw::TwoSurface, false, true),
        (ConcreteLaw::Fracturing, false, true),
    ] {
        let mut case = sandwich(1e-3);
        for layer in &mut case.tank.courses[0].layers {
            if let Behaviour::Concrete(concrete) = &mut layer.material.behaviour {
                concrete.law = law;
            }
        }
        for (own, taken) in [(options(&case, 20), of_fibres), (shells(&case, 20), of_shells)] {
            let found = refusals(&case, &own, Purpose::History);
            assert_eq!(found.is_empty(), taken, "{law:?} {:?}: {found:?}", own.wall);
            assert!(found.iter().all(|r| matches!(r.place, Place::Law(_))), "{found:?}");
            assert_eq!(Strip::new(&case, &own).is_ok(), taken, "{law:?} {:?}", own.wall);
        }
    }
}
