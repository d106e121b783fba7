//! Unanchored walls on their bottom.

use fem::progress::Silent;
use results::Channel;
use results::channel::Side;
use results::nonlinear::End;
use tank::{Behaviour, Case, Shape, Steel, Support};

use super::super::super::simulate_with_states;
use super::super::march::Cylinder;
use super::super::model::CylinderModel;
use super::{marched, marched_to, options, shaken};
use crate::floor_pressure::impulsive_pressure;
use crate::harmonic::test_tanks;
use tank::options::nonlinear::NonlinearOptions;
use tank::reference::{case, material};

/// R = 5 m, 9 m of water under 10 m of 8 mm steel, 6 mm of bottom plate on 10⁸ N/m³.
pub(super) fn slender() -> Case {
    let mut steel = material(2.05e11, 0.3, 7850.0);
    steel.yield_strength = Some(235e6);
    steel.behaviour = Behaviour::Steel(Steel {
        yield_strength: 235e6,
        tangent_modulus: 2.05e9,
        kinematic_share: 1.0,
        ultimate_strength: None,
    });
    let mut case = case(Shape::Cylinder { radius: 5.0 }, &[(10.0, 8e-3)], &steel, (1000.0, 9.0));
    test_tanks::on_ground(&mut case, 6e-3, steel, 1e8);
    case
}

/// A tank on its bottom is damped at the first mode of the wall held, that of the harmonic engine: another element on 48 sectors and 24 rows,
/// whose frequency is within 1 % of it for a held wall (`small_shaking_is_linear`). Sliding, or on anchors, it is the same.
#[test]
fn the_damping_is_that_of_the_held_wall() {
    let case = shaken(slender(), 0.05, 10);
    let linear_options = crate::Options { mesh_error: false, ..crate::Options::default() };
    let linear = crate::simulate(&case, &linear_options).unwrap();
    let period = linear.values[&tank::Quantity::ImpulsivePeriod];
    let mut sliding = case.clone();
    sliding.tank.foundation.as_mut().unwrap().friction = Some(0.4);
    for case in [case, sliding, anchored(1e12)] {
        let tank = CylinderModel::new(&case, &options(&case, 24, 48)).unwrap();
        assert!(tank.standing.is_some());
        let found = std::f64::consts::TAU / tank.wall_omega;
        assert!((found / period - 1.0).abs() < 0.01, "{found} s, expected {period} s");
    }
}

/// The shock lifts the foot on one side by millimetres and presses it on the other, where the wall is compressed; the plate yields at
/// its weld. Work and energies agree to rounding, since the ground is elastic: 1e-6 of the energy put in.
#[test]
fn a_shock_lifts_the_foot() {
    let case = shaken(slender(), 3.0, 50);
    let run = simulate_with_states(&case, &options(&case, 8, 12), (Some(0.05), None), &Silent).unwrap();
    assert_eq!(run.result.end, End::Completed);
    let peak = |channel: Channel| {
        let found = run.result.histories.iter().find(|h| h.id == channel.id());
        found.map(|h| h.peak).unwrap()
    };
    let [front, back] = Side::BOTH.map(|side| peak(Channel::Uplift(side)));
    assert!(front > 1e-3 && back < 0.02 * front, "{front} {back}");
    let extremes = &run.result.nonlinear.as_ref().unwrap().extremes;
    let pressed = |side: Side| {
        let of = extremes.iter().find(|e| e.title == Channel::Uplift(side).title());
        of.and_then(|e| e.min.as_ref()).map(|m| m.value).unwrap()
    };
    assert!(pressed(Side::Back) < 2.0 * pressed(Side::Front), "toe");
    assert!(peak(Channel::ToeStress) > 1e6 && peak(Channel::BaseRotation) > 1e-4);
    let plastic = extremes.iter().find(|e| e.title == Channel::PlasticRotation(Side::Front).title()).unwrap();
    // The side that lifts more turns its joint as a plate that lifts, the other one is pressed.
    assert!(plastic.max.value > 1e-3, "{plastic:?}");
    let joint = run.demands.as_ref().and_then(|d| d.base.as_ref()?.joint).unwrap();
    let [front, back] = Side::BOTH.map(|side| peak(Channel::PlasticRotation(side)));
    assert!((joint.value / front.max(back) - 1.0).abs() < 1e-12, "{joint:?} {front} {back}");
    let cycles = extremes.iter().find(|e| e.title.starts_with("Largest range of the plastic")).unwrap();
    assert!(cycles.max.value >= joint.value * (1.0 - 1e-12), "{cycles:?} {joint:?}");
    assert!(run.result.energy.unwrap().error.abs() < 1e-6);
    assert!(run.assumptions.iter().any(|a| a.contains("does not slide")));
    assert!(run.notes.iter().all(|n| !n.contains("clamps")));
    let pictures = run.snapshots.as_ref().unwrap();
    assert_eq!(pictures.states.len(), 10);
    at_rest_the_ground_carries_all(&case, pictures);
    let lifted = |s: &results::Snapshot| {
        let own = pictures.bottom.iter().flatten();
        own.filter(|n| s.displacement[**n][2] > 0.0).map(|n| s.ground[*n]).collect::<Vec<f64>>()
    };
    assert!(lifted(&pictures.states[0]).is_empty());
    assert!(pictures.states.iter().any(|s| !lifted(s).is_empty()));
    assert!(pictures.states.iter().all(|s| lifted(s).iter().all(|p| *p == 0.0)));
    let yields = |s: &results::Snapshot| s.plastic.iter().any(|p| *p != 0.0);
    assert!(yields(pictures.states.last().unwrap()));
}

