//! Ready observers: histories and ranges of linear observables and of support reactions.

use super::{Instant, Observe, Problem};
use crate::analysis::AnalysisError;
use crate::analysis::checkpoint::{CheckpointError, Reader, Writer};
use crate::analysis::damping::Rayleigh;
use crate::analysis::observable::{Observable, apply};
use crate::assembly::Forces;
use crate::dofs::KINDS;
use crate::element::{Response, Trial, Want};
use crate::state::Gather;

/// Resultant of all support reactions in a rigid motion w of the supports,
///
/// ```text
/// R = Σ w · (f_int + C u̇ + M (ü + Σ ι_k a_k))          over the held dofs
/// ```
///
/// with the nonlinear internal forces; C holds Rayleigh's part of the initial stiffness and the elements' own damping, not the
/// tangent damping. Loads applied to held dofs are not in it.
#[derive(Clone, Debug, PartialEq)]
pub struct Reaction {
    /// (number among the assembler's supports, w).
    rows: Vec<(usize, f64)>,
    /// Inertia and damping.
    moving: Observable,
    /// Elements that stand for the ground, with w in the order of their dofs.
    ground: Vec<(usize, Vec<f64>)>,
}

impl Reaction {
    /// For the rigid motion `field` (global components at every node): (1, 0, 0, …) gives the force along x that the ground
    /// exerts on the model, (z, 0, −x, 0, 1, 0, …) the moment about y. Zero away from a part of the supports picks it out.
    ///
    /// `rayleigh(e)`: coefficients of element e.
    ///
    /// Errors: those of the elements.
    pub fn new(
        problem: Problem<'_>,
        name: &str,
        field: impl Fn(usize) -> [f64; KINDS],
        rayleigh: impl Fn(usize) -> Rayleigh,
    ) -> Result<Reaction, AnalysisError> {
        let model = problem.model;
        let rows = problem.assembler.supports().iter().enumerate();
        let rows = rows.map(|(s, &(node, dof))| (s, model.component(node, dof, &field(node))));
        Ok(Reaction {
            rows: rows.filter(|(_, w)| *w != 0.0).collect(),
            moving: Observable::reaction_of_motion(model, name, field, rayleigh)?,
            ground: Vec::new(),
        })
    }

    /// With the forces of elements that stand for the ground, such as [`Ground`](crate::element::ground::Ground): number of each, and w in
    /// the order of its dofs. One with a history is asked with that of the last step: friction on ground whose pressure has fallen in that step
    /// is lower by as much.
    pub fn with_ground(mut self, elements: Vec<(usize, Vec<f64>)>) -> Reaction {
        self.ground = elements;
        self
    }

    /// Its inertia under a unit acceleration of the ground along x, y and z, of which these are the motions of the unknowns.
    pub fn carried(&self, influence: &[Vec<f64>; 3]) -> [f64; 3] {
        self.moving.total_ground(influence)
    }

    /// With the inertia of further unknowns: those of a base that moves below.
    pub fn with_acceleration(mut self, row: Vec<(usize, f64)>) -> Reaction {
        self.moving.acceleration.extend(row);
        self
    }

    /// −Σ w · f of the elements that stand for the ground; NaN if one fails.
    fn of_ground(&self, now: &Instant<'_>) -> f64 {
        let model = now.problem.model;
        let (mut gather, mut sum) = (Gather::default(), 0.0);
        for (e, w) in &self.ground {
            let element = &*model.elements()[*e];
            let motion = gather.motion(model, &now.state.committed, element);
            let history = &now.state.old[now.state.history(*e)];
            let (mut out, mut new) = (Response::sized(w.len()), history.to_vec());
            match element.respond(Trial { motion, old: history, new: &mut new, want: Want::FORCE }, &mut out) {
                Ok(()) => sum -= w.iter().zip(&out.force).map(|(w, f)| w * f).sum::<f64>(),
                Err(_) => return f64::NAN,
            }
        }
        sum
    }

    fn static_part(&self, forces: &Forces) -> f64 {
        self.rows.iter().map(|&(s, w)| w * forces.support[s]).sum()
    }
}

/// A quantity of a [`QuantityObserver`].
#[derive(Clone, Debug, PartialEq)]
pub enum Quantity {
    /// A linear functional of displacement, velocity and total acceleration.
    Linear(Observable),
    /// A reaction.
    Reaction(Reaction),
}

