//! Static tilt test.

use serde::{Deserialize, Serialize};
use tank::units::Dimension;

/// A tank at rest on a tilted base; θ = 0 is the low side.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Tilt {
    /// Angle of the base [rad].
    pub angle: f64,
    /// Force along the base, towards the low side [N].
    pub base_shear: f64,
    /// Moment above the base plate [N·m].
    pub base_moment: f64,
    /// Moment below the base plate, without that of the weight along the axis at rest [N·m].
    pub overturning_moment: f64,
    /// Radii (or x from the centre) of the surface [m].
    pub r: Vec<f64>,
    /// Rise of the surface in axes of the tank, towards the low side [m].
    pub surface: Vec<f64>,
    /// Values over the height.
    pub lines: Vec<TiltLine>,
    /// Where the tilt leaves linear theory, one sentence each.
    pub notes: Vec<String>,
}

/// A quantity over the height of a tilted tank, weight and hydrostatic pressure contained.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct TiltLine {
    /// Id: `pressure`, `hoop_stress`, `axial_membrane_stress`, `bending_stress`, `radial_displacement`.
    pub id: String,
    /// Title.
    pub title: String,
    /// Dimension.
    pub dimension: Dimension,
    /// Heights [m], ascending.
    pub z: Vec<f64>,
    /// At θ = 0, the low side.
    pub low: Vec<f64>,
    /// At θ = 180°.
    pub high: Vec<f64>,
}
