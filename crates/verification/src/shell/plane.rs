//! Plane structures and plates: S2 patch, S7 Cook, S8 Z-cantilever, S9 frame, S10 plate.

use std::sync::Arc;

use super::{Answer, Case, Grid, hold, solve, surface};
use crate::{Reference, Row};
use fem::assembly::Assembler;
use fem::dofs::Dof;
use fem::element::Inspect;
use fem::element::shell::load::NodalLoads;
use fem::element::shell::recovery::nodal_resultants;
use fem::element::shell::section::{ElasticSection, Section};
use fem::element::shell::surface::{DRILLING, ShellCell};
use fem::element::shell4::{Axes, RESULTANTS};
use fem::linalg::{Cholesky, generalized_eigen};
use fem::model::Builder;

/// S2: the patch of MacNeal & Harder with displacements given on its boundary.
pub(super) fn patch() -> Answer<Vec<Row>> {
    let (thickness, scale) = (1e-3_f64, 1e-3);
    let section: Arc<dyn Section> = Arc::new(ElasticSection::new(1e6, 0.25, thickness, 0.0)?);
    let mut builder = Builder::new();
    let plan = [
        [0.0, 0.0],
        [0.24, 0.0],
        [0.24, 0.12],
        [0.0, 0.12],
        [0.04, 0.02],
        [0.18, 0.03],
        [0.16, 0.08],
        [0.08, 0.08],
    ];
    plan.iter().for_each(|&[x, y]| {
        builder.node([x, y, 0.0]);
    });
    let cells = [[0, 1, 5, 4], [1, 2, 6, 5], [2, 3, 7, 6], [3, 0, 4, 7], [4, 5, 6, 7]];
    let mut shell = surface(&cells, &section);
    shell.axes = Axes::Along([1.0, 0.0, 0.0]);
    let placed = shell.place(&mut builder)?;
    let model = builder.build()?;
    let assembler = Assembler::new(&model);
    let k = assembler.stiffness(&model)?.to_dense();
    let case = Case {
        id: "S2",
        page: "shell-patch",
        source: "MacNeal & Harder 1985",
        unit: "N/m² and N",
    };
    let membrane = model.vector(|n| {
        let [x, y] = plan[n];
        [
            scale * (x + 0.5 * y),
            scale * (y + 0.5 * x),
            0.0,
            0.0,
            0.0,
            0.0,
            0.0,
            0.0,
            0.0,
        ]
    });
    let bending = model.vector(|n| {
        let [x, y] = plan[n];
        let w = 0.5 * scale * (x * x + x * y + y * y);
        let (w_x, w_y) = (scale * (x + 0.5 * y), scale * (y + 0.5 * x));
        [0.0, 0.0, w, w_y, -w_x, 0.0, 0.0, 0.0, 0.0]
    });
    let mut rows = Vec::new();
    // m = −D (w,xx + ν w,yy): the director turns against the slope.
    let plate = 1e6 * thickness * thickness * thickness / (12.0 * (1.0 - 0.0625)) * scale;
    let expected = [
        (&membrane, 0, [4000.0 / 3.0, 4000.0 / 3.0, 400.0], thickness),
        (&bending, 3, [-1.25 * plate, -1.25 * plate, -0.375 * plate], 1.0),
    ];
    for (given, first, reference, divisor) in expected {
        let inner: Vec<usize> = (0..model.dofs().len())
            .filter(|&e| model.dofs().unknown(e).0 >= 4)
            .collect();
        let outer: Vec<usize> = (0..model.dofs().len())
            .filter(|&e| model.dofs().unknown(e).0 < 4)
            .collect();
        let boundary: Vec<f64> = outer.iter().map(|&e| given[e]).collect();
        let load: Vec<f64> = k.select(&inner, &outer).times(&boundary).iter().map(|f| -f).collect();
        let found = Cholesky::factor(&k.select(&inner, &inner))?.solve_vector(&load);
        let mut u = given.clone();
        inner.iter().zip(&found).for_each(|(&e, &v)| u[e] = v);
        for (i, reference) in reference.into_iter().enumerate() {
            let mut worst = reference;
            for &e in &placed.elements {
                let element = &*model.elements()[e];
                let local = fem::assembly::local_values(&model, element, &u);
                for sample in element.samples().iter().filter(|s| s.name == RESULTANTS[first + i]) {
                    let value = sample.row.iter().zip(&local).map(|(c, v)| c * v).sum::<f64>() / divisor;
                    if (value - reference).abs() > (worst - reference).abs() {
                        worst = value;
                    }
                }
            }
            let what = format!("{}, worst of all points", RESULTANTS[first + i]);
            // Exact up to rounding, which grows with the ratio of side to thickness (100) squared.
            rows.push(case.row(what, Reference::ClosedForm, reference, worst, 1e-9));
        }
    }
    Ok(rows)
}

