//! M17: laws of solid concrete as layers of a shell: a membrane patch against the point and closed forms.
//!
//! Source:    Drucker & Prager 1952 (strengths of two cones); Dougill 1976 (first loss); the laws at a point (rows M15)
//! Model:     1 m × 1 m, 20 cm thick, 2 × 2 shells with the inner node off the middle, four layers in plane stress, held at two edges, drawn or
//!            pressed at the others by displacement control
//! Measures:  the shells have Green's strain E and the second Piola-Kirchhoff stress S, in which the law is written. A side of 1 m that
//!            moves by u has E = u + u²/2, so that the strain E is reached at u = √(1 + 2 E) − 1; the force per metre of the undeformed edge
//!            is t P with P = (1 + u) S, since the sides turn nowhere, so that S = P/(1 + u)
//! Tolerance: plateaus 1e-6, which Newton's method reaches; the fracturing solid depends on the steps of a path that is not proportional, in
//!            first order: steps of 1/100 of the range, 0.5 %

use std::sync::Arc;

use materials::Law;
use materials::dougill::Fracturing;
use materials::plane_stress::PlaneStress;
use materials::two_surface::TwoSurface;

use super::path::Problem;
use super::{Answer, Grid, hold};
use crate::materials::solid_concrete::driven_stress;
use crate::{Benchmark, Part, Reference, Row};
use fem::analysis::continuation::StepLength;
use fem::analysis::newton::Criteria;
use fem::dofs::Dof;
use fem::element::shell::layered::{LayeredSection, Ply};
use fem::element::shell::load::NodalLoads;
use fem::element::shell::rule::Rule;
use fem::element::shell::section::Section;
use fem::element::shell4::Axes;
use fem::model::Builder;
use fem::progress::Silent;
use fem::state::State;

/// The page.
pub(crate) const BENCHMARK: Benchmark = Benchmark {
    id: "shell-concrete-patch",
    title: "Shell: layers of solid concrete",
    model: "A membrane patch of four shells whose layers are two-surface plasticity or Dougill's fracturing solid in plane stress: E = 34 GPa, \
            ν = 0.2, f_c = 35 MPa, f_bc = 1.16 f_c, f_t = 3.5 MPa. The parameters are our own: the dissertation prints none.",
    ids: &[("M17", "two surfaces and the fracturing solid as layers of a shell")],
    parts: &[Part::Fast(rows)],
};

const E: f64 = 34e9;
const NU: f64 = 0.2;
const F_C: f64 = 35e6;
const F_T: f64 = 3.5e6;
const RATIO: f64 = 1.16;
/// Energy of the fracturing solid [J/m³].
const ENERGY: f64 = 50e3;
const THICKNESS: f64 = 0.2;
/// Steps over the range of a path.
const STEPS: i32 = 100;

/// Movement [m] of a side of 1 m at Green's strain.
fn movement(strain: f64) -> f64 {
    (1.0 + 2.0 * strain).sqrt() - 1.0
}

