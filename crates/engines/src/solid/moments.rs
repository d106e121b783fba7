//! The whole state of the model at given moments, from the reduced coordinates.

use tank::case::GroundMotion;

use super::reduce::Space;
use super::rows::sparse_dot;
use crate::FeError;
use crate::linear::model::Model;
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
    q: Vec<Vec<f64>>,
    acceleration: Vec<Vec<f64>>,
    ground: Vec<f64>,
}

/// The state at one moment.
pub(super) struct Moment {
    /// Time [s].
    pub time: f64,
    /// Unknowns relative to the ground; zero for potentials.
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
        let kept: Vec<Vec<&CoupledMode>> = model
            .systems()
            .map(|h| superpose::keep(&h.modes, &model.damper, options.wave_modes))
            .collect();
        let systems = model
            .systems()
            .zip(&kept)
            .map(|(h, kept)| ModalSystem::new(&h.coupled, kept.clone(), &model.damper))
            .collect::<Result<Vec<ModalSystem>, FeError>>()?;
        let grid = model.grid(motion, Integrator::Modal)?;
        let records = std::iter::once(&motion.horizontal).chain(&motion.vertical);
        let ground: Vec<Motion> = records.map(|r| Motion::new(r, &grid)).collect();
        let ground: Vec<&Motion> = ground.iter().collect();
        let sizes: Vec<usize> = model.systems().map(|h| h.coupled.influence.len()).collect();
        let probes: Vec<(usize, Vec<Probe>)> = sizes.iter().map(|&n| unit_probes(n)).enumerate().collect();
        let observables: Vec<Observable> = probes
            .iter()
            .flat_map(|(system, probes)| probes.iter().map(|p| vec![(*system, 1.0, p)]))
            .collect();
        let observed = superpose::respond(&systems, &ground, grid, &observables, &[], &fem::progress::Silent)?;
        let mut rest = observed.scalars.into_iter().map(|h| h.values);
        let directions = model
            .systems()
            .zip(&sizes)
            .map(|(h, &n)| {
                let q: Vec<Vec<f64>> = rest.by_ref().take(n).collect();
                let mut acceleration: Vec<Vec<f64>> = rest.by_ref().take(n).collect();
                let ground = rest.next().unwrap_or_default();
                for (values, iota) in acceleration.iter_mut().zip(&h.coupled.influence) {
                    for (value, a) in values.iter_mut().zip(&ground) {
                        *value -= iota * a;
                    }
                }
                Direction {
                    q,
                    acceleration,
                    ground,
                }
            })
            .collect();
        Ok(Histories {
            dt: grid.dt,
            samples: grid.samples,
            directions,
        })
    }

    /// The state at the sample nearest to `time` [s]; `spaces` belong to the directions.
    pub(super) fn at(&self, spaces: &[Space], time: f64) -> Moment {
        let sample = ((time / self.dt).round().max(0.0) as usize).min(self.samples - 1);
        let size = spaces[0].rigid.len();
        let (mut displacement, mut acceleration) = (vec![0.0; size], vec![0.0; size]);
        for (direction, space) in self.directions.iter().zip(spaces) {
            let take = |histories: &[Vec<f64>]| histories.iter().map(|h| h[sample]).collect::<Vec<f64>>();
            for (x, v) in displacement.iter_mut().zip(space.basis.times(&take(&direction.q))) {
                *x += v;
            }
            let relative = space.basis.times(&take(&direction.acceleration));
            let ground = direction.ground[sample];
            for (e, (x, v)) in acceleration.iter_mut().zip(relative).enumerate() {
                *x += v;
                if space.potentials[e] {
                    *x += ground * space.rigid[e];
                }
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
