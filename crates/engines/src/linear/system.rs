//! A coupled system and its modes.

use crate::coupled::Coupled;
use crate::impulsive::Impulsive;
use crate::modes::{CoupledMode, Kind};

/// A structural mode is significant if it carries this share of the mass.
const SIGNIFICANT: f64 = 0.01;

/// A coupled system and its modes.
#[derive(Clone, Debug)]
pub(crate) struct Harmonic {
    /// The system.
    pub coupled: Coupled,
    /// Its modes by ascending frequency.
    pub modes: Vec<CoupledMode>,
}

impl Harmonic {
    /// First mode of a kind: of those that the motion excites, where there are others.
    pub(crate) fn first(&self, kind: Kind) -> Option<&CoupledMode> {
        self.modes.iter().find(|m| m.kind == kind && m.number == 1)
    }

    /// The impulsive mode.
    pub(crate) fn impulsive(&self) -> Option<Impulsive> {
        Impulsive::among(&self.modes)
    }

    /// Highest circular frequency of the structural modes that carry at least 1 % of the mass, and of the first one.
    pub(crate) fn significant(&self) -> f64 {
        let load = self.coupled.mass.times(&self.coupled.influence);
        let total = fem::linalg::dot(&load, &self.coupled.influence);
        self.modes
            .iter()
            .filter(|m| m.kind == Kind::Structural)
            .filter(|m| m.number == 1 || m.effective_mass() > SIGNIFICANT * total)
            .fold(0.0, |w, m| f64::max(w, m.omega))
    }
}
