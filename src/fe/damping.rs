//! Damping models and the table of resulting ratios.
//!
//! Modal damping gives every mode the ratio of its kind. Rayleigh damping C = a_M M + a_K K gives the mode ω the ratio
//!
//! ```text
//! ξ(ω) = (a_M/ω + a_K ω)/2
//! a_M = 2 ω₁ω₂ (ω₂ ξ₁ − ω₁ ξ₂)/(ω₂² − ω₁²)        a_K = 2 (ω₂ ξ₂ − ω₁ ξ₁)/(ω₂² − ω₁²)
//! ```
//!
//! With ω₁ < ω₂ both coefficients are ≥ 0 if and only if ω₁/ω₂ ≤ ξ₂/ξ₁ ≤ ω₂/ω₁. Outside, one of them is negative: energy
//! is fed into all modes below (a_M < 0) or above (a_K < 0) √(−a_M/a_K). Source: Clough & Penzien 1993, section 12-5.

use codes::Case;

use crate::fe::harmonic::{CoupledMode, Kind};
use crate::fe::{DampingModel, FeError};
use crate::results::DampingRow;

/// Ratios above this are flagged in the table.
const HIGH: f64 = 0.20;
/// Ratios below this are flagged in the table.
const LOW: f64 = 0.001;

/// Coefficients of C = a_M M + a_K K.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Rayleigh {
    /// a_M [1/s].
    pub mass: f64,
    /// a_K [s].
    pub stiffness: f64,
}

impl Rayleigh {
    /// Coefficients that give the ratios of two (circular frequency [rad/s], ratio) pairs.
    ///
    /// Errors: a frequency that is not positive, equal frequencies, a negative ratio; unless `allow_negative`, a negative
    /// coefficient, with the admissible range of ξ₂/ξ₁.
    pub fn fit(first: (f64, f64), second: (f64, f64), allow_negative: bool) -> Result<Rayleigh, FeError> {
        let option = |found: String, allowed: &str| FeError::Option {
            option: "Rayleigh damping".into(),
            found,
            allowed: allowed.into(),
        };
        for (omega, ratio) in [first, second] {
            if !(omega > 0.0 && omega.is_finite()) {
                return Err(option(format!("circular frequency {omega} rad/s"), "a positive number"));
            }
            if !(0.0..1.0).contains(&ratio) {
                return Err(option(format!("damping ratio {ratio}"), "0 to 1"));
            }
        }
        let ((w1, x1), (w2, x2)) = if first.0 <= second.0 {
            (first, second)
        } else {
            (second, first)
        };
        let span = (w2 - w1) * (w2 + w1);
        if span <= 1e-9 * w2 * w2 {
            return Err(option(
                format!("both frequencies at {w1} rad/s"),
                "two different frequencies",
            ));
        }
        let rayleigh = Rayleigh {
            mass: 2.0 * w1 * w2 * (w2 * x1 - w1 * x2) / span,
            stiffness: 2.0 * (w2 * x2 - w1 * x1) / span,
        };
        if (rayleigh.mass < 0.0 || rayleigh.stiffness < 0.0) && !allow_negative {
            return Err(option(
                format!(
                    "ratios {x1} at {w1} rad/s and {x2} at {w2} rad/s, which give a_M = {:.4} 1/s, a_K = {:.4e} s \
                     (a negative coefficient feeds energy into modes)",
                    rayleigh.mass, rayleigh.stiffness
                ),
                &format!(
                    "a quotient of the ratios from {:.4} to {:.4} (upper frequency's over lower frequency's)",
                    w1 / w2,
                    w2 / w1
                ),
            ));
        }
        Ok(rayleigh)
    }

    /// ξ(ω) = (a_M/ω + a_K ω)/2.
    pub fn ratio(&self, omega: f64) -> f64 {
        0.5 * (self.mass / omega + self.stiffness * omega)
    }
}

/// The ratio of every mode.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Damper {
    /// By kind of mode.
    ByKind {
        /// Sloshing modes.
        sloshing: f64,
        /// Structural modes.
        structural: f64,
    },
    /// By frequency.
    Rayleigh(Rayleigh),
}

