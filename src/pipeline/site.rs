//! The modes of an engine under the design spectrum of the site, as a column of the comparison.

mod words;

use std::collections::BTreeMap;

use codes::modal_action::ModalAction;
use codes::procedure::CodeError;
use codes::site_action;
use tank::assessment::{Excitation, Profile, Step};
use tank::outside::Outside;
use tank::units::Dimension;
use tank::{Quantity, Shape, Support};

use super::quantities::with_crest;
use crate::job::Job;
use engines::Simulation;
use engines::modes::Kind;
use engines::spectral::{self, Action, KeptMode, ModalUnits, Spectral};
use results::{EngineId, Method, Status};

/// A column with what marks its numbers.
pub(super) struct Column {
    /// The column.
    pub method: Method,
    /// Relative mesh errors by quantity id.
    pub errors: BTreeMap<String, f64>,
    /// Why its numbers are outside the model.
    pub outside: Option<Outside>,
}

/// Least share of the mass of the modes that the sheet lists.
const LISTED: f64 = 1e-3;

/// Quantities that do not depend on the ground motion.
const OWN: [Quantity; 6] = [
    Quantity::SloshingPeriod,
    Quantity::ImpulsivePeriod,
    Quantity::ImpulsiveMass,
    Quantity::WallMass,
    Quantity::RoofMass,
    Quantity::ConvectiveMass,
];

/// The column of the run `number` from 0; none of an engine without modes, or where the site has no design spectrum.
pub(super) fn column(job: &Job, number: usize, simulation: &Simulation) -> Option<Column> {
    let units = simulation.units.as_ref()?;
    let options = &job.linear.spectrum;
    let wanted = options.code.as_deref();
    let engine = simulation.result.engine;
    let found = site_action::of(&job.case, wanted, options.reduced);
    let (code, action) = match (found, wanted) {
        (Some(found), _) => found,
        (None, None) => return None,
        (None, Some(code)) => {
            let missing = CodeError::Data { clause: "analysis.spectrum.code".into(), reason: words::no_data(code) };
            (code, Err(missing))
        }
    };
    let title = words::title(engine, code);
    let mut method = Method {
        label: engine.label(number).into(),
        figure_key: engine.figure_key(number).into(),
        ..Method::new(engine.column(number), &title, Excitation::Site)
    };
    let (errors, outside) = match action.and_then(|action| covered(job, units, action)) {
        Ok(action) => respond(&mut method, job, (simulation, units), &action),
        Err(error) => {
            let (clause, reason) = match error {
                CodeError::NotApplicable(n) => (n.clause, n.reason),
                CodeError::Data { clause, reason } => (clause, reason),
                other => (code.to_owned(), other.to_string()),
            };
            method.status = Status::NotApplicable { clause, reason };
            Default::default()
        }
    };
    Some(Column { method, errors, outside })
}

