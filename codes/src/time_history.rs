//! Demands of a finite-element engine under the record against the capacities of the codes.
//!
//! Static and seismic parts act together, at every instant and around the circumference: the hoop stress or interior pressure that a
//! capacity depends on is that of the same instant and place. Nothing is reduced by a behaviour factor.
//!
//! | limit state | demand | capacity |
//! |---|---|---|
//! | freeboard | largest rise of the surface | height of the wall above the liquid |
//! | hoop stress | σ_θ | f_y; min(1.33 S_d e, 0.9 F_y e) |
//! | equivalent stress | √(σ_θ² + σ_z² − σ_θ σ_z + 3 τ²), membrane | f_y |
//! | with bending at the base | range of the same on a face | 2 f_y |
//! | compression | −σ_z | EN 1998-4 A.10.2 and A.10.3, API 650 E.6.2.2.3 |
//! | anchors | pull × spacing | given capacity |
//! | uplift | plastic rotation of the joint of the bottom plate | 0.20 rad |
//! | sliding | base shear | μ M (g + a_v) |
//! | bearing | pressure of M′ and M (g + a_v) under a rigid base | given resistance |
//! | displacement of isolators | γ_x d | given capacity |
//! | tension of bearings | 1 − N/N_0 | 1 |
//!
//! Uplift is judged where the engine lets the base lift ([`tank::demand::FreeBase`]); the shear of a tank that slides is then that of the tank
//! held in place. Where runs of such a base that should agree do not, or the pressure of the motion exceeds what its strips hold, nothing but the wave may hold. The wall does not lift in an engine that clamps it, and the walls of a box are cantilevers in one without plates. Where an unanchored
//! wall pulls, or such a box is too narrow for that ([`tank::PLANE_WALLS`]), every demand but the wave is outside the model: nothing may hold there
//! ([`Findings::outside`]). The same is true of a base that moves further than the engine follows ([`tank::demand::Footing::Beyond`]); only
//! its anchors then have a demand.
//!
//! Capacities are those of the codes that count, which are known by [`Code`] alone. `docs/theory/limit-states-of-runs.md` has the details.

mod anchors;
mod base;
mod bearing;
mod field;
mod isolators;
pub(crate) mod limit_states;
mod lists;
mod ready;
mod search;
mod surface;
#[cfg(test)]
mod tests;
mod wall;
mod work;

use std::collections::BTreeMap;

use tank::Support;
use tank::assessment::{Check, CheckStatus, CourseHoop, Requirement, Step};
use tank::case::Case;
use tank::demand::{Angles, Demands, Footing};
use tank::outside::Outside;
use tank::units::{Dimension, display};

use crate::CODES;
use crate::sheet::Sheet;
use limit_states::{ANCHORS, FREEBOARD, OTHER_WALL, PLATES, ROOF};
use work::Work;

pub(crate) use lists::tables;
pub use lists::{Judges, counted, ground_motion, limit_states, snow_share, without_code};
pub use ready::Ready;

/// What the demands of a run amount to.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Findings {
    /// Checks of all limit states.
    pub checks: Vec<Check>,
    /// Calculation lines.
    pub steps: Vec<Step>,
    /// Hoop stresses course by course, against the limit that is used most; empty where the run is outside its model.
    pub courses: Vec<CourseHoop>,
    /// Remarks, one sentence each.
    pub notes: Vec<String>,
    /// Why the run is outside its model.
    pub outside: Option<Outside>,
}

/// The demands of a run against the capacities of codes.
///
/// * `errors`: relative mesh errors of the run by quantity id
pub fn assess(case: &Case, judges: &Judges, demands: &Demands, errors: &BTreeMap<String, f64>) -> Findings {
    assess_at(case, judges, (&Ready::new(case, demands), 1.0), errors)
}

