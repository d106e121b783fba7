//! Example 8.2: the perspex model tank of Pal et al. (2001).

use std::f64::consts::TAU;
use std::fmt::Write as _;

use engines::solid::Liquid;
use engines::{DampingModel, Simulation};
use oscillator::record::Record;
use tank::reference::{case, material};
use tank::units::significant;
use tank::{Case, Shape};

use super::sheet::{Line, columns, line, omega, options, peak, runs, shaken, table};
use crate::Failure;
use crate::tanks::G;

/// Table 8.8: depth [m], test and simulation [Hz].
const FREQUENCIES: [(f64, &str, &str); 5] = [
    (0.03, "1.513", "1.580"),
    (0.06, "1.873", "1.978"),
    (0.09, "1.916", "2.116"),
    (0.12, "1.969", "2.159"),
    (0.15, "2.078", "2.171"),
];

/// Table 8.9 and figure 8.6.
const WAVE: [Line; 2] =
    [line("largest wave", "mm", &["6.1", "6.0"]), line("largest wave from 100 s to 150 s", "mm", &["6.1", ""])];

fn tank(depth: f64) -> Case {
    let perspex = material(3.3e9, 0.3, 1500.0);
    let mut case = case(Shape::Cylinder { radius: 0.096 }, &[(0.225, 6e-3)], &perspex, (1e4 / G, depth));
    case.damping.sloshing = 1e-3;
    case.damping.impulsive = 1e-3;
    case
}

/// Ground motion of 5 mm at 1.2 Hz from rest, 150 s.
fn motion() -> Record {
    let (omega, dt) = (TAU * 1.2, 0.02);
    let acceleration = (0..=7500).map(|i| -5e-3 * omega * omega * (omega * dt * f64::from(i)).sin());
    Record { name: "harmonic".into(), dt, acceleration: acceleration.collect(), processing: Vec::new() }
}

fn wave(run: &Simulation) -> Vec<f64> {
    const WAVE: &str = "wave_height_theta_0";
    let Some(column) = run.series.ids.iter().position(|id| id == WAVE) else {
        return vec![f64::NAN; 2];
    };
    let history = run.series.time.iter().zip(&run.series.columns[column]);
    let late = history.filter(|(t, _)| **t >= 100.0);
    let late = late.map(|(_, v)| v.abs()).fold(0.0, f64::max);
    vec![1e3 * peak(run, WAVE).abs(), 1e3 * late]
}

/// The section.
pub(super) fn section() -> Result<String, Failure> {
    let mut text = String::from("## Example 8.2: perspex model tank (tables 8.8 and 8.9)\n\n");
    let mut found = Vec::new();
    let shaking = motion();
    for (depth, test, printed) in FREQUENCIES {
        let case = shaken(tank(depth), &shaking);
        let runs = runs(&case, &options(DampingModel::Modal, &[]), Liquid::Potential)?;
        if found.is_empty() {
            let titles: Vec<&str> = runs.iter().map(|(title, _)| title.as_str()).collect();
            let _ = writeln!(
                text,
                "First sloshing frequency [Hz]:\n\n| depth [cm] | test | printed | {} |",
                titles.join(" | ")
            );
            let _ = writeln!(text, "|---|---|---|{}", "---|".repeat(titles.len()));
        }
        let values: Vec<String> = runs.iter().map(|(_, run)| significant(omega(run) / TAU, 4)).collect();
        let _ = writeln!(text, "| {} | {test} | {printed} | {} |", significant(1e2 * depth, 2), values.join(" | "));
        found.push((case, runs));
    }
    let (case, modal) = &found[2];
    // 0.1 % at the first sloshing frequency and at that of cos 2θ, which no horizontal motion excites.
    let second = (3.054_24 * G / 0.096 * (3.054_24 * 0.09_f64 / 0.096).tanh()).sqrt();
    let first = (1.841_18 * G / 0.096 * (1.841_18 * 0.09_f64 / 0.096).tanh()).sqrt();
    let rayleigh = DampingModel::Coefficients {
        mass: 2.0 * 1e-3 * first * second / (first + second),
        stiffness: 2.0 * 1e-3 / (first + second),
    };
    text.push_str(
        "\nGround motion of 5 mm at 1.2 Hz from rest, 9 cm of water. Rayleigh damping of 0.1 % at the first two sloshing \
         frequencies as the dissertation has it:\n\n",
    );
    let own = runs(case, &options(rayleigh, &[]), Liquid::Potential)?;
    table(&mut text, &["printed", "test"], &WAVE, &columns(&own, wave));
    text.push_str("Modal damping of 0.1 %:\n\n");
    table(&mut text, &["printed", "test"], &WAVE, &columns(modal, wave));
    Ok(text)
}
