//! The engine beside the harmonic one.

use fem::progress::Progress;

use crate::error::{EXIT_COMPUTATION, Error};
use crate::job::{Engines, Job};
use engines::{self, FeError, Simulation};
use results::FeResult;
use results::compare::Happened;
use results::nonlinear::End;

/// What the second engine of a job gives.
#[derive(Default)]
pub(super) struct Second {
    /// Its run.
    pub run: Option<Simulation>,
    /// Why there is none though one was asked for: a sentence without capital and full stop.
    pub missing: Option<String>,
}

/// Runs the second engine, if the job has one. Stopped or failed before it has anything, it leaves the first one's report.
///
/// Errors: bad input, and a failure of the three-dimensional engine.
pub(super) fn run(job: &Job, progress: &dyn Progress) -> Result<Second, Error> {
    let Some(options) = &job.fe else {
        return Ok(Second::default());
    };
    let (name, outcome) = match job.engines {
        Engines::Harmonic | Engines::Solid => return Ok(Second::default()),
        Engines::Both => (
            "three-dimensional",
            engines::solid::simulate(&job.case, options, &job.solid, progress),
        ),
        Engines::Nonlinear => (
            "nonlinear",
            engines::nonlinear::simulate(&job.case, &job.nonlinear, job.checkpoint.as_ref(), progress),
        ),
    };
    let missing = |what: String| {
        Ok(Second {
            run: None,
            missing: Some(format!("the {name} run {what}")),
        })
    };
    match outcome.map_err(Error::Fe) {
        Ok(simulation) => Ok(Second {
            run: Some(simulation),
            missing: None,
        }),
        Err(Error::Fe(FeError::Interrupted { .. })) => missing("was interrupted before it had a result".into()),
        Err(error) if job.engines == Engines::Nonlinear && error.exit_code() == EXIT_COMPUTATION => {
            missing(format!("failed before it had a result ({error})"))
        }
        Err(error) => Err(error),
    }
}

/// Why the results are not those of the whole ground motion, a sentence without its full stop; empty if they are, or if
/// an interruption says it.
pub(super) fn incomplete(missing: Option<String>, nonlinear: Option<&FeResult>) -> String {
    let run = nonlinear.and_then(|fe| fe.nonlinear.as_ref());
    match (missing, run.map(|n| &n.end)) {
        (Some(missing), _) => format!("Incomplete: {missing}"),
        (None, Some(End::Collapsed { time, .. })) if *time < 0.0 => {
            "Collapse: the wall does not carry weight and pressure at rest".into()
        }
        (None, Some(End::Collapsed { time, .. })) => {
            format!("Collapse: the nonlinear run finds no equilibrium after {time:.2} s, its extremes are lower bounds")
        }
        (None, Some(End::Left { time, .. })) => {
            format!(
                "The nonlinear run left its model and was stopped at {time:.2} s, its extremes are those until then"
            )
        }
        (None, Some(End::Interrupted { time })) => {
            format!("Incomplete: the nonlinear run was interrupted at {time:.2} s, its extremes are not final")
        }
        (None, Some(End::Completed) | None) => match run.and_then(|n| n.departures.first()) {
            Some(first) => format!(
                "The nonlinear run left its model at {:.2} s, what comes later is no result",
                first.time
            ),
            None => String::new(),
        },
    }
}

/// What the comparison needs to know of the nonlinear run.
pub(super) fn happened(linear: Option<&FeResult>, nonlinear: Option<&FeResult>) -> Option<Happened> {
    let fe = nonlinear?;
    let run = fe.nonlinear.as_ref()?;
    let damping = |fe: &FeResult| {
        let line = fe.integration.iter().find(|l| l.label == "damping")?;
        Some(line.text.clone())
    };
    let last = |values: &[f64]| values.last().copied().unwrap_or(0.0);
    Some(Happened {
        end: run.end.clone(),
        events: run.events.clone(),
        hysteretic: last(&run.energies.hysteretic),
        input: last(&run.energies.input),
        damping: linear.and_then(damping).zip(damping(fe)).map(|(a, b)| [a, b]),
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_missing_run_says_why() {
        let reason = incomplete(Some("the nonlinear run failed".into()), None);
        assert_eq!(reason, "Incomplete: the nonlinear run failed");
        assert!(incomplete(None, None).is_empty());
    }
}
