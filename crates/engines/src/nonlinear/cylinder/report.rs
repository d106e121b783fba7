//! A run in the vocabulary of the results.

use std::collections::BTreeMap;
use std::f64::consts::TAU;

use fem::analysis::march::{Outcome, Run};
use tank::{Case, Quantity, Support};

use super::curve::departures;
use super::demands::demands;
use super::describe::{HELD_DOWN, assumptions, cost, integration, mesh};
use super::extremes;
use super::limits::limits;
use super::march::Cylinder;
use super::meridian::Extremes;
use super::model::CylinderModel;
use super::points::look;
use super::recorded::{
    BASE_MOMENT, BASE_ROTATION, BASE_SHEAR, BELLY_FRONT, SLIP, TOP_FRONT, UPLIFT_BACK, UPLIFT_FRONT, WAVE_BACK,
    WAVE_FRONT,
};
use super::state::{energies, events, grid, loops, maps, pictures, place};
use super::two;
use super::watch::Watch;
use crate::Simulation;
use crate::histories::Histories;
use crate::hoop;
use crate::linear::both_directions;
use results::channel::{OnWall, Side};
use results::nonlinear::{End, Event, EventKind, Nonlinear};
use results::{Channel, EnergyBalance, EngineId, Envelope, Run as Finished, SeriesInfo};

/// Everything that is reported of a run.
pub(super) fn report(cylinder: &Cylinder<'_>, watch: &Watch<'_>, run: &Run) -> Simulation {
    let Cylinder { case, options, tank, span, .. } = cylinder;
    let last = look(tank, &run.state);
    let mut worst = watch.seen.worst.clone().unwrap_or_else(|| last.clone());
    worst.envelop(&last);
    let histories = histories(tank, watch);
    let mut values = values(tank, watch);
    for (quantity, value) in of_base(&histories).filter(|_| tank.standing.is_some()) {
        let known = values.entry(quantity).or_default();
        *known = value.max(*known);
    }
    let (end, events) = (end(tank, run), events(tank, watch));
    let notes = notes(case, tank, &end, &events);
    let maps = maps(case, tank, watch, &worst, &last);
    let nonlinear = Nonlinear {
        grid: grid(tank),
        extremes: extremes::extremes(tank, watch, &maps),
        maps,
        cracks: pictures(watch, &last, run.time),
        loops: loops(watch),
        energies: energies(run, watch),
        cost: cost(tank, watch, run),
        moments: Vec::new(),
        departures: departures(tank, watch),
    };
    let result = Finished {
        end,
        events,
        mesh: mesh(tank),
        integration: integration(tank, options, span, watch, run),
        energy: Some(balance(tank, run)),
        envelopes: envelopes(tank, watch),
        record_end: span.record_end(),
        limits: limits(cylinder, watch, &worst),
        histories: histories.info,
        nonlinear: Some(nonlinear),
        around: watch.seen.around.around(case, tank),
        directions: watch.seen.two.results(tank, &watch.recorder),
        incomplete: run.outcome != Outcome::Completed,
        ..Finished::new(EngineId::Nonlinear)
    };
    Simulation {
        values,
        result,
        series: histories.series,
        assumptions: assumptions(case, options, tank, span),
        notes,
        snapshots: watch.pictures.as_ref().map(|p| p.states.clone()).filter(|p| !p.states.is_empty()),
        demands: Some(demands(case, tank, watch)),
        units: None,
        of_modes: None,
        second: None,
        slab_motion: None,
    }
}

/// Remarks on a run that ended so.
fn notes(case: &Case, tank: &CylinderModel, end: &End, events: &[Event]) -> Vec<String> {
    let mut notes = case.ground_motion.as_ref().map_or_else(Vec::new, both_directions);
    if case.tank.support == Support::Unanchored && tank.standing.is_none() {
        notes.push(HELD_DOWN.into());
    }
    notes.extend(crate::linear::soil::note(case, EngineId::Nonlinear, tank.slab.is_some()));
    match end {
        End::Completed | End::Left { .. } => {}
        End::Interrupted { time } => {
            notes.push(format!("Interrupted at {time:.3} s: all results end there."));
        }
        End::Collapsed { time, reason, .. } => notes.push(format!(
            "Collapse: no equilibrium after {time:.3} s ({reason}). All numbers are those until then and are lower bounds."
        )),
    }
    let parts = events.iter().find(|e| e.kind == EventKind::LowPressure).filter(|_| tank.joints.is_none());
    notes.extend(parts.map(|parts| {
        format!(
            "The liquid separates from the wall ({}, first at {:.2} s); the engine keeps it in contact.",
            parts.place, parts.time
        )
    }));
    notes
}

