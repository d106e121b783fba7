//! How a nonlinear run ended.

use crate::number::{fixed, percent};
use results::nonlinear::Departure;

/// What the numbers of a run are worth that ended early.
pub const BOUNDS: &str =
    "Values, pictures and histories are those until then: lower bounds of what the ground motion asks of the tank.";
/// What the numbers of a stopped run are.
pub const UNTIL_THEN: &str = "Values, pictures and histories are those until then.";
/// Headline of a whole run.
pub const COMPLETED: &str = "Equilibrium was found to the end of the ground motion";
/// What a whole run guarantees.
pub const CONVERGED: &str = "No step was accepted before it had converged.";
/// Headline of a run that the user stopped.
pub const INCOMPLETE: &str = "Incomplete";
/// What holds of a run that left its model and went on.
pub const BEYOND_MODEL: &str = "Equilibrium was found to the end of the ground motion, but not within the limits of the model: what comes \
                                later is no result.";

/// Headline of a run that left its model at a time [s]; `stopped` there, or went on.
pub fn left_model(time: f64, stopped: bool) -> String {
    match stopped {
        true => format!("Stopped: the run left its model at t = {} s", fixed(time, 3)),
        false => format!("The run left its model at t = {} s", fixed(time, 3)),
    }
}

/// Why a run was stopped, and where.
pub fn stopped(place: &str, reason: &str) -> String {
    format!("{}: {}.", super::capital(place), reason.trim_end_matches('.'))
}

/// Headline of an interrupted run, at a time [s].
pub fn interrupted(time: f64) -> String {
    format!("Interrupted at t = {} s", fixed(time, 2))
}

/// Headline of a collapse: the time of the last equilibrium [s], negative where there is none.
pub fn collapse(time: f64) -> String {
    match time < 0.0 {
        true => "Collapse: the wall does not carry weight and pressure at rest".into(),
        false => format!("Collapse: no equilibrium after t = {} s", fixed(time, 3)),
    }
}

/// Part of weight and pressure at rest that was carried.
pub fn carried(factor: f64) -> String {
    format!(
        "Of weight and pressure at rest it carries {}; the earthquake was not begun.",
        percent(factor)
    )
}

/// Where forces are furthest from equilibrium.
pub fn worst_place(place: &str) -> String {
    format!("Where forces are furthest from equilibrium: {place}.")
}

/// Why no equilibrium was found.
pub fn reason(reason: &str) -> String {
    format!("Reason: {}.", reason.trim_end_matches('.'))
}

/// A departure from the model.
pub fn departure(departure: &Departure) -> String {
    format!(
        "After {} s, {}: {}.",
        fixed(departure.time, 3),
        departure.place,
        departure.reason
    )
}
