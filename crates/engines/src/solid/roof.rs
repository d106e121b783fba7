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
use fem::element::{Element, ElementError, LocalMatrix, Response, Trial};

/// The ring of mass.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct RoofRing {
    nodes: Vec<usize>,
    /// Tilts ψ = Σ p u_z about the middle, (p_x, p_y) of every node [1/m].
    tilts: Vec<(f64, f64)>,
    /// Share of each node in the ring; all of them add to 1.
    shares: Vec<f64>,
    mass: f64,
    lever: f64,
    /// Share of its weight that the wall carries.
    carried: f64,
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
        let tilt = |direction: f64, share: f64| -2.0 * direction * share / radius;
        let tilts = positions.iter().zip(&shares);
        RoofRing {
            tilts: tilts.map(|(p, &s)| (tilt(p[0] / radius, s), tilt(p[1] / radius, s))).collect(),
            nodes,
            shares,
            mass,
            lever,
            carried: 1.0,
        }
    }

    /// The same with this share of its weight on the wall; columns carry the rest.
    #[must_use]
    pub(crate) fn carrying(self, share: f64) -> RoofRing {
        RoofRing { carried: share, ..self }
    }

    /// A closed frame of `mass` [kg] on nodes in the order of a polygon symmetric about both axes, spread evenly over its length; its centre
    /// is `lever` [m] above them. Its tilt is the straight line of least squares through u_z.
    pub(crate) fn frame(nodes: Vec<usize>, positions: &[[f64; 3]], mass: f64, lever: f64) -> RoofRing {
        let n = positions.len();
        let side = |a: usize| {
            let (p, q) = (positions[a % n], positions[(a + 1) % n]);
            (p[0] - q[0]).hypot(p[1] - q[1])
        };
        let around: f64 = (0..n).map(side).sum();
        let shares: Vec<f64> = (0..n).map(|a| 0.5 * (side(a + n - 1) + side(a)) / around).collect();
        let square = |axis: usize| -> f64 { positions.iter().zip(&shares).map(|(p, s)| s * p[axis] * p[axis]).sum() };
        let [x, y] = [square(0), square(1)];
        let tilts = positions.iter().zip(&shares);
        RoofRing {
            tilts: tilts.map(|(p, s)| (-s * p[0] / x, -s * p[1] / y)).collect(),
            nodes,
            shares,
            mass,
            lever,
            carried: 1.0,
        }
    }
}

impl Element for RoofRing {
    fem::answers!("roof", nodes, Dof::TRANSLATIONS);

    fn mass(&self, out: &mut LocalMatrix) {
        for i in 0..out.n {
            out.add(i, i, self.mass * self.shares[i / 3]);
        }
        if self.lever == 0.0 {
            return;
        }
        for (a, &(xa, ya)) in self.tilts.iter().enumerate() {
            for (b, &(xb, yb)) in self.tilts.iter().enumerate() {
                let share = self.shares[a];
                for (c, ta, tb) in [(0, xa, xb), (1, ya, yb)] {
                    let (ta, tb) = (ta * self.lever, tb * self.lever);
                    out.add(3 * a + c, 3 * b + 2, self.mass * share * tb);
                    out.add(3 * b + 2, 3 * a + c, self.mass * share * tb);
                    out.add(3 * a + 2, 3 * b + 2, self.mass * ta * tb);
                }
            }
        }
    }

    fn respond(&self, _: Trial<'_>, _out: &mut Response) -> Result<(), ElementError> {
        Ok(())
    }

    fn body_force(&self, acceleration: [f64; 3], out: &mut [f64]) {
        for (force, share) in out.chunks_exact_mut(3).zip(&self.shares) {
            for ((f, b), part) in force.iter_mut().zip(acceleration).zip([1.0, 1.0, self.carried]) {
                *f += self.mass * share * part * b;
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
        // A rectangle of 4 by 6 m.
        let corners =
            [[2.0, 0.0], [2.0, 3.0], [0.0, 3.0], [-2.0, 3.0], [-2.0, 0.0], [-2.0, -3.0], [0.0, -3.0], [2.0, -3.0]];
        let frame: Vec<[f64; 3]> = corners.iter().map(|p| [p[0], p[1], z]).collect();
        let ring = RoofRing::frame((0..8).collect(), &frame, mass, lever);
        let m = reference_mass(&ring).to_matrix();
        let along: Vec<f64> = frame.iter().flat_map(|_| [0.6, 0.8, 0.0]).collect();
        assert!((fem::linalg::dot(&along, &m.times(&along)) / mass - 1.0).abs() < 1e-12);
        let tilted: Vec<f64> = frame.iter().flat_map(|p| [p[2], 0.0, -p[0]]).collect();
        // Lumped at the nodes: 2² over the long sides, half of it over the short ones.
        let lumped = (12.0 * 4.0 + 8.0 * 2.0) / 20.0;
        let exact_frame = mass * ((z + lever).powi(2) + lumped);
        assert!((fem::linalg::dot(&tilted, &m.times(&tilted)) / exact_frame - 1.0).abs() < 1e-12);
        // Half the ring has half of it in symmetric motions.
        let part = &positions[..=n as usize / 2];
        let half = RoofRing::half((0..part.len()).collect(), part, mass, lever);
        let m = reference_mass(&half).to_matrix();
        let rotation: Vec<f64> = part.iter().flat_map(|p| [p[2], 0.0, -p[0]]).collect();
        let own = fem::linalg::dot(&rotation, &m.times(&rotation));
        assert!((2.0 * own / exact - 1.0).abs() < 1e-12);
    }
}
