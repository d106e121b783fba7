//! Roof of a round tank: a ring of mass on the edge of the wall, whose centre may lie above it.
//!
//! ```text
//! 2 T = Σ m_r/n |u̇_s|² + m_r Σ_{c = x, y} (2 d U̇_c ψ̇_c + d² ψ̇_c²)
//! U_c = 1/n Σ u_c          ψ_x = −2/(n R) Σ cos θ_s u_z,   ψ_y = −2/(n R) Σ sin θ_s u_z
//! ```
//!
//! with the height d of the centre of mass above the edge: it moves by U_c + d ψ_c with the mean translation U and tilt ψ
//! of the edge.

use fem::dofs::Dof;
use fem::element::{Element, ElementError, LocalMatrix, Motion, Response, Want};

/// The ring of mass.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct RoofRing {
    nodes: Vec<usize>,
    /// (cos θ, sin θ) of the nodes.
    directions: Vec<(f64, f64)>,
    /// Share of each node in the ring; all of them add to 1.
    shares: Vec<f64>,
    mass: f64,
    radius: f64,
    lever: f64,
}

impl RoofRing {
    /// A ring of `mass` [kg] on equally spaced nodes at `positions` about the z axis, its centre `lever` [m] above them.
    pub(crate) fn new(nodes: Vec<usize>, positions: &[[f64; 3]], mass: f64, lever: f64) -> RoofRing {
        let share = 1.0 / nodes.len() as f64;
        let shares = vec![share; nodes.len()];
        RoofRing::of_shares(nodes, positions, shares, mass, lever)
    }

    /// The half at 0 ≤ θ ≤ π of a ring of `mass` [kg], for motions symmetric about that plane; nodes from θ = 0 to π.
    pub(crate) fn half(nodes: Vec<usize>, positions: &[[f64; 3]], mass: f64, lever: f64) -> RoofRing {
        let sectors = (nodes.len() - 1) as f64;
        let mut shares = vec![1.0 / sectors; nodes.len()];
        for end in [0, nodes.len() - 1] {
            shares[end] *= 0.5;
        }
        RoofRing::of_shares(nodes, positions, shares, 0.5 * mass, lever)
    }

    fn of_shares(nodes: Vec<usize>, positions: &[[f64; 3]], shares: Vec<f64>, mass: f64, lever: f64) -> RoofRing {
        let radius = positions.first().map_or(1.0, |p| p[0].hypot(p[1]));
        RoofRing {
            directions: positions.iter().map(|p| (p[0] / radius, p[1] / radius)).collect(),
            nodes,
            shares,
            mass,
            radius,
            lever,
        }
    }
}

impl Element for RoofRing {
    fn kind(&self) -> &'static str {
        "roof"
    }

    fn nodes(&self) -> &[usize] {
        &self.nodes
    }

    fn dofs(&self, _node: usize) -> &'static [Dof] {
        Dof::TRANSLATIONS
    }

    fn mass(&self, out: &mut LocalMatrix) {
        for i in 0..out.n {
            out.add(i, i, self.mass * self.shares[i / 3]);
        }
        if self.lever == 0.0 {
            return;
        }
        for (a, &(ca, sa)) in self.directions.iter().enumerate() {
            for (b, &(cb, sb)) in self.directions.iter().enumerate() {
                let [pa, pb] = [self.shares[a], self.shares[b]];
                for (c, da, db) in [(0, ca, cb), (1, sa, sb)] {
                    let tilt = |d: f64, share: f64| -2.0 * d * share / self.radius * self.lever;
                    out.add(3 * a + c, 3 * b + 2, self.mass * pa * tilt(db, pb));
                    out.add(3 * b + 2, 3 * a + c, self.mass * pa * tilt(db, pb));
                    out.add(3 * a + 2, 3 * b + 2, self.mass * tilt(da, pa) * tilt(db, pb));
                }
            }
        }
    }

    fn respond(
        &self,
        _motion: Motion<'_>,
        _old: &[f64],
        _new: &mut [f64],
        _want: Want,
        _out: &mut Response,
    ) -> Result<(), ElementError> {
        Ok(())
    }

    fn body_force(&self, acceleration: [f64; 3], out: &mut [f64]) {
        for (force, share) in out.chunks_exact_mut(3).zip(&self.shares) {
            for (f, b) in force.iter_mut().zip(acceleration) {
                *f += self.mass * share * b;
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use fem::element::reference_mass;

    /// A rigid translation moves m_r; a rigid rotation about the y axis through the base moves m_r ((z + d)² + R²/2): the
    /// ring's own mass m_r (z² + R²/2), and the lever.
    #[test]
    fn rigid_motions() {
        let (n, radius, z, lever, mass) = (12, 3.0, 5.0, 0.7, 40.0);
        let positions: Vec<[f64; 3]> = (0..n)
            .map(|s| {
                let (sine, cosine) = (std::f64::consts::TAU * f64::from(s) / f64::from(n)).sin_cos();
                [radius * cosine, radius * sine, z]
            })
            .collect();
        let ring = RoofRing::new((0..n as usize).collect(), &positions, mass, lever);
        let m = reference_mass(&ring).to_matrix();
        let energy = |x: &[f64]| fem::linalg::dot(x, &m.times(x));
        let translation: Vec<f64> = positions.iter().flat_map(|_| [0.6, 0.8, 0.0]).collect();
        assert!((energy(&translation) / mass - 1.0).abs() < 1e-12);
        let rotation: Vec<f64> = positions.iter().flat_map(|p| [p[2], 0.0, -p[0]]).collect();
        let exact = mass * ((z + lever).powi(2) + 0.5 * radius * radius);
        assert!((energy(&rotation) / exact - 1.0).abs() < 1e-12);
        // Half the ring has half of it in symmetric motions.
        let part = &positions[..=n as usize / 2];
        let half = RoofRing::half((0..part.len()).collect(), part, mass, lever);
        let m = reference_mass(&half).to_matrix();
        let rotation: Vec<f64> = part.iter().flat_map(|p| [p[2], 0.0, -p[0]]).collect();
        let own = fem::linalg::dot(&rotation, &m.times(&rotation));
        assert!((2.0 * own / exact - 1.0).abs() < 1e-12);
    }
}
