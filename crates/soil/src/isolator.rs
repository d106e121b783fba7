//! Laws of isolators, as the sum over all bearings of a tank.
//!
//! | kind | force | K_eff(D) | ξ_eff(D) |
//! |---|---|---|---|
//! | lead rubber | K₂ d + Q z, K₁ before yielding | K₂ + Q/D | 2 Q (D − d_y)/(π K_eff D²) |
//! | friction pendulum | N d/R_c + μ N v/\|v\| | N/R_c + μ N/D | (2/π) μ/(μ + D/R_c) |
//! | elastomer | K d + c v | K | ξ |
//! | viscous damper | C \|v\|^α v/\|v\| | 0 | C λ(α) ω^α D^{α−1}/(2π K) with the stiffness K beside it |
//!
//! with d_y = Q/(K₁ − K₂). Two horizontal components share a circular yield surface: the friction or yield force is a vector of length at
//! most Q. A friction pendulum slips elastically over a small distance before it slides, which gives sticking a stiffness.
//!
//! N = N₀ (1 + a_v/g); overturning does not change the sum of N. Uplift of single bearings is not modelled.
//!
//! Source: Naeim & Kelly 1999 (effective stiffness and damping); Zayas et al. 1990 (friction pendulum); Park, Wen & Ang 1986 (two
//! components); Constantinou et al. 1990 (friction and velocity).

use std::f64::consts::PI;

use crate::error::{SoilError, not_negative, positive};

/// Isolators of one kind, all bearings together.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Isolator {
    /// Lead-rubber bearings, bilinear.
    LeadRubber {
        /// Characteristic strength Q [N].
        strength: f64,
        /// Stiffness K₁ before yielding [N/m].
        initial_stiffness: f64,
        /// Stiffness K₂ after yielding [N/m].
        yielded_stiffness: f64,
    },
    /// Friction pendulums.
    FrictionPendulum {
        /// Radius R_c of the concave surface [m].
        radius: f64,
        /// Friction.
        friction: Friction,
        /// Distance of elastic slip before sliding [m].
        slip: f64,
    },
    /// Elastomeric bearings, linear.
    Elastomer {
        /// Stiffness K [N/m].
        stiffness: f64,
        /// Damping ratio ξ at the period of the mass above on K.
        damping: f64,
    },
    /// Viscous dampers.
    Damper {
        /// C [N (s/m)^α].
        coefficient: f64,
        /// Exponent α, above 0 to 2.
        exponent: f64,
    },
}

/// Friction coefficient μ(v) = μ_max − (μ_max − μ_min) e^{−a |v|}.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Friction {
    /// μ_max.
    pub fast: f64,
    /// μ_min at rest.
    pub slow: f64,
    /// a [s/m].
    pub rate: f64,
}

impl Friction {
    /// A coefficient that does not depend on the velocity.
    pub fn constant(mu: f64) -> Friction {
        let (fast, slow, rate) = (mu, mu, 0.0);
        Friction { fast, slow, rate }
    }

    /// μ at the speed |v| [m/s].
    pub fn at(&self, speed: f64) -> f64 {
        self.fast - (self.fast - self.slow) * (-self.rate * speed).exp()
    }
}

/// Effective linear properties of a cycle.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct EffectiveLinear {
    /// K_eff [N/m].
    pub stiffness: f64,
    /// ξ_eff.
    pub damping: f64,
}

/// The parts of a law: F = k d + c v + h with |h| ≤ q, + C |v|^α v/|v|.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Parts {
    pub(crate) linear: f64,
    pub(crate) viscous: f64,
    /// Stiffness of the part h before it yields [N/m].
    pub(crate) stick: f64,
    pub(crate) yields: Yield,
    pub(crate) damper: Option<(f64, f64)>,
}

/// Strength of the part that yields.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) enum Yield {
    /// Q [N].
    Constant(f64),
    /// μ(v) N, with N₀ [N].
    Friction(Friction, f64),
}

