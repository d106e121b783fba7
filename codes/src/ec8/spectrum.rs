//! Elastic and design spectra of Eurocode 8: EN 1998-1:2004 and the pre-standard ENV 1998-1-1:1994.
//!
//! ```text
//! a_g = γ_I a_gR                                               design ground acceleration on rock
//! η   = max(√(10/(5+ξ)), 0.55)   EN      max(√(7/(2+ξ)), 0.7)   ENV      ξ in per cent
//!
//! EN horizontal, b = 2.5 η                          ENV horizontal, b = 2.5 η
//! T ≤ T_B        a_g S [1 + T/T_B (b−1)]            a_g S [1 + T/T_B (b−1)]
//! T_B…T_C        a_g S b                            a_g S b
//! T_C…T_D        a_g S b T_C/T                      a_g S b T_C/T
//! T_D…4 s        a_g S b T_C T_D/T²                 a_g S b T_C T_D/T²   (no upper period)
//! ```
//!
//! Beyond 4 s EN 1998-1 refers to the displacement spectrum of its annex A, whose control periods T_E, T_F are given for
//! type 1 only. With d_g = 0.025 a_g S T_C T_D
//!
//! ```text
//! T_D…T_E   S_De = d_g b                T_E…T_F   S_De = d_g [b + (T−T_E)/(T_F−T_E) (1−b)]
//! T > T_F   S_De = d_g                  S_e = S_De (2π/T)²
//! ```
//!
//! Since 0.025 stands for 1/(4π²) = 0.02533, S_e drops by 1.3 % at 4 s, and the continued 1/T² branch
//! ([`ElasticSpectrum::horizontal_continued`]) is never below annex A. Sloshing periods of large tanks lie there: both
//! values and the [`Branch`] are reported.
//!
//! Sources: EN 1998-1:2004, 3.2.2.2, 3.2.2.3, 3.2.2.5, tables 3.2 to 3.4, annex A (recommended values; a national annex
//! may differ). ENV 1998-1-1:1994, 4.2; its row for ground A is confirmed by the dissertation, table D.3, the rows for
//! B and C and the vertical factors are recalled.

use std::f64::consts::PI;

use crate::procedure::CodeError;
use tank::assessment::NotApplicable;
use tank::case::{Ec8Site, GroundType};
use tank::hazard::SpectrumParameters;

/// Clause of the horizontal elastic spectrum.
pub const EN_HORIZONTAL: &str = "EN 1998-1:2004 3.2.2.2";
/// Clause of the vertical elastic spectrum.
pub const EN_VERTICAL: &str = "EN 1998-1:2004 3.2.2.3";
/// Clause of the elastic spectrum of the pre-standard.
pub const ENV_HORIZONTAL: &str = "ENV 1998-1-1:1994 4.2.2";
/// Clause of the vertical elastic spectrum of the pre-standard.
pub const ENV_VERTICAL: &str = "ENV 1998-1-1:1994 4.2.1";

/// Longest period of the elastic spectrum of EN 1998-1 3.2.2.2 [s].
pub const LONGEST_PERIOD: f64 = 4.0;

/// Piece of the spectrum that gave a value.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Branch {
    /// 0…T_B.
    Rising,
    /// T_B…T_C, constant acceleration.
    Plateau,
    /// T_C…T_D, constant velocity.
    ConstantVelocity,
    /// From T_D, constant displacement (EN: up to 4 s).
    ConstantDisplacement,
    /// EN beyond 4 s by annex A of EN 1998-1.
    AnnexA,
    /// EN type 2 beyond 4 s: annex A gives no control periods, the 1/T² branch is continued.
    Continued,
}

impl Branch {
    /// The branch in words.
    pub fn describe(self) -> &'static str {
        match self {
            Branch::Rising => "rising branch, T ≤ T_B",
            Branch::Plateau => "constant acceleration, T_B ≤ T ≤ T_C",
            Branch::ConstantVelocity => "constant velocity, T_C ≤ T ≤ T_D",
            Branch::ConstantDisplacement => "constant displacement, T ≥ T_D",
            Branch::AnnexA => "displacement spectrum of annex A, T > 4 s",
            Branch::Continued => "1/T² branch continued beyond 4 s (no control periods of annex A)",
        }
    }
}

