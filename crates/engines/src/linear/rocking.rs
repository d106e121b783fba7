//! An unanchored cylinder that rocks and slides on its bottom plate.
//!
//! The modes of the wall on a fixed base become the body of [`::base::history`], whose base is that of the strips. Where the run with
//! the wall held down neither lifts the rim nor overcomes friction nothing else is computed: the tank moves as if it were held. Otherwise the
//! motion of the base drives the wall ([`lifted`]), and its values are those of the run.
//! `docs/theory/base.md`.

mod body;
mod floor;
mod law;
mod lifted;
pub(super) mod limits;
mod outcome;
mod peaks;
mod search;
mod setup;
#[cfg(test)]
mod tests;
mod words;

use std::collections::BTreeMap;
use std::sync::Arc;

use ::base::history::Friction;
use ::base::{Anchors, Base, Soil};
use rayon::prelude::*;
use results::channel::OnWall;
use results::{BaseRun, Channel, EngineId};
use tank::case::GroundMotion;
use tank::demand::{Demands, Footing, FreeBase};
use tank::options::LinearOptions as Options;
use tank::{Case, FRICTION, Quantity, STANDARD_GRAVITY, Shape, Support};

use super::analysis::{Analysis, Extent};
use super::model::Model;
use crate::FeError;
use crate::floor_pressure::impulsive_pressure;
use crate::harmonic::{CLAMPED, IN_CONTACT};
use crate::response::motion::{Grid, Motion};

pub(super) use lifted::of_base;
pub(super) use outcome::{Bottom, Moved};
use search::Found;
pub(crate) use setup::Known;
use setup::Setup;
pub(super) use words::HELD_DOWN;

/// Longest time step [s].
const LONGEST: f64 = 1e-3;
/// What follows the record in the runs that search [s]: the rotation follows the wall, not the sloshing.
const AFTER: f64 = 2.0;
/// Part of the moment at which a rim that is not round leaves the ground below which it is not followed in time: shells of a squat tank had 1.4 times the
/// moment of the wall held down before they lifted.
const RESTS: f64 = 0.5;
/// Moduli of the band over that of the ground.
const BAND: [f64; 2] = [1.0 / 3.0, 3.0];
/// Radii at which the form of the pressure on the bottom is known, from the axis to the wall.
const FORM: usize = 41;

/// What an unanchored tank does.
pub(super) enum Free {
    /// It is none, or its engine says so elsewhere.
    Held,
    /// Anchors hold it that may yield under a stronger motion.
    Anchored,
    /// It moves further than a run can follow.
    Beyond(Box<Beyond>),
    /// It is not computed, and why.
    NotComputed(String),
    /// Nothing lifts or slides, a note; whether friction alone holds it in place.
    Rests(String, bool),
    /// It lifts or slides.
    Moves(Box<Moved>),
}

/// A tank that moves further than a run can follow.
pub(super) struct Beyond {
    /// The note of the run.
    note: String,
    /// Why, a clause.
    reason: String,
    /// How far it turns [rad] and when it leaves the model [s], where that is known.
    turns: Option<[f64; 2]>,
}

impl Free {
    fn beyond(note: String, missed: &setup::Missed) -> Free {
        Free::Beyond(Box::new(Beyond { note, reason: words::reason(missed), turns: missed.turns() }))
    }

    /// The run that lifts or slides.
    pub(super) fn moved(&self) -> Option<&Moved> {
        match self {
            Free::Moves(moved) => Some(moved),
            _ => None,
        }
    }

    /// The same, to be completed.
    pub(super) fn moved_mut(&mut self) -> Option<&mut Moved> {
        match self {
            Free::Moves(moved) => Some(moved),
            _ => None,
        }
    }

    /// Whether the base was free to move.
    pub(super) fn is_modelled(&self) -> bool {
        matches!(self, Free::Rests(..) | Free::Moves(_))
    }

