//! A strip bent by its end: the model of S13 and S14.

use std::sync::Arc;

use super::path::Problem;
use super::{Answer, Grid, hold};
use fem::dofs::Dof;
use fem::element::shell::section::{ElasticSection, Section};
use fem::element::shell4::Axes;
use fem::model::Builder;

/// Strip of length × 1 × 0.1 along x, E 1.2e6, ν 0, clamped at x = 0: its tip nodes.
pub(super) fn strip(length: f64, elements: usize) -> Answer<(Builder, Vec<usize>)> {
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
pub(super) type Curve = (Vec<[f64; 3]>, (usize, usize));

/// Displacement of `node` at each of `steps` equal load steps, with the number of iterations, with extrapolated stresses or the
/// plain tangent.
pub(super) fn path(problem: &Problem, steps: usize, extrapolated: bool, node: usize) -> Answer<Curve> {
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
