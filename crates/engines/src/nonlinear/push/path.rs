//! The path of one shell: load steps, then an arc through the limit point.

use fem::analysis::checkpoint::{CheckpointError, Reader, Writer};
use fem::analysis::continuation::{Constraint, Continuation, Memory, StepLength};
use fem::dofs::Dof;
use fem::progress::Progress;
use fem::state::State;

use super::continuation::{analysis, continuation};
use super::imperfection::Dent;
use super::keep::Keeper;
use super::model::{Plan, PushModel};
use super::seen::Seen;
use crate::FeError;

/// Load steps over gravity, and the shortest of them.
const FIRST: f64 = 0.1;
const LEAST: f64 = 0.01;
/// Load steps of an unanchored tank over gravity: contact opens in them.
const FIRST_FREE: f64 = 0.02;
/// Load steps of weight and liquid on the way to rest of an unanchored tank, and how often one is halved.
const RESTING: u32 = 10;
const HALVINGS: u32 = 6;
/// The path of an unanchored tank ends with this rotation of its foot [rad],
const TURNED: f64 = 0.02;
/// or where this part of the modelled plate is off the ground.
const LIFTED: f64 = 0.9;
/// The path ends this far beyond its maximum.
const FALL: f64 = 0.97;
/// Largest acceleration over gravity.
const MOST: f64 = 10.0;
/// Most states of a path.
pub(super) const STATES: usize = 120;
/// A step of the arc over the first one at most.
const LONGEST: f64 = 4.0;

/// A path that was followed.
pub(super) struct Followed<'a> {
    /// Its states.
    pub(super) seen: Seen<'a>,
    /// Why it ends, in words; `None` if the user stopped it.
    pub(super) end: Option<String>,
}

/// Follows the path of a shell, from where `from` has it; `keeper` writes checkpoints.
///
/// Errors: a model that cannot be built; a static state without equilibrium; an interruption before the first load step;
/// a checkpoint of another model.
pub(super) fn follow<'a>(
    plan: &'a Plan<'a>,
    imperfection: Option<&Dent>,
    name: &'static str,
    from: Option<Reader>,
    keeper: &mut Keeper<'_>,
    progress: &dyn Progress,
) -> Result<Followed<'a>, FeError> {
    let model = plan.build(imperfection)?;
    progress.stage(name, STATES as u64);
    let mut walk = Walk::new(plan, &model);
    if let Some(mut from) = from {
        walk.restore(&mut from).map_err(|fault| keeper.unusable(fault))?;
        progress.advance(walk.seen.len() as u64);
    }
    loop {
        if progress.interrupted() {
            if walk.seen.len() > 0 {
                keeper.save(Some(walk.save()), progress);
            }
            if !walk.arc.is_finite() {
                return Err(FeError::Interrupted { stage: name.into() });
            }
            return Ok(Followed { seen: walk.seen, end: None });
        }
        let before = walk.seen.len();
        let end = walk.attempt()?;
        progress.advance((walk.seen.len() - before) as u64);
        if let Some(end) = end {
            return Ok(Followed { seen: walk.seen, end: Some(end) });
        }
        if walk.seen.len() > before && keeper.due() {
            keeper.save(Some(walk.save()), progress);
        }
    }
}

/// A path under way: everything that its next step depends on.
struct Walk<'a, 'm> {
    plan: &'a Plan<'a>,
    model: &'m PushModel,
    state: State,
    seen: Seen<'a>,
    /// Acceleration of the last load step [m/s²].
    reached: f64,
    /// The next load step [m/s²], zero for the static state.
    step: f64,
    /// ‖Δu‖ of a load step of [`FIRST`]; not finite before there is one.
    arc: f64,
    /// The path beyond the load steps.
    along: Option<Along<'m>>,
}

/// The arc from the last load step on, in its pattern.
struct Along<'m> {
    path: Continuation<'m>,
    /// Next step.
    length: f64,
    /// Largest acceleration so far [m/s²].
    largest: f64,
    /// Number of states when it began.
    first: usize,
}