/// Where a foot lifts, plate and wall bend under one moment and turn the joint in one sense: the wall of a weaker steel yields with its plate. Where the
/// foot is pressed, both have the other sign.
#[test]
fn plate_and_wall_turn_the_joint_in_one_sense() {
    let mut case = slender();
    let lowest = &mut case.tank.courses[0];
    lowest.thickness = 6e-3;
    if let Behaviour::Steel(steel) = &mut lowest.material.behaviour {
        steel.yield_strength = 120e6;
    }
    let case = shaken(case, 4.0, 50);
    let own = options(&case, 24, 12);
    let tank = CylinderModel::new(&case, &own).unwrap();
    let cylinder = Cylinder::of(&case, &own, tank).unwrap();
    let motion = case.ground_motion.as_ref().unwrap();
    let (watch, run) = cylinder.march(motion, 1.0, 1, None, &Silent).unwrap();
    let standing = cylinder.tank.standing.as_ref().unwrap();
    let parts = standing.plastic_parts(&cylinder.tank, &run.state).unwrap();
    let wall = parts.map(|[_, wall]| wall.abs()).into_iter().fold(0.0, f64::max);
    assert!(wall > 1e-4, "{parts:?}");
    assert!(parts.iter().all(|[plate, wall]| plate * wall >= 0.0), "{parts:?}");
    let last = watch.seen.standing.joint.map(|joint| joint[joint.len() - 1]);
    assert_eq!(last, parts.map(|[plate, wall]| plate + wall));
}

/// Half of the wall and of the liquid over the rings, from the foot to half of the radius. A quarter of every quadrilateral goes with each of
/// its corners, which puts the peak under the foot, two thicknesses wide, off by a third of a ring: 1 % of the whole. The areas of the ground are those of
/// arcs of 30°, the quadrilaterals are between their chords.
fn at_rest_the_ground_carries_all(case: &Case, pictures: &results::Snapshots) {
    let rest = &pictures.states[0];
    let area = |cell: &[usize; 4]| {
        let [a, b, c, d] = cell.map(|n| pictures.nodes[n]);
        0.5 * ((c[0] - a[0]) * (d[1] - b[1]) - (d[0] - b[0]) * (c[1] - a[1])).abs()
    };
    let mean = |cell: &[usize; 4]| cell.iter().map(|n| rest.ground[*n]).sum::<f64>() / 4.0;
    let found: f64 = pictures.bottom.iter().map(|cell| area(cell) * mean(cell)).sum();
    let covered: f64 = pictures.bottom.iter().map(area).sum();
    let pressure = case.liquid.density * case.gravity * case.liquid.fill_height;
    let bottom = case.tank.bottom.as_ref().unwrap();
    let plate = bottom.thickness * bottom.material.density * case.gravity;
    let expected = (pressure + plate) * covered + 0.5 * case.tank.wall_mass() * case.gravity;
    let arc = std::f64::consts::PI / 6.0;
    let found = found * arc / arc.sin();
    assert!((found / expected - 1.0).abs() < 0.01, "{found} {expected}");
}