impl Damper {
    /// The damping that `model` asks for in `case`.
    ///
    /// Errors: those of [`Rayleigh::fit`], coefficients that are not finite.
    pub fn new(case: &Case, model: &DampingModel) -> Result<Damper, FeError> {
        match *model {
            DampingModel::Modal => Ok(Damper::ByKind {
                sloshing: case.damping.sloshing,
                structural: case.damping.impulsive,
            }),
            DampingModel::Rayleigh {
                first,
                second,
                allow_negative,
            } => Ok(Damper::Rayleigh(Rayleigh::fit(first, second, allow_negative)?)),
            DampingModel::Coefficients { mass, stiffness } => {
                if !(mass.is_finite() && stiffness.is_finite()) {
                    return Err(FeError::Option {
                        option: "Rayleigh coefficients".into(),
                        found: format!("a_M = {mass} 1/s, a_K = {stiffness} s"),
                        allowed: "finite numbers".into(),
                    });
                }
                Ok(Damper::Rayleigh(Rayleigh { mass, stiffness }))
            }
        }
    }

    /// Ratio of a mode of this kind and circular frequency [rad/s].
    pub fn ratio(&self, kind: Kind, omega: f64) -> f64 {
        match *self {
            Damper::ByKind { sloshing, structural } => match kind {
                Kind::Sloshing => sloshing,
                Kind::Structural => structural,
            },
            Damper::Rayleigh(rayleigh) => rayleigh.ratio(omega),
        }
    }

    /// In words, for the report.
    pub fn text(&self) -> String {
        match *self {
            Damper::ByKind { sloshing, structural } => format!(
                "modal: {} % in sloshing modes, {} % in structural modes",
                percent(sloshing),
                percent(structural)
            ),
            Damper::Rayleigh(Rayleigh { mass, stiffness }) => {
                format!("Rayleigh: C = a_M M + a_K K with a_M = {mass:.5} 1/s, a_K = {stiffness:.6} s")
            }
        }
    }

    /// Warnings about negative and over-critical ratios at `modes`; empty for modal damping.
    ///
    /// Errors: a ratio at or below −1, whose response has no meaning.
    pub fn review(&self, modes: &[CoupledMode]) -> Result<Vec<String>, FeError> {
        let Damper::Rayleigh(rayleigh) = self else {
            return Ok(Vec::new());
        };
        let mut notes = Vec::new();
        if rayleigh.mass < 0.0 || rayleigh.stiffness < 0.0 {
            let crossing = (-rayleigh.mass / rayleigh.stiffness).sqrt();
            let below = modes.iter().filter(|m| rayleigh.ratio(m.omega) < 0.0).count();
            notes.push(format!(
                "Rayleigh damping with a negative coefficient: the ratio is negative {} {crossing:.3} rad/s; {below} of \
                 {} modes lie there.",
                if rayleigh.mass < 0.0 { "below" } else { "above" },
                modes.len()
            ));
        }
        if let Some(worst) = modes.iter().find(|m| rayleigh.ratio(m.omega) <= -1.0) {
            return Err(FeError::Option {
                option: "Rayleigh damping".into(),
                found: format!(
                    "ratio {:.3} at the mode {:.4} rad/s",
                    rayleigh.ratio(worst.omega),
                    worst.omega
                ),
                allowed: "a ratio above −1 at every mode".into(),
            });
        }
        Ok(notes)
    }

    /// Ratios at the modes with more than 1 % of `total_mass` [kg]; empty for modal damping.
    pub fn table(&self, modes: &[CoupledMode], total_mass: f64) -> Vec<DampingRow> {
        let Damper::Rayleigh(rayleigh) = self else {
            return Vec::new();
        };
        modes
            .iter()
            .filter(|m| m.effective_mass() > 0.01 * total_mass)
            .map(|m| {
                let ratio = rayleigh.ratio(m.omega);
                DampingRow {
                    omega: m.omega,
                    kind: m.kind.id().into(),
                    ratio,
                    note: remark(ratio).into(),
                }
            })
            .collect()
    }
}