impl<'a, 'm> Walk<'a, 'm> {
    fn new(plan: &'a Plan<'a>, model: &'m PushModel) -> Walk<'a, 'm> {
        Walk {
            plan,
            model,
            state: State::new(&model.model),
            seen: Seen::new(plan),
            reached: 0.0,
            step: 0.0,
            arc: f64::NAN,
            along: None,
        }
    }

    /// Tries one step; a reason if the path ends there.
    fn attempt(&mut self) -> Result<Option<String>, FeError> {
        match self.along {
            Some(_) => self.arc_step(),
            None => self.load_step().map(|()| self.off_the_ground()),
        }
    }

    /// A reason to end the path of an unanchored tank.
    fn off_the_ground(&self) -> Option<String> {
        let (base, plate) = (self.seen.last()?.base?, self.plan.plate.as_ref()?);
        if base.rotation > TURNED {
            Some(format!("stopped with a rotation of the foot of {TURNED} rad"))
        } else if base.lifted_width > LIFTED * plate.width() {
            Some("stopped where the uplift reaches the part of the plate that is held down in the model".into())
        } else {
            None
        }
    }

    /// Weight and liquid in load steps, as contact needs them.
    fn settle(&mut self) -> Result<(), FeError> {
        let weight = &self.model.weight;
        let none = vec![0.0; weight.len()];
        let mut path = continuation(self.model, &none, weight)?;
        let (mut step, mut halvings) = (1.0 / f64::from(RESTING), 0);
        while path.factor() < 1.0 {
            let next = path.factor() + step;
            // A sum of steps may miss 1 by its rounding.
            let next = if next > 1.0 - 1e-9 { 1.0 } else { next };
            match path.step(&mut self.state, &Constraint::Load(next)) {
                Ok(_) => {}
                Err(_) if halvings < HALVINGS => {
                    step *= 0.5;
                    halvings += 1;
                }
                Err(failure) => {
                    return Err(FeError::Analysis(format!(
                        "the bottom finds no rest under {:.0} % of weight and liquid: {failure}",
                        100.0 * next
                    )));
                }
            }
        }
        Ok(())
    }

    fn first(&self) -> f64 {
        if self.plan.plate.is_some() { FIRST_FREE } else { FIRST }
    }

    /// Load steps while there is an equilibrium; suction is removed again at each. The arc-length steps start where there is none.
    fn load_step(&mut self) -> Result<(), FeError> {
        let gravity = self.plan.case.gravity;
        if self.reached > MOST * gravity {
            return self.begin_arc();
        }
        let (model, step) = (self.model, self.step);
        if step == 0.0 && model.bottom.is_some() {
            self.settle()?;
            self.seen.see(model, 0.0, &self.state)?;
            self.step = self.first() * gravity;
            return Ok(());
        }
        let before = self.state.committed.u.clone();
        let next = self.reached + step;
        let mut load = model.load(next).0;
        load.iter_mut().zip(&model.weight).for_each(|(f, w)| *f += w);
        let none = vec![0.0; load.len()];
        match continuation(model, &load, &none)?.step(&mut self.state, &Constraint::Load(0.0)) {
            Ok(_) => {
                self.reached = next;
                self.seen.see(model, next, &self.state)?;
                self.arc = model.translations(&before, &self.state.committed.u) * self.first() * gravity / step;
                self.step = if step == 0.0 { self.first() * gravity } else { step };
            }
            Err(failure) if step == 0.0 => {
                return Err(FeError::Analysis(format!(
                    "the wall does not carry its weight and the hydrostatic pressure: {failure}"
                )));
            }
            Err(_) if step > LEAST / FIRST * self.first() * gravity => self.step *= 0.5,
            Err(_) => return self.begin_arc(),
        }
        Ok(())
    }

    fn begin_arc(&mut self) -> Result<(), FeError> {
        if !self.arc.is_finite() {
            return Err(FeError::Analysis(format!("no equilibrium at {LEAST} g, the smallest load step")));
        }
        self.along = Some(Along {
            path: self.pattern()?,
            length: self.lengths().first,
            largest: self.reached,
            first: self.seen.len(),
        });
        Ok(())
    }

