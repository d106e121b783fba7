//! Linear systems of a wall on equally spaced meridians with elements that are not assembled.
//!
//! ```text
//! A = S + c_M M_f + c_K K_f          S sparse: wall; M_f, K_f block-circulant: liquid
//! A x = b                            minimal residuals, preconditioned by P
//! P = ⟨S⟩ + c_M M_f + c_K K_f        ⟨S⟩: mean of S over all turns by 2π/N and the reflection
//! ```
//!
//! P has one block for each circumferential harmonic, over the unknowns of a meridian and the amplitudes: banded where the wall
//! is alone, full over the wetted radial displacements. As long as the wall is elastic and round S = ⟨S⟩ but for rounding and
//! the method ends after one step or two; cracks and yielding are differences that the iteration carries. P is the mean of congruent
//! matrices, and so positive definite if A is; A itself may be indefinite behind a bifurcation ([`minres`] does not
//! mind), then P is taken from the initial stiffness if its factor fails.
//!
//! Joints of the liquid's face and the wall that are open (`joints`) are taken out of P exactly: their mean over a level with closed ones
//! is neither.
//!
//! A factor of S alone is no substitute: with steps of some ms c_M M_f exceeds the stiffness of the wall up to harmonics of order 100.
//!
//! Source: Chan 1988 (optimal circulant preconditioner); Paige & Saunders 1975.

use std::sync::Arc;

use super::{AnalysisError, failed};
use crate::assembly::Assembler;
use crate::cores::each;
use crate::linalg::{LinalgError, Matrix, Symmetric, minres};
use crate::model::Model;
use crate::ring::{RingBlock, Weight};
use joints::{Open, Update};
use order::SectionFactor;

mod joints;
mod layout;
mod order;
mod wide;

pub use joints::OPEN_AT_MOST;
pub use layout::RingLayout;
pub(in crate::analysis) use layout::Without;
pub(in crate::analysis) use order::Order;

/// Products in one solution at most.
const LIMIT: usize = 400;
/// Unknowns from which a second thread is worth its start.
const MANY: usize = 5_000;
/// A solution that has not reached its tolerance is still a direction if its residual has fallen to this part.
const USEFUL: f64 = 0.3;

/// Factored preconditioner, and the factors of the elements that are not assembled.
pub struct RingSolver {
    layout: Arc<RingLayout>,
    factors: Vec<SectionFactor>,
    /// Open joints.
    open: Option<Update>,
    /// (c_M, c_K) by the order of the operators.
    shares: Vec<[f64; 2]>,
    threads: usize,
}

impl RingSolver {
    /// Factors the mean of `sparse` with the operators, `shares` times their mass and stiffness.
    ///
    /// Errors: a mean that is not positive definite.
    pub fn new(
        layout: &Arc<RingLayout>,
        model: &Model,
        assembler: &Assembler,
        sparse: &Symmetric,
        shares: &[[f64; 2]],
    ) -> Result<RingSolver, LinalgError> {
        let mut out =
            RingSolver { layout: layout.clone(), factors: Vec::new(), open: None, shares: shares.to_vec(), threads: 1 };
        out.refactor(model, assembler, sparse, shares)?;
        Ok(out)
    }

    /// The same with solutions on `threads` threads; no result depends on their number.
    pub fn on_threads(mut self, threads: usize) -> RingSolver {
        self.threads = threads;
        self
    }

    /// The same for other values.
    ///
    /// Errors: a mean that is not positive definite; the solver must not be used then.
    pub fn refactor(
        &mut self,
        model: &Model,
        assembler: &Assembler,
        sparse: &Symmetric,
        shares: &[[f64; 2]],
    ) -> Result<(), LinalgError> {
        self.shares = shares.to_vec();
        let layout = self.layout.clone();
        let mut mean = layout.mean(sparse);
        let open = Open::close(&layout, sparse, &mut mean);
        let amplitudes = layout.amplitude_diagonal(sparse);
        if self.factors.is_empty() {
            let rows: Vec<usize> = (0..layout.size()).collect();
            let orders = [0, 1].map(|sloshing| Arc::new(Order::new(&layout, sloshing, [&rows, &[]])));
            let harmonics = 0..layout.ring().harmonics();
            let of = |m: usize| SectionFactor::new(&orders[usize::from(layout.has_amplitudes(m))]);
            self.factors = harmonics.map(of).collect::<Result<_, LinalgError>>()?;
        }
        let operators: Vec<_> = assembler.operators(model).map(|placed| placed.operator).collect();
        let done = each(self.threads, &mut self.factors, |m, factor| {
            let mut section = layout.section(m, &mean);
            for (number, (operator, [on_mass, on_stiffness])) in operators.iter().zip(shares).enumerate() {
                let RingBlock { mass, stiffness } = &operator.blocks()[m];
                layout.add_block(&mut section, number, *on_mass, mass);
                if let Some(k) = stiffness {
                    layout.add_block(&mut section, number, *on_stiffness, k);
                }
            }
            layout.close(&mut section, m, &amplitudes);
            factor.renew(&section)
        });
        done.into_iter().collect::<Result<(), LinalgError>>()?;
        self.open = open.update(&layout, &self.factors)?;
        Ok(())
    }

