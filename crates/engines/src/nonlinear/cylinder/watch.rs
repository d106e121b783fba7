//! Observer of a run.
//!
//! At every sample of the record: histories, the meridians next to θ = 0 and θ = π, the pressure on the wall. At every **look**
//! (at intervals, and when the base moment has grown by `GROWN`): all material points.

use fem::analysis::AnalysisError;
use fem::analysis::checkpoint::{CheckpointError, Reader, Writer};
use fem::analysis::damping::Rayleigh;
use fem::analysis::march::{Instant, Observe, Quantity, QuantityObserver, Reaction};
use fem::analysis::observable::Observable;
use fem::dofs::{Dof, KINDS};
use fem::element::Inspect;
use fem::linalg::Matrix;
use fem::liquid::separation::{Openings, SeparationCheck};
use fem::state::Gather;
use serde::{Deserialize, Serialize};

use super::around::AroundSeen;
use super::contact::rise;
use super::model::CylinderModel;
use super::points::{Happening, Look, look};

/// A base moment larger than that of the last picture by this factor gives a new one.
const GROWN: f64 = 1.05;

/// Numbers of the recorded quantities.
pub(super) const BASE_SHEAR: usize = 0;
/// Moment about the y axis at the base.
pub(super) const BASE_MOMENT: usize = 1;
/// Elevation of the surface at the wall, θ = 0.
pub(super) const WAVE_FRONT: usize = 2;
/// The same at θ = π.
pub(super) const WAVE_BACK: usize = 3;
/// Radial displacement of the top of the wall, θ = 0.
pub(super) const TOP_FRONT: usize = 4;
/// Displacement along x of the wall's node that bulges most in the static state.
pub(super) const BELLY_FRONT: usize = 5;

/// [`TOP_FRONT`] and [`BELLY_FRONT`] at θ = π, outwards.
pub(super) const TOP_BACK: usize = 6;
/// See [`TOP_BACK`].
pub(super) const BELLY_BACK: usize = 7;

/// Smallest and largest value with their times.
#[derive(Clone, Copy, Debug, Default, PartialEq, Serialize, Deserialize)]
pub(crate) struct Extremes {
    /// In the static state.
    pub rest: f64,
    /// Smallest.
    pub min: f64,
    /// Its time [s].
    pub min_time: f64,
    /// Largest.
    pub max: f64,
    /// Its time [s].
    pub max_time: f64,
}

impl Extremes {
    fn start(value: f64) -> Extremes {
        Extremes {
            rest: value,
            min: value,
            min_time: 0.0,
            max: value,
            max_time: 0.0,
        }
    }

    fn include(&mut self, value: f64, time: f64) {
        if value < self.min {
            (self.min, self.min_time) = (value, time);
        }
        if value > self.max {
            (self.max, self.max_time) = (value, time);
        }
    }

    /// Largest distance from the static state, and its time.
    pub(crate) fn swing(&self) -> (f64, f64) {
        let (down, up) = (self.rest - self.min, self.max - self.rest);
        if up >= down {
            (up, self.max_time)
        } else {
            (down, self.min_time)
        }
    }
}

/// A meridian of cells.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
pub(crate) struct Meridian {
    /// Hoop force over the thickness of the shells, by row [Pa].
    pub hoop: Vec<Extremes>,
    /// Axial force over it [Pa].
    pub axial: Vec<Extremes>,
    /// Hoop stress at the samples, by row [Pa].
    pub hoop_history: Vec<Vec<f64>>,
    /// Axial stress at the samples, by row [Pa].
    pub axial_history: Vec<Vec<f64>>,
    /// Meridional curvature of the lowest cell at the samples [1/m].
    pub curvature: Vec<f64>,
    /// Meridional moment there [N].
    pub moment: Vec<f64>,
    /// Axial force there over the thickness [Pa].
    pub base_axial: Vec<f64>,
}

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
    /// The observations.
    pub seen: Seen,
    /// Where bonded liquid would separate from the wall; unused where the contact opens.
    pub separation: SeparationCheck,
    /// Where it has separated from the wall, at the points of the joints.
    pub openings: Option<Openings>,
    /// Equations of the liquid's unknowns.
    unknowns: Vec<Option<usize>>,
    /// cos θ of each wetted node.
    cosine: Vec<f64>,
    /// Rise of each wetted particle under unit amplitudes.
    rise: Matrix,
    /// Failure of an element that was asked.
    pub failure: Option<AnalysisError>,
}

