//! Direct time integration of linear systems with constant step, many records at once.
//!
//! ```text
//! A a₁ = p_α − α_m M a₀ − K [u₀ + (1 − α_f) (h v₀ + h² (1/2 − β) a₀)] − C [v₀ + (1 − α_f) h (1 − γ) a₀]
//! A = (1 − α_m) M + (1 − α_f) (γ h C + β h² K)
//! ```
//!
//! The acceleration is the unknown. K u, K v, K a, M v and M a are carried along, and a step extends them by the products
//! of the new acceleration alone: **one sweep over the matrices and one solve**, with Rayleigh damping too. They are
//! recomputed from u and v every 32 steps, so that rounding does not add up. All records share one factor and are solved
//! together, a column each.
//!
//! # Energy balance
//!
//! In the motion relative to the ground,
//!
//! ```text
//! E_in = ∫ ẋᵀ (p − M ι a_g) dt = ½ ẋᵀ M ẋ + ½ xᵀ K x + ∫ ẋᵀ C ẋ dt        (from the initial state)
//! ```
//!
//! With trapezoidal increments ½ (f₀ + f₁)·Δx it closes for the trapezoidal rule up to rounding, whatever the step: it
//! proves the matrices symmetric, the factor right and the equations solved, not the step short. For the dissipative
//! schemes the residual is their dissipation.
//!
//! Where the load jumps (at the start, and at the end of a record that does not end with zero) the acceleration jumps by
//! M⁻¹ Δp. M may be singular (rotations without inertia), so (M + ε K) Δa = Δp is solved instead, with ε = 10⁻⁶ h²/4, and
//! refined once against M: a mode's share of the jump is then right to (ε ω²)².
//!
//! Source: Newmark 1959; Chung & Hulbert 1993; Hughes 1987, section 9.1.

use std::sync::Arc;

use super::motion::{Grid, Motion};
use super::observable::{Observable, apply};
use super::observer::{Chunk, Observed, Observer, Row, Slope};
use super::scheme::TimeScheme;
use super::system::System;
use super::{AnalysisError, check_length};
use crate::linalg::{Kind, Symbolic};
use crate::progress::Progress;
use march::March;

mod low_rank;
mod march;

/// Loads of one record.
#[derive(Clone, Debug, Default)]
pub struct Load {
    /// Ground acceleration along x, y, z.
    pub ground: [Option<Motion>; 3],
    /// Nodal forces and their time functions.
    pub forces: Vec<(Vec<f64>, Motion)>,
}

impl Load {
    /// Ground acceleration along one axis (0, 1, 2).
    pub fn ground(axis: usize, motion: Motion) -> Load {
        let mut load = Load::default();
        load.ground[axis] = Some(motion);
        load
    }

    /// Ground acceleration at the end of sub-step `i`.
    pub fn acceleration(&self, i: usize) -> [f64; 3] {
        [0, 1, 2].map(|k| self.ground[k].as_ref().map_or(0.0, |m| m.at(i)))
    }
}

/// When the fields are kept.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum SnapshotAt {
    /// At the end of the sub-step nearest to a time [s].
    Time(f64),
    /// At the largest absolute value of a scalar observable (its number).
    Peak(usize),
}

/// Fields at an instant.
#[derive(Clone, Debug, PartialEq)]
pub struct Snapshot {
    /// Why they were kept.
    pub at: SnapshotAt,
    /// Time [s].
    pub time: f64,
    /// Ground acceleration [m/s²].
    pub ground: [f64; 3],
    /// Displacement relative to the ground.
    pub u: Vec<f64>,
    /// Velocity relative to the ground.
    pub v: Vec<f64>,
    /// Acceleration relative to the ground.
    pub a: Vec<f64>,
}

/// How to integrate.
#[derive(Clone, Debug)]
pub struct Settings {
    /// Scheme.
    pub scheme: TimeScheme,
    /// Samples and sub-steps.
    pub grid: Grid,
    /// How the effective matrix is factored.
    pub kind: Kind,
    /// Displacement and velocity at the start; at rest if `None`.
    pub initial: Option<(Vec<f64>, Vec<f64>)>,
    /// Constant load (weight), with the initial state in equilibrium as a rule.
    pub constant: Option<Vec<f64>>,
    /// Fields to be kept.
    pub snapshots: Vec<SnapshotAt>,
    /// Whether extremes are sought between the sub-steps, by their slopes, or at them alone.
    pub between: bool,
}

impl Settings {
    /// Trapezoidal rule from rest.
    pub fn new(grid: Grid) -> Settings {
        Settings {
            scheme: TimeScheme::Trapezoidal,
            grid,
            kind: Kind::QuasiDefinite,
            initial: None,
            constant: None,
            snapshots: Vec::new(),
            between: true,
        }
    }
}

