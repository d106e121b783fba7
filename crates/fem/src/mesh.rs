//! Generators of structured meshes. A mesh is nodes, cells and named faces; it becomes a model when elements are made of
//! its cells.

pub mod grading;

mod cylinder;
mod rectangle;

pub use cylinder::{Cylinder, Volume, Wall};
pub use rectangle::{Block, Rectangle, Side};

/// A quadrilateral face with the chart coordinates of its corners.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Face {
    /// Nodes, counter-clockwise seen from outside.
    pub nodes: [usize; 4],
    /// Chart coordinates (x, y, z or r, θ, z) of the corners.
    pub chart: [[f64; 3]; 4],
}

/// A hexahedron with the chart coordinates of its corners; numbering as in [`crate::shape::hex8`].
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Hexahedron {
    /// Nodes; collapsed ones repeat.
    pub nodes: [usize; 8],
    /// Chart coordinates (x, y, z or r, θ, z) of the corners.
    pub chart: [[f64; 3]; 8],
}

/// Failure of a generator.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
pub enum MeshError {
    /// A count or a coordinate out of range.
    #[error("mesh: {what}: found {found}, allowed {allowed}")]
    Range {
        /// The wrong quantity.
        what: &'static str,
        /// Found.
        found: String,
        /// Allowed.
        allowed: &'static str,
    },
}

/// Rejects fewer than `least` values, and values that do not ascend.
///
/// Errors: those values, under the name `what`.
pub fn check_ascending(what: &'static str, values: &[f64], least: usize) -> Result<(), MeshError> {
    if values.len() < least {
        return Err(MeshError::Range {
            what,
            found: format!("{} values", values.len()),
            allowed: "at least one element",
        });
    }
    match values.windows(2).find(|w| !(w[1] > w[0] && w[0].is_finite() && w[1].is_finite())) {
        Some(w) => Err(MeshError::Range {
            what,
            found: format!("{} after {}", w[1], w[0]),
            allowed: "finite ascending values",
        }),
        None => Ok(()),
    }
}
