//! Linear buckling about a loaded state.
//!
//! ```text
//! (K₀ + μ K_G) φ = 0 ,   μ > 0 the smallest
//! ```
//!
//! K₀ is the tangent of the state from which the load grows, positive definite, K_G the geometric stiffness of the stresses that
//! the load adds to it ([`Assembler::geometric_stiffness`](crate::assembly::Assembler::geometric_stiffness) of the linear solution).
//! K_G is indefinite: a load that buckles a wall where it compresses stiffens it elsewhere. The negative pivots of K₀ + μ K_G
//! count the buckling loads below μ (Sylvester), which encloses the smallest between μ₁ and a little more; then
//!
//! ```text
//! (K₀ + μ₁ K_G) φ = κ K₀ φ ,   κ = 1 − μ₁/μ
//! ```
//!
//! is a definite problem whose lowest pair is the one wanted, far below all others that are not near it.

use std::sync::Arc;

use super::{AnalysisError, failed};
use crate::linalg::{Kind, LinalgError, Search, Sparse, Symbolic, Symmetric, modes};

/// Width of the bracket around the smallest multiplier: the lowest κ is below it, and Lanczos needs a shift that close only.
const BRACKET: f64 = 1.02;
/// Larger multipliers count as infinite.
const MOST: f64 = 1e9;

/// A buckling mode.
#[derive(Clone, Debug, PartialEq)]
pub struct Buckling {
    /// μ: times the load.
    pub factor: f64,
    /// φ over the unknowns, its largest entry 1.
    pub mode: Vec<f64>,
}

/// The lowest buckling mode; `None` if no multiple of the load up to 10⁹ buckles anything.
///
/// * `stiffness`: K₀, positive definite, `geometric`: K_G, both on the pattern of `symbolic`
///
/// Errors: a K₀ that is not positive definite; the eigenvalue solver.
pub fn lowest(
    stiffness: &Symmetric,
    geometric: &Symmetric,
    symbolic: &Arc<Symbolic>,
) -> Result<Option<Buckling>, AnalysisError> {
    let at = |factor: f64| {
        let mut sum = stiffness.clone();
        sum.add(factor, geometric);
        sum
    };
    let stable = |factor: f64| -> Result<bool, AnalysisError> {
        let factor = symbolic.factor(&at(factor), Kind::QuasiDefinite);
        Ok(factor.map_err(failed("stiffness under load"))?.inertia().negative == 0)
    };
    symbolic.factor(stiffness, Kind::Definite).map_err(failed("stiffness before the load"))?;
    let (mut low, mut high) = (0.0, 1.0);
    while stable(high)? {
        low = high;
        high *= 4.0;
        if high > MOST {
            return Ok(None);
        }
    }
    while low == 0.0 {
        let next = 0.25 * high;
        if next < 1.0 / MOST {
            return Err(AnalysisError::Linalg {
                what: "stiffness under load",
                source: LinalgError::Singular { size: symbolic.pattern().size() },
            });
        }
        if stable(next)? {
            low = next;
        } else {
            high = next;
        }
    }
    while high > BRACKET * low {
        let middle = (low * high).sqrt();
        if stable(middle)? {
            low = middle;
        } else {
            high = middle;
        }
    }
    let loaded = at(low);
    let pencil = Sparse::new(&loaded, stiffness, symbolic.clone());
    let found = modes(&pencil, &Search::lowest(1)).map_err(failed("buckling modes"))?;
    let Some(&kappa) = found.lambda.first() else { return Ok(None) };
    let vector = found.vectors.column(0);
    let largest = vector.iter().fold(0.0_f64, |m, v| if v.abs() > m.abs() { *v } else { m });
    Ok(Some(Buckling { factor: low / (1.0 - kappa), mode: vector.iter().map(|v| v / largest).collect() }))
}
