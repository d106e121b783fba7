//! Time history of a case: model, analysis, second mesh, and everything the results folder holds of them.

pub(crate) mod analysis;
mod around;
pub(crate) mod demands;
pub(crate) mod describe;
mod drawn;
pub(crate) mod isolation;
mod large_wave;
pub(crate) mod limits;
pub(crate) mod mesh_error;
mod modal;
pub(crate) mod model;
mod moving;
pub(crate) mod prepared;
pub(crate) mod rocking;
pub(crate) mod shared;
pub(crate) mod soil;
pub(crate) mod system;
pub(crate) mod tilt;
mod transfer;
pub(crate) mod turned;
pub(crate) mod units;
mod waves;

use std::collections::BTreeMap;
use std::sync::Arc;

use fem::progress::{Progress, Silent};
use tank::Case;
use tank::case::GroundMotion;
use tank::demand::Demands;
use tank::{Quantity, Shape, Support};

pub(crate) use around::Across;
use around::Around;

pub(crate) use analysis::Extent;
use analysis::{Analysis, LineExtremes, analyse_on};
pub(crate) use drawn::Pictures;
use mesh_error::{Second, SecondMesh};
use model::Model;
use moving::MovingBase;
use system::Harmonic;

use super::harmonic::Places;
use super::histories::Histories;
use super::response::motion::Grid;
use super::{FeError, Simulation};
use crate::checks::checked_motion;
use results::channel::OnWall;
use results::nonlinear::End;
use results::{EngineId, Envelope, Mode, Run, SeriesInfo};
use tank::options::LinearOptions as Options;
use tank::options::linear::{Integrator, LiquidModel};

/// Modes of each kind and harmonic that are listed in the results.
const LISTED_MODES: usize = 6;
/// Remark on a rectangular tank in the harmonic engine.
const SIDE_WALLS: &str = "The rectangular tank is modelled as a plane strip of its breadth with rigid side walls: plate bending and \
     corners are left out.";
/// Remark on dashpots beside a spectrum.
const NO_DASHPOTS: &str =
    "`analysis.damping.dashpots`: the response-spectrum method combines uncoupled modes and leaves the dashpots out.";
/// Remark on the wall under a nonlinear liquid.
const LINEAR_WALL: &str = "--liquid nonlinear: waves, base shear and moments are those of the nonlinear liquid; pressures on the wall and its stresses are those of the \
    linear one.";
/// Remark on two records.
const TWO_STEPS: &str =
    "The records differ in their time step: the vertical one is linearised within the steps of the analysis.";

/// Remark on a base that turns.
const TURNS: &str = "The base turns (`analysis.quake_rotation`): values are those relative to it, gravity acts across the tank as it leans, and the code \
    procedures leave the rotation out.";

/// The comparable values of a run.
type Values = BTreeMap<Quantity, f64>;

/// Time history of the coupled tank and liquid; its modes alone for a case that has a site and no record.
///
/// Errors: neither record nor site or a record without samples; an option out of range; a model that cannot be built or
/// factored; a response that is not finite.
pub fn simulate(case: &Case, options: &Options) -> Result<Simulation, FeError> {
    simulate_watched(case, options, &Silent)
}

/// [`simulate`] with progress; it cannot be interrupted.
///
/// Errors: as [`simulate`].
pub fn simulate_watched(case: &Case, options: &Options, progress: &dyn Progress) -> Result<Simulation, FeError> {
    simulate_to(case, options, (Extent::Whole, None), progress)
}

/// [`simulate_watched`] that keeps states for pictures, to an extent.
///
/// Errors: as [`simulate`].
pub(crate) fn simulate_to(
    case: &Case,
    options: &Options,
    (extent, states): (Extent, Option<Pictures>),
    progress: &dyn Progress,
) -> Result<Simulation, FeError> {
    let motion = match case.ground_motion {
        None if case.site.is_given() => None,
        _ => Some(checked_motion(case)?),
    };
    let vertical = motion.is_some_and(|m| m.vertical.is_some());
    let round = matches!(case.tank.shape, Shape::Cylinder { .. });
    if !round && motion.is_some_and(|m| m.transverse.is_some()) {
        return Err(FeError::Unsupported(
            "--quake-y: the harmonic engine has no walls along y of a rectangular tank; use --fe solid".into(),
        ));
    }
    progress.stage("wall, liquid and modes", 1);
    // The two meshes share nothing and are computed in parallel.
    let first = || {
        let model = Model::new(case, options, vertical, Places::Usual)?;
        if motion.is_none() {
            return units::without_record(case, options, &model, EngineId::Harmonic);
        }
        let linear = Linear {
            engine: EngineId::Harmonic,
            model: &model,
            direct: None,
            across: None,
            states,
            extent,
            known: None,
        };
        complete(case, options, &linear, progress)
    };
    let second = |mesh: SecondMesh| -> Result<Second, FeError> {
        let model = Model::new(case, &mesh.options, vertical, Places::Dense)?;
        let values = match motion {
            Some(motion) => {
                analyse_on(&model, motion, (&mesh.options, Extent::Extremes), &Silent)?.values(&model, round)
            }
            None => units::properties(&model),
        };
        let units = case.site.is_given().then(|| units::units(&model, &mesh.options)).transpose()?;
        Ok(Second { ratio: mesh.ratio, values, wave: None, units })
    };
    let (first, other) = rayon::join(first, || SecondMesh::of(options).map(second));
    let mut simulation = first?;
    mesh_error::note(&mut simulation, other.transpose()?.as_ref(), options);
    finished(case, options, &mut simulation)?;
    Ok(simulation)
}

