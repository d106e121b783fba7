//! The joint between the wall of a cylinder and its base.

use serde::{Deserialize, Serialize};

/// What the base does to the foot of a wall that is not a metal shell.
#[derive(Clone, Copy, Debug, Default, PartialEq, Serialize, Deserialize)]
#[serde(tag = "kind", rename_all = "snake_case")]
pub enum WallBase {
    /// Monolithic: the foot neither moves nor turns.
    #[default]
    Fixed,
    /// The foot turns freely and does not move.
    Hinged,
    /// The foot turns freely and moves outwards and inwards; along the circumference it is held.
    Sliding {
        /// Radial stiffness of the bearing, force per length of the circumference and displacement [Pa]; none resists by friction alone.
        #[serde(default, skip_serializing_if = "Option::is_none")]
        stiffness: Option<f64>,
        /// Coefficient of friction of the joint.
        #[serde(default, skip_serializing_if = "Option::is_none")]
        friction: Option<f64>,
    },
}

impl WallBase {
    /// Whether the foot neither moves nor turns.
    #[allow(clippy::trivially_copy_pass_by_ref, reason = "the signature that serde calls")]
    pub fn is_fixed(&self) -> bool {
        *self == WallBase::Fixed
    }

    /// Whether the foot cannot move along the radius, and whether it cannot turn.
    pub fn holds(self) -> (bool, bool) {
        match self {
            WallBase::Fixed => (true, true),
            WallBase::Hinged => (true, false),
            WallBase::Sliding { .. } => (false, false),
        }
    }

    /// Radial stiffness of a foot that can move [Pa].
    pub fn stiffness(self) -> f64 {
        match self {
            WallBase::Sliding { stiffness, .. } => stiffness.unwrap_or(0.0),
            _ => 0.0,
        }
    }
}
