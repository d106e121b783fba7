//! One run of both walls, and everything the results folder holds of it.

use std::collections::BTreeMap;

use fem::progress::Progress;
use tank::Shape;
use tank::case::GroundMotion;
use tank::demand::{Demands, Peak, Surface};
use tank::{Case, Quantity};

use super::case::Strip;
use super::history::{Scalar, WallHistory};
use super::modes::{damping_table, modes};
use super::walls::Walls;
use crate::checkpoint::CheckpointFile;
use crate::checks::checked_motion;
use crate::histories::Histories;
use crate::impulsive::{Impulsive, Member};
use crate::modes::Kind;
use crate::nonlinear::extremes::of_maps;
use crate::{FeError, Simulation};
use results::channel::{OnWall, Side};
use results::nonlinear::{At, Nonlinear, TwoSided};
use results::{Channel, EngineId, Mode, Run, SeriesInfo};
use tank::options::nonlinear::{Damping, NonlinearOptions};

/// Time history of a strip.
///
/// * `states`: time between states for pictures [s]; none keeps none
///
/// Errors: as [`Strip::new`]; an invalid record; a checkpoint that cannot be written or belongs to another run; interrupted
/// before the first step of a wall.
pub(crate) fn simulate(
    case: &Case,
    options: &NonlinearOptions,
    (states, checkpoint): (Option<f64>, Option<&CheckpointFile>),
    progress: &dyn Progress,
) -> Result<Simulation, FeError> {
    let motion = checked_motion(case)?;
    let mut strip = Strip::new(case, options)?;
    strip.quake.states = states;
    let breadth = match case.tank.shape {
        Shape::Rectangle { breadth, .. } => breadth,
        Shape::Cylinder { .. } => 1.0,
    };
    let files = Side::BOTH.map(|side| checkpoint.map(|c| c.wall(side, options.checkpoint)));
    let runs = strip.model.histories(&strip.quake, files, progress)?;
    let samples = runs.iter().map(|r| r.history.samples.len()).min().unwrap_or(0);
    let walls = Walls { case, model: &strip.model, runs: &runs, breadth, samples };
    if walls.interrupted() && samples == 0 {
        return Err(FeError::Interrupted { stage: "the nonlinear run".into() });
    }
    Ok(Report { case, options, motion, strip: &strip, walls }.simulation())
}

/// A history of the tank or of a wall, with its static value.
struct Line {
    channel: Channel,
    title: String,
    rest: f64,
    times: Vec<f64>,
    values: Vec<f64>,
}

impl Line {
    /// Largest and smallest change from the static value, with their times.
    fn extremes(&self) -> [(f64, f64); 2] {
        let mut out = [(0.0, 0.0); 2];
        for (v, &t) in self.values.iter().zip(&self.times) {
            let change = v - self.rest;
            if change > out[0].0 {
                out[0] = (change, t);
            }
            if change < out[1].0 {
                out[1] = (change, t);
            }
        }
        out
    }

    fn peak(&self) -> (f64, f64) {
        let [most, least] = self.extremes();
        if most.0 >= -least.0 { most } else { (-least.0, least.1) }
    }
}

/// Everything that is reported of a run.
pub(super) struct Report<'a> {
    pub case: &'a Case,
    pub options: &'a NonlinearOptions,
    pub motion: &'a GroundMotion,
    pub strip: &'a Strip,
    pub walls: Walls<'a>,
}

