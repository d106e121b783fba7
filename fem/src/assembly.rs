//! Global matrices and vectors from those of the elements: the pattern and every element's places are found once.

use std::sync::Arc;

use nalgebra::{Matrix3, UnitQuaternion, Vector3};

use crate::dofs::{Dof, KINDS};
use crate::element::{Element, ElementError, LocalMatrix, Motion, Response, Want, local_size, reference_stiffness};
use crate::linalg::{Ordering, Pattern, Symmetric};
use crate::model::Model;
use crate::state::{Gather, State};

/// Marks local dofs and entries that go nowhere.
const NONE: u32 = u32::MAX;

/// Pattern of a model's matrices and, element by element, the places of its entries.
pub struct Assembler {
    pattern: Arc<Pattern>,
    /// Equations of the local dofs (of the node's frame), element after element; [`NONE`] if held.
    equations: Vec<u32>,
    equation_starts: Vec<usize>,
    /// Places of the local entries of the lower triangle (by equation), element after element.
    places: Vec<u32>,
    place_starts: Vec<usize>,
    /// Elements with a node that has a frame.
    turned: Vec<bool>,
}

impl Assembler {
    /// Finds pattern and places.
    pub fn new(model: &Model) -> Assembler {
        let dofs = model.dofs();
        let (mut equations, mut equation_starts) = (Vec::new(), vec![0]);
        let mut turned = Vec::new();
        for element in model.elements() {
            let mut any = false;
            for (a, &node) in element.nodes().iter().enumerate() {
                any |= model.frame(node).is_some() || model.rotation_frame(node).is_some();
                for &dof in element.dofs(a) {
                    equations.push(dofs.equation(node, dof).map_or(NONE, |e| e as u32));
                }
            }
            turned.push(any);
            equation_starts.push(equations.len());
        }
        let cliques: Vec<Vec<usize>> = equation_starts
            .windows(2)
            .map(|w| {
                let own = &equations[w[0]..w[1]];
                let mut clique: Vec<usize> = own.iter().filter(|&&e| e != NONE).map(|&e| e as usize).collect();
                clique.sort_unstable();
                clique.dedup();
                clique
            })
            .collect();
        let pattern = Pattern::from_cliques(dofs.len(), cliques.iter().map(Vec::as_slice));
        let (mut places, mut place_starts) = (Vec::new(), vec![0]);
        for w in equation_starts.windows(2) {
            let own = &equations[w[0]..w[1]];
            for &j in own {
                for &i in own {
                    let place = if i == NONE || j == NONE || i < j {
                        NONE
                    } else {
                        let found = pattern.place(i as usize, j as usize);
                        found.expect("the pattern holds every element's entries") as u32
                    };
                    places.push(place);
                }
            }
            place_starts.push(places.len());
        }
        Assembler {
            pattern: Arc::new(pattern),
            equations,
            equation_starts,
            places,
            place_starts,
            turned,
        }
    }

    /// The pattern of all matrices of the model.
    pub fn pattern(&self) -> &Arc<Pattern> {
        &self.pattern
    }

    /// Adds the matrix of element `e`, given in global components.
    fn scatter(&self, model: &Model, e: usize, local: &mut LocalMatrix, values: &mut [f64]) {
        if self.turned[e] {
            turn_matrix(model, &*model.elements()[e], local);
        }
        let places = &self.places[self.place_starts[e]..self.place_starts[e + 1]];
        for (&place, &value) in places.iter().zip(&local.data) {
            if place != NONE {
                values[place as usize] += value;
            }
        }
    }

    /// Adds the vector of element `e`, given in global components.
    fn scatter_vector(&self, model: &Model, e: usize, local: &mut [f64], out: &mut [f64]) {
        if self.turned[e] {
            turn_vector(model, &*model.elements()[e], local);
        }
        let equations = &self.equations[self.equation_starts[e]..self.equation_starts[e + 1]];
        for (&equation, &value) in equations.iter().zip(local.iter()) {
            if equation != NONE {
                out[equation as usize] += value;
            }
        }
    }

