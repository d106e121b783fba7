//! Walls of a metal box: elastic stress of axial force and bending below the yield strength.

use super::place::{Place, Situation};
use crate::ec8::limit_states::{DAMAGE, DAMAGE_WALL, WALL_BENDING};
use crate::ec8::work::Work;
use tank::assessment::Check;
use tank::units::Dimension::*;

/// Writes the checks: |n|/s + 6 |m|/s² ≤ f_y in each direction.
pub(super) fn assess(work: &mut Work, places: &[Place], damage: bool) {
    let courses = &work.case.tank.courses;
    if let Some(course) = courses.iter().find(|c| c.material.yield_strength.is_none()) {
        let input = format!("materials.{}.yield_strength", course.material.name);
        work.missing(WALL_BENDING.id, &input);
        if damage {
            work.missing(DAMAGE.id, &input);
        }
        return;
    }
    one(work, places, Situation::Seismic, WALL_BENDING.id);
    if damage {
        one(work, places, Situation::Damage, DAMAGE.id);
    }
}

fn one(work: &mut Work, places: &[Place], situation: Situation, state: &str) {
    let stress = |p: &Place| {
        let s = p.course.thickness;
        p.n.abs() / s + 6.0 * p.m.abs() / (s * s)
    };
    let capacity = |p: &Place| p.course.material.yield_strength.unwrap_or_default();
    let worst = (places.iter())
        .filter(|p| p.factors.situation == situation)
        .max_by(|a, b| (stress(a) / capacity(a)).total_cmp(&(stress(b) / capacity(b))));
    let Some(place) = worst else { return };
    let clause = "elastic plate theory";
    work.sheet.section("Walls of metal: axial force and bending");
    work.sheet.given(&[("n", place.n, LineForce), ("m", place.m, LineMoment), ("s", place.course.thickness, Length)]);
    let name = format!("largest stress, {}", place.describe());
    let stress = work.sheet.calc("σ_Ed", &name, "max(n, -n)/s + 6·max(m, -m)/s²", Stress, clause);
    let id = if state == DAMAGE.id { DAMAGE_WALL.id } else { WALL_BENDING.id };
    let name = "Tension and bending of the wall below yield";
    let check = Check::new(id, name, stress, capacity(place), Stress, clause, &place.describe());
    work.out.checks.push(check.of(state));
}
