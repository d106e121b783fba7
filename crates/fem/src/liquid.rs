//! The liquid by its displacement potential, condensed.
//!
//! [`Potential`]: the meridional section of a cylinder, one Fourier harmonic at a time, or the plane of a strip, condensed
//! to the wall's trace and the free surface. [`HarmonicLiquid`] gathers the harmonics into the added mass of a wall of
//! spatial elements. [`separation`]: where a liquid leaves its wall.

mod circular;
mod domain;
mod harmonic;
pub mod large_wave;
mod mesh;
mod on_wall;
mod potential;
pub mod separation;
mod super_liquid;

pub use circular::{CircularElement, CircularLiquid};
pub use domain::Domain;
pub use harmonic::{Block, HarmonicLiquid};
pub use mesh::{LiquidMesh, scaled};
pub use on_wall::WallLiquid;
pub use potential::{Potential, Row, Trace};
pub use super_liquid::{CondenseError, CondensedLiquid, Rim};
