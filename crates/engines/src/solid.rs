//! The three-dimensional engine: the dissertation's elements on a tank.
//!
//! [`simulate`] turns a case into a model of the crate `fem` (liquid, shell wall, contact between them), runs it, and
//! returns what the harmonic engine returns, so that reports can compare them.

mod around;
mod around_probes;
mod coupling;
mod direct;
mod estimate;
mod exchanged;
mod fields;
mod form;
mod instants;
mod loaded;
mod memory;
pub(crate) mod mesh;
mod mirror;
pub mod model;
mod modes;
mod moments;
mod penalty;
mod plan;
mod poles;
mod project;
mod reduce;
pub(crate) mod ring;
mod ritz;
pub(crate) mod roof;
mod rows;
mod run;
mod search;
mod shared;
pub mod spectrum;
mod symmetry;
pub mod system;
pub mod wall;
mod waves;

pub use estimate::estimate;
pub use model::refused;
pub use modes::{modes, most_waves};
pub use penalty::notes as penalty_notes;
#[cfg(test)]
pub(crate) use run::around_a_perfect_liquid;
pub(crate) use run::unresolved;
pub use run::{respond, simulate, tilted};
pub use shared::Shared;
pub use tank::options::solid::{Liquid, MeshSize, MeshSizeError, SolidOptions};

#[cfg(test)]
mod tests;