/// Energies at the end of a run, those of the whole tank.
fn balance(tank: &CylinderModel, run: &Run) -> EnergyBalance {
    let total = run.balance.samples.last().copied().unwrap_or_default();
    let copies = tank.cells.copies();
    EnergyBalance {
        input: copies * total.input,
        kinetic: copies * total.kinetic,
        elastic: copies * (total.internal - total.hysteretic),
        damping: copies * total.damping,
        error: run.balance.error(),
    }
}

/// Histories relative to the static state, as in the other engines.
fn histories(tank: &CylinderModel, watch: &Watch<'_>) -> Histories {
    let recorder = &watch.recorder;
    let times = &recorder.times;
    let mut histories = Histories::at(times.clone());
    let mut push = |channel: Channel, values: &[f64], peak: Option<(f64, f64)>| {
        let rest = values.first().copied().unwrap_or(0.0);
        let own: Vec<f64> = values.iter().map(|v| v - rest).collect();
        let sampled = || {
            let i = (0..own.len()).fold(0, |m, i| if own[i].abs() > own[m].abs() { i } else { m });
            (own.get(i).map_or(0.0, |v| v.abs()), times.get(i).copied().unwrap_or(0.0))
        };
        let info = SeriesInfo::of(channel, rest, peak.unwrap_or_else(sampled));
        histories.push(info, own);
    };
    for (k, channel) in [
        (WAVE_FRONT, Channel::Wave(Side::Front)),
        (WAVE_BACK, Channel::Wave(Side::Back)),
        (BASE_SHEAR, Channel::BaseShear),
        (BASE_MOMENT, Channel::BaseMoment),
        (TOP_FRONT, Channel::Top),
        (BELLY_FRONT, Channel::Belly),
    ] {
        push(channel, &recorder.histories[k], Some(extremes(watch, k).swing()));
    }
    for (meridian, side) in watch.seen.sides.iter().zip(Side::BOTH) {
        push(Channel::BaseOn(OnWall::Axial, side), &meridian.base_axial, None);
        push(Channel::BaseOn(OnWall::Moment, side), &meridian.moment, None);
    }
    if tank.standing.is_some() {
        push(Channel::BaseRotation, &recorder.histories[BASE_ROTATION], None);
    }
    let slab = watch.foundation.into_iter().flatten();
    for (k, channel) in slab.zip([Channel::FoundationTranslation, Channel::FoundationRotation]) {
        push(channel, &recorder.histories[k], Some(extremes(watch, k).swing()));
    }
    if let Some(open) = extremes::open_history(tank, watch) {
        push(Channel::Open, &open, None);
    }
    if let Some(standing) = &tank.standing {
        let mut whole = |channel: Channel, values: Vec<f64>, peak: (f64, f64)| {
            histories.push(SeriesInfo::of(channel, 0.0, peak), values);
        };
        for (k, side) in [UPLIFT_FRONT, UPLIFT_BACK].into_iter().zip(Side::BOTH) {
            let up = recorder.histories[k].iter().map(|v| v.max(0.0)).collect();
            let range = &recorder.ranges[k];
            whole(Channel::Uplift(side), up, (range.max.max(0.0), range.max_time));
        }
        let toe = extremes::toe(watch);
        let peak = toe.iter().zip(times).max_by(|a, b| a.0.total_cmp(b.0));
        let peak = peak.map_or((0.0, 0.0), |(v, t)| (*v, *t));
        whole(Channel::ToeStress, toe, peak);
        let sampled = |values: &[f64]| {
            let all = values.iter().zip(times);
            all.fold((0.0, 0.0), |m: (f64, f64), (v, t)| if v.abs() > m.0 { (v.abs(), *t) } else { m })
        };
        let seen = &watch.seen.standing;
        for (history, side) in seen.joint.iter().zip(Side::BOTH) {
            whole(Channel::PlasticRotation(side), history.clone(), sampled(history));
        }
        if !seen.anchor.is_empty() {
            whole(Channel::AnchorForce, seen.anchor.clone(), sampled(&seen.anchor));
        }
        if standing.slides() {
            let slip = &recorder.histories[SLIP];
            let rest = slip.first().copied().unwrap_or(0.0);
            let own: Vec<f64> = slip.iter().map(|v| v - rest).collect();
            let peak = sampled(&own);
            whole(Channel::Slip, own, peak);
        }
    }
    two::add(&mut histories, recorder, &watch.seen.two);
    histories
}