/// S7: Cook's membrane, n × n elements.
pub(super) fn cook(meshes: &[usize]) -> Answer<Vec<Row>> {
    let case = Case {
        id: "S7",
        page: "shell-cook",
        source: "Cook 1974; 23.96 is the limit of fine meshes",
        unit: "m",
    };
    let mut values = Vec::new();
    for &n in meshes {
        let section: Arc<dyn Section> = Arc::new(ElasticSection::new(1.0, 1.0 / 3.0, 1.0, 0.0)?);
        let grid = Grid::new(n, n);
        let mut builder = Builder::new();
        grid.nodes(&mut builder, |a, b| [48.0 * a, 44.0 * (a + b) - 28.0 * a * b, 0.0]);
        let placed = grid.surface(&section).place(&mut builder)?;
        let all: Vec<usize> = (0..(n + 1) * (n + 1)).collect();
        hold(&mut builder, &all, &[Dof::Uz, Dof::Rx, Dof::Ry]);
        hold(&mut builder, &grid.line_i(0), Dof::TRANSLATIONS);
        let mut loads = NodalLoads::new();
        for pair in grid.line_i(n).windows(2) {
            let edge = [pair[0], pair[1]];
            loads.edge_force(edge, edge.map(|e| builder.position(e)), |_| [0.0, 1.0 / 16.0, 0.0]);
        }
        let middle = grid.node(n, n / 2);
        values.push((n, solve(builder, placed, &loads, [0.0; 3])?.at(middle)[1]));
    }
    let prototype = [(2, 13.88), (4, 19.84), (8, 22.69), (16, 23.61), (32, 23.87)].map(|(n, v)| (n, v / 23.96));
    // Published: 32 × 32 still lacks 0.4 %, error of first to second order because of the corner of the support.
    // Prototype: its centre-point shear is the same; printed to four digits.
    Ok(case.study("middle of the free edge", 23.96, 0.01, &values, &prototype, 0.02))
}

/// σ_xx [MPa] at the flange tip of the Z-cantilever, n elements along it.
fn z_cantilever_stress(n: usize, drilling: f64) -> Answer<f64> {
    let thickness = 0.1;
    let section: Arc<dyn Section> = Arc::new(ElasticSection::new(210e9, 0.3, thickness, 0.0)?);
    // Developed width: lower flange, web, upper flange.
    let (flange, web) = (n / 4, n / 2);
    let grid = Grid::new(n, 2 * flange + web);
    let mut builder = Builder::new();
    let width = (2 * flange + web) as f64;
    grid.nodes(&mut builder, |a, b| {
        let s = 4.0 * (b * width).round() / width;
        let (y, z) = match s {
            s if s < 1.0 => (s - 1.0, -1.0),
            s if s > 3.0 => (s - 3.0, 1.0),
            s => (0.0, s - 2.0),
        };
        [10.0 * a, y, z]
    });
    let mut shell = grid.surface(&section);
    (shell.axes, shell.drilling) = (Axes::Along([1.0, 0.0, 0.0]), drilling);
    let placed = shell.place(&mut builder)?;
    hold(&mut builder, &grid.line_i(0), Dof::SHELL);
    let mut loads = NodalLoads::new();
    let end = grid.line_i(n);
    for (from, force) in [(0, -0.6e6), (flange + web, 0.6e6)] {
        for pair in end[from..=from + flange].windows(2) {
            let edge = [pair[0], pair[1]];
            loads.edge_force(edge, edge.map(|e| builder.position(e)), |_| [0.0, force, 0.0]);
        }
    }
    let tip = grid.node(n / 4, 2 * flange + web);
    let solution = solve(builder, placed, &loads, [0.0; 3])?;
    // Elements run along x first: the upper flange is the last rows.
    let upper = &solution.placed.elements[n * (flange + web)..];
    let nodal = nodal_resultants(&solution.model, upper, &solution.u);
    Ok(nodal[&tip][0] / thickness / 1e6)
}

