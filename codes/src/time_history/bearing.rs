//! Bearing of the ground under the record: the pressure below the base of every instant against a given resistance.
//!
//! ```text
//! N(t) = M (g + a_v(t))        e(t) = |M′(t)|/N(t)        σ of a rigid base without tension, as in [`crate::ec8::bearing`]
//! ```
//!
//! M is the mass of liquid, wall and roof, a_v the acceleration of the ground upwards, M′ the moment below the base plate.

use std::f64::consts::{PI, TAU};

use tank::assessment::{Check, CheckStatus};
use tank::quantity::Quantity;
use tank::units::Dimension::{Acceleration, Force, Mass, Moment, Stress, Time};
use tank::{FoundationKind, Support};

use super::limit_states::BEARING;
use super::search::Found;
use super::work::Work;
use crate::ec8::bearing::{
    BEYOND_KERN, Bears, LIFTS, ON_ANCHORS, RESISTANCE, base_lines, largest_pressure, leaves_kern,
};
use crate::sheet::with_unit;

/// Why a rigid base does not speak of a wall on a ring.
const ON_A_RING: &str =
    "the wall presses on a narrow ring, where the pressure exceeds that under a rigid base; the procedures compare it";
/// The largest error that is stated: where the resultant nears the edge, the pressure grows without bound.
const LARGEST_ERROR: f64 = 10.0;

/// Adds the check, or what is missing for it.
pub(super) fn assess(work: &mut Work<'_>) {
    // Bearings stand on the ground in place of the tank.
    if work.case.tank.isolators.is_some() {
        return;
    }
    let mut codes = work.codes.iter();
    let resistance = match codes.find_map(|code| code.bearing_resistance(work.case)) {
        Some(Ok(resistance)) => resistance,
        Some(Err(input)) => {
            return work.missing(BEARING.id, input);
        }
        None => return,
    };
    let (ready, factor) = (work.ready, work.factor);
    let Some(moments) = &ready.moment else {
        let reason = "the engine does not give the moment below the base plate";
        return work.without(BEARING.id, CheckStatus::NotChecked, reason, None);
    };
    let moment = |k: usize| factor * moments.size(k);
    let upwards = |k: usize| factor * ready.upwards(k);
    let case = work.case;
    let mass = case.liquid_mass() + case.tank.wall_mass() + case.tank.roof.mass;
    let normal = |k: usize| mass * (case.gravity + upwards(k));
    let pressure = |k: usize, more: f64| largest_pressure(case.tank.shape, normal(k), moment(k) * (1.0 + more));
    let all: Vec<f64> = (0..moments.len()).map(moment).collect();
    let pressures = ready.vertical.as_ref().map(|_| (0..moments.len()).map(|k| pressure(k, 0.0)).collect());
    let Some(k) = governing(&all, pressures) else { return };
    let at = At { instant: k, moment: all[k], mass, upwards: upwards(k) };
    let bears = lines(work, &at, resistance);
    let found = Found {
        utilisation: 0.0,
        demand: at.moment,
        rest: 0.0,
        capacity: resistance,
        instant: k,
        direction: (1.0, 0.0),
    };
    let of_moment = work.error(&[Quantity::OverturningMoment], &found);
    let error = of_moment.map(|more| match bears {
        Bears::Pressure(now) => (pressure(k, more) / now - 1.0).min(LARGEST_ERROR),
        Bears::Leaves { .. } => more,
    });
    if let Some(reason) = unlike_a_rigid_base(work, &bears, resistance, leaves_kern(case.tank.shape, normal(k), all[k]))
    {
        return work.without(BEARING.id, CheckStatus::NotChecked, reason, None);
    }
    let clause = work.clause(BEARING.id);
    let note = "rigid base without tension, weight of the same instant, without bottom plate and foundation";
    let check = match bears {
        Bears::Pressure(pressure) => {
            let name = "Pressure under a rigid base";
            Check::new(BEARING.id, name, pressure, resistance, Stress, &clause, note)
        }
        Bears::Leaves { limit } => {
            let name = "Moment that a base without tension carries";
            let note = format!("the resultant leaves the base; {note}");
            Check::new(BEARING.id, name, at.moment, limit, Moment, &clause, &note)
        }
    };
    // M′ is that of the accelerations towards θ = 0: tank and liquid lean back, to θ = 180°.
    let theta = match moments.at(k) {
        (x, Some(y)) => (-y).atan2(-x).rem_euclid(TAU),
        (x, None) if x > 0.0 => PI,
        _ => 0.0,
    };
    let time = work.demands.times.get(k).copied();
    work.checks.push(check.at(time, Some(0.0), Some(theta)).with_error(error));
}

/// The governing instant: under a constant weight the pressure grows with the moment. Of several instants whose resultant leaves the
/// base, that with the largest moment.
///
/// * `pressures`: of every instant [Pa], under a weight that changes
fn governing(moments: &[f64], pressures: Option<Vec<f64>>) -> Option<usize> {
    let worse = |&i: &usize, &j: &usize| {
        let by_moment = moments[i].total_cmp(&moments[j]);
        let by_pressure = pressures.as_ref().map_or(by_moment, |p| p[i].total_cmp(&p[j]));
        by_pressure.then(by_moment).then(j.cmp(&i))
    };
    (0..moments.len()).max_by(worse)
}

/// Why a rigid base without tension does not speak of this tank: a wall on anchors, on a ring, or one that lifts.
fn unlike_a_rigid_base(work: &Work<'_>, bears: &Bears, resistance: f64, leaves_kern: bool) -> Option<&'static str> {
    let tank = &work.case.tank;
    let anchored = tank.support == Support::Anchored;
    let Bears::Pressure(pressure) = *bears else { return anchored.then_some(ON_ANCHORS) };
    if pressure > resistance {
        return (leaves_kern && anchored).then_some(BEYOND_KERN);
    }
    match tank.foundation.map(|f| f.kind) {
        // A slab spreads the toe.
        Some(FoundationKind::Slab) => None,
        _ if work.demands.base.as_ref().is_some_and(|base| base.lifts) => Some(LIFTS),
        Some(FoundationKind::RingWall) => Some(ON_A_RING),
        _ => None,
    }
}

/// The governing instant.
struct At {
    instant: usize,
    /// Moment below the base plate [N·m].
    moment: f64,
    /// Mass on the base [kg].
    mass: f64,
    /// Vertical acceleration [m/s²].
    upwards: f64,
}

/// Lines of the governing instant.
fn lines(work: &mut Work<'_>, at: &At, resistance: f64) -> Bears {
    let clause = work.clause(BEARING.id);
    let time = work.demands.times.get(at.instant).copied().unwrap_or_default();
    let (shape, gravity) = (work.case.tank.shape, work.case.gravity);
    let sheet = &mut work.sheet;
    sheet.section(&format!("Bearing of the ground: t = {}", with_unit(time, Time)));
    let run = "the run of the engine";
    sheet.input("M′", "moment below the base plate", at.moment, Moment, run);
    sheet.input("R_d", "design bearing resistance", resistance, Stress, RESISTANCE);
    let name = "vertical acceleration of the ground then, upwards";
    sheet.input("a_v", name, at.upwards, Acceleration, "record");
    sheet.given(&[("M", at.mass, Mass), ("g", gravity, Acceleration)]);
    let name = "weight of liquid, wall and roof then";
    let normal = sheet.calc("N_b", name, "M·(g + a_v)", Force, &clause);
    base_lines(sheet, shape, normal, "M′/N_b")
}

#[cfg(test)]
mod tests;
