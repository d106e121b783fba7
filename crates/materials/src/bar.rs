//! Reinforcing bar: bilinear, kinematic hardening, with a rupture strain.
//!
//! ```text
//! trial  σ = E (ε − ε_p) ,   |σ − b| > f_y :   Δg = (|σ − b| − f_y)/(E + H) ,   H = E E_T/(E − E_T)
//! ε_p += Δg sign ,   b = H ε_p ,   tangent E H/(E + H) = E_T
//! ```
//!
//! The return is exact for any increment. Dissipation f_y Δg: hardening stores its part of the work.
//!
//! The rupture strain ε_su is a total strain in tension. By default exceeding it is only recorded
//! ([`Bar::ruptured`]); optionally the bar is removed, and its stored energy ½ E ε_e² + ½ H ε_p² counts as
//! dissipated.
//!
//! Source: Prager 1956 (kinematic hardening); Simo & Hughes 1998 box 1.5.

use crate::check::{below, positive};
use crate::{Law, LawError, PointState, Response};

const KIND: &str = "bar";

/// Effect of exceeding the rupture strain.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Rupture {
    /// It is recorded; the bar keeps its stress.
    #[default]
    Recorded,
    /// The bar is removed.
    Drops,
}

/// Bilinear bar; `Law<1>`.
///
/// History: ε_p, the largest strain so far.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Bar {
    young_modulus: f64,
    yield_stress: f64,
    hardening: f64,
    rupture_strain: f64,
    rupture: Rupture,
}

impl Bar {
    /// * `young_modulus` E [Pa] > 0
    /// * `yield_stress` f_y [Pa] > 0
    /// * `tangent_modulus` E_T [Pa], 0 ≤ E_T < E
    ///
    /// Errors: a parameter out of range.
    pub fn new(young_modulus: f64, yield_stress: f64, tangent_modulus: f64) -> Result<Bar, LawError> {
        positive(KIND, "youngs_modulus", young_modulus, "Pa")?;
        positive(KIND, "yield_stress", yield_stress, "Pa")?;
        below(KIND, "tangent_modulus", tangent_modulus, [0.0, young_modulus], "Pa")?;
        Ok(Bar {
            young_modulus,
            yield_stress,
            hardening: young_modulus * tangent_modulus / (young_modulus - tangent_modulus),
            rupture_strain: f64::INFINITY,
            rupture: Rupture::Recorded,
        })
    }

    /// Sets the rupture strain and the effect of exceeding it.
    ///
    /// * `rupture_strain` ε_su, above the yield strain f_y/E
    ///
    /// Errors: a parameter out of range.
    pub fn with_rupture(mut self, rupture_strain: f64, rupture: Rupture) -> Result<Bar, LawError> {
        let yield_strain = self.yield_stress / self.young_modulus;
        below(KIND, "rupture_strain", rupture_strain, [yield_strain, f64::INFINITY], "")?;
        self.rupture_strain = rupture_strain;
        self.rupture = rupture;
        Ok(self)
    }

    /// Young's modulus E [Pa].
    pub fn young_modulus(&self) -> f64 {
        self.young_modulus
    }

    /// Yield stress f_y [Pa].
    pub fn yield_stress(&self) -> f64 {
        self.yield_stress
    }

    /// Whether a bar of this history has exceeded its rupture strain.
    pub fn ruptured(&self, history: &[f64]) -> bool {
        history[1] >= self.rupture_strain
    }

    fn gone(&self, history: &[f64]) -> bool {
        self.rupture == Rupture::Drops && self.ruptured(history)
    }
}

