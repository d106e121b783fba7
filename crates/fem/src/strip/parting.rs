//! When the liquid parts from a wall, or would if it could: [`SeparationCheck`] where it is joined to the wall, [`Openings`]
//! where it may leave.

use super::StripModel;
use crate::analysis::checkpoint::{CheckpointError, Reader, Writer};
use crate::analysis::march::Instant;
use crate::liquid::separation::{Openings, Parting, SeparationCheck};
use crate::liquid::strip::Place;

impl StripModel {
    /// Unknowns of the liquid in `field`: those of its face, then the amplitudes.
    pub(super) fn face_of(&self, field: &[f64]) -> Vec<f64> {
        let mut out: Vec<f64> = self.face_unknowns(field).collect();
        out.extend(self.amplitudes.iter().map(|&e| field[e]));
        out
    }

    /// The same of the accelerations, those of the face with the acceleration `ground` of the ground [m/s²].
    pub(super) fn face_acceleration(&self, field: &[f64], ground: f64) -> Vec<f64> {
        let mut out = self.face_of(field);
        let each = self.tank.contact.trace().unknowns();
        let face = out[..each * self.face.len()].iter_mut();
        face.step_by(each).for_each(|a| *a += ground);
        out
    }
}

/// Observes one wall.
#[derive(Clone, Debug)]
pub(super) struct PartingObserver {
    /// Middles of the wet elements.
    places: Vec<Place>,
    /// Unknowns of the liquid at rest.
    rest: Vec<f64>,
    check: SeparationCheck,
    openings: Option<Openings>,
}

impl PartingObserver {
    pub(crate) fn new(strip: &StripModel) -> PartingObserver {
        let (tank, liquid) = (&strip.tank, &strip.tank.liquid);
        let middles = tank.levels.windows(2).map(|w| 0.5 * (w[0] + w[1]));
        let heights: Vec<f64> = middles.filter(|z| *z < liquid.depth).collect();
        PartingObserver {
            places: liquid.places(tank.contact.trace(), strip.face_levels(), tank.sloshing, &heights),
            rest: Vec::new(),
            check: SeparationCheck::new(liquid.density * liquid.gravity, liquid.depth, heights),
            openings: strip.joints.as_ref().map(|j| Openings::new(j.heights.clone())),
        }
    }

    /// Looks at one instant.
    pub(crate) fn see(&mut self, strip: &StripModel, now: &Instant<'_>) {
        if let (Some(joints), Some(openings)) = (&strip.joints, &mut self.openings) {
            let touches = joints.look(&strip.model, now.state);
            openings.see(now.time, touches.iter().map(|t| (t.gap, t.penetration)));
            return;
        }
        let fields = &now.state.committed;
        let mut moved = strip.face_of(&fields.u);
        if self.rest.is_empty() {
            self.rest.clone_from(&moved);
        }
        moved.iter_mut().zip(&self.rest).for_each(|(u, rest)| *u -= rest);
        let acceleration = strip.face_acceleration(&fields.a, now.ground[0]);
        let liquid = &strip.tank.liquid;
        let places = &self.places;
        self.check.see(
            now.time,
            |i| {
                let depth = liquid.depth - places[i].height;
                dot(&places[i].pressure, &acceleration) + liquid.density * now.ground[2] * depth
            },
            |i| dot(&places[i].rise, &moved),
            strip.elevation(&fields.u),
        );
    }

    /// The first parting so far.
    pub(crate) fn first(&self) -> Option<Parting> {
        Parting::first(&self.check, self.openings.as_ref())
    }

    /// Writes what was seen to a checkpoint.
    pub(crate) fn save(&self, to: &mut Writer) {
        to.numbers(&self.rest);
        self.check.save(to);
        if let Some(openings) = &self.openings {
            openings.save(to);
        }
    }

    /// Reads it back.
    ///
    /// Errors: a payload that is not its own.
    pub(crate) fn restore(&mut self, from: &mut Reader) -> Result<(), CheckpointError> {
        self.rest = from.numbers("the state at rest")?;
        self.check.restore(from)?;
        match &mut self.openings {
            Some(openings) => openings.restore(from),
            None => Ok(()),
        }
    }
}

fn dot(a: &[f64], b: &[f64]) -> f64 {
    a.iter().zip(b).map(|(a, b)| a * b).sum()
}