    /// What a base that rests adds to the comparable values.
    pub(super) fn rest(&self, values: &mut BTreeMap<Quantity, f64>) {
        if let Free::Rests(_, slides) = self {
            values.extend([Quantity::Uplift, Quantity::PlasticRotation].map(|quantity| (quantity, 0.0)));
            values.extend(slides.then_some((Quantity::Slip, 0.0)));
        }
    }

    /// The demands on a free base, where those of the wall are computed.
    ///
    /// Errors: a response that is not finite.
    pub(super) fn demands(
        &self,
        demands: &mut Demands,
        models: (&Model, &Model),
        analysis: &Analysis<'_>,
        motion: &GroundMotion,
    ) -> Result<(), FeError> {
        match self {
            Free::Moves(moved) => moved.demands(demands, models, analysis, motion)?,
            Free::Rests(..) => demands.base = Some(FreeBase::default()),
            Free::Held | Free::Anchored | Free::Beyond(_) | Free::NotComputed(_) => {}
        }
        demands.footing = match self {
            Free::Held | Free::NotComputed(_) => Footing::Fixed,
            Free::Anchored | Free::Rests(..) => Footing::Rests,
            Free::Moves(_) => Footing::Moves,
            Free::Beyond(beyond) => {
                Footing::Beyond { time: beyond.turns.map(|[_, time]| time), reason: beyond.reason.clone() }
            }
        };
        Ok(())
    }

    /// The bottom for pictures, where it moves and they are asked for.
    pub(super) fn bottom(&self) -> Option<&Bottom> {
        self.moved()?.bottom.as_ref()
    }

    /// The results of the run.
    pub(super) fn result(self) -> Option<BaseRun> {
        match self {
            Free::Moves(moved) => Some(moved.result),
            _ => None,
        }
    }
}

/// What is asked of a run of a base: options; its extent, whether it also runs on softer and harder ground and under motions slightly apart; laws
/// of the base from runs under other records; whether the bottom is drawn.
pub(super) type Asked<'a> = (&'a Options, Extent, Option<&'a Arc<Known>>, bool);

/// The run of a tank that is not held down.
pub(super) fn free(
    case: &Case,
    (engine, model): (EngineId, &Model),
    analysis: &Analysis<'_>,
    motion: &GroundMotion,
    (options, extent, known, drawn): Asked<'_>,
) -> Free {
    let round = matches!(case.tank.shape, Shape::Cylinder { .. });
    if !round || engine != EngineId::Harmonic {
        return Free::Held;
    }
    if case.tank.support == Support::Anchored {
        return on_anchors(case, model, analysis, motion, (options, extent, known, drawn));
    }
    let Ok(base) = Base::of(case) else { return Free::Held };
    if let Some(reason) = words::unsupported(motion.transverse.is_some(), !options.dashpots.is_empty()) {
        return Free::NotComputed(reason);
    }
    let Some(setup) = setup(case, model, motion, analysis.grid, options) else {
        return Free::NotComputed(words::NO_ROWS.into());
    };
    let setup = Setup { thorough: extent.repeats(), grounds: extent.has_band(), known: known.cloned(), drawn, ..setup };
    match setup.dragging(&base).and_then(|setup| run(&setup, &base, analysis)) {
        Ok(free) => free,
        Err(missed) => Free::beyond(words::missed(&missed), &missed),
    }
}

