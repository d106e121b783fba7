//! Two horizontal components of the ground motion at the same time, on a cylinder and on a box.
//!
//! The tank moves under the component along y as under that along x, turned by 90°: the same harmonic m = 1 with another record,
//!
//! ```text
//! value(θ, t) = even(t) + X(t) cos θ + Y(t) sin θ        largest over θ: even + √(X² + Y²) at tan θ = Y/X
//! ```
//!
//! A box has walls of its own along y: its motion along y is that along x of the box with length and breadth exchanged, turned by 90°. A
//! motion along x is even about the plane y = 0, one along y odd, and so the other way round:
//!
//! ```text
//! middle of a wall         one of the two, the other is 0
//! corner (±, ±)            ± X ± Y        waves, horizontal moments of the walls; every sign is at one of the four corners
//! forces and moments       √(X² + Y²)
//! ```
//!
//! X is the response to a_x, Y that to a_y, even that to the vertical record. The direction of an extreme is that of the sub-step at
//! which it is found; its value is the extreme of the response in that direction, between the sub-steps as well. A direction that
//! turns within a sub-step makes it too small by 0.3 % at most with 20 sub-steps in a period: with half a sub-step ω h/2 ≤ π/20 and
//! an elliptical orbit of axes a > b, Δθ ≤ (b/a) π/20, and 1 − h(θ + Δθ)/h(θ) ≤ (1 − b²/a²) (b²/a²) (π/20)²/2.

mod items;
mod meet;

use std::f64::consts::TAU;

use fem::progress::Silent;
use results::channel::{OnWall, Side};
use results::{Channel, Directional, SeriesInfo};
use tank::case::GroundMotion;
use tank::demand::Peak;
use tank::options::LinearOptions;
use tank::options::linear::Integrator;

pub(crate) use meet::Across;

use super::analysis::Analysis;
use super::demands::combine;
use super::model::Model;
use crate::estimate::MOST_INSTANTS;
use items::{Item, items, on_base, stations};
use meet::{CORNERS, Meet, at_corners, extreme_directions, lines, opposite};

use crate::FeError;
use crate::histories::Histories;
use crate::response::direct::{self, DirectSystem};
use crate::response::motion::Motion;
use crate::response::observe::{Extreme, Observed};
use crate::response::superpose::{self, Combined, ModalSystem, Observable};

/// Extremes of a quantity over time and circumference.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Ends {
    /// Largest value.
    pub max: Peak,
    /// Smallest value.
    pub min: Peak,
    /// Largest absolute value under the motion along y.
    across: f64,
    /// Largest value under the motion along y.
    rise_across: f64,
    /// Largest absolute value and largest value under the motion along x.
    along: (f64, f64),
}

impl Ends {
    /// The one of larger size.
    fn largest(&self) -> Peak {
        if -self.min.value > self.max.value { Peak { value: -self.min.value, ..self.min } } else { self.max }
    }
}

/// What two horizontal components together do.
#[derive(Clone, Debug)]
pub(crate) struct Around {
    columns: Vec<(SeriesInfo, Vec<f64>)>,
    results: Vec<Directional>,
    /// Largest rise of the surface at the wall.
    pub wave: Option<Peak>,
    /// Largest rise of the axial stress at the base [Pa].
    pub axial: Option<Peak>,
    /// Smallest pressure at the places of its line [Pa].
    pub suction: Vec<Peak>,
}

