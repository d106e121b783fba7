//! Normal stress of an interlayer or a contact: full stiffness in compression, nearly zero in tension.
//!
//! ```text
//! σ = E ε              ε ≤ 0, and ε > 0 if it is glued
//! σ = r E ε            ε > 0, no tension; r = 1e-6 keeps the stiffness regular
//! ```
//!
//! The switch may be rounded over |ε| < δ, which gives Newton's method a continuous tangent:
//!
//! ```text
//! dσ/dε = E [½ (1 + r) − ½ (1 − r) ε/δ]          |ε| ≤ δ
//! σ     = ∫ dσ/dε  with σ = E ε at −δ, hence σ(0) = −¼ (1 − r) E δ, and r E (ε − …) beyond δ
//! ```
//!
//! No history, no dissipation: the stress has a potential.

use crate::{Law, LawError, PointState, Response, refuse};

/// Name in errors and files.
const KIND: &str = "interlayer-normal";

/// Stiffness left in tension, as a share of that in compression.
pub const RESIDUAL: f64 = 1e-6;

/// Behaviour of an interlayer in tension.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Opening {
    /// Glued: elastic both ways.
    Glued,
    /// No tension.
    Free {
        /// Share r of the stiffness left in tension, 0 to 1; [`RESIDUAL`] by default.
        residual: f64,
        /// Half width δ ≥ 0 of the rounded switch (strain); 0: a kink.
        rounding: f64,
    },
}

impl Default for Opening {
    fn default() -> Self {
        Opening::Free { residual: RESIDUAL, rounding: 0.0 }
    }
}

/// Normal law of an interlayer.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct NormalLaw {
    modulus: f64,
    residual: f64,
    rounding: f64,
}

impl NormalLaw {
    /// * `modulus`: E [Pa] > 0; stiffness times thickness where the caller works with a gap instead of a strain
    /// * `opening`: tension
    ///
    /// Errors: a parameter out of range.
    pub fn new(modulus: f64, opening: Opening) -> Result<NormalLaw, LawError> {
        if !(modulus > 0.0 && modulus.is_finite()) {
            return Err(refuse(KIND, "modulus", format!("{modulus} Pa"), "> 0 and finite"));
        }
        let (residual, rounding) = match opening {
            Opening::Glued => (1.0, 0.0),
            Opening::Free { residual, rounding } => (residual, rounding),
        };
        if !(0.0..=1.0).contains(&residual) {
            return Err(refuse(KIND, "residual", residual.to_string(), "from 0 to 1"));
        }
        if !(rounding >= 0.0 && rounding.is_finite()) {
            return Err(refuse(KIND, "rounding", rounding.to_string(), "≥ 0 and finite"));
        }
        Ok(NormalLaw { modulus, residual, rounding })
    }

    /// Stress and tangent [Pa] at the strain ε.
    #[inline]
    pub fn at(&self, strain: f64) -> (f64, f64) {
        let NormalLaw { modulus, residual: r, rounding: d } = *self;
        if strain < -d {
            (modulus * strain, modulus)
        } else if strain <= d && d > 0.0 {
            let z = strain / d;
            (
                modulus * (0.5 * (1.0 + r) * strain - 0.25 * (1.0 - r) * d * (1.0 + z * z)),
                modulus * 0.5 * (1.0 + r - (1.0 - r) * z),
            )
        } else {
            // At a kink ε = 0 counts as closed: the stiffness of an untouched wall is full.
            let open = if strain > 0.0 { r } else { 1.0 };
            (modulus * r * strain, modulus * open)
        }
    }
}

impl Law<1> for NormalLaw {
    fn kind(&self) -> &'static str {
        KIND
    }

    #[inline]
    fn respond(&self, strain: &[f64; 1], _old: &[f64], _new: &mut [f64]) -> Result<Response<1>, LawError> {
        let (stress, tangent) = self.at(strain[0]);
        Ok(Response { stress: [stress], tangent: [[tangent]], dissipation: 0.0 })
    }

    /// Damage is the stiffness missing at this strain: 0 closed, 1 − r open.
    fn inspect(&self, strain: &[f64; 1], _history: &[f64]) -> PointState {
        PointState { damage: 1.0 - self.at(strain[0]).1 / self.modulus, ..PointState::default() }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn closed_open_and_glued() {
        let free = NormalLaw::new(2e9, Opening::default()).unwrap();
        assert_eq!(free.at(-1e-3), (-2e6, 2e9));
        assert_eq!(free.at(0.0), (0.0, 2e9));
        let (stress, tangent) = free.at(1e-3);
        assert!((stress / 2.0 - 1.0).abs() < 1e-12 && (tangent / 2e3 - 1.0).abs() < 1e-12);
        assert_eq!(NormalLaw::new(2e9, Opening::Glued).unwrap().at(1e-3), (2e6, 2e9));
    }

    /// The rounded law is continuous, its tangent is the derivative, and beyond ±δ it is the kinked law (σ = r E ε).
    #[test]
    fn rounding_joins_both_branches() {
        let d = 1e-5;
        let law = NormalLaw::new(1.0, Opening::Free { residual: 1e-3, rounding: d }).unwrap();
        for at in [-d, d] {
            let (below, above) = (law.at(at - 1e-12), law.at(at + 1e-12));
            // Two points 2e-12 apart, slope at most 1; the tangent changes by E/(2δ) times that.
            assert!((below.0 - above.0).abs() < 3e-12 && (below.1 - above.1).abs() < 3e-7);
        }
        for strain in [-0.9 * d, 0.0, 0.4 * d, 2.0 * d] {
            let step = 1e-4 * d;
            let slope = (law.at(strain + step).0 - law.at(strain - step).0) / (2.0 * step);
            assert!((slope - law.at(strain).1).abs() < 1e-9);
        }
    }

    #[test]
    fn parameters_out_of_range_are_rejected() {
        let free = |residual, rounding| NormalLaw::new(1.0, Opening::Free { residual, rounding });
        assert!(free(-1e-9, 0.0).is_err() && free(1.5, 0.0).is_err() && free(0.0, -1.0).is_err());
        assert!(NormalLaw::new(f64::INFINITY, Opening::Glued).is_err());
    }
}
