//! The response mode by mode as the response-spectrum method takes it, and a run without a record.

use std::collections::BTreeMap;

use tank::Quantity;

use super::model::Model;
use super::system::Harmonic;
use crate::FeError;
use crate::impulsive::Impulsive;
use crate::modes::{CoupledMode, Kind};
use crate::response::superpose::{self, ModalSystem, Observable};
use crate::spectral::{KeptMode, ModalUnits, Unit, UnitLine};
use results::channel::{OnWall, Side};
use results::{Channel, EngineId, Labelled, Run};
use tank::options::LinearOptions as Options;

use crate::engine::Simulation;
use tank::Case;

/// Scalars that are combined.
const SCALARS: [Channel; 6] = [
    Channel::Wave(Side::Front),
    Channel::BaseShear,
    Channel::BaseMoment,
    Channel::OverturningMoment,
    Channel::Base(OnWall::Axial),
    Channel::Base(OnWall::Bending),
];

/// The modes that a response keeps and the missing mass, per unit of acceleration, of horizontal motion and of the vertical motion of the
/// site.
///
/// Errors: a stiffness matrix that is not positive definite.
pub(crate) fn units(model: &Model, options: &Options) -> Result<ModalUnits, FeError> {
    let upwards = match &model.site {
        Some(vertical) => Some(Box::new(of(vertical, model, options)?)),
        None => None,
    };
    Ok(ModalUnits { vertical: upwards, ..of(model.held(), model, options)? })
}

/// The same of one harmonic.
///
/// Errors: as [`units`].
fn of(harmonic: &Harmonic, model: &Model, options: &Options) -> Result<ModalUnits, FeError> {
    let coupled = &harmonic.coupled;
    let kept = superpose::keep(coupled, &harmonic.modes, &model.damper, options.wave_modes);
    let modes = kept
        .iter()
        .map(|m| KeptMode {
            kind: m.kind,
            number: m.number,
            omega: m.omega,
            damping: model.damper.ratio(m.kind, m.omega),
            mass: m.effective_mass(),
        })
        .collect();
    let system = ModalSystem::new(coupled, kept, &model.damper)?;
    let scalars: Vec<Channel> = SCALARS.into_iter().filter(|c| coupled.probe(*c).is_some()).collect();
    let mut probes: Vec<Observable> =
        scalars.iter().filter_map(|channel| Some(vec![(0, 1.0, coupled.probe(*channel)?)])).collect();
    for line in &coupled.lines {
        probes.extend(line.probes.iter().map(|probe| vec![(0, 1.0, probe)]));
    }
    let found = superpose::per_acceleration(&system, &probes)?;
    let unit = |((modes, rest), observable): ((Vec<f64>, f64), &Observable)| Unit {
        modes,
        rest,
        static_value: observable.iter().map(|(_, _, probe)| probe.static_value).sum(),
    };
    let mut all = found.into_iter().zip(&probes).map(unit);
    let number = scalars.len();
    let scalars = scalars.into_iter().zip(all.by_ref().take(number)).collect::<Vec<_>>();
    let mut lines = Vec::new();
    for line in &coupled.lines {
        lines.push(UnitLine {
            what: line.what,
            z: line.z.clone(),
            units: all.by_ref().take(line.probes.len()).collect(),
        });
    }
    Ok(ModalUnits { modes, scalars, lines, level: coupled.level, vertical: None })
}

/// Periods and masses, which do not depend on the ground motion.
pub(crate) fn properties(model: &Model) -> BTreeMap<Quantity, f64> {
    let first = |kind| model.held().first(kind);
    let impulsive = model.held().impulsive();
    let found = [
        (Quantity::SloshingPeriod, first(Kind::Sloshing).map(|m| std::f64::consts::TAU / m.omega)),
        (Quantity::ConvectiveMass, first(Kind::Sloshing).map(CoupledMode::effective_mass)),
        (Quantity::ImpulsivePeriod, impulsive.as_ref().map(Impulsive::period)),
        (Quantity::ImpulsiveMass, impulsive.as_ref().map(Impulsive::mass)),
    ];
    found.into_iter().filter_map(|(q, value)| Some((q, value?))).collect()
}

/// The modes alone, for a tank without a record under the spectrum of its site.
///
/// Errors: an inadmissible damping ratio.
pub(crate) fn without_record(
    case: &Case,
    options: &Options,
    model: &Model,
    engine: EngineId,
) -> Result<Simulation, FeError> {
    let mut notes = super::review(model)?;
    notes.extend(super::model_notes(case, engine));
    notes.extend(super::soil::note(case, engine, false));
    notes.extend(model.held().impulsive().and_then(|found| found.note()));
    let labels = [("method", "response-spectrum method, no time history".to_owned()), ("damping", model.damper.text())];
    let result = Run {
        mesh: model.horizontal.coupled.mesh.clone(),
        modes: super::modes(case, model),
        modal: super::modal::parts(&model.on_fixed_base(), None),
        integration: labels.map(|(label, text)| Labelled { label: label.into(), text }).into(),
        damping_table: super::damping_table(model),
        mass_balance: super::describe::mass_balance(model),
        ..Run::new(engine)
    };
    let mut simulation = Simulation {
        values: properties(model),
        result,
        series: Default::default(),
        assumptions: super::describe::assumptions(case, options, engine),
        notes,
        snapshots: None,
        demands: None,
        units: Some(units(model, options)?),
        of_modes: None,
        second: None,
        slab_motion: None,
    };
    super::transfer::add(&mut simulation, model, options)?;
    Ok(simulation)
}
