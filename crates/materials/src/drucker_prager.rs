//! Drucker and Prager's cone for concrete in compression: plane stress and solid, associated flow, ideally plastic or with
//! linear kinematic hardening.
//!
//! ```text
//! F = √J_2(σ − ρ) + α I_1(σ − ρ) − k ≤ 0 ,   ε_p' = λ n ,  n = ∂F/∂σ ,   ρ' = c ε_p' (tensors, all components)
//! α = (f_bc − f_c)/(√3 (2 f_bc − f_c)) ,   k = f_c f_bc/(√3 (2 f_bc − f_c))
//! ```
//!
//! f_c and f_bc are the uniaxial and the biaxial strength. The cone alone carries k/(1/√3 + α) in tension, 0.78 f_c
//! for f_bc = 1.16 f_c: combine it with a crack law.
//!
//! In plane stress ρ_zz is not zero, because the material flows through the thickness. Since n : n = ½ + 3α² and F is
//! homogeneous, the back stress of a step acts like a growth of the cone about the centre at its beginning:
//!
//! ```text
//! √J_2(η) + α I_1(η) − k − c (½ + 3α²) λ = 0 ,   η = σ − ρ_n
//! ```
//!
//! In plane stress the return is two scalar equations (`plane.rs`), in the solid it is explicit, on the cone as at
//! its apex I_1 = k/α. The apex is out of reach in plane stress without hardening: α < 1/√12 is required, so that the
//! plane section of the cone is closed.
//!
//! Dissipation (σ − ρ) : ε_p' = k λ ≥ 0; ½ ρ : ρ/c is stored.
//!
//! Source: Drucker & Prager 1952; calibration after Kupfer, Hilsdorf & Rüsch 1969 (f_bc = 1.16 f_c).

pub(crate) mod plane;
mod solid;
#[cfg(test)]
mod tests;

use crate::check::{below, positive, within};
use crate::elastic::Elastic;
use crate::modes::Modes;
use crate::{Law, LawError, PointState, Response};

const KIND: &str = "drucker_prager";

/// Relative excess of the surface taken for rounding.
pub(crate) const ON_SURFACE: f64 = 1e-12;

/// Drucker-Prager law; `Law<3>` and `Law<6>`.
///
/// History: the accumulated plastic strain (of uniaxial compression), ε_p (in plane stress xx, yy, xy, zz).
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct DruckerPrager {
    elastic: Elastic,
    cone: Cone,
    hardening: f64,
    modes: Modes<3>,
}

/// α and k.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Cone {
    /// α, 0 ≤ α < 1/√12.
    pub alpha: f64,
    /// k [Pa] > 0.
    pub k: f64,
}

impl Cone {
    /// * `strength` f_c [Pa] > 0, uniaxial, as a positive number
    /// * `biaxial` f_bc [Pa], f_c ≤ f_bc ≤ 1.5 f_c
    ///
    /// Errors: a parameter out of range.
    pub fn of_strengths(strength: f64, biaxial: f64) -> Result<Cone, LawError> {
        positive(KIND, "f_c", strength, "Pa")?;
        within(KIND, "f_bc", biaxial, [strength, 1.5 * strength], "Pa")?;
        let under = 3f64.sqrt() * (2.0 * biaxial - strength);
        Ok(Cone { alpha: (biaxial - strength) / under, k: strength * biaxial / under })
    }

    /// Plastic strain in uniaxial compression for a multiplier of 1: 1/√3 − α.
    pub fn uniaxial(&self) -> f64 {
        1.0 / 3f64.sqrt() - self.alpha
    }
}

impl DruckerPrager {
    /// Ideally plastic.
    ///
    /// * `young_modulus` E [Pa] > 0
    /// * `poisson_ratio` ν, −1 < ν < 0.5
    /// * `strength` f_c [Pa] > 0, as a positive number
    /// * `biaxial` f_bc [Pa], f_c ≤ f_bc ≤ 1.5 f_c; usually 1.16 f_c (Kupfer, Hilsdorf & Rüsch 1969)
    ///
    /// Errors: a parameter out of range.
    pub fn new(young_modulus: f64, poisson_ratio: f64, strength: f64, biaxial: f64) -> Result<DruckerPrager, LawError> {
        DruckerPrager::of_cone(young_modulus, poisson_ratio, Cone::of_strengths(strength, biaxial)?)
    }

