//! The equivalent membrane stress around the circumference.

use super::mises_squared;
use crate::time_history::field::{Direction, Field, SIDES};

/// The fields of an equivalent stress in a block.
pub(super) struct Membrane {
    pub(super) hoop: Field,
    pub(super) axial: Field,
    pub(super) shear: Option<Vec<f64>>,
    pub(super) transverse_shear: Option<Vec<f64>>,
}

impl Membrane {
    /// The largest σ² of an instant around the circumference, and its cos θ.
    ///
    /// ```text
    /// σ²(c) = σ_θ² + σ_z² − σ_θ σ_z + 3 τ² (1 − c²)        σ_θ, σ_z linear in c = cos θ
    /// ```
    ///
    /// is a parabola in c: the largest value is at a side or at its vertex.
    pub(super) fn largest(&self, k: usize) -> (f64, f64) {
        let [front, back] = SIDES.map(|side| mises_squared(self.hoop.at(k, side), self.axial.at(k, side)));
        let sides = if front >= back { (front, 1.0) } else { (back, -1.0) };
        let Some(shear) = &self.shear else { return sides };
        let across = (0.0, 0.0);
        let middle = mises_squared(self.hoop.at(k, across), self.axial.at(k, across)) + 3.0 * shear[k] * shear[k];
        let (curvature, slope) = (0.5 * (front + back) - middle, 0.5 * (front - back));
        let vertex = -0.5 * slope / curvature;
        if curvature < 0.0 && vertex.abs() < 1.0 { (middle - 0.25 * slope * slope / curvature, vertex) } else { sides }
    }

    /// Amplitudes of the shear along x and y at an instant.
    fn shears(&self, k: usize) -> (f64, f64) {
        let of = |shear: &Option<Vec<f64>>| shear.as_ref().map_or(0.0, |shear| shear[k]);
        (of(&self.shear), of(&self.transverse_shear))
    }

    /// σ² of an instant in a direction.
    pub(super) fn squared(&self, k: usize, direction: Direction) -> f64 {
        let ((c, s), (x, y)) = (direction, self.shears(k));
        // The shear of a motion along y is turned by 90°: sin(θ − 90°) = −cos θ.
        let shear = s * x - c * y;
        mises_squared(self.hoop.at(k, direction), self.axial.at(k, direction)) + 3.0 * shear * shear
    }

    /// What σ² can be at an instant at most.
    pub(super) fn bound(&self, k: usize) -> f64 {
        let (a, b) = (self.hoop.bound(k), self.axial.bound(k));
        let (x, y) = self.shears(k);
        let shear = x.hypot(y);
        a * a + b * b + a * b + 3.0 * shear * shear
    }
}
