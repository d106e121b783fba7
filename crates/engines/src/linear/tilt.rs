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
use results::part::{Amount, Axis, Block, Chart, Form, Line, Look, Message, Room, Scale, Table};
use results::{Channel, Finding, Part};
use tank::Case;
use tank::units::Dimension;

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
) -> Result<Part, FeError> {
    let tilted = Case { gravity: case.gravity * angle.cos(), ..case.clone() };
    let coupled = build(&tilted)?;
    let across = Across::new(&coupled, -case.gravity * angle.sin())?;
    let on_base = |id, channel: Channel| {
        let value = coupled.probe(channel).map_or(0.0, |probe| -across.value(probe));
        Finding::new(id, value, channel.dimension())
    };
    let rows = coupled.shape_rows.r.iter().zip(&coupled.shape_rows.surface);
    let surface: Vec<[f64; 2]> = rows.map(|(r, row)| [*r, row.iter().map(|&(i, c)| c * across.x[i]).sum()]).collect();
    let rise = surface.iter().fold(0.0, |most: f64, point| most.max(point[1].abs()));
    let resultants = vec![
        Finding { form: Form::Degrees(2), ..Finding::new("angle", angle, Dimension::Angle) },
        on_base("base_shear", Channel::BaseShear),
        on_base("base_moment", Channel::BaseMoment),
        on_base("overturning_moment", Channel::OverturningMoment),
        Finding::new("rise", rise, Dimension::Length),
    ];
    let columns = ["r", "rise"].map(|id| (id, Dimension::Length, Form::Usual));
    let surface = surface.iter().map(|point| point.map(Into::into).to_vec()).collect();
    let mut blocks = vec![Block::Note(Message::new("tilt-rest")), Block::values("resultants", resultants)];
    blocks.extend(remarks(case, angle).into_iter().map(Block::Text));
    blocks.push(Block::Note(Message::new("tilt-over-height")));
    let height = case.tank.wall_height();
    let drawn = coupled.lines.iter().filter(|line| line.z.len() > 1);
    blocks.extend(drawn.map(|line| Block::Chart(across.chart(line, height))));
    blocks.push(Block::Series(Table::new("surface", &columns, surface)));
    Ok(Part { id: "tilt".into(), blocks })
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
        Ok(Across { coupled, acceleration, x })
    }

    /// An observation without its static part.
    fn value(&self, probe: &Probe) -> f64 {
        // An empty vector stands for zeros.
        let product = |row: &[f64], x: &[f64]| if row.is_empty() { 0.0 } else { dot(row, x) };
        let inertia = product(&probe.absolute_acceleration, &self.coupled.influence) + probe.ground_acceleration;
        product(&probe.displacement, &self.x) + inertia * self.acceleration
    }

    /// Both sides of the tank over its height.
    fn chart(&self, line: &ProbeLine, height: f64) -> Chart {
        let side = |sign: f64| {
            let points = line.probes.iter().zip(&line.z);
            points.map(|(p, z)| [p.static_value + sign * self.value(p), *z]).collect()
        };
        let title = match line.what {
            // The whole one here.
            OnWall::Pressure => "tilt-on-wall-pressure".to_owned(),
            other => format!("on-wall-{}", other.id()),
        };
        let lines = vec![Line::new("low", Look::Main, side(1.0)), Line::new("high", Look::Other, side(-1.0))];
        let x = Axis::new(&title, line.what.dimension(), Scale::Zero);
        let y = Axis::new("height", Dimension::Length, Scale::Range([0.0, height]));
        Chart {
            title: Some(Message::new("tilt-chart").with("of", Message::new(&title))),
            room: Room::Tall,
            ..Chart::new(line.what.id(), x, y, lines)
        }
    }
}

/// Where the tilt leaves linear theory.
fn remarks(case: &Case, angle: f64) -> Vec<Message> {
    let rise = case.tank.shape.half_length() * angle.tan();
    let remark = |id: &str| {
        let degrees = Amount::new(angle, Dimension::Angle).form(Form::Degrees(1));
        Message::new(id).with("angle", degrees).with("rise", Amount::new(rise, Dimension::Length))
    };
    let overtops = (rise > case.freeboard()).then(|| {
        let freeboard = Amount::new(case.freeboard(), Dimension::Length);
        remark("tilt-overtops").with("freeboard", freeboard)
    });
    let dry = (rise > case.liquid.fill_height).then(|| remark("tilt-dry"));
    let wetted = (rise > 0.2 * case.tank.shape.half_length()).then(|| remark("tilt-wetted"));
    overtops.into_iter().chain(dry).chain(wetted).collect()
}

#[cfg(test)]
mod tests;
