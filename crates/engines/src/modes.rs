//! Coupled modes, sorted into sloshing and structural ones.
//!
//! ```text
//! γ_j = φ_jᵀ M ι        effective mass γ_j²        effective height φ_jᵀ M κ / γ_j        (φ_jᵀ M φ_j = 1)
//! sloshing:  ηᵀ ρ g S η > ½ φ_jᵀ K φ_j, the surface holds more than half of the potential energy
//! ```
//!
//! A displacement liquid resists rotation by a penalty; its modes that live on it are sorted out as *rotational*.
//!
//! With m = 0 the "effective mass" is that of the load of vertical motion, hydrostatic pressure and wall weight.

use tank::Case;

use crate::FeError;
use crate::coupled::{Coupled, Part};
use crate::error::failure;
use fem::linalg::{dot, generalized_eigen};
use results::Mode;

/// Part of the model that stores a mode's potential energy.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum Kind {
    /// Gravity at the free surface.
    Sloshing,
    /// Elasticity of the wall.
    Structural,
    /// The penalty against rotation of a displacement liquid: a mode that the liquid itself does not have.
    Rotational,
}

impl Kind {
    /// `sloshing`, `structural` or `rotational`.
    pub fn id(self) -> &'static str {
        match self {
            Kind::Sloshing => "sloshing",
            Kind::Structural => "structural",
            Kind::Rotational => "rotational",
        }
    }
}

/// A coupled mode with its vector.
#[derive(Clone, Debug, PartialEq)]
pub struct CoupledMode {
    /// Kind.
    pub kind: Kind,
    /// Number within its kind, from 1, by ascending frequency.
    pub number: usize,
    /// Circular frequency [rad/s].
    pub omega: f64,
    /// Shape φ, φᵀ M φ = 1.
    pub vector: Vec<f64>,
    /// Participation factor γ [√kg].
    pub participation: f64,
    /// Effective height [m]; 0 if the mode has no effective mass.
    pub effective_height: f64,
    /// Share of the potential energy in the surface.
    pub surface_share: f64,
    /// Its share of dashpots that hold all damping of the system, in place of the ratio of its kind; none where the ratio is that.
    pub damping: Option<f64>,
}

/// The lowest `count` modes of a coupled system (all that are resolved if `None`), by ascending frequency.
///
/// Errors: K not positive definite, or a mode that fails its residual check.
pub fn solve(coupled: &Coupled, count: Option<usize>) -> Result<Vec<CoupledMode>, FeError> {
    let eigen =
        generalized_eigen(&coupled.stiffness, &coupled.mass, count).map_err(failure("the coupled stiffness matrix"))?;
    let load = coupled.mass.times(&coupled.influence);
    let moment = coupled.mass.times(&coupled.moment_arm);
    let total = dot(&load, &coupled.influence);
    let (mut sloshing, mut structural, mut rotational) = (0, 0, 0);
    let mode = |(j, &omega): (usize, &f64)| {
        let vector = eigen.vectors.column(j).to_vec();
        // φᵀ M φ = 1, so that φᵀ K φ = ω².
        let share = |part: &Part| part.energy(&vector) / (omega * omega);
        let surface_share = share(&coupled.surface);
        let (kind, counter) = if surface_share > 0.5 {
            (Kind::Sloshing, &mut sloshing)
        } else if coupled.rotation.as_ref().is_some_and(|part| share(part) > 0.5) {
            (Kind::Rotational, &mut rotational)
        } else {
            (Kind::Structural, &mut structural)
        };
        *counter += 1;
        let participation = dot(&vector, &load);
        // Below this share of the mass a height is a quotient of rounding errors.
        let carries_mass = participation * participation > 1e-12 * total;
        CoupledMode {
            kind,
            number: *counter,
            omega,
            participation,
            effective_height: if carries_mass { dot(&vector, &moment) / participation } else { 0.0 },
            surface_share,
            damping: None,
            vector,
        }
    };
    Ok(eigen.omega.iter().enumerate().map(mode).collect())
}

impl CoupledMode {
    /// Effective mass γ² [kg].
    pub fn effective_mass(&self) -> f64 {
        self.participation * self.participation
    }

    /// The mode in the vocabulary of the results folder, with the damping ratio of its kind.
    pub fn to_result(&self, coupled: &Coupled, case: &Case) -> Mode {
        Mode {
            harmonic: coupled.harmonic,
            axial: None,
            kind: self.kind.id().into(),
            number: self.number,
            omega: self.omega,
            period: 2.0 * std::f64::consts::PI / self.omega,
            damping: match self.kind {
                Kind::Sloshing => case.damping.sloshing,
                Kind::Structural | Kind::Rotational => case.damping.impulsive,
            },
            participation: self.participation,
            effective_mass: self.participation * self.participation,
            effective_height: self.effective_height,
            shape: coupled.shape_rows.shape(&self.vector),
        }
    }
}
