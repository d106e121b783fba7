//! Energies of a march.

use super::problem::Problem;
use crate::analysis::checkpoint::{CheckpointError, Reader, Writer};
use crate::analysis::scheme::GeneralizedAlpha;
use crate::assembly::Forces;
use crate::element::Inspect;
use crate::linalg::{Symmetric, dot};
use crate::state::{Fields, State};

/// Energies since the start [J].
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Energies {
    /// Work of all loads, the constant ones included.
    pub input: f64,
    /// Work of the constant loads.
    pub constant: f64,
    /// Kinetic energy.
    pub kinetic: f64,
    /// Work done on the internal forces: stored and hysteretic.
    pub internal: f64,
    /// Work done on the viscous damping.
    pub damping: f64,
    /// Dissipation of the scheme.
    pub numerical: f64,
    /// Dissipation of the elements, as of the last sample.
    pub hysteretic: f64,
}

impl Energies {
    /// E_in − E_kin − E_int − E_damp − E_num: the work of the residuals that were left.
    pub fn residual(&self) -> f64 {
        self.input - self.kinetic - self.internal - self.damping - self.numerical
    }

    const COUNT: usize = 7;

    fn array(&self) -> [f64; Energies::COUNT] {
        [self.input, self.constant, self.kinetic, self.internal, self.damping, self.numerical, self.hysteretic]
    }

    fn of(a: &[f64]) -> Energies {
        Energies {
            input: a[0],
            constant: a[1],
            kinetic: a[2],
            internal: a[3],
            damping: a[4],
            numerical: a[5],
            hysteretic: a[6],
        }
    }
}

/// Energies at the samples.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Balance {
    /// At the samples reached.
    pub samples: Vec<Energies>,
    /// Largest |residual| after any step [J].
    pub worst: f64,
    /// Largest |E_in| or E_kin after any step [J].
    pub largest: f64,
}

impl Balance {
    /// Largest residual relative to the largest energy.
    pub fn error(&self) -> f64 {
        if self.largest > 0.0 { self.worst / self.largest } else { 0.0 }
    }

    pub(super) fn save(&self, to: &mut Writer) {
        let all: Vec<f64> = self.samples.iter().flat_map(Energies::array).collect();
        to.numbers(&all);
        to.number(self.worst);
        to.number(self.largest);
    }

    pub(super) fn restore(from: &mut Reader) -> Result<Balance, CheckpointError> {
        Ok(Balance {
            samples: from.numbers("energies")?.chunks_exact(Energies::COUNT).map(Energies::of).collect(),
            worst: from.number()?,
            largest: from.number()?,
        })
    }
}

/// Sums the energies from step to step.
pub(super) struct Meter<'a> {
    problem: Problem<'a>,
    pub now: Energies,
    initial: f64,
    /// At the beginning of the step: fields, internal forces, M a, M v.
    before: Fields,
    force: Forces,
    ma: Vec<f64>,
    mv: Vec<f64>,
    /// Fields of the last end of a step: `ma` and `mv` belong to them.
    known: bool,
    /// Whether the fourth vector of `room` is C v of it.
    known_damping: bool,
    room: [Vec<f64>; 5],
}

