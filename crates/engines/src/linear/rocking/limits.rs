//! Limits of validity of a run on a free base.

use results::{BaseSpread, Limit};
use tank::units::Dimension;

use super::search::MOST;
use super::{Free, words};
use crate::linear::limits::UPLIFT;

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
                let rotation = Limit {
                    id: "base_rotation".into(),
                    name: words::TURNS.into(),
                    value: angle,
                    limit: MOST,
                    dimension: Dimension::Angle,
                    holds: false,
                    note: beyond.note.clone(),
                };
                limits.insert(0, rotation);
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
    limits.extend(unbroken(free));
    limits
}

/// Anchors hold the tank in place as long as they do not break.
fn unbroken(free: &Free) -> Option<Limit> {
    let anchors = free.moved()?.result.anchors.as_ref()?;
    let rupture = anchors.rupture_elongation?;
    let holds = anchors.broken == 0;
    Some(Limit {
        id: "anchor_rupture".into(),
        name: words::ANCHOR_RUPTURE.into(),
        value: anchors.largest_elongation,
        limit: rupture,
        dimension: Dimension::Length,
        holds,
        note: if holds { String::new() } else { words::anchors_break(anchors.broken, anchors.count) },
    })
}

/// Strips are welded to a wall that does not yield.
fn elastic_wall(free: &Free) -> Option<Limit> {
    let moved = free.moved().filter(|moved| moved.yields)?;
    let [stress, strength] = moved.wall?;
    let holds = stress <= strength;
    Some(Limit {
        id: "base_wall".into(),
        name: words::WALL.into(),
        value: stress,
        limit: strength,
        dimension: Dimension::Stress,
        holds,
        note: if holds { String::new() } else { words::WALL_YIELDS.into() },
    })
}

pub(super) fn repeats(free: &Free) -> Option<Limit> {
    let spread = free.moved()?.result.spread?;
    Some(Limit {
        id: "base_repeats".into(),
        name: words::SPREAD.into(),
        value: spread.relative(),
        limit: BaseSpread::REPEATS,
        dimension: Dimension::Dimensionless,
        holds: spread.repeats(),
        note: match spread.repeats() {
            true => String::new(),
            false => words::does_not_repeat(&spread),
        },
    })
}
