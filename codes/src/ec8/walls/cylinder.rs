//! Forces in the wall of a cylinder that is not a metal shell.

use std::f64::consts::PI;

use super::checks;
use super::place::{Factors, Horizontal, Place, cases, course_index};
use crate::ec8::cylinder_stress::State;
use crate::ec8::wall_bending::{Plan, State as Bent, Wall};
use crate::ec8::work::Work;
use tank::BarDirection;
use tank::quantity::Quantity;

/// Writes the checks of the wall.
pub(in crate::ec8) fn assess(work: &mut Work, state: &State, vertical: bool) {
    let case = work.case;
    if case.tank.is_metal() {
        return;
    }
    let (depth, courses) = (case.liquid.fill_height, case.tank.courses.as_slice());
    let q = work.demand.behaviour_factor;
    let horizontal = Horizontal::new(
        (depth, courses),
        state.combination,
        (state.impulsive_acceleration(), q),
        |z| (state.pressure_impulsive(z), state.pressure_convective(z)),
    );
    let radius = state.radius;
    let wall = Wall::new(courses, Plan::Cylinder { radius });
    let reduction = work.demand.site.and_then(|site| site.reduction_factor);
    let cases = cases(vertical, reduction);
    let [still, breathing] = [
        wall.under(|z| state.pressure_hydrostatic(z)),
        wall.under(|z| state.pressure_vertical(z)),
    ];
    let of = |situation| wall.under(|z| horizontal.pressure(z, situation));
    let seismic = of(super::place::Situation::Seismic);
    let damage = of(super::place::Situation::Damage);
    let base_shear = work.out.values.get(&Quantity::BaseShear).copied().unwrap_or_default();
    let mut places = Vec::new();
    for z in case.tank.profile_heights(depth) {
        let index = course_index(courses, z);
        let shear = if z == 0.0 { base_shear } else { state.shear(z) };
        let axial = (state.axial(z), shear / (PI * radius));
        for factors in &cases {
            let side = match factors.situation {
                super::place::Situation::Damage => &damage,
                _ => &seismic,
            };
            let x = if factors.aside { 0.0 } else { factors.x };
            let sum = |of: &dyn Fn(&Bent) -> f64| of(&still) + x * of(side) + factors.v * of(&breathing);
            let scale = horizontal.scale(factors.situation);
            let pressure = state.pressure_hydrostatic(z)
                + x * horizontal.pressure(z, factors.situation)
                + factors.v * state.pressure_vertical(z);
            let (hoop, vertical) = forces(state, z, factors, (axial.0 * scale, axial.1 * scale));
            let base = z == 0.0;
            let m = if base {
                sum(&|s| s.base.0)
            } else {
                sum(&|s| s.at(0.0, z).m_z)
            };
            let nu = courses[index].material.poisson_ratio;
            let place = |direction, n, m, shear| Place {
                course: &courses[index],
                index,
                wall: ("", ""),
                z,
                head: (depth - z).max(0.0),
                factors: *factors,
                direction,
                n,
                m,
                shear,
            };
            let membrane = (pressure * radius).max(sum(&|s| s.hoop(z)));
            places.push(place(BarDirection::Hoop, membrane + hoop, nu * m, None));
            let shear = base.then(|| sum(&|s| s.base.1).abs());
            places.push(place(BarDirection::Vertical, vertical, m, shear));
        }
    }
    work.out.notes.push(
        "Wall of concrete: bending of a wall clamped at its base under the pressure of its meridian; the hoop force is the larger of p R \
         and of the clamped shell's. Restraint, temperature, shrinkage, prestress and least reinforcement (EN 1992-1-1 7.3.2, 9.6) are \
         left out."
            .into(),
    );
    checks::assess(work, &places);
}

/// Axial force of the membrane shear in hoop direction, and axial force in vertical direction [N/m].
///
/// * `(axial, flow)`: seismic axial force and membrane shear at the height [N/m]
fn forces(state: &State, z: f64, factors: &Factors, (axial, flow): (f64, f64)) -> (f64, f64) {
    let weight = state.weight(z) * state.weight_factor(factors.v);
    if factors.aside {
        let shear = factors.x * flow;
        return (shear, shear - weight);
    }
    (0.0, -weight - factors.x * axial)
}
