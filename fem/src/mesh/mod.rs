//! Generators of structured meshes. A mesh is nodes, cells and named faces; it becomes a model when elements are made of
//! its cells.

mod cylinder;

pub use cylinder::{Cylinder, Volume, Wall};

/// A quadrilateral face with the chart coordinates of its own corners.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Face {
    /// Nodes, counter-clockwise seen from outside.
    pub nodes: [usize; 4],
    /// Chart coordinates (x, y, z or r, θ, z) of the corners.
    pub chart: [[f64; 3]; 4],
}

/// A hexahedron with the chart coordinates of its own corners; numbering as in [`crate::shape::hex8`].
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
        /// What.
        what: &'static str,
        /// Found.
        found: String,
        /// Allowed.
        allowed: &'static str,
    },
}
