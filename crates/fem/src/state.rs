//! Committed and trial fields and the elements' history.
//!
//! No element and no material has commit code: [`State::commit`] makes the trial fields and history the committed ones,
//! [`State::revert`] the other way round. Finite rotations are fields: each node's rotation since the reference
//! state, updated multiplicatively by spin increments, so that a cut step restores them with everything else.

use nalgebra::{UnitQuaternion, Vector3};

use crate::dofs::{Dof, KINDS};
use crate::element::{Element, Motion, Stage};
use crate::model::Model;

/// Fields over a model.
#[derive(Clone, Debug, PartialEq)]
pub struct Fields {
    /// Unknowns (displacements, linear rotations, potentials), one an equation.
    pub u: Vec<f64>,
    /// Their velocity.
    pub v: Vec<f64>,
    /// Their acceleration.
    pub a: Vec<f64>,
    /// Rotation of every node since the reference state.
    pub rotation: Vec<UnitQuaternion<f64>>,
}

/// Committed and trial state of a model.
#[derive(Clone, Debug)]
pub struct State {
    /// Last converged fields.
    pub committed: Fields,
    /// Fields being iterated.
    pub trial: Fields,
    /// History at the committed state, all elements one after the other.
    pub old: Vec<f64>,
    /// History at the trial state; without meaning until the elements have written it.
    new: Vec<f64>,
    /// Whether they have, since the last commit or revert.
    written: bool,
    /// Start of each element's history, with the total at the end.
    offsets: Vec<usize>,
}

impl State {
    /// The reference state at rest.
    pub fn new(model: &Model) -> State {
        let n = model.dofs().len();
        let fields = Fields {
            u: vec![0.0; n],
            v: vec![0.0; n],
            a: vec![0.0; n],
            rotation: vec![UnitQuaternion::identity(); model.nodes().len()],
        };
        let mut offsets = vec![0];
        for element in model.elements() {
            offsets.push(offsets[offsets.len() - 1] + element.history_len());
        }
        let mut old = vec![0.0; offsets[offsets.len() - 1]];
        for (e, element) in model.elements().iter().enumerate() {
            element.init_history(&mut old[offsets[e]..offsets[e + 1]]);
        }
        State { committed: fields.clone(), trial: fields, new: old.clone(), written: false, old, offsets }
    }

    /// Range of element `e` in `old` and `new`.
    pub fn history(&self, e: usize) -> std::ops::Range<usize> {
        self.offsets[e]..self.offsets[e + 1]
    }

    /// Trial fields, committed history, trial history to be written, and the start of each element's history with the total at the
    /// end.
    pub(crate) fn split(&mut self) -> (&Fields, &[f64], &mut [f64], &[usize]) {
        self.written = true;
        (&self.trial, &self.old, &mut self.new, &self.offsets)
    }

    /// Changes the stage of all elements in the committed history.
    pub fn stage(&mut self, model: &Model, stage: Stage) {
        for (e, element) in model.elements().iter().enumerate() {
            element.stage(stage, &mut self.old[self.offsets[e]..self.offsets[e + 1]]);
        }
    }

    /// Accepts the trial state.
    pub fn commit(&mut self) {
        self.committed.clone_from(&self.trial);
        if std::mem::take(&mut self.written) {
            // Elements write all of their trial history: the old one need not be copied back.
            std::mem::swap(&mut self.old, &mut self.new);
        }
    }

    /// Returns to the committed state.
    pub fn revert(&mut self) {
        self.trial.clone_from(&self.committed);
        self.written = false;
    }

    /// Adds an increment to the trial displacements; its rotational part is a spin superposed on the nodes' rotations,
    /// with components in the node's rotation frame as it has turned with the node.
    pub fn increment(&mut self, model: &Model, du: &[f64]) {
        for (u, d) in self.trial.u.iter_mut().zip(du) {
            *u += d;
        }
        for node in 0..model.nodes().len() {
            let rotates = [Dof::Rx, Dof::Ry, Dof::Rz].iter().any(|&dof| model.dofs().equation(node, dof).is_some());
            if rotates {
                let spin = model.at_node(du, node);
                let rotation = &mut self.trial.rotation[node];
                let mut spin = Vector3::new(spin[3], spin[4], spin[5]);
                if model.rotation_frame(node).is_some() {
                    // The frame has turned with the node.
                    spin = *rotation * spin;
                }
                let turn = UnitQuaternion::from_scaled_axis(spin);
                *rotation = turn * *rotation;
                rotation.renormalize();
            }
        }
    }
}

/// Equal fields and equal committed history.
impl PartialEq for State {
    fn eq(&self, other: &State) -> bool {
        (&self.committed, &self.trial, &self.old) == (&other.committed, &other.trial, &other.old)
    }
}

/// Local values and rotations of one element, reused from element to element.
#[derive(Clone, Debug, Default)]
pub struct Gather {
    values: Vec<f64>,
    rotations: Vec<UnitQuaternion<f64>>,
}

impl Gather {
    /// The given values, and the rotations of the nodes of `element` in `fields`.
    pub fn values(&mut self, fields: &Fields, element: &dyn Element, values: impl Iterator<Item = f64>) -> Motion<'_> {
        self.values.clear();
        self.values.extend(values);
        self.rotations.clear();
        self.rotations.extend(element.nodes().iter().map(|&n| fields.rotation[n]));
        Motion { values: &self.values, rotations: &self.rotations }
    }

    /// The components of the nodes of `element` among those `at` all nodes, and their rotations in `fields`.
    pub(crate) fn turned(&mut self, fields: &Fields, element: &dyn Element, at: &[[f64; KINDS]]) -> Motion<'_> {
        self.values.clear();
        self.rotations.clear();
        for (a, &node) in element.nodes().iter().enumerate() {
            let own = &at[node];
            self.values.extend(element.dofs(a).iter().map(|d| own[d.index()]));
            self.rotations.push(fields.rotation[node]);
        }
        Motion { values: &self.values, rotations: &self.rotations }
    }

    /// Gathers the motion of the nodes of `element` in `fields`.
    pub fn motion(&mut self, model: &Model, fields: &Fields, element: &dyn Element) -> Motion<'_> {
        self.values.clear();
        self.rotations.clear();
        for (a, &node) in element.nodes().iter().enumerate() {
            let at: [f64; KINDS] = match element.own_axes() {
                true => model.own_at_node(&fields.u, node),
                false => model.at_node(&fields.u, node),
            };
            self.values.extend(element.dofs(a).iter().map(|d| at[d.index()]));
            self.rotations.push(fields.rotation[node]);
        }
        Motion { values: &self.values, rotations: &self.rotations }
    }
}
