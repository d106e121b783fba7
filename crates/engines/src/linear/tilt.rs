//! Static tilt test: a tank at rest on a base that is tilted by the angle α, with its liquid.
//!
//! In axes of the tank gravity has g cos α along the axis and g sin α across it. The part along the axis makes the static state and the
//! weight of the surface, that of a tank under the gravity g cos α; the part across it is an inertia force that does not change in time,
//!
//! ```text
//! a = −g sin α        K x = −M ι a        ẍ_total = ι a        θ = 0 is the low side
//! ```
//!
//! so that every observation y = d·x + c·ẍ_total + b a of the seismic analysis is one of the tilt test. The liquid follows exactly: its
//! pressure on the wall changes by ρ g sin α R cos θ at every depth, its surface stays level, η = x tan α. The linear theory leaves out that
//! the wall is wetted higher on one side than on the other.
//!
//! Source: Manos and Clough 1982 tilted tanks to measure buckling under known loads; statics.

use fem::linalg::{Cholesky, dot};
use results::channel::OnWall;
use results::{Channel, Tilt, TiltLine};
use tank::Case;

use crate::FeError;
use crate::coupled::Coupled;
use crate::error::failure;
use crate::probe::{Probe, ProbeLine};

/// The tilt test of a case by an engine.
///
/// * `angle`: α [rad]
/// * `build`: the engine's system of harmonic 1 of a case
///
/// Errors: those of `build`; a stiffness matrix that is not positive definite.
pub(crate) fn tilt(
    case: &Case,
    angle: f64,
    build: impl FnOnce(&Case) -> Result<Coupled, FeError>,
) -> Result<Tilt, FeError> {
    let tilted = Case {
        gravity: case.gravity * angle.cos(),
        ..case.clone()
    };
    let coupled = build(&tilted)?;
    let across = Across::new(&coupled, -case.gravity * angle.sin())?;
    let on_base = |channel| coupled.probe(channel).map_or(0.0, |probe| -across.value(probe));
    Ok(Tilt {
        angle,
        base_shear: on_base(Channel::BaseShear),
        base_moment: on_base(Channel::BaseMoment),
        overturning_moment: on_base(Channel::OverturningMoment),
        r: coupled.shape_rows.r.clone(),
        surface: coupled
            .shape_rows
            .surface
            .iter()
            .map(|row| row.iter().map(|&(i, c)| c * across.x[i]).sum())
            .collect(),
        lines: coupled.lines.iter().map(|line| across.line(line)).collect(),
        notes: notes(case, angle),
    })
}

/// The state under an acceleration that does not change.
struct Across<'a> {
    coupled: &'a Coupled,
    /// Acceleration of the ground [m/s²].
    acceleration: f64,
    /// Unknowns relative to the ground.
    x: Vec<f64>,
}

impl<'a> Across<'a> {
    fn new(coupled: &'a Coupled, acceleration: f64) -> Result<Across<'a>, FeError> {
        let mut x = Cholesky::factor(&coupled.stiffness)
            .map_err(failure("the coupled stiffness matrix"))?
            .solve_vector(&coupled.mass.times(&coupled.influence));
        x.iter_mut().for_each(|x| *x *= -acceleration);
        Ok(Across {
            coupled,
            acceleration,
            x,
        })
    }

    /// An observation without its static part.
    fn value(&self, probe: &Probe) -> f64 {
        // An empty vector stands for zeros.
        let product = |row: &[f64], x: &[f64]| if row.is_empty() { 0.0 } else { dot(row, x) };
        let inertia = product(&probe.absolute_acceleration, &self.coupled.influence) + probe.ground_acceleration;
        product(&probe.displacement, &self.x) + inertia * self.acceleration
    }

    fn line(&self, line: &ProbeLine) -> TiltLine {
        let whole = |sign: f64| {
            line.probes
                .iter()
                .map(|p| p.static_value + sign * self.value(p))
                .collect()
        };
        TiltLine {
            id: line.what.id().into(),
            title: title(line.what).into(),
            dimension: line.what.dimension(),
            z: line.z.clone(),
            low: whole(1.0),
            high: whole(-1.0),
        }
    }
}

/// The pressure is the whole one here.
fn title(what: OnWall) -> &'static str {
    match what {
        OnWall::Pressure => "Pressure on the wall",
        other => other.title(),
    }
}

/// Where the tilt leaves linear theory.
fn notes(case: &Case, angle: f64) -> Vec<String> {
    let rise = case.tank.shape.half_length() * angle.tan();
    let degrees = angle.to_degrees();
    let mut notes = Vec::new();
    if rise > case.freeboard() {
        notes.push(format!(
            "Tilted by {degrees:.1}° the surface rises by {rise:.2} m at the wall, above the freeboard of {:.2} m: the liquid overtops or \
             presses on the roof, which the tilt test does not model.",
            case.freeboard()
        ));
    }
    if rise > case.liquid.fill_height {
        notes.push(format!(
            "Tilted by {degrees:.1}° the liquid leaves a part of the bottom dry, which the tilt test does not model."
        ));
    }
    if rise > 0.2 * case.tank.shape.half_length() {
        notes.push(format!(
            "Tilted by {degrees:.1}° the wetted part of the wall changes by {rise:.2} m on both sides, which the linear tilt test leaves \
             out."
        ));
    }
    notes
}

#[cfg(test)]
mod tests;
