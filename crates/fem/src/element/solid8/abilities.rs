//! Internal state of `solid8`, and its optional abilities.

use materials::PointState;
use nalgebra::{Matrix3, Vector3};

use super::kernels::{displacement_gradient, strain_rows, tensor, voigt};
use super::{Solid8, VALUES};
use crate::element::solid8_law::{Law, dyad};
use crate::element::{Buckling, Contact, ElementError, Inspect, Inspection, LocalMatrix, Motion, Sample};

impl Contact for Solid8 {
    fn only_between_shells(&self) -> bool {
        self.material.law.only_between_shells()
    }

    /// The points of a layer without tension: pressed or parted.
    fn switches(&self, motion: Motion<'_>, _history: &[f64], see: &mut dyn FnMut(bool)) {
        if !self.material.law.is_linear() {
            self.normal_strains(motion.values).iter().for_each(|&e| see(e <= 0.0));
        }
    }
}

impl Inspect for Solid8 {
    /// Stresses at the 2 × 2 × 2 points: `stress_11` … `stress_13` in global components, or `stress_nn` along the layer's
    /// normal.
    fn samples(&self) -> Vec<Sample> {
        const NAMES: [&str; 6] = ["stress_11", "stress_22", "stress_33", "stress_12", "stress_23", "stress_13"];
        let mut samples = Vec::new();
        for (q, point) in self.points().iter().enumerate() {
            let position = std::array::from_fn(|k| (0..8).map(|a| VALUES[q][a] * self.coordinates[a][k]).sum());
            let columns = point.gradients.map(|g| strain_rows(&Matrix3::identity(), &g));
            let (_, moduli) = self.material.law.stress(&[0.0; 6], &point.normal);
            // Stress of a unit displacement, column after column.
            let stresses: Vec<[f64; 6]> = columns
                .as_flattened()
                .iter()
                .map(|strain| moduli.map(|row| row.iter().zip(strain).map(|(d, e)| d * e).sum()))
                .collect();
            let mut push = |name, row: Vec<f64>| {
                samples.push(Sample { name, position, row, of_acceleration: false });
            };
            match self.material.law {
                Law::NormalOnly { .. } | Law::Core { .. } => {
                    let n = point.normal;
                    push("stress_nn", stresses.iter().map(|s| n.dot(&(tensor(s) * n))).collect());
                }
                Law::Isotropic { .. } => {
                    for (component, name) in NAMES.into_iter().enumerate() {
                        push(name, stresses.iter().map(|s| s[component]).collect());
                    }
                }
            }
        }
        samples
    }

    /// Strain and stress along the layer's normal at the 2 × 2 × 2 points, for layers only.
    fn material_points(&self, motion: Motion<'_>, _history: &[f64], see: &mut dyn FnMut(&Inspection)) {
        if !self.material.law.only_between_shells() {
            return;
        }
        for (q, point) in self.points().iter().enumerate() {
            let (_, strain) = self.strain(point, motion.values);
            let p = dyad(&point.normal);
            let (stress, _) = self.material.law.stress(&strain, &point.normal);
            let along = point.normal.dot(&(tensor(&stress) * point.normal));
            let wish = if point.normal.x.abs() < 0.7 { Vector3::x() } else { Vector3::y() };
            see(&Inspection {
                point: q,
                layer: 0,
                position: std::array::from_fn(|k| (0..8).map(|a| VALUES[q][a] * self.coordinates[a][k]).sum()),
                depth: 0.0,
                axes: [point.normal, point.normal.cross(&wish).normalize()],
                strain: [p.iter().zip(strain).map(|(p, e)| p * e).sum(), 0.0, 0.0],
                stress: [along, 0.0, 0.0],
                state: PointState::default(),
            });
        }
    }
}

impl Buckling for Solid8 {
    /// Stresses of the linear solution times products of gradients.
    fn geometric_stiffness(&self, values: &[f64], out: &mut LocalMatrix) -> Result<(), ElementError> {
        for point in &self.points() {
            let h = displacement_gradient(point, values);
            let strain = voigt(&(0.5 * (h + h.transpose())));
            let (stress, _) = self.material.law.stress(&strain, &point.normal);
            let s = tensor(&stress);
            for b in 0..8 {
                let sg = s * Vector3::from(point.gradients[b]) * point.volume;
                for a in 0..8 {
                    let value = Vector3::from(point.gradients[a]).dot(&sg);
                    (0..3).for_each(|i| out.add(3 * a + i, 3 * b + i, value));
                }
            }
        }
        Ok(())
    }
}
