//! Observer of a run.
//!
//! At every sample of the record: histories, the meridians next to θ = 0 and θ = π, the pressure on the wall. At every **look**
//! (at intervals, and when the base moment has grown by `GROWN`): all material points.

use fem::analysis::AnalysisError;
use fem::analysis::checkpoint::{CheckpointError, Reader, Writer};
use fem::analysis::march::{Instant, Observe, QuantityObserver};
use fem::dofs::Dof;
use fem::element::{Inspect, SectionState};
use fem::linalg::Matrix;
use fem::liquid::separation::{Openings, SeparationCheck};
use fem::state::Gather;
use serde::{Deserialize, Serialize};

use super::around::AroundSeen;
use super::contact::rise;
use super::meridian::{Extremes, Meridian};
use super::model::CylinderModel;
use super::pictures::Pictures;
use super::points::{Happening, Look, look};
use super::recorded::{BASE_MOMENT, WAVE_BACK, WAVE_FRONT, quantities};
use super::two::{self, MOMENT_Y, TwoSeen};

/// A base moment larger than that of the last picture by this factor gives a new one.
const GROWN: f64 = 1.05;

/// A picture kept.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub(crate) struct Kept {
    /// Time [s].
    pub time: f64,
    /// Base moment then [N m].
    pub moment: f64,
    /// The observations.
    pub look: Look,
}

/// What the foot of a wall on its bottom goes through, at the samples.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
pub(crate) struct StandingSeen {
    /// Plastic rotation of the joint at θ = 0 and π, positive where the plate lifts [rad].
    pub joint: [Vec<f64>; 2],
    /// Force of the anchor that pulls most [N].
    pub anchor: Vec<f64>,
    /// The largest elongation from the ground of an anchor, its play included [m], with its time [s] and angle [rad].
    pub stretched: (f64, f64, f64),
    /// Largest plastic elongation of an anchor [m].
    pub plastic: f64,
}

/// Observations so far, without those that the parts of [`Watch`] store.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
pub(crate) struct Seen {
    /// Meridians next to θ = 0 and π.
    pub sides: [Meridian; 2],
    /// The static state.
    pub rest: Option<Look>,
    /// The largest base moment.
    pub extreme: Option<Kept>,
    /// Time of the next look [s].
    next: f64,
    /// Largest values of quantities that can decrease, cell by cell.
    pub worst: Option<Look>,
    /// First time [s] and cell of each kind of event.
    pub first: Vec<(Happening, f64, usize)>,
    /// Number of looks.
    pub looks: usize,
    /// Waves around an imperfect wall.
    #[serde(default)]
    pub around: AroundSeen,
    /// Two horizontal components.
    #[serde(default)]
    pub two: TwoSeen,
    /// An unanchored wall, or one on anchors.
    #[serde(default)]
    pub standing: StandingSeen,
    /// Largest radial displacement of the wall at a sample, the static state included [m], and its time [s].
    pub displacement: (f64, f64),
}

/// Watches a run.
pub(crate) struct Watch<'a> {
    tank: &'a CylinderModel,
    /// Time between looks [s].
    interval: f64,
    /// Histories.
    pub recorder: QuantityObserver,
    /// Numbers of the translation and the rotation of a slab that moves among them.
    pub foundation: Option<[usize; 2]>,
    /// The observations.
    pub seen: Seen,
    /// Where bonded liquid would separate from the wall; unused where the contact opens.
    pub separation: SeparationCheck,
    /// Where it has separated from the wall, at the points of the joints.
    pub openings: Option<Openings>,
    /// Equations of the liquid's unknowns.
    unknowns: Vec<Option<usize>>,
    /// cos θ and sin θ of each wetted node.
    directions: Vec<[f64; 2]>,
    /// Columns of the fan of meridians with two horizontal components, but for the sides; none with one.
    fan: Option<Vec<usize>>,
    /// Rise of each wetted particle under unit amplitudes.
    rise: Matrix,
    /// States for pictures, where they are asked for.
    pub pictures: Option<Pictures<'a>>,
    /// Failure of an element that was asked.
    pub failure: Option<AnalysisError>,
}

