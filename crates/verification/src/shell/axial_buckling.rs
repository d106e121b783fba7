//! S12: axial buckling of a cylinder: linear on one sector, and along the nonlinear path of a panel.

use std::f64::consts::PI;
use std::sync::Arc;

use super::panel::{NU, Panel, instability};
use super::tank::{TankStrip, wall_strip};
use super::{Answer, Case, hold, solve};
use crate::{Benchmark, Part, Reference};
use fem::assembly::Assembler;
use fem::dofs::Dof;
use fem::element::shell::load::NodalLoads;
use fem::element::shell::section::{ElasticSection, Section};
use fem::element::shell4::MembraneShear;
use fem::linalg::generalized_eigen;

/// The page.
pub(crate) const BENCHMARK: Benchmark = Benchmark {
    id: "shell-axial-buckling",
    title: "Shell: axial buckling of a cylinder",
    model: "Linear buckling of one sector against 0.605 E t/R.",
    ids: &[("S12", "axial buckling of a cylinder, linear and along the nonlinear path")],
    parts: &[
        Part::Fast(|| buckling(&[(64, 8), (64, 12)])),
        Part::Slow(fine),
        Part::Tested(|| panels(12, &[0.02])),
        Part::Slow(|| panels(16, &[0.01, 0.03, 0.1, 0.3])),
    ],
};

/// Critical axial force over E t²/R: strip of 5 half-waves, R/t = 100, uniform prestress, simple supports.
fn critical(sectors: usize, per_half_wave: usize, membrane_shear: MembraneShear) -> Answer<f64> {
    let (radius, t, nu) = (1.0_f64, 0.01, 0.3_f64);
    let half_wave = PI * (radius * t).sqrt() / (12.0_f64 * (1.0 - nu * nu)).powf(0.25);
    let n = 5 * per_half_wave;
    let heights: Vec<f64> = (0..=n).map(|k| 5.0 * half_wave * k as f64 / n as f64).collect();
    let section: Arc<dyn Section> = Arc::new(ElasticSection::new(1.0, nu, t, 0.0)?);
    let TankStrip { mut builder, placed, levels } =
        wall_strip(radius, sectors, &heights, membrane_shear, |_| section.clone())?;
    hold(&mut builder, &levels[0], &[Dof::Uz]);
    // Free to widen: axial force −1 per length everywhere, no hoop force.
    let mut loads = NodalLoads::new();
    let top = levels[n];
    loads.edge_force(top, top.map(|e| builder.position(e)), |_| [0.0, 0.0, -1.0]);
    let before = solve(builder, placed, &loads, [0.0; 3])?;
    let (model, assembler): (_, &Assembler) = (&before.model, &before.assembler);
    // Simple supports come only now, for the buckling mode.
    let keep: Vec<usize> = (0..model.dofs().len())
        .filter(|&e| {
            let (node, dof) = model.dofs().unknown(e);
            !(dof == Dof::Ux && (levels[0].contains(&node) || top.contains(&node)))
        })
        .collect();
    let k = assembler.stiffness(model)?.submatrix(&keep).to_dense();
    let mut g = assembler.geometric_stiffness(model, &before.u)?.submatrix(&keep).to_dense();
    g.data.iter_mut().for_each(|v| *v = -*v);
    let eigen = generalized_eigen(&k, &g, Some(1))?;
    Ok(eigen.omega.first().map_or(f64::NAN, |w| w * w) / (t * t / radius))
}

/// S12: classical buckling force of an axially compressed cylinder.
pub(super) fn buckling(meshes: &[(usize, usize)]) -> Answer {
    let case = Case { id: "S12", source: "Timoshenko & Gere 1961: 1/√(3 (1 − ν²))", unit: "E t²/R" };
    let classical = 1.0 / (3.0_f64 * (1.0 - 0.09)).sqrt();
    let prototype = [((32, 8), 0.6110), ((64, 8), 0.6081), ((64, 20), 0.6044)];
    let mut rows = Vec::new();
    let mut study = Vec::new();
    for &(sectors, per_half_wave) in meshes {
        let value = critical(sectors, per_half_wave, MembraneShear::CentrePoint)?;
        let what = format!("critical axial force, {sectors} sectors, {per_half_wave} per half-wave");
        if sectors == 64 {
            study.push((per_half_wave as f64, value / classical - 1.0));
            // Curvature of a half-wave by n straight pieces: error π²/(12 n²) = 0.6 % at 12; polygon 0.1 %.
            let tolerance = 0.01 * (12.0 / per_half_wave as f64).powi(2).max(1.0);
            rows.push(case.row(what.clone(), Reference::ClosedForm, classical, value, tolerance));
        }
        if let Some(&(_, reference)) = prototype.iter().find(|(mesh, _)| *mesh == (sectors, per_half_wave)) {
            let mut row = case.row(format!("{what}, prototype"), Reference::SecondFormulation, reference, value, 0.002);
            row.source = "independent prototype of the same formulation on the same mesh";
            rows.push(row);
        }
    }
    if let Some(row) = rows.iter_mut().rev().find(|r| r.kind == Reference::ClosedForm) {
        row.convergence = study;
    }
    Ok(rows)
}

