//! Linear statics: K u = p, and the state a transient starts from.

use std::sync::Arc;

use super::{AnalysisError, check_length, failed};
use crate::linalg::{Factor, Kind, Matrix, Symbolic, Symmetric, dot};

/// A factored stiffness matrix.
#[derive(Debug)]
pub struct Statics {
    factor: Factor,
}

/// Largest allowed ‖p − K u‖/‖p‖ after one refinement. Penalty methods reach condition numbers of 1e10, with which the
/// residual of a backward-stable solution is still of the order 1e-16 ‖K‖ ‖u‖/‖p‖ < 1e-7.
const RESIDUAL: f64 = 1e-6;

impl Statics {
    /// Factors K.
    ///
    /// Errors: a singular matrix (a mechanism, or a support forgotten), not enough memory.
    pub fn new(symbolic: &Arc<Symbolic>, stiffness: &Symmetric, kind: Kind) -> Result<Statics, AnalysisError> {
        let factor = symbolic.factor(stiffness, kind).map_err(failed("the stiffness matrix"))?;
        Ok(Statics { factor })
    }

    /// Displacements under the loads p, a column a load case, with one step of iterative refinement.
    ///
    /// Errors: loads of the wrong length; a residual that shows K to be singular.
    pub fn solve(&self, stiffness: &Symmetric, loads: &[&[f64]]) -> Result<Vec<Vec<f64>>, AnalysisError> {
        let n = self.factor.size();
        let mut x = Matrix::zeros(n, loads.len());
        for (j, p) in loads.iter().enumerate() {
            check_length("load vector", p.len(), n)?;
            x.column_mut(j).copy_from_slice(p);
        }
        self.factor.solve(&mut x).map_err(failed("the static solution"))?;
        let mut r = Matrix::zeros(n, loads.len());
        for (j, p) in loads.iter().enumerate() {
            r.column_mut(j).copy_from_slice(p);
            stiffness.add_product(-1.0, x.column(j), r.column_mut(j));
        }
        self.factor.solve(&mut r).map_err(failed("the static solution"))?;
        for (x, d) in x.data.iter_mut().zip(&r.data) {
            *x += d;
        }
        for (j, p) in loads.iter().enumerate() {
            let mut rest = p.to_vec();
            stiffness.add_product(-1.0, x.column(j), &mut rest);
            let (rest, scale) = (dot(&rest, &rest).sqrt(), dot(p, p).sqrt());
            if !(rest <= RESIDUAL * scale || scale == 0.0) {
                return Err(AnalysisError::option(
                    "static solution",
                    format!("relative residual {:.1e} in load case {}", rest / scale, j + 1),
                    format!("{RESIDUAL:.0e}: the stiffness matrix is singular or nearly so"),
                ));
            }
        }
        Ok((0..loads.len()).map(|j| x.column(j).to_vec()).collect())
    }
}
