//! Limit states of ACI 350.3-06 for tanks on the ground.

use crate::ec8::limit_states as ec8;
use crate::limit_state::{LimitStateDef, common};
use crate::two_mass::limit_states::{of_concrete, open, unanchored};
use tank::assessment::LimitState;
use tank::case::Case;

/// All, in the order of the checks. Resistances are those of ACI 350-06, which is not implemented.
pub(super) const TABLE: &[LimitStateDef] =
    &[FREEBOARD, WALL_BENDING, WALL_SHEAR, CRACKS, OVERTURNING, SLIDING, BEARING];

const FREEBOARD: LimitStateDef = common::FREEBOARD.by("ACI 350.3-06 7.1");
const WALL_BENDING: LimitStateDef = ec8::WALL_BENDING.by("ACI 350-06 chapters 10, 14").when(of_concrete);
const WALL_SHEAR: LimitStateDef = ec8::WALL_SHEAR.by("ACI 350-06 chapter 11").when(of_concrete);
const CRACKS: LimitStateDef = ec8::CRACKS.by("ACI 350-06 10.6").when(of_concrete);
const OVERTURNING: LimitStateDef = ec8::OVERTURNING.by("ACI 350.3-06 4.1.3").when(unanchored);
const SLIDING: LimitStateDef = common::SLIDING.by("ACI 350.3-06 4.1").when(open);
const BEARING: LimitStateDef = common::BEARING.by("ACI 350.3-06 4.1").when(open);

/// All limit states of a case.
pub(super) fn all(case: &Case) -> Vec<LimitState> {
    TABLE.iter().map(|state| state.under(state.clause.into(), case)).collect()
}
