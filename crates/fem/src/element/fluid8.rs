//! `fluid8`: liquid in displacements, trilinear hexahedron.
//!
//! The covariant components u_i of the chart are interpolated, u_i = Σ N_a û_i^a, with û_i^a = base_i(x_a) · U_a of the
//! global Cartesian displacement U_a at each corner. In the cylindrical chart
//!
//! ```text
//! û₁ = u_r        û₂ = r u_θ        û₃ = u_z
//! e = u₁,₁ + u₂,₂/r² + u₁/r + u₃,₃        (Γʳ_θθ = −r)
//! ½ K_rot ω_ij ω^ij = ¼ K_rot [ (u₁,₂ − u₂,₁)²/r² + (u₁,₃ − u₃,₁)² + (u₂,₃ − u₃,₂)²/r² ]
//! ½ ρ u̇² = ½ ρ (u̇₁² + u̇₂²/r² + u̇₃²)
//! ```
//!
//! A corner on the axis has its own θ: û₁ = u_x cos θ + u_y sin θ, while û₂ = 0, so the nodes of a level on the axis can
//! be one node with three Cartesian unknowns. A rigid horizontal translation is free of strain to O(Δθ²/12) only.
//!
//! Numbering: [`crate::shape::hex8`]. Source: dissertation, chapter 5 and appendix C; Flanagan & Belytschko 1981 (mean
//! dilatation). Checked by `crates/verification/src/fluid/`.

use std::sync::LazyLock;

use nalgebra::Vector3;

use super::fluid::{LiquidProperties, VolumePart};
use super::{Element, ElementError, Inspect, LocalMatrix, Response, Sample, Trial};
use crate::chart::Chart;
use crate::dofs::Dof;
use crate::mesh::Hexahedron;
use crate::shape::{gauss, hex8};

const KIND: &str = "fluid8";

/// Shape functions at a point of the reference cube: values, derivatives by direction, weight.
struct Reference {
    n: [f64; 8],
    d: [[f64; 8]; 3],
    weight: f64,
}

impl Reference {
    fn at(r: f64, s: f64, t: f64, weight: f64) -> Reference {
        let slope = hex8::slope(r, s, t);
        Reference { n: hex8::value(r, s, t), d: std::array::from_fn(|k| slope.map(|row| row[k])), weight }
    }
}

/// The eight points of full quadrature.
static FULL: LazyLock<[Reference; 8]> = LazyLock::new(|| {
    std::array::from_fn(|q| {
        let ((r, wr), (s, ws), (t, wt)) = (gauss::TWO[q & 1], gauss::TWO[(q >> 1) & 1], gauss::TWO[(q >> 2) & 1]);
        Reference::at(r, s, t, wr * ws * wt)
    })
});

/// The centre, for one-point quadrature.
static CENTRE: LazyLock<[Reference; 1]> = LazyLock::new(|| [Reference::at(0.0, 0.0, 0.0, 8.0)]);

/// An integration point.
struct Point {
    /// N.
    n: [f64; 8],
    /// N,₁ N,₂ N,₃: derivatives by the chart coordinates.
    d: [[f64; 8]; 3],
    /// Chart coordinates.
    x: [f64; 3],
    /// g¹¹, g²², g³³.
    metric: [f64; 3],
    /// Weight · det J · √g [m³].
    volume: f64,
}

/// Liquid in displacements.
#[derive(Clone, Debug)]
pub struct Fluid8 {
    nodes: [usize; 8],
    /// Chart coordinates of the corners, by coordinate.
    corners: [[f64; 8]; 3],
    /// Covariant base vectors of the corners, û_i^a = turn[i][j][a] U_j^a. All charts keep x³ = z, so only i, j < 2 are
    /// kept.
    turn: [[[f64; 8]; 2]; 2],
    chart: Chart,
    liquid: LiquidProperties,
}

/// Upper half of a symmetric matrix of the covariant components: K = B + Bᵀ, where block (i, k) couples û_i^a (row a)
/// and û_k^b. Order of the blocks: 11, 22, 33, 12, 13, 23; a diagonal block holds half of its part of K.
type Half = [[[f64; 8]; 8]; 6];

