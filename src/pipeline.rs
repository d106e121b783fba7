//! The whole flow of a verification in one function. Procedures and engine use the same [`Job`] and are
//! independent of each other; [`compare`] joins their results.

mod attribution;
mod columns;
mod decision;
mod design;
pub mod ground_motion;
mod measured;
mod motion;
pub mod procedures;
mod quantities;
mod roof_wave;
mod runs;
mod series;
mod site;
mod standing;
mod unsaid;

use std::collections::BTreeMap;

use codes::base_state;
use codes::time_history::{self, Findings, Ready};
use fem::progress::Progress;
use tank::Quantity;
use tank::assessment::Check;
use tank::demand::Demands;
use tank::ingredients::Ingredients;

use self::columns::Columns;
pub use self::design::{Design, Records};
use self::procedures::{Assessed, assess};
use crate::error::Error;
use crate::job::Job;
use engines::{Simulation, engine};
use results::compare::{Context, Incomplete};
use results::{EngineId, FORMAT, Method, RecordSummary, Results, Series, Snapshots, Verdict, Volatile, finite};

/// Results of a job.
#[derive(Clone, Debug)]
pub struct Outcome {
    /// For `results.json`.
    pub results: Results,
    /// For `series.csv`.
    pub series: Series,
    /// States of the last engine that has some, if requested.
    pub snapshots: Option<(EngineId, Snapshots)>,
}

/// Runs a job: procedures, engines, comparison. `volatile` is empty except for the version.
///
/// Errors: input that an engine does not support, a procedure that does not converge, a failure of an engine, a result that is
/// not finite.
pub fn run(job: &Job, progress: &dyn Progress) -> Result<Outcome, Error> {
    runs::admit(job)?;
    let computed = assess_and_simulate(job, progress)?;
    assemble(job, computed, None)
}

/// Rejects a job with input that one of its engines does not support.
///
/// Errors: the first refusal.
pub fn admit(job: &Job) -> Result<(), Error> {
    runs::admit(job)
}

/// The results of a job under a set of records, of which one is that of the job.
///
/// * `simulations`: the run of the engine under that record; none without an engine
///
/// Errors: as [`run`].
pub fn run_set(job: &Job, simulations: Vec<Simulation>, design: Design) -> Result<Outcome, Error> {
    let computed = (assess(job)?, motion::records(job), simulations, None);
    assemble(job, computed, Some(design))
}

/// Joins procedures and runs.
///
/// Errors: a result that is not finite.
fn assemble(job: &Job, computed: Computed, design: Option<Design>) -> Result<Outcome, Error> {
    let (assessed, mut records, mut simulations, missing) = computed;
    let (mut methods, ingredients): (Vec<Method>, Vec<Vec<Ingredients>>) = assessed.into_iter().unzip();
    // Histories as computed; next to those of a longer run they are NaN after their end.
    for (number, simulation) in simulations.iter().enumerate() {
        finite::check_series(simulation.result.engine.column(number), &simulation.series)?;
    }
    let snapshots = simulations.iter_mut().rev().find_map(|s| Some((s.result.engine, s.snapshots.take()?)));
    let spectra = motion::spectra(job, &tank_periods(&methods, simulations.first()));
    let of_engine = simulations.first().and_then(|s| s.values.get(&Quantity::SloshingPeriod).copied());
    motion::mark(&mut records, of_engine.or_else(|| sloshing_period(&methods)));
    for simulation in &mut simulations {
        attribution::separate(job, simulation);
    }
    let mut context = Context::default();
    match &design {
        // One record is attributed; the design value of a set has no single way to that of a procedure.
        None => context.attribution = attribution::attribute(job, &methods, &ingredients, simulations.first()),
        Some(design) => design::procedures(&mut methods, design),
    }
    let mut columns = Columns::of(methods);
    for (number, simulation) in simulations.into_iter().enumerate() {
        // A thread of its own: checks print and fill sheets as their thread is set.
        let (findings, site) = std::thread::scope(|scope| {
            let site = scope.spawn(|| site::column(job, number, &simulation));
            let motion = job.case.ground_motion.as_ref();
            let findings = motion.map(|_| of_run(job, number, &simulation, design.as_ref()));
            let site = site.join().unwrap_or_else(|panic| std::panic::resume_unwind(panic));
            (findings, site)
        });
        columns.add(job, simulation, (findings, site), design.as_ref());
    }
    // Measured values belong to one record.
    if design.is_none() {
        columns.methods.extend(measured::column(job));
    }
    let comparison = columns.compare(job, context);
    let Columns { methods, runs, series, .. } = columns;
    let roof = roof_wave::part(job, &methods);
    let cause = runs::incomplete(missing, &runs);
    let unfinished = cause.is_some() || runs.iter().any(|run| run.incomplete);
    let verdict = Verdict {
        unstated: job.decision.unstated.clone(),
        overruled: decision::overruled(job, &methods),
        ..results::verdict(&methods, decision::deciding(job, &methods), unfinished, cause)
    };
    let warnings = [job.warnings.clone(), decision::unused(job, &methods)].concat();
    let not_computed = runs::left_out(job, &runs);
    let results = Results {
        format: FORMAT.into(),
        volatile: Volatile { version: env!("CARGO_PKG_VERSION").into(), ..Volatile::default() },
        name: job.case.name.clone(),
        project: job.project.clone(),
        files: job.files.clone(),
        input: job.echo.clone(),
        tank: job.tank(),
        records,
        record_set: design.map(|design| design.set),
        spectra,
        parts: roof.into_iter().collect(),
        methods,
        runs,
        comparison,
        verdict,
        warnings,
        not_computed,
    };
    finite::check_results(&results)?;
    Ok(Outcome { results, series, snapshots })
}

