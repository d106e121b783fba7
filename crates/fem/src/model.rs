//! The model: nodes, elements, supports, frames and groups. Built once by [`Builder`], then read-only.
//!
//! A node may have a **frame**: its displacement unknowns are then the components along the frame's axes, which makes
//! supports in oblique directions (a rigid cylindrical wall) plain supports. It may have a **rotation frame** as well,
//! whose third axis is the director of a smooth shell node: holding [`Dof::Rz`] there leaves the five parameters of the
//! shell. Elements never see frames.

use std::collections::BTreeMap;

use nalgebra::Matrix3;

use crate::dofs::{Dof, DofMap, KINDS};
use crate::element::Element;
use crate::ring::NodeRings;

/// Number of a group of elements.
pub type GroupId = usize;

/// Failure while a model is built.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
pub enum ModelError {
    /// An element names a node that does not exist.
    #[error("element {element} ({kind}) names node {node}, but there are {nodes} nodes")]
    Node {
        /// Number of the element.
        element: usize,
        /// Its kind.
        kind: &'static str,
        /// Node named.
        node: usize,
        /// Number of nodes.
        nodes: usize,
    },
    /// The model has no unknown.
    #[error("the model has no unknowns: every dof is held, or there are no elements")]
    NoUnknown,
    /// A coordinate that is not a number.
    #[error("node {node}: coordinate {value} is not finite")]
    Coordinate {
        /// Number of the node.
        node: usize,
        /// Value.
        value: f64,
    },
}

/// Nodes, elements and supports while they are gathered.
#[derive(Default)]
pub struct Builder {
    nodes: Vec<[f64; 3]>,
    elements: Vec<Box<dyn Element>>,
    group_of: Vec<GroupId>,
    groups: Vec<String>,
    held: Vec<[bool; KINDS]>,
    frames: BTreeMap<usize, Matrix3<f64>>,
    rotation_frames: BTreeMap<usize, Matrix3<f64>>,
    rings: Option<NodeRings>,
}

impl Builder {
    /// An empty model.
    pub fn new() -> Builder {
        Builder::default()
    }

    /// Adds a node at a global Cartesian position [m]; returns its number.
    pub fn node(&mut self, position: [f64; 3]) -> usize {
        self.nodes.push(position);
        self.held.push([false; KINDS]);
        self.nodes.len() - 1
    }

    /// Adds nodes; returns the number of the first.
    pub fn nodes(&mut self, positions: &[[f64; 3]]) -> usize {
        let first = self.nodes.len();
        for &p in positions {
            self.node(p);
        }
        first
    }

    /// Position of a node that was added [m].
    pub fn position(&self, node: usize) -> [f64; 3] {
        self.nodes[node]
    }

    /// Adds an element to the group called `group`; returns its number.
    pub fn element(&mut self, group: &str, element: impl Element + 'static) -> usize {
        let id = match self.groups.iter().position(|g| g == group) {
            Some(id) => id,
            None => {
                self.groups.push(group.to_owned());
                self.groups.len() - 1
            }
        };
        self.elements.push(Box::new(element));
        self.group_of.push(id);
        self.elements.len() - 1
    }

    /// Numbers of nodes and elements so far.
    pub fn counts(&self) -> [usize; 2] {
        [self.nodes.len(), self.elements.len()]
    }

    /// Holds a dof of a node at zero.
    pub fn hold(&mut self, node: usize, dof: Dof) {
        self.held[node][dof.index()] = true;
    }

    /// Displacement unknowns of `node` along the rows of `frame` (orthonormal, global components).
    pub fn frame(&mut self, node: usize, frame: Matrix3<f64>) {
        self.frames.insert(node, frame);
    }

    /// Rotation unknowns of `node` along the rows of `frame`; the third row is the director. Under finite rotations the
    /// frame turns with the node.
    pub fn rotation_frame(&mut self, node: usize, frame: Matrix3<f64>) {
        self.rotation_frames.insert(node, frame);
    }

    /// Names the rings on which all nodes with displacements lie. Analyses that use them find unknowns on other nodes.
    pub fn rings(&mut self, rings: NodeRings) {
        self.rings = Some(rings);
    }

    /// Checks and numbers the model.
    ///
    /// Errors: an element with an unknown node, a coordinate that is not finite, no unknown at all.
    pub fn build(self) -> Result<Model, ModelError> {
        for (node, position) in self.nodes.iter().enumerate() {
            if let Some(&value) = position.iter().find(|v| !v.is_finite()) {
                return Err(ModelError::Coordinate { node, value });
            }
        }
        let mut used = vec![[false; KINDS]; self.nodes.len()];
        for (number, element) in self.elements.iter().enumerate() {
            for (a, &node) in element.nodes().iter().enumerate() {
                let Some(row) = used.get_mut(node) else {
                    let (kind, nodes) = (element.kind(), self.nodes.len());
                    return Err(ModelError::Node { element: number, kind, node, nodes });
                };
                for dof in element.dofs(a) {
                    row[dof.index()] = true;
                }
            }
        }
        let dofs = DofMap::new(&used, &self.held);
        if dofs.is_empty() {
            return Err(ModelError::NoUnknown);
        }
        let by_node = |frames: &BTreeMap<usize, Matrix3<f64>>| {
            (0..self.nodes.len()).map(|node| frames.get(&node).copied()).collect()
        };
        Ok(Model {
            frames: by_node(&self.frames),
            rotation_frames: by_node(&self.rotation_frames),
            nodes: self.nodes,
            elements: self.elements,
            group_of: self.group_of,
            groups: self.groups,
            held: self.held,
            rings: self.rings,
            dofs,
        })
    }
}