/// What a ratio means.
fn remark(ratio: f64) -> &'static str {
    if ratio < 0.0 {
        "negative: energy is fed into the mode"
    } else if ratio < LOW {
        "below 0.1 %: practically undamped"
    } else if ratio >= 1.0 {
        "over-critical: the mode does not vibrate"
    } else if ratio > HIGH {
        "above 20 %: the mode is largely suppressed"
    } else {
        ""
    }
}

/// A ratio in percent, without trailing zeros.
fn percent(ratio: f64) -> f64 {
    (ratio * 1e8).round() / 1e6
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    /// Dissertation example 8.1 as corrected in the theory of damping: a_M = −0.0600, a_K = 0.01320 for 1 % at 3.02 and
    /// 2 % at 4.13 rad/s (printed −0.0604 and 0.013205); half the last digit.
    #[test]
    fn coefficients_of_the_broad_tank() {
        let r = Rayleigh::fit((3.02, 0.01), (4.13, 0.02), true).unwrap();
        assert!((r.mass + 0.0600).abs() < 5e-5, "{}", r.mass);
        assert!((r.stiffness - 0.01320).abs() < 5e-6, "{}", r.stiffness);
        let message = Rayleigh::fit((3.02, 0.01), (4.13, 0.02), false)
            .unwrap_err()
            .to_string();
        // 3.02/4.13 and its inverse.
        assert!(message.contains("0.7312") && message.contains("1.3675"), "{message}");
    }

    /// Table of resulting ratios (theory sheet on damping, D4), each to 1 % of its value or half its last digit.
    #[test]
    fn ratios_of_the_broad_tank() {
        let r = Rayleigh::fit((3.02, 0.01), (4.13, 0.02), true).unwrap();
        for (omega, ratio, tolerance) in [
            (1.0, -0.023, 5e-4),
            (2.0, -0.002, 5e-4),
            (2.13, 0.0, 5e-5),
            (3.02, 0.01, 1e-12),
            (4.13, 0.02, 1e-12),
            (10.0, 0.063, 5e-4),
            (50.0, 0.33, 5e-3),
            (100.0, 0.66, 5e-3),
        ] {
            assert!(
                (r.ratio(omega) - ratio).abs() <= tolerance,
                "{omega}: {}",
                r.ratio(omega)
            );
        }
    }

    #[test]
    fn refuses_what_has_no_meaning() {
        assert!(Rayleigh::fit((3.0, 0.01), (3.0, 0.02), true).is_err());
        assert!(Rayleigh::fit((0.0, 0.01), (3.0, 0.02), true).is_err());
        assert!(Rayleigh::fit((1.0, -0.01), (3.0, 0.02), true).is_err());
        assert!(Rayleigh::fit((f64::NAN, 0.01), (3.0, 0.02), true).is_err());
    }

    proptest! {
        /// The fit returns the ratios it was given, whatever the order, and refuses exactly outside the inequality.
        #[test]
        fn fit_meets_both_points(w1 in 0.1f64..50.0, factor in 1.01f64..100.0, x1 in 1e-4f64..0.3, q in 0.001f64..100.0) {
            let (w2, x2) = (w1 * factor, (x1 * q).min(0.99));
            let r = Rayleigh::fit((w1, x1), (w2, x2), true).unwrap();
            prop_assert!((r.ratio(w1) - x1).abs() < 1e-9 && (r.ratio(w2) - x2).abs() < 1e-9);
            prop_assert_eq!(Rayleigh::fit((w2, x2), (w1, x1), true).unwrap(), r);
            let quotient = x2 / x1;
            // Equality is a matter of rounding.
            if quotient > 1.000001 / factor && quotient < 0.999999 * factor {
                prop_assert!(Rayleigh::fit((w1, x1), (w2, x2), false).is_ok());
            }
            if quotient < 0.999999 / factor || quotient > 1.000001 * factor {
                prop_assert!(Rayleigh::fit((w1, x1), (w2, x2), false).is_err());
            }
        }
    }
}