/// Energies at the samples [J], as changes since the initial state.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Energy {
    /// Work of the loads.
    pub input: Vec<f64>,
    /// Kinetic energy.
    pub kinetic: Vec<f64>,
    /// Elastic energy (and that of the liquid's surface).
    pub elastic: Vec<f64>,
    /// Work done on the damping.
    pub damping: Vec<f64>,
}

impl Energy {
    /// Largest |E_in − E_kin − E_el − E_damp|, relative to the largest |E_in|, or stored energy if no load does work.
    pub fn error(&self) -> f64 {
        let (mut worst, mut largest) = (0.0_f64, 0.0_f64);
        for i in 0..self.input.len() {
            let rest = self.input[i] - self.kinetic[i] - self.elastic[i] - self.damping[i];
            worst = worst.max(rest.abs());
            largest = largest.max(self.input[i].abs()).max(self.kinetic[i].abs());
        }
        if largest > 0.0 { worst / largest } else { 0.0 }
    }
}

/// Response to one record.
#[derive(Clone, Debug, PartialEq)]
pub struct Transient {
    /// Histories of the scalars, extremes of the other observables.
    pub observed: Observed,
    /// Energy balance.
    pub energy: Energy,
    /// Fields kept, in the order asked for; those whose time was not reached are missing.
    pub snapshots: Vec<Snapshot>,
    /// Whether the analysis came to its end.
    pub complete: bool,
    /// Time reached [s].
    pub time: f64,
    /// Largest residual ‖r − A a‖/‖r‖ of a solution that was looked at (one in 32).
    pub residual: f64,
    /// Displacement at the end.
    pub u: Vec<f64>,
    /// Velocity at the end.
    pub v: Vec<f64>,
}

/// Observables of one record under way.
struct Watch<'a> {
    observables: Vec<&'a Observable>,
    ground: Vec<[f64; 3]>,
    chunk: Chunk,
    observer: Observer<'a>,
    energy: Energy,
    snapshots: Vec<(f64, Option<Snapshot>)>,
}

impl Watch<'_> {
    /// Writes the observables at instant `k` of the chunk and looks after the snapshots.
    fn take(&mut self, k: usize, i: usize, march: &March, column: usize, settings: &Settings) {
        let (u, v, a) = march.fields(column);
        let ground = march.load(column).acceleration(i);
        let count = self.observables.len();
        for (j, (row, on_ground)) in self.observables.iter().zip(&self.ground).enumerate() {
            let mut y = apply(&row.displacement, u) + apply(&row.velocity, v) + apply(&row.acceleration, a);
            y += on_ground.iter().zip(&ground).map(|(b, a)| b * a).sum::<f64>();
            self.chunk.set(j, k, y);
            if !row.has_acceleration(on_ground) {
                self.chunk.set(count + j, k, apply(&row.displacement, v) + apply(&row.velocity, a));
            }
        }
        let grid = &settings.grid;
        for (at, (best, kept)) in settings.snapshots.iter().zip(&mut self.snapshots) {
            let keep = match *at {
                SnapshotAt::Time(t) => i == ((t / grid.h()).round().max(0.0) as usize).min(grid.steps()),
                SnapshotAt::Peak(scalar) => {
                    let value = self.chunk.state(scalar)[k].abs();
                    let higher = value > *best;
                    if higher {
                        *best = value;
                    }
                    higher
                }
            };
            if keep {
                *kept =
                    Some(Snapshot { at: *at, time: grid.time(i), ground, u: u.to_vec(), v: v.to_vec(), a: a.to_vec() });
            }
        }
    }

    /// Slopes of observables that depend on accelerations, by differences of the second order.
    fn differentiate(&mut self, h: f64) {
        let count = self.observables.len();
        for (j, (row, on_ground)) in self.observables.iter().zip(&self.ground).enumerate() {
            if !row.has_acceleration(on_ground) {
                continue;
            }
            let (y, slope) = self.chunk.pair_mut(j, count + j);
            let last = y.len() - 1;
            for k in 0..=last {
                slope[k] = match k {
                    _ if last == 1 => y[1] - y[0],
                    0 => 2.0 * y[1] - 1.5 * y[0] - 0.5 * y[2],
                    _ if k == last => 1.5 * y[k] - 2.0 * y[k - 1] + 0.5 * y[k - 2],
                    _ => 0.5 * (y[k + 1] - y[k - 1]),
                } / h;
            }
        }
    }
}