    /// Tangent stiffness in the reference state, of the elements for which `which(element number)` holds.
    ///
    /// Errors: those of the elements.
    pub fn stiffness_of(&self, model: &Model, which: impl Fn(usize) -> bool) -> Result<Symmetric, ElementError> {
        let mut out = Symmetric::zeros(self.pattern.clone());
        for (e, element) in model.elements().iter().enumerate() {
            if which(e) {
                let mut local = reference_stiffness(&**element)?;
                self.scatter(model, e, &mut local, &mut out.values);
            }
        }
        Ok(out)
    }

    /// Tangent stiffness in the reference state.
    ///
    /// Errors: those of the elements.
    pub fn stiffness(&self, model: &Model) -> Result<Symmetric, ElementError> {
        self.stiffness_of(model, |_| true)
    }

    /// Mass matrix of the elements for which `which(element number)` holds.
    pub fn mass_of(&self, model: &Model, which: impl Fn(usize) -> bool) -> Symmetric {
        let mut out = Symmetric::zeros(self.pattern.clone());
        let mut local = LocalMatrix::default();
        for (e, element) in model.elements().iter().enumerate() {
            if which(e) && element.has_mass() {
                local.reset(local_size(&**element));
                element.mass(&mut local);
                self.scatter(model, e, &mut local, &mut out.values);
            }
        }
        out
    }

    /// Mass matrix.
    pub fn mass(&self, model: &Model) -> Symmetric {
        self.mass_of(model, |_| true)
    }

    /// Geometric stiffness of the linear solution `u`: buckling at λ times its load, (K + λ K_G) φ = 0.
    ///
    /// Errors: those of the elements.
    pub fn geometric_stiffness(&self, model: &Model, u: &[f64]) -> Result<Symmetric, ElementError> {
        let mut out = Symmetric::zeros(self.pattern.clone());
        let mut local = LocalMatrix::default();
        for (e, element) in model.elements().iter().enumerate() {
            local.reset(local_size(&**element));
            if element.geometric_stiffness(&local_values(model, &**element, u), &mut local)? {
                self.scatter(model, e, &mut local, &mut out.values);
            }
        }
        Ok(out)
    }

    /// Forces K_e u_e that the elements for which `which(element number)` holds put up at every node, held or not,
    /// under the linear solution `u`; global components. Reaction of a support: this less the load applied there.
    ///
    /// Errors: those of the elements.
    pub fn nodal_forces(
        &self,
        model: &Model,
        u: &[f64],
        which: impl Fn(usize) -> bool,
    ) -> Result<Vec<[f64; KINDS]>, ElementError> {
        let mut out = vec![[0.0; KINDS]; model.nodes().len()];
        for (_, element) in model.elements().iter().enumerate().filter(|(e, _)| which(*e)) {
            let force = reference_stiffness(&**element)?
                .to_matrix()
                .times(&local_values(model, &**element, u));
            let mut k = 0;
            for (a, &node) in element.nodes().iter().enumerate() {
                for dof in element.dofs(a) {
                    out[node][dof.index()] += force[k];
                    k += 1;
                }
            }
        }
        Ok(out)
    }

    /// Sum of the elements' own damping matrices.
    pub fn damping(&self, model: &Model) -> Symmetric {
        let mut out = Symmetric::zeros(self.pattern.clone());
        let mut local = LocalMatrix::default();
        for (e, element) in model.elements().iter().enumerate() {
            local.reset(local_size(&**element));
            if element.damping(&mut local) {
                self.scatter(model, e, &mut local, &mut out.values);
            }
        }
        out
    }

