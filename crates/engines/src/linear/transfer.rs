//! Transfer functions of wave, base shear and overturning moment under harmonic horizontal motion.
//!
//! ```text
//! H(Ω) = Σ_j Γ_j [c·φ_j (ω_j² + 2 i ξ_j ω_j Ω) − d·φ_j]/(ω_j² − Ω² + 2 i ξ_j ω_j Ω) + r        y = d·x + c·ẍ_total + b a
//! ```
//!
//! with the modes that the time history keeps and what follows the ground, r; hysteretic damping has 2 i ξ_j ω_j² in place of
//! 2 i ξ_j ω_j Ω. The wave has the sloshing modes that count for it. `docs/theory/dynamics.md`.

use std::f64::consts::TAU;

use results::channel::Side;
use results::{Channel, Transfer, TransferFunction, TransferMode};
use tank::options::LinearOptions as Options;
use tank::options::frequency::{FrequencyDamping, FrequencyOptions};

use super::model::Model;
use crate::modes::{CoupledMode, Kind};
use crate::response::superpose::{self, ModalSystem, Observable};
use crate::{FeError, Simulation};

/// Observables: channel, id and unit of the table.
const FUNCTIONS: [(Channel, &str, &str); 3] = [
    (Channel::Wave(Side::Front), "wave_height", "m_per_m_s2"),
    (Channel::BaseShear, "base_shear", "n_per_m_s2"),
    (Channel::OverturningMoment, "overturning_moment", "nm_per_m_s2"),
];
/// From the first mode down and from the impulsive mode up, by default.
const AROUND: (f64, f64) = (0.2, 2.0);
/// Least ratio of the ends of a range of which one is given.
const LEAST: f64 = 10.0;
/// Frequencies around a mode, in half-widths ξ ω of its peak.
const PEAK: [f64; 13] = [-16.0, -8.0, -4.0, -2.0, -1.0, -0.5, 0.0, 0.5, 1.0, 2.0, 4.0, 8.0, 16.0];

/// Adds the transfer functions that the options ask for.
///
/// Errors: a stiffness matrix that is not positive definite; an undamped resonance.
pub(crate) fn add(simulation: &mut Simulation, model: &Model, options: &Options) -> Result<(), FeError> {
    let Some(wanted) = &options.frequency else { return Ok(()) };
    let kept = superpose::keep(&model.horizontal.coupled, &model.horizontal.modes, &model.damper, options.wave_modes);
    let ratio = |mode: &CoupledMode| model.damper.of(mode);
    if let Some(mode) = kept.iter().find(|mode| ratio(mode) <= 0.0) {
        simulation.notes.push(format!(
            "`analysis.frequency`: the {} mode {} has no damping, so that there is no steady state: no transfer functions.",
            mode.kind.id(),
            mode.number
        ));
        return Ok(());
    }
    let coupled = &model.horizontal.coupled;
    let impulsive = model.horizontal.impulsive().map(|found| found.dominant.omega);
    let range = range(wanted, &kept, impulsive);
    let peaks: Vec<(f64, f64)> = kept.iter().map(|mode| (mode.omega, ratio(mode))).collect();
    let omega = frequencies(range, wanted.points, &peaks);
    let modes = kept
        .iter()
        .map(|mode| TransferMode {
            kind: mode.kind.id().into(),
            number: mode.number,
            frequency: mode.omega / TAU,
            damping: ratio(mode),
        })
        .collect();
    let highest = peaks.iter().map(|(omega, _)| *omega).fold(0.0, f64::max);
    if range.1 > highest {
        simulation.notes.push(format!(
            "`analysis.frequency`: modes above {:.4} Hz are not kept and follow the ground; transfer functions beyond it have no resonance.",
            highest / TAU
        ));
    }
    let system = ModalSystem::new(coupled, kept, &model.damper)?;
    let observed = FUNCTIONS.into_iter().filter_map(|function| Some((function, coupled.probe(function.0)?)));
    let (functions, probes): (Vec<_>, Vec<Observable>) =
        observed.map(|(function, probe)| (function, vec![(0, 1.0, probe)])).unzip();
    let hysteretic = wanted.damping == FrequencyDamping::Hysteretic;
    let statics = superpose::transfer(&system, &probes, hysteretic, &[0.0])?;
    let found = superpose::transfer(&system, &probes, hysteretic, &omega)?;
    let functions = functions.into_iter().zip(found).zip(statics);
    let found = Transfer {
        damping: wanted.damping,
        frequency: omega.iter().map(|omega| omega / TAU).collect(),
        modes,
        functions: functions
            .map(|(((_, id, unit), values), at_rest)| TransferFunction {
                id: id.into(),
                unit: unit.into(),
                static_value: at_rest.first().map_or(0.0, |h| h.re),
                magnitude: values.iter().map(|h| h.norm()).collect(),
                phase: values.iter().map(|h| h.arg()).collect(),
            })
            .collect(),
    };
    simulation.result.parts.push(found.part());
    Ok(())
}

/// Lowest and highest circular frequency [rad/s].
fn range(wanted: &FrequencyOptions, kept: &[&CoupledMode], impulsive: Option<f64>) -> (f64, f64) {
    let lowest = kept.iter().map(|m| m.omega).fold(f64::INFINITY, f64::min);
    let sloshing = kept.iter().filter(|m| m.kind == Kind::Sloshing).map(|m| m.omega);
    let highest = impulsive.unwrap_or_else(|| sloshing.fold(lowest, f64::max));
    let (from, to) = (AROUND.0 * lowest, AROUND.1 * highest);
    match (wanted.from, wanted.to) {
        (Some(from), Some(to)) => (from, to),
        (Some(from), None) => (from, to.max(LEAST * from)),
        (None, Some(to)) => (from.min(to / LEAST), to),
        (None, None) => (from, to),
    }
}

/// `points` frequencies with equal ratios, and those around the peaks (ω, ξ) within the range; ascending.
fn frequencies((from, to): (f64, f64), points: usize, peaks: &[(f64, f64)]) -> Vec<f64> {
    let step = (to / from).ln() / (points.max(2) - 1) as f64;
    let mut all: Vec<f64> = (0..points.max(2)).map(|k| from * (step * k as f64).exp()).collect();
    if let Some(last) = all.last_mut() {
        *last = to;
    }
    for &(omega, ratio) in peaks {
        all.extend(PEAK.iter().map(|k| omega * (1.0 + k * ratio)));
        // The displacement of a viscously damped mode is largest here.
        all.push(omega * (1.0 - 2.0 * ratio * ratio).max(0.0).sqrt());
    }
    all.retain(|omega| (from..=to).contains(omega));
    all.sort_by(f64::total_cmp);
    all.dedup_by(|a, b| (*a - *b).abs() <= 1e-9 * *b);
    all
}

#[cfg(test)]
mod tests;
