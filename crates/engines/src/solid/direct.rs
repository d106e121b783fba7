//! Direct integration of all unknowns of the model, liquid potentials included: the independent check of the reduction.
//!
//! ```text
//! M₃ ẍ + C ẋ + K₃ x = −f a_g          trapezoidal rule, one factor of K₃ + 2/h C + 4/h² M₃
//! ```
//!
//! in the motion relative to the ground, φ included, with f of [`super::reduce`]. Rayleigh damping is that of the whole
//! matrices; damping by kind gives every mode of the reduced system its ratio, W D Wᵀ with W = M₃ Φ. Horizontal motion
//! only: with a vertical record the reduced coordinates are integrated.

use fem::analysis::damping::{Damping, ModalPart, Rayleigh};
use fem::analysis::motion::Motion;
use fem::analysis::observable::Observable;
use fem::analysis::system::System as LinearSystem;
use fem::analysis::transient::{Load, Settings, integrate};
use fem::assembly::order;
use fem::linalg::{Kind as FactorKind, Matrix, Symbolic};
use fem::progress::Progress;
use tank::case::GroundMotion;

use super::model::TankModel;
use super::reduce::{Space, rigid_motion};
use super::rows::{Row, sparse_dot};
use super::system::System;
use crate::FeError;
use crate::damping::Damper;
use crate::error::{failed, failure};
use crate::linear::Direct;
use crate::linear::analysis::{Analysis, LineExtremes, largest_difference, mirrored};
use crate::linear::model::Model;
use crate::modes::{CoupledMode, Kind};
use crate::probe::{ModeSelection, Probe};
use crate::response::direct::balance;
use crate::response::observe::{Extreme, History};
use tank::options::linear::Integrator;

/// Input of the integration.
pub(super) struct OwnUnknowns<'a> {
    /// The tank.
    pub tank: &'a TankModel,
    /// Its factored matrices.
    pub system: &'a System,
    /// The reduced model, whose modes give damping and wave heights.
    pub model: &'a Model,
    /// Map from its horizontal coordinates to the unknowns of the tank.
    pub space: &'a Space,
}

impl OwnUnknowns<'_> {
    fn modes(&self) -> &[CoupledMode] {
        &self.model.horizontal.modes
    }

    /// M₃ φ and φ of a mode over all unknowns.
    fn momentum(&self, mode: &CoupledMode) -> (Vec<f64>, Vec<f64>) {
        let shape = self.space.basis.times(&mode.vector);
        (self.system.mass_times(&shape), shape)
    }

    fn damping(&self) -> Damping {
        let mut damping = self.by_model();
        let dashpots = &self.space.dashpots;
        if !dashpots.is_empty() {
            let size = self.system.size();
            let modal =
                damping.modal.get_or_insert_with(|| ModalPart { momenta: Matrix::zeros(size, 0), rates: Vec::new() });
            for (row, coefficient) in dashpots {
                let mut dense = vec![0.0; size];
                row.iter().for_each(|&(i, c)| dense[i] += c);
                modal.momenta.data.extend(dense);
                modal.momenta.cols += 1;
                modal.rates.push(*coefficient);
            }
        }
        damping
    }

    fn by_model(&self) -> Damping {
        match self.model.damper {
            Damper::Rayleigh(r) => Damping::rayleigh(Rayleigh { mass: r.mass, stiffness: r.stiffness }),
            Damper::ByKind { .. } | Damper::ByGroup { .. } | Damper::Caughey(_) => {
                let (mut data, mut rates) = (Vec::new(), Vec::new());
                for mode in self.modes() {
                    let rate = 2.0 * self.model.damper.ratio(mode.kind, mode.omega) * mode.omega;
                    if rate != 0.0 {
                        data.extend(self.momentum(mode).0);
                        rates.push(rate);
                    }
                }
                let momenta = Matrix { rows: self.system.size(), cols: rates.len(), data };
                Damping { modal: (!rates.is_empty()).then_some(ModalPart { momenta, rates }), ..Damping::none() }
            }
        }
    }

    /// The observable of a probe, from its row over the model.
    fn observable(&self, probe: &Probe) -> Option<Observable> {
        let Row { displacement, acceleration, held } = self.space.rows.get(&probe.key())?.clone();
        let displacement = match probe.modes {
            ModeSelection::All => displacement,
            ModeSelection::FirstSloshing(most) => {
                let mut row = vec![0.0; self.system.size()];
                let counts = |m: &&CoupledMode| m.kind == Kind::Sloshing && m.number <= most;
                for mode in self.modes().iter().filter(counts) {
                    let (momentum, shape) = self.momentum(mode);
                    let share = sparse_dot(&displacement, &shape);
                    for (r, m) in row.iter_mut().zip(momentum) {
                        *r += share * m;
                    }
                }
                let entries = row.into_iter().enumerate();
                entries.filter(|(_, c)| *c != 0.0).collect()
            }
        };
        Some(Observable {
            name: probe.key(),
            displacement,
            velocity: Vec::new(),
            acceleration,
            ground: [held, 0.0, 0.0],
        })
    }
}

