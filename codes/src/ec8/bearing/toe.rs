//! Bearing of the ground under the toe of a wall: of one that lifts, and of any on a ring wall.
//!
//! The whole weight of the wall, the moment and the pull of the lifted bottom plate press at the toe with n_t a length ([`crate::base_state`]); where
//! nothing lifts, n_t = w_t + n_z. A ring wall spreads the toe over its width alone, also under a wall that is held down.
//!
//! ```text
//! ring wall, b wide and h high        σ_t = n_t/b + p + ρ_c g h ≤ R_d                      the wall in its middle, ρ_c = 2500 kg/m³
//! bottom plate on soil                n_t ≤ n_Rd = (R_d − p) c_i + R_d (s + c_o)
//!                                     c_i = s_b √(f_y/(3 (R_d − p)))      c_o = min(projection, s_b √(f_y/(3 R_d)))
//! slab                                spreads the toe: the rigid base decides
//! ```
//!
//! p is the pressure of the liquid at the toe, p_0 + p_h with the vertical motion, also on the half of a ring wall that lies outside. The
//! plate spreads the toe as far as its ends, cantilevers under R_d less the liquid on them, do not yield: m = (R_d − p) c²/2 = f_y s_b²/6, as
//! a base plate by EN 1993-1-8 6.2.5(4).
//!
//! Source: EN 1998-5:2004 5.4.1.1 with equilibrium, derived here; EN 1993-1-8:2005 6.2.5(4), recalled.

use super::super::limit_states::{BEARING, BEARING_RING, BEARING_TOE};
use super::super::work::Work;
use super::CLAUSE;
use tank::FoundationKind;
use tank::assessment::CheckStatus;
use tank::case::Case;
use tank::units::Dimension::*;

/// Density of the concrete of a ring wall [kg/m³].
const CONCRETE: f64 = 2500.0;
/// Why the ring wall under a box or under a wall of concrete is open.
const NO_RIM: &str = "the wall presses on a narrow ring; its compression at the toe is known for metal cylinders alone";
/// Clause of the spread of the plate.
const PLATE: &str = "EN 1993-1-8:2005 6.2.5(4)";

/// The toe of a wall.
#[derive(Clone, Copy, Debug)]
pub(super) struct Toe {
    /// Its compression [N/m].
    pub force: f64,
    /// Largest pressure of the liquid there [Pa].
    pub pressure: f64,
    /// Whether the wall lifts.
    pub lifts: bool,
}

/// Whether the wall stands on a ring.
pub(super) fn on_a_ring(case: &Case) -> bool {
    let foundation = case.tank.foundation;
    foundation.is_some_and(|f| f.kind == FoundationKind::RingWall)
}

/// Adds the check of a ring wall under a wall that does not lift; returns false where it is open.
pub(super) fn of_a_rim(work: &mut Work, pressure: f64, resistance: f64) -> bool {
    let Some(force) = work.rim else {
        work.without_comparison(BEARING.id, CheckStatus::NotChecked, NO_RIM, None);
        return false;
    };
    let toe = Toe { force, pressure, lifts: false };
    assess(work, toe, resistance)
}

/// Adds the check; returns false where it is open.
///
/// * `resistance`: R_d [Pa]
pub(super) fn assess(work: &mut Work, toe: Toe, resistance: f64) -> bool {
    let missing = |work: &mut Work, input: &str| {
        let what = match toe.lifts {
            true => "the wall lifts and its toe presses on a narrow ring",
            false => "the wall presses on a narrow ring",
        };
        let reason = format!("{what}: `{input}` is missing");
        work.without_comparison(BEARING.id, CheckStatus::NotChecked, &reason, Some(input));
        false
    };
    // Without a foundation the plate lies on the ground.
    let foundation = work.case.tank.foundation;
    match foundation.map_or(FoundationKind::Soil, |f| f.kind) {
        FoundationKind::Slab => {}
        FoundationKind::Soil => on_soil(work, toe, resistance),
        FoundationKind::RingWall => match (foundation.and_then(|f| f.width), foundation.and_then(|f| f.thickness)) {
            (Some(width), Some(height)) => on_ring(work, toe, resistance, (width, height)),
            (None, _) => return missing(work, "tank.foundation.width"),
            (_, None) => return missing(work, "tank.foundation.thickness"),
        },
    }
    true
}

/// Lines of the force at the toe and of the pressure of the liquid there.
fn inputs(work: &mut Work, toe: Toe) {
    let sheet = &mut work.sheet;
    let (section, name, source) = match toe.lifts {
        true => (
            "Bearing under the toe of the lifted wall",
            "compression at the toe, the larger of both estimates",
            "uplift",
        ),
        false => ("Bearing of the ring wall", "compression at the toe, weight and moment", "membrane theory"),
    };
    sheet.section(section);
    sheet.input("n_T", name, toe.force, LineForce, source);
    sheet.input("p_T", "largest pressure of the liquid at the toe", toe.pressure, Stress, CLAUSE);
}

fn on_ring(work: &mut Work, toe: Toe, resistance: f64, (width, height): (f64, f64)) {
    inputs(work, toe);
    let sheet = &mut work.sheet;
    sheet.input("b_R", "width of the ring wall", width, Length, "tank.foundation.width");
    sheet.input("h_R", "height of the ring wall", height, Length, "tank.foundation.thickness");
    sheet.input("ρ_c", "density of concrete", CONCRETE, Density, "assumption");
    let name = "pressure under the ring wall at the toe";
    let formula = "n_T/b_R + p_T + ρ_c·g·h_R";
    let demand = sheet.calc("σ_T", name, formula, Stress, CLAUSE);
    let note = match toe.lifts {
        true => "the wall lifts; the wall in the middle of the ring, the liquid on its whole width",
        false => "the wall in the middle of the ring, the liquid on its whole width",
    };
    work.part((BEARING, BEARING_RING), demand, resistance, note);
}

fn on_soil(work: &mut Work, toe: Toe, resistance: f64) {
    let plate = work.case.tank.bottom.as_ref();
    let plate = plate.and_then(|plate| Some((plate.net_thickness(), plate.material.yield_strength?, plate.projection)));
    // A wall that lifts has a plate of known strength.
    let (Some((thickness, f_y, projection)), Some(course)) = (plate, work.case.tank.courses.first()) else { return };
    inputs(work, toe);
    let note = "the wall lifts; the plate spreads its toe as far as it does not yield";
    if toe.pressure >= resistance {
        return work.part((BEARING, BEARING_TOE), toe.force, 0.0, note);
    }
    let sheet = &mut work.sheet;
    sheet.given(&[
        ("s_b", thickness, Length),
        ("f_y", f_y, Stress),
        ("c_P", projection, Length),
        ("s", course.net_thickness(), Length),
    ]);
    for (symbol, title, formula) in [
        ("c_i", "spread inside the wall", "s_b·√(f_y/(3·(R_d - p_T)))"),
        ("c_o", "spread outside the wall", "min(c_P, s_b·√(f_y/(3·R_d)))"),
    ] {
        sheet.calc(symbol, title, formula, Length, PLATE);
    }
    let title = "force of the toe that the ground bears";
    let formula = "(R_d - p_T)·c_i + R_d·(s + c_o)";
    let capacity = sheet.calc("n_Rd", title, formula, LineForce, CLAUSE);
    work.part((BEARING, BEARING_TOE), toe.force, capacity, note);
}

#[cfg(test)]
mod tests;
