//! Numbers of a model, each with its kind: the report names them.

use serde::{Deserialize, Serialize};
use tank::units::Dimension;

/// A number of a model.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub struct Fact {
    /// Its kind.
    #[serde(rename = "id")]
    pub kind: FactKind,
    /// Value in SI.
    pub value: f64,
    /// Dimension.
    pub dimension: Dimension,
}

/// Kind of a number of a model.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "snake_case")]
pub enum FactKind {
    /// Elements over the height of a wall of a strip.
    ElementsOverWall,
    /// Fibres in a section of a wall.
    SectionFibres,
    /// Shell elements around a cylinder, or its half.
    ShellsAround,
    /// Shell elements over its height.
    ShellsOverHeight,
    /// Sloshing modes of the liquid.
    SloshingModes,
    /// Unknowns of the model.
    Unknowns,
    /// Circular frequency of the first sloshing mode [rad/s].
    FirstSloshing,
    /// Damping ratio of the first sloshing mode.
    SloshingDamping,
    /// Circular frequency of the first mode of wall and liquid [rad/s].
    FirstWall,
    /// Damping ratio of that mode.
    WallDamping,
    /// Longest time step [s].
    LongestStep,
    /// R/t of the lowest course.
    RadiusOverThickness,
    /// Elements over the height of a pushover.
    ElementsOverHeight,
    /// Elements around its half.
    ElementsAround,
    /// Height of the lowest element over √(R t).
    LowestElement,
    /// Smallest element along the circumference over √(R t).
    SmallestAround,
    /// Impulsive mass of the liquid [kg].
    ImpulsiveMass,
    /// Its height [m].
    ImpulsiveHeight,
    /// Mass of wall and roof [kg].
    WallAndRoofMass,
}

impl FactKind {
    /// Whether it is a damping ratio.
    pub fn is_damping(self) -> bool {
        matches!(self, FactKind::SloshingDamping | FactKind::WallDamping)
    }
}
