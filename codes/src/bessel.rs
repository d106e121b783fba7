//! Bessel functions and their ratios.
