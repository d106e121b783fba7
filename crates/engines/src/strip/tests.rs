//! The strip in one run: against the linear engine, at rest, until collapse.

mod chain;
mod model;
mod resume;
mod shells;

use fem::progress::Silent;
use oscillator::record::Record;
use tank::case::{Damping as Ratios, GroundMotion};
use tank::{
    Bar, BarDirection, Behaviour, Concrete, Course, Layer, LayerKind, Material, Reinforcement, Shape, Softening,
};
use tank::{Case, Quantity};

use super::Strip;
use crate::harmonic::test_tanks;
use crate::nonlinear::simulate;
use crate::{FeError, Simulation};
use results::nonlinear::{Columns, End, EventKind, Nonlinear};
use tank::options::nonlinear::{Contact, NonlinearOptions, StripWall, WallElements};

/// g of the test cases.
const G: f64 = 9.81;
const DEPTH: f64 = 2.57;
const DENSITY: f64 = 1019.4;
const PLANE_MODULUS: f64 = 34e9 / (1.0 - 0.2 * 0.2);

/// Strip 8.4 of one material, 30 cm.
fn strip(behaviour: Behaviour, peak: f64) -> Case {
    let shape = Shape::Rectangle { length: 5.0, breadth: 1.0, strip: true };
    let mut case = test_tanks::case(shape, &[(3.0, 0.3)], (34e9, 0.2, 2950.0), (DENSITY, DEPTH));
    case.tank.courses[0].material.behaviour = behaviour;
    case.damping = Ratios { sloshing: 0.005, impulsive: 0.05 };
    // Two seconds that excite sloshing and wall alike, begun and ended softly.
    let dt = 0.01;
    let acceleration = (0..=200).map(|i| {
        let t = f64::from(i) * dt;
        let swell = (std::f64::consts::PI * t / 2.0).sin().powi(2);
        peak * swell * (0.6 * (2.4 * t).sin() + 0.5 * (40.0 * t).sin() + 0.3 * (95.0 * t + 1.0).sin())
    });
    case.ground_motion = Some(GroundMotion {
        horizontal: Record { name: "test".into(), dt, acceleration: acceleration.collect(), processing: Vec::new() },
        transverse: None,
        vertical: None,
    });
    case
}

fn concrete() -> Behaviour {
    Behaviour::Concrete(Concrete {
        law: tank::ConcreteLaw::Cracked,
        compressive_strength: 35e6,
        characteristic_strength: None,
        biaxial_ratio: 1.16,
        tensile_strength: 3.5e6,
        softening: Softening::FractureEnergy(140.0),
        shear_retention: 0.0,
        shear_retention_strain: 1e-3,
        tension_stiffening: 0.0,
        crack_spacing: None,
        envelope: tank::BiaxialEnvelope::default(),
        bond: tank::BarBond::Perfect,
    })
}

/// The same with bars near both faces.
fn reinforced(peak: f64) -> Case {
    let mut case = strip(concrete(), peak);
    let material = case.tank.courses[0].material.clone();
    let bars = |depth| Reinforcement {
        direction: BarDirection::Vertical,
        area: 7e-4,
        depth,
        diameter: None,
        prestress: 0.0,
        material: Material {
            name: "bars".into(),
            youngs_modulus: 210e9,
            behaviour: Behaviour::Reinforcement(Bar {
                yield_strength: 500e6,
                tangent_modulus: 2.1e9,
                rupture_strain: None,
            }),
            ..material.clone()
        },
    };
    let layer = Layer {
        kind: LayerKind::Shell,
        thickness: 0.3,
        material: material.clone(),
        reinforcement: vec![bars(0.035), bars(0.265)],
    };
    case.tank.courses = vec![Course::layered(3.0, vec![layer])];
    case
}

fn options(case: &Case, elements: u32) -> NonlinearOptions {
    NonlinearOptions {
        elements: Some(WallElements { height: elements, circumference: 1 }),
        ..NonlinearOptions::new(case.damping)
    }
}

fn run(case: &Case, options: &NonlinearOptions) -> Simulation {
    simulate(case, options, None, &Silent).unwrap()
}

fn nonlinear(simulation: &Simulation) -> &Nonlinear {
    simulation.result.nonlinear.as_ref().unwrap()
}

fn column<'a>(simulation: &'a Simulation, id: &str) -> &'a [f64] {
    let series = &simulation.series;
    let i = series.ids.iter().position(|x| x == id).unwrap();
    &series.columns[i]
}

