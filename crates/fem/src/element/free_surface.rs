//! `free_surface`: stiffness of a liquid's free surface, ½ ∫ ρ g u_z² dA.
//!
//! ```text
//! S_ab = ρ g ∫ N_a N_b √g dx¹ dx²
//! ```
//!
//! on the horizontal projection of the face (dissertation, eqs. (5.36), (5.40), appendix C, G and H). The nodal areas
//! Σ_b S_ab/ρg must be those of the liquid element below, ∫ N_a,₃ dV of its top corners, or the liquid circulates under
//! its own weight. Full quadrature of N_a √g matches mean dilatation and full volume quadrature; next to a liquid whose
//! volume part is taken at one point, √g and the Jacobian are taken at the face's centre as well
//! ([`FreeSurface::at_one_point`]).

use super::{Element, ElementError, Response, Trial, positive, require};
use crate::chart::Chart;
use crate::dofs::Dof;
use crate::mesh::Face;
use crate::shape::{gauss, quad4};

const KIND: &str = "free_surface";

/// Free surface on a four-node face.
#[derive(Clone, Debug)]
pub struct FreeSurface {
    nodes: [usize; 4],
    matrix: [[f64; 4]; 4],
}

impl FreeSurface {
    /// Surface on `face`, seen counter-clockwise from above.
    ///
    /// * `weight_density`: ρ g [N/m³]
    ///
    /// Errors: the face does not look upwards, or has no area; ρ g not positive.
    pub fn new(face: &Face, chart: Chart, weight_density: f64) -> Result<FreeSurface, ElementError> {
        FreeSurface::with(face, chart, weight_density, false)
    }

    /// The same with the Jacobian of the face's centre: nodal areas of a quarter each, to go with a liquid whose volume
    /// part is taken at one point.
    ///
    /// Errors: as [`FreeSurface::new`].
    pub fn at_one_point(face: &Face, chart: Chart, weight_density: f64) -> Result<FreeSurface, ElementError> {
        FreeSurface::with(face, chart, weight_density, true)
    }

    fn with(face: &Face, chart: Chart, weight_density: f64, one_point: bool) -> Result<FreeSurface, ElementError> {
        require(positive(weight_density), KIND, "weight density", weight_density, "a positive number")?;
        let centre = area_factor(face, chart, 0.0, 0.0)?;
        let mut matrix = [[0.0; 4]; 4];
        for &(r, wr) in gauss::TWO {
            for &(s, ws) in gauss::TWO {
                let own = area_factor(face, chart, r, s)?;
                let weight = weight_density * wr * ws * if one_point { centre } else { own };
                let n = quad4::value(r, s);
                for a in 0..4 {
                    for b in 0..4 {
                        matrix[a][b] += weight * n[a] * n[b];
                    }
                }
            }
        }
        Ok(FreeSurface { nodes: face.nodes, matrix })
    }
}

/// √g det ∂(x¹, x²)/∂(r, s): horizontal area per area of the reference square.
fn area_factor(face: &Face, chart: Chart, r: f64, s: f64) -> Result<f64, ElementError> {
    let (n, d) = (quad4::value(r, s), quad4::slope(r, s));
    let (mut x, mut j) = ([0.0; 3], [[0.0; 2]; 2]);
    for a in 0..4 {
        for i in 0..3 {
            x[i] += n[a] * face.chart[a][i];
        }
        for k in 0..2 {
            for i in 0..2 {
                j[k][i] += d[a][k] * face.chart[a][i];
            }
        }
    }
    let determinant = (j[0][0] * j[1][1] - j[0][1] * j[1][0]) * chart.volume_factor(x);
    if determinant > 0.0 && determinant.is_finite() {
        Ok(determinant)
    } else {
        Err(ElementError::Jacobian { kind: KIND, determinant, nodes: face.nodes.to_vec() })
    }
}

impl Element for FreeSurface {
    // All three, so that nodes may have frames; only u_z has stiffness.
    crate::answers!(KIND, nodes, Dof::TRANSLATIONS; massless);

    fn respond(&self, Trial { motion, want, .. }: Trial<'_>, out: &mut Response) -> Result<(), ElementError> {
        for (a, row) in self.matrix.iter().enumerate() {
            for (b, k) in row.iter().enumerate() {
                if want.force {
                    out.force[3 * a + 2] += k * motion.values[3 * b + 2];
                }
                if want.tangent {
                    out.tangent.add(3 * a + 2, 3 * b + 2, *k);
                }
            }
        }
        Ok(())
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::element::reference_stiffness;
    use crate::mesh::Cylinder;

    /// In the cylindrical chart the area of a disc is exact: Σ S_ab = ρ g π R².
    #[test]
    fn areas() {
        let mesh = Cylinder { radii: vec![0.0, 0.5, 2.0], sectors: 7, heights: vec![0.0, 1.0] };
        let volume = mesh.volume().unwrap();
        for at_one_point in [false, true] {
            let mut sum = 0.0;
            for face in &volume.surface {
                let surface = if at_one_point {
                    FreeSurface::at_one_point(face, Chart::Cylindrical, 3.0)
                } else {
                    FreeSurface::new(face, Chart::Cylindrical, 3.0)
                };
                let k = reference_stiffness(&surface.unwrap()).unwrap();
                assert_eq!(k.get(0, 0), 0.0);
                sum += k.data.iter().sum::<f64>();
            }
            assert!((sum / (12.0 * std::f64::consts::PI) - 1.0).abs() < 1e-13);
        }
        assert!(FreeSurface::new(&volume.bottom[0], Chart::Cylindrical, 3.0).is_err());
        assert!(FreeSurface::new(&volume.surface[0], Chart::Cylindrical, 0.0).is_err());
    }
}
