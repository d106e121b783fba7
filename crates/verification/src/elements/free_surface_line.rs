//! `free_surface_line`: stiffness of the free surface of the plane liquid [`super::Fluid4`], ½ ∫ ρ g u_z² dA.
//!
//! The two-dimensional form of [`fem::element::FreeSurface`].

use fem::chart::Chart;
use fem::dofs::Dof;
use fem::element::{Element, ElementError, Response, Trial};
use fem::shape::gauss;

const KIND: &str = "free_surface_line";

/// A line of two nodes.
#[derive(Clone, Debug)]
pub struct FreeSurfaceLine {
    nodes: [usize; 2],
    matrix: [[f64; 2]; 2],
}

impl FreeSurfaceLine {
    /// Surface between two nodes with chart coordinates x¹ = x or r, the second greater.
    ///
    /// * `breadth`: thickness [m], or the angle of the sector [rad] in the cylindrical chart
    /// * `weight_density`: ρ g [N/m³]
    ///
    /// Errors: the line does not run to greater x¹, breadth or ρ g not positive.
    pub fn new(
        nodes: [usize; 2],
        x: [f64; 2],
        chart: Chart,
        breadth: f64,
        weight_density: f64,
    ) -> Result<FreeSurfaceLine, ElementError> {
        for (parameter, value) in [("weight density", weight_density), ("breadth", breadth)] {
            if !(value > 0.0 && value.is_finite()) {
                return Err(ElementError::Parameter {
                    kind: KIND,
                    parameter,
                    found: value.to_string(),
                    allowed: "a positive number",
                });
            }
        }
        let determinant = 0.5 * (x[1] - x[0]);
        if !(determinant > 0.0 && determinant.is_finite()) {
            let nodes = nodes.to_vec();
            return Err(ElementError::Jacobian { kind: KIND, determinant, nodes });
        }
        let mut matrix = [[0.0; 2]; 2];
        for &(r, weight) in gauss::TWO {
            let n = [0.5 * (1.0 - r), 0.5 * (1.0 + r)];
            let place = n[0] * x[0] + n[1] * x[1];
            let area = weight * determinant * breadth * chart.volume_factor([place, 0.0, 0.0]);
            for a in 0..2 {
                for b in 0..2 {
                    matrix[a][b] += weight_density * area * n[a] * n[b];
                }
            }
        }
        Ok(FreeSurfaceLine { nodes, matrix })
    }
}

impl Element for FreeSurfaceLine {
    fem::answers!(KIND, nodes, &[Dof::Uz]; massless);

    fn respond(&self, Trial { motion, want, .. }: Trial<'_>, out: &mut Response) -> Result<(), ElementError> {
        for (a, row) in self.matrix.iter().enumerate() {
            for (b, k) in row.iter().enumerate() {
                if want.force {
                    out.force[a] += k * motion.values[b];
                }
                if want.tangent {
                    out.tangent.add(a, b, *k);
                }
            }
        }
        Ok(())
    }
}

#[cfg(test)]
mod tests {
    use fem::element::reference_stiffness;

    use super::*;

    /// The area of a sector, in the cylindrical chart.
    #[test]
    fn area() {
        let line = FreeSurfaceLine::new([0, 1], [0.5, 2.0], Chart::Cylindrical, 2.0, 3.0).unwrap();
        let k = reference_stiffness(&line).unwrap();
        // ρ g · angle · ½ (R² − r²)
        assert!((k.data.iter().sum::<f64>() - 3.0 * 3.75).abs() < 1e-13);
        assert!(FreeSurfaceLine::new([0, 1], [2.0, 0.5], Chart::Cylindrical, 2.0, 3.0).is_err());
    }
}
