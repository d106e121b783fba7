//! The liquid's floor over a bottom plate that lifts.
//!
//! ```text
//! y_jk       displacement of the liquid's floor at ring j and meridian k, upwards; linear between the rings, still within the inmost one
//! y_jk = Σ_i a_ji u_z,ik + g_jk  a_ji = ∫ N_j N_i r dr/∫ N_j r dr    over the rings i of the plate
//! W = κ_j g (y − Σ a u_z) − κ_j g²/2                                stationary in the gap g of a stiff spring κ_j = k ∫ N_j r dr Δθ
//! ```
//!
//! The gap g stays an unknown where the liquid is an operator. Eliminating it would couple all displacements of a meridian under one function,
//! κ a aᵀ, and triple the operations of the plate's factor. One element carries each term of W, which couples no other pair of unknowns. The pivot of g
//! is negative; y has no stiffness of its own and must be eliminated after g ([`fem::analysis::zone`]).
//!
//! The condensed liquid has y among its unknowns as it has the wall's radial displacements, so that its pressure acts on the plate and the moving
//! plate on the liquid, with one symmetric mass matrix: energy is kept. Few rings carry the pressure, which is smooth; the weights spread it
//! over the fine rings of the plate, so that a uniform pressure stays uniform.

use fem::dofs::Dof;
use fem::element::super_element::SuperElement;
use fem::linalg::Matrix;
use fem::model::Builder;

use crate::FeError;
use crate::error::failed;
use crate::nonlinear::arcs::shares;
use crate::nonlinear::bottom::Plate;

/// Group of the springs.
pub(super) const FLOOR: &str = "floor";
/// Places of the rings between the foot and the inmost ring of the plate.
const PLACES: [f64; 5] = [0.0, 0.1, 0.25, 0.5, 1.0];
/// Stiffness of the springs by area [N/m³]: a pressure of 100 kPa moves the liquid's floor by 0.01 mm against the plate.
const STIFF: f64 = 1e10;
/// Points of the weights in a ring of the plate.
const GAUSS: [f64; 2] = [-0.577_350_269_189_625_8, 0.577_350_269_189_625_8];

/// What of a spring acts on the plate.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct Share {
    /// Number of an element.
    pub element: usize,
    /// Its unknowns, and those that are u_z of a node: place and ring.
    pub size: usize,
    pub places: Vec<(usize, usize)>,
    /// Angle of the meridian [rad].
    pub angle: f64,
}

/// The floor of a model.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct LiquidFloor {
    /// Radii of its rings, falling [m].
    pub(super) radii: Vec<f64>,
    /// Nodes of y, ring after ring.
    pub(super) nodes: Vec<usize>,
}

impl LiquidFloor {
    /// Over a plate with `meridians` nodes in each ring.
    pub(super) fn over(plate: &Plate, builder: &mut Builder, meridians: usize) -> LiquidFloor {
        let (foot, width) = (plate.radii[plate.foot], plate.width());
        let radii: Vec<f64> = PLACES.iter().map(|x| foot - x * width).collect();
        let nodes = (0..radii.len() * meridians).map(|_| builder.node([0.0; 3])).collect();
        LiquidFloor { radii, nodes }
    }

