//! The run in words: integration, damping, modes, balances, assumptions.

use tank::Case;
use tank::case::GroundMotion;
use tank::units::significant;

use super::analysis::Analysis;
use super::model::Model;
use super::system::Harmonic;
use crate::harmonic::{self};
use crate::modes::{CoupledMode, Kind};
use crate::response::superpose::{FREQUENCY_FACTOR, SLOSHING_MODES, STRUCTURAL_MODES};
use fem::linalg::dot;
use results::{Balance, Channel, EngineId, Labelled};
use tank::options::LinearOptions as Options;
use tank::options::linear::{DampingModel, Dashpots, Integrator, WallDirection};

/// Time integration, damping and number of modes, in words.
///
/// * `reduced`: whether the model is a reduction of a larger one
pub(crate) fn integration(
    model: &Model,
    options: &Options,
    analysis: &Analysis,
    motion: &GroundMotion,
    reduced: bool,
) -> Vec<Labelled> {
    let label = |label: &str, text: String| Labelled { label: label.into(), text };
    let grid = &analysis.grid;
    let mut labels = vec![label(
        "method",
        match options.integrator {
            Integrator::Modal => "modal superposition, exact for ground motion linear between samples".into(),
            // With a second record the reduction itself is integrated.
            Integrator::Newmark if reduced && (motion.vertical.is_some() || motion.transverse.is_some()) => {
                "direct integration of the reduced coordinates, Newmark's average acceleration".into()
            }
            Integrator::Newmark => "direct integration of all unknowns, Newmark's average acceleration".into(),
        },
    )];
    labels.push(label(
        "time step",
        format!(
            "{} s, {} of the record's step of {} s; histories are stored at the record's step; maxima include the values between the samples",
            significant(grid.h(), 3),
            match grid.sub_steps {
                1 => "the whole".to_owned(),
                n => format!("1/{n}"),
            },
            significant(grid.dt, 4),
        ),
    ));
    let record = motion.horizontal.duration();
    labels.push(label(
        "duration",
        format!(
            "{:.2} s: the record and at least 2 periods of the first sloshing mode of free vibration",
            grid.time(grid.steps())
        ),
    ));
    if analysis.scalars.iter().any(|(s, h)| s.channel.is_wave() && h.extreme.peak().1 > record) {
        labels.push(label("after the record", "a wave height peaks in free vibration".into()));
    }
    labels.push(label("damping", model.damper.text()));
    labels.extend(options.dashpots.iter().map(dashpots));
    if options.integrator == Integrator::Modal {
        for (h, kept) in model.systems().zip(&analysis.kept) {
            labels.push(kept_modes(h, kept, options));
        }
    }
    labels.push(label("wave height", format!("first {} sloshing modes", options.wave_modes)));
    if let Some((difference, title)) = &analysis.difference {
        labels.push(label(
            "against modal superposition",
            format!("largest difference of a peak {} % ({title})", significant(100.0 * difference, 2)),
        ));
    }
    labels
}

/// A ring of dashpots.
fn dashpots(ring: &Dashpots) -> Labelled {
    let direction = match ring.direction {
        WallDirection::Radial => "radial",
        WallDirection::Tangential => "tangential",
        WallDirection::Vertical => "vertical",
    };
    Labelled {
        label: "dashpots".into(),
        text: format!(
            "{} N s/m in all, {direction}, evenly around the wall at z = {} m; they couple the modes, and reactions of the base contain their forces",
            significant(ring.coefficient, 4),
            significant(ring.z, 4),
        ),
    }
}

fn kept_modes(h: &Harmonic, kept: &[&CoupledMode], options: &Options) -> Labelled {
    let sloshing = kept.iter().filter(|m| m.kind == Kind::Sloshing).count();
    let load = h.coupled.mass.times(&h.coupled.influence);
    let total = dot(&load, &h.coupled.influence);
    let carried: f64 = kept.iter().map(|m| m.effective_mass()).sum();
    let by_frequency =
        h.coupled.dashpots.is_empty() && matches!(options.damping, DampingModel::Modal | DampingModel::Caughey(_));
    let rule = if by_frequency {
        format!(
            "up to {FREQUENCY_FACTOR} × the frequency of the impulsive mode, at least {SLOSHING_MODES} sloshing and \
             {STRUCTURAL_MODES} structural"
        )
    } else {
        "all".into()
    };
    Labelled {
        label: format!("modes, m = {}", h.coupled.harmonic),
        text: format!(
            "{} sloshing, {} structural ({rule}); the missing mass, {} %, follows the ground statically",
            sloshing,
            kept.len() - sloshing,
            significant((100.0 * (1.0 - carried / total)).max(0.0), 2)
        ),
    }
}

/// Base shear of the rigid translation against the mass of liquid, wall and roof.
pub(crate) fn mass_balance(model: &Model) -> Vec<Balance> {
    let coupled = &model.horizontal.coupled;
    let mass = coupled.liquid_mass + coupled.wall_mass;
    coupled
        .probe(Channel::BaseShear)
        .into_iter()
        .map(|p| Balance {
            label: "base shear of a rigid translation against the mass of liquid, wall and roof".into(),
            error: (dot(&p.absolute_acceleration, &coupled.influence) + p.ground_acceleration) / mass - 1.0,
        })
        .collect()
}

/// Assumptions of the engine.
pub(crate) fn assumptions(case: &Case, options: &Options, engine: EngineId) -> Vec<String> {
    let isolated = case.tank.isolators.is_some();
    let mut list = harmonic::assumptions(case, engine == EngineId::Solid, isolated);
    list.push(format!(
        "Wave height: the first {} sloshing modes (more only chase the singularity at the contact line).",
        options.wave_modes
    ));
    list
}
