//! Damage limitation: freeboard and hoop stress under the reduced seismic action ν S_e.
//!
//! ```text
//! ν d_f ≤ freeboard          [p_0 + ν (E_x (q p_i + p_c) + E_z p_v)] R/s ≤ f_y        at the lower edge of each course
//! ```
//!
//! The annex's pressures are linear in the spectrum, so that the action of the damage limitation state is ν times that of the ultimate
//! limit state, with q = 1 for the impulsive part. Freeboard: the liquid does not spill or strike the roof. Hoop: the wall stays elastic
//! and tight. Stability is checked in the ultimate limit state only, whose action is the larger one unless ν q > 1; a note says so then.
//! Crack widths of concrete walls and stresses of boxes are checked in `walls`; the pipes are not covered.
//!
//! Source: EN 1998-4:2006 2.1.3, EN 1998-1:2004 2.2.3(2), recalled.

use super::cylinder_stress::{Factors, State};
use super::limit_states::{DAMAGE, DAMAGE_FREEBOARD, DAMAGE_HOOP};
use super::work::Work;
use crate::sheet::{Sheet, number, with_unit};
use tank::Course;
use tank::case::Combination;
use tank::units::Dimension::*;

/// Path of the reduction factor.
const REDUCTION: &str = "site.ec8.reduction_factor";

/// Lower edge of a course under one combination.
struct Place<'a> {
    course: &'a Course,
    number: usize,
    z: f64,
    factors: Factors,
}

/// Writes the checks, or that the reduction factor is missing. Needs the wave height.
///
/// * `state`: of a cylinder
pub(super) fn assess(work: &mut Work, state: Option<&State>, vertical: bool) {
    let Some(wave) = work.wave else { return };
    let Some(reduction) = work.demand.site.and_then(|site| site.reduction_factor) else {
        return work.missing(DAMAGE.id, REDUCTION);
    };
    let clause = work.edition.main("2.1.3");
    work.sheet.section("Damage limitation");
    let name = "reduction factor of the seismic action";
    work.sheet.input("ν", name, reduction, Dimensionless, REDUCTION);
    work.sheet.given(&[("d_f", wave, Length)]);
    let name = "wave height, damage limitation";
    let height = work.sheet.calc("d_DL", name, "ν·d_f", Length, &clause);
    let freeboard = work.case.freeboard();
    work.part((DAMAGE, DAMAGE_FREEBOARD), height, freeboard, "");
    // The part of other walls is in `walls`.
    if let Some(state) = state.filter(|state| state.tank.is_metal()) {
        hoop(work, state, reduction, vertical);
    }
    let q = work.demand.behaviour_factor;
    if reduction * q > 1.0 {
        work.out.notes.push(format!(
            "{clause}: ν·q = {} exceeds 1; the impulsive action of the damage limitation state is larger than that of the checks of \
             stability, which do not cover it.",
            number(reduction * q)
        ));
    }
}

/// Hoop stress of a metal wall below yield.
fn hoop(work: &mut Work, state: &State, reduction: f64, vertical: bool) {
    let missing = state.tank.courses.iter().find(|c| c.material.yield_strength.is_none());
    if let Some(course) = missing {
        let input = format!("materials.{}.yield_strength", course.material.name);
        return work.missing(DAMAGE.id, &input);
    }
    let q = work.demand.behaviour_factor;
    let mut governing: Option<(f64, Place)> = None;
    let mut z = 0.0;
    for (index, course) in state.tank.courses.iter().enumerate() {
        for factors in state.combinations(vertical) {
            let place = Place { course, number: index + 1, z, factors };
            let mut scratch = Sheet::new();
            let stress = lines(&mut scratch, state, &place, (reduction, q), "");
            let utilisation = stress / course.material.yield_strength.unwrap_or_default();
            if governing.as_ref().is_none_or(|(largest, _)| utilisation > *largest) {
                governing = Some((utilisation, place));
            }
        }
        z += course.height;
    }
    let Some((_, place)) = governing else { return };
    let clause = work.edition.main("2.1.3");
    let stress = lines(&mut work.sheet, state, &place, (reduction, q), &clause);
    let capacity = place.course.material.yield_strength.unwrap_or_default();
    let mut note = format!("course {} at z = {}", place.number, with_unit(place.z, Length));
    if vertical {
        let (x, z) = place.factors;
        note = format!("{note}, {} E_x + {} E_z", number(x), number(z));
    }
    work.part((DAMAGE, DAMAGE_HOOP), stress, capacity, &note);
}

/// Lines of the hoop stress [Pa] at one place.
///
/// * `(reduction, q)`: reduction factor ν, behaviour factor of the impulsive part
fn lines(sheet: &mut Sheet, state: &State, place: &Place, (reduction, q): (f64, f64), clause: &str) -> f64 {
    let z = place.z;
    sheet.given(&[
        ("p_0", state.pressure_hydrostatic(z), Stress),
        ("p_g", state.tank.pressure.internal, Stress),
        ("p_i", state.pressure_impulsive(z), Stress),
        ("p_c", state.pressure_convective(z), Stress),
        ("p_v", state.pressure_vertical(z), Stress),
        ("E_x", place.factors.0, Dimensionless),
        ("E_z", place.factors.1, Dimensionless),
        ("ν", reduction, Dimensionless),
        ("q", q, Dimensionless),
        ("R", state.radius, Length),
        ("s", place.course.net_thickness(), Length),
    ]);
    let formula = match state.combination {
        Combination::Abs => "p_0 + ν·(E_x·(q·p_i + p_c) + E_z·p_v)",
        Combination::Srss => "p_0 + ν·(E_x·√((q·p_i)² + p_c²) + E_z·p_v)",
    };
    let formula = match state.tank.pressure.internal > 0.0 {
        true => formula.replacen("p_0", "p_0 + p_g", 1),
        false => formula.to_string(),
    };
    let name = format!("largest pressure, q = 1, at z = {}", with_unit(z, Length));
    sheet.calc("p_DL", &name, &formula, Stress, clause);
    sheet.calc("σ_DL", "hoop stress", "p_DL·R/s", Stress, clause)
}

#[cfg(test)]
mod tests;
