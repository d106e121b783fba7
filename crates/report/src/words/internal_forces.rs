//! Internal forces at stations of the wall.

use results::channel::OnWall;
use tank::units::Dimension;

use crate::number::{fixed, significant, with_unit};

/// Head of the column of parts.
pub const PART: &str = "Part";
/// The seismic part.
pub const SEISMIC: &str = "largest seismic";

/// Symbol of an internal force.
pub fn symbol(what: OnWall) -> &'static str {
    match what {
        OnWall::AxialForce => "n_s",
        OnWall::HoopForce => "n_θ",
        OnWall::Shear => "n_sθ",
        OnWall::Moment => "m_s",
        OnWall::HoopMoment => "m_θ",
        OnWall::Twist => "m_sθ",
        other => other.title(),
    }
}

/// Title of the figure of forces (or moments) at z [m] and θ [°], and of its axis.
pub fn figure(forces: bool, (z, degrees): (f64, f64)) -> [String; 2] {
    let what = if forces { "Membrane forces" } else { "Bending and twisting moments" };
    [format!("{what} at z = {} m, θ = {}°", fixed(z, 3), significant(degrees, 5)), what.to_owned()]
}

/// Description of a figure: title, the largest value, the end [s].
pub fn description(title: &str, dimension: Dimension, largest: f64, end: f64) -> String {
    format!("{title} over {} s, seismic part; the largest is {}.", fixed(end, 1), with_unit(largest, dimension))
}

/// Stations that are listed and not drawn; empty without any.
pub fn undrawn(count: usize) -> String {
    match count {
        0 => String::new(),
        1 => "1 further station is listed, not drawn.".into(),
        count => format!("{count} further stations are listed, not drawn."),
    }
}
