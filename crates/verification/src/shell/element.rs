//! S1: zero energies, rigid rotations, tangent of one element.

use std::sync::Arc;

use nalgebra::{DMatrix, UnitQuaternion, Vector3};

use super::{Answer, Case};
use crate::{Benchmark, Part, Reference};
use fem::element::shell::section::ElasticSection;
use fem::element::shell::surface::rotation_frame;
use fem::element::shell4::{Axes, SIZE, Shell4, rigid_motion};
use fem::element::{Element, Motion, Response, Trial, Want, reference_stiffness};

/// The page.
pub(crate) const BENCHMARK: Benchmark = Benchmark {
    id: "shell-element",
    title: "Shell: one element",
    model: "One distorted `shell4`: zero energies, finite rigid rotations, tangent against differences of the \
            force.",
    ids: &[("S1", "zero energies, rigid rotations, tangent of one element")],
    parts: &[Part::Fast(element)],
};

const FLAT: [[f64; 3]; 4] = [[0.0, 0.0, 0.0], [1.2, 0.1, 0.0], [1.0, 0.9, 0.0], [-0.1, 1.1, 0.0]];

const WARPED: [[f64; 3]; 4] = [[0.0, 0.0, 0.1], [1.2, 0.1, -0.1], [1.0, 0.9, 0.2], [-0.1, 1.1, -0.05]];

fn shell(x: [[f64; 3]; 4], tilt: f64, drilling: bool) -> Answer<(Shell4, [Vector3<f64>; 4])> {
    let directors = [[0.1, 0.05], [-0.1, 0.1], [0.0, -0.2], [0.2, 0.1]]
        .map(|[a, b]| Vector3::new(tilt * a, tilt * b, 1.0).normalize());
    let section = ElasticSection::new(1000.0, 0.3, 0.1, 1.0)?;
    let shell = Shell4::new([0, 1, 2, 3], x, directors, Arc::new(section))?.with_drilling([drilling; 4], 1e-3)?;
    Ok((shell, directors))
}

/// Eigenvalues of the stiffness, relative to the largest, ascending; without drilling in the space of the five
/// parameters of each node.
fn eigenvalues(x: [[f64; 3]; 4], tilt: f64, drilling: bool) -> Answer<Vec<f64>> {
    let (shell, directors) = shell(x, tilt, drilling)?;
    let k = reference_stiffness(&shell)?;
    let full = DMatrix::from_fn(SIZE, SIZE, |i, j| k.get(i, j));
    let per_node = if drilling { 6 } else { 5 };
    let mut basis = DMatrix::<f64>::zeros(SIZE, 4 * per_node);
    for a in 0..4 {
        let frame = rotation_frame(&Axes::Element, x[a], directors[a]);
        for i in 0..3 {
            basis[(6 * a + i, per_node * a + i)] = 1.0;
            for j in 0..per_node - 3 {
                basis[(6 * a + 3 + i, per_node * a + 3 + j)] = frame[(j, i)];
            }
        }
    }
    let reduced = basis.transpose() * full * &basis;
    let mut values: Vec<f64> = reduced.symmetric_eigen().eigenvalues.iter().copied().collect();
    values.sort_by(f64::total_cmp);
    let largest = values[values.len() - 1];
    Ok(values.iter().map(|v| v / largest).collect())
}

fn respond(shell: &Shell4, values: &[f64; SIZE], rotations: &[UnitQuaternion<f64>; 4]) -> Answer<Response> {
    let mut out = Response::sized(SIZE);
    shell.respond(Trial { motion: Motion { values, rotations }, old: &[], new: &mut [], want: Want::ALL }, &mut out)?;
    Ok(out)
}

/// Reproducible numbers between −1 and 1.
fn scatter(k: usize) -> f64 {
    (1.0 + 2.7 * k as f64 + 0.3 * (k * k) as f64).sin()
}

