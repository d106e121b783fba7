//! The steps of a march.

use std::time::Instant as Clock;

use super::energy::{Balance, Meter};
use super::stride::Strides;
use super::*;
use crate::analysis::checkpoint::{CheckpointError, Hash, Reader, Writer};
use crate::analysis::newton::{Inertia, Newton, lasting_path};

/// Where a march stands.
#[derive(Clone, Copy, Debug)]
struct Position {
    /// Nominal step.
    step: usize,
    /// Beginning and length of the next part, in units of the shortest.
    at: u32,
    part: u32,
    /// Steps that converged since the last change of length.
    easy: usize,
    cuts: u64,
    shortest: f64,
    longest: f64,
}

pub(super) struct Driver<'a> {
    problem: Problem<'a>,
    load: &'a Load,
    settings: &'a Settings,
    newton: Newton<'a>,
    state: State,
    position: Position,
    strides: Option<Strides>,
    /// Time functions at the end of the last step: three components, then the forces.
    functions: Vec<f64>,
    meter: Meter<'a>,
    balance: Balance,
    statics: Option<LoadPath>,
    identity: u64,
}

/// Identity of a checkpoint: the key of its input with sizes and settings, in case the key does not contain them.
fn identity(key: &str, state: &State, settings: &Settings) -> u64 {
    let mut hash = Hash::default();
    hash.text(key);
    hash.count(state.committed.u.len());
    hash.count(state.old.len());
    hash.text(&format!("{:?} {:?} {:?}", settings.scheme, settings.grid, settings.newton));
    hash.text(&format!("{:?}", settings.adaptive));
    for count in [settings.load_steps, settings.halvings as usize, settings.recovery] {
        hash.count(count);
    }
    hash.value()
}

