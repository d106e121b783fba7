//! The joint of a wall and a liquid over a piece between two levels, whose closed part is cut where the pressing force vanishes.
//!
//! ```text
//! q(t) = k e(t) + s(t)·x ,  0 ≤ t ≤ 1 along the piece: linear between its ends, closed where q ≥ 0
//! F_a = L [Σ_b W_ab q_b − Σ_b M_ab s_b·x] ,   W = r M + (1 − r) A ,   M_ab = ∫₀¹ N_a N_b dt ,   A_ab = ∫ N_a N_b dt where q ≥ 0
//! ∂F_a/∂e_b = k L W_ab
//! ```
//!
//! F_a is the integral of N_a times the law of [`super::LiquidJoint`], exact for any place of the zero of q. It is continuous with its tangent:
//! the boundary of the closed part moves where the integrand vanishes, so that there is no set to be found and Newton's method does not cycle.
//! s·x is that of the end of the last step, as there.

use super::{JointPoint, PointForce, RESIDUAL, add, dot};
use crate::dofs::Dof;
use crate::element::{Contact, Element, ElementError, LocalMatrix, Motion, Response, Want};

const KIND: &str = "clipped_joint";

/// ∫₀¹ N_a N_b dt.
const WHOLE: [[f64; 2]; 2] = [[1.0 / 3.0, 1.0 / 6.0], [1.0 / 6.0, 1.0 / 3.0]];

/// The element.
#[derive(Clone, Debug)]
pub struct ClippedJoint {
    nodes: Vec<usize>,
    dofs: Vec<Dof>,
    ends: [JointPoint; 2],
    length: f64,
}

impl ClippedJoint {
    /// Joint over these unknowns, components along the axes of the nodes' frames.
    ///
    /// * `ends`: closing and relief at both ends, the relief per area and breadth [Pa m per unknown], `stiffness` k times the breadth [N/m²], the
    ///   same at both
    /// * `length`: L [m]
    ///
    /// Errors: no unknown; a row that leaves the unknowns; a stiffness or length that is not positive.
    pub fn new(unknowns: &[(usize, Dof)], ends: [JointPoint; 2], length: f64) -> Result<ClippedJoint, ElementError> {
        let refuse = |parameter, found: String, allowed| {
            Err(ElementError::Parameter {
                kind: KIND,
                parameter,
                found,
                allowed,
            })
        };
        for end in &ends {
            let mut rows = end.closing.iter().chain(&end.relief);
            if let Some((i, c)) = rows.find(|(i, c)| *i >= unknowns.len() || !c.is_finite()) {
                let found = format!("{c} on unknown {i}");
                return refuse("row", found, "finite, on unknowns of the element");
            }
            if !(end.stiffness > 0.0 && end.stiffness.is_finite()) || end.stiffness != ends[0].stiffness {
                return refuse(
                    "stiffness",
                    end.stiffness.to_string(),
                    "> 0 N/m², the same at both ends",
                );
            }
        }
        if !(length > 0.0 && length.is_finite()) {
            return refuse("length", length.to_string(), "> 0 m");
        }
        Ok(ClippedJoint {
            nodes: unknowns.iter().map(|u| u.0).collect(),
            dofs: unknowns.iter().map(|u| u.1).collect(),
            ends,
            length,
        })
    }

    /// q at both ends.
    fn pressing(&self, values: &[f64], relief: &[f64]) -> [f64; 2] {
        std::array::from_fn(|a| self.ends[a].stiffness * dot(&self.ends[a].closing, values) + relief[a])
    }

    /// F at both ends [N].
    fn forces(&self, q: [f64; 2], relief: &[f64]) -> [f64; 2] {
        let weights = weights(q);
        std::array::from_fn(|a| {
            let sum = |b: usize| weights[a][b] * q[b] - WHOLE[a][b] * relief[b];
            self.length * (sum(0) + sum(1))
        })
    }

