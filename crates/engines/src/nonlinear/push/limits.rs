//! Formulas to compare with the pushover: the acceleration at which the beam's axial stress reaches each of them.
//!
//! ```text
//! σ_m(z, a) = [M(z, a)/(π R²) + N_0(z)]/t         at the lower edge of every course
//! p(z, a)   = ρ g (H − z) ± a p_i(z)               + for the collapse, − for the elastic buckling
//! ```

use std::f64::consts::PI;

use results::PushLimit;
use tank::Course;

use super::model::Plan;

/// A formula for the compressive strength of a wall, to be compared with the pushover.
pub struct Formula<'a> {
    /// Name.
    pub name: String,
    /// Source.
    pub source: String,
    /// Whether it holds for the bottom course alone.
    pub bottom_course: bool,
    /// Factor of the impulsive pressure in the total pressure: 1, −1, or 0 if it does not count.
    pub impulsive: f64,
    /// Compression carried [Pa] by a course under an internal pressure [Pa].
    pub capacity: Capacity<'a>,
}

/// See [`Formula::capacity`].
pub type Capacity<'a> = Box<dyn Fn(&Course, f64) -> f64 + 'a>;

/// Mass of wall and roof above z, and its moment about z [kg, kg m].
pub(super) fn masses(plan: &Plan, z: f64) -> (f64, f64) {
    plan.case.tank.mass_above(z)
}

/// Horizontal force above z and its moment about z per m/s² [kg, kg m].
fn loads(plan: &Plan, z: f64) -> (f64, f64) {
    let (wall, liquid) = (masses(plan, z), plan.impulsive.above(z));
    (wall.0 + liquid.0, wall.1 + liquid.1)
}

/// Axial compression of beam theory at z [Pa].
fn beam(plan: &Plan, z: f64, acceleration: f64) -> f64 {
    stress(plan, z, acceleration * loads(plan, z).1)
}

/// Axial compression of beam theory at z under a moment [Pa].
pub(super) fn stress(plan: &Plan, z: f64, moment: f64) -> f64 {
    let t = plan.case.tank.course_at(z).thickness;
    let weight = if plan.options.self_weight { masses(plan, z).0 * plan.case.gravity } else { 0.0 };
    (moment / (PI * plan.radius * plan.radius) + weight / (2.0 * PI * plan.radius)) / t
}

/// A place: height, course.
struct Place<'a> {
    z: f64,
    number: usize,
    course: &'a Course,
}

/// The formulas, each at its governing course.
pub(super) fn limits(plan: &Plan, formulas: &[Formula]) -> Vec<PushLimit> {
    let mut z = 0.0;
    let mut places = Vec::new();
    for (k, course) in plan.case.tank.courses.iter().enumerate() {
        places.push(Place { z, number: k + 1, course });
        z += course.height;
    }
    let of = |formula: &Formula| match formula.bottom_course {
        true => governing(plan, &places[..1], formula),
        false => governing(plan, &places, formula),
    };
    formulas.iter().map(of).collect()
}

fn governing(plan: &Plan, places: &[Place], formula: &Formula) -> PushLimit {
    let case = plan.case;
    let limit = |p: &Place, a: f64| {
        let rest = case.liquid.density * case.gravity * (case.liquid.fill_height - p.z).max(0.0);
        let pressure = rest + formula.impulsive * a * plan.impulsive.pressure(p.z);
        (formula.capacity)(p.course, pressure)
    };
    let most = 10.0 * plan.case.gravity;
    let reached = |p: &Place, a: f64| beam(plan, p.z, a) >= limit(p, a);
    let of = |p: &Place| {
        if !reached(p, most) {
            return f64::INFINITY;
        }
        // The stress grows with a; the limits fall or grow slower.
        let (mut low, mut high) = (0.0, most);
        for _ in 0..60 {
            let middle = 0.5 * (low + high);
            if reached(p, middle) {
                high = middle;
            } else {
                low = middle;
            }
        }
        high
    };
    let found = places.iter().map(|p| (of(p), p)).min_by(|a, b| a.0.total_cmp(&b.0));
    let (acceleration, place) = found.map_or((f64::INFINITY, &places[0]), |(a, p)| (a, p));
    PushLimit {
        name: formula.name.clone(),
        source: formula.source.clone(),
        acceleration: acceleration.is_finite().then_some(acceleration),
        course: place.number,
        height: place.z,
        stress: limit(place, acceleration.min(most)),
    }
}
