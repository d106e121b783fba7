//! The motion of a base that turns and slips, as ground motion of the wall built into it.
//!
//! ```text
//! M ẍ + C ẋ + K x = −M ι A − M κ ψ̈          x relative to the moving base, ẍ_total = ẍ + ι A + κ ψ̈
//! ```
//!
//! A = a_g + s̈ and ψ̈ are those of [`::base::history`]; with both known the system is linear. Its part under ψ̈ is that of the same system with
//! the influence vector κ. Observables are the same rows: nothing of the clamped edge moves with ψ̈ but, by reciprocity, its share b_M of
//! the base moment under A, which is that of the base shear under ψ̈.
//!
//! A base whose rotation is given ([`Turned::driven`]) turns the floor as well, and gravity with it:
//!
//! ```text
//! M ẍ + C ẋ + K x = −M ι (a_g − g ψ) − (f_ψ − M s) ψ̈
//! ```
//!
//! f_ψ is the row of the overturning moment, with the pressure on the floor: the force on the unknowns under a surface that stays level. The
//! surface that rests in the tank turns with it, by −s with s = g K_s⁻¹ (M ι)_s, η = r cos θ for a unit rotation.
//!
//! In axes of the tank gravity has g ψ along x; a slow rotation is a horizontal acceleration −g ψ. ψ is the integral from rest, and stays
//! what it is when the record ends.

use fem::linalg::{Cholesky, dot};
use oscillator::record::Record;
use results::Channel;
use results::channel::OnWall;
use tank::options::LinearOptions as Options;
use tank::options::linear::Integrator;
use tank::{Case, Support, WallBase};

use super::soil::{Rigid, Slab};
use super::system::Harmonic;
use crate::FeError;
use crate::coupled::Coupled;
use crate::error::failure;
use crate::probe::Probe;
use crate::response::motion::{Grid, Motion};

/// m = 1 under the rotation of its base.
#[derive(Clone, Debug)]
pub(crate) struct Turned {
    /// The system with the influence vector κ, and its modes.
    pub harmonic: Harmonic,
    /// Step of the motion of the base [s].
    pub step: f64,
    /// Steps in one of the record.
    pub sub_steps: usize,
    /// A at each step [m/s²].
    pub acceleration: Vec<f64>,
    /// ψ̈ at each step [rad/s²].
    pub rotation: Vec<f64>,
}

impl Turned {
    /// * `grid`: the record's steps with those of the motion of the base
    /// * `acceleration` A [m/s²] and `rotation` ψ̈ [rad/s²] at each of them
    pub(crate) fn new(horizontal: &Harmonic, grid: &Grid, acceleration: Vec<f64>, rotation: Vec<f64>) -> Turned {
        let mut harmonic = horizontal.clone();
        let turn = harmonic.coupled.mass.times(&harmonic.coupled.moment_arm);
        for mode in &mut harmonic.modes {
            mode.participation = dot(&mode.vector, &turn);
        }
        lean(&mut harmonic.coupled);
        Turned { harmonic, step: grid.h(), sub_steps: grid.sub_steps, acceleration, rotation }
    }

    /// m = 1 on a base that turns as a record says, floor and all.
    ///
    /// * `grid`: the steps of the run
    /// * `along`: a_g; `rotation`: ψ̈
    ///
    /// Errors: a mass that is not positive definite; a rotation that is not small.
    pub(crate) fn driven(
        horizontal: &Harmonic,
        case: &Case,
        grid: &Grid,
        (along, rotation): (&Record, &Record),
    ) -> Result<Turned, FeError> {
        let missing = || FeError::Analysis("a base that turns: no row of the overturning moment".into());
        let rigid = Rigid::of_tank(&horizontal.coupled, case).ok_or_else(missing)?;
        let mut harmonic = horizontal.clone();
        whole(&mut harmonic.coupled, &rigid, case.gravity)?;
        let force = harmonic.coupled.mass.times(&harmonic.coupled.influence);
        for mode in &mut harmonic.modes {
            mode.participation = dot(&mode.vector, &force);
        }
        let (along, turn) = (Motion::new(along, grid), Motion::new(rotation, grid));
        let h = grid.h();
        let angles = angles(h, (0..grid.steps().min(turn.last())).map(|i| turn.interval(i)));
        let largest = angles.iter().fold(0.0_f64, |most, angle| most.max(angle.abs()));
        let angle = |i: usize| angles[i.min(angles.len() - 1)];
        let acceleration = (0..=grid.steps()).map(|i| along.at(i) - case.gravity * angle(i)).collect();
        if largest > MOST {
            return Err(FeError::Option {
                option: rotation.name.clone(),
                found: format!("an angle of up to {largest:.3} rad by integration from rest"),
                allowed: format!("at most {MOST} rad: a record without drift"),
            });
        }
        let rotation = (0..=grid.steps()).map(|i| turn.at(i)).collect();
        Ok(Turned { harmonic, step: h, sub_steps: grid.sub_steps, acceleration, rotation })
    }