    /// M x of a field given at every node in global components, **held dofs included**.
    ///
    /// With a rigid translation this is the load −f/a_g of a ground motion: it holds the inertia that joins the unknowns
    /// to held nodes (a clamped edge, a rigid wetted wall), which M times a vector of unknowns lacks.
    pub fn inertia(&self, model: &Model, field: impl Fn(usize) -> [f64; KINDS]) -> Vec<f64> {
        let mut out = vec![0.0; model.dofs().len()];
        let mut mass = LocalMatrix::default();
        let (mut values, mut product) = (Vec::new(), Vec::new());
        for (e, element) in model.elements().iter().enumerate() {
            if !element.has_mass() {
                continue;
            }
            values.clear();
            for (a, &node) in element.nodes().iter().enumerate() {
                let global = field(node);
                values.extend(element.dofs(a).iter().map(|d| global[d.index()]));
            }
            mass.reset(values.len());
            element.mass(&mut mass);
            product.clear();
            product.resize(values.len(), 0.0);
            for (column, &x) in mass.data.chunks_exact(values.len()).zip(&values) {
                if x != 0.0 {
                    for (y, a) in product.iter_mut().zip(column) {
                        *y += a * x;
                    }
                }
            }
            self.scatter_vector(model, e, &mut product, &mut out);
        }
        out
    }

    /// Nodal forces of a uniform acceleration field b [m/s²] (gravity: (0, 0, −g)).
    pub fn body_force(&self, model: &Model, acceleration: [f64; 3]) -> Vec<f64> {
        let mut out = vec![0.0; model.dofs().len()];
        let mut local = Vec::new();
        for (e, element) in model.elements().iter().enumerate() {
            local.clear();
            local.resize(local_size(&**element), 0.0);
            element.body_force(acceleration, &mut local);
            self.scatter_vector(model, e, &mut local, &mut out);
        }
        out
    }

    /// Internal force and, if wanted, tangent at the trial state; writes the trial history.
    ///
    /// Errors: the first element without an answer, with its number.
    pub fn respond(
        &self,
        model: &Model,
        state: &mut State,
        want: Want,
        tangent: &mut Symmetric,
    ) -> Result<Vec<f64>, (usize, ElementError)> {
        let mut force = vec![0.0; model.dofs().len()];
        if want.tangent {
            tangent.values.fill(0.0);
        }
        let mut gather = Gather::default();
        let mut response = Response::default();
        for (e, element) in model.elements().iter().enumerate() {
            response.reset(local_size(&**element));
            let range = state.history(e);
            let motion: Motion<'_> = gather.motion(model, &state.trial, &**element);
            element
                .respond(
                    motion,
                    &state.old[range.clone()],
                    &mut state.new[range],
                    want,
                    &mut response,
                )
                .map_err(|error| (e, error))?;
            if self.turned[e] {
                turn_back(model, &**element, &state.trial.rotation, want, &mut response);
            }
            if want.force {
                self.scatter_vector(model, e, &mut response.force, &mut force);
            }
            if want.tangent {
                self.scatter(model, e, &mut response.tangent, &mut tangent.values);
            }
        }
        Ok(force)
    }
}

/// Values of an element's dofs under the unknowns `u`, global components.
pub fn local_values(model: &Model, element: &dyn Element, u: &[f64]) -> Vec<f64> {
    let mut out = Vec::with_capacity(local_size(element));
    for (a, &node) in element.nodes().iter().enumerate() {
        let global = model.at_node(u, node);
        out.extend(element.dofs(a).iter().map(|d| global[d.index()]));
    }
    out
}

/// Order of elimination for the matrices of a model: nested dissection by the positions of its nodes, or minimum degree if
/// that is cheaper.
pub fn order(model: &Model, pattern: &Pattern) -> Ordering {
    let dofs = model.dofs();
    let node_of: Vec<usize> = (0..dofs.len()).map(|e| dofs.unknown(e).0).collect();
    Ordering::best(pattern, &node_of, model.nodes())
}

/// Turns rotational components back with their nodes where these have a rotation frame: the frame F turns with the
/// node, its rows are those of F Rᵀ, so that the third one stays the director of a smooth shell node.
fn turn_back(
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
fn turn_matrix(model: &Model, element: &dyn Element, local: &mut LocalMatrix) {
    triples(model, element, |first, f| turn_rows_and_columns(local, first, f));
}

/// v ← T v with the frames of the nodes.
fn turn_vector(model: &Model, element: &dyn Element, local: &mut [f64]) {
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