impl Direct for OwnUnknowns<'_> {
    fn replace(
        &self,
        analysis: &mut Analysis<'_>,
        motion: &GroundMotion,
        progress: &dyn Progress,
    ) -> Result<Option<f64>, FeError> {
        let grid = self.model.grid(motion, Integrator::Newmark)?;
        let (rigid, load) = rigid_motion(self.tank, self.system, 1)?;
        let mut system =
            LinearSystem::new(&self.tank.model, &self.tank.assembler).map_err(failed)?.with_damping(self.damping());
        (system.influence[0], system.inertia[0]) = (rigid, load);
        let pattern = self.tank.assembler.pattern();
        let symbolic = Symbolic::new(pattern.clone(), &order(&self.tank.model, pattern))
            .map_err(failure("the symbolic factor of a step"))?
            .into();
        let record = &motion.horizontal;
        let loads = [Load::ground(0, Motion::sampled(record.dt, &record.acceleration, &grid))];
        let settings = Settings {
            kind: if self.space.potentials.contains(&true) { FactorKind::QuasiDefinite } else { FactorKind::Definite },
            ..Settings::new(grid)
        };
        // θ = 180° has a separate scalar, with the opposite sign.
        let scalars: Vec<Observable> = analysis
            .scalars
            .iter()
            .map(|(s, _)| s.observable.first())
            .map(|term| term.and_then(|&(_, _, probe)| self.observable(probe)).unwrap_or_default())
            .collect();
        let lines = &self.model.horizontal.coupled.lines;
        let others: Vec<Observable> = lines
            .iter()
            .flat_map(|line| &line.probes)
            .map(|probe| self.observable(probe).unwrap_or_default())
            .collect();
        progress.stage("direct integration of all unknowns", grid.steps() as u64);
        let transient = integrate(&system, &symbolic, &loads, &settings, &scalars, &others, progress)
            .map_err(failed)?
            .pop()
            .ok_or_else(|| failed("no record was integrated"))?;

        let before: Vec<History> = analysis.scalars.iter().map(|(_, h)| h.clone()).collect();
        for ((scalar, history), found) in analysis.scalars.iter_mut().zip(&transient.observed.scalars) {
            let factor = scalar.observable.first().map_or(1.0, |t| t.1);
            let extreme = if factor < 0.0 { mirrored(&found.extreme) } else { found.extreme };
            *history = History {
                values: found.values.iter().map(|v| factor * v).collect(),
                extreme: Extreme { min: factor.abs() * extreme.min, max: factor.abs() * extreme.max, ..extreme },
            };
            // Samples that an interrupted run did not reach are unknown.
            history.values.resize(grid.samples, f64::NAN);
        }
        let after: Vec<History> = analysis.scalars.iter().map(|(_, h)| h.clone()).collect();
        let scalars: Vec<_> = analysis.scalars.iter().map(|(s, _)| s.clone()).collect();
        analysis.difference = if transient.complete { largest_difference(&scalars, &before, &after) } else { None };
        let mut rest = transient.observed.extremes.iter().copied();
        let level = self.model.horizontal.coupled.level;
        analysis.lines = lines
            .iter()
            .map(|line| {
                let front: Vec<Extreme> = rest.by_ref().take(line.probes.len()).collect();
                let back = front.iter().map(mirrored).collect();
                LineExtremes::new(line, level, front, back)
            })
            .collect();
        analysis.energy = Some(balance(&transient.energy));
        analysis.grid = grid;
        let reached = transient.observed.scalars.first().map_or(0, |s| s.values.len());
        Ok((!transient.complete).then(|| grid.dt * reached.saturating_sub(1) as f64))
    }
}