/// The demands of a linear run under its record times a positive factor against the capacities of codes: the motion grows, the static
/// state stays. A run of another model has no factor but 1. On isolators each check is the worst of their properties; lines are those of
/// nominal ones.
///
/// * `errors`: relative mesh errors of the run by quantity id
pub fn assess_at(
    case: &Case,
    judges: &Judges,
    (ready, factor): (&Ready<'_>, f64),
    errors: &BTreeMap<String, f64>,
) -> Findings {
    let mut found = of_demands(case, judges, (ready, factor), errors);
    for (scale, bound) in &ready.bounds {
        let other = of_demands(case, judges, (bound, factor), errors);
        isolators::take_worse(&mut found.checks, other.checks, *scale);
    }
    found
}

/// The same of one run.
fn of_demands(
    case: &Case,
    judges: &Judges,
    (ready, factor): (&Ready<'_>, f64),
    errors: &BTreeMap<String, f64>,
) -> Findings {
    let states = limit_states(case, judges);
    let demands = ready.demands;
    let mut work = Work::new((case, &judges.codes), (ready, factor), errors, &states);
    surface::assess(&mut work);
    let mut pulls = None;
    if let Some(radius) = case.tank.shape.radius().filter(|_| !demands.places.is_empty()) {
        if case.tank.is_metal() {
            wall::assess(&mut work, radius);
        }
        pulls = base::tension(&mut work, radius);
    }
    base::sliding(&mut work);
    bearing::assess(&mut work);
    isolators::assess(&mut work);
    let outside = outside(&mut work, pulls);
    if let Some((why, reason)) = &outside {
        leave(&mut work, *why, reason);
    }
    if demands.base.as_ref().is_some_and(|base| base.scatters) {
        open(&mut work, SCATTERS);
    }
    if demands.base.as_ref().is_some_and(|base| base.softened) {
        open(&mut work, SOFTENED);
    }
    if demands.base.as_ref().is_some_and(|base| base.broken > 0) {
        open(&mut work, BROKEN);
    }
    if judges.alone {
        anchors::layout(&mut work);
        let apart = judges.codes.iter().flat_map(|code| code.apart(case));
        work.checks.extend(apart);
    }
    notes(&mut work);
    for state in &states {
        let checked = work.checks.iter().any(|check| check.limit_state == state.id);
        if !checked && state.requirement == Requirement::Required {
            let reason = "the engine does not give the demand";
            work.checks.push(Check::without_comparison(state, CheckStatus::NotChecked, reason, None));
        }
    }
    let Work { sheet, checks, notes, courses, .. } = work;
    let courses = if outside.is_some() { Vec::new() } else { courses };
    Findings { steps: steps(sheet), checks, notes, courses, outside: outside.map(|(why, _)| why) }
}

/// The lines; none if a formula is faulty, which the tests exclude.
fn steps(sheet: Sheet) -> Vec<Step> {
    sheet.into_steps().unwrap_or_default()
}

/// Why the run is outside its model, with the reason of the checks that cannot hold.
///
/// * `pulls`: where an unanchored wall pulls, in words
fn outside(work: &mut Work<'_>, pulls: Option<String>) -> Option<(Outside, String)> {
    if let Footing::Beyond { reason, .. } = &work.demands.footing {
        return Some((Outside::Uplift, beyond(reason)));
    }
    if let Some(pulls) = pulls {
        let reason = format!(
            "{pulls} and the tank is unanchored: the wall lifts off, which the engine does not model; its forces and stresses are \
             outside the model"
        );
        return Some((Outside::Uplift, reason));
    }
    let tank = &work.case.tank;
    let ratio = tank.breadth_to_height()?;
    if work.demands.plates {
        let reason = "the engine models the four walls as plates";
        work.without(PLATES.id, CheckStatus::NotApplicable, reason, None);
        return None;
    }
    let (breadth, limit) = (format!("{ratio:.2} heights of the wall broad"), tank::PLANE_WALLS);
    if !tank.bends_as_plates() {
        let reason = format!("the box is {breadth}, at least {limit:.0}: its walls across the shaking are cantilevers");
        work.without(PLATES.id, CheckStatus::NotApplicable, &reason, None);
        return None;
    }
    let height = display(tank.wall_height(), Dimension::Length);
    let reason = format!(
        "the box is {breadth} ({height}), less than {limit:.0}: its walls bend as plates held at the base and both sides, and the engine \
         computes cantilevers; its impulsive period, forces and stresses are outside the model"
    );
    Some((Outside::Plates, reason))
}

/// Why nothing holds under a base that rocks differently each time.
const SCATTERS: &str = "the rocking base does not repeat: motions 0.1 % apart or half the time step give other peaks, and the demand is one draw of many";

/// Why nothing holds where the motion takes too much of the pressure at rest from the bottom.
const SOFTENED: &str = "the pressure of the motion on the bottom exceeds that up to which strips of the bottom plate hold: their moment, lift and toe stress are wrong; the nonlinear engine (`--fe nonlinear`) has shells";

/// Why nothing holds where anchors break.
const BROKEN: &str = "anchors break: the engine holds the tank in place along the ground all the same, and does not follow one that slides";

/// A check that holds is not checked, and keeps its numbers.
fn leave_open(check: &mut Check, reason: &str) {
    if check.holds() {
        check.status = CheckStatus::NotChecked;
        check.within_error = false;
        reason.clone_into(&mut check.reason);
    }
}

/// Checks of what depends on the wall and its base; the wave hardly does.
fn of_wall<'c>(work: &'c mut Work<'_>) -> impl Iterator<Item = &'c mut Check> {
    let depends = |check: &&mut Check| ![FREEBOARD.id, ROOF.id, OTHER_WALL.id].contains(&check.limit_state.as_str());
    work.checks.iter_mut().filter(depends)
}

/// Nothing that depends on the wall may hold.
fn open(work: &mut Work<'_>, reason: &str) {
    for check in of_wall(work) {
        leave_open(check, reason);
    }
}

/// Why a wall that moves further than the engine follows has no demands.
///
/// * `reason`: a clause
fn beyond(reason: &str) -> String {
    format!(
        "uplift cannot be computed: {reason}; forces and stresses of the engine are those of a wall that is held down, outside the model"
    )
}

/// A wall held down has no demands of one that moves further than the engine follows. Its anchors have: they are judged as if elastic.
fn withdraw(work: &mut Work<'_>, reason: &str) {
    for check in of_wall(work).filter(|check| check.compared() && check.limit_state != ANCHORS.id) {
        *check = check.left_open(reason.to_owned());
    }
}

/// Nothing that depends on what the engine leaves out may hold.
fn leave(work: &mut Work<'_>, why: Outside, reason: &str) {
    if matches!(work.demands.footing, Footing::Beyond { .. }) {
        withdraw(work, reason);
    }
    open(work, reason);
    for check in of_wall(work).filter(|check| check.status == CheckStatus::Fails) {
        check.note = format!("outside the model: {}", check.note);
    }
    work.without(why.limit_state(), CheckStatus::NotChecked, reason, None);
    // Before all that follows from it.
    work.checks.rotate_right(1);
}

/// What the checks are, and what the codes ask of such an analysis.
fn notes(work: &mut Work<'_>) {
    let case = work.case;
    work.notes.push(
        "Limit states under the record: static and seismic demands of the same instant and place, unreduced: no behaviour \
         factor, and no importance factor beside the scaling of the record."
            .into(),
    );
    for code in work.codes {
        work.notes.extend(code.notes(case));
    }
    if !work.ready.bounds.is_empty() {
        work.notes.push(
            "Every limit state is the worst of nominal, lower and upper properties of the isolators; where it is not that of nominal ones, the check says so, and calculation lines are those of nominal ones."
                .into(),
        );
    }
    if work.demands.angles == Angles::Sides {
        work.notes
            .push("The histories of this engine are known at θ = 0 and 180°; between them nothing is checked.".into());
    }
    if case.tank.support == Support::Anchored
        && work.demands.vertical.is_none()
        && CODES.iter().any(|code| code.asks_vertical(&case.site))
    {
        work.notes
            .push("No vertical record is given: the limit states under the record are without vertical motion.".into());
    }
}
