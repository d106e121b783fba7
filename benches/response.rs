//! Response analyses of the broad tank (dissertation example 8.1) under 54 s of made-up broad-band motion, 31 s after
//! compression of time: modes, superposition with envelopes, a step of direct integration, the whole `simulate`.
//!
//! `cargo bench --bench response`

use std::hint::black_box;

use criterion::{Criterion, criterion_group, criterion_main};

#[path = "../crates/verification/tests/models/motions.rs"]
#[allow(dead_code)]
mod motions;

use engines::damping::Damper;
use engines::harmonic::build;
use engines::modes::solve;
use engines::response::direct::{self, DirectSystem};
use engines::response::motion::{Grid, Motion};
use engines::response::superpose::{self, ModalSystem, Observable};
use engines::{Options, simulate};
use tank::Case;
use tank::case::GroundMotion;
use tank::reference::broad;

fn shaken() -> Case {
    let mut case = broad(1000.0);
    case.ground_motion =
        Some(GroundMotion { horizontal: motions::broad_band(0.0115, 31.0), transverse: None, vertical: None });
    case
}

fn response(c: &mut Criterion) {
    let case = shaken();
    let options = Options::default();
    let horizontal = &case.ground_motion.as_ref().expect("the case is shaken").horizontal;
    let coupled = build(&case, &options, 1).expect("the tank is sound");
    let modes = solve(&coupled, None).expect("the tank is sound");
    let damper = Damper::new(&case, &options.damping).expect("the damping is sound");
    c.bench_function("modes", |b| b.iter(|| solve(black_box(&coupled), None)));

    let grid = Grid::new(horizontal.dt, horizontal.duration(), 4.2, 7.7e-4);
    let motion = Motion::new(horizontal, &grid);
    let kept = superpose::keep(&coupled, &modes, &damper, 5);
    let system = ModalSystem::new(&coupled, kept, &damper).expect("the tank is sound");
    let systems = [system];
    let of = |p| -> Observable { vec![(0, 1.0, p)] };
    let scalars: Vec<Observable> = coupled.probes.iter().map(of).collect();
    let lines: Vec<Observable> = coupled.lines.iter().flat_map(|l| &l.probes).map(of).collect();
    println!("{} unknowns, {} sub-steps, {} probes on lines", coupled.influence.len(), grid.steps(), lines.len());
    c.bench_function("superposition, histories and envelopes", |b| {
        b.iter(|| superpose::respond(black_box(&systems), &[&motion], grid, &scalars, &lines, &fem::progress::Silent));
    });

    let direct_system = [DirectSystem::new(&coupled, &modes, &damper)];
    let short = Grid { samples: 1 + 1000 / grid.sub_steps, ..grid };
    let mut group = c.benchmark_group("direct");
    group.sample_size(10);
    group.bench_function("1000 steps with histories and envelopes", |b| {
        b.iter(|| {
            direct::respond(black_box(&direct_system), &[&motion], short, &scalars, &lines, &fem::progress::Silent)
        });
    });
    group.finish();

    let mut group = c.benchmark_group("whole");
    group.sample_size(10);
    group.bench_function("simulate", |b| b.iter(|| simulate(black_box(&case), &options)));
    group.finish();
}

criterion_group!(benches, response);
criterion_main!(benches);