impl Law<1> for Bar {
    fn kind(&self) -> &'static str {
        KIND
    }

    fn history_len(&self) -> usize {
        2
    }

    #[inline(always)]
    fn respond(&self, strain: &[f64; 1], old: &[f64], new: &mut [f64]) -> Result<Response<1>, LawError> {
        let (e, h) = (self.young_modulus, self.hardening);
        let strain = strain[0];
        if !strain.is_finite() {
            return Err(LawError::NoConvergence { law: KIND, increment: strain });
        }
        new.copy_from_slice(old);
        new[1] = old[1].max(strain);
        if self.gone(old) {
            return Ok(Response::default());
        }
        let trial = e * (strain - old[0]);
        let xi = trial - h * old[0];
        let excess = xi.abs() - self.yield_stress;
        let mut response = Response { stress: [trial], tangent: [[e]], dissipation: 0.0 };
        // 10⁻¹² of f_y is rounding.
        if excess > 1e-12 * self.yield_stress {
            let flow = excess / (e + h);
            new[0] = old[0] + flow * xi.signum();
            response.stress = [e * (strain - new[0])];
            response.tangent = [[e * h / (e + h)]];
            response.dissipation = self.yield_stress * flow;
        }
        if self.gone(new) {
            let stored = 0.5 * response.stress[0] * response.stress[0] / e + 0.5 * h * new[0] * new[0];
            return Ok(Response { dissipation: response.dissipation + stored, ..Response::default() });
        }
        Ok(response)
    }

    fn inspect(&self, strain: &[f64; 1], history: &[f64]) -> PointState {
        let gone = self.gone(history);
        let xi = self.young_modulus * (strain[0] - history[0]) - self.hardening * history[0];
        PointState {
            plastic_strain: history[0].abs(),
            utilisation: if gone { 0.0 } else { xi.abs() / self.yield_stress },
            damage: f64::from(u8::from(gone)),
            rupture: history[1] / self.rupture_strain,
            ..PointState::default()
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// By hand: E = 200, f_y = 1, E_T = 20.
    #[test]
    fn bilinear_by_hand() {
        let law = Bar::new(200.0, 1.0, 20.0).unwrap();
        let (mut a, mut b) = ([0.0; 2], [0.0; 2]);
        let up = law.respond(&[0.015], &[0.0; 2], &mut a).unwrap();
        let down = law.respond(&[-0.005], &a, &mut b).unwrap();
        assert!((up.stress[0] - 1.2).abs() < 1e-12 && (up.tangent[0][0] - 20.0).abs() < 1e-12);
        assert!((down.stress[0] + 1.0).abs() < 1e-12);
    }

    /// Recorded only, and dropped: then all work done on the bar, ½·0.005·1 + 1·0.095, is dissipated (ideal plasticity).
    #[test]
    fn rupture_is_recorded_or_drops_the_bar() {
        let law = Bar::new(200.0, 1.0, 0.0).unwrap();
        let kept = law.with_rupture(0.1, Rupture::Recorded).unwrap();
        let mut new = [0.0; 2];
        let stress = kept.respond(&[0.1], &[0.0; 2], &mut new).unwrap().stress[0];
        assert!((stress - 1.0).abs() < 1e-12 && kept.ruptured(&new) && kept.inspect(&[0.1], &new).damage == 0.0);
        // A recorded rupture is visible and persists after unloading.
        assert_eq!(kept.inspect(&[0.1], &new).rupture, 1.0);
        assert_eq!(kept.inspect(&[0.0], &new).rupture, 1.0);
        assert_eq!(law.inspect(&[0.1], &new).rupture, 0.0);

        let lost = law.with_rupture(0.1, Rupture::Drops).unwrap();
        let (mut before, mut after) = ([0.0; 2], [0.0; 2]);
        let first = lost.respond(&[0.0999], &[0.0; 2], &mut before).unwrap();
        assert!(!lost.ruptured(&before) && (first.stress[0] - 1.0).abs() < 1e-12);
        let last = lost.respond(&[0.1], &before, &mut after).unwrap();
        assert!(last.stress[0] == 0.0 && lost.inspect(&[0.1], &after).damage == 1.0);
        assert!((first.dissipation + last.dissipation - 0.0975).abs() < 1e-12);
        assert_eq!(lost.respond(&[0.0], &after, &mut new).unwrap().stress[0], 0.0);
    }

    #[test]
    fn parameters_out_of_range_are_rejected() {
        assert!(Bar::new(0.0, 1.0, 0.0).is_err() && Bar::new(1.0, f64::NAN, 0.0).is_err());
        assert!(Bar::new(1.0, 1.0, 1.0).is_err());
        let law = Bar::new(200.0, 1.0, 0.0).unwrap();
        assert_eq!(
            law.with_rupture(0.001, Rupture::Drops).unwrap_err().to_string(),
            "bar: rupture_strain is 0.001, allowed at least 0.005 and below inf"
        );
    }
}
