//! Sliding on the foundation: base shear against friction.
//!
//! ```text
//! V_Ed = Q ≤ V_Rd = μ N_Ed       N_Ed = M (g − 0.3 A_v) with E_x + 0.3 E_z,   0.3 Q ≤ μ M (g − A_v) with 0.3 E_x + E_z
//! ```
//!
//! M is the mass of liquid, wall and roof. μ = tan δ/γ_M is given as a design value. The earth pressure in front of the
//! foundation (5.4.1.1, equation 5.2) is left out. So are weight and inertia of bottom plate and foundation, which is on the safe side
//! while the ground acceleration is below μ g. Anchors do not change the check: they tie the tank to a foundation that slides with it.
//!
//! Source: EN 1998-5:2004 5.4.1.1, recalled; combinations of EN 1998-1:2004 4.3.3.5.2.

use super::limit_states::SLIDING;
use super::work::Work;
use crate::roof;
use tank::case::Components;
use tank::quantity::Quantity;
use tank::units::Dimension::*;

/// Clause of the check.
const CLAUSE: &str = "EN 1998-5:2004 5.4.1.1";
/// Path of the friction coefficient.
const FRICTION: &str = "site.ec8.friction";

/// Writes the check, or that the friction is missing. Needs the base shear.
pub(super) fn assess(work: &mut Work) {
    let Some(shear) = work.out.values.get(&Quantity::BaseShear).copied() else { return };
    let Some(friction) = work.demand.site.and_then(|site| site.friction) else {
        work.missing(SLIDING.id, FRICTION);
        return;
    };
    work.sheet.section("Sliding");
    let name = "design friction of the foundation, tan δ/γ_M";
    work.sheet.input("μ", name, friction, Dimensionless, FRICTION);
    work.sheet.given(&[("A_v", work.demand.vertical_ground(), Acceleration)]);
    let roof = roof::holding(&mut work.sheet, &work.case.tank, true);
    // 0.3 E_x + E_z meets 0.3 Q only; divided by 0.3, its weight is compared with the whole of Q.
    let (name, formula) = if work.demand.vertical && work.demand.components == Components::HundredThirty {
        (
            "effective weight: the smaller of 0.3 E_z beside both horizontal components and of E_z beside c_v of them, divided by c_v",
            format!("(m + m_w + {roof})·min(g - 0.3·A_v, (g - A_v)/c_v)"),
        )
    } else if work.demand.vertical {
        (
            "effective weight: the smaller of E_x + 0.3 E_z and of 0.3 E_x + E_z divided by 0.3",
            format!("(m + m_w + {roof})·min(g - 0.3·A_v, (g - A_v)/0.3)"),
        )
    } else {
        ("weight of liquid, wall and roof", format!("(m + m_w + {roof})·g"))
    };
    work.sheet.calc("N_Ed", name, &formula, Force, CLAUSE);
    let capacity = work.sheet.calc("V_Rd", "sliding resistance", "μ·N_Ed", Force, CLAUSE);
    let note = "without the weight of bottom plate and foundation and without earth pressure";
    work.check(SLIDING, shear, capacity, CLAUSE, note);
}

#[cfg(test)]
mod tests;