impl Observable {
    fn has_acceleration(&self, ground: &[f64; 3]) -> bool {
        !self.acceleration.is_empty() || ground.iter().any(|b| *b != 0.0)
    }
}

/// Response of `system` to every one of `loads`: histories of `scalars`, extremes of `others`.
///
/// `symbolic` is the symbolic factor of the system's pattern. All motions must stand on the grid of `settings`.
///
/// If interrupted, it returns the results so far, marked incomplete.
///
/// Errors: vectors of wrong length, an effective matrix that cannot be factored, a response that is not finite.
// Long: checks and layout serve the loop at its end.
pub fn integrate(
    system: &System,
    symbolic: &Arc<Symbolic>,
    loads: &[Load],
    settings: &Settings,
    scalars: &[Observable],
    others: &[Observable],
    progress: &dyn Progress,
) -> Result<Vec<Transient>, AnalysisError> {
    check(system, loads, settings, scalars.len())?;
    let grid = settings.grid;
    let scheme = settings.scheme.with_step(grid.h())?;
    let count = scalars.len() + others.len();
    let row = |k: usize| Row {
        value: vec![(k, 1.0)],
        slope: settings.between.then(|| Slope { states: vec![(count + k, 1.0)], linear: Vec::new() }),
    };
    let rows: Vec<Row> = (0..count).map(row).collect();
    let (scalar_rows, other_rows) = rows.split_at(scalars.len());
    let mut watches: Vec<Watch> = loads
        .iter()
        .map(|_| Watch {
            observables: scalars.iter().chain(others).collect(),
            ground: scalars.iter().chain(others).map(|o| o.total_ground(&system.influence)).collect(),
            chunk: Chunk::new(2 * count),
            observer: Observer::new(scalar_rows, other_rows, grid),
            energy: Energy::default(),
            snapshots: vec![(0.0, None); settings.snapshots.len()],
        })
        .collect();
    let mut march = March::new(system, symbolic, loads, settings, scheme)?;
    progress.stage("time integration", grid.steps() as u64);
    let mut start = 0;
    while start < grid.steps() && !progress.interrupted() {
        let len = (grid.steps() - start).min(Chunk::LENGTH) + 1;
        march.refresh();
        for watch in &mut watches {
            (watch.chunk.start, watch.chunk.len) = (start, len);
        }
        for k in 0..len {
            let i = start + k;
            if k > 0 {
                march.step(i - 1, k == 1)?;
            }
            for (column, watch) in watches.iter_mut().enumerate() {
                watch.take(k, i, &march, column, settings);
                if i.is_multiple_of(grid.sub_steps) && (k > 0 || i == 0) {
                    march.energies(column, &mut watch.energy);
                }
            }
        }
        for (column, watch) in watches.iter_mut().enumerate() {
            watch.differentiate(grid.h());
            let (u, v, _) = march.fields(column);
            if !(watch.chunk.close() && u.iter().chain(v).sum::<f64>().is_finite()) {
                return Err(AnalysisError::NotFinite {
                    time: grid.time(start),
                    cause: "negative damping, an unstable system, or loads that are not finite",
                });
            }
            watch.observer.take(&watch.chunk);
        }
        start += len - 1;
        progress.advance((len - 1) as u64);
    }
    let finish = |(column, watch): (usize, Watch)| {
        let (u, v, _) = march.fields(column);
        Transient {
            observed: watch.observer.finish(),
            energy: watch.energy,
            snapshots: watch.snapshots.into_iter().filter_map(|(_, s)| s).collect(),
            complete: start >= grid.steps(),
            time: grid.time(start),
            residual: march.residual(),
            u: u.to_vec(),
            v: v.to_vec(),
        }
    };
    Ok(watches.into_iter().enumerate().map(finish).collect())
}

/// Checks lengths and numbers.
fn check(system: &System, loads: &[Load], settings: &Settings, scalars: usize) -> Result<(), AnalysisError> {
    let n = system.size();
    for (force, _) in loads.iter().flat_map(|l| &l.forces) {
        check_length("nodal forces", force.len(), n)?;
    }
    if let Some((u, v)) = &settings.initial {
        check_length("initial displacement", u.len(), n)?;
        check_length("initial velocity", v.len(), n)?;
    }
    if let Some(p) = &settings.constant {
        check_length("constant load", p.len(), n)?;
    }
    for at in &settings.snapshots {
        if let SnapshotAt::Peak(k) = at
            && *k >= scalars
        {
            return Err(AnalysisError::option(
                "snapshot",
                format!("peak of scalar observable {k}"),
                format!("numbers below {scalars}"),
            ));
        }
    }
    Ok(())
}

#[cfg(test)]
mod tests;
