//! The code procedures on an oil tank of today's size (examples/05), one by one and all together as `check` runs them.
//!
//! `cargo bench --bench codes`. The aim for the whole of `check` is 50 ms, reading and writing included; the procedures
//! under record and site are what it computes.

use std::hint::black_box;
use std::path::Path;

use codes::ALL;
use criterion::{Criterion, criterion_group, criterion_main};
use oscillator::record::Record;
use tank::Case;
use tank::assessment::Excitation;

/// 2688 samples at 0.02 s, the length of the El Centro record: three decaying oscillations.
fn record() -> Record {
    let wave = |t: f64, amplitude: f64, omega: f64, decay: f64| amplitude * (omega * t).sin() * (-decay * t).exp();
    Record {
        name: "three decaying oscillations".into(),
        dt: 0.02,
        acceleration: (0..2688)
            .map(|i| f64::from(i) * 0.02)
            .map(|t| wave(t, 2.0, 15.7, 0.2) + wave(t, 1.5, 6.1, 0.1) + wave(t, 0.5, 1.1, 0.05))
            .collect(),
        processing: vec![],
    }
}

/// Example 05 with the record.
fn case() -> Case {
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("examples/05_oil_tank/tank.json");
    let file = tankcheck::input::read_tank(&path).unwrap_or_else(|e| panic!("examples/05 is readable: {e}"));
    let mut case = file.case;
    case.ground_motion = Some(tank::case::GroundMotion { horizontal: record(), transverse: None, vertical: None });
    case
}

fn procedures(c: &mut Criterion) {
    let case = case();
    let mut group = c.benchmark_group("procedure");
    for procedure in ALL {
        for excitation in [Excitation::Record, Excitation::Site] {
            if procedure.applies(&case, excitation).is_err() {
                continue;
            }
            let id = format!("{}/{excitation:?}", procedure.id());
            group.bench_function(id, |b| b.iter(|| black_box(procedure.assess(black_box(&case), excitation))));
        }
    }
    group.finish();
    c.bench_function("all procedures, record and site", |b| {
        b.iter(|| {
            for procedure in ALL {
                for excitation in [Excitation::Record, Excitation::Site] {
                    let _ = black_box(procedure.assess(black_box(&case), excitation));
                }
            }
        })
    });
}

criterion_group!(benches, procedures);
criterion_main!(benches);
