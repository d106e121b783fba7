//! Motions of an element's nodes.

use fem::dofs::{Dof, KINDS};
use fem::element::Motion;
use nalgebra::{UnitQuaternion, Vector3};

use crate::specimen::Specimen;

/// Motion of the nodes of a specimen. Rotational dofs hold the rotation vector of the same rotation.
#[derive(Clone, Debug)]
pub(crate) struct Moved {
    pub(crate) values: Vec<f64>,
    pub(crate) rotations: Vec<UnitQuaternion<f64>>,
}

impl Moved {
    pub(crate) fn motion(&self) -> Motion<'_> {
        Motion { values: &self.values, rotations: &self.rotations }
    }

    /// No motion.
    pub(crate) fn rest(specimen: &Specimen) -> Moved {
        Moved {
            values: vec![0.0; specimen.locals().len()],
            rotations: vec![UnitQuaternion::identity(); specimen.positions.len()],
        }
    }

    /// Something without any pattern, number `k`, of `part` of the specimen's amplitude.
    pub(crate) fn scattered(specimen: &Specimen, k: usize, part: f64) -> Moved {
        let locals = specimen.locals();
        let value = |i: usize| part * specimen.amplitude * (0.7 + 1.9 * i as f64 + 2.3 * k as f64).sin();
        let values: Vec<f64> = (0..locals.len()).map(value).collect();
        let mut vectors = vec![Vector3::zeros(); specimen.positions.len()];
        for (&(a, dof), &x) in locals.iter().zip(&values) {
            if let i @ 3..6 = dof.index() {
                vectors[a][i - 3] = x;
            }
        }
        Moved { values, rotations: vectors.into_iter().map(UnitQuaternion::from_scaled_axis).collect() }
    }

    /// A run of `steps` motions that goes out and back, so that laws load and unload.
    pub(crate) fn run(specimen: &Specimen, steps: usize) -> Vec<Moved> {
        let part = |k: usize| (4.0 * k as f64 / steps as f64).sin();
        (0..steps).map(|k| Moved::scattered(specimen, k / 3, part(k + 1))).collect()
    }

    /// The same with local dof `k` moved by `h`: rotations by a spin on top.
    pub(crate) fn nudged(&self, specimen: &Specimen, k: usize, h: f64) -> Moved {
        let mut out = self.clone();
        out.values[k] += h;
        let (a, dof) = specimen.locals()[k];
        if let i @ 3..6 = dof.index() {
            let mut spin = Vector3::zeros();
            spin[i - 3] = h;
            out.rotations[a] = UnitQuaternion::from_scaled_axis(spin) * out.rotations[a];
        }
        out
    }

    /// The same seen in turned axes.
    pub(crate) fn turned(&self, specimen: &Specimen, turn: &UnitQuaternion<f64>) -> Moved {
        Moved {
            values: turned_vector(specimen, turn, &self.values),
            rotations: self.rotations.iter().map(|r| turn * r * turn.inverse()).collect(),
        }
    }

    /// A rotation about the origin and a translation on top of the motion. Values of rotational dofs stay as they are:
    /// elements with finite rotations do not read them.
    pub(crate) fn carried(&self, specimen: &Specimen, turn: &UnitQuaternion<f64>, shift: Vector3<f64>) -> Moved {
        let mut out = self.clone();
        let mut moved = vec![Vector3::zeros(); specimen.positions.len()];
        let locals = specimen.locals();
        for (&(a, dof), &x) in locals.iter().zip(&self.values) {
            if dof.index() < 3 {
                moved[a][dof.index()] = x;
            }
        }
        for (k, &(a, dof)) in locals.iter().enumerate() {
            if dof.index() < 3 {
                let x = Vector3::from(specimen.positions[a]);
                out.values[k] = (turn * (x + moved[a]) + shift - x)[dof.index()];
            }
        }
        out.rotations.iter_mut().for_each(|r| *r = turn * *r);
        out
    }
}

/// v ← T v, where T turns displacements and rotations of every node.
///
/// Panics if a component appears that the element has no dof for.
pub(crate) fn turned_vector(specimen: &Specimen, turn: &UnitQuaternion<f64>, v: &[f64]) -> Vec<f64> {
    let locals = specimen.locals();
    let mut at = vec![[0.0; KINDS]; specimen.positions.len()];
    locals.iter().zip(v).for_each(|(&(a, dof), &x)| at[a][dof.index()] = x);
    let scale = v.iter().fold(0.0_f64, |m, x| m.max(x.abs()));
    for (a, own) in at.iter_mut().enumerate() {
        for first in [0, 3] {
            let turned = turn * Vector3::new(own[first], own[first + 1], own[first + 2]);
            own[first..first + 3].copy_from_slice(turned.as_slice());
        }
        for (dof, x) in Dof::ALL.iter().zip(own.iter()) {
            let carried = locals.contains(&(a, *dof));
            assert!(carried || x.abs() <= 1e-14 * scale, "{specimen}: {dof} of node {a}");
        }
    }
    locals.iter().map(|&(a, dof)| at[a][dof.index()]).collect()
}
