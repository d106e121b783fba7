//! Effective period and damping of a structure of one mass on a rigid disc.
//!
//! ```text
//! 1/S(ω) = 1/(k + iωc) + 1/K_x(ω) + h²/K_θ(ω)          massless foundation
//! Re S(ω̃) = m ω̃²          T̃ = 2π/ω̃          ξ̃ = Im S/(2 Re S)
//! static:  T̃/T = √(1 + k/K_x (1 + K_x h²/K_θ))
//! ```
//!
//! Above ξ̃ = 0.15 three definitions differ: the complex stiffness at ω̃ above, the viscous oscillator with the same peak of deformation
//! at the same frequency ([`OnSoil::peak`]), and the complex mode of the cones ([`crate::chain`]). A result names its definition.
//!
//! Source: Veletsos & Meek 1974; Veletsos & Verbic 1973.

use std::f64::consts::TAU;

use crate::C64;
use crate::disc::{Disc, Impedance};
use crate::error::{SoilError, not_negative, positive};

/// A structure of one mass on a fixed base.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Structure {
    /// Mass m [kg]: impulsive mass, wall and roof.
    pub mass: f64,
    /// Arm h above the foundation [m]; with a rigid raft the arm with bottom pressure.
    pub height: f64,
    /// Period T on a fixed base [s].
    pub period: f64,
    /// Damping ratio ξ on a fixed base.
    pub damping: f64,
}

/// Period and damping.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Effective {
    /// T̃ [s].
    pub period: f64,
    /// ξ̃.
    pub damping: f64,
}

/// A structure on a disc.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct OnSoil {
    /// The structure.
    pub structure: Structure,
    /// The foundation.
    pub disc: Disc,
}

impl Structure {
    /// k = m (2π/T)² [N/m].
    pub fn stiffness(&self) -> f64 {
        self.mass * (TAU / self.period).powi(2)
    }

    /// c = 2 ξ m 2π/T [N s/m].
    pub fn dashpot(&self) -> f64 {
        2.0 * self.damping * self.mass * TAU / self.period
    }
}

impl OnSoil {
    /// A structure on a disc.
    ///
    /// Errors: a mass, arm or period that is not above 0, a negative damping.
    pub fn new(structure: Structure, disc: Disc) -> Result<OnSoil, SoilError> {
        positive("mass [kg]", structure.mass)?;
        positive("arm [m]", structure.height)?;
        positive("period [s]", structure.period)?;
        not_negative("damping ratio", structure.damping)?;
        Ok(OnSoil { structure, disc })
    }

    /// k h²/K_θ + k/K_x; below 0.05 the soil changes the period by less than 2.5 %.
    pub fn flexibility(&self) -> f64 {
        let (k, s) = (self.structure.stiffness(), self.disc.stiffness());
        k * self.structure.height.powi(2) / s.rocking + k / s.horizontal
    }

    /// T̃ on static springs [s].
    pub fn static_period(&self) -> f64 {
        self.structure.period * (1.0 + self.flexibility()).sqrt()
    }

    /// S(ω) [N/m].
    pub fn complex_stiffness(&self, omega: f64, kind: Impedance) -> C64 {
        let Structure { height, .. } = self.structure;
        let wall = C64::new(self.structure.stiffness(), omega * self.structure.dashpot());
        let ground = self.disc.horizontal(omega, kind).inv() + height * height * self.disc.rocking(omega, kind).inv();
        (wall.inv() + ground).inv()
    }

    /// T̃ and ξ̃ of the complex stiffness.
    ///
    /// Errors: no convergence (a layer whose cut-off frequency lies at ω̃).
    pub fn effective(&self, kind: Impedance) -> Result<Effective, SoilError> {
        let square = self.structure.height.powi(2);
        effective(&self.structure, TAU / self.static_period(), |omega| {
            self.disc.horizontal(omega, kind).inv() + square * self.disc.rocking(omega, kind).inv()
        })
    }

    /// Damping ratio without the structure's own share, ξ̃ − ξ (T/T̃)³.
    pub fn foundation_damping(&self, effective: Effective) -> f64 {
        effective.damping - self.structure.damping * (self.structure.period / effective.period).powi(3)
    }

    /// Deformation of the structure times ω², over the ground acceleration: |S k/m/((S − m ω²)(k + iωc))| m.
    pub fn deformation(&self, omega: f64, kind: Impedance) -> f64 {
        let Structure { mass, .. } = self.structure;
        let k = self.structure.stiffness();
        let s = self.complex_stiffness(omega, kind);
        (s * k / ((s - mass * omega * omega) * C64::new(k, omega * self.structure.dashpot()))).norm()
    }

    /// The viscous oscillator whose deformation has the same peak at the same frequency:
    ///
    /// ```text
    /// 1/(2 ξ √(1 − ξ²)) = peak          T̃ = T_peak √(1 − 2 ξ²)
    /// ```
    ///
    /// None where the peak is below 1 (ξ > 0.7: no resonance).
    pub fn peak(&self, kind: Impedance) -> Option<Effective> {
        let fixed = TAU / self.structure.period;
        let at = |x: f64| self.deformation(x * fixed, kind);
        // From a tenth of the fixed-base frequency to 1.2 of it; then golden section.
        const SCAN: usize = 2000;
        let place = |i: usize| 0.1 + 1.1 * i as f64 / SCAN as f64;
        let best = (0..=SCAN).max_by(|&i, &j| at(place(i)).total_cmp(&at(place(j))))?;
        let (mut low, mut high) = (place(best.saturating_sub(1)), place(best + 1));
        let golden = (5.0_f64.sqrt() - 1.0) / 2.0;
        while high - low > 1e-9 {
            let (a, b) = (high - golden * (high - low), low + golden * (high - low));
            if at(a) > at(b) {
                high = b;
            } else {
                low = a;
            }
        }
        let x = 0.5 * (low + high);
        let inverse = 1.0 / at(x).powi(2);
        if inverse >= 1.0 {
            return None;
        }
        let square = 0.5 * (1.0 - (1.0 - inverse).sqrt());
        Some(Effective { period: TAU / (x * fixed) * (1.0 - 2.0 * square).sqrt(), damping: square.sqrt() })
    }
}

/// T̃ and ξ̃ of the complex stiffness of a structure on ground of this flexibility under its mass [m/N].
///
/// * `omega`: where the search begins [rad/s]
///
/// Errors: no convergence.
pub(crate) fn effective(
    structure: &Structure,
    mut omega: f64,
    ground: impl Fn(f64) -> C64,
) -> Result<Effective, SoilError> {
    const STEPS: usize = 500;
    let stiffness = |omega: f64| {
        let wall = C64::new(structure.stiffness(), omega * structure.dashpot());
        (wall.inv() + ground(omega)).inv()
    };
    let mut change = f64::INFINITY;
    for _ in 0..STEPS {
        // Half of the way: the rocking stiffness falls with ω, which turns the full step into a slow oscillation.
        let wanted = (stiffness(omega).re / structure.mass).sqrt();
        change = (wanted / omega - 1.0).abs();
        omega = 0.5 * (omega + wanted);
        if change < 1e-14 {
            break;
        }
    }
    if change.is_nan() || change > 1e-10 {
        let what = "effective period on soil";
        return Err(SoilError::Iteration { what, steps: STEPS, change });
    }
    let s = stiffness(omega);
    Ok(Effective { period: TAU / omega, damping: s.im / (2.0 * s.re) })
}
