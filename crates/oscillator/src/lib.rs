//! Recorded ground motion and the response of an oscillator of one degree of freedom.
//!
//! | module | idea |
//! |---|---|
//! | [`intensity`] | intensity measures, the axes of fragility curves |
//! | [`known`] | processings of accelerograms by their numbers |
//! | [`record`] | a ground motion sampled at equal steps |
//! | [`sdof`] | exact recurrence for piecewise linear loads; Duhamel's integral as a reference |
//! | [`newmark`] | coefficients of Newmark's method |
//! | [`spectrum`] | response spectra |
//! | [`synthetic`] | records whose spectrum follows a target |
//!
//! SI units throughout (m, kg, s, N, rad).

pub mod intensity;
pub mod known;
pub mod newmark;
pub mod record;
pub mod sdof;
pub mod spectrum;
pub mod synthetic;

/// Standard acceleration of free fall, 9.80665 m/s² (ISO 80000-3); the meaning of the unit `g`.
pub const STANDARD_GRAVITY: f64 = 9.80665;
