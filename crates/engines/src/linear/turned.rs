//! The motion of a base that turns and slips, as ground motion of the wall built into it.
//!
//! ```text
//! M ẍ + C ẋ + K x = −M ι A − M κ ψ̈          x relative to the moving base, ẍ_total = ẍ + ι A + κ ψ̈
//! ```
//!
//! A = a_g + s̈ and ψ̈ are those of [`::base::history`]; with both known the system is linear. Its part under ψ̈ is that of the same system with
//! the influence vector κ. Observables are the same rows: nothing of the clamped edge moves with ψ̈ but, by reciprocity, its share b_M of
//! the base moment under A, which is that of the base shear under ψ̈.

use fem::linalg::dot;
use results::Channel;

use super::system::Harmonic;
use crate::coupled::Coupled;
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

    /// A and ψ̈ on a grid.
    pub(crate) fn motions(&self, grid: &Grid) -> [Motion; 2] {
        [&self.acceleration, &self.rotation].map(|values| Motion::sampled(self.step, values, grid))
    }
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
