//! The liquid: displacement potential on the meridional section of a cylinder or on the plane of a strip.

mod domain;
mod mesh;
mod potential;

pub use domain::Domain;
pub use mesh::{LiquidMesh, scaled};

pub use potential::{Potential, Row};
