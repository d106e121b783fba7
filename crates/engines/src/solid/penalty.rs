//! What a rotation penalty of the user does to the waves of a run.
//!
//! The full rotation part has 14 modes in an element where a liquid has three rotations to lose ([B02, table 5.3]; rows `fluid-rank`): it also
//! resists the bending of an element, so that a large K_rot raises the frequencies of the waves. Under a small one the modes of the penalty
//! itself lie among the waves. The lowest that turns with the motion of the tank is a swirl about vertical axes, alike at all depths,
//!
//! ```text
//! ψ = J₁(k r) cos θ    curl u = −k² ψ    ω_r = k √(K_rot/2ρ)    k R = j₁,₁ = 3.8317
//! ```
//!
//! whose stream function vanishes at the wall, which the liquid does not cross, and with it the rotation, as the natural condition there asks.
//! Known value: K_rot = ρ g R in tank 8.1, 2.09 ω₁; the elements have 2.1 (row K6).

use tank::Case;
use tank::options::LinearOptions as Options;
use tank::options::solid::SolidOptions;
use tank::units::Dimension;

use super::model::{TankModel, displacement_liquid};
use crate::linear::limits::limit_of;
use crate::linear::system::Harmonic;
use crate::modes::Kind;
use fem::element::{LiquidProperties, RotationPart};
use results::{Limit, Mode};
use std::f64::consts::TAU;

/// First zero of J₁′, and of J₁ (Abramowitz & Stegun 1964, tables 9.5).
const SLOSHING: f64 = 1.841_183_781_340_659;
const SWIRL: f64 = 3.831_705_970_207_512;

/// Share by which the elements may raise the first frequency: the default element has 0.7 % on 12 × 16 × 12 (row K4), and 2 % in ω are 4 % in
/// stiffness.
const RAISED: f64 = 1.02;

/// Lowest circular frequency of a mode of the penalty that turns with the motion of a cylinder [rad/s].
fn swirl(liquid: &LiquidProperties, penalty: f64, radius: f64) -> f64 {
    SWIRL / radius * (0.5 * penalty / liquid.density).sqrt()
}

/// Limits of validity of a rotation penalty of the user; none of the default element.
pub(super) fn limits(case: &Case, tank: &TankModel, horizontal: &Harmonic, options: &Options) -> Vec<Limit> {
    let waves = horizontal.modes.iter().filter(|m| m.kind == Kind::Sloshing && m.number <= options.wave_modes.max(1));
    let omegas: Vec<f64> = waves.map(|mode| mode.omega).collect();
    judged(case, &tank.properties, &omegas)
}

/// What these limits say of the modes of a tank, where they do not hold.
pub fn notes(case: &Case, solid: &SolidOptions, modes: &[Mode]) -> Vec<String> {
    let waves = modes.iter().filter(|m| m.harmonic == 1 && m.kind == Kind::Sloshing.id());
    let omegas: Vec<f64> = waves.map(|mode| mode.omega).collect();
    let found = judged(case, &displacement_liquid(case, solid), &omegas);
    found.into_iter().map(|limit| limit.note).filter(|note| !note.is_empty()).collect()
}

/// The limits for the sloshing modes of cos θ, ascending [rad/s].
fn judged(case: &Case, liquid: &LiquidProperties, omegas: &[f64]) -> Vec<Limit> {
    let RotationPart::Full(penalty) = liquid.rotation else { return Vec::new() };
    let (Some(first), Some(highest)) = (omegas.first(), omegas.last()) else { return Vec::new() };
    let radius = case.tank.shape.half_length();
    let k = SLOSHING / radius;
    let exact = (case.gravity * k * (k * case.liquid.fill_height).tanh()).sqrt();
    let raised = first / exact;
    let lowest = swirl(liquid, penalty, radius);
    vec![
        limit_of(
            "rotation_penalty_raises_waves",
            "First sloshing frequency over that of potential flow, with a rotation penalty of the user",
            [raised, RAISED],
            Dimension::Dimensionless,
            raised <= RAISED,
            || {
                "The full rotation part resists the bending of the elements, not their rotation alone, and raises the frequencies of the \
                 waves: lower rotation_penalty, or take more elements around the tank."
                    .into()
            },
        ),
        limit_of(
            "rotation_modes_among_waves",
            "Highest sloshing mode of the wave against the lowest mode of the rotation penalty",
            [highest / TAU, lowest / TAU],
            Dimension::Frequency,
            *highest < lowest,
            || {
                "Modes of the rotation penalty lie among the sloshing modes and take part of their motion: raise rotation_penalty, or leave \
                 it out."
                    .into()
            },
        ),
    ]
}

#[cfg(test)]
mod tests {
    use super::*;

    /// By hand: 3.8317/1.83 √(1000 · 9.81 · 1.83/2000) = 6.273 rad/s.
    #[test]
    fn swirl_of_tank_8_1() {
        let liquid = LiquidProperties::new(1000.0, 2.06e9, 9.81, 1.83);
        let found = swirl(&liquid, 1000.0 * 9.81 * 1.83, 1.83);
        assert!((found - 6.273).abs() < 5e-4, "{found}");
    }
}
