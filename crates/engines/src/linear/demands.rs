//! Demands of a linear run: its histories as combinations of modal coordinates and ground motion.
//!
//! Kept are the modal states at the sub-steps, not the histories: some forty numbers an instant instead of several hundred. They are
//! those of modal superposition also where the histories of the run are integrated directly.

use std::f64::consts::PI;

use fem::progress::Silent;
use oscillator::record::Record;
use tank::case::GroundMotion;
use tank::demand::{Angles, Demands, Footing, OnWall as Stress, Peak, Place, Surface, Terms};
use tank::{Case, Shape};

use super::analysis::{Analysis, Extent, analyse_on};
use super::model::Model;
use super::system::Harmonic;
use crate::FeError;
use crate::estimate::MOST_INSTANTS;
use crate::modes::CoupledMode;
use crate::probe::{Probe, ProbeLine};
use crate::response::motion::{Grid, Motion};
use crate::response::superpose::{self, Combined, ModalSystem, Observable};
use results::Channel;
use results::channel::{OnWall, Side};
use tank::options::LinearOptions;
use tank::options::linear::Integrator;

/// Part of a peak of the fastest mode that instants apart may miss.
const LOST: f64 = 1e-3;
/// Part of the ringing that the samples miss where a mode is too fast to be resolved: it follows the record statically.
const UNRESOLVED: f64 = 0.005;

/// Observables with their static values, of m = 1 and m = 0 apart.
#[derive(Default)]
struct Wanted<'a> {
    observables: Vec<Observable<'a>>,
}

/// Where the terms of a quantity stand among the observables.
struct Slot {
    rest: f64,
    odd: usize,
    even: Option<usize>,
}

impl<'a> Wanted<'a> {
    fn push(&mut self, observable: Observable<'a>) -> usize {
        self.observables.push(observable);
        self.observables.len() - 1
    }

    /// Σ share × probe `i` of a line, of m = 1 and of m = 0.
    fn on_line(&mut self, model: &'a Model, line: &'a ProbeLine, shares: &[(usize, f64)]) -> Slot {
        let rest = shares.iter().map(|(i, w)| w * line.probes[*i].static_value).sum();
        let of =
            |line: &'a ProbeLine| -> Observable<'a> { shares.iter().map(|(i, w)| (1, *w, &line.probes[*i])).collect() };
        let odd = shares.iter().flat_map(|(i, w)| model.odd_on_line(line, *i, *w)).collect();
        let odd = self.push(odd);
        let same = |h: &'a Harmonic| h.coupled.lines.iter().find(|l| l.what == line.what && l.z == line.z);
        let even = model.vertical.as_ref().and_then(same);
        let even = even.map(|line| self.push(of(line)));
        Slot { rest, odd, even }
    }
}

/// The demands of a run, without its wave.
///
/// * `kept`: the modes that count, system by system
///
/// Errors: a response that is not finite.
pub(crate) fn demands(
    case: &Case,
    model: &Model,
    kept: &[Vec<&CoupledMode>],
    motion: &GroundMotion,
) -> Result<Demands, FeError> {
    // Direct integration may have a finer grid; the modal one serves here.
    let grid = model.grid(motion, Integrator::Modal)?;
    let stride = stride(model, &grid);
    let upwards = Probe { ground_acceleration: 1.0, ..Probe::new(Channel::BaseShear) };
    let mut wanted = Wanted::default();
    let shear = model.horizontal.coupled.probe(Channel::BaseShear);
    let shear = shear.map(|probe| wanted.push(model.odd(probe)));
    let below = model.horizontal.coupled.probe(Channel::OverturningMoment);
    let below = below.map(|probe| wanted.push(model.odd(probe)));
    let vertical = model.vertical.is_some().then(|| wanted.push(vec![(1, 1.0, &upwards)]));
    let slots = places(case, model, &mut wanted);
    let of = |record| {
        let records = (record, motion.vertical.as_ref());
        combine(model, kept, records, (grid, stride), &wanted.observables)
    };
    let Combined { states, terms } = of(&motion.horizontal)?;
    // The walls of a box along y are others: its part along y is added by `across`.
    let round = matches!(case.tank.shape, Shape::Cylinder { .. });
    let transverse = motion.transverse.as_ref().filter(|_| round).map(of).transpose()?;
    let take = |i: usize| -> Terms { terms[i].clone() };
    let on_wall =
        |slot: &Slot| Stress { rest: slot.rest, odd: take(slot.odd), even: slot.even.map_or(Terms::new(), take) };
    let place = |found: &PlaceSlots| Place {
        z: found.z,
        course: found.course,
        turned: 0.0,
        hoop: on_wall(&found.hoop),
        axial: on_wall(&found.axial),
        bending: found.bending.as_ref().map(on_wall),
        shear: found.shear.as_ref().map(|(slot, thickness)| {
            let per_area = |(state, c): (usize, f64)| (state, c / thickness);
            take(slot.odd).into_iter().map(per_area).collect()
        }),
        pressure: found.pressure.as_ref().map(on_wall),
    };
    Ok(Demands {
        times: (0..=grid.steps()).step_by(stride).map(|i| grid.time(i)).collect(),
        angles: Angles::All,
        places: slots.iter().map(place).collect(),
        wave: None,
        surface: Surface::Linear,
        base_shear: shear.map(take),
        overturning_moment: below.map(take),
        vertical: vertical.map(take),
        plates: false,
        base: None,
        isolation: None,
        footing: Footing::Fixed,
        sampling: sampling(model, grid.h() * stride as f64, stride),
        states,
        transverse: transverse.map_or_else(Vec::new, |of_y| of_y.states),
    })
}

