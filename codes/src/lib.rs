//! Vocabulary of the seismic verification of liquid storage tanks, and the code procedures themselves.
//!
//! This crate knows no files, no finite elements and no report. It holds
//!
//! | module | idea |
//! |---|---|
//! | [`units`] | dimensions, parsing and printing of quantities with units |
//! | [`tank`], [`record`], [`case`] | the tank, the ground motion, and all a procedure needs of one verification |
//! | [`quantity`] | what can be compared between procedures and the finite-element engine |
//! | [`procedure`], [`sheet`] | the trait all code procedures implement, and their calculation sheets |
//! | [`bessel`], [`mechanical`] | special functions; masses, levers and periods of potential flow |
//! | [`newmark`], [`sdof`], [`spectrum`] | oscillators, response and design spectra |
//! | [`housner`], [`ec8`], [`api650`], [`deformability`] | the procedures |
//!
//! SI units throughout (m, kg, s, N, Pa, rad); every field names its unit. `z` points upwards from the tank bottom.

pub mod api650;
pub mod bessel;
pub mod case;
pub mod deformability;
pub mod ec8;
pub mod housner;
pub mod mechanical;
pub mod newmark;
pub mod procedure;
pub mod quantity;
pub mod record;
pub mod sdof;
pub mod sheet;
pub mod spectrum;
pub mod tank;
pub mod units;

pub use case::Case;
pub use procedure::{Assessment, Procedure};
pub use quantity::Quantity;

/// Standard acceleration of free fall, 9.80665 m/s² (ISO 80000-3); the default of [`Case::gravity`] and the meaning of
/// the unit `g`.
pub const STANDARD_GRAVITY: f64 = 9.80665;
