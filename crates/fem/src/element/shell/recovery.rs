//! Nodal values of the resultants, and edge values from reactions.
//!
//! Centres of elements are superconvergent for m and q; Gauss points are carried to the nodes by the bilinear function
//! through them and averaged inside one smooth patch of one section only. At a supported edge both are poor: the first
//! Gauss point of a clamped wall shows half its moment. There the reaction is taken, which is the consistent nodal force:
//!
//! ```text
//! m = moment reaction / length ,   n = force reaction / length       (loads applied at the same node subtracted)
//! ```

use std::collections::BTreeMap;

use nalgebra::Vector3;

use crate::assembly::local_values;
use crate::dofs::KINDS;
use crate::element::Inspect;
use crate::element::shell4::RESULTANTS;
use crate::model::Model;

/// Resultants (order of [`RESULTANTS`]) at the centre of each of `elements`, with its position, under the linear
/// solution `u`. Elements that are not shells are left out.
pub fn centre_resultants(model: &Model, elements: &[usize], u: &[f64]) -> Vec<([f64; 3], [f64; 8])> {
    let mut out = Vec::with_capacity(elements.len());
    for &e in elements {
        if let Some((position, points)) = point_resultants(model, e, u) {
            out.push((position, points[0]));
        }
    }
    out
}

/// Resultants at the nodes of one patch of shells: bilinear from the Gauss points, averaged over the elements of the patch.
/// The caller names elements of one section without a fold between them.
pub fn nodal_resultants(model: &Model, elements: &[usize], u: &[f64]) -> BTreeMap<usize, [f64; 8]> {
    let mut sums: BTreeMap<usize, ([f64; 8], f64)> = BTreeMap::new();
    for &e in elements {
        let Some((_, points)) = point_resultants(model, e, u) else { continue };
        // Corner c lies at √3 times the Gauss point c; N_g there, with Gauss points as nodes.
        let (near, next, far) = (1.0 + 0.5 * 3.0_f64.sqrt(), -0.5, 1.0 - 0.5 * 3.0_f64.sqrt());
        for (c, &node) in model.elements()[e].nodes().iter().enumerate() {
            let (sum, count) = sums.entry(node).or_insert(([0.0; 8], 0.0));
            for k in 0..8 {
                let at = |step: usize| points[1 + (c + step) % 4][k];
                sum[k] += near * at(0) + next * (at(1) + at(3)) + far * at(2);
            }
            *count += 1.0;
        }
    }
    sums.into_iter().map(|(n, (sum, count))| (n, sum.map(|v| v / count))).collect()
}

/// Position of the centre, and the resultants at the centre and the four Gauss points.
fn point_resultants(model: &Model, e: usize, u: &[f64]) -> Option<([f64; 3], [[f64; 8]; 5])> {
    let element = &*model.elements()[e];
    let samples = element.samples();
    if samples.len() != 5 * RESULTANTS.len() || samples[0].name != RESULTANTS[0] {
        return None;
    }
    let local = local_values(model, element, u);
    let mut points = [[0.0; 8]; 5];
    for (k, sample) in samples.iter().enumerate() {
        points[k / 8][k % 8] = sample.row.iter().zip(&local).map(|(c, v)| c * v).sum();
    }
    Some((samples[0].position, points))
}

/// Force [N/m] and moment [N m/m] of an edge: nodal forces of the support divided by the length of the polygon that
/// belongs to the node.
///
/// * `edge`: nodes in order; `closed` if the last is joined to the first
/// * `forces`: forces on each node of the model (global components, as from
///   [`Assembler::nodal_forces`](crate::assembly::Assembler::nodal_forces), loads subtracted)
pub fn edge_values(model: &Model, edge: &[usize], closed: bool, forces: &[[f64; KINDS]]) -> Vec<[f64; 6]> {
    let x: Vec<Vector3<f64>> = edge.iter().map(|&n| Vector3::from(model.nodes()[n])).collect();
    let mut length = vec![0.0; edge.len()];
    let pairs = if closed { edge.len() } else { edge.len().saturating_sub(1) };
    for i in 0..pairs {
        let j = (i + 1) % edge.len();
        let half = 0.5 * (x[j] - x[i]).norm();
        length[i] += half;
        length[j] += half;
    }
    edge.iter().zip(length).map(|(&n, l)| std::array::from_fn(|i| forces[n][i] / l)).collect()
}
