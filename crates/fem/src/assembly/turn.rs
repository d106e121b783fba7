//! Components in the frames of the nodes.

use nalgebra::{Matrix3, UnitQuaternion, Vector3};

use crate::dofs::{Dof, KINDS};
use crate::element::{Element, LocalMatrix, Response, Want};
use crate::model::Model;
use crate::state::Fields;

/// Turns rotational components back with their nodes where these have a rotation frame: the frame F turns with the
/// node, its rows are those of F Rᵀ, so that the third one stays the director of a smooth shell node.
pub(super) fn turn_back(
    model: &Model,
    element: &dyn Element,
    rotation: &[UnitQuaternion<f64>],
    want: Want,
    response: &mut Response,
) {
    let mut k = 0;
    for (a, &node) in element.nodes().iter().enumerate() {
        for (i, &dof) in element.dofs(a).iter().enumerate() {
            let turned = dof == Dof::Rx && model.rotation_frame(node).is_some();
            if turned && rotation[node].imag() != Vector3::zeros() {
                let back = rotation[node].inverse().to_rotation_matrix();
                if want.force {
                    turn_triple(&mut response.force, k + i, back.matrix());
                }
                if want.tangent {
                    turn_rows_and_columns(&mut response.tangent, k + i, back.matrix());
                }
            }
        }
        k += element.dofs(a).len();
    }
}

/// What the elements of one evaluation share at the nodes.
pub(super) struct Nodes {
    /// Global components of the displacements.
    pub(super) values: Vec<[f64; KINDS]>,
    /// F Rᵀ: from global components of a rotation to those along the frame, which turns with the node ([`turn_back`]).
    spins: Vec<Option<Matrix3<f64>>>,
}

impl Nodes {
    pub(super) fn new(model: &Model, fields: &Fields) -> Nodes {
        let count = model.nodes().len();
        let spin = |node: usize| {
            let (frame, rotation) = (model.rotation_frame(node)?, &fields.rotation[node]);
            Some(match rotation.imag() == Vector3::zeros() {
                true => *frame,
                false => frame * rotation.inverse().to_rotation_matrix().matrix(),
            })
        };
        Nodes {
            values: (0..count).map(|node| model.at_node(&fields.u, node)).collect(),
            spins: (0..count).map(spin).collect(),
        }
    }

    /// Response of an element along the axes of the unknowns, as they have turned with the nodes.
    pub(super) fn turn(&self, model: &Model, element: &dyn Element, want: Want, response: &mut Response) {
        let mut k = 0;
        for (a, &node) in element.nodes().iter().enumerate() {
            for (i, &dof) in element.dofs(a).iter().enumerate() {
                let frame = match dof {
                    Dof::Ux => model.frame(node),
                    Dof::Rx => self.spins[node].as_ref(),
                    _ => None,
                };
                if let Some(frame) = frame {
                    if want.force {
                        turn_triple(&mut response.force, k + i, frame);
                    }
                    if want.tangent {
                        turn_rows_and_columns(&mut response.tangent, k + i, frame);
                    }
                }
            }
            k += element.dofs(a).len();
        }
    }
}

/// Calls `turn(first local dof, frame)` for every triple of dofs that has a frame.
fn triples(model: &Model, element: &dyn Element, mut turn: impl FnMut(usize, &Matrix3<f64>)) {
    let mut k = 0;
    for (a, &node) in element.nodes().iter().enumerate() {
        for (i, &dof) in element.dofs(a).iter().enumerate() {
            let frame = match dof {
                Dof::Ux => model.frame(node),
                Dof::Rx => model.rotation_frame(node),
                _ => None,
            };
            if let Some(frame) = frame {
                debug_assert!(element.dofs(a).len() >= i + 3, "vector dofs come in triples");
                turn(k + i, frame);
            }
        }
        k += element.dofs(a).len();
    }
}

/// A ← T A Tᵀ with the frames of the nodes.
pub(super) fn turn_matrix(model: &Model, element: &dyn Element, local: &mut LocalMatrix) {
    triples(model, element, |first, f| turn_rows_and_columns(local, first, f));
}

/// v ← T v with the frames of the nodes.
pub(super) fn turn_vector(model: &Model, element: &dyn Element, local: &mut [f64]) {
    triples(model, element, |first, f| turn_triple(local, first, f));
}

/// A ← T A Tᵀ with T = f for three dofs from `first` on.
fn turn_rows_and_columns(local: &mut LocalMatrix, first: usize, f: &Matrix3<f64>) {
    let n = local.n;
    for j in 0..n {
        let old = [0, 1, 2].map(|k| local.get(first + k, j));
        for i in 0..3 {
            local.data[first + i + j * n] = (0..3).map(|k| f[(i, k)] * old[k]).sum();
        }
    }
    for i in 0..n {
        let old = [0, 1, 2].map(|k| local.get(i, first + k));
        for j in 0..3 {
            local.data[i + (first + j) * n] = (0..3).map(|k| f[(j, k)] * old[k]).sum();
        }
    }
}

/// v ← T v with T = f for three dofs from `first` on.
fn turn_triple(local: &mut [f64], first: usize, f: &Matrix3<f64>) {
    let old = [local[first], local[first + 1], local[first + 2]];
    for i in 0..3 {
        local[first + i] = (0..3).map(|k| f[(i, k)] * old[k]).sum();
    }
}