impl Fluid8 {
    /// An element on the corners of `cell`.
    ///
    /// Errors: Jacobian determinant not positive at an integration point (the cell is inside out, flat, or has a negative
    /// radius), density or bulk modulus not positive, negative penalty.
    pub fn new(cell: &Hexahedron, chart: Chart, liquid: LiquidProperties) -> Result<Fluid8, ElementError> {
        liquid.check(KIND)?;
        let bases = cell.chart.map(|x| chart.covariant_base(x));
        let element = Fluid8 {
            nodes: cell.nodes,
            corners: std::array::from_fn(|i| cell.chart.map(|x| x[i])),
            turn: std::array::from_fn(|i| std::array::from_fn(|j| std::array::from_fn(|a| bases[a][(i, j)]))),
            chart,
            liquid,
        };
        for reference in FULL.iter().chain(CENTRE.iter()) {
            let volume = element.point(reference).volume;
            if !(volume > 0.0 && volume.is_finite()) {
                return Err(ElementError::Jacobian {
                    kind: KIND,
                    determinant: volume / reference.weight,
                    nodes: cell.nodes.to_vec(),
                });
            }
        }
        Ok(element)
    }

    /// Its liquid.
    pub fn liquid(&self) -> &LiquidProperties {
        &self.liquid
    }

    /// Volume, by full quadrature [m³].
    pub fn volume(&self) -> f64 {
        FULL.iter().map(|q| self.point(q).volume).sum()
    }

    /// Place, inverse metric, weight · det J · √g and the cofactors C[k][i]/det J = ∂ξᵏ/∂xⁱ of a point.
    #[inline]
    fn place(&self, reference: &Reference) -> ([f64; 3], [f64; 3], f64, [[f64; 3]; 3]) {
        // J[k][i] = ∂xⁱ/∂ξᵏ
        let x = std::array::from_fn(|i| dot(&reference.n, &self.corners[i]));
        let j: [[f64; 3]; 3] = std::array::from_fn(|k| std::array::from_fn(|i| dot(&reference.d[k], &self.corners[i])));
        let cofactor = |k: usize, i: usize| {
            let (k1, k2, i1, i2) = ((k + 1) % 3, (k + 2) % 3, (i + 1) % 3, (i + 2) % 3);
            j[k1][i1] * j[k2][i2] - j[k1][i2] * j[k2][i1]
        };
        let c: [[f64; 3]; 3] = std::array::from_fn(|k| std::array::from_fn(|i| cofactor(k, i)));
        let det = j[0][0] * c[0][0] + j[0][1] * c[0][1] + j[0][2] * c[0][2];
        let inverse = 1.0 / det;
        let volume = reference.weight * det * self.chart.volume_factor(x);
        (x, self.chart.inverse_metric(x), volume, c.map(|row| row.map(|v| inverse * v)))
    }

    fn point(&self, reference: &Reference) -> Point {
        let (x, metric, volume, f) = self.place(reference);
        let d = std::array::from_fn(|i| {
            std::array::from_fn(|a| {
                f[0][i] * reference.d[0][a] + f[1][i] * reference.d[1][a] + f[2][i] * reference.d[2][a]
            })
        });
        Point { n: reference.n, d, x, metric, volume }
    }

    /// Row of e over the covariant components: g^ii N,_i − N g^jj Γⁱ_jj.
    fn dilatation(&self, p: &Point) -> [[f64; 8]; 3] {
        let hoop = match self.chart {
            Chart::Cartesian => 0.0,
            Chart::Cylindrical => 1.0 / p.x[0],
        };
        [
            std::array::from_fn(|a| p.metric[0] * p.d[0][a] + hoop * p.n[a]),
            p.d[1].map(|d| p.metric[1] * d),
            p.d[2].map(|d| p.metric[2] * d),
        ]
    }

    /// (1/V) ∫ e dV as a row, and V.
    fn mean_dilatation(&self, points: &[Point; 8]) -> ([[f64; 8]; 3], f64) {
        let (mut row, mut volume) = ([[0.0; 8]; 3], 0.0);
        for p in points {
            volume += p.volume;
            let own = self.dilatation(p);
            for i in 0..3 {
                for a in 0..8 {
                    row[i][a] += p.volume * own[i][a];
                }
            }
        }
        (row.map(|r| r.map(|v| v / volume)), volume)
    }

    /// Turns a row over covariant components into one over the local dofs.
    fn to_cartesian(&self, row: &[[f64; 8]; 3]) -> [f64; 24] {
        let t = &self.turn;
        std::array::from_fn(|c| match (c / 3, c % 3) {
            (a, 2) => row[2][a],
            (a, j) => row[0][a] * t[0][j][a] + row[1][a] * t[1][j][a],
        })
    }

