//! The wall and its liquid as a body on a turning base.
//!
//! ```text
//! Γ^ψ = φᵀ M κ          S = κᵀ M ι + b          J = κᵀ M κ          p = a·(Σ φ q̈ + ι A + κ ψ̈) + b_p A
//! ```
//!
//! κ is the rigid rotation about the base; b and b_p are the shares of the clamped edge.

use ::base::history::{Body, BodyMode};
use fem::linalg::dot;
use results::Channel;
use results::channel::OnWall;

use super::super::model::Model;
use crate::response::superpose;

/// The body, and the rigid parts of its bottom pressure per A and per ψ̈; `None` without the rows of base moment and pressure.
pub(super) fn body(model: &Model, wave_modes: usize) -> Option<(Body, [f64; 2])> {
    let coupled = &model.horizontal.coupled;
    let turn = coupled.mass.times(&coupled.moment_arm);
    let edge = coupled.probe(Channel::BaseMoment)?.ground_acceleration;
    let foot = coupled.line(OnWall::Pressure)?.probes.first()?;
    let pressure = |x: &[f64]| match foot.absolute_acceleration.is_empty() {
        true => 0.0,
        false => dot(&foot.absolute_acceleration, x),
    };
    let kept = superpose::keep(coupled, &model.horizontal.modes, &model.damper, wave_modes);
    let modes = kept.iter().map(|mode| BodyMode {
        omega: mode.omega,
        damping: model.damper.ratio(mode.kind, mode.omega),
        translation: mode.participation,
        rotation: dot(&mode.vector, &turn),
        pressure: pressure(&mode.vector),
    });
    let body = Body {
        modes: modes.collect(),
        mass: coupled.liquid_mass + coupled.wall_mass,
        first_moment: dot(&turn, &coupled.influence) + edge,
        second_moment: dot(&turn, &coupled.moment_arm),
    };
    let rigid = [pressure(&coupled.influence) + foot.ground_acceleration, pressure(&coupled.moment_arm)];
    Some((body, rigid))
}