impl<'a> Watch<'a> {
    /// Watches with looks every `interval` [s], `two` horizontal components or one.
    ///
    /// Errors: those of the elements.
    pub(crate) fn new(tank: &'a CylinderModel, interval: f64, two: bool) -> Result<Watch<'a>, AnalysisError> {
        let heights: Vec<f64> = tank.wetted.iter().map(|&n| tank.model.nodes()[n][2]).collect();
        let angles: Vec<f64> = tank
            .wetted
            .iter()
            .map(|&n| {
                let [x, y, _] = tank.model.nodes()[n];
                y.atan2(x)
            })
            .collect();
        let mut recorded = quantities(tank)?;
        if two {
            recorded.extend(two::quantities(tank)?);
        }
        let foundation = tank.slab.as_ref().map(|slab| {
            let first = recorded.len();
            recorded.extend(slab.motion());
            [first, first + 1]
        });
        let fan = two.then(|| two::fan(&tank.cells));
        let others = fan.as_ref().map_or(0, Vec::len);
        Ok(Watch {
            recorder: QuantityObserver::new(recorded),
            foundation,
            separation: SeparationCheck::new(tank.unit_weight, tank.depth, heights.clone()),
            unknowns: tank.liquid_unknowns(),
            directions: angles.iter().map(|t| [t.cos(), t.sin()]).collect(),
            fan,
            rise: rise(&tank.liquid, tank.gravity, tank.depth, &heights, &angles),
            openings: tank.joints.as_ref().map(|j| Openings::new(j.heights(), j.areas.clone())),
            seen: Seen { two: TwoSeen::new(others), ..Seen::default() },
            tank,
            interval,
            pictures: None,
            failure: None,
        })
    }

    /// Factor from the computed part to the whole tank.
    pub(crate) fn copies(&self) -> f64 {
        self.tank.cells.copies()
    }

    /// A look at the committed state.
    fn look(&mut self, now: &Instant<'_>) -> Look {
        let found = look(self.tank, now.state);
        self.seen.looks += 1;
        for (what, cell) in found.happenings() {
            if !self.seen.first.iter().any(|f| f.0 == what) {
                self.seen.first.push((what, now.time, cell));
            }
        }
        match &mut self.seen.worst {
            Some(worst) => worst.envelop(&found),
            None => self.seen.worst = Some(found.clone()),
        }
        found
    }

    /// Section states of a cell, its hoop and its axial stress [Pa]: means of the points of each shell, sums over the shells.
    fn cell(
        &self,
        now: &Instant<'_>,
        gather: &mut Gather,
        row: usize,
        column: usize,
    ) -> Result<(Vec<SectionState>, [f64; 2]), AnalysisError> {
        let e = self.tank.wall.rows[row][column];
        let element = &*self.tank.model.elements()[e];
        let motion = gather.motion(&self.tank.model, &now.state.committed, element);
        let states = element
            .sections(motion, &now.state.old[now.state.history(e)])
            .map_err(|source| AnalysisError::Element { number: e, source })?;
        let thickness = self.tank.rows[row].thickness;
        let stress = [0, 1].map(|i| sum(&states, |s| s.resultants[i]) / thickness);
        Ok((states, stress))
    }

    fn meridians(&mut self, now: &Instant<'_>) -> Result<(), AnalysisError> {
        let columns = self.tank.cells.columns();
        let opposite = if self.tank.cells.half { columns - 1 } else { columns / 2 };
        let mut gather = Gather::default();
        let fan = self.fan.iter().flatten().copied();
        let all: Vec<usize> = [0, opposite].into_iter().chain(fan).collect();
        for (number, column) in all.into_iter().enumerate() {
            for row in 0..self.tank.cells.rows() {
                let (states, [hoop, axial]) = self.cell(now, &mut gather, row, column)?;
                let meridian = match number.checked_sub(2) {
                    None => &mut self.seen.sides[number],
                    Some(other) => &mut self.seen.two.meridians[other],
                };
                if now.sample.is_some() {
                    let histories = [&mut meridian.hoop_history, &mut meridian.axial_history];
                    for (history, value) in histories.into_iter().zip([hoop, axial]) {
                        history.resize(history.len().max(row + 1), Vec::new());
                        history[row].push(value);
                    }
                }
                for (list, value) in [(&mut meridian.hoop, hoop), (&mut meridian.axial, axial)] {
                    match list.get_mut(row) {
                        Some(extremes) => extremes.include(value, now.time),
                        None => list.push(Extremes::start(value)),
                    }
                }
                if row == 0 && now.sample.is_some() {
                    let shells = (states.len() as f64 / POINTS).max(1.0);
                    meridian.curvature.push(sum(&states, |s| s.strain[4]) / shells);
                    meridian.moment.push(sum(&states, |s| s.resultants[4]));
                    meridian.base_axial.push(axial);
                }
            }
        }
        Ok(())
    }

    /// Stresses of all cells, with two horizontal components.
    fn stresses(&mut self, now: &Instant<'_>) -> Result<(), AnalysisError> {
        if self.fan.is_none() {
            return Ok(());
        }
        let cells = &self.tank.cells;
        let mut gather = Gather::default();
        let (mut hoop, mut axial) = (Vec::new(), Vec::new());
        for row in 0..cells.rows() {
            for column in 0..cells.columns() {
                let (_, [around, along]) = self.cell(now, &mut gather, row, column)?;
                hoop.push(around);
                axial.push(along);
            }
        }
        self.seen.two.stresses((cells, self.tank.depth), [&hoop, &axial], now.time);
        Ok(())
    }

    fn standing(&mut self, now: &Instant<'_>) -> Result<(), AnalysisError> {
        let Some(standing) = &self.tank.standing else { return Ok(()) };
        let seen = &mut self.seen.standing;
        for (history, value) in seen.joint.iter_mut().zip(standing.plastic(self.tank, now.state)?) {
            history.push(value);
        }
        if let Some(pulled) = standing.pulled(self.tank, now.state) {
            seen.anchor.push(pulled.force);
            seen.plastic = seen.plastic.max(pulled.plastic);
            if pulled.height > seen.stretched.0 {
                seen.stretched = (pulled.height, now.time, pulled.angle);
            }
        }
        Ok(())
    }

    fn displacement(&mut self, now: &Instant<'_>) {
        let model = &self.tank.model;
        for &node in &self.tank.wall.inner {
            let [x, y, _] = model.nodes()[node];
            let own = model.at_node(&now.state.committed.u, node);
            let radial = (own[Dof::Ux.index()] * x + own[Dof::Uy.index()] * y).abs() / self.tank.radius;
            if radial > self.seen.displacement.0 {
                self.seen.displacement = (radial, now.time);
            }
        }
    }

    fn pressures(&mut self, now: &Instant<'_>) {
        let fields = &now.state.committed;
        let wall = self.tank.liquid.wall();
        let of = |values: &[f64]| -> Vec<f64> {
            let at = |e: &Option<usize>| e.map_or(0.0, |e| values[e]);
            self.unknowns.iter().map(at).collect()
        };
        let mut a = of(&fields.a);
        for (a, [c, s]) in a.iter_mut().zip(&self.directions) {
            *a += c * now.ground[0] + s * now.ground[1];
        }
        let heights: Vec<f64> = self.tank.wetted.iter().map(|&n| self.tank.model.nodes()[n][2]).collect();
        let on_slab = self.tank.slab.as_ref().map(|slab| {
            let places = heights.iter().copied().zip(self.directions.iter().copied());
            slab.accelerate(&fields.a, &mut a, places)
        });
        let u = of(&fields.u);
        let mut force = self.tank.liquid.forces(&a, &u);
        force.iter_mut().zip(on_slab.iter().flatten()).for_each(|(f, own)| *f += own);
        let rises = self.rise.times(&u[wall..]);
        let vertical = now.ground[2] * self.tank.unit_weight / self.tank.gravity;
        let depth = self.tank.depth;
        let pressure = |i: usize| {
            let area = self.tank.areas[i];
            let own = if area > 0.0 { -force[i] / area } else { 0.0 };
            own + vertical * (depth - heights[i])
        };
        let last = |k: usize| self.recorder.histories[k].last().copied().unwrap_or(0.0);
        let sides = || last(WAVE_FRONT).min(last(WAVE_BACK));
        let lowest = two::trough(&self.recorder).unwrap_or_else(sides).min(0.0);
        self.separation.see(now.time, pressure, |i| rises[i], lowest);
    }

    fn watch(&mut self, now: &Instant<'_>) -> Result<(), AnalysisError> {
        self.recorder.see(now);
        if self.fan.is_some() {
            self.seen.two.see(&self.recorder, now);
        }
        // At every step: a period of the wall may be three samples of the record.
        self.seen.around.see(self.tank, &now.state.committed.u, now.time);
        if now.sample.is_none() {
            return Ok(());
        }
        if let Some(pictures) = &mut self.pictures {
            pictures.see(now)?;
        }
        self.meridians(now)?;
        self.stresses(now)?;
        self.standing(now)?;
        self.displacement(now);
        match (&self.tank.joints, &mut self.openings) {
            (Some(joints), Some(openings)) => openings.see(now.time, joints.look(&self.tank.model, now.state)),
            _ => self.pressures(now),
        }
        let last = |k: usize| self.recorder.histories.get(k).and_then(|h| h.last()).copied();
        let across = self.fan.as_ref().and_then(|_| last(MOMENT_Y));
        let moment = match (last(BASE_MOMENT).unwrap_or(0.0), across) {
            (along, None) => along.abs(),
            (along, Some(across)) => along.hypot(across),
        };
        let grown = self.seen.extreme.as_ref().is_some_and(|k| moment > GROWN * k.moment);
        if self.seen.rest.is_none() {
            let found = self.look(now);
            self.seen.rest = Some(found.clone());
            self.seen.extreme = Some(Kept { time: now.time, moment, look: found });
            self.seen.next = self.interval;
        } else if grown || now.time >= self.seen.next * (1.0 - 1e-9) {
            let found = self.look(now);
            if grown {
                self.seen.extreme = Some(Kept { time: now.time, moment, look: found });
            }
            while self.seen.next <= now.time * (1.0 + 1e-9) {
                self.seen.next += self.interval;
            }
        }
        Ok(())
    }
}

impl Observe for Watch<'_> {
    fn see(&mut self, now: &Instant<'_>) {
        if self.failure.is_none() {
            self.failure = self.watch(now).err();
        }
    }

