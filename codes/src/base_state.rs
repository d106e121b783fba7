//! What the base of a tank does under the actions of a method: one state, which all checks of the method ask.
//!
//! | state | compression of the wall | pipes | bearing of the ground |
//! |---|---|---|---|
//! | bears | of a wall held down | no uplift | rigid base |
//! | lifts | of the model of uplift | its uplift | rigid base, and force of its toe |
//! | not known | open, unless it fails | open | open, unless it fails |
//!
//! The base of a tank on anchors bears while they hold; anchors that are not given are a gap of their own. The displacement of the pipes of
//! a tank that slides is not known either.

use tank::assessment::{Check, CheckStatus};

/// Limit states of the tension of anchors, of procedures and engines.
const ANCHORAGE: [&str; 2] = ["anchorage", "anchor_tension"];
/// Limit states of the compression of a wall.
const COMPRESSED: [&str; 5] =
    ["buckling_elastic", "buckling_elastic_plastic", "shell_compression", "upper_compression", "equivalent_stress"];
/// Why the base of a tank on anchors is not known.
const LIFTS_OFF: &str =
    "its anchors are overstressed: the wall lifts, and its compression grows beyond that of a wall held down";
/// Why the displacement of pipes is not known.
const SLIDES: &str = "the tank slides: how far is not known, nor the displacement of its pipes";
/// Limit state of the ground under it.
const BEARING: &str = "bearing";
/// Limit states of pipes.
const PIPES: [&str; 2] = ["pipes", "piping"];
/// Limit state of sliding.
const SLIDING: &str = "sliding";

/// What the base does.
#[derive(Clone, Debug, PartialEq)]
pub(crate) enum BaseState {
    /// All of the rim bears.
    Bears,
    /// A part of the rim lifts.
    Lifts(Lift),
    /// Not known, for this reason.
    Unknown(String),
}

/// A base that lifts.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Lift {
    /// Largest uplift of the rim [m].
    pub(crate) uplift: f64,
    /// Largest compression at the toe [N/m].
    pub(crate) toe: f64,
}

impl BaseState {
    /// State of a tank on anchors, whose check decides.
    pub(crate) fn on_anchors(checks: &[Check]) -> BaseState {
        match checks.iter().any(|check| fails(check, &ANCHORAGE)) {
            true => BaseState::Unknown(LIFTS_OFF.into()),
            false => BaseState::Bears,
        }
    }

    /// Largest uplift [m], or why it is not known.
    pub(crate) fn uplift(&self) -> Result<f64, &str> {
        match self {
            BaseState::Bears => Ok(0.0),
            BaseState::Lifts(lift) => Ok(lift.uplift),
            BaseState::Unknown(reason) => Err(reason),
        }
    }

    /// Leaves open what the state does not let hold; such checks keep their numbers.
    pub(crate) fn follow(&self, checks: &mut [Check]) {
        if let BaseState::Unknown(reason) = self {
            leave_open(checks, &COMPRESSED, reason);
            leave_open(checks, &[BEARING], reason);
        }
        if checks.iter().any(|check| fails(check, &[SLIDING])) {
            leave_open(checks, &PIPES, SLIDES);
        }
    }
}

/// Where anchors fail, the compression of a wall that is held down does not hold, nor the bearing of its ground.
///
/// * `checks`: of an engine that holds the wall down
pub fn overstressed(checks: &mut [Check]) {
    BaseState::on_anchors(checks).follow(checks);
}

fn fails(check: &Check, states: &[&str]) -> bool {
    states.contains(&check.limit_state.as_str()) && check.status == CheckStatus::Fails
}

/// Leaves open what holds of these limit states; such checks keep their numbers.
pub(crate) fn leave_open(checks: &mut [Check], states: &[&str], reason: &str) {
    let held = checks.iter_mut().filter(|check| check.holds());
    for check in held.filter(|check| states.contains(&check.limit_state.as_str())) {
        check.status = CheckStatus::NotChecked;
        check.within_error = false;
        reason.clone_into(&mut check.reason);
    }
}
