//! Motion of the ground.

use tank::listed;
use tank::units::Dimension;

/// Columns of `series.csv` that hold the ground motion as computed with: acceleration [m/s²], velocity [m/s],
/// displacement [m]; those of a vertical record carry [`VERTICAL_PREFIX`].
pub const GROUND_COLUMNS: [&str; 3] = ["ground_acceleration", "ground_velocity", "ground_displacement"];
/// Prefix of [`GROUND_COLUMNS`] for the vertical record.
pub const VERTICAL_PREFIX: &str = "vertical_";

listed! {
    /// A component of the motion of the ground, in the order of [`GROUND_COLUMNS`].
    #[derive(Clone, Copy, Debug, PartialEq, Eq)]
    pub enum Ground {
        /// Name of the column without a prefix.
        id: &'static str,
        /// Title.
        title: &'static str,
        /// Dimension.
        dimension: Dimension,
    }
    /// Acceleration [m/s²].
    Acceleration: GROUND_COLUMNS[0], "Ground acceleration", Dimension::Acceleration;
    /// Velocity [m/s].
    Velocity: GROUND_COLUMNS[1], "Ground velocity", Dimension::Velocity;
    /// Displacement [m].
    Displacement: GROUND_COLUMNS[2], "Ground displacement", Dimension::Length;
}
