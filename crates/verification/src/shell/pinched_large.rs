//! S18: pinched cylinder at large displacements. Geometry, loads and reference values: Sze, Liu & Lo 2004.

use std::f64::consts::FRAC_PI_2;
use std::sync::Arc;

use nalgebra::Vector3;

use super::barrel::{ABOUT_Y, barrel};
use super::path::{Problem, case, prototype};
use super::{Answer, hold};
use crate::{Benchmark, Part};
use fem::dofs::Dof;
use fem::element::shell::load::NodalLoads;
use fem::element::shell::section::{ElasticSection, Section};
use fem::element::shell::surface::Normals;

/// The page.
pub(crate) const BENCHMARK: Benchmark = Benchmark {
    id: "shell-pinched-large",
    title: "Shell: pinched cylinder with diaphragms at large displacements",
    model: "R = 100, L = 200, t = 1, E = 30·10³, ν = 0.3, an eighth in 40 × 40 elements, displacement control.",
    ids: &[("S18", "pinched cylinder at large displacements")],
    parts: &[Part::Slow(|| pinched(40))],
};

/// S18: pinched cylinder with end diaphragms, an eighth with n × n elements under a quarter of P, by displacement control.
pub(super) fn pinched(n: usize) -> Answer {
    let mut case = case("S18");
    case.unit = "force";
    let section: Arc<dyn Section> = Arc::new(ElasticSection::new(30e3, 0.3, 1.0, 0.0)?);
    let (grid, mut builder) = barrel(n, 100.0, 100.0, FRAC_PI_2);
    let positions: Vec<Vector3<f64>> = (0..(n + 1) * (n + 1)).map(|m| builder.position(m).into()).collect();
    let radial = |_: usize, node: usize| Vector3::new(positions[node].x, 0.0, positions[node].z);
    let mut shell = grid.surface(&section);
    (shell.normals, shell.axes) = (Normals::Exact(&radial), ABOUT_Y);
    shell.place(&mut builder)?;
    hold(&mut builder, &grid.line_j(0), &[Dof::Ux, Dof::Uz]);
    hold(&mut builder, &grid.line_j(n), &[Dof::Uy, Dof::Rx]);
    hold(&mut builder, &grid.line_i(0), &[Dof::Ux, Dof::Ry]);
    hold(&mut builder, &grid.line_i(n), &[Dof::Uz, Dof::Ry]);
    let loaded = grid.node(0, n);
    let mut loads = NodalLoads::new();
    loads.force(loaded, [0.0, 0.0, -0.25]);
    let problem = Problem::new(builder, &loads)?;
    let expected = [(10.0, 626.0), (20.0, 1071.0), (40.0, 1835.0), (60.0, 2629.0), (80.0, 8965.0)];
    let targets = expected.map(|(w, _)| -w);
    let (factors, _) = problem.at_displacements((loaded, Dof::Uz), &targets, 2.5, |_, _| {})?;
    let rows = expected.iter().zip(factors).map(|(&(w, reference), p)| {
        // The same mesh: half the last printed digit, and a tenth of it for the criterion of the iterations.
        let tolerance = 0.6 / reference;
        prototype(&case, format!("load at W = {w}, {n} × {n} elements"), reference, p, tolerance)
    });
    Ok(rows.collect())
}
