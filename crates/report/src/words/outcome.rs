//! How a nonlinear run ended.

use tank::units::{Dimension, display, significant};

use crate::number::{fixed, percent};
use results::nonlinear::{Departure, DepartureKind, Passed};

/// Meaning of the numbers of a run that ended early.
pub const BOUNDS: &str = "Values, figures and histories end there; they are lower bounds of the demand.";
/// Meaning of the numbers of a stopped run.
pub const UNTIL_THEN: &str = "Values, figures and histories end there.";
/// Headline of a whole run.
pub const COMPLETED: &str = "Equilibrium was found to the end of the ground motion";
/// Guarantee of a whole run.
pub const CONVERGED: &str = "Every accepted step has converged.";
/// Remark on a run that left its model and continued.
pub const BEYOND_MODEL: &str = "Equilibrium was found to the end of the ground motion, but not within the limits of the model: later \
                                values are not results.";

/// Headline of a run that left its model at a time [s]; `stopped` there, or continued.
pub fn left_model(time: f64, stopped: bool) -> String {
    match stopped {
        true => format!("Stopped: the run left its model at t = {} s", fixed(time, 3)),
        false => format!("The run left its model at t = {} s", fixed(time, 3)),
    }
}

/// Why a run was stopped, and where.
pub fn stopped(departure: &Departure) -> String {
    format!("{}: {}.", super::capital(&place(departure)), passed(departure))
}

/// Headline of an interrupted run, at a time [s].
pub fn interrupted(time: f64) -> String {
    format!("Interrupted at t = {} s", fixed(time, 2))
}

/// Headline of a collapse: the time of the last equilibrium [s], negative where there is none.
pub fn collapse(time: f64) -> String {
    match time < 0.0 {
        true => "Collapse: the wall does not carry weight and static pressure".into(),
        false => format!("Collapse: no equilibrium after t = {} s", fixed(time, 3)),
    }
}

/// Carried part of weight and static pressure.
pub fn carried(factor: f64) -> String {
    format!("The wall carries {} of weight and static pressure; the ground motion was not applied.", percent(factor))
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
    format!("After {} s, {}: {}.", fixed(departure.time, 3), place(departure), passed(departure))
}

/// A departure at which a run was stopped, as a remark on the calculation.
pub fn stopped_remark(departure: &Departure) -> String {
    format!(
        "The run left its model after {:.3} s ({}): {}. All values end there.",
        departure.time,
        place(departure),
        passed(departure)
    )
}

/// A departure as a remark on the calculation.
pub fn remark(departure: &Departure) -> String {
    format!(
        "The run leaves the limits of its model at {:.3} s ({}): {}.",
        departure.time,
        place(departure),
        passed(departure)
    )
}

/// Where a limit was passed: `wall at θ = 0°, z = 12.0 mm`.
pub fn place(departure: &Departure) -> String {
    let height = format!("z = {}", display(departure.height, Dimension::Length));
    match departure.theta {
        None => height,
        Some(theta) => format!("wall at θ = {}°, {height}", significant(theta.to_degrees(), 3)),
    }
}

/// Value and limit, a sentence without capital and full stop.
pub fn passed(departure: &Departure) -> String {
    let Some(Passed { value, limit }) = departure.passed else {
        return match departure.kind {
            DepartureKind::BarStrain => "a bar is strained beyond its strain at rupture",
            DepartureKind::MomentBalance => "damping and inertia exert too large a part of the moment on the base",
            DepartureKind::Acceleration => "the wall is accelerated too much",
            DepartureKind::StoredEnergy => "the time integration gains energy",
        }
        .into();
    };
    let percent = |share: f64| significant(100.0 * share, 3);
    match departure.kind {
        DepartureKind::BarStrain => {
            format!("a bar is strained by {} %, its strain at rupture is {} %", percent(value), percent(limit))
        }
        DepartureKind::MomentBalance => format!(
            "damping and inertia exert {} % of the moment of the section on the base, at most {} % are accepted",
            percent(value),
            percent(limit)
        ),
        DepartureKind::Acceleration => format!(
            "the wall is accelerated by {} m/s², at most {} m/s² are accepted",
            significant(value, 3),
            significant(limit, 3)
        ),
        DepartureKind::StoredEnergy => format!(
            "the time integration gains energy where cracks close and open within a step: the wall stores {} per metre, at least {} \
             is possible; a smaller spectral_radius or damping by group keeps it stable",
            display(value, Dimension::Energy),
            display(limit, Dimension::Energy)
        ),
    }
}
