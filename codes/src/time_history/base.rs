//! The base of the tank: tension of the anchors, uplift without them, sliding.

use std::f64::consts::{PI, TAU};

use tank::Support;
use tank::assessment::{Check, CheckStatus};
use tank::demand::FreeBase;
use tank::quantity::Quantity;
use tank::units::Dimension::{Acceleration, Angle, Dimensionless, Force, LineForce, Mass};

use super::limit_states::{ANCHORS, SLIDING, UPLIFT};
use super::ready::History;
use super::search::Found;
use super::work::Work;
use crate::api650::edition2020::limit_states::{ANNULUS, ATTACHMENT, CONNECTIONS};
use crate::code::{Friction, Open};
use crate::ec8::limit_states::UPLIFT as PLATE_UPLIFT;
use crate::sheet::with_unit;

/// Limit states of anchors at which the earthquake pulls.
const OF_PULLED_ANCHORS: [&str; 3] = [ANCHORS.id, ATTACHMENT.id, CONNECTIONS.id];
/// Limit states of a bottom plate that lifts.
const OF_LIFTED_PLATE: [&str; 4] = [UPLIFT.id, PLATE_UPLIFT.id, ANNULUS.id, CONNECTIONS.id];

/// Nothing lifts.
fn rests(work: &mut Work<'_>, reason: &str) {
    for id in OF_LIFTED_PLATE {
        work.without(id, CheckStatus::NotApplicable, reason, None);
    }
}

/// Tension at the base of a cylinder's wall. Returns where an unanchored wall pulls, in words.
pub(super) fn tension(work: &mut Work<'_>, radius: f64) -> Option<String> {
    let demands = work.demands;
    if let Some(base) = &demands.base {
        lifting(work, base);
        if work.case.tank.support == Support::Unanchored {
            return None;
        }
    }
    let pulls = work.ready.base.iter().filter_map(|searched| {
        let (place, above) = (searched.place, f64::NEG_INFINITY);
        let found = work.search(searched).axial_tension(0.0, above)?;
        Some((place, found.turned(place.turned)))
    });
    // More than one only where the histories are known at two sides of each.
    let (base, found) = pulls.reduce(|best, next| if next.1.demand > best.1.demand { next } else { best })?;
    let thickness = work.case.tank.courses[base.course].thickness;
    let moment = work.moment(&found, 0.0);
    let pull = found.demand * thickness;
    let pulls = format!("the wall pulls at its base with {} at {}", with_unit(pull, LineForce), moment.words());
    if work.case.tank.support == Support::Unanchored {
        return match pull > 0.0 {
            true => Some(pulls),
            false => {
                rests(work, "the wall does not pull at its base: it stays in contact");
                None
            }
        };
    }
    // On anchors the wall presses the ground at rest; its relief pulls an anchor before the wall pulls.
    let spring = demands.base.as_ref().and_then(|base| base.anchor);
    if pull <= 0.0 && spring.is_none_or(|anchor| anchor.value <= 0.0) {
        let reason = "the wall does not pull at its base";
        for id in OF_PULLED_ANCHORS {
            work.without(id, CheckStatus::NotApplicable, reason, None);
        }
        return None;
    }
    let anchors = work.case.tank.anchors.filter(|anchors| anchors.count > 0);
    let Some((count, capacity)) = anchors.and_then(|a| a.capacity.map(|capacity| (a.count, capacity))) else {
        let input = match anchors {
            Some(_) => "tank.anchors.capacity",
            None => "tank.anchors",
        };
        let reason = format!("{pulls}; `{input}` is missing");
        work.without(ANCHORS.id, CheckStatus::NotChecked, &reason, Some(input));
        return None;
    };
    let spacing = TAU * radius / f64::from(count);
    let clause = work.clause(ANCHORS.id);
    work.sheet.section(&format!("Anchors: {}", moment.words()));
    work.sheet.input("n_a", "largest pull at the base, static and seismic", pull, LineForce, "the run of the engine");
    work.sheet.given(&[("R", radius, tank::units::Dimension::Length), ("n_A", f64::from(count), Dimensionless)]);
    let name = "tension of an anchor";
    let of_wall = work.sheet.calc("F_a", name, "n_a·2·π·R/n_A", Force, &clause);
    let (mut force, mut place) = (of_wall, (moment.time, moment.theta));
    if let Some(anchor) = spring {
        let title = "largest force of an anchor, of one that yields as if it stayed elastic";
        work.sheet.input("F_s", title, anchor.value, Force, "the run of the engine");
        force = work.sheet.calc("F_A", name, "max(F_a, F_s)", Force, &clause);
        if anchor.value > of_wall {
            place = (anchor.time, anchor.theta);
        }
    }
    let found = Found {
        demand: force,
        // Without the earthquake the wall presses: the weight takes its part of the pull.
        rest: base.axial.rest * thickness * spacing,
        ..found
    };
    let error = work.error(&[Quantity::AxialMembraneStress], &found);
    let note = format!("{count} anchors, one every {}", with_unit(spacing, tank::units::Dimension::Length));
    let anchor = ANCHORS.named("Tension of an anchor").check();
    let check = anchor.of(force, capacity, &clause, &note);
    let check = check.at(Some(place.0), Some(0.0), Some(place.1)).with_error(error);
    work.checks.push(check);
    None
}

