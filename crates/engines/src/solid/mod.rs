//! The three-dimensional engine: the dissertation's elements on a tank.
//!
//! [`simulate`] turns a case into a model of the crate `fem` (liquid, shell wall, contact between them), runs it, and
//! returns what the harmonic engine returns, so that both stand side by side in every report.

mod direct;
mod estimate;
pub mod fields;
mod memory;
pub mod mesh;
pub mod model;
pub mod moments;
mod poles;
mod project;
pub mod reduce;
pub mod ritz;
pub(crate) mod roof;
pub mod rows;
mod run;
pub mod spectrum;
mod symmetry;
pub mod system;
pub mod waves;

pub use estimate::estimate;
pub use run::{modes, most_waves, respond, simulate};
pub use tank::options::solid::{Liquid, MeshSize, MeshSizeError, SolidOptions};
