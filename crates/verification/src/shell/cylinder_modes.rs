//! Free vibration of a cylinder on shear diaphragms: waves cos nθ sin(mπz/L) against the closed form.
//!
//! ```text
//! u = U cos λz cos nθ ,  v = V sin λz sin nθ ,  w = W sin λz cos nθ ,   λ = mπ/L
//! ε_z = −λ U            κ_z = λ² W
//! ε_φ = (n V + W)/R     κ_φ = (n² W + n V)/R²
//! γ   = λ V − n U/R     2τ  = 2 λ n W/R + 3/2 λ V/R + ½ n U/R²
//! ```
//!
//! Every amplitude has the same mean square, so that K = Bᵀ C B over (U, V, W) with the mass ρ t 1 gives three
//! frequencies. No shear flexibility, no rotary inertia: both are of the order (t n/R)².
//!
//! Source: strains of Sanders 1959; Leissa 1973, Vibration of Shells, chapter 2.

use std::f64::consts::PI;
use std::sync::Arc;

use nalgebra::{Matrix3, RowVector3, Vector3};

use super::{Answer, Case, Grid, hold};
use crate::{Benchmark, Part, Reference};
use fem::assembly::Assembler;
use fem::dofs::Dof;
use fem::element::shell::section::{ElasticSection, Section};
use fem::element::shell::surface::Normals;
use fem::element::shell4::Axes;
use fem::linalg::generalized_eigen;
use fem::model::Builder;

/// The page.
pub(crate) const BENCHMARK: Benchmark = Benchmark {
    id: "shell-cylinder-modes",
    title: "Shell: modes of a cylinder",
    model: "Simply supported cylinder, R = 1 m, L = 2 m, t = 10 mm, steel; the lowest frequency by waves around.",
    ids: &[("shell-modes", "lowest frequencies of a simply supported cylinder by waves around")],
    parts: &[Part::Fast(|| cylinder_modes(&[4, 8, 12, 16]))],
};

const RADIUS: f64 = 1.0;

const LENGTH: f64 = 2.0;

const THICKNESS: f64 = 0.01;

const YOUNG: f64 = 200e9;

const POISSON: f64 = 0.3;

const DENSITY: f64 = 7850.0;

/// Waves in the sector of the model.
const WAVES: usize = 5;

/// Lowest frequency [Hz] of the wave (m, n).
fn closed_form(m: usize, n: usize) -> f64 {
    let (lambda, n, r) = (m as f64 * PI / LENGTH, n as f64, RADIUS);
    let c = YOUNG / (1.0 - POISSON * POISSON);
    let twist = 0.5 * (1.0 - POISSON);
    let part = |a: RowVector3<f64>, b: RowVector3<f64>, g: RowVector3<f64>, factor: f64| {
        let cross = a.transpose() * b;
        (a.transpose() * a + b.transpose() * b + (cross + cross.transpose()) * POISSON + g.transpose() * g * twist)
            * (c * factor)
    };
    let membrane = part(
        RowVector3::new(-lambda, 0.0, 0.0),
        RowVector3::new(0.0, n / r, 1.0 / r),
        RowVector3::new(-n / r, lambda, 0.0),
        THICKNESS,
    );
    let bending = part(
        RowVector3::new(0.0, 0.0, lambda * lambda),
        RowVector3::new(0.0, n / (r * r), n * n / (r * r)),
        RowVector3::new(0.5 * n / (r * r), 1.5 * lambda / r, 2.0 * lambda * n / r),
        THICKNESS.powi(3) / 12.0,
    );
    let stiffness: Matrix3<f64> = membrane + bending;
    let lowest = stiffness.symmetric_eigenvalues().min();
    (lowest / (DENSITY * THICKNESS)).sqrt() / (2.0 * PI)
}

/// Lowest frequency [Hz] of half a wave of the circumference and half the length, n × n elements.
fn lowest(n: usize) -> Answer<f64> {
    let section: Arc<dyn Section> = Arc::new(ElasticSection::new(YOUNG, POISSON, THICKNESS, DENSITY)?);
    let sector = PI / WAVES as f64;
    let grid = Grid::new(n, n);
    let mut builder = Builder::new();
    grid.nodes(&mut builder, |a, b| {
        let (s, c) = (sector * a).sin_cos();
        [RADIUS * c, RADIUS * s, 0.5 * LENGTH * b]
    });
    let count = (n + 1) * (n + 1);
    let positions: Vec<[f64; 3]> = (0..count).map(|k| builder.position(k)).collect();
    for (node, [x, y, _]) in positions.iter().enumerate() {
        let (c, s) = (x / RADIUS, y / RADIUS);
        builder.frame(node, Matrix3::new(c, s, 0.0, -s, c, 0.0, 0.0, 0.0, 1.0));
    }
    let radial = |_: usize, node: usize| Vector3::new(positions[node][0], positions[node][1], 0.0);
    let mut shell = grid.surface(&section);
    (shell.normals, shell.axes) = (Normals::Exact(&radial), Axes::HOOP_Z);
    shell.place(&mut builder)?;
    for ray in [0, n] {
        hold(&mut builder, &grid.line_i(ray), &[Dof::Uy, Dof::Ry]);
    }
    hold(&mut builder, &grid.line_j(0), &[Dof::Ux, Dof::Uy, Dof::Ry]);
    hold(&mut builder, &grid.line_j(n), &[Dof::Uz, Dof::Rx]);
    let model = builder.build()?;
    let assembler = Assembler::new(&model);
    let k = assembler.stiffness(&model)?.to_dense();
    let eigen = generalized_eigen(&k, &assembler.mass(&model).to_dense(), Some(1))?;
    Ok(eigen.omega.first().map_or(f64::NAN, |w| w / (2.0 * PI)))
}

/// Lowest frequency with 5 k waves round the circumference, symmetric to the middle.
pub(super) fn cylinder_modes(meshes: &[usize]) -> Answer {
    let case =
        Case { id: "shell-modes", source: "Sanders 1959, Leissa 1973: shear diaphragms, closed form", unit: "Hz" };
    // The sector holds the waves 0, 5, 10, … and odd half-waves along the axis.
    let waves = [0, 1, 2].map(|k| [1, 3, 5].map(|m| closed_form(m, k * WAVES)));
    let reference = waves.as_flattened().iter().copied().fold(f64::INFINITY, f64::min);
    let mut study = Vec::new();
    for &n in meshes {
        study.push((n as f64, lowest(n)?));
    }
    let Some(&(n, value)) = study.last() else { return Ok(Vec::new()) };
    let what = format!("wave (1, {WAVES}), {n} elements a half-wave");
    // Half a wave by n straight pieces: curvature π²/(12 n²) per direction, 0.3 % at 16, and the polygon π²/(2 (5 n)²).
    let mut row = case.row(what, Reference::ClosedForm, reference, value, 0.005);
    row.convergence = study.iter().map(|&(n, v)| (n, v / reference - 1.0)).collect();
    Ok(vec![row])
}
