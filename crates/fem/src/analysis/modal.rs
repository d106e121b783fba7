//! Modal superposition, exact for ground motion that is linear between steps, with missing mass.
//!
//! ```text
//! x = Σ φ_j Y_j − Σ r_k a_k          Ÿ_j + 2 ξ_j ω_j Ẏ_j + ω_j² Y_j = −Σ Γ_jk a_k          Γ_jk = φ_jᵀ M ι_k
//! r_k = K⁻¹ M ι_k − Σ φ_j Γ_jk/ω_j²
//! ```
//!
//! with M-normalised modes and the components k of the ground motion. Y_j follows from the exact recurrence of
//! [`oscillator::sdof::Recurrence`]. Modes that are not kept follow the ground statically (the missing mass): their part of
//! K⁻¹ M ι stays in r, and their relative acceleration vanishes, so that ẍ_total = Σ φ_j Ÿ_j + Σ ι_k a_k. They do not
//! replace a mode that vibrates: the impulsive modes must be among those kept.
//!
//! An observable y = d·x + e·ẋ + c·ẍ_total + b·a is a combination of Y_j, Ẏ_j and a_k, and so is its slope (r_k ȧ_k, which
//! is piecewise constant, is left out of velocities):
//!
//! ```text
//! y = Σ (d·φ_j − ω_j² c·φ_j) Y_j + Σ (e·φ_j − 2 ξ_j ω_j c·φ_j) Ẏ_j + Σ [b_k + c·ι_k − d·r_k − Σ c·φ_j Γ_jk] a_k
//! ```
//!
//! Dashpots couple the modes: Ÿ_j gets −Σ D_jk Ẏ_k, and all modes are propagated together.
//!
//! Source: Nigam & Jennings 1969; missing mass after Kennedy 1984 and Clough & Penzien 1993, section 12-6.

mod coupled;

use oscillator::sdof::Recurrence;

use coupled::Propagator;

use super::motion::Grid;
use super::observable::{Observable, apply};
use super::observer::{Chunk, Observed, Observer, Row, Slope};
use super::system::System;
use super::transient::{Load, Snapshot, SnapshotAt};
use super::{AnalysisError, check_length};
use crate::linalg::{Matrix, dot};
use crate::progress::Progress;

/// A system in some of its modes.
#[derive(Clone, Debug, PartialEq)]
pub struct ModalBasis {
    /// ω_j [rad/s].
    pub omega: Vec<f64>,
    /// φ_j column by column, with φᵀ M φ = 1.
    pub vectors: Matrix,
    /// Γ_jk.
    pub participation: Vec<[f64; 3]>,
    /// ι_k: total acceleration of the unknowns per unit ground acceleration without motion relative to the ground.
    pub influence: [Vec<f64>; 3],
    /// r_k; empty for a component without missing mass.
    pub residual: [Vec<f64>; 3],
    /// D of dashpots over the modes; none without them.
    pub coupling: Option<Matrix>,
}

impl ModalBasis {
    /// Modes (M-normalised, a column each) of `system`; `statics[k]` = K⁻¹ M ι_k for the components whose missing mass is
    /// wanted.
    ///
    /// Errors: vectors of wrong length, a frequency that is not positive.
    pub fn new(
        system: &System,
        omega: &[f64],
        vectors: &Matrix,
        statics: [Option<&[f64]>; 3],
    ) -> Result<ModalBasis, AnalysisError> {
        check_length("modes", vectors.rows, system.size())?;
        let participation: Vec<[f64; 3]> = (0..omega.len()).map(|j| system.participation(vectors.column(j))).collect();
        ModalBasis::from_parts(omega, vectors, participation, system.influence.clone(), statics)
    }

    /// A basis of given participation factors (a condensed liquid has its own M ι).
    ///
    /// Errors: as [`ModalBasis::new`].
    pub fn from_parts(
        omega: &[f64],
        vectors: &Matrix,
        participation: Vec<[f64; 3]>,
        influence: [Vec<f64>; 3],
        statics: [Option<&[f64]>; 3],
    ) -> Result<ModalBasis, AnalysisError> {
        if let Some(w) = omega.iter().find(|w| !(**w > 0.0 && w.is_finite())) {
            return Err(AnalysisError::option(
                "modal superposition",
                format!("a mode with ω = {w} rad/s"),
                "positive frequencies",
            ));
        }
        let mut residual: [Vec<f64>; 3] = Default::default();
        for (k, given) in statics.iter().enumerate() {
            let Some(given) = given else { continue };
            check_length("static response", given.len(), vectors.rows)?;
            residual[k] = given.to_vec();
            for (j, w) in omega.iter().enumerate() {
                let factor = participation[j][k] / (w * w);
                for (r, phi) in residual[k].iter_mut().zip(vectors.column(j)) {
                    *r -= factor * phi;
                }
            }
        }
        Ok(ModalBasis {
            omega: omega.to_vec(),
            vectors: vectors.clone(),
            participation,
            influence,
            residual,
            coupling: None,
        })
    }

