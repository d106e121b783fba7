//! Concrete that flows and loses stiffness in compression: the cone of Drucker and Prager for the effective stress, and
//! scalar damage.
//!
//! ```text
//! σ = (1 − d) σ_eff ,   σ_eff = C (ε − ε_p) ,   √J_2(σ_eff) + α I_1(σ_eff) = η s(a) ,   η = 1/√3 − α ,   a' = η λ
//! ```
//!
//! s(a) and d(a) are such that uniaxial compression follows an envelope σ_env, and unloads to the plastic strain
//! measured by Karsan and Jirsa. With x = ε/ε_0 (ε_0: strain at the peak) and w = a/ε_0:
//!
//! ```text
//! w = 0.145 x² + 0.13 x                                       x ≥ ½
//! w = 0.275 (x − x_0) ,  x_0 = 0.132                          x < ½: the tangent at ½, elastic below x_0
//! s = E ε_0 (x − w)                                           up to x = 3, where it is greatest; then constant
//! 1 − d = min(1, σ_env/s)
//! σ_env = f_c (κ x − x²)/(1 + (κ − 2) x) , κ = 1.05 E ε_0/f_c    x ≤ 1 (Sargin)
//! σ_env = f_c max(0.2, 1 − (x − 1) ε_0 f_c h/(2 G_c))            beyond: crushing energy G_c over the length h
//! ```
//!
//! The formula of Karsan and Jirsa has plastic strain from the first load on; the tangent at x = ½ gives the cone an
//! initial size and keeps all measured points. Where σ_env exceeds s (small x, or strong concrete with small E
//! ε_0/f_c) the damage is zero and the stress is s.
//!
//! Dissipation (1 − d) η s λ + ½ σ_eff : C⁻¹ σ_eff d' ≥ 0: hardening does not store energy. The tangent is not symmetric where
//! damage grows.
//!
//! Limits: compression only. In tension the law flows at about 0.2 f_c or more: combine it with a crack law. It
//! replaces the plastic-fracturing law of Bažant & Kim 1979, whose fracturing decrement alone does not define the
//! loss of stiffness.
//!
//! Source: Karsan & Jirsa 1969; Sargin 1971; Bažant & Kim 1979; Drucker & Prager 1952. Checks: row M4.

use crate::check::{positive, within};
use crate::drucker_prager::{Cone, ON_SURFACE, plane};
use crate::elastic::Elastic;
use crate::modes::Modes;
use crate::{Law, LawError, PointState, Response};

const KIND: &str = "plastic_fracturing";

/// x below which the tangent of Karsan and Jirsa's parabola is used.
const X_TANGENT: f64 = 0.5;
/// Its slope there, 0.29 x + 0.13.
const SLOPE: f64 = 0.275;
/// Its value there.
const W_TANGENT: f64 = 0.101_25;
/// Greatest effective stress: 0.87 x − 0.145 x² has its top here.
const X_TOP: f64 = 3.0;
/// Residual strength over f_c.
const RESIDUAL: f64 = 0.2;

/// Plastic strain over ε_0 left by unloading at x = ε/ε_0 (Karsan & Jirsa 1969).
pub fn karsan_jirsa(x: f64) -> f64 {
    0.145 * x * x + 0.13 * x
}

/// Plastic-fracturing law; `Law<3>`.
///
/// History: a, ε_p (xx, yy, xy), d.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct PlasticFracturing {
    elastic: Elastic,
    modes: Modes<3>,
    alpha: f64,
    strength: f64,
    peak_strain: f64,
    /// Strain from the peak to the zero of the falling line.
    fall: f64,
}

/// Parameters; see the fields.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Parameters {
    /// Young's modulus E [Pa] > 0.
    pub young_modulus: f64,
    /// Poisson's ratio ν, −1 < ν < 0.5.
    pub poisson_ratio: f64,
    /// Uniaxial strength f_c [Pa] > 0, as a positive number.
    pub strength: f64,
    /// Biaxial strength f_bc [Pa], f_c ≤ f_bc ≤ 1.5 f_c.
    pub biaxial: f64,
    /// Strain at the peak ε_0, as a positive number, from 1.38 f_c/E (below, the effective stress does not reach f_c) to
    /// 10 f_c/E.
    pub peak_strain: f64,
    /// Crushing energy G_c [N/m] > 0, about 250 G_f.
    pub crushing_energy: f64,
    /// Length h over which it is spread [m], from 0 to 2 E G_c/f_c² (beyond, the line falls more steeply than E).
    pub length: f64,
}