/// Concrete far below its strength, a thousandth of an earthquake: the linear harmonic engine, whose liquid is a mesh of finite
/// elements and whose integration is modal and exact.
///
/// Tolerances: 60 steps in a period of the wall lengthen it by (ω h)²/12 ≈ 1e-3, which a resonance of 5 % damping sees as up
/// to 1e-2; twelve sloshing modes lack 3e-4 of the mass; the wall's higher modes are damped more than by the modal ratio.
#[test]
fn small_motion_is_that_of_the_linear_engine() {
    let case = strip(concrete(), 3e-3);
    let mut own = options(&case, 28);
    own.time_step = Some(0.0624 / 60.0);
    own.spectral_radius = 1.0;
    let found = run(&case, &own);
    let linear =
        crate::simulate(&case, &crate::Options { wave_modes: 12, mesh_error: false, ..crate::Options::default() })
            .unwrap();
    for (quantity, tolerance) in [
        (Quantity::SloshingPeriod, 1e-3),
        (Quantity::ImpulsivePeriod, 2e-3),
        (Quantity::ConvectiveMass, 2e-3),
        (Quantity::ImpulsiveMass, 2e-3),
        (Quantity::SloshingHeight, 1.5e-2),
        (Quantity::BaseShear, 1.5e-2),
        (Quantity::BaseMoment, 1.5e-2),
        (Quantity::OverturningMoment, 1.5e-2),
    ] {
        let (a, b) = (found.values[&quantity], linear.values[&quantity]);
        assert!((a / b - 1.0).abs() < tolerance, "{}: {a} {b}", quantity.id());
    }
    // Histories, sign included. The moment of the wall there is elastic, here a reaction: with the damping, 2 ξ = 10 % of it in
    // quadrature.
    for (id, theirs, tolerance) in [
        ("wave_height_theta_0", "wave_height_theta_0", 2e-2),
        ("wave_height_theta_180", "wave_height_theta_180", 2e-2),
        ("base_shear", "base_shear", 2e-2),
        ("base_moment", "base_moment", 2e-2),
        ("overturning_moment", "overturning_moment", 2e-2),
        ("wall_moment_base_theta_0", "wall_moment_base", 0.1),
    ] {
        let (a, b) = (column(&found, id), column(&linear, theirs));
        let largest = b.iter().fold(0.0, |m: f64, x| m.max(x.abs()));
        let difference = a.iter().zip(b).fold(0.0, |m: f64, (x, y)| m.max((x - y).abs()));
        assert!(difference < tolerance * largest, "{id}: {}", difference / largest);
    }
    for id in ["pressure", "radial_displacement"] {
        let of = |s: &Simulation| s.result.envelopes.iter().find(|e| e.id == id).unwrap().clone();
        let (a, b) = (of(&found), of(&linear));
        // At the level nearest to 1 m of ours, linear in theirs between neighbours.
        let i = (0..a.z.len()).min_by(|&i, &j| (a.z[i] - 1.0).abs().total_cmp(&(a.z[j] - 1.0).abs())).unwrap();
        let z = a.z[i];
        let k = b.z.windows(2).position(|w| w[0] <= z && z <= w[1]).unwrap();
        let part = (z - b.z[k]) / (b.z[k + 1] - b.z[k]);
        let theirs = |v: &[f64]| v[k] + part * (v[k + 1] - v[k]);
        for (what, x, y) in [
            ("rest", a.static_[i], theirs(&b.static_)),
            ("min", a.min[i], theirs(&b.min)),
            ("max", a.max[i], theirs(&b.max)),
        ] {
            assert!((x / y - 1.0).abs() < 2e-2, "{id} at {z}, {what}: {x} {y}");
        }
    }
    let n = nonlinear(&found);
    assert_eq!(found.result.end, End::Completed);
    assert!(found.result.events.is_empty(), "{:?}", found.result.events);
    assert!(n.energies.error < 1e-6, "{}", n.energies.error);
    // Both walls the same, mirrored.
    let (a, b) = (column(&found, "wall_displacement_theta_0"), column(&found, "wall_displacement_theta_180"));
    let largest = a.iter().fold(0.0, |m: f64, x| m.max(x.abs()));
    assert!(a.iter().zip(b).all(|(x, y)| (x + y).abs() < 1e-6 * largest));
}

