//! The runs of the engines: in sequence, as columns of the comparison, with the reason for an incomplete one.

use codes::time_history::{self, Findings};
use fem::progress::Progress;
use files::code::Code;
use tank::Course;
use tank::assessment::Excitation;
use tank::demand::Demands;
use tank::options::linear::LiquidModel;

use super::quantities::with_crest;
use super::{decision, unsaid};
use crate::error::{EXIT_COMPUTATION, Error};
use crate::job::Job;
use engines::damping::Damper;
use engines::{FeError, Simulation, engine, nonlinear};
use results::compare::{Damping, Happened, Incomplete};
use results::nonlinear::End;
use results::{EngineId, LeftOut, Method, Omittable, Run};

/// Why an engine other than the default one has no nonlinear liquid.
const NO_NONLINEAR: &str = "a nonlinear liquid (--liquid nonlinear, `analysis.liquid`) is one of the default engine\n  help: remove it, or run the \
                            default engine too (--fe both)";

/// Rejects a job with input that one of its engines does not support.
///
/// Errors: the first refusal.
pub(super) fn admit(job: &Job) -> Result<(), Error> {
    let task = job.task();
    let refused = job.engines.iter().find_map(|&id| engine(id).refuses(&task).into_iter().next());
    let default = job.engines.is_empty() || job.engines.contains(&EngineId::Harmonic);
    if job.linear.liquid == LiquidModel::Nonlinear && !default {
        return Err(Error::input(Code::Unsupported, NO_NONLINEAR.into()));
    }
    let Some(refusal) = refused else { return Ok(()) };
    let mut text = refusal.message.clone();
    for (word, what) in [("found", &refusal.found), ("expected", &refusal.allowed)] {
        if !what.is_empty() {
            text.push_str(&format!(", {word} {what}"));
        }
    }
    if !refusal.help.is_empty() {
        text.push_str(&format!("\n  help: {}", refusal.help));
    }
    Err(Error::input(Code::Unsupported, text))
}

/// Runs the engines after the first. If one stops or fails without results, the report contains the runs before it, and the
/// reason is returned.
///
/// Errors: bad input.
pub(super) fn beside(
    job: &Job,
    simulations: &mut Vec<Simulation>,
    progress: &dyn Progress,
) -> Result<Option<Incomplete>, Error> {
    for &id in job.engines.iter().skip(1) {
        let missing = |error: Option<String>| Ok(Some(Incomplete::Missing { engine: id, error }));
        match engine(id).run(&job.task(), progress).map_err(Error::Fe) {
            Ok(simulation) => {
                // Those of the last engine are drawn.
                if simulation.snapshots.is_some() {
                    simulations.iter_mut().for_each(|earlier| earlier.snapshots = None);
                }
                simulations.push(simulation);
            }
            Err(Error::Fe(FeError::Interrupted { .. })) => return missing(None),
            Err(error) if error.exit_code() == EXIT_COMPUTATION => return missing(Some(error.to_string())),
            Err(error) => return Err(error),
        }
    }
    Ok(None)
}

/// Demands of a run against the capacities of the codes.
pub(super) fn findings(job: &Job, simulation: &Simulation) -> Findings {
    let none = Demands::default();
    let demands = simulation.demands.as_ref().unwrap_or(&none);
    let judges = time_history::counted(&job.case, &job.decision.decide);
    time_history::assess(&job.case, &judges, demands, &simulation.result.mesh_error)
}

/// A run as a column of the comparison.
pub(super) fn method(job: &Job, number: usize, simulation: &Simulation, findings: Findings) -> Method {
    let id = simulation.result.engine;
    let mut assumptions = simulation.assumptions.clone();
    if !engine(id).has_layers() {
        assumptions.extend(layers(job).map(String::from));
    }
    Method {
        label: id.label(number).into(),
        figure_key: id.figure_key(number).into(),
        quantities: with_crest(&job.case, &simulation.values),
        assumptions,
        notes: [simulation.notes.clone(), findings.notes].concat(),
        checks: decision::checks_of_run(job, id.column(number), unsaid::leave_open(job, findings.checks)),
        steps: findings.steps,
        courses: findings.courses,
        ..Method::new(id.column(number), id.title(), Excitation::Record)
    }
}

