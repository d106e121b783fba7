//! Overturning of an unanchored tank whose bottom is a slab: a rigid body about the edge of its base.
//!
//! ```text
//! M′ ≤ N_Ed L        N_Ed = M (g − 0.3 A_v) with E_x + 0.3 E_z,   0.3 M′ ≤ M (g − A_v) L with 0.3 E_x + E_z
//! ```
//!
//! M is the mass of liquid, wall and roof, M′ the moment below the base plate. The slab and its foundation are left out, which is on the
//! safe side while their inertia is small beside their weight. How the ground carries the edge is the check of its bearing.
//!
//! Source: statics; EN 1998-4:2006 4.5.1.2, recalled.

use super::limit_states::OVERTURNING;
use super::work::Work;
use tank::quantity::Quantity;
use tank::units::Dimension::*;

/// Writes the check of a box. Needs the moment below the base plate.
///
/// * `half`: half length L in the direction of shaking [m]
pub(super) fn assess(work: &mut Work, half: f64) {
    let Some(moment) = work.out.values.get(&Quantity::OverturningMoment).copied() else {
        return;
    };
    let case = work.case;
    let clause = work.edition.main("4.5.1.2");
    work.sheet.section("Overturning about the edge of the base");
    let terms = [
        ("m", work.mass, Mass),
        ("m_w", case.tank.wall_mass(), Mass),
        ("m_r", case.tank.roof.mass, Mass),
        ("g", case.gravity, Acceleration),
        ("A_v", work.demand.vertical_ground(), Acceleration),
        ("L", half, Length),
    ];
    let (name, formula) = if work.demand.vertical {
        (
            "stabilising moment: the smaller of E_x + 0.3 E_z and of 0.3 E_x + E_z divided by 0.3",
            "(m + m_w + m_r)·min(g - 0.3·A_v, (g - A_v)/0.3)·L",
        )
    } else {
        ("stabilising moment", "(m + m_w + m_r)·g·L")
    };
    let limit = work.sheet.calc("M_stb", name, formula, &terms, Moment, &clause);
    let name = "Overturning of the unanchored tank";
    let note = "rigid body, without base slab and foundation";
    work.check(OVERTURNING, name, moment, limit, Moment, &clause, note);
    if !case.tank.is_metal() {
        // A slab; the bottom plate of a steel box may lift, which is not implemented.
        work.uplift = Some(0.0);
    }
}

#[cfg(test)]
mod tests;
