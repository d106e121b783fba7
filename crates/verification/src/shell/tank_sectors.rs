//! S11: a polygon for a circle.

use super::tank::*;
use super::{Answer, Case};
use crate::{Benchmark, Part, Reference};
use fem::element::shell4::MembraneShear;

/// The page.
pub(crate) const BENCHMARK: Benchmark = Benchmark {
    id: "shell-tank-sectors",
    title: "Shell: a polygon for a circle",
    model: "Wall of tank 8.1 by the number of its sectors.",
    ids: &[("S11", "wall of tank 8.1 by the number of sectors")],
    parts: &[Part::Fast(|| sectors(&[16, 32, 64]))],
};

/// S11, gate: the polygon error is all that is left.
pub(super) fn sectors(counts: &[usize]) -> Answer {
    let case = Case { id: "S11", source: "independent prototype on the same mesh", unit: "over closed form" };
    let prototype = [(16, 0.982), (32, 0.996), (64, 1.000), (128, 1.001)];
    let mut rows = Vec::new();
    for &n in counts {
        let [w, ..] = ratios(n, MembraneShear::CentrePoint)?;
        let Some(&(_, reference)) = prototype.iter().find(|p| p.0 == n) else { continue };
        // Printed to three digits (0.0005), read at the nodes or between them (0.0005).
        let what = format!("largest w, {n} sectors, 200 elements");
        rows.push(case.row(what, Reference::SecondFormulation, reference, w, 0.0015));
    }
    Ok(rows)
}
