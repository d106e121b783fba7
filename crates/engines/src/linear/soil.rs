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
mod ground;
mod outcome;
mod residual;
#[cfg(test)]
mod tests;
mod twin;
mod under;
mod words;

use std::f64::consts::PI;

use ::soil::SoilError;
use ::soil::disc::{Disc, Soil};
use ::soil::layered::{Embedded, Layer};
use tank::{Case, FoundationKind, Shape, Subsoil, Support};

use crate::FeError;

pub(super) use extend::Rigid;
pub(crate) use floor::Floor;
pub(crate) use ground::Ground;
pub(super) use outcome::outcome;
pub(crate) use outcome::part;
pub use twin::slab_body;
pub(crate) use under::{founded, under};
pub(crate) use words::note;

/// Density of reinforced concrete [kg/m³], EN 1991-1-1:2002 table A.1.
const CONCRETE: f64 = 2500.0;

/// A slab on soil.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct Slab {
    /// Disc on the half-space.
    pub disc: Disc,
    /// Layers, embedment and damping, where there are any.
    pub embedded: Option<Embedded>,
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
        let failed = |e| FeError::Analysis(format!("tank.foundation: {e}"));
        let disc = Disc::new(radius + projection, soil).map_err(failed)?;
        let embedded = embedded(&disc, &case.tank.subsoil).transpose().map_err(failed)?;
        Ok(Some(Slab { disc, embedded, thickness: foundation.thickness.unwrap_or(0.0) }))
    }

    /// Mass [kg].
    pub(crate) fn mass(&self) -> f64 {
        PI * self.disc.radius.powi(2) * self.thickness * CONCRETE
    }

    /// Moment of inertia about a diameter of the underside [kg m²].
    pub(crate) fn inertia(&self) -> f64 {
        self.mass() * (self.disc.radius.powi(2) / 4.0 + self.thickness.powi(2) / 3.0)
    }
}

/// The layers, embedment and damping below a slab; `None` on the surface of a uniform half-space without damping.
fn embedded(disc: &Disc, subsoil: &Subsoil) -> Option<Result<Embedded, SoilError>> {
    if subsoil.is_plain() {
        return None;
    }
    let layer = |layer: &tank::SoilLayer| Layer {
        thickness: layer.thickness,
        soil: Soil {
            density: layer.density,
            shear_wave_velocity: layer.shear_wave_velocity,
            poisson_ratio: layer.poisson_ratio,
            damping: layer.damping,
            depth: None,
        },
    };
    let below = Soil { damping: subsoil.damping, ..disc.soil };
    Some(Embedded::new(disc.radius, subsoil.embedment, subsoil.layers.iter().map(layer).collect(), below))
}
