//! Global matrices and vectors from those of the elements: the pattern and every element's places are found once.

use std::ops::Range;
use std::sync::Arc;

use nalgebra::{Matrix3, UnitQuaternion, Vector3};

use crate::dofs::{Dof, KINDS};
use crate::element::{Element, ElementError, LocalMatrix, Motion, Response, Want, local_size, reference_stiffness};
use crate::linalg::{Ordering, Pattern, Symmetric};
use crate::model::Model;
use crate::state::{Gather, State};

/// Marks local dofs and entries that go nowhere.
const NONE: u32 = u32::MAX;

/// Models with at least this many elements are assembled in two halves: below it a thread costs more than it saves.
const HALVED: usize = 2000;

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
    /// Elements whose force is K u in components that do not turn with the nodes.
    linear: Vec<bool>,
    /// Elements whose force is taken at the end of a time step; empty without any.
    at_end: Vec<bool>,
    /// Held dofs that some element uses, by node.
    supports: Vec<(usize, Dof)>,
    /// Number in `supports` of the local dofs, element after element; [`NONE`] if free.
    held: Vec<u32>,
    /// Places that both halves of the elements write to lie in this range.
    shared: Range<usize>,
}

/// Where the entries of a matrix are added: places `start ..` in `head`, places `border ..` in `tail`.
struct Sink<'a> {
    head: &'a mut [f64],
    start: usize,
    tail: &'a mut [f64],
    border: usize,
}

impl<'a> Sink<'a> {
    /// All places of a matrix.
    fn whole(values: &'a mut [f64]) -> Sink<'a> {
        Sink {
            border: values.len(),
            head: values,
            start: 0,
            tail: &mut [],
        }
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

/// Internal forces of a model.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Forces {
    /// Of the unknowns.
    pub internal: Vec<f64>,
    /// Of the held dofs, in the order of [`Assembler::supports`].
    pub support: Vec<f64>,
    /// Part of `internal` that time steps take at their end ([`acts_at_end`](crate::element::Contact::acts_at_end)); empty without such elements.
    pub at_end: Vec<f64>,
}

/// What an evaluation of all elements is asked for.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Ask<'a> {
    /// Force, tangent.
    pub want: Want,
    /// Stands for the linear elements.
    pub linear: Option<&'a LinearPart>,
    /// Factor on the tangents of elements that act at the end of a step.
    pub end_tangent: f64,
}

impl<'a> Ask<'a> {
    /// At one instant.
    pub fn now(want: Want, linear: Option<&'a LinearPart>) -> Ask<'a> {
        Ask {
            want,
            linear,
            end_tangent: 1.0,
        }
    }
}

/// What the elements keep from one iteration of a step to the next ([`respond_mixed`](crate::element::Mixed::respond_mixed)).
#[derive(Clone, Debug, PartialEq)]
pub struct Kept {
    values: Vec<f64>,
    /// Start of each element's part, with the total at the end.
    offsets: Vec<usize>,
}

impl Kept {
    /// Nothing yet.
    pub fn new(model: &Model) -> Kept {
        let mut offsets = vec![0];
        for element in model.elements() {
            offsets.push(offsets[offsets.len() - 1] + element.mixed().map_or(0, |mixed| mixed.mixed_len()));
        }
        Kept {
            values: vec![0.0; offsets[offsets.len() - 1]],
            offsets,
        }
    }

    /// Forgets the iterate before: a step begins.
    pub fn clear(&mut self) {
        self.values.fill(0.0);
    }

