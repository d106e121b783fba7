//! Static load paths.

use super::*;
use crate::element::Stage;

/// A static path that was followed.
#[derive(Clone, Debug, PartialEq)]
pub struct LoadPath {
    /// Load factor reached: 1 at the end.
    pub factor: f64,
    /// (load factor, iterations) of every step.
    pub steps: Vec<(f64, usize)>,
    /// Why the path ended before 1.
    pub failure: Option<StepFailure>,
}

/// Smallest part of the nominal step that is tried.
const SMALLEST: f64 = 1.0 / 64.0;

/// Applies `constant` + λ `load`, λ from 0 to 1 in `steps` nominal steps; a step that fails is halved, down to 1/64, and after
/// four steps that converge the length is doubled again up to the nominal one. `each` sees every committed state.
///
/// Interrupted or at a limit point, it returns how far it came.
///
/// Errors: loads of wrong length, no step.
pub fn load_path(
    newton: &mut Newton<'_>,
    state: &mut State,
    constant: &[f64],
    load: &[f64],
    steps: usize,
    progress: &dyn Progress,
    each: impl FnMut(f64, &State),
) -> Result<LoadPath, AnalysisError> {
    check_length("constant load", constant.len(), newton.model.dofs().len())?;
    let at = |factor: f64| constant.iter().zip(load).map(|(c, p)| c + factor * p).collect();
    follow(newton, state, (load, &at), steps, progress, |_, _| {}, each)
}

/// Applies λ `load` and the share λ of all free strains ([`Stage::Lasting`]) in the same way. At the end the stage is [`Stage::Short`].
///
/// Errors: those of [`load_path`].
pub fn lasting_path(
    newton: &mut Newton<'_>,
    state: &mut State,
    load: &[f64],
    steps: usize,
    progress: &dyn Progress,
) -> Result<LoadPath, AnalysisError> {
    let model = newton.model;
    let at = |factor: f64| load.iter().map(|p| factor * p).collect();
    let set = |state: &mut State, factor: f64| state.stage(model, Stage::Lasting(factor));
    let path = follow(newton, state, (load, &at), steps, progress, set, |_, _| {})?;
    state.stage(model, Stage::Lasting(path.factor));
    state.stage(model, Stage::Short);
    Ok(path)
}

/// The loads `at` every λ; `before` a step to λ the committed state may be changed.
fn follow(
    newton: &mut Newton<'_>,
    state: &mut State,
    (load, at): (&[f64], &dyn Fn(f64) -> Vec<f64>),
    steps: usize,
    progress: &dyn Progress,
    before: impl Fn(&mut State, f64),
    mut each: impl FnMut(f64, &State),
) -> Result<LoadPath, AnalysisError> {
    check_length("load", load.len(), newton.model.dofs().len())?;
    if steps == 0 {
        return Err(AnalysisError::Option { option: "load steps", found: "0".into(), allowed: "1 or more".into() });
    }
    progress.stage("load steps", steps as u64);
    let mut path = LoadPath { factor: 0.0, steps: Vec::new(), failure: None };
    let nominal = 1.0 / steps as f64;
    let (mut part, mut easy, mut told) = (1.0, 0, 0);
    while path.factor < 1.0 - 1e-12 && !progress.interrupted() {
        let next = (path.factor + part * nominal).min(1.0);
        before(state, next);
        match newton.step(&LoadStep, state, &at(path.factor), &at(next)) {
            Ok(report) => {
                path.factor = next;
                path.steps.push((next, report.iterations));
                each(next, state);
                easy += 1;
                if easy == 4 && part < 1.0 {
                    (part, easy) = (2.0 * part, 0);
                }
                let done = (next * steps as f64 + 1e-9) as u64;
                progress.advance(done - told);
                told = done;
            }
            Err(_) if part > SMALLEST => (part, easy) = (0.5 * part, 0),
            Err(failure) => {
                path.failure = Some(failure);
                break;
            }
        }
    }
    Ok(path)
}