    /// Arcs in the pattern of the last load step.
    fn pattern(&self) -> Result<Continuation<'m>, FeError> {
        let (mut constant, slope) = self.model.load(self.reached);
        constant.iter_mut().zip(&self.model.weight).for_each(|(f, w)| *f += w);
        continuation(self.model, &constant, &slope)
    }

    fn lengths(&self) -> StepLength {
        StepLength { first: 0.1 * self.arc, shortest: self.arc / 500.0, longest: LONGEST * self.arc }
    }

    fn arc_step(&mut self) -> Result<Option<String>, FeError> {
        let (lengths, gravity) = (self.lengths(), self.plan.case.gravity);
        let Some(along) = &mut self.along else { return Ok(None) };
        let point = match along.path.arc(&mut self.state, lengths, &mut along.length) {
            Ok(Some(point)) => point,
            Ok(None) => return Ok(None),
            Err(failure) => return Ok(Some(format!("no further equilibrium was found: {failure}"))),
        };
        let acceleration = self.reached + point.factor;
        self.seen.see(self.model, acceleration, &self.state)?;
        along.largest = along.largest.max(acceleration);
        let (largest, first) = (along.largest, along.first);
        if let Some(end) = self.off_the_ground() {
            return Ok(Some(end));
        }
        Ok(if acceleration < FALL * largest {
            Some(format!("followed until {:.0} % of the maximum", 100.0 * FALL))
        } else if acceleration > MOST * gravity {
            Some(format!("stopped at {MOST} g: the wall does not fail in this pattern"))
        } else if self.seen.len() >= first.saturating_add(STATES) {
            Some(format!("stopped after {STATES} states"))
        } else {
            None
        })
    }

    fn save(&self) -> Writer {
        let mut to = Writer::default();
        to.state(&self.state);
        self.seen.save(&mut to);
        to.numbers(&[self.reached, self.step, self.arc]);
        to.count(usize::from(self.along.is_some()));
        if let Some(along) = &self.along {
            let memory = along.path.memory();
            to.numbers(&[along.length, along.largest, memory.factor]);
            to.count(along.first);
            to.count(usize::from(memory.last.is_some()));
            memory.last.iter().for_each(|last| to.numbers(last));
        }
        to
    }

    /// Errors: a payload that is not of this plan and model.
    fn restore(&mut self, from: &mut Reader) -> Result<(), FeError> {
        from.state_into(&mut self.state)?;
        self.seen = Seen::restore(self.plan, from)?;
        let mut numbers = [0.0; 3];
        from.numbers_into("the load steps", &mut numbers)?;
        [self.reached, self.step, self.arc] = numbers;
        if from.count()? == 0 {
            return Ok(());
        }
        if !(self.arc.is_finite() && self.arc >= 0.0) {
            return Err(FeError::Checkpoint(CheckpointError::Value {
                what: "the length of the arc",
                found: self.arc,
                allowed: "a finite number from 0 on",
            }));
        }
        let mut numbers = [0.0; 3];
        from.numbers_into("the arc", &mut numbers)?;
        let [length, largest, factor] = numbers;
        let first = from.count()?;
        let last = match from.count()? {
            0 => None,
            _ => {
                let mut last = vec![0.0; self.state.committed.u.len()];
                from.numbers_into("the increment of the last step", &mut last)?;
                Some(last)
            }
        };
        let mut path = self.pattern()?;
        path.recall(Memory { factor, last }).map_err(analysis)?;
        self.along = Some(Along { path, length, largest, first });
        Ok(())
    }
}

impl PushModel {
    /// ‖b − a‖ over the translations.
    fn translations(&self, a: &[f64], b: &[f64]) -> f64 {
        let dofs = self.model.dofs();
        let counts = |e: &usize| matches!(dofs.unknown(*e).1, Dof::Ux | Dof::Uy | Dof::Uz);
        let squares = (0..dofs.len()).filter(counts).map(|e| (b[e] - a[e]).powi(2));
        squares.sum::<f64>().sqrt()
    }
}
