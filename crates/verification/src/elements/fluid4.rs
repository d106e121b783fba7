//! `fluid4`: liquid in displacements, bilinear quadrilateral in a vertical plane.
//!
//! The two-dimensional form of [`fem::element::Fluid8`]. Cartesian chart: plane motion in (x, z), thickness t. Cylindrical
//! chart: axisymmetric motion in (r, z) without swirl, a sector of the given angle,
//!
//! ```text
//! e = u_r,r + u_r/r + u_z,z        ω_rz = ½ (u_r,z − u_z,r)        √g = r
//! ```
//!
//! Unknowns u_x and u_z; its nodes must not have frames. Axis nodes: hold u_x. Numbering: [`fem::shape::quad4`] with
//! r towards x and s towards z. Source: Wilson & Khalvati 1983; dissertation, chapter 5 (eqs. (5.60) to (5.62)).

use fem::chart::Chart;
use fem::dofs::Dof;
use fem::element::{
    Element, ElementError, Inspect, LiquidProperties, LocalMatrix, Response, Sample, Trial, VolumePart,
};
use fem::mesh::Face;
use fem::shape::{gauss, quad4};

const KIND: &str = "fluid4";

/// An integration point.
struct Point {
    n: [f64; 4],
    /// N,₁ and N,₃.
    d: [[f64; 4]; 2],
    /// x¹ and x³.
    x: [f64; 2],
    /// Weight · det J · √g · breadth [m³].
    volume: f64,
}

/// Plane or axisymmetric liquid in displacements.
#[derive(Clone, Debug)]
pub struct Fluid4 {
    nodes: [usize; 4],
    /// x¹ and x³ of the corners.
    corners: [[f64; 2]; 4],
    chart: Chart,
    breadth: f64,
    liquid: LiquidProperties,
}

impl Fluid4 {
    /// An element on the corners of `face`, whose second chart coordinate is not read.
    ///
    /// * `breadth`: thickness [m], or the angle of the sector [rad] in the cylindrical chart
    ///
    /// Errors: Jacobian determinant not positive at an integration point; breadth, density or bulk modulus not positive;
    /// negative penalty.
    pub fn new(face: &Face, chart: Chart, breadth: f64, liquid: LiquidProperties) -> Result<Fluid4, ElementError> {
        liquid.check(KIND)?;
        if !(breadth > 0.0 && breadth.is_finite()) {
            return Err(ElementError::Parameter {
                kind: KIND,
                parameter: "breadth",
                found: breadth.to_string(),
                allowed: "a positive number",
            });
        }
        let element = Fluid4 { nodes: face.nodes, corners: face.chart.map(|c| [c[0], c[2]]), chart, breadth, liquid };
        for p in element.full().iter().chain([&element.centre()]) {
            if !(p.volume > 0.0 && p.volume.is_finite()) {
                return Err(ElementError::Jacobian {
                    kind: KIND,
                    determinant: p.volume / breadth,
                    nodes: face.nodes.to_vec(),
                });
            }
        }
        Ok(element)
    }

    /// Volume, by full quadrature [m³].
    pub fn volume(&self) -> f64 {
        self.full().iter().map(|p| p.volume).sum()
    }

    fn point(&self, r: f64, s: f64, weight: f64) -> Point {
        let (n, slope) = (quad4::value(r, s), quad4::slope(r, s));
        let (mut x, mut j) = ([0.0; 2], [[0.0; 2]; 2]);
        for a in 0..4 {
            for i in 0..2 {
                x[i] += n[a] * self.corners[a][i];
                for k in 0..2 {
                    j[k][i] += slope[a][k] * self.corners[a][i];
                }
            }
        }
        let det = j[0][0] * j[1][1] - j[0][1] * j[1][0];
        Point {
            n,
            d: [
                slope.map(|d| (j[1][1] * d[0] - j[0][1] * d[1]) / det),
                slope.map(|d| (j[0][0] * d[1] - j[1][0] * d[0]) / det),
            ],
            x,
            volume: weight * det * self.breadth * self.chart.volume_factor([x[0], 0.0, x[1]]),
        }
    }

    fn full(&self) -> [Point; 4] {
        std::array::from_fn(|q| {
            let ((r, wr), (s, ws)) = (gauss::TWO[q & 1], gauss::TWO[q >> 1]);
            self.point(r, s, wr * ws)
        })
    }

    fn centre(&self) -> Point {
        self.point(0.0, 0.0, 4.0)
    }

    /// Row of e over the local dofs.
    fn dilatation(&self, p: &Point) -> [f64; 8] {
        let hoop = match self.chart {
            Chart::Cartesian => 0.0,
            Chart::Cylindrical => 1.0 / p.x[0],
        };
        std::array::from_fn(|k| match k % 2 {
            0 => p.d[0][k / 2] + hoop * p.n[k / 2],
            _ => p.d[1][k / 2],
        })
    }