impl Quantity {
    /// Its name.
    pub fn name(&self) -> &str {
        match self {
            Quantity::Linear(o) => &o.name,
            Quantity::Reaction(r) => &r.moving.name,
        }
    }

    /// Its value.
    pub fn at(&self, now: &Instant<'_>) -> f64 {
        let (row, still) = match self {
            Quantity::Linear(o) => (o, 0.0),
            Quantity::Reaction(r) => (&r.moving, r.static_part(now.forces) + r.of_ground(now)),
        };
        let fields = &now.state.committed;
        let ground = row.total_ground(&now.problem.system.influence);
        let mut y = still + apply(&row.displacement, &fields.u);
        y += apply(&row.velocity, &fields.v) + apply(&row.acceleration, &fields.a);
        y + ground.iter().zip(&now.ground).map(|(b, a)| b * a).sum::<f64>()
    }
}

/// Smallest and largest value over the committed steps, the start included.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Range {
    /// Smallest value.
    pub min: f64,
    /// Its time [s].
    pub min_time: f64,
    /// Largest value.
    pub max: f64,
    /// Its time [s].
    pub max_time: f64,
}

impl Range {
    /// Empty.
    pub const EMPTY: Range = Range { min: f64::INFINITY, min_time: 0.0, max: f64::NEG_INFINITY, max_time: 0.0 };

    /// Takes a value in.
    pub fn include(&mut self, value: f64, time: f64) {
        if value > self.max {
            (self.max, self.max_time) = (value, time);
        }
        if value < self.min {
            (self.min, self.min_time) = (value, time);
        }
    }

    /// Largest absolute value and its time.
    pub fn peak(&self) -> (f64, f64) {
        if self.max.abs() >= self.min.abs() { (self.max.abs(), self.max_time) } else { (self.min.abs(), self.min_time) }
    }
}

/// Histories at the samples, ranges over all steps.
#[derive(Clone, Debug)]
pub struct QuantityObserver {
    quantities: Vec<Quantity>,
    /// Times of the samples reached [s].
    pub times: Vec<f64>,
    /// Value of each quantity at the samples.
    pub histories: Vec<Vec<f64>>,
    /// Range of each quantity.
    pub ranges: Vec<Range>,
}

impl QuantityObserver {
    /// An observer of these quantities.
    pub fn new(quantities: Vec<Quantity>) -> QuantityObserver {
        QuantityObserver {
            times: Vec::new(),
            histories: vec![Vec::new(); quantities.len()],
            ranges: vec![Range::EMPTY; quantities.len()],
            quantities,
        }
    }

    /// The quantities.
    pub fn quantities(&self) -> &[Quantity] {
        &self.quantities
    }
}

impl Observe for QuantityObserver {
    fn see(&mut self, now: &Instant<'_>) {
        if now.sample.is_some() {
            self.times.push(now.time);
        }
        for (k, quantity) in self.quantities.iter().enumerate() {
            let value = quantity.at(now);
            self.ranges[k].include(value, now.time);
            if now.sample.is_some() {
                self.histories[k].push(value);
            }
        }
    }

    fn save(&self, to: &mut Writer) {
        to.numbers(&self.times);
        to.count(self.quantities.len());
        for (history, r) in self.histories.iter().zip(&self.ranges) {
            to.numbers(history);
            to.numbers(&[r.min, r.min_time, r.max, r.max_time]);
        }
    }

    fn restore(&mut self, from: &mut Reader) -> Result<(), CheckpointError> {
        self.times = from.numbers("times")?;
        let found = from.count()?;
        if found != self.quantities.len() {
            return Err(CheckpointError::Shape { what: "recorded quantities", found, allowed: self.quantities.len() });
        }
        for (history, range) in self.histories.iter_mut().zip(&mut self.ranges) {
            *history = from.numbers("a history")?;
            if history.len() != self.times.len() {
                return Err(CheckpointError::Shape {
                    what: "a history",
                    found: history.len(),
                    allowed: self.times.len(),
                });
            }
            let mut r = [0.0; 4];
            from.numbers_into("a range", &mut r)?;
            *range = Range { min: r[0], min_time: r[1], max: r[2], max_time: r[3] };
        }
        Ok(())
    }
}
