//! Parts of a tank of which its file says nothing, or says that there are none.
//!
//! | part | open while nothing is said of it |
//! |---|---|
//! | roof | what its weight presses, what its mass overturns, the freeboard under it |
//! | foundation | bearing, and overturning on it |
//! | bottom of an unanchored tank | overturning and uplift |
//! | anchors, pipes | their own limit states, whose input is missing anyhow |
//!
//! A tank without pipes has no limit state of pipes. Studies, whose rows are numbers, leave nothing open.

use codes::meaning;
use tank::Support;
use tank::assessment::{Check, CheckStatus, LimitState, Requirement};
use tank::check::TankPart;

use crate::job::Job;

/// A check that takes bare ground for a foundation of which nothing is said: it does not fail by that either.
const ON_BARE_GROUND: &str = "bearing_toe";
/// What a tank without a foundation stands on.
const ON_THE_GROUND: &str = "the tank has no foundation: it stands on the ground, neither on a ring wall nor on a slab";
/// Limit states of pipes.
const PIPES: [&str; 2] = ["pipes", "piping"];

/// A tank without pipes has none to check, and one without a foundation stands on the ground.
pub(super) fn without(job: &Job, states: &mut [LimitState]) {
    let without = &job.decision.without;
    for state in states {
        if without.contains(&TankPart::Pipes) && PIPES.contains(&state.id) {
            state.requirement = Requirement::NotApplicable("the tank has no pipes".into());
        }
        let asks = state.requirement == Requirement::Missing("tank.foundation".into());
        if without.contains(&TankPart::Foundation) && asks {
            state.requirement = Requirement::NotApplicable(ON_THE_GROUND.into());
        }
    }
}

/// Whether a check is open for want of a part of which the file says that there is none.
fn denied(check: &Check, part: TankPart) -> bool {
    let path = format!("tank.{}", part.key());
    let of = |input: &String| *input == path || input.strip_prefix(&path).is_some_and(|rest| rest.starts_with('.'));
    check.status == CheckStatus::NotChecked && check.input.as_ref().is_some_and(of)
}

/// The same checks; those that want for a part which the file denies say so, in place of "is missing".
pub(super) fn contradicted(job: &Job, mut checks: Vec<Check>) -> Vec<Check> {
    let anchored = job.case.tank.support == Support::Anchored;
    for part in &job.decision.without {
        let key = part.key();
        for check in checks.iter_mut().filter(|check| denied(check, *part)) {
            check.reason = match part {
                TankPart::Anchors | TankPart::Foundation if anchored => {
                    format!("`tank.{key}` is \"none\", and `tank.support` is \"anchored\": they contradict each other")
                }
                _ => format!("`tank.{key}` is \"none\", and the clause is about one"),
            };
            check.input = Some(format!("tank.{key}"));
        }
    }
    checks
}

/// The checks without those of limit states that are not required of the tank.
pub(super) fn required(states: &[LimitState], checks: Vec<Check>) -> Vec<Check> {
    let spared = |check: &Check| {
        PIPES.contains(&check.limit_state.as_str())
            && states
                .iter()
                .any(|s| s.id == check.limit_state && matches!(s.requirement, Requirement::NotApplicable(_)))
    };
    checks.into_iter().filter(|check| !spared(check)).collect()
}

/// Leaves open what holds, or assumes bare ground, although it needs to know of a part of which nothing is said; such checks keep their numbers.
pub(super) fn leave_open(job: &Job, mut checks: Vec<Check>) -> Vec<Check> {
    let states = meaning::all();
    let needs =
        |id: &str, part: TankPart| states.iter().any(|(state, _)| state.id == id && state.needs.contains(&part));
    for part in [TankPart::Roof, TankPart::Foundation, TankPart::Bottom] {
        let needed = part != TankPart::Bottom || job.case.tank.support == Support::Unanchored;
        if !needed || !job.decision.unstated.contains(&part) {
            continue;
        }
        let held = (checks.iter_mut()).filter(|check| check.holds() || check.compared() && check.id == ON_BARE_GROUND);
        for check in held.filter(|check| needs(&check.limit_state, part)) {
            let key = part.key();
            check.status = CheckStatus::NotChecked;
            check.within_error = false;
            check.reason = format!("`tank.{key}` is not stated: describe it, or write \"{key}\": \"none\"");
            check.input = Some(format!("tank.{key}"));
        }
    }
    checks
}
