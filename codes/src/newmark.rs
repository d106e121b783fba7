//! Newmark's coefficients.
