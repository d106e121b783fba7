//! Direct integration of all unknowns by Newmark's average acceleration, the independent check of modal superposition.
//!
//! ```text
//! [M + h/2 C + h²/4 K] ẍ₁ = −M ι a_g − C (ẋ₀ + h/2 ẍ₀) − K (x₀ + h ẋ₀ + h²/4 ẍ₀)
//! ```
//!
//! The matrix is factored once. C holds the ratio of every mode, C = Σ 2 ξ_j ω_j (M φ_j)(M φ_j)ᵀ, or Rayleigh's
//! a_M M + a_K K. Where the ground acceleration jumps (at the start, and at the end of a record that does not end with
//! zero), equilibrium gives the jump of ẍ as −ι Δa_g.
//!
//! The energy balance is kept in the motion relative to the ground:
//!
//! ```text
//! −∫ ẋᵀ M ι a_g dt = ½ ẋᵀ M ẋ + ½ xᵀ K x + ∫ ẋᵀ C ẋ dt
//! ```
//!
//! With trapezoidal increments ½ (f₀ + f₁)·Δx it closes for the average acceleration method up to rounding, whatever the
//! step: it proves the matrices symmetric, the factor right and the equations solved, not the step short. The step is
//! judged by the lengthening of periods (ω h)²/12. Source: Newmark 1959; Hughes 1987, section 9.1.

use fem::progress::Progress;
use oscillator::newmark::Newmark;

use super::motion::{Grid, Motion};
use super::observe::{Chunk, Observed, Observer, Row};
use super::superpose::Observable;
use crate::FeError;
use crate::coupled::Coupled;
use crate::damping::{Damper, Rayleigh};
use crate::error::failure;
use crate::modes::{CoupledMode, Kind};
use crate::probe::{ModeSelection, Probe};
use fem::linalg::{Cholesky, Matrix, dot, product};
use results::EnergyBalance;

/// Steps in the period of the highest significant mode: the period is lengthened by (2π/80)²/12 = 0.05 %.
pub const STEPS_PER_PERIOD: f64 = 80.0;

/// A coupled system with its damping matrix.
#[derive(Clone, Debug)]
pub struct DirectSystem<'a> {
    system: &'a Coupled,
    modes: &'a [CoupledMode],
    damping: Matrix,
}

impl<'a> DirectSystem<'a> {
    /// The system with damping by `damper`; `modes` are all its modes (they make up the modal damping matrix and select
    /// the sloshing modes that count for wave heights).
    pub fn new(system: &'a Coupled, modes: &'a [CoupledMode], damper: &Damper) -> DirectSystem<'a> {
        let n = system.influence.len();
        let damping = match damper {
            Damper::Rayleigh(Rayleigh { mass, stiffness }) => Matrix {
                rows: n,
                cols: n,
                data: (system.mass.data.iter().zip(&system.stiffness.data))
                    .map(|(m, k)| mass * m + stiffness * k)
                    .collect(),
            },
            Damper::ByKind { .. } => {
                let mut shapes = Matrix::zeros(n, modes.len());
                for (j, mode) in modes.iter().enumerate() {
                    shapes.column_mut(j).copy_from_slice(&mode.vector);
                }
                let momenta = product(&system.mass, &shapes);
                let mut weighted = Matrix::zeros(modes.len(), n);
                for (j, mode) in modes.iter().enumerate() {
                    let factor = 2.0 * damper.ratio(mode.kind, mode.omega) * mode.omega;
                    for i in 0..n {
                        weighted.add(j, i, factor * momenta.get(i, j));
                    }
                }
                product(&momenta, &weighted)
            }
        };
        DirectSystem { system, modes, damping }
    }

    /// Number of unknowns.
    fn size(&self) -> usize {
        self.system.influence.len()
    }

    /// Number of states: x, ẍ, a_g.
    fn states(&self) -> usize {
        2 * self.size() + 1
    }

    /// Adds `factor` × `probe` to `row`, with the states of this system starting at `offset`.
    fn observe(&self, probe: &Probe, factor: f64, offset: usize, row: &mut Row) {
        let n = self.size();
        let (d, a) = (&probe.displacement, &probe.absolute_acceleration);
        let (d, a, ground) = match probe.modes {
            ModeSelection::All => (
                d.clone(),
                a.clone(),
                dot(a, &self.system.influence) + probe.ground_acceleration,
            ),
            ModeSelection::FirstSloshing(most) => {
                // Projection on the selected modes: x ← Σ φ φᵀ M x.
                let (mut on_x, mut on_a, mut ground) = (vec![0.0; n], vec![0.0; n], 0.0);
                let selected = |m: &&CoupledMode| m.kind == Kind::Sloshing && m.number <= most;
                for mode in self.modes.iter().filter(selected) {
                    let (p, q) = (dot(d, &mode.vector), dot(a, &mode.vector));
                    let momentum = self.system.mass.times(&mode.vector);
                    for ((x, y), m) in on_x.iter_mut().zip(&mut on_a).zip(momentum) {
                        *x += p * m;
                        *y += q * m;
                    }
                    ground += q * mode.participation;
                }
                (on_x, on_a, ground)
            }
        };
        let mut push = |first: usize, coefficients: &[f64]| {
            let terms = coefficients.iter().enumerate().filter(|(_, c)| **c != 0.0);
            row.value.extend(terms.map(|(i, c)| (offset + first + i, factor * c)));
        };
        push(0, &d);
        push(n, &a);
        push(2 * n, &[ground]);
    }
}