/// Range of a recorded quantity with its static value; zeros if the static state was not reached.
fn extremes(watch: &Watch<'_>, k: usize) -> Extremes {
    let range = &watch.recorder.ranges[k];
    match watch.recorder.histories[k].first() {
        Some(&rest) => {
            Extremes { rest, min: range.min, min_time: range.min_time, max: range.max, max_time: range.max_time }
        }
        None => Extremes::default(),
    }
}

/// The comparable values of a base that is free to move whose histories are given.
fn of_base(histories: &Histories) -> impl Iterator<Item = (Quantity, f64)> {
    let of = |info: &SeriesInfo| {
        let quantity = match info.channel()? {
            Channel::Uplift(_) => Quantity::Uplift,
            Channel::BaseRotation => Quantity::BaseRotation,
            Channel::PlasticRotation(_) => Quantity::PlasticRotation,
            Channel::ToeStress => Quantity::ToeAxialStress,
            Channel::Slip => Quantity::Slip,
            Channel::AnchorForce => Quantity::AnchorForce,
            _ => return None,
        };
        Some((quantity, info.peak))
    };
    histories.info.iter().filter_map(of)
}

fn values(tank: &CylinderModel, watch: &Watch<'_>) -> BTreeMap<Quantity, f64> {
    let swing = |k: usize| extremes(watch, k).swing().0;
    let rise = |k: usize| {
        let of = extremes(watch, k);
        of.max - of.rest
    };
    let sides = &watch.seen.sides;
    let swing_of = |row: usize| {
        let rows = sides.iter().filter_map(|s| s.hoop.get(row));
        rows.map(|e| e.swing().0).fold(0.0, f64::max)
    };
    let axial = sides.iter().filter_map(|s| s.axial.first().map(|e| e.swing().0)).fold(0.0, f64::max);
    let along = watch.seen.two.along();
    let mut out = BTreeMap::from([
        (Quantity::ImpulsivePeriod, TAU / tank.wall_omega),
        (Quantity::SloshingHeight, rise(WAVE_FRONT).max(rise(WAVE_BACK))),
        (Quantity::BaseShear, swing(BASE_SHEAR)),
        (Quantity::BaseMoment, swing(BASE_MOMENT)),
        (Quantity::AxialMembraneStress, along.map_or(axial, |along| along[2])),
    ]);
    let middles = middles(tank);
    let rows = sides.first().map_or(0, |s| s.hoop.len()).min(middles.len());
    hoop::put(&mut out, (&middles[..rows], tank.depth), swing_of);
    if let Some([wall, rim, _]) = along {
        for (quantity, value) in [(Quantity::HoopStress, wall), (Quantity::RimHoopStress, rim)] {
            out.entry(quantity).and_modify(|own| *own = value);
        }
    }
    if tank.sloshing_omega > 0.0 {
        out.insert(Quantity::SloshingPeriod, TAU / tank.sloshing_omega);
    }
    out
}

/// Heights of the middles of the rows [m].
fn middles(tank: &CylinderModel) -> Vec<f64> {
    tank.cells.z.windows(2).map(|z| 0.5 * (z[0] + z[1])).collect()
}

fn end(tank: &CylinderModel, run: &Run) -> End {
    match &run.outcome {
        Outcome::Completed => End::Completed,
        Outcome::Interrupted | Outcome::Stopped { .. } => End::Interrupted { time: run.time },
        Outcome::Collapsed(collapse) => {
            let node = collapse.worst.map(|(node, _)| node);
            let node = node.or(collapse.element.map(|e| tank.model.elements()[e].nodes()[0]));
            End::Collapsed {
                time: collapse.time,
                load_factor: collapse.load_factor,
                reason: collapse.failure.to_string(),
                place: node.map_or(String::new(), |n| {
                    let [x, y, z] = tank.model.nodes()[n];
                    place(y.atan2(x), z)
                }),
            }
        }
    }
}

fn envelopes(tank: &CylinderModel, watch: &Watch<'_>) -> Vec<Envelope> {
    let z = middles(tank);
    let front = &watch.seen.sides[0];
    [(OnWall::Hoop, &front.hoop), (OnWall::Axial, &front.axial)]
        .into_iter()
        .map(|(what, list)| Envelope {
            id: what.id().into(),
            title: what.title().into(),
            dimension: what.dimension(),
            z: z[..list.len()].to_vec(),
            static_: list.iter().map(|e| e.rest).collect(),
            min: list.iter().map(|e| e.min - e.rest).collect(),
            max: list.iter().map(|e| e.max - e.rest).collect(),
        })
        .collect()
}