/// Gives the column the response of the modes to the action; returns mesh errors, and why the numbers are outside the model.
fn respond(
    method: &mut Method,
    job: &Job,
    (simulation, units): (&Simulation, &ModalUnits),
    action: &ModalAction<'_>,
) -> (BTreeMap<String, f64>, Option<Outside>) {
    let options = &job.linear.spectrum;
    let engine = simulation.result.engine;
    let round = matches!(job.case.tank.shape, Shape::Cylinder { .. });
    let seen = Action { structural: &action.structural, sloshing: &action.sloshing, wave: &action.wave };
    let both = |units: &ModalUnits| -> (Spectral, Option<KeptMode>) {
        let along = units.respond(&seen, options, round);
        let upwards = action.upwards.as_ref();
        let found = upwards.and_then(|up| units.with_vertical(&along, (&up.spectrum, up.beside), options, round));
        found.unwrap_or((along, None))
    };
    let (found, breathing) = both(units);
    let mut values = found.values.clone();
    let own = simulation.values.iter().filter(|(q, _)| OWN.contains(q));
    values.extend(own.map(|(q, value)| (*q, *value)));
    let errors = simulation.second.as_ref().map(|(ratio, other)| {
        let other = both(other).0.values;
        engines::mesh_errors(engine, &found.values, &other, *ratio)
    });
    let errors = errors.unwrap_or_default();
    let outside = outside(job, engine, &found);
    let upwards = action.upwards.as_ref().filter(|_| units.vertical.is_some());
    method.quantities = with_crest(&job.case, &values);
    method.steps = steps(units, &found);
    if let (Some(up), Some(mode)) = (upwards, breathing) {
        for (symbol, (name, at), period) in
            [("S_v", words::breathing(mode.period()), mode.period()), ("S_v0", words::upward_rest(), 0.0)]
        {
            let value = (up.spectrum)(period, mode.damping);
            method.steps.push(step(symbol.into(), name, at, value));
        }
    }
    method.profiles = profiles(&found);
    method.assumptions = vec![action.assumption.clone(), words::combination(options)];
    // Notes and assumptions are of the wall whose modes these are.
    let (said, assumed) = match &simulation.of_modes {
        Some((notes, assumptions)) => (notes, assumptions),
        None => (&simulation.notes, &simulation.assumptions),
    };
    method.assumptions.extend(assumed.iter().cloned());
    method.notes = vec![words::INFORMATION.into()];
    match upwards {
        Some(up) => method.assumptions.push(words::vertical(up.beside)),
        None if action.vertical => method.notes.push(words::NO_VERTICAL.into()),
        None => {}
    }
    if let Some((quantity, error)) = errors.iter().max_by(|a, b| a.1.total_cmp(b.1)) {
        method.notes.push(words::mesh_error(quantity, *error));
    }
    method.notes.extend(outside.map(words::outside).map(String::from));
    method.notes.extend(said.iter().cloned());
    (errors, outside)
}

/// The action, if it covers every mode.
fn covered<'a>(job: &Job, units: &ModalUnits, action: ModalAction<'a>) -> Result<ModalAction<'a>, CodeError> {
    if let Some((kind, period)) = units.longest() {
        let what = match kind {
            Kind::Sloshing => "sloshing",
            Kind::Structural | Kind::Rotational => "structural",
        };
        site_action::covers(&job.case.site, what, period)?;
    }
    Ok(action)
}

/// Why the column is outside the model of its engine: it clamps a wall that pulls, or has cantilevers for the plates of a box.
fn outside(job: &Job, engine: EngineId, found: &Spectral) -> Option<Outside> {
    let tank = &job.case.tank;
    if engine == EngineId::Harmonic && tank.bends_as_plates() {
        return Some(Outside::Plates);
    }
    let (peak, at_rest) = found.base_axial?;
    (tank.support == Support::Unanchored && peak + at_rest > 0.0).then_some(Outside::Uplift)
}

/// A line of the sheet with a spectral acceleration [m/s²].
fn step(symbol: String, name: String, look_up: String, value: f64) -> Step {
    Step {
        section: words::SHEET.into(),
        symbol,
        name,
        look_up,
        value,
        dimension: Dimension::Acceleration,
        clause: words::CLAUSE.into(),
        ..Step::default()
    }
}

/// Spectral accelerations of the modes that carry mass.
fn steps(units: &ModalUnits, found: &Spectral) -> Vec<Step> {
    let total: f64 = units.modes.iter().map(|m| m.mass).sum();
    let modes = units.modes.iter().zip(&found.accelerations).enumerate();
    let mut steps: Vec<Step> = modes
        .filter(|(_, (mode, _))| mode.mass > LISTED * total)
        .map(|(j, (mode, acceleration))| {
            let (name, at) = words::mode(mode.kind.id(), mode.number, mode.period(), mode.damping);
            step(format!("S_{}", j + 1), name, at, *acceleration)
        })
        .collect();
    let (name, at) = words::rest();
    steps.push(step("S_0".into(), name, at, found.ground));
    steps
}

fn profiles(found: &Spectral) -> Vec<Profile> {
    let profile = |line: &spectral::LinePeaks| Profile {
        id: line.what.id().into(),
        title: line.what.title().into(),
        dimension: line.what.dimension(),
        z: line.z.clone(),
        values: line.values.clone(),
    };
    found.lines.iter().map(profile).collect()
}
