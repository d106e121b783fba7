//! What is reported of a run on a free base.

use std::collections::BTreeMap;
use std::sync::Arc;

use ::base::history::History;
use ::base::{Base, Origin, Ring, Suction, Turn};
use results::channel::Side;
use results::{
    AnchorRun, BaseBand, BaseEnergy, BaseRun, BaseSpread, Channel, Finding, GroundOrigin, JointCycles, MissedBand,
    SeriesInfo, Snapshots,
};
use tank::units::Dimension;

use super::floor::{Floor, Now};
use super::peaks::{Peaks, largest, turns};
use super::search::Found;
use super::setup::{Laws, Setup};
use super::words;
use crate::rainflow;
use crate::response::motion::Grid;

/// Largest plastic rotation of the joint, EN 1998-4:2006 A.9, recalled [rad].
const PLASTIC: f64 = 0.20;
/// Points of the cycles that are kept, and their time on either side of the largest rotation [s].
const CYCLES: (usize, f64) = (800, 2.0);
/// Parts of the half circumference over which the range of the rim's uplifts is looked for.
const PLACES: usize = 24;
/// Points of the backbone.
const BACKBONE: usize = 60;
/// Shares of the limit of the plastic rotation whose cycles are counted.
const SHARES: [f64; 4] = [0.1, 0.25, 0.5, 1.0];

/// The motion of the base.
pub(crate) struct BaseMotion {
    /// Its steps.
    pub grid: Grid,
    /// A at each step [m/s²].
    pub acceleration: Vec<f64>,
    /// ψ̈ at each step [rad/s²].
    pub rotation: Vec<f64>,
}

/// A run on a free base.
pub(crate) struct Moved {
    /// Its results.
    pub result: BaseRun,
    /// The motion of the base.
    pub motion: BaseMotion,
    /// Axial stress of the foot at θ = 0 and 180°, tension positive, at each step [Pa].
    pub foot: [Vec<f64>; 2],
    /// Largest base shear [N] and moment that base and dashpot resist [N m].
    pub march: [f64; 2],
    /// Whether the bottom plate may yield.
    pub yields: bool,
    /// Whether all of the bottom slid at once.
    pub slid: bool,
    /// Stress of the lowest course at the joint at the largest uplift, and its yield strength [Pa].
    pub wall: Option<[f64; 2]>,
    /// Largest bottom pressure of the motion of a foot that lifts and warps.
    pub suction: Option<Suction>,
    /// Whether waves of its foot follow at once, without inertia.
    pub warps_at_once: bool,
    /// Largest bottom pressure of the motion over that at rest, of a foot that lifts.
    pub swing: Option<f64>,
    /// Its histories at the steps of the record.
    pub columns: Vec<(SeriesInfo, Vec<f64>)>,
    /// The bottom at any time for pictures, where they are asked for.
    pub bottom: Option<Bottom>,
}

/// States of the base, step by step.
struct States {
    turns: Vec<Turn>,
    /// Displacement of the rim at θ = 0 and 180° [m].
    rim: [Vec<f64>; 2],
    /// Axial stress at the toe [Pa].
    toe: Vec<f64>,
    /// Axial stress of the foot at θ = 0 and 180°, tension positive [Pa].
    foot: [Vec<f64>; 2],
}

fn states(base: &Base, found: &Found, history: &History) -> States {
    let turns: Vec<Turn> = turns(&found.laws, history).collect();
    // The anchor that pulls most, per length of the rim, stands where the wall is lifted.
    let count = found.laws.ring.as_ref().map_or(0.0, |ring| ring.anchors().count as f64);
    let per_length = count / (std::f64::consts::TAU * base.radius);
    let anchored = |i: usize| history.anchor_force.get(i).map_or(0.0, |force| force * per_length);
    let rim = [0.0, std::f64::consts::PI].map(|theta| {
        let moved = turns.iter().zip(&history.rotation);
        moved.map(|(turn, psi)| turn.rim_at(base.radius, *psi, theta)).collect()
    });
    let foot = [1.0, -1.0].map(|side| {
        let places = turns.iter().zip(&history.rotation).enumerate();
        // A positive rotation presses θ = 0.
        let force = |(i, (turn, psi)): (usize, (&Turn, &f64))| match side * psi > 0.0 {
            true => -turn.toe_force,
            false => turn.pull + anchored(i),
        };
        places.map(|place| force(place) / base.wall_thickness()).collect()
    });
    States { foot, toe: turns.iter().map(|turn| turn.toe_force / base.wall_thickness()).collect(), turns, rim }
}