    /// Row of (1/V) ∫ e dV, and V.
    fn mean_dilatation(&self) -> ([f64; 8], f64) {
        let (mut row, mut volume) = ([0.0; 8], 0.0);
        for p in self.full() {
            volume += p.volume;
            for (sum, e) in row.iter_mut().zip(self.dilatation(&p)) {
                *sum += p.volume * e;
            }
        }
        (row.map(|v| v / volume), volume)
    }

    /// Row of ω₁₃ = ½ (u₁,₃ − u₃,₁).
    fn rotation(p: &Point) -> [f64; 8] {
        std::array::from_fn(|k| match k % 2 {
            0 => 0.5 * p.d[1][k / 2],
            _ => -0.5 * p.d[0][k / 2],
        })
    }

    /// Row of ω₁₃ at the centre over the local dofs.
    pub fn rotation_row(&self) -> [f64; 8] {
        Fluid4::rotation(&self.centre())
    }

    fn stiffness(&self) -> [[f64; 8]; 8] {
        let mut out = [[0.0; 8]; 8];
        let mut add = |row: [f64; 8], weight: f64| {
            for a in 0..8 {
                for b in 0..8 {
                    out[a][b] += weight * row[a] * row[b];
                }
            }
        };
        // ω_ij ω^ij counts 13 and 31.
        let (full, one) = self.liquid.rotation.penalties();
        let (points, centre) = (self.full(), self.centre());
        for p in &points {
            add(Fluid4::rotation(p), 2.0 * full * p.volume);
        }
        add(Fluid4::rotation(&centre), 2.0 * one * centre.volume);
        let k = self.liquid.bulk_modulus;
        match self.liquid.volume {
            VolumePart::Full => points.iter().for_each(|p| add(self.dilatation(p), k * p.volume)),
            VolumePart::OnePoint => add(self.dilatation(&centre), k * centre.volume),
            VolumePart::MeanDilatation => {
                let (row, volume) = self.mean_dilatation();
                add(row, k * volume);
            }
        }
        out
    }
}

impl Element for Fluid4 {
    fem::answers!(KIND, nodes, &[Dof::Ux, Dof::Uz]; inspect);

    fn mass(&self, out: &mut LocalMatrix) {
        for p in self.full() {
            for a in 0..4 {
                for b in 0..4 {
                    let m = self.liquid.density * p.volume * p.n[a] * p.n[b];
                    out.add(2 * a, 2 * b, m);
                    out.add(2 * a + 1, 2 * b + 1, m);
                }
            }
        }
    }

    fn respond(&self, Trial { motion, want, .. }: Trial<'_>, out: &mut Response) -> Result<(), ElementError> {
        for (a, row) in self.stiffness().iter().enumerate() {
            for (b, &k) in row.iter().enumerate() {
                if want.force {
                    out.force[a] += k * motion.values[b];
                }
                if want.tangent {
                    out.tangent.add(a, b, k);
                }
            }
        }
        Ok(())
    }

    /// With the quadrature of the volume part. In the cylindrical chart a horizontal acceleration has no axisymmetric
    /// part and gives no load.
    fn body_force(&self, acceleration: [f64; 3], out: &mut [f64]) {
        let add = |p: &Point, out: &mut [f64]| {
            for a in 0..4 {
                let m = self.liquid.density * p.volume * p.n[a];
                if self.chart == Chart::Cartesian {
                    out[2 * a] += m * acceleration[0];
                }
                out[2 * a + 1] += m * acceleration[2];
            }
        };
        match self.liquid.volume {
            VolumePart::OnePoint => add(&self.centre(), out),
            VolumePart::Full | VolumePart::MeanDilatation => self.full().iter().for_each(|p| add(p, out)),
        }
    }
}

impl Inspect for Fluid4 {
    /// The pressure −K e, positive in compression, of the element's centre (in the cylindrical chart at θ = 0). Not a
    /// wall pressure.
    fn samples(&self) -> Vec<Sample> {
        let row = match self.liquid.volume {
            VolumePart::MeanDilatation => self.mean_dilatation().0,
            VolumePart::Full | VolumePart::OnePoint => self.dilatation(&self.centre()),
        };
        let [x, z] = self.centre().x;
        vec![Sample {
            name: "pressure",
            position: [x, 0.0, z],
            row: row.map(|v| -self.liquid.bulk_modulus * v).to_vec(),
            of_acceleration: false,
        }]
    }
}

#[cfg(test)]
mod tests;
