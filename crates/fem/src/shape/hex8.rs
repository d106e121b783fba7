//! Trilinear hexahedron on [−1, 1]³.
//!
//! ```text
//!        8 ─────── 7
//!       /│        /│      t  s
//!      5 ─────── 6 │      │ /
//!      │ 4 ──────│ 3      └─► r
//!      │/        │/
//!      1 ─────── 2
//! ```

/// Natural coordinates of the corners.
pub const CORNERS: [[f64; 3]; 8] = [
    [-1.0, -1.0, -1.0],
    [1.0, -1.0, -1.0],
    [1.0, 1.0, -1.0],
    [-1.0, 1.0, -1.0],
    [-1.0, -1.0, 1.0],
    [1.0, -1.0, 1.0],
    [1.0, 1.0, 1.0],
    [-1.0, 1.0, 1.0],
];

/// Shape functions at (r, s, t).
pub fn value(r: f64, s: f64, t: f64) -> [f64; 8] {
    CORNERS.map(|[ra, sa, ta]| 0.125 * (1.0 + ra * r) * (1.0 + sa * s) * (1.0 + ta * t))
}

/// Derivatives [dN/dr, dN/ds, dN/dt] at (r, s, t).
pub fn slope(r: f64, s: f64, t: f64) -> [[f64; 3]; 8] {
    CORNERS.map(|[ra, sa, ta]| {
        let (fr, fs, ft) = (1.0 + ra * r, 1.0 + sa * s, 1.0 + ta * t);
        [0.125 * ra * fs * ft, 0.125 * sa * fr * ft, 0.125 * ta * fr * fs]
    })
}
