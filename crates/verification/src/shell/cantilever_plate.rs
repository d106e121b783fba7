//! S10: cantilevered square plate.

use std::sync::Arc;

use super::{Answer, Case, Grid, hold};
use crate::{Benchmark, Part, Reference};
use fem::assembly::Assembler;
use fem::dofs::Dof;
use fem::element::shell::section::{ElasticSection, Section};
use fem::linalg::generalized_eigen;
use fem::model::Builder;

/// The page.
pub(crate) const BENCHMARK: Benchmark = Benchmark {
    id: "shell-cantilever-plate",
    title: "Shell: cantilevered square plate (NAFEMS FV16)",
    model: "Modes of a thin square plate clamped along one side.",
    ids: &[("S10", "frequencies of a cantilevered square plate")],
    parts: &[Part::Fast(|| cantilever_plate(&[8, 12, 16])), Part::Slow(|| cantilever_plate(&[8, 12, 16, 24]))],
};

/// S10: NAFEMS FV16, square plate clamped on one side; out-of-plane motion only.
pub(super) fn cantilever_plate(meshes: &[usize]) -> Answer {
    let reference = [0.421, 1.029, 2.582, 3.306, 3.753, 6.555];
    let mut study = Vec::new();
    for &n in meshes {
        let section: Arc<dyn Section> = Arc::new(ElasticSection::new(200e9, 0.3, 0.05, 8000.0)?);
        let grid = Grid::new(n, n);
        let mut builder = Builder::new();
        grid.nodes(&mut builder, |a, b| [10.0 * a, 10.0 * b, 0.0]);
        grid.surface(&section).place(&mut builder)?;
        let all: Vec<usize> = (0..(n + 1) * (n + 1)).collect();
        hold(&mut builder, &all, &[Dof::Ux, Dof::Uy]);
        hold(&mut builder, &grid.line_i(0), Dof::SHELL);
        let model = builder.build()?;
        let assembler = Assembler::new(&model);
        let k = assembler.stiffness(&model)?.to_dense();
        let eigen = generalized_eigen(&k, &assembler.mass(&model).to_dense(), Some(6))?;
        study.push((n, eigen.omega));
    }
    let mut rows = Vec::new();
    for (mode, reference) in reference.into_iter().enumerate() {
        let case = Case { id: "S10", source: "NAFEMS 1990, FV16", unit: "Hz" };
        let hertz = |omega: &Vec<f64>| omega.get(mode).map_or(f64::NAN, |w| w / std::f64::consts::TAU);
        let Some((n, finest)) = study.last() else { break };
        let what = format!("frequency {}, {n} × {n}", mode + 1);
        // 1 % on 16 × 16 (sheet); the error is of second order: 1 % (16/n)².
        let tolerance = 0.01 * (16.0 / *n as f64).powi(2).max(1.0);
        let mut row = case.row(what, Reference::Published, reference, hertz(finest), tolerance);
        row.convergence = study.iter().map(|(n, w)| (*n as f64, hertz(w) / reference - 1.0)).collect();
        rows.push(row);
    }
    Ok(rows)
}
