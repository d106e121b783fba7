//! Waves that are not small: crest and trough over the linear wave, the factors of the codes' comparison, and the time of a
//! long record.
//!
//! `cargo run --release -p fem --example large_wave` (`-- factors` prints the table of `tank::large_wave`)

use std::time::Instant;

use fem::liquid::large_wave::{Basis, Liquid, Motion, Properties, RESONANCE, Sampled, Side, run};

const RADIUS: f64 = 10.0;
/// Shares by which the crest is higher where the factor is read: its larger value counts.
const HIGHER: [f64; 2] = [0.1, 0.2];

fn own(share: f64, order: usize) -> Properties {
    Properties { depth: share * RADIUS, density: 1000.0, gravity: 9.81, damping: 0.005, order }
}

fn main() {
    if std::env::args().any(|a| a == "factors") {
        return factors();
    }
    if std::env::args().any(|a| a == "time") {
        return record();
    }
    println!("crest and trough over the linear wave, three cycles in resonance; rows H/R, columns eta/R");
    let cylinder = Basis::cylinder(RADIUS, 4, Side::Cosine);
    for share in [0.2, 0.3, 0.4, 0.5, 0.6, 0.75, 1.0, 1.5, 2.0] {
        print!("{share:5}");
        for rise in [0.025, 0.05, 0.1, 0.2] {
            match RESONANCE.ratios(&cylinder, own(share, 3), rise * RADIUS) {
                Ok([crest, trough]) => print!("  {crest:.3} / {trough:.3}"),
                Err(stop) => print!("  {:?} {:.1} s ", stop.reason, stop.time),
            }
        }
        println!("  c {:.3}", factor(&cylinder, share));
    }
    record();
}

/// Time of a record of 300 s in a tank with T = 7 s.
fn record() {
    let basis = Basis::cylinder(21.35, 4, Side::Cosine);
    let liquid =
        Liquid::new(basis, Properties { depth: 14.0, density: 870.0, gravity: 9.81, damping: 0.005, order: 3 });
    let omega = liquid.omega().iter().copied().filter(|&w| w > 0.0).fold(f64::MAX, f64::min);
    let samples = (0..30_000).map(|i| {
        let t = 0.01 * f64::from(i);
        Motion::along_x(0.02 * (omega * t).sin() * (0.05 * t).sin() + 1.5 * (9.0 * t).sin() * (-0.05 * t).exp())
    });
    let record = Sampled::new(0.01, samples.collect());
    let start = Instant::now();
    let found = run(&liquid, &record, record.duration(), None, |motion| motion);
    let march = start.elapsed();
    let forces = liquid.forces(found.frames());
    println!(
        "300 s, {} modes, {} steps: march {:.3} s, with forces {:.3} s; crest {:.2} m, volume {:.1e} m, energy {:.1e}, stop {:?}",
        liquid.basis().modes().len(),
        found.len(),
        march.as_secs_f64(),
        start.elapsed().as_secs_f64(),
        found.extremes(&liquid, [21.35, 0.0])[0].1,
        found.volume_error,
        found.energy_error(),
        found.stop
    );
    let worst = |f: &dyn Fn(usize) -> f64| (0..forces.len()).map(f).fold(0.0_f64, |a, b| a.max(b.abs()));
    println!(
        "largest shear {:.4e} N, largest difference of that by pressures {:.1e}",
        worst(&|i| forces[i].shear[0]),
        worst(&|i| forces[i].shear[0] - forces[i].pressure_shear[0]) / worst(&|i| forces[i].shear[0])
    );
}

/// Factors c over H/R of a cylinder and over 2H/L of a strip.
fn factors() {
    let cylinder = Basis::cylinder(RADIUS, 4, Side::Cosine);
    let strip = Basis::strip(2.0 * RADIUS, 1.0, 16);
    for share in [0.2, 0.25, 0.3, 0.35, 0.4, 0.45, 0.5, 0.55, 0.6, 0.65, 0.7, 0.75, 0.8, 0.9, 1.0, 1.25, 1.5, 2.0, 3.0]
    {
        println!("    ({share:?}, {:.2}, {:.2}),", factor(&cylinder, share), factor(&strip, share));
    }
}

fn factor(basis: &Basis, share: f64) -> f64 {
    HIGHER.into_iter().filter_map(|higher| RESONANCE.factor(basis, own(share, 3), higher).ok()).fold(f64::NAN, f64::max)
}