impl Isolator {
    /// Checks its values.
    ///
    /// Errors: a value outside its range, K₁ not above K₂, μ_min above μ_max.
    pub fn check(&self) -> Result<(), SoilError> {
        match *self {
            Isolator::LeadRubber { strength, initial_stiffness, yielded_stiffness } => {
                positive("strength of the lead [N]", strength)?;
                positive("stiffness after yielding [N/m]", yielded_stiffness)?;
                positive("stiffness before yielding less that after it [N/m]", initial_stiffness - yielded_stiffness)
            }
            Isolator::FrictionPendulum { radius, friction, slip } => {
                positive("radius of the concave surface [m]", radius)?;
                positive("elastic slip [m]", slip)?;
                positive("friction coefficient", friction.slow)?;
                not_negative("friction coefficient of fast sliding less that at rest", friction.fast - friction.slow)?;
                not_negative("rate of the friction [s/m]", friction.rate)
            }
            Isolator::Elastomer { stiffness, damping } => {
                positive("stiffness of the elastomer [N/m]", stiffness)?;
                not_negative("damping ratio of the elastomer", damping)
            }
            Isolator::Damper { coefficient, exponent } => {
                positive("coefficient of the damper", coefficient)?;
                positive("exponent of the damper", exponent)?;
                not_negative("2 less the exponent of the damper", 2.0 - exponent)
            }
        }
    }

    /// Effective stiffness and damping of a cycle of amplitude D [m]; the formulas of the module.
    ///
    /// * `weight`: N₀ [N], used by friction pendulums alone
    /// * `omega`: circular frequency of the cycle [rad/s] and `beside`, the stiffness of the other isolators [N/m]; both are used by
    ///   dampers alone
    pub fn effective(&self, amplitude: f64, weight: f64, omega: f64, beside: f64) -> EffectiveLinear {
        let d = amplitude;
        match *self {
            Isolator::LeadRubber { strength: q, initial_stiffness, yielded_stiffness } => {
                let yields = q / (initial_stiffness - yielded_stiffness);
                if d <= yields {
                    return EffectiveLinear { stiffness: initial_stiffness, damping: 0.0 };
                }
                let stiffness = yielded_stiffness + q / d;
                EffectiveLinear { stiffness, damping: 2.0 * q * (d - yields) / (PI * stiffness * d * d) }
            }
            Isolator::FrictionPendulum { radius, friction, .. } => {
                let mu = friction.fast;
                EffectiveLinear {
                    stiffness: weight / radius + mu * weight / d,
                    damping: 2.0 / PI * mu / (mu + d / radius),
                }
            }
            Isolator::Elastomer { stiffness, damping } => EffectiveLinear { stiffness, damping },
            Isolator::Damper { coefficient, exponent } => {
                let work = coefficient * omega.powf(exponent) * d.powf(1.0 + exponent) * cycle(exponent);
                EffectiveLinear { stiffness: 0.0, damping: work / (2.0 * PI * beside * d * d) }
            }
        }
    }

    /// Its parts, carrying the mass `mass` [kg] under gravity `gravity` [m/s²].
    pub(crate) fn parts(&self, mass: f64, gravity: f64) -> Parts {
        let still = Parts { linear: 0.0, viscous: 0.0, stick: 0.0, yields: Yield::Constant(0.0), damper: None };
        match *self {
            Isolator::LeadRubber { strength, initial_stiffness, yielded_stiffness } => Parts {
                linear: yielded_stiffness,
                stick: initial_stiffness - yielded_stiffness,
                yields: Yield::Constant(strength),
                ..still
            },
            Isolator::FrictionPendulum { radius, friction, slip } => Parts {
                linear: mass * gravity / radius,
                stick: friction.fast * mass * gravity / slip,
                yields: Yield::Friction(friction, mass * gravity),
                ..still
            },
            Isolator::Elastomer { stiffness, damping } => {
                Parts { linear: stiffness, viscous: 2.0 * damping * (stiffness * mass).sqrt(), ..still }
            }
            Isolator::Damper { coefficient, exponent } => Parts { damper: Some((coefficient, exponent)), ..still },
        }
    }
}

/// ∫ |cos φ|^{1+α} dφ over a full turn: λ(α), the work of a damper's cycle over C ω^α D^{1+α}. α = 1: π.
pub fn cycle(exponent: f64) -> f64 {
    // The midpoint rule of a periodic function; its kinks at ±π/2 leave an error of (2π/n)^{2+α}.
    const PARTS: usize = 40_000;
    let width = 2.0 * PI / PARTS as f64;
    (0..PARTS).map(|i| ((i as f64 + 0.5) * width).cos().abs().powf(1.0 + exponent) * width).sum()
}

