//! Strains of the shell, their first and second derivatives, and the pull-back of directors to rotations.

use nalgebra::Vector3;

use super::place::{Configuration, EDGES, Values};
use super::rows::{Row, SIZE, put};
use super::{MembraneShear, Shell4};
use crate::element::shell::director::{add_turn_block, turned};
use crate::element::shell::geometry::{Point, blend};
use crate::element::{LocalMatrix, Motion};

/// Rows of membrane shear and edge shears, common to all points.
pub(super) struct Common {
    shear: Option<Row>,
    edges: [Row; 4],
}

/// Weighted resultants that multiply the constant second derivatives of the strains.
#[derive(Clone, Default)]
pub(super) struct Stressed {
    /// Coefficients of x_a · x_b.
    pub(super) xx: [[f64; 4]; 4],
    /// Coefficients of x_a · d_b.
    pub(super) xd: [[f64; 4]; 4],
}

impl Shell4 {
    pub(super) fn configuration(&self, motion: &Motion<'_>) -> Configuration {
        let u: [Vector3<f64>; 4] =
            std::array::from_fn(|a| Vector3::from_column_slice(&motion.values[6 * a..6 * a + 3]));
        let w: [Vector3<f64>; 4] = std::array::from_fn(|a| turned(&motion.rotations[a], &self.directors[a]));
        Configuration {
            x: std::array::from_fn(|a| self.x[a] + u[a]),
            d: std::array::from_fn(|a| self.directors[a] + w[a]),
            u,
            w,
        }
    }

    pub(super) fn reference(&self) -> Configuration {
        Configuration { x: self.x, u: [Vector3::zeros(); 4], d: self.directors, w: [Vector3::zeros(); 4] }
    }

    /// Row of 2ε_12 at a point.
    fn membrane_shear_row(p: &Point, c: &Configuration) -> Row {
        let (x1, x2) = (blend(&p.d1, &c.x), blend(&p.d2, &c.x));
        let mut row = [0.0; SIZE];
        for a in 0..4 {
            put(&mut row, 6 * a, x2 * p.d1[a] + x1 * p.d2[a]);
        }
        row
    }

    /// 2ε_12 at a point.
    #[inline(always)]
    fn membrane_shear(&self, p: &Point, c: &Configuration) -> f64 {
        let (u1, u2) = (blend(&p.d1, &c.u), blend(&p.d2, &c.u));
        let (g1, g2) = (blend(&p.d1, &self.x), blend(&p.d2, &self.x));
        g1.dot(&u2) + g2.dot(&u1) + u1.dot(&u2)
    }

    /// Strains that are common to all points.
    #[inline(always)]
    pub(super) fn values(&self, c: &Configuration) -> Values {
        Values {
            shear: match self.membrane_shear {
                MembraneShear::CentrePoint => Some(self.membrane_shear(&self.centre, c)),
                MembraneShear::Full => None,
            },
            edges: EDGES.map(|(a, b)| {
                let stretch = (c.u[b] - c.u[a]) * 0.25;
                let turn = c.w[a] + c.w[b];
                stretch.dot(&(self.directors[a] + self.directors[b] + turn)) + (self.x[b] - self.x[a]).dot(&turn) * 0.25
            }),
        }
    }

    pub(super) fn common(&self, c: &Configuration) -> Common {
        let edges = EDGES.map(|(a, b)| {
            // At the middle of the edge: x,α = ½ (x_b − x_a), d = ½ (d_a + d_b).
            let along = (c.x[b] - c.x[a]) * 0.25;
            let director = (c.d[a] + c.d[b]) * 0.25;
            let mut row = [0.0; SIZE];
            put(&mut row, 6 * a, -director);
            put(&mut row, 6 * b, director);
            put(&mut row, 6 * a + 3, c.d[a].cross(&along));
            put(&mut row, 6 * b + 3, c.d[b].cross(&along));
            row
        });
        Common {
            shear: match self.membrane_shear {
                MembraneShear::CentrePoint => Some(Self::membrane_shear_row(&self.centre, c)),
                MembraneShear::Full => None,
            },
            edges,
        }
    }

