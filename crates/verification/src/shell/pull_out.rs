//! S17: open cylinder pulled out. Geometry, loads and reference values: Sze, Liu & Lo 2004.

use std::f64::consts::FRAC_PI_2;
use std::sync::Arc;

use nalgebra::Vector3;

use super::barrel::{ABOUT_Y, barrel};
use super::path::{Problem, case, iterations, prototype};
use super::{Answer, hold};
use crate::{Benchmark, Part, Reference};
use fem::dofs::Dof;
use fem::element::shell::load::NodalLoads;
use fem::element::shell::section::{ElasticSection, Section};
use fem::element::shell::surface::Normals;

/// The page.
pub(crate) const BENCHMARK: Benchmark = Benchmark {
    id: "shell-pull-out",
    title: "Shell: open cylinder pulled out",
    model: "L = 10.35, R = 4.953, t = 0.094, E = 10.5·10⁶, ν = 0.3125, two forces of 40 000.",
    ids: &[("S17", "open cylinder pulled out")],
    parts: &[Part::Tested(|| pull_out(false)), Part::Slow(|| pull_out(true))],
};

/// S17: pull-out of an open cylinder, an eighth with `n` × `n` elements under a quarter of P = 40 000.
pub(super) fn pull_out(fine: bool) -> Answer {
    let case = case("S17");
    // (W at the load, U at its side in the middle, U at the free end), at half and at full load.
    let solve = |n: usize, steps: usize, extrapolated: bool| -> Answer<_> {
        let section: Arc<dyn Section> = Arc::new(ElasticSection::new(10.5e6, 0.3125, 0.094, 0.0)?);
        let radius = 4.953;
        // j from the free end to the middle of the length, i from the load to the side.
        let (grid, mut builder) = barrel(n, radius, 0.5 * 10.35, FRAC_PI_2);
        let positions: Vec<Vector3<f64>> = (0..(n + 1) * (n + 1)).map(|m| builder.position(m).into()).collect();
        let radial = |_: usize, node: usize| Vector3::new(positions[node].x, 0.0, positions[node].z);
        let mut shell = grid.surface(&section);
        (shell.normals, shell.axes) = (Normals::Exact(&radial), ABOUT_Y);
        shell.place(&mut builder)?;
        hold(&mut builder, &grid.line_j(n), &[Dof::Uy, Dof::Rx]);
        hold(&mut builder, &grid.line_i(0), &[Dof::Ux, Dof::Ry]);
        hold(&mut builder, &grid.line_i(n), &[Dof::Uz, Dof::Ry]);
        let (a, b, c) = (grid.node(0, n), grid.node(n, n), grid.node(n, 0));
        let mut loads = NodalLoads::new();
        loads.force(a, [0.0, 0.0, 0.25 * 40e3]);
        let problem = Problem::new(builder, &loads)?;
        let mut values = Vec::new();
        let count = problem.load_steps(steps, extrapolated, |factor, state| {
            let at = |node: usize| problem.displacement(state, node);
            values.push((factor, [at(a)[2], at(b)[0], at(c)[0]]));
        })?;
        Ok((values, count))
    };
    let (_, count) = solve(16, 5, true)?;
    let plain = if fine { Some(solve(16, 10, false)?.1) } else { None };
    let (values, _) = solve(24, 6, true)?;
    let at = |factor: f64| {
        let found = values.iter().find(|(f, _)| (f - factor).abs() < 1e-9);
        found.map_or([f64::NAN; 3], |(_, v)| *v)
    };
    let (half, full) = (at(0.5), at(1.0));
    let mut rows = vec![
        // 1.5 % (sheet).
        case.row("W under the load, full load, 24 × 24 elements", Reference::Published, 2.768, full[0], 0.015),
        case.row("W under the load, half load, 24 × 24 elements", Reference::Published, 2.473, half[0], 0.015),
    ];
    for (what, expected, value) in [
        ("W under the load, full load", 2.752, full[0]),
        ("W under the load, half load", 2.465, half[0]),
        ("U of the middle, full load", -4.585, full[1]),
        ("U of the free end, full load", -3.254, full[2]),
    ] {
        rows.push(prototype(&case, format!("{what}, 24 × 24 elements, prototype"), expected, value, 0.003));
    }
    rows.extend(iterations(&case, count, plain, (31, 83)));
    Ok(rows)
}
