//! `potential8`: incompressible, inviscid liquid by its displacement potential on a trilinear hexahedron.
//!
//! ```text
//! u = ∇φ,  Δφ = 0,  p' = −ρ φ̈            H_ab = ∫ g^ii N_a,i N_b,i √g dV            mass block −ρ H
//! ```
//!
//! One unknown a node, [`Dof::Phi`]. Together with [`super::PotentialSurface`] (S) and [`super::WetFace`] (B) the
//! assembled matrices are
//!
//! ```text
//!      ⎡ M_s   0    ρBᵀ ⎤           ⎡ K_s   0    0 ⎤
//! M3 = ⎢ 0     0    ρS  ⎥      K3 = ⎢ 0    ρgS   0 ⎥      x = (u, η, φ)
//!      ⎣ ρB    ρS  −ρH  ⎦           ⎣ 0     0    0 ⎦
//! ```
//!
//! The rows of φ are H φ = B u + S η: the liquid's boundary moves with wall and surface. Where no face is added the
//! boundary is rigid and at rest. Coordinates are those of the element's chart, integrated with 2 × 2 × 2 points: in the
//! cylindrical chart volumes are exact, the wedge at the axis is a hexahedron whose inner corners share a node, and 1/r
//! is taken at integration points only.
//!
//! A constant φ is a null vector of H, not of M3 or of K3 + M3/(β Δt²): see `docs/theory/potential-elements.md`, 3.
//!
//! Source: Morand & Ohayon 1995, chapter 5. Limits: small motion about rest, incompressible.

use nalgebra::Matrix3;

use super::{Element, ElementError, Inspect, LocalMatrix, Response, Sample, Trial, positive, require};
use crate::chart::Chart;
use crate::dofs::Dof;
use crate::mesh::Hexahedron;
use crate::shape::{gauss, hex8};

const KIND: &str = "potential8";

/// Trilinear potential element.
#[derive(Clone, Debug, PartialEq)]
pub struct Potential8 {
    cell: Hexahedron,
    chart: Chart,
    density: f64,
}

/// Gradients at an integration point: orthonormal components (a, i), and the volume that belongs to the point.
type Gradients = ([[f64; 3]; 8], f64);

impl Potential8 {
    /// An element of a liquid of density ρ [kg/m³].
    ///
    /// Errors: a Jacobian or a density that is not positive.
    pub fn new(cell: &Hexahedron, chart: Chart, density: f64) -> Result<Potential8, ElementError> {
        require(positive(density), KIND, "density", density, "a positive number")?;
        let element = Potential8 { cell: *cell, chart, density };
        element.integrate(|_| {})?;
        Ok(element)
    }

    /// Density ρ [kg/m³].
    pub fn density(&self) -> f64 {
        self.density
    }

    /// Volume [m³].
    pub fn volume(&self) -> f64 {
        let mut volume = 0.0;
        self.integrate(|(_, dv)| volume += dv).expect("checked by `new`");
        volume
    }

    /// Visits the integration points.
    fn integrate(&self, mut visit: impl FnMut(Gradients)) -> Result<(), ElementError> {
        for &(t, wt) in gauss::TWO {
            for &(s, ws) in gauss::TWO {
                for &(r, wr) in gauss::TWO {
                    let (n, d) = (hex8::value(r, s, t), hex8::slope(r, s, t));
                    let mut x = [0.0; 3];
                    let mut jacobian = Matrix3::zeros();
                    for a in 0..8 {
                        for i in 0..3 {
                            x[i] += n[a] * self.cell.chart[a][i];
                            for k in 0..3 {
                                jacobian[(k, i)] += d[a][k] * self.cell.chart[a][i];
                            }
                        }
                    }
                    let determinant = jacobian.determinant();
                    let volume = determinant * self.chart.volume_factor(x);
                    let inverse = jacobian.try_inverse().filter(|_| volume > 0.0);
                    let Some(inverse) = inverse else {
                        return Err(ElementError::Jacobian {
                            kind: KIND,
                            determinant,
                            nodes: self.cell.nodes.to_vec(),
                        });
                    };
                    let scale = self.chart.inverse_metric(x).map(f64::sqrt);
                    let gradient = |a: usize| {
                        std::array::from_fn(|i| {
                            scale[i]
                                * (inverse[(i, 0)] * d[a][0] + inverse[(i, 1)] * d[a][1] + inverse[(i, 2)] * d[a][2])
                        })
                    };
                    visit((std::array::from_fn(gradient), volume * wr * ws * wt));
                }
            }
        }
        Ok(())
    }
}

impl Element for Potential8 {
    crate::answers!(KIND, cell.nodes, &[Dof::Phi]; linear inspect);

    fn mass(&self, out: &mut LocalMatrix) {
        self.integrate(|(gradient, volume)| {
            let factor = -self.density * volume;
            for (j, gj) in gradient.iter().enumerate() {
                let scaled = gj.map(|g| factor * g);
                for (i, gi) in gradient.iter().enumerate() {
                    out.data[i + 8 * j] += gi[0] * scaled[0] + gi[1] * scaled[1] + gi[2] * scaled[2];
                }
            }
        })
        .expect("checked by `new`");
    }

    fn respond(&self, _: Trial<'_>, _out: &mut Response) -> Result<(), ElementError> {
        Ok(())
    }
}

