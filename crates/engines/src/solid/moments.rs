//! The whole state of the model at given moments, from the reduced coordinates.

use oscillator::record::Record;
use tank::case::GroundMotion;

use super::model::TankModel;
use super::reduce::Space;
use super::rows::sparse_dot;
use super::symmetry::turned;
use crate::FeError;
use crate::linear::model::Model;
use crate::linear::system::Harmonic;
use crate::modes::CoupledMode;
use crate::probe::Probe;
use crate::response::motion::Motion;
use crate::response::superpose::{self, ModalSystem, Observable};
use results::Channel;
use tank::options::LinearOptions as Options;
use tank::options::linear::Integrator;

/// Histories of the reduced coordinates at the samples of the record.
pub(super) struct Histories {
    /// Step of the samples [s].
    dt: f64,
    /// Number of samples.
    pub samples: usize,
    /// Direction by direction: q, q̈ relative to the ground, and the ground's acceleration.
    directions: Vec<Direction>,
}

struct Direction {
    /// Number of its system and space.
    system: usize,
    /// Whether its motion is that of its space turned by 90°.
    turned: bool,
    q: Vec<Vec<f64>>,
    acceleration: Vec<Vec<f64>>,
    ground: Vec<f64>,
}

/// The state at one moment.
pub(super) struct Moment {
    /// Time [s].
    pub time: f64,
    /// Unknowns relative to the ground, or to a slab on it that moves; zero for potentials.
    pub displacement: Vec<f64>,
    /// Second derivative of the potential in the whole motion; other entries are accelerations relative to the ground.
    pub acceleration: Vec<f64>,
    /// Mean elevation of a potential liquid's surface [m].
    pub mean_elevation: f64,
}

impl Histories {
    /// Modal superposition of the reduced coordinates themselves.
    ///
    /// Errors: those of [`superpose::respond`].
    pub(super) fn new(model: &Model, motion: &GroundMotion, options: &Options) -> Result<Histories, FeError> {
        let kept: Vec<Vec<&CoupledMode>> =
            model.systems().map(|h| superpose::keep(&h.coupled, &h.modes, &model.damper, options.wave_modes)).collect();
        // Along y the tank moves as along x.
        let second = motion.transverse.as_ref().map(|record| (0, true, record));
        let upwards = motion.vertical.as_ref().map(|record| (1, false, record));
        let directions: Vec<(usize, bool, &Record)> =
            std::iter::once((0, false, &motion.horizontal)).chain(second).chain(upwards).collect();
        let all: Vec<&Harmonic> = model.systems().collect();
        let systems = directions
            .iter()
            .map(|&(system, ..)| ModalSystem::new(&all[system].coupled, kept[system].clone(), &model.damper))
            .collect::<Result<Vec<ModalSystem>, FeError>>()?;
        let grid = model.grid(motion, Integrator::Modal)?;
        let ground: Vec<Motion> = directions.iter().map(|(.., r)| Motion::new(r, &grid)).collect();
        let ground: Vec<&Motion> = ground.iter().collect();
        let sizes: Vec<usize> = directions.iter().map(|&(s, ..)| all[s].coupled.influence.len()).collect();
        let probes: Vec<(usize, Vec<Probe>)> = sizes.iter().map(|&n| unit_probes(n)).enumerate().collect();
        let observables: Vec<Observable> =
            probes.iter().flat_map(|(system, probes)| probes.iter().map(|p| vec![(*system, 1.0, p)])).collect();
        let observed = superpose::respond(&systems, &ground, grid, &observables, &[], &fem::progress::Silent)?;
        let mut rest = observed.scalars.into_iter().map(|h| h.values);
        let directions = directions
            .iter()
            .zip(&sizes)
            .map(|(&(system, turned, _), &n)| {
                let h = all[system];
                let q: Vec<Vec<f64>> = rest.by_ref().take(n).collect();
                let mut acceleration: Vec<Vec<f64>> = rest.by_ref().take(n).collect();
                let ground = rest.next().unwrap_or_default();
                for (values, iota) in acceleration.iter_mut().zip(&h.coupled.influence) {
                    for (value, a) in values.iter_mut().zip(&ground) {
                        *value -= iota * a;
                    }
                }
                Direction { system, turned, q, acceleration, ground }
            })
            .collect();
        Ok(Histories { dt: grid.dt, samples: grid.samples, directions })
    }

    /// Time of the last sample [s].
    pub(super) fn end(&self) -> f64 {
        self.dt * self.samples.saturating_sub(1) as f64
    }

    /// The state at the sample nearest to `time` [s]; `spaces` belong to the systems of the model.
    pub(super) fn at(&self, tank: &TankModel, spaces: &[Space], time: f64) -> Moment {
        let sample = ((time / self.dt).round().max(0.0) as usize).min(self.samples - 1);
        let size = spaces[0].rigid.len();
        let (mut displacement, mut acceleration) = (vec![0.0; size], vec![0.0; size]);
        for direction in &self.directions {
            let space = &spaces[direction.system];
            let take = |histories: &[Vec<f64>]| histories.iter().map(|h| h[sample]).collect::<Vec<f64>>();
            // Unknowns beyond those of the basis are of a slab.
            let own = space.basis.cols;
            let (q, with_slab) = (take(&direction.q), take(&direction.acceleration));
            let mut moved = space.basis.times(&q[..own]);
            let mut relative = space.basis.times(&with_slab[..own]);
            let ground = direction.ground[sample];
            let mut carried = vec![0.0; size];
            for (e, carried) in carried.iter_mut().enumerate().filter(|(e, _)| space.potentials[*e]) {
                let slab = space.slab.iter().flatten().zip(&with_slab[own..]);
                *carried = ground * space.rigid[e] + slab.map(|(phi, a)| phi[e] * a).sum::<f64>();
            }
            if direction.turned {
                [moved, relative, carried] = [moved, relative, carried].map(|x| turned(tank, &x));
            }
            for (x, v) in displacement.iter_mut().zip(moved) {
                *x += v;
            }
            for ((x, v), ground) in acceleration.iter_mut().zip(relative).zip(carried) {
                *x += v;
                *x += ground;
            }
        }
        for (e, x) in displacement.iter_mut().enumerate() {
            if spaces[0].potentials[e] {
                *x = 0.0;
            }
        }
        Moment {
            time: sample as f64 * self.dt,
            acceleration,
            mean_elevation: sparse_dot(&spaces[0].mean_elevation, &displacement),
            displacement,
        }
    }
}

/// Probes of every coordinate, of its absolute acceleration, and of the ground's acceleration.
fn unit_probes(n: usize) -> Vec<Probe> {
    // Their titles are not used.
    let probe = |displacement, absolute_acceleration, ground_acceleration| Probe {
        displacement,
        absolute_acceleration,
        ground_acceleration,
        ..Probe::new(Channel::Top)
    };
    let unit = |i: usize| -> Vec<f64> { (0..n).map(|j| if i == j { 1.0 } else { 0.0 }).collect() };
    let mut probes: Vec<Probe> = (0..n).map(|i| probe(unit(i), Vec::new(), 0.0)).collect();
    probes.extend((0..n).map(|i| probe(Vec::new(), unit(i), 0.0)));
    probes.push(probe(vec![0.0; n], vec![0.0; n], 1.0));
    probes
}
