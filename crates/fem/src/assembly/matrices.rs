//! Matrices and vectors of the reference state.

use std::ops::Range;

use nalgebra::UnitQuaternion;

use super::turn::{turn_matrix, turn_vector};
use super::{Assembler, HALVED, NONE, local_values};
use crate::dofs::KINDS;
use crate::element::{
    Element, ElementError, LocalMatrix, Motion, Response, Trial, Want, local_size, reference_stiffness,
};
use crate::linalg::Symmetric;
use crate::model::Model;

/// Where the entries of a matrix are added: places `start ..` in `head`, places `border ..` in `tail`.
pub(super) struct Sink<'a> {
    head: &'a mut [f64],
    start: usize,
    tail: &'a mut [f64],
    border: usize,
}

impl<'a> Sink<'a> {
    /// All places of a matrix.
    pub(super) fn whole(values: &'a mut [f64]) -> Sink<'a> {
        Sink { border: values.len(), head: values, start: 0, tail: &mut [] }
    }

    #[inline]
    fn add(&mut self, place: usize, value: f64) {
        if place < self.border {
            self.head[place - self.start] += value;
        } else {
            self.tail[place - self.border] += value;
        }
    }
}

impl Assembler {
    /// Adds the matrix of element `e`, given in global components.
    pub(super) fn scatter(&self, model: &Model, e: usize, local: &mut LocalMatrix, sink: &mut Sink<'_>) {
        if self.turned[e] {
            turn_matrix(model, &*model.elements()[e], local);
        }
        self.place(e, &local.data, sink);
    }

    /// Adds the matrix of element `e`, given along the axes of the unknowns.
    pub(super) fn place(&self, e: usize, local: &[f64], sink: &mut Sink<'_>) {
        let places = &self.places[self.place_starts[e]..self.place_starts[e + 1]];
        for (&place, &value) in places.iter().zip(local) {
            if place != NONE {
                sink.add(place as usize, value);
            }
        }
    }