/// S8: NAFEMS LE5, three plates joined at folds.
pub(super) fn z_cantilever() -> Answer<Vec<Row>> {
    let case = Case {
        id: "S8",
        page: "shell-z-cantilever",
        source: "NAFEMS 1990, LE5",
        unit: "MPa",
    };
    let mut values = Vec::new();
    for n in [8_usize, 16] {
        values.push((n, z_cantilever_stress(n, DRILLING)?));
    }
    // The sheet's tolerance, 3 % of what the prototype gives; the series tends to −111.4, not to the printed −108,
    // which is why the published value gets 4 %.
    let prototype = [(8, 113.6 / 108.0), (16, 111.7 / 108.0)];
    Ok(case.study(
        "σ_xx at the flange tip, x = 2.5 m",
        -108.0,
        0.04,
        &values,
        &prototype,
        0.03,
    ))
}

/// S8: the drilling factor hardly matters.
pub(super) fn drilling() -> Answer<Vec<Row>> {
    let case = Case {
        id: "S8",
        page: "shell-z-cantilever",
        source: "the same with the default factor 10⁻³",
        unit: "MPa",
    };
    let default = z_cantilever_stress(16, DRILLING)?;
    let mut rows = Vec::new();
    for factor in [1e-6, 1e-4, 1e-2, 1e-1, 1.0] {
        let value = z_cantilever_stress(16, factor)?;
        // A study; only that small factors do not matter is asserted.
        let tolerance = if factor <= 1e-2 { 2e-3 } else { f64::INFINITY };
        rows.push(case.row(
            format!("σ_xx with k_d = {factor:.0e}"),
            Reference::Regression,
            default,
            value,
            tolerance,
        ));
    }
    Ok(rows)
}

/// S9: closed square frame under inner pressure, a strip one element wide.
pub(super) fn square_frame() -> Answer<Vec<Row>> {
    let case = Case {
        id: "S9",
        page: "shell-square-frame",
        source: "symmetric frame: p a²/12, p a²/24, p a/2",
        unit: "kN m/m, kN/m",
    };
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
            let dofs: &[Dof] = if corner {
                &[Dof::Uy, Dof::Rx, Dof::Rz]
            } else {
                &[Dof::Uy, Dof::Ry]
            };
            hold(&mut builder, &[node], dofs);
        }
        for row in [0, total] {
            hold(&mut builder, &[row + n / 2, row + 2 * n + n / 2], &[Dof::Ux]);
            hold(&mut builder, &[row + n + n / 2, row + 3 * n + n / 2], &[Dof::Uz]);
        }
        let solution = solve(builder, placed, &loads, [0.0; 3])?;
        let group = solution.model.group("side 0");
        let model = &solution.model;
        let forces = solution
            .assembler
            .nodal_forces(model, &solution.u, |e| Some(model.group_of(e)) == group)?;
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

/// S10: NAFEMS FV16, square plate clamped on one side; out-of-plane motion only.
pub(super) fn cantilever_plate(meshes: &[usize]) -> Answer<Vec<Row>> {
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
        let case = Case {
            id: "S10",
            page: "shell-cantilever-plate",
            source: "NAFEMS 1990, FV16",
            unit: "Hz",
        };
        let hertz = |omega: &Vec<f64>| omega.get(mode).map_or(f64::NAN, |w| w / std::f64::consts::TAU);
        let Some((n, finest)) = study.last() else { break };
        let what = format!("frequency {}, {n} × {n}", mode + 1);
        // 1 % on 16 × 16 (sheet); the error is of second order: 1 % (16/n)².
        let tolerance = 0.01 * (16.0 / *n as f64).powi(2).max(1.0);
        let mut row = case.row(what, Reference::Published, reference, hertz(finest), tolerance);
        row.convergence = study
            .iter()
            .map(|(n, w)| (*n as f64, hertz(w) / reference - 1.0))
            .collect();
        rows.push(row);
    }
    Ok(rows)
}
