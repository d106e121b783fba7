//! Stress laws at one point: rows M1 to M9.
//!
//! No mesh: a strain path, its stresses, the energy dissipated.

mod compression;
mod concrete;
mod drive;
mod steel;

pub use compression::{drucker_prager, plastic_fracturing};
pub use concrete::concrete;
pub use steel::steel;

use super::{Row, VerifyError};

/// All rows of this topic.
///
/// Errors: a law without an answer.
pub fn materials() -> Result<Vec<Row>, VerifyError> {
    let parts = [steel()?, drucker_prager()?, plastic_fracturing()?, concrete()?];
    Ok(parts.into_iter().flatten().collect())
}
