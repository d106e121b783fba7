//! The generalised minimal-residual method with a preconditioner on the right that may be indefinite.
//!
//! ```text
//! A x = b ,  x = Z y        Z: P⁻¹ v of the orthonormal vectors v, kept
//! A Z = V H                 H: upper Hessenberg, made triangular by plane rotations
//! ```
//!
//! minimises ‖b − A x‖ over the Krylov space of A P⁻¹ without a restart: for few steps. [`minres`](super::minres) needs a P that is positive
//! definite.
//!
//! Source: Saad & Schultz 1986; Saad 1993 (Z is kept).

use super::{Iterations, LinalgError, Precondition, dot};

/// Solves A x = b from x = 0 until ‖b − A x‖ has fallen to `tolerance` of ‖b‖, or with `limit` products.
///
/// * `product(x, y)`: y = A x
/// * `precondition(r, z)`: z = P⁻¹ r
///
/// Errors: those of `precondition`, numbers that are not finite.
pub fn gmres(
    product: &mut dyn FnMut(&[f64], &mut [f64]),
    precondition: &mut Precondition<'_>,
    b: &[f64],
    x: &mut [f64],
    tolerance: f64,
    limit: usize,
) -> Result<Iterations, LinalgError> {
    let n = b.len();
    x.fill(0.0);
    let first = dot(b, b).sqrt();
    if first == 0.0 {
        return Ok(Iterations { count: 0, residual: 0.0 });
    }
    let mut basis: Vec<Vec<f64>> = vec![b.iter().map(|v| v / first).collect()];
    let (mut directions, mut columns) = (Vec::new(), Vec::<Vec<f64>>::new());
    let mut turns: Vec<[f64; 2]> = Vec::new();
    let mut right = vec![first];
    while columns.len() < limit {
        let j = columns.len();
        let mut z = vec![0.0; n];
        precondition(&basis[j], &mut z)?;
        let mut w = vec![0.0; n];
        product(&z, &mut w);
        directions.push(z);
        let mut h = Vec::with_capacity(j + 1);
        for v in &basis {
            let along = dot(v, &w);
            w.iter_mut().zip(v).for_each(|(w, v)| *w -= along * v);
            h.push(along);
        }
        let rest = dot(&w, &w).sqrt();
        for (k, [c, s]) in turns.iter().enumerate() {
            (h[k], h[k + 1]) = (c * h[k] + s * h[k + 1], c * h[k + 1] - s * h[k]);
        }
        let length = h[j].hypot(rest);
        if !(length > 0.0 && length.is_finite()) {
            return Err(LinalgError::Singular { size: n });
        }
        let [c, s] = [h[j] / length, rest / length];
        h[j] = length;
        turns.push([c, s]);
        columns.push(h);
        right.push(-s * right[j]);
        right[j] *= c;
        if right[j + 1].abs() <= tolerance * first {
            break;
        }
        w.iter_mut().for_each(|w| *w /= rest);
        basis.push(w);
    }
    let count = columns.len();
    for j in (0..count).rev() {
        let known: f64 = (j + 1..count).map(|k| columns[k][j] * right[k]).sum();
        right[j] = (right[j] - known) / columns[j][j];
        x.iter_mut().zip(&directions[j]).for_each(|(x, z)| *x += right[j] * z);
    }
    Ok(Iterations { count, residual: right[count].abs() / first })
}
