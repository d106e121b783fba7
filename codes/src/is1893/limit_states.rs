//! Limit states of IS 1893-2:2014.

use crate::ec8::limit_states as ec8;
use crate::limit_state::{ASKED, LimitStateDef, common};
use crate::two_mass::limit_states::{anchored, of_concrete, of_plates, of_shells, on_staging, open, unanchored};
use tank::assessment::LimitState;
use tank::case::Case;
use tank::units::Dimension::Moment;

/// All, in the order of the checks. Resistances are those of IS 3370, IS 456 and IS 803, which are not implemented.
pub(super) const TABLE: &[LimitStateDef] =
    &[FREEBOARD, HOOP, BUCKLING, WALL_BENDING, WALL_SHEAR, CRACKS, ANCHORS, OVERTURNING, STAGING, SLIDING, BEARING];

const FREEBOARD: LimitStateDef = common::FREEBOARD.by("IITK-GSDMA 2007 4.11");
const HOOP: LimitStateDef = ec8::HOOP.by("IS 803").when(of_shells);
const BUCKLING: LimitStateDef = ec8::ELASTIC_BUCKLING.by("IITK-GSDMA 2007 4.13").when(of_shells);
const WALL_BENDING: LimitStateDef = ec8::WALL_BENDING.by("IS 3370, IS 456").when(of_plates);
const WALL_SHEAR: LimitStateDef = ec8::WALL_SHEAR.by("IS 3370, IS 456").when(of_concrete);
const CRACKS: LimitStateDef = ec8::CRACKS.by("IS 3370-2").when(of_concrete);
const ANCHORS: LimitStateDef = common::ANCHORS.by("IITK-GSDMA 2007 4.12").when(anchored);
const OVERTURNING: LimitStateDef = ec8::OVERTURNING.by("IITK-GSDMA 2007 4.12").when(unanchored);
/// Columns, braces and footing of an elevated tank.
const STAGING: LimitStateDef = LimitStateDef {
    id: "staging",
    name: "Members of the staging",
    clause: "IS 456, IS 800; IITK-GSDMA 2007 4.8",
    applies: on_staging,
    demand: "base shear and moment at the top of the footing, full or empty, in the critical direction of each member",
    capacity: "resistance of columns, braces or shaft",
    dimension: Moment,
    page: 355,
    ..ASKED
};
const SLIDING: LimitStateDef = common::SLIDING.by("IITK-GSDMA 2007 4.12").when(open);
const BEARING: LimitStateDef = common::BEARING.by("IITK-GSDMA 2007 4.12").when(open);

/// All limit states of a case.
pub(super) fn all(case: &Case) -> Vec<LimitState> {
    TABLE.iter().map(|state| state.under(state.clause.into(), case)).collect()
}
