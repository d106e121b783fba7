//! Bilinear quadrilateral on [−1, 1]².
//!
//! ```text
//!   4 ─────── 3      s
//!   │         │      ▲
//!   │         │      └─► r
//!   1 ─────── 2
//! ```

/// Natural coordinates of the corners.
pub const CORNERS: [[f64; 2]; 4] = [[-1.0, -1.0], [1.0, -1.0], [1.0, 1.0], [-1.0, 1.0]];

/// Shape functions at (r, s).
pub fn value(r: f64, s: f64) -> [f64; 4] {
    CORNERS.map(|[ra, sa]| 0.25 * (1.0 + ra * r) * (1.0 + sa * s))
}

/// Derivatives [dN/dr, dN/ds] at (r, s).
pub fn slope(r: f64, s: f64) -> [[f64; 2]; 4] {
    CORNERS.map(|[ra, sa]| [0.25 * ra * (1.0 + sa * s), 0.25 * sa * (1.0 + ra * r)])
}