/// Demands of a run under the record, or those of a set, against the capacities of the codes and the rule for the records.
fn of_run(job: &Job, number: usize, simulation: &Simulation, design: Option<&Design>) -> Findings {
    let mut findings = match design {
        Some(design) => design.findings.clone(),
        None => runs::findings(job, simulation),
    };
    if simulation.demands.as_ref().is_some_and(|demands| demands.base.is_none()) {
        base_state::overstressed(&mut findings.checks);
    }
    if ground_motion::asked(job, simulation.result.engine.column(number)) {
        let records = match design {
            Some(design) => design.records.clone(),
            None => ground_motion::of_one(job, simulation),
        };
        let check = match records {
            Some(records) => ground_motion::check(job, &records),
            None => time_history::without_code(&job.case),
        };
        findings.checks.extend(check);
    }
    findings
}

/// The first sloshing period that a procedure gives [s].
pub fn sloshing_period(methods: &[Method]) -> Option<f64> {
    let of = |m: &Method| m.quantities.get(Quantity::SloshingPeriod.id()).map(|v| v.value);
    methods.iter().find_map(of)
}

/// Demands of a run against the capacities of the codes.
///
/// * `errors`: relative mesh errors by quantity id
pub fn findings(job: &Job, demands: &Demands, errors: &BTreeMap<String, f64>) -> Findings {
    let judges = time_history::counted(&job.case, &job.decision.decide);
    time_history::assess(&job.case, &judges, demands, errors)
}

/// Adds what only figures need, before results are written: the base of an unanchored tank under the moments of the codes.
///
/// Errors: a value that is not finite.
pub fn draw(job: &Job, results: &mut Results) -> Result<(), Error> {
    let standing = standing::standing(job, &results.methods);
    results.parts.extend(standing.map(|found| found.part(&results.methods)));
    finite::check("the base", &results.parts)?;
    Ok(())
}

/// The checks of the demands of the first engine under the record times a factor, which is 1 where the response is not linear.
pub fn checks_of_demands(job: &Job, ready: &Ready<'_>, factor: f64) -> Vec<Check> {
    let judges = time_history::counted(&job.case, &job.decision.decide);
    let found = time_history::assess_at(&job.case, &judges, (ready, factor), &BTreeMap::new());
    decision::checks_of_run(job, results::FE, found.checks)
}

/// Results of the procedures, the records and the engines, and the reason if those of the engines are incomplete.
type Computed = (Vec<Assessed>, Vec<RecordSummary>, Vec<Simulation>, Option<Incomplete>);

/// Runs procedures and engines, the first engine in parallel with the procedures.
fn assess_and_simulate(job: &Job, progress: &dyn Progress) -> Result<Computed, Error> {
    let task = job.task();
    let mut first = None;
    let codes = rayon::in_place_scope(|scope| {
        if let Some(id) = job.engines.first() {
            scope.spawn(|_| first = Some(engine(*id).run(&task, progress)));
        }
        assess(job).map(|methods| (methods, motion::records(job)))
    });
    let (methods, records) = codes?;
    let mut simulations: Vec<Simulation> = first.transpose()?.into_iter().collect();
    let missing = runs::beside(job, &mut simulations, progress)?;
    Ok((methods, records, simulations, missing))
}

/// Periods of the tank [s]: the first modes of the engine, or those of the procedures without an engine.
fn tank_periods(methods: &[Method], simulation: Option<&Simulation>) -> Vec<f64> {
    match simulation {
        Some(simulation) => {
            let modes = simulation.result.modes.iter().filter(|m| m.harmonic == 1 && m.number <= 3);
            modes.map(|m| m.period).collect()
        }
        None => {
            let ids = [Quantity::SloshingPeriod.id(), Quantity::ImpulsivePeriod.id()];
            let values = methods.iter().flat_map(|m| ids.iter().filter_map(|id| m.quantities.get(*id)));
            values.map(|v| v.value).collect()
        }
    }
}