/// Uplift of an unanchored wall in an engine that lets it lift: the plastic rotation of the joint of its bottom plate.
fn lifting(work: &mut Work<'_>, base: &FreeBase) {
    if !base.lifts {
        return rests(work, "the rim stays on the ground");
    }
    let limits = work.codes.iter().map(|code| code.joint_rotation());
    let rotation = match limits.reduce(Result::or) {
        Some(Ok(rotation)) => rotation,
        why => {
            let reason = format!("the rim lifts; {}", why.and_then(Result::err).unwrap_or_default());
            work.without(UPLIFT.id, CheckStatus::NotChecked, &reason, None);
            return;
        }
    };
    let Some(joint) = base.joint else {
        let reason = "the rim lifts; the material of the bottom plate has no yield_strength";
        work.without(UPLIFT.id, CheckStatus::NotChecked, reason, None);
        return;
    };
    let bottom = work.case.tank.bottom.as_ref();
    let lowest = work.case.tank.courses.first().map_or(0.0, |course| course.thickness);
    let wall_first = base.elastic_wall && bottom.is_some_and(|bottom| bottom.thickness > lowest);
    if wall_first && joint.value <= rotation {
        let reason = "the rim lifts; the bottom plate is thicker than the lowest course, which yields before it and which the run leaves elastic";
        work.without(UPLIFT.id, CheckStatus::NotChecked, reason, None);
        return;
    }
    let clause = work.clause(UPLIFT.id);
    let name = "Plastic rotation of the joint of the bottom plate";
    let note = "joint of wall and bottom plate, the largest of the run";
    let check = Check::new(UPLIFT.id, name, joint.value, rotation, Angle, &clause, note);
    work.checks.push(check.at(Some(joint.time), Some(0.0), Some(joint.theta)));
}

