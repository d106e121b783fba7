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

use crate::listed;

listed! {
    /// Physical dimension of a value that is stored in SI.
    #[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash, Serialize, Deserialize)]
    #[serde(rename_all = "snake_case")]
    pub enum Dimension {
        /// SI symbol as written to `results.json`, e.g. `m`, `Pa`, `N*m`.
        si_symbol: &'static str,
        /// The dimension in words with its article ("a length").
        noun: &'static str,
        /// An example as in an input file, without quotes.
        example: &'static str,
    }
    /// A bare number.
    Dimensionless: "1", "a number without a unit", "0.02";
    /// m
    Length: "m", "a length", "1.83 m";
    /// s
    Time: "s", "a time", "0.02 s";
    /// kg
    Mass: "kg", "a mass", "500 kg";
    /// kg/m³
    Density: "kg/m3", "a density", "1000 kg/m3";
    /// m/s
    Velocity: "m/s", "a velocity", "0.8 m/s";
    /// m/s²
    Acceleration: "m/s2", "an acceleration", "0.5 g";
    /// Hz
    Frequency: "Hz", "a frequency", "1.2 Hz";
    /// rad/s
    AngularFrequency: "rad/s", "a circular frequency", "3.0 rad/s";
    /// rad
    Angle: "rad", "an angle", "30 deg";
    /// N
    Force: "N", "a force", "120 kN";
    /// N·m
    Moment: "N*m", "a moment", "35 kNm";
    /// Pa (stress, pressure, modulus)
    Stress: "Pa", "a stress", "210 GPa";
    /// N/m
    LineForce: "N/m", "a force per length", "25 kN/m";
    /// N·m/m
    LineMoment: "N*m/m", "a moment per length", "3 kNm/m";
    /// J
    Energy: "J", "an energy", "5 kJ";
    /// m²/m
    LineArea: "m2/m", "an area per length", "7.0 cm2/m";
    /// °C
    Temperature: "degC", "a temperature", "90 degC";
    /// 1/m
    Curvature: "rad/m", "a curvature", "0.01 rad/m";
    /// N/m³
    Subgrade: "N/m3", "a subgrade modulus", "100 MN/m3";
    /// N·m/rad (spring against rotation)
    RotationalStiffness: "N*m/rad", "a rotational stiffness", "200 kNm/rad";
    /// N·s/m (viscous force per velocity)
    Dashpot: "N*s/m", "a dashpot coefficient", "5 kNs/m";
    /// N·m·s/rad (viscous moment per angular velocity)
    RotationalDashpot: "N*m*s/rad", "a rotational dashpot coefficient", "5 kNms/rad";
    /// kg·m² (moment of inertia of a mass)
    RotationalInertia: "kg*m2", "a moment of inertia", "500 kgm2";
    /// m² (section of a ring)
    Area: "m2", "an area", "24 cm2";
    /// m⁴
    SecondMoment: "m4", "a second moment of area", "820 cm4";
    /// kg/m² (insulation)
    AreaMass: "kg/m2", "a mass per area", "15 kg/m2";
}

impl Dimension {
    /// The dimension with this SI symbol.
    pub fn from_si_symbol(symbol: &str) -> Option<Dimension> {
        Dimension::ALL.into_iter().find(|d| d.si_symbol() == symbol)
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
