//! Slender tanks, H/a > 1.5: the liquid deeper than 1.5 a below the surface moves with the tank as a solid.
//!
//! ```text
//! H_b = 1.5 a     m_b = m H_b/H     upper part: the formulas of squat tanks with H → H_b, m → m_b
//! H_r = H − H_b   m_r = m H_r/H     P_r = a_B m_r, at H_r/2
//! M   = P_i (H_r + h_i) + P_r H_r/2 + P_k (H_r + h_k)
//! ```
//!
//! Frequency, angle, wave and convective mass no longer depend on H, the moment is a quadratic in H, and the mass that
//! moves with the wall is `m (1 − 0.4357 a/H)`, which is the 0.218 D/H of later codes. The moment with base pressure is
//! an extension: Housner does not define it, the levers of the upper part are used on its own lower boundary.
//!
//! Source: TID-7024 (1963) as used in the dissertation's example 8.3; formulas re-derived.

use super::lines::{Lines, SLENDER};
use super::model::SLENDER_LIMIT;
use tank::units::Dimension::{Length, Mass};

/// The two parts of the liquid.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Split {
    /// H_b = min(H, 1.5 a) [m].
    pub sloshing_depth: f64,
    /// m_b [kg].
    pub sloshing_mass: f64,
    /// H_r = H − H_b [m].
    pub rigid_depth: f64,
    /// m_r [kg].
    pub rigid_mass: f64,
}

impl Lines<'_> {
    /// Splits the liquid into the part that can slosh and the constrained part below, with its lines; the latter vanishes
    /// for H/a ≤ 1.5.
    pub(super) fn split(&mut self) -> Split {
        if !self.slender() {
            return Split {
                sloshing_depth: self.input.depth,
                sloshing_mass: self.input.mass,
                rigid_depth: 0.0,
                rigid_mass: 0.0,
            };
        }
        let depth = format!("{SLENDER_LIMIT}·{}", self.length());
        Split {
            sloshing_depth: self.sheet.calc("H_b", "depth that can slosh", &depth, Length, SLENDER),
            sloshing_mass: self.sheet.calc("m_b", "its mass", "m·H_b/H", Mass, SLENDER),
            rigid_depth: self.sheet.calc("H_r", "constrained depth below", "H − H_b", Length, SLENDER),
            // By proportion: the difference m − m_b could round to a negative mass.
            rigid_mass: self.sheet.calc("m_r", "its mass, moves as a solid", "m·H_r/H", Mass, SLENDER),
        }
    }
}
