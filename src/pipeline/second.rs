//! The engine beside the harmonic one.

use engines::damping::Damper;
use fem::progress::Progress;

use crate::error::{EXIT_COMPUTATION, Error};
use crate::job::{Engines, Job};
use engines::{self, FeError, Simulation, nonlinear};
use results::FeResult;
use results::compare::{Damping, Happened, Incomplete, SecondEngine};
use results::nonlinear::End;

/// What the second engine of a job gives.
#[derive(Default)]
pub(super) struct Second {
    /// Its run.
    pub run: Option<Simulation>,
    /// Why there is none though one was asked for.
    pub missing: Option<Incomplete>,
}

/// Runs the second engine, if the job has one. Stopped or failed before it has anything, it leaves the first one's report.
///
/// Errors: bad input, and a failure of the three-dimensional engine.
pub(super) fn run(job: &Job, progress: &dyn Progress) -> Result<Second, Error> {
    let Some(options) = &job.fe else {
        return Ok(Second::default());
    };
    let (engine, outcome) = match job.engines {
        Engines::Harmonic | Engines::Solid => return Ok(Second::default()),
        Engines::Both => (
            SecondEngine::Solid,
            engines::solid::simulate(&job.case, options, &job.solid, progress),
        ),
        Engines::Nonlinear => (
            SecondEngine::Nonlinear,
            nonlinear::simulate(&job.case, &job.nonlinear, job.checkpoint.as_ref(), progress),
        ),
    };
    let missing = |error: Option<String>| {
        Ok(Second {
            run: None,
            missing: Some(Incomplete::Missing { engine, error }),
        })
    };
    match outcome.map_err(Error::Fe) {
        Ok(simulation) => Ok(Second {
            run: Some(simulation),
            missing: None,
        }),
        Err(Error::Fe(FeError::Interrupted { .. })) => missing(None),
        Err(error) if job.engines == Engines::Nonlinear && error.exit_code() == EXIT_COMPUTATION => {
            missing(Some(error.to_string()))
        }
        Err(error) => Err(error),
    }
}

/// Why the results are not those of the whole ground motion; none if they are, or if the user stopped a linear run.
pub(super) fn incomplete(missing: Option<Incomplete>, nonlinear: Option<&FeResult>) -> Option<Incomplete> {
    if missing.is_some() {
        return missing;
    }
    let run = nonlinear.and_then(|fe| fe.nonlinear.as_ref())?;
    match run.end {
        End::Collapsed { time, .. } if time < 0.0 => Some(Incomplete::NotCarriedAtRest),
        End::Collapsed { time, .. } => Some(Incomplete::NoEquilibrium { time }),
        End::Left { time, .. } => Some(Incomplete::LeftModel { time }),
        End::Interrupted { time } => Some(Incomplete::Interrupted { time }),
        End::Completed => run
            .departures
            .first()
            .map(|first| Incomplete::BeyondModel { time: first.time }),
    }
}

/// What the comparison needs to know of the nonlinear run.
pub(super) fn happened(job: &Job, nonlinear: Option<&FeResult>) -> Option<Happened> {
    let run = nonlinear?.nonlinear.as_ref()?;
    let last = |values: &[f64]| values.last().copied().unwrap_or(0.0);
    Some(Happened {
        end: run.end.clone(),
        events: run.events.clone(),
        hysteretic: last(&run.energies.hysteretic),
        input: last(&run.energies.input),
        damping: linear_damping(job).map(|linear| [linear, nonlinear_damping(&job.nonlinear.damping)]),
    })
}

/// Damping of the harmonic run.
fn linear_damping(job: &Job) -> Option<Damping> {
    let model = &job.fe.as_ref()?.damping;
    Some(match Damper::new(&job.case, model).ok()? {
        Damper::ByKind { sloshing, structural } => Damping::Modal { sloshing, structural },
        Damper::Rayleigh(c) => Damping::Rayleigh {
            mass: c.mass,
            stiffness: c.stiffness,
        },
    })
}

/// Damping of the nonlinear run.
fn nonlinear_damping(damping: &nonlinear::Damping) -> Damping {
    match *damping {
        nonlinear::Damping::ByGroup { wall, sloshing } => Damping::ByGroup { wall, sloshing },
        nonlinear::Damping::Rayleigh { first, second, .. } => Damping::InitialRayleigh {
            first: first.into(),
            second: second.into(),
        },
        nonlinear::Damping::MassProportional { ratio, .. } => Damping::MassProportional { ratio },
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_missing_run_is_the_cause() {
        let missing = Incomplete::Missing {
            engine: SecondEngine::Nonlinear,
            error: Some("the solver failed".into()),
        };
        assert_eq!(incomplete(Some(missing.clone()), None), Some(missing));
        assert_eq!(incomplete(None, None), None);
    }
}
