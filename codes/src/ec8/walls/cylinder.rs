//! Forces in the wall of a cylinder that is not a metal shell: those of the shell on its joint with the base (`tank.wall_base`).
//!
//! ```text
//! n_θ = E s w/R        m_z = D w''        m_θ = ν m_z        v = reaction of the base
//! ```
//!
//! A joint that slides with friction holds the foot with anything between nothing and μ n, n being the force that stands on it. Both ends are
//! checked: without friction the hoop force is largest, with it bending and shear. What would be more than a hinge is a hinge.

use std::f64::consts::PI;

use super::checks;
use super::place::{Factors, Horizontal, Place, cases, course_index};
use crate::ec8::cylinder_stress::State;
use crate::ec8::limit_states::{WALL_JOINT, WALL_SHEAR};
use crate::ec8::wall_bending::{Plan, State as Bent, Wall};
use crate::ec8::work::Work;
use tank::assessment::{Check, CheckStatus};
use tank::quantity::Quantity;
use tank::units::Dimension::*;
use tank::{BarDirection, WallBase};

/// Clause of what statics alone gives.
const STATICS: &str = "statics";

/// Writes the checks of the wall.
pub(in crate::ec8) fn assess(work: &mut Work, state: &State, vertical: bool) {
    let case = work.case;
    if case.tank.is_metal() {
        return;
    }
    let (depth, courses) = (case.liquid.fill_height, case.tank.courses.as_slice());
    let q = work.demand.behaviour_factor;
    let horizontal = Horizontal::new((depth, courses), state.combination, (state.impulsive_acceleration(), q), |z| {
        (state.pressure_impulsive(z), state.pressure_convective(z))
    });
    let radius = state.radius;
    let base = case.tank.wall_base;
    let wall = Wall::new(courses, Plan::Cylinder { radius, base });
    let pulled = (!base.holds().0).then(|| wall.pulled());
    let reduction = work.demand.site.and_then(|site| site.reduction_factor);
    let cases = cases(vertical, reduction);
    let [still, breathing] =
        [wall.under(|z| state.pressure_hydrostatic(z)), wall.under(|z| state.pressure_vertical(z))];
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
            let (hoop, vertical) = forces(state, z, factors, (axial.0 * scale, axial.1 * scale));
            let foot = z == 0.0;
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
            let stands = state.weight(0.0) * state.weight_factor(factors.v) + x * state.axial(0.0) * scale;
            for held in by_friction(friction(base) * stands.max(0.0), pulled.as_ref(), sum(&|s| s.at(0.0, 0.0).w)) {
                let pull = |of: &dyn Fn(&Bent) -> f64| pulled.as_ref().map_or(0.0, |pulled| held * of(pulled));
                let both = |of: &dyn Fn(&Bent) -> f64| sum(of) - pull(of);
                let m = if foot { both(&|s| s.base.0) } else { both(&|s| s.at(0.0, z).m_z) };
                places.push(place(BarDirection::Hoop, both(&|s| s.hoop(z)) + hoop, nu * m, None));
                let shear = foot.then(|| (both(&|s| s.base.1) + held).abs());
                places.push(place(BarDirection::Vertical, vertical, m, shear));
            }
        }
    }
    work.out.notes.push(format!(
        "{} Restraint, temperature, shrinkage, prestress and least reinforcement (EN 1992-1-1 7.3.2, 9.6) are left out.",
        words(base)
    ));
    checks::assess(work, &places);
    if let WallBase::Sliding { friction, .. } = base {
        along_the_joint(work, state, (base_shear / (PI * radius), friction), vertical);
    }
}

/// What the base is taken for.
fn words(base: WallBase) -> &'static str {
    match base {
        WallBase::Fixed => {
            "Wall of concrete: hoop force and bending of the shell clamped at its base, under the pressure of its meridian."
        }
        WallBase::Hinged => {
            "Wall of concrete: hoop force and bending of the shell on a hinge, under the pressure of its meridian; periods are those of a \
             clamped foot."
        }
        WallBase::Sliding { .. } => {
            "Wall of concrete: hoop force and bending of the shell on a joint that slides, under the pressure of its meridian; periods are those \
             of a clamped foot."
        }
    }
}

/// Coefficient of the friction that alone holds a foot along the radius.
fn friction(base: WallBase) -> f64 {
    match base {
        WallBase::Sliding { stiffness: None, friction: Some(friction) } => friction,
        _ => 0.0,
    }
}

/// The forces with which friction may hold the foot [N/m]: none, and what stops it, at most `most`.
///
/// * `moved`: displacement of the foot without friction [m]
fn by_friction(most: f64, pulled: Option<&Bent>, moved: f64) -> Vec<f64> {
    let Some(pulled) = pulled.filter(|_| most > 0.0) else { return vec![0.0] };
    let stops = moved / pulled.at(0.0, 0.0).w;
    vec![0.0, stops.clamp(-most, most)]
}

/// Shear of the earthquake along a joint that slides: largest at the sides of the tank, where the moment leaves the weight alone.
///
/// * `(flow, friction)`: Q/(π R) [N/m], and the coefficient of friction
fn along_the_joint(work: &mut Work, state: &State, (flow, friction): (f64, Option<f64>), vertical: bool) {
    let Some(friction) = friction else {
        let reason = "the shear of the earthquake along the sliding joint: `tank.wall_base.friction` is missing";
        return work.without_comparison(
            WALL_SHEAR.id,
            CheckStatus::NotChecked,
            reason,
            Some("tank.wall_base.friction"),
        );
    };
    let lifted = if vertical { -0.3 } else { 0.0 };
    let weight = state.held() * state.weight_factor(lifted);
    let sheet = &mut work.sheet;
    sheet.section("Wall of concrete: shear along the joint at its base");
    let source = "Q/(π·R) at the sides of the tank";
    let demand = sheet.look_up("n_zθ", "shear along the joint", source, flow, LineForce, STATICS);
    sheet.input("μ", "friction of the joint", friction, Dimensionless, "tank.wall_base");
    let source = "wall and roof, 1 - 0.3 A_v/g";
    sheet.look_up("n", "force on the joint", source, weight, LineForce, STATICS);
    let capacity = sheet.calc("v_Rd", "friction of the joint", "μ·n", LineForce, STATICS);
    let name = "Shear along the joint at the base";
    let check = Check::new(WALL_JOINT.id, name, demand, capacity, LineForce, STATICS, "");
    work.out.checks.push(check.of(WALL_SHEAR.id));
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
