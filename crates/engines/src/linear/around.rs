//! Two horizontal components of the ground motion at the same time on a cylinder.
//!
//! The tank moves under the component along y as under that along x, turned by 90°: the same harmonic m = 1 with another record,
//!
//! ```text
//! value(θ, t) = even(t) + X(t) cos θ + Y(t) sin θ        largest over θ: even + √(X² + Y²) at tan θ = Y/X
//! ```
//!
//! X is the response to a_x, Y that to a_y, even that to the vertical record. The direction of an extreme is that of the sub-step at
//! which it is found; its value is the extreme of the response in that direction, between the sub-steps as well. A direction that
//! turns within a sub-step makes it too small by 0.3 % at most with 20 sub-steps in a period: with half a sub-step ω h/2 ≤ π/20 and
//! an elliptical orbit of axes a > b, Δθ ≤ (b/a) π/20, and 1 − h(θ + Δθ)/h(θ) ≤ (1 − b²/a²) (b²/a²) (π/20)²/2.

use std::f64::consts::TAU;

use fem::progress::Silent;
use results::channel::{OnBase, OnWall, Side};
use results::{Channel, Directional, SeriesInfo};
use tank::case::GroundMotion;
use tank::demand::Peak;
use tank::options::LinearOptions;
use tank::options::linear::Integrator;

use super::analysis::Analysis;
use super::demands::{MOST_INSTANTS, combine};
use super::model::{Harmonic, Model};
use crate::FeError;
use crate::histories::Histories;
use crate::probe::Probe;
use crate::response::direct::{self, DirectSystem};
use crate::response::motion::Motion;
use crate::response::observe::{Extreme, Observed};
use crate::response::superpose::{self, Combined, ModalSystem, Observable};

/// Numbers of the systems of the joint response: m = 1 along x, m = 1 along y, m = 0.
const ALONG: usize = 0;
const ACROSS: usize = 1;
const UPWARDS: usize = 2;

/// A quantity that goes around the tank.
#[derive(Clone, Copy)]
struct Item<'a> {
    channel: Channel,
    odd: &'a Probe,
    even: Option<&'a Probe>,
}

impl<'a> Item<'a> {
    /// The response in the direction (c, s).
    fn towards(&self, (c, s): (f64, f64)) -> Observable<'a> {
        let mut terms = vec![(ALONG, c, self.odd), (ACROSS, s, self.odd)];
        terms.extend(self.even.map(|even| (UPWARDS, 1.0, even)));
        terms
    }

    /// The response to the component along y at θ = 90° (or 270°).
    fn across(&self, sign: f64) -> Observable<'a> {
        let mut terms = vec![(ACROSS, sign, self.odd)];
        terms.extend(self.even.map(|even| (UPWARDS, 1.0, even)));
        terms
    }
}

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
}

