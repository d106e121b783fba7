//! Sliding in time.
//!
//! Source:    an independent program
//! Model:     `base::history` of a rigid body that does not turn
//! Reference: slip of a rectangular pulse, A² t₀²/(2 μ g) − A t₀²/2; range of the slip of a harmonic motion,
//!            2 A/ω² √(1 − (π η/2)²) with η = μ g/A below 0.537; normal force of a steady vertical acceleration; an independent program
//! Tolerance: closed forms 1e-3: each end of the pulse is a step long, 3e-4 of it at 0.1 ms; a step of 0.2 ms turns a motion of 2 Hz by
//!            1e-3 rad between places where sliding may turn round; independent program 1 %: printed digits, and its step

use std::f64::consts::{FRAC_PI_2, TAU};

use ::base::history::{Body, Friction, History, Run, march};

use super::{GRAVITY, failure};
use crate::benchmark::{Benchmark, Part};
use crate::{Answer, Failure, Reference, Row};

pub(crate) const BENCHMARK: Benchmark = Benchmark {
    id: "base-sliding",
    title: "Sliding in time",
    model: "A rigid body of 1000 kg on dry friction. El Centro NS as in textbooks (0.319 g), at 1 ms.",
    ids: &[
        ("U14", "slip of a rectangular pulse"),
        ("U15", "range of the slip of a harmonic motion"),
        ("U16", "slip under El Centro"),
        ("U17", "a steady vertical acceleration as more or less weight"),
    ],
    parts: &[Part::Fast(closed_forms), Part::Fast(el_centro)],
};

const MASS: f64 = 1000.0;

fn slide(ground: &[f64], step: f64, coefficient: f64, vertical: Vec<f64>) -> Result<History, Failure> {
    let body = Body { modes: Vec::new(), mass: MASS, first_moment: 0.0, second_moment: 0.0 };
    march(&Run {
        body: &body,
        law: None,
        ring: None,
        heave: None,
        waves: None,
        hysteretic: 0.0,
        dashpot: 0.0,
        friction: Some(Friction { coefficient, weight: MASS * GRAVITY, vertical, springs: Vec::new(), delay: 0.0 }),
        rigid_pressure: [0.0; 2],
        step,
        ground,
    })
    .map_err(failure)
}

/// Slip at the end, largest, and way [m].
fn slips(history: &History) -> [f64; 3] {
    let largest = history.slip.iter().fold(0.0, |m: f64, s| m.max(s.abs()));
    let way = history.slip.windows(2).map(|w| (w[1] - w[0]).abs()).sum();
    [history.slip.last().copied().unwrap_or(f64::NAN).abs(), largest, way]
}

fn pulse(vertical: f64) -> Result<[f64; 2], Failure> {
    let (a, t0, mu, step) = (0.5 * GRAVITY, 0.3, 0.2, 1e-4);
    let ground: Vec<f64> = (0..20_000).map(|i| if f64::from(i) * step < t0 - 0.5 * step { a } else { 0.0 }).collect();
    let up = if vertical == 0.0 { Vec::new() } else { vec![vertical; ground.len()] };
    let [found, ..] = slips(&slide(&ground, step, mu, up)?);
    let held = mu * GRAVITY * (1.0 + vertical);
    Ok([a * a * t0 * t0 / (2.0 * held) - a * t0 * t0 / 2.0, found])
}

fn closed_forms() -> Answer {
    let mut rows = Vec::new();
    let source = "A² t₀²/(2 μ N/m) − A t₀²/2";
    let [expected, found] = pulse(0.0)?;
    let what = "0.5 g for 0.3 s, μ = 0.2";
    let closed = (expected, source, Reference::ClosedForm);
    rows.push(Row::new("U14", what, closed, found, (1e-3, "m")));
    for vertical in [-0.4, 0.4] {
        let [expected, found] = pulse(vertical)?;
        let what = format!("0.5 g for 0.3 s, μ = 0.2, N = m (g + a_v) with a_v = {vertical} g");
        let closed = (expected, source, Reference::ClosedForm);
        rows.push(Row::new("U17", what, closed, found, (1e-3, "m")));
    }
    let (a, omega, step) = (0.4 * GRAVITY, 2.0 * TAU, 2e-4);
    for eta in [0.1, 0.3, 0.5] {
        let ground: Vec<f64> = (0..200_000).map(|i| a * (omega * step * f64::from(i)).sin()).collect();
        let history = slide(&ground, step, eta * a / GRAVITY, Vec::new())?;
        // The last period.
        let last = &history.slip[history.slip.len() - 2_500..];
        let (low, high) = last.iter().fold((f64::MAX, f64::MIN), |(l, h), s| (l.min(*s), h.max(*s)));
        let expected = 2.0 * a / (omega * omega) * (1.0 - (FRAC_PI_2 * eta).powi(2)).sqrt();
        rows.push(Row::new(
            "U15",
            format!("0.4 g at 2 Hz, μ g/A = {eta}"),
            (expected, "2 A/ω² √(1 − (π η/2)²)", Reference::ClosedForm),
            high - low,
            (1e-3, "m"),
        ));
    }
    Ok(rows)
}

/// Factor on the record, μ, and slip at the end, largest, and way [mm].
const EL_CENTRO: [(f64, f64, [f64; 3]); 4] = [
    (1.0, 0.2, [1.70, 3.25, 8.28]),
    (1.0, 0.1, [13.84, 29.43, 144.2]),
    (2.0, 0.4, [3.40, 6.50, 16.56]),
    (3.0, 0.4, [23.72, 49.72, 196.9]),
];

fn el_centro() -> Answer {
    const PARTS: u32 = 20;
    let text = include_str!("../../../../examples/records/elcentro.csv");
    let record: Vec<f64> =
        (text.lines()).filter_map(|line| line.split_once(',')?.1.trim().parse::<f64>().ok()).collect();
    let ground: Vec<f64> = (record.windows(2))
        .flat_map(|pair| (0..PARTS).map(move |i| pair[0] + (pair[1] - pair[0]) * f64::from(i) / f64::from(PARTS)))
        .map(|a| a * GRAVITY)
        .collect();
    let step = 0.02 / f64::from(PARTS);
    let mut rows = Vec::new();
    for (factor, mu, expected) in EL_CENTRO {
        let scaled: Vec<f64> = ground.iter().map(|a| factor * a).collect();
        let found = slips(&slide(&scaled, step, mu, Vec::new())?);
        for ((what, expected), found) in ["slip at the end", "largest slip", "way"].into_iter().zip(expected).zip(found)
        {
            rows.push(Row::new(
                "U16",
                format!("{what}, El Centro × {factor}, μ = {mu}"),
                (expected, "independent program", Reference::SecondFormulation),
                1e3 * found,
                (0.01, "mm"),
            ));
        }
    }
    let [_, still, _] = slips(&slide(&ground, step, 0.4, Vec::new())?);
    let zero = (0.0, "0.319 g is less than μ g", Reference::ClosedForm);
    rows.push(Row::new("U16", "largest slip, El Centro × 1, μ = 0.4", zero, 1e3 * still, (1e-12, "mm")));
    Ok(rows)
}
