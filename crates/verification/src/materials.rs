//! Stress laws at one point: rows M1 to M9.
//!
//! No mesh: a strain path, its stresses, the energy dissipated.

mod compression;
pub(crate) mod concrete;
mod drive;
pub(crate) mod steel;