/// Adds what does not depend on the ground motion.
///
/// Errors: a tilted tank that cannot be solved.
fn finished(case: &Case, options: &Options, simulation: &mut Simulation) -> Result<(), FeError> {
    if !options.snapshots.is_empty() {
        simulation.notes.push(
            "`analysis.snapshots`: states at given times are those of the three-dimensional engine (--fe solid, --fe both).".into(),
        );
    }
    large_wave::put(options.liquid, simulation);
    if let Some(angle) = options.tilt {
        let build = |tilted: &Case| crate::harmonic::build_observed(tilted, options, 1, Places::Usual);
        simulation.result.parts.push(tilt::tilt(case, angle, build)?);
    }
    Ok(())
}

/// Remarks on two horizontal components, one sentence each; none on one.
pub(crate) fn both_directions(motion: &GroundMotion) -> Vec<String> {
    Around::notes(motion)
}

/// Direct integration of an engine's own unknowns in place of those of its model.
pub(crate) trait Direct {
    /// Replaces the histories and extremes of `analysis`; returns the time at which it was interrupted, if it was [s].
    ///
    /// Errors: an effective matrix that cannot be factored, a response that is not finite.
    fn replace(
        &self,
        analysis: &mut Analysis<'_>,
        motion: &GroundMotion,
        progress: &dyn Progress,
    ) -> Result<Option<f64>, FeError>;
}

/// Model of an engine for a run on the requested mesh.
pub(crate) struct Linear<'a> {
    /// Which engine.
    pub engine: EngineId,
    /// Its model, whole or reduced.
    pub model: &'a Model,
    /// Its own direct integration, for horizontal motion.
    pub direct: Option<&'a dyn Direct>,
    /// Motion along y of a box.
    pub across: Option<Across<'a>>,
    /// States for pictures; none keeps none.
    pub states: Option<Pictures>,
    /// How much of the run is computed.
    pub extent: Extent,
    /// Laws of such a base from runs under other records.
    pub known: Option<&'a Arc<rocking::Known>>,
}

/// The run on the requested mesh, with everything that is reported.
pub(crate) fn complete(
    case: &Case,
    options: &Options,
    linear: &Linear<'_>,
    progress: &dyn Progress,
) -> Result<Simulation, FeError> {
    let motion = checked_motion(case)?;
    // The damping is reviewed before it is used.
    let notes = review(linear.model)?;
    let alone = motion.vertical.is_none() && motion.transverse.is_none();
    let newmark = options.integrator == Integrator::Newmark && alone;
    let Some(direct) = linear.direct.filter(|_| newmark) else {
        let analysis = analyse_on(linear.model, motion, (options, linear.extent), progress)?;
        return report(case, options, linear, analysis, motion, notes);
    };
    let modal = Options { integrator: Integrator::Modal, ..options.clone() };
    let mut analysis = analyse_on(linear.model, motion, (&modal, linear.extent), progress)?;
    let interrupted = direct.replace(&mut analysis, motion, progress)?;
    let mut simulation = report(case, options, linear, analysis, motion, notes)?;
    if let Some(time) = interrupted {
        simulation.result.end = End::Interrupted { time };
        simulation.result.incomplete = true;
        simulation.notes.push(format!(
            "The direct integration was interrupted at t = {time:.2} s: extremes are those until then, histories end there, and \
             ratios to them are meaningless."
        ));
    }
    Ok(simulation)
}

/// Warnings about the damping.
///
/// Errors: an inadmissible ratio.
fn review(model: &Model) -> Result<Vec<String>, FeError> {
    let mut notes = Vec::new();
    for harmonic in model.held_systems() {
        notes.extend(model.damper.review(&harmonic.modes)?);
    }
    Ok(notes)
}

