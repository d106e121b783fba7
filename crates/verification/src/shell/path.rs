//! Common to the nonlinear benchmarks of shells: a model with its load, and its equilibrium path.

use std::sync::Arc;

use super::{Answer, Case};
use crate::{Failure, Reference, Row};
use fem::analysis::continuation::{Continuation, StepLength};
use fem::analysis::newton::{Criteria, Newton, lasting_path, load_path};
use fem::assembly::{Assembler, order};
use fem::dofs::Dof;
use fem::element::shell::load::NodalLoads;
use fem::element::{Inspect, SectionState};
use fem::linalg::Symbolic;
use fem::model::{Builder, Model};
use fem::progress::Silent;
use fem::state::{Gather, State};

/// Sharp, so that counts of iterations compare.
pub(super) const SHARP: Criteria = Criteria { energy: 1e-13, force: 1e-4, iterations: 30 };

/// A model under λ times a load.
pub(super) struct Problem {
    pub(super) model: Model,
    pub(super) assembler: Assembler,
    pub(super) symbolic: Arc<Symbolic>,
    pub(super) load: Vec<f64>,
}

impl Problem {
    pub(super) fn new(builder: Builder, loads: &NodalLoads) -> Answer<Problem> {
        let model = builder.build()?;
        let assembler = Assembler::new(&model);
        let symbolic = Arc::new(Symbolic::new(assembler.pattern().clone(), &order(&model, assembler.pattern()))?);
        let load = loads.vector(&model);
        Ok(Problem { model, assembler, symbolic, load })
    }

    /// The path under growing λ.
    pub(super) fn continuation(&self, criteria: Criteria) -> Answer<Continuation<'_>> {
        let none = vec![0.0; self.load.len()];
        let parts = (&self.model, &self.assembler, &self.symbolic);
        Ok(Continuation::new(parts.0, parts.1, parts.2, &none, &self.load, criteria)?)
    }

    /// Displacement of a node in the committed state.
    pub(super) fn displacement(&self, state: &State, node: usize) -> [f64; 3] {
        let [x, y, z, ..] = self.model.at_node(&state.committed.u, node);
        [x, y, z]
    }

    /// Sections of an element in the committed state.
    pub(super) fn sections(&self, state: &State, element: usize) -> Answer<Vec<SectionState>> {
        let mut gather = Gather::default();
        let shell = &*self.model.elements()[element];
        let motion = gather.motion(&self.model, &state.committed, shell);
        Ok(shell.sections(motion, &state.old[state.history(element)])?)
    }

    /// Load steps to λ = 1; returns their number and the sum of their iterations.
    pub(super) fn load_steps(
        &self,
        steps: usize,
        extrapolated: bool,
        each: impl FnMut(f64, &State),
    ) -> Answer<(usize, usize)> {
        self.load_steps_from(&mut State::new(&self.model), steps, extrapolated, each)
    }

    /// The same from a state, which may come from a model with the same nodes and supports.
    pub(super) fn load_steps_from(
        &self,
        state: &mut State,
        steps: usize,
        extrapolated: bool,
        each: impl FnMut(f64, &State),
    ) -> Answer<(usize, usize)> {
        let mut newton = Newton::new(&self.model, &self.assembler, &self.symbolic, None, SHARP)?;
        if extrapolated {
            newton = newton.with_extrapolated_stresses();
        }
        let none = vec![0.0; self.load.len()];
        let path = load_path(&mut newton, state, &none, &self.load, steps, &Silent, each)?;
        match path.failure {
            None => Ok((path.steps.len(), path.steps.iter().map(|s| s.1).sum())),
            Some(failure) => Err(ended(path.factor, &failure)),
        }
    }

    /// Free strains at rest in load steps, without a load; returns the forces of the supports.
    pub(super) fn rest(&self, state: &mut State, steps: usize) -> Answer<Vec<((usize, Dof), f64)>> {
        let mut newton = Newton::new(&self.model, &self.assembler, &self.symbolic, None, SHARP)?;
        let path = lasting_path(&mut newton, state, &vec![0.0; self.load.len()], steps, &Silent)?;
        if let Some(failure) = path.failure {
            return Err(ended(path.factor, &failure));
        }
        let forces = newton.committed_forces(state).map_err(|failure| ended(1.0, &failure))?;
        Ok(self.assembler.supports().iter().copied().zip(forces.support.iter().copied()).collect())
    }

    /// Load factors at which the displacement `dof` of `node` reaches the `targets`, with the states; and the iterations of
    /// the whole path.
    pub(super) fn at_displacements(
        &self,
        (node, dof): (usize, Dof),
        targets: &[f64],
        first: f64,
        mut each: impl FnMut(f64, &State),
    ) -> Answer<(Vec<f64>, usize)> {
        let mut path = self.continuation(SHARP)?.with_extrapolated_stresses();
        let mut state = State::new(&self.model);
        let row = self.model.row(node, dof);
        let mut factors = Vec::with_capacity(targets.len());
        let followed =
            path.to_displacements(&mut state, &row, targets, StepLength::around(first), &Silent, |_, point, state| {
                factors.push(point.factor);
                each(point.factor, state);
            })?;
        match followed.failure {
            None => Ok((factors, followed.points.iter().map(|p| p.iterations).sum())),
            Some(failure) => Err(ended(factors.len() as f64 / targets.len() as f64, &failure)),
        }
    }
}

const SZE: &str = "Sze, Liu & Lo 2004";

const PROTOTYPE: &str = "independent prototype of the same formulation on the same mesh";

pub(super) fn case(id: &'static str) -> Case {
    Case { id, source: SZE, unit: "length" }
}

/// A row against the prototype.
pub(super) fn prototype(case: &Case, what: impl Into<String>, reference: f64, value: f64, tolerance: f64) -> Row {
    let mut row = case.row(what, Reference::SecondFormulation, reference, value, tolerance);
    row.source = PROTOTYPE;
    row
}

/// Iterations with extrapolated stresses and with the plain tangent: (steps, iterations) measured, and by the prototype.
///
/// Shown, not asserted: the prototype stops by another criterion of forces, and where a step had to be halved the steps differ.
pub(super) fn iterations(
    case: &Case,
    found: (usize, usize),
    plain: Option<(usize, usize)>,
    expected: (usize, usize),
) -> Vec<Row> {
    let mut rows = vec![prototype(
        case,
        format!("iterations, extrapolated stresses, {} steps", found.0),
        expected.0 as f64,
        found.1 as f64,
        f64::INFINITY,
    )];
    if let Some((steps, count)) = plain {
        rows.push(prototype(
            case,
            format!("iterations, plain tangent, {steps} steps"),
            expected.1 as f64,
            count as f64,
            f64::INFINITY,
        ));
    }
    rows.iter_mut().for_each(|r| r.unit = "iterations");
    rows
}

/// A path that ended early, at a part of its length.
pub(super) fn ended(reached: f64, why: &dyn std::fmt::Display) -> Failure {
    format!("the path ends at {reached:.3} of its length: {why}").into()
}
