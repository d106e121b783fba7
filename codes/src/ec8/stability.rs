//! Overturning of a box as a rigid body, and the anchors that it needs.
//!
//! ```text
//! M_Ed ≤ M_Rd = W_Ed L       W_Ed = M (g − 0.3 A_v) with E_x + 0.3 E_z,   M (g − A_v)/0.3 for 0.3 E_x + E_z
//! F = (M_Ed − W_Ed L)/(2 L)/(n b/P)       force of an anchor of the wall that lifts
//! ```
//!
//! L is the half length and b the breadth, P the length of all walls, n the number of anchors around them. Where the walls are clamped to
//! a bottom of concrete (`tank.bottom` that is not metal), the liquid holds the tank down and M_Ed is the moment below the bottom;
//! otherwise walls and roof alone resist the moment above it. The weight of the bottom and the anchors of the walls along the shaking
//! are left out, which is safe.
//!
//! Source: equilibrium; EN 1998-4:2006 4.5.1, recalled.

use super::limit_states::{ANCHORS, OVERTURNING};
use super::work::Work;
use crate::base_state::BaseState;
use crate::roof;
use crate::sheet::with_unit;
use tank::Support;
use tank::assessment::CheckStatus;
use tank::quantity::Quantity;
use tank::units::Dimension::*;

/// Writes the check of a box. Needs the resultants.
pub(super) fn assess(work: &mut Work) {
    let tank = &work.case.tank;
    let solid = (tank.bottom.as_ref()).is_some_and(|bottom| !bottom.material.is_metal());
    let monolithic = solid && !tank.is_metal();
    let quantity = if monolithic { Quantity::OverturningMoment } else { Quantity::BaseMoment };
    let Some(moment) = work.out.values.get(&quantity).copied() else { return };
    let clause = work.edition.main("4.5.1.2");
    work.sheet.section("Overturning");
    work.sheet.given(&[
        ("m", if monolithic { work.mass } else { 0.0 }, Mass),
        ("A_v", work.demand.vertical_ground(), Acceleration),
    ]);
    let name = match monolithic {
        true => "effective weight of liquid, walls and roof",
        false => "effective weight of walls and roof (the bottom is not one with the walls)",
    };
    // As in sliding: 0.3 E_x + E_z meets 0.3 of the moment.
    let roof = roof::holding(&mut work.sheet, tank, monolithic);
    let formula = match work.demand.vertical {
        true => format!("(m + m_w + {roof})·min(g - 0.3·A_v, (g - A_v)/0.3)"),
        false => format!("(m + m_w + {roof})·g"),
    };
    work.sheet.calc("W_Ed", name, &formula, Force, &clause);
    let name = "moment about the toe that the weight resists";
    let resisted = work.sheet.calc("M_Rd", name, "W_Ed·L", Moment, &clause);
    match tank.support {
        Support::Unanchored => {
            let note = "rigid body about the toe of the wall, without the weight of the bottom";
            let name = "Overturning of the unanchored tank";
            work.check(OVERTURNING.named(name), moment, resisted, &clause, note);
            if moment > resisted {
                work.base = BaseState::Unknown("the unanchored tank overturns".into());
            } else if !work.case.tank.is_metal() {
                // A slab; the bottom plate of a metal box may lift, which is not implemented.
                work.base = BaseState::Bears;
            }
        }
        Support::Anchored if moment <= resisted => {
            let reason = format!(
                "the tank stands without anchors: {} of {}",
                with_unit(moment, Moment),
                with_unit(resisted, Moment)
            );
            work.without_comparison(ANCHORS.id, CheckStatus::NotApplicable, &reason, None);
        }
        Support::Anchored => {
            anchors(work, moment, resisted);
            work.base = BaseState::on_anchors(&work.out.checks);
        }
    }
}

/// Anchors of a box that would overturn without them.
fn anchors(work: &mut Work, moment: f64, resisted: f64) {
    let clause = work.edition.main("4.5.1.3");
    let given = work.case.tank.anchors;
    let Some((count, capacity)) = given.and_then(|a| a.capacity.map(|capacity| (a.count, capacity))) else {
        let input = match given {
            Some(_) => "tank.anchors.capacity",
            None => "tank.anchors",
        };
        let reason = format!(
            "the tank overturns without anchors, {} of {}; `{input}` is missing",
            with_unit(moment, Moment),
            with_unit(resisted, Moment)
        );
        return work.without_comparison(ANCHORS.id, CheckStatus::NotChecked, &reason, Some(input));
    };
    work.sheet.given(&[("P", work.case.tank.perimeter(), Length), ("n", f64::from(count), Dimensionless)]);
    let name = "tension of an anchor of the wall that lifts";
    let formula = "(M - M_Rd)/(2·L)/(n·b/P)";
    let force = work.sheet.calc("F_a", name, formula, Force, &clause);
    let note = "rigid body; the anchors of the wall across the shaking alone";
    work.check(ANCHORS.named("Tension of an anchor"), force, capacity, &clause, note);
}

#[cfg(test)]
mod tests;
