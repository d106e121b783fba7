//! Finite rotations: S13 cantilever under an end force, S14 roll-up under an end moment.

use std::f64::consts::PI;
use std::sync::Arc;

use super::large::iterations;
use super::path::Problem;
use super::{Answer, Case, Grid, hold};
use crate::{Reference, Row};
use fem::dofs::Dof;
use fem::element::shell::load::NodalLoads;
use fem::element::shell::section::{ElasticSection, Section};
use fem::element::shell4::Axes;
use fem::model::Builder;

/// Strip of length × 1 × 0.1 along x, E 1.2e6, ν 0, clamped at x = 0: its tip nodes.
fn strip(length: f64, elements: usize) -> Answer<(Builder, Vec<usize>)> {
    let section: Arc<dyn Section> = Arc::new(ElasticSection::new(1.2e6, 0.0, 0.1, 0.0)?);
    let grid = Grid::new(elements, 1);
    let mut builder = Builder::new();
    grid.nodes(&mut builder, |a, b| [length * a, b, 0.0]);
    let mut surface = grid.surface(&section);
    // Rotation frames (y, −x, z): the moment about y is the first component at any rotation about y.
    surface.axes = Axes::Along([0.0, 1.0, 0.0]);
    surface.place(&mut builder)?;
    hold(&mut builder, &grid.line_i(0), Dof::SHELL);
    Ok((builder, grid.line_i(elements)))
}

/// Displacements, and (steps, iterations).
type Curve = (Vec<[f64; 3]>, (usize, usize));

/// Displacement of `node` at each of `steps` equal load steps, with the number of iterations, with extrapolated stresses or the
/// plain tangent.
fn path(problem: &Problem, steps: usize, extrapolated: bool, node: usize) -> Answer<Curve> {
    let mut out = vec![[f64::NAN; 3]; steps];
    let count = problem.load_steps(steps, extrapolated, |factor, state| {
        let step = factor * steps as f64;
        // A step that was halved has states in between.
        if (step - step.round()).abs() < 1e-9 {
            out[step.round() as usize - 1] = problem.displacement(state, node);
        }
    })?;
    Ok((out, count))
}

/// S13: end force 4 on a strip of length 10, 20 elements.
pub(super) fn cantilever() -> Answer<Vec<Row>> {
    let case = Case {
        id: "S13",
        page: "shell-cantilever",
        source: "Sze, Liu & Lo 2004",
        unit: "length",
    };
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

/// S14: end moment 2π E I/L rolls a strip of length 12 into a ring, `elements` elements.
pub(super) fn roll_up(meshes: &[usize]) -> Answer<Vec<Row>> {
    let case = Case {
        id: "S14",
        page: "shell-roll-up",
        source: "circle of radius E I/M",
        unit: "length",
    };
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
    let Some(&(n, half, full)) = study.last() else {
        return Ok(rows);
    };
    let expected = [
        ("u at half the moment", -12.0, half[0]),
        ("w at half the moment", 24.0 / PI, half[2]),
        ("u at the full moment", -12.0, full[0]),
    ];
    for (what, reference, value) in expected {
        // 1 % of the length (sheet): a polygon of n sides instead of the circle.
        let tolerance = 0.01 * length / f64::abs(reference);
        rows.push(case.row(
            format!("{what}, {n} elements"),
            Reference::ClosedForm,
            reference,
            value,
            tolerance,
        ));
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
