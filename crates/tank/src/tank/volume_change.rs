//! Changes of volume without stress: temperature, shrinkage, creep.

use super::{Behaviour, Family, Layer, Material};
use crate::keys::{Field, Limits, Number, Opt, Or, Temperature, keys};

/// Coefficients of thermal expansion [1/K]: EN 1991-1-5, table C.1.
const STEEL: f64 = 12e-6;
const STAINLESS: f64 = 16e-6;
const ALUMINIUM: f64 = 24e-6;
const CONCRETE: f64 = 10e-6;
/// Temperatures of walls [°C].
const TEMPERATURE: Limits = Limits::from(-200.0).to(260.0);
/// Stands in for a temperature that is not given [°C]: EN 1991-1-5, A.1 (3).
const STRESS_FREE: f64 = 10.0;

keys! {
    /// Changes of volume of a material, for the state at rest before the record of the nonlinear engine.
    pub VolumeChange (Copy, Default) {
        /// Coefficient of linear thermal expansion, per kelvin.
        @"Option::is_none" thermal_expansion (1.2e-5): Opt<Number> [Limits::from(0.0).to(1e-3)] = Absent::Follows(
            "1.2e-5 of carbon steel, 1.6e-5 of stainless steel, 2.4e-5 of aluminium, 1.0e-5 of concrete (EN 1991-1-5, table C.1); of bars that of their layer"
        ),
        /// Shrinkage strain until the record, positive where the material contracts; not for bars and interlayers.
        @(default) shrinkage (3e-4): Or<Number> [Limits::from(-0.01).to(0.01)] = default(Number(0.0)),
        /// Creep coefficient φ of the loads at rest; not for bars and interlayers.
        @(default) creep_coefficient (2.0): Or<Number> [Limits::from(0.0).to(10.0)] = default(Number(0.0)),
    }

    /// Temperature of a wall at rest before the record, linear between its faces.
    pub WallTemperature (Copy) {
        /// Of the inner face.
        inside ("60 degC"): Field<Temperature> [TEMPERATURE],
        /// Of the outer face.
        outside ("20 degC"): Field<Temperature> [TEMPERATURE],
        /// Temperature at which the empty wall is free of stress.
        stress_free ("15 degC"): Or<Temperature> [TEMPERATURE] = default(Temperature(STRESS_FREE)).because("EN 1991-1-5, A.1 (3)"),
    }
}

impl VolumeChange {
    /// Nothing given.
    pub const NONE: VolumeChange = VolumeChange { thermal_expansion: None, shrinkage: 0.0, creep_coefficient: 0.0 };

    /// Whether nothing is given.
    pub fn is_none(&self) -> bool {
        *self == VolumeChange::NONE
    }

    /// Whether there is a change without a change of temperature.
    pub fn lasts(&self) -> bool {
        self.shrinkage != 0.0 || self.creep_coefficient > 0.0
    }
}

impl WallTemperature {
    /// Change against the temperature free of stress [K] at this share of the thickness from the inner face.
    pub fn change(&self, share: f64) -> f64 {
        self.inside + share * (self.outside - self.inside) - self.stress_free
    }
}

impl Material {
    /// Coefficient of thermal expansion [1/K]: given, or that of its family; none where that has none.
    pub fn thermal_expansion(&self) -> Option<f64> {
        let of_family = match self.family {
            Some(Family::CarbonSteel) => Some(STEEL),
            Some(Family::Stainless) => Some(STAINLESS),
            Some(Family::Aluminium) => Some(ALUMINIUM),
            Some(Family::Concrete) => Some(CONCRETE),
            Some(Family::OtherMetal | Family::Polymer | Family::Other) => None,
            None => match self.behaviour {
                Behaviour::Steel(_) => Some(STEEL),
                Behaviour::Concrete(_) => Some(CONCRETE),
                _ => None,
            },
        };
        self.volume_change.thermal_expansion.or(of_family)
    }
}

impl Layer {
    /// Whether it has shrinkage, creep or bars with a prestress.
    pub fn lasts(&self) -> bool {
        self.material.volume_change.lasts() || self.reinforcement.iter().any(|bars| bars.prestress != 0.0)
    }
}