/// The run of a tank on anchors, where one yields in the run with the wall held down.
fn on_anchors(
    case: &Case,
    model: &Model,
    analysis: &Analysis<'_>,
    motion: &GroundMotion,
    (options, extent, known, drawn): Asked<'_>,
) -> Free {
    // The wall that is held down stands on ground that the tank does not feel.
    if case.tank.isolators.is_some() {
        return Free::Held;
    }
    let Some((anchors, yields)) = case.tank.anchors.and_then(|a| Some((a, a.yield_force.or(a.capacity)?))) else {
        return Free::Held;
    };
    let Some(pull) = super::limits::pull(case, model, analysis) else { return Free::Held };
    let force = pull * std::f64::consts::TAU * case.tank.shape.half_length() / f64::from(anchors.count.max(1));
    if force <= yields {
        let stretches = anchors.stiffness.is_some() && Base::of(case).is_ok();
        return if stretches { Free::Anchored } else { Free::Held };
    }
    let said = |reason: &str| words::anchors_not_computed(force, yields, reason);
    let held = |reason: &str| Free::NotComputed(said(reason));
    let Some(stiffness) = anchors.stiffness else { return held("`tank.anchors.stiffness` is missing") };
    if model.fixed.is_some() {
        return held("anchors that yield on a slab that moves are not modelled");
    }
    if motion.transverse.is_some() || !options.dashpots.is_empty() {
        return held("anchors that yield under two horizontal components, or with dashpots, are not modelled");
    }
    // The pull of single anchors is not that of a weight on a foot that warps.
    let Ok(base) = Base::of(case).map(Base::plane) else {
        return held("`tank.bottom` is missing, the plate that lifts with the wall");
    };
    let Some(setup) = setup(case, model, motion, analysis.grid, options) else {
        return held("the model has no rows of base moment or pressure");
    };
    let setup = Setup {
        thorough: extent.repeats(),
        grounds: extent.has_band(),
        known: known.cloned(),
        friction: None,
        anchors: Some(Anchors {
            count: anchors.count as usize,
            stiffness,
            yield_force: yields,
            gap: anchors.gap.unwrap_or(0.0),
            rupture: anchors.rupture_elongation,
        }),
        drawn,
        ..setup
    };
    match run(&setup, &base, analysis) {
        Ok(free) => free,
        Err(missed) => Free::beyond(said(&words::reason(&missed)), &missed),
    }
}

/// The run, if anything moves.
fn run(setup: &Setup, base: &Base, analysis: &Analysis<'_>) -> Result<Free, setup::Missed> {
    let laws = law::laws(setup, base, search::FIRST)?;
    let law = &laws.law;
    let peak = |channel| analysis.sides(channel).map_or(0.0, |(front, back)| front.peak().0.max(back.peak().0));
    let moment = peak(Channel::BaseMoment);
    let pressure = analysis.line(OnWall::Pressure).map_or(0.0, |line| line.peak(0));
    let lifting = search::lifting(law, pressure);
    let rests = if laws.waves.is_some() { RESTS * lifting } else { lifting };
    if setup.anchors.is_none() && moment < rests && !slides(setup, analysis) {
        return Ok(Free::Rests(words::rests(moment, lifting, setup.friction.is_some()), setup.friction.is_some()));
    }
    let reach = search::reach(setup, base, &laws)?;
    let known = (reach == law.largest()).then_some(laws);
    let band: &[f64] = if setup.grounds { &BAND } else { &[] };
    let other = |factor: &f64| {
        let on = base.on(factor * base.modulus).with_long_elements();
        let own = setup.dragging(&on);
        match own.and_then(|own| search::settle(&own, &on, (reach, None), false)) {
            Ok(found) => Ok(outcome::band(&on, &found)),
            Err(missed) => Err(words::missed_band(on.modulus, &missed)),
        }
    };
    let (main, others) =
        rayon::join(|| search::closed(setup, base, (reach, known)), || band.par_iter().map(other).collect::<Vec<_>>());
    let (setup, found): (Setup, Found) = main?;
    let grid = Grid { sub_steps: setup.sub_steps, ..analysis.grid };
    Ok(Free::Moves(Box::new(outcome::moved(&setup, base, found, others, grid))))
}

/// Whether the shear of the wall held down overcomes friction.
fn slides(setup: &Setup, analysis: &Analysis<'_>) -> bool {
    let Some(friction) = &setup.friction else { return false };
    let shear = analysis.scalars.iter().find(|(s, _)| s.channel == Channel::BaseShear);
    shear.is_some_and(|(_, history)| {
        history.values.iter().enumerate().any(|(k, v)| {
            let up = friction.vertical.get(k * setup.sub_steps).copied().unwrap_or(0.0);
            v.abs() > friction.coefficient * friction.weight * (1.0 + up).max(0.0)
        })
    })
}

