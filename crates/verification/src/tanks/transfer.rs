//! Transfer functions of the harmonic engine against potential flow in a rigid cylinder, and against a history.
//!
//! A rigid cylinder under a(t) = cos Ωt has, with λ_n the zeros of J_1' and viscous damping of each sloshing mode,
//!
//! ```text
//! V = m_0 + Σ m_n (ω_n² + 2 i ξ ω_n Ω) D_n        m_n = m_l 2 R tanh(λ_n H/R)/(λ_n (λ_n² − 1) H)        m_0 = m_l − Σ m_n
//! η = −Σ 2/(λ_n² − 1) R/g ω_n² D_n                ω_n² = g λ_n/R tanh(λ_n H/R)        D_n = 1/(ω_n² − Ω² + 2 i ξ ω_n Ω)
//! ```
//!
//! η at θ = 0 of as many modes as the engine counts, five. Source: Housner 1957; Abramson 1966; EN 1998-4, A.2.

use std::f64::consts::TAU;

use nalgebra::Complex;

use super::{exact, row};
use crate::{Answer, Benchmark, Part, Reference, Row};
use engines::{FeError, Options, Simulation, simulate};
use oscillator::record::Record;
use tank::case::GroundMotion;
use tank::options::frequency::FrequencyOptions;
use tank::reference::{GRAVITY, broad, case, material};
use tank::{Case, Shape};

/// The page.
pub(crate) const BENCHMARK: Benchmark = Benchmark {
    id: "transfer-functions",
    title: "Transfer functions under harmonic base motion",
    model: "Harmonic engine. A cylinder with a practically rigid wall without mass (E = 10¹⁶ Pa), R = 10 m, 8 m of water, sloshing \
            damped by 0.5 %, mesh with twice the default elements in each direction; and tank 8.1 (ρ = 1 t/m³, sloshing damped by 5 %) at \
            0.6 Hz beside its own history under 90 s of that motion.",
    ids: &[
        ("transfer-1", "magnitudes of the rigid cylinder at multiples of its first sloshing frequency, 1 is resonance"),
        ("transfer-2", "phases of the rigid cylinder at resonance"),
        ("transfer-3", "distance of the history's last ten periods from the steady state, over its magnitude"),
    ],
    parts: &[Part::Fast(rigid), Part::Fast(history)],
};

const SOURCE: &str = "potential flow, modes with viscous damping";
/// Radius and depth [m], ratio of each sloshing mode.
const RIGID: (f64, f64, f64) = (10.0, 8.0, 0.005);
/// Zeros of J_1' (Abramowitz & Stegun 1964, table 9.5).
const ZEROS: [f64; 5] = [1.841_184, 5.331_443, 8.536_316, 11.706_005, 14.863_589];

/// Base shear and wave at the wall per unit of acceleration at Ω [rad/s], each with the sum of the sizes of its parts: between resonances they
/// cancel.
fn potential_flow(omega: f64) -> [(Complex<f64>, f64); 2] {
    let (radius, depth, ratio) = RIGID;
    let liquid = 1000.0 * std::f64::consts::PI * radius * radius * depth;
    let (mut shear, mut wave) = (Complex::new(liquid, 0.0), Complex::new(0.0, 0.0));
    let mut sizes = [liquid, 0.0];
    for zero in ZEROS {
        let own = exact(radius, depth, zero);
        let share = zero * zero - 1.0;
        let mass = liquid * 2.0 * radius * (zero * depth / radius).tanh() / (zero * share * depth);
        let damped = Complex::new(own * own, 2.0 * ratio * own * omega);
        let parts = [
            mass * (damped / (damped - omega * omega) - 1.0),
            -2.0 / share * radius / GRAVITY * own * own / (damped - omega * omega),
        ];
        shear += parts[0];
        wave += parts[1];
        sizes.iter_mut().zip(parts).for_each(|(size, part)| *size += part.norm());
    }
    [(shear, sizes[0]), (wave, sizes[1])]
}

/// Frequencies [Hz], magnitudes or phases of a function, by the beginning of their head.
fn numbers(found: &results::Part, begin: &str) -> Result<Vec<f64>, FeError> {
    let series = found.table("transfer");
    let own = series.and_then(|series| series.columns.iter().find(|own| own.id.starts_with(begin)));
    match (series, own) {
        (Some(series), Some(own)) => Ok(series.column(&own.id)),
        _ => Err(FeError::Analysis(format!("no column {begin} of transfer functions"))),
    }
}

fn run(case: &Case, record: (f64, Vec<f64>), options: &Options) -> Result<(Simulation, results::Part), FeError> {
    let mut case = case.clone();
    case.ground_motion = Some(GroundMotion {
        horizontal: Record { name: "harmonic".into(), dt: record.0, acceleration: record.1, processing: Vec::new() },
        transverse: None,
        vertical: None,
    });
    let found = simulate(&case, options)?;
    let transfer = found.result.part("transfer").cloned();
    let transfer = transfer.ok_or_else(|| FeError::Analysis("no transfer functions".into()))?;
    Ok((found, transfer))
}

