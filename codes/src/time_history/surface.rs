//! The surface of the liquid: freeboard, and impact on the roof.

use tank::assessment::{Check, CheckStatus};
use tank::demand::SMALL_WAVE;
use tank::quantity::Quantity;
use tank::units::Dimension::Length;

use super::limit_states::{FREEBOARD, ROOF};
use super::work::Work;
use crate::sheet::with_unit;

/// Why a wave that stays within the freeboard does not show that it holds.
const NOT_SMALL: &str =
    "the wave is higher than 0.2 of the radius or half length: it is not small, and its height indicative only";

/// The largest wave against the freeboard; no small wave holds where it is not small.
pub(super) fn assess(work: &mut Work<'_>) {
    let Some(wave) = work.demands.wave else {
        for id in [FREEBOARD.id, ROOF.id] {
            work.without(id, CheckStatus::NotChecked, "the engine does not give the wave", None);
        }
        return;
    };
    let rise = work.factor * wave.value;
    let freeboard = work.case.freeboard();
    let clause = work.clause(FREEBOARD.id);
    work.sheet.section("Freeboard");
    let name = "largest rise of the surface at the wall";
    work.sheet.input("d", name, rise, Length, "the run of the engine");
    work.sheet.input("h_f", "freeboard", freeboard, Length, "tank.courses, liquid");
    let note = "the wave needs this freeboard if the liquid must neither spill nor strike the roof";
    let check = Check::new(FREEBOARD.id, "Freeboard", rise, freeboard, Length, &clause, note)
        .at(Some(wave.time), None, Some(wave.theta))
        .with_error(work.mesh_error(Quantity::SloshingHeight));
    let indicative = work.demands.small_waves && rise > SMALL_WAVE * work.case.tank.shape.half_length();
    work.checks.push(if check.holds() && indicative { check.left_open(NOT_SMALL.to_owned()) } else { check });
    let roof = work.case.tank.roof.mass > 0.0;
    let (status, reason) = match (rise > freeboard, roof) {
        (false, _) => (CheckStatus::NotApplicable, "the wave does not reach the top of the wall".to_owned()),
        (true, false) => (CheckStatus::NotApplicable, "the tank has no roof".to_owned()),
        (true, true) => {
            let above = with_unit(rise - freeboard, Length);
            let reason = format!("the wave rises {above} above the wall; the impact on the roof is not implemented");
            (CheckStatus::NotChecked, reason)
        }
    };
    work.without(ROOF.id, status, &reason, None);
}