/// Largest values on another ground.
pub(super) fn band(base: &Base, found: &Found) -> BaseBand {
    let peaks = Peaks::of(base, turns(&found.laws, &found.history), &found.laws, &found.history);
    BaseBand {
        spread: spread(found, &peaks),
        modulus: base.modulus,
        uplift: peaks.uplift.0,
        base_rotation: peaks.rotation.0.abs(),
        plastic_rotation: peaks.plastic,
        toe_axial_stress: peaks.toe.0.abs(),
        slip: peaks.slip.0.abs(),
        base_shear: peaks.shear.0.abs(),
    }
}

/// Extremes of the run and its twins; none without them.
fn spread(found: &Found, own: &Peaks) -> Option<BaseSpread> {
    if found.twins.is_empty() {
        return None;
    }
    let values =
        |peaks: &Peaks| [peaks.uplift.0, peaks.rotation.0.abs(), peaks.plastic, peaks.toe.0.abs(), peaks.shear.0.abs()];
    let mut ranges = values(own).map(|v| [v; 2]);
    for twin in &found.twins {
        for (range, value) in ranges.iter_mut().zip(values(twin)) {
            *range = [range[0].min(value), range[1].max(value)];
        }
    }
    let [uplift, base_rotation, plastic_rotation, toe_axial_stress, base_shear] = ranges;
    Some(BaseSpread { uplift, base_rotation, plastic_rotation, toe_axial_stress, base_shear })
}

/// The run as it is reported; the values of the wall held down and the superposed ones are added by [`Moved::complete`].
///
/// * `grounds`: the runs of the band
pub(super) fn moved(
    setup: &Setup,
    base: &Base,
    found: Found,
    grounds: Vec<Result<BaseBand, MissedBand>>,
    grid: Grid,
) -> Moved {
    let history = &found.history;
    let states = states(base, &found, history);
    let peaks = Peaks::of(base, states.turns.iter().copied(), &found.laws, history);
    let lifted_at = peaks.uplift.1;
    let lean = history.rotation[lifted_at];
    let [around, lifted] = around(base, &found, (&states.turns[lifted_at], history.pressure[lifted_at]), lean);
    let highest = now(&states, history, lifted_at);
    let result = BaseRun {
        modulus: base.modulus,
        origin: match base.origin {
            Origin::Given => GroundOrigin::Given,
            Origin::Waves => GroundOrigin::Waves,
            Origin::Assumed(kind) => GroundOrigin::Assumed(kind),
        },
        friction: setup.friction.as_ref().map(|f| f.coefficient),
        hysteretic: found.hysteretic,
        settled: found.settled,
        dashpot: found.dashpot,
        step: setup.step,
        quantities: quantities(setup, &peaks, &found, lean),
        plastic_rotation_limit: PLASTIC,
        anchors: found.laws.ring.as_ref().map(|ring| anchors(ring, history)),
        held: BTreeMap::new(),
        superposition: 0.0,
        energy: energy(history),
        band: grounds.iter().filter_map(|ground| ground.clone().ok()).collect(),
        missed: grounds.into_iter().filter_map(Result::err).collect(),
        spread: spread(&found, &peaks),
        backbone: backbone(&found, 1.1 * peaks.rotation.0.abs()),
        cycles: cycles(setup, &found, peaks.rotation.1),
        around,
        lifted,
        ground: floor(setup, base, &[highest]).map(|f| f.plan(&highest, lifted_at as f64 * setup.step)),
        joint: base.yields().then(|| joint_cycles(&states, &found)),
        assumptions: words::assumptions(setup, base, &found),
    };
    let swing = largest(&found.history.pressure).0;
    Moved {
        bottom: Bottom::of(setup, base, &found, &states),
        columns: columns(setup, &states, &found),
        result,
        march: [peaks.shear.0.abs(), largest(&found.history.resistance).0.abs()],
        foot: states.foot,
        yields: base.yields(),
        slid: found.history.slid,
        suction: base.suction_in_time(swing).filter(|_| peaks.uplift.0 > 0.0),
        warps_at_once: found.laws.waves.is_none(),
        swing: (peaks.uplift.0 > 0.0).then_some(swing.abs() / base.pressure),
        wall: base.wall_yield.map(|strength| {
            let point = found.laws.rocking.curve().at(peaks.uplift.0);
            [base.wall_stress(&point), strength]
        }),
        motion: BaseMotion {
            grid,
            acceleration: found.history.acceleration,
            rotation: found.history.rotational_acceleration,
        },
    }
}

fn energy(history: &History) -> BaseEnergy {
    let energy = history.energy;
    BaseEnergy {
        input: energy.input,
        viscous: energy.viscous,
        base_elastic: energy.base_elastic,
        base_hysteretic: energy.base_hysteretic,
        anchors: energy.anchors,
        base_radiated: energy.base_radiated,
        friction: energy.friction,
        body: energy.body,
        error: history.balance,
    }
}