/// Moves the yielding part to displacement `d`: its force [N] and its new slip. Radial return to the circle of radius `strength`.
pub fn yielding_force(stick: f64, strength: f64, d: [f64; 2], slip: [f64; 2]) -> ([f64; 2], [f64; 2]) {
    let trial = [stick * (d[0] - slip[0]), stick * (d[1] - slip[1])];
    let size = trial[0].hypot(trial[1]);
    if size <= strength {
        return (trial, slip);
    }
    let force = trial.map(|f| f * strength / size);
    let slip = [d[0] - force[0] / stick, d[1] - force[1] / stick];
    (force, slip)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_cycle_of_a_linear_damper_is_pi() {
        assert!((cycle(1.0) - PI).abs() < 1e-9);
        // α → 0 is friction: ∫ |cos| = 4.
        assert!((cycle(1e-12) - 4.0).abs() < 1e-6);
    }

    #[test]
    fn the_force_stays_on_the_circle() {
        let (force, slip) = yielding_force(10.0, 2.0, [3.0, 4.0], [0.0, 0.0]);
        assert!((force[0] - 1.2).abs() < 1e-12 && (force[1] - 1.6).abs() < 1e-12);
        let (again, same) = yielding_force(10.0, 2.0, [3.0, 4.0], slip);
        assert!((again[0] - force[0]).abs() < 1e-12 && (same[0] - slip[0]).abs() < 1e-12);
    }

    /// A cycle loses 4 Q (D − d_y) in lead and 4 μ N D in friction, ξ_eff is that over 2π K_eff D²; within d_y lead loses nothing. By hand.
    #[test]
    fn a_cycle_loses_what_its_loop_encloses() {
        let rubber = Isolator::LeadRubber { strength: 2.0, initial_stiffness: 11.0, yielded_stiffness: 1.0 };
        let pendulum = Isolator::FrictionPendulum { radius: 4.0, friction: Friction::constant(0.05), slip: 1e-3 };
        // K_eff = 1 + 2/0.8; 100/4 + 0.05·100/0.5.
        for (isolator, amplitude, stiffness, work) in
            [(rubber, 0.8, 3.5, 8.0 * 0.6), (rubber, 0.2, 11.0, 0.0), (pendulum, 0.5, 35.0, 4.0 * 5.0 * 0.5)]
        {
            let found = isolator.effective(amplitude, 100.0, 0.0, 0.0);
            let wanted = work / (2.0 * PI * stiffness * amplitude * amplitude);
            assert!((found.stiffness - stiffness).abs() < 1e-12, "{found:?}");
            assert!((found.damping - wanted).abs() < 1e-12, "{found:?} {wanted}");
        }
        // A linear damper c beside K: ξ = c ω/(2 K), at any amplitude.
        let damper = Isolator::Damper { coefficient: 3.0, exponent: 1.0 };
        assert!((damper.effective(0.7, 0.0, 5.0, 40.0).damping - 0.1875).abs() < 1e-9);
    }

    /// Half of the difference is left where a |v| = ln 2.
    #[test]
    fn friction_grows_with_speed() {
        let friction = Friction { fast: 0.1, slow: 0.04, rate: 20.0 };
        assert!((friction.at(0.0) - 0.04).abs() < 1e-15);
        assert!((friction.at(2.0_f64.ln() / 20.0) - 0.07).abs() < 1e-15);
        assert!((friction.at(9.0) - 0.1).abs() < 1e-15);
    }

    #[test]
    fn impossible_isolators_are_errors() {
        let rubber =
            |initial_stiffness| Isolator::LeadRubber { strength: 1.0, initial_stiffness, yielded_stiffness: 1.0 };
        assert!(rubber(10.0).check().is_ok());
        assert!(rubber(0.5).check().is_err());
        let damper = |exponent| Isolator::Damper { coefficient: 1.0, exponent };
        assert!(damper(0.3).check().is_ok());
        assert!(damper(2.5).check().is_err());
    }
}
