//! S21: limit loads of plates of ideally plastic steel, small displacements.
//!
//! Circular plates under uniform pressure, p_u R²/M_p, and plane-strain bending, m_u/M_p; M_p = f_y t²/4. The yield strain is 10⁻⁶,
//! so that the deflection stays far below the thickness and no membrane force helps.

use std::collections::BTreeMap;
use std::f64::consts::FRAC_PI_4;
use std::sync::Arc;

use materials::von_mises::VonMises;

use super::path::Problem;
use super::{Answer, Case, hold, surface};
use crate::{Benchmark, Part, Reference};
use fem::dofs::Dof;
use fem::element::ElementError;
use fem::element::shell::layered::{LayeredSection, Ply};
use fem::element::shell::load::NodalLoads;
use fem::element::shell::rule::Rule;
use fem::element::shell::section::{Section, SectionResponse};
use fem::element::shell4::Axes;
use fem::model::Builder;

/// The page.
pub(crate) const BENCHMARK: Benchmark = Benchmark {
    id: "shell-plastic-plates",
    title: "Shell: plastic plates",
    model: "Circular plates and a strip of von Mises steel without hardening, loaded to collapse.",
    ids: &[("S21", "plastic collapse of plates")],
    parts: &[Part::Tested(|| plates(&[4, 6])), Part::Slow(|| plates(&[4, 8, 12]))],
};

const YOUNG: f64 = 200e9;

const NU: f64 = 0.3;

const YIELD: f64 = 200e3;

/// Section of thickness t in `layers` stretched layers: an even number has the exact plastic moment to 1/(2 n²).
fn steel(t: f64, layers: usize) -> Answer<LayeredSection> {
    let law = VonMises::new(YOUNG, NU, YIELD, 0.0, 0.0)
        .map_err(|source| ElementError::Law { kind: "layered section", source })?;
    let ply = Ply { law: Arc::new(law), thickness: t, density: 0.0, rule: Rule::MidPoint(layers) };
    Ok(LayeredSection::new(&[ply], &[])?)
}

/// Nodes and cells of a quarter of the unit disc: a square of m × m cells about the centre, and m + m cells by `k` rings
/// around it, graded towards the edge.
fn quarter_disc(m: usize, k: usize) -> (Vec<[f64; 3]>, Vec<[usize; 4]>) {
    let mut numbers: BTreeMap<(i64, i64), usize> = BTreeMap::new();
    let (mut positions, mut cells) = (Vec::new(), Vec::new());
    let mut node = |x: f64, y: f64| {
        let key = ((x * 1e9).round() as i64, (y * 1e9).round() as i64);
        *numbers.entry(key).or_insert_with(|| {
            positions.push([x, y, 0.0]);
            positions.len() - 1
        })
    };
    let (side, corner) = (0.5, 0.42);
    // Edge of the inner square opposite to the origin, from the x axis to the diagonal.
    let inner = |a: f64| [side + (corner - side) * a, corner * a];
    let core = |a: f64, b: f64| [a * inner(b)[0], b * inner(a)[0]];
    for j in 0..m {
        for i in 0..m {
            let at = |i: usize, j: usize| core(i as f64 / m as f64, j as f64 / m as f64);
            cells.push([(i, j), (i + 1, j), (i + 1, j + 1), (i, j + 1)].map(|(i, j)| {
                let [x, y] = at(i, j);
                node(x, y)
            }));
        }
    }
    let ring = |a: f64, b: f64| {
        let (s, c) = (FRAC_PI_4 * a).sin_cos();
        // Rings become thinner outwards.
        let b = b * (1.5 - 0.5 * b);
        let [x, y] = inner(a);
        [x + (c - x) * b, y + (s - y) * b]
    };
    for j in 0..k {
        for i in 0..m {
            let at = |i: usize, j: usize| ring(i as f64 / m as f64, j as f64 / k as f64);
            let corners = [(i, j), (i, j + 1), (i + 1, j + 1), (i + 1, j)];
            cells.push(corners.map(|(i, j)| {
                let [x, y] = at(i, j);
                node(x, y)
            }));
            // Its mirror image about the diagonal, turned the other way round.
            let mirrored = [(i, j), (i + 1, j), (i + 1, j + 1), (i, j + 1)];
            cells.push(mirrored.map(|(i, j)| {
                let [x, y] = at(i, j);
                node(y, x)
            }));
        }
    }
    (positions, cells)
}

