//! The space that a ground motion excites in an imperfect tank.
//!
//! An imperfection cos nθ couples the harmonic m of the load to m + n and |m − n|, to first order in its amplitude. To the Krylov
//! space of the load within m come
//!
//! ```text
//! Krylov space of P_k (K x₁ − f)     of every coupled harmonic k, purified to k; x₁ the static response within m
//! K⁻¹ f, K⁻¹ M K⁻¹ f     whole: the static response, with all that it is coupled to
//! ```
//!
//! P_k projects on harmonic k: K x₁ is the load with which the static response within m acts on k. What couples to these harmonics in
//! turn (second order) is in the whole vectors alone.

use fem::linalg::dot;
use fem::progress::Progress;

use super::model::TankModel;
use super::poles::VECTORS;
use super::ritz::{Growing, Ritz};
use super::symmetry::Harmonic;
use super::system::System;
use crate::FeError;
use crate::error::failed;
use crate::modes::CoupledMode;
use tank::imperfection::Imperfections;

/// Vectors of a coupled harmonic, of which a third are its sloshing modes: as many as the search for modes of a harmonic has.
const COUPLED: usize = 48;
/// Whole vectors.
const WHOLE: usize = 2;
/// Most coupled harmonics.
const MOST: usize = 24;

/// Harmonics that the imperfections couple to `harmonic`, without itself.
pub(super) fn harmonics(waves: &[u32], harmonic: u32) -> Vec<u32> {
    let mut all: Vec<u32> =
        waves.iter().flat_map(|&n| [n.abs_diff(harmonic), n + harmonic]).filter(|&k| k != harmonic).collect();
    all.sort_unstable();
    all.dedup();
    all
}

/// Vectors of the space for horizontal motion, at most.
pub(super) fn vectors(imperfections: &Imperfections, height: f64) -> usize {
    match imperfections.is_empty() {
        true => VECTORS,
        false => VECTORS + WHOLE + COUPLED * harmonics(&imperfections.waves(height), 1).len().min(MOST),
    }
}

/// The reduced system for a load of `harmonic`.
///
/// Errors: imperfections of too many waves; as [`super::ritz::reduce`].
pub(super) fn reduce(
    tank: &TankModel,
    system: &System,
    load: &[f64],
    harmonic: u32,
    progress: &dyn Progress,
) -> Result<Ritz, FeError> {
    let height = tank.height();
    let twins = !tank.imperfections.is_symmetric(height);
    let coupled = harmonics(&tank.imperfections.waves(height), harmonic);
    if coupled.len() > MOST {
        let found = format!("waves that are coupled to {} harmonics", coupled.len());
        let allowed = format!("at most {MOST}; smooth the table, or give fewer waves");
        return Err(FeError::option("analysis.imperfections", found, allowed));
    }
    let mut space = Growing::renewed(system);
    let own = Harmonic::new(tank, harmonic).with_twins(twins);
    space.grow(load, VECTORS, &|x| own.project(x), progress)?;
    let Some(first) = space.first().map(<[f64]>::to_vec) else { return space.finish() };
    let forces = system.stiffness_times(&first);
    let scale = dot(&forces, &first).abs() / dot(load, &first).abs().max(f64::MIN_POSITIVE);
    for k in coupled {
        if progress.interrupted() {
            return Err(FeError::Interrupted { stage: "the reduction".into() });
        }
        let other = Harmonic::new(tank, k).with_twins(twins);
        let mut start: Vec<f64> = forces.iter().zip(load).map(|(k, f)| k - scale * f).collect();
        other.project(&mut start);
        let before = space.len();
        space.grow(&start, COUPLED, &|x| other.project(x), progress)?;
        // An amplitude of zero leaves rounding.
        if space.len() == before && dot(&start, &start) > 1e-24 * dot(&forces, &forces) {
            let what = "to which the imperfections couple the ground motion";
            return Err(failed(format!("the reduced space holds no motion of harmonic {k}, {what}")));
        }
    }
    // Last: to first order they lie in the sum of the spaces before, and a chain ends with a vector that adds nothing.
    space.grow(load, WHOLE, &|_| {}, progress)?;
    space.finish()
}

/// Numbers the modes that live in `harmonic` first, then those of the harmonics that imperfections couple to it, each by ascending
/// frequency: the first sloshing modes are then those of the perfect tank.
///
/// * `expand`: a mode over all unknowns
pub(super) fn number(
    tank: &TankModel,
    system: &System,
    harmonic: u32,
    modes: &mut [CoupledMode],
    expand: &dyn Fn(&CoupledMode) -> Vec<f64>,
) {
    if tank.imperfections.is_empty() {
        return;
    }
    let twins = !tank.imperfections.is_symmetric(tank.height());
    let symmetry = Harmonic::new(tank, harmonic).with_twins(twins);
    let own: Vec<bool> = modes
        .iter()
        .map(|mode| {
            let whole = expand(mode);
            let mut part = whole.clone();
            symmetry.project(&mut part);
            // φᵀ M φ = 1.
            dot(&part, &system.mass_times(&whole)) > 0.5
        })
        .collect();
    let mut counts = std::collections::BTreeMap::new();
    for wanted in [true, false] {
        for (mode, _) in modes.iter_mut().zip(&own).filter(|(_, own)| **own == wanted) {
            let count: &mut usize = counts.entry(mode.kind).or_insert(0);
            *count += 1;
            mode.number = *count;
        }
    }
}
