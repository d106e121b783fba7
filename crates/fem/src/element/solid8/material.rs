//! Material of a solid: law, density, and damping.

use crate::element::solid8_law::{Law, Tension};

/// Elastic material of a solid.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Elastic {
    /// Stress law.
    pub law: Law,
    /// Density in the reference state ρ₀ [kg/m³], ≥ 0.
    pub density: f64,
    /// Mass-proportional part a_M of the element's own damping [1/s].
    pub damping_mass: f64,
    /// Stiffness-proportional part a_K of the element's own damping [s].
    pub damping_stiffness: f64,
}

impl Elastic {
    /// Isotropic: Young's modulus E [Pa], Poisson's ratio ν, density ρ₀ [kg/m³].
    pub fn isotropic(young_modulus: f64, poisson_ratio: f64, density: f64) -> Elastic {
        Elastic {
            law: Law::Isotropic { young_modulus, poisson_ratio },
            density,
            damping_mass: 0.0,
            damping_stiffness: 0.0,
        }
    }

    /// Stiff along the layer's normal only: modulus [Pa], density ρ₀ [kg/m³].
    pub fn normal_only(e_normal: f64, density: f64) -> Elastic {
        Elastic {
            law: Law::NormalOnly { e_normal, tension: Tension::Full },
            density,
            damping_mass: 0.0,
            damping_stiffness: 0.0,
        }
    }

    /// The same without tension ([`Tension::NONE`]).
    pub fn pressed_only(e_normal: f64, density: f64) -> Elastic {
        Elastic { law: Law::NormalOnly { e_normal, tension: Tension::NONE }, ..Elastic::normal_only(e_normal, density) }
    }

    /// Bonded layer, stiff along its normal and in shear across it: moduli [Pa], density ρ₀ [kg/m³].
    pub fn core(e_normal: f64, shear_modulus: f64, density: f64) -> Elastic {
        Elastic {
            law: Law::Core { e_normal, shear_modulus, e_parallel: 0.0 },
            ..Elastic::normal_only(e_normal, density)
        }
    }

    /// Bonded layer, stiff along its normal, in shear across it and in its plane: moduli [Pa], density ρ₀ [kg/m³].
    pub fn transverse([e_normal, shear_modulus, e_parallel]: [f64; 3], density: f64) -> Elastic {
        Elastic { law: Law::Core { e_normal, shear_modulus, e_parallel }, ..Elastic::normal_only(e_normal, density) }
    }

    /// The same with the element damping C_e = a_M M_e + a_K K_e(0); a_M [1/s], a_K [s].
    pub fn with_damping(self, damping_mass: f64, damping_stiffness: f64) -> Elastic {
        Elastic { damping_mass, damping_stiffness, ..self }
    }
}