/// The value of a history's peak.
fn peak(run: &crate::Simulation, channel: Channel) -> f64 {
    let found = run.result.histories.iter().find(|h| h.id == channel.id());
    found.map(|h| h.peak).unwrap()
}

fn run(case: &Case, height: u32, circumference: u32) -> crate::Simulation {
    simulate_with_states(case, &options(case, height, circumference), (None, None), &Silent).unwrap()
}

/// A rigid tank that accelerates by 1 m/s² with a surface free of pressure presses the liquid's floor as the series of Haroun and Housner does,
/// in the mean over the function of every ring. Five elements of the liquid over the radius: 1 % of the largest.
#[test]
fn the_floor_has_the_impulsive_pressure() {
    let case = slender();
    let tank = CylinderModel::new(&case, &options(&case, 12, 24)).unwrap();
    let floor = tank.floor.as_ref().unwrap();
    let (wetted, wall) = (tank.wetted.len(), tank.liquid.wall());
    let mut a = vec![0.0; wall + tank.amplitudes.len()];
    let still = a.clone();
    for (a, &node) in a.iter_mut().zip(&tank.wetted) {
        let [x, y, _] = tank.model.nodes()[node];
        *a = x / x.hypot(y);
    }
    // The masses of the amplitudes are 1: they follow so that nothing presses on the surface.
    let pressed = tank.liquid.forces(&a, &still);
    for j in wall..a.len() {
        a[j] = -pressed[j];
    }
    let force = tank.liquid.forces(&a, &still);
    let meridians = floor.nodes.len() / floor.radii.len();
    let share = std::f64::consts::PI / (meridians - 1) as f64;
    let ring = |j: usize, value: &dyn Fn(f64) -> f64| {
        // ∫ N r f dr by its hats, on both sides of the ring.
        let side = |other: Option<&f64>| {
            let Some(&end) = other else { return 0.0 };
            let n = 200;
            let width = (end - floor.radii[j]).abs() / f64::from(n);
            let at = |i: i32| floor.radii[j] + (end - floor.radii[j]) * (f64::from(i) + 0.5) / f64::from(n);
            (0..n).map(|i| (1.0 - (f64::from(i) + 0.5) / f64::from(n)) * at(i) * value(at(i)) * width).sum()
        };
        let outer = j.checked_sub(1).and_then(|i| floor.radii.get(i));
        side(outer) + side(floor.radii.get(j + 1))
    };
    let largest = impulsive_pressure(&case, 5.0, 5.0);
    for j in 0..floor.radii.len() {
        let area = ring(j, &|_| 1.0);
        let expected = ring(j, &|r| impulsive_pressure(&case, 5.0, r)) / area;
        for k in [0, 3, meridians - 1] {
            let weight = if k == 0 || k == meridians - 1 { 0.5 } else { 1.0 };
            let found = force[wetted + j * meridians + k] / (area * share * weight);
            let cos = (share * k as f64).cos();
            // The ground accelerates towards θ = 0, where the liquid pulls at the floor: the force that lifts it is negative.
            assert!((found + expected * cos).abs() < 0.01 * largest, "{j} {k}: {found} {}", expected * cos);
        }
    }
}

/// Friction of 0.05 under tank and liquid caps the shear; the springs of the ground follow the pressure of the step before, 1 % of it. What the
/// tank slides has taken energy, and the balance closes.
#[test]
fn friction_caps_the_shear() {
    let mut case = shaken(slender(), 3.0, 50);
    case.tank.foundation.as_mut().unwrap().friction = Some(0.05);
    let run = run(&case, 8, 12);
    assert_eq!(run.result.end, End::Completed);
    let plate = std::f64::consts::PI * 25.0 * 6e-3 * 7850.0;
    let weight = (case.liquid_mass() + case.tank.wall_mass() + plate) * case.gravity;
    let shear = peak(&run, Channel::BaseShear);
    assert!(shear < 1.01 * 0.05 * weight && shear > 0.95 * 0.05 * weight, "{shear} {weight}");
    assert!(peak(&run, Channel::Slip) > 5e-3, "{}", peak(&run, Channel::Slip));
    let energies = &run.result.nonlinear.as_ref().unwrap().energies;
    assert!(energies.hysteretic.last().unwrap() > &(0.05 * weight * 1e-3));
    assert!(run.result.energy.unwrap().error.abs() < 1e-3, "{:?}", run.result.energy);
    assert!(run.demands.unwrap().base_shear.is_none());
    assert!(run.assumptions.iter().any(|a| a.contains("Coulomb friction")));
}

