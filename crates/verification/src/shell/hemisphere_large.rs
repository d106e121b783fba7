//! S16: hemisphere at large displacements. Geometry, loads and reference values: Sze, Liu & Lo 2004.

use super::Answer;
use super::hemisphere::quarter;
use super::path::{Problem, case, iterations, prototype};
use crate::{Benchmark, Part, Reference};
use fem::element::shell::load::NodalLoads;

/// The page.
pub(crate) const BENCHMARK: Benchmark = Benchmark {
    id: "shell-hemisphere-large",
    title: "Shell: hemisphere with a hole at large displacements",
    model: "Hole of 18°, R = 10, t = 0.04, E = 6.825·10⁷, ν = 0.3, four radial forces of 400.",
    ids: &[("S16", "hemisphere with a hole at large displacements")],
    parts: &[Part::Tested(|| hemisphere(false)), Part::Slow(|| hemisphere(true))],
};

/// Quarter of a hemisphere with an 18 degree hole under alternating radial loads of 200 each (400 on the whole), n × n.
fn large_hemisphere(n: usize) -> Answer<(Problem, [usize; 2])> {
    let (grid, builder, _) = quarter(n)?;
    let (out, inward) = (grid.node(0, 0), grid.node(n, 0));
    let mut loads = NodalLoads::new();
    loads.force(out, [200.0, 0.0, 0.0]);
    loads.force(inward, [0.0, -200.0, 0.0]);
    Ok((Problem::new(builder, &loads)?, [out, inward]))
}

/// S16: hemisphere under alternating point loads, 8 × 8 and 16 × 16 (fine: 24 × 24) elements.
pub(super) fn hemisphere(fine: bool) -> Answer {
    let case = case("S16");
    // (outwards, inwards) at half and at full load.
    let solve = |n: usize, steps: usize, extrapolated: bool| -> Answer<_> {
        let (problem, [out, inward]) = large_hemisphere(n)?;
        let mut values = Vec::new();
        let count = problem.load_steps(steps, extrapolated, |_, state| {
            let (x, y) = (problem.displacement(state, out)[0], problem.displacement(state, inward)[1]);
            values.push([x, y]);
        })?;
        let half = values.get(values.len() / 2 - 1).copied().unwrap_or([f64::NAN; 2]);
        Ok((half, values.last().copied().unwrap_or([f64::NAN; 2]), count))
    };
    let mut rows = Vec::new();
    let (_, eight, count) = solve(8, 4, true)?;
    let plain = if fine { Some(solve(8, 10, false)?.2) } else { None };
    let n = if fine { 24 } else { 16 };
    let (half, full, _) = solve(n, 4, true)?;
    let references = [
        ("outwards, full load", 4.067, full[0], [4.045, 4.071]),
        ("inwards, full load", -8.178, full[1], [-8.102, -8.156]),
        ("outwards, half load", 3.406, half[0], [f64::NAN, 3.401]),
        ("inwards, half load", -5.902, half[1], [f64::NAN, -5.853]),
    ];
    for (k, (what, reference, value, by_prototype)) in references.into_iter().enumerate() {
        // 16 × 16 within 2 % (sheet).
        let mut row = case.row(format!("{what}, {n} × {n} elements"), Reference::Published, reference, value, 0.02);
        if k < 2 {
            row.convergence = vec![(8.0, eight[k] / reference - 1.0), (n as f64, value / reference - 1.0)];
        }
        rows.push(row);
        let expected = by_prototype[usize::from(fine)];
        if expected.is_finite() {
            rows.push(prototype(&case, format!("{what}, {n} × {n} elements, prototype"), expected, value, 0.002));
        }
    }
    rows.extend(iterations(&case, count, plain, (19, 127)));
    Ok(rows)
}
