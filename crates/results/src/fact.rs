//! Numbers of a model, each with its kind: the report names them.

use serde::{Deserialize, Serialize};
use tank::listed;
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

listed! {
    /// Kind of a number of a model.
    #[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
    #[serde(rename_all = "snake_case")]
    pub enum FactKind {
        /// Name of the number.
        name: &'static str,
    }
    /// Elements over the height of a wall of a strip.
    ElementsOverWall: "elements over a wall";
    /// Fibres in a section of a wall.
    SectionFibres: "fibres in a section";
    /// Shell elements around a cylinder, or its half.
    ShellsAround: "shells around";
    /// Shell elements over its height.
    ShellsOverHeight: "shells over the height";
    /// Sloshing modes of the liquid.
    SloshingModes: "sloshing modes of the liquid";
    /// Unknowns of the model.
    Unknowns: "unknowns";
    /// Circular frequency of the first sloshing mode [rad/s].
    FirstSloshing: "first sloshing mode";
    /// Damping ratio of the first sloshing mode.
    SloshingDamping: "damping of the first sloshing mode";
    /// Circular frequency of the first mode of wall and liquid [rad/s].
    FirstWall: "first mode of wall and liquid";
    /// Damping ratio of that mode.
    WallDamping: "damping of the first mode of wall and liquid";
    /// Longest time step [s].
    LongestStep: "longest time step";
    /// R/t of the lowest course.
    RadiusOverThickness: "R/t of the lowest course";
    /// Elements over the height of a pushover.
    ElementsOverHeight: "elements over the height";
    /// Elements around its half.
    ElementsAround: "elements around the half";
    /// Height of the lowest element over √(R t).
    LowestElement: "lowest element over √(R t)";
    /// Smallest element along the circumference over √(R t).
    SmallestAround: "smallest element along the circumference over √(R t)";
    /// Impulsive mass of the liquid [kg].
    ImpulsiveMass: "impulsive mass of the liquid";
    /// Its height [m].
    ImpulsiveHeight: "its height";
    /// Mass of wall and roof [kg].
    WallAndRoofMass: "mass of wall and roof";
}

impl FactKind {
    /// Whether it is a damping ratio.
    pub fn is_damping(self) -> bool {
        matches!(self, FactKind::SloshingDamping | FactKind::WallDamping)
    }
}
