//! Discretisation error of a linear run, estimated from a second mesh.
//!
//! ```text
//! v(h) = v(0) + C h^p        E = |v(h) − v(r h)| / |1 − r^p| / |v(h)|                                  (Richardson)
//! ```
//!
//! | engine | quantity | p | reason |
//! |---|---|---|---|
//! | harmonic | first sloshing period, convective mass, wave | 4 | quadratic liquid: eigenvalues and functionals h^{2·2} |
//! | harmonic | all that moves with the wall | 2 | the pressure has a logarithmic singularity where the moving wall meets the surface: the energy converges with h² whatever the degree |
//! | three dimensions | all | 2 | linear elements |
//!
//! The second mesh has elements half as long (r = ½) where that is cheap: then the order matters little (1 − r^p is ¾ or ¹⁵⁄₁₆),
//! and the second values are almost v(0). Above [`FINEST_SECOND`], and in three dimensions, its elements are twice as long (r = 2), and
//! the order matters: differences of two meshes overestimate the error of the finer one by 2^p − 1, 15 for waves.
//!
//! A wave is the sum of several sloshing modes over a long time. On a mesh of linear elements the frequencies of the higher ones are
//! wrong by per cents, their phases drift through whole periods on the coarser mesh, and the peaks of two meshes say little about each
//! other. Frequencies and shares of the modes converge regularly: in three dimensions the wave is computed again with both
//! extrapolated by Richardson, mode by mode, and its change is the estimate.

use std::collections::BTreeMap;

use tank::Quantity;
use tank::options::LinearOptions as Options;
use tank::options::linear::Integrator;

use super::model::Model;
use super::system::Harmonic;
use crate::engine::Simulation;
use crate::modes::{CoupledMode, Kind};
use crate::spectral::ModalUnits;
use fem::linalg::dot;
use results::channel::Side;
use results::{Channel, EngineId, Part};

/// Smallest mesh refinement of the engines.
const COARSEST: f64 = 0.25;
/// Finest second mesh: on it, a run of the harmonic engine takes some tenths of a second.
const FINEST_SECOND: f64 = 4.0;

/// The second mesh of a run.
#[derive(Clone, Debug)]
pub(crate) struct SecondMesh {
    /// Its options. Modal superposition serves for it whatever the integrator.
    pub options: Options,
    /// Length of its elements over those of the run.
    pub ratio: f64,
}

/// Results of a second mesh.
#[derive(Clone, Debug)]
pub(crate) struct Second {
    /// Length of its elements over those of the run.
    pub ratio: f64,
    /// Its comparable values.
    pub values: BTreeMap<Quantity, f64>,
    /// Wave of the run's mesh with extrapolated modes [m].
    pub wave: Option<f64>,
    /// Its response mode by mode.
    pub units: Option<ModalUnits>,
}

impl SecondMesh {
    /// Elements half as long, or, if those are too many, twice as long; `None` where the error is not asked for.
    pub(crate) fn of(options: &Options) -> Option<SecondMesh> {
        match 2.0 * options.refine <= FINEST_SECOND {
            true => SecondMesh::at(options, 2.0 * options.refine),
            false => SecondMesh::coarser(options),
        }
    }

    /// Elements twice as long; `None` also where there are no longer ones.
    pub(crate) fn coarser(options: &Options) -> Option<SecondMesh> {
        let refine = (0.5 * options.refine).max(COARSEST);
        (refine < options.refine).then(|| SecondMesh::at(options, refine))?
    }

    fn at(options: &Options, refine: f64) -> Option<SecondMesh> {
        options.mesh_error.then(|| SecondMesh {
            ratio: options.refine / refine,
            options: Options {
                refine,
                integrator: Integrator::Modal,
                gauges: Vec::new(),
                stations: Vec::new(),
                ..options.clone()
            },
        })
    }
}

/// Order of convergence p.
fn order(engine: EngineId, quantity: Quantity) -> i32 {
    use Quantity::{ConvectiveMass, SloshingHeight, SloshingPeriod};
    match (engine, quantity) {
        (EngineId::Harmonic, SloshingPeriod | ConvectiveMass | SloshingHeight) => 4,
        _ => 2,
    }
}

/// Relative error of a value: `value` on the mesh of the run, `other` on one with elements `ratio` times as long.
fn richardson(value: f64, other: f64, ratio: f64, order: i32) -> f64 {
    ((value - other) / (1.0 - ratio.powi(order)) / value).abs()
}

/// Whether a value has an estimate. The dry rim has none: it swings with modes of its edge that a mesh has not resolved yet, and the estimate is up to
/// six times off.
fn estimated(quantity: Quantity, value: f64) -> bool {
    value != 0.0 && quantity != Quantity::RimHoopStress
}

