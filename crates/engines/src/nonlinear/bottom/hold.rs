//! Springs that hold the foot.

use std::f64::consts::PI;

use fem::dofs::Dof;
use fem::element::super_element::SuperElement;
use fem::linalg::Matrix;
use fem::model::Builder;
use tank::Course;

use super::KEY;
use crate::FeError;
use crate::nonlinear::arcs::shares;

/// Stiffness that holds the foot over E t of the lowest course: so stiff that it moves by less than 10⁻³ of what the wall does.
const HELD: f64 = 1e3;

/// A stiff spring against the displacement of the foot along itself, −2 ∫ u_θ sin θ dθ/π = 0 over half of it: the ground takes the shear as the wall
/// hands it over, and the tank does not slide, while the foot is free to move in and out. A spring that also pushed across the foot would make the plate
/// turn one into the other, V/s = 1.2·10¹⁰ N/m for plates of 8 mm. Returns its element and the weights that make ∫ of its force along x.
pub(in crate::nonlinear) fn keep_in_place(
    builder: &mut Builder,
    angles: &[f64],
    foot: &[usize],
    lowest: &Course,
) -> Result<(usize, Vec<f64>), FeError> {
    let stiffness = HELD * lowest.build_up().iter().map(|l| l.material.youngs_modulus * l.thickness).sum::<f64>();
    let failed = |e: fem::element::ElementError| FeError::Analysis(e.to_string());
    let mut unknowns = Vec::new();
    let (mut mean, mut along) = (Vec::new(), Vec::new());
    for ((&node, share), angle) in foot.iter().zip(shares(angles)).zip(angles) {
        unknowns.push((node, Dof::Uy));
        mean.push(-2.0 * angle.sin() * share / PI);
        along.push(-angle.sin());
    }
    let mut matrix = Matrix::zeros(mean.len(), mean.len());
    for (i, a) in mean.iter().enumerate() {
        for (j, b) in mean.iter().enumerate() {
            matrix.add(i, j, stiffness * a * b);
        }
    }
    let element = SuperElement::over(&unknowns).and_then(|e| e.with_stiffness(matrix)).map_err(failed)?;
    Ok((builder.element(KEY, element), along))
}

/// Springs against all vertical displacements of the foot other than w₀ + w₁ cos θ.
pub(in crate::nonlinear) fn keep_plane(builder: &mut Builder, angles: &[f64], foot: &[usize]) -> Result<(), FeError> {
    /// A hundred times the stiffness of the ground and more [N/m per radian].
    const STIFF: f64 = 1e12;
    let failed = |e: fem::element::ElementError| FeError::Analysis(e.to_string());
    let n = foot.len();
    let weights = shares(angles);
    let unit = |f: &dyn Fn(f64) -> f64, before: Option<&Vec<f64>>| -> Vec<f64> {
        let mut v: Vec<f64> = angles.iter().map(|a| f(*a)).collect();
        let product = |a: &[f64], b: &[f64]| (0..n).map(|i| weights[i] * a[i] * b[i]).sum::<f64>();
        if let Some(b) = before {
            let part = product(&v, b);
            v.iter_mut().zip(b).for_each(|(v, b)| *v -= part * b);
        }
        let length = product(&v, &v).sqrt();
        v.iter().map(|x| x / length).collect()
    };
    let even = unit(&|_| 1.0, None);
    let tilt = unit(&f64::cos, Some(&even));
    let mut matrix = Matrix::zeros(n, n);
    for i in 0..n {
        matrix.add(i, i, STIFF * weights[i]);
        for j in 0..n {
            let plane = even[i] * even[j] + tilt[i] * tilt[j];
            matrix.add(i, j, -STIFF * weights[i] * weights[j] * plane);
        }
    }
    let unknowns: Vec<(usize, Dof)> = foot.iter().map(|n| (*n, Dof::Uz)).collect();
    let element = SuperElement::over(&unknowns).and_then(|e| e.with_stiffness(matrix)).map_err(failed)?;
    builder.element("plane", element);
    Ok(())
}
