//! A case from mesh to results, by the three-dimensional engine.

use std::collections::BTreeMap;

use fem::progress::Progress;
use tank::Case;
use tank::case::GroundMotion;

use super::coupling;
use super::fields;
use super::instants::{asked, extreme_moments};
use super::mesh::Division;
use super::model::{self, TankModel};
use super::moments::Histories;
use super::poles::{VECTORS, poles};
use super::reduce::{self, Space};
use super::shared::Shared;
use super::spectrum::{self, TankMode};
use super::system::System;
use crate::checks::check_options;
use crate::coupled::Coupled;
use crate::damping::Damper;
use crate::engine::Task;
use crate::linear::mesh_error::{self, Second, SecondMesh};
use crate::linear::model::{Model, shaken_upwards};
use crate::linear::soil::{self, Slab};
use crate::linear::system::Harmonic;
use crate::linear::tilt;
use crate::linear::units;
use crate::modes::{CoupledMode, Kind, solve};
use crate::{FeError, Simulation};
use results::{Channel, EngineId, Part};
use tank::options::LinearOptions as Options;
use tank::options::solid::{Liquid, SolidOptions};
use tank::refusal::Refusal;

/// Ritz vectors of the search for one mode to be drawn.
const DRAWN_VECTORS: usize = 32;
/// The same in one part of the motions of a rectangle.
const DRAWN_PART_VECTORS: usize = 48;
/// Other parts of the motions of a rectangle whose lowest modes are drawn: along y, even about both planes.
const DRAWN_PARTS: [u32; 2] = [2, 0];
/// Wave numbers beyond 1 whose lowest wall modes are drawn.
const DRAWN_WAVES: [u32; 3] = [2, 3, 5];

/// A tank with its reductions and their modes.
pub(super) struct Prepared {
    pub(super) tank: TankModel,
    pub(super) system: System,
    /// Maps from the reduced coordinates to the model, by direction.
    pub(super) spaces: Vec<Space>,
    /// The model of the response analyses: the reductions for x and, with a vertical record, for z.
    pub(super) model: Model,
}

impl Prepared {
    pub(super) fn new(
        case: &Case,
        options: &Options,
        solid: &SolidOptions,
        vertical: bool,
        progress: &dyn Progress,
    ) -> Result<Prepared, FeError> {
        progress.stage("mesh, matrices and factors", 2);
        let tank = TankModel::new(case, options, solid)?;
        Prepared::of(tank, case, options, solid, vertical, progress)
    }

    fn of(
        tank: TankModel,
        case: &Case,
        options: &Options,
        solid: &SolidOptions,
        vertical: bool,
        progress: &dyn Progress,
    ) -> Result<Prepared, FeError> {
        let damper = Damper::new(case, &options.damping)?;
        progress.advance(1);
        stop(progress, "the mesh")?;
        let system = System::new(&tank.model, &tank.assembler, &poles(case, solid), solid.memory_limit_mib << 20)?;
        progress.advance(1);
        let directions = if vertical { 2 } else { 1 };
        progress.stage("reduction to the space that the ground motion excites", VECTORS as u64 * directions);
        let mut spaces = Vec::new();
        let mut prepare = |harmonic: u32| -> Result<Harmonic, FeError> {
            stop(progress, "the reduction")?;
            let (coupled, space) = reduce::new(case, options, &tank, &system, harmonic, progress)?;
            let mut modes = solve(&coupled, None)?;
            coupling::number(&tank, &system, harmonic, &mut modes, &|mode| space.basis.times(&mode.vector));
            spaces.push(space);
            if !tank.is_round() {
                renumber(&mut modes);
            }
            Ok(Harmonic { coupled, modes })
        };
        let horizontal = prepare(1)?;
        let vertical = if vertical { Some(prepare(0)?) } else { None };
        let site = match &vertical {
            _ if !shaken_upwards(case) => None,
            Some(same) => Some(same.clone()),
            // The reduction loses the volume of the liquid of harmonic 0 in an imperfect tank; the column says that it is
            // without vertical motion.
            None if !tank.imperfections.is_empty() => None,
            None => Some(prepare(0)?),
        };
        // Spaces are those of responses to records.
        spaces.truncate(1 + usize::from(vertical.is_some()));
        let damper = damper.tuned(&horizontal.modes);
        let (horizontal, fixed) = match moves_on_soil(&tank) {
            true => soil::under(case, &damper, horizontal)?,
            false => (horizontal, None),
        };
        if let (Some(slab), Some(_)) = (Slab::of(case)?, &fixed) {
            let turning = reduce::turning(case, &tank, &system, &slab)?;
            spaces[0].slab = Some(slab_potentials(&horizontal.coupled, &spaces[0], turning));
        }
        let model = Model { whole: false, vertical, site, turned: None, damper, horizontal, fixed };
        Ok(Prepared { tank, system, spaces, model })
    }

