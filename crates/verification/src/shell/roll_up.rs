//! S14: a strip rolled up by an end moment.

use std::f64::consts::PI;

use super::bent_strip::{path, strip};
use super::path::{Problem, iterations};
use super::{Answer, Case};
use crate::{Benchmark, Part, Reference};
use fem::element::shell::load::NodalLoads;

/// The page.
pub(crate) const BENCHMARK: Benchmark = Benchmark {
    id: "shell-roll-up",
    title: "Shell: strip rolled up",
    model: "Strip of 12 × 1 × 0.1, E = 1.2·10⁶, ν = 0, an end moment of 2π E I/L bends it to a ring.",
    ids: &[("S14", "strip rolled up by an end moment")],
    parts: &[Part::Tested(|| roll_up(&[20, 40]))],
};

/// S14: end moment 2π E I/L rolls a strip of length 12 into a ring, `elements` elements.
pub(super) fn roll_up(meshes: &[usize]) -> Answer {
    let case = Case { id: "S14", source: "circle of radius E I/M", unit: "length" };
    let length = 12.0;
    let (mut study, mut counts) = (Vec::new(), Vec::new());
    for &n in meshes {
        let (builder, tip) = strip(length, n)?;
        let mut loads = NodalLoads::new();
        // Upwards: about −y.
        let moment = 2.0 * PI * 100.0 / length;
        tip.iter().for_each(|&n| loads.moment(n, [0.0, -0.5 * moment, 0.0]));
        let problem = Problem::new(builder, &loads)?;
        let (curve, count) = path(&problem, 6, true, tip[0])?;
        if n == 40 {
            let (_, plain) = path(&problem, 10, false, tip[0])?;
            counts = iterations(&case, count, Some(plain), (46, 109));
        }
        study.push((n as f64, curve[2], curve[5]));
    }
    let mut rows = Vec::new();
    let Some(&(n, half, full)) = study.last() else { return Ok(rows) };
    let expected = [
        ("u at half the moment", -12.0, half[0]),
        ("w at half the moment", 24.0 / PI, half[2]),
        ("u at the full moment", -12.0, full[0]),
    ];
    for (what, reference, value) in expected {
        // 1 % of the length (sheet): a polygon of n sides instead of the circle.
        let tolerance = 0.01 * length / f64::abs(reference);
        rows.push(case.row(format!("{what}, {n} elements"), Reference::ClosedForm, reference, value, tolerance));
    }
    rows.push(case.row(
        format!("w at the full moment, {n} elements"),
        Reference::ClosedForm,
        0.0,
        full[2],
        0.01 * length,
    ));
    if let Some(row) = rows.get_mut(2) {
        row.convergence = study.iter().map(|(n, _, full)| (*n, full[0] / -12.0 - 1.0)).collect();
    }
    rows.extend(counts);
    Ok(rows)
}