impl<'a> Meter<'a> {
    pub(crate) fn new(problem: Problem<'a>, state: &State) -> Meter<'a> {
        Meter {
            problem,
            now: Energies::default(),
            initial: hysteresis(problem, state),
            before: state.committed.clone(),
            force: Forces::default(),
            ma: Vec::new(),
            mv: Vec::new(),
            known: false,
            known_damping: false,
            room: Default::default(),
        }
    }

    /// Before a step: the committed state with its internal forces.
    pub(crate) fn begin(&mut self, state: &State, force: &Forces) {
        // The acceleration jumps where the loads do.
        let known = self.known && self.before.a == state.committed.a && self.before.v == state.committed.v;
        self.before.clone_from(&state.committed);
        self.force.clone_from(force);
        self.known_damping &= known;
        if !known {
            mass_product(self.problem, &self.before.a, &mut self.ma);
            mass_product(self.problem, &self.before.v, &mut self.mv);
        }
    }

    /// After a step that converged; `viscous` is the tangent damping that held in it.
    pub(crate) fn end(
        &mut self,
        state: &State,
        forces: &Forces,
        loads: [&[f64]; 2],
        constant: &[f64],
        scheme: &GeneralizedAlpha,
        viscous: Option<&Symmetric>,
    ) {
        let system = self.problem.system;
        let (force, before) = (&forces.internal, &self.force.internal);
        let n = force.len();
        let after = &state.committed;
        let [du, ma, mv, cv0, cv1] = &mut self.room;
        du.clear();
        du.extend(after.u.iter().zip(&self.before.u).map(|(a, b)| a - b));
        mass_product(self.problem, &after.a, ma);
        mass_product(self.problem, &after.v, mv);
        let c = system.damping.of_operators();
        let Problem { model, assembler, .. } = self.problem;
        // Tangent damping changes from step to step.
        let kept = self.known_damping && viscous.is_none();
        for (v, out) in [(&self.before.v, &mut *cv0), (&after.v, &mut *cv1)].into_iter().skip(usize::from(kept)) {
            out.clear();
            out.resize(n, 0.0);
            system.damping.add_sparse_product(&system.mass, &system.stiffness, 1.0, v, out);
            assembler.add_operator_products(model, |_| [c.mass, c.stiffness], v, out);
            if let Some(c) = viscous {
                c.add_product(1.0, v, out);
            }
        }
        let (h, gamma, beta) = (scheme.h, scheme.gamma, scheme.beta);
        let (on_mass, on_force) = (0.5 - scheme.alpha_m, 0.5 - scheme.alpha_f);
        let (mut input, mut internal, mut damping, mut numerical) = (0.0, 0.0, 0.0, 0.0);
        for i in 0..n {
            let (d, p0, p1) = (du[i], loads[0][i], loads[1][i]);
            input += 0.5 * (p0 + p1) * d;
            internal += 0.5 * (before[i] + force[i]) * d;
            damping += 0.5 * (cv0[i] + cv1[i]) * d;
            let rate = cv1[i] - cv0[i] + force[i] - before[i] - p1 + p0;
            let inertia = ma[i] - self.ma[i];
            let (mean_v, mean_a) = (0.5 * (self.before.v[i] + after.v[i]), 0.5 * (self.before.a[i] + after.a[i]));
            numerical += on_force * rate * d
                + inertia * (on_mass * d - h * (gamma - 0.5) * mean_v + h * h * (beta - 0.5 * gamma) * mean_a);
        }
        // Forces that act at the end of the step; the scheme blends the others.
        for ((d, after), before) in du.iter().zip(&forces.at_end).zip(&self.force.at_end) {
            numerical += (0.5 - on_force) * (after - before) * d;
        }
        self.now.input += input;
        self.now.internal += internal;
        self.now.damping += damping;
        self.now.numerical += numerical;
        self.now.kinetic = 0.5 * dot(&after.v, mv);
        if !constant.is_empty() {
            self.now.constant += dot(constant, du);
        }
        // The end of this step is the beginning of the next.
        std::mem::swap(&mut self.ma, ma);
        std::mem::swap(&mut self.mv, mv);
        self.before.a.clone_from(&after.a);
        self.before.v.clone_from(&after.v);
        std::mem::swap(cv0, cv1);
        self.known = true;
        self.known_damping = viscous.is_none();
    }

    /// At a sample: asks the elements.
    pub(crate) fn sample(&mut self, state: &State) {
        self.now.hysteretic = hysteresis(self.problem, state) - self.initial;
    }

    pub(crate) fn save(&self, to: &mut Writer) {
        to.numbers(&self.now.array());
        to.number(self.initial);
    }

    pub(crate) fn restore(&mut self, from: &mut Reader) -> Result<(), CheckpointError> {
        let mut now = [0.0; Energies::COUNT];
        from.numbers_into("energies", &mut now)?;
        self.now = Energies::of(&now);
        self.initial = from.number()?;
        Ok(())
    }
}

fn mass_product(problem: Problem<'_>, x: &[f64], out: &mut Vec<f64>) {
    out.clear();
    out.resize(x.len(), 0.0);
    problem.system.mass.add_product(1.0, x, out);
    problem.assembler.add_operator_mass(problem.model, x, out);
    if let Some(border) = &problem.system.border {
        border.add_product(1.0, x, out);
    }
}

fn hysteresis(problem: Problem<'_>, state: &State) -> f64 {
    let elements = problem.model.elements().iter().enumerate();
    elements.map(|(e, element)| element.dissipated(&state.old[state.history(e)])).sum()
}
