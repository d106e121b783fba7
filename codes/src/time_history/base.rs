//! The base of the tank: tension of the anchors, uplift without them, sliding.

use std::f64::consts::{PI, TAU};

use tank::assessment::{Check, CheckStatus};
use tank::case::Case;
use tank::demand::FreeBase;
use tank::quantity::Quantity;
use tank::units::Dimension::{Acceleration, Angle, Dimensionless, Force, LineForce, Mass};
use tank::{Shape, Support};

use super::limit_states::{ANCHORS, API, Codes, SLIDING, UPLIFT};
use super::search::Found;
use super::work::Work;
use crate::ec8::plate_uplift::ROTATION;
use crate::sheet::with_unit;

/// Path of the friction of Eurocode 8.
const FRICTION: &str = "site.ec8.friction";
/// Largest friction that API 650 allows (E.7.6).
const API_FRICTION: f64 = 0.4;

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
    let pulls = format!(
        "the wall pulls at its base with {} at {}",
        with_unit(pull, LineForce),
        moment.words()
    );
    if work.case.tank.support == Support::Unanchored {
        return match pull > 0.0 {
            true => Some(pulls),
            false => {
                let reason = "the wall does not pull at its base: it stays in contact";
                work.without(UPLIFT, CheckStatus::NotApplicable, reason, None);
                None
            }
        };
    }
    // On anchors the wall presses the ground at rest; its relief pulls an anchor before the wall pulls.
    let spring = demands.base.as_ref().and_then(|base| base.anchor);
    if pull <= 0.0 && spring.is_none_or(|anchor| anchor.value <= 0.0) {
        let reason = "the wall does not pull at its base";
        work.without(ANCHORS, CheckStatus::NotApplicable, reason, None);
        return None;
    }
    let anchors = work.case.tank.anchors.filter(|anchors| anchors.count > 0);
    let Some((count, capacity)) = anchors.and_then(|a| a.capacity.map(|capacity| (a.count, capacity))) else {
        let input = match anchors {
            Some(_) => "tank.anchors.capacity",
            None => "tank.anchors",
        };
        let reason = format!("{pulls}; `{input}` is missing");
        work.without(ANCHORS, CheckStatus::NotChecked, &reason, Some(input));
        return None;
    };
    let spacing = TAU * radius / f64::from(count);
    let clause = work.clause(ANCHORS);
    work.sheet.section(&format!("Anchors: {}", moment.words()));
    work.sheet.input(
        "n_a",
        "largest pull at the base, static and seismic",
        pull,
        LineForce,
        "the run of the engine",
    );
    let terms = [
        ("n_a", pull, LineForce),
        ("R", radius, tank::units::Dimension::Length),
        ("n_A", f64::from(count), Dimensionless),
    ];
    let name = "tension of an anchor";
    let of_wall = work.sheet.calc("F_a", name, "n_a·2·π·R/n_A", &terms, Force, &clause);
    let (mut force, mut place) = (of_wall, (moment.time, moment.theta));
    if let Some(anchor) = spring {
        let title = "largest force of an anchor, of one that yields as if it stayed elastic";
        work.sheet
            .input("F_s", title, anchor.value, Force, "the run of the engine");
        let terms = [("F_a", of_wall, Force), ("F_s", anchor.value, Force)];
        force = work.sheet.calc("F_A", name, "max(F_a, F_s)", &terms, Force, &clause);
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
    let note = format!(
        "{count} anchors, one every {}",
        with_unit(spacing, tank::units::Dimension::Length)
    );
    let check = Check::new(ANCHORS, "Tension of an anchor", force, capacity, Force, &clause, &note);
    let check = check.at(Some(place.0), Some(0.0), Some(place.1)).with_error(error);
    work.checks.push(check);
    None
}

/// Uplift of an unanchored wall in an engine that lets it lift: the plastic rotation of the joint of its bottom plate.
fn lifting(work: &mut Work<'_>, base: &FreeBase) {
    if !base.lifts {
        let reason = "the rim stays on the ground";
        work.without(UPLIFT, CheckStatus::NotApplicable, reason, None);
        return;
    }
    if !work.codes.ec8 {
        let reason = "the rim lifts; API 650 judges uplift by the anchorage ratio of its annex, not by a time history";
        work.without(UPLIFT, CheckStatus::NotChecked, reason, None);
        return;
    }
    let Some(joint) = base.joint else {
        let reason = "the rim lifts; the material of the bottom plate has no yield_strength";
        work.without(UPLIFT, CheckStatus::NotChecked, reason, None);
        return;
    };
    let bottom = work.case.tank.bottom.as_ref();
    let lowest = work.case.tank.courses.first().map_or(0.0, |course| course.thickness);
    let wall_first = base.elastic_wall && bottom.is_some_and(|bottom| bottom.thickness > lowest);
    if wall_first && joint.value <= ROTATION {
        let reason = "the rim lifts; the bottom plate is thicker than the lowest course, which yields before it and which the run leaves elastic";
        work.without(UPLIFT, CheckStatus::NotChecked, reason, None);
        return;
    }
    let clause = work.clause(UPLIFT);
    let name = "Plastic rotation of the joint of the bottom plate";
    let note = "joint of wall and bottom plate, the largest of the run";
    let check = Check::new(UPLIFT, name, joint.value, ROTATION, Angle, &clause, note);
    work.checks
        .push(check.at(Some(joint.time), Some(0.0), Some(joint.theta)));
}

