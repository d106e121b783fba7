//! Example 8.3: slender steel tank, five depths.

use std::fmt::Write as _;

use engines::solid::Liquid;
use engines::{DampingModel, Simulation};
use oscillator::record::Record;
use tank::reference::slender;

use super::sheet::{Line, columns, line, omega, options, peak, runs, shaken, table};
use crate::Failure;
use crate::tanks::G;

/// Table 8.10: depth [m], wave [cm], axial stress [N/mm²].
const PRINTED: [(f64, [Line; 3]); 5] = [
    (3.0, lines(&["3.16"], &["40"], &["6.55"])),
    (3.5, lines(&["3.17"], &["39"], &["9.57"])),
    (4.0, lines(&["3.17"], &["39"], &["13.34"])),
    (4.5, lines(&["3.17"], &["38"], &["17.78"])),
    (5.0, lines(&["3.17"], &["38"], &["22.80"])),
];

const fn lines(
    omega: &'static [&'static str],
    wave: &'static [&'static str],
    axial: &'static [&'static str],
) -> [Line; 3] {
    [
        line("first sloshing frequency", "rad/s", omega),
        line("wave at the wall, record as described", "cm", wave),
        line("axial membrane stress at the base", "N/mm²", axial),
    ]
}

/// 1 % and 2 % at the first two shapes, 3.17 and 4.32 rad/s; the coefficients are not printed.
const DAMPING: DampingModel = DampingModel::Coefficients { mass: -0.0646, stiffness: 0.01273 };

fn values(run: &Simulation) -> Vec<f64> {
    vec![omega(run), 1e2 * peak(run, "wave_height_theta_0"), peak(run, "axial_membrane_stress_base") / 1e6]
}

/// The section, for El Centro as described.
pub(super) fn section(record: &Record) -> Result<String, Failure> {
    let mut text = String::from("## Example 8.3: slender tank (table 8.10), El Centro\n\n");
    for (damping, name) in [
        (DAMPING, "Rayleigh damping of 1 % and 2 % at 3.17 and 4.32 rad/s (a_M = −0.0646 1/s, a_K = 0.01273 s)"),
        (DampingModel::Modal, "Damping by kind (sloshing 1 %, wall 2 %)"),
    ] {
        let _ = writeln!(text, "### {name}\n");
        for (depth, lines) in &PRINTED {
            let mut case = slender(1e4 / G, *depth);
            case.damping.sloshing = 0.01;
            let case = shaken(case, record);
            let found = runs(&case, &options(damping, &[]), Liquid::Potential)?;
            let _ = writeln!(text, "Depth {depth:.1} m:\n");
            table(&mut text, &["printed"], lines, &columns(&found, values));
        }
    }
    Ok(text)
}