/// Note on the equivalent wall of a method for one material, if the wall has layers.
pub(super) fn layers(job: &Job) -> Option<&'static str> {
    job.case.tank.courses.iter().find_map(Course::layer_assumption)
}

/// Why the results do not cover the whole ground motion; `None` if they do, or if the user stopped a linear run.
pub(super) fn incomplete(missing: Option<Incomplete>, runs: &[Run]) -> Option<Incomplete> {
    missing.or_else(|| runs.iter().find_map(ended))
}

/// Why a run does not cover the whole ground motion.
fn ended(run: &Run) -> Option<Incomplete> {
    let departures = &run.nonlinear.as_ref()?.departures;
    match run.end {
        End::Collapsed { time, .. } if time < 0.0 => Some(Incomplete::NotCarriedAtRest),
        End::Collapsed { time, .. } => Some(Incomplete::NoEquilibrium { time }),
        End::Left { time, .. } => Some(Incomplete::LeftModel { time }),
        End::Interrupted { time } => Some(Incomplete::Interrupted { time }),
        End::Completed => departures.first().map(|first| Incomplete::BeyondModel { time: first.time }),
    }
}

/// What the results have not, because nobody needs it: softer and harder ground is that of a base that moves.
pub(super) fn left_out(job: &Job, runs: &[Run]) -> Vec<LeftOut> {
    let would_have = |part: &&Omittable| match part {
        Omittable::Grounds => runs.iter().any(|run| run.base.is_some()),
        Omittable::MeshError | Omittable::Envelopes | Omittable::Histories => true,
    };
    let parts = job.without.iter().filter(would_have);
    parts.map(|part| LeftOut::of(*part)).collect()
}

/// Facts of the nonlinear run for the comparison.
pub(super) fn happened(job: &Job, runs: &[Run]) -> Option<Happened> {
    let (run, nonlinear) = runs.iter().find_map(|run| Some((run, run.nonlinear.as_ref()?)))?;
    let last = |values: &[f64]| values.last().copied().unwrap_or(0.0);
    Some(Happened {
        end: run.end.clone(),
        events: run.events.clone(),
        hysteretic: last(&nonlinear.energies.hysteretic),
        input: last(&nonlinear.energies.input),
        damping: linear_damping(job).map(|linear| [linear, nonlinear_damping(&job.nonlinear.damping)]),
    })
}

/// Damping of the harmonic run.
fn linear_damping(job: &Job) -> Option<Damping> {
    let model = &job.linear.damping;
    Some(match Damper::new(&job.case, model).ok()? {
        Damper::ByKind { sloshing, structural } => Damping::Modal { sloshing, structural },
        Damper::ByGroup { wall, sloshing, .. } => Damping::ByGroup { wall, sloshing },
        Damper::Caughey(caughey) => Damping::Caughey {
            pairs: caughey.pairs().len(),
            first: caughey.pairs().first().copied().unwrap_or_default().into(),
            last: caughey.pairs().last().copied().unwrap_or_default().into(),
        },
        Damper::Rayleigh(c) => Damping::Rayleigh { mass: c.mass, stiffness: c.stiffness },
    })
}

/// Damping of the nonlinear run.
fn nonlinear_damping(damping: &nonlinear::Damping) -> Damping {
    match *damping {
        nonlinear::Damping::ByGroup { wall, sloshing } => Damping::ByGroup { wall, sloshing },
        nonlinear::Damping::Rayleigh { first, second, .. } => {
            Damping::InitialRayleigh { first: first.into(), second: second.into() }
        }
        nonlinear::Damping::MassProportional { ratio, .. } => Damping::MassProportional { ratio },
    }
}

#[cfg(test)]
mod tests {
    use results::EngineId;

    use super::*;

    #[test]
    fn a_missing_run_is_the_cause() {
        let missing = Incomplete::Missing { engine: EngineId::Nonlinear, error: Some("the solver failed".into()) };
        assert_eq!(incomplete(Some(missing.clone()), &[]), Some(missing));
        let harmonic = Run::new(EngineId::Harmonic);
        assert_eq!(incomplete(None, std::slice::from_ref(&harmonic)), None);
    }
}
