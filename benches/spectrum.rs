//! Response spectrum of 200 periods over 2688 points: the kernel, and one oscillator after the other beside it.

use std::hint::black_box;

use criterion::{Criterion, criterion_group, criterion_main};
use oscillator::record::Record;
use oscillator::sdof;
use oscillator::spectrum::{Method, spectrum};

/// The record named by `SPECTRUM_RECORD` (columns `time_s,acceleration_…`), or noise under an envelope.
fn record() -> Record {
    if let Ok(path) = std::env::var("SPECTRUM_RECORD") {
        let options = tankcheck::input::records::ReadOptions::default();
        return tankcheck::input::records::read(path.as_ref(), &options).expect("a readable record").record;
    }
    let mut seed = 1u64;
    let acceleration = (0..2688)
        .map(|k| {
            seed = seed.wrapping_mul(6364136223846793005).wrapping_add(1442695040888963407);
            let x = f64::from(k) / 2688.0;
            ((seed >> 33) as f64 / f64::from(1u32 << 31) - 0.5) * 20.0 * x * (-6.0 * x).exp()
        })
        .collect();
    Record { name: "noise".into(), dt: 0.02, acceleration, processing: Vec::new() }
}

fn bench(c: &mut Criterion) {
    let record = record();
    let periods: Vec<f64> = (0..200).map(|i| 0.02 * 1000f64.powf(f64::from(i) / 199.0)).collect();
    c.bench_function("spectrum/kernel, continuous maxima", |b| {
        b.iter(|| spectrum(black_box(&record), &periods, &[0.02], Method::Exact));
    });
    c.bench_function("spectrum/one after the other, samples only", |b| {
        b.iter(|| {
            let peak = |t: &f64| {
                let history = sdof::exact(&record.acceleration, record.dt, std::f64::consts::TAU / t, 0.02);
                history.u.iter().fold(0.0, |m: f64, u| m.max(u.abs()))
            };
            periods.iter().map(peak).sum::<f64>()
        });
    });
    c.bench_function("spectrum/Duhamel, 10 periods", |b| {
        b.iter(|| spectrum(black_box(&record), &periods[100..110], &[0.02], Method::Duhamel));
    });
}

criterion_group!(benches, bench);
criterion_main!(benches);