    /// Both ends at `values` of the unknowns, with the `history` that was committed with them; forces are those on the ends' unknowns.
    pub fn look(&self, values: &[f64], history: &[f64]) -> [PointForce; 2] {
        let q = self.pressing(values, history);
        let forces = self.forces(q, history);
        std::array::from_fn(|a| PointForce {
            closing: dot(&self.ends[a].closing, values),
            force: forces[a],
            gap: (-q[a] / self.ends[a].stiffness).max(0.0),
        })
    }
}

/// W of the pressing forces at both ends.
fn weights(q: [f64; 2]) -> [[f64; 2]; 2] {
    let closed = match (q[0] >= 0.0, q[1] >= 0.0) {
        (true, true) => [0.0, 1.0],
        (false, false) => [0.0, 0.0],
        (first, _) => {
            let zero = q[0] / (q[0] - q[1]);
            if first { [0.0, zero] } else { [zero, 1.0] }
        }
    };
    // ∫ (1 − t)², ∫ t (1 − t), ∫ t² from `from` to `to`.
    let [from, to] = closed;
    let cube = |x: f64| x * x * x / 3.0;
    let first = cube(1.0 - from) - cube(1.0 - to);
    let second = cube(to) - cube(from);
    let mixed = 0.5 * (to * to - from * from) - second;
    let own = [[first, mixed], [mixed, second]];
    std::array::from_fn(|a| std::array::from_fn(|b| RESIDUAL * WHOLE[a][b] + (1.0 - RESIDUAL) * own[a][b]))
}

impl Element for ClippedJoint {
    fn kind(&self) -> &'static str {
        KIND
    }

    fn nodes(&self) -> &[usize] {
        &self.nodes
    }

    fn dofs(&self, node: usize) -> &'static [Dof] {
        let own = self.dofs[node].index();
        Dof::slice(own..own + 1)
    }

    fn own_axes(&self) -> bool {
        true
    }

    /// s·x of both ends at the end of the last step.
    fn history_len(&self) -> usize {
        2
    }

    fn has_mass(&self) -> bool {
        false
    }

    fn respond(
        &self,
        motion: Motion<'_>,
        old: &[f64],
        new: &mut [f64],
        want: Want,
        out: &mut Response,
    ) -> Result<(), ElementError> {
        let q = self.pressing(motion.values, old);
        for (end, after) in self.ends.iter().zip(new) {
            *after = dot(&end.relief, motion.values);
        }
        if want.force {
            for (end, force) in self.ends.iter().zip(self.forces(q, old)) {
                end.closing.iter().for_each(|&(i, c)| out.force[i] += force * c);
            }
        }
        if want.tangent {
            self.add_tangent(&weights(q), &mut out.tangent);
        }
        Ok(())
    }

    fn contact(&self) -> Option<&dyn Contact> {
        Some(self)
    }
}

impl ClippedJoint {
    fn add_tangent(&self, weights: &[[f64; 2]; 2], out: &mut LocalMatrix) {
        let k = self.length * self.ends[0].stiffness;
        let [first, second] = &self.ends;
        // W_01 (r_0 r_1ᵀ + r_1 r_0ᵀ) by the square of the sum.
        let sum: Vec<(usize, f64)> = first.closing.iter().chain(&second.closing).copied().collect();
        add(out, k * (weights[0][0] - weights[0][1]), &first.closing);
        add(out, k * (weights[1][1] - weights[0][1]), &second.closing);
        add(out, k * weights[0][1], &sum);
    }
}

impl Contact for ClippedJoint {
    fn acts_at_end(&self) -> bool {
        true
    }

    fn switches(&self, motion: Motion<'_>, history: &[f64], see: &mut dyn FnMut(bool)) {
        self.pressing(motion.values, history)
            .iter()
            .for_each(|q| see(*q >= 0.0));
    }

    fn penetration(&self, motion: Motion<'_>) -> f64 {
        let closing = self.ends.iter().map(|end| dot(&end.closing, motion.values));
        closing.fold(0.0, f64::max)
    }
}

