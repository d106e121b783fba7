//! Verification: closed forms, published benchmarks, convergence, and an independent second formulation.

mod bulging;
mod rigid_cylinder;
mod rigid_strip;
mod tanks;
