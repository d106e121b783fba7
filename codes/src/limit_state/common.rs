//! Limit states that several codes ask for: what they compare. Names, clauses and requirements are those of each code.

use tank::check::TankPart;
use tank::units::Dimension::{Dimensionless, Force, Length, Mass, Stress};

use super::{ASKED, LimitStateDef};

pub(crate) const FREEBOARD: LimitStateDef = LimitStateDef {
    id: "freeboard",
    name: "Freeboard",
    demand: "largest rise of the liquid surface at the wall, d_max or δ_s",
    capacity: "height of the wall, or of the roof, above the liquid at rest; API 650 asks for a part of δ_s in some seismic use groups",
    dimension: Length,
    page: 10,
    needs: &[TankPart::Roof],
    ..ASKED
};

pub(crate) const MATERIAL: LimitStateDef = LimitStateDef {
    id: "wall_material",
    name: "Material of the wall",
    demand: "the family of the wall's materials",
    capacity: "not compared: each code is written for some families",
    dimension: Dimensionless,
    page: 160,
    ..ASKED
};

pub(crate) const ANCHOR_COUNT: LimitStateDef = LimitStateDef {
    id: "anchor_count",
    name: "Number of the anchors",
    demand: "least number of anchors, 4, and 6 where the earthquake pulls at them",
    capacity: "number of anchors, given",
    dimension: Dimensionless,
    page: 240,
    ..ASKED
};

pub(crate) const ANCHOR_SPACING: LimitStateDef = LimitStateDef {
    id: "anchor_spacing",
    name: "Spacing of the anchors",
    demand: "distance of the anchors along the shell",
    capacity: "largest spacing of the standard, 10 ft (printed as 3 m (10 ft); the larger counts)",
    dimension: Length,
    page: 260,
    ..ASKED
};

pub(crate) const SLIDING: LimitStateDef = LimitStateDef {
    id: "sliding",
    name: "Sliding on the foundation",
    demand: "horizontal force on the foundation",
    capacity: "friction times the weight with its vertical acceleration",
    dimension: Force,
    page: 360,
    ..ASKED
};

pub(crate) const BEARING: LimitStateDef = LimitStateDef {
    id: "bearing",
    name: "Bearing of the ground",
    demand: "pressure of the foundation on the ground",
    capacity: "bearing resistance of the ground, given; of a wall that lifts also bearing_ring or bearing_toe",
    dimension: Stress,
    page: 380,
    needs: &[TankPart::Foundation],
    ..ASKED
};

pub(crate) const SNOW: LimitStateDef = LimitStateDef {
    id: "snow",
    name: "Snow on the roof",
    demand: "share of the snow in the mass of the roof",
    capacity: "not compared: answered by the tank file",
    dimension: Mass,
    page: 410,
    ..ASKED
};

pub(crate) const ANCHORS: LimitStateDef = LimitStateDef {
    id: "anchorage",
    name: "Tension of the anchors",
    demand: "largest tension of an anchor: pull of the wall times the spacing",
    capacity: "capacity of an anchor, given",
    dimension: Force,
    page: 210,
    needs: &[TankPart::Roof],
    ..ASKED
};
