//! Parts of the shell element [`Shell4`](super::shell4::Shell4).
//!
//! * [`section`]: resultants N, M, Q from the strains of the reference surface.
//! * [`layered`]: sections of layers and bars; [`rule`]: quadrature through a layer.
//! * [`geometry`]: points of a quadrilateral with their tangent frames.
//! * `director`: rotation of a director and its second derivative; `drilling`: energy of the rotation about the normal at folds.
//! * [`surface`]: directors of a mesh, and how a mesh of shells gets into a model.
//! * [`load`]: pressure on faces and forces on edges.
//! * [`recovery`]: nodal values and edge values.

pub(super) mod director;
pub(super) mod drilling;
pub mod geometry;
pub mod layered;
pub mod load;
pub mod recovery;
pub mod rule;
pub mod section;
pub mod surface;