impl Around {
    /// None without a component along y. A box has a model of its own for it, `second`.
    ///
    /// Errors: a response that is not finite.
    pub(crate) fn of(
        model: &Model,
        second: Option<Across<'_>>,
        motion: &GroundMotion,
        options: &LinearOptions,
        analysis: &Analysis<'_>,
    ) -> Result<Option<Around>, FeError> {
        if motion.transverse.is_none() {
            return Ok(None);
        }
        let items = items(model, second);
        let other = second.map_or(model, |second| second.model);
        let directions = directions((model, other), motion, options, analysis, &items)?;
        let mut histories: Vec<(Channel, Observable<'_>)> = items.iter().flat_map(across).collect();
        histories.extend(stations(model));
        let scalars: Vec<Observable<'_>> = histories.iter().map(|(_, o)| o.clone()).collect();
        let mut others = Vec::new();
        for (item, &[max, min]) in items.iter().zip(&directions) {
            others.extend([max, opposite(max), min, opposite(min)].map(|direction| item.towards(direction)));
            others.extend([1.0, -1.0].map(|sign| item.across(sign)));
            others.extend([1.0, -1.0].map(|sign| item.along(sign)));
        }
        let observed = respond((model, other), motion, options, analysis, &scalars, &others)?;
        let ends: Vec<Ends> = (observed.extremes.chunks(8).zip(&directions).zip(&items))
            .map(|((found, directions), item)| ends(found, *directions, item.stretch))
            .collect();
        let wave = of_channel(&items, &ends, Channel::Wave(Side::Front)).map(|e| e.max);
        let corner = items.iter().position(Item::is_corner_wave).map(|i| ends[i].max);
        Ok(Some(Around {
            columns: columns(analysis, &items, &ends, &histories, observed),
            results: results(analysis, &items, &ends),
            wave: corner.or(wave),
            axial: of_channel(&items, &ends, Channel::Base(OnWall::Axial)).map(|e| e.max),
            suction: on_line(&items, &ends, OnWall::Pressure).map(|(_, e)| e.min).collect(),
        }))
    }

    /// Adds the histories along y and the resultants.
    pub(crate) fn add(&self, histories: &mut Histories) {
        for (info, column) in &self.columns {
            histories.push(info.clone(), column.clone());
        }
    }

    /// The extremes for the results.
    pub(crate) fn results(&self) -> Vec<Directional> {
        self.results.clone()
    }

    /// Remarks, one sentence each.
    pub(crate) fn notes(motion: &GroundMotion) -> Vec<String> {
        let Some(across) = &motion.transverse else { return Vec::new() };
        let mut notes = vec![
            "Two horizontal components: values of the comparison are those along x, which the codes assess; resultants of both \
             directions are listed apart, and limit states are checked with both around the circumference."
                .to_owned(),
        ];
        if across.dt != motion.horizontal.dt {
            notes.push(
                "The records differ in their time step: the one along y is linearised within the steps of the analysis."
                    .into(),
            );
        }
        let (x, y) = (motion.horizontal.duration(), across.duration());
        if (x - y).abs() > motion.horizontal.dt {
            notes.push(format!(
                "The record along x ends at {x:.2} s, the one along y at {y:.2} s: after its end a component is zero."
            ));
        }
        notes
    }
}

/// Directions (cos θ, sin θ) of the largest and the smallest value of each quantity, at the instants of the sub-steps.
fn directions(
    (model, other): (&Model, &Model),
    motion: &GroundMotion,
    options: &LinearOptions,
    analysis: &Analysis<'_>,
    items: &[Item<'_>],
) -> Result<Vec<[(f64, f64); 2]>, FeError> {
    let grid = model.grid(motion, Integrator::Modal)?;
    let stride = grid.steps().div_ceil(MOST_INSTANTS).max(1);
    let odd = items.iter().map(|item| vec![(0, 1.0, item.odd)]);
    let turned: Vec<Observable<'_>> = items.iter().map(|item| vec![(0, 1.0, item.across)]).collect();
    let even = items.iter().map(|item| item.even.map_or_else(Vec::new, |e| vec![(1, 1.0, e)]));
    let observables: Vec<Observable<'_>> = odd.chain(even).collect();
    let records = (&motion.horizontal, motion.vertical.as_ref());
    let along = combine(model, &analysis.kept, records, (grid, stride), &observables)?;
    let kept = [superpose::keep(&other.horizontal.coupled, &other.horizontal.modes, &other.damper, options.wave_modes)];
    let across = match &motion.transverse {
        Some(record) => Some(combine(other, &kept, (record, None), (grid, stride), &turned)?),
        None => None,
    };
    let count = grid.steps() / stride + 1;
    let history = |from: Option<&Combined>, number: usize| -> Vec<f64> {
        let mut out = vec![0.0; count];
        let Some(from) = from else { return out };
        for &(state, factor) in &from.terms[number] {
            for (y, s) in out.iter_mut().zip(&from.states[state]) {
                *y += factor * s;
            }
        }
        out
    };
    let found = (0..items.len()).map(|i| {
        let (x, y) = (history(Some(&along), i), history(across.as_ref(), i));
        extreme_directions(items[i].meet, &x, &y, &history(Some(&along), items.len() + i))
    });
    Ok(found.collect())
}

/// The joint response by the integrator of the run.
fn respond(
    (model, other): (&Model, &Model),
    motion: &GroundMotion,
    options: &LinearOptions,
    analysis: &Analysis<'_>,
    scalars: &[Observable<'_>],
    others: &[Observable<'_>],
) -> Result<Observed, FeError> {
    let records = [Some(&motion.horizontal), motion.transverse.as_ref(), motion.vertical.as_ref()];
    let grid = model.grid(motion, options.integrator)?;
    let motions: Vec<Motion> = records.into_iter().flatten().map(|r| Motion::new(r, &grid)).collect();
    let motions: Vec<&Motion> = motions.iter().collect();
    let upwards = model.vertical.as_ref().map(|vertical| (vertical, &model.damper));
    let systems = || {
        let along = [(&model.horizontal, &model.damper), (&other.horizontal, &other.damper)];
        along.into_iter().chain(upwards)
    };
    match options.integrator {
        Integrator::Modal => {
            let turned =
                superpose::keep(&other.horizontal.coupled, &other.horizontal.modes, &other.damper, options.wave_modes);
            let kept = [analysis.kept.first().cloned().unwrap_or_default(), turned];
            let kept = kept.into_iter().chain(analysis.kept.get(1).cloned());
            let systems = systems()
                .zip(kept)
                .map(|((h, damper), kept)| ModalSystem::new(&h.coupled, kept, damper))
                .collect::<Result<Vec<ModalSystem<'_>>, FeError>>()?;
            superpose::respond(&systems, &motions, grid, scalars, others, &Silent)
        }
        Integrator::Newmark => {
            let systems: Vec<DirectSystem<'_>> =
                systems().map(|(h, damper)| DirectSystem::new(&h.coupled, &h.modes, damper)).collect();
            direct::respond(&systems, &motions, grid, scalars, others, &Silent).map(|(observed, _)| observed)
        }
    }
}

/// Extremes from those at both ends of the diameters of the largest and of the smallest value, and at θ = 90° and 270° under the
/// motion along y.
fn ends(found: &[Extreme], [max, min]: [(f64, f64); 2], stretch: [f64; 2]) -> Ends {
    let directions = [max, opposite(max), min, opposite(min)];
    let mut ends = Ends {
        max: Peak::default(),
        min: Peak::default(),
        across: found[4].peak().0.max(found[5].peak().0),
        rise_across: found[4].max.max(found[5].max),
        along: (found[6].peak().0.max(found[7].peak().0), found[6].max.max(found[7].max)),
    };
    for (extreme, (c, s)) in found.iter().zip(directions) {
        let theta = (s * stretch[1]).atan2(c * stretch[0]).rem_euclid(TAU);
        if extreme.max > ends.max.value {
            (ends.max.value, ends.max.time, ends.max.theta) = (extreme.max, extreme.max_time, theta);
        }
        if extreme.min < ends.min.value {
            (ends.min.value, ends.min.time, ends.min.theta) = (extreme.min, extreme.min_time, theta);
        }
    }
    ends
}

fn of_channel(items: &[Item<'_>], ends: &[Ends], channel: Channel) -> Option<Ends> {
    let place = items.iter().position(|item| item.channel == channel)?;
    ends.get(place).copied()
}

/// Places of a line with their extremes.
fn on_line<'a>(items: &'a [Item<'_>], ends: &'a [Ends], of: OnWall) -> impl Iterator<Item = (f64, Ends)> + 'a {
    items.iter().zip(ends).filter_map(move |(item, ends)| match item.channel {
        Channel::Largest { what, z } if what == of => Some((z, *ends)),
        _ => None,
    })
}

/// Histories of the component along y, with their channels.
fn across<'a>(item: &Item<'a>) -> Vec<(Channel, Observable<'a>)> {
    let one = |channel: Channel| vec![(channel, item.across(1.0))];
    let degrees = 90.0;
    match item.channel {
        Channel::Wave(_) => vec![
            (Channel::WaveAround { degrees }, item.across(1.0)),
            (Channel::WaveAround { degrees: 270.0 }, item.across(-1.0)),
        ],
        // At the corners: x and y together.
        Channel::WaveAround { degrees } if item.meet == Meet::Corners => {
            let corners = at_corners(degrees).into_iter().zip(CORNERS);
            corners.map(|(degrees, corner)| (Channel::WaveAround { degrees }, item.towards(corner))).collect()
        }
        Channel::Base(what) => one(Channel::BaseAtAngle { what, degrees }),
        Channel::At { what, z } => one(Channel::AtAngle { what, z, degrees }),
        channel => on_base(channel).map_or_else(Vec::new, |what| one(Channel::Y(what))),
    }
}

/// Histories along y and of resultants with their peaks.
fn columns(
    analysis: &Analysis<'_>,
    items: &[Item<'_>],
    ends: &[Ends],
    across: &[(Channel, Observable<'_>)],
    observed: Observed,
) -> Vec<(SeriesInfo, Vec<f64>)> {
    let along = |channel: Channel| {
        let found = analysis.scalars.iter().find(|(s, _)| s.channel == channel);
        found.map(|(scalar, history)| (scalar.static_value, &history.values))
    };
    let mut columns = Vec::new();
    for ((channel, observable), history) in across.iter().zip(observed.scalars) {
        let static_value = observable.first().map_or(0.0, |(_, _, probe)| probe.static_value);
        let info = SeriesInfo::of(*channel, static_value, history.extreme.peak());
        columns.push((info, history.values));
    }
    let turned = |channel: Channel| columns.iter().find(|(info, _)| info.id == channel.id()).map(|(_, c)| c);
    let mut resultants = Vec::new();
    for (item, ends) in items.iter().zip(ends) {
        let peak = ends.largest();
        if let (Some(what), Some((_, x))) = (on_base(item.channel), along(item.channel)) {
            let y = turned(Channel::Y(what));
            let values = x.iter().zip(y.into_iter().flatten()).map(|(x, y)| x.hypot(*y)).collect();
            let info = SeriesInfo::of(Channel::Resultant(what), 0.0, (peak.value, peak.time));
            resultants.push((info, values));
        }
        if let (Meet::Corners, Channel::WaveAround { degrees }) = (item.meet, item.channel) {
            let corners = at_corners(degrees).map(|degrees| turned(Channel::WaveAround { degrees }));
            let count = corners[0].map_or(0, Vec::len);
            let largest = |k: usize| corners.iter().flatten().map(|c| c[k]).fold(f64::NEG_INFINITY, f64::max);
            let peak = (ends.max.value, ends.max.time);
            let values = (0..count).map(largest).collect();
            resultants.push((SeriesInfo::of(Channel::WaveLargest, 0.0, peak), values));
        }
        let sides = Side::BOTH.map(|side| along(Channel::Wave(side)).map(|(_, values)| values));
        let round = item.meet == Meet::Everywhere;
        if let (true, Channel::Wave(_), [Some(front), Some(back)]) = (round, item.channel, sides) {
            let y = turned(Channel::WaveAround { degrees: 90.0 });
            let value = |((front, back), y): ((&f64, &f64), &f64)| {
                let (even, x) = (0.5 * (front + back), 0.5 * (front - back));
                even + x.hypot(y - even)
            };
            let values = front.iter().zip(back).zip(y.into_iter().flatten()).map(value).collect();
            let peak = (ends.max.value, ends.max.time);
            resultants.push((SeriesInfo::of(Channel::WaveLargest, 0.0, peak), values));
        }
    }
    columns.extend(resultants);
    columns
}

/// Extremes along x, along y and of both, of scalars and of the places where hoop stress and pressure are largest.
fn results(analysis: &Analysis<'_>, items: &[Item<'_>], ends: &[Ends]) -> Vec<Directional> {
    let peak = |(front, back): (Extreme, Extreme)| front.peak().0.max(back.peak().0);
    let mut out = Vec::new();
    for (item, ends) in items.iter().zip(ends) {
        let channel = item.channel;
        if let Channel::Largest { .. } = channel {
            continue;
        }
        if item.is_corner_wave() {
            let title = "Wave height at the corners".to_owned();
            let rises = (ends.along.1, ends.rise_across);
            out.push(directional(("wave_height_corner".into(), title), channel, None, rises, ends.max));
            continue;
        }
        let Some(sides) = analysis.sides(channel) else { continue };
        let (id, title, z, found, (x, y)) = match channel {
            // Only the rise of the wave counts, as in the comparison.
            Channel::Wave(_) => {
                let rises = (analysis.wave().unwrap_or_default(), ends.rise_across);
                let title = "Wave height at the wall".to_owned();
                ("wave_height".into(), title, None, ends.max, rises)
            }
            Channel::At { z, .. } => {
                let both = (peak(sides), ends.across);
                (channel.id(), channel.title(), Some(z), ends.largest(), both)
            }
            _ => {
                let both = (peak(sides), ends.across);
                (channel.id(), channel.title(), None, ends.largest(), both)
            }
        };
        out.push(directional((id, title), channel, z, (x, y), found));
    }
    let boxed = items.iter().any(|item| item.meet == Meet::Corners);
    for what in lines(boxed) {
        let larger = |best: Option<(f64, Ends, f64)>, next: (f64, Ends, f64)| match best {
            Some(best) if best.1.largest().value >= next.1.largest().value => Some(best),
            _ => Some(next),
        };
        let Some(line) = analysis.line(what) else { continue };
        // The rim above the surface at rest is not compared.
        let places = on_line(items, ends, what).take(line.wetted).enumerate();
        let worst = places.map(|(i, (z, ends))| (z, ends, line.peak(i))).fold(None, larger);
        let Some((z, ends, x)) = worst else { continue };
        let names = (what.id().to_owned(), what.title().to_owned());
        let channel = Channel::Largest { what, z };
        out.push(directional(names, channel, Some(z), (x, ends.across), ends.largest()));
    }
    out
}

fn directional(
    (id, title): (String, String),
    channel: Channel,
    z: Option<f64>,
    (x, y): (f64, f64),
    found: Peak,
) -> Directional {
    Directional {
        id,
        title,
        dimension: channel.dimension(),
        z,
        x,
        y,
        resultant: found.value,
        time: found.time,
        theta: found.theta,
    }
}

#[cfg(test)]
mod tests;
