//! A tank on isolators: their displacement and tension, and the worst of their properties.
//!
//! ```text
//! displacement        γ_x max |d(t)|                  γ_x = 1.2 of Eurocode 8
//! tension             1 − min N(t)/N_0 ≤ 1            N of the outermost bearing, N_0 at rest
//! ```
//!
//! Both codes ask for every limit state with the lower and the upper bound of the properties: each check is the worst of the runs with
//! nominal, lower and upper ones. An engine that holds the base still has none of these demands, and its checks do not
//! apply. ASCE 7 asks for the displacement in the maximum considered earthquake. The record is the design earthquake, so that check stays open.
//!
//! Source: EN 1998-1:2004 10.3(2), 10.8, 10.10; ASCE 7-16 17.2.4.6, 17.2.8, 17.5.3; recalled.

use tank::assessment::Check;
use tank::units::Dimension::{Dimensionless, Length};

use super::limit_states::{ISOLATORS, TENSION};
use super::work::Work;
use crate::sheet::number;

/// Path of the capacity.
const CAPACITY: &str = "tank.isolators.displacement_capacity";
/// Why nothing is compared where the base is held still.
const FIXED: &str = "the engine holds the base still, and the tank moves on its isolators";

/// The isolators of a tank that has them; nothing is compared without their demands.
pub(super) fn assess(work: &mut Work<'_>) {
    let Some(isolators) = work.case.tank.isolators else { return };
    let Some(found) = &work.demands.isolation else {
        for check in work.checks.iter_mut().filter(|check| check.compared()) {
            *check = check.left_open(FIXED.to_owned());
        }
        return;
    };
    let run = "the run of the engine";
    work.sheet.section("Isolators");
    let displacement = work.factor * found.displacement.value;
    let factor = work.codes.iter().find_map(|code| code.isolator_factor());
    match (factor, isolators.displacement_capacity) {
        (None, _) => {}
        (Some(_), None) => {
            work.missing(ISOLATORS.id, CAPACITY);
        }
        (Some(factor), Some(capacity)) => {
            let clause = work.clause(ISOLATORS.id);
            let name = "largest displacement of the isolators";
            work.sheet.input("d_b", name, displacement, Length, run);
            work.sheet.input("γ_x", "magnification of the displacement", factor, Dimensionless, &clause);
            work.sheet.input("d_R", "displacement they have room for", capacity, Length, CAPACITY);
            let name = "displacement to be provided for";
            let demand = work.sheet.calc("d_x", name, "γ_x·d_b", Length, &clause);
            let note = format!("{} times the largest displacement of the run", number(factor));
            let check = ISOLATORS.check().of(demand, capacity, &clause, &note);
            let peak = found.displacement;
            work.checks.push(check.at(Some(peak.time), None, Some(peak.theta)));
        }
    }
    let Some(share) = found.bearing_share else { return };
    let clause = work.clause(TENSION.id);
    let name = "smallest force of the outermost bearing over that at rest";
    work.sheet.input("n_b", name, share.value, Dimensionless, run);
    let name = "part of its force at rest that the bearing loses";
    let lost = work.sheet.calc("n_l", name, "1 − n_b", Dimensionless, &clause);
    let note = "bearings of equal load under the whole plan; beyond 1 the outermost one is in tension";
    let check = TENSION.check().of(lost, 1.0, &clause, note);
    work.checks.push(check.at(Some(share.time), None, Some(share.theta)));
}

/// Takes the worse of each pair of checks.
///
/// * `factor`: that of the properties of the others
pub(super) fn take_worse(checks: &mut [Check], others: Vec<Check>, factor: f64) {
    for other in others {
        let Some(own) = checks.iter_mut().find(|own| own.id == other.id) else { continue };
        let worse = (other.status, own.ratio().unwrap_or(0.0)) < (own.status, other.ratio().unwrap_or(0.0));
        if !worse {
            continue;
        }
        let with = format!("with the properties of the isolators times {}", number(factor));
        let text = if other.compared() { &other.note } else { &other.reason };
        let text = if text.is_empty() { with } else { format!("{with}: {text}") };
        *own = if other.compared() { Check { note: text, ..other } } else { Check { reason: text, ..other } };
    }
}
