//! Roofs, rings, attachments and pipes.

use super::{Material, SIZE};
use crate::keys::{Length, Limits, Opt, keys};
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

/// A stiffening ring or wind girder around the wall. It stiffens the wall against ovalling: extension of its axis and bending in its
/// plane; its torsion and its bending out of the plane are left out.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Ring {
    /// Height above the tank bottom [m].
    pub height: f64,
    /// Area A of its section [m²].
    pub area: f64,
    /// Second moment I of its section about the vertical axis through its centroid [m⁴].
    pub inertia: f64,
    /// Material.
    pub material: Material,
}

/// A mass that the wall carries at one height, such as a ladder, a platform or a nozzle; it counts as spread around the wall.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Attachment {
    /// Name in the input file.
    pub name: String,
    /// Mass [kg].
    pub mass: f64,
    /// Height of its centre above the tank bottom [m].
    pub height: f64,
}

/// Displacements of pipes.
const DISPLACEMENT: Limits = Limits::from(0.0).to(10.0);

keys! {
    /// Pipes that are connected to the tank; of several the one with the least reserve.
    pub Pipes (Copy, Default) {
        /// Distance from the connection to the first support of the pipe that is fixed to the ground.
        support_distance ("12 m"): Opt<Length> [SIZE] = without("displacements of pipes are not checked, EN 1998-4:2006 4.5.1.3"),
        /// Displacement of the connection against that support that the pipe and its connection can bear without yielding, a
        /// design value.
        allowable_displacement ("60 mm"): Opt<Length> [Limits::from(0.0).to(10.0)]
            = without("displacements of pipes are not checked, EN 1998-4:2006 4.5.2.3"),
        /// Displacement upwards, relative to the foundation, that the pipes allow.
        uplift ("100 mm"): Opt<Length> [DISPLACEMENT] = without("the flexibility of the pipes is not checked, API 650 E.7.3"),
        /// Displacement downwards, relative to the foundation.
        settlement ("25 mm"): Opt<Length> [DISPLACEMENT]
            = without("the flexibility of the pipes is not checked, API 650 E.7.3"),
        /// Displacement horizontally, radial and tangential.
        horizontal ("50 mm"): Opt<Length> [DISPLACEMENT]
            = without("the flexibility of the pipes is not checked, API 650 E.7.3"),
    }
}
