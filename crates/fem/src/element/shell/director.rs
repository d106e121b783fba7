//! Vectors that turn with a node: directors, and the tangent vectors of the drilling energy.

use nalgebra::{UnitQuaternion, Vector3};

use crate::element::LocalMatrix;

/// (R − 1) v, accurate for small rotations: 2 w (q × v) + 2 q × (q × v) with the quaternion (w, q).
pub(in crate::element) fn turned(rotation: &UnitQuaternion<f64>, v: &Vector3<f64>) -> Vector3<f64> {
    let q = rotation.imag();
    let cross = q.cross(v) * 2.0;
    cross * rotation.scalar() + q.cross(&cross)
}

/// Adds ½ (f dᵀ + d fᵀ) − (f · d) 1 to the rotational block of a node.
pub(in crate::element) fn add_turn_block(out: &mut LocalMatrix, node: usize, f: &Vector3<f64>, d: &Vector3<f64>) {
    let product = f.dot(d);
    for i in 0..3 {
        for j in 0..3 {
            let unit = if i == j { product } else { 0.0 };
            out.add(6 * node + 3 + i, 6 * node + 3 + j, 0.5 * (f[i] * d[j] + d[i] * f[j]) - unit);
        }
    }
}
