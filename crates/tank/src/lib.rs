//! Vocabulary of the seismic verification of liquid storage tanks: plain data that procedures, engines, results and
//! reports share. It does not depend on procedures, engines or file formats.
//!
//! | module | idea |
//! |---|---|
//! | [`keys`](mod@keys), [`words`](mod@words) | declaration of the keys of a tank file, and of choices of words |
//! | [`listed!`] | enums as tables |
//! | [`units`] | dimensions, parsing and printing of quantities with units |
//! | [`Tank`], [`Liquid`] and their parts | the tank and its contents |
//! | [`case`] | input of a procedure or an engine for one verification |
//! | [`formula`] | text of a formula, its value, and its text with numbers |
//! | [`options`] | options of the engines with their defaults |
//! | [`refusal`] | rejected input and its place |
//! | [`quantity`] | comparable quantities of procedures and engines |
//! | [`check`] | limit states, and how each ends |
//! | [`outside`] | why numbers of an engine are outside its model |
//! | [`demand`] | histories of stresses and forces that limit states compare with capacities |
//! | [`assessment`] | result of a procedure |
//! | [`large_wave`] | crest and trough of a wave that is not small |
//! | [`imperfection`] | deviations of a wall from the perfect cylinder |
//! | [`ingredients`], [`factor`] | what a quantity is made of, and the order in which that is exchanged |
//!
//! SI units throughout (m, kg, s, N, Pa, rad); the unit is in the doc of every field. `z` points upwards from the
//! tank bottom.

pub mod assessment;
pub mod case;
pub mod check;
pub mod demand;
pub mod factor;
pub mod formula;
pub mod hazard;
pub mod imperfection;
pub mod ingredients;
pub mod keys;
pub mod large_wave;
mod listed;
pub mod national;
pub mod options;
pub mod outside;
mod project;
pub mod quantity;
pub mod reference;
pub mod refusal;
#[allow(clippy::module_inception)]
mod tank;
pub mod units;
pub mod value;
pub mod words;

pub use case::Case;
pub use oscillator::STANDARD_GRAVITY;
pub use project::{Language, Project};
pub use quantity::Quantity;
pub use tank::*;