    /// Ideally plastic, of given α and k.
    ///
    /// Errors: a parameter out of range.
    pub fn of_cone(young_modulus: f64, poisson_ratio: f64, cone: Cone) -> Result<DruckerPrager, LawError> {
        let elastic = Elastic::new(young_modulus, poisson_ratio)?;
        below(KIND, "alpha", cone.alpha, [0.0, 1.0 / 12f64.sqrt()], "")?;
        positive(KIND, "k", cone.k, "Pa")?;
        Ok(DruckerPrager { elastic, cone, hardening: 0.0, modes: Modes::plane(&elastic) })
    }

    /// Linear kinematic hardening ρ' = c ε_p', without bound. In plane stress a tensile flow of about k/(3 α c)
    /// brings the state to the apex, where the law returns an error.
    ///
    /// * `modulus` c [Pa] ≥ 0
    ///
    /// Errors: a parameter out of range.
    pub fn with_hardening(mut self, modulus: f64) -> Result<DruckerPrager, LawError> {
        self.hardening = below(KIND, "hardening_modulus", modulus, [0.0, f64::INFINITY], "Pa")?;
        Ok(self)
    }

    /// The cone.
    pub fn cone(&self) -> Cone {
        self.cone
    }

    /// Elastic part.
    pub fn elastic(&self) -> &Elastic {
        &self.elastic
    }

    /// c (½ + 3α²).
    fn growth(&self) -> f64 {
        self.hardening * (0.5 + 3.0 * self.cone.alpha * self.cone.alpha)
    }

    /// Trial stress, centre of the cone and its strength, in plane stress along the modes.
    fn trial(&self, strain: &[f64; 3], old: &[f64]) -> ([f64; 3], [f64; 3], f64) {
        let total = Modes::split(strain);
        let plastic = Modes::split(&[old[1], old[2], old[3]]);
        let c = self.hardening;
        let rho_zz = c * old[4];
        let trial = std::array::from_fn(|i| self.modes.c[i] * (total[i] - plastic[i]));
        // Tensor shear of ρ: half the engineering strain.
        let centre = Modes::split(&[c * old[1] - rho_zz, c * old[2] - rho_zz, 0.5 * c * old[3]]);
        (trial, centre, self.cone.k + 3.0 * self.cone.alpha * rho_zz)
    }
}

impl Law<3> for DruckerPrager {
    fn kind(&self) -> &'static str {
        KIND
    }

    fn history_len(&self) -> usize {
        5
    }

    fn respond(&self, strain: &[f64; 3], old: &[f64], new: &mut [f64]) -> Result<Response<3>, LawError> {
        let (trial, centre, strength) = self.trial(strain, old);
        let eta: [f64; 3] = std::array::from_fn(|i| trial[i] - centre[i]);
        new.copy_from_slice(old);
        if plane::measure(self.cone.alpha, eta) <= strength + ON_SURFACE * self.cone.k {
            return Ok(Response { stress: Modes::join(&trial), tangent: self.modes.moduli, dissipation: 0.0 });
        }
        let growth = self.growth();
        let step = plane::plastic_step(&self.modes, self.cone.alpha, trial, centre, |lambda| {
            (strength + growth * lambda, growth)
        })
        // Beyond that η and ξ point in opposite directions: the apex.
        .filter(|step| step.root > 0.5 * self.hardening * step.multiplier)
        .ok_or_else(|| LawError::NoConvergence {
            law: KIND,
            increment: plane::measure(0.0, eta) / self.elastic.young_modulus(),
        })?;
        let flow = Modes::join(&step.normal.map(|n| step.multiplier * n));
        new[0] += step.multiplier * self.cone.uniaxial();
        for i in 0..3 {
            new[1 + i] += flow[i];
        }
        new[4] += step.multiplier * step.normal_zz;
        Ok(Response {
            stress: Modes::join(&step.stress),
            tangent: plane::join_matrix(&step.tangent),
            dissipation: self.cone.k * step.multiplier,
        })
    }

    fn inspect(&self, strain: &[f64; 3], history: &[f64]) -> PointState {
        let (trial, centre, strength) = self.trial(strain, history);
        let eta = std::array::from_fn(|i| trial[i] - centre[i]);
        let excess = plane::measure(self.cone.alpha, eta) - strength;
        PointState {
            plastic_strain: history[0],
            utilisation: (1.0 + excess / self.cone.k).max(0.0),
            ..PointState::default()
        }
    }
}