    /// Modes of the reduced systems on the whole model, of one direction and kind, at most `count`.
    fn expanded(&self, direction: usize, kind: Kind, count: usize) -> Vec<TankMode> {
        let Some(harmonic) = self.model.held_systems().nth(direction) else { return Vec::new() };
        let space = &self.spaces[direction];
        harmonic
            .modes
            .iter()
            .filter(|m| m.kind == kind && m.number <= count)
            .map(|m| {
                let vector = space.basis.times(&m.vector);
                TankMode {
                    kind,
                    harmonic: harmonic.coupled.harmonic,
                    omega: m.omega,
                    waves: spectrum::waves(&self.tank, &vector),
                    vector,
                }
            })
            .collect()
    }

    /// Modes to be drawn: the first that the ground motion excites, and the lowest wall modes of some other wave numbers.
    fn drawn_modes(&self, progress: &dyn Progress) -> Result<Vec<TankMode>, FeError> {
        let mut drawn = self.expanded(0, Kind::Sloshing, 3);
        drawn.extend(self.expanded(0, Kind::Structural, 2));
        let (others, vectors): (&[u32], usize) = match self.tank.is_round() {
            true => (&DRAWN_WAVES, DRAWN_VECTORS),
            false => (&DRAWN_PARTS, DRAWN_PART_VECTORS),
        };
        progress.stage("modes of other wave numbers", (others.len() * vectors) as u64);
        for &n in others {
            if n > spectrum::most_waves(&self.tank) || progress.interrupted() {
                break;
            }
            let found = spectrum::of_harmonic(&self.tank, &self.system, n, (vectors, 1), progress)?;
            let first = |kind: Kind| found.iter().find(|m| m.kind == kind).cloned();
            if n == 2 || !self.tank.is_round() {
                drawn.extend(first(Kind::Sloshing));
            }
            drawn.extend(first(Kind::Structural));
        }
        Ok(drawn)
    }

    /// Pictures of a run.
    pub(super) fn pictures(
        &self,
        motion: &GroundMotion,
        options: &Options,
        solid: &SolidOptions,
        simulation: &mut Simulation,
        progress: &dyn Progress,
    ) -> Result<(), FeError> {
        let drawn = self.drawn_modes(progress)?;
        // The other motion of a box is that of another model.
        let along;
        let motion = match self.tank.is_round() {
            true => motion,
            false => {
                along = GroundMotion { transverse: None, ..motion.clone() };
                &along
            }
        };
        let histories = Histories::new(&self.model, motion, options)?;
        let mut moments = extreme_moments(&simulation.result);
        let asked = asked(&simulation.result, histories.end(), &options.snapshots)?;
        for one in asked {
            if !moments.contains(&one) {
                moments.push(one);
            }
        }
        simulation.result.fields = Some(fields::fields(&self.tank, &self.spaces, &histories, &drawn, &moments));
        if let Some(interval) = solid.snapshot_interval.filter(|i| *i > 0.0) {
            let end = motion.horizontal.duration();
            let asked = (interval, end, solid.snapshot_inside);
            let states = fields::snapshots(&self.tank, &self.spaces, &histories, &drawn, asked);
            simulation.snapshots = Some(states);
        }
        Ok(())
    }
}

/// Whether a slab on soil moves: under a perfect wall and a potential liquid, whose probes contain the motion of the base.
fn moves_on_soil(tank: &TankModel) -> bool {
    tank.is_round() && tank.imperfections.is_empty() && tank.liquid == Liquid::Potential
}

/// Potentials of the slab's two unknowns, in their units; `turning`: that of a unit rotation.
fn slab_potentials(coupled: &Coupled, space: &Space, turning: Vec<f64>) -> [Vec<f64>; 2] {
    let units = [Channel::FoundationTranslation, Channel::FoundationRotation].map(|channel| {
        let row = coupled.probe(channel).map_or(&[][..], |probe| &probe.displacement);
        row.iter().sum::<f64>()
    });
    let along = space.rigid.iter().zip(&space.potentials).map(|(v, phi)| if *phi { units[0] * v } else { 0.0 });
    [along.collect(), turning.into_iter().map(|v| units[1] * v).collect()]
}

/// Share of all effective mass from which a mode of a rectangle counts before the others of its kind.
const COUNTS: f64 = 1e-5;

/// Numbers the modes that the motion excites first, by kind and frequency, then the others.
///
/// In a rectangle waves across the shaking lie between those along it; walls that give way excite them hardly, and the first five waves
/// are not to be taken up by them.
fn renumber(modes: &mut [CoupledMode]) {
    let all: f64 = modes.iter().map(CoupledMode::effective_mass).sum();
    let mut last: BTreeMap<Kind, usize> = BTreeMap::new();
    for excited in [true, false] {
        for mode in modes.iter_mut() {
            if (mode.effective_mass() > COUNTS * all) == excited {
                let number = last.entry(mode.kind).or_insert(0);
                *number += 1;
                mode.number = *number;
            }
        }
    }
}