/// Largest difference between the tangent and the symmetric part of central differences of the force, relative to the
/// largest entry, at a warped element turned by two radians and then deformed.
fn tangent_error(drilling: bool) -> Answer<f64> {
    let (shell, _) = shell(WARPED, 1.0, drilling)?;
    let turn = UnitQuaternion::from_scaled_axis(Vector3::new(0.7, -1.9, 1.1));
    let (mut u, mut r) = rigid_motion(&WARPED, turn, [0.3, 0.2, 0.1]);
    for a in 0..4 {
        (0..3).for_each(|i| u[6 * a + i] += 0.2 * scatter(3 * a + i));
        let own = Vector3::new(scatter(40 + a), scatter(50 + a), scatter(60 + a)) * 0.4;
        r[a] = UnitQuaternion::from_scaled_axis(own) * r[a];
    }
    let tangent = respond(&shell, &u, &r)?.tangent;
    let h = 1e-5;
    let mut difference = DMatrix::<f64>::zeros(SIZE, SIZE);
    for j in 0..SIZE {
        for sign in [-1.0, 1.0] {
            let (mut u, mut r) = (u, r);
            if j % 6 < 3 {
                u[j] += sign * h;
            } else {
                let mut spin = Vector3::zeros();
                spin[j % 6 - 3] = sign * h;
                r[j / 6] = UnitQuaternion::from_scaled_axis(spin) * r[j / 6];
            }
            for (i, f) in respond(&shell, &u, &r)?.force.iter().enumerate() {
                difference[(i, j)] += sign * f / (2.0 * h);
            }
        }
    }
    let symmetric = (&difference + difference.transpose()) * 0.5;
    let scale = tangent.data.iter().fold(0.0_f64, |m, v| m.max(v.abs()));
    Ok((0..SIZE * SIZE).map(|k| (tangent.data[k] - symmetric[(k % SIZE, k / SIZE)]).abs() / scale).fold(0.0, f64::max))
}

/// S1.
pub(super) fn element() -> Answer {
    let case = Case { id: "S1", source: "rigid bodies have six motions; a tangent is a derivative", unit: "-" };
    let mut rows = Vec::new();
    for (name, x, tilt) in [("flat", FLAT, 0.0), ("warped", WARPED, 1.0)] {
        for drilling in [false, true] {
            let unknowns = if drilling { "24" } else { "20" };
            let values = eigenvalues(x, tilt, drilling)?;
            // 1e-11 lies between rounding (1e-16 times the size) and the softest true mode (drilling, some 1e-6).
            let zeros = values.iter().filter(|v| v.abs() < 1e-11).count();
            let what = format!("zero eigenvalues, {name}, {unknowns} unknowns");
            rows.push(case.row(what, Reference::ClosedForm, 6.0, zeros as f64, 0.0));
        }
    }
    for angle in [0.1, 1.5, 3.0] {
        let (shell, _) = shell(WARPED, 1.0, true)?;
        let turn = UnitQuaternion::from_scaled_axis(Vector3::new(0.48, -0.6, 0.64) * angle);
        let (u, r) = rigid_motion(&WARPED, turn, [0.3, 0.2, 0.1]);
        let worst = respond(&shell, &u, &r)?.force.iter().fold(0.0_f64, |m, f| m.max(f.abs()));
        let what = format!("largest force under a rigid rotation of {angle} rad, over E t L");
        // Rounding of some hundred products; the sheet allows 1e-9.
        rows.push(case.row(what, Reference::ClosedForm, 0.0, worst / 100.0, 1e-12));
    }
    for (name, drilling) in [("without", false), ("with", true)] {
        let what = format!("tangent against central differences, {name} drilling");
        // Step 1e-5: truncation 1e-10, rounding 1e-16/1e-5 times the size.
        rows.push(case.row(what, Reference::SecondFormulation, 0.0, tangent_error(drilling)?, 1e-8));
    }
    Ok(rows)
}
