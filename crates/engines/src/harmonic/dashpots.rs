//! Rings of dashpots on one harmonic.
//!
//! n ≥ 3 dashpots of c/n each, evenly spaced around the wall, have for a field q(z) cos mθ (or sin mθ) the power of a ring,
//!
//! ```text
//! Σ c/n (q̇ cos mθ_i)² = c/2 q̇²   (m = 1)        c q̇²   (m = 0)
//! ```
//!
//! q is w, v or u. For m = 1 the mean of cos² is 1/2 for any n ≥ 3, wherever the first dashpot stands. Responses of other harmonics to those of
//! this one, which n dashpots excite from n − 1 on, are left out.

use tank::options::LinearOptions as Options;
use tank::options::linear::WallDirection;

use super::assembly::Assembly;
use super::wall::displacements;

/// Rows over the free unknowns with their coefficients.
pub(super) fn rows(assembly: &Assembly, options: &Options) -> Vec<(Vec<f64>, f64)> {
    let wall = &assembly.wall;
    // A strip is not a ring.
    let rings = options.dashpots.iter().filter(|_| wall.curvature > 0.0);
    let share = if assembly.harmonic == 0 { 1.0 } else { 0.5 };
    rings
        .map(|ring| {
            let (e, xi) = wall.locate(ring.z, true);
            let element = &wall.elements[e];
            let [u, v, w] = displacements(xi, element.length);
            let local = match ring.direction {
                WallDirection::Radial => w,
                WallDirection::Tangential => v,
                WallDirection::Vertical => u,
            };
            let mut row = vec![0.0; assembly.size];
            assembly.add_nodal_row(e, &element.condensed_row(&local), 1.0, &mut row);
            (assembly.reduction.row(&row), share * ring.coefficient)
        })
        .collect()
}