/// Vertical elastic spectrum of EN 1998-1:2004 3.2.2.3 [m/s²] for a peak vertical ground acceleration a_vg [m/s²].
pub fn vertical_elastic(peak: f64, period: f64, damping: f64) -> f64 {
    let b = 3.0 * damping_correction(damping);
    four_branches(period, peak, b, ElasticSpectrum::VERTICAL_CORNERS).0
}

/// Damping correction of EN 1998-1:2004, eq. (3.6), `η = max(√(10/(5+ξ)), 0.55)`; `damping` is a fraction (0.05 gives 1).
pub fn damping_correction(damping: f64) -> f64 {
    (10.0 / (5.0 + 100.0 * damping)).sqrt().max(0.55)
}

/// Damping correction of ENV 1998-1-1:1994, `η = max(√(7/(2+ξ)), 0.7)`; `damping` is a fraction (0.05 gives 1).
pub fn damping_correction_env(damping: f64) -> f64 {
    (7.0 / (2.0 + 100.0 * damping)).sqrt().max(0.7)
}

/// The four branches that EN and ENV share: `a [1 + T/T_B (b−1)]`, `a b`, `a b T_C/T`, `a b T_C T_D/T²`.
fn four_branches(period: f64, a: f64, b: f64, [t_b, t_c, t_d]: [f64; 3]) -> (f64, Branch) {
    if period <= t_b {
        (a * (1.0 + period / t_b * (b - 1.0)), Branch::Rising)
    } else if period <= t_c {
        (a * b, Branch::Plateau)
    } else if period <= t_d {
        (a * b * t_c / period, Branch::ConstantVelocity)
    } else {
        (a * b * t_c * t_d / (period * period), Branch::ConstantDisplacement)
    }
}

/// Elastic spectrum of EN 1998-1:2004 with the recommended parameters.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ElasticSpectrum {
    /// a_g = γ_I a_gR [m/s²].
    pub ag: f64,
    /// Soil factor S.
    pub soil: f64,
    /// Control periods T_B, T_C, T_D [s].
    pub corners: [f64; 3],
    /// Control periods T_E, T_F of annex A [s]; none for type 2.
    pub long_corners: Option<[f64; 2]>,
    /// a_vg/a_g.
    pub vertical_ratio: f64,
}

impl ElasticSpectrum {
    /// Control periods of the vertical spectrum [s].
    pub const VERTICAL_CORNERS: [f64; 3] = [0.05, 0.15, 1.0];

    /// The spectrum of a site. Error: a spectrum type other than 1 or 2, an acceleration or importance that is negative
    /// or not finite.
    pub fn new(site: &Ec8Site) -> Result<ElasticSpectrum, CodeError> {
        use GroundType::*;
        let ag = design_acceleration(site)?;
        let (soil, corners, long_corners, vertical_ratio) = match site.spectrum {
            1 => {
                let (s, corners, t_e) = match site.ground {
                    A => (1.0, [0.15, 0.4, 2.0], 4.5),
                    B => (1.2, [0.15, 0.5, 2.0], 5.0),
                    C => (1.15, [0.20, 0.6, 2.0], 6.0),
                    D => (1.35, [0.20, 0.8, 2.0], 6.0),
                    E => (1.4, [0.15, 0.5, 2.0], 6.0),
                };
                (s, corners, Some([t_e, 10.0]), 0.90)
            }
            2 => {
                let (s, corners) = match site.ground {
                    A => (1.0, [0.05, 0.25, 1.2]),
                    B => (1.35, [0.05, 0.25, 1.2]),
                    C => (1.5, [0.10, 0.25, 1.2]),
                    D => (1.8, [0.10, 0.30, 1.2]),
                    E => (1.6, [0.05, 0.25, 1.2]),
                };
                (s, corners, None, 0.45)
            }
            other => {
                return Err(CodeError::Data {
                    clause: EN_HORIZONTAL.into(),
                    reason: format!("spectrum type {other} found, allowed are 1 and 2"),
                });
            }
        };
        Ok(ElasticSpectrum { ag, soil, corners, long_corners, vertical_ratio })
    }