/// Steps of the base in a sample of `dt` [s], where the wall takes so many.
pub(crate) fn sub_steps(dt: f64, of_wall: usize) -> usize {
    ((dt / LONGEST - 1e-9).ceil() as usize).max(of_wall)
}

/// What does not depend on the ground.
fn setup(case: &Case, model: &Model, motion: &GroundMotion, grid: Grid, options: &Options) -> Option<Setup> {
    let (body, rigid_pressure) = body::body(model, options.wave_modes)?;
    // Not coarser than the steps of the wall, which goes on with the motion of the base.
    let sub_steps = sub_steps(grid.dt, grid.sub_steps);
    let fine = Grid { sub_steps, ..grid };
    let sampled = |record| {
        let motion = Motion::new(record, &fine);
        (0..=fine.steps()).map(|i| motion.at(i)).collect::<Vec<f64>>()
    };
    let vertical = motion.vertical.as_ref().map_or_else(Vec::new, sampled);
    let coupled = &model.horizontal.coupled;
    let foundation = case.tank.foundation;
    let searched = ((motion.duration() + AFTER) / fine.h()) as usize + 1;
    let form = || {
        let at = |j: usize| {
            let radius = case.tank.shape.half_length();
            impulsive_pressure(case, radius, radius * j as f64 / (FORM - 1) as f64)
        };
        let all: Vec<f64> = (0..FORM).map(at).collect();
        all.iter().map(|p| p / all[FORM - 1]).collect()
    };
    // That of the wall at its impulsive mode, which the plate and the ground are a part of.
    let impulsive = model.horizontal.impulsive();
    let after = |ratio: f64| impulsive.as_ref().map_or(0.0, |i| 2.0 * ratio / i.dominant.omega);
    let delay = after(case.damping.impulsive);
    Some(Setup {
        thorough: true,
        corrodes: case.tank.corrodes(),
        damping: case.damping.impulsive,
        delay,
        ground_damping: [options.ground_damping, after(options.ground_damping)],
        heave: options.heave,
        grounds: true,
        known: None,
        anchors: None,
        drawn: false,
        form: form(),
        assumed: foundation.is_none(),
        friction: foundation.map_or(Some(FRICTION), |f| f.friction).map(|coefficient| Friction {
            coefficient,
            weight: (coupled.liquid_mass + coupled.wall_mass) * case.gravity,
            vertical: vertical.iter().map(|a| a / STANDARD_GRAVITY).collect(),
            springs: Vec::new(),
            delay,
        }),
        soil: foundation.and_then(|f| {
            let velocity = f.shear_wave_velocity?;
            Some((Soil::of_waves(velocity, f.soil_density, f.soil_poisson_ratio), velocity, f.soil_density))
        }),
        ground: sampled(&motion.horizontal),
        searched,
        step: fine.h(),
        sub_steps,
        shortened: false,
        vertical: motion.vertical.is_some(),
        body,
        rigid_pressure,
    })
}

/// Replaces the note and the assumptions of a wall that is held down.
///
/// * `heave`: whether inertia on the foot is asked for
pub(super) fn say(free: &Free, heave: bool, notes: &mut Vec<String>, assumptions: &mut Vec<String>) {
    if heave && free.moved().is_none() {
        notes.push(words::NO_HEAVE.into());
    }
    if free.is_modelled() {
        assumptions.retain(|text| text != IN_CONTACT);
    }
    if let (Free::Moves(_), Some(text)) = (free, assumptions.iter_mut().find(|text| *text == CLAMPED)) {
        *text = words::FOOT.into();
    }
    let text = match free {
        Free::Held | Free::Anchored => return,
        Free::NotComputed(reason) | Free::Rests(reason, _) => reason.clone(),
        Free::Beyond(beyond) => beyond.note.clone(),
        Free::Moves(moved) => words::moves(moved.result.anchors.is_some()),
    };
    match notes.iter_mut().find(|note| *note == HELD_DOWN) {
        Some(note) => *note = text,
        None => notes.push(text),
    }
    if let Free::Moves(moved) = free {
        notes.extend(moved.result.missed.iter().map(words::band_note));
    }
}
