//! The nonlinear liquid beside the linear response of the elastic tank.
//!
//! The liquid is potential flow of third order in the rigid tank ([`fem::liquid::large_wave`]). What it adds to a linear liquid in
//! the same rigid tank is added to the linear response of the elastic one:
//!
//! ```text
//! Q(t) = Q_linear(t) + [Q_3(t) − Q_1(t)]        without the horizontal acceleration, whose part the elastic wall has
//! ```
//!
//! A mode of wall and liquid has a hundredth of the period of a wave, so that the wall does not feel which liquid it carries.

use std::collections::BTreeMap;
use std::f64::consts::TAU;

use fem::liquid::large_wave::{
    BREAKING, Basis, Energy, Forces, Liquid, Motion, Properties, Reason, Run, Sampled, Side, Stop, run,
};
use oscillator::record::Record;
use results::channel::Side as WallSide;
use results::part::{Amount, Axis, Block, Chart, Form, Line, Look, Message, Room, Scale, Table};
use results::{Channel, Finding, Part};
use tank::case::GroundMotion;
use tank::demand::{Demands, Peak, Surface};
use tank::large_wave::LargeWave;
use tank::options::linear::LiquidModel;
use tank::units::Dimension;
use tank::{Case, Quantity, Shape};

use super::turned::angles;
use crate::Simulation;

/// Id of the part.
const PART: &str = "large_wave";
/// Radial modes of each harmonic of a cylinder, and modes of a strip.
const RADIAL: usize = 4;
const ALONG: usize = 16;
/// Places around the circumference.
const PLACES: usize = 24;
/// Difference from which the wave in a rigid tank that follows the ground is another than that of the engine, whose base may rock.
const OTHER: f64 = 0.1;
/// Most points of a line of the chart.
const MOST_POINTS: usize = 400;
/// First periods before and after the crest that the chart shows.
const AROUND: f64 = 4.0;

/// A linear run whose waves may not be small.
pub(crate) struct Held<'a> {
    /// Time between two samples of the histories [s].
    pub step: f64,
    /// Histories along x by channel.
    pub columns: Vec<(Channel, &'a [f64])>,
    /// Largest wave, of both components where there are two [m].
    pub wave: f64,
}

/// A nonlinear run beside a linear one.
pub(crate) struct Beside {
    /// Its part of the results.
    pub part: Part,
    /// Where the freeboard is judged by this run: its crest around the circumference, and its trough [m].
    pub judged: Option<(Peak, f64)>,
    /// Whether both are lower bounds.
    bound: bool,
}

impl Beside {
    /// The crest of the nonlinear liquid to what limit states see, where it is the one that counts.
    pub(crate) fn demands(&self, demands: &mut Demands) {
        if let (Some((crest, _)), Some(wave)) = (self.judged, &mut demands.wave) {
            *wave = crest;
            demands.surface = if self.bound { Surface::Stopped } else { Surface::Nonlinear };
        }
    }
}

/// Crest and trough of the nonlinear liquid to the values of a run where they count; forces and moments only where it is asked for.
pub(crate) fn put(asked: LiquidModel, simulation: &mut Simulation) {
    let counts = simulation.demands.as_ref().is_some_and(|demands| demands.surface != Surface::Linear);
    let Some(part) = simulation.result.part(PART).filter(|_| counts) else { return };
    let found = part.values().filter_map(|found| Some((Quantity::from_id(&found.id)?, found.value.value)));
    let waves = [Quantity::SloshingCrest, Quantity::SloshingTrough];
    let all = asked == LiquidModel::Nonlinear;
    let own: BTreeMap<Quantity, f64> = found.filter(|(quantity, _)| all || waves.contains(quantity)).collect();
    simulation.values.extend(own);
}

/// The nonlinear liquid under the motion that the tank feels, with the rotation of its base: where the options ask for it, or the linear wave of a run that is reported is not small.
/// It counts where it is asked for, where its wave breaks, and where the factor of the crest is
/// no longer exact.
pub(crate) fn beside(
    case: &Case,
    (asked, reported): (LiquidModel, bool),
    motion: (&GroundMotion, Option<&Record>),
    held: &Held<'_>,
) -> Option<Beside> {
    let large = LargeWave::of(case);
    let all = asked == LiquidModel::Nonlinear;
    let count = held.columns.iter().map(|(_, column)| column.len()).max().unwrap_or(0);
    if count < 2 || !(all || (reported && held.wave > large.small())) {
        return None;
    }
    let duration = (count - 1) as f64 * held.step;
    let basis = basis(case, motion.0.transverse.is_some());
    let marched = |order| Marched::new(case, basis.clone(), (motion, duration), order);
    let (linear, nonlinear) = rayon::join(|| marched(1), || marched(3));
    let breaks = nonlinear.run.stop.is_some() || nonlinear.run.breaks.is_some();
    let counts = all || breaks || large.excess(held.wave) > large.fitted();
    let found = Found { case, asked, held, large, counts, linear, nonlinear };
    let alone = found.linear.highest(&found.linear.around().unwrap_or_else(|| found.sides()));
    Some(if (alone / held.wave - 1.0).abs() > OTHER { found.left_out(alone) } else { found.beside() })
}