/// p R²/M_p of a circular plate at growing deflection, in multiples of the elastic deflection under the reference load.
fn plate(clamped: bool, m: usize, reference: f64, multiples: &[f64]) -> Answer<Vec<f64>> {
    let t = 0.05_f64;
    let section: Arc<dyn Section> = Arc::new(steel(t, 12)?);
    let (positions, cells) = quarter_disc(m, 2 * m);
    let mut builder = Builder::new();
    builder.nodes(&positions);
    let mut shell = surface(&cells, &section);
    shell.axes = Axes::Along([1.0, 0.0, 0.0]);
    shell.place(&mut builder)?;
    let small = 1e-9;
    for (node, [x, y, _]) in positions.iter().enumerate() {
        if x.abs() < small {
            hold(&mut builder, &[node], &[Dof::Ux, Dof::Ry]);
        }
        if y.abs() < small {
            hold(&mut builder, &[node], &[Dof::Uy, Dof::Rx]);
        }
        if x.hypot(*y) > 1.0 - small {
            hold(&mut builder, &[node], if clamped { Dof::SHELL } else { &[Dof::Uz] });
        }
    }
    let plastic = YIELD * t * t / 4.0;
    let mut loads = NodalLoads::new();
    for cell in &cells {
        loads.pressure(cell, &cell.map(|n| positions[n]), |_| -plastic);
    }
    let problem = Problem::new(builder, &loads)?;
    let stiffness = YOUNG * t.powi(3) / (12.0 * (1.0 - NU * NU));
    let factor = if clamped { 1.0 } else { (5.0 + NU) / (1.0 + NU) };
    let elastic = reference * plastic * factor / (64.0 * stiffness);
    let targets: Vec<f64> = multiples.iter().map(|k| -k * elastic).collect();
    let centre = positions.iter().position(|p| p[0] == 0.0 && p[1] == 0.0).unwrap_or(0);
    Ok(problem.at_displacements((centre, Dof::Uz), &targets, 0.2 * elastic, |_, _| {})?.0)
}

/// S21: limit loads of circular plates and of a strip in plane strain.
pub(super) fn plates(meshes: &[usize]) -> Answer {
    let case = Case { id: "S21", source: "Hopkins & Wang 1955", unit: "M_p/R²" };
    let mut rows = Vec::new();
    for (name, clamped, reference) in [("simply supported", false, 6.52), ("clamped", true, 12.5)] {
        let mut study = Vec::new();
        for &m in meshes {
            // At 8 times the elastic deflection the load still grows by less than a thousandth.
            let loads = plate(clamped, m, reference, &[1.0, 2.0, 4.0, 8.0])?;
            study.push((m, loads[3]));
        }
        if let Some(&(m, value)) = study.last() {
            let what = format!("limit load, {name} circular plate, {m} elements on half the radius");
            // 3 % (sheet).
            let mut row = case.row(what, Reference::Published, reference, value, 0.03);
            row.convergence = study.iter().map(|&(m, v)| (m as f64, v / reference - 1.0)).collect();
            rows.push(row);
        }
    }
    let t = 0.05;
    let section = steel(t, 20)?;
    let mut old = vec![0.0; section.history_len()];
    section.init_history(&mut old);
    let mut out = SectionResponse::default();
    let mut strain = [0.0; 8];
    for step in 1..=200 {
        // To 100 times the curvature of first yield.
        strain[3] = 0.5 * f64::from(step) * 2.0 * YIELD / (YOUNG * t);
        let mut new = old.clone();
        section.respond(&strain, &old, &mut new, &mut out)?;
        old = new;
    }
    let mut row = case.row(
        "limit moment of a strip in plane strain",
        Reference::ClosedForm,
        2.0 / 3.0_f64.sqrt(),
        out.resultants[3] / (YIELD * t * t / 4.0),
        0.005,
    );
    (row.unit, row.source) = ("M_p", "2/√3, von Mises");
    rows.push(row);
    Ok(rows)
}
