//! The benchmarks of the verification manual.