/// The modes of a tank's plan; `across`: whether it is shaken along y as well.
fn basis(case: &Case, across: bool) -> Basis {
    match case.tank.shape {
        Shape::Cylinder { radius } => Basis::cylinder(radius, RADIAL, if across { Side::Both } else { Side::Cosine }),
        Shape::Rectangle { length, breadth, .. } => Basis::strip(length, breadth, ALONG),
    }
}

/// The motion without its horizontal acceleration and rotation.
fn without_horizontal(motion: Motion) -> Motion {
    Motion { vertical: motion.vertical, ..Motion::default() }
}

/// The components at the step of the record along x, for a duration [s].
fn sampled((motion, rotation): (&GroundMotion, Option<&Record>), duration: f64) -> Sampled {
    let step = motion.horizontal.dt;
    // After the record the ground is at rest, but the base may keep its rotation.
    let end = if rotation.is_some() { duration } else { motion.duration() };
    let count = (end / step).ceil() as usize + 1;
    let at = |record: Option<&Record>, time: f64| record.map_or(0.0, |r| between(&r.acceleration, time / r.dt));
    let angles = rotation.map_or_else(Vec::new, |r| angles(r.dt, r.acceleration.windows(2).map(|w| (w[0], w[1]))));
    // The base keeps the rotation that it has when the record ends.
    let last = angles.len().saturating_sub(1) as f64;
    let samples = (0..count).map(|i| {
        let time = i as f64 * step;
        let tilt = rotation.map_or(0.0, |r| between(&angles, (time / r.dt).min(last)));
        Motion {
            acceleration: [at(Some(&motion.horizontal), time), at(motion.transverse.as_ref(), time)],
            vertical: at(motion.vertical.as_ref(), time),
            tilt: [tilt, 0.0],
            angular: [at(rotation, time), 0.0],
        }
    });
    Sampled::new(step, samples.collect())
}

/// The value at a place among samples, linear between them, zero after the last.
fn between(samples: &[f64], place: f64) -> f64 {
    let first = place.floor() as usize;
    let value = |i: usize| samples.get(i).copied().unwrap_or(0.0);
    value(first) + (place - first as f64) * (value(first + 1) - value(first))
}

/// A march with its forces.
struct Marched {
    liquid: Liquid,
    run: Run,
    forces: Vec<Forces>,
}

struct Found<'a> {
    case: &'a Case,
    asked: LiquidModel,
    held: &'a Held<'a>,
    large: LargeWave,
    /// Whether the crest of this run is the one that counts.
    counts: bool,
    linear: Marched,
    nonlinear: Marched,
}

/// A history, its quantity, and the part of the forces that it is.
type Resultant = (Channel, Quantity, fn(&Forces) -> f64);

/// Horizontal force and moments of the engine, which are those of the base on the tank, with the force of the liquid that has them.
const RESULTANTS: [Resultant; 3] = [
    (Channel::BaseShear, Quantity::BaseShear, |f| -f.shear[0]),
    (Channel::BaseMoment, Quantity::BaseMoment, |f| -f.wall_moment[0]),
    (Channel::OverturningMoment, Quantity::OverturningMoment, |f| -f.moment[0]),
];