    /// The spectrum of the user's parameters. Without T_E and T_F the 1/T² branch is continued beyond 4 s.
    ///
    /// * `vertical_ratio`: a_vg/a_g
    /// * `importance`: γ_I
    pub fn of_parameters(given: &SpectrumParameters, vertical_ratio: f64, importance: f64) -> ElasticSpectrum {
        ElasticSpectrum {
            ag: importance * given.ag,
            soil: given.soil,
            corners: given.corners,
            long_corners: given.long_corners,
            vertical_ratio,
        }
    }

    /// Peak horizontal ground acceleration at the surface `a_g S` [m/s²], the ordinate at T = 0.
    pub fn peak(&self) -> f64 {
        self.ag * self.soil
    }

    /// Peak vertical ground acceleration `a_vg` [m/s²] (no soil factor).
    pub fn vertical_peak(&self) -> f64 {
        self.ag * self.vertical_ratio
    }

    /// Horizontal elastic spectrum `S_e(T)` [m/s²] at a period [s] and a damping ratio (fraction); annex A beyond 4 s.
    ///
    /// Check: a_g = 1 m/s², ground C, type 1, 5 %: 1.15, 2.0125, 2.875, 1.725, 0.8625, 0.2156 at 0, 0.1, 0.5, 1, 2, 4 s.
    pub fn horizontal(&self, period: f64, damping: f64) -> f64 {
        self.horizontal_with_branch(period, damping).0
    }

    /// `S_e(T)` and the branch it came from.
    pub fn horizontal_with_branch(&self, period: f64, damping: f64) -> (f64, Branch) {
        if period > LONGEST_PERIOD.max(self.corners[2]) {
            match self.displacement_long(period, damping) {
                Some(displacement) => (displacement * (2.0 * PI / period).powi(2), Branch::AnnexA),
                None => (self.horizontal_continued(period, damping), Branch::Continued),
            }
        } else {
            four_branches(period, self.peak(), 2.5 * damping_correction(damping), self.corners)
        }
    }

    /// `S_e(T)` with the 1/T² branch continued beyond 4 s [m/s²]; not below [`ElasticSpectrum::horizontal`].
    pub fn horizontal_continued(&self, period: f64, damping: f64) -> f64 {
        self.continued(period, damping).0
    }

    /// [`ElasticSpectrum::horizontal_continued`] and its branch.
    pub(super) fn continued(&self, period: f64, damping: f64) -> (f64, Branch) {
        four_branches(period, self.peak(), 2.5 * damping_correction(damping), self.corners)
    }

    /// Displacement spectrum `S_De(T)` of annex A [m] for T ≥ T_D; none for type 2.
    pub fn displacement_long(&self, period: f64, damping: f64) -> Option<f64> {
        let [t_e, t_f] = self.long_corners?;
        let [_, t_c, t_d] = self.corners;
        let ground = 0.025 * self.peak() * t_c * t_d;
        let b = 2.5 * damping_correction(damping);
        Some(if period <= t_e {
            ground * b
        } else if period <= t_f {
            ground * (b + (period - t_e) / (t_f - t_e) * (1.0 - b))
        } else {
            ground
        })
    }

    /// Vertical elastic spectrum `S_ve(T)` [m/s²]: factor 3.0 instead of 2.5, S = 1, own control periods.
    pub fn vertical(&self, period: f64, damping: f64) -> f64 {
        vertical_elastic(self.vertical_peak(), period, damping)
    }