/// Relative mesh errors of values by quantity id, from those of a second mesh with elements `ratio` times as long.
pub fn errors(
    engine: EngineId,
    values: &BTreeMap<Quantity, f64>,
    other: &BTreeMap<Quantity, f64>,
    ratio: f64,
) -> BTreeMap<String, f64> {
    let error = |(quantity, value): (&Quantity, &f64)| {
        let error = richardson(*value, *other.get(quantity)?, ratio, order(engine, *quantity));
        estimated(*quantity, *value).then(|| (quantity.id().to_owned(), error))
    };
    values.iter().filter_map(error).collect()
}

/// A model whose sloshing modes have the frequencies, and the share in the wave, that they have in the limit of small elements, from
/// those of `other` with elements `ratio` times as long. It serves for the wave alone.
pub(crate) fn extrapolated(model: &Model, other: &Model, ratio: f64) -> Model {
    let factor = 1.0 - ratio.powi(order(EngineId::Solid, Quantity::SloshingHeight));
    let limit_of = |value: f64, other: f64| value - (value - other) / factor;
    let (own, coarse) = (&model.horizontal, &other.horizontal);
    let mut limit = model.clone();
    for mode in limit.horizontal.modes.iter_mut().filter(|m| m.kind == Kind::Sloshing) {
        let mut partners = coarse.modes.iter().filter(|m| m.kind == Kind::Sloshing);
        let Some(partner) = partners.find(|m| m.number == mode.number) else { continue };
        let shares = [(own, &*mode), (coarse, partner)].map(|(harmonic, mode)| wave_share(harmonic, mode));
        // A mode that the coarser mesh does not resolve may extrapolate to nothing, or to its opposite: it keeps half of what it was.
        let omega = limit_of(mode.omega, partner.omega).max(0.5 * mode.omega);
        if let [Some(share), Some(other)] = shares
            && share != 0.0
        {
            mode.participation *= (limit_of(share, other) / share).clamp(0.5, 2.0);
        }
        mode.omega = omega;
    }
    limit
}

/// Share of a mode in the elevation at the wall: participation factor times elevation.
fn wave_share(harmonic: &Harmonic, mode: &CoupledMode) -> Option<f64> {
    let probe = harmonic.coupled.probe(Channel::Wave(Side::Front))?;
    Some(mode.participation * dot(&probe.displacement, &mode.vector))
}

/// Writes the estimated errors into a simulation.
pub(crate) fn note(simulation: &mut Simulation, second: Option<&Second>, options: &Options) {
    let engine = simulation.result.engine;
    simulation.second = second.and_then(|second| Some((second.ratio, second.units.clone()?)));
    if let Some(second) = second {
        // The error of a wall on a moving base is that of the wall held down, relative.
        let result = &simulation.result;
        let isolation = || result.part("isolation").map(Part::held);
        let held = result.base.as_ref().map(|base| base.held.clone()).or_else(isolation);
        let error = |(quantity, value): (&Quantity, &f64)| {
            let held = held.as_ref().and_then(|held| held.get(quantity.id()));
            let value = held.unwrap_or(value);
            let other = second.values.get(quantity)?;
            let wave = second.wave.filter(|_| *quantity == Quantity::SloshingHeight);
            let error = match wave {
                Some(limit) => (limit / value - 1.0).abs(),
                None => richardson(*value, *other, second.ratio, order(engine, *quantity)),
            };
            Some((quantity.id().to_owned(), error))
        };
        let values = simulation.values.iter().filter(|(quantity, value)| estimated(**quantity, **value));
        simulation.result.mesh_error = values.filter_map(error).collect();
    } else if options.mesh_error {
        simulation.notes.push("No coarser mesh exists: the discretisation error is not estimated.".into());
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// v(h) = v₀ (1 + c h^p) exactly: the estimate is the true error, from a finer and from a coarser mesh.
    #[test]
    fn richardson_is_exact_for_one_power() {
        let at = |h: f64, p: i32| 7.0 * (1.0 + 0.03 * h.powi(p));
        for p in [2, 4] {
            for ratio in [0.5, 2.0] {
                let true_error = (at(1.0, p) - 7.0) / at(1.0, p);
                let found = richardson(at(1.0, p), at(ratio, p), ratio, p);
                assert!((found - true_error).abs() < 1e-14, "{p} {ratio}");
            }
        }
    }

    #[test]
    fn the_second_mesh_is_finer_as_long_as_it_is_cheap() {
        let mesh = |refine: f64| {
            SecondMesh::of(&Options { refine, ..Options::default() }).map(|m| (m.options.refine, m.ratio))
        };
        assert_eq!(mesh(1.0), Some((2.0, 0.5)));
        assert_eq!(mesh(2.0), Some((4.0, 0.5)));
        assert_eq!(mesh(4.0), Some((2.0, 2.0)));
        let none = Options { mesh_error: false, ..Options::default() };
        assert!(SecondMesh::of(&none).is_none());
        let coarsest = Options { refine: 0.25, ..Options::default() };
        assert!(SecondMesh::coarser(&coarsest).is_none());
    }
}