/// Without motion: moment, shear and deflection of a cantilever under hydrostatic pressure only.
#[test]
fn at_rest() {
    let case = strip(Behaviour::Elastic, 0.0);
    let found = run(&case, &options(&case, 20));
    let gamma = DENSITY * G;
    let bending = PLANE_MODULUS * 0.3_f64.powi(3) / 12.0;
    let top = gamma * DEPTH.powi(5) / (30.0 * bending) + (3.0 - DEPTH) * gamma * DEPTH.powi(4) / (24.0 * bending);
    for (id, reference, tolerance) in [
        ("wall_moment_base_theta_0", -gamma * DEPTH.powi(3) / 6.0, 1e-6),
        ("wall_shear_base_theta_180", -gamma * DEPTH * DEPTH / 2.0, 1e-6),
        ("wall_displacement_theta_180", top, 5e-3),
    ] {
        let entry = found.result.histories.iter().find(|s| s.id == id).unwrap();
        assert!((entry.static_value / reference - 1.0).abs() < tolerance, "{id}: {}", entry.static_value);
        assert!(entry.peak < 1e-6 * reference.abs(), "{id}: {}", entry.peak);
    }
    // Without weight the pressure is still there at the start.
    let mut weightless = options(&case, 20);
    weightless.self_weight = false;
    let light = run(&case, &weightless);
    let entry =
        |s: &Simulation| s.result.histories.iter().find(|s| s.id == "wall_displacement_theta_0").unwrap().clone();
    assert!((entry(&light).static_value / entry(&found).static_value - 1.0).abs() < 1e-9);
    assert!(entry(&light).peak < 1e-6 * top);
    let n = nonlinear(&found);
    let separation = n.maps.iter().find(|m| m.id == "separation").unwrap();
    // The hydrostatic pressure in the middle of the lowest element.
    let middle = 0.5 * (n.grid.z[0] + n.grid.z[1]);
    assert!((separation.values[1] / (gamma * (DEPTH - middle)) - 1.0).abs() < 1e-9);
    assert_eq!(separation.values.len(), n.grid.cells());
    assert!(matches!(&n.grid.columns, Columns::Walls { names } if names.len() == 2));
}

/// Reinforced walls crack in the middle of it: events in order, cracks on both faces of both walls, energy that adds up.
#[test]
fn walls_that_crack() {
    let case = reinforced(6.0);
    let found = run(&case, &options(&case, 12));
    let n = nonlinear(&found);
    assert_eq!(found.result.end, End::Completed, "{:?}", found.result.end);
    let events = &found.result.events;
    assert!(events.iter().any(|e| e.kind == EventKind::FirstCrack && e.time > 0.0));
    assert!(events.windows(2).all(|e| e[0].time <= e[1].time));
    let map = |id: &str| n.maps.iter().find(|m| m.id == id).unwrap();
    // At the base, not at the top.
    let (width, stress) = (map("crack_width"), map("bar_stress"));
    assert!(width.values[0] > 0.0 && width.values[n.grid.cells() - 1] == 0.0);
    assert_eq!(stress.mark, Some(500e6));
    assert!(stress.values[0] > 10e6);
    assert_eq!(n.cracks.len(), 6);
    for picture in &n.cracks {
        assert!(picture.cracks.iter().all(|c| c.cell < n.grid.cells() && c.width <= c.largest));
    }
    let e = &n.energies;
    assert!(e.error < 1e-3, "{}", e.error);
    for i in 0..e.time.len() {
        let rest = e.input[i] - e.kinetic[i] - e.internal[i] - e.damping[i] - e.numerical[i];
        let scale = e.input.iter().fold(0.0, |m: f64, x| m.max(x.abs()));
        assert!(rest.abs() < 1e-3 * scale, "{rest} {scale}");
    }
    assert!(e.hysteretic.windows(2).all(|w| w[1] >= w[0] - 1e-9) && *e.hysteretic.last().unwrap() > 0.0);
    for series in &found.result.histories {
        assert_eq!(column(&found, &series.id).len(), found.series.time.len(), "{}", series.id);
    }
    assert_eq!(n.loops.len(), 4);
    assert!(n.loops.iter().all(|l| l.points.len() == found.series.time.len()));
}

