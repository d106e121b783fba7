//! Coupled systems as the diagonal blocks of one system, each with its own component of the ground motion.

use fem::analysis::AnalysisError;
use fem::analysis::observable::Observable as Functional;
use fem::analysis::transient::Load;
use fem::linalg::dot;
use fem::progress::Progress;

use super::motion::Motion;
use crate::FeError;
use crate::coupled::Coupled;
use crate::modes::{CoupledMode, Kind};
use crate::probe::{ModeSelection, Probe};

/// A quantity to be observed: Σ factor × probe of a system (by its number).
pub type Observable<'a> = Vec<(usize, f64, &'a Probe)>;

/// A system with the modes that select the waves of its probes.
#[derive(Clone, Debug)]
pub(super) struct Block<'a> {
    pub(super) system: &'a Coupled,
    pub(super) modes: Vec<&'a CoupledMode>,
}

impl Block<'_> {
    pub(super) fn size(&self) -> usize {
        self.system.influence.len()
    }

    /// Adds `factor` × `probe` to `row`: unknowns of this system start at `offset`, its ground motion is the component `axis`.
    fn observe(&self, probe: &Probe, factor: f64, (offset, axis): (usize, usize), row: &mut Functional) {
        let scaled = |dense: &[f64]| -> Vec<(usize, f64)> {
            let entries = dense.iter().enumerate().filter(|(_, c)| **c != 0.0);
            entries.map(|(i, c)| (offset + i, factor * c)).collect()
        };
        let (d, a) = (&probe.displacement, &probe.absolute_acceleration);
        row.displacement.extend(probe.rim.iter().map(|(i, c)| (offset + i, factor * c)));
        match probe.modes {
            ModeSelection::All => {
                row.displacement.extend(scaled(d));
                row.acceleration.extend(scaled(a));
                row.ground[axis] += factor * probe.ground_acceleration;
            }
            ModeSelection::FirstSloshing(most) => {
                // The part of the selected modes alone: x ← Σ φ φᵀ M x.
                let (mut on_x, mut on_a) = (vec![0.0; self.size()], vec![0.0; self.size()]);
                let selected = |m: &&&CoupledMode| m.kind == Kind::Sloshing && m.number <= most;
                for mode in self.modes.iter().filter(selected) {
                    let (p, q) = (dot(d, &mode.vector), dot(a, &mode.vector));
                    let momentum = self.system.mass.times(&mode.vector);
                    for ((x, y), m) in on_x.iter_mut().zip(&mut on_a).zip(momentum) {
                        *x += p * m;
                        *y += q * m;
                    }
                }
                row.displacement.extend(scaled(&on_x));
                row.acceleration.extend(scaled(&on_a));
            }
        }
    }
}

/// First unknown of each block.
pub(super) fn offsets(blocks: &[&Block]) -> Vec<usize> {
    let next = |start: &mut usize, block: &&Block| {
        let own = *start;
        *start += block.size();
        Some(own)
    };
    blocks.iter().scan(0, next).collect()
}

/// Observables over the unknowns of all blocks.
pub(super) fn functionals(blocks: &[&Block], observables: &[Observable]) -> Vec<Functional> {
    let offsets = offsets(blocks);
    let row = |terms: &Observable| {
        let mut row = Functional::default();
        for &(block, factor, probe) in terms {
            blocks[block].observe(probe, factor, (offsets[block], block), &mut row);
        }
        row
    };
    observables.iter().map(row).collect()
}

/// Motions as components of the ground motion, one for each block.
pub(super) fn load(motions: &[&Motion]) -> Load {
    let mut load = Load::default();
    for (component, motion) in load.ground.iter_mut().zip(motions) {
        *component = Some((*motion).clone());
    }
    load
}

/// A failed response as an error of the engine.
pub(super) fn failed(error: AnalysisError) -> FeError {
    match error {
        AnalysisError::NotFinite { time, cause } => FeError::NotFinite { time, cause: cause.into() },
        error => FeError::Analysis(error.to_string()),
    }
}

/// Counts the steps of a stage that several analyses share; it cannot be interrupted.
pub(super) struct Steps<'a>(pub(super) &'a dyn Progress);

impl Progress for Steps<'_> {
    fn stage(&self, _name: &str, _steps: u64) {}
    fn advance(&self, steps: u64) {
        self.0.advance(steps);
    }
    fn interrupted(&self) -> bool {
        false
    }
}
