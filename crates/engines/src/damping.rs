//! Damping models and the table of resulting ratios.
//!
//! Modal damping gives every mode the ratio of its kind. Rayleigh damping C = a_M M + a_K K gives the mode ω the ratio
//! (a_M/ω + a_K ω)/2; its rules stand at [`Rayleigh`]. By group the wall is damped in proportion to its stiffness, ξ ω/ω₁ in its modes,
//! as in the nonlinear engine; [`Caughey`]'s series has given ratios at up to six frequencies. All of them keep the modes uncoupled:
//! direct integration takes them as C = Σ 2 ξ_j ω_j (M φ_j)(M φ_j)ᵀ, Rayleigh's as its own matrix.

use tank::Case;

use crate::FeError;
use crate::modes::{CoupledMode, Kind};
use results::DampingRow;
use tank::options::linear::DampingModel;
use tank::units::significant;

pub use fem::analysis::caughey::Caughey;
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
    /// Wall proportional to its stiffness, a ratio for every sloshing mode.
    ByGroup {
        /// At the first structural mode.
        wall: f64,
        /// Sloshing modes.
        sloshing: f64,
        /// Circular frequency of the first structural mode [rad/s]; none before the modes are known ([`Damper::tuned`]).
        omega: Option<f64>,
    },
    /// By frequency.
    Rayleigh(Rayleigh),
    /// By frequency, through several pairs.
    Caughey(Caughey),
}

impl Damper {
    /// The damping that `model` asks for in `case`.
    ///
    /// Errors: those of [`Rayleigh::fit`], coefficients that are not finite.
    pub fn new(case: &Case, model: &DampingModel) -> Result<Damper, FeError> {
        match *model {
            DampingModel::Modal => {
                Ok(Damper::ByKind { sloshing: case.damping.sloshing, structural: case.damping.impulsive })
            }
            DampingModel::Rayleigh { first, second, allow_negative } => {
                Ok(Damper::Rayleigh(Rayleigh::fit(first, second, allow_negative).map_err(refused)?))
            }
            DampingModel::ByGroup { wall, sloshing } => Ok(Damper::ByGroup { wall, sloshing, omega: None }),
            DampingModel::Caughey(pairs) => Ok(Damper::Caughey(Caughey::fit(pairs.pairs()).map_err(refused)?)),
            DampingModel::Coefficients { mass, stiffness } => {
                if !(mass.is_finite() && stiffness.is_finite()) {
                    return Err(FeError::option(
                        "Rayleigh coefficients",
                        format!("a_M = {mass} 1/s, a_K = {stiffness} s"),
                        "finite numbers",
                    ));
                }
                Ok(Damper::Rayleigh(Rayleigh { mass, stiffness }))
            }
        }
    }

    /// The same with the first structural mode of `modes`, to which the wall's ratio belongs.
    pub fn tuned(self, modes: &[CoupledMode]) -> Damper {
        match self {
            Damper::ByGroup { wall, sloshing, .. } => Damper::ByGroup {
                wall,
                sloshing,
                // By its number: waves of an imperfect wall may be lower.
                omega: modes.iter().find(|m| m.kind == Kind::Structural && m.number == 1).map(|m| m.omega),
            },
            other => other,
        }
    }

    /// Ratio of a mode of this kind and circular frequency [rad/s].
    pub fn ratio(&self, kind: Kind, omega: f64) -> f64 {
        match *self {
            Damper::ByKind { sloshing, structural } => match kind {
                Kind::Sloshing => sloshing,
                Kind::Structural | Kind::Rotational => structural,
            },
            Damper::ByGroup { wall, sloshing, omega: first } => match kind {
                Kind::Sloshing => sloshing,
                // a_K ω²/(2 ω) with a_K = 2 ξ/ω₁: K is that of the wall but for a trifle of gravity.
                Kind::Structural | Kind::Rotational => first.map_or(wall, |first| wall * omega / first),
            },
            Damper::Rayleigh(rayleigh) => rayleigh.ratio(omega),
            Damper::Caughey(caughey) => caughey.ratio(omega),
        }
    }

    /// Ratio of a mode: that of its dashpots, or that of its kind and frequency.
    pub fn of(&self, mode: &CoupledMode) -> f64 {
        mode.damping.unwrap_or_else(|| self.ratio(mode.kind, mode.omega))
    }

    /// Ratio of a mode beside the dashpots of its system: 0 where they hold all damping.
    pub fn beside(&self, mode: &CoupledMode) -> f64 {
        match mode.damping {
            Some(_) => 0.0,
            None => self.ratio(mode.kind, mode.omega),
        }
    }

    /// Whether every mode has the ratio of its kind.
    fn is_by_kind(&self) -> bool {
        matches!(self, Damper::ByKind { .. })
    }