/// Plain MITC4 in S12.
pub(super) fn plain_buckling() -> Answer {
    let case =
        Case { id: "S12", source: "independent prototype of the same formulation on the same mesh", unit: "E t²/R" };
    let mut rows = Vec::new();
    for (sectors, reference) in [(32, 0.735), (64, 0.639)] {
        let value = critical(sectors, 8, MembraneShear::Full)?;
        let what = format!("critical axial force, {sectors} sectors, 8 per half-wave, plain MITC4");
        rows.push(case.row(what, Reference::SecondFormulation, reference, value, 0.005));
    }
    Ok(rows)
}

/// Allowed error of 12 and more elements a side: 1.3 % of the bending energy, twice over.
const MESH_ERROR: f64 = 0.03;

/// Root of (1 − λ)² = 3/2 √(3 (1 − ν²)) λ δ below 1.
fn koiter(delta: f64) -> f64 {
    let b = 1.0 + 0.75 * (3.0 * (1.0 - NU * NU)).sqrt() * delta;
    b - (b * b - 1.0).sqrt()
}

/// Finer meshes and plain MITC4.
fn fine() -> Answer {
    let fine = buckling(&[(32, 8), (64, 8), (64, 12), (64, 20)])?;
    Ok([fine, plain_buckling()?].concat())
}

/// S12: bifurcation of the perfect and the imperfect panel.
pub(super) fn panels(n: usize, imperfections: &[f64]) -> Answer {
    let case = Case {
        id: "S12", source: "Koiter 1945: (1 − λ)² = 3/2 √(3 (1 − ν²)) λ δ/t", unit: "classical load"
    };
    let panel = Panel::square(n);
    let mut rows = Vec::new();
    let perfect = instability(&panel.axisymmetric(0.0)?)?.0;
    // 8 elements a half-wave of the axisymmetric mode: π²/(12 · 8²) = 1.3 % of its bending energy; strain 0.15 %.
    rows.push(case.row(
        format!("perfect panel, nonlinear path, {n} × {n} elements"),
        Reference::ClosedForm,
        1.0,
        perfect.stable,
        MESH_ERROR,
    ));
    for &delta in imperfections {
        let found = instability(&panel.axisymmetric(delta)?)?.0;
        // The formula is the limit δ → 0; the terms it leaves out are of the order of δ/t. Up to the error of the mesh it is
        // asserted, beyond it is shown: the rows under internal pressure hold the same panels to 2 % of the full equations.
        let tolerance = if delta <= MESH_ERROR { MESH_ERROR } else { f64::INFINITY };
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

#[cfg(test)]
mod tests {
    use super::super::panel::Panel;
    use super::*;
    use fem::analysis::buckling::lowest;
    use fem::linalg::{Kind, dot};

    /// The panel that Koiter's square waves fit, under the classical load: the multiplier is that of a dense eigenvalue problem, which
    /// needs neither shift nor bracket, and near 1. 8 elements over a wave of the axisymmetric mode: π²/(12 · 4²) = 5 % of its
    /// bending energy, half of the whole.
    #[test]
    fn sparse_mode_is_the_dense_one() {
        let problem = Panel::square(8).axisymmetric(0.0).unwrap();
        let (model, assembler) = (&problem.model, &problem.assembler);
        let stiffness = assembler.stiffness(model).unwrap();
        let factor = problem.symbolic.factor(&stiffness, Kind::Definite).unwrap();
        let u = factor.solve_vector(&problem.load).unwrap();
        let geometric = assembler.geometric_stiffness(model, &u).unwrap();
        let found = lowest(&stiffness, &geometric, &problem.symbolic).unwrap().unwrap();
        let mut dense = geometric.to_dense();
        dense.data.iter_mut().for_each(|v| *v = -*v);
        let eigen = generalized_eigen(&stiffness.to_dense(), &dense, Some(1)).unwrap();
        let dense = eigen.omega[0].powi(2);
        assert!((found.factor / dense - 1.0).abs() < 1e-8, "{} {dense}", found.factor);
        assert!((found.factor - 1.0).abs() < 0.03, "{}", found.factor);
        // Rayleigh's quotient of the mode.
        let quotient =
            -dot(&stiffness.times(&found.mode), &found.mode) / dot(&geometric.times(&found.mode), &found.mode);
        assert!((quotient / found.factor - 1.0).abs() < 1e-8, "{quotient}");
        // Under tension nothing buckles.
        let pulled = {
            let mut out = geometric.clone();
            out.values.iter_mut().for_each(|v| *v = -*v);
            lowest(&stiffness, &out, &problem.symbolic).unwrap()
        };
        assert!(pulled.is_none_or(|b| b.factor > 10.0));
    }
}
