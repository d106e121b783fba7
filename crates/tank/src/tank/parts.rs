//! Roofs and pipes.

use crate::words;
use serde::{Deserialize, Serialize};

words! {
    /// How a roof is carried.
    pub RoofKind: Fixed {
        /// By the wall.
        Fixed = "fixed",
        /// By the liquid.
        Floating = "floating",
        /// There is none.
        Open = "open",
    }
}

impl RoofKind {
    /// Whether the wall carries it.
    pub fn is_fixed(&self) -> bool {
        *self == RoofKind::Fixed
    }
}

/// Displacements that the pipes and their connections to the tank allow.
#[derive(Clone, Copy, Debug, Default, PartialEq, Serialize, Deserialize)]
pub struct Pipes {
    /// Distance from the connection to the first support of the pipe that is fixed to the ground [m].
    pub support_distance: Option<f64>,
    /// Displacement of the connection against that support that the pipe can bear [m].
    pub allowable_displacement: Option<f64>,
    /// Upwards [m].
    pub uplift: Option<f64>,
    /// Downwards [m].
    pub settlement: Option<f64>,
    /// Horizontally, radial and tangential [m].
    pub horizontal: Option<f64>,
}
