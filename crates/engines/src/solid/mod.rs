//! The three-dimensional engine: the dissertation's elements on a tank.
//!
//! [`simulate`] turns a case into a model of the crate `fem` (liquid, shell wall, contact between them), runs it, and
//! returns what the harmonic engine returns, so that both stand side by side in every report.

mod mesh_size;

mod direct;
mod estimate;
pub mod fields;
pub mod mesh;
pub mod model;
pub mod moments;
pub mod reduce;
pub mod ritz;
pub(crate) mod roof;
pub mod rows;
mod run;
pub mod spectrum;
mod symmetry;
pub mod system;
pub mod waves;

pub use estimate::{RUN, estimate};
pub use run::{modes, most_waves, respond, simulate};

pub use mesh_size::{MeshSize, MeshSizeError};

use crate::estimate::MEMORY_LIMIT_MIB;

/// Formulation of the liquid.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Liquid {
    /// Displacement element in convective coordinates with mean dilatation and split rotation penalty (`fluid8`),
    /// joined to the wall by `contact8`.
    Displacement,
    /// Displacement potential on hexahedra (`potential8`), in the sparse three-field form.
    Potential,
}

/// Options of the three-dimensional engine.
#[derive(Clone, Debug, PartialEq)]
pub struct SolidOptions {
    /// Numbers of elements; by the mesh rule of the theory manual if `None`.
    pub mesh: Option<MeshSize>,
    /// Formulation of the liquid.
    pub liquid: Liquid,
    /// Largest memory of matrices and factors [MiB]; a larger model is refused before the run.
    pub memory_limit_mib: u64,
    /// Time between the states kept in [`Simulation::snapshots`] [s]; `None` keeps none.
    pub snapshot_interval: Option<f64>,
}

impl Default for SolidOptions {
    fn default() -> Self {
        SolidOptions {
            mesh: None,
            liquid: Liquid::Potential,
            memory_limit_mib: MEMORY_LIMIT_MIB,
            snapshot_interval: None,
        }
    }
}
