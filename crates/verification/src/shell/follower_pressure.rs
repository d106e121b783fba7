//! S20: pressure that follows the surface, on a ring and on a sphere.
//!
//! Membranes of the Saint Venant-Kirchhoff material S = E t ε under p, with the stretch λ of the radius:
//!
//! ```text
//! ring (ν = 0, no axial stretch)   S = p R             λ² = 1 + 2 S/(E t)          polygon: S = p R cos(π/n)
//! sphere                           S = p λ R/2         λ² − 1 = λ p R (1 − ν)/(E t)
//! ```
//!
//! S is the resultant per reference length (second Piola-Kirchhoff). A dead pressure gives λ S = p R on the ring.

use std::collections::BTreeMap;
use std::f64::consts::FRAC_PI_2;
use std::sync::Arc;

use nalgebra::Vector3;

use super::barrel::ABOUT_Y;
use super::path::Problem;
use super::{Answer, Case, Grid, hold, surface};
use crate::{Benchmark, Part, Reference};
use fem::dofs::Dof;
use fem::element::shell::load::{FollowerPressure, NodalLoads};
use fem::element::shell::section::{ElasticSection, Section};
use fem::element::shell::surface::Normals;
use fem::element::shell4::Axes;
use fem::model::Builder;
use fem::state::State;

/// The page.
pub(crate) const BENCHMARK: Benchmark = Benchmark {
    id: "shell-follower-pressure",
    title: "Shell: follower pressure",
    model: "Segments of closed shells under internal pressure that turns with them.",
    ids: &[("S20", "pressure that turns with the surface")],
    parts: &[Part::Tested(|| follower(&[2, 4])), Part::Slow(|| follower(&[2, 4, 8]))],
};

const RADIUS: f64 = 10.0;

const YOUNG: f64 = 1000.0;

const THICKNESS: f64 = 0.01;

fn press(builder: &mut Builder, cells: &[[usize; 4]], pressure: f64) {
    for &nodes in cells {
        let positions = nodes.map(|n| builder.position(n));
        builder.element("pressure", FollowerPressure::new(nodes, positions, pressure));
    }
}

/// Stretch of the radius of a quarter ring of 8 elements, and its hoop resultant over p R, at a tenth, two tenths, … of the
/// pressure: in one step the slack ring evades the pressure by bending.
fn ring(ratio: f64) -> Answer<(f64, f64)> {
    let section: Arc<dyn Section> = Arc::new(ElasticSection::new(YOUNG, 0.0, THICKNESS, 0.0)?);
    let n = 8;
    let grid = Grid::new(n, 1);
    let (mut before, mut answer) = (None, (f64::NAN, f64::NAN));
    for part in 1..=10 {
        let pressure = 0.1 * f64::from(part) * ratio * YOUNG * THICKNESS / RADIUS;
        let mut builder = Builder::new();
        grid.nodes(&mut builder, |a, b| {
            let (s, c) = (FRAC_PI_2 * a).sin_cos();
            [RADIUS * s, b, RADIUS * c]
        });
        let positions: Vec<Vector3<f64>> = (0..2 * (n + 1)).map(|m| builder.position(m).into()).collect();
        let radial = |_: usize, node: usize| Vector3::new(positions[node].x, 0.0, positions[node].z);
        let mut shell = grid.surface(&section);
        (shell.normals, shell.axes) = (Normals::Exact(&radial), ABOUT_Y);
        let placed = shell.place(&mut builder)?;
        press(&mut builder, &grid.cells, pressure);
        hold(&mut builder, &grid.line_j(0), &[Dof::Uy]);
        hold(&mut builder, &grid.line_i(0), &[Dof::Ux, Dof::Ry]);
        hold(&mut builder, &grid.line_i(n), &[Dof::Uz, Dof::Ry]);
        let problem = Problem::new(builder, &NodalLoads::new())?;
        let mut state = before.take().unwrap_or_else(|| State::new(&problem.model));
        problem.load_steps_from(&mut state, 1, true, |_, _| {})?;
        let sections = problem.sections(&state, placed.elements[n / 2])?;
        answer = (
            1.0 + problem.displacement(&state, grid.node(0, 0))[2] / RADIUS,
            sections[0].resultants[0] / (pressure * RADIUS),
        );
        before = Some(state);
    }
    Ok(answer)
}