/// Base shear against the friction under the weight of the same instant.
///
/// ```text
/// |V(t)| ≤ μ M (g + a_v(t))        a_v upwards
/// ```
///
/// |V| is √(V_x² + V_y²) under two horizontal components.
///
/// M is the mass of liquid, wall and roof. The weight of the bottom plate is left out, on the safe side.
pub(super) fn sliding(work: &mut Work<'_>) {
    let case = work.case;
    let (mut frictions, mut open) = (Vec::new(), Vec::new());
    for code in work.codes {
        match code.friction(case) {
            Ok(friction) => frictions.push(friction),
            Err(why) => open.push(why),
        }
    }
    // A check that does not apply under one code says nothing beside one that another makes or misses.
    let missing = open.iter().find(|open| open.status == CheckStatus::NotChecked);
    let open = missing.or(open.first().filter(|_| frictions.is_empty()));
    if let Some(Open { status, reason, input }) = open {
        work.without(SLIDING.id, *status, reason, *input);
    }
    // Friction caps the shear of a tank that slides: it is judged by that of the tank held in place.
    let slides = (work.demands.base.as_ref()).is_some_and(|base| base.held_shear.is_some());
    let (ready, factor) = (work.ready, work.factor);
    let Some(shear) = &ready.shear else {
        if !frictions.is_empty() {
            let reason = "the engine does not give the base shear";
            work.without(SLIDING.id, CheckStatus::NotChecked, reason, None);
        }
        return;
    };
    let size = |k: usize| factor * shear.size(k);
    let upwards = |k: usize| factor * ready.upwards(k);
    let mass = case.liquid_mass() + case.tank.wall_mass() + case.tank.roof.mass;
    for friction in frictions {
        let Friction { id, name: title, coefficient: friction, clause } = friction;
        let Some((k, utilisation)) = slides_most(work, shear, friction * mass) else { continue };
        let (time, upwards) = (work.demands.times[k], upwards(k));
        let when = with_unit(time, tank::units::Dimension::Time);
        work.sheet.section(&format!("Sliding ({clause}): t = {when}"));
        let demand = size(k);
        work.sheet.input("V", "base shear", demand, Force, "the run of the engine");
        let name = "vertical acceleration of the ground then, upwards";
        work.sheet.input("a_v", name, upwards, Acceleration, "record");
        work.sheet.given(&[("μ", friction, Dimensionless), ("M", mass, Mass), ("g", case.gravity, Acceleration)]);
        let name = "friction under the weight of liquid, wall and roof then";
        let capacity = work.sheet.calc("V_R", name, "μ·M·(g + a_v)", Force, clause);
        let found = Found { utilisation, demand, rest: 0.0, capacity, instant: k, direction: (1.0, 0.0) };
        let error = work.error(&[Quantity::BaseShear], &found);
        let note = match slides {
            true => {
                "shear of the tank held in place, which slides; weight of the same instant, without bottom plate and foundation"
            }
            false => "weight of the same instant, without bottom plate and foundation",
        };
        let check = Check::new(id, title, demand, capacity, Force, clause, note);
        let theta = match shear.at(k) {
            (x, Some(y)) => y.atan2(x).rem_euclid(TAU),
            (x, None) if x < 0.0 => PI,
            _ => 0.0,
        };
        work.checks.push(check.of(SLIDING.id).at(Some(time), Some(0.0), Some(theta)).with_error(error));
    }
}

/// The first instant of the largest ratio of shear to friction, and that ratio.
///
/// * `held`: friction times mass [kg]
fn slides_most(work: &Work<'_>, shear: &History, held: f64) -> Option<(usize, f64)> {
    let (ready, factor) = (work.ready, work.factor);
    // It grows with the size and falls with the acceleration, rounding included: extremes of a row bound its instants.
    let ratio = |size: f64, upwards: f64| match held * (work.case.gravity + factor * upwards) {
        c if c > 0.0 => factor * size / c,
        _ => f64::INFINITY,
    };
    let mut worst: Option<(usize, f64)> = None;
    let more = |ratio: f64, worst: Option<(usize, f64)>| worst.is_none_or(|(_, most)| ratio.total_cmp(&most).is_gt());
    for (number, (row, largest)) in shear.rows().enumerate() {
        if !more(ratio(largest, ready.least_upwards(number)), worst) {
            continue;
        }
        for k in row {
            let ratio = ratio(shear.size(k), ready.upwards(k));
            if more(ratio, worst) {
                worst = Some((k, ratio));
            }
        }
    }
    worst
}