/// Ω = ω_1/2, ω_1/√2, ω_1, √2 ω_1 and 2 ω_1.
///
/// Errors: a failure of the engine.
fn rigid() -> Answer {
    let (radius, depth, ratio) = RIGID;
    let stiff = material(1e16, 0.3, 1.0);
    let shape = Shape::Cylinder { radius };
    let mut tank = case(shape, &[(1.05 * depth, 0.05)], &stiff, (1000.0, depth));
    tank.damping.sloshing = ratio;
    let first = exact(radius, depth, ZEROS[0]);
    let options = Options {
        refine: 2.0,
        mesh_error: false,
        frequency: Some(FrequencyOptions {
            from: Some(0.5 * first),
            to: Some(2.0 * first),
            points: 5,
            ..FrequencyOptions::DEFAULT
        }),
        ..Options::default()
    };
    let (_, found) = run(&tank, (0.01, vec![0.0, 0.1, 0.0]), &options)?;
    let mut rows = Vec::new();
    let tables = [("base_shear", "base shear", "N s²/m"), ("wave_height", "wave at the wall", "s²")];
    for (name, multiple) in [("1/2", 0.5), ("1/√2", 0.5_f64.sqrt()), ("1", 1.0), ("√2", 2.0_f64.sqrt()), ("2", 2.0)]
    {
        let omega = multiple * first;
        let frequency = numbers(&found, "frequency_hz")?;
        let at = frequency.iter().position(|f| (f * TAU / omega - 1.0).abs() < 1e-9);
        let at = at.ok_or_else(|| FeError::Analysis(format!("{omega} rad/s is not among the frequencies")))?;
        for ((id, title, unit), (expected, size)) in tables.iter().zip(potential_flow(omega)) {
            let magnitude = numbers(&found, &format!("{id}_magnitude"))?;
            let phase = numbers(&found, &format!("{id}_phase"))?;
            // Masses of the default mesh err by 0.2 %, with twice the elements by at most a quarter of it; the first frequency by 1e-5,
            // which is 0.001 of the half-width of the peak. Modes beyond the fifth have 0.1 % of the shear's static part and are in
            // the total mass: 3e-3 in all, of the sum of the parts.
            rows.push(row(
                "transfer-1",
                format!("{title}, Ω = {name} ω_1"),
                SOURCE,
                (expected.norm(), 3e-3 * size / expected.norm()),
                magnitude[at],
                unit,
            ));
            if multiple == 1.0 {
                // A phase turns by 1 rad over the half-width of the peak: 1e-5/0.005 of it.
                rows.push(row(
                    "transfer-2",
                    format!("{title}, phase at resonance"),
                    SOURCE,
                    (expected.arg(), 3e-3),
                    phase[at],
                    "rad",
                ));
            }
        }
    }
    Ok(rows)
}

/// A start of ten periods, which has died away to e^(−0.05 · 3.0 · 60) = 1e-4 after 60 s; the record is linear between 200 samples a period,
/// (2π/200)²/12 = 1e-4. 1 % of amplitude and phase is asked for.
///
/// Errors: a failure of the engine.
fn history() -> Answer {
    let mut tank = broad(1000.0);
    tank.damping.sloshing = 0.05;
    let frequency = 0.6_f64;
    let omega = TAU * frequency;
    let options = Options {
        mesh_error: false,
        frequency: Some(FrequencyOptions {
            from: Some(omega),
            to: Some(1.001 * omega),
            points: 2,
            ..FrequencyOptions::DEFAULT
        }),
        ..Options::default()
    };
    let (dt, last) = (1.0 / (200.0 * frequency), (90.0 * 200.0 * frequency) as usize);
    let record: Vec<f64> =
        (0..=last).map(|k| k as f64 * dt).map(|t| (t * frequency / 10.0).min(1.0) * (omega * t).cos()).collect();
    let (run, found) = run(&tank, (dt, record), &options)?;
    let mut rows = Vec::new();
    for (id, column, title) in [
        ("wave_height", "wave_height_theta_0", "wave"),
        ("base_shear", "base_shear", "base shear"),
        ("overturning_moment", "overturning_moment", "overturning moment"),
    ] {
        let place = run.series.ids.iter().position(|c| c == column);
        let history = place.map(|place| &run.series.columns[place]);
        let history = history.ok_or_else(|| FeError::Analysis(format!("no history {column}")))?;
        let mut sum = Complex::new(0.0, 0.0);
        for i in last - 2000..last {
            sum += history[i] * Complex::new(0.0, -omega * run.series.time[i]).exp() / 1000.0;
        }
        let first = |what: &str| Ok::<f64, FeError>(numbers(&found, &format!("{id}_{what}"))?[0]);
        let steady = Complex::from_polar(first("magnitude")?, first("phase")?);
        let reference = (0.0, "the engine's own time history", Reference::SecondFormulation);
        rows.push(Row::new("transfer-3", title, reference, (sum - steady).norm() / steady.norm(), (0.01, "–")));
    }
    Ok(rows)
}
