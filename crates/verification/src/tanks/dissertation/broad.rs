//! Example 8.1: statics, frequencies and three records.

use std::fmt::Write as _;

use engines::solid::Liquid;
use engines::{DampingModel, Simulation, simulate};
use oscillator::record::Record;
use tank::reference::broad;
use tank::units::significant;

use super::sheet::{Line, columns, line, omega, options, peak, runs, shaken, table};
use crate::Failure;
use crate::tanks::G;

const STATIC: [Line; 5] = [
    line("first sloshing frequency", "rad/s", &["3.02"]),
    line("largest radial displacement, hydrostatic", "mm", &["0.296"]),
    line("largest hoop force, hydrostatic", "kN/m", &["22.4"]),
    line("moment at the base, hydrostatic", "kNm/m", &["-0.007"]),
    line("axial force at the base, own weight", "kN/m", &["-0.084"]),
];

/// Tables 8.4 to 8.7, a record each.
const DYNAMIC: [[Line; 6]; 3] = [
    dynamic(&["38.6", "13.4"], &["1.11", "4.90"], &["4.83", "4.9"], &["5.6", "5.87"]),
    dynamic(&["4.4", "3.1"], &["0.9", "4.15"], &["4.55", "4.97"], &["5.15", "6.44"]),
    dynamic(&["11.4", "15.5"], &["0.8", "4.61"], &["3.85", "5.12"], &["4.42", "6.74"]),
];

const fn dynamic(
    wave: &'static [&'static str],
    axial: &'static [&'static str],
    hoop: &'static [&'static str],
    bending: &'static [&'static str],
) -> [Line; 6] {
    [
        line("wave at the wall, record as described", "cm", wave),
        line("axial membrane stress at the base", "N/mm²", axial),
        line("hoop stress at z = 5 cm", "N/mm²", hoop),
        line("hoop stress at z = 10 cm", "N/mm²", &["", ""]),
        line("bending stress at the base", "N/mm²", bending),
        line("base shear", "kN", &["", ""]),
    ]
}

/// Coefficients that the dissertation prints.
const PRINTED: DampingModel = DampingModel::Coefficients { mass: -0.0604, stiffness: 0.013205 };

/// Thickness of the lower course [m].
const THICKNESS: f64 = 2.03e-3;

fn statics(run: &Simulation) -> Vec<f64> {
    let line = |id: &str| run.result.envelopes.iter().find(|e| e.id == id);
    let most = |values: &mut dyn Iterator<Item = f64>| values.fold(f64::NEG_INFINITY, f64::max);
    let displacement = line("radial_displacement").map_or(f64::NAN, |e| most(&mut e.static_.iter().copied()));
    // The hoop force is largest in the lower course.
    let hoop = line("hoop_stress").map_or(f64::NAN, |e| {
        let lower = e.z.iter().zip(&e.static_).filter(|(z, _)| **z < 0.5);
        most(&mut lower.map(|(_, s)| *s))
    });
    let series = |id: &str| {
        let found = run.result.histories.iter().find(|s| s.id == id);
        found.map_or(f64::NAN, |s| s.static_value)
    };
    vec![
        omega(run),
        1e3 * displacement,
        hoop * THICKNESS / 1e3,
        series("wall_moment_base") / 1e3,
        series("axial_membrane_stress_base") * THICKNESS / 1e3,
    ]
}

fn dynamics(run: &Simulation) -> Vec<f64> {
    vec![
        1e2 * peak(run, "wave_height_theta_0"),
        peak(run, "axial_membrane_stress_base") / 1e6,
        peak(run, "hoop_stress_z_0.05") / 1e6,
        peak(run, "hoop_stress_z_0.1") / 1e6,
        peak(run, "bending_stress_base") / 1e6,
        peak(run, "base_shear") / 1e3,
    ]
}

/// The section; records as (name, as recorded, as described).
pub(super) fn section(records: &[(&str, Record, Record)]) -> Result<String, Failure> {
    let mut text = String::from("## Example 8.1: broad tank (tables 8.2 to 8.7)\n\n");
    let mut tank = broad(1e4 / G);
    tank.damping.sloshing = 0.01;
    let asked = |damping| options(damping, &[0.05, 0.1]);
    for (liquid, name) in [
        (Liquid::Potential, "potential liquid"),
        (Liquid::Displacement, "displacement liquid (mean dilatation, split penalty, joined by `contact8`)"),
    ] {
        for (i, (record, _, motion)) in records.iter().enumerate() {
            // The second liquid is a check of the first: one record is enough.
            if liquid == Liquid::Displacement && i > 0 {
                continue;
            }
            let case = shaken(tank.clone(), motion);
            let found = runs(&case, &asked(PRINTED), liquid)?;
            if i == 0 {
                let _ = writeln!(text, "### Frequency and statics, {name}\n");
                table(&mut text, &["printed"], &STATIC, &columns(&found, statics));
            }
            let heads = ["printed", "test"];
            let _ = writeln!(
                text,
                "### {record}, {name}\n\nPrinted Rayleigh damping (a_M = −0.0604 1/s, a_K = 0.013205 s):\n"
            );
            table(&mut text, &heads, &DYNAMIC[i], &columns(&found, dynamics));
            let _ = writeln!(text, "Damping by kind (sloshing 1 %, wall 2 %):\n");
            let right = runs(&case, &asked(DampingModel::Modal), liquid)?;
            table(&mut text, &heads, &DYNAMIC[i], &columns(&right, dynamics));
        }
    }
    text.push_str("### The wave under the records as they were recorded\n\n");
    text.push_str(
        "Harmonic engine, sloshing 1 %, at the wall. The printed 38.6 cm of El Centro is met by the original record, neither \
         scaled nor compressed; the record as described gives a third of that, as the shaking table measured.\n\n",
    );
    text.push_str(
        "| record | printed [cm] | test [cm] | as described [cm] | as recorded [cm] |\n|---|---|---|---|---|\n",
    );
    for ((record, original, motion), lines) in records.iter().zip(&DYNAMIC) {
        let wave = |motion: &Record| -> Result<String, Failure> {
            let run = simulate(&shaken(tank.clone(), motion), &options(DampingModel::Modal, &[]))?;
            Ok(significant(1e2 * peak(&run, "wave_height_theta_0"), 3))
        };
        let [printed, test] = [0, 1].map(|i| lines[0].sources[i]);
        let _ = writeln!(text, "| {record} | {printed} | {test} | {} | {} |", wave(motion)?, wave(original)?);
    }
    text.push('\n');
    Ok(text)
}
