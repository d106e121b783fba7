//! The finite-element engine: `simulate` a case, or find its `modes`.
//!
//! The linear engine works harmonic by harmonic: a displacement-potential liquid, condensed to the wall and the free
//! surface, coupled to a shell of revolution (or a plane wall strip). Everything it reports is a linear functional of the
//! unknowns, a [`probe::Probe`]; the response analyses depend on nothing else of the model.

#![warn(unreachable_pub)]

mod checkpoint;
mod checks;
pub mod coupled;
pub mod damping;
pub mod engine;
mod error;
pub mod estimate;
mod fittings;
pub mod harmonic;
pub mod modes;
pub mod nonlinear;

mod floor_pressure;
mod histories;
mod hoop;
mod impulsive;
mod linear;
mod out_of_round;
pub mod probe;
mod rainflow;
mod registry;
pub mod response;
pub mod solid;
pub mod spectral;
pub mod strip;

pub use engine::{Engine, Simulation, Task};
pub use error::FeError;
pub use fem::liquid;
pub use floor_pressure::impulsive_pressure;
pub use linear::isolation::{IsolatedBody, isolated_body};
pub use linear::mesh_error::errors as mesh_errors;
pub use linear::prepared::{Prepared, Response};
pub use linear::shared::Shared;
pub use linear::soil::slab_body;
pub use linear::{simulate, simulate_watched};
pub use registry::{ALL, engine};
pub use tank::options::LinearOptions as Options;
pub use tank::options::linear::{DampingModel, Integrator};

use tank::Case;

use results::Mode;

/// Coupled modes of the given harmonics (0, 1, 2, …), at most `count` of each kind and harmonic, by ascending frequency.
pub fn modes(case: &Case, options: &Options, harmonics: &[u32], count: usize) -> Result<Vec<Mode>, FeError> {
    harmonic::modes(case, options, harmonics, count)
}