    /// Design spectrum `S_d(T)` of 3.2.2.5 [m/s²] for a behaviour factor q, lower bound β = 0.2.
    ///
    /// It belongs to 5 % damping; tanks with other damping use `S_e(T, ξ)/q` instead. With q = 1 it gives 2/3 of the
    /// elastic ordinate at T = 0.
    pub fn design(&self, period: f64, behaviour_factor: f64) -> f64 {
        let [t_b, t_c, t_d] = self.corners;
        let (a, b, floor) = (self.peak(), 2.5 / behaviour_factor, 0.2 * self.ag);
        if period <= t_b {
            a * (2.0 / 3.0 + period / t_b * (b - 2.0 / 3.0))
        } else if period <= t_c {
            a * b
        } else if period <= t_d {
            (a * b * t_c / period).max(floor)
        } else {
            (a * b * t_c * t_d / (period * period)).max(floor)
        }
    }
}

/// Elastic spectrum of ENV 1998-1-1:1994 for subsoil classes A, B, C.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct EnvSpectrum {
    /// a_g = γ_I a_gR [m/s²].
    pub ag: f64,
    /// Soil parameter S.
    pub soil: f64,
    /// Control periods T_B, T_C, T_D [s].
    pub corners: [f64; 3],
}

impl EnvSpectrum {
    /// The spectrum of a site; the spectrum type does not exist in the pre-standard and is not used.
    ///
    /// Error: ground types D and E, which the pre-standard does not define; inadmissible acceleration or importance.
    pub fn new(site: &Ec8Site) -> Result<EnvSpectrum, CodeError> {
        let ag = design_acceleration(site)?;
        let (soil, corners) = match site.ground {
            GroundType::A => (1.0, [0.10, 0.40, 3.0]),
            GroundType::B => (1.0, [0.15, 0.60, 3.0]),
            GroundType::C => (0.9, [0.20, 0.80, 3.0]),
            other @ (GroundType::D | GroundType::E) => {
                return Err(NotApplicable {
                    clause: "ENV 1998-1-1:1994 3.2".into(),
                    reason: format!("ground type {other:?} found, the pre-standard defines subsoil classes A, B and C"),
                }
                .into());
            }
        };
        Ok(EnvSpectrum { ag, soil, corners })
    }

    /// The spectrum with the user's parameters; T_E and T_F do not exist here.
    ///
    /// * `importance`: γ_I
    pub fn of_parameters(given: &SpectrumParameters, importance: f64) -> EnvSpectrum {
        EnvSpectrum { ag: importance * given.ag, soil: given.soil, corners: given.corners }
    }

    /// Peak horizontal ground acceleration at the surface `a_g S` [m/s²].
    pub fn peak(&self) -> f64 {
        self.ag * self.soil
    }

    /// Horizontal elastic spectrum `S_e(T)` [m/s²] at a period [s] and a damping ratio (fraction).
    pub fn horizontal(&self, period: f64, damping: f64) -> f64 {
        self.horizontal_with_branch(period, damping).0
    }

    /// `S_e(T)` and the branch it came from.
    pub fn horizontal_with_branch(&self, period: f64, damping: f64) -> (f64, Branch) {
        four_branches(period, self.peak(), 2.5 * damping_correction_env(damping), self.corners)
    }

    /// Vertical elastic spectrum [m/s²]: the horizontal one times 0.7 (T ≤ 0.15 s) … 0.5 (T ≥ 0.5 s), linear between.
    pub fn vertical(&self, period: f64, damping: f64) -> f64 {
        self.horizontal(period, damping) * (0.7 - 0.2 * ((period - 0.15) / 0.35).clamp(0.0, 1.0))
    }

    /// Peak vertical ground acceleration `0.7 a_g S` [m/s²].
    pub fn vertical_peak(&self) -> f64 {
        0.7 * self.peak()
    }
}

/// `a_g = γ_I a_gR`, both checked.
fn design_acceleration(site: &Ec8Site) -> Result<f64, CodeError> {
    for (name, value) in [("ag", site.ag), ("importance", site.importance)] {
        if !(value.is_finite() && value >= 0.0) {
            return Err(CodeError::Data {
                clause: "EN 1998-1:2004 3.2.1".into(),
                reason: format!("{name} = {value} found, allowed is a finite number ≥ 0"),
            });
        }
    }
    Ok(site.importance * site.ag)
}

#[cfg(test)]
mod tests;