    /// K + R, column by column.
    fn stiffness(&self, out: &mut [f64]) {
        let mut half = [[[0.0; 8]; 8]; 6];
        let points: [Point; 8] = std::array::from_fn(|q| self.point(&FULL[q]));
        let centre = self.point(&CENTRE[0]);
        let (full, one) = self.liquid.rotation.penalties();
        if full != 0.0 {
            add_rotation(&mut half, &points, full);
        }
        if one != 0.0 {
            add_rotation(&mut half, std::array::from_ref(&centre), one);
        }
        let k = self.liquid.bulk_modulus;
        match self.liquid.volume {
            VolumePart::Full => {
                for p in &points {
                    add_square(&mut half, &self.dilatation(p), k * p.volume);
                }
            }
            VolumePart::OnePoint => add_square(&mut half, &self.dilatation(&centre), k * centre.volume),
            VolumePart::MeanDilatation => {
                let (row, volume) = self.mean_dilatation(&points);
                add_square(&mut half, &row, k * volume);
            }
        }
        self.write(&half, out);
    }

    /// Turns half a matrix into Cartesian components and writes the whole, column by column.
    fn write(&self, half: &Half, out: &mut [f64]) {
        let (columns, _) = out.as_chunks_mut::<24>();
        let [[t00, t01], [t10, t11]] = &self.turn;
        let [h00, h11, h22, h01, h02, h12] = half;
        for a in 0..8 {
            let (a00, a01, a10, a11) = (t00[a], t01[a], t10[a], t11[a]);
            // Rows 1 and 2 of the half times the base vectors of b, then those of a; all b at once.
            let mut rows = [[[0.0; 8]; 3]; 3];
            for b in 0..8 {
                let first = h00[a][b] * t00[b] + h01[a][b] * t10[b];
                let second = h11[a][b] * t10[b];
                rows[0][0][b] = a00 * first + a10 * second;
                rows[1][0][b] = a01 * first + a11 * second;
            }
            for b in 0..8 {
                let first = h00[a][b] * t01[b] + h01[a][b] * t11[b];
                let second = h11[a][b] * t11[b];
                rows[0][1][b] = a00 * first + a10 * second;
                rows[1][1][b] = a01 * first + a11 * second;
            }
            for b in 0..8 {
                rows[0][2][b] = a00 * h02[a][b] + a10 * h12[a][b];
                rows[1][2][b] = a01 * h02[a][b] + a11 * h12[a][b];
            }
            rows[2][2] = h22[a];
            for (i, row) in rows.iter().enumerate() {
                let column = &mut columns[3 * a + i];
                for b in 0..8 {
                    for k in 0..3 {
                        column[3 * b + k] = row[k][b];
                    }
                }
            }
        }
        for i in 0..24 {
            for j in 0..i {
                let sum = columns[i][j] + columns[j][i];
                columns[i][j] = sum;
                columns[j][i] = sum;
            }
            columns[i][i] *= 2.0;
        }
    }

    /// Row of the pressure −K e of the element (mean, or at the centre) over the local dofs.
    fn pressure_row(&self) -> [f64; 24] {
        let row = match self.liquid.volume {
            VolumePart::MeanDilatation => self.mean_dilatation(&std::array::from_fn(|q| self.point(&FULL[q]))).0,
            VolumePart::Full | VolumePart::OnePoint => self.dilatation(&self.point(&CENTRE[0])),
        };
        self.to_cartesian(&row).map(|v| -self.liquid.bulk_modulus * v)
    }

    /// Rows of ω₁₂, ω₁₃, ω₂₃ at the centre over the local dofs, in orthonormal components (ω_12/√(g₁₁ g₂₂), …).
    pub fn rotation_rows(&self) -> [[f64; 24]; 3] {
        let p = self.point(&CENTRE[0]);
        [(0, 1), (0, 2), (1, 2)].map(|(i, j)| {
            let scale = 0.5 * (p.metric[i] * p.metric[j]).sqrt();
            let mut row = [[0.0; 8]; 3];
            row[i] = p.d[j].map(|d| scale * d);
            row[j] = p.d[i].map(|d| -scale * d);
            self.to_cartesian(&row)
        })
    }
}

/// Scalar product.
fn dot(a: &[f64; 8], b: &[f64; 8]) -> f64 {
    let mut sum = [0.0; 4];
    for i in 0..4 {
        sum[i] = a[i] * b[i] + a[i + 4] * b[i + 4];
    }
    (sum[0] + sum[1]) + (sum[2] + sum[3])
}

/// Adds weight · rowᵀ row.
fn add_square(half: &mut Half, row: &[[f64; 8]; 3], weight: f64) {
    const PAIRS: [(usize, usize, f64); 6] =
        [(0, 0, 0.5), (1, 1, 0.5), (2, 2, 0.5), (0, 1, 1.0), (0, 2, 1.0), (1, 2, 1.0)];
    for (block, (i, k, part)) in half.iter_mut().zip(PAIRS) {
        for (own, value) in block.iter_mut().zip(&row[i]) {
            let f = part * weight * value;
            for b in 0..8 {
                own[b] += f * row[k][b];
            }
        }
    }
}

