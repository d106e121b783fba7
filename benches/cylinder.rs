//! The nonlinear cylinder on its bottom: model and 40 steps of 5 ms of the tank of `benches/cylinder/tank.json` with half of its
//! elements each way, under a sine of 0.4 g and 2 Hz, on one thread and on all. docs/performance.md has the whole tank.
//!
//! `cargo bench --bench cylinder`

use std::hint::black_box;

use criterion::{Criterion, criterion_group, criterion_main};
use engines::nonlinear::{NonlinearOptions, WallElements, simulate};
use fem::progress::Silent;
use oscillator::record::Record;
use results::Channel;
use results::channel::Side;
use tank::case::GroundMotion;

fn cylinder(c: &mut Criterion) {
    let file = concat!(env!("CARGO_MANIFEST_DIR"), "/benches/cylinder/tank.json");
    let read = tankcheck::input::read_tank(file.as_ref()).expect("the file is valid");
    let mut case = read.case;
    let dt = 0.01;
    let gravity = case.gravity;
    let sine = |k: i32| 0.4 * gravity * (std::f64::consts::TAU * 2.0 * dt * f64::from(k)).sin();
    case.ground_motion = Some(GroundMotion {
        horizontal: Record {
            name: "sine".into(),
            dt,
            acceleration: (0..=20).map(sine).collect(),
            processing: Vec::new(),
        },
        transverse: None,
        vertical: None,
    });
    let options = NonlinearOptions { elements: Some(WallElements { height: 30, circumference: 48 }), ..read.nonlinear };
    let run = || simulate(black_box(&case), &options, None, &Silent).expect("the tank is modelled");
    let found = run();
    // The shock of 0.4 g lifts one side and not the other, and the energies agree.
    let lifted = |side| {
        let of = found.result.histories.iter().find(|h| h.id == Channel::Uplift(side).id());
        of.map_or(0.0, |h| h.peak)
    };
    let [front, back] = Side::BOTH.map(lifted);
    assert!(front.max(back) > 1e-3, "{front} {back}");
    assert!(found.result.energy.is_some_and(|e| e.error < 1e-3));
    for threads in [1, 0] {
        fem::cores::limit(threads);
        let of = if threads == 1 { "one thread" } else { "all threads" };
        c.bench_function(&format!("cylinder on its bottom, 40 steps, {of}"), |b| b.iter(run));
    }
}

criterion_group! {
    name = benches;
    config = Criterion::default().sample_size(10);
    targets = cylinder
}
criterion_main!(benches);
