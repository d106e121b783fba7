//! Tanks on soil and on isolators: rigid foundations, effective period and damping, isolators in time.
//!
//! | page | reference |
//! |---|---|
//! | impedances of a rigid disc | closed forms, Veletsos & Verbic 1973 |
//! | effective period and damping | an independent program, limits |
//! | the harmonic engine on a slab | a body in its modes, a fixed base |
//! | isolators | closed forms, an independent program, Runge and Kutta's method |
//! | the harmonic engine on isolators | an independent program, Runge and Kutta's method |

use ::soil::SoilError;
use ::soil::disc::{Disc, Soil};
use ::soil::structure::{OnSoil, Structure};

use crate::Failure;

pub(crate) mod engine;
pub(crate) mod impedances;
pub(crate) mod isolated_tanks;
pub(crate) mod isolation;
mod procedures;
mod runge_kutta;
pub(crate) mod structure;

/// Impulsive mass with wall and roof [kg], its arm [m], its period [s], of tanks B, C and D of the pages on bases.
pub(crate) const IMPULSIVE: [(&str, f64, [f64; 3]); 3] = [
    ("B", 13.9, [5.794e6, 6.433, 0.2231]),
    ("C", 20.0, [7.479e6, 6.065, 0.2181]),
    ("D", 6.1, [1.0118e6, 4.795, 0.1403]),
];

/// Gravity [m/s²].
const GRAVITY: f64 = 9.81;

fn failure(error: SoilError) -> Failure {
    Failure::from(error.to_string())
}

/// Soil without hysteresis; ρ_s = 1900 kg/m³.
fn soil(shear_wave_velocity: f64, poisson_ratio: f64) -> Soil {
    Soil { density: 1900.0, shear_wave_velocity, poisson_ratio, damping: 0.0, depth: None }
}

/// A tank on a half-space with ν = 1/3; wall 2 %.
fn on_soil(radius: f64, [mass, height, period]: [f64; 3], shear_wave_velocity: f64) -> Result<OnSoil, Failure> {
    let disc = Disc::new(radius, soil(shear_wave_velocity, 1.0 / 3.0)).map_err(failure)?;
    let structure = Structure { mass, height, period, damping: 0.02 };
    OnSoil::new(structure, disc).map_err(failure)
}