/// The slender tank on twelve anchors of 20 MN/m and a yield force.
fn anchored(yield_force: f64) -> Case {
    let mut case = shaken(slender(), 3.0, 50);
    case.tank.support = Support::Anchored;
    case.tank.anchors = Some(tank::Anchors {
        count: 12,
        capacity: Some(yield_force),
        attachment_capacity: None,
        stiffness: Some(2e7),
        yield_force: Some(yield_force),
        gap: None,
        rupture_elongation: None,
    });
    case
}

/// Strong anchors stay elastic and hold the foot down more than none; weak ones yield at their force, and the balance closes with their work.
#[test]
fn anchors_hold_the_foot_and_yield() {
    let free = peak(&run(&shaken(slender(), 3.0, 50), 8, 12), Channel::Uplift(Side::Front));
    let (strong, weak) = (run(&anchored(1e9), 8, 12), run(&anchored(1e4), 8, 12));
    let lifted = [&strong, &weak].map(|run| peak(run, Channel::Uplift(Side::Front)));
    assert!(lifted[0] < lifted[1] && lifted[1] < free * 1.05, "{lifted:?} {free}");
    let force = peak(&strong, Channel::AnchorForce);
    // The force is that of the recorded instants, the uplift that of every step.
    assert!((force / (2e7 * lifted[0]) - 1.0).abs() < 5e-3, "{force} {lifted:?}");
    assert!((peak(&weak, Channel::AnchorForce) / 1e4 - 1.0).abs() < 1e-6);
    for run in [&strong, &weak] {
        assert_eq!(run.result.end, End::Completed);
        assert!(run.result.energy.unwrap().error.abs() < 1e-3);
        assert!(run.assumptions.iter().any(|a| a.contains("Anchors are elastic-plastic")));
    }
    let judged = weak.demands.unwrap().base.unwrap().anchor.unwrap();
    assert!((judged.value / (2e7 * lifted[1]) - 1.0).abs() < 0.02, "{judged:?}");
}

/// Under a roof of 400 t the foot does not leave the ground: the tank is one that is anchored so that it cannot, whose anchors are never stretched,
/// to the rounding of the iteration.
#[test]
fn a_heavy_roof_keeps_the_foot_down() {
    let mut case = shaken(slender(), 0.5, 30);
    case.tank.roof.mass = 4e5;
    let free = run(&case, 6, 8);
    case.tank.support = Support::Anchored;
    case.tank.anchors = anchored(1e12).tank.anchors;
    let held = run(&case, 6, 8);
    for channel in [Channel::BaseShear, Channel::BaseMoment, Channel::Top] {
        let [a, b] = [&free, &held].map(|run| peak(run, channel));
        assert!((a / b - 1.0).abs() < 1e-6, "{channel:?}: {a} {b}");
    }
    for side in Side::BOTH {
        assert_eq!(peak(&free, Channel::Uplift(side)), 0.0);
    }
    assert_eq!(peak(&held, Channel::AnchorForce), 0.0);
}

