//! The ground under the rim.
//!
//! ```text
//! k B = 0.65 E_s/(1 − ν_s²) (E_s B⁴/(E I))^(1/12)          B = 2 (4 D/k)^(1/4) ,  E I = D B
//! ```
//!
//! The rim loads a strip of width B, not the plan of the tank: a modulus from a plate-load test of the whole tank is far too soft.
//! B depends on k, so both are found together. Vesic 1961 for a long beam, here a strip of the plate one B wide.

use crate::error::{BaseError, positive};
use crate::plate::Plate;

/// Elastic half-space.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Soil {
    /// Young's modulus E_s [Pa].
    pub young_modulus: f64,
    /// Poisson's ratio ν_s.
    pub poisson_ratio: f64,
}

impl Soil {
    /// From the velocity of shear waves [m/s] and the density [kg/m³]: G = ρ_s V_s², E_s = 2 (1 + ν_s) G.
    ///
    /// These are moduli of small strains; under a strong earthquake the velocity of the strained soil belongs here (EN 1998-5:2004,
    /// table 4.1).
    pub fn of_waves(velocity: f64, density: f64, poisson_ratio: f64) -> Soil {
        Soil { young_modulus: 2.0 * (1.0 + poisson_ratio) * density * velocity * velocity, poisson_ratio }
    }
}

/// Modulus k of the ground under the rim of `plate` [N/m³].
///
/// Errors: parameters that are not positive.
pub fn subgrade_modulus(soil: Soil, plate: &Plate) -> Result<f64, BaseError> {
    positive("Young's modulus of the soil", soil.young_modulus)?;
    let d = plate.bending_stiffness();
    let e = soil.young_modulus / (1.0 - soil.poisson_ratio * soil.poisson_ratio);
    // A contraction: k enters the right side with the power 5/16.
    let mut k = 1e8;
    for _ in 0..100 {
        let b = 2.0 * (4.0 * d / k).powf(0.25);
        let next = 0.65 * e / b * (soil.young_modulus * b.powi(3) / d).powf(1.0 / 12.0);
        if (next / k - 1.0).abs() < 1e-12 {
            break;
        }
        k = next;
    }
    Ok(k)
}
