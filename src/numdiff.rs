//! Comparison of two results folders, number by number.
