//! A cylinder on a rigid slab on soil, by further unknowns of the coupled system.
//!
//! ```text
//! unknowns   u relative to the slab, x and ψ of the slab's underside, θ of the rocking cone
//!
//!     ⎡ M    f_x   f_ψ   ·  ⎤        ⎡ K            ⎤
//! M = ⎢ f_xᵀ  m     S    ·  ⎥    K = ⎢    K_x       ⎥    C = Σ 2 ξ ω (M φ)(M φ)ᵀ + C_x e_x e_xᵀ + C_θ (e_ψ − e_θ)(e_ψ − e_θ)ᵀ
//!     ⎢ f_ψᵀ  S     J    ·  ⎥        ⎢       K_θ    ⎥
//!     ⎣  ·    ·     ·    M₁ ⎦        ⎣           ·  ⎦
//! ```
//!
//! f_x = M ι and, by reciprocity, f_ψ, the row of the overturning moment, which contains the bottom pressure; m, S, J those of tank, liquid
//! and slab about its underside. The liquid over the turning floor has its own inertia ([`floor`]). C has the modal damping of the tank on
//! a fixed base and couples the modes of the system. The cones are those of [`::soil::disc`].
//!
//! Everything else of the engine runs on this system unchanged. `docs/theory/soil.md`.

mod extend;
mod floor;
mod outcome;
mod residual;
#[cfg(test)]
mod tests;
mod twin;
mod words;

use std::f64::consts::PI;

use ::soil::disc::{Disc, Soil};
use tank::{Case, FoundationKind, Shape, Support};

use super::system::Harmonic;
use crate::FeError;
use crate::damping::Damper;

pub(crate) use floor::Floor;
pub(super) use outcome::outcome;
pub use twin::slab_body;
pub(crate) use words::note;

/// Density of reinforced concrete [kg/m³], EN 1991-1-1:2002 table A.1.
const CONCRETE: f64 = 2500.0;

/// The system of m = 1 on its slab, and that on a fixed base, where there is soil under the slab.
///
/// Errors: as [`Slab::of`] and [`extend::on_soil`].
pub(crate) fn under(case: &Case, damper: &Damper, held: Harmonic) -> Result<(Harmonic, Option<Harmonic>), FeError> {
    let Some(slab) = Slab::of(case)? else { return Ok((held, None)) };
    let (coupled, modes) = extend::on_soil((&held.coupled, &held.modes), case, damper, &slab)?;
    Ok((Harmonic { coupled, modes }, Some(held)))
}

/// A slab on soil.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Slab {
    /// Disc on soil.
    pub disc: Disc,
    /// Thickness [m]; 0 where it is not given.
    pub thickness: f64,
}

impl Slab {
    /// The slab of a case; `None` without one, without the velocity of shear waves, under plane walls or a tank that is not
    /// anchored: the soil under the rim is that of [`::base`] then, and would count twice.
    ///
    /// Errors: values that the input does not let pass.
    pub(crate) fn of(case: &Case) -> Result<Option<Slab>, FeError> {
        let (Shape::Cylinder { radius }, Some(foundation)) = (case.tank.shape, case.tank.foundation) else {
            return Ok(None);
        };
        if case.tank.support == Support::Unanchored {
            return Ok(None);
        }
        let (FoundationKind::Slab, Some(shear_wave_velocity)) = (foundation.kind, foundation.shear_wave_velocity)
        else {
            return Ok(None);
        };
        let projection = case.tank.bottom.as_ref().map_or(0.0, |bottom| bottom.projection);
        let soil = Soil {
            density: foundation.soil_density,
            shear_wave_velocity,
            poisson_ratio: foundation.soil_poisson_ratio,
            damping: 0.0,
            depth: None,
        };
        let disc =
            Disc::new(radius + projection, soil).map_err(|e| FeError::Analysis(format!("tank.foundation: {e}")))?;
        Ok(Some(Slab { disc, thickness: foundation.thickness.unwrap_or(0.0) }))
    }

    /// Mass [kg].
    pub(super) fn mass(&self) -> f64 {
        PI * self.disc.radius.powi(2) * self.thickness * CONCRETE
    }

    /// Moment of inertia about a diameter of the underside [kg m²].
    pub(super) fn inertia(&self) -> f64 {
        self.mass() * (self.disc.radius.powi(2) / 4.0 + self.thickness.powi(2) / 3.0)
    }
}