impl<'a> Driver<'a> {
    pub(crate) fn new(
        problem: Problem<'a>,
        load: &'a Load,
        settings: &'a Settings,
    ) -> Result<Driver<'a>, AnalysisError> {
        let system = problem.system;
        let inertia = Inertia::from(system);
        let newton = Newton::with_options(
            problem.model,
            problem.assembler,
            problem.symbolic,
            Some(inertia),
            settings.newton.clone(),
        )?
        .on_threads(settings.threads);
        let state = match &settings.start {
            Some(start) => start.clone(),
            None => State::new(problem.model),
        };
        Ok(Driver {
            identity: match &settings.checkpoint {
                Some(file) => identity(&file.key, &state, settings),
                None => 0,
            },
            meter: Meter::new(problem, &state),
            problem,
            load,
            settings,
            newton,
            state,
            position: Position {
                step: 0,
                at: 0,
                part: 1 << settings.halvings,
                easy: 0,
                cuts: 0,
                shortest: f64::INFINITY,
                longest: 0.0,
            },
            strides: settings.adaptive.map(|a| Strides::new(a, settings.grid.sub_steps, settings.recovery, problem)),
            functions: vec![0.0; 3 + load.forces.len()],
            balance: Balance::default(),
            statics: None,
        })
    }

    pub(crate) fn run(
        mut self,
        observers: &mut [&mut dyn Observe],
        progress: &dyn Progress,
    ) -> Result<Run, AnalysisError> {
        let settings = self.settings;
        let file = settings.checkpoint.as_ref();
        let resumed = match file {
            Some(c) if c.resume && c.path.exists() => {
                self.restore(&c.path, observers).map_err(|error| match error {
                    AnalysisError::Checkpoint(fault) => AnalysisError::Checkpoint(fault.of(&c.path)),
                    other => other,
                })?;
                true
            }
            _ => false,
        };
        if !resumed {
            if let Some(end) = self.start_static(progress)? {
                return Ok(self.finish(end));
            }
            self.meter = Meter::new(self.problem, &self.state);
            if let Some(strides) = &mut self.strides {
                strides.begin(&self.state);
            }
            if let Err(failure) = self.show(observers, 0, 0.0) {
                return Ok(self.finish(Outcome::Collapsed(Collapse::new(0.0, None, failure))));
            }
        }
        let grid = &settings.grid;
        progress.stage("time steps", grid.steps() as u64);
        progress.advance(self.position.step as u64);
        let mut written = (self.position.step, Clock::now());
        let end = loop {
            if self.position.step >= grid.steps() {
                break Outcome::Completed;
            }
            if progress.interrupted() {
                if let Some(c) = file {
                    self.keep(&c.path, observers, progress);
                }
                break Outcome::Interrupted;
            }
            if self.position.at == 0 {
                self.jump()?;
            }
            match self.advance(observers)? {
                Ok(0) => {}
                Ok(steps) => progress.advance(steps as u64),
                Err(failure) => {
                    break Outcome::Collapsed(Collapse::new(self.time(), None, failure));
                }
            }
            if let Some(reason) = observers.iter().find_map(|o| o.stop()) {
                break Outcome::Stopped { reason };
            }
            if let Some(c) = file
                && self.position.at == 0
                && ((c.steps > 0 && self.position.step >= written.0 + c.steps)
                    || written.1.elapsed().as_secs_f64() >= c.seconds)
            {
                self.keep(&c.path, observers, progress);
                written = (self.position.step, Clock::now());
            }
        };
        if let (Some(c), Outcome::Completed) = (file, &end) {
            self.keep(&c.path, observers, progress);
        }
        Ok(self.finish(end))
    }

    /// Writes a checkpoint. A failure is only a warning: a disk that is full now may have room at the next.
    fn keep(&self, path: &std::path::Path, observers: &mut [&mut dyn Observe], progress: &dyn Progress) {
        if let Err(error) = self.save(path, observers) {
            progress.warn(&format!("{error}; the run continues without it"));
        }
    }

    fn finish(self, outcome: Outcome) -> Run {
        Run {
            time: self.time(),
            outcome,
            state: self.state,
            statics: self.statics,
            balance: self.balance,
            cost: self.newton.cost(),
            cuts: self.position.cuts,
            shortest: self.position.shortest,
            longest: self.position.longest,
            refused: self.strides.map_or(0, |s| s.refused),
        }
    }

    fn unit(&self) -> f64 {
        f64::from(1_u32 << self.settings.halvings)
    }

    fn time(&self) -> f64 {
        let grid = &self.settings.grid;
        let part = f64::from(self.position.at) / self.unit();
        if self.position.at == 0 {
            return grid.time(self.position.step);
        }
        grid.time(self.position.step) + part * grid.h()
    }

    /// Applies the constant loads and the free strains; returns the end of the march if there is no equilibrium.
    fn start_static(&mut self, progress: &dyn Progress) -> Result<Option<Outcome>, AnalysisError> {
        let settings = self.settings;
        if settings.start.is_some() || settings.constant.iter().all(|p| *p == 0.0) {
            return Ok(None);
        }
        let (newton, state) = (&mut self.newton, &mut self.state);
        let path = lasting_path(newton, state, &settings.constant, settings.load_steps, progress)?;
        let end = match &path.failure {
            Some(failure) => Some(Outcome::Collapsed(Collapse::new(0.0, Some(path.factor), failure.clone()))),
            None if path.factor < 1.0 - 1e-12 => Some(Outcome::Interrupted),
            None => None,
        };
        self.statics = Some(path);
        Ok(end)
    }

    /// Time functions at part `f` of nominal step `i`.
    fn at(&self, i: usize, f: f64) -> Vec<f64> {
        let ground = self.load.ground.iter().map(Option::as_ref);
        let motions = ground.chain(self.load.forces.iter().map(|(_, m)| Some(m)));
        let value = |m: Option<&crate::analysis::motion::Motion>| {
            m.map_or(0.0, |m| {
                let (a, b) = m.interval(i);
                if f == 1.0 { b } else { a + f * (b - a) }
            })
        };
        motions.map(value).collect()
    }

    /// All loads at these values of the time functions.
    fn load_vector(&self, functions: &[f64], out: &mut Vec<f64>) {
        out.clear();
        match self.settings.constant.is_empty() {
            true => out.resize(self.problem.system.size(), 0.0),
            false => out.extend_from_slice(&self.settings.constant),
        }
        self.add_functions(functions, out);
    }

    fn add_functions(&self, functions: &[f64], out: &mut [f64]) {
        for (k, &f) in functions.iter().enumerate().filter(|(_, f)| **f != 0.0) {
            let (shape, factor) = match k {
                0..3 => (&self.problem.system.inertia[k], -f),
                _ => (&self.load.forces[k - 3].0, f),
            };
            for (p, s) in out.iter_mut().zip(shape) {
                *p += factor * s;
            }
        }
    }

    /// Jump of the acceleration where the loads jump.
    fn jump(&mut self) -> Result<(), AnalysisError> {
        let begin = self.at(self.position.step, 0.0);
        let change: Vec<f64> = begin.iter().zip(&self.functions).map(|(b, e)| b - e).collect();
        if change.iter().all(|c| *c == 0.0) {
            return Ok(());
        }
        let mut force = vec![0.0; self.problem.system.size()];
        self.add_functions(&change, &mut force);
        self.functions = begin;
        self.newton.accelerate(&mut self.state, &force, self.settings.grid.h())
    }

    /// Nominal steps in the next step.
    fn stride(&self, unit: u32) -> usize {
        let Position { step, part, .. } = self.position;
        match &self.strides {
            Some(strides) if part == unit => strides.next(step, self.load),
            _ => 1,
        }
    }

    /// One step, cut as often as it needs; the number of nominal steps that are complete. The inner error is a collapse.
    // Long: every way a step can end.
    fn advance(&mut self, observers: &mut [&mut dyn Observe]) -> Result<Result<usize, StepFailure>, AnalysisError> {
        let unit = 1_u32 << self.settings.halvings;
        let (mut p0, mut p1) = (Vec::new(), Vec::new());
        let begin = match self.newton.committed_forces(&mut self.state) {
            Ok(forces) => forces,
            Err(failure) => return Ok(Err(failure)),
        };
        self.meter.begin(&self.state, begin);
        let viscous = self.newton.viscous().cloned();
        loop {
            let Position { step, at, part, .. } = self.position;
            let stride = self.stride(unit);
            let ends = [at, at + part].map(|x| f64::from(x) / self.unit());
            self.load_vector(&self.at(step, ends[0]), &mut p0);
            let functions = self.at(step + stride - 1, ends[1]);
            self.load_vector(&functions, &mut p1);
            let h = self.settings.grid.h() * (ends[1] - ends[0]) * stride as f64;
            let scheme = self.settings.scheme.with_step(h)?;
            let last = part == 1 && stride == 1;
            let tried = self.newton.attempt(&scheme, &mut self.state, [&p0, &p1], last);
            let error = self.strides.as_ref().map_or(0.0, |s| s.error(&scheme, &self.state));
            if let Some(strides) = &mut self.strides
                && stride > 1
                && tried.is_ok()
                && strides.too_long(error)
            {
                self.newton.take_back(&mut self.state);
                strides.shrink();
                continue;
            }
            match self.newton.conclude(tried, &mut self.state) {
                Ok(report) => {
                    let forces = match self.newton.committed_forces(&mut self.state) {
                        Ok(forces) => forces,
                        Err(failure) => return Ok(Err(failure)),
                    };
                    self.meter.end(&self.state, forces, [&p0, &p1], &self.settings.constant, &scheme, viscous.as_ref());
                    self.functions = functions;
                    self.position.shortest = self.position.shortest.min(h);
                    self.position.longest = self.position.longest.max(h);
                    let done = self.grow(unit, stride);
                    if let Some(strides) = &mut self.strides
                        && part == unit
                        && stride == strides.now()
                    {
                        strides.accept(error, self.position.step, &self.state);
                    }
                    if let Err(failure) = self.show(observers, report.iterations, h) {
                        return Ok(Err(failure));
                    }
                    return Ok(Ok(done));
                }
                Err(_) if stride > 1 => {
                    if let Some(strides) = &mut self.strides {
                        strides.shrink();
                    }
                }
                Err(failure) if part == 1 => return Ok(Err(failure)),
                Err(_) => {
                    if let Some(strides) = &mut self.strides {
                        strides.reset();
                    }
                    self.position.part = part / 2;
                    self.position.easy = 0;
                    self.position.cuts += 1;
                }
            }
        }
    }

    /// Advances by the part that has converged, or by `stride` nominal steps; returns the number of those complete.
    fn grow(&mut self, unit: u32, stride: usize) -> usize {
        let p = &mut self.position;
        p.at += p.part;
        p.easy += 1;
        let done = p.at == unit;
        if done {
            p.at = 0;
            p.step += stride;
        }
        if p.easy >= self.settings.recovery && p.part < unit && p.at.is_multiple_of(2 * p.part) {
            p.part *= 2;
            p.easy = 0;
        }
        if done { stride } else { 0 }
    }

    /// Energies, and the observers.
    fn show(&mut self, observers: &mut [&mut dyn Observe], iterations: usize, step: f64) -> Result<(), StepFailure> {
        let Position { step: i, at, .. } = self.position;
        let grid = &self.settings.grid;
        let sample = (at == 0 && i.is_multiple_of(grid.sub_steps)).then(|| i / grid.sub_steps);
        if sample.is_some() {
            self.meter.sample(&self.state);
            self.balance.samples.push(self.meter.now);
        }
        let energies = self.meter.now;
        let b = &mut self.balance;
        b.worst = b.worst.max(energies.residual().abs());
        b.largest = b.largest.max(energies.input.abs()).max(energies.kinetic.abs());
        let time = self.time();
        let forces = self.newton.committed_forces(&mut self.state)?;
        let now = Instant {
            problem: self.problem,
            time,
            sample,
            state: &self.state,
            forces,
            ground: [0, 1, 2].map(|k| self.functions[k]),
            energies,
            iterations,
            step,
        };
        observers.iter_mut().for_each(|o| o.see(&now));
        Ok(())
    }

    fn save(&self, path: &std::path::Path, observers: &mut [&mut dyn Observe]) -> Result<(), CheckpointError> {
        let mut to = Writer::default();
        let p = &self.position;
        for count in [p.step, p.at as usize, p.part as usize, p.easy, p.cuts as usize] {
            to.count(count);
        }
        to.numbers(&[p.shortest, p.longest]);
        if let Some(strides) = &self.strides {
            strides.save(&mut to);
        }
        to.state(&self.state);
        to.numbers(&self.functions);
        self.meter.save(&mut to);
        self.balance.save(&mut to);
        self.newton.save(&mut to);
        to.count(observers.len());
        for observer in observers.iter() {
            let mut part = Writer::default();
            observer.save(&mut part);
            to.part(part);
        }
        to.save(path, self.identity)
    }

    fn restore(&mut self, path: &std::path::Path, observers: &mut [&mut dyn Observe]) -> Result<(), AnalysisError> {
        let mut from = Reader::open(path, self.identity)?;
        let p = &mut self.position;
        let unit = 1_u64 << self.settings.halvings;
        p.step = from.count_within("the step", 0..=self.settings.grid.steps() as u64, "a step of the run")? as usize;
        p.at = from.count_within("the place in the step", 0..=unit - 1, "less than a step")? as u32;
        p.part = from.count_within("the part of the step", 1..=unit, "a step or less")? as u32;
        if !p.part.is_power_of_two() || !p.at.is_multiple_of(p.part) {
            return Err(CheckpointError::Value {
                what: "the part of the step",
                found: p.part.into(),
                allowed: "a power of two that divides its place",
            }
            .into());
        }
        p.easy = from.count()?;
        p.cuts = from.count()? as u64;
        let mut lengths = [0.0; 2];
        from.numbers_into("lengths of steps", &mut lengths)?;
        [p.shortest, p.longest] = lengths;
        if let Some(strides) = &mut self.strides {
            strides.restore(&mut from)?;
        }
        from.state_into(&mut self.state)?;
        from.numbers_into("time functions", &mut self.functions)?;
        self.meter.restore(&mut from)?;
        self.balance = Balance::restore(&mut from)?;
        self.newton.restore(&mut from, &self.state)?;
        let found = from.count()?;
        if found != observers.len() {
            return Err(CheckpointError::Shape { what: "observers", found, allowed: observers.len() }.into());
        }
        for observer in observers.iter_mut() {
            observer.restore(&mut from.part()?)?;
        }
        Ok(())
    }
}