/// The analysis of a model, and its demands beside it: they share modes and motion alone.
///
/// Errors: a response that is not finite.
pub(super) fn beside<'a>(
    case: &Case,
    model: &'a Model,
    motion: &GroundMotion,
    (options, extent): (&LinearOptions, Extent),
) -> Result<(Analysis<'a>, Demands), FeError> {
    let kept = model.kept(options.wave_modes);
    let (analysis, found) =
        rayon::join(|| analyse_on(model, motion, (options, extent), &Silent), || demands(case, model, &kept, motion));
    Ok((analysis?, found?))
}

/// Adds the part along y of the forces on the base of a box, whose motion along y is that along x of `other`, to its demands.
///
/// Errors: a response that is not finite.
pub(crate) fn across(
    demands: &mut Demands,
    (model, other): (&Model, Option<&Model>),
    motion: &GroundMotion,
    options: &LinearOptions,
) -> Result<(), FeError> {
    let (Some(record), Some(other)) = (&motion.transverse, other) else { return Ok(()) };
    let grid = model.grid(motion, Integrator::Modal)?;
    let stride = stride(model, &grid);
    let kept = [superpose::keep(&other.horizontal.coupled, &other.horizontal.modes, &other.damper, options.wave_modes)];
    let forces =
        [(Channel::BaseShear, &mut demands.base_shear), (Channel::OverturningMoment, &mut demands.overturning_moment)];
    for (channel, terms) in forces {
        let (Some(own), Some(probe)) = (terms.as_ref(), other.horizontal.coupled.probe(channel)) else { continue };
        let found = combine(other, &kept, (record, None), (grid, stride), &[vec![(0, 1.0, probe)]])?;
        let sum = |terms: &Terms, states: &[Vec<f64>]| -> Vec<f64> {
            let value = |k: usize| terms.iter().map(|&(state, factor)| factor * states[state][k]).sum();
            (0..demands.times.len()).map(value).collect()
        };
        let (along, across) = (sum(own, &demands.states), sum(&found.terms[0], &found.states));
        // A state of its own under either record.
        demands.transverse.resize(demands.states.len(), Vec::new());
        *terms = Some(vec![(demands.states.len(), 1.0)]);
        demands.states.push(along);
        demands.transverse.push(across);
    }
    Ok(())
}

/// The observables as combinations of modal states under a horizontal record and the vertical one. Which states they combine does
/// not depend on the records.
///
/// Errors: a response that is not finite.
pub(crate) fn combine(
    model: &Model,
    kept: &[Vec<&CoupledMode>],
    (horizontal, vertical): (&Record, Option<&Record>),
    (grid, stride): (Grid, usize),
    observables: &[Observable<'_>],
) -> Result<Combined, FeError> {
    let systems = model
        .systems()
        .zip(kept)
        .map(|(h, kept)| ModalSystem::new(&h.coupled, kept.clone(), &model.damper))
        .collect::<Result<Vec<ModalSystem>, FeError>>()?;
    let motions = model.motions((horizontal, vertical), &grid);
    let motions: Vec<&Motion> = motions.iter().collect();
    superpose::combine(&systems, &motions, grid, stride, observables)
}

/// A place whose histories are not combined yet.
struct PlaceSlots {
    z: f64,
    course: usize,
    hoop: Slot,
    axial: Slot,
    bending: Option<Slot>,
    /// Shear force per length, and the thickness [m].
    shear: Option<(Slot, f64)>,
    pressure: Option<Slot>,
}

/// Places of a cylinder's wall; none for plane walls.
fn places<'a>(case: &Case, model: &'a Model, wanted: &mut Wanted<'a>) -> Vec<PlaceSlots> {
    let coupled = &model.horizontal.coupled;
    let (Shape::Cylinder { .. }, Some(hoop), Some(axial)) =
        (case.tank.shape, coupled.line(OnWall::Hoop), coupled.line(OnWall::Axial))
    else {
        return Vec::new();
    };
    let (bending, pressure) = (coupled.line(OnWall::Bending), coupled.line(OnWall::Pressure));
    let mut found = Vec::new();
    for (i, &z) in hoop.z.iter().enumerate() {
        let course = course(case, &hoop.z, i);
        let here = [(i, 1.0)];
        let thickness = case.tank.courses[course].thickness;
        found.push(PlaceSlots {
            z,
            course,
            hoop: wanted.on_line(model, hoop, &here),
            axial: wanted.on_line(model, axial, &here),
            bending: bending.map(|line| wanted.on_line(model, line, &here)),
            shear: coupled.shear.as_ref().map(|line| (wanted.on_line(model, line, &here), thickness)),
            pressure: pressure.and_then(|line| Some(wanted.on_line(model, line, &between(&line.z, z)?))),
        });
    }
    found
}

