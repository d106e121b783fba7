//! Geometry of a quadrilateral face in its chart.
//!
//! ```text
//! xⁱ(r, s) = Σ N_a xⁱ_a         t_r = ∂x/∂r, t_s = ∂x/∂s  with orthonormal components (dr, r dθ, dz)
//! dA = |t_r × t_s| dr ds        n = t_r × t_s / |t_r × t_s|
//! ```
//!
//! In the cylindrical chart a face of the mantle has the area R Δθ Δz of the cylinder, not that of a facet.

use nalgebra::Vector3;

use super::ElementError;
use crate::chart::Chart;
use crate::mesh::Face;
use crate::shape::{gauss, quad4};

/// One point of a face.
#[derive(Clone, Copy, Debug)]
pub(super) struct FacePoint {
    /// Shape functions of the corners.
    pub n: [f64; 4],
    /// Chart coordinates.
    pub chart: [f64; 3],
    /// Area element dA/(dr ds) [m²].
    pub area: f64,
    /// Unit normal, global Cartesian; outwards for corners that run counter-clockwise seen from outside.
    pub normal: Vector3<f64>,
}

/// The point at natural coordinates (r, s).
pub(super) fn point(face: &Face, chart: Chart, r: f64, s: f64) -> FacePoint {
    let (n, d) = (quad4::value(r, s), quad4::slope(r, s));
    let mut x = [0.0; 3];
    let mut tangents = [[0.0; 3]; 2];
    for a in 0..4 {
        for i in 0..3 {
            x[i] += n[a] * face.chart[a][i];
            for (tangent, slope) in tangents.iter_mut().zip(d[a]) {
                tangent[i] += slope * face.chart[a][i];
            }
        }
    }
    let base = chart.orthonormal_base(x);
    let length = [1.0, chart.volume_factor(x), 1.0];
    let vector = |t: [f64; 3]| (0..3).fold(Vector3::zeros(), |v, i| v + base[i] * (t[i] * length[i]));
    let cross = vector(tangents[0]).cross(&vector(tangents[1]));
    let area = cross.norm();
    FacePoint { n, chart: x, area, normal: if area > 0.0 { cross / area } else { cross } }
}

/// The 2 × 2 Gauss points; `area` includes the weights.
pub(super) fn gauss_points(face: &Face, chart: Chart) -> [FacePoint; 4] {
    std::array::from_fn(|k| {
        let ((r, wr), (s, ws)) = (gauss::TWO[k % 2], gauss::TWO[k / 2]);
        let mut p = point(face, chart, r, s);
        p.area *= wr * ws;
        p
    })
}

/// Errors: an area that is not positive at an integration point.
pub(super) fn check_face(kind: &'static str, face: &Face, chart: Chart) -> Result<(), ElementError> {
    for p in gauss_points(face, chart) {
        if !(p.area > 0.0 && p.area.is_finite()) {
            return Err(ElementError::Jacobian { kind, determinant: p.area, nodes: face.nodes.to_vec() });
        }
    }
    Ok(())
}
