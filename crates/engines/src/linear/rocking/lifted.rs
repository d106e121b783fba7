//! The wall on the moving base in place of the wall held down: model, values and demands.
//!
//! A and ψ̈ of the march drive the modes ([`Turned`]). What goes with cos θ is theirs; the axial stress at the foot does not: at the toe and
//! at the lifted side it is the force of the strips. Its excess over the part with cos θ is added over the whole lowest course, half of it all
//! around and half with cos θ, so that both sides have it and nothing between them is below a straight line in cos θ.

use std::collections::BTreeMap;

use results::channel::{OnWall as Line, Side};
use results::{Channel, Envelope, Finding};
use tank::Quantity;
use tank::case::GroundMotion;
use tank::demand::{Demands, FreeBase, OnWall as Stress, Peak};
use tank::options::linear::Integrator;

use super::super::analysis::Analysis;
use super::super::demands::{combine, stride};
use super::super::model::Model;
use super::super::turned::Turned;
use super::outcome::Moved;
use crate::FeError;
use crate::histories::Histories;
use crate::response::observe::Extreme;

/// Values that depend on how the base moves.
const MOVING: [Quantity; 8] = [
    Quantity::SloshingHeight,
    Quantity::BaseShear,
    Quantity::BaseMoment,
    Quantity::OverturningMoment,
    Quantity::HoopStress,
    Quantity::RimHoopStress,
    Quantity::AxialMembraneStress,
    Quantity::BendingStress,
];

/// What a base that moves adds to the comparable values.
pub(crate) fn of_base(found: &[Finding], values: &mut BTreeMap<Quantity, f64>) {
    for &quantity in Quantity::OF_BASE {
        if let Some(own) = found.iter().find(|own| own.id == quantity.id()) {
            values.insert(quantity, own.value.value);
        }
    }
}

impl Moved {
    /// The model on the moving base.
    pub(crate) fn model(&self, model: &Model) -> Model {
        let motion = &self.motion;
        let [along, rotation] = [&motion.acceleration, &motion.rotation].map(Vec::clone);
        Model { turned: Some(Turned::new(&model.horizontal, &motion.grid, along, rotation)), ..model.clone() }
    }

    /// Replaces the values that are not superposed, and completes the results with the superposed ones.
    ///
    /// * `values`: those of `analysis`, on the moving base
    /// * `held`: those of the wall held down
    pub(crate) fn complete(
        &mut self,
        analysis: &Analysis<'_>,
        values: &mut BTreeMap<Quantity, f64>,
        held: &BTreeMap<Quantity, f64>,
    ) {
        // The foot of the run is built in; that of the tank is the joint of the bottom plate.
        values.remove(&Quantity::BendingStress);
        let (axial, at) = self.foot_stress();
        values.insert(Quantity::AxialMembraneStress, axial);
        of_base(&self.result.quantities, values);
        if self.result.friction.is_none() {
            // It is held in place, which says nothing about slip.
            values.remove(&Quantity::Slip);
        }
        let moving = |quantity: &Quantity| MOVING.contains(quantity);
        let held = held.iter().filter(|(quantity, _)| moving(quantity));
        self.result.held = held.map(|(quantity, value)| (quantity.id().to_owned(), *value)).collect();
        let peak = |channel| {
            analysis
                .sides(channel)
                .map(|(front, back)| if back.peak().0 > front.peak().0 { back } else { front }.peak())
        };
        let mut off = 0.0_f64;
        for (channel, march) in [(Channel::BaseShear, self.march[0]), (Channel::BaseMoment, self.march[1])] {
            if let (Some((found, _)), true) = (peak(channel), march > 0.0) {
                off = off.max((found / march - 1.0).abs());
            }
        }
        self.result.superposition = off;
        for quantity in MOVING {
            let Some(&value) = values.get(&quantity) else { continue };
            let time = match quantity {
                Quantity::BaseShear => peak(Channel::BaseShear).map(|p| p.1),
                Quantity::BaseMoment => peak(Channel::BaseMoment).map(|p| p.1),
                Quantity::OverturningMoment => peak(Channel::OverturningMoment).map(|p| p.1),
                Quantity::AxialMembraneStress => Some(at),
                Quantity::SloshingHeight => rise(analysis),
                _ => None,
            };
            let own = Finding {
                time,
                z: place(analysis, quantity),
                ..Finding::new(quantity.id(), value, quantity.dimension())
            };
            match self.result.quantities.iter_mut().find(|q| q.id == own.id) {
                Some(same) => *same = own,
                None => self.result.quantities.push(own),
            }
        }
    }