/// Rotations up to `largest` [rad] with their moments on the first way up [N m].
fn backbone(found: &Found, largest: f64) -> Vec<[f64; 2]> {
    let point = |i: usize| {
        let psi = largest * (i as f64 / BACKBONE as f64).powi(2);
        [psi, found.laws.law.respond(psi, 0.0, 0.0, &[]).moment]
    };
    (0..=BACKBONE).map(point).collect()
}

/// Uplift of the rim [m] and width that is off the ground [m] over the angle [°] of a base that leans by `lean` [rad] under a bottom pressure [Pa].
fn around(base: &Base, found: &Found, (turn, pressure): (&Turn, f64), lean: f64) -> [Vec<[f64; 2]>; 2] {
    let degrees = (0..=72).map(|i| 5.0 * f64::from(i));
    let uplifts: Vec<[f64; 2]> = degrees.map(|at| [at, turn.rim_at(base.radius, lean, at.to_radians())]).collect();
    // The pressure is that at θ = 0 over that at rest.
    let width = |[at, w]: &[f64; 2]| [*at, found.laws.rocking.lifted_width(*w, at.to_radians().cos(), -pressure)];
    let widths = uplifts.iter().map(width).collect();
    [uplifts, widths]
}

/// The bottom at any time, for pictures.
pub(crate) struct Bottom {
    floor: Floor,
    laws: Arc<Laws>,
    /// The base at each step.
    steps: Vec<Now>,
    /// Length of a step [s].
    step: f64,
}

impl Bottom {
    /// None where nobody asks for it or a strip has no equilibrium.
    fn of(setup: &Setup, base: &Base, found: &Found, states: &States) -> Option<Bottom> {
        if !setup.drawn {
            return None;
        }
        let steps: Vec<Now> = (0..states.turns.len()).map(|i| now(states, &found.history, i)).collect();
        Some(Bottom { floor: floor(setup, base, &steps)?, laws: Arc::clone(&found.laws), steps, step: setup.step })
    }

    /// The base at the step next to a time [s].
    pub(crate) fn at(&self, time: f64) -> Now {
        let place = (time / self.step).round() as usize;
        self.steps[place.min(self.steps.len() - 1)]
    }

    /// States of the plate at times [s].
    pub(crate) fn states(&self, times: &[f64]) -> Snapshots {
        let instants: Vec<(f64, Now)> = times.iter().map(|&time| (time, self.at(time))).collect();
        self.floor.states(&instants, &|w| plastic(&self.laws, w))
    }
}

/// The base at a step.
fn now(states: &States, history: &History, step: usize) -> Now {
    let at = |values: &[f64]| values.get(step).copied().unwrap_or(0.0);
    Now {
        turn: states.turns[step],
        rotation: at(&history.rotation),
        pressure: at(&history.pressure),
        slip: at(&history.slip),
    }
}

/// The plate at all uplifts of these instants; none where a strip has no equilibrium.
pub(super) fn floor(setup: &Setup, base: &Base, instants: &[Now]) -> Option<Floor> {
    let mut range = [f64::INFINITY, f64::NEG_INFINITY];
    let mut most = 0.0_f64;
    for now in instants {
        for i in 0..=PLACES {
            let rim = now.turn.rim(base.radius, std::f64::consts::PI * i as f64 / PLACES as f64);
            range = [range[0].min(rim), range[1].max(rim)];
        }
        most = most.max(now.pressure.abs());
    }
    let form = |r: f64| {
        let last = setup.form.len() - 1;
        let place = (r / base.radius).clamp(0.0, 1.0) * last as f64;
        let i = (place as usize).min(last.saturating_sub(1));
        setup.form[i] + (place - i as f64) * (setup.form[i + 1] - setup.form[i])
    };
    Floor::of(base, range, most, &form)
}

/// Plastic rotation of the joint where the rim is lifted by `uplift` [m] for the first time [rad]; none of one that is pressed down.
fn plastic(laws: &Laws, uplift: f64) -> f64 {
    if uplift > 0.0 { laws.rocking.curve().at(uplift).plastic_rotation } else { 0.0 }
}

/// Cycles of the joint at θ = 0 or 180°, that with the larger range.
fn joint_cycles(states: &States, found: &Found) -> JointCycles {
    let side = |(rim, degrees): (&Vec<f64>, f64)| {
        let all = rainflow::cycles(rim.iter().map(|w| plastic(&found.laws, *w)));
        let (range, counts) = rainflow::counted(&all, PLASTIC, &SHARES);
        JointCycles { degrees, range, counts }
    };
    let [front, back] = [(&states.rim[0], 0.0), (&states.rim[1], 180.0)].map(side);
    if back.range > front.range { back } else { front }
}

