//! S19: shallow roof on hinged edges (Sze, Liu & Lo 2004): limit points and snap-back.

use std::sync::Arc;

use nalgebra::Vector3;

use super::barrel::{ABOUT_Y, barrel};
use super::path::{Problem, SHARP, case, prototype};
use super::{Answer, hold};
use crate::{Benchmark, Part, Reference};
use fem::analysis::continuation::StepLength;
use fem::dofs::Dof;
use fem::element::shell::load::NodalLoads;
use fem::element::shell::section::{ElasticSection, Section};
use fem::element::shell::surface::Normals;
use fem::progress::Silent;
use fem::state::State;

/// The page.
pub(crate) const BENCHMARK: Benchmark = Benchmark {
    id: "shell-hinged-roof",
    title: "Shell: hinged cylindrical roof",
    model: "R = 2540, L = 254, 0.1 rad, E = 3102.75, ν = 0.3; t = 12.7 snaps through, t = 6.35 snaps back.",
    ids: &[("S19", "hinged cylindrical roof: snap-through and snap-back")],
    parts: &[Part::Tested(|| roof(16)), Part::Slow(|| snap_back(16))],
};

/// Quarter of a shallow roof of thickness t on hinged edges under a quarter of the load at its crown, n × n elements; the crown.
fn hinged_roof(n: usize, t: f64) -> Answer<(Problem, usize)> {
    let section: Arc<dyn Section> = Arc::new(ElasticSection::new(3102.75, 0.3, t, 0.0)?);
    // i from the crown to the hinge, j from the middle of the length to the free edge.
    let (grid, mut builder) = barrel(n, 2540.0, 254.0, 0.1);
    let positions: Vec<Vector3<f64>> = (0..(n + 1) * (n + 1)).map(|m| builder.position(m).into()).collect();
    let radial = |_: usize, node: usize| Vector3::new(positions[node].x, 0.0, positions[node].z);
    let mut shell = grid.surface(&section);
    (shell.normals, shell.axes) = (Normals::Exact(&radial), ABOUT_Y);
    shell.place(&mut builder)?;
    hold(&mut builder, &grid.line_j(0), &[Dof::Uy, Dof::Rx]);
    hold(&mut builder, &grid.line_i(0), &[Dof::Ux, Dof::Ry]);
    hold(&mut builder, &grid.line_i(n), &[Dof::Ux, Dof::Uy, Dof::Uz]);
    let crown = grid.node(0, 0);
    let mut loads = NodalLoads::new();
    loads.force(crown, [0.0, 0.0, -0.25]);
    Ok((Problem::new(builder, &loads)?, crown))
}

/// S19: shallow roof: limit point and the path beyond it.
pub(super) fn roof(n: usize) -> Answer {
    let mut case = case("S19");
    case.unit = "N";
    let solve = |t: f64, targets: &[f64]| -> Answer<Vec<f64>> {
        let (problem, crown) = hinged_roof(n, t)?;
        let targets: Vec<f64> = targets.iter().map(|w| -w).collect();
        Ok(problem.at_displacements((crown, Dof::Uz), &targets, 1.0, |_, _| {})?.0)
    };
    let thick = solve(12.7, &[10.0, 10.5, 11.0, 11.5, 12.0, 20.0, 25.0])?;
    let limit = thick[..5].iter().copied().fold(0.0, f64::max);
    let thin = solve(6.35, &[12.0, 12.5, 13.0, 13.5, 14.0])?;
    let thin_limit = thin.iter().copied().fold(0.0, f64::max);
    let mut rows = Vec::new();
    for (what, reference, value, printed) in [
        ("limit load, t 12.7", 2221.6, limit, 2220.0),
        ("load at W = 20, t 12.7", 519.0, thick[5], f64::NAN),
        ("load at W = 25, t 12.7", 1437.0, thick[6], f64::NAN),
        ("limit load, t 6.35", 586.0, thin_limit, 590.0),
    ] {
        // 1 % (sheet); the published limit loads are recalled to two or three digits.
        rows.push(prototype(&case, format!("{what}, {n} × {n} elements, prototype"), reference, value, 0.01));
        if f64::is_finite(printed) {
            rows.push(case.row(format!("{what}, {n} × {n} elements"), Reference::Published, printed, value, 0.01));
        }
    }
    Ok(rows)
}

/// S19: the thin roof by arc length, through the snap-back that displacement control cannot follow.
pub(super) fn snap_back(n: usize) -> Answer {
    let mut case = case("S19");
    let (problem, crown) = hinged_roof(n, 6.35)?;
    let mut path = problem.continuation(SHARP)?.with_extrapolated_stresses().with_watch();
    let mut state = State::new(&problem.model);
    // (W, λ, negative eigenvalues) until the load is above the first limit again.
    let mut curve: Vec<(f64, f64, usize)> = Vec::new();
    let length = StepLength { first: 10.0, shortest: 0.1, longest: 10.0 };
    path.along(&mut state, length, &Silent, |point, state| {
        let w = -problem.displacement(state, crown)[2];
        curve.push((w, point.factor, point.negative.unwrap_or(0)));
        (w > 20.0 && point.factor > 1000.0) || curve.len() > 600
    });
    let first_unstable = curve.iter().position(|c| c.2 > 0).unwrap_or(0);
    let limit = curve.iter().take(first_unstable + 1).map(|c| c.1).fold(0.0, f64::max);
    let lowest = curve.iter().map(|c| c.1).fold(0.0, f64::min);
    let back = curve.windows(2).map(|c| c[0].0 - c[1].0).fold(0.0, f64::max);
    let last = curve.last().map_or((f64::NAN, f64::NAN, 1), |c| *c);
    let mut rows = vec![prototype(
        &case,
        "limit load by arc length, t 6.35: the first state with a negative eigenvalue and those before",
        586.0,
        limit,
        // Steps of 20 in the norm of all nodes miss the top by 1 %, these by a quarter of that.
        0.01,
    )];
    rows[0].unit = "N";
    // Recalled from the curves of Sze, Liu & Lo: about −380.
    let mut row = case.row("smallest load, t 6.35", Reference::Published, -380.0, lowest, f64::INFINITY);
    row.unit = "N";
    rows.push(row);
    case.source = "an eigenvalue changes its sign at every limit point";
    let mut stable = case.row("negative eigenvalues beyond the snap", Reference::ClosedForm, 0.0, last.2 as f64, 0.0);
    stable.unit = "";
    rows.push(stable);
    // Shows that the path turns back; zero means that the path jumped over the snap.
    rows.push(case.row("largest step of W backwards", Reference::ClosedForm, 0.5, back.min(0.5), 1e-12));
    Ok(rows)
}
