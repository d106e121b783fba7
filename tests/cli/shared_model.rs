//! One model under several records against runs of their own.

use std::path::Path;

use engines::{Options, Shared, simulate};
use fem::progress::Silent;
use oscillator::record::Record;
use tank::Case;
use tank::case::GroundMotion;
use tankcheck::input::{read_tank, records};

fn root() -> &'static Path {
    Path::new(env!("CARGO_MANIFEST_DIR"))
}

fn case(tank: &str) -> (Case, Options) {
    let file = read_tank(&root().join(tank)).unwrap_or_else(|e| panic!("{e}"));
    (file.case, file.fe)
}

fn motion(number: usize) -> GroundMotion {
    let path = root().join(format!("examples/10_tank_farm/records/synthetic-{number:03}.csv"));
    let read = records::read(&path, &records::ReadOptions::default()).unwrap_or_else(|e| panic!("{e}"));
    let horizontal: Record = read.record;
    GroundMotion { horizontal, transverse: None, vertical: None }
}

/// Of the record whose content reaches highest the run is that of the engine by itself, on the same mesh: rounding. Of the others the mesh is finer
/// than their own: 1 %. The estimated mesh errors are those of a run by itself, and a quick run has the same values.
#[test]
fn a_shared_model_gives_the_runs_of_each_record() {
    let (case, options) = case("examples/01_broad_tank/tank.json");
    let motions = [1, 2, 3].map(motion);
    let shared = Shared::new(&case, &options, &motions.each_ref()).unwrap_or_else(|e| panic!("{e}"));
    let mut same = 0;
    for motion in &motions {
        let quick = shared.run(motion, false, &Silent).unwrap_or_else(|e| panic!("{e}"));
        let mut thorough = shared.run(motion, true, &Silent).unwrap_or_else(|e| panic!("{e}"));
        shared.finish(&mut thorough, motion).unwrap_or_else(|e| panic!("{e}"));
        let alone = Case { ground_motion: Some(motion.clone()), ..case.clone() };
        let own = simulate(&alone, &options).unwrap_or_else(|e| panic!("{e}"));
        assert_eq!(quick.values, thorough.values);
        let mut largest = 0.0_f64;
        for (quantity, value) in &own.values {
            let found = thorough.values[quantity];
            largest = largest.max((found / value - 1.0).abs());
        }
        assert!(largest < 1e-2, "{largest}");
        if own.result.mesh == thorough.result.mesh {
            same += 1;
            assert!(largest < 1e-9, "{largest}");
            for (quantity, error) in &own.result.mesh_error {
                let found = thorough.result.mesh_error[quantity];
                assert!((found - error).abs() < 1e-9 + 1e-6 * error, "{quantity}: {found} {error}");
            }
        }
    }
    assert!(same >= 1, "no record has the mesh of the set");
}

/// Processor seconds of this process so far, of all threads.
fn processor() -> f64 {
    let stat = std::fs::read_to_string("/proc/self/stat").unwrap_or_default();
    let after = stat.rsplit(')').next().unwrap_or_default();
    let ticks: Vec<f64> = after.split_whitespace().filter_map(|w| w.parse().ok()).collect();
    // User and system time stand eleventh and twelfth after the state; a tick is 10 ms.
    0.01 * (ticks.get(10).copied().unwrap_or(0.0) + ticks.get(11).copied().unwrap_or(0.0))
}

/// Processor time of the engine: eleven records on one model against one record by itself, both with the estimated mesh error.
#[test]
#[ignore = "slow: a measurement, cargo test --test cli eleven_records -- --ignored --nocapture; last result in docs/verification/slow-tests.md"]
fn eleven_records_cost_two_and_a_half_times_one() {
    let mut ratios = Vec::new();
    for tank in ["examples/01_broad_tank/tank.json", "examples/05_oil_tank/tank.json"] {
        let (case, options) = case(tank);
        let first = motion(1);
        let alone = Case { ground_motion: Some(first.clone()), ..case.clone() };
        let before = processor();
        let count = 3;
        for _ in 0..count {
            simulate(&alone, &options).unwrap_or_else(|e| panic!("{e}"));
        }
        let one = (processor() - before) / f64::from(count);
        // Seven records, four of them with the other sign: other motions for a base that lifts, and for the codes.
        let mut motions: Vec<GroundMotion> = (1..=7).map(motion).collect();
        for k in 0..4 {
            let mut other = motions[k].clone();
            other.horizontal.acceleration.iter_mut().for_each(|a| *a *= -0.97);
            motions.push(other);
        }
        let before = processor();
        let all: Vec<&GroundMotion> = motions.iter().collect();
        let shared = Shared::new(&case, &options, &all).unwrap_or_else(|e| panic!("{e}"));
        let built = processor() - before;
        for (i, motion) in motions.iter().enumerate() {
            let mut run = shared.run(motion, i == 0, &Silent).unwrap_or_else(|e| panic!("{e}"));
            if i == 0 {
                shared.finish(&mut run, motion).unwrap_or_else(|e| panic!("{e}"));
            }
        }
        let eleven = processor() - before;
        println!(
            "{tank}: one {one:.2} s, eleven {eleven:.2} s ({:.2} times), of which the model {built:.2} s",
            eleven / one
        );
        ratios.push(eleven / one);
    }
    assert!(ratios.iter().all(|ratio| *ratio < 2.5), "{ratios:?}");
}