    /// A and ψ̈ on a grid.
    pub(crate) fn motions(&self, grid: &Grid) -> [Motion; 2] {
        [&self.acceleration, &self.rotation].map(|values| Motion::sampled(self.step, values, grid))
    }
}

/// ψ at the start and the ends of steps [rad], from ψ̈ at the start and the end of each, linear between, by integration from rest.
pub(super) fn angles(step: f64, rates: impl Iterator<Item = (f64, f64)>) -> Vec<f64> {
    let (mut velocity, mut angle) = (0.0, 0.0);
    let next = rates.map(|(start, end)| {
        angle += step * (velocity + step * (2.0 * start + end) / 6.0);
        velocity += 0.5 * step * (start + end);
        angle
    });
    std::iter::once(0.0).chain(next).collect()
}

/// The system under a rotation of wall and floor.
fn whole(coupled: &mut Coupled, rigid: &Rigid, gravity: f64) -> Result<(), FeError> {
    let mut influence = Cholesky::factor(&coupled.mass)
        .map_err(failure("the mass matrix of the tank that turns"))?
        .solve_vector(&rigid.moment);
    let shown = |probe: &Probe, z: Option<f64>, coupled: &Coupled| {
        // The rows contain what the influence vector moves.
        let own = &probe.absolute_acceleration;
        let moved = if own.is_empty() { 0.0 } else { dot(own, &influence) };
        rigid.turned(probe, z, coupled) - moved
    };
    let mut turned = coupled.clone();
    for (probe, held) in turned.probes.iter_mut().zip(&coupled.probes) {
        probe.ground_acceleration = shown(held, None, coupled);
    }
    let lines = turned.lines.iter_mut().chain(&mut turned.shear);
    for (line, held) in lines.zip(coupled.lines.iter().chain(&coupled.shear)) {
        for ((probe, held), z) in line.probes.iter_mut().zip(&held.probes).zip(&line.z) {
            probe.ground_acceleration = shown(held, (line.what == OnWall::Pressure).then_some(*z), coupled);
        }
    }
    // The surface turns with the tank; what the probes show of it is in their values under a level one.
    let level = Cholesky::factor(&coupled.stiffness)
        .map_err(failure("the coupled stiffness matrix"))?
        .solve_vector(&coupled.mass.times(&coupled.influence));
    coupled.surface.unknowns.clone().for_each(|i| influence[i] -= gravity * level[i]);
    turned.influence = influence;
    *coupled = turned;
    Ok(())
}

/// Largest angle of a base whose rotation is given [rad]: sin ψ and ψ differ by 0.2 %.
const MOST: f64 = 0.1;

/// Why the harmonic engine does not turn the base of a tank, and what to do; none where it does.
pub(crate) fn turns_no_base(case: &Case, options: &Options) -> Option<(&'static str, &'static str)> {
    let foundation = matches!(Slab::of(case), Ok(None));
    let motion = case.ground_motion.as_ref();
    let remove = "remove the rotation of the base";
    let reasons = [
        (case.tank.support == Support::Unanchored, "an unanchored tank turns by itself", remove),
        (case.tank.isolators.is_some(), "a base on isolators turns by itself", "remove `tank.isolators`"),
        (!foundation, "a slab on soil turns by itself", "remove `tank.foundation.shear_wave_velocity`"),
        (case.tank.wall_base != WallBase::Fixed, "the base of a wall that is clamped to it alone is turned", remove),
        (
            motion.is_some_and(|m| m.transverse.is_some()),
            "the base turns under one horizontal component",
            "remove --quake-y",
        ),
        (
            !options.dashpots.is_empty(),
            "dashpots to the ground do not turn with the base",
            "remove `analysis.damping.dashpots`",
        ),
        (
            options.integrator == Integrator::Newmark,
            "the base turns with modal integration",
            "remove the integrator \"newmark\"",
        ),
    ];
    reasons.into_iter().find(|(applies, ..)| *applies).map(|(_, reason, help)| (reason, help))
}

/// The system under a rotation.
fn lean(coupled: &mut Coupled) {
    let edge = coupled.probe(Channel::BaseMoment).map_or(0.0, |probe| probe.ground_acceleration);
    let on_lines = coupled.lines.iter_mut().chain(&mut coupled.shear);
    let probes = coupled.probes.iter_mut().chain(on_lines.flat_map(|line| &mut line.probes));
    for probe in probes {
        probe.ground_acceleration = match probe.channel {
            Channel::BaseShear => edge,
            _ => 0.0,
        };
    }
    coupled.influence = coupled.moment_arm.clone();
}
