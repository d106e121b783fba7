//! Stress laws of steel, concrete, reinforcement and interlayers.
//!
//! A law is a pure function
//!
//! ```text
//! (strain, history) → (stress, consistent tangent, new history, dissipation of the step)
//! ```
//!
//! It is independent of the element and stateless: the caller owns the history and commits it with the converged
//! step. Strains and stresses are components in an orthonormal frame, shears as engineering strains:
//!
//! ```text
//! N = 1   ε                              bars, fibres
//! N = 3   ε_11 ε_22 γ_12                 layers, plane stress (σ_33 = σ_13 = σ_23 = 0)
//! N = 6   ε_11 ε_22 ε_33 γ_12 γ_23 γ_13  solids
//! ```
//!
//! Units are SI throughout: stresses and moduli [Pa], strains [-], lengths [m], fracture energies [N/m], dissipation [J/m³].

pub mod bar;
mod check;
pub mod concrete;
pub mod dougill;
pub mod drucker_prager;
pub mod elastic;
pub mod grades;
pub mod interlayer;
mod modes;
pub mod plane_stress;
pub mod plastic_fracturing;
mod range;
pub mod two_surface;
pub mod von_mises;

pub use range::ElasticRange;

use std::fmt::Debug;

/// Response of a law.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Response<const N: usize> {
    /// Stress [Pa].
    pub stress: [f64; N],
    /// Algorithmic tangent ∂σ/∂ε [Pa] of this step.
    pub tangent: [[f64; N]; N],
    /// Energy dissipated in this step [J/m³], ≥ 0 up to rounding.
    pub dissipation: f64,
}

impl<const N: usize> Default for Response<N> {
    fn default() -> Self {
        Response { stress: [0.0; N], tangent: [[0.0; N]; N], dissipation: 0.0 }
    }
}

/// A crack at a point.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Crack {
    /// Angle of the crack's normal from axis 1, counter-clockwise [rad].
    pub angle: f64,
    /// Present opening strain, ≥ 0.
    pub opening: f64,
    /// Largest opening strain so far, ≥ 0.
    pub largest: f64,
}

/// State of a point for output.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct PointState {
    /// Accumulated equivalent plastic strain, ≥ 0.
    pub plastic_strain: f64,
    /// Stress over strength: 1 on the yield or failure surface.
    pub utilisation: f64,
    /// Cracks that have opened at least once; at most two.
    pub cracks: [Option<Crack>; 2],
    /// Loss of stiffness, from 0 to 1.
    pub damage: f64,
    /// Largest strain in tension so far over the strain at rupture; 0 where the law has none.
    pub rupture: f64,
}

/// Failure of a law.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
pub enum LawError {
    /// A parameter out of range.
    #[error("{law}: {parameter} is {found}, allowed {allowed}")]
    Parameter {
        /// The law.
        law: &'static str,
        /// Name of the parameter.
        parameter: &'static str,
        /// Found, with unit.
        found: String,
        /// Allowed, with unit.
        allowed: String,
    },
    /// The local iteration has not converged, substeps included.
    #[error("{law}: no stress found for a strain increment of {increment:.2e}")]
    NoConvergence {
        /// The law.
        law: &'static str,
        /// Norm of the strain increment.
        increment: f64,
    },
}

/// A stress law.
pub trait Law<const N: usize>: Debug + Send + Sync {
    /// Kind, as users name it.
    fn kind(&self) -> &'static str;

    /// Number of history variables of one point.
    fn history_len(&self) -> usize {
        0
    }

    /// Writes the initial history; zeros by default.
    fn init_history(&self, slots: &mut [f64]) {
        slots.fill(0.0);
    }

    /// Whether σ = C ε with one C for all time, without history: such a law can be integrated beforehand.
    fn is_linear(&self) -> bool {
        false
    }

    /// Strains in which a point without a past is elastic, if the law can tell.
    fn elastic_range(&self) -> Option<&dyn ElasticRange<N>> {
        None
    }

    /// Stress, tangent and dissipation at the total strain `strain`, with the committed history `old`; writes the new
    /// history. `old` and `new` have [`Law::history_len`] slots. Equal input gives bit-identical output.
    ///
    /// Errors: no stress found.
    fn respond(&self, strain: &[f64; N], old: &[f64], new: &mut [f64]) -> Result<Response<N>, LawError>;

    /// [`Law::respond`] of points whose histories stand one after another: one call in place of one a point.
    ///
    /// Errors: those of the first point that fails.
    fn respond_row(
        &self,
        strains: &[[f64; N]],
        old: &[f64],
        new: &mut [f64],
        out: &mut [Response<N>],
    ) -> Result<(), LawError> {
        let slots = self.history_len();
        for (i, (strain, response)) in strains.iter().zip(out).enumerate() {
            let own = i * slots..(i + 1) * slots;
            *response = self.respond(strain, &old[own.clone()], &mut new[own])?;
        }
        Ok(())
    }

    /// State for output of a point with this strain and committed history.
    fn inspect(&self, _strain: &[f64; N], _history: &[f64]) -> PointState {
        PointState::default()
    }
}

/// Refuses a parameter.
pub(crate) fn refuse(law: &'static str, parameter: &'static str, found: String, allowed: &str) -> LawError {
    LawError::Parameter { law, parameter, found, allowed: allowed.to_owned() }
}
