//! Which section of the liquid is meshed and how integrals over it become integrals over the tank.
//!
//! ```text
//! cylinder, φ(r, z) cos mθ:   ∫ … dV = c ∫ … r dr dz,   c = π (m ≥ 1), 2π (m = 0)
//! strip, right half:          ∫ … dV = c ∫ … dx dz,     c = 2 × breadth (both halves)
//! ```
//!
//! The antisymmetric half of a strip plays the part of m = 1, the symmetric half that of m = 0.

use std::f64::consts::PI;

/// Section of the liquid and its harmonic.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Domain {
    /// Meridional section of an upright cylinder.
    Cylinder {
        /// Radius R [m].
        radius: f64,
        /// Circumferential harmonic m.
        harmonic: u32,
    },
    /// Right half of a plane strip.
    Strip {
        /// Half length L [m].
        half_length: f64,
        /// Breadth [m].
        breadth: f64,
        /// Symmetric about x = 0 instead of antisymmetric.
        symmetric: bool,
    },
}

impl Domain {
    /// R or L [m].
    pub fn half_length(&self) -> f64 {
        match *self {
            Domain::Cylinder { radius, .. } => radius,
            Domain::Strip { half_length, .. } => half_length,
        }
    }

    /// Factor c of the integrals: angle [rad] or breadth [m].
    pub fn factor(&self) -> f64 {
        match *self {
            Domain::Cylinder { harmonic: 0, .. } => 2.0 * PI,
            Domain::Cylinder { .. } => PI,
            Domain::Strip { breadth, .. } => 2.0 * breadth,
        }
    }

    /// Weight of an area at r: r for a cylinder, 1 for a strip.
    pub fn weight(&self, r: f64) -> f64 {
        match self {
            Domain::Cylinder { .. } => r,
            Domain::Strip { .. } => 1.0,
        }
    }

    /// Coefficient m²/r² of φ² in the gradient.
    pub fn angular(&self, r: f64) -> f64 {
        match *self {
            Domain::Cylinder { harmonic, .. } => (f64::from(harmonic) / r).powi(2),
            Domain::Strip { .. } => 0.0,
        }
    }

    /// True if φ and η vanish on the axis (m ≥ 1, antisymmetric half).
    pub fn vanishes_on_axis(&self) -> bool {
        !self.is_floating()
    }

    /// True if a constant φ costs no energy (m = 0, symmetric half): the surface must then keep the volume.
    pub fn is_floating(&self) -> bool {
        match *self {
            Domain::Cylinder { harmonic, .. } => harmonic == 0,
            Domain::Strip { symmetric, .. } => symmetric,
        }
    }
}