/// Everything that is reported of a finished analysis.
///
/// Errors: a response that is not finite.
fn report(
    case: &Case,
    options: &Options,
    linear: &Linear<'_>,
    analysis: Analysis,
    motion: &GroundMotion,
    mut notes: Vec<String>,
) -> Result<Simulation, FeError> {
    let (model, round) = (linear.model, matches!(case.tank.shape, Shape::Cylinder { .. }));
    notes.extend(remarks(case, options, linear, motion));
    let mut base = MovingBase::of(case, options, linear, &analysis, motion)?;
    let held = analysis.values(model, round);
    // Where the hoop stress of the wall held down is largest: there are those of its modes.
    let hoop_place = analysis.line(OnWall::Hoop).filter(|_| round).map(LineExtremes::worst);
    let (moving, driven) = (base.model(model), base.motion(motion));
    let (mut analysis, mut demands) = match &moving {
        Some(moving) => demands::beside(case, moving, &driven, (options, linear.extent))?,
        None => demands::demands(case, model, &analysis.kept, &driven).map(|demands| (analysis, demands))?,
    };
    // What is observed, on the moving base where it moves.
    let seen = moving.as_ref().unwrap_or(model);
    let mut values = analysis.values(seen, round);
    base.put(&analysis, &held, &mut values);
    let around = Around::of(seen, linear.across, &driven, options, &analysis)?;
    demands.wave = around.as_ref().map_or_else(|| demands::wave(&analysis), |around| around.wave);
    notes.extend(waves::note(analysis.wave(), options.wave_modes, &analysis.waves));
    notes.extend(base.complete((&analysis, &values, &held), &mut demands));
    base.free.demands(&mut demands, (model, seen), &analysis, motion)?;
    demands::across(&mut demands, (model, linear.across.map(|second| second.model)), motion, options)?;
    if linear.extent == Extent::Values && moving.is_none() {
        return Ok(Simulation::unreported(linear.engine, values, demands));
    }
    let (soil, fixed_place) = soil::outcome(case, model, &analysis, motion, options)?.unzip();
    let hoop_place = fixed_place.flatten().or(hoop_place);
    notes.extend(soil::note(case, linear.engine, soil.is_some()));
    let grid = analysis.grid;
    analysis.grid = base.record_grid(grid);
    let mut assumptions = describe::assumptions(case, options, linear.engine);
    let of_modes = base.free.moved().map(|_| (notes.clone(), assumptions.clone()));
    rocking::say(&base.free, options.heave.is_some(), &mut notes, &mut assumptions);
    let large = large(case, options, linear, (&analysis, &driven), &mut demands);
    let nonlinear = large.as_ref().and_then(|large| large.judged).map(|(crest, trough)| [crest.value, trough]);
    let both = (&analysis, around.as_ref());
    let of_wall = limits::limits(case, seen, both, nonlinear, (motion.horizontal.dt, linear.engine));
    let snapshots = base.states(linear.states, (case, seen), (&driven, options), &analysis)?;
    let histories = histories(linear.extent, motion, (grid, &mut analysis), around.as_ref(), &base);
    let result = Run {
        modes: modes(case, model),
        modal: modal::parts(&model.on_fixed_base(), hoop_place),
        hoop_height: hoop_place.and_then(|place| demands::height(case, model, place)),
        integration: describe::integration(model, options, &analysis, motion, linear.direct.is_some()),
        damping_table: damping_table(model),
        mass_balance: describe::mass_balance(model),
        energy: analysis.energy,
        parts: base.part().into_iter().chain(soil).chain(large.map(|large| large.part)).collect(),
        envelopes: envelopes(linear.extent, seen, &analysis, base.free.moved()),
        limits: rocking::limits::limits(&base.free, of_wall),
        base: base.free.result(),
        record_end: Some(motion.duration()),
        histories: histories.info,
        directions: around.as_ref().map_or_else(Vec::new, Around::results),
        mesh: model.horizontal.coupled.mesh.clone(),
        ..Run::new(linear.engine)
    };
    let mut simulation = Simulation {
        values,
        result,
        series: histories.series,
        assumptions,
        notes,
        snapshots,
        demands: Some(Demands { plates: linear.engine == EngineId::Solid, ..demands }),
        units: case.site.is_given().then(|| units::units(model, options)).transpose()?,
        of_modes,
        second: None,
        slab_motion: base.isolated.is_some().then_some(driven),
    };
    transfer::add(&mut simulation, model, options)?;
    Ok(simulation)
}