    /// Largest axial stress of the motion at the foot [Pa], without that at rest, and its time [s].
    fn foot_stress(&self) -> (f64, f64) {
        let mut found = (0.0, 0.0);
        for side in &self.foot {
            let rest = side.first().copied().unwrap_or(0.0);
            for (i, stress) in side.iter().enumerate() {
                if (stress - rest).abs() > found.0 {
                    found = ((stress - rest).abs(), i as f64 * self.motion.grid.h());
                }
            }
        }
        found
    }

    /// Puts the forces of the strips into the demands of the wall, and adds those of the base.
    ///
    /// * `model`: that of the wall held down, `moving` that on the moving base
    ///
    /// Errors: a response that is not finite.
    pub(crate) fn demands(
        &self,
        demands: &mut Demands,
        (model, moving): (&Model, &Model),
        analysis: &Analysis<'_>,
        motion: &GroundMotion,
    ) -> Result<(), FeError> {
        // The foot is a plastic joint, not built in.
        demands.places.iter_mut().for_each(|place| place.bending = None);
        if let Some(place) = demands.places.iter().find(|place| place.z == 0.0 && place.course == 0) {
            let [even, odd] = self.excess(demands, &place.axial);
            let number = demands.states.len();
            demands.states.extend([even, odd]);
            for place in demands.places.iter_mut().filter(|place| place.course == 0) {
                place.axial.even.push((number, 1.0));
                place.axial.odd.push((number + 1, 1.0));
            }
        }
        let mut held_shear = None;
        if let (true, Some(probe)) = (self.slid, model.horizontal.coupled.probe(Channel::BaseShear)) {
            let grid = moving.grid(motion, Integrator::Modal)?;
            let stride = stride(moving, &grid);
            let records = (&motion.horizontal, motion.vertical.as_ref());
            let kept = &analysis.kept[..model.systems().count()];
            let found = combine(model, kept, records, (grid, stride), &[vec![(0, 1.0, probe)]])?;
            let value = |k: usize| found.terms[0].iter().map(|&(state, c)| c * found.states[state][k]).sum();
            held_shear = Some(vec![(demands.states.len(), 1.0)]);
            demands.states.push((0..demands.times.len()).map(value).collect());
        }
        demands.base = Some(FreeBase {
            lifts: self.value("uplift") > 0.0,
            scatters: self.result.spread.is_some_and(|spread| !spread.repeats()),
            softened: self.suction.is_some_and(|suction| !suction.holds())
                || self.swing.is_some_and(|swing| swing > ::base::FOLLOWED),
            warps: self.suction.is_some() && self.warps_at_once,
            joint: self.joint(),
            anchor: self.anchor(),
            elastic_wall: true,
            broken: self.result.anchors.as_ref().map_or(0, |anchors| anchors.broken),
            held_shear,
        });
        Ok(())
    }

    /// Adds the histories of the base. At the foot the axial stress becomes that of the strips, and bending is left out: the wall of the model is
    /// built in there, that of the tank is not.
    pub(crate) fn add(&self, histories: &mut Histories) {
        let (h, stride) = (self.motion.grid.h(), self.motion.grid.sub_steps.max(1));
        for (i, info) in histories.info.iter_mut().enumerate() {
            let side = match info.channel() {
                Some(Channel::Base(Line::Axial) | Channel::BaseOn(Line::Axial, Side::Front)) => 0,
                Some(Channel::BaseOn(Line::Axial, Side::Back)) => 1,
                _ => continue,
            };
            let foot = &self.foot[side];
            let rest = foot.first().copied().unwrap_or(0.0);
            let column: Vec<f64> = foot.iter().step_by(stride).map(|stress| stress - rest).collect();
            let larger = |most: (f64, usize), (k, stress): (usize, &f64)| match (stress - rest).abs() > most.0 {
                true => ((stress - rest).abs(), k),
                false => most,
            };
            let (peak, at) = foot.iter().enumerate().fold((0.0, 0), larger);
            (info.peak, info.time, info.static_value) = (peak, at as f64 * h, rest);
            if let Some(own) = histories.series.columns.get_mut(i) {
                own.iter_mut().zip(&column).for_each(|(own, stress)| *own = *stress);
            }
        }
        histories.retain(|channel| !is_bending_of_the_foot(channel));
        for (info, column) in &self.columns {
            histories.push(info.clone(), column.clone());
        }
    }

