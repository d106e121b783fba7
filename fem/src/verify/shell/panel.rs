//! Nonlinear buckling of a cylinder under axial compression: perfect, and with axisymmetric imperfections.
//!
//! A perfect cylinder buckles at σ = E t/(R √(3 (1 − ν²))) in all waves of Koiter's circle m² + s² = m₀ m at once
//! (m axial, s circumferential wave number), m₀ = (12 (1 − ν²))^¼/√(R t). An imperfection w₀ = δ cos m₀ z in the shape of the
//! axisymmetric wave meets the square waves m = s = m₀/2, and the cylinder bifurcates from its axisymmetric state at λ
//! times that stress,
//!
//! ```text
//! (1 − λ)² = 3/2 √(3 (1 − ν²)) λ |δ|/t                               δ ≪ t
//! ```
//!
//! Model: one half-wave of m₀/2 in both directions between planes of symmetry, 2π/m₀ by 2π/m₀. Only waves that fit between
//! these planes can appear.
//!
//! Source: Koiter 1945 (the formula), 1963 (axisymmetric imperfections).

use std::f64::consts::PI;
use std::sync::Arc;

use nalgebra::{Matrix3, Vector3};

use super::path::{Problem, SHARP};
use super::{Answer, Case, Grid, hold};
use crate::analysis::continuation::{Continuation, Critical};
use crate::dofs::Dof;
use crate::element::shell::load::NodalLoads;
use crate::element::shell::section::{ElasticSection, Section};
use crate::element::shell::surface::Normals;
use crate::element::shell4::Axes;
use crate::element::spring::{Direction, Spring};
use crate::model::Builder;
use crate::progress::Silent;
use crate::state::State;
use crate::verify::{Reference, Row};

const RADIUS: f64 = 1.0;
const THICKNESS: f64 = 1.0 / 400.0;
const NU: f64 = 0.3;

/// Panel of n × n elements with an imperfection of `delta` thicknesses inwards at its ends; the load is that of the classical
/// stress.
fn panel(n: usize, delta: f64) -> Answer<Problem> {
    let section: Arc<dyn Section> = Arc::new(ElasticSection::new(1.0, NU, THICKNESS, 0.0)?);
    let wave = (12.0_f64 * (1.0 - NU * NU)).powf(0.25) / (RADIUS * THICKNESS).sqrt();
    let side = 2.0 * PI / wave;
    let angle = side / RADIUS;
    let grid = Grid::new(n, n);
    let mut builder = Builder::new();
    grid.nodes(&mut builder, |a, b| {
        let r = RADIUS - delta * THICKNESS * (2.0 * PI * b).cos();
        let (s, c) = (angle * a).sin_cos();
        [r * c, r * s, side * b]
    });
    let positions: Vec<Vector3<f64>> = (0..(n + 1) * (n + 1)).map(|m| builder.position(m).into()).collect();
    // r' of the imperfect meridian.
    let slope = |z: f64| delta * THICKNESS * wave * (wave * z).sin();
    let normal = |_: usize, node: usize| {
        let p = positions[node];
        let radial = Vector3::new(p.x, p.y, 0.0).normalize();
        radial - Vector3::z() * slope(p.z)
    };
    for (node, p) in positions.iter().enumerate() {
        let (s, c) = p.y.atan2(p.x).sin_cos();
        // Displacements along e_r, e_φ, e_z.
        builder.frame(node, Matrix3::new(c, s, 0.0, -s, c, 0.0, 0.0, 0.0, 1.0));
    }
    let mut shell = grid.surface(&section);
    (shell.normals, shell.axes) = (Normals::Exact(&normal), Axes::HOOP_Z);
    shell.place(&mut builder)?;
    for ray in [0, n] {
        hold(&mut builder, &grid.line_i(ray), &[Dof::Uy, Dof::Ry]);
    }
    hold(&mut builder, &grid.line_j(0), &[Dof::Uz, Dof::Rx]);
    hold(&mut builder, &grid.line_j(n), &[Dof::Rx]);
    // The upper plane of symmetry stays plane: its nodes hang on one, by springs a thousand times as stiff as the panel.
    let master = builder.node([0.0, 0.0, side]);
    let stiffness = 1e3 * THICKNESS * angle / side;
    for node in grid.line_j(n) {
        let spring = Spring::between(node, master, Direction::Translation([0.0, 0.0, 1.0]), stiffness)?;
        builder.element("plane", spring);
    }
    hold(&mut builder, &[master], &[Dof::Ux, Dof::Uy]);
    let classical = THICKNESS / (RADIUS * (3.0 * (1.0 - NU * NU)).sqrt());
    let mut loads = NodalLoads::new();
    loads.force(master, [0.0, 0.0, -classical * THICKNESS * angle * RADIUS]);
    Problem::new(builder, &loads)
}

fn critical(n: usize, delta: f64) -> Answer<Critical> {
    let problem = panel(n, delta)?;
    let none = vec![0.0; problem.load.len()];
    let mut path = Continuation::new(
        &problem.model,
        &problem.assembler,
        &problem.symbolic,
        &none,
        &problem.load,
        SHARP,
    )?
    .with_extrapolated_stresses();
    let mut state = State::new(&problem.model);
    // To a thousandth of the classical load.
    Ok(path.first_instability(&mut state, 0.1, 1e-3, 1.5, &Silent)?)
}

/// Root of (1 − λ)² = 3/2 √(3 (1 − ν²)) λ δ below 1.
fn koiter(delta: f64) -> f64 {
    let b = 1.0 + 0.75 * (3.0 * (1.0 - NU * NU)).sqrt() * delta;
    b - (b * b - 1.0).sqrt()
}

/// S12: bifurcation of the perfect and the imperfect panel.
pub(super) fn panels(n: usize, imperfections: &[f64]) -> Answer<Vec<Row>> {
    let case = Case {
        id: "S12",
        page: "shell-axial-buckling",
        source: "Koiter 1945: (1 − λ)² = 3/2 √(3 (1 − ν²)) λ δ/t",
        unit: "classical load",
    };
    let mut rows = Vec::new();
    let perfect = critical(n, 0.0)?;
    // 8 elements a half-wave of the axisymmetric mode: π²/(12 · 8²) = 1.3 % of its bending energy; strain 0.15 %.
    rows.push(case.row(
        format!("perfect panel, nonlinear path, {n} × {n} elements"),
        Reference::ClosedForm,
        1.0,
        perfect.stable,
        0.03,
    ));
    for &delta in imperfections {
        let found = critical(n, delta)?;
        // Asymptotic: the next terms are of the order of δ/t itself. Convergence for δ → 0 is in the rows.
        let tolerance = 0.03_f64.max(delta);
        rows.push(case.row(
            format!("axisymmetric imperfection of {delta} t, {n} × {n} elements"),
            Reference::ClosedForm,
            koiter(delta),
            found.stable,
            tolerance,
        ));
    }
    Ok(rows)
}
