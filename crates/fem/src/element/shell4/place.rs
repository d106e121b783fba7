//! Where a shell stands, and what its four points have in common.

use nalgebra::Vector3;

use crate::element::shell::geometry::Point;

/// The four edges (from, to) with the strain they sample: along r at s = −1 and 1, along s at r = 1 and −1.
pub(super) const EDGES: [(usize, usize); 4] = [(0, 1), (3, 2), (1, 2), (0, 3)];

/// Positions, directors and their increments.
pub(super) struct Configuration {
    pub(super) x: [Vector3<f64>; 4],
    pub(super) u: [Vector3<f64>; 4],
    pub(super) d: [Vector3<f64>; 4],
    pub(super) w: [Vector3<f64>; 4],
}

/// Membrane shear and edge shears, common to all points.
pub(super) struct Values {
    pub(super) shear: Option<f64>,
    pub(super) edges: [f64; 4],
}

/// Factors of the four edge shears in γ_1 and γ_2 at a point.
pub(super) fn tying(p: &Point) -> [[f64; 4]; 2] {
    let [r, s] = p.natural;
    let weight = [0.5 * (1.0 - s), 0.5 * (1.0 + s), 0.5 * (1.0 + r), 0.5 * (1.0 - r)];
    [0, 1].map(|i| std::array::from_fn(|e| weight[e] * p.contravariant[e / 2][i]))
}