    /// Leaves out the envelopes of bending, and gives that of the axial stress the strips' at the foot, on the side θ = 0.
    pub(crate) fn correct(&self, envelopes: &mut Vec<Envelope>) {
        envelopes.retain(|envelope| ![Line::Bending.id(), Line::Moment.id()].contains(&envelope.id.as_str()));
        let rest = self.foot[0].first().copied().unwrap_or(0.0);
        let (low, high) = self.foot[0]
            .iter()
            .fold((0.0_f64, 0.0_f64), |(low, high), stress| (low.min(stress - rest), high.max(stress - rest)));
        for envelope in envelopes.iter_mut().filter(|envelope| envelope.id == Line::Axial.id()) {
            if envelope.z.first().is_some_and(|z| *z == 0.0) {
                (envelope.static_[0], envelope.min[0], envelope.max[0]) = (rest, low, high);
            }
        }
    }

    fn value(&self, id: &str) -> f64 {
        self.result.quantity(id).map_or(0.0, |q| q.value.value)
    }

    fn anchor(&self) -> Option<Peak> {
        let (found, anchors) = (self.result.quantity("anchor_force")?, self.result.anchors.as_ref()?);
        Some(Peak {
            value: match anchors.broken {
                0 => found.value.value + anchors.stiffness * anchors.plastic_elongation,
                _ => anchors.stiffness * anchors.largest_elongation,
            },
            time: found.time.unwrap_or_default(),
            theta: found.degrees.unwrap_or_default().to_radians(),
        })
    }

    fn joint(&self) -> Option<Peak> {
        let found = self.result.quantity("plastic_rotation")?;
        let own = found.value.value;
        // A run that does not repeat is judged by the largest of its twins.
        let spread = self.result.spread.filter(|spread| !spread.repeats());
        self.yields.then(|| Peak {
            value: spread.map_or(own, |spread| spread.plastic_rotation[1]),
            time: found.time.unwrap_or_default(),
            theta: found.degrees.unwrap_or_default().to_radians(),
        })
    }

    /// Stress of the foot over that which goes with cos θ at the times of the demands: its even and its odd part [Pa].
    fn excess(&self, demands: &Demands, axial: &Stress) -> [Vec<f64>; 2] {
        let odd = demands.history(&axial.odd);
        let at = |values: &[f64], time: f64| {
            let place = time / self.motion.grid.h();
            let left = (place as usize).min(values.len().saturating_sub(2));
            match values.get(left..left + 2) {
                Some([a, b]) => a + (place - left as f64).clamp(0.0, 1.0) * (b - a),
                _ => axial.rest,
            }
        };
        let parts = demands.times.iter().zip(odd).map(|(&time, odd)| {
            let front = at(&self.foot[0], time) - (axial.rest + odd);
            let back = at(&self.foot[1], time) - (axial.rest - odd);
            (0.5 * (front + back), 0.5 * (front - back))
        });
        let (even, odd): (Vec<f64>, Vec<f64>) = parts.unzip();
        [even, odd]
    }
}

/// Bending moment, bending stress or shear of the wall at its foot.
fn is_bending_of_the_foot(channel: Channel) -> bool {
    let bent = |what: Line| matches!(what, Line::Bending | Line::Moment | Line::Shear);
    match channel {
        Channel::Base(what) | Channel::BaseOn(what, _) | Channel::BaseAtAngle { what, .. } => bent(what),
        _ => false,
    }
}

/// Height of the largest hoop stress of the wall or of its rim [m]; none of other quantities.
fn place(analysis: &Analysis<'_>, quantity: Quantity) -> Option<f64> {
    let line = analysis.line(Line::Hoop)?;
    let place = match quantity {
        Quantity::HoopStress => line.worst(),
        Quantity::RimHoopStress => line.rim()?,
        _ => return None,
    };
    line.z.get(place).copied()
}

/// Time of the largest rise of the surface at the wall [s].
fn rise(analysis: &Analysis<'_>) -> Option<f64> {
    let found = |side| {
        let scalar = analysis.scalars.iter().find(|(s, _)| s.channel == Channel::Wave(side));
        scalar.map(|(_, history)| history.extreme)
    };
    let [front, back] = Side::BOTH.map(found);
    let larger = |a: Extreme, b: Extreme| if b.max > a.max { b.max_time } else { a.max_time };
    Some(larger(front?, back?))
}
