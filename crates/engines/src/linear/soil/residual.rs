//! What dashpots need of the modes that are not resolved.
//!
//! ```text
//! d = K⁻¹ b − Σ φ_j (φ_jᵀ M K⁻¹ b)          (dᵀ M d, dᵀ K d) → a mode of each d, M- and K-orthogonal to φ_j
//! ```
//!
//! A slab without mass has next to no mass but that of tank and liquid: most of its motion under a force at its underside lies in modes of so
//! high a frequency that they are not resolved, and modes that follow the ground statically have no force of a dashpot. With the static
//! response d to the force of each dashpot the modes contain it. Without d translation and rotation of the slab of the tests are 1.1 % and
//! 1.6 % from those of [`::soil::body`]; a slab with mass has them in its modes.

use fem::linalg::{Cholesky, Matrix, dot, generalized_eigen};

use crate::FeError;
use crate::coupled::Coupled;
use crate::error::failure;
use crate::modes::{CoupledMode, Kind};

/// Share of dᵀ K d in bᵀ K⁻¹ b below which the modes have all of it but rounding.
const NOTHING: f64 = 1e-7;

/// Modes of the static responses to `dashpots`, beside those found.
///
/// Errors: K not positive definite.
pub(super) fn modes(
    system: &Coupled,
    found: &[CoupledMode],
    dashpots: &[(Vec<f64>, f64)],
) -> Result<Vec<CoupledMode>, FeError> {
    let failed = || failure("the stiffness under the dashpots of the soil");
    let factor = Cholesky::factor(&system.stiffness).map_err(failed())?;
    let mut left: Vec<Vec<f64>> = Vec::new();
    for (row, _) in dashpots {
        let mut d = factor.solve_vector(row);
        let whole = dot(row, &d);
        // Twice: the first pass leaves the rounding of what it takes away.
        for _ in 0..2 {
            let momentum = system.mass.times(&d);
            for mode in found {
                add(&mut d, -dot(&mode.vector, &momentum), &mode.vector);
            }
        }
        let energy = dot(&d, &system.stiffness.times(&d));
        if energy > NOTHING * whole {
            let scale = 1.0 / energy.sqrt();
            d.iter_mut().for_each(|v| *v *= scale);
            left.push(d);
        }
    }
    if left.is_empty() {
        return Ok(Vec::new());
    }
    let reduced = |whole: &Matrix| {
        let mut small = Matrix::zeros(left.len(), left.len());
        for (j, d) in left.iter().enumerate() {
            let image = whole.times(d);
            left.iter().enumerate().for_each(|(i, other)| small.add(i, j, dot(other, &image)));
        }
        small
    };
    let eigen = generalized_eigen(&reduced(&system.stiffness), &reduced(&system.mass), None).map_err(failed())?;
    let load = system.mass.times(&system.influence);
    let number = found.iter().filter(|mode| mode.kind == Kind::Structural).count();
    let mode = |(j, &omega): (usize, &f64)| {
        let mut vector = vec![0.0; system.influence.len()];
        for (share, d) in eigen.vectors.column(j).iter().zip(&left) {
            add(&mut vector, *share, d);
        }
        CoupledMode {
            kind: Kind::Structural,
            number: number + j + 1,
            omega,
            participation: dot(&vector, &load),
            effective_height: 0.0,
            surface_share: 0.0,
            damping: None,
            vector,
        }
    };
    Ok(eigen.omega.iter().enumerate().map(mode).collect())
}

/// x + a y.
fn add(x: &mut [f64], a: f64, y: &[f64]) {
    x.iter_mut().zip(y).for_each(|(x, y)| *x += a * y);
}