impl Ends {
    /// The one of larger size.
    fn largest(&self) -> Peak {
        match -self.min.value > self.max.value {
            true => Peak {
                value: -self.min.value,
                ..self.min
            },
            false => self.max,
        }
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
    /// None without a component along y.
    ///
    /// Errors: a response that is not finite.
    pub(crate) fn of(
        model: &Model,
        motion: &GroundMotion,
        options: &LinearOptions,
        analysis: &Analysis<'_>,
    ) -> Result<Option<Around>, FeError> {
        if motion.transverse.is_none() {
            return Ok(None);
        }
        let items = items(model);
        let directions = directions(model, motion, analysis, &items)?;
        let histories: Vec<(Channel, Observable<'_>)> = items.iter().flat_map(across).collect();
        let scalars: Vec<Observable<'_>> = histories.iter().map(|(_, o)| o.clone()).collect();
        let mut others = Vec::new();
        for (item, &[max, min]) in items.iter().zip(&directions) {
            others.extend([max, opposite(max), min, opposite(min)].map(|direction| item.towards(direction)));
            others.extend([1.0, -1.0].map(|sign| item.across(sign)));
        }
        let observed = respond(model, motion, options, analysis, &scalars, &others)?;
        let ends: Vec<Ends> = (observed.extremes.chunks(6).zip(&directions))
            .map(|(found, directions)| ends(found, *directions))
            .collect();
        Ok(Some(Around {
            columns: columns(analysis, &items, &ends, &histories, observed),
            results: results(analysis, &items, &ends),
            wave: of_channel(&items, &ends, Channel::Wave(Side::Front)).map(|e| e.max),
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
        let Some(across) = &motion.transverse else {
            return Vec::new();
        };
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

/// Everything that is observed: scalars but for the gauges, which lie along x, hoop stress and pressure over the height.
fn items(model: &Model) -> Vec<Item<'_>> {
    let coupled = &model.horizontal.coupled;
    let gauge = |probe: &&Probe| !matches!(probe.channel, Channel::WaveAt { .. });
    let even = |probe: &Probe| {
        let of = |v: &'_ Harmonic| v.coupled.probes.iter().position(|p| p.channel == probe.channel);
        let vertical = model.vertical.as_ref()?;
        Some(&vertical.coupled.probes[of(vertical)?])
    };
    let mut all: Vec<Item<'_>> = (coupled.probes.iter().filter(gauge))
        .map(|odd| Item {
            channel: odd.channel,
            odd,
            even: even(odd),
        })
        .collect();
    for what in [OnWall::Hoop, OnWall::Pressure] {
        let Some(line) = coupled.line(what) else { continue };
        let upwards = model.vertical.as_ref().and_then(|v| v.coupled.line(what));
        let upwards = upwards.filter(|same| same.z == line.z);
        for (i, (odd, &z)) in line.probes.iter().zip(&line.z).enumerate() {
            all.push(Item {
                channel: Channel::Largest { what, z },
                odd,
                even: upwards.map(|same| &same.probes[i]),
            });
        }
    }
    all
}

/// Directions (cos θ, sin θ) of the largest and the smallest value of each quantity, at the instants of the sub-steps.
fn directions(
    model: &Model,
    motion: &GroundMotion,
    analysis: &Analysis<'_>,
    items: &[Item<'_>],
) -> Result<Vec<[(f64, f64); 2]>, FeError> {
    let grid = model.grid(motion, Integrator::Modal)?;
    let stride = grid.steps().div_ceil(MOST_INSTANTS).max(1);
    let odd = items.iter().map(|item| vec![(0, 1.0, item.odd)]);
    let even = items
        .iter()
        .map(|item| item.even.map_or_else(Vec::new, |e| vec![(1, 1.0, e)]));
    let observables: Vec<Observable<'_>> = odd.chain(even).collect();
    let of = |record| {
        let records = (record, motion.vertical.as_ref());
        combine(model, analysis, records, (grid, stride), &observables)
    };
    let (along, across) = (of(&motion.horizontal)?, motion.transverse.as_ref().map(of).transpose()?);
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
        extreme_directions(&x, &y, &history(Some(&along), items.len() + i))
    });
    Ok(found.collect())
}

/// Where even + X cos θ + Y sin θ is largest and smallest over time and θ.
fn extreme_directions(x: &[f64], y: &[f64], even: &[f64]) -> [(f64, f64); 2] {
    let (mut highest, mut lowest) = (f64::NEG_INFINITY, f64::INFINITY);
    let mut directions = [(1.0, 0.0), (-1.0, 0.0)];
    for ((&x, &y), &even) in x.iter().zip(y).zip(even) {
        let size = x.hypot(y);
        if size == 0.0 {
            continue;
        }
        let towards = (x / size, y / size);
        if even + size > highest {
            (highest, directions[0]) = (even + size, towards);
        }
        if even - size < lowest {
            (lowest, directions[1]) = (even - size, (-towards.0, -towards.1));
        }
    }
    directions
}

/// The joint response by the integrator of the run.
fn respond(
    model: &Model,
    motion: &GroundMotion,
    options: &LinearOptions,
    analysis: &Analysis<'_>,
    scalars: &[Observable<'_>],
    others: &[Observable<'_>],
) -> Result<Observed, FeError> {
    let records = [
        Some(&motion.horizontal),
        motion.transverse.as_ref(),
        motion.vertical.as_ref(),
    ];
    let grid = model.grid(motion, options.integrator)?;
    let motions: Vec<Motion> = records.into_iter().flatten().map(|r| Motion::new(r, &grid)).collect();
    let motions: Vec<&Motion> = motions.iter().collect();
    let systems = || std::iter::once((0, &model.horizontal)).chain(model.systems().enumerate());
    match options.integrator {
        Integrator::Modal => {
            let systems = systems()
                .map(|(number, h)| ModalSystem::new(&h.coupled, analysis.kept[number].clone(), &model.damper))
                .collect::<Result<Vec<ModalSystem<'_>>, FeError>>()?;
            superpose::respond(&systems, &motions, grid, scalars, others, &Silent)
        }
        Integrator::Newmark => {
            let systems: Vec<DirectSystem<'_>> = systems()
                .map(|(_, h)| DirectSystem::new(&h.coupled, &h.modes, &model.damper))
                .collect();
            direct::respond(&systems, &motions, grid, scalars, others, &Silent).map(|(observed, _)| observed)
        }
    }
}

/// The other end of a diameter.
fn opposite((c, s): (f64, f64)) -> (f64, f64) {
    (-c, -s)
}

/// Extremes from those at both ends of the diameters of the largest and of the smallest value, and at θ = 90° and 270° under the
/// motion along y.
fn ends(found: &[Extreme], [max, min]: [(f64, f64); 2]) -> Ends {
    let directions = [max, opposite(max), min, opposite(min)];
    let mut ends = Ends {
        max: Peak::default(),
        min: Peak::default(),
        across: found[4].peak().0.max(found[5].peak().0),
        rise_across: found[4].max.max(found[5].max),
    };
    for (extreme, (c, s)) in found.iter().zip(directions) {
        let theta = s.atan2(c).rem_euclid(TAU);
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
    items
        .iter()
        .zip(ends)
        .filter_map(move |(item, ends)| match item.channel {
            Channel::Largest { what, z } if what == of => Some((z, *ends)),
            _ => None,
        })
}

/// The force or moment on the base of a channel.
fn on_base(channel: Channel) -> Option<OnBase> {
    OnBase::ALL.into_iter().find(|what| what.along() == channel)
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
            let values = x
                .iter()
                .zip(y.into_iter().flatten())
                .map(|(x, y)| x.hypot(*y))
                .collect();
            let info = SeriesInfo::of(Channel::Resultant(what), 0.0, (peak.value, peak.time));
            resultants.push((info, values));
        }
        let sides = Side::BOTH.map(|side| along(Channel::Wave(side)).map(|(_, values)| values));
        if let (Channel::Wave(_), [Some(front), Some(back)]) = (item.channel, sides) {
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
        let Some(sides) = analysis.sides(channel) else { continue };
        let (id, title, z, found, (x, y)) = match channel {
            // Of the wave only the rise counts, as in the comparison.
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
    for what in [OnWall::Hoop, OnWall::Pressure] {
        let larger = |best: Option<(f64, Ends, f64)>, next: (f64, Ends, f64)| match best {
            Some(best) if best.1.largest().value >= next.1.largest().value => Some(best),
            _ => Some(next),
        };
        let Some(line) = analysis.line(what) else { continue };
        let places = on_line(items, ends, what).enumerate();
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
