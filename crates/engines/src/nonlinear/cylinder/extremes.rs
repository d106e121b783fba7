//! Extremes of a cylinder's run: both signs, θ = 0 and θ = 180°, both faces; and the area that the liquid has left.

use fem::analysis::march::Range;
use results::Channel;
use results::channel::{OnWall, Side};
use results::nonlinear::{At, CellMap, TwoSided};

use super::super::extremes::{of_maps, of_range};
use super::meridian::Extremes;
use super::model::CylinderModel;
use super::recorded::{
    BASE_MOMENT, BASE_ROTATION, BASE_SHEAR, BELLY_BACK, BELLY_FRONT, TOP_BACK, TOP_FRONT, UPLIFT_BACK, UPLIFT_FRONT,
    WAVE_BACK, WAVE_FRONT,
};
use super::state::grid;
use super::watch::Watch;
use crate::rainflow;
use tank::units::Dimension;

/// Limit of the plastic rotation of the joint, EN 1998-4:2006 A.9, recalled [rad].
const JOINT_LIMIT: f64 = 0.20;

/// Extremes of a stress of the wall, as changes from that at rest.
fn of_stress(e: &Extremes, what: OnWall, side: Side) -> TwoSided {
    let title = Channel::BaseOn(what, side).title();
    TwoSided {
        title: match what {
            OnWall::Hoop => title.replace(" at the base", ", row of its largest change"),
            _ => title,
        },
        dimension: what.dimension(),
        rest: e.rest,
        min: Some(At { value: e.min - e.rest, time: Some(e.min_time) }),
        max: At { value: e.max - e.rest, time: Some(e.max_time) },
    }
}

/// Everything that was watched.
pub(super) fn extremes(tank: &CylinderModel, watch: &Watch<'_>, maps: &[CellMap]) -> Vec<TwoSided> {
    let recorder = &watch.recorder;
    let back = |channel: Channel| channel.title().replace("θ = 0°", "θ = 180°");
    let recorded = [
        (WAVE_FRONT, Channel::Wave(Side::Front), Channel::Wave(Side::Front).title()),
        (WAVE_BACK, Channel::Wave(Side::Back), Channel::Wave(Side::Back).title()),
        (BASE_SHEAR, Channel::BaseShear, Channel::BaseShear.title()),
        (BASE_MOMENT, Channel::BaseMoment, Channel::BaseMoment.title()),
        (TOP_FRONT, Channel::Top, Channel::Top.title()),
        (TOP_BACK, Channel::Top, back(Channel::Top)),
        (BELLY_FRONT, Channel::Belly, Channel::Belly.title()),
        (BELLY_BACK, Channel::Belly, back(Channel::Belly)),
    ];
    let mut out: Vec<TwoSided> = recorded
        .into_iter()
        .filter_map(|(k, channel, title)| {
            let rest = recorder.histories[k].first()?;
            of_range(title, channel.dimension(), *rest, &recorder.ranges[k])
        })
        .collect();
    for (meridian, side) in watch.seen.sides.iter().zip(Side::BOTH) {
        let hoop = meridian.hoop.iter().max_by(|a, b| a.swing().0.total_cmp(&b.swing().0));
        out.extend(hoop.map(|e| of_stress(e, OnWall::Hoop, side)));
        out.extend(meridian.axial.first().map(|e| of_stress(e, OnWall::Axial, side)));
    }
    if tank.standing.is_some() {
        out.extend(standing(watch));
        out.extend(joint(watch));
    }
    out.extend(open(tank, watch));
    out.extend(of_maps(maps, &grid(tank)));
    out
}