/// Friction coefficients with their clauses, and the reason where one is missing.
fn frictions(case: &Case, codes: Codes) -> (Vec<(&'static str, f64, String)>, Option<String>) {
    let (mut found, mut missing) = (Vec::new(), None);
    if codes.ec8 {
        match case.site.ec8.and_then(|site| site.friction) {
            Some(friction) => found.push(("sliding", friction, "EN 1998-5:2004 5.4.1.1".to_owned())),
            None => missing = Some(format!("`{FRICTION}` is missing")),
        }
    }
    if let (true, Some(site), Support::Unanchored) = (codes.api, case.site.api650, case.tank.support) {
        let friction = site.friction.min(API_FRICTION);
        found.push(("sliding_api", friction, format!("{API} E.7.6")));
    }
    (found, missing)
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
    let (frictions, missing) = frictions(case, work.codes);
    if let Some(reason) = missing {
        work.without(SLIDING, CheckStatus::NotChecked, &reason, Some(FRICTION));
    } else if frictions.is_empty() {
        let reason = format!("{API} E.7.6: the check is for self-anchored tanks");
        work.without(SLIDING, CheckStatus::NotApplicable, &reason, None);
    }
    // Friction caps the shear of a tank that slides: it is judged by that of the tank held in place.
    let slides = (work.demands.base.as_ref()).is_some_and(|base| base.held_shear.is_some());
    let (ready, factor) = (work.ready, work.factor);
    let Some(shear) = &ready.shear else {
        if !frictions.is_empty() {
            let reason = "the engine does not give the base shear";
            work.without(SLIDING, CheckStatus::NotChecked, reason, None);
        }
        return;
    };
    let size = |k: usize| factor * shear.size(k);
    let upwards = |k: usize| factor * ready.upwards(k);
    let mass = case.liquid_mass() + case.tank.wall_mass() + case.tank.roof.mass;
    for (id, friction, clause) in frictions {
        // It grows with the size and falls with the acceleration, rounding included: extremes of a row bound its instants.
        let ratio = |size: f64, upwards: f64| match friction * mass * (case.gravity + factor * upwards) {
            c if c > 0.0 => factor * size / c,
            _ => f64::INFINITY,
        };
        let mut worst: Option<(usize, f64)> = None;
        let more =
            |ratio: f64, worst: Option<(usize, f64)>| worst.is_none_or(|(_, most)| ratio.total_cmp(&most).is_gt());
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
        let Some((k, utilisation)) = worst else {
            continue;
        };
        let (time, upwards) = (work.demands.times[k], upwards(k));
        let when = with_unit(time, tank::units::Dimension::Time);
        work.sheet.section(&format!("Sliding ({clause}): t = {when}"));
        let demand = size(k);
        work.sheet
            .input("V", "base shear", demand, Force, "the run of the engine");
        let name = "vertical acceleration of the ground then, upwards";
        work.sheet.input("a_v", name, upwards, Acceleration, "record");
        let terms = [
            ("μ", friction, Dimensionless),
            ("M", mass, Mass),
            ("g", case.gravity, Acceleration),
            ("a_v", upwards, Acceleration),
        ];
        let name = "friction under the weight of liquid, wall and roof then";
        let capacity = work.sheet.calc("V_R", name, "μ·M·(g + a_v)", &terms, Force, &clause);
        let found = Found {
            utilisation,
            demand,
            rest: 0.0,
            capacity,
            instant: k,
            direction: (1.0, 0.0),
        };
        let error = work.error(&[Quantity::BaseShear], &found);
        let note = match slides {
            true => {
                "shear of the tank held in place, which slides; weight of the same instant, without bottom plate and foundation"
            }
            false => "weight of the same instant, without bottom plate and foundation",
        };
        let title = match id == SLIDING {
            true => "Sliding on the foundation",
            false => "Sliding on the foundation, API 650",
        };
        let check = Check::new(id, title, demand, capacity, Force, &clause, note);
        let theta = match shear.at(k) {
            (x, Some(y)) => y.atan2(x).rem_euclid(TAU),
            (x, None) if x < 0.0 => PI,
            _ => 0.0,
        };
        work.checks.push(
            check
                .of(SLIDING)
                .at(Some(time), Some(0.0), Some(theta))
                .with_error(error),
        );
    }
}

/// Inner radius of a cylinder [m].
pub(super) fn radius(case: &Case) -> Option<f64> {
    match case.tank.shape {
        Shape::Cylinder { radius } => Some(radius),
        Shape::Rectangle { .. } => None,
    }
}
