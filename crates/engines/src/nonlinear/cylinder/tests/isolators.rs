//! A cylinder on isolators against the linear engine.

use std::f64::consts::TAU;

use tank::{Bearing, Isolators};

use super::*;

/// The tank of [`super::soil`] on these bearings under two tones, of the period of the bearings and faster.
fn tank(bearing: Bearing) -> Case {
    let mut case = super::soil::tank(None);
    let slab_mass = 2500.0 * 0.6 * std::f64::consts::PI * 25.0;
    case.tank.isolators = Some(Isolators {
        bearing,
        damper: None,
        slab_mass,
        slab_thickness: 0.6,
        bounds: [0.6, 1.8],
        displacement_capacity: None,
    });
    let of = |i: usize| {
        let t = 0.01 * i as f64;
        let tones = (TAU * 0.45 * t).sin() + 0.6 * (TAU * 1.7 * t).sin() + 0.4 * (TAU * 4.0 * t).sin();
        2.5 * (0.5 * TAU * t / 5.0).sin().powi(2) * tones
    };
    case.ground_motion.as_mut().unwrap().horizontal.acceleration = (0..=500).map(of).collect();
    case
}

/// Set before: displacement, force and base shear on isolators within 3 % of those of the linear engine on a coarse mesh, bearings that slide and
/// bearings that yield. The energies of the tank close, and the forces of the last run are those under which its slab has moved within 3 %.
#[test]
fn isolators_act_as_in_the_linear_engine() {
    let yielded = 1.03e6 * (TAU / 2.5_f64).powi(2);
    for bearing in [
        Bearing::FrictionPendulum { radius: 2.0, friction: 0.06, slow: 0.03, rate: 50.0, slip: 1e-3 },
        Bearing::LeadRubber { strength: 0.05 * 1.03e6 * 9.81, initial: 10.0 * yielded, yielded },
    ] {
        let case = tank(bearing);
        let linear = fe::simulate(&case, &fe::Options { mesh_error: false, ..fe::Options::default() }).unwrap();
        let own = simulate(&case, &options(&case, 12, 24), None, &Silent).unwrap();
        assert_eq!(own.result.end, End::Completed);
        assert!(own.result.energy.as_ref().unwrap().error < 1e-4, "{:?}", own.result.energy);
        let n = own.series.time.len();
        for id in ["isolator_displacement", "isolator_force", "base_shear", "base_moment"] {
            let [found, expected] = [&own, &linear].map(|s| super::soil::peak(&super::soil::column(s, id)[..n]));
            assert!((found / expected - 1.0).abs() < 0.03, "{bearing:?} {id}: {found} {expected}");
        }
        let part = own.result.part("isolation").unwrap();
        let change = part.said("isolation-balance-another", "change").unwrap();
        assert!(change < 0.03, "{change}");
        assert_eq!(own.demands.unwrap().isolation.unwrap().bounds.len(), 2);
    }
}

/// Interrupted in the first run and in the second, under the motion of a slab that the first has corrected, and resumed: the same to the last bit.
#[test]
fn run_on_isolators_resumed_is_uninterrupted() {
    let bearing = Bearing::FrictionPendulum { radius: 2.0, friction: 0.06, slow: 0.03, rate: 50.0, slip: 1e-3 };
    let mut case = tank(bearing);
    case.ground_motion.as_mut().unwrap().horizontal.acceleration.drain(..250);
    case.ground_motion.as_mut().unwrap().horizontal.acceleration.truncate(21);
    let own = options(&case, 4, 8);
    // Steps of the stages before and of both runs.
    let all = StopAfter { left: AtomicU64::new(u64::MAX) };
    let straight = simulate(&case, &own, None, &all).unwrap();
    let steps = u64::MAX - all.left.load(Ordering::Relaxed);
    for stop in [steps / 3, steps * 5 / 6] {
        let folder = tempfile::tempdir().unwrap();
        let file = |resume| CheckpointFile { path: folder.path().join("run.checkpoint"), key: "a".into(), resume };
        let stop = StopAfter { left: AtomicU64::new(stop) };
        let part = simulate(&case, &own, Some(&file(false)), &stop).unwrap();
        assert!(part.result.incomplete && part.series.time.len() < straight.series.time.len());
        let resumed = simulate(&case, &own, Some(&file(true)), &Silent).unwrap();
        assert_eq!(resumed.series, straight.series);
        assert_eq!(resumed.values, straight.values);
    }
}
