//! Coupled modes: participation, effective mass, sorting into sloshing and structural.
//!
//! ```text
//! K φ_j = ω_j² M φ_j        φ_jᵀ M φ_j = 1        Γ_j = φ_jᵀ M ι ≥ 0        effective mass Γ_j²
//! ```
//!
//! A mode is *sloshing* if the free surface holds more than half of its potential energy, φ_ηᵀ ρ g S φ_η > ω²/2, and
//! *structural* otherwise. Σ Γ_j² = ιᵀ M ι. Source: Clough & Penzien 1993, chapters 11 and 12.

use crate::fe::FeError;
use crate::fe::coupled::Coupled;
use crate::fe::damping::Damper;
use crate::fe::linalg::{LinalgError, dot, generalized_eigen};
use crate::results::Mode;

/// What a mode mainly is.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Kind {
    /// The surface holds more than half of the potential energy.
    Sloshing,
    /// The wall does.
    Structural,
}

impl Kind {
    /// As in `results.json`.
    pub fn id(self) -> &'static str {
        match self {
            Kind::Sloshing => "sloshing",
            Kind::Structural => "structural",
        }
    }
}

/// A mode of a coupled system.
#[derive(Clone, Debug, PartialEq)]
pub struct CoupledMode {
    /// Circular frequency ω [rad/s].
    pub omega: f64,
    /// Kind.
    pub kind: Kind,
    /// Number within its kind, from 1.
    pub number: usize,
    /// Shape φ, M-normalised, oriented so that Γ ≥ 0.
    pub shape: Vec<f64>,
    /// Participation factor Γ [√kg].
    pub participation: f64,
    /// Effective mass Γ² [kg].
    pub effective_mass: f64,
    /// Height κᵀMφ/Γ of the effective mass from the wall moment [m]; 0 where Γ vanishes.
    pub effective_height: f64,
    /// Share of the surface in the potential energy, 0 to 1.
    pub surface_share: f64,
}

/// Effective masses below this share of ιᵀ M ι have no height.
const NO_MASS: f64 = 1e-12;

/// Modes of `system` by ascending frequency: the lowest `count`, or all that double precision resolves if `None`.
///
/// Errors: matrices that are not positive definite, an eigenvalue solver that does not converge.
pub fn modes(system: &Coupled, count: Option<usize>) -> Result<Vec<CoupledMode>, FeError> {
    let size = system.influence.len();
    let count = count.map(|c| c.min(size));
    let eigen = generalized_eigen(&system.stiffness, &system.mass, count).map_err(failure)?;
    let load = system.mass.times(&system.influence);
    let arm = system.mass.times(&system.moment_arm);
    let total = dot(&load, &system.influence);
    let mut numbers = [0usize; 2];
    Ok((0..eigen.omega.len())
        .map(|j| {
            let omega = eigen.omega[j];
            let mut shape = eigen.vectors.column(j).to_vec();
            let mut participation = dot(&shape, &load);
            if participation < 0.0 {
                participation = -participation;
                shape.iter_mut().for_each(|v| *v = -*v);
            }
            let surface_share = surface_energy(system, &shape) / (omega * omega);
            let kind = if surface_share > 0.5 {
                Kind::Sloshing
            } else {
                Kind::Structural
            };
            numbers[kind as usize] += 1;
            let effective_mass = participation * participation;
            let effective_height = if effective_mass > NO_MASS * total {
                dot(&shape, &arm) / participation
            } else {
                0.0
            };
            CoupledMode {
                omega,
                kind,
                number: numbers[kind as usize],
                shape,
                participation,
                effective_mass,
                effective_height,
                surface_share,
            }
        })
        .collect())
}

/// φ_ηᵀ (ρ g S) φ_η: K is block diagonal in wall and surface.
fn surface_energy(system: &Coupled, shape: &[f64]) -> f64 {
    let range = system.surface.clone();
    let eta = &shape[range.clone()];
    range
        .clone()
        .zip(eta)
        .map(|(j, &value)| value * dot(&system.stiffness.column(j)[range.clone()], eta))
        .sum()
}

/// The mode in the vocabulary of the results folder.
pub fn describe(system: &Coupled, mode: &CoupledMode, damper: &Damper) -> Mode {
    Mode {
        harmonic: system.harmonic,
        kind: mode.kind.id().into(),
        number: mode.number,
        omega: mode.omega,
        period: std::f64::consts::TAU / mode.omega,
        damping: damper.ratio(mode.kind, mode.omega),
        participation: mode.participation,
        effective_mass: mode.effective_mass,
        effective_height: mode.effective_height,
        shape: system.shape_rows.shape(&mode.shape),
    }
}

/// The first mode of a kind.
pub fn first(modes: &[CoupledMode], kind: Kind) -> Option<&CoupledMode> {
    modes.iter().find(|m| m.kind == kind)
}

/// A failure of the linear algebra in the engine's words.
pub(crate) fn failure(error: LinalgError) -> FeError {
    match error {
        LinalgError::NotPositiveDefinite { pivot, size } => FeError::NotPositiveDefinite {
            matrix: format!("stiffness (pivot {pivot} of {size})"),
            cause: "an unknown without stiffness, or a thickness or density out of range".into(),
        },
        other => FeError::Eigen(other.to_string()),
    }
}
