//! Limit states that the 9th edition alone knows.

use crate::limit_state::{ASKED, LimitStateDef};
use tank::units::Dimension::Dimensionless;

pub(super) const TABLE: &[LimitStateDef] = &[STABILITY];

pub(super) const STABILITY: LimitStateDef = LimitStateDef {
    id: "stability",
    name: "Stability",
    demand: "moment over what weight and bottom plate hold down, M/(D²·(w_t + w_L))",
    capacity: "1.57",
    dimension: Dimensionless,
    page: 320,
    ..ASKED
};