impl<'a> Watch<'a> {
    /// Watches with looks every `interval` [s].
    ///
    /// Errors: those of the elements.
    pub(crate) fn new(tank: &'a CylinderModel, interval: f64) -> Result<Watch<'a>, AnalysisError> {
        let heights: Vec<f64> = tank.wetted.iter().map(|&n| tank.model.nodes()[n][2]).collect();
        let angles: Vec<f64> = tank
            .wetted
            .iter()
            .map(|&n| {
                let [x, y, _] = tank.model.nodes()[n];
                y.atan2(x)
            })
            .collect();
        Ok(Watch {
            recorder: QuantityObserver::new(quantities(tank)?),
            separation: SeparationCheck::new(tank.unit_weight, tank.depth, heights.clone()),
            unknowns: tank.liquid_unknowns(),
            cosine: angles.iter().map(|t| t.cos()).collect(),
            rise: rise(&tank.liquid, tank.gravity, tank.depth, &heights, &angles),
            openings: tank
                .joints
                .as_ref()
                .map(|j| Openings::new(j.heights(), j.areas.clone())),
            seen: Seen::default(),
            tank,
            interval,
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

    fn meridians(&mut self, now: &Instant<'_>) -> Result<(), AnalysisError> {
        let columns = self.tank.cells.columns();
        let opposite = if self.tank.cells.half { columns - 1 } else { columns / 2 };
        let mut gather = Gather::default();
        for (side, column) in [0, opposite].into_iter().enumerate() {
            for row in 0..self.tank.cells.rows() {
                let e = self.tank.wall.rows[row][column];
                let element = &*self.tank.model.elements()[e];
                let motion = gather.motion(&self.tank.model, &now.state.committed, element);
                let states = element
                    .sections(motion, &now.state.old[now.state.history(e)])
                    .map_err(|source| AnalysisError::Element { number: e, source })?;
                // Mean of the points of each shell, sum over the shells.
                let points = 4.0;
                let sum = |f: &dyn Fn(&fem::element::SectionState) -> f64| states.iter().map(f).sum::<f64>() / points;
                let thickness = self.tank.rows[row].thickness;
                let (hoop, axial) = (
                    sum(&|s| s.resultants[0]) / thickness,
                    sum(&|s| s.resultants[1]) / thickness,
                );
                let meridian = &mut self.seen.sides[side];
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
                    let shells = (states.len() as f64 / points).max(1.0);
                    meridian.curvature.push(sum(&|s| s.strain[4]) / shells);
                    meridian.moment.push(sum(&|s| s.resultants[4]));
                    meridian.base_axial.push(axial);
                }
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
        let wall = self.tank.wetted.len();
        let of = |values: &[f64]| -> Vec<f64> {
            let at = |e: &Option<usize>| e.map_or(0.0, |e| values[e]);
            self.unknowns.iter().map(at).collect()
        };
        let mut a = of(&fields.a);
        for (a, c) in a.iter_mut().zip(&self.cosine) {
            *a += c * now.ground[0];
        }
        let u = of(&fields.u);
        let force = self.tank.liquid.forces(&a, &u);
        let rises = self.rise.times(&u[wall..]);
        let vertical = now.ground[2] * self.tank.unit_weight / self.tank.gravity;
        let depth = self.tank.depth;
        let heights: Vec<f64> = self
            .tank
            .wetted
            .iter()
            .map(|&n| self.tank.model.nodes()[n][2])
            .collect();
        let pressure = |i: usize| {
            let area = self.tank.areas[i];
            let own = if area > 0.0 { -force[i] / area } else { 0.0 };
            own + vertical * (depth - heights[i])
        };
        let last = |k: usize| self.recorder.histories[k].last().copied().unwrap_or(0.0);
        let lowest = last(WAVE_FRONT).min(last(WAVE_BACK)).min(0.0);
        self.separation.see(now.time, pressure, |i| rises[i], lowest);
    }

    fn watch(&mut self, now: &Instant<'_>) -> Result<(), AnalysisError> {
        self.recorder.see(now);
        if now.sample.is_none() {
            return Ok(());
        }
        self.meridians(now)?;
        self.displacement(now);
        self.seen.around.see(self.tank, &now.state.committed.u, now.time);
        match (&self.tank.joints, &mut self.openings) {
            (Some(joints), Some(openings)) => openings.see(now.time, joints.look(&self.tank.model, now.state)),
            _ => self.pressures(now),
        }
        let moment = self.recorder.histories[BASE_MOMENT].last().map_or(0.0, |m| m.abs());
        let grown = self.seen.extreme.as_ref().is_some_and(|k| moment > GROWN * k.moment);
        if self.seen.rest.is_none() {
            let found = self.look(now);
            self.seen.rest = Some(found.clone());
            self.seen.extreme = Some(Kept {
                time: now.time,
                moment,
                look: found,
            });
            self.seen.next = self.interval;
        } else if grown || now.time >= self.seen.next * (1.0 - 1e-9) {
            let found = self.look(now);
            if grown {
                self.seen.extreme = Some(Kept {
                    time: now.time,
                    moment,
                    look: found,
                });
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
        // Plain numbers: writing cannot fail.
        to.text(&serde_json::to_string(&self.seen).unwrap_or_default());
    }

    fn restore(&mut self, from: &mut Reader) -> Result<(), CheckpointError> {
        self.recorder.restore(from)?;
        self.separation.restore(from)?;
        if let Some(openings) = &mut self.openings {
            openings.restore(from)?;
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

/// Recorded quantities, those of half a tank doubled where they are sums.
fn quantities(tank: &CylinderModel) -> Result<Vec<Quantity>, AnalysisError> {
    let base: Vec<usize> = tank.footprint.levels[0]
        .iter()
        .flat_map(|&p| [Some(&tank.wall.inner), Some(&tank.wall.outer)].map(|l| l.and_then(|l| l.get(p)).copied()))
        .flatten()
        // The force of the liquid at the base of the wall goes into the ground there.
        .chain(tank.wetted[..tank.footprint.levels[0].len()].iter().copied())
        .collect();
    let copies = tank.cells.copies();
    let at_base = |field: [f64; KINDS]| {
        let base = &base;
        move |node: usize| match base.contains(&node) {
            true => field.map(|v| copies * v),
            false => [0.0; KINDS],
        }
    };
    let rayleigh = |e: usize| -> Rayleigh { tank.rayleigh[tank.model.group_of(e)] };
    let mut sideways = [0.0; KINDS];
    sideways[Dof::Ux.index()] = 1.0;
    let shear = Reaction::new(tank.problem(), "base shear", at_base(sideways), rayleigh)?;
    let nodes = tank.model.nodes();
    let turning = |node: usize| {
        let mut field = [0.0; KINDS];
        if base.contains(&node) {
            field[Dof::Uz.index()] = -copies * nodes[node][0];
            field[Dof::Ry.index()] = copies;
        }
        field
    };
    let moment = Reaction::new(tank.problem(), "base moment", turning, rayleigh)?;
    let levels = &tank.footprint.levels;
    let row = |name: &str, row| {
        Quantity::Linear(Observable {
            name: name.into(),
            displacement: row,
            ..Observable::default()
        })
    };
    let at = |level: usize| tank.wall.inner[levels[level][0]];
    let belly = levels.len() / 3;
    // Half a wall has its last meridian at θ = π, a whole one its middle one.
    let back = |level: usize| -> Vec<(usize, f64)> {
        let around = &levels[level];
        let opposite = if tank.cells.half {
            around.len() - 1
        } else {
            around.len() / 2
        };
        let row = tank.model.row(tank.wall.inner[around[opposite]], Dof::Ux);
        row.into_iter().map(|(e, c)| (e, -c)).collect()
    };
    Ok(vec![
        Quantity::Reaction(shear),
        Quantity::Reaction(moment),
        row("wave at θ = 0°", tank.elevation(0.0)),
        row("wave at θ = 180°", tank.elevation(std::f64::consts::PI)),
        row("top of the wall", tank.model.row(at(levels.len() - 1), Dof::Ux)),
        row("lower third of the wall", tank.model.row(at(belly), Dof::Ux)),
        row("top of the wall, θ = 180°", back(levels.len() - 1)),
        row("lower third of the wall, θ = 180°", back(belly)),
    ])
}
