//! Limits of validity of a run on a free base.

use results::{BaseSpread, Limit};
use tank::units::Dimension;

use super::search::MOST;
use super::{Free, words};
use crate::linear::limits::{UPLIFT, limit_of};

/// The limits of validity of a run, those of its base among them: in place of the tension of a wall held down, where the base was free.
pub(crate) fn limits(free: &Free, others: Vec<Limit>) -> Vec<Limit> {
    let mut limits = others;
    if free.is_modelled() {
        limits.retain(|limit| limit.id != UPLIFT);
    }
    if let Free::Beyond(beyond) = free {
        match beyond.turns {
            Some([angle, _]) => {
                limits.retain(|limit| limit.id != UPLIFT);
                // It concerns all of wall and base: before the others.
                let note = || beyond.note.clone();
                limits.insert(0, limit_of("base_rotation", words::TURNS, [angle, MOST], Dimension::Angle, false, note));
            }
            None => {
                for limit in limits.iter_mut().filter(|limit| limit.id == UPLIFT) {
                    limit.holds = false;
                    limit.note.clone_from(&beyond.note);
                }
            }
        }
    }
    limits.extend(repeats(free));
    limits.extend(elastic_wall(free));
    limits.extend(hoop_force(free));
    limits.extend(curves(free));
    limits.extend(unbroken(free));
    limits
}

/// Anchors hold the tank in place as long as they do not break.
fn unbroken(free: &Free) -> Option<Limit> {
    let anchors = free.moved()?.result.anchors.as_ref()?;
    let values = [anchors.largest_elongation, anchors.rupture_elongation?];
    Some(limit_of("anchor_rupture", words::ANCHOR_RUPTURE, values, Dimension::Length, anchors.broken == 0, || {
        words::anchors_break(anchors.broken, anchors.count)
    }))
}

/// Strips are welded to a wall that does not yield.
fn elastic_wall(free: &Free) -> Option<Limit> {
    let moved = free.moved().filter(|moved| moved.yields)?;
    let values = moved.wall?;
    let holds = values[0] <= values[1];
    Some(limit_of("base_wall", words::WALL, values, Dimension::Stress, holds, || words::WALL_YIELDS.into()))
}

/// The curves of the strips end at a bottom pressure; a limit only of a run that exceeds it.
fn curves(free: &Free) -> Option<Limit> {
    let swing = free.moved()?.swing.filter(|swing| *swing > ::base::FOLLOWED)?;
    let values = [swing, ::base::FOLLOWED];
    Some(limit_of("base_curves", words::CURVES, values, Dimension::Dimensionless, false, || words::CURVES_END.into()))
}

/// The lifted side of a wall whose rim is not round needs hoop force.
fn hoop_force(free: &Free) -> Option<Limit> {
    let suction = free.moved()?.suction?;
    let values = [suction.share, suction.limit];
    Some(limit_of("base_suction", words::SUCTION, values, Dimension::Dimensionless, suction.holds(), || {
        words::softened(&suction)
    }))
}

pub(super) fn repeats(free: &Free) -> Option<Limit> {
    let spread = free.moved()?.result.spread?;
    let values = [spread.relative(), BaseSpread::REPEATS];
    Some(limit_of("base_repeats", words::SPREAD, values, Dimension::Dimensionless, spread.repeats(), || {
        words::does_not_repeat(&spread)
    }))
}
