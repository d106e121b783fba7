//! Strains, stresses and stiffness of one integration point.

use nalgebra::{Matrix3, Vector3};

use super::Point;
use crate::element::LocalMatrix;
use crate::element::solid8_law::Moduli;

/// Adds ∫ B_aᵀ D B_b + (g_a · S g_b) 1 of one point.
pub(super) fn add_stiffness(
    point: &Point,
    f: &Matrix3<f64>,
    moduli: &Moduli,
    stress: &[f64; 6],
    out: &mut LocalMatrix,
) {
    let b = point.gradients.map(|g| strain_rows(f, &g));
    let s = tensor(stress);
    for (node, rows) in b.iter().enumerate() {
        // D B_b, one column a component of the displacement.
        let db = rows.map(|column| moduli.map(|d| d.iter().zip(&column).map(|(x, y)| x * y).sum::<f64>()));
        let gb = Vector3::from(point.gradients[node]);
        let sg = s * gb;
        for a in node..8 {
            let geometric = Vector3::from(point.gradients[a]).dot(&sg);
            for j in 0..3 {
                for i in 0..3 {
                    let material: f64 = b[a][i].iter().zip(&db[j]).map(|(x, y)| x * y).sum();
                    let value = point.volume * (material + if i == j { geometric } else { 0.0 });
                    out.add(3 * a + i, 3 * node + j, value);
                    if a != node {
                        out.add(3 * node + j, 3 * a + i, value);
                    }
                }
            }
        }
    }
}

/// Adds the same for the isotropic law: λ h_a h_bᵀ + μ h_b h_aᵀ + μ (g_a · g_b) F Fᵀ + (g_a · S g_b) 1, h_a = F g_a.
pub(super) fn add_isotropic_stiffness(
    point: &Point,
    f: &Matrix3<f64>,
    (lambda, mu): (f64, f64),
    stress: &[f64; 6],
    out: &mut LocalMatrix,
) {
    let (s, left) = (tensor(stress), f * f.transpose());
    let g = point.gradients.map(Vector3::from);
    let h = g.map(|g| f * g);
    for b in 0..8 {
        let sg = s * g[b];
        for a in b..8 {
            let (metric, geometric) = (mu * g[a].dot(&g[b]), g[a].dot(&sg));
            for j in 0..3 {
                for i in 0..3 {
                    let mut value = lambda * h[a][i] * h[b][j] + mu * h[b][i] * h[a][j] + metric * left[(i, j)];
                    if i == j {
                        value += geometric;
                    }
                    value *= point.volume;
                    out.add(3 * a + i, 3 * b + j, value);
                    if a != b {
                        out.add(3 * b + j, 3 * a + i, value);
                    }
                }
            }
        }
    }
}

/// Columns of B_a: the Voigt strain of a unit displacement of the node along x, y, z.
pub(super) fn strain_rows(f: &Matrix3<f64>, g: &[f64; 3]) -> [[f64; 6]; 3] {
    std::array::from_fn(|i| {
        let (f1, f2, f3) = (f[(i, 0)], f[(i, 1)], f[(i, 2)]);
        [f1 * g[0], f2 * g[1], f3 * g[2], f1 * g[1] + f2 * g[0], f2 * g[2] + f3 * g[1], f1 * g[2] + f3 * g[0]]
    })
}

/// Symmetric tensor of a Voigt stress.
pub(super) fn tensor(s: &[f64; 6]) -> Matrix3<f64> {
    Matrix3::new(s[0], s[3], s[5], s[3], s[1], s[4], s[5], s[4], s[2])
}

/// Voigt vector, with engineering shears, of a symmetric strain tensor.
pub(super) fn voigt(e: &Matrix3<f64>) -> [f64; 6] {
    [e[(0, 0)], e[(1, 1)], e[(2, 2)], 2.0 * e[(0, 1)], 2.0 * e[(1, 2)], 2.0 * e[(0, 2)]]
}

/// H = Σ u_a g_aᵀ.
pub(super) fn displacement_gradient(point: &Point, values: &[f64]) -> Matrix3<f64> {
    let mut h = Matrix3::zeros();
    for (g, u) in point.gradients.iter().zip(values.as_chunks::<3>().0) {
        for i in 0..3 {
            for j in 0..3 {
                h[(i, j)] += u[i] * g[j];
            }
        }
    }
    h
}