    /// Rows of the strains at a point.
    pub(super) fn rows(p: &Point, c: &Configuration, common: &Common) -> [Row; 8] {
        let (x1, x2) = (blend(&p.d1, &c.x), blend(&p.d2, &c.x));
        let (d1, d2) = (blend(&p.d1, &c.d), blend(&p.d2, &c.d));
        let mut rows = [[0.0; SIZE]; 8];
        for a in 0..4 {
            let (n1, n2, k) = (p.d1[a], p.d2[a], 6 * a);
            put(&mut rows[0], k, x1 * n1);
            put(&mut rows[1], k, x2 * n2);
            put(&mut rows[3], k, d1 * n1);
            put(&mut rows[4], k, d2 * n2);
            put(&mut rows[5], k, d2 * n1 + d1 * n2);
            let t1 = c.d[a].cross(&x1);
            let t2 = c.d[a].cross(&x2);
            put(&mut rows[3], k + 3, t1 * n1);
            put(&mut rows[4], k + 3, t2 * n2);
            put(&mut rows[5], k + 3, t2 * n1 + t1 * n2);
        }
        rows[2] = common.shear.unwrap_or_else(|| Self::membrane_shear_row(p, c));
        for (i, tying) in super::place::tying(p).iter().enumerate() {
            for (&factor, row) in tying.iter().zip(&common.edges) {
                for (to, from) in rows[6 + i].iter_mut().zip(row) {
                    *to += factor * from;
                }
            }
        }
        rows
    }

    /// Strains at a point.
    pub(super) fn strain(&self, p: &Point, c: &Configuration, common: &Values) -> [f64; 8] {
        let (d1, d2) = (blend(&p.d1, &c.d), blend(&p.d2, &c.d));
        let (u1, u2) = (blend(&p.d1, &c.u), blend(&p.d2, &c.u));
        let (w1, w2) = (blend(&p.d1, &c.w), blend(&p.d2, &c.w));
        let (g1, g2) = (blend(&p.d1, &self.x), blend(&p.d2, &self.x));
        let mut strain = [
            g1.dot(&u1) + 0.5 * u1.dot(&u1),
            g2.dot(&u2) + 0.5 * u2.dot(&u2),
            common.shear.unwrap_or_else(|| self.membrane_shear(p, c)),
            u1.dot(&d1) + g1.dot(&w1),
            u2.dot(&d2) + g2.dot(&w2),
            u1.dot(&d2) + g1.dot(&w2) + u2.dot(&d1) + g2.dot(&w1),
            0.0,
            0.0,
        ];
        for (i, tying) in super::place::tying(p).iter().enumerate() {
            for (&factor, value) in tying.iter().zip(&common.edges) {
                strain[6 + i] += factor * value;
            }
        }
        strain
    }

    /// Adds the weighted resultants of one point.
    pub(super) fn stress(&self, p: &Point, resultants: &[f64; 8], out: &mut Stressed) {
        let [n11, n22, n12, m11, m22, m12, q1, q2] = resultants.map(|v| v * p.area);
        let twist = match self.membrane_shear {
            MembraneShear::CentrePoint => &self.centre,
            MembraneShear::Full => p,
        };
        for a in 0..4 {
            for b in 0..4 {
                let (aa, bb) = (p.d1[a] * p.d1[b], p.d2[a] * p.d2[b]);
                out.xx[a][b] += n11 * aa + n22 * bb + n12 * (twist.d1[a] * twist.d2[b] + twist.d2[a] * twist.d1[b]);
                out.xd[a][b] += m11 * aa + m22 * bb + m12 * (p.d1[a] * p.d2[b] + p.d2[a] * p.d1[b]);
            }
        }
        let tying = super::place::tying(p);
        for (e, &(a, b)) in EDGES.iter().enumerate() {
            let q = 0.25 * (q1 * tying[0][e] + q2 * tying[1][e]);
            for n in [a, b] {
                out.xd[b][n] += q;
                out.xd[a][n] -= q;
            }
        }
    }

    /// Adds the geometric stiffness: second derivatives of the strains, and the diagonal blocks of the directors.
    ///
    /// The director's force follows from the same coefficients: f_d,b = Σ_a xd_ab x_a, because bending and transverse
    /// shear strains are bilinear in x and d.
    pub(super) fn add_geometric(&self, c: &Configuration, stressed: &Stressed, out: &mut LocalMatrix) {
        for b in 0..4 {
            let f = (0..4).fold(Vector3::zeros(), |sum, a| sum + c.x[a] * stressed.xd[a][b]);
            add_turn_block(out, b, &f, &c.d[b]);
            let p = -c.d[b].cross_matrix();
            for a in 0..4 {
                for i in 0..3 {
                    out.add(6 * a + i, 6 * b + i, stressed.xx[a][b]);
                    for j in 0..3 {
                        out.add_symmetric(6 * a + i, 6 * b + 3 + j, stressed.xd[a][b] * p[(i, j)]);
                    }
                }
            }
        }
    }
}
