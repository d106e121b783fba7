//! S4: pinched cylinder with end diaphragms.

use std::f64::consts::FRAC_PI_2;
use std::sync::Arc;

use nalgebra::Vector3;

use super::barrel::{ABOUT_Y, barrel};
use super::{Answer, Case, hold, solve};
use crate::{Benchmark, Part};
use fem::dofs::Dof;
use fem::element::shell::load::NodalLoads;
use fem::element::shell::section::{ElasticSection, Section};
use fem::element::shell::surface::Normals;

/// The page.
pub(crate) const BENCHMARK: Benchmark = Benchmark {
    id: "shell-pinched-cylinder",
    title: "Shell: pinched cylinder with end diaphragms",
    model: "One eighth, R = 300, L = 600, t = 3, E = 3·10⁶, ν = 0.3; meshes in each row.",
    ids: &[("S4", "pinched cylinder with end diaphragms")],
    parts: &[
        Part::Fast(|| pinched_cylinder(&[4, 8, 16, 32])),
        Part::Slow(|| pinched_cylinder(&[4, 8, 16, 32, 48, 64])),
    ],
};

/// S4: eighth of a cylinder on end diaphragms under two opposite point loads, n × n elements.
pub(super) fn pinched_cylinder(meshes: &[usize]) -> Answer {
    let case = Case { id: "S4", source: "Belytschko et al. 1985 (1.8248e-5), R/t 100", unit: "10⁻⁵ length" };
    let mut values = Vec::new();
    for &n in meshes {
        let section: Arc<dyn Section> = Arc::new(ElasticSection::new(3e6, 0.3, 3.0, 0.0)?);
        let (grid, mut builder) = barrel(n, 300.0, 300.0, FRAC_PI_2);
        let positions: Vec<Vector3<f64>> = (0..(n + 1) * (n + 1)).map(|m| builder.position(m).into()).collect();
        let radial = |_: usize, node: usize| Vector3::new(positions[node].x, 0.0, positions[node].z);
        let mut shell = grid.surface(&section);
        (shell.normals, shell.axes) = (Normals::Exact(&radial), ABOUT_Y);
        let placed = shell.place(&mut builder)?;
        hold(&mut builder, &grid.line_j(0), &[Dof::Ux, Dof::Uz]);
        hold(&mut builder, &grid.line_j(n), &[Dof::Uy, Dof::Rx]);
        hold(&mut builder, &grid.line_i(0), &[Dof::Ux, Dof::Ry]);
        hold(&mut builder, &grid.line_i(n), &[Dof::Uz, Dof::Ry]);
        let mut loads = NodalLoads::new();
        let loaded = grid.node(0, n);
        loads.force(loaded, [0.0, 0.0, -0.25]);
        values.push((n, -1e5 * solve(builder, placed, &loads, [0.0; 3])?.at(loaded)[2]));
    }
    let prototype = [(4, 0.388), (8, 0.755), (16, 0.933), (32, 0.990), (48, 1.002), (64, 1.007)];
    // The value under a point load on a shear-flexible shell does not converge; 1.8248 belongs to the Kirchhoff-like range.
    Ok(case.study("displacement under the load", 1.8248, 0.02, &values, &prototype, 0.02))
}
