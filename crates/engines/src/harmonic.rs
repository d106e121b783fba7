//! The default linear engine: one Fourier harmonic of a cylinder, or a plane strip, at a time.
//!
//! [`build`] couples the condensed liquid of [`crate::liquid`] with the wall of this folder and returns the
//! [`crate::coupled::Coupled`] that the response analyses work on; [`modes`] sorts its eigenmodes.

mod assembly;
mod build;
mod content;
mod dashpots;
mod estimate;
mod limits;
mod liquid_mesh;
mod modes;
mod observe;
mod places;
mod reduce;
mod rings;
mod state;
mod wall;
mod wall_mesh;

pub use build::build;
pub(crate) use build::build_observed;
pub(crate) use estimate::add_states;
pub use estimate::estimate;
pub use limits::notes;
pub(crate) use limits::{CLAMPED, IN_CONTACT, assumptions};
pub(crate) use liquid_mesh::content;
pub use modes::modes;
pub(crate) use places::Places;
pub use state::Static;
pub use wall::{NODAL, NODE, Output, Wall};
pub use wall_mesh::wall_nodes;

#[cfg(test)]
mod foot_tests;
#[cfg(test)]
pub(crate) mod test_tanks;