impl PlasticFracturing {
    /// Errors: a parameter out of range.
    pub fn new(p: &Parameters) -> Result<PlasticFracturing, LawError> {
        let elastic = Elastic::new(p.young_modulus, p.poisson_ratio)?;
        let cone = Cone::of_strengths(p.strength, p.biaxial)?;
        let yield_strain = p.strength / p.young_modulus;
        within(KIND, "peak_strain", p.peak_strain, [1.38 * yield_strain, 10.0 * yield_strain], "")?;
        positive(KIND, "crushing_energy", p.crushing_energy, "N/m")?;
        positive(KIND, "length", p.length, "m")?;
        let longest = 2.0 * p.crushing_energy * p.young_modulus / (p.strength * p.strength);
        within(KIND, "length", p.length, [0.0, longest], "m")?;
        Ok(PlasticFracturing {
            elastic,
            modes: Modes::plane(&elastic),
            alpha: cone.alpha,
            strength: p.strength,
            peak_strain: p.peak_strain,
            fall: 2.0 * p.crushing_energy / (p.length * p.strength),
        })
    }

    /// Stress of the envelope at the strain ε = x ε_0 of first loading [Pa], both positive in compression.
    pub fn envelope(&self, x: f64) -> f64 {
        self.envelope_slope(x).0
    }

    /// σ_env and dσ_env/dx.
    fn envelope_slope(&self, x: f64) -> (f64, f64) {
        let f_c = self.strength;
        if x <= 1.0 {
            let k = 1.05 * self.elastic.young_modulus() * self.peak_strain / f_c;
            let (over, under) = (k * x - x * x, 1.0 + (k - 2.0) * x);
            (f_c * over / under, f_c * ((k - 2.0 * x) * under - over * (k - 2.0)) / (under * under))
        } else {
            let slope = self.peak_strain / self.fall;
            let rest = 1.0 - (x - 1.0) * slope;
            if rest > RESIDUAL { (f_c * rest, -f_c * slope) } else { (f_c * RESIDUAL, 0.0) }
        }
    }

    /// x(w) and dx/dw of first loading in uniaxial compression.
    fn first_loading(w: f64) -> (f64, f64) {
        if w <= W_TANGENT {
            return (X_TANGENT + (w - W_TANGENT) / SLOPE, 1.0 / SLOPE);
        }
        let top = karsan_jirsa(X_TOP);
        if w <= top {
            let x = (-0.13 + (0.0169 + 0.58 * w).sqrt()) / 0.29;
            (x, 1.0 / (0.29 * x + 0.13))
        } else {
            (X_TOP + w - top, 1.0)
        }
    }

    /// s(a) and ds/da [Pa].
    fn effective_strength(&self, a: f64) -> (f64, f64) {
        let w = a / self.peak_strain;
        let (x, slope) = Self::first_loading(w);
        let e = self.elastic.young_modulus();
        (e * self.peak_strain * (x - w), e * (slope - 1.0))
    }

    /// 1 − d and its derivative by a, of first loading.
    fn integrity(&self, a: f64) -> (f64, f64) {
        let (x, x_slope) = Self::first_loading(a / self.peak_strain);
        let (s, s_slope) = self.effective_strength(a);
        let (env, env_slope) = self.envelope_slope(x);
        let ratio = env / s;
        if ratio >= 1.0 { (1.0, 0.0) } else { (ratio, (env_slope * x_slope / self.peak_strain - ratio * s_slope) / s) }
    }

    /// 1/√3 − α.
    fn uniaxial(&self) -> f64 {
        1.0 / 3f64.sqrt() - self.alpha
    }

    /// Effective trial stress along the modes.
    fn trial(&self, strain: &[f64; 3], old: &[f64]) -> [f64; 3] {
        let elastic = Modes::split(&[strain[0] - old[1], strain[1] - old[2], strain[2] - old[3]]);
        std::array::from_fn(|i| self.modes.c[i] * elastic[i])
    }
}