impl Found<'_> {
    fn beside(&self) -> Beside {
        let sides = self.sides();
        let run = &self.nonlinear.run;
        let bound = run.stop.is_some() || run.breaks.is_some();
        let [rise, fall] = self.linear.extremes(&sides);
        let [crest, trough] = self.nonlinear.extremes(&sides);
        let mut rows = vec![
            self.finding(Quantity::SloshingCrest, crest, rise.value, self.large.crest(rise.value)),
            self.finding(Quantity::SloshingTrough, trough, fall.value, self.large.trough(fall.value)),
        ];
        let around = self.nonlinear.around().map(|places| self.nonlinear.extremes(&places));
        if let Some([around, _]) = around {
            let linear = self.linear.around().map_or(rise, |places| self.linear.extremes(&places)[0]);
            let degrees = Some(around.theta.to_degrees());
            let own = Finding::new("crest_around", around.value, Dimension::Length);
            rows.push(Finding { time: Some(around.time), degrees, held: Some(linear.value), ..own });
        }
        for (channel, quantity, force) in RESULTANTS {
            let Some((_, own)) = self.held.columns.iter().find(|(id, _)| *id == channel) else { continue };
            let (peak, linear) = self.peaks(own, force);
            rows.push(self.finding(quantity, peak, linear, linear));
        }
        let mut blocks = vec![Block::Text(self.about())];
        let breaks = run.breaks.map(|time| {
            let slope = Amount::ratio(BREAKING).form(Form::Given);
            Message::new("large_wave-breaking").with("time", Amount::new(time, Dimension::Time)).with("slope", slope)
        });
        blocks.extend(breaks.map(Block::Text));
        blocks.extend(run.stop.map(|stop| Block::Text(stopped(stop))));
        blocks.push(Block::values("values", rows));
        blocks.push(Block::Note(Message::new("large_wave-model")));
        blocks.push(Block::Chart(self.chart(crest.time)));
        blocks.push(Block::Table(self.energy()));
        blocks.push(Block::Note(self.balance()));
        let [highest, deepest] = around.unwrap_or([crest, trough]);
        // A run that stopped may end before the largest wave.
        let least = if bound { self.large.crest(self.held.wave) } else { 0.0 };
        let judged = self.counts.then(|| (Peak { value: highest.value.max(least), ..highest }, deepest.value));
        Beside { part: Part { id: PART.into(), blocks }, judged, bound }
    }

    /// Places at θ = 0 and 180°.
    fn sides(&self) -> Vec<[f64; 2]> {
        let half = self.case.tank.shape.half_length();
        vec![[half, 0.0], [-half, 0.0]]
    }

    /// What is left of a run whose linear wave `alone` [m] is not that of the engine.
    fn left_out(&self, alone: f64) -> Beside {
        let about = Message::new("large_wave-other")
            .with("wave", Amount::new(self.held.wave, Dimension::Length))
            .with("alone", Amount::new(alone, Dimension::Length));
        Beside { part: Part { id: PART.into(), blocks: vec![Block::Text(about)] }, judged: None, bound: false }
    }

    /// A value beside that of the linear liquid. Of a run that stopped it is at least `least`, what is known without it.
    fn finding(&self, quantity: Quantity, peak: Peak, linear: f64, least: f64) -> Finding {
        let short = self.nonlinear.run.stop.is_some() && least > peak.value;
        let (value, time) = if short { (least, None) } else { (peak.value, Some(peak.time)) };
        Finding { time, held: Some(linear), ..Finding::new(quantity.id(), value, quantity.dimension()) }
    }

    /// Largest value of a force with the nonlinear liquid, until the march stopped, and with the linear one, until the end.
    fn peaks(&self, linear: &[f64], force: fn(&Forces) -> f64) -> (Peak, f64) {
        let end = self.nonlinear.run.end();
        let mut peak = Peak::default();
        for (i, own) in linear.iter().enumerate() {
            let time = i as f64 * self.held.step;
            if time > end {
                break;
            }
            let value = (own + self.nonlinear.force(time, force) - self.linear.force(time, force)).abs();
            if value > peak.value {
                peak = Peak { value, time, ..peak };
            }
        }
        (peak, linear.iter().fold(0.0, |most: f64, value| most.max(value.abs())))
    }

    fn about(&self) -> Message {
        let id = match (self.asked, self.counts) {
            (LiquidModel::Nonlinear, _) => "large_wave-asked",
            (LiquidModel::Linear, false) => "large_wave-passed",
            (LiquidModel::Linear, true) => "large_wave-counts",
        };
        Message::new(id)
            .with("wave", Amount::new(self.held.wave, Dimension::Length))
            .with("limit", Amount::new(self.large.small(), Dimension::Length))
    }

    /// The wave at θ = 0 around the crest, linear and nonlinear.
    fn chart(&self, crest: f64) -> Chart {
        let omega = self.linear.liquid.omega();
        let first = omega.iter().copied().filter(|w| *w > 0.0).fold(f64::MAX, f64::min);
        let period = TAU / first;
        let end = self.nonlinear.run.end();
        let (from, to) = ((crest - AROUND * period).max(0.0), (crest + AROUND * period).min(end));
        let line = |id: &str, look: Look, marched: &Marched| {
            let values = marched.liquid.values([self.case.tank.shape.half_length(), 0.0]);
            let points = (0..=MOST_POINTS).map(|i| from + (to - from) * i as f64 / MOST_POINTS as f64);
            Line::new(id, look, points.map(|t| [t, marched.run.wave_at(&values, t)]).collect())
        };
        let lines = vec![line("nonlinear", Look::Main, &self.nonlinear), line("linear", Look::Other, &self.linear)];
        let x = Axis::new("time", Dimension::Time, Scale::Free);
        let y = Axis::new("wave", Dimension::Length, Scale::Zero);
        Chart { room: Room::Wide, ..Chart::new(Channel::Wave(WallSide::Front).id().as_str(), x, y, lines) }
    }

    fn energy(&self) -> Table {
        let Energy { input, kinetic, potential, damped } =
            self.nonlinear.run.energies.last().copied().unwrap_or_default();
        Table::energies([("input", input), ("damped", damped), ("kinetic", kinetic), ("potential", potential)])
    }

    fn balance(&self) -> Message {
        let run = &self.nonlinear.run;
        Message::new("large_wave-balance")
            .with("energy", Amount::percent(run.energy_error()))
            .with("volume", Amount::new(run.volume_error, Dimension::Length))
            .with("slope", Amount::ratio(run.slope).form(Form::Significant(2)))
            .with("steps", Amount::ratio(run.len().saturating_sub(1) as f64).form(Form::Given))
    }
}