/// Non-zero entries of a symmetric matrix, row by row.
#[derive(Clone, Debug)]
struct Rows {
    start: Vec<usize>,
    entries: Vec<(usize, f64)>,
}

impl Rows {
    fn new(matrix: &Matrix) -> Rows {
        let (mut start, mut entries) = (vec![0], Vec::new());
        for j in 0..matrix.cols {
            // Symmetric: the column is the row.
            let column = matrix.column(j).iter().enumerate();
            entries.extend(column.filter(|(_, v)| **v != 0.0).map(|(i, v)| (i, *v)));
            start.push(entries.len());
        }
        Rows { start, entries }
    }

    fn times(&self, x: &[f64], out: &mut [f64]) {
        for (y, range) in out.iter_mut().zip(self.start.windows(2)) {
            *y = self.entries[range[0]..range[1]].iter().map(|&(i, v)| v * x[i]).sum();
        }
    }
}

/// State of one system under way.
struct Run<'a> {
    system: &'a DirectSystem<'a>,
    motion: &'a Motion,
    newmark: Newmark,
    factor: Cholesky,
    stiffness: Rows,
    load: Vec<f64>,
    x: Vec<f64>,
    v: Vec<f64>,
    a: Vec<f64>,
    /// C ẋ and C ẍ, carried along so that a step costs one product with C.
    c_v: Vec<f64>,
    c_a: Vec<f64>,
    right: Vec<f64>,
    elastic: Vec<f64>,
    input: f64,
    damped: f64,
}