    /// Number of modes.
    pub fn len(&self) -> usize {
        self.omega.len()
    }

    /// Whether there is no mode.
    pub fn is_empty(&self) -> bool {
        self.omega.is_empty()
    }

    /// Effective masses Γ² of a mode [kg].
    pub fn effective_mass(&self, mode: usize) -> [f64; 3] {
        self.participation[mode].map(|g| g * g)
    }

    /// An observable of displacements and accelerations per unit of pseudo-acceleration of each mode, and the static response of the
    /// missing mass per unit of ground acceleration, under the component `axis`:
    ///
    /// ```text
    /// r_j = Γ_j (c·φ_j − d·φ_j/ω_j²)          r = b + c·ι − d·r_k − Σ c·φ_j Γ_j          Σ r_j + r: everything follows the ground
    /// ```
    pub fn per_acceleration(&self, observable: &Observable, axis: usize) -> (Vec<f64>, f64) {
        let p = self.project(observable);
        let unit = |j: usize| {
            let w = self.omega[j];
            self.participation[j][axis] * (p.acceleration[j] - p.displacement[j] / (w * w))
        };
        let followed: f64 = (0..self.len()).map(|j| p.acceleration[j] * self.participation[j][axis]).sum();
        ((0..self.len()).map(unit).collect(), p.ground[axis] - followed)
    }

    /// An observable's coefficients of (Y_j), (Ẏ_j without its acceleration part), (Ÿ_j) and a_k.
    pub(super) fn project(&self, row: &Observable) -> Projected {
        let on = |sparse: &[(usize, f64)]| -> Vec<f64> {
            (0..self.len()).map(|j| apply(sparse, self.vectors.column(j))).collect()
        };
        let mut ground = row.total_ground(&self.influence);
        for (k, g) in ground.iter_mut().enumerate() {
            if !self.residual[k].is_empty() {
                *g -= apply(&row.displacement, &self.residual[k]);
            }
        }
        Projected {
            displacement: on(&row.displacement),
            velocity: on(&row.velocity),
            acceleration: on(&row.acceleration),
            ground,
        }
    }

    /// The observable over the states Y, Ẏ, a.
    fn row(&self, observable: &Observable, ratios: &[f64]) -> Row {
        let m = self.len();
        let p = self.project(observable);
        let mut row = Row::default();
        let mut slope = Slope::default();
        let mut ground = p.ground;
        // D is symmetric: c·Φ D v = (D Φᵀ c)·v.
        let by_dashpots = self.coupled(&p.acceleration);
        let on_v = |j: usize| p.velocity[j] - 2.0 * ratios[j] * self.omega[j] * p.acceleration[j] - by_dashpots[j];
        let slowed = self.coupled(&(0..m).map(on_v).collect::<Vec<f64>>());
        for j in 0..m {
            let (c, k) = (2.0 * ratios[j] * self.omega[j], self.omega[j] * self.omega[j]);
            let on_y = p.displacement[j] - k * p.acceleration[j];
            let on_v = on_v(j);
            row.value.push((j, on_y));
            slope.states.push((m + j, on_y - c * on_v - slowed[j]));
            if on_v != 0.0 {
                row.value.push((m + j, on_v));
                slope.states.push((j, -k * on_v));
            }
            for (axis, g) in self.participation[j].iter().enumerate() {
                ground[axis] -= p.acceleration[j] * g;
                if on_v * g != 0.0 {
                    slope.states.push((2 * m + axis, -on_v * g));
                }
            }
        }
        for (axis, g) in ground.into_iter().enumerate() {
            if g != 0.0 {
                row.value.push((2 * m + axis, g));
                slope.linear.push((2 * m + axis, g));
            }
        }
        row.slope = Some(slope);
        row
    }

    /// Response to the ground motion of `load` (its forces are rejected) with the damping ratio of every mode: histories of
    /// `scalars`, extremes of `others`. If interrupted, it returns the results so far and `false`.
    ///
    /// Errors: a ratio a mode is missing, nodal forces, a response that is not finite.
    pub fn respond(
        &self,
        ratios: &[f64],
        load: &Load,
        grid: Grid,
        scalars: &[Observable],
        others: &[Observable],
        progress: &dyn Progress,
    ) -> Result<(Observed, bool), AnalysisError> {
        let rows = |list: &[Observable]| -> Vec<Row> { list.iter().map(|o| self.row(o, ratios)).collect() };
        self.check(ratios, load)?;
        let (scalars, others) = (rows(scalars), rows(others));
        let mut observer = Observer::new(&scalars, &others, grid);
        progress.stage("modal superposition", grid.steps() as u64);
        let complete = self.march(ratios, load, grid, |chunk| {
            observer.take(chunk);
            progress.advance((chunk.len - 1) as u64);
            !progress.interrupted()
        })?;
        Ok((observer.finish(), complete))
    }