/// Heights of the foot over the ground, its rotation, and the stress at the toe.
fn standing(watch: &Watch<'_>) -> Vec<TwoSided> {
    let recorder = &watch.recorder;
    let sides = [UPLIFT_FRONT, UPLIFT_BACK].into_iter().zip(Side::BOTH);
    let channels = sides.map(|(k, side)| (k, Channel::Uplift(side)));
    let all = channels.chain([(BASE_ROTATION, Channel::BaseRotation)]);
    let mut out: Vec<TwoSided> = all
        .filter_map(|(k, channel)| of_range(channel.title(), channel.dimension(), 0.0, &recorder.ranges[k]))
        .collect();
    let toe = toe(watch);
    let peak = toe.iter().zip(&recorder.times).max_by(|a, b| a.0.total_cmp(b.0));
    out.extend(peak.map(|(value, time)| TwoSided {
        title: Channel::ToeStress.title(),
        dimension: Channel::ToeStress.dimension(),
        rest: 0.0,
        min: None,
        max: At { value: *value, time: Some(*time) },
    }));
    out
}

/// Axial compression of the lowest cell, the larger of θ = 0 and π, at the samples; 0 where both are in tension [Pa].
pub(super) fn toe(watch: &Watch<'_>) -> Vec<f64> {
    let [front, back] = watch.seen.sides.each_ref().map(|side| &side.base_axial);
    front.iter().zip(back).map(|(a, b)| (-a.min(*b)).max(0.0)).collect()
}

/// Plastic rotation of the joint on both sides, its largest range in a cycle, and the cycles beyond the limit.
fn joint(watch: &Watch<'_>) -> Vec<TwoSided> {
    let times = &watch.recorder.times;
    let sides = watch.seen.standing.joint.iter().zip(Side::BOTH);
    let mut out: Vec<TwoSided> = sides
        .clone()
        .filter_map(|(history, side)| {
            let mut range = Range::EMPTY;
            history.iter().zip(times).for_each(|(v, t)| range.include(*v, *t));
            let channel = Channel::PlasticRotation(side);
            of_range(channel.title(), channel.dimension(), 0.0, &range)
        })
        .collect();
    let (range, beyond, degrees) = cycles(watch);
    let more = [
        (
            format!("Largest range of the plastic rotation of the joint in a cycle (rainflow), θ = {degrees}°"),
            Dimension::Angle,
            range,
        ),
        (
            format!("Cycles of the joint of at least {JOINT_LIMIT:.2} rad (rainflow), θ = {degrees}°"),
            Dimension::Dimensionless,
            beyond,
        ),
    ];
    out.extend(more.map(|(title, dimension, value)| TwoSided {
        title,
        dimension,
        rest: 0.0,
        min: None,
        max: At { value, time: None },
    }));
    out
}

/// Largest range of the joint in a cycle [rad], number of cycles of at least [`JOINT_LIMIT`], and the side with the larger range [°].
fn cycles(watch: &Watch<'_>) -> (f64, f64, u32) {
    let side = |(history, degrees): (&Vec<f64>, u32)| {
        let all = rainflow::cycles(history.iter().copied());
        let (range, counts) = rainflow::counted(&all, JOINT_LIMIT, &[1.0]);
        (range, counts.first().map_or(0.0, |c| c[1]), degrees)
    };
    let [front, back] = &watch.seen.standing.joint;
    let [front, back] = [(front, 0), (back, 180)].map(side);
    if back.0 > front.0 { back } else { front }
}

/// Share of the wetted wall that the liquid has left, at the samples.
pub(super) fn open_history(tank: &CylinderModel, watch: &Watch<'_>) -> Option<Vec<f64>> {
    let wetted: f64 = tank.areas.iter().sum();
    let open = watch.openings.as_ref()?.open();
    Some(open.iter().map(|area| area / wetted).collect())
}

/// The largest of it, and when.
fn open(tank: &CylinderModel, watch: &Watch<'_>) -> Option<TwoSided> {
    let history = open_history(tank, watch)?;
    let samples = history.iter().zip(&watch.recorder.times);
    let (value, time) = samples.max_by(|a, b| a.0.total_cmp(b.0))?;
    Some(TwoSided {
        title: Channel::Open.title(),
        dimension: Channel::Open.dimension(),
        rest: 0.0,
        min: None,
        max: At { value: *value, time: Some(*time) },
    })
}