impl<'a> Run<'a> {
    fn new(system: &'a DirectSystem<'a>, motion: &'a Motion, h: f64) -> Result<Run<'a>, FeError> {
        let newmark = Newmark::average_acceleration(h);
        let (m, k) = (&system.system.mass, &system.system.stiffness);
        let effective = Matrix {
            rows: m.rows,
            cols: m.cols,
            data: (m.data.iter().zip(&system.damping.data).zip(&k.data))
                .map(|((m, c), k)| m + newmark.a7 * c + k / newmark.a0)
                .collect(),
        };
        let zero = vec![0.0; m.rows];
        let mut run = Run {
            system,
            motion,
            newmark,
            factor: Cholesky::factor(&effective).map_err(failure("the effective matrix of a step"))?,
            stiffness: Rows::new(k),
            load: m.times(&system.system.influence),
            x: zero.clone(),
            v: zero.clone(),
            a: zero.clone(),
            c_v: zero.clone(),
            c_a: zero.clone(),
            right: zero.clone(),
            elastic: zero,
            input: 0.0,
            damped: 0.0,
        };
        run.jump(motion.at(0));
        Ok(run)
    }

    /// The ground acceleration jumps by `change`.
    fn jump(&mut self, change: f64) {
        for (a, iota) in self.a.iter_mut().zip(&self.system.system.influence) {
            *a -= iota * change;
        }
        self.c_a = self.system.damping.times(&self.a);
    }

    /// The sub-step from `i` to `i` + 1.
    fn step(&mut self, i: usize) {
        let (a0, a1) = self.motion.interval(i);
        if i == self.motion.last() {
            self.jump(-self.motion.at(i));
        }
        let n = &self.newmark;
        let x0 = self.x.clone();
        for ((x, v), a) in self.x.iter_mut().zip(&mut self.v).zip(&self.a) {
            *x = n.predict_displacement(*x, *v, *a);
            *v = n.predict_velocity(*v, *a);
        }
        self.stiffness.times(&self.x, &mut self.elastic);
        let c_v0 = self.c_v.clone();
        for (c_v, c_a) in self.c_v.iter_mut().zip(&self.c_a) {
            *c_v += n.a6 * c_a;
        }
        for (r, ((load, k_x), c_v)) in (self.right.iter_mut()).zip(self.load.iter().zip(&self.elastic).zip(&self.c_v)) {
            *r = -load * a1 - k_x - c_v;
        }
        self.a = self.factor.solve_vector(&self.right);
        self.c_a = self.system.damping.times(&self.a);
        let (mut work, mut loss) = (0.0, 0.0);
        for k in 0..self.a.len() {
            self.x[k] += self.a[k] / n.a0;
            self.v[k] += n.a7 * self.a[k];
            self.c_v[k] += n.a7 * self.c_a[k];
            let dx = self.x[k] - x0[k];
            work += self.load[k] * dx;
            loss += (c_v0[k] + self.c_v[k]) * dx;
        }
        self.input -= 0.5 * (a0 + a1) * work;
        self.damped += 0.5 * loss;
    }

    /// Kinetic and elastic energy now, from the matrices themselves.
    fn energies(&mut self) -> (f64, f64) {
        self.stiffness.times(&self.x, &mut self.elastic);
        let kinetic = 0.5 * dot(&self.v, &self.system.system.mass.times(&self.v));
        (kinetic, 0.5 * dot(&self.x, &self.elastic))
    }
}

/// Response of `systems` to `motions` (one each): histories of `scalars`, extremes of `others` at the sub-steps, and the
/// energy balance, taken at the samples of the grid.
///
/// Errors: an effective matrix that is not positive definite, a response that is not finite, with its time.
pub fn respond(
    systems: &[DirectSystem],
    motions: &[&Motion],
    grid: Grid,
    scalars: &[Observable],
    others: &[Observable],
    progress: &dyn Progress,
) -> Result<(Observed, EnergyBalance), FeError> {
    let mut offsets = vec![0];
    for system in systems {
        offsets.push(offsets[offsets.len() - 1] + system.states());
    }
    let rows = |observables: &[Observable]| -> Vec<Row> {
        let row = |terms: &Observable| {
            let mut row = Row::default();
            for &(system, factor, probe) in terms {
                systems[system].observe(probe, factor, offsets[system], &mut row);
            }
            row
        };
        observables.iter().map(row).collect()
    };
    let (scalars, others) = (rows(scalars), rows(others));
    let mut observer = Observer::new(&scalars, &others, grid);
    let mut runs = systems
        .iter()
        .zip(motions)
        .map(|(system, motion)| Run::new(system, motion, grid.h()))
        .collect::<Result<Vec<Run>, FeError>>()?;
    let mut chunk = Chunk::new(offsets[systems.len()]);
    let mut balance = EnergyBalance {
        input: 0.0,
        kinetic: 0.0,
        elastic: 0.0,
        damping: 0.0,
        error: 0.0,
    };
    let (mut worst, mut largest) = (0.0_f64, 0.0_f64);
    while chunk.start < grid.steps() {
        chunk.len = (grid.steps() - chunk.start).min(Chunk::LENGTH) + 1;
        for k in 0..chunk.len {
            let i = chunk.start + k;
            for (run, offset) in runs.iter_mut().zip(&offsets) {
                if k > 0 {
                    run.step(i - 1);
                }
                let n = run.x.len();
                for (j, (x, a)) in run.x.iter().zip(&run.a).enumerate() {
                    chunk.set(offset + j, k, *x);
                    chunk.set(offset + n + j, k, *a);
                }
                chunk.set(offset + 2 * n, k, run.motion.at(i));
            }
            if i.is_multiple_of(grid.sub_steps) {
                (balance.kinetic, balance.elastic) = (0.0, 0.0);
                for run in &mut runs {
                    let (kinetic, elastic) = run.energies();
                    balance.kinetic += kinetic;
                    balance.elastic += elastic;
                }
                balance.input = runs.iter().map(|r| r.input).sum();
                balance.damping = runs.iter().map(|r| r.damped).sum();
                let rest = balance.input - balance.kinetic - balance.elastic - balance.damping;
                (worst, largest) = (worst.max(rest.abs()), largest.max(balance.input.abs()));
            }
        }
        if !chunk.close() {
            return Err(FeError::NotFinite {
                time: grid.time(chunk.start),
                cause: "negative damping, or ground motion that is not finite".into(),
            });
        }
        observer.take(&chunk);
        progress.advance((chunk.len - 1) as u64);
        chunk.start += chunk.len - 1;
    }
    balance.error = if largest > 0.0 { worst / largest } else { 0.0 };
    Ok((observer.finish(), balance))
}