    /// An observable as a combination of the states of [`ModalBasis::states`]: (number of the state, coefficient).
    pub fn combination(&self, observable: &Observable, ratios: &[f64]) -> Vec<(usize, f64)> {
        self.row(observable, ratios).value
    }

    /// Histories of the states Y_j, Ẏ_j (j = 1 … m) and a_k (k = 1 … 3), 2 m + 3 of them, at the end of every `stride`-th sub-step.
    ///
    /// Errors: as [`ModalBasis::respond`].
    pub fn states(
        &self,
        ratios: &[f64],
        load: &Load,
        grid: Grid,
        stride: usize,
    ) -> Result<Vec<Vec<f64>>, AnalysisError> {
        self.check(ratios, load)?;
        let stride = stride.max(1);
        let history = |_| Vec::with_capacity(grid.steps() / stride + 1);
        let mut out: Vec<Vec<f64>> = (0..2 * self.len() + 3).map(history).collect();
        self.march(ratios, load, grid, |chunk| {
            let kept = chunk.every(stride);
            for (number, history) in out.iter_mut().enumerate() {
                let own = chunk.state(number);
                match stride {
                    1 => history.extend_from_slice(&own[kept.start..]),
                    _ => history.extend(kept.clone().step_by(stride).map(|k| own[k])),
                }
            }
            true
        })?;
        Ok(out)
    }

    /// Displacement, velocity and acceleration, relative to the ground, at the ends of the given sub-steps (ascending).
    ///
    /// Errors: as [`ModalBasis::respond`].
    pub fn fields(
        &self,
        ratios: &[f64],
        load: &Load,
        grid: Grid,
        sub_steps: &[usize],
    ) -> Result<Vec<Snapshot>, AnalysisError> {
        self.check(ratios, load)?;
        let mut out: Vec<Snapshot> = Vec::new();
        self.march(ratios, load, grid, |chunk| {
            while let Some(&i) = sub_steps.get(out.len()).filter(|i| **i < chunk.start + chunk.len) {
                out.push(self.snapshot(ratios, chunk, i.saturating_sub(chunk.start), grid.time(i)));
            }
            out.len() < sub_steps.len()
        })?;
        Ok(out)
    }

    /// Fields at a place of a chunk.
    fn snapshot(&self, ratios: &[f64], chunk: &Chunk, k: usize, time: f64) -> Snapshot {
        let m = self.len();
        let at = |state: usize| chunk.state(state)[k];
        let ground = [0, 1, 2].map(|axis| at(2 * m + axis));
        let y: Vec<f64> = (0..m).map(at).collect();
        let v: Vec<f64> = (0..m).map(|j| at(m + j)).collect();
        let by_dashpots = self.coupled(&v);
        let acceleration = |j: usize| {
            let w = self.omega[j];
            let damped = 2.0 * ratios[j] * w * v[j] + by_dashpots[j];
            -damped - w * w * y[j] - dot(&self.participation[j], &ground)
        };
        let a: Vec<f64> = (0..m).map(acceleration).collect();
        let mut u = self.vectors.times(&y);
        for (r, a) in self.residual.iter().zip(&ground) {
            u.iter_mut().zip(r).for_each(|(u, r)| *u -= r * a);
        }
        let (v, a) = (self.vectors.times(&v), self.vectors.times(&a));
        Snapshot { at: SnapshotAt::Time(time), time, ground, u, v, a }
    }

    fn check(&self, ratios: &[f64], load: &Load) -> Result<(), AnalysisError> {
        let refuse = |found: String, allowed: String| {
            Err(AnalysisError::Option { option: "modal superposition", found, allowed })
        };
        if ratios.len() != self.len() {
            return refuse(format!("{} damping ratios", ratios.len()), format!("{}, one a mode", self.len()));
        }
        if !load.forces.is_empty() {
            return refuse("nodal forces".into(), "ground motion; forces by direct integration".into());
        }
        Ok(())
    }

