//! Dimensions and units: parse `"1.83 m"`, convert to SI, print with an engineer's unit.
//!
//! A quantity in text is a decimal number, then a unit: `"2.03 mm"`, `"69 GPa"`, `"1000 kg/m3"`, `"0.5 g"`. The
//! expected dimension decides the meaning of `g` (gram or standard gravity). Units may be written with `^`, `*`, `·`,
//! superscripts and blanks around `/` (`kg / m^3`, `kN·m`); upper and lower case matter (`mm`, `MPa`).
//!
//! Print chooses units of SI, or those of the [`System`] of the [`Scope`] it runs in.

mod fraction;
mod parse;
mod print;
mod system;
mod table;
mod text;

use serde::{Deserialize, Serialize};

pub use parse::{UnitError, parse};
pub use print::{column_unit, display, display_in, in_unit, significant, unit_for};
pub use system::{Preferred, Scope, System};
pub use table::{UNITS, Unit};
pub use text::converted;

/// Physical dimension of a value that is stored in SI.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash, Serialize, Deserialize)]
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
    /// m²/m
    LineArea,
    /// 1/m
    Curvature,
    /// N/m³
    Subgrade,
    /// N·m/rad (spring against rotation)
    RotationalStiffness,
    /// N·s/m (viscous force per velocity)
    Dashpot,
    /// N·m·s/rad (viscous moment per angular velocity)
    RotationalDashpot,
    /// kg·m² (moment of inertia of a mass)
    RotationalInertia,
}

impl Dimension {
    /// All dimensions.
    pub const ALL: [Dimension; 23] = [
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
        Dimension::LineArea,
        Dimension::Curvature,
        Dimension::Subgrade,
        Dimension::RotationalStiffness,
        Dimension::Dashpot,
        Dimension::RotationalDashpot,
        Dimension::RotationalInertia,
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
            Dimension::LineArea => "m2/m",
            Dimension::Curvature => "rad/m",
            Dimension::Subgrade => "N/m3",
            Dimension::RotationalStiffness => "N*m/rad",
            Dimension::Dashpot => "N*s/m",
            Dimension::RotationalDashpot => "N*m*s/rad",
            Dimension::RotationalInertia => "kg*m2",
        }
    }

    /// The dimension in words with its article ("a length").
    pub fn noun(self) -> &'static str {
        match self {
            Dimension::Dimensionless => "a number without a unit",
            Dimension::Length => "a length",
            Dimension::Time => "a time",
            Dimension::Mass => "a mass",
            Dimension::Density => "a density",
            Dimension::Velocity => "a velocity",
            Dimension::Acceleration => "an acceleration",
            Dimension::Frequency => "a frequency",
            Dimension::AngularFrequency => "a circular frequency",
            Dimension::Angle => "an angle",
            Dimension::Force => "a force",
            Dimension::Moment => "a moment",
            Dimension::Stress => "a stress",
            Dimension::LineForce => "a force per length",
            Dimension::LineMoment => "a moment per length",
            Dimension::Energy => "an energy",
            Dimension::LineArea => "an area per length",
            Dimension::Curvature => "a curvature",
            Dimension::Subgrade => "a subgrade modulus",
            Dimension::RotationalStiffness => "a rotational stiffness",
            Dimension::Dashpot => "a dashpot coefficient",
            Dimension::RotationalDashpot => "a rotational dashpot coefficient",
            Dimension::RotationalInertia => "a moment of inertia",
        }
    }

    /// An example as in an input file, without quotes.
    pub fn example(self) -> &'static str {
        match self {
            Dimension::Dimensionless => "0.02",
            Dimension::Length => "1.83 m",
            Dimension::Time => "0.02 s",
            Dimension::Mass => "500 kg",
            Dimension::Density => "1000 kg/m3",
            Dimension::Velocity => "0.8 m/s",
            Dimension::Acceleration => "0.5 g",
            Dimension::Frequency => "1.2 Hz",
            Dimension::AngularFrequency => "3.0 rad/s",
            Dimension::Angle => "30 deg",
            Dimension::Force => "120 kN",
            Dimension::Moment => "35 kNm",
            Dimension::Stress => "210 GPa",
            Dimension::LineForce => "25 kN/m",
            Dimension::LineMoment => "3 kNm/m",
            Dimension::Energy => "5 kJ",
            Dimension::LineArea => "7.0 cm2/m",
            Dimension::Curvature => "0.01 rad/m",
            Dimension::Subgrade => "100 MN/m3",
            Dimension::RotationalStiffness => "200 kNm/rad",
            Dimension::Dashpot => "5 kNs/m",
            Dimension::RotationalDashpot => "5 kNms/rad",
            Dimension::RotationalInertia => "500 kgm2",
        }
    }

    /// The units of this dimension, in the order of the table.
    pub fn units(self) -> impl Iterator<Item = &'static Unit> {
        UNITS.iter().filter(move |u| u.dimension == self)
    }

    /// Expected form, for messages: `a length such as "1.83 m" (units: m, cm, mm, in, ft)`.
    pub fn allowed(self) -> String {
        if self == Dimension::Dimensionless {
            return "a number without a unit such as 0.02, or a percentage such as \"2 %\"".into();
        }
        let units: Vec<&str> = self.units().map(|u| u.text).collect();
        format!("{} such as \"{}\" (units: {})", self.noun(), self.example(), units.join(", "))
    }

    /// The SI unit of this dimension.
    pub fn si_unit(self) -> &'static Unit {
        self.units().find(|u| u.factor() == 1.0).expect("each dimension has its SI unit in the table")
    }
}