    fn stop(&self) -> Option<String> {
        self.failure.as_ref().map(ToString::to_string)
    }

    fn save(&self, to: &mut Writer) {
        self.recorder.save(to);
        self.separation.save(to);
        if let Some(openings) = &self.openings {
            openings.save(to);
        }
        if let Some(pictures) = &self.pictures {
            pictures.save(to);
        }
        // Plain numbers: writing cannot fail.
        to.text(&serde_json::to_string(&self.seen).unwrap_or_default());
    }

    fn restore(&mut self, from: &mut Reader) -> Result<(), CheckpointError> {
        self.recorder.restore(from)?;
        self.separation.restore(from)?;
        if let Some(openings) = &mut self.openings {
            openings.restore(from)?;
        }
        if let Some(pictures) = &mut self.pictures {
            pictures.restore(from)?;
        }
        let text = from.text()?;
        self.seen = serde_json::from_str(&text).map_err(|e| CheckpointError::Shape {
            what: "what was seen",
            found: text.len(),
            allowed: e.column(),
        })?;
        Ok(())
    }
}

/// Integration points of a cell of one shell.
const POINTS: f64 = 4.0;

/// Mean over the points of each shell, sum over the shells.
fn sum(states: &[SectionState], of: impl Fn(&SectionState) -> f64) -> f64 {
    states.iter().map(of).sum::<f64>() / POINTS
}
