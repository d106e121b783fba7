//! S13: finite rotations of a cantilever under an end force.

use super::bent_strip::{path, strip};
use super::path::{Problem, iterations};
use super::{Answer, Case};
use crate::{Benchmark, Part, Reference};
use fem::element::shell::load::NodalLoads;

/// The page.
pub(crate) const BENCHMARK: Benchmark = Benchmark {
    id: "shell-cantilever",
    title: "Shell: cantilever under an end force",
    model: "Strip of 10 × 1 × 0.1, E = 1.2·10⁶, ν = 0, 20 elements, end force of 4 (Sze, Liu & Lo 2004).",
    ids: &[("S13", "cantilever under an end force, finite rotations")],
    parts: &[Part::Tested(cantilever)],
};

/// S13: end force 4 on a strip of length 10, 20 elements.
pub(super) fn cantilever() -> Answer {
    let case = Case { id: "S13", source: "Sze, Liu & Lo 2004", unit: "length" };
    let (builder, tip) = strip(10.0, 20)?;
    let mut loads = NodalLoads::new();
    tip.iter().for_each(|&n| loads.force(n, [0.0, 0.0, 2.0]));
    let problem = Problem::new(builder, &loads)?;
    let (curve, count) = path(&problem, 4, true, tip[0])?;
    let (_, plain) = path(&problem, 4, false, tip[0])?;
    let mut rows = iterations(&case, count, Some(plain), (18, 35));
    for (step, name, w, u) in [(1, "half load", 4.933, 1.604), (3, "full load", 6.698, 3.286)] {
        // 20 elements: error of second order, 0.2 % by the prototype; the curve is printed to four digits.
        let [x, _, z] = curve[step];
        rows.push(case.row(format!("deflection, {name}"), Reference::Published, w, z, 0.003));
        rows.push(case.row(format!("shortening, {name}"), Reference::Published, u, -x, 0.003));
    }
    Ok(rows)
}
