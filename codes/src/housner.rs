//! Housner's two-mass procedure (1957, 1963) for upright circular and rectangular tanks, and stresses from it.
//!
//! The liquid is replaced by an impulsive mass that moves with the tank and a convective one on a spring. The procedure
//! is the dissertation's "analytical solution" (tables D.1, 8.4, 8.8 to 8.11), there after TID-7024 (1963).
//!
//! | module | idea |
//! |---|---|
//! | [`coefficients`] | constants of the convective part, exact and as published |
//! | [`model`] | masses, levers, frequency, wave, forces, moments of squat tanks: pure functions |
//! | [`slender`] | the constrained lower part of tanks with H/a > 1.5 |
//! | [`stress`] | pressures over the height, membrane and bending stresses |
//! | [`statics`] | hydrostatic state with edge disturbances (Anhang D.4) |
//! | [`motion`] | ground motion from a record or a design spectrum |
//! | [`Housner`] | the procedure with its calculation sheet |

pub mod coefficients;
pub mod model;
pub mod motion;
pub mod slender;
#[cfg(test)]
pub(crate) mod statics;
pub mod stress;

mod assess;
mod ingredients;
mod lines;
mod notes;
mod run;

pub use assess::Housner;

#[cfg(test)]
mod tests;
