//! Limits of the model that a run of a wall has passed, and what its moments at the base are made of, for the results.

use fem::strip::{self, DepartureKind};
use tank::units::{Dimension, display, significant};

use results::nonlinear::{BaseMoment, Departure};

/// A departure in words; `wall`: name of the wall, empty where it is not told.
pub(super) fn departure(found: &strip::Departure, wall: &str) -> Departure {
    let percent = |share: f64| significant(100.0 * share, 3);
    let (id, reason) = match found.kind {
        DepartureKind::BarStrain => (
            "bar_strain",
            format!(
                "a bar is strained by {} %, its strain at rupture is {} %",
                percent(found.value),
                percent(found.limit)
            ),
        ),
        DepartureKind::MomentBalance => (
            "moment_balance",
            format!(
                "damping and inertia exert {} % of the moment of the section on the base, at most {} % are accepted",
                percent(found.value),
                percent(found.limit)
            ),
        ),
        DepartureKind::Acceleration => (
            "acceleration",
            format!(
                "the wall is accelerated by {} m/s², at most {} m/s² are accepted",
                significant(found.value, 3),
                significant(found.limit, 3)
            ),
        ),
        DepartureKind::StoredEnergy => (
            "stored_energy",
            format!(
                "the time integration gains energy where cracks close and open within a step: the wall stores {} per metre, at least \
                 {} is possible; a smaller spectral_radius or damping by group keeps it stable",
                display(found.value, Dimension::Energy),
                display(found.limit, Dimension::Energy)
            ),
        ),
    };
    let height = format!("z = {}", display(found.height, Dimension::Length));
    Departure {
        id: id.into(),
        time: found.time,
        place: match wall {
            "" => height,
            wall => format!("{wall}, {height}"),
        },
        reason,
    }
}

/// The moments at the base of a wall of this name.
pub(super) fn base_moment(found: &strip::BaseMoment, wall: &str, largest_section: f64) -> BaseMoment {
    BaseMoment {
        place: wall.into(),
        time: found.time,
        reaction: found.reaction,
        section: found.section,
        damping: found.damping,
        inertia: found.inertia,
        load: found.load,
        largest_section,
    }
}
