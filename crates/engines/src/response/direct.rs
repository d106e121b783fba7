//! Direct integration of all unknowns by Newmark's average acceleration ([`fem::analysis::transient`]), the independent check of
//! modal superposition.
//!
//! C holds the ratio of every mode, C = Σ 2 ξ_j ω_j (M φ_j)(M φ_j)ᵀ, or Rayleigh's a_M M + a_K K. Extremes are those at the
//! sub-steps. The energy balance proves the matrices symmetric, the factor right and the equations solved, not the step short:
//! the step is judged by the lengthening of periods (ω h)²/12. Source: Newmark 1959; Hughes 1987, section 9.1.

use std::sync::Arc;

use fem::analysis::damping::Damping;
use fem::analysis::system::System;
use fem::analysis::transient::{Energy, Settings, integrate};
use fem::linalg::{Kind, Matrix, Ordering, Pattern, Symbolic, Symmetric, product};
use fem::progress::Progress;
use results::EnergyBalance;

use super::blocks::{Block, Observable, Steps, failed, functionals, load, offsets};
use super::motion::{Grid, Motion};
use super::observe::Observed;
use crate::FeError;
use crate::coupled::Coupled;
use crate::damping::{Damper, Rayleigh};
use crate::error::failure;
use crate::modes::CoupledMode;

/// Steps in the period of the highest significant mode: the period is lengthened by (2π/80)²/12 = 0.05 %.
pub const STEPS_PER_PERIOD: f64 = 80.0;

/// A coupled system with its damping matrix.
#[derive(Clone, Debug)]
pub struct DirectSystem<'a> {
    block: Block<'a>,
    damping: Matrix,
}

impl<'a> DirectSystem<'a> {
    /// The system with damping by `damper`; `modes` are all its modes (they make up the modal damping matrix and select
    /// the sloshing modes that count for wave heights).
    pub fn new(system: &'a Coupled, modes: &'a [CoupledMode], damper: &Damper) -> DirectSystem<'a> {
        let n = system.influence.len();
        let held = modes.iter().all(|mode| mode.damping.is_none());
        let mut damping = match damper {
            Damper::Rayleigh(Rayleigh { mass, stiffness }) if held => Matrix {
                rows: n,
                cols: n,
                data: (system.mass.data.iter().zip(&system.stiffness.data))
                    .map(|(m, k)| mass * m + stiffness * k)
                    .collect(),
            },
            Damper::Rayleigh(_) | Damper::ByKind { .. } | Damper::ByGroup { .. } | Damper::Caughey(_) => {
                let mut shapes = Matrix::zeros(n, modes.len());
                for (j, mode) in modes.iter().enumerate() {
                    shapes.column_mut(j).copy_from_slice(&mode.vector);
                }
                let momenta = product(&system.mass, &shapes);
                let mut weighted = Matrix::zeros(modes.len(), n);
                for (j, mode) in modes.iter().enumerate() {
                    let factor = 2.0 * damper.beside(mode) * mode.omega;
                    for i in 0..n {
                        weighted.add(j, i, factor * momenta.get(i, j));
                    }
                }
                product(&momenta, &weighted)
            }
        };
        for (row, coefficient) in &system.dashpots {
            for (j, b) in row.iter().enumerate().filter(|(_, b)| **b != 0.0) {
                for (to, a) in damping.column_mut(j).iter_mut().zip(row) {
                    *to += coefficient * a * b;
                }
            }
        }
        let block = Block { system, modes: modes.iter().collect() };
        DirectSystem { block, damping }
    }
}

/// Matrices of the systems as diagonal blocks on the pattern of full blocks.
fn diagonal<'a>(pattern: &Arc<Pattern>, matrices: impl Iterator<Item = &'a Matrix>) -> Symmetric {
    let lower = |matrix: &'a Matrix| (0..matrix.cols).flat_map(move |j| &matrix.column(j)[j..]).copied();
    Symmetric { pattern: pattern.clone(), values: matrices.flat_map(lower).collect() }
}

/// The energies at the end of a response.
pub(crate) fn balance(energy: &Energy) -> EnergyBalance {
    let last = |values: &[f64]| values.last().copied().unwrap_or(0.0);
    EnergyBalance {
        input: last(&energy.input),
        kinetic: last(&energy.kinetic),
        elastic: last(&energy.elastic),
        damping: last(&energy.damping),
        error: energy.error(),
    }
}

/// Response of `systems` (three at most) to `motions` (one each): histories of `scalars`, extremes of `others` at the sub-steps,
/// and the energy balance, taken at the samples of the grid.
///
/// Errors: an effective matrix that is not positive definite, a response that is not finite, with its time.
pub fn respond(
    systems: &[DirectSystem],
    motions: &[&Motion],
    grid: Grid,
    scalars: &[Observable],
    others: &[Observable],
    progress: &dyn Progress,
) -> Result<(Observed, EnergyBalance), FeError> {
    let blocks: Vec<&Block> = systems.iter().map(|s| &s.block).collect();
    let size = blocks.iter().map(|b| b.size()).sum();
    let unknowns: Vec<Vec<usize>> =
        blocks.iter().zip(offsets(&blocks)).map(|(block, start)| (start..start + block.size()).collect()).collect();
    let pattern = Arc::new(Pattern::from_cliques(size, unknowns.iter().map(Vec::as_slice)));
    let mut influence = [0, 1, 2].map(|_| vec![0.0; size]);
    for ((block, own), influence) in blocks.iter().zip(&unknowns).zip(&mut influence) {
        influence[own[0]..own[0] + own.len()].copy_from_slice(&block.system.influence);
    }
    let mass = diagonal(&pattern, blocks.iter().map(|b| &b.system.mass));
    let stiffness = diagonal(&pattern, blocks.iter().map(|b| &b.system.stiffness));
    let damping = Damping { sparse: Some(diagonal(&pattern, systems.iter().map(|s| &s.damping))), ..Damping::none() };
    let system = System::from_matrices(mass, stiffness, influence).with_damping(damping);
    let symbolic = Symbolic::new(pattern, &Ordering::Given((0..size).collect()))
        .map_err(failure("the effective matrix of a step"))?;
    let settings = Settings { kind: Kind::Definite, between: false, ..Settings::new(grid) };
    let (scalars, others) = (functionals(&blocks, scalars), functionals(&blocks, others));
    let loads = [load(motions)];
    let found = integrate(&system, &Arc::new(symbolic), &loads, &settings, &scalars, &others, &Steps(progress))
        .map_err(failed)?
        .pop()
        .ok_or_else(|| FeError::Analysis("no motion was integrated".into()))?;
    Ok((found.observed, balance(&found.energy)))
}
