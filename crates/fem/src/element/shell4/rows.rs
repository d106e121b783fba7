//! Rows over the 24 local unknowns, and the material stiffness made of them.

use nalgebra::Vector3;

use crate::element::LocalMatrix;

/// Number of local dofs.
pub const SIZE: usize = 24;

/// Row over the local dofs.
pub type Row = [f64; SIZE];

/// Adds a vector to three entries of a row.
pub(super) fn put(row: &mut Row, at: usize, v: Vector3<f64>) {
    row[at] += v.x;
    row[at + 1] += v.y;
    row[at + 2] += v.z;
}

/// out ← out + w Bᵀ C B, lower triangle only.
pub(super) fn add_material(rows: &[Row; 8], tangent: &[[f64; 8]; 8], weight: f64, out: &mut LocalMatrix) {
    let mut product = [[0.0; SIZE]; 8];
    for (to, c) in product.iter_mut().zip(tangent) {
        for (&c, row) in c.iter().zip(rows) {
            if c != 0.0 {
                let c = c * weight;
                for (t, b) in to.iter_mut().zip(row) {
                    *t += c * b;
                }
            }
        }
    }
    for (j, column) in out.data.chunks_exact_mut(SIZE).enumerate() {
        // Whole quarters of a column, so that the inner loop stays straight.
        let first = j & !3;
        for (row, cb) in rows.iter().zip(&product) {
            let f = cb[j];
            for (k, b) in column[first..].iter_mut().zip(&row[first..]) {
                *k += f * b;
            }
        }
    }
}