#[cfg(test)]
mod tests {
    use nalgebra::UnitQuaternion;

    use super::*;

    const K: f64 = 2e3;
    const LENGTH: f64 = 0.4;

    fn joint() -> ClippedJoint {
        let end = |closing: Vec<(usize, f64)>, relief: f64| JointPoint {
            closing,
            relief: vec![(4, relief)],
            stiffness: K,
        };
        let unknowns = [
            (0, Dof::Ux),
            (1, Dof::Ux),
            (2, Dof::Ux),
            (3, Dof::Ux),
            (4, Dof::Amplitude),
        ];
        let ends = [
            end(vec![(0, 1.0), (2, -1.0)], -30.0),
            end(vec![(1, 1.0), (3, -1.0)], 10.0),
        ];
        ClippedJoint::new(&unknowns, ends, LENGTH).unwrap()
    }

    fn answer(values: &[f64], old: &[f64]) -> (Response, Vec<f64>) {
        let mut out = Response::sized(5);
        let mut new = old.to_vec();
        let rotations = vec![UnitQuaternion::identity(); 5];
        let motion = Motion {
            values,
            rotations: &rotations,
        };
        joint().respond(motion, old, &mut new, Want::ALL, &mut out).unwrap();
        (out, new)
    }

    /// Closed, open, cut on either side: forces against a rule of 20000 middles of the pointwise law, tangents against differences.
    #[test]
    fn forces_and_tangents() {
        let old = [-6.0, 3.0];
        for [a, b] in [[0.02, 0.03], [-0.02, -0.01], [0.02, -0.015], [-0.01, 0.04]] {
            let values = [a, b, 0.001, -0.002, 0.2];
            let (out, new) = answer(&values, &old);
            assert_eq!(new, vec![-30.0 * 0.2, 10.0 * 0.2]);
            let e = [values[0] - values[2], values[1] - values[3]];
            let mut exact = [0.0; 2];
            let n = 20_000;
            for i in 0..n {
                let t = (f64::from(i) + 0.5) / f64::from(n);
                let at = |x: [f64; 2]| (1.0 - t) * x[0] + t * x[1];
                let (closing, relief) = (at(e), at(old));
                let density = if K * closing + relief >= 0.0 {
                    K * closing
                } else {
                    -relief
                };
                for (sum, shape) in exact.iter_mut().zip([1.0 - t, t]) {
                    *sum += density * shape * LENGTH / f64::from(n);
                }
            }
            for (k, exact) in exact.into_iter().enumerate() {
                // The rule leaves 1e-8 of the force at the cut.
                assert!((out.force[k] - exact).abs() < 1e-6, "{a} {b}: {} {exact}", out.force[k]);
                assert_eq!(out.force[k], -out.force[2 + k]);
                assert_eq!(joint().look(&values, &old)[k].force, out.force[k]);
            }
            let h = 1e-7;
            for j in 0..5 {
                let mut moved = [values, values];
                moved[0][j] += h;
                moved[1][j] -= h;
                let [up, down] = moved.map(|v| answer(&v, &old).0.force);
                for i in 0..5 {
                    let slope = (up[i] - down[i]) / (2.0 * h);
                    assert!((slope - out.tangent.get(i, j)).abs() < 1e-4, "{i} {j}");
                }
            }
        }
    }

    #[test]
    fn bad_parameters_are_rejected() {
        let end = |stiffness| JointPoint {
            closing: vec![(0, 1.0)],
            relief: Vec::new(),
            stiffness,
        };
        let over = |ends, length| ClippedJoint::new(&[(0, Dof::Ux)], ends, length);
        assert!(over([end(1.0), end(1.0)], 1.0).is_ok());
        assert!(over([end(1.0), end(2.0)], 1.0).is_err());
        assert!(over([end(0.0), end(0.0)], 1.0).is_err());
        assert!(over([end(1.0), end(1.0)], 0.0).is_err());
    }
}