/// A complete model.
pub struct Model {
    nodes: Vec<[f64; 3]>,
    elements: Vec<Box<dyn Element>>,
    group_of: Vec<GroupId>,
    groups: Vec<String>,
    held: Vec<[bool; KINDS]>,
    frames: Vec<Option<Matrix3<f64>>>,
    rotation_frames: Vec<Option<Matrix3<f64>>>,
    rings: Option<NodeRings>,
    dofs: DofMap,
}

impl Model {
    /// Positions of the nodes [m].
    pub fn nodes(&self) -> &[[f64; 3]] {
        &self.nodes
    }

    /// The elements.
    pub fn elements(&self) -> &[Box<dyn Element>] {
        &self.elements
    }

    /// Group of element `e`.
    pub fn group_of(&self, e: usize) -> GroupId {
        self.group_of[e]
    }

    /// Names of the groups, by number.
    pub fn groups(&self) -> &[String] {
        &self.groups
    }

    /// Number of the group called `name`.
    pub fn group(&self, name: &str) -> Option<GroupId> {
        self.groups.iter().position(|g| g == name)
    }

    /// The numbering of the unknowns.
    pub fn dofs(&self) -> &DofMap {
        &self.dofs
    }

    /// Whether a support holds a dof.
    pub fn is_held(&self, node: usize, dof: Dof) -> bool {
        self.held[node][dof.index()]
    }

    /// Frame of the displacement unknowns of `node`, if not the global axes; rows are the axes.
    pub fn frame(&self, node: usize) -> Option<&Matrix3<f64>> {
        self.frames[node].as_ref()
    }

    /// Frame of the rotation unknowns of `node`, if not the global axes; rows are the axes.
    pub fn rotation_frame(&self, node: usize) -> Option<&Matrix3<f64>> {
        self.rotation_frames[node].as_ref()
    }

    /// Rings on which the nodes lie, if they were named.
    pub fn rings(&self) -> Option<&NodeRings> {
        self.rings.as_ref()
    }

    /// The unknowns under a field given at every node: displacement, rotation (global components), potential, elevation,
    /// amplitude.
    ///
    /// Rigid translation along x: `|_| [1.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0]`.
    pub fn vector(&self, field: impl Fn(usize) -> [f64; KINDS]) -> Vec<f64> {
        (0..self.dofs.len())
            .map(|e| {
                let (node, dof) = self.dofs.unknown(e);
                self.component(node, dof, &field(node))
            })
            .collect()
    }

    /// Component along an unknown's axis of global components at a node.
    pub(crate) fn component(&self, node: usize, dof: Dof, global: &[f64; KINDS]) -> f64 {
        let i = dof.index();
        let along = |frame: Option<&Matrix3<f64>>, first: usize| match frame {
            Some(f) => (0..3).map(|j| f[(i - first, j)] * global[first + j]).sum(),
            None => global[i],
        };
        match i {
            0..3 => along(self.frame(node), 0),
            3..6 => along(self.rotation_frame(node), 3),
            _ => global[i],
        }
    }

    /// Components along the unknowns' own axes at `node` of a vector of unknowns; held and unused dofs are zero.
    pub fn own_at_node(&self, x: &[f64], node: usize) -> [f64; KINDS] {
        let mut own = [0.0; KINDS];
        for dof in Dof::ALL {
            if let Some(e) = self.dofs.equation(node, dof) {
                own[dof.index()] = x[e];
            }
        }
        own
    }

    /// Global components at `node` of a vector of unknowns; held and unused dofs are zero.
    pub fn at_node(&self, x: &[f64], node: usize) -> [f64; KINDS] {
        self.to_global(node, self.own_at_node(x, node))
    }

    /// Global components at `node` of components along the unknowns' own axes.
    pub fn to_global(&self, node: usize, own: [f64; KINDS]) -> [f64; KINDS] {
        let mut global = own;
        for (frame, first) in [(self.frame(node), 0), (self.rotation_frame(node), 3)] {
            if let Some(f) = frame {
                for j in 0..3 {
                    global[first + j] = (0..3).map(|i| f[(i, j)] * own[first + i]).sum();
                }
            }
        }
        global
    }

    /// Row over the unknowns of the global component `dof` at `node`: (equation, coefficient).
    pub fn row(&self, node: usize, dof: Dof) -> Vec<(usize, f64)> {
        let i = dof.index();
        let (frame, first) = match i {
            0..3 => (self.frame(node), 0),
            3..6 => (self.rotation_frame(node), 3),
            _ => (None, 0),
        };
        match frame {
            Some(f) => (0..3)
                .filter_map(|k| Some((self.dofs.equation(node, Dof::ALL[first + k])?, f[(k, i - first)])))
                .filter(|&(_, c)| c != 0.0)
                .collect(),
            None => self.dofs.equation(node, dof).map(|e| (e, 1.0)).into_iter().collect(),
        }
    }

    /// Spreads a row over an element's local dofs to the unknowns.
    pub fn spread(&self, element: &dyn Element, local: &[f64]) -> BTreeMap<usize, f64> {
        let mut out = BTreeMap::new();
        let mut k = 0;
        for (a, &node) in element.nodes().iter().enumerate() {
            for &dof in element.dofs(a) {
                let row = match element.own_axes() {
                    true => self.dofs.equation(node, dof).map(|e| (e, 1.0)).into_iter().collect(),
                    false => self.row(node, dof),
                };
                for (e, c) in row {
                    *out.entry(e).or_insert(0.0) += c * local[k];
                }
                k += 1;
            }
        }
        out
    }
}
