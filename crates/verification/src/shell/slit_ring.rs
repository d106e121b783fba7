//! S15: slit annular plate. Geometry, loads and reference values: Sze, Liu & Lo 2004.

use std::f64::consts::PI;
use std::sync::Arc;

use super::path::{Problem, case, iterations, prototype};
use super::{Answer, Grid, hold};
use crate::{Benchmark, Part, Reference};
use fem::dofs::Dof;
use fem::element::shell::load::NodalLoads;
use fem::element::shell::section::{ElasticSection, Section};
use fem::model::Builder;

/// The page.
pub(crate) const BENCHMARK: Benchmark = Benchmark {
    id: "shell-slit-ring",
    title: "Shell: slit annular plate",
    model: "Radii 6 and 10, t = 0.03, E = 21·10⁶, ν = 0, line load 0.8 on one lip of the slit; meshes in each \
            row.",
    ids: &[("S15", "slit annular plate")],
    parts: &[Part::Tested(|| ring(false)), Part::Slow(|| ring(true))],
};

/// Ring from radius 6 to 10, slit along x > 0: one lip clamped, the other under `load` per length; `m` elements along the
/// radius, `n` around. Returns the tips at the inner and the outer radius.
fn slit_ring(m: usize, n: usize, load: f64) -> Answer<(Problem, [usize; 2])> {
    let section: Arc<dyn Section> = Arc::new(ElasticSection::new(21e6, 0.0, 0.03, 0.0)?);
    let grid = Grid::new(m, n);
    let mut builder = Builder::new();
    grid.nodes(&mut builder, |a, b| {
        let (s, c) = (2.0 * PI * b).sin_cos();
        let r = 6.0 + 4.0 * a;
        [r * c, r * s, 0.0]
    });
    grid.surface(&section).place(&mut builder)?;
    hold(&mut builder, &grid.line_j(0), Dof::SHELL);
    let mut loads = NodalLoads::new();
    for pair in grid.line_j(n).windows(2) {
        let edge = [pair[0], pair[1]];
        let positions = edge.map(|e| builder.position(e));
        loads.edge_force(edge, positions, |_| [0.0, 0.0, load]);
    }
    Ok((Problem::new(builder, &loads)?, [grid.node(0, n), grid.node(m, n)]))
}

/// S15: lifting of a slit annular plate.
pub(super) fn ring(fine: bool) -> Answer {
    let case = case("S15");
    let solve = |m: usize, n: usize, steps: usize, extrapolated: bool| -> Answer<_> {
        let (problem, tips) = slit_ring(m, n, 0.8)?;
        let mut w = [0.0; 2];
        let count = problem.load_steps(steps, extrapolated, |_, state| {
            w = tips.map(|tip| problem.displacement(state, tip)[2]);
        })?;
        Ok((w, count))
    };
    let (coarse, count) = solve(6, 30, 5, true)?;
    let mut rows = Vec::new();
    for (what, reference, value) in [("inner", 13.600, coarse[0]), ("outer", 17.242, coarse[1])] {
        rows.push(prototype(&case, format!("{what} tip, 6 × 30 elements"), reference, value, 0.002));
    }
    let plain = if fine { Some(solve(6, 30, 10, false)?.1) } else { None };
    rows.extend(iterations(&case, count, plain, (26, 244)));
    if fine {
        let ([inner, outer], _) = solve(10, 80, 5, true)?;
        for (what, reference, value, coarse) in
            [("inner", 13.891, inner, coarse[0]), ("outer", 17.528, outer, coarse[1])]
        {
            // 10 × 80 within 1.5 % (sheet): thin plate, second order; the coarse mesh is 2 % off.
            let mut row =
                case.row(format!("{what} tip, 10 × 80 elements"), Reference::Published, reference, value, 0.015);
            row.convergence = vec![(30.0, coarse / reference - 1.0), (80.0, value / reference - 1.0)];
            rows.push(row);
        }
    }
    Ok(rows)
}
