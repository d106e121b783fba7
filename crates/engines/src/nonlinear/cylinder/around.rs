//! Waves around an imperfect wall, step by step.
//!
//! ```text
//! u_n(z) = (2 − δ_n0)/2π ∫ u_r cos nθ dθ  by the trapezoidal rule          half the tank: twice the integral from 0 to π
//! ```
//!
//! relative to the static state, and with sin nθ where the whole tank is computed: the amplitude is √(c² + s²) at a time.

use fem::dofs::Dof;
use results::{Around, WaveAround};
use serde::{Deserialize, Serialize};
use tank::Case;

use super::model::CylinderModel;
use crate::out_of_round;

/// Harmonics that are always seen, from 0.
const SEEN: u32 = 8;
/// Most levels at which they are.
const LEVELS: usize = 24;

/// A peak of a harmonic.
#[derive(Clone, Copy, Debug, Default, PartialEq, Serialize, Deserialize)]
struct Peak {
    /// Amplitude [m].
    amplitude: f64,
    /// Height [m].
    z: f64,
    /// Time [s].
    time: f64,
}

/// What was seen so far; empty of a perfect wall.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
pub(crate) struct AroundSeen {
    /// Amplitudes of cosine and sine in the static state, level by level and harmonic by harmonic [m].
    rest: Vec<[f64; 2]>,
    /// Peaks by harmonic.
    peaks: Vec<Peak>,
}

impl AroundSeen {
    /// Looks at the displacements `u` of an imperfect wall.
    pub(super) fn see(&mut self, tank: &CylinderModel, u: &[f64], time: f64) {
        if tank.imperfections.is_empty() {
            return;
        }
        let most = match self.peaks.len().checked_sub(1) {
            Some(most) => most as u32,
            None => {
                let height = tank.cells.z.last().copied().unwrap_or(0.0);
                let highest = tank.imperfections.waves(height).last().map_or(0, |n| n + 1);
                highest.max(SEEN).min((tank.cells.sectors / 2) as u32 - 1)
            }
        };
        let found = amplitudes(tank, u, most);
        if self.rest.is_empty() {
            self.rest = found.iter().flat_map(|(_, all)| all.iter().copied()).collect();
            self.peaks = vec![Peak::default(); most as usize + 1];
        }
        let count = self.peaks.len();
        for (level, (z, all)) in found.iter().enumerate() {
            for (n, (peak, [c, s])) in self.peaks.iter_mut().zip(all).enumerate() {
                let [c0, s0] = self.rest[level * count + n];
                let amplitude = (c - c0).hypot(s - s0);
                if amplitude > peak.amplitude {
                    *peak = Peak { amplitude, z: *z, time };
                }
            }
        }
    }

    /// In the vocabulary of the results; none of a perfect wall.
    pub(super) fn around(&self, case: &Case, tank: &CylinderModel) -> Option<Around> {
        let waves = self.peaks.iter().enumerate().map(|(n, peak)| WaveAround {
            n: n as u32,
            deviation: 0.0,
            displacement: peak.amplitude,
            z: peak.z,
            time: peak.time,
            stress: None,
        });
        (!self.peaks.is_empty()).then(|| out_of_round::around(&case.tank, &tank.imperfections, waves.collect(), None))
    }
}

/// Amplitudes of cos nθ and sin nθ, n = 0 … `most`, of the radial displacements [m] with the heights of their levels [m].
fn amplitudes(tank: &CylinderModel, u: &[f64], most: u32) -> Vec<(f64, Vec<[f64; 2]>)> {
    let levels = &tank.footprint.levels;
    let step = levels.len().div_ceil(LEVELS);
    let counted = (1..levels.len()).filter(|l| l % step == 0 || l + 1 == levels.len());
    counted
        .map(|level| {
            let points = &levels[level];
            let radial: Vec<(f64, f64, f64)> = points
                .iter()
                .enumerate()
                .map(|(k, &point)| {
                    let [c, s, _] = tank.footprint.normals[point];
                    let own = tank.model.at_node(u, tank.wall.inner[point]);
                    let end = tank.cells.half && (k == 0 || k + 1 == points.len());
                    let weight = tank.cells.copies() / tank.cells.sectors as f64 * if end { 0.5 } else { 1.0 };
                    let value = own[Dof::Ux.index()] * c + own[Dof::Uy.index()] * s;
                    (tank.cells.angle() * k as f64, weight, value)
                })
                .collect();
            let of = |n: u32| {
                let factor = if n == 0 { 1.0 } else { 2.0 };
                radial.iter().fold([0.0; 2], |[c, s], (theta, weight, value)| {
                    let (sine, cosine) = (f64::from(n) * theta).sin_cos();
                    let sine = if tank.cells.half { 0.0 } else { sine };
                    let value = factor * weight * value;
                    [c + value * cosine, s + value * sine]
                })
            };
            (tank.cells.z[level], (0..=most).map(of).collect())
        })
        .collect()
}
