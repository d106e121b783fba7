//! Geometric stiffness from extrapolated stresses.
//!
//! ```text
//! S* = S_k + C_k B_k δq            δq = (δu, θ) from the iterate before, q_k, to the present one
//! ```
//!
//! The geometric part of the tangent takes S* instead of S; the forces take S. A bending increment δq that stretches the
//! reference surface in second order only (½ C δqᵀ ∂²ε δq, large in a thin shell) then does not stiffen the next
//! iteration; at equilibrium both are the same. It is the iteration of a mixed formulation whose stresses are unknowns of
//! their own, condensed at the integration points.
//!
//! Source: Magisano, Leonetti & Garcea 2017 (mixed integration points), for elastic laws; path-dependent ones take
//! the algorithmic tangent C_k.

use nalgebra::{Quaternion, UnitQuaternion, Vector3};

use super::Shell4;
use super::rows::SIZE;
use crate::element::Motion;
use crate::element::shell::section::SectionResponse;

/// 1 once there is an iterate before.
const FILLED: usize = 0;
/// Displacements of the iterate before.
const U: usize = 1;
/// Its rotations: w, x, y, z of each node.
const ROTATION: usize = U + 12;
/// Its resultants and tangents, point by point.
const POINT: usize = ROTATION + 16;
const POINT_LEN: usize = 8 + 64;

/// Number of variables kept.
pub(super) const LEN: usize = POINT + 4 * POINT_LEN;

/// Keeps resultants and tangent of point `g`.
pub(super) fn keep_point(kept: &mut [f64], g: usize, section: &SectionResponse) {
    let own = &mut kept[POINT + g * POINT_LEN..][..POINT_LEN];
    own[..8].copy_from_slice(&section.resultants);
    for (row, from) in own[8..].chunks_exact_mut(8).zip(&section.tangent) {
        row.copy_from_slice(from);
    }
}

/// Keeps the motion.
pub(super) fn keep_motion(kept: &mut [f64], motion: &Motion<'_>) {
    kept[FILLED] = 1.0;
    for a in 0..4 {
        kept[U + 3 * a..][..3].copy_from_slice(&motion.values[6 * a..6 * a + 3]);
        let q = motion.rotations[a].quaternion();
        kept[ROTATION + 4 * a..][..4].copy_from_slice(&[q.w, q.i, q.j, q.k]);
    }
}

impl Shell4 {
    /// S* at the four points, if there was an iterate before.
    pub(super) fn extrapolate(&self, kept: &[f64], motion: &Motion<'_>) -> Option<[[f64; 8]; 4]> {
        if kept[FILLED] == 0.0 {
            return None;
        }
        let mut values = [0.0; SIZE];
        let mut step = [0.0; SIZE];
        let rotations: [UnitQuaternion<f64>; 4] = std::array::from_fn(|a| {
            let q = &kept[ROTATION + 4 * a..][..4];
            UnitQuaternion::new_unchecked(Quaternion::new(q[0], q[1], q[2], q[3]))
        });
        for a in 0..4 {
            let turn: Vector3<f64> = (motion.rotations[a] * rotations[a].inverse()).scaled_axis();
            for i in 0..3 {
                values[6 * a + i] = kept[U + 3 * a + i];
                step[6 * a + i] = motion.values[6 * a + i] - values[6 * a + i];
                step[6 * a + 3 + i] = turn[i];
            }
        }
        let before = self.configuration(&Motion { values: &values, rotations: &rotations });
        let common = self.common(&before);
        Some(std::array::from_fn(|g| {
            let rows = Self::rows(&self.points[g], &before, &common);
            let strain = rows.map(|row| row.iter().zip(&step).map(|(b, v)| b * v).sum::<f64>());
            let own = &kept[POINT + g * POINT_LEN..][..POINT_LEN];
            std::array::from_fn(|i| {
                let tangent = &own[8 + 8 * i..][..8];
                own[i] + tangent.iter().zip(&strain).map(|(c, e)| c * e).sum::<f64>()
            })
        }))
    }
}