/// The course of place `i`: at a joint the lower place of two belongs to the course below, a place alone to that above.
fn course(case: &Case, z: &[f64], i: usize) -> usize {
    let tolerance = 1e-9 * case.tank.wall_height();
    let same = |j: Option<usize>| j.and_then(|j| z.get(j)).is_some_and(|other| (other - z[i]).abs() < tolerance);
    let courses = case.tank.courses.len();
    let mut top = 0.0;
    for (number, course) in case.tank.courses.iter().enumerate() {
        top += course.height;
        let below = z[i] < top - tolerance;
        let lower_of_two = (z[i] - top).abs() <= tolerance && same(Some(i + 1)) && !same(i.checked_sub(1));
        if below || lower_of_two {
            return number;
        }
    }
    courses - 1
}

/// Height of place `i` of the hoop stress [m]; of the lower of two places at a joint of courses a little below it, as between
/// [`tank::Tank::profile_heights`].
pub(super) fn height(case: &Case, model: &Model, i: usize) -> Option<f64> {
    let heights = &model.horizontal.coupled.line(OnWall::Hoop)?.z;
    let z = *heights.get(i)?;
    let below = course(case, heights, i) < course_above(case, z);
    Some(if below { z - 2e-6 * case.liquid.fill_height } else { z })
}

/// The course at a height, at a joint the upper one.
fn course_above(case: &Case, z: f64) -> usize {
    let mut top = 0.0;
    let courses = case.tank.courses.iter();
    let below = courses.filter(|course| {
        top += course.height;
        top <= z + 1e-9 * case.tank.wall_height()
    });
    below.count().min(case.tank.courses.len() - 1)
}

/// Shares of the neighbours of height `z` in a line by linear interpolation; none above it.
pub(super) fn between(line: &[f64], z: f64) -> Option<Vec<(usize, f64)>> {
    let last = line.len().checked_sub(1)?;
    let tolerance = 1e-9 * line[last].abs().max(1e-9);
    if let Some(same) = line.iter().position(|other| (other - z).abs() <= tolerance) {
        return Some(vec![(same, 1.0)]);
    }
    let upper = line.iter().position(|other| *other > z).filter(|upper| *upper > 0)?;
    let share = (z - line[upper - 1]) / (line[upper] - line[upper - 1]);
    Some(vec![(upper - 1, 1.0 - share), (upper, share)])
}

/// Largest rise of the surface at the wall, between the samples as well.
pub(super) fn wave(analysis: &Analysis<'_>) -> Option<Peak> {
    let rise = |side: Side| {
        let found = analysis.scalars.iter().find(|(s, _)| s.channel == Channel::Wave(side))?;
        let extreme = found.1.extreme;
        Some(Peak { value: extreme.max, time: extreme.max_time, theta: if side == Side::Front { 0.0 } else { PI } })
    };
    let [front, back] = Side::BOTH.map(rise);
    let (front, back) = (front?, back?);
    Some(if front.value >= back.value { front } else { back })
}

/// Sub-steps from one kept instant to the next: of a grid that is finer than the modes need, for the motion of the base, as many are left out
/// as cost a peak [`LOST`].
pub(super) fn stride(model: &Model, grid: &Grid) -> usize {
    let most = 2.0 * (1.0 - LOST).acos() / (model.fastest() * grid.h());
    let fine = if most.is_finite() { most as usize } else { 1 };
    fine.max(grid.steps().div_ceil(MOST_INSTANTS)).max(1)
}

/// What a peak loses that lies half a step from the next instant, 1 − cos(π/n) with n instants in a period.
fn sampling(model: &Model, step: f64, stride: usize) -> f64 {
    let half = 0.5 * model.fastest() * step;
    // n < 20 at every sub-step: the sub-steps do not resolve the mode.
    if stride == 1 && half > PI / 19.9 {
        return UNRESOLVED;
    }
    1.0 - half.min(0.5 * PI).cos()
}

#[cfg(test)]
mod tests;
