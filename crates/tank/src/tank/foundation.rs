//! What the tank stands on.

use crate::words;
use serde::{Deserialize, Serialize};

words! {
    /// Kind of foundation.
    pub FoundationKind {
        /// The bottom plate lies on soil or on a pad of gravel.
        Soil = "soil",
        /// A ring of concrete under the wall, soil within it.
        RingWall = "ring_wall",
        /// A stiff slab or raft of concrete under the whole bottom.
        Slab = "slab",
    }
}

/// Coefficient of friction under a bottom plate whose file gives none: the largest of API 650 E.7.6.
pub const FRICTION: f64 = 0.4;

/// Foundation and the soil below it.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub struct Foundation {
    /// Kind.
    pub kind: FoundationKind,
    /// Modulus of the ground under the rim of the bottom plate [N/m³].
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub stiffness: Option<f64>,
    /// Velocity V_s of shear waves in the soil at the strains of the earthquake [m/s].
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub shear_wave_velocity: Option<f64>,
    /// Density ρ_s of the soil [kg/m³].
    pub soil_density: f64,
    /// Poisson's ratio ν_s of the soil.
    pub soil_poisson_ratio: f64,
    /// Thickness of the slab, or height of the ring wall [m].
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub thickness: Option<f64>,
    /// Width of a ring wall, or of the compacted pad under the shell, on the ground [m].
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub width: Option<f64>,
    /// Coefficient of friction between the bottom plate and the ground; none where it is left out.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub friction: Option<f64>,
}

/// What the soil under a slab is besides the uniform half-space of [`Foundation`].
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
pub struct Subsoil {
    /// Hysteretic damping ratio ξ_g of the half-space.
    pub damping: f64,
    /// Depth of the underside of the slab below the ground [m].
    pub embedment: f64,
    /// Layers from the ground down, over the half-space.
    pub layers: Vec<SoilLayer>,
}

/// A layer of soil.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub struct SoilLayer {
    /// Thickness [m].
    pub thickness: f64,
    /// V_s [m/s].
    pub shear_wave_velocity: f64,
    /// ρ_s [kg/m³].
    pub density: f64,
    /// ν_s.
    pub poisson_ratio: f64,
    /// ξ_g.
    pub damping: f64,
}

impl Subsoil {
    /// Whether the slab lies on the surface of a uniform half-space without damping.
    pub fn is_plain(&self) -> bool {
        *self == Subsoil::default()
    }
}
