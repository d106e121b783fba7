//! Response of the elements to a motion.

mod parallel;

use super::matrices::{Sink, Work};
use super::turn::{Nodes, turn_back};
use super::{Assembler, NONE};
use crate::element::{ElementError, LocalMatrix, Motion, Response, Trial, Want, local_size};
use crate::linalg::Symmetric;
use crate::model::Model;
use crate::state::{Fields, Gather, State};

/// Room for the response of one element, reused from element to element.
#[derive(Default)]
struct Room {
    gather: Gather,
    response: Response,
}

/// Variables of one element: committed and trial history, and data kept from one iteration to the next.
struct Slots<'a> {
    old: &'a [f64],
    new: &'a mut [f64],
    kept: &'a mut [f64],
}

/// Internal forces of a model.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Forces {
    /// Forces on the unknowns.
    pub internal: Vec<f64>,
    /// Forces on the held dofs, in the order of [`Assembler::supports`].
    pub support: Vec<f64>,
    /// Part of `internal` that time steps take at their end ([`acts_at_end`](crate::element::Contact::acts_at_end)); empty without such elements.
    pub at_end: Vec<f64>,
}

/// Requested results of an evaluation of all elements.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Ask<'a> {
    /// Force, tangent.
    pub want: Want,
    /// Stands for the linear elements.
    pub linear: Option<&'a LinearPart>,
    /// Factor on the tangents of elements that act at the end of a step.
    pub end_tangent: f64,
    /// Threads that evaluate the elements, at most; the results do not depend on them.
    pub threads: usize,
    /// Tangents of these elements alone; `None` for those of all.
    pub tangents: Option<&'a [bool]>,
}

impl<'a> Ask<'a> {
    /// At one instant.
    pub(crate) fn now(want: Want, linear: Option<&'a LinearPart>) -> Ask<'a> {
        Ask { want, linear, end_tangent: 1.0, threads: 1, tangents: None }
    }

    /// Whether the tangent of element `e` is wanted.
    pub(super) fn wants_tangent(&self, e: usize) -> bool {
        self.want.tangent && self.tangents.is_none_or(|of| of[e])
    }
}

/// Tangents of some elements into a matrix of their own.
pub(crate) struct Apart<'a> {
    /// The elements.
    pub elements: &'a [bool],
    /// Their tangents; written only where they have places.
    pub tangent: &'a mut Symmetric,
}

/// Data that elements keep from one iteration of a step to the next ([`respond_mixed`](crate::element::Mixed::respond_mixed)).
#[derive(Clone, Debug, PartialEq)]
pub struct Kept {
    values: Vec<f64>,
    /// Start of each element's part, with the total at the end.
    offsets: Vec<usize>,
}

impl Kept {
    /// Empty.
    pub fn new(model: &Model) -> Kept {
        let mut offsets = vec![0];
        for element in model.elements() {
            offsets.push(offsets[offsets.len() - 1] + element.mixed().map_or(0, |mixed| mixed.mixed_len()));
        }
        Kept { values: vec![0.0; offsets[offsets.len() - 1]], offsets }
    }

    /// Forgets the iterate before: a step begins.
    pub fn clear(&mut self) {
        self.values.fill(0.0);
    }
}

/// Stiffness of the linear elements, assembled once for all steps.
#[derive(Clone, Debug)]
pub struct LinearPart {
    tangent: Symmetric,
    /// Columns with entries that are not zero: number, diagonal, end of its entries below the diagonal. Most of the pattern is that of nonlinear
    /// elements.
    columns: Vec<(u32, f64, usize)>,
    /// Entries below the diagonal that are not zero, column by column: row, value.
    entries: Vec<(u32, f64)>,
    /// Rows of the held dofs: (support, unknown, coefficient).
    support: Vec<(u32, u32, f64)>,
}

impl LinearPart {
    /// Collects the entries that are not zero.
    fn collect(&mut self) {
        let pattern = &self.tangent.pattern;
        for j in 0..pattern.size() {
            let (first, last) = (pattern.starts[j], pattern.starts[j + 1]);
            let begin = self.entries.len();
            let below = pattern.rows[first + 1..last].iter().zip(&self.tangent.values[first + 1..last]);
            let found = below.filter(|(_, k)| **k != 0.0).map(|(&i, &k)| (i as u32, k));
            self.entries.extend(found);
            let diagonal = self.tangent.values[first];
            if diagonal != 0.0 || self.entries.len() > begin {
                self.columns.push((j as u32, diagonal, self.entries.len()));
            }
        }
    }

    /// y ← y + K x, in the order of [`Symmetric::add_product`]: the same bits.
    fn add_forces(&self, x: &[f64], y: &mut [f64]) {
        let mut first = 0;
        for &(j, diagonal, end) in &self.columns {
            let j = j as usize;
            let mut sum = diagonal * x[j];
            for &(i, k) in &self.entries[first..end] {
                y[i as usize] += k * x[j];
                sum += k * x[i as usize];
            }
            y[j] += sum;
            first = end;
        }
    }
}