/// The nonlinear liquid of the harmonic engine beside its linear one, where it is asked for or the wave is not small, with its demands. A study, which scales
/// values, has none.
fn large(
    case: &Case,
    options: &Options,
    linear: &Linear<'_>,
    (analysis, motion): (&Analysis<'_>, &GroundMotion),
    demands: &mut Demands,
) -> Option<large_wave::Beside> {
    if linear.engine != EngineId::Harmonic {
        return None;
    }
    let held = large_wave::Held {
        step: analysis.grid.dt,
        columns: analysis.scalars.iter().map(|(s, history)| (s.channel, history.values.as_slice())).collect(),
        wave: demands.wave.map_or(0.0, |peak| peak.value),
    };
    let reported = linear.extent != Extent::Values;
    let found = large_wave::beside(case, (options.liquid, reported), (motion, options.rotation.as_ref()), &held)?;
    found.demands(demands);
    Some(found)
}

/// Remarks on what model and analysis leave out of the tank and its motion.
fn remarks(case: &Case, options: &Options, linear: &Linear<'_>, motion: &GroundMotion) -> Vec<String> {
    let mut notes = model_notes(case, linear.engine);
    notes.extend(applying([
        (!options.dashpots.is_empty() && case.site.is_given(), NO_DASHPOTS),
        (options.liquid == LiquidModel::Nonlinear && linear.engine == EngineId::Harmonic, LINEAR_WALL),
        (motion.vertical.as_ref().is_some_and(|v| v.dt != motion.horizontal.dt), TWO_STEPS),
    ]));
    notes.extend(Around::notes(motion));
    notes.extend(options.rotation.as_ref().map(|_| TURNS.to_owned()));
    notes.extend(linear.model.held().impulsive().and_then(|found| found.note()));
    notes
}

/// What the model of a tank leaves out.
fn model_notes(case: &Case, engine: EngineId) -> Vec<String> {
    let four_walls = matches!(case.tank.shape, Shape::Rectangle { strip: false, .. });
    let said = applying([
        (case.tank.support == Support::Unanchored, rocking::HELD_DOWN),
        (engine == EngineId::Harmonic && four_walls, SIDE_WALLS),
    ]);
    said.collect()
}

/// The remarks whose condition is met.
fn applying<const N: usize>(said: [(bool, &str); N]) -> impl Iterator<Item = String> {
    said.into_iter().filter(|(applies, _)| *applies).map(|(_, text)| text.to_owned())
}

/// Resulting damping ratios of all systems.
fn damping_table(model: &Model) -> Vec<results::DampingRow> {
    let of = |h: &Harmonic| {
        let mass = h.coupled.liquid_mass + h.coupled.wall_mass;
        model.damper.table(&h.modes, mass)
    };
    model.held_systems().flat_map(of).collect()
}

/// The first modes of each kind, harmonic by harmonic, with the damping they were given.
fn modes(case: &Case, model: &Model) -> Vec<Mode> {
    let listed = |h: &Harmonic| -> Vec<Mode> {
        h.modes
            .iter()
            .filter(|m| m.number <= LISTED_MODES)
            .map(|m| Mode { damping: model.damper.ratio(m.kind, m.omega), ..m.to_result(&h.coupled, case) })
            .collect()
    };
    model.held_systems().flat_map(listed).collect()
}

/// Ground motion, scalars and the base's own histories; runs to some extents have none. The scalars of the analysis lose their values.
fn histories(
    extent: Extent,
    motion: &GroundMotion,
    (grid, analysis): (Grid, &mut Analysis),
    around: Option<&Around>,
    base: &MovingBase,
) -> Histories {
    if extent == Extent::Selected {
        return Histories::at(Vec::new());
    }
    let mut histories = Histories::at((0..grid.samples).map(|k| k as f64 * grid.dt).collect());
    histories.push_ground(motion);
    for (scalar, history) in &mut analysis.scalars {
        // With a component along y the internal forces are those of both ([`around`]).
        if motion.transverse.is_some() && scalar.channel.force_at().is_some() {
            continue;
        }
        let info = SeriesInfo::of(scalar.channel, scalar.static_value, history.extreme.peak());
        histories.push(info, std::mem::take(&mut history.values));
    }
    if let Some(around) = around {
        around.add(&mut histories);
    }
    if let Some(found) = &base.isolated {
        isolation::push(found, &mut histories);
    }
    if let Some(found) = base.free.moved() {
        found.add(&mut histories);
    }
    histories
}

/// Envelopes at θ = 0 with the static state; none of a run that has not the extremes of all lines.
fn envelopes(extent: Extent, model: &Model, analysis: &Analysis, moved: Option<&rocking::Moved>) -> Vec<Envelope> {
    let lines = model.horizontal.coupled.lines.iter().filter(|_| extent == Extent::Whole);
    let mut all: Vec<Envelope> = lines
        .zip(&analysis.lines)
        .map(|(line, extremes)| Envelope {
            id: line.what.id().into(),
            title: line.what.title().into(),
            dimension: line.what.dimension(),
            z: line.z.clone(),
            static_: line.probes.iter().map(|p| p.static_value).collect(),
            min: extremes.front.iter().map(|e| e.min).collect(),
            max: extremes.front.iter().map(|e| e.max).collect(),
        })
        .collect();
    if let Some(moved) = moved {
        moved.correct(&mut all);
    }
    all
}