    /// Solves (S + operators) x = b to √(rᵀ P⁻¹ r) ≤ `tolerance` times its first value; returns the number of products.
    ///
    /// Errors: no convergence.
    pub fn solve(
        &self,
        model: &Model,
        assembler: &Assembler,
        sparse: &Symmetric,
        b: &[f64],
        x: &mut Vec<f64>,
        tolerance: f64,
    ) -> Result<usize, LinalgError> {
        x.clear();
        x.resize(b.len(), 0.0);
        let numbers: Vec<usize> = assembler.operators(model).map(|p| p.element).collect();
        let share = |e: usize| {
            let found = numbers.iter().position(|n| *n == e);
            found.map_or([0.0; 2], |i| self.shares[i])
        };
        let mut room = vec![0.0; b.len()];
        let mut product = |x: &[f64], y: &mut [f64]| {
            y.fill(0.0);
            assembler.add_whole_product(model, (sparse, &share), x, [y, &mut room], self.threads);
        };
        let mut precondition = |r: &[f64], z: &mut [f64]| self.precondition(r, z);
        let found = minres(&mut product, &mut precondition, b, x, tolerance, LIMIT)?;
        if found.residual > tolerance.max(USEFUL) || (found.residual > tolerance && tolerance < 1e-6) {
            return Err(LinalgError::Iteration {
                iterations: found.count,
                residual: found.residual,
                allowed: tolerance,
            });
        }
        Ok(found.count)
    }

    /// z = P⁻¹ r.
    fn precondition(&self, r: &[f64], z: &mut [f64]) -> Result<(), LinalgError> {
        self.precondition_closed(r, z)?;
        if let Some(update) = &self.open {
            let mut more = r.to_vec();
            update.add(z, &mut more);
            self.precondition_closed(&more, z)?;
        }
        Ok(())
    }

    /// z = P₀⁻¹ r.
    fn precondition_closed(&self, r: &[f64], z: &mut [f64]) -> Result<(), LinalgError> {
        let layout = &*self.layout;
        let ring = layout.ring();
        let (families, size) = (ring.families(), layout.size());
        let (harmonics, threads) = (ring.harmonics(), if r.len() < MANY { 1 } else { self.threads });
        let mut waves = vec![Vec::new(); size];
        each(threads, &mut waves, |a, out: &mut Vec<f64>| {
            let value = |&e: &u32| r.get(e as usize).copied().unwrap_or(0.0);
            let row: Vec<f64> = layout.equations(a).iter().map(value).collect();
            out.resize(families * harmonics, 0.0);
            let put = |m: usize, f: usize, c: f64| out[f * harmonics + m] = c;
            ring.analyse(&row, layout.is_odd(a), Weight::Displacements, &mut ring.room(), put);
        });
        let mut sections: Vec<Matrix> =
            (0..harmonics).map(|m| Matrix::zeros(layout.symbolic(m).pattern().size(), families)).collect();
        each(threads, &mut sections, |m, section| {
            for f in 0..families {
                section.column_mut(f).iter_mut().zip(&waves).for_each(|(x, wave)| *x = wave[f * harmonics + m]);
            }
            for &(e, a) in layout.amplitudes().iter().filter(|(_, a)| a.harmonic == m) {
                section.column_mut(a.family)[size + a.slot] = r[e];
            }
            self.factors[m].solve(section);
        });
        each(threads, &mut waves, |a, row: &mut Vec<f64>| {
            row.resize(ring.meridians(), 0.0);
            let get = |m: usize, f: usize| sections[m].column(f)[a];
            ring.synthesise(layout.is_odd(a), Weight::Displacements, &mut ring.room(), get, row);
        });
        z.fill(0.0);
        for (a, row) in waves.iter().enumerate() {
            for (value, &e) in row.iter().zip(layout.equations(a)) {
                if let Some(z) = z.get_mut(e as usize) {
                    *z = *value;
                }
            }
        }
        for &(e, a) in layout.amplitudes() {
            z[e] = sections[a.harmonic].column(a.family)[size + a.slot];
        }
        Ok(())
    }
}

/// Solves (S + c_M M_f + c_K K_f) x = b to 10⁻¹².
///
/// Errors: a model without rings of nodes; a mean that is not positive definite; no convergence.
pub fn solve_once(
    model: &Model,
    assembler: &Assembler,
    sparse: &Symmetric,
    share: [f64; 2],
    b: &[f64],
) -> Result<Vec<f64>, AnalysisError> {
    let layout = Arc::new(RingLayout::new(model, assembler)?);
    let shares: Vec<[f64; 2]> = assembler.operators(model).map(|_| share).collect();
    let solve = || -> Result<Vec<f64>, LinalgError> {
        let solver = RingSolver::new(&layout, model, assembler, sparse, &shares)?;
        let mut x = Vec::new();
        solver.solve(model, assembler, sparse, b, &mut x, 1e-12)?;
        Ok(x)
    };
    solve().map_err(failed("a wall with its liquid"))
}
