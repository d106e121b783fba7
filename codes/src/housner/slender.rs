//! Slender tanks, H/a > 1.5: the liquid deeper than 1.5 a below the surface moves with the tank as a solid.
//!
//! ```text
//! H_b = 1.5 a     m_b = m H_b/H     upper part: the formulas of squat tanks with H → H_b, m → m_b
//! H_r = H − H_b   m_r = m − m_b     P_r = a_B m_r, at H_r/2
//! M   = P_i (H_r + h_i) + P_r H_r/2 + P_k (H_r + h_k)
//! ```
//!
//! Frequency, angle, wave and convective mass no longer depend on H, the moment is a quadratic in H, and the mass that
//! moves with the wall is `m (1 − 0.4357 a/H)`, which is the 0.218 D/H of later codes. The moment with base pressure is
//! an extension: Housner does not define it, the levers of the upper part are used on its own lower boundary.
//!
//! Source: TID-7024 (1963) as used in the dissertation's example 8.3; formulas re-derived.

use super::model::SLENDER_LIMIT;

/// The two parts of the liquid.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Split {
    /// H_b = min(H, 1.5 a) [m].
    pub sloshing_depth: f64,
    /// m_b [kg].
    pub sloshing_mass: f64,
    /// H_r = H − H_b [m].
    pub rigid_depth: f64,
    /// m_r [kg].
    pub rigid_mass: f64,
}

/// Splits the liquid into the part that can slosh and the constrained part below; the latter vanishes for H/a ≤ 1.5.
///
/// * `depth`: H [m]; `half_length`: a [m]; `mass`: m [kg]
pub fn split(depth: f64, half_length: f64, mass: f64) -> Split {
    let sloshing_depth = depth.min(SLENDER_LIMIT * half_length);
    let rigid_depth = depth - sloshing_depth;
    // Both by proportion: a difference of masses could round to a negative one.
    Split {
        sloshing_depth,
        sloshing_mass: mass * sloshing_depth / depth,
        rigid_depth,
        rigid_mass: mass * rigid_depth / depth,
    }
}