    /// Runs through time in chunks of the states Y, Ẏ, a until `take` returns false.
    fn march(
        &self,
        ratios: &[f64],
        load: &Load,
        grid: Grid,
        mut take: impl FnMut(&Chunk) -> bool,
    ) -> Result<bool, AnalysisError> {
        let m = self.len();
        let mut groups = match self.coupling {
            Some(_) => Vec::new(),
            None => self.groups(ratios, grid.h()),
        };
        let mut together =
            self.coupling.as_ref().map(|d| (Propagator::new(self, ratios, d, grid.h()), vec![0.0; 2 * m]));
        let mut chunk = Chunk::new(2 * m + 3);
        let mut loads = Vec::with_capacity(Chunk::LENGTH);
        while chunk.start < grid.steps() {
            chunk.len = (grid.steps() - chunk.start).min(Chunk::LENGTH) + 1;
            loads.clear();
            loads.extend((chunk.start..chunk.start + chunk.len - 1).map(|i| {
                let both =
                    |motion: &Option<_>| motion.as_ref().map_or((0.0, 0.0), |m: &super::motion::Motion| m.interval(i));
                [both(&load.ground[0]), both(&load.ground[1]), both(&load.ground[2])]
            }));
            if let Some((propagator, state)) = &mut together {
                self.advance(propagator, state, &loads, &mut chunk);
            }
            for group in &mut groups {
                group.advance(m, &loads, &mut chunk);
            }
            for k in 0..chunk.len {
                let a = load.acceleration(chunk.start + k);
                for (axis, a) in a.into_iter().enumerate() {
                    chunk.set(2 * m + axis, k, a);
                }
            }
            if !chunk.close() {
                return Err(AnalysisError::NotFinite {
                    time: grid.time(chunk.start),
                    cause: "a mode with negative damping, or ground motion that is not finite",
                });
            }
            if !take(&chunk) {
                return Ok(chunk.start + chunk.len > grid.steps());
            }
            chunk.start += chunk.len - 1;
        }
        Ok(true)
    }
}

/// Modes beside each other: a step of one waits for the step before, those of the others do not.
const LANES: usize = 4;

/// A few modes in time; those that are missing in the last group stay at rest.
struct Group {
    /// Number of the first.
    first: usize,
    steps: [Recurrence; LANES],
    participation: [[f64; LANES]; 3],
    /// Y and Ẏ.
    now: [[f64; LANES]; 2],
}

impl Group {
    /// Fills a chunk of `modes` modes.
    fn advance(&mut self, modes: usize, loads: &[[(f64, f64); 3]], chunk: &mut Chunk) {
        let mut motion = [[[0.0; 2]; Chunk::LENGTH + 1]; LANES];
        let [mut y, mut v] = self.now;
        let g = &self.participation;
        for (k, a) in loads.iter().enumerate() {
            for lane in 0..LANES {
                motion[lane][k] = [y[lane], v[lane]];
                let p0 = -(g[0][lane] * a[0].0 + g[1][lane] * a[1].0 + g[2][lane] * a[2].0);
                let p1 = -(g[0][lane] * a[0].1 + g[1][lane] * a[1].1 + g[2][lane] * a[2].1);
                (y[lane], v[lane]) = self.steps[lane].step(y[lane], v[lane], p0, p1);
            }
        }
        for lane in 0..LANES {
            motion[lane][loads.len()] = [y[lane], v[lane]];
        }
        self.now = [y, v];
        for (j, motion) in (self.first..modes).zip(&motion) {
            let (own, velocity) = chunk.pair_mut(j, modes + j);
            for ((y, v), found) in own.iter_mut().zip(velocity).zip(motion) {
                [*y, *v] = *found;
            }
        }
    }
}

impl ModalBasis {
    /// The modes in groups, at rest.
    fn groups(&self, ratios: &[f64], h: f64) -> Vec<Group> {
        let of = |first: usize| Group {
            first,
            steps: std::array::from_fn(|lane| {
                let mode = self.omega.get(first + lane).zip(ratios.get(first + lane));
                let (omega, ratio) = mode.unwrap_or((&0.0, &0.0));
                Recurrence::new(*omega, *ratio, h)
            }),
            participation: std::array::from_fn(|axis| {
                std::array::from_fn(|lane| self.participation.get(first + lane).map_or(0.0, |g| g[axis]))
            }),
            now: [[0.0; LANES]; 2],
        };
        (0..self.len()).step_by(LANES).map(of).collect()
    }

    /// Fills a chunk with modes that dashpots couple, from the state (ω Y, Ẏ) on.
    fn advance(&self, propagator: &mut Propagator, state: &mut [f64], loads: &[[(f64, f64); 3]], chunk: &mut Chunk) {
        let m = self.len();
        for k in 0..chunk.len {
            if k > 0 {
                propagator.advance(state, &loads[k - 1]);
            }
            for (j, omega) in self.omega.iter().enumerate() {
                chunk.set(j, k, state[j] / omega);
                chunk.set(m + j, k, state[m + j]);
            }
        }
    }
}

/// An observable in modal coordinates.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct Projected {
    /// d·φ_j.
    pub displacement: Vec<f64>,
    /// e·φ_j.
    pub velocity: Vec<f64>,
    /// c·φ_j.
    pub acceleration: Vec<f64>,
    /// b_k + c·ι_k − d·r_k.
    pub ground: [f64; 3],
}

#[cfg(test)]
mod tests;
