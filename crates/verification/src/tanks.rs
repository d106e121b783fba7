//! Whole tanks: liquid between rigid walls, wall and liquid together, responses to ground motion.

use oscillator::record::Record;

use crate::{Reference, Row};
use engines::FeError;
use engines::liquid::Domain;
use rigid::RigidTank;
use tank::reference::GRAVITY;

pub(crate) mod coupled_modes;
pub(crate) mod datasheet;
pub mod dissertation;
pub(crate) mod imperfect_wall;
pub(crate) mod internal_forces;
pub(crate) mod mesh_error;
pub(crate) mod mode_damping;
pub(crate) mod responses;
pub mod rigid;
pub(crate) mod rigid_masses;
pub(crate) mod rigid_sloshing;
pub(crate) mod rigid_strip;
pub(crate) mod rings;
pub mod solid_against_harmonic;
pub(crate) mod solid_box;
pub(crate) mod tilt;
pub(crate) mod transfer;
pub(crate) mod turning;
pub(crate) mod two_masses;
pub(crate) mod wall_modes;

/// The dissertation's g [m/s²].
pub(crate) const G: f64 = 9.81;

/// A record as the dissertation describes its treatment: scaled to 0.5 g, its time axis compressed by √3.
pub(crate) fn as_described(original: &Record) -> Record {
    let factor = 0.5 * G / original.pga();
    Record {
        dt: original.dt * (1.0 / 3.0_f64.sqrt()),
        acceleration: original.acceleration.iter().map(|a| a * factor).collect(),
        ..original.clone()
    }
}

/// A rigid cylinder with g = 9.81 m/s².
fn cylinder(radius: f64, depth: f64, harmonic: u32, refine: f64) -> Result<RigidTank, FeError> {
    RigidTank::new(Domain::Cylinder { radius, harmonic }, depth, GRAVITY, refine)
}

/// ω of the rigid cylinder: ω² = g λ/R tanh(λ H/R).
fn exact(radius: f64, depth: f64, zero: f64) -> f64 {
    (GRAVITY * zero / radius * (zero * depth / radius).tanh()).sqrt()
}

/// A row against potential flow.
fn row(
    id: &str,
    what: String,
    source: &'static str,
    (reference, tolerance): (f64, f64),
    computed: f64,
    unit: &'static str,
) -> Row {
    let reference = (reference, source, Reference::ClosedForm);
    Row::new(id, what, reference, computed, (tolerance, unit))
}