/// Second Piola-Kirchhoff stress [Pa] at Green's strain `end` of both directions (`equibiaxial`), or of the first alone.
fn patch(law: Arc<dyn Law<3>>, equibiaxial: bool, end: f64) -> Answer<f64> {
    let ply = Ply { law, thickness: THICKNESS, density: 0.0, rule: Rule::MidPoint(4) };
    let section: Arc<dyn Section> = Arc::new(LayeredSection::new(&[ply], &[])?);
    let grid = Grid::new(2, 2);
    let mut builder = Builder::new();
    // The inner node off the middle: the strain is uniform all the same.
    let shifted = |a: f64, b: f64| {
        if (a, b) == (0.5, 0.5) { [0.58, 0.45, 0.0] } else { [a, b, 0.0] }
    };
    grid.nodes(&mut builder, shifted);
    let mut surface = grid.surface(&section);
    surface.axes = Axes::Along([1.0, 0.0, 0.0]);
    surface.place(&mut builder)?;
    hold(&mut builder, &grid.line_i(0), &[Dof::Ux]);
    hold(&mut builder, &grid.line_j(0), &[Dof::Uy]);
    let all: Vec<usize> = (0..3).flat_map(|j| grid.line_j(j)).collect();
    hold(&mut builder, &all, &[Dof::Uz, Dof::Rx, Dof::Ry]);
    // 1 N/m² on the edges, of the sign of the strain.
    let push = end.signum() * THICKNESS;
    let shares = [0.25, 0.5, 0.25];
    let mut loads = NodalLoads::new();
    for (node, share) in grid.line_i(2).into_iter().zip(shares) {
        loads.force(node, [share * push, 0.0, 0.0]);
    }
    if equibiaxial {
        for (node, share) in grid.line_j(2).into_iter().zip(shares) {
            loads.force(node, [0.0, share * push, 0.0]);
        }
    }
    let problem = Problem::new(builder, &loads)?;
    let criteria = Criteria { energy: 1e-16, force: 1e-8, iterations: 60 };
    let mut path = problem.continuation(criteria)?;
    let mut state = State::new(&problem.model);
    let row = problem.model.row(grid.node(2, 1), Dof::Ux);
    let targets: Vec<f64> = (1..=STEPS).map(|i| movement(end * f64::from(i) / f64::from(STEPS))).collect();
    let mut factor = f64::NAN;
    let first = end.abs() / f64::from(STEPS);
    let followed =
        path.to_displacements(&mut state, &row, &targets, StepLength::around(first), &Silent, |_, point, _| {
            factor = point.factor
        })?;
    match followed.failure {
        // The factor is the nominal stress, on the undeformed edge.
        None => Ok(end.signum() * factor / (1.0 + movement(end))),
        Some(failure) => Err(format!("the patch stops before a strain of {end}: {failure}").into()),
    }
}

fn rows() -> Answer {
    let mut rows = Vec::new();
    let cones = TwoSurface::new(E, NU, F_C, RATIO * F_C, F_T)?;
    let layer: Arc<dyn Law<3>> = Arc::new(PlaneStress::new(cones));
    for (what, both, end, exact, source) in [
        ("uniaxial compression", false, -4e-3, -F_C, "f_c"),
        ("equibiaxial compression", true, -4e-3, -RATIO * F_C, "f_bc"),
        ("uniaxial tension", false, 1e-3, F_T, "f_t"),
        ("equibiaxial tension", true, 1e-3, 2.0 * F_C * F_T / (3.0 * F_C - F_T), "2 f_c f_t/(3 f_c − f_t)"),
    ] {
        rows.push(Row::new(
            "M17",
            format!("two surfaces, patch of shells: strength in {what}"),
            (1e-6 * exact, source, Reference::ClosedForm),
            1e-6 * patch(layer.clone(), both, end)?,
            (1e-6, "MPa"),
        ));
    }
    let solid = Fracturing::of_energy(E, NU, F_C, RATIO, ENERGY)?;
    let layer: Arc<dyn Law<3>> = Arc::new(PlaneStress::new(solid));
    for (what, both, first) in [("uniaxial", false, -F_C / E), ("equibiaxial", true, -RATIO * F_C * (1.0 - NU) / E)] {
        let driven: &[usize] = if both { &[0, 1] } else { &[0] };
        let exact = if both { -RATIO * F_C } else { -F_C };
        rows.push(Row::new(
            "M17",
            format!("fracturing, patch of shells: first loss in {what} compression"),
            (1e-6 * exact, "f_c, and f_bc", Reference::ClosedForm),
            1e-6 * patch(layer.clone(), both, first)?,
            (1e-6, "MPa"),
        ));
        // Beyond the first loss in equibiaxial compression the driver of the point finds no stress.
        if both {
            continue;
        }
        let end = 2.0 * first;
        rows.push(Row::new(
            "M17",
            format!("fracturing, patch of shells: stress at twice that strain in {what} compression"),
            (
                1e-6 * driven_stress(&solid, driven, end, 10 * STEPS)?,
                "the law of the solid at a point, other stresses driven to zero",
                Reference::SecondFormulation,
            ),
            1e-6 * patch(layer.clone(), both, end)?,
            (5e-3, "MPa"),
        ));
    }
    Ok(rows)
}
