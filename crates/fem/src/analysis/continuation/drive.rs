//! Many steps: through given displacements, along an arc, up to the first instability.

use super::{AnalysisError, Constraint, Continuation, PathPoint, StepFailure};
use crate::progress::Progress;
use crate::state::State;

/// Where a path under growing load loses its stability.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Critical {
    /// Largest load factor that was found stable.
    pub stable: f64,
    /// Smallest load factor beyond it that was not.
    pub beyond: f64,
    /// Negative eigenvalues there: 1 or more at a bifurcation, `None` where no equilibrium was found (a limit point).
    pub negative: Option<usize>,
}

/// How long steps are.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct StepLength {
    /// First one.
    pub first: f64,
    /// Shortest before the path ends, > 0.
    pub shortest: f64,
    /// Longest.
    pub longest: f64,
}

impl StepLength {
    /// From 1/64 to 4 times the first one.
    pub fn around(first: f64) -> StepLength {
        StepLength { first, shortest: first.abs() / 64.0, longest: 4.0 * first.abs() }
    }

    /// Length after a step of length `s` that took so many iterations: up to 7 double, up to 12 the same, else 0.7 times.
    fn after(&self, s: f64, iterations: usize) -> f64 {
        let factor = match iterations {
            0..=7 => 2.0,
            8..=12 => 1.0,
            _ => 0.7,
        };
        (factor * s).clamp(self.shortest, self.longest)
    }
}

/// A path that was followed.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Path {
    /// Its states, the start excluded.
    pub points: Vec<PathPoint>,
    /// Why it ended early.
    pub failure: Option<StepFailure>,
}

impl Continuation<'_> {
    /// Displacement c · u through all `targets`; steps are cut where they fail and lengthened where they are easy. `each`
    /// sees the state at every target.
    ///
    /// Errors: a row without an unknown. A path that ends early gives the reason in [`Path::failure`].
    pub fn to_displacements(
        &mut self,
        state: &mut State,
        row: &[(usize, f64)],
        targets: &[f64],
        length: StepLength,
        progress: &dyn Progress,
        mut each: impl FnMut(f64, &PathPoint, &State),
    ) -> Result<Path, AnalysisError> {
        if row.is_empty() {
            return Err(AnalysisError::option("controlled displacement", "a held or unused dof", "an unknown"));
        }
        let value = |state: &State| row.iter().map(|&(e, c)| c * state.committed.u[e]).sum::<f64>();
        let mut path = Path::default();
        let mut step = length.first.abs();
        progress.stage("displacement steps", targets.len() as u64);
        for &target in targets {
            loop {
                let rest = target - value(state);
                let whole = rest.abs() <= step * (1.0 + 1e-9);
                let end = if whole { target } else { target - rest + step.copysign(rest) };
                if progress.interrupted() {
                    return Ok(path);
                }
                match self.step(state, &Constraint::Displacement(row.to_vec(), end)) {
                    Ok(point) => {
                        step = length.after(step, point.iterations);
                        path.points.push(point.clone());
                        if whole {
                            each(target, &point, state);
                            break;
                        }
                    }
                    Err(_) if 0.5 * step.min(rest.abs()) >= length.shortest => step = 0.5 * step.min(rest.abs()),
                    Err(failure) => {
                        path.failure = Some(failure);
                        return Ok(path);
                    }
                }
            }
            progress.advance(1);
        }
        Ok(path)
    }

    /// Arc-length steps until `done` returns true; it sees every state. A path that ends early gives the reason in [`Path::failure`].
    pub fn along(
        &mut self,
        state: &mut State,
        length: StepLength,
        progress: &dyn Progress,
        mut done: impl FnMut(&PathPoint, &State) -> bool,
    ) -> Path {
        let mut path = Path::default();
        let mut step = length.first;
        while !progress.interrupted() {
            match self.arc(state, length, &mut step) {
                Ok(None) => {}
                Ok(Some(point)) => {
                    path.points.push(point.clone());
                    if done(&point, state) {
                        break;
                    }
                }
                Err(failure) => {
                    path.failure = Some(failure);
                    break;
                }
            }
        }
        path
    }

    /// One step along the arc of length `step`, which becomes that of the next step; `None` if the step failed and is to be tried
    /// again at half its length.
    ///
    /// Errors: no step, not even with the shortest length.
    pub fn arc(
        &mut self,
        state: &mut State,
        length: StepLength,
        step: &mut f64,
    ) -> Result<Option<PathPoint>, StepFailure> {
        match self.step(state, &Constraint::Arc(*step)) {
            Ok(point) => {
                *step = length.after(*step, point.iterations);
                Ok(Some(point))
            }
            Err(_) if 0.5 * *step >= length.shortest => {
                *step *= 0.5;
                Ok(None)
            }
            Err(failure) => Err(failure),
        }
    }

    /// Raises λ in steps of `step` up to `largest` and halves them where the state is unstable, or where there is none, down to
    /// `tolerance`. `state` is then the last stable one, and [`Continuation::lowest_mode`] is the mode of buckling. A bifurcation
    /// is seen although the path itself continues undisturbed.
    ///
    /// Errors: no unstable state up to `largest`; a first state that is not stable.
    pub fn first_instability(
        &mut self,
        state: &mut State,
        step: f64,
        tolerance: f64,
        largest: f64,
        progress: &dyn Progress,
    ) -> Result<Critical, AnalysisError> {
        let watched = std::mem::replace(&mut self.watch, true);
        let mut step = step;
        let mut found = None;
        while self.lambda < largest && !progress.interrupted() {
            let (before, start) = (state.clone(), self.lambda);
            let next = start + step;
            let negative = match self.step(state, &Constraint::Load(next)) {
                Ok(point) if point.negative == Some(0) => continue,
                Ok(point) => point.negative,
                Err(_) => None,
            };
            *state = before;
            self.lambda = start;
            found = Some(Critical { stable: start, beyond: next, negative });
            if step <= tolerance {
                break;
            }
            step = (0.5 * step).max(tolerance);
        }
        self.watch = watched;
        found.ok_or_else(|| {
            AnalysisError::option(
                "largest load factor of a search for instability",
                format!("stable up to {:.4}", self.lambda),
                "one beyond the first instability",
            )
        })
    }
}
