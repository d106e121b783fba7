//! Points of a quadrilateral in space with their tangent frames, in the reference state.
//!
//! ```text
//! X = Σ N_a X_a ,  e_3 = X,r × X,s normalised ,  e_1 = the centre's X,r projected on the tangent plane ,  e_2 = e_3 × e_1
//! N_a,i = N_a,α (G^α · e_i)
//! ```
//!
//! All frames follow the centre's first axis, so that components at different points of one element may be exchanged
//! (centre-point membrane shear).

use nalgebra::{Matrix3, Vector3};

use crate::element::ElementError;
use crate::shape::quad4;

/// Reference geometry at one point.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Point {
    /// Natural coordinates.
    pub natural: [f64; 2],
    /// Shape functions.
    pub n: [f64; 4],
    /// Their derivatives along e_1.
    pub d1: [f64; 4],
    /// Their derivatives along e_2.
    pub d2: [f64; 4],
    /// G^α · e_i: row α = r, s; column i.
    pub contravariant: [[f64; 2]; 2],
    /// Rows e_1, e_2, e_3.
    pub frame: Matrix3<f64>,
    /// dA/(dr ds) times the point's weight.
    pub area: f64,
}

/// Sum of scaled corner vectors.
pub fn blend(factors: &[f64; 4], vectors: &[Vector3<f64>; 4]) -> Vector3<f64> {
    vectors[0] * factors[0] + vectors[1] * factors[1] + vectors[2] * factors[2] + vectors[3] * factors[3]
}

/// Base vectors X,r and X,s at (r, s).
pub fn base(x: &[Vector3<f64>; 4], r: f64, s: f64) -> [Vector3<f64>; 2] {
    let slope = quad4::slope(r, s);
    [0, 1].map(|alpha| blend(&slope.map(|d| d[alpha]), x))
}

impl Point {
    /// The point (r, s) of the quadrilateral with corners `x`; `weight` is that of the quadrature.
    ///
    /// Errors: a quadrilateral that is degenerate or folded over there (normal against the centre's).
    pub fn new(x: &[Vector3<f64>; 4], r: f64, s: f64, weight: f64, nodes: &[usize; 4]) -> Result<Point, ElementError> {
        let centre = base(x, 0.0, 0.0);
        let [g_r, g_s] = base(x, r, s);
        let normal = g_r.cross(&g_s);
        let along = normal.dot(&centre[0].cross(&centre[1]).normalize());
        // Relative to the diagonals: a sliver of 1e-9 counts as degenerate.
        let size = (x[2] - x[0]).norm_squared() + (x[3] - x[1]).norm_squared();
        if along <= 1e-9 * size || along.is_nan() {
            return Err(ElementError::Jacobian { kind: "shell4", determinant: along, nodes: nodes.to_vec() });
        }
        let jacobian = normal.norm();
        let e3 = normal / jacobian;
        let e1 = (centre[0] - e3 * e3.dot(&centre[0])).normalize();
        let e2 = e3.cross(&e1);
        let contra = [g_s.cross(&e3) / jacobian, e3.cross(&g_r) / jacobian];
        let contravariant = contra.map(|g| [g.dot(&e1), g.dot(&e2)]);
        let slope = quad4::slope(r, s);
        let along = |i: usize| slope.map(|d| d[0] * contravariant[0][i] + d[1] * contravariant[1][i]);
        Ok(Point {
            natural: [r, s],
            n: quad4::value(r, s),
            d1: along(0),
            d2: along(1),
            contravariant,
            frame: Matrix3::from_rows(&[e1.transpose(), e2.transpose(), e3.transpose()]),
            area: jacobian * weight,
        })
    }

    /// Axis e_i, i = 0, 1, 2.
    pub fn axis(&self, i: usize) -> Vector3<f64> {
        self.frame.row(i).transpose()
    }
}