    /// Joins the floor to the rings of the plate at these angles [rad], with the gaps as unknowns or without; returns the shares of the plate.
    ///
    /// Errors: those of the elements.
    pub(super) fn join(
        &self,
        plate: &Plate,
        builder: &mut Builder,
        rings: &[Vec<usize>],
        angles: &[f64],
        with_gaps: bool,
    ) -> Result<Vec<Share>, FeError> {
        let (shares, mut out) = (shares(angles), Vec::new());
        for (j, weights) in self.weights(plate).iter().enumerate() {
            let area: f64 = weights.iter().map(|w| w.1).sum();
            for (k, (share, &angle)) in shares.iter().zip(angles).enumerate() {
                let stiffness = STIFF * area * share;
                let on_plate = weights.iter().map(|(ring, weight)| ((rings[*ring][k], Dof::Uz), -weight / area));
                let own = (self.nodes[j * shares.len() + k], Dof::Amplitude);
                let row: Vec<((usize, Dof), f64)> = std::iter::once((own, 1.0)).chain(on_plate).collect();
                // Where it is, for the order of elimination.
                let place = [self.radii[j] * angle.cos(), self.radii[j] * angle.sin(), 0.0];
                let gap = with_gaps.then(|| (builder.node(place), Dof::Amplitude));
                let mut spring = |unknowns: &[(usize, Dof)], terms: &[(usize, usize, f64)]| {
                    let mut matrix = Matrix::zeros(unknowns.len(), unknowns.len());
                    terms.iter().for_each(|&(a, b, term)| matrix.add(a, b, stiffness * term));
                    let spring = SuperElement::over(unknowns).and_then(|e| e.with_stiffness(matrix));
                    spring.map(|e| builder.element(FLOOR, e)).map_err(failed)
                };
                let Some(gap) = gap else {
                    let unknowns: Vec<_> = row.iter().map(|r| r.0).collect();
                    let terms: Vec<_> = (0..row.len())
                        .flat_map(|a| (0..row.len()).map(move |b| (a, b)))
                        .map(|(a, b)| (a, b, row[a].1 * row[b].1))
                        .collect();
                    out.push(Share {
                        element: spring(&unknowns, &terms)?,
                        size: row.len(),
                        places: weights.iter().enumerate().map(|(i, (ring, _))| (1 + i, *ring)).collect(),
                        angle,
                    });
                    continue;
                };
                spring(&[own, gap], &[(0, 1, 1.0), (1, 0, 1.0), (1, 1, -1.0)])?;
                for ((unknown, along), (ring, _)) in row[1..].iter().zip(weights) {
                    out.push(Share {
                        element: spring(&[*unknown, gap], &[(0, 1, *along), (1, 0, *along)])?,
                        size: 2,
                        places: vec![(0, *ring)],
                        angle,
                    });
                }
            }
        }
        Ok(out)
    }

    /// For each ring of the floor the rings of the plate under its function, with ∫ N_j N_i r dr [m²/rad].
    fn weights(&self, plate: &Plate) -> Vec<Vec<(usize, f64)>> {
        let mut out = vec![vec![0.0; plate.radii.len()]; self.radii.len()];
        for (i, pair) in plate.radii.windows(2).enumerate().skip(plate.foot) {
            let (middle, half) = (0.5 * (pair[0] + pair[1]), 0.5 * (pair[0] - pair[1]));
            for xi in GAUSS {
                let r = middle + half * xi;
                let own = [0.5 * (1.0 + xi), 0.5 * (1.0 - xi)];
                for (j, to) in out.iter_mut().enumerate() {
                    let value = hat(&self.radii, j, r) * r * half;
                    to[i] += value * own[0];
                    to[i + 1] += value * own[1];
                }
            }
        }
        let kept = |row: Vec<f64>| row.into_iter().enumerate().filter(|(_, w)| *w > 0.0).collect();
        out.into_iter().map(kept).collect()
    }
}

/// Function of a ring at a radius between the first and the last: 1 there and 0 at its neighbours.
fn hat(radii: &[f64], ring: usize, r: f64) -> f64 {
    let side = |other: Option<&f64>| {
        let other = other?;
        let t = (r - other) / (radii[ring] - other);
        (0.0..=1.0).contains(&t).then_some(t)
    };
    let outwards = ring.checked_sub(1).and_then(|i| radii.get(i));
    if r == radii[ring] {
        return 1.0;
    }
    let other = if r > radii[ring] { outwards } else { radii.get(ring + 1) };
    side(other).unwrap_or(0.0)
}

#[cfg(test)]
mod tests {
    use super::hat;

    /// At every radius the functions of all rings add up to 1.
    #[test]
    fn functions_share_everything() {
        let radii = [5.0, 4.75, 4.4, 3.75, 2.5];
        for r in [5.0, 4.9, 4.75, 4.1, 2.6, 2.5] {
            let sum: f64 = (0..radii.len()).map(|j| hat(&radii, j, r)).sum();
            assert!((sum - 1.0).abs() < 1e-12, "{r}: {sum}");
        }
    }
}