/// Errors: the user wants to stop.
pub(super) fn stop(progress: &dyn Progress, stage: &str) -> Result<(), FeError> {
    if progress.interrupted() {
        return Err(FeError::Interrupted { stage: stage.into() });
    }
    Ok(())
}

/// Time history of a case by the three-dimensional engine.
///
/// Errors: as [`crate::simulate()`]; a mesh that cannot be built; more memory than allowed; interrupted before there are results.
pub fn simulate(
    case: &Case,
    options: &Options,
    solid: &SolidOptions,
    progress: &dyn Progress,
) -> Result<Simulation, FeError> {
    if case.ground_motion.is_none() && case.site.is_given() {
        return without_record(case, options, solid, progress);
    }
    let shared = Shared::new(case, options, solid, progress)?;
    let mut simulation = shared.respond(case, options, progress)?;
    shared.finish((case, options, solid), &mut simulation, progress)?;
    Ok(simulation)
}

/// The static tilt test alone, on a base tilted by `angle` [rad].
///
/// Errors: as [`simulate`].
pub fn tilted(
    case: &Case,
    angle: f64,
    options: &Options,
    solid: &SolidOptions,
    progress: &dyn Progress,
) -> Result<Part, FeError> {
    tilt::tilt(case, angle, |tilted| coupled(tilted, options, solid, progress))
}

/// The modes of a case that has a site and no record, for the design spectrum of the site.
///
/// Errors: as [`simulate`].
fn without_record(
    case: &Case,
    options: &Options,
    solid: &SolidOptions,
    progress: &dyn Progress,
) -> Result<Simulation, FeError> {
    check_options(case, options)?;
    let model = Prepared::new(case, options, solid, false, progress)?.model;
    let mut simulation = units::without_record(case, options, &model, EngineId::Solid)?;
    let coarser = SecondMesh::coarser(options).filter(|_| solid.mesh.is_none() && !progress.interrupted());
    let second = match coarser {
        Some(SecondMesh { options, ratio }) => {
            let coarse = Prepared::new(case, &options, solid, false, progress)?.model;
            Some(Second {
                ratio,
                values: units::properties(&coarse),
                wave: None,
                units: Some(units::units(&coarse, &options)?),
            })
        }
        None => None,
    };
    if let Some(angle) = options.tilt.filter(|_| !progress.interrupted()) {
        let build = |tilted: &Case| coupled(tilted, options, solid, progress);
        simulation.result.parts.push(tilt::tilt(case, angle, build)?);
    }
    if solid.snapshot_interval.is_some() || !options.snapshots.is_empty() {
        let note = "States for pictures and ParaView are those of a time history: this run has no record.";
        simulation.notes.push(note.into());
    }
    simulation.result.incomplete |= progress.interrupted();
    mesh_error::note(&mut simulation, second.as_ref(), options);
    Ok(simulation)
}

/// The system of harmonic 1 of a case.
///
/// Errors: as [`simulate`].
fn coupled(case: &Case, options: &Options, solid: &SolidOptions, progress: &dyn Progress) -> Result<Coupled, FeError> {
    let tank = TankModel::new(case, options, solid)?;
    let memory = solid.memory_limit_mib << 20;
    let system = System::new(&tank.model, &tank.assembler, &poles(case, solid), memory)?;
    reduce::new(case, options, &tank, &system, 1, progress).map(|(coupled, _)| coupled)
}

/// The response alone, without pictures and a second mesh.
///
/// Errors: as [`simulate`].
pub fn respond(
    case: &Case,
    options: &Options,
    solid: &SolidOptions,
    progress: &dyn Progress,
) -> Result<Simulation, FeError> {
    Shared::new(case, options, solid, progress)?.respond(case, options, progress)
}

/// The response around an imperfect wall on the liquid of the perfect tank, as the nonlinear engine has it.
///
/// Errors: as [`simulate`].
#[cfg(test)]
pub(crate) fn around_a_perfect_liquid(
    case: &Case,
    options: &Options,
    solid: &SolidOptions,
) -> Result<Option<results::Around>, FeError> {
    let form = super::form::Form { wet: false, ..super::form::Form::of(case, &solid.imperfections) };
    let progress = &fem::progress::Silent;
    let tank = TankModel::formed(case, options, solid, &form)?;
    let prepared = Prepared::of(tank, case, options, solid, false, progress)?;
    let parts = (&prepared.model, &prepared.spaces[..]);
    super::around::respond(case, &solid.imperfections, parts, crate::checks::checked_motion(case)?, options, progress)
}

/// The refusal of imperfections, if there is one.
pub(crate) fn unresolved(task: &Task<'_>) -> Option<Refusal> {
    if task.solid.imperfections.is_empty() {
        return None;
    }
    let depth = task.case.liquid.fill_height;
    let division = Division::new(&task.case.tank, depth, task.linear, task.solid, false).ok()?;
    model::unresolved(task.case, task.solid, (division.sectors, division.wall.len() - 1))
}
