//! The law of the base up to a rotation.

use std::sync::{Arc, OnceLock};

use super::setup::{Laws, Setup};
use ::base::{Base, BaseError, Heave, Law, Ring, Rocking, Waves};
use tank::STANDARD_GRAVITY;

/// Stress of a wall that no toe exceeds [Pa]; how far the rim is pressed into hard ground.
const CRUSHED: f64 = 500e6;
/// How often the curves of the strips are drawn farther.
const TRIES: usize = 4;

/// The law up to a rotation [rad], or one that is known and reaches it.
///
/// Errors: no equilibrium.
pub(super) fn laws(setup: &Setup, base: &Base, largest: f64) -> Result<Arc<Laws>, BaseError> {
    let Some(known) = &setup.known else { return law(setup, base, largest).map(Arc::new) };
    if let Some(found) = known.reaching(base.modulus, largest) {
        return Ok(found);
    }
    let made = Arc::new(law(setup, base, largest)?);
    known.add(base.modulus, &made);
    Ok(made)
}

/// The law up to a rotation [rad].
///
/// Errors: no equilibrium.
pub(super) fn law(setup: &Setup, base: &Base, largest: f64) -> Result<Laws, BaseError> {
    let reach = largest * base.radius;
    // The rim loads a strip of this width.
    let width = 2.0 * (4.0 * base.plate().bending_stiffness() / base.modulus).powf(0.25);
    let line = base.modulus * width;
    let rest = 10.0 * base.pressure / base.modulus + 5.0 * base.weight / line;
    let mut pressed = reach.min(CRUSHED * base.wall_thickness() / line) + rest;
    let mut lifted = base.rise() * reach + 0.02;
    let mut tries = 0;
    loop {
        let rocking = base.rocking(-pressed, lifted, true)?;
        // Under a mass on the foot the waves follow at once.
        let (rocking, waves) = match setup.heave {
            Some(_) => (rocking, None),
            None => Waves::of(rocking, setup.damping)?,
        };
        let made = Law::new(&rocking, largest).and_then(|law| {
            let ring = setup.anchors.map(|anchors| Ring::new(anchors, &rocking, &law)).transpose()?;
            let heave = if ring.is_none() { heave(setup, base, &rocking, &law)? } else { None };
            Ok((law, ring, heave))
        });
        match made {
            Err(BaseError::BeyondCurve { wanted, from, to, .. }) if tries < TRIES => {
                tries += 1;
                if wanted > 0.5 * (from + to) {
                    lifted *= 1.5;
                } else {
                    pressed *= 3.0;
                }
            }
            other => {
                let (law, ring, heave) = other?;
                return Ok(Laws { rocking, law, ring, heave, waves, losses: OnceLock::new() });
            }
        }
    }
}

/// Wall and roof on the foot, with its damping and what the ground under its ring radiates; none where it is not asked for.
///
/// Errors: no equilibrium.
fn heave(setup: &Setup, base: &Base, rocking: &Rocking, law: &Law) -> Result<Option<Heave>, BaseError> {
    let Some(asked) = setup.heave else { return Ok(None) };
    let mass = std::f64::consts::TAU * base.radius * base.weight / STANDARD_GRAVITY;
    let heave = Heave::new(mass, rocking, law)?;
    let stiffness = heave.stiffness();
    // 2 π R of what a metre of the ring resists with, of which c_ψ is π R³.
    let ground = 2.0 * dashpot(setup, base) / base.radius.powi(2);
    let own = match asked.damping {
        Some(ratio) => 2.0 * ratio * (mass / stiffness).sqrt(),
        None => setup.delay,
    };
    Ok(Some(heave.damped(own + ground / stiffness)))
}

/// c_ψ of the closed ground: what it radiates and what its damping loses in proportion to its stiffness.
pub(super) fn closed(setup: &Setup, base: &Base, law: &Law) -> f64 {
    dashpot(setup, base) + setup.ground_damping[1] * law.initial()
}

/// c_ψ = π R³ ρ_s V_La B of the rim's strip on soil with shear waves; 0 without.
fn dashpot(setup: &Setup, base: &Base) -> f64 {
    let Some((soil, velocity, density)) = setup.soil else { return 0.0 };
    let analogue = 3.4 * velocity / (std::f64::consts::PI * (1.0 - soil.poisson_ratio));
    let width = 2.0 * (4.0 * base.plate().bending_stiffness() / base.modulus).powf(0.25);
    std::f64::consts::PI * base.radius.powi(3) * density * analogue * width
}