impl Law<3> for PlasticFracturing {
    fn kind(&self) -> &'static str {
        KIND
    }

    fn history_len(&self) -> usize {
        5
    }

    fn respond(&self, strain: &[f64; 3], old: &[f64], new: &mut [f64]) -> Result<Response<3>, LawError> {
        let trial = self.trial(strain, old);
        let eta = self.uniaxial();
        let a = old[0];
        let strength = eta * self.effective_strength(a).0;
        let whole = 1.0 - old[4];
        new.copy_from_slice(old);
        let measure = plane::measure(self.alpha, trial);
        if measure <= strength * (1.0 + ON_SURFACE) {
            return Ok(Response {
                stress: Modes::join(&trial).map(|s| whole * s),
                tangent: self.modes.moduli.map(|row| row.map(|c| whole * c)),
                dissipation: 0.0,
            });
        }
        let step = plane::plastic_step(&self.modes, self.alpha, trial, [0.0; 3], |lambda| {
            let (s, slope) = self.effective_strength(a + eta * lambda);
            (eta * s, eta * eta * slope)
        })
        .ok_or_else(|| LawError::NoConvergence { law: KIND, increment: measure / self.elastic.young_modulus() })?;
        new[0] = a + eta * step.multiplier;
        let flow = Modes::join(&step.normal.map(|n| step.multiplier * n));
        for i in 0..3 {
            new[1 + i] += flow[i];
        }
        let (mut rest, mut rest_slope) = self.integrity(new[0]);
        if rest >= whole {
            (rest, rest_slope) = (whole, 0.0);
        }
        new[4] = 1.0 - rest;
        // Elastic energy per loss of integrity.
        let energy: f64 = step.stress.iter().zip(&self.modes.c).map(|(s, c)| 0.5 * s * s / c).sum();
        let mut tangent = step.tangent;
        for i in 0..3 {
            for j in 0..3 {
                tangent[i][j] = rest * tangent[i][j] + step.stress[i] * rest_slope * eta * step.pull[j];
            }
        }
        Ok(Response {
            stress: Modes::join(&step.stress).map(|s| rest * s),
            tangent: plane::join_matrix(&tangent),
            dissipation: rest * eta * self.effective_strength(new[0]).0 * step.multiplier + energy * (whole - rest),
        })
    }

    fn inspect(&self, strain: &[f64; 3], history: &[f64]) -> PointState {
        let size = self.uniaxial() * self.effective_strength(history[0]).0;
        PointState {
            plastic_strain: history[0],
            utilisation: (plane::measure(self.alpha, self.trial(strain, history)) / size).max(0.0),
            damage: history[4],
            ..PointState::default()
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn parameters() -> Parameters {
        Parameters {
            young_modulus: 34e9,
            poisson_ratio: 0.2,
            strength: 35e6,
            biaxial: 1.16 * 35e6,
            peak_strain: 2.2e-3,
            crushing_energy: 25e3,
            length: 0.1,
        }
    }

    /// Karsan & Jirsa: x = 0.5, 1, 1.5, 2 leave 0.1013, 0.275, 0.521, 0.840 (printed to four digits); the inverse used here
    /// returns x, and is smooth at ½.
    #[test]
    fn plastic_strain_of_first_loading() {
        for (x, w) in [(0.5, 0.10125), (1.0, 0.275), (1.5, 0.52125), (2.0, 0.84)] {
            assert!((karsan_jirsa(x) - w).abs() < 1e-12);
            assert!((PlasticFracturing::first_loading(w).0 - x).abs() < 1e-12);
        }
        let [below, above] = [-1e-9, 1e-9].map(|d| PlasticFracturing::first_loading(W_TANGENT + d).1);
        assert!((below - above).abs() < 1e-6);
    }

    /// Sargin's curve: f_c with horizontal tangent at the peak; the falling line ends at 0.2 f_c.
    #[test]
    fn envelope_has_its_peak_at_the_peak_strain() {
        let law = PlasticFracturing::new(&parameters()).unwrap();
        assert!((law.envelope(1.0) / 35e6 - 1.0).abs() < 1e-12);
        assert!(law.envelope_slope(1.0).1.abs() < 1e-3 && law.envelope(1e3) == 7e6);
    }

    #[test]
    fn parameters_out_of_range_are_rejected() {
        let text = |p| PlasticFracturing::new(&p).unwrap_err().to_string();
        let with_length = |length| Parameters { length, ..parameters() };
        assert!(text(with_length(2.0)).starts_with("plastic_fracturing: length is 2 m, allowed from 0 to 1.38"));
        assert_eq!(text(with_length(0.0)), "plastic_fracturing: length is 0 m, allowed > 0 and finite");
        let peak_strain = 1e-3;
        assert!(text(Parameters { peak_strain, ..parameters() }).contains("peak_strain is 0.001"));
    }
}
