//! Solution with the effective tangent: by its factor, or by iteration where elements are not assembled.

use super::{Inertia, Newton};
use crate::analysis::border::Bordered;
use crate::analysis::rings::RingSolver;
use crate::analysis::scheme::Weights;
use crate::analysis::zone::solver::ZoneSolver;
use crate::analysis::{AnalysisError, failed};
use crate::linalg::{Factor, Keep, LinalgError, Symmetric, gmres};

/// Relative residual at which the iteration of one increment ends: Newton's next residual is new anyway, and with less than this
/// more of them are needed.
const TOLERANCE: f64 = 1e-3;
/// The same of the columns of a moving base, with which the increments of the base are as exact as others.
const PRECISE: f64 = 1e-6;
/// The same where nothing corrects the solution.
const EXACT: f64 = 1e-12;

/// The same where a zone has its outside by harmonics, beside a modified Newton's method that leaves as much, and products in one solution at most: where the
/// wall yields at one side the last ones gain little.
const GUIDED: f64 = 0.3;
const FEW: usize = 10;

/// What stands for the inverse of the effective tangent.
pub(super) enum Solver {
    Direct(Factor),
    Rings(Box<RingSolver>),
    Zone(Box<ZoneSolver>),
}

/// The solution of a system that is factorised, of any right-hand side.
type Solved<'a> = Box<dyn Fn(&[f64]) -> Result<Vec<f64>, AnalysisError> + 'a>;

pub(super) const WHAT: &str = "the effective tangent";

impl Inertia<'_> {
    /// A ← A + w_M M + w_C C of what is assembled.
    pub(super) fn add_to(&self, a: &mut Symmetric, w: Weights) {
        let c = &self.damping.rayleigh;
        a.add(w.mass + w.damping * c.mass, self.mass);
        if w.damping * c.stiffness != 0.0 {
            a.add(w.damping * c.stiffness, self.stiffness);
        }
        if let Some(sparse) = &self.damping.sparse {
            a.add(w.damping, sparse);
        }
    }
}

