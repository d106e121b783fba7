//! S9: closed frame under inner pressure.

use std::sync::Arc;

use super::{Answer, Case, hold, solve, surface};
use crate::{Benchmark, Part, Reference};
use fem::dofs::Dof;
use fem::element::shell::load::NodalLoads;
use fem::element::shell::recovery::nodal_resultants;
use fem::element::shell::section::{ElasticSection, Section};
use fem::element::shell::surface::ShellCell;
use fem::element::shell4::Axes;
use fem::model::Builder;

/// The page.
pub(crate) const BENCHMARK: Benchmark = Benchmark {
    id: "shell-square-frame",
    title: "Shell: closed frame under inner pressure",
    model: "Square frame of plates with folds at its corners, a strip one element wide, under inner pressure.",
    ids: &[("S9", "closed frame under inner pressure")],
    parts: &[Part::Fast(square_frame)],
};

/// S9: closed square frame under inner pressure, a strip one element wide.
pub(super) fn square_frame() -> Answer {
    // More than 80 lines: one model from nodes to section forces.
    let case = Case { id: "S9", source: "symmetric frame: p a²/12, p a²/24, p a/2", unit: "kN m/m, kN/m" };
    let (side, pressure) = (5.0, 10.0);
    let mut study = Vec::new();
    let mut rows = Vec::new();
    for n in [4_usize, 8, 16] {
        let section: Arc<dyn Section> = Arc::new(ElasticSection::new(3e7, 0.0, 0.3, 0.0)?);
        let width = side / n as f64;
        let mut builder = Builder::new();
        let total = 4 * n;
        for y in [0.0, width] {
            for k in 0..total {
                let s = (k % n) as f64 * width;
                let (x, z) = match k / n {
                    0 => (s, 0.0),
                    1 => (side, s),
                    2 => (side - s, side),
                    _ => (0.0, side - s),
                };
                builder.node([x, y, z]);
            }
        }
        // Normal outwards: on the lower side along −z, from x × y reversed.
        let cells: Vec<ShellCell> = (0..total)
            .map(|k| ShellCell {
                nodes: [k, (k + 1) % total, total + (k + 1) % total, total + k],
                section: section.clone(),
                group: format!("side {}", k / n),
            })
            .map(|mut c| {
                c.nodes.reverse();
                c
            })
            .collect();
        let mut shell = surface(&[], &section);
        shell.axes = Axes::Along([0.0, 1.0, 0.0]);
        shell.cells = cells;
        let mut loads = NodalLoads::new();
        for cell in &shell.cells {
            loads.pressure(&cell.nodes, &cell.nodes.map(|m| builder.position(m)), |_| pressure);
        }
        let placed = shell.place(&mut builder)?;
        for node in 0..2 * total {
            // Plane strip: no displacement along y, rotation about y only.
            let corner = (node % total) % n == 0;
            let dofs: &[Dof] = if corner { &[Dof::Uy, Dof::Rx, Dof::Rz] } else { &[Dof::Uy, Dof::Ry] };
            hold(&mut builder, &[node], dofs);
        }
        for row in [0, total] {
            hold(&mut builder, &[row + n / 2, row + 2 * n + n / 2], &[Dof::Ux]);
            hold(&mut builder, &[row + n + n / 2, row + 3 * n + n / 2], &[Dof::Uz]);
        }
        let solution = solve(builder, placed, &loads, [0.0; 3])?;
        let group = solution.model.group("side 0");
        let model = &solution.model;
        let forces = solution.assembler.nodal_forces(model, &solution.u, |e| Some(model.group_of(e)) == group)?;
        // Both rows of nodes together carry the strip. Along the side the corner's force holds half an element's load
        // across, none along.
        let corner = (forces[0][4] + forces[total][4]).abs() / width;
        let axial = (forces[0][0] + forces[total][0]).abs() / width;
        let nodal = nodal_resultants(model, &solution.placed.elements[..n], &solution.u);
        let middle = nodal[&(n / 2)][4].abs();
        study.push((n as f64, corner, middle, axial));
    }
    let quantities = [
        ("corner moment", pressure * side * side / 12.0, 0.01),
        ("moment in the middle", pressure * side * side / 24.0, 0.02),
        ("axial force", pressure * side / 2.0, 1e-3),
    ];
    for (q, (what, reference, tolerance)) in quantities.into_iter().enumerate() {
        let value = |r: &(f64, f64, f64, f64)| [r.1, r.2, r.3][q];
        let Some(last) = study.last() else { break };
        // Moments: element-wise constant, error of second order in 1/16; axial force: statics.
        let mut row = case.row(what, Reference::ClosedForm, reference, value(last), tolerance);
        row.convergence = study.iter().map(|r| (r.0, value(r) / reference - 1.0)).collect();
        rows.push(row);
    }
    Ok(rows)
}
