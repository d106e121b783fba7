//! Verification: closed forms, published benchmarks, convergence, and an independent second formulation.

mod bulging;
mod convergence;
mod manual;
mod motions;
mod observables;
mod response_oscillators;
mod response_simulate;
mod response_tank;
mod rigid_cylinder;
mod rigid_strip;
mod shared_model;
mod solid_engine;
mod strip_wall;
mod tanks;
mod wall_modes;
mod wall_statics;
