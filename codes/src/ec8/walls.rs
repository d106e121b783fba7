//! Walls that are not metal shells: concrete cylinders by EN 1992, walls of boxes as plates.
//!
//! Forces per metre of wall under the seismic combinations, under the hydrostatic load alone, and in the damage limitation state if
//! its reduction factor is given:
//!
//! | wall | bending | axial force |
//! |---|---|---|
//! | cylinder | shell on the joint with its base, pressure of the meridian all around (`wall_bending`) | hoop: E s w/R; vertical: weight and n_z |
//! | box | plate clamped at base and sides, free at the top | reaction of the walls at its sides; vertical: weight and moment of the tank |
//! | strip | cantilever in plane strain | weight |
//!
//! The wall's own inertia loads it with the impulsive acceleration. At the sides of the tank (θ = 90°, walls along the shaking) the
//! membrane shear of the base shear adds to the axial forces of both directions of bars, EN 1992-1-1 annex F.

mod checks;
mod cylinder;
mod lines;
mod metal;
mod place;
mod rectangle;
mod required;
mod section;

pub(super) use cylinder::assess as cylinder;
pub(super) use rectangle::{BoxTank, assess as rectangle};

#[cfg(test)]
mod tests;
