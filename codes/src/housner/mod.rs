//! Housner's two-mass procedure (1957/1963), and stresses from it.

pub mod coefficients;
pub mod model;
pub mod slender;
pub mod statics;
pub mod stress;

#[cfg(test)]
mod tests;
