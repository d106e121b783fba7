//! Motion of the ground.

use tank::units::Dimension;

/// Columns of `series.csv` that hold the ground motion as computed with: acceleration [m/s²], velocity [m/s],
/// displacement [m]; those of a vertical record carry [`VERTICAL_PREFIX`].
pub const GROUND_COLUMNS: [&str; 3] = ["ground_acceleration", "ground_velocity", "ground_displacement"];
/// Prefix of [`GROUND_COLUMNS`] for the vertical record.
pub const VERTICAL_PREFIX: &str = "vertical_";

/// A component of the motion of the ground.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Ground {
    /// Acceleration [m/s²].
    Acceleration,
    /// Velocity [m/s].
    Velocity,
    /// Displacement [m].
    Displacement,
}

impl Ground {
    /// All components, in the order of [`GROUND_COLUMNS`].
    pub const ALL: [Ground; 3] = [Ground::Acceleration, Ground::Velocity, Ground::Displacement];

    /// Id: name of the column without a prefix.
    pub(super) fn id(self) -> &'static str {
        GROUND_COLUMNS[self as usize]
    }

    /// Title.
    pub(super) fn title(self) -> &'static str {
        match self {
            Ground::Acceleration => "Ground acceleration",
            Ground::Velocity => "Ground velocity",
            Ground::Displacement => "Ground displacement",
        }
    }

    /// Dimension.
    pub(super) fn dimension(self) -> Dimension {
        match self {
            Ground::Acceleration => Dimension::Acceleration,
            Ground::Velocity => Dimension::Velocity,
            Ground::Displacement => Dimension::Length,
        }
    }
}