impl Report<'_> {
    fn simulation(self) -> Simulation {
        let model = &self.strip.model;
        let modes = modes(model.closed(), self.walls.breadth);
        let lines = self.lines();
        let values = self.values(&modes, &lines);
        let histories = self.histories(&lines);
        let wave = values.get(&Quantity::SloshingHeight).copied().unwrap_or(0.0);
        let result = Run {
            end: self.walls.end(),
            events: self.walls.events(),
            mesh: self.mesh(),
            integration: self.integration(),
            damping_table: match self.options.damping {
                Damping::ByGroup { .. } => Vec::new(),
                _ => damping_table(model.closed()),
            },
            modes,
            mass_balance: self.mass_balance(),
            envelopes: self.envelopes(),
            record_end: self.strip.span.record_end(),
            histories: histories.info,
            limits: self.strip.limits(wave, self.suction()),
            nonlinear: Some(self.nonlinear(&lines)),
            incomplete: self.walls.interrupted(),
            ..Run::new(EngineId::Nonlinear)
        };
        Simulation {
            values,
            result,
            series: histories.series,
            assumptions: self.strip.assumptions.clone(),
            notes: self.notes(),
            snapshots: self.walls.snapshots(),
            demands: Some(demands(&lines)),
            units: None,
            of_modes: None,
            second: None,
            slab_motion: None,
        }
    }

    fn nonlinear(&self, lines: &[Line]) -> Nonlinear {
        let mut found = self.walls.nonlinear();
        let of = |line: &Line| {
            let [(max, max_time), (min, min_time)] = line.extremes();
            let at = |value, time| At { value, time: Some(time) };
            TwoSided {
                title: line.title.clone(),
                dimension: line.channel.dimension(),
                rest: line.rest,
                min: (!matches!(line.channel, Channel::OpenOn(_))).then(|| at(min, min_time)),
                max: at(max, max_time),
            }
        };
        found.extremes = lines.iter().map(of).collect();
        found.extremes.extend(of_maps(&found.maps, &found.grid));
        found
    }

    fn wall_line(&self, side: Side, scalar: Scalar, channel: Channel) -> Line {
        let history = &self.walls.runs[side as usize].history;
        Line {
            channel,
            title: channel.title(),
            rest: history.at_rest(scalar),
            times: history.times.clone(),
            values: history.scalar(scalar).to_vec(),
        }
    }

    /// Histories of the tank and of both walls.
    fn lines(&self) -> Vec<Line> {
        let mut lines = Vec::new();
        for side in Side::BOTH {
            lines.push(self.wall_line(side, Scalar::Elevation, Channel::Wave(side)));
        }
        let shear = self.tank_line(|h| h.scalar(Scalar::Shear).to_vec());
        let moment = self.tank_line(|h| h.scalar(Scalar::Moment).to_vec());
        let below = self.tank_line(|h| {
            let (wall, bottom) = (h.scalar(Scalar::Moment), h.scalar(Scalar::BottomMoment));
            wall.iter().zip(bottom).map(|(a, b)| a + b).collect()
        });
        for (channel, (times, values)) in
            [(Channel::BaseShear, shear), (Channel::BaseMoment, moment), (Channel::OverturningMoment, below)]
        {
            lines.push(Line { channel, title: channel.title(), rest: 0.0, times, values });
        }
        type OnSide = fn(Side) -> Channel;
        let walls: [(Scalar, OnSide, &str); 4] = [
            (Scalar::Deflection, Channel::Deflection, "Deflection of the top of the wall"),
            (Scalar::Shear, |side| Channel::BaseOn(OnWall::Shear, side), "Shear force at the base of the wall"),
            (Scalar::Moment, |side| Channel::BaseOn(OnWall::Moment, side), "Bending moment of the wall at the base"),
            (Scalar::SectionMoment, Channel::SectionMoment, "Bending moment of the lowest section of the wall"),
        ];
        for (scalar, channel, title) in walls {
            for (side, angle) in Side::BOTH.into_iter().zip([0, 180]) {
                lines.push(Line {
                    // Strips have no meridians.
                    title: format!("{title}, θ = {angle}°"),
                    ..self.wall_line(side, scalar, channel(side))
                });
            }
        }
        for (run, side) in self.walls.runs.iter().zip(Side::BOTH) {
            let Some(openings) = &run.history.openings else { continue };
            let depth = self.case.liquid.fill_height;
            lines.push(Line {
                channel: Channel::OpenOn(side),
                title: Channel::OpenOn(side).title(),
                rest: 0.0,
                times: run.history.times.clone(),
                values: openings.open().iter().map(|length| length / depth).collect(),
            });
        }
        lines
    }

    /// b (f(wall at +L) − f(wall at −L)): the second wall is the mirror image. Where one wall cut its steps, the other is
    /// linear between its own.
    fn tank_line(&self, of: impl Fn(&WallHistory) -> Vec<f64>) -> (Vec<f64>, Vec<f64>) {
        let [a, b] = self.walls.runs.each_ref().map(|r| &r.history);
        let (first, second) = (of(a), of(b));
        let end = self.walls.time();
        let mut times: Vec<f64> = a.times.iter().chain(&b.times).copied().filter(|t| *t <= end).collect();
        times.sort_by(f64::total_cmp);
        times.dedup();
        let (mut i, mut j) = (0, 0);
        let values = times
            .iter()
            .map(|&t| {
                let change = value_at(&a.times, &first, t, &mut i) - value_at(&b.times, &second, t, &mut j);
                self.walls.breadth * change
            })
            .collect();
        (times, values)
    }

    fn values(&self, modes: &[Mode], lines: &[Line]) -> BTreeMap<Quantity, f64> {
        let mut values = BTreeMap::new();
        let first = |kind: Kind| modes.iter().find(|m| m.kind == kind.id() && m.number == 1);
        if let Some(mode) = first(Kind::Sloshing) {
            values.insert(Quantity::SloshingPeriod, mode.period);
            values.insert(Quantity::ConvectiveMass, mode.effective_mass);
        }
        let structural = modes.iter().filter(|m| m.kind == Kind::Structural.id());
        let impulsive =
            Impulsive::of(structural.map(|m| Member { number: m.number, omega: m.omega, mass: m.effective_mass }));
        if let Some(impulsive) = impulsive {
            values.insert(Quantity::ImpulsivePeriod, impulsive.period());
            values.insert(Quantity::ImpulsiveMass, impulsive.mass());
        }
        let rises = lines.iter().filter(|l| l.channel.is_wave());
        values.insert(Quantity::SloshingHeight, rises.map(|l| l.extremes()[0].0).fold(0.0, f64::max));
        for channel in [Channel::BaseShear, Channel::BaseMoment, Channel::OverturningMoment] {
            let line = lines.iter().find(|l| l.channel == channel);
            if let (Some(line), Some(quantity)) = (line, channel.quantity()) {
                values.insert(quantity, line.peak().0);
            }
        }
        values
    }

    /// All histories at the samples that both walls have.
    fn histories(&self, lines: &[Line]) -> Histories {
        let history = &self.walls.runs[0].history;
        let samples = history.samples.iter().take(self.walls.samples);
        let mut histories = Histories::at(samples.map(|&i| history.times[i]).collect());
        if !histories.series.time.is_empty() {
            histories.push_ground(self.motion);
        }
        for line in lines {
            let mut at = 0;
            let times = histories.series.time.iter();
            let column = times.map(|&t| value_at(&line.times, &line.values, t, &mut at) - line.rest);
            let column = column.collect();
            let info = SeriesInfo { title: line.title.clone(), ..SeriesInfo::of(line.channel, line.rest, line.peak()) };
            histories.push(info, column);
        }
        histories
    }
}

