//! Solutions with the initial stiffness of a model.

use fem::analysis::rings::solve_once;
use fem::analysis::zone::solver::ZoneSolver;
use fem::cores;
use fem::linalg::{Keep, Kind};
use fem::liquid::WallLiquid;

use super::CylinderModel;
use crate::FeError;
use crate::error::failed;

/// Solves a linear system.
type StaticSolver<'a> = Box<dyn Fn(&[f64]) -> Result<Vec<f64>, FeError> + 'a>;

impl CylinderModel {
    /// Solves with the initial stiffness.
    pub(super) fn static_solver(&self) -> Result<StaticSolver<'_>, FeError> {
        if let Some(zone) = &self.zone {
            let shares: Vec<[f64; 2]> = self.assembler.operators(&self.model).map(|_| [0.0, 1.0]).collect();
            let mut solver = ZoneSolver::new(zone, Keep::Double, cores::available()).map_err(failed)?;
            solver.renew(&self.system.stiffness, None, &shares).map_err(failed)?;
            return Ok(Box::new(move |b| {
                let mut x = Vec::new();
                solver.solve(b, &mut x);
                Ok(x)
            }));
        }
        if let WallLiquid::Circular(_) = &self.liquid {
            let solve = |b: &[f64]| {
                let (model, assembler) = (&self.model, &self.assembler);
                solve_once(model, assembler, &self.system.stiffness, [0.0, 1.0], b).map_err(failed)
            };
            return Ok(Box::new(solve));
        }
        let factor = self.symbolic.factor(&self.system.stiffness, Kind::QuasiDefinite);
        let factor = factor.map_err(failed)?;
        Ok(Box::new(move |b| factor.solve_vector(b).map_err(failed)))
    }
}