/// Why and where a march stopped.
fn stopped(stop: Stop) -> Message {
    let id = match stop.reason {
        Reason::Steep => "large_wave-steep",
        Reason::Dry => "large_wave-dry",
        Reason::Diverged => "large_wave-diverged",
    };
    let [x, y] = stop.place;
    Message::new(id)
        .with("time", Amount::new(stop.time, Dimension::Time))
        .with("r", Amount::new(x.hypot(y), Dimension::Length))
        .with("angle", Amount::new(y.atan2(x), Dimension::Angle).form(Form::Degrees(0)))
}

impl Marched {
    /// The liquid of a case, on the modes of its plan, under a motion for a duration [s].
    fn new(
        case: &Case,
        basis: Basis,
        (motion, duration): ((&GroundMotion, Option<&Record>), f64),
        order: usize,
    ) -> Marched {
        let own = Properties {
            depth: case.liquid.fill_height,
            density: case.liquid.density,
            gravity: case.gravity,
            damping: case.damping.sloshing,
            order,
        };
        let liquid = Liquid::new(basis, own);
        let run = run(&liquid, &sampled(motion, duration), duration, None, without_horizontal);
        let forces = liquid.forces(run.frames());
        Marched { liquid, run, forces }
    }

    /// Places around the circumference, where the wave is not even about the plane of one component.
    fn around(&self) -> Option<Vec<[f64; 2]>> {
        let basis = self.liquid.basis();
        let fem::liquid::large_wave::Shape::Cylinder { radius } = basis.shape() else { return None };
        let both = basis.modes().iter().any(|mode| mode.sine);
        let angle = |i: usize| TAU * i as f64 / PLACES as f64;
        both.then(|| (0..PLACES).map(|i| [radius * angle(i).cos(), radius * angle(i).sin()]).collect())
    }

    /// Highest crest or deepest trough over places at the wall [m].
    fn highest(&self, places: &[[f64; 2]]) -> f64 {
        self.extremes(places).iter().fold(0.0, |most: f64, peak| most.max(peak.value))
    }

    /// Highest crest and deepest trough over places at the wall.
    fn extremes(&self, places: &[[f64; 2]]) -> [Peak; 2] {
        let mut out = [Peak::default(); 2];
        for place in places {
            let theta = place[1].atan2(place[0]).rem_euclid(TAU);
            let [high, low] = self.run.extremes(&self.liquid, *place);
            for (most, (time, value)) in out.iter_mut().zip([high, (low.0, -low.1)]) {
                if value > most.value {
                    *most = Peak { value, time, theta };
                }
            }
        }
        out
    }

    /// A force at a time, linear between instants.
    fn force(&self, time: f64, force: fn(&Forces) -> f64) -> f64 {
        let place = time / self.run.step();
        let first = (place.floor() as usize).min(self.forces.len().saturating_sub(2));
        let Some(a) = self.forces.get(first) else { return 0.0 };
        let b = self.forces.get(first + 1).unwrap_or(a);
        let part = place - first as f64;
        (1.0 - part) * force(a) + part * force(b)
    }
}

#[cfg(test)]
mod tests;
