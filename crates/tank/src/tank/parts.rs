//! Roofs and pipes.

use super::SIZE;
use crate::keys::{Length, Limits, Opt, keys};
use crate::words;

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
