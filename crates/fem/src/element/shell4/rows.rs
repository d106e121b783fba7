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

/// out ← out + w Bᵀ C B, lower triangle only, in the registers of the processor.
pub(super) fn add_material(rows: &[Row; 8], tangent: &[[f64; 8]; 8], weight: f64, out: &mut LocalMatrix) {
    pulp::Arch::new().dispatch(Material { rows, tangent, weight, out });
}

struct Material<'a> {
    rows: &'a [Row; 8],
    tangent: &'a [[f64; 8]; 8],
    weight: f64,
    out: &'a mut LocalMatrix,
}

impl pulp::WithSimd for Material<'_> {
    type Output = ();

    #[inline(always)]
    fn with_simd<S: pulp::Simd>(self, simd: S) {
        let Material { rows, tangent, weight, out } = self;
        let mut product = [[0.0; SIZE]; 8];
        for (to, c) in product.iter_mut().zip(tangent) {
            let (to, _) = S::as_mut_simd_f64s(to);
            for (&c, row) in c.iter().zip(rows) {
                if c != 0.0 {
                    let c = simd.splat_f64s(c * weight);
                    for (t, b) in to.iter_mut().zip(S::as_simd_f64s(row).0) {
                        *t = simd.add_f64s(*t, simd.mul_f64s(c, *b));
                    }
                }
            }
        }
        for (j, column) in out.data.chunks_exact_mut(SIZE).enumerate() {
            // Whole quarters of a column, so that the inner loop stays straight.
            let first = j & !3;
            let (column, _) = S::as_mut_simd_f64s(&mut column[first..]);
            for (row, cb) in rows.iter().zip(&product) {
                let f = simd.splat_f64s(cb[j]);
                for (k, b) in column.iter_mut().zip(S::as_simd_f64s(&row[first..]).0) {
                    *k = simd.add_f64s(*k, simd.mul_f64s(f, *b));
                }
            }
        }
    }
}
