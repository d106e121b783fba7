//! Unanchored walls on their bottom.

use fem::progress::Silent;
use results::Channel;
use results::channel::Side;
use results::nonlinear::End;
use tank::{Behaviour, Bottom, Case, Foundation, FoundationKind, Shape, Steel, Support};

use super::super::super::simulate;
use super::super::march::Cylinder;
use super::super::model::CylinderModel;
use super::{marched, options, shaken};
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
    case.tank.support = Support::Unanchored;
    case.tank.bottom = Some(Bottom {
        thickness: 6e-3,
        corrosion: 0.0,
        width: None,
        sketch: None,
        projection: 0.0,
        subgrade_modulus: None,
        material: steel,
    });
    case.tank.foundation = Some(Foundation {
        kind: FoundationKind::Soil,
        stiffness: Some(1e8),
        shear_wave_velocity: None,
        soil_density: 1900.0,
        soil_poisson_ratio: 0.33,
        thickness: None,
        friction: None,
    });
    case
}

/// The shock lifts the foot on one side by millimetres and presses it on the other, where the wall is compressed; the plate yields at
/// its weld. Work and energies agree to rounding, since the ground is elastic: 1e-6 of the energy put in.
#[test]
fn a_shock_lifts_the_foot() {
    let case = shaken(slender(), 3.0, 50);
    let run = simulate(&case, &options(&case, 8, 12), None, &Silent).unwrap();
    assert_eq!(run.result.end, End::Completed);
    let peak = |channel: Channel| {
        let found = run.result.histories.iter().find(|h| h.id == channel.id());
        found.map(|h| h.peak).unwrap()
    };
    let [front, back] = Side::BOTH.map(|side| peak(Channel::Uplift(side)));
    assert!(front > 1e-3 && back < 1e-4, "{front} {back}");
    let extremes = &run.result.nonlinear.as_ref().unwrap().extremes;
    let pressed = |side: Side| {
        let of = extremes.iter().find(|e| e.title == Channel::Uplift(side).title());
        of.and_then(|e| e.min.as_ref()).map(|m| m.value).unwrap()
    };
    assert!(pressed(Side::Back) < 2.0 * pressed(Side::Front), "toe");
    assert!(peak(Channel::ToeStress) > 1e6 && peak(Channel::BaseRotation) > 1e-4);
    let plastic = extremes
        .iter()
        .find(|e| e.title.starts_with("Plastic rotation"))
        .unwrap();
    assert!(plastic.max.value > 0.0);
    assert!(run.result.energy.unwrap().error.abs() < 1e-6);
    assert!(run.assumptions.iter().any(|a| a.contains("does not slide")));
    assert!(run.notes.iter().all(|n| !n.contains("clamps")));
}

/// Tangents of the wall that are kept and the liquid as an operator give the march of full Newton with the liquid as a dense block: two
/// formulations of one system. The criterion of contact leaves a relative error of 1e-9 of the increment of a step (|δu·r| ≤ 1e-18 of
/// its first value); 60 steps in which points of the ground open and close, multiplied by their differences of stiffness, leave 1e-6.
#[test]
fn kept_tangents_are_full_newton() {
    let case = shaken(slender(), 4.0, 60);
    let own = options(&case, 8, 12);
    let (expected, full) = marched(&case, &own, false);
    let (found, kept) = marched(&case, &own, true);
    for (k, (a, b)) in found.iter().zip(&expected).enumerate() {
        let largest = b.iter().fold(0.0_f64, |m, v| m.max(v.abs()));
        let apart = a.iter().zip(b).map(|(a, b)| (a - b).abs()).fold(0.0, f64::max);
        assert!(apart < 1e-6 * largest, "{k}: {apart} of {largest}");
    }
    assert!(full.cost.wholes == 0 && kept.cost.wholes > 0);
    assert!(
        kept.cost.wholes * 5 < full.cost.factors,
        "{:?} {:?}",
        kept.cost,
        full.cost
    );
    assert!(kept.balance.error() < 1e-6);
}

/// Processor time of this process so far [s]; 0 where the system does not say.
fn processor_time() -> f64 {
    let stat = std::fs::read_to_string("/proc/self/stat").unwrap_or_default();
    let ticks = stat
        .split_whitespace()
        .skip(13)
        .take(2)
        .filter_map(|t| t.parse::<f64>().ok());
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
        let own = NonlinearOptions {
            time_step: Some(5e-3),
            ..options(&case, rows, 2 * half)
        };
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
