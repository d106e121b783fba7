//! Internal state of `wall`, and its optional abilities.

use nalgebra::Vector3;

use super::{INNER, OUTER, SHELL_SIZE, SIZE, Wall, add_block};
use crate::element::shell::director::add_turn_block;
use crate::element::shell4::{RESULTANTS, Shell4};
use crate::element::{
    Buckling, ElementError, Inspect, Inspection, LocalMatrix, Motion, Sample, SectionState, reference_stiffness,
};

impl Inspect for Wall {
    /// Samples of the inner shell (`inner_n_11`, …), the layer (`stress_nn`, …) and the outer shell (`outer_n_11`, …).
    fn samples(&self) -> Vec<Sample> {
        let mut out = Vec::new();
        let rename = |name: &'static str, to: &[&'static str; 8]| {
            let found = RESULTANTS.iter().position(|r| *r == name);
            found.map_or(name, |k| to[k])
        };
        let of_shell = |shell: &Shell4, i: usize, names: &[&'static str; 8]| {
            let spread = |sample: Sample| {
                let mut row = vec![0.0; SIZE];
                row[SHELL_SIZE * i..SHELL_SIZE * (i + 1)].copy_from_slice(&sample.row);
                Sample { name: rename(sample.name, names), row, ..sample }
            };
            shell.samples().into_iter().map(spread).collect::<Vec<_>>()
        };
        out.extend(of_shell(&self.inner, 0, &INNER));
        for sample in self.layer.samples() {
            let mut row = vec![0.0; SIZE];
            self.add_force(&sample.row, &self.directors, &mut row);
            out.push(Sample { row, ..sample });
        }
        out.extend(of_shell(&self.outer, 1, &OUTER));
        out
    }

    fn dissipated(&self, history: &[f64]) -> f64 {
        let of = |(shell, i): (&Shell4, usize)| shell.dissipated(&history[self.slots(i)]);
        self.shells().into_iter().map(of).sum()
    }

    /// Points of the inner shell 0 to 3, of the outer 4 to 7, of the layer 8 to 15.
    fn material_points(&self, motion: Motion<'_>, history: &[f64], see: &mut dyn FnMut(&Inspection)) {
        let shift =
            |inspection: &Inspection, by: usize| Inspection { point: inspection.point + by, ..inspection.clone() };
        for (shell, i) in self.shells() {
            shell.material_points(Wall::part(&motion, i), &history[self.slots(i)], &mut |p| see(&shift(p, 4 * i)));
        }
        let (u, _) = self.faces(&motion);
        let face = Motion { values: &u, rotations: motion.rotations };
        self.layer.material_points(face, &[], &mut |p| see(&shift(p, 8)));
    }

    /// Sections of the inner shell, then of the outer.
    fn sections(&self, motion: Motion<'_>, history: &[f64]) -> Result<Vec<SectionState>, ElementError> {
        let mut out = Vec::new();
        for (shell, i) in self.shells() {
            out.extend(shell.sections(Wall::part(&motion, i), &history[self.slots(i)])?);
        }
        Ok(out)
    }
}

impl Buckling for Wall {
    fn geometric_stiffness(&self, values: &[f64], out: &mut LocalMatrix) -> Result<(), ElementError> {
        for (shell, i) in self.shells() {
            let mut part = LocalMatrix::zeros(SHELL_SIZE);
            shell.geometric_stiffness(&values[SHELL_SIZE * i..SHELL_SIZE * (i + 1)], &mut part)?;
            add_block(i, &part, out);
        }
        match self.loose {
            true => Ok(()),
            false => self.layer_geometric_stiffness(values, out),
        }
    }
}

impl Wall {
    /// Adds the geometric stiffness of the layer.
    pub(super) fn layer_geometric_stiffness(&self, values: &[f64], out: &mut LocalMatrix) -> Result<(), ElementError> {
        let pull = self.pull(&self.directors);
        let mut u = vec![0.0; 24];
        for a in 0..8 {
            let turn = pull[a] * Vector3::from_column_slice(&values[6 * a + 3..6 * a + 6]);
            (0..3).for_each(|i| u[3 * a + i] = values[6 * a + i] + turn[i]);
        }
        let mut face = LocalMatrix::zeros(24);
        self.layer.geometric_stiffness(&u, &mut face)?;
        self.add_pulled(&face, &self.directors, out);
        let force = reference_stiffness(&self.layer)?.to_matrix().times(&u);
        for a in 0..8 {
            let f = Vector3::from_column_slice(&force[3 * a..3 * a + 3]) * self.lever[a];
            add_turn_block(out, a, &f, &self.directors[a]);
        }
        Ok(())
    }
}
