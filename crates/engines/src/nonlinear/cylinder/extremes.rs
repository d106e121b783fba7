//! Extremes of a cylinder's run: both signs, θ = 0 and θ = 180°, both faces; and the area that the liquid has left.

use fem::analysis::march::Run;
use results::Channel;
use results::channel::{OnWall, Side};
use results::nonlinear::{At, CellMap, TwoSided};

use super::super::extremes::{of_maps, of_range};
use super::model::CylinderModel;
use super::recorded::{
    BASE_MOMENT, BASE_ROTATION, BASE_SHEAR, BELLY_BACK, BELLY_FRONT, TOP_BACK, TOP_FRONT, UPLIFT_BACK, UPLIFT_FRONT,
    WAVE_BACK, WAVE_FRONT,
};
use super::state::grid;
use super::watch::{Extremes, Watch};
use tank::units::Dimension;

/// Everything that was watched.
pub(super) fn extremes(tank: &CylinderModel, watch: &Watch<'_>, maps: &[CellMap]) -> Vec<TwoSided> {
    let recorder = &watch.recorder;
    let back = |channel: Channel| channel.title().replace("θ = 0°", "θ = 180°");
    let recorded = [
        (
            WAVE_FRONT,
            Channel::Wave(Side::Front),
            Channel::Wave(Side::Front).title(),
        ),
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
        let of = |found: Option<&Extremes>, what: OnWall| {
            let title = Channel::BaseOn(what, side).title();
            let title = match what {
                OnWall::Hoop => title.replace(" at the base", ", row of its largest change"),
                _ => title,
            };
            found.map(|e| TwoSided {
                title,
                dimension: what.dimension(),
                rest: e.rest,
                min: Some(At {
                    value: e.min - e.rest,
                    time: Some(e.min_time),
                }),
                max: At {
                    value: e.max - e.rest,
                    time: Some(e.max_time),
                },
            })
        };
        out.extend(of(hoop, OnWall::Hoop));
        out.extend(of(meridian.axial.first(), OnWall::Axial));
    }
    if tank.standing.is_some() {
        out.extend(standing(watch));
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
        max: At {
            value: *value,
            time: Some(*time),
        },
    }));
    out
}

/// Axial compression of the lowest cell, the larger of θ = 0 and π, at the samples; 0 where both are in tension [Pa].
pub(super) fn toe(watch: &Watch<'_>) -> Vec<f64> {
    let [front, back] = watch.seen.sides.each_ref().map(|side| &side.base_axial);
    front.iter().zip(back).map(|(a, b)| (-a.min(*b)).max(0.0)).collect()
}

/// Plastic rotation that is left at the end, the larger of θ = 0 and π.
pub(super) fn plastic(tank: &CylinderModel, run: &Run) -> Option<TwoSided> {
    let [front, back] = tank.standing.as_ref()?.plastic(tank, &run.state).ok()?;
    Some(TwoSided {
        title: "Plastic rotation of the bottom plate at the foot of the wall, at the end".into(),
        dimension: Dimension::Angle,
        rest: 0.0,
        min: None,
        max: At {
            value: front.max(back),
            time: Some(run.time),
        },
    })
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
        max: At {
            value: *value,
            time: Some(*time),
        },
    })
}
