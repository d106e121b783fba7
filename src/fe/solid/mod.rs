//! The three-dimensional engine: the dissertation's elements on a tank.
//!
//! [`simulate`] turns a case into a model of the crate `fem` (liquid, shell wall, contact between them), runs it, and
//! returns what the harmonic engine returns, so that both stand side by side in every report.

use codes::Case;
use fem::progress::Progress;

use super::{FeError, Options, Simulation};

/// Formulation of the liquid.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Liquid {
    /// Displacement element in convective coordinates with mean dilatation and split rotation penalty (`fluid8`),
    /// joined to the wall by `contact8`.
    Displacement,
    /// Displacement potential on hexahedra (`potential8`), in the sparse three-field form.
    Potential,
}

/// Numbers of elements.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct MeshSize {
    /// Over the radius (or half length).
    pub radial: usize,
    /// Over the circumference (or the breadth of a rectangle).
    pub sectors: usize,
    /// Over the height of the wall.
    pub vertical: usize,
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
}

impl Default for SolidOptions {
    fn default() -> Self {
        SolidOptions {
            mesh: None,
            liquid: Liquid::Potential,
            memory_limit_mib: 4096,
        }
    }
}

/// Time history of a case by the three-dimensional engine.
///
/// Errors: as [`crate::fe::simulate`]; a mesh that cannot be built; more memory than allowed.
pub fn simulate(
    _case: &Case,
    _options: &Options,
    _solid: &SolidOptions,
    _progress: &dyn Progress,
) -> Result<Simulation, FeError> {
    Err(FeError::Unsupported(
        "the three-dimensional engine is not built yet".into(),
    ))
}
