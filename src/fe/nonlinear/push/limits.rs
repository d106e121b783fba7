//! Formulas beside the pushover: the acceleration at which the beam's axial stress reaches each of them.
//!
//! ```text
//! σ_m(z, a) = [M(z, a)/(π R²) + N_0(z)]/t         at the lower edge of every course
//! p(z, a)   = ρ g (H − z) ± a p_i(z)               + for the collapse, − for the elastic buckling
//! ```

use std::f64::consts::PI;

use codes::api650::hold_down::allowable_compression;
use codes::ec8::buckling;
use tank::Course;

use super::model::Plan;
use crate::results::PushLimit;

/// Density of water in the specific gravity of API 650 [kg/m³].
const WATER: f64 = 1000.0;

/// Mass of wall and roof above z, and its moment about z [kg, kg m].
pub(super) fn masses(plan: &Plan, z: f64) -> (f64, f64) {
    let tank = &plan.case.tank;
    let mut sum = (tank.roof.mass, tank.roof.mass * (tank.roof_height() - z));
    let mut base = 0.0;
    for course in &tank.courses {
        let top = base + course.height;
        let from = f64::max(base, z);
        if top > from {
            let mass = tank.perimeter() * (top - from) * course.thickness * course.material.density;
            sum.0 += mass;
            sum.1 += mass * (0.5 * (from + top) - z);
        }
        base = top;
    }
    sum
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
    let weight = match plan.options.self_weight {
        true => masses(plan, z).0 * plan.case.gravity,
        false => 0.0,
    };
    (moment / (PI * plan.radius * plan.radius) + weight / (2.0 * PI * plan.radius)) / t
}

/// A place: height, course.
struct Place<'a> {
    z: f64,
    number: usize,
    course: &'a Course,
}

/// The formulas, each at its governing course.
pub(super) fn limits(plan: &Plan) -> Vec<PushLimit> {
    let case = plan.case;
    let radius = plan.radius;
    let mut z = 0.0;
    let mut places = Vec::new();
    for (k, course) in case.tank.courses.iter().enumerate() {
        places.push(Place {
            z,
            number: k + 1,
            course,
        });
        z += course.height;
    }
    let quality = case.site.ec8.map_or(1.0, |s| s.construction_quality);
    let pressure = |p: &Place, a: f64| {
        let rest = case.liquid.density * case.gravity * (case.liquid.fill_height - p.z).max(0.0);
        rest + a * plan.impulsive.pressure(p.z)
    };
    let young = |p: &Place| p.course.material.youngs_modulus;
    let yielding = places.iter().all(|p| p.course.material.yield_strength.is_some());
    let strength = |p: &Place| p.course.material.yield_strength.unwrap_or(f64::INFINITY);
    let mut out = vec![governing(
        plan,
        &places,
        "0.605 E t/R, perfect elastic".into(),
        "Timoshenko & Gere 1961".into(),
        &|p, _| 0.605 * young(p) * p.course.thickness / radius,
    )];
    if yielding {
        out.push(governing(
            plan,
            &places,
            format!("elastic buckling, quality {quality}"),
            "EN 1998-4:2006, A.10.2".into(),
            &|p, a| {
                let t = p.course.thickness;
                buckling::elastic(young(p), strength(p), t, radius, pressure(p, -a), quality).limit
            },
        ));
        out.push(governing(
            plan,
            &places,
            "elastic-plastic collapse".into(),
            "EN 1998-4:2006, A.10.3".into(),
            &|p, a| buckling::elastic_plastic(young(p), strength(p), p.course.thickness, radius, pressure(p, a)),
        ));
    }
    let specific = case.liquid.density / WATER;
    let api = |p: &Place| {
        let depth = case.liquid.fill_height;
        allowable_compression(
            p.course.thickness,
            2.0 * radius,
            specific,
            depth,
            p.course.material.yield_strength,
        )
    };
    // The code checks the bottom course.
    if api(&places[0]).is_some() {
        out.push(governing(
            plan,
            &places[..1],
            "allowable compression F_C".into(),
            "API 650, E.6.2.2.3".into(),
            &|p, _| api(p).unwrap_or(f64::INFINITY),
        ));
    }
    out
}

fn governing(
    plan: &Plan,
    places: &[Place],
    name: String,
    source: String,
    limit: &dyn Fn(&Place, f64) -> f64,
) -> PushLimit {
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
        name,
        source,
        acceleration: acceleration.is_finite().then_some(acceleration),
        course: place.number,
        height: place.z,
        stress: limit(place, acceleration.min(most)),
    }
}