impl Inspect for Potential8 {
    /// Pressure p' = −ρ φ̈ at the centre.
    fn samples(&self) -> Vec<Sample> {
        let mut centre = [0.0; 3];
        for corner in &self.cell.chart {
            for (x, c) in centre.iter_mut().zip(corner) {
                *x += 0.125 * c;
            }
        }
        vec![Sample {
            name: "pressure",
            position: self.chart.position(centre),
            row: vec![-0.125 * self.density; 8],
            of_acceleration: true,
        }]
    }
}

#[cfg(test)]
mod tests {
    use std::f64::consts::PI;

    use super::*;
    use crate::element::{WetFace, reference_mass};
    use crate::mesh::{Cylinder, Face};

    /// Faces of a hexahedron, counter-clockwise seen from outside.
    const FACES: [[usize; 4]; 6] = [[0, 3, 2, 1], [4, 5, 6, 7], [0, 1, 5, 4], [1, 2, 6, 5], [2, 3, 7, 6], [3, 0, 4, 7]];

    fn distorted() -> Hexahedron {
        let mut chart = [
            [0.0, 0.0, 0.0],
            [1.0, 0.0, 0.0],
            [1.2, 0.9, 0.0],
            [-0.1, 1.1, 0.0],
            [0.0, 0.0, 1.0],
            [1.0, 0.0, 0.8],
            [1.2, 0.9, 1.3],
            [-0.1, 1.1, 1.1],
        ];
        // A frustum-like cell whose four sides are planes: the top corners slide along the side edges.
        for a in 4..8 {
            chart[a][0] = chart[a - 4][0];
            chart[a][1] = chart[a - 4][1];
        }
        Hexahedron { nodes: std::array::from_fn(|a| a), chart }
    }

    /// H φ with φ linear is the flux of its gradient through the faces: ∫ N,i dV = ∮ N n_i dA on any hexahedron. Tested
    /// with x and y at the four nodes off the warped top, whose normal is not constant.
    #[test]
    fn linear_potential_is_exact_on_a_distorted_cell() {
        let cell = distorted();
        let element = Potential8::new(&cell, Chart::Cartesian, 2.0).unwrap();
        let h = reference_mass(&element);
        for i in 0..8 {
            let row: f64 = (0..8).map(|j| h.get(i, j)).sum();
            assert!(row.abs() < 1e-14, "a constant has no energy");
            for j in 0..8 {
                assert!((h.get(i, j) - h.get(j, i)).abs() < 1e-15);
            }
        }
        // The energy of φ = x, y or z is that of unit velocity, ρ V.
        for k in 0..3 {
            let x: Vec<f64> = cell.chart.iter().map(|c| c[k]).collect();
            let energy: f64 = (0..8).map(|i| (0..8).map(|j| x[i] * h.get(i, j) * x[j]).sum::<f64>()).sum();
            assert!((energy + 2.0 * element.volume()).abs() < 1e-13);
        }
        for k in 0..2 {
            let mut flux = [0.0; 8];
            for corners in &FACES[2..] {
                let face = Face { nodes: *corners, chart: corners.map(|c| cell.chart[c]) };
                let normal = super::super::potential_face::point(&face, Chart::Cartesian, 0.0, 0.0).normal;
                let wet = WetFace::new(&face, Chart::Cartesian, *corners, [normal.into(); 4], 2.0).unwrap();
                let b = reference_mass(&wet);
                for a in 0..4 {
                    flux[corners[a]] += (0..4).map(|c| b.get(a, 4 + 3 * c + k)).sum::<f64>();
                }
            }
            for a in 0..4 {
                let image: f64 = (0..8).map(|j| -h.get(a, j) * cell.chart[j][k]).sum();
                assert!((image - flux[a]).abs() < 1e-13, "node {a}: {image} {}", flux[a]);
            }
        }
    }

    /// Cylindrical chart, axis wedges included: the volume is π R² H, and so is the energy of φ = z.
    #[test]
    fn cylinder_volume_and_vertical_potential() {
        let mesh = Cylinder { radii: vec![0.0, 0.5, 1.3], sectors: 7, heights: vec![0.0, 0.4, 1.0] };
        let volume = mesh.volume().unwrap();
        let (mut sum, mut energy) = (0.0, 0.0);
        for cell in &volume.cells {
            let element = Potential8::new(cell, Chart::Cylindrical, 1.0).unwrap();
            sum += element.volume();
            let h = reference_mass(&element);
            let z: Vec<f64> = cell.chart.iter().map(|c| c[2]).collect();
            energy -= (0..8).map(|i| (0..8).map(|j| z[i] * h.get(i, j) * z[j]).sum::<f64>()).sum::<f64>();
        }
        let exact = PI * 1.69;
        assert!((sum / exact - 1.0).abs() < 1e-13 && (energy / exact - 1.0).abs() < 1e-13);
    }

    #[test]
    fn inverted_cells_are_rejected() {
        let mut cell = distorted();
        cell.chart.swap(0, 4);
        assert!(matches!(Potential8::new(&cell, Chart::Cartesian, 1.0), Err(ElementError::Jacobian { .. })));
        assert!(matches!(Potential8::new(&distorted(), Chart::Cartesian, -1.0), Err(ElementError::Parameter { .. })));
    }
}
