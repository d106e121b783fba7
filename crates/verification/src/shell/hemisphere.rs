//! S5: pinched hemisphere.

use std::f64::consts::{FRAC_PI_2, PI};
use std::sync::Arc;

use nalgebra::Vector3;

use super::{Answer, Case, Grid, hold, solve};
use crate::{Benchmark, Part};
use fem::dofs::Dof;
use fem::element::shell::load::NodalLoads;
use fem::element::shell::section::{ElasticSection, Section};
use fem::element::shell::surface::{Normals, PlacedShell};
use fem::element::shell4::Axes;
use fem::model::Builder;

/// The page.
pub(crate) const BENCHMARK: Benchmark = Benchmark {
    id: "shell-hemisphere",
    title: "Shell: pinched hemisphere",
    model: "Quarter with a hole of 18°, R = 10, t = 0.04, E = 6.825·10⁷, ν = 0.3; meshes in each row.",
    ids: &[("S5", "pinched hemisphere with a hole")],
    parts: &[Part::Fast(|| hemisphere(&[4, 8, 16])), Part::Slow(|| hemisphere(&[4, 8, 16, 32]))],
};

/// Quarter of the hemisphere on n × n elements: free hole, symmetry at both meridians, held in height at one node.
pub(super) fn quarter(n: usize) -> Answer<(Grid, Builder, PlacedShell)> {
    let section: Arc<dyn Section> = Arc::new(ElasticSection::new(6.825e7, 0.3, 0.04, 0.0)?);
    let grid = Grid::new(n, n);
    let mut builder = Builder::new();
    // i along the parallel, j from the equator up: hoop × meridian is the radius.
    grid.nodes(&mut builder, |a, b| {
        let ((s, c), (sv, cv)) = ((FRAC_PI_2 * a).sin_cos(), (72.0 * PI / 180.0 * b).sin_cos());
        [10.0 * cv * c, 10.0 * cv * s, 10.0 * sv]
    });
    let positions: Vec<Vector3<f64>> = (0..(n + 1) * (n + 1)).map(|m| builder.position(m).into()).collect();
    let radial = |_: usize, node: usize| positions[node];
    let mut shell = grid.surface(&section);
    (shell.normals, shell.axes) = (Normals::Exact(&radial), Axes::HOOP_Z);
    let placed = shell.place(&mut builder)?;
    hold(&mut builder, &grid.line_i(0), &[Dof::Uy, Dof::Ry]);
    hold(&mut builder, &grid.line_i(n), &[Dof::Ux, Dof::Ry]);
    // The loads are horizontal: this support only fixes the height.
    hold(&mut builder, &[grid.node(0, 0)], &[Dof::Uz]);
    Ok((grid, builder, placed))
}

/// S5: quarter of a hemisphere with an 18 degree hole under alternating radial loads, n × n elements.
pub(super) fn hemisphere(meshes: &[usize]) -> Answer {
    let case = Case { id: "S5", source: "MacNeal & Harder 1985; Simo, Fox & Rifai 1989 (0.0940)", unit: "m" };
    let mut values = Vec::new();
    for &n in meshes {
        let (grid, builder, placed) = quarter(n)?;
        let mut loads = NodalLoads::new();
        loads.force(grid.node(0, 0), [1.0, 0.0, 0.0]);
        loads.force(grid.node(n, 0), [0.0, -1.0, 0.0]);
        let solution = solve(builder, placed, &loads, [0.0; 3])?;
        values.push((n, solution.at(grid.node(0, 0))[0]));
    }
    let prototype = [(4, 1.025), (8, 0.996), (16, 0.992), (32, 0.994)];
    // Published values scatter from 0.0924 to 0.0940: 1.5 %.
    Ok(case.study("displacement under the load", 0.0940, 0.015, &values, &prototype, 0.005))
}
