//! Roofs, rings, attachments, insulation and pipes.

use super::{Course, HEIGHT, Material, SIZE, is_zero};
use crate::keys::{AreaMass, Field, Length, Limits, Mass, Opt, keys};
use crate::words;
use serde::{Deserialize, Serialize};

words! {
    /// Kind of a roof.
    pub RoofKind: Fixed {
        /// A fixed roof of a shape that is not stated, carried by the wall.
        Fixed = "fixed",
        /// A cone, carried by the wall alone or also by columns.
        Cone = "cone",
        /// A dome, carried by the wall.
        Dome = "dome",
        /// An external floating roof, carried by the liquid.
        Floating = "floating",
        /// There is none.
        Open = "open",
    }
}

impl RoofKind {
    /// Whether it is a fixed roof, which stands on the wall.
    pub fn is_fixed(self) -> bool {
        matches!(self, RoofKind::Fixed | RoofKind::Cone | RoofKind::Dome)
    }

    /// Height of the centre of mass above the top of the wall over the rise: a third of a cone's of one thickness, half of a cap's.
    fn centre(self) -> f64 {
        match self {
            RoofKind::Cone => 1.0 / 3.0,
            RoofKind::Dome => 0.5,
            RoofKind::Fixed | RoofKind::Floating | RoofKind::Open => 0.0,
        }
    }
}

/// Mass on top of the wall, and below a fixed roof on the liquid.
#[derive(Clone, Copy, Debug, Default, PartialEq, Serialize, Deserialize)]
pub struct Roof {
    /// Mass m_r that moves with the top of the wall [kg], with its share of the snow; 0 of a floating roof.
    pub mass: f64,
    /// Height of its centre of mass above the tank bottom [m]; follows from the rise, or is the top of the wall, unless given.
    pub height: Option<f64>,
    /// What it is.
    #[serde(default, skip_serializing_if = "is_unspecified")]
    pub kind: RoofKind,
    /// Height of the crown of a cone or dome above the top of the wall [m].
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub rise: Option<f64>,
    /// Share of its weight that columns carry to the bottom, 0 to 1. The inertia of the whole roof is with the wall.
    #[serde(default, skip_serializing_if = "is_zero")]
    pub on_columns: f64,
    /// Radius of the outermost ring of columns [m], where the share follows from it.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub columns: Option<f64>,
    /// Snow load, of which `mass` has a share.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub snow: Option<SnowLoad>,
    /// Live load on plan [Pa].
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub live_load: Option<f64>,
    /// Mass that the liquid carries [kg], of a floating roof or of one below a fixed roof: it displaces its own mass of liquid below the
    /// level of the fill height, so the mass of the liquid contains it.
    #[serde(default, skip_serializing_if = "is_zero")]
    pub afloat: f64,
    /// Height of a floating roof's rim and seal above the level of the liquid [m].
    #[serde(default, skip_serializing_if = "is_zero")]
    pub rim: f64,
    /// What it does to the top edge of the wall.
    #[serde(default, skip_serializing_if = "RimSupport::is_free")]
    pub holds: RimSupport,
}

/// Snow on a roof.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub struct SnowLoad {
    /// Load on plan [Pa].
    pub load: f64,
    /// Share ψ_E of it in the seismic mass of EN 1998.
    pub combination: f64,
    /// Mass of the roof without snow [kg].
    pub bare: f64,
    /// Mass of snow that the mass of the roof contains [kg].
    pub mass: f64,
}

/// Whether the kind is left out of a file.
#[allow(clippy::trivially_copy_pass_by_ref, reason = "the signature that serde calls")]
fn is_unspecified(kind: &RoofKind) -> bool {
    *kind == RoofKind::Fixed
}

impl Roof {
    /// Mass whose weight stands on the wall [kg].
    pub fn on_wall(&self) -> f64 {
        (1.0 - self.on_columns) * self.mass
    }

