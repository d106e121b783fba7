//! The quantities of two horizontal components: the probe of the motion along x, that along y, that of the vertical motion.

use results::Channel;
use results::channel::{OnBase, OnWall};

use super::meet::{Across, Meet, lines};
use crate::linear::model::Model;
use crate::linear::system::Harmonic;
use crate::probe::Probe;
use crate::response::superpose::Observable;

/// Numbers of the systems of the joint response: m = 1 along x, m = 1 along y, m = 0.
const ALONG: usize = 0;
const ACROSS: usize = 1;
const UPWARDS: usize = 2;

/// A quantity that goes around the tank.
#[derive(Clone, Copy)]
pub(super) struct Item<'a> {
    pub(super) channel: Channel,
    pub(super) odd: &'a Probe,
    /// That of the motion along y.
    pub(super) across: &'a Probe,
    pub(super) even: Option<&'a Probe>,
    pub(super) meet: Meet,
    /// Angle of a direction (c, s): atan2 of s times the second, c times the first.
    pub(super) stretch: [f64; 2],
}

impl<'a> Item<'a> {
    /// The response in the direction (c, s).
    pub(super) fn towards(&self, (c, s): (f64, f64)) -> Observable<'a> {
        let mut terms = vec![(ALONG, c, self.odd), (ACROSS, s, self.across)];
        terms.extend(self.even.map(|even| (UPWARDS, 1.0, even)));
        terms
    }

    /// The response to the component along y at θ = 90° (or 270°).
    pub(super) fn across(&self, sign: f64) -> Observable<'a> {
        let mut terms = vec![(ACROSS, sign, self.across)];
        terms.extend(self.even.map(|even| (UPWARDS, 1.0, even)));
        terms
    }

    /// The response to the component along x at θ = 0 (or 180°).
    pub(super) fn along(&self, sign: f64) -> Observable<'a> {
        let mut terms = vec![(ALONG, sign, self.odd)];
        terms.extend(self.even.map(|even| (UPWARDS, 1.0, even)));
        terms
    }

    /// Whether it is the wave at a corner of a box.
    pub(super) fn is_corner_wave(&self) -> bool {
        self.meet == Meet::Corners && self.channel.is_wave()
    }
}

/// The force or moment on the base of a channel.
pub(super) fn on_base(channel: Channel) -> Option<OnBase> {
    OnBase::ALL.into_iter().find(|what| what.along() == channel)
}

/// Everything that is observed: scalars but for the gauges, which lie along x, hoop stress and pressure over the height.
pub(super) fn items<'a>(model: &'a Model, second: Option<Across<'a>>) -> Vec<Item<'a>> {
    let coupled = &model.horizontal.coupled;
    // Gauges lie along x, stations of internal forces have an angle.
    let gauge = |probe: &&Probe| !matches!(probe.channel, Channel::WaveAt { .. }) && probe.turn.is_none();
    let even = |probe: &Probe| even(model, probe);
    let other = second.map_or(coupled, |second| &second.model.horizontal.coupled);
    let corner = second.map(|second| Channel::WaveAround { degrees: Across::corner(second.halves) });
    // Both models list the same quantities in the same order.
    let mut all: Vec<Item<'_>> = (coupled.probes.iter().zip(&other.probes).filter(|(odd, _)| gauge(odd)))
        .map(|(odd, across)| {
            let meet = match second {
                None => Meet::Everywhere,
                Some(_) if on_base(odd.channel).is_some() => Meet::Everywhere,
                Some(_) if Some(odd.channel) == corner => Meet::Corners,
                Some(_) => Meet::Walls,
            };
            Item {
                channel: odd.channel,
                odd,
                across,
                even: even(odd),
                meet,
                stretch: match (meet, second) {
                    (Meet::Corners, Some(second)) => second.halves,
                    _ => [1.0, 1.0],
                },
            }
        })
        .collect();
    for what in lines(second.is_some()) {
        let Some(line) = coupled.line(what) else { continue };
        let Some(turned) = other.line(what).filter(|same| same.z == line.z) else { continue };
        let upwards = model.vertical.as_ref().and_then(|v| v.coupled.line(what));
        let upwards = upwards.filter(|same| same.z == line.z);
        for (i, (odd, &z)) in line.probes.iter().zip(&line.z).enumerate() {
            let corner = what == OnWall::CornerMoment;
            all.push(Item {
                channel: Channel::Largest { what, z },
                odd,
                across: &turned.probes[i],
                even: upwards.map(|same| &same.probes[i]),
                meet: match second {
                    None => Meet::Everywhere,
                    Some(_) if corner => Meet::Corners,
                    Some(_) => Meet::Walls,
                },
                stretch: second.filter(|_| corner).map_or([1.0, 1.0], |second| second.halves),
            });
        }
    }
    all
}

/// The probe of m = 0 that belongs to one of m = 1.
fn even<'a>(model: &'a Model, probe: &Probe) -> Option<&'a Probe> {
    let vertical: &'a Harmonic = model.vertical.as_ref()?;
    vertical.coupled.probes.iter().find(|p| p.channel == probe.channel)
}

/// Internal forces at stations under both components.
pub(super) fn stations(model: &Model) -> Vec<(Channel, Observable<'_>)> {
    let probes = model.horizontal.coupled.probes.iter();
    let both = |probe| {
        let probe: &Probe = probe;
        let turn = probe.turn?;
        let mut terms = vec![(ALONG, turn.along, probe), (ACROSS, turn.across, probe)];
        terms.extend(even(model, probe).map(|even| (UPWARDS, 1.0, even)));
        Some((probe.channel, terms))
    };
    probes.filter_map(both).collect()
}