    /// Adds the vector of element `e`, given in global components.
    pub(super) fn scatter_vector(&self, model: &Model, e: usize, local: &mut [f64], out: &mut [f64]) {
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
    pub fn stiffness_of(&self, model: &Model, which: impl Fn(usize) -> bool + Sync) -> Result<Symmetric, ElementError> {
        let [stiffness] = self.gather(model, |e, work, [stiffness]| {
            if which(e) {
                self.scatter(model, e, work.stiffness(&*model.elements()[e])?, stiffness);
            }
            Ok(())
        })?;
        Ok(stiffness)
    }

    /// Tangent stiffness in the reference state.
    ///
    /// Errors: those of the elements.
    pub fn stiffness(&self, model: &Model) -> Result<Symmetric, ElementError> {
        self.stiffness_of(model, |_| true)
    }

    /// Mass matrix of the elements for which `which(element number)` holds.
    pub fn mass_of(&self, model: &Model, which: impl Fn(usize) -> bool + Sync) -> Symmetric {
        let gathered = self.gather(model, |e, work, [mass]| {
            let element = &*model.elements()[e];
            if which(e) && element.has_mass() {
                self.scatter(model, e, work.mass(element), mass);
            }
            Ok(())
        });
        let [mass] = gathered.expect("a mass matrix cannot fail");
        mass
    }

    /// Mass matrix.
    pub fn mass(&self, model: &Model) -> Symmetric {
        self.mass_of(model, |_| true)
    }

    /// Stiffness and mass matrix, in one sweep over the elements.
    ///
    /// Errors: those of the elements.
    pub fn stiffness_and_mass(&self, model: &Model) -> Result<(Symmetric, Symmetric), ElementError> {
        let [stiffness, mass] = self.gather(model, |e, work, [stiffness, mass]| {
            let element = &*model.elements()[e];
            self.scatter(model, e, work.stiffness(element)?, stiffness);
            if element.has_mass() {
                self.scatter(model, e, work.mass(element), mass);
            }
            Ok(())
        })?;
        Ok((stiffness, mass))
    }

    /// Geometric stiffness of the linear solution `u`: buckling at λ times its load, (K + λ K_G) φ = 0.
    ///
    /// Errors: those of the elements.
    pub fn geometric_stiffness(&self, model: &Model, u: &[f64]) -> Result<Symmetric, ElementError> {
        let mut out = Symmetric::zeros(self.pattern.clone());
        let mut local = LocalMatrix::default();
        for (e, element) in model.elements().iter().enumerate() {
            if let Some(slender) = element.buckling() {
                local.reset(local_size(&**element));
                slender.geometric_stiffness(&local_values(model, &**element, u), &mut local)?;
                self.scatter(model, e, &mut local, &mut Sink::whole(&mut out.values));
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
            let force = reference_stiffness(&**element)?.to_matrix().times(&local_values(model, &**element, u));
            let mut k = 0;
            for (a, &node) in element.nodes().iter().enumerate() {
                let mut at = [0.0; KINDS];
                for dof in element.dofs(a) {
                    at[dof.index()] = force[k];
                    k += 1;
                }
                if element.own_axes() {
                    at = model.to_global(node, at);
                }
                for (sum, f) in out[node].iter_mut().zip(at) {
                    *sum += f;
                }
            }
        }
        Ok(out)
    }

    /// Calls `add(element, working space, N matrices)` for every element. Large models are cut in two halves that run side by
    /// side: each writes to its own part of the values, the second to a copy of the shared part. The halves are the
    /// same on every machine, so that the sums are, to the last digit.
    fn gather<const N: usize>(
        &self,
        model: &Model,
        add: impl Fn(usize, &mut Work, &mut [Sink<'_>; N]) -> Result<(), ElementError> + Sync,
    ) -> Result<[Symmetric; N], ElementError> {
        let count = model.elements().len();
        let run = |range: Range<usize>, mut sinks: [Sink<'_>; N]| -> Result<(), ElementError> {
            let mut work = Work::default();
            let mut assembled = range.into_iter().filter(|e| !self.unassembled[*e]);
            assembled.try_for_each(|e| add(e, &mut work, &mut sinks))
        };
        let mut values: [Vec<f64>; N] = std::array::from_fn(|_| vec![0.0; self.pattern.places()]);
        if count < HALVED {
            run(0..count, values.each_mut().map(|v| Sink::whole(v)))?;
        } else {
            let Range { start, end } = self.shared;
            let mut copies: [Vec<f64>; N] = std::array::from_fn(|_| vec![0.0; end - start]);
            let mut tails = copies.each_mut().map(|copy| Sink { head: copy, start, tail: &mut [], border: end });
            let mut tail = tails.iter_mut();
            let heads = values.each_mut().map(|v| {
                let (head, rest) = v.split_at_mut(end);
                if let Some(sink) = tail.next() {
                    sink.tail = rest;
                }
                Sink::whole(head)
            });
            let (first, second) = rayon::join(|| run(0..count / 2, heads), || run(count / 2..count, tails));
            first.and(second)?;
            for (sum, copy) in values.iter_mut().zip(&copies) {
                for (a, b) in sum[start..end].iter_mut().zip(copy) {
                    *a += b;
                }
            }
        }
        Ok(values.map(|values| Symmetric { pattern: self.pattern.clone(), values }))
    }

    /// Sum of the elements' own damping matrices.
    pub fn damping(&self, model: &Model) -> Symmetric {
        let mut out = Symmetric::zeros(self.pattern.clone());
        let mut local = LocalMatrix::default();
        for (e, element) in model.elements().iter().enumerate() {
            if let Some(operator) = element.operator() {
                self.add_diagonal_damping(e, operator, &mut out);
                continue;
            }
            local.reset(local_size(&**element));
            if element.damping(&mut local) {
                self.scatter(model, e, &mut local, &mut Sink::whole(&mut out.values));
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
        each_inertia(model, field, |e, product| self.scatter_vector(model, e, product, &mut out));
        out
    }

    /// wᵀ M x of two fields given at every node in global components, held dofs included on both sides.
    pub fn inertia_between(
        &self,
        model: &Model,
        virtual_field: impl Fn(usize) -> [f64; KINDS],
        field: impl Fn(usize) -> [f64; KINDS],
    ) -> f64 {
        let mut sum = 0.0;
        let mut values = Vec::new();
        each_inertia(model, field, |e, product| {
            local_field(model, &*model.elements()[e], &virtual_field, &mut values);
            sum += values.iter().zip(&*product).map(|(w, f)| w * f).sum::<f64>();
        });
        sum
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
}

/// Local vector of a field given at every node in global components.
fn local_field(model: &Model, element: &dyn Element, field: &impl Fn(usize) -> [f64; KINDS], values: &mut Vec<f64>) {
    values.clear();
    for (a, &node) in element.nodes().iter().enumerate() {
        let global = field(node);
        values.extend(element.dofs(a).iter().map(|&d| match element.own_axes() {
            true => model.component(node, d, &global),
            false => global[d.index()],
        }));
    }
}

/// Shows M_e x of every element with a mass.
fn each_inertia(model: &Model, field: impl Fn(usize) -> [f64; KINDS], mut see: impl FnMut(usize, &mut [f64])) {
    let mut mass = LocalMatrix::default();
    let (mut values, mut product) = (Vec::new(), Vec::new());
    for (e, element) in model.elements().iter().enumerate().filter(|(_, element)| element.has_mass()) {
        local_field(model, &**element, &field, &mut values);
        product.clear();
        product.resize(values.len(), 0.0);
        if let Some(operator) = element.operator() {
            operator.add_mass(1.0, &values, &mut product);
            see(e, &mut product);
            continue;
        }
        mass.reset(values.len());
        element.mass(&mut mass);
        for (column, &x) in mass.data.chunks_exact(values.len()).zip(&values) {
            if x != 0.0 {
                product.iter_mut().zip(column).for_each(|(y, a)| *y += a * x);
            }
        }
        see(e, &mut product);
    }
}

/// Room for one element's matrices, reused from element to element.
#[derive(Default)]
pub(super) struct Work {
    response: Response,
    mass: LocalMatrix,
    values: Vec<f64>,
    rotations: Vec<UnitQuaternion<f64>>,
    old: Vec<f64>,
    new: Vec<f64>,
}

impl Work {
    /// Stiffness of an element at rest in its reference state.
    pub(super) fn stiffness(&mut self, element: &dyn Element) -> Result<&mut LocalMatrix, ElementError> {
        let (n, history) = (local_size(element), element.history_len());
        self.response.reset(n);
        self.values.resize(n, 0.0);
        self.rotations.resize(element.nodes().len(), UnitQuaternion::identity());
        self.old.clear();
        self.old.resize(history, 0.0);
        element.init_history(&mut self.old);
        self.new.clone_from(&self.old);
        let rest = Motion { values: &self.values, rotations: &self.rotations };
        element.respond(
            Trial { motion: rest, old: &self.old, new: &mut self.new, want: Want::TANGENT },
            &mut self.response,
        )?;
        Ok(&mut self.response.tangent)
    }

    /// Mass matrix of an element.
    pub(super) fn mass(&mut self, element: &dyn Element) -> &mut LocalMatrix {
        self.mass.reset(local_size(element));
        element.mass(&mut self.mass);
        &mut self.mass
    }
}
