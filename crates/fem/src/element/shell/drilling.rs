//! Energy of the rotation about the normal, at the corners where shells meet at an angle.
//!
//! ```text
//! ψ_a = ½ (x,1 · t_2 − x,2 · t_1) at corner a ,   t_i = R_a e_i
//! energy ½ k_d G t A_a ψ_a² ,   A_a = ∫ N_a dA
//! ```
//!
//! e_i is the tangent frame of the element at that corner. ψ vanishes under every rigid motion, and tends to
//! ω_3 − ½ (v,1 − u,2) (Hughes & Brezzi 1989). It is taken corner by corner, not at Gauss points: only nodes with six
//! dofs enter, so that a neighbour whose rotation about its director is not an unknown is not affected.

use nalgebra::{UnitQuaternion, Vector3};

use super::director::{add_turn_block, turned};
use super::geometry::{Point, blend};
use crate::element::shell4::rows::SIZE;
use crate::element::{ElementError, Response, Want};
use crate::shape::quad4;

/// One corner with drilling energy.
#[derive(Clone, Debug)]
pub(crate) struct Corner {
    /// Local node.
    pub node: usize,
    d1: [f64; 4],
    d2: [f64; 4],
    e: [Vector3<f64>; 2],
    /// k_d G t A_a [N m].
    stiffness: f64,
}

impl Corner {
    pub(crate) fn new(
        x: &[Vector3<f64>; 4],
        node: usize,
        stiffness: f64,
        nodes: &[usize; 4],
    ) -> Result<Corner, ElementError> {
        let [r, s] = quad4::CORNERS[node];
        let point = Point::new(x, r, s, 1.0, nodes)?;
        Ok(Corner { node, d1: point.d1, d2: point.d2, e: [point.axis(0), point.axis(1)], stiffness })
    }

    /// Adds force and tangent; the pull-back of t_i is that of the director.
    pub(crate) fn respond(
        &self,
        u: &[Vector3<f64>; 4],
        rotation: &UnitQuaternion<f64>,
        want: Want,
        out: &mut Response,
    ) {
        let [e1, e2] = self.e;
        // x,i = e_i + u,i: the tangent frame is Cartesian, X,i = e_i.
        let (u1, u2) = (blend(&self.d1, u), blend(&self.d2, u));
        let (x1, x2) = (e1 + u1, e2 + u2);
        let (w1, w2) = (turned(rotation, &e1), turned(rotation, &e2));
        let (t1, t2) = (e1 + w1, e2 + w2);
        let psi = 0.5 * (u1.dot(&e2) - u2.dot(&e1) + x1.dot(&w2) - x2.dot(&w1));
        let mut row = [0.0; SIZE];
        let (f1, f2) = (x2 * -0.5, x1 * 0.5);
        let turn = t1.cross(&f1) + t2.cross(&f2);
        for a in 0..4 {
            for i in 0..3 {
                row[6 * a + i] = 0.5 * (self.d1[a] * t2[i] - self.d2[a] * t1[i]);
            }
        }
        let at = 6 * self.node + 3;
        for i in 0..3 {
            row[at + i] = turn[i];
        }
        let moment = self.stiffness * psi;
        if want.force {
            for (f, b) in out.force.iter_mut().zip(&row) {
                *f += moment * b;
            }
        }
        if want.tangent {
            for (j, column) in out.tangent.data.chunks_exact_mut(SIZE).enumerate() {
                let f = self.stiffness * row[j];
                for (k, b) in column.iter_mut().zip(&row) {
                    *k += f * b;
                }
            }
            if moment != 0.0 {
                let (p1, p2) = (-t1.cross_matrix(), -t2.cross_matrix());
                for a in 0..4 {
                    let (g1, g2) = (0.5 * moment * self.d1[a], 0.5 * moment * self.d2[a]);
                    for i in 0..3 {
                        for j in 0..3 {
                            let value = g1 * p2[(i, j)] - g2 * p1[(i, j)];
                            out.tangent.add_symmetric(6 * a + i, at + j, value);
                        }
                    }
                }
                add_turn_block(&mut out.tangent, self.node, &(f1 * moment), &t1);
                add_turn_block(&mut out.tangent, self.node, &(f2 * moment), &t2);
            }
        }
    }
}
