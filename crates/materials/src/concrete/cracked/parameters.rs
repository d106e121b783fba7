//! Parameters of cracking concrete and their ranges.

use crate::check::positive;
use crate::concrete::tension::{Tension, Traction};
use crate::{LawError, refuse};

/// Shear stiffness of cracked concrete, β = b + (1 − b) exp(−m/e_b).
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ShearRetention {
    /// Least share b of G, above 0 to 1.
    pub least: f64,
    /// Opening strain e_b > 0.
    pub strain: f64,
}

impl Default for ShearRetention {
    fn default() -> Self {
        ShearRetention { least: 0.1, strain: 2e-4 }
    }
}

/// Axes of cracks.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum CrackAxes {
    /// Fixed when the first crack begins.
    #[default]
    Fixed,
    /// Rotating with the strain until a crack is wider than 2 f_t/E, then fixed.
    Turning,
}

/// Surface of plastic compression.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Envelope {
    /// Drucker and Prager's cone through f_c and f_bc.
    #[default]
    DruckerPrager,
    /// The biaxial envelope of Kupfer and Gerstle through f_c and f_bc.
    Kupfer,
}

/// Parameters of [`super::CrackedConcrete`].
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct CrackedParameters {
    /// Young's modulus E [Pa] > 0.
    pub young_modulus: f64,
    /// Poisson's ratio ν, 0 ≤ ν < 0.5.
    pub poisson_ratio: f64,
    /// Compressive strength f_c [Pa] > 0.
    pub compressive_strength: f64,
    /// f_bc/f_c, 1 to 1.5.
    pub biaxial_ratio: f64,
    /// Surface of compression.
    pub envelope: Envelope,
    /// Tension; f_t below f_c/2, so that cracks come before the tip of the cone.
    pub tension: Tension,
    /// Shear across cracks.
    pub retention: ShearRetention,
    /// Axes of cracks.
    pub axes: CrackAxes,
    /// Sides of the cell along axes 1 and 2 [m], > 0: a crack is then smeared over the side next to its normal
    /// ([`super::super::crack_band`]) instead of the size of [`super::super::Softening::Energy`], which is the longer side.
    pub sides: Option<[f64; 2]>,
}

impl CrackedParameters {
    /// Defaults for the optional parameters: f_bc = 1.16 f_c (Kupfer, Hilsdorf & Rüsch 1969), b = 0.1,
    /// e_b = 2e-4, fixed axes.
    pub fn new(
        young_modulus: f64,
        poisson_ratio: f64,
        compressive_strength: f64,
        tension: Tension,
    ) -> CrackedParameters {
        CrackedParameters {
            young_modulus,
            poisson_ratio,
            compressive_strength,
            biaxial_ratio: 1.16,
            envelope: Envelope::default(),
            tension,
            retention: ShearRetention::default(),
            axes: CrackAxes::default(),
            sides: None,
        }
    }

    /// Rejects parameters out of range; otherwise returns the traction of the cracks.
    pub(super) fn check(&self, law: &'static str) -> Result<Traction, LawError> {
        positive(law, "youngs_modulus", self.young_modulus, "Pa")?;
        positive(law, "compressive_strength", self.compressive_strength, "Pa")?;
        if !(0.0..0.5).contains(&self.poisson_ratio) {
            return Err(refuse(law, "poisson_ratio", self.poisson_ratio.to_string(), "from 0 to below 0.5"));
        }
        if !(1.0..=1.5).contains(&self.biaxial_ratio) {
            return Err(refuse(law, "biaxial_ratio", self.biaxial_ratio.to_string(), "from 1 to 1.5"));
        }
        let traction = Traction::new(law, self.young_modulus, &self.tension)?;
        if self.tension.strength >= 0.5 * self.compressive_strength {
            return Err(refuse(
                law,
                "tensile_strength",
                format!("{} Pa", self.tension.strength),
                &format!("below half the compressive strength, {} Pa", 0.5 * self.compressive_strength),
            ));
        }
        if let Some(sides) = self.sides {
            positive(law, "side of the cell", sides[0].min(sides[1]), "m")?;
        }
        let ShearRetention { least, strain } = self.retention;
        if !(least > 0.0 && least <= 1.0) {
            return Err(refuse(law, "shear retention, least", least.to_string(), "above 0, at most 1"));
        }
        positive(law, "shear retention, strain", strain, "")?;
        Ok(traction)
    }
}
