//! Limits of the model that a run of a wall has exceeded, and the parts of its moments at the base, for the results.

use fem::strip;

use results::nonlinear::{BaseMoment, Departure, DepartureKind, Passed};

/// A departure in the vocabulary of the results.
///
/// * `theta`: angle of the wall [rad]; none where only one of both is meant
pub(super) fn departure(found: &strip::Departure, theta: Option<f64>) -> Departure {
    Departure {
        kind: match found.kind {
            strip::DepartureKind::BarStrain => DepartureKind::BarStrain,
            strip::DepartureKind::MomentBalance => DepartureKind::MomentBalance,
            strip::DepartureKind::Acceleration => DepartureKind::Acceleration,
            strip::DepartureKind::StoredEnergy => DepartureKind::StoredEnergy,
        },
        time: found.time,
        theta,
        height: found.height,
        passed: Some(Passed {
            value: found.value,
            limit: found.limit,
        }),
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
