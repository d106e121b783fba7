//! The linear engine: assembly of one harmonic and its eigenmodes, on the default mesh of example 8.1 and refined.
//!
//! Each benchmark also checks the answer: the first bulging frequency of the broad tank, 164.67 rad/s within 0.3 %.

use std::hint::black_box;

use criterion::{Criterion, criterion_group, criterion_main};
use engines::Options;
use engines::harmonic::build;
use engines::modes::{Kind, solve};

fn harmonic(c: &mut Criterion) {
    let file = concat!(env!("CARGO_MANIFEST_DIR"), "/examples/01_broad_tank/tank.json");
    let case = tankcheck::input::read_tank(file.as_ref()).expect("the example is valid").case;
    for refine in [1.0, 2.0] {
        let options = Options { refine, ..Options::default() };
        let coupled = build(&case, &options, 1).expect("the example is modelled");
        let count = coupled.surface.unknowns.len() + 20;
        let modes = solve(&coupled, Some(count)).expect("the modes are resolved");
        let bulging = modes.iter().find(|m| m.kind == Kind::Structural).expect("the wall is flexible");
        assert!((bulging.omega / 164.67 - 1.0).abs() < 0.003, "{}", bulging.omega);

        let unknowns = coupled.mass.rows;
        c.bench_function(&format!("build, {unknowns} unknowns"), |b| {
            b.iter(|| build(black_box(&case), &options, 1));
        });
        c.bench_function(&format!("{count} lowest modes, {unknowns} unknowns"), |b| {
            b.iter(|| solve(black_box(&coupled), Some(count)));
        });
    }
}

criterion_group! {
    name = benches;
    config = Criterion::default().sample_size(20);
    targets = harmonic
}
criterion_main!(benches);
