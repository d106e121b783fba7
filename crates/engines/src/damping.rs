//! Damping models and the table of resulting ratios.
//!
//! Modal damping gives every mode the ratio of its kind. Rayleigh damping C = a_M M + a_K K gives the mode ω the ratio
//! (a_M/ω + a_K ω)/2; its rules stand at [`Rayleigh`].

use tank::Case;

use crate::FeError;
use crate::modes::{CoupledMode, Kind};
use results::DampingRow;
use tank::options::linear::DampingModel;

pub use fem::analysis::damping::Rayleigh;
use fem::analysis::damping::{DampingError, remark};

/// The ratio of every mode.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Damper {
    /// By kind of mode.
    ByKind {
        /// Sloshing modes.
        sloshing: f64,
        /// Structural modes and all others.
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
            } => Ok(Damper::Rayleigh(
                Rayleigh::fit(first, second, allow_negative).map_err(refused)?,
            )),
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
                Kind::Structural | Kind::Rotational => structural,
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
    /// Errors: a ratio at or below −1, for which the response is undefined.
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

/// A refusal as an error of the options.
fn refused(error: DampingError) -> FeError {
    FeError::Option {
        option: error.option.into(),
        found: error.found,
        allowed: error.allowed,
    }
}

/// A ratio in percent, without trailing zeros.
fn percent(ratio: f64) -> f64 {
    (ratio * 1e8).round() / 1e6
}