impl Newton<'_> {
    /// (c_M, c_K) of every element that is not assembled.
    pub(super) fn shares(&self, w: Weights) -> Vec<[f64; 2]> {
        let c = self.inertia.map(|i| i.damping.of_operators()).unwrap_or_default();
        let share = [w.mass + w.damping * c.mass, w.stiffness + w.damping * c.stiffness];
        self.assembler.operators(self.model).map(|_| share).collect()
    }

    /// Makes `self.factor` that of `self.effective`.
    pub(super) fn factorise(&mut self, w: Weights) -> Result<(), AnalysisError> {
        // Taken out, so that a factor that failed is not used again.
        let before = self.factor.take().map(|(solver, _)| solver);
        if self.zoned.is_some() {
            let shares = self.shares(w);
            let Some(zoned) = &mut self.zoned else { return Ok(()) };
            zoned.join(&self.effective, w);
            let own = Some((w.stiffness, &zoned.own));
            let keep = zoned.keep(w);
            let mut solver = match before {
                Some(Solver::Zone(solver)) => solver,
                _ => Box::new(ZoneSolver::new(&zoned.zone, keep, self.threads).map_err(failed(WHAT))?),
            };
            solver.keep_as(keep, true);
            solver.renew(&self.effective, own, &shares).map_err(failed(WHAT))?;
            self.factor = Some((Solver::Zone(solver), w));
            return Ok(());
        }
        let solver = match (&self.rings, before) {
            (Some(_), before) => Solver::Rings(Box::new(self.ring_solver(w, before)?)),
            (None, Some(Solver::Direct(mut factor))) => {
                factor.refactor(&self.effective).map_err(failed(WHAT))?;
                Solver::Direct(factor)
            }
            (None, _) => {
                let factor = self.symbolic.factor(&self.effective, self.kind);
                Solver::Direct(factor.map_err(failed(WHAT))?)
            }
        };
        self.factor = Some((solver, w));
        self.bordered = None;
        let bordered = self.border(w.mass)?;
        self.bordered = bordered;
        Ok(())
    }

    /// What the factor lacks of a moving base; nothing in statics, which inertia does not enter.
    fn border(&self, weight: f64) -> Result<Option<Bordered>, AnalysisError> {
        let Some(border) = self.inertia.and_then(|i| i.border).filter(|_| weight != 0.0) else { return Ok(None) };
        let solve = |column: &[f64]| {
            let mut x = Vec::new();
            self.substitute(column, &mut x, PRECISE).map(|_| x)
        };
        Bordered::new(border, weight, &self.effective, solve).map(Some)
    }

    /// The mean of the effective tangent, or of that with the initial stiffness if it is not positive definite; joints as they are.
    fn ring_solver(&self, w: Weights, before: Option<Solver>) -> Result<RingSolver, AnalysisError> {
        let Some(layout) = &self.rings else { return Err(failed(WHAT)(LinalgError::Singular { size: 0 })) };
        let shares = self.shares(w);
        let (model, assembler) = (self.model, self.assembler);
        let make = |before: Option<Solver>, sparse: &Symmetric| match before {
            Some(Solver::Rings(mut solver)) => {
                solver.refactor(model, assembler, sparse, &shares)?;
                Ok(solver.on_threads(self.threads))
            }
            _ => RingSolver::new(layout, model, assembler, sparse, &shares).map(|made| made.on_threads(self.threads)),
        };
        if let Ok(solver) = make(before, &self.effective) {
            return Ok(solver);
        }
        // Without C_T, which a resumed run has in another state.
        let stiffness = assembler.stiffness(model);
        let mut initial = stiffness.map_err(|source| AnalysisError::Element { number: 0, source })?;
        initial.values.iter_mut().for_each(|k| *k *= w.stiffness);
        if let Some(inertia) = self.inertia {
            inertia.add_to(&mut initial, w);
        }
        layout.take_joints(&self.effective, &mut initial);
        make(None, &initial).map_err(failed(WHAT))
    }

    /// x = A⁻¹ b with the factor there is.
    pub(super) fn back_substitute(&mut self, b: &[f64], x: &mut Vec<f64>) -> Result<(), AnalysisError> {
        // Two solutions suffice for the criterion of forces.
        let tolerance = TOLERANCE.min(self.options.criteria.force.sqrt());
        let mut products = 0;
        let mut solve = |b: &[f64], x: &mut Vec<f64>| {
            products += self.substitute(b, x, tolerance)?;
            Ok(())
        };
        match (&self.bordered, self.inertia.and_then(|i| i.border)) {
            (Some(bordered), Some(border)) => bordered.solve(border, b, x, solve)?,
            _ => solve(b, x)?,
        }
        self.cost.products += products as u64;
        Ok(())
    }

    /// The same without a moving base, to a relative residual where it iterates; returns the number of products.
    fn substitute(&self, b: &[f64], x: &mut Vec<f64>, tolerance: f64) -> Result<usize, AnalysisError> {
        let (solver, _) = self.factor.as_ref().ok_or(AnalysisError::option(
            "Newton's method",
            "no factor",
            "a factor of the effective tangent",
        ))?;
        match solver {
            Solver::Direct(factor) => {
                x.clear();
                x.extend_from_slice(b);
                let mut column = crate::linalg::Matrix { rows: x.len(), cols: 1, data: std::mem::take(x) };
                let solved = factor.solve(&mut column);
                *x = column.data;
                solved.map(|_| 0).map_err(failed(WHAT))
            }
            Solver::Zone(solver) => self.solve_guided(solver, b, x).map_err(failed(WHAT)),
            Solver::Rings(solver) => {
                solver.solve(self.model, self.assembler, &self.effective, b, x, tolerance).map_err(failed(WHAT))
            }
        }
    }

    /// x = A⁻¹ b with the factors of a zone: as they are, or as the guide of an iteration where its outside is a mean.
    fn solve_guided(&self, solver: &ZoneSolver, b: &[f64], x: &mut Vec<f64>) -> Result<usize, LinalgError> {
        let Some((zoned, (_, w))) = self.zoned.as_ref().zip(self.factor.as_ref()).filter(|_| solver.is_mean()) else {
            solver.solve(b, x);
            return Ok(0);
        };
        let share = self.shares(*w).first().copied().unwrap_or_default();
        let mut images = vec![0.0; b.len()];
        let mut product = |x: &[f64], y: &mut [f64]| {
            let whole = (&zoned.whole, &|_| share);
            self.assembler.add_whole_product(self.model, whole, x, [y, &mut images], self.threads);
        };
        let mut room = Vec::new();
        let mut guide = |r: &[f64], z: &mut [f64]| {
            solver.solve(r, &mut room);
            z.copy_from_slice(&room);
            Ok(())
        };
        x.clear();
        x.resize(b.len(), 0.0);
        gmres(&mut product, &mut guide, b, x, GUIDED, FEW).map(|found| found.count)
    }

    /// (M + ε K)⁻¹ b for each of two right-hand sides, the second of which follows from the first solution.
    pub(super) fn regular_mass(
        &self,
        epsilon: f64,
        force: &[f64],
        rest: impl Fn(&[f64]) -> Vec<f64>,
    ) -> Result<[Vec<f64>; 2], AnalysisError> {
        let Some(inertia) = self.inertia else {
            return Err(failed("the mass matrix")(LinalgError::Singular { size: 0 }));
        };
        let mut regular = inertia.mass.clone();
        regular.add(epsilon, inertia.stiffness);
        let shares: Vec<[f64; 2]> = self.assembler.operators(self.model).map(|_| [1.0, epsilon]).collect();
        let (of_mass, after) = (failed("the mass matrix"), failed("the acceleration after a jump"));
        if let Some(zoned) = &self.zoned {
            let mut solver = ZoneSolver::new(&zoned.zone, Keep::Double, self.threads).map_err(&of_mass)?;
            solver.renew(&regular, None, &shares).map_err(&of_mass)?;
            let [mut first, mut second] = [Vec::new(), Vec::new()];
            solver.solve(force, &mut first);
            solver.solve(&rest(&first), &mut second);
            return Ok([first, second]);
        }
        let (model, assembler) = (self.model, self.assembler);
        let solver: Solved<'_> = match &self.rings {
            None => {
                let factor = self.symbolic.factor(&regular, self.kind).map_err(&of_mass)?;
                Box::new(move |b| factor.solve_vector(b).map_err(&after))
            }
            Some(layout) => {
                let solver = RingSolver::new(layout, model, assembler, &regular, &shares).map_err(&of_mass)?;
                let regular = &regular;
                Box::new(move |b| {
                    let mut x = Vec::new();
                    let solved = solver.solve(model, assembler, regular, b, &mut x, EXACT);
                    solved.map(|_| x).map_err(&after)
                })
            }
        };
        let Some(border) = inertia.border else {
            let first = solver(force)?;
            let second = solver(&rest(&first))?;
            return Ok([first, second]);
        };
        let bordered = Bordered::new(border, 1.0, &regular, &solver)?;
        let solve = |b: &[f64]| {
            let mut x = Vec::new();
            let own = |b: &[f64], x: &mut Vec<f64>| solver(b).map(|found| *x = found);
            bordered.solve(border, b, &mut x, own).map(|()| x)
        };
        let first = solve(force)?;
        let second = solve(&rest(&first))?;
        Ok([first, second])
    }
}
