//! What a tank stands on: soil under a rigid foundation, or isolators.
//!
//! | module | what |
//! |---|---|
//! | [`disc`] | rigid disc on a half-space or a layer: static stiffness, impedance, cones |
//! | [`structure`] | effective period and damping of a structure on such a disc |
//! | [`chain`] | the structure on cones as matrices with constant coefficients, complex mode, time history |
//! | [`body`] | time history of a body in its modes on cones |
//! | [`isolator`] | laws of isolators, their effective stiffness and damping |
//! | [`isolated`] | time history of a body in its modes on isolators |
//!
//! Only a stiff foundation (slab, raft, pile cap) moves as a disc. A flexible bottom on soil is softer at its rim by an order of
//! magnitude and belongs to the crate `base`.
//!
//! Theory: `docs/theory/soil.md`.

#![warn(unreachable_pub)]

pub mod body;
pub mod chain;
pub mod disc;
mod error;
pub mod isolated;
pub mod isolator;
pub mod layered;
pub mod structure;
#[cfg(test)]
mod tests;

pub use error::SoilError;
pub use num_complex::Complex;

/// A complex number.
pub type C64 = Complex<f64>;
