//! Elements and a mesh that only the benchmarks use: references for the elements of the engines.

pub mod beam2;
mod fluid4;
mod free_surface_line;
mod plane_mesh;

pub use fluid4::Fluid4;
pub use free_surface_line::FreeSurfaceLine;
pub use plane_mesh::{Plane, Strip};
