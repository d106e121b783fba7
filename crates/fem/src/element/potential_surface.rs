//! `potential_surface`: free surface of a liquid given by its potential.
//!
//! ```text
//! φ,n = η,   φ̈ + g η = 0        S_ab = ∫ N_a N_b dA        stiffness ρ g S (η, η)        mass block ρ S (φ, η)
//! ```
//!
//! Dofs at each node: [`Dof::Phi`], [`Dof::Eta`]. The face is horizontal at rest, its normal upwards.
//!
//! Source: Morand & Ohayon 1995, chapter 5. Limits: small waves, no surface tension.

use super::potential_face::{check_face, gauss_points, point};
use super::{Element, ElementError, Inspect, LocalMatrix, Response, Sample, Trial, positive, require};
use crate::chart::Chart;
use crate::dofs::Dof;
use crate::mesh::Face;

const KIND: &str = "potential_surface";

/// Free-surface face.
#[derive(Clone, Debug, PartialEq)]
pub struct PotentialSurface {
    face: Face,
    chart: Chart,
    density: f64,
    gravity: f64,
}

impl PotentialSurface {
    /// A face of the free surface; ρ [kg/m³], g [m/s²].
    ///
    /// Errors: area, density or gravity not positive.
    pub fn new(face: &Face, chart: Chart, density: f64, gravity: f64) -> Result<PotentialSurface, ElementError> {
        require(positive(density), KIND, "density", density, "a positive number")?;
        require(positive(gravity), KIND, "gravity", gravity, "a positive number")?;
        check_face(KIND, face, chart)?;
        Ok(PotentialSurface { face: *face, chart, density, gravity })
    }

    /// S, 4 × 4 [m²].
    fn areas(&self) -> [[f64; 4]; 4] {
        let mut s = [[0.0; 4]; 4];
        for p in gauss_points(&self.face, self.chart) {
            for (row, ni) in s.iter_mut().zip(p.n) {
                for (entry, nj) in row.iter_mut().zip(p.n) {
                    *entry += ni * nj * p.area;
                }
            }
        }
        s
    }
}

impl Element for PotentialSurface {
    crate::answers!(KIND, face.nodes, &[Dof::Phi, Dof::Eta]; linear inspect);

    fn mass(&self, out: &mut LocalMatrix) {
        for (i, row) in self.areas().into_iter().enumerate() {
            for (j, s) in row.into_iter().enumerate() {
                out.add(2 * i, 2 * j + 1, self.density * s);
                out.add(2 * j + 1, 2 * i, self.density * s);
            }
        }
    }

    fn respond(&self, Trial { motion, want, .. }: Trial<'_>, out: &mut Response) -> Result<(), ElementError> {
        let weight = self.density * self.gravity;
        for (i, row) in self.areas().into_iter().enumerate() {
            for (j, s) in row.into_iter().enumerate() {
                if want.tangent {
                    out.tangent.add(2 * i + 1, 2 * j + 1, weight * s);
                }
                if want.force {
                    out.force[2 * i + 1] += weight * s * motion.values[2 * j + 1];
                }
            }
        }
        Ok(())
    }
}

impl Inspect for PotentialSurface {
    /// Elevation η at the centre.
    fn samples(&self) -> Vec<Sample> {
        let centre = point(&self.face, self.chart, 0.0, 0.0);
        vec![Sample {
            name: "elevation",
            position: self.chart.position(centre.chart),
            row: centre.n.iter().flat_map(|&n| [0.0, n]).collect(),
            of_acceleration: false,
        }]
    }
}