    /// In words, for the report.
    pub fn text(&self) -> String {
        match *self {
            Damper::ByKind { sloshing, structural } => format!(
                "modal: {} % in sloshing modes, {} % in structural modes",
                percent(sloshing),
                percent(structural)
            ),
            Damper::ByGroup { wall, sloshing, .. } => format!(
                "by group: wall {} % at the first mode of wall and liquid, proportional to its stiffness; sloshing modes {} % each",
                percent(wall),
                percent(sloshing)
            ),
            Damper::Caughey(caughey) => {
                let pair =
                    |&(omega, ratio): &(f64, f64)| format!("{} % at {} rad/s", percent(ratio), significant(omega, 4));
                let pairs: Vec<String> = caughey.pairs().iter().map(pair).collect();
                format!("Caughey: {}; beyond them the ratio of the nearest", pairs.join(", "))
            }
            Damper::Rayleigh(Rayleigh { mass, stiffness }) => {
                format!("Rayleigh: C = a_M M + a_K K with a_M = {mass:.5} 1/s, a_K = {stiffness:.6} s")
            }
        }
    }

    /// Warnings about negative and over-critical ratios at `modes`; empty for modal damping.
    ///
    /// Errors: a ratio at or below −1, for which the response is undefined; a negative one of Caughey's series.
    pub fn review(&self, modes: &[CoupledMode]) -> Result<Vec<String>, FeError> {
        let rayleigh = match self {
            Damper::Rayleigh(rayleigh) => rayleigh,
            Damper::Caughey(caughey) => return negative(caughey, modes).map_or(Ok(Vec::new()), Err),
            Damper::ByKind { .. } | Damper::ByGroup { .. } => return Ok(Vec::new()),
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
            return Err(FeError::option(
                "Rayleigh damping",
                format!("ratio {:.3} at the mode {:.4} rad/s", rayleigh.ratio(worst.omega), worst.omega),
                "a ratio above −1 at every mode",
            ));
        }
        Ok(notes)
    }

    /// Ratios at the modes with more than 1 % of `total_mass` [kg]; empty for modal damping.
    pub fn table(&self, modes: &[CoupledMode], total_mass: f64) -> Vec<DampingRow> {
        if self.is_by_kind() {
            return Vec::new();
        }
        modes
            .iter()
            .filter(|m| m.effective_mass() > 0.01 * total_mass)
            .map(|m| {
                let ratio = self.ratio(m.kind, m.omega);
                DampingRow { omega: m.omega, kind: m.kind.id().into(), ratio, note: remark(ratio).into() }
            })
            .collect()
    }
}

/// The error of a series that feeds energy into a mode between its pairs.
fn negative(caughey: &Caughey, modes: &[CoupledMode]) -> Option<FeError> {
    let worst = modes.iter().find(|m| caughey.ratio(m.omega) < 0.0)?;
    Some(FeError::option(
        "analysis.damping.caughey",
        format!("ratio {:.4} at the mode {:.4} rad/s, between the pairs", caughey.ratio(worst.omega), worst.omega),
        "pairs whose series is not negative at any mode: fewer or closer ones",
    ))
}

/// A refusal as an error of the options.
fn refused(error: DampingError) -> FeError {
    FeError::Option { option: error.option.into(), found: error.found, allowed: error.allowed }
}

/// A ratio in percent, without trailing zeros.
fn percent(ratio: f64) -> f64 {
    (ratio * 1e8).round() / 1e6
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::harmonic::{self, test_tanks};
    use fem::linalg::dot;

    /// The wall's part of the matrix, a_K K without the gravity of the surface, at the modes of wall and liquid: the ratio by group is
    /// its φᵀ C φ/(2 ω). Gravity has (ω_s/ω)² of the stiffness in a structural mode, below 1e-3 of this tank.
    #[test]
    fn by_group_is_the_matrix_of_the_wall() {
        let case = test_tanks::broad();
        let coupled = harmonic::build(&case, &tank::options::LinearOptions::default(), 1).unwrap();
        let modes = crate::modes::solve(&coupled, None).unwrap();
        let model = DampingModel::ByGroup { wall: 0.02, sloshing: 0.005 };
        let damper = Damper::new(&case, &model).unwrap().tuned(&modes);
        let structural = || modes.iter().filter(|m| m.kind == Kind::Structural).take(4);
        let first = structural().next().unwrap().omega;
        assert!((damper.ratio(Kind::Structural, first) - 0.02).abs() < 1e-15);
        for mode in structural() {
            let x = &mode.vector;
            let wall = dot(&coupled.stiffness.times(x), x) - coupled.surface.energy(x);
            let of_matrix = 2.0 * 0.02 / first * wall / (2.0 * mode.omega);
            let ratio = damper.ratio(mode.kind, mode.omega);
            assert!((ratio / of_matrix - 1.0).abs() < 1e-3, "{} {ratio} {of_matrix}", mode.number);
        }
        for mode in modes.iter().filter(|m| m.kind == Kind::Sloshing) {
            assert_eq!(damper.ratio(mode.kind, mode.omega), 0.005);
        }
    }
}
