//! The cone in the solid: explicit return to the cone and to its apex.
//!
//! With the trial state ξ = C (ε − ε_p,n) − ρ_n, its deviator s, R = √(½ s : s) and mean p:
//!
//! ```text
//! cone   λ = F/(G + 9Kα² + c (½ + 3α²)) ,   ε_p += λ (s/(2R) + α 1)          if R − (G + c/2) λ ≥ 0
//! apex   ε_p += s/(2G + c) + ⅓ (p − k/(3α))/(K + c/3) 1
//! ```

use super::{DruckerPrager, KIND, ON_SURFACE};
use crate::{Law, LawError, PointState, Response};

/// Trial state ξ.
struct Trial {
    stress: [f64; 6],
    deviator: [f64; 6],
    mean: f64,
    root: f64,
}

impl DruckerPrager {
    fn solid_trial(&self, strain: &[f64; 6], old: &[f64]) -> Trial {
        let elastic: [f64; 6] = std::array::from_fn(|i| strain[i] - old[1 + i]);
        let stress = self.elastic.solid().map(|row| row.iter().zip(&elastic).map(|(c, e)| c * e).sum());
        let mut deviator: [f64; 6] = stress;
        for i in 0..6 {
            let tensor = if i < 3 { 1.0 } else { 0.5 };
            deviator[i] -= self.hardening * tensor * old[1 + i];
        }
        let mean = (deviator[0] + deviator[1] + deviator[2]) / 3.0;
        deviator[..3].iter_mut().for_each(|s| *s -= mean);
        let square: f64 = (0..6).map(|i| deviator[i] * deviator[i] * if i < 3 { 0.5 } else { 1.0 }).sum();
        Trial { stress, deviator, mean, root: square.sqrt() }
    }
}

impl Law<6> for DruckerPrager {
    fn kind(&self) -> &'static str {
        KIND
    }

    fn history_len(&self) -> usize {
        7
    }

    fn respond(&self, strain: &[f64; 6], old: &[f64], new: &mut [f64]) -> Result<Response<6>, LawError> {
        let Trial { stress, deviator: s, mean, root } = self.solid_trial(strain, old);
        let (alpha, k, c) = (self.cone.alpha, self.cone.k, self.hardening);
        let mut tangent = self.elastic.solid();
        new.copy_from_slice(old);
        let f = root + 3.0 * alpha * mean - k;
        if !f.is_finite() {
            let increment = f64::NAN;
            return Err(LawError::NoConvergence { law: KIND, increment });
        }
        if f <= ON_SURFACE * k {
            return Ok(Response { stress, tangent, dissipation: 0.0 });
        }
        let g = self.elastic.shear_modulus();
        let bulk = self.elastic.young_modulus() / (3.0 - 6.0 * self.elastic.poisson_ratio());
        let under = g + 9.0 * bulk * alpha * alpha + self.growth();
        let mut lambda = f / under;
        let mut flow = [0.0; 6];
        if root - (g + 0.5 * c) * lambda >= 0.0 {
            // C n, and the change of direction of n.
            let mut push = [0.0; 6];
            for i in 0..6 {
                let (one, engineering) = if i < 3 { (1.0, 1.0) } else { (0.0, 2.0) };
                flow[i] = lambda * (engineering * s[i] / (2.0 * root) + alpha * one);
                push[i] = g * s[i] / root + 3.0 * bulk * alpha * one;
            }
            let turn = 2.0 * g * g * lambda / root;
            for i in 0..6 {
                for j in 0..6 {
                    tangent[i][j] += turn * s[i] * s[j] / (2.0 * root * root) - push[i] * push[j] / under;
                    if i < 3 && j < 3 {
                        tangent[i][j] += turn / 3.0;
                    }
                }
                tangent[i][i] -= turn * if i < 3 { 1.0 } else { 0.5 };
            }
        } else {
            let volume = (mean - k / (3.0 * alpha)) / (bulk + c / 3.0);
            lambda = volume / (3.0 * alpha);
            let shear = g * c / (2.0 * g + c);
            let bulk = bulk * (c / 3.0) / (bulk + c / 3.0);
            tangent = [[0.0; 6]; 6];
            for i in 0..3 {
                for j in 0..3 {
                    tangent[i][j] = bulk - 2.0 / 3.0 * shear;
                }
                tangent[i][i] += 2.0 * shear;
                tangent[3 + i][3 + i] = shear;
            }
            for i in 0..6 {
                let (one, engineering) = if i < 3 { (1.0, 1.0) } else { (0.0, 2.0) };
                flow[i] = engineering * s[i] / (2.0 * g + c) + volume / 3.0 * one;
            }
        }
        new[0] += lambda * self.cone.uniaxial();
        let moduli = self.elastic.solid();
        let mut response = Response { stress, tangent, dissipation: k * lambda };
        for i in 0..6 {
            new[1 + i] += flow[i];
            response.stress[i] -= (0..6).map(|j| moduli[i][j] * flow[j]).sum::<f64>();
        }
        Ok(response)
    }

    fn inspect(&self, strain: &[f64; 6], history: &[f64]) -> PointState {
        let trial = self.solid_trial(strain, history);
        PointState {
            plastic_strain: history[0],
            utilisation: ((trial.root + 3.0 * self.cone.alpha * trial.mean) / self.cone.k).max(0.0),
            ..PointState::default()
        }
    }
}
