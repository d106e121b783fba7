//! The staging of an elevated tank.

use crate::keys::{Field, Length, Limits, LineForce, Mass, Opt, Or, Whole, keys};
use crate::words;

words! {
    /// Kind of staging.
    pub StagingKind in "snake_case" {
        /// Frame of reinforced concrete without ductile detailing.
        RcFrame = "rc_frame",
        /// Frame of reinforced concrete with ductile detailing.
        DuctileRcFrame = "ductile_rc_frame",
        /// Frame of steel.
        SteelFrame = "steel_frame",
        /// Shaft of reinforced concrete.
        RcShaft = "rc_shaft",
    }
}

/// Masses of parts, up to that of the largest water tower.
const MASS: Limits = Limits::from(0.0).to(1e8);
/// Lateral stiffness of stagings.
const STIFFNESS: Limits = Limits::from(1e3).to(1e12).usual(1e6, 1e9);
/// Heights of stagings.
const HEIGHT: Limits = Limits::above(0.0).to(300.0).usual(3.0, 60.0);

keys! {
    /// Staging of an elevated tank: the frame or the shaft between its footing and the container, which is the rest of `tank`.
    pub Staging (Copy) {
        /// Kind of staging.
        kind ("ductile_rc_frame"): Field<StagingKind>,
        /// Lateral stiffness: the horizontal force at the centre of the empty container over its displacement there.
        stiffness ("17 MN/m"): Field<LineForce> [STIFFNESS],
        /// Mass of columns and braces, or of the shaft.
        mass ("110 t"): Field<Mass> [MASS.usual(5e3, 1e7)],
        /// Height of the bottom of the wall above the top of the footing.
        height ("16 m"): Field<Length> [HEIGHT],
        /// Mass of the container besides wall and roof: its floor, dome or cone, ring beams, gallery.
        floor_mass ("60 t"): Field<Mass> [MASS],
        /// Height of the centre of that mass above the bottom of the wall, negative below it.
        floor_centre ("-0.4 m"): Or<Length> [Limits::from(-30.0).to(30.0)] = default(Length(0.0)).because("at the bottom of the wall"),
        /// Number of columns of a frame.
        @"Option::is_none" columns (6): Opt<Whole> [Limits::count(3, 200)] = Absent::Follows("fewer than eight"),
    }
}

impl Staging {
    /// Share of its mass that moves with the container: that of a frame whose displacement is linear over the height.
    pub const SHARE: f64 = 1.0 / 3.0;
}