    /// Mass of snow whose weight stands on the wall [kg].
    pub fn snow_on_wall(&self) -> f64 {
        self.snow.map_or(0.0, |snow| (1.0 - self.on_columns) * snow.mass)
    }

    /// The share of the weight that the wall carries of a roof whose outermost columns stand on a circle.
    ///
    /// Rafters span as simple beams from the columns at r_c to the wall at R, under a load that is the same on every part of the plan. A load
    /// at r brings (r − r_c)/(R − r_c) of itself to the wall:
    ///
    /// ```text
    /// 2/R² ∫_{r_c}^{R} r (r − r_c)/(R − r_c) dr = (1 − ρ)(2 + ρ)/3        ρ = r_c/R
    /// ```
    ///
    /// * `ratio`: ρ, 0 for one column in the middle, which leaves 2/3 to the wall
    ///
    /// ```
    /// assert!((tank::Roof::share_of_wall(0.0) - 2.0 / 3.0).abs() < 1e-15);
    /// ```
    pub fn share_of_wall(ratio: f64) -> f64 {
        (1.0 - ratio) * (2.0 + ratio) / 3.0
    }

    /// The roof with this share of the snow in its mass, in place of any other.
    ///
    /// * `area`: plan area [m²]
    #[must_use]
    pub fn with_snow(self, share: f64, area: f64, gravity: f64) -> Roof {
        let Some(snow) = self.snow else { return self };
        let mass = share * snow.load * area / gravity;
        Roof { mass: snow.bare + mass, snow: Some(SnowLoad { mass, ..snow }), ..self }
    }

    /// Height of the centre of mass [m] on a wall of this height [m].
    pub(super) fn centre(&self, wall: f64) -> f64 {
        self.height.unwrap_or_else(|| wall + self.kind.centre() * self.rise.unwrap_or(0.0))
    }
}

words! {
    /// What the roof does to the top edge of the wall.
    pub RimSupport: Free {
        /// It keeps it round, as a cone or dome does.
        Round = "round",
        /// Nothing.
        Free = "free",
    }
}

impl RimSupport {
    /// Whether it does nothing.
    pub fn is_free(&self) -> bool {
        *self == RimSupport::Free
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

keys! {
    /// A mass that the wall carries at one height, such as a ladder, a platform or a nozzle; it counts as spread around the wall.
    pub Attachment {
        /// What it is.
        name ("spiral stairs"): Field<String>,
        /// Its mass.
        mass ("1.2 t"): Field<Mass> [Limits::from(0.0).to(1e8)],
        /// Height of its centre above the tank bottom, within the height of the wall.
        height ("6 m"): Field<Length> [Limits::from(0.0).to(1000.0)],
    }
}

keys! {
    /// Insulation of the wall with its cladding. Its mass counts as that of the courses which it covers; it has no stiffness.
    pub Insulation (Copy) {
        /// Mass per area of wall, cladding included.
        mass ("15 kg/m2"): Field<AreaMass> [Limits::from(0.0).to(1000.0).usual(0.0, 100.0)],
        /// Height up to which it covers the wall, the top of a course.
        @"Option::is_none" height ("8 m"): Opt<Length> [HEIGHT] = without("the whole wall"),
    }
}

impl Insulation {
    /// Raises the density of the courses below its top, of one of layers that of the outermost layer, so that their mass contains its own.
    pub fn cover(self, courses: &mut [Course]) {
        let up_to = self.height.unwrap_or(f64::INFINITY);
        let mut top = 0.0;
        for course in courses {
            top += course.height;
            // Slack for heights that are sums of decimal fractions.
            if top > up_to * (1.0 + 1e-9) {
                return;
            }
            match course.layers.last_mut() {
                Some(outer) => {
                    outer.material.density += self.mass / outer.thickness;
                    *course = Course::layered(course.height, std::mem::take(&mut course.layers));
                }
                None => course.material.density += self.mass / course.thickness,
            }
        }
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
