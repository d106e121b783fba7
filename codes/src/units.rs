//! Dimensions and units: parse `"1.83 m"`, convert to SI, print with an engineer's unit.

use serde::{Deserialize, Serialize};

/// Physical dimension of a value that is stored in SI.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, Serialize, Deserialize)]
#[serde(rename_all = "snake_case")]
pub enum Dimension {
    /// A bare number.
    Dimensionless,
    /// m
    Length,
    /// s
    Time,
    /// kg
    Mass,
    /// kg/m³
    Density,
    /// m/s
    Velocity,
    /// m/s²
    Acceleration,
    /// Hz
    Frequency,
    /// rad/s
    AngularFrequency,
    /// rad
    Angle,
    /// N
    Force,
    /// N·m
    Moment,
    /// Pa (stress, pressure, modulus)
    Stress,
    /// N/m
    LineForce,
    /// N·m/m
    LineMoment,
    /// J
    Energy,
}

impl Dimension {
    /// All dimensions.
    pub const ALL: [Dimension; 16] = [
        Dimension::Dimensionless,
        Dimension::Length,
        Dimension::Time,
        Dimension::Mass,
        Dimension::Density,
        Dimension::Velocity,
        Dimension::Acceleration,
        Dimension::Frequency,
        Dimension::AngularFrequency,
        Dimension::Angle,
        Dimension::Force,
        Dimension::Moment,
        Dimension::Stress,
        Dimension::LineForce,
        Dimension::LineMoment,
        Dimension::Energy,
    ];

    /// The dimension with this SI symbol.
    pub fn from_si_symbol(symbol: &str) -> Option<Dimension> {
        Dimension::ALL.into_iter().find(|d| d.si_symbol() == symbol)
    }

    /// SI symbol as written to `results.json`, e.g. `m`, `Pa`, `N*m`.
    pub fn si_symbol(self) -> &'static str {
        match self {
            Dimension::Dimensionless => "1",
            Dimension::Length => "m",
            Dimension::Time => "s",
            Dimension::Mass => "kg",
            Dimension::Density => "kg/m3",
            Dimension::Velocity => "m/s",
            Dimension::Acceleration => "m/s2",
            Dimension::Frequency => "Hz",
            Dimension::AngularFrequency => "rad/s",
            Dimension::Angle => "rad",
            Dimension::Force => "N",
            Dimension::Moment => "N*m",
            Dimension::Stress => "Pa",
            Dimension::LineForce => "N/m",
            Dimension::LineMoment => "N*m/m",
            Dimension::Energy => "J",
        }
    }
}