impl Assembler {
    /// Assembles the linear elements once for all.
    ///
    /// Errors: the first element that fails, with its number.
    pub fn linear_part(&self, model: &Model) -> Result<LinearPart, (usize, ElementError)> {
        let mut out = LinearPart {
            tangent: Symmetric::zeros(self.pattern.clone()),
            columns: Vec::new(),
            entries: Vec::new(),
            support: Vec::new(),
        };
        let mut work = Work::default();
        let elements = model.elements().iter().enumerate();
        for (e, element) in elements.filter(|(e, _)| self.linear[*e] && !self.unassembled[*e]) {
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
        out.collect();
        Ok(out)
    }

    /// Internal force and, if wanted, tangent at the trial state; writes the trial history.
    ///
    /// Errors: the first element that fails, with its number.
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

    /// The same with the forces at the supports, into storage that is kept; `linear` replaces the linear elements.
    ///
    /// Errors: the first element that fails, with its number.
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
        kept: Option<&mut Kept>,
    ) -> Result<(), (usize, ElementError)> {
        self.answer_apart(model, state, ask, tangent, None, forces, kept)
    }

    /// The same with the tangents of some elements `apart`. `tangent` is not written if only theirs are wanted.
    pub(crate) fn answer_apart(
        &self,
        model: &Model,
        state: &mut State,
        ask: Ask<'_>,
        tangent: &mut Symmetric,
        mut apart: Option<Apart<'_>>,
        forces: &mut Forces,
        kept: Option<&mut Kept>,
    ) -> Result<(), (usize, ElementError)> {
        let Ask { want, linear, .. } = ask;
        let ends = !self.at_end.is_empty();
        for (out, len) in [
            (&mut forces.internal, model.dofs().len()),
            (&mut forces.support, self.supports.len()),
            (&mut forces.at_end, if ends { model.dofs().len() } else { 0 }),
        ] {
            out.clear();
            out.resize(len, 0.0);
        }
        if want.tangent && ask.tangents.is_none() {
            match linear {
                Some(part) => tangent.values.copy_from_slice(&part.tangent.values),
                None => tangent.values.fill(0.0),
            }
        }
        if let Some(apart) = apart.as_mut().filter(|_| want.tangent) {
            apart.tangent.values.fill(0.0);
        }
        if let (Some(part), true) = (linear, want.force) {
            part.add_forces(&state.trial.u, &mut forces.internal);
            for &(s, e, k) in &part.support {
                forces.support[s as usize] += k * state.trial.u[e as usize];
            }
        }
        if want.force {
            self.add_operator_forces(model, &state.trial.u, forces);
        }
        let nodes = Nodes::new(model, &state.trial);
        self.evaluate(model, state, &nodes, ask, kept, |e, force, matrix| {
            if want.force {
                self.add_forces(e, force, forces);
            }
            if ask.wants_tangent(e) {
                let to = match &mut apart {
                    Some(apart) if apart.elements[e] => &mut apart.tangent.values,
                    _ => &mut tangent.values,
                };
                self.place(e, matrix, &mut Sink::whole(to));
            }
        })
    }

    /// Response of element `e` along the axes of the unknowns, into the room; writes its part `new` of the history.
    fn local(
        &self,
        model: &Model,
        e: usize,
        ask: Ask<'_>,
        (trial, nodes): (&Fields, &Nodes),
        slots: Slots<'_>,
        room: &mut Room,
    ) -> Result<(), ElementError> {
        let element = &*model.elements()[e];
        let want = Want { tangent: ask.wants_tangent(e), ..ask.want };
        let Slots { old, new, kept } = slots;
        let dofs = self.equation_starts[e]..self.equation_starts[e + 1];
        let Room { gather, response } = room;
        if want.tangent {
            response.reset(dofs.len())
        } else {
            response.reset_force(dofs.len())
        }
        let motion: Motion<'_> = match self.turned[e] {
            true => gather.turned(trial, element, &nodes.values),
            // Components are the unknowns themselves.
            false => {
                let value = |&q: &u32| if q == NONE { 0.0 } else { trial.u[q as usize] };
                gather.values(trial, element, self.equations[dofs].iter().map(value))
            }
        };
        let trial = Trial { motion, old, new, want };
        match element.mixed().filter(|_| !kept.is_empty()) {
            Some(mixed) => mixed.respond_mixed(trial, kept, response)?,
            None => element.respond(trial, response)?,
        }
        if want.tangent && self.at_end.get(e) == Some(&true) {
            response.tangent.data.iter_mut().for_each(|k| *k *= ask.end_tangent);
        }
        if self.turned[e] {
            nodes.turn(model, element, want, response);
        }
        Ok(())
    }

    /// Adds the force of element `e`: to the unknowns, the supports, and the forces at the end of a step.
    fn add_forces(&self, e: usize, force: &[f64], forces: &mut Forces) {
        let dofs = self.equation_starts[e]..self.equation_starts[e + 1];
        let ends = self.at_end.get(e) == Some(&true);
        for ((&q, &s), f) in self.equations[dofs.clone()].iter().zip(&self.held[dofs]).zip(force) {
            if q != NONE {
                forces.internal[q as usize] += f;
                if ends {
                    forces.at_end[q as usize] += f;
                }
            }
            if s != NONE {
                forces.support[s as usize] += f;
            }
        }
    }

    /// Adds Σ a_e K_e⁺ of the elements' tangents at the trial state, where K_e⁺ is the positive part of K_e and
    /// a_e = `factor(e)`.
    ///
    /// Errors: the first element that fails, with its number.
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
            if a == 0.0 || self.unassembled[e] {
                continue;
            }
            response.reset(local_size(&**element));
            let old = &state.old[state.history(e)];
            new.clear();
            new.extend_from_slice(old);
            let motion = gather.motion(model, &state.trial, &**element);
            element
                .respond(Trial { motion, old, new: &mut new, want: Want::TANGENT }, &mut response)
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
