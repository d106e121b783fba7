//! Finite rotations: S13 cantilever under an end force, S14 roll-up under an end moment.

use std::f64::consts::PI;
use std::sync::Arc;

use super::{Answer, Case, Grid, hold};
use crate::assembly::Assembler;
use crate::dofs::Dof;
use crate::element::shell::load::NodalLoads;
use crate::element::shell::section::{ElasticSection, Section};
use crate::element::shell4::Axes;
use crate::element::{ElementError, Want};
use crate::linalg::{Kind, Ordering, Symbolic, Symmetric, dot};
use crate::model::{Builder, Model};
use crate::state::State;
use crate::verify::{Reference, Row};

/// Strip of length × 1 × 0.1 along x, E 1.2e6, ν 0, clamped at x = 0: model and its tip nodes.
fn strip(length: f64, elements: usize) -> Answer<(Model, Vec<usize>)> {
    let section: Arc<dyn Section> = Arc::new(ElasticSection::new(1.2e6, 0.0, 0.1, 0.0)?);
    let grid = Grid::new(elements, 1);
    let mut builder = Builder::new();
    grid.nodes(&mut builder, |a, b| [length * a, b, 0.0]);
    let mut surface = grid.surface(&section);
    // Rotation frames (y, −x, z): the moment about y is the first component at any rotation about y.
    surface.axes = Axes::Along([0.0, 1.0, 0.0]);
    surface.place(&mut builder)?;
    hold(&mut builder, &grid.line_i(0), Dof::SHELL);
    Ok((builder.build()?, grid.line_i(elements)))
}

/// Newton with plain tangent in equal load steps; the displacement of `node` after each step.
fn path(model: &Model, load: &[f64], steps: usize, node: usize) -> Answer<Vec<[f64; 3]>> {
    let assembler = Assembler::new(model);
    let symbolic = Arc::new(Symbolic::new(assembler.pattern().clone(), &Ordering::MinimumDegree)?);
    let mut tangent = Symmetric::zeros(assembler.pattern().clone());
    let mut state = State::new(model);
    let mut out = Vec::new();
    for step in 1..=steps {
        let factor = step as f64 / steps as f64;
        let mut first = None;
        let mut converged = false;
        for _ in 0..40 {
            let force = assembler
                .respond(model, &mut state, Want::ALL, &mut tangent)
                .map_err(|(_, error)| error)?;
            let residual: Vec<f64> = load.iter().zip(&force).map(|(p, f)| factor * p - f).collect();
            // A tangent on the way to equilibrium may be indefinite.
            let du = symbolic
                .factor(&tangent, Kind::QuasiDefinite)?
                .solve_vector(&residual)?;
            state.increment(model, &du);
            let work = dot(&du, &residual).abs();
            // Work of the increment beside that of the step's first: rotations are then good to seven digits.
            converged = work <= 1e-14 * *first.get_or_insert(work);
            if converged {
                break;
            }
        }
        if !converged {
            return Err(ElementError::NoAnswer {
                kind: "shell4",
                reason: format!("no equilibrium in load step {step} of {steps}"),
            }
            .into());
        }
        state.commit();
        let [x, y, z, ..] = model.at_node(&state.committed.u, node);
        out.push([x, y, z]);
    }
    Ok(out)
}

/// S13: end force 4 on a strip of length 10, 20 elements.
pub(super) fn cantilever() -> Answer<Vec<Row>> {
    let case = Case {
        id: "S13",
        page: "shell-cantilever",
        source: "Sze, Liu & Lo 2004",
        unit: "length",
    };
    let (model, tip) = strip(10.0, 20)?;
    let mut loads = NodalLoads::new();
    tip.iter().for_each(|&n| loads.force(n, [0.0, 0.0, 2.0]));
    let path = path(&model, &loads.vector(&model), 8, tip[0])?;
    let mut rows = Vec::new();
    for (step, name, w, u) in [(3, "half load", 4.933, 1.604), (7, "full load", 6.698, 3.286)] {
        // 20 elements: error of second order, 0.2 % by the prototype; the curve is printed to four digits.
        let [x, _, z] = path[step];
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
    let mut study = Vec::new();
    for &n in meshes {
        let (model, tip) = strip(length, n)?;
        let mut loads = NodalLoads::new();
        // Upwards: about −y.
        let moment = 2.0 * PI * 100.0 / length;
        tip.iter().for_each(|&n| loads.moment(n, [0.0, -0.5 * moment, 0.0]));
        let path = path(&model, &loads.vector(&model), 20, tip[0])?;
        study.push((n as f64, path[9], path[19]));
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
    Ok(rows)
}