fn quantities(setup: &Setup, peaks: &Peaks, found: &Found, lean: f64) -> Vec<Finding> {
    let quantity = |id: &str, value: f64, dimension, time: Option<usize>, degrees| Finding {
        time: time.map(|i| i as f64 * setup.step),
        degrees,
        ..Finding::new(id, value, dimension)
    };
    let lifted_side = if lean > 0.0 { 180.0 } else { 0.0 };
    let toe_side = if found.history.rotation[peaks.toe.1] > 0.0 { 0.0 } else { 180.0 };
    let residual = found.history.slip.last().copied().unwrap_or(0.0);
    let path = found.history.slip.windows(2).map(|s| (s[1] - s[0]).abs()).sum();
    let (rotation, toe, slip) = (peaks.rotation, peaks.toe, peaks.slip);
    let anchor = found.laws.ring.as_ref().map(|ring| {
        let place = found.history.anchor_place.get(peaks.anchor.1).copied().unwrap_or(0);
        let degrees = angle(ring, place);
        quantity("anchor_force", peaks.anchor.0, Dimension::Force, Some(peaks.anchor.1), Some(degrees))
    });
    let quantities = vec![
        quantity("uplift", peaks.uplift.0, Dimension::Length, Some(peaks.uplift.1), Some(lifted_side)),
        quantity("base_rotation", rotation.0.abs(), Dimension::Angle, Some(rotation.1), None),
        quantity("plastic_rotation", peaks.plastic, Dimension::Angle, Some(peaks.uplift.1), Some(lifted_side)),
        quantity("toe_axial_stress", toe.0.abs(), Dimension::Stress, Some(toe.1), Some(toe_side)),
        quantity("slip", slip.0.abs(), Dimension::Length, Some(slip.1), None),
        quantity("slip_residual", residual.abs(), Dimension::Length, None, None),
        quantity("slip_path", path, Dimension::Length, None, None),
        quantity("base_shear", peaks.shear.0.abs(), Dimension::Force, Some(peaks.shear.1), None),
        quantity("base_moment", peaks.moment.0.abs(), Dimension::Moment, Some(peaks.moment.1), None),
    ];
    quantities.into_iter().chain(anchor).collect()
}

/// Angle of a place of the ring [°].
fn angle(ring: &Ring, place: usize) -> f64 {
    360.0 * place as f64 / ring.anchors().count as f64
}

/// What the anchors have gone through.
fn anchors(ring: &Ring, history: &History) -> AnchorRun {
    let (own, bolts) = (ring.anchors(), &history.bolts);
    let many = |which: &dyn Fn(usize) -> bool| {
        let places = ring.places().iter().enumerate().filter(|(i, _)| which(*i));
        places.map(|(_, (_, number))| *number as usize).sum()
    };
    let by_angle = |values: &[f64]| (0..).map(|i| angle(ring, i)).zip(values).map(|(a, v)| [a, *v]).collect();
    AnchorRun {
        count: own.count,
        stiffness: own.stiffness,
        yield_force: own.yield_force,
        gap: own.gap,
        rupture_elongation: own.rupture,
        plastic_elongation: bolts.plastic.iter().copied().fold(0.0, f64::max),
        largest_elongation: history.anchor_stretch,
        yielded: many(&|i| bolts.plastic[i] > 0.0),
        broken: many(&|i| bolts.broken[i]),
        around: by_angle(&bolts.plastic),
        forces: by_angle(&history.anchor_peaks),
    }
}

/// Rotation and moment around the step `peak`.
fn cycles(setup: &Setup, found: &Found, peak: usize) -> Vec<[f64; 2]> {
    let side = (CYCLES.1 / setup.step) as usize;
    let end = (peak + side).min(found.history.rotation.len());
    let steps = peak.saturating_sub(side)..end;
    let stride = steps.len().div_ceil(CYCLES.0).max(1);
    steps.step_by(stride).map(|i| [found.history.rotation[i], found.history.moment[i]]).collect()
}

/// Histories at the steps of the record.
fn columns(setup: &Setup, states: &States, found: &Found) -> Vec<(SeriesInfo, Vec<f64>)> {
    let column = |channel: Channel, values: &[f64]| {
        let (peak, at) = largest(values);
        let info = SeriesInfo::of(channel, 0.0, (peak.abs(), at as f64 * setup.step));
        (info, values.iter().step_by(setup.sub_steps).copied().collect())
    };
    let [front, back] = &states.rim;
    let mut columns = vec![
        column(Channel::BaseRotation, &found.history.rotation),
        column(Channel::Uplift(Side::Front), front),
        column(Channel::Uplift(Side::Back), back),
        column(Channel::ToeStress, &states.toe),
    ];
    if setup.friction.is_some() {
        columns.push(column(Channel::Slip, &found.history.slip));
    }
    if found.laws.ring.is_some() {
        columns.push(column(Channel::AnchorForce, &found.history.anchor_force));
    }
    columns
}