/// Tangents of the wall that are kept and the liquid as an operator give the march of full Newton with the liquid as a dense block: two
/// formulations of one system. The criterion of contact leaves a relative error of 1e-9 of the increment of a step (|δu·r| ≤ 1e-18 of
/// its first value); 30 steps in which points of the ground open and close, multiplied by their differences of stiffness, leave 1e-6.
/// The criterion by default leaves 1e-4 of an increment: 1e-3 after the same steps.
#[test]
fn kept_tangents_are_full_newton() {
    let case = shaken(slender(), 4.0, 30);
    let own = options(&case, 8, 12);
    let (expected, full) = marched(&case, &own, false);
    let exact = fem::analysis::newton::Options::for_contact().criteria;
    let (found, kept) = marched_to(&case, &own, true, Some(exact));
    let (usual, _) = marched(&case, &own, true);
    for (found, allowed) in [(&found, 1e-6), (&usual, 1e-3)] {
        for (k, (a, b)) in found.iter().zip(&expected).enumerate() {
            let largest = b.iter().fold(0.0_f64, |m, v| m.max(v.abs()));
            let apart = a.iter().zip(b).map(|(a, b)| (a - b).abs()).fold(0.0, f64::max);
            assert!(apart < allowed * largest, "{k}: {apart} of {largest}");
        }
    }
    assert!(full.cost.wholes == 0 && kept.cost.wholes > 0);
    assert!(kept.cost.wholes * 5 < full.cost.factors, "{:?} {:?}", kept.cost, full.cost);
    assert!(kept.balance.error() < 1e-6);
}

/// Processor time of this process so far [s]; 0 where the system does not say.
fn processor_time() -> f64 {
    let stat = std::fs::read_to_string("/proc/self/stat").unwrap_or_default();
    let ticks = stat.split_whitespace().skip(13).take(2).filter_map(|t| t.parse::<f64>().ok());
    ticks.sum::<f64>() / 100.0
}

/// Steps of a tank of usual size on its bottom, rows x half sectors @ steps of 5 ms under 3 m/s² of 2 Hz, and what they cost:
/// `SIZES="60x48@20" cargo test -p engines --lib measured_tank -- --ignored --nocapture`
#[test]
#[ignore = "slow: a measurement, cargo test -p engines --lib measured_tank -- --ignored --nocapture; numbers in docs/performance.md"]
fn measured_tank() {
    let sizes = std::env::var("SIZES").unwrap_or_else(|_| "30x24@20".into());
    for size in sizes.split_whitespace() {
        let numbers: Vec<u32> = size.split(['x', '@']).filter_map(|n| n.parse().ok()).collect();
        let [rows, half, steps] = numbers[..] else {
            panic!("{size}: rows x half sectors @ steps");
        };
        let mut case = slender();
        case.tank.shape = Shape::Cylinder { radius: 17.5 };
        let course = case.tank.courses[0].clone();
        let courses = [12.0, 11.0, 10.0, 9.0, 8.0, 8.0].map(|t| {
            let mut course = course.clone();
            course.height = 2.25;
            course.thickness = 1e-3 * t;
            course
        });
        case.tank.courses = courses.to_vec();
        case.liquid.fill_height = 12.0;
        if let Some(bottom) = &mut case.tank.bottom {
            bottom.thickness = 8e-3;
        }
        let mut case = shaken(case, 3.0, steps as usize);
        if let Some(motion) = &mut case.ground_motion {
            motion.horizontal.dt = 5e-3;
            let sine = (0..=steps).map(|k| 3.0 * (std::f64::consts::TAU * 2.0 * 5e-3 * f64::from(k)).sin());
            motion.horizontal.acceleration = sine.collect();
        }
        let own = NonlinearOptions { time_step: Some(5e-3), ..options(&case, rows, 2 * half) };
        let before = processor_time();
        let tank = CylinderModel::new(&case, &own).unwrap();
        let built = processor_time();
        let zone = tank.zone.as_ref().map(|zone| zone.sizes());
        let cylinder = Cylinder::of(&case, &own, tank).unwrap();
        // The rest, then all steps: their difference is that of the steps.
        let mut spent = Vec::new();
        for scale in [0.0, 1.0] {
            let begin = processor_time();
            let motion = case.ground_motion.as_ref().unwrap();
            let (watch, run) = cylinder.march(motion, scale, 1, None, &Silent).unwrap();
            let uplift = watch.recorder.ranges.iter().map(|r| r.max).fold(0.0, f64::max);
            spent.push(processor_time() - begin);
            println!(
                "{size} scale {scale}: {:.2} s, {:?}, {uplift:.3e}, {:?} statics",
                spent[spent.len() - 1],
                run.cost,
                run.statics.map(|path| path.steps)
            );
        }
        println!("{size}: zone {zone:?}, model {:.2} s", built - before);
    }
}