/// Wave and base reactions; the resistance of plane walls is not implemented.
fn demands(lines: &[Line]) -> Demands {
    let rise = |(side, theta): (Side, f64)| {
        let line = lines.iter().find(|l| l.channel == Channel::Wave(side))?;
        let [(value, time), _] = line.extremes();
        Some(Peak { value, time, theta })
    };
    let rises = Side::BOTH.into_iter().zip([0.0, std::f64::consts::PI]).filter_map(rise);
    let of = |channel| lines.iter().find(|l| l.channel == channel);
    let shear = of(Channel::BaseShear);
    let below = of(Channel::OverturningMoment).filter(|below| shear.is_some_and(|shear| shear.times == below.times));
    Demands {
        times: shear.map(|l| l.times.clone()).unwrap_or_default(),
        states: shear.into_iter().chain(below).map(|l| l.values.clone()).collect(),
        base_shear: shear.map(|_| vec![(0, 1.0)]),
        overturning_moment: below.map(|_| vec![(1, 1.0)]),
        wave: rises.reduce(|a, b| if b.value > a.value { b } else { a }),
        surface: Surface::Linear,
        ..Demands::default()
    }
}

/// Value at the time `t` of a history that is linear between its `times`; `at` is where the last search ended.
fn value_at(times: &[f64], values: &[f64], t: f64, at: &mut usize) -> f64 {
    while *at + 1 < times.len() && times[*at + 1] <= t {
        *at += 1;
    }
    let i = *at;
    match (times.get(i), times.get(i + 1)) {
        (Some(&a), Some(&b)) if t > a => values[i] + (t - a) / (b - a) * (values[i + 1] - values[i]),
        (Some(_), _) => values[i],
        (None, _) => 0.0,
    }
}