    fn of(&mut self, e: usize) -> &mut [f64] {
        &mut self.values[self.offsets[e]..self.offsets[e + 1]]
    }
}

/// Stiffness of the linear elements, assembled once for all steps.
#[derive(Clone, Debug)]
pub struct LinearPart {
    tangent: Symmetric,
    /// Rows of the held dofs: (support, unknown, coefficient).
    support: Vec<(u32, u32, f64)>,
}

impl Assembler {
    /// Finds pattern and places.
    pub fn new(model: &Model) -> Assembler {
        let dofs = model.dofs();
        let (mut equations, mut equation_starts) = (Vec::new(), vec![0]);
        let (mut turned, mut linear, mut held) = (Vec::new(), Vec::new(), Vec::new());
        let ends: Vec<bool> = model
            .elements()
            .iter()
            .map(|e| e.contact().is_some_and(|joint| joint.acts_at_end()))
            .collect();
        let mut supports: Vec<(usize, Dof)> = Vec::new();
        let mut number = std::collections::BTreeMap::new();
        for element in model.elements() {
            let (mut any, mut fixed) = (false, element.is_linear());
            for (a, &node) in element.nodes().iter().enumerate() {
                let framed = model.frame(node).is_some() || model.rotation_frame(node).is_some();
                any |= framed && !element.own_axes();
                for &dof in element.dofs(a) {
                    let equation = dofs.equation(node, dof);
                    equations.push(equation.map_or(NONE, |e| e as u32));
                    held.push(match equation {
                        Some(_) => NONE,
                        None => *number.entry((node, dof)).or_insert_with(|| {
                            supports.push((node, dof));
                            supports.len() as u32 - 1
                        }),
                    });
                    fixed &= dof != Dof::Rx || model.rotation_frame(node).is_none() || element.own_axes();
                }
            }
            turned.push(any);
            linear.push(fixed);
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
        let (first, second) = places.split_at(place_starts[(place_starts.len() - 1) / 2]);
        let end = first
            .iter()
            .filter(|&&p| p != NONE)
            .max()
            .map_or(0, |&p| p as usize + 1);
        let start = second.iter().min().map_or(end, |&p| (p as usize).min(end));
        Assembler {
            pattern: Arc::new(pattern),
            equations,
            equation_starts,
            places,
            place_starts,
            turned,
            linear,
            at_end: if ends.contains(&true) { ends } else { Vec::new() },
            supports,
            held,
            shared: start..end,
        }
    }

    /// Held dofs that some element uses, along the axes of their nodes.
    pub fn supports(&self) -> &[(usize, Dof)] {
        &self.supports
    }

    /// Whether some element's force is taken at the end of a time step.
    pub fn acts_at_end(&self) -> bool {
        !self.at_end.is_empty()
    }

    /// The pattern of all matrices of the model.
    pub fn pattern(&self) -> &Arc<Pattern> {
        &self.pattern
    }

    /// Adds the matrix of element `e`, given in global components.
    fn scatter(&self, model: &Model, e: usize, local: &mut LocalMatrix, sink: &mut Sink<'_>) {
        if self.turned[e] {
            turn_matrix(model, &*model.elements()[e], local);
        }
        let places = &self.places[self.place_starts[e]..self.place_starts[e + 1]];
        for (&place, &value) in places.iter().zip(&local.data) {
            if place != NONE {
                sink.add(place as usize, value);
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
            let force = reference_stiffness(&**element)?
                .to_matrix()
                .times(&local_values(model, &**element, u));
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
    /// side: each writes to its own part of the values, the second to a copy of what both write to. The halves are the
    /// same on every machine, so that the sums are, to the last digit.
    fn gather<const N: usize>(
        &self,
        model: &Model,
        add: impl Fn(usize, &mut Work, &mut [Sink<'_>; N]) -> Result<(), ElementError> + Sync,
    ) -> Result<[Symmetric; N], ElementError> {
        let count = model.elements().len();
        let run = |range: Range<usize>, mut sinks: [Sink<'_>; N]| -> Result<(), ElementError> {
            let mut work = Work::default();
            range.into_iter().try_for_each(|e| add(e, &mut work, &mut sinks))
        };
        let mut values: [Vec<f64>; N] = std::array::from_fn(|_| vec![0.0; self.pattern.places()]);
        if count < HALVED {
            run(0..count, values.each_mut().map(|v| Sink::whole(v)))?;
        } else {
            let Range { start, end } = self.shared;
            let mut copies: [Vec<f64>; N] = std::array::from_fn(|_| vec![0.0; end - start]);
            let mut tails = copies.each_mut().map(|copy| Sink {
                head: copy,
                start,
                tail: &mut [],
                border: end,
            });
            let mut tail = tails.iter_mut();
            let heads = values.each_mut().map(|v| {
                let (head, rest) = v.split_at_mut(end);
                if let Some(sink) = tail.next() {
                    sink.tail = rest;
                }
                Sink::whole(head)
            });
            std::thread::scope(|scope| {
                let second = scope.spawn(|| run(count / 2..count, tails));
                let first = run(0..count / 2, heads);
                let second = second.join().unwrap_or_else(|panic| std::panic::resume_unwind(panic));
                first.and(second)
            })?;
            for (sum, copy) in values.iter_mut().zip(&copies) {
                for (a, b) in sum[start..end].iter_mut().zip(copy) {
                    *a += b;
                }
            }
        }
        Ok(values.map(|values| Symmetric {
            pattern: self.pattern.clone(),
            values,
        }))
    }

    /// Sum of the elements' own damping matrices.
    pub fn damping(&self, model: &Model) -> Symmetric {
        let mut out = Symmetric::zeros(self.pattern.clone());
        let mut local = LocalMatrix::default();
        for (e, element) in model.elements().iter().enumerate() {
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
        let mut mass = LocalMatrix::default();
        let (mut values, mut product) = (Vec::new(), Vec::new());
        for (e, element) in model.elements().iter().enumerate() {
            if !element.has_mass() {
                continue;
            }
            values.clear();
            for (a, &node) in element.nodes().iter().enumerate() {
                let global = field(node);
                values.extend(element.dofs(a).iter().map(|&d| match element.own_axes() {
                    true => model.component(node, d, &global),
                    false => global[d.index()],
                }));
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

    /// Assembles the linear elements once for all.
    ///
    /// Errors: the first element without an answer, with its number.
    pub fn linear_part(&self, model: &Model) -> Result<LinearPart, (usize, ElementError)> {
        let mut out = LinearPart {
            tangent: Symmetric::zeros(self.pattern.clone()),
            support: Vec::new(),
        };
        let mut work = Work::default();
        for (e, element) in model.elements().iter().enumerate().filter(|(e, _)| self.linear[*e]) {
            let local = work.stiffness(&**element).map_err(|error| (e, error))?;
            self.scatter(model, e, local, &mut Sink::whole(&mut out.tangent.values));
            let range = self.equation_starts[e]..self.equation_starts[e + 1];
            let (equations, held) = (&self.equations[range.clone()], &self.held[range]);
            for (i, &support) in held.iter().enumerate().filter(|(_, s)| **s != NONE) {
                for (j, &equation) in equations.iter().enumerate() {
                    let value = local.get(i, j);
                    if equation != NONE && value != 0.0 {
                        out.support.push((support, equation, value));
                    }
                }
            }
        }
        Ok(out)
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
        let mut forces = Forces::default();
        self.respond_into(model, state, want, None, tangent, &mut forces)?;
        Ok(forces.internal)
    }

    /// The same by [`respond_mixed`](crate::element::Mixed::respond_mixed).
    ///
    /// Errors: those of [`Assembler::respond`].
    pub fn respond_mixed(
        &self,
        model: &Model,
        state: &mut State,
        want: Want,
        tangent: &mut Symmetric,
        kept: &mut Kept,
    ) -> Result<Vec<f64>, (usize, ElementError)> {
        let mut forces = Forces::default();
        self.answer(model, state, Ask::now(want, None), tangent, &mut forces, Some(kept))?;
        Ok(forces.internal)
    }

    /// The same with the forces at the supports, into storage that is kept; `linear` stands for the linear elements.
    ///
    /// Errors: the first element without an answer, with its number.
    pub fn respond_into(
        &self,
        model: &Model,
        state: &mut State,
        want: Want,
        linear: Option<&LinearPart>,
        tangent: &mut Symmetric,
        forces: &mut Forces,
    ) -> Result<(), (usize, ElementError)> {
        self.answer(model, state, Ask::now(want, linear), tangent, forces, None)
    }

    /// [`Assembler::respond_into`], by [`respond_mixed`](crate::element::Mixed::respond_mixed) if there is something `kept`.
    pub(crate) fn answer(
        &self,
        model: &Model,
        state: &mut State,
        ask: Ask<'_>,
        tangent: &mut Symmetric,
        forces: &mut Forces,
        mut kept: Option<&mut Kept>,
    ) -> Result<(), (usize, ElementError)> {
        let Ask { want, linear, .. } = ask;
        let Forces {
            internal,
            support,
            at_end,
        } = forces;
        let ends = !self.at_end.is_empty();
        for (out, len) in [
            (&mut *internal, model.dofs().len()),
            (&mut *support, self.supports.len()),
            (&mut *at_end, if ends { model.dofs().len() } else { 0 }),
        ] {
            out.clear();
            out.resize(len, 0.0);
        }
        match linear {
            Some(part) if want.tangent => tangent.values.copy_from_slice(&part.tangent.values),
            None if want.tangent => tangent.values.fill(0.0),
            _ => {}
        }
        if let (Some(part), true) = (linear, want.force) {
            part.tangent.add_product(1.0, &state.trial.u, internal);
            for &(s, e, k) in &part.support {
                support[s as usize] += k * state.trial.u[e as usize];
            }
        }
        let (mut gather, mut response) = (Gather::default(), Response::default());
        for (e, element) in model.elements().iter().enumerate() {
            if linear.is_some() && self.linear[e] {
                continue;
            }
            let dofs = self.equation_starts[e]..self.equation_starts[e + 1];
            response.reset(dofs.len());
            let range = state.history(e);
            let motion: Motion<'_> = match self.turned[e] {
                true => gather.motion(model, &state.trial, &**element),
                // Components are the unknowns themselves.
                false => {
                    let value = |&q: &u32| if q == NONE { 0.0 } else { state.trial.u[q as usize] };
                    gather.values(&state.trial, &**element, self.equations[dofs.clone()].iter().map(value))
                }
            };
            let (old, new) = (&state.old[range.clone()], &mut state.new[range]);
            match kept.as_deref_mut().and_then(|kept| Some((element.mixed()?, kept))) {
                Some((mixed, kept)) => mixed.respond_mixed(motion, old, new, want, kept.of(e), &mut response),
                None => element.respond(motion, old, new, want, &mut response),
            }
            .map_err(|error| (e, error))?;
            if self.turned[e] {
                turn_back(model, &**element, &state.trial.rotation, want, &mut response);
            }
            if want.force {
                self.scatter_vector(model, e, &mut response.force, internal);
                for (&s, f) in self.held[dofs].iter().zip(&response.force) {
                    if s != NONE {
                        support[s as usize] += f;
                    }
                }
            }
            if ends && self.at_end[e] {
                if want.force {
                    // Turned already.
                    let equations = self.equations[self.equation_starts[e]..self.equation_starts[e + 1]].iter();
                    for (&q, f) in equations.zip(&response.force).filter(|(q, _)| **q != NONE) {
                        at_end[q as usize] += f;
                    }
                }
                response.tangent.data.iter_mut().for_each(|k| *k *= ask.end_tangent);
            }
            if want.tangent {
                self.scatter(model, e, &mut response.tangent, &mut Sink::whole(&mut tangent.values));
            }
        }
        Ok(())
    }
}

impl Assembler {
    /// Adds Σ a_e K_e⁺ of the elements' tangents at the trial state, where K_e⁺ is the positive part of K_e and
    /// a_e = `factor(e)`.
    ///
    /// Errors: the first element without an answer, with its number.
    pub fn add_positive_tangent(
        &self,
        model: &Model,
        state: &State,
        factor: impl Fn(usize) -> f64,
        out: &mut Symmetric,
    ) -> Result<(), (usize, ElementError)> {
        let (mut gather, mut response) = (Gather::default(), Response::default());
        let mut new = Vec::new();
        for (e, element) in model.elements().iter().enumerate() {
            let a = factor(e);
            if a == 0.0 {
                continue;
            }
            response.reset(local_size(&**element));
            let old = &state.old[state.history(e)];
            new.clear();
            new.extend_from_slice(old);
            let motion = gather.motion(model, &state.trial, &**element);
            element
                .respond(motion, old, &mut new, Want::TANGENT, &mut response)
                .map_err(|error| (e, error))?;
            positive_part(&mut response.tangent);
            response.tangent.data.iter_mut().for_each(|k| *k *= a);
            if self.turned[e] {
                turn_back(model, &**element, &state.trial.rotation, Want::TANGENT, &mut response);
            }
            self.scatter(model, e, &mut response.tangent, &mut Sink::whole(&mut out.values));
        }
        Ok(())
    }
}

/// Leaves the eigenvalues ≥ 0 of a symmetric matrix.
fn positive_part(a: &mut LocalMatrix) {
    let n = a.n;
    let largest = a.data.iter().fold(0.0_f64, |m, v| m.max(v.abs()));
    let mut shifted = nalgebra::DMatrix::from_column_slice(n, n, &a.data);
    for i in 0..n {
        shifted[(i, i)] += 1e-9 * largest;
    }
    if shifted.clone().cholesky().is_some() {
        return;
    }
    let eigen = nalgebra::DMatrix::from_column_slice(n, n, &a.data).symmetric_eigen();
    let kept = eigen.eigenvalues.map(|l| l.max(0.0));
    let positive = &eigen.eigenvectors * nalgebra::DMatrix::from_diagonal(&kept) * eigen.eigenvectors.transpose();
    a.data.copy_from_slice(positive.as_slice());
}

/// Room for one element's matrices, reused from element to element.
#[derive(Default)]
struct Work {
    response: Response,
    mass: LocalMatrix,
    values: Vec<f64>,
    rotations: Vec<UnitQuaternion<f64>>,
    old: Vec<f64>,
    new: Vec<f64>,
}

impl Work {
    /// Stiffness of an element at rest in its reference state.
    fn stiffness(&mut self, element: &dyn Element) -> Result<&mut LocalMatrix, ElementError> {
        let (n, history) = (local_size(element), element.history_len());
        self.response.reset(n);
        self.values.resize(n, 0.0);
        self.rotations.resize(element.nodes().len(), UnitQuaternion::identity());
        self.old.clear();
        self.old.resize(history, 0.0);
        element.init_history(&mut self.old);
        self.new.clone_from(&self.old);
        let rest = Motion {
            values: &self.values,
            rotations: &self.rotations,
        };
        element.respond(rest, &self.old, &mut self.new, Want::TANGENT, &mut self.response)?;
        Ok(&mut self.response.tangent)
    }

    /// Mass matrix of an element.
    fn mass(&mut self, element: &dyn Element) -> &mut LocalMatrix {
        self.mass.reset(local_size(element));
        element.mass(&mut self.mass);
        &mut self.mass
    }
}

/// Values of an element's dofs under the unknowns `u`, in the components that the element knows.
pub fn local_values(model: &Model, element: &dyn Element, u: &[f64]) -> Vec<f64> {
    let mut out = Vec::with_capacity(local_size(element));
    for (a, &node) in element.nodes().iter().enumerate() {
        let at = match element.own_axes() {
            true => model.own_at_node(u, node),
            false => model.at_node(u, node),
        };
        out.extend(element.dofs(a).iter().map(|d| at[d.index()]));
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

#[cfg(test)]
mod tests {
    use super::*;
    use crate::element::reference_mass;
    use crate::element::solid8::{Elastic, Kinematics, Solid8};
    use crate::model::Builder;

    /// The matrices of a model large enough to be assembled in halves, times a vector, against the sum over the elements. With
    /// the elements in shuffled order both halves write everywhere.
    #[test]
    fn halves_add_up() {
        let n = 13;
        let node = |x: usize, y: usize, z: usize| x + (n + 1) * (y + (n + 1) * z);
        for stride in [1, 997] {
            let mut builder = Builder::new();
            for k in 0..(n + 1).pow(3) {
                builder.node([k % (n + 1), k / (n + 1) % (n + 1), k / (n + 1).pow(2)].map(|i| i as f64));
            }
            for k in 0..n.pow(3) {
                // 997 is a prime, so that every brick comes once.
                let k = k * stride % n.pow(3);
                let (x, y, z) = (k % n, k / n % n, k / n / n);
                let corners = [(0, 0), (1, 0), (1, 1), (0, 1)];
                let nodes = std::array::from_fn(|a| node(x + corners[a % 4].0, y + corners[a % 4].1, z + a / 4));
                let positions =
                    nodes.map(|k: usize| [k % (n + 1), k / (n + 1) % (n + 1), k / (n + 1).pow(2)].map(|i| i as f64));
                let material = Elastic::isotropic(3.0 + (k % 7) as f64, 0.3, 2.0 + (k % 5) as f64);
                builder.element(
                    "solid",
                    Solid8::new(nodes, positions, material, Kinematics::Linear).unwrap(),
                );
            }
            builder.hold(3, Dof::Uy);
            let model = builder.build().unwrap();
            assert!(model.elements().len() >= HALVED);
            let assembler = Assembler::new(&model);
            let (stiffness, mass) = assembler.stiffness_and_mass(&model).unwrap();
            assert_eq!(stiffness, assembler.stiffness(&model).unwrap());
            assert_eq!(mass, assembler.mass(&model));
            let x: Vec<f64> = (0..model.dofs().len())
                .map(|i| ((i * 7919) % 101) as f64 - 50.0)
                .collect();
            let (mut kx, mut mx) = (vec![0.0; x.len()], vec![0.0; x.len()]);
            for (e, element) in model.elements().iter().enumerate() {
                let own = local_values(&model, &**element, &x);
                let matrices = [reference_stiffness(&**element).unwrap(), reference_mass(&**element)];
                for (local, out) in matrices.iter().zip([&mut kx, &mut mx]) {
                    assembler.scatter_vector(&model, e, &mut local.to_matrix().times(&own), out);
                }
            }
            for (found, expected) in [(stiffness.times(&x), kx), (mass.times(&x), mx)] {
                for (f, e) in found.iter().zip(&expected) {
                    // Some 10² terms of up to 10³.
                    assert!((f - e).abs() < 1e-9, "{f} {e}");
                }
            }
        }
    }
}