/// Stretch of the radius of an eighth of a sphere, three patches of n × n elements.
fn sphere(n: usize, ratio: f64, nu: f64) -> Answer<f64> {
    let section: Arc<dyn Section> = Arc::new(ElasticSection::new(YOUNG, nu, THICKNESS, 0.0)?);
    let mut builder = Builder::new();
    // Nodes by their place on the cube of side n.
    let mut nodes: BTreeMap<[usize; 3], usize> = BTreeMap::new();
    let mut cells = Vec::new();
    for axis in 0..3 {
        for k in 0..n * n {
            let (i, j) = (k % n, k / n);
            cells.push([(i, j), (i + 1, j), (i + 1, j + 1), (i, j + 1)].map(|(i, j)| {
                let mut place = [0; 3];
                place[axis] = n;
                place[(axis + 1) % 3] = i;
                place[(axis + 2) % 3] = j;
                *nodes.entry(place).or_insert_with(|| {
                    // Equal angles along the edges of the cube.
                    let on_cube = place.map(|p| (FRAC_PI_2 * 0.5 * p as f64 / n as f64).tan());
                    builder.node((Vector3::from(on_cube).normalize() * RADIUS).into())
                })
            }));
        }
    }
    let positions: Vec<Vector3<f64>> = (0..nodes.len()).map(|m| builder.position(m).into()).collect();
    let radial = |_: usize, node: usize| positions[node];
    let mut shell = surface(&cells, &section);
    (shell.normals, shell.axes) = (Normals::Exact(&radial), Axes::HOOP_Z);
    shell.place(&mut builder)?;
    press(&mut builder, &cells, ratio * YOUNG * THICKNESS / RADIUS);
    for (place, &node) in &nodes {
        // Rotation frames are (parallel, meridian, radius).
        match place {
            [0, 0, _] => hold(&mut builder, &[node], &[Dof::Ux, Dof::Uy, Dof::Rx, Dof::Ry]),
            _ => {
                for (dof, held, turn) in [
                    (Dof::Ux, place[0] == 0, Dof::Ry),
                    (Dof::Uy, place[1] == 0, Dof::Ry),
                    (Dof::Uz, place[2] == 0, Dof::Rx),
                ] {
                    if held {
                        hold(&mut builder, &[node], &[dof, turn]);
                    }
                }
            }
        }
    }
    let problem = Problem::new(builder, &NodalLoads::new())?;
    let corner = nodes.get(&[n, n, n]).copied().unwrap_or(0);
    let mut stretch = f64::NAN;
    problem.load_steps(1, true, |_, state| {
        let u = Vector3::from(problem.displacement(state, corner));
        stretch = (positions[corner] + u).norm() / RADIUS;
    })?;
    Ok(stretch)
}

/// S20: ring and sphere under follower pressure.
pub(super) fn follower(meshes: &[usize]) -> Answer {
    let case = Case { id: "S20", source: "membrane of the Saint Venant-Kirchhoff material", unit: "" };
    let (stretch, hoop) = ring(0.2)?;
    // Chords instead of arcs: their pressure pulls with p R cos(half the angle of an element). The rest is bending, t²/R² = 1e-6.
    let apothem = (FRAC_PI_2 / 16.0).cos();
    let exact = (1.0 + 0.4 * apothem).sqrt();
    let mut rows = vec![
        case.row("ring of 32 chords, stretch of the radius", Reference::ClosedForm, exact, stretch, 1e-5),
        case.row("ring of 32 chords, n over p R", Reference::ClosedForm, apothem, hoop, 1e-5),
    ];
    let (ratio, nu) = (0.2 / 0.7, 0.3);
    let k: f64 = ratio * (1.0 - nu);
    let exact = 0.5 * (k + (k * k + 4.0).sqrt());
    let study: Vec<(usize, f64)> = meshes.iter().map(|&n| Ok((n, sphere(n, ratio, nu)?))).collect::<Answer<_>>()?;
    if let Some(&(n, value)) = study.last() {
        // Flat facets: the enclosed volume is second order in the mesh, 1 % at 4 × 4.
        let tolerance = 0.01 * (4.0 / n as f64).powi(2);
        let what = format!("sphere, stretch of the radius, {n} × {n} elements a patch");
        let mut row = case.row(what, Reference::ClosedForm, exact, value, tolerance);
        row.convergence = study.iter().map(|&(n, v)| (n as f64, v / exact - 1.0)).collect();
        rows.push(row);
    }
    Ok(rows)
}
