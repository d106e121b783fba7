//! Vocabulary of the seismic verification of liquid storage tanks: plain data that procedures, engines, results and
//! reports share. It imports no procedure, no engine and no file format.
//!
//! | module | idea |
//! |---|---|
//! | [`units`] | dimensions, parsing and printing of quantities with units |
//! | [`Tank`], [`Liquid`] and what they are made of | the tank and its contents |
//! | [`case`] | all that a procedure or an engine needs of one verification |
//! | [`quantity`] | what procedures and engines can be compared by |
//! | [`assessment`] | what a procedure concludes |
//!
//! SI units throughout (m, kg, s, N, Pa, rad); every field names its unit. `z` points upwards from the tank bottom.

pub mod assessment;
pub mod case;
pub mod quantity;
pub mod reference;
#[allow(clippy::module_inception)]
mod tank;
pub mod units;

pub use case::Case;
pub use oscillator::STANDARD_GRAVITY;
pub use quantity::Quantity;
pub use tank::*;