/// A joint that may open follows the wall as long as it is in compression, and opens where the check of the bonded run finds
/// pressure below zero.
///
/// Tolerance: a pressure that is handed over at the nodes of 20 elements bends them less, (1/20)²; the penalty yields by 1e-3 of
/// the wall's displacement.
#[test]
fn contact_that_opens() {
    for (peak, opens) in [(0.5, false), (12.0, true)] {
        let case = strip(Behaviour::Elastic, peak);
        let bonded = run(&case, &options(&case, 20));
        let own = NonlinearOptions { contact: Contact::Opening, ..options(&case, 20) };
        let found = run(&case, &own);
        let n = nonlinear(&found);
        assert_eq!(found.result.end, End::Completed);
        assert!(n.energies.error < 1e-6, "{}", n.energies.error);
        let would = nonlinear(&bonded).maps.iter().find(|m| m.id == "separation").unwrap();
        assert_eq!(would.values.iter().any(|p| *p < 0.0), opens);
        let gap = n.maps.iter().find(|m| m.id == "separation").unwrap();
        assert_eq!(gap.values.iter().any(|g| *g > 0.0), opens);
        assert_eq!(found.result.events.iter().any(|e| e.title == "the liquid separates from the wall"), opens);
        assert_eq!(found.result.parted(), opens);
        // An incremental analysis gives the same at the scale 1.
        for options in [&options(&case, 20), &own] {
            let curve = Strip::new(&case, options).unwrap();
            let runs = curve.incremental(&[1.0], 1, &|_| None, &Silent, |_| {}).unwrap();
            let open = options.contact == Contact::Opening;
            let parting = runs[0].parting;
            assert_eq!(parting.is_some(), opens);
            assert!(parting.is_none_or(|p| p.open == open && p.height > 0.0 && p.height <= DEPTH));
            let told = found.result.events.iter().find(|e| e.title == "the liquid separates from the wall");
            if let (Some(parting), Some(told), true) = (parting, told, open) {
                assert_eq!(parting.time, told.time);
            }
        }
        if !opens {
            for (quantity, a) in &found.values {
                let b = bonded.values[quantity];
                assert!((a / b - 1.0).abs() < 2.5e-3, "{}: {a} {b}", quantity.id());
            }
        }
    }
}

/// A wall that does not carry the hydrostatic pressure: the part that it carries, and no response.
#[test]
fn collapse_at_rest() {
    let Behaviour::Concrete(mut weak) = concrete() else { unreachable!() };
    // Cracks at (1 MPa + 0.09 MPa) h²/6 = 16 kNm/m of the 29 kNm/m at the base.
    (weak.tensile_strength, weak.softening) = (1e6, Softening::FractureEnergy(20.0));
    let case = strip(Behaviour::Concrete(weak), 1.0);
    let found = run(&case, &options(&case, 12));
    let End::Collapsed { load_factor: Some(factor), time, .. } = found.result.end else {
        panic!("{:?}", found.result.end);
    };
    assert!(time < 0.0 && factor > 0.5 && factor < 0.95, "{factor}");
    assert!(found.series.time.is_empty() && found.notes[0].contains("does not carry"));
    let text = serde_json::to_string(&found.result).unwrap();
    serde_json::from_str::<results::Run>(&text).expect("finite numbers");
}

/// Walls without bars break: a result that ends there, with time, place and all that was seen until then.
#[test]
fn collapse_is_a_result() {
    let case = strip(concrete(), 12.0);
    let found = run(&case, &options(&case, 12));
    let End::Collapsed { time, load_factor, reason, place } = &found.result.end else {
        panic!("{:?}", found.result.end);
    };
    assert!(*time > 0.1 && *time < 2.0 && load_factor.is_none() && !reason.is_empty());
    assert!(place.starts_with("wall at"), "{place}");
    let last = *found.series.time.last().unwrap();
    assert!(last <= *time && last > time - 0.011, "{last} {time}");
    assert!(found.notes.iter().any(|n| n.starts_with("Collapse")), "{:?}", found.notes);
    assert!(!found.result.incomplete);
    assert!(found.result.events.iter().any(|e| e.kind == EventKind::FirstCrack));
    assert!(found.values[&Quantity::BaseShear].is_finite());
    let again: results::Run =
        serde_json::from_str(&serde_json::to_string(&found.result).unwrap()).expect("finite numbers");
    assert_eq!(again.histories, found.result.histories);
}

/// Rectangles that are not strips, roofs.
#[test]
fn what_the_strip_refuses() {
    let mut case = strip(Behaviour::Elastic, 0.0);
    case.tank.roof.mass = 1000.0;
    let refused = |case: &Case| match simulate(case, &options(case, 8), None, &Silent) {
        Err(FeError::Unsupported(message)) => message,
        other => panic!("{other:?}"),
    };
    assert!(refused(&case).contains("roof"));
    case.tank.shape = Shape::Rectangle { length: 5.0, breadth: 4.0, strip: false };
    assert!(refused(&case).contains("strip true"));
}
