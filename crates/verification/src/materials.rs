//! Stress laws at one point: rows M1 to M15.
//!
//! No mesh: a strain path, its stresses, the energy dissipated.

pub(crate) mod bond;
mod compression;
pub(crate) mod concrete;
mod drive;
pub(crate) mod solid_concrete;
pub(crate) mod steel;