/// Adds the rotation part of some points: ½ K_rot Σ_{i<j} g^ii g^jj (u_i,j − u_j,i)² dV.
fn add_rotation<const N: usize>(half: &mut Half, points: &[Point; N], penalty: f64) {
    // ½ K_rot g^ii g^jj dV for 12, 13, 23.
    let weights: [[f64; 3]; N] = std::array::from_fn(|q| {
        let [g1, g2, g3] = points[q].metric;
        let w = 0.5 * penalty * points[q].volume;
        [w * g1 * g2, w * g1 * g3, w * g2 * g3]
    });
    let [h00, h11, h22, h01, h02, h12] = half;
    for a in 0..8 {
        // The sums of a row stay in registers, three blocks at a time.
        let (mut s00, mut s01, mut s02) = (h00[a], h01[a], h02[a]);
        for (p, [w12, w13, _]) in points.iter().zip(&weights) {
            let [d1, d2, d3] = &p.d;
            let (q12, q13) = (w12 * d2[a], w13 * d3[a]);
            let (r12, r13) = (0.5 * q12, 0.5 * q13);
            for b in 0..8 {
                s00[b] += r12 * d2[b] + r13 * d3[b];
                s01[b] -= q12 * d1[b];
                s02[b] -= q13 * d1[b];
            }
        }
        (h00[a], h01[a], h02[a]) = (s00, s01, s02);
        let (mut s11, mut s22, mut s12) = (h11[a], h22[a], h12[a]);
        for (p, [w12, w13, w23]) in points.iter().zip(&weights) {
            let [d1, d2, d3] = &p.d;
            let (r12, r13) = (0.5 * w12 * d1[a], 0.5 * w13 * d1[a]);
            let (q23, r23) = (w23 * d3[a], 0.5 * w23 * d2[a]);
            let half_q23 = 0.5 * q23;
            for b in 0..8 {
                s11[b] += r12 * d1[b] + half_q23 * d3[b];
                s22[b] += r13 * d1[b] + r23 * d2[b];
                s12[b] -= q23 * d2[b];
            }
        }
        (h11[a], h22[a], h12[a]) = (s11, s22, s12);
    }
}

impl Element for Fluid8 {
    crate::answers!(KIND, nodes, Dof::TRANSLATIONS; inspect);

    fn mass(&self, out: &mut LocalMatrix) {
        let mut half = [[[0.0; 8]; 8]; 6];
        for q in FULL.iter() {
            let (_, metric, volume, _) = self.place(q);
            // All charts have g¹¹ = g³³ = 1.
            let plain = 0.5 * self.liquid.density * volume;
            let around = plain * metric[1];
            for a in 0..8 {
                let (f, g) = (plain * q.n[a], around * q.n[a]);
                for b in 0..8 {
                    half[0][a][b] += f * q.n[b];
                    half[1][a][b] += g * q.n[b];
                }
            }
        }
        half[2] = half[0];
        self.write(&half, &mut out.data);
    }

    fn respond(&self, Trial { motion, want, .. }: Trial<'_>, out: &mut Response) -> Result<(), ElementError> {
        self.stiffness(&mut out.tangent.data);
        if want.force {
            for (column, &u) in out.tangent.data.chunks_exact(24).zip(motion.values) {
                for (f, k) in out.force.iter_mut().zip(column) {
                    *f += k * u;
                }
            }
        }
        Ok(())
    }

    /// With the quadrature of the volume part: a liquid without shear stiffness reacts to the least mismatch between nodal
    /// weight and nodal pressure force with free circulation.
    fn body_force(&self, acceleration: [f64; 3], out: &mut [f64]) {
        let points: &[Reference] = match self.liquid.volume {
            VolumePart::OnePoint => &*CENTRE,
            VolumePart::Full | VolumePart::MeanDilatation => &*FULL,
        };
        let mut force = [[0.0; 8]; 3];
        for q in points {
            let p = self.point(q);
            let covariant = self.chart.covariant_base(p.x) * Vector3::from(acceleration);
            for i in 0..3 {
                let f = self.liquid.density * p.volume * p.metric[i] * covariant[i];
                for a in 0..8 {
                    force[i][a] += f * p.n[a];
                }
            }
        }
        for (o, f) in out.iter_mut().zip(self.to_cartesian(&force)) {
            *o += f;
        }
    }
}

impl Inspect for Fluid8 {
    /// The pressure −K e, positive in compression, of the element's centre. Not a wall pressure.
    fn samples(&self) -> Vec<Sample> {
        vec![Sample {
            name: "pressure",
            position: self.chart.position(self.point(&CENTRE[0]).x),
            row: self.pressure_row().to_vec(),
            of_acceleration: false,
        }]
    }
}

#[cfg(test)]
mod tests;
