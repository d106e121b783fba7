//! Stress laws, nanoseconds per point: `cargo bench -p materials`.
//!
//! A point follows a path and commits every step; the time is that of one step. The minimum of many runs is printed,
//! which is least affected by other load. Goals: fibres of beams 15 ns; layers 100 ns elastic, 1.5 µs cracking.

use std::hint::black_box;
use std::time::Instant;

use materials::Law;
use materials::bar::Bar;
use materials::concrete::{
    Compression, CrackedConcrete, CrackedParameters, PostPeak, Softening, Tension, UniaxialConcrete,
};
use materials::drucker_prager::DruckerPrager;
use materials::plastic_fracturing::{Parameters, PlasticFracturing};
use materials::von_mises::VonMises;

/// Runs a law along a path repeatedly, each time from the initial state.
fn along<const N: usize>(name: &str, law: &dyn Law<N>, path: &[[f64; N]]) {
    let (mut old, mut new) = (vec![0.0; law.history_len()], vec![0.0; law.history_len()]);
    let mut least = f64::INFINITY;
    for _ in 0..2000 {
        law.init_history(&mut old);
        let start = Instant::now();
        for strain in path {
            let _ = black_box(law.respond(black_box(strain), &old, &mut new));
            std::mem::swap(&mut old, &mut new);
        }
        least = least.min(start.elapsed().as_secs_f64());
    }
    println!("{name:24} {:7.1} ns", 1e9 * least / path.len() as f64);
}

/// The same, by [`UniaxialConcrete::update`].
fn direct(name: &str, law: &UniaxialConcrete, path: &[[f64; 1]]) {
    let (mut old, mut new) = ([0.0; 5], [0.0; 5]);
    let mut least = f64::INFINITY;
    for _ in 0..2000 {
        law.init_history(&mut old);
        let start = Instant::now();
        for strain in path {
            black_box(law.update(black_box(strain[0]), &old, &mut new).stress[0]);
            std::mem::swap(&mut old, &mut new);
        }
        least = least.min(start.elapsed().as_secs_f64());
    }
    println!("{name:24} {:7.1} ns", 1e9 * least / path.len() as f64);
}

/// Path of `steps` steps.
fn path<const N: usize>(steps: usize, at: impl Fn(f64) -> [f64; N]) -> Vec<[f64; N]> {
    (1..=steps).map(|i| at(i as f64 / steps as f64)).collect()
}

fn concrete() {
    let tension = Tension {
        strength: 3.5e6,
        softening: Softening::Energy { fracture_energy: 100.0, size: 0.1 },
        stiffening: None,
        bond: None,
    };
    let sargin = Compression::Sargin {
        strength: 35e6,
        peak_strain: 2.2e-3,
        post_peak: PostPeak::Crushing { crushing_energy: 25e3, size: 0.2 },
    };
    let fibre = UniaxialConcrete::new(34e9, sargin, Some(tension)).expect("admissible");
    let layer = CrackedConcrete::new(&CrackedParameters::new(34e9, 0.2, 35e6, tension)).expect("admissible");
    // Growing cycles of bending under compression, as in an earthquake.
    let wave = |t: f64| (t * 60.0).sin() * t;
    along("fibre, elastic", &fibre, &path(1000, |t| [8e-5 * wave(t)]));
    along("fibre, cracking", &fibre, &path(1000, |t| [2e-3 * t]));
    along("fibre, crushing", &fibre, &path(1000, |t| [-4e-3 * t]));
    along("fibre, cyclic", &fibre, &path(1000, |t| [-4e-4 * t + 2e-3 * wave(t)]));
    let plane = |size: f64, wave: f64| [size * wave, -0.3 * size * wave, 0.4 * size * wave];
    // Without the trait, as the fibres of a beam call it.
    direct("fibre, cyclic, direct", &fibre, &path(1000, |t| [-4e-4 * t + 2e-3 * wave(t)]));
    along("layer, elastic", &layer, &path(1000, |t| plane(6e-5, wave(t))));
    along("layer, cracking", &layer, &path(1000, |t| plane(2e-3, t)));
    along("layer, two cracks", &layer, &path(1000, |t| [2e-3 * t, 1.5e-3 * t, 1e-3 * t]));
    along("layer, flow", &layer, &path(1000, |t| plane(-2e-3, t)));
    along("layer, cyclic", &layer, &path(1000, |t| plane(1e-3, wave(t))));
}

/// Steel and the cone: an elastic path, and one that flows at nearly every step.
fn plasticity() {
    let steel = VonMises::new(210e9, 0.3, 355e6, 2.1e9, 0.5).expect("admissible");
    let low_cycle =
        steel.with_saturation(80e6, 25.0).and_then(|law| law.with_back_stress(60e9, 500.0)).expect("admissible");
    let cone = DruckerPrager::new(34e9, 0.2, 35e6, 40.6e6).expect("admissible");
    let damage = PlasticFracturing::new(&Parameters {
        young_modulus: 34e9,
        poisson_ratio: 0.2,
        strength: 35e6,
        biaxial: 40.6e6,
        peak_strain: 2.2e-3,
        crushing_energy: 25e3,
        length: 0.1,
    })
    .expect("admissible");
    let bar = Bar::new(210e9, 500e6, 2.1e9).expect("admissible");
    let layer = |size: f64| path(1000, move |t| [1.0, -0.2, 0.4].map(|x| size * t * x));
    let brick = |size: f64| path(1000, move |t| [1.0, -0.2, -0.4, 0.4, 0.0, 0.1].map(|x| size * t * x));
    for (state, strain) in [("elastic", 1e-3), ("plastic", 0.2)] {
        along(&format!("bar, {state}"), &bar, &path(1000, |t| [strain * t]));
        along(&format!("steel fibre, {state}"), &steel, &path(1000, |t| [strain * t]));
        along(&format!("steel layer, {state}"), &steel, &layer(strain));
        along(&format!("low-cycle, {state}"), &low_cycle, &layer(strain));
        along(&format!("steel brick, {state}"), &steel, &brick(strain));
    }
    for (state, strain) in [("elastic", -2e-4), ("plastic", -0.1)] {
        along(&format!("cone layer, {state}"), &cone, &layer(strain));
        along(&format!("cone brick, {state}"), &cone, &brick(strain));
        along(&format!("damage layer, {state}"), &damage, &layer(strain));
    }
}

fn main() {
    concrete();
    plasticity();
}
