//! The whole flow of a verification under a set of records: each record by procedures and engine, then the set.
//!
//! ```text
//! spectra of the set ─ rule of the code ─ one factor
//! one model ─ a run a record ─ quantities and checks of each ─ mean or worst ─ columns, checks, verdict
//! ```
//!
//! Engines build their model once. Histories, spectra, profiles and sheets of the results are those of one record, which is named;
//! what stands for the set are the quantities and the checks.

mod design;

use std::collections::BTreeMap;

use codes::record_set::standard::{Combine, Standard};
use codes::record_set::{Component, Horizontal, Ratios};
use codes::time_history::Findings;
use fem::progress::Progress;
use files::code::{Code, Warning};
use oscillator::record::Record;
use oscillator::spectrum::ordinates;
use tank::Quantity;
use tank::assessment::Excitation;
use tank::case::GroundMotion;
use tank::demand::Footing;
use tank::hazard::SpectrumTable;
use tank::outside::Outside;

use self::design::Rules;
use crate::error::Error;
use crate::job::Job;
use crate::pipeline::{self, Outcome, ground_motion};
use crate::study::rule::{self, Answer, FIVE, Question, Wanted};
use engines::{FeError, Shared, Simulation, solid};
use results::{Compatibility, EngineId, Method, SetPeriod, SourceFile};

/// Every how many of the periods of the rule the curves of the results keep one.
const KEPT: usize = 4;

/// A verification under a set of records.
#[derive(Clone, Debug)]
pub struct SetJob {
    /// The job without ground motion; at most one engine, the harmonic or the three-dimensional one.
    pub job: Job,
    /// Title of the set; may be empty.
    pub name: String,
    /// The records: three or more, all with the same components.
    pub records: Vec<Earthquake>,
    /// Standard whose rules are asked.
    pub code: Standard,
    /// The design value.
    pub combine: Combine,
    /// Target; none for the spectrum of the site.
    pub table: Option<SpectrumTable>,
    /// Name of the target.
    pub target: String,
    /// Factor on all records that is in them.
    pub factor: f64,
    /// Whether the set is scaled to the rule.
    pub fit: bool,
}

/// A record of a set.
#[derive(Clone, Debug)]
pub struct Earthquake {
    /// Its name, unique in the set.
    pub id: String,
    /// As applied, before the factor of the rule.
    pub motion: GroundMotion,
    /// Its components as read.
    pub raw: Vec<Record>,
    /// Longest period of which each of them says something [s], where its file gives it.
    pub usable: Vec<Option<f64>>,
    /// Their files.
    pub files: Vec<SourceFile>,
}

impl SetJob {
    /// The job with the longest record, for estimates.
    pub fn longest(&self) -> Job {
        let duration = |i: &usize| self.records[*i].motion.duration();
        let longest = (0..self.records.len()).max_by(|a, b| duration(a).total_cmp(&duration(b)));
        match longest {
            Some(i) => under(self, i),
            None => self.job.clone(),
        }
    }

    /// Takes engines and options of a job.
    ///
    /// Errors: more than one engine, or the nonlinear one.
    pub fn adopt(&mut self, job: &Job) -> Result<(), Error> {
        if job.engines.len() > 1 || job.engines.contains(&EngineId::Nonlinear) {
            return Err(Error::conflict(
                "--fe: a set of records runs with one linear engine, expected harmonic, solid or none\n  help: run nonlinear engines record \
                 by record, or as a study (`tankcheck study`)",
            ));
        }
        self.job =
            Job { case: self.job.case.clone(), raw_records: Vec::new(), usable_periods: Vec::new(), ..job.clone() };
        Ok(())
    }
}

impl Earthquake {
    fn horizontal(&self) -> Horizontal<'_> {
        Horizontal { along: &self.motion.horizontal, across: self.motion.transverse.as_ref() }
    }

    /// Longest period of which both horizontal components say something [s].
    fn usable(&self) -> Option<f64> {
        let components = 1 + usize::from(self.motion.transverse.is_some());
        self.usable.iter().take(components).flatten().copied().reduce(f64::min)
    }

    fn scale(&mut self, factor: f64) {
        let GroundMotion { horizontal, transverse, vertical } = &mut self.motion;
        let components = std::iter::once(horizontal).chain(transverse).chain(vertical);
        for record in components {
            for a in &mut record.acceleration {
                *a *= factor;
            }
            record.processing.push(format!("times the factor of the set, {factor:.6}"));
        }
    }
}

/// The run under one record.
#[derive(Default)]
struct Under {
    methods: Vec<Method>,
    values: BTreeMap<Quantity, f64>,
    findings: Findings,
    limits_exceeded: Vec<String>,
}

impl Under {
    /// Takes the values, findings and limits of a run of the engine.
    ///
    /// * `errors`: relative mesh errors by quantity id
    fn take(&mut self, job: &Job, simulation: &mut Simulation, errors: &BTreeMap<String, f64>) {
        let demands = simulation.demands.get_or_insert_default();
        self.findings = pipeline::findings(job, demands, errors);
        let exceeded = simulation.result.limits.iter().filter(|l| !l.holds);
        self.limits_exceeded = exceeded.map(|l| l.id.clone()).collect();
        self.values.clone_from(&simulation.values);
        // A mean or maximum leaves out forces of a wall that is held down: the tank does not have them.
        if matches!(demands.footing, Footing::Beyond { .. }) {
            self.values.retain(|quantity, _| !results::compare::depends(*quantity, Outside::Uplift));
        }
    }
}

/// Runs a job. `volatile` of the results is empty except for the version.
///
/// Errors: as [`pipeline::run`], with the name of the record; a rule that is to be fitted without a target.
pub fn run(set: &SetJob, progress: &dyn Progress) -> Result<Outcome, Error> {
    let mut set = set.clone();
    pipeline::admit(&under(&set, 0))?;
    let case = set.job.case.clone();
    let motions: Vec<&GroundMotion> = set.records.iter().map(|r| &r.motion).collect();
    let model = match set.job.engines.first() {
        Some(EngineId::Harmonic) => {
            progress.stage("wall, liquid and modes", 1);
            Some(Model::Harmonic(Box::new(Shared::new(&case, &set.job.linear, &motions)?)))
        }
        Some(EngineId::Solid) => {
            let job = under(&set, 0);
            Some(Model::Solid(Box::new(solid::Shared::new(&job.case, &job.linear, &job.solid, progress)?)))
        }
        _ => None,
    };
    let modes = match &model {
        Some(Model::Harmonic(shared)) => shared.periods(),
        _ => [None; 2],
    };
    let wanted = match rule::periods(&case, &set.job.decision) {
        Ok(wanted) => wanted,
        Err(_) => rule::both(&case, modes.map(|period| Some((period?, "finite elements")))),
    };
    let (compatibility, no_target) = match compatible(&mut set, &wanted) {
        Ok((found, misses)) => {
            let warning = misses.map(|text| Warning::new(Code::UnusualRecord, text));
            set.job.warnings.extend(warning);
            (Some(found), String::new())
        }
        Err(error) if set.fit => return Err(error),
        Err(error) => (None, rule::reason(&error)),
    };
    let horizontal: Vec<Horizontal<'_>> = set.records.iter().map(Earthquake::horizontal).collect();
    let rules = Rules { compatibility, no_target, of_site: ground_motion::ask(&set.job, &wanted, &horizontal) };
    let impulsive = modes[0].or_else(|| wanted.iter().find(|w| w.which == "impulsive").map(|w| w.period));
    let shown = strongest(&set.records, impulsive);
    let (mut simulation, mut errors) = (None, BTreeMap::new());
    let mut runs: Vec<Option<Under>> = set.records.iter().map(|_| None).collect();
    let others = (0..set.records.len()).filter(|&i| i != shown);
    for (done, i) in std::iter::once(shown).chain(others).enumerate() {
        progress.stage(&format!("record {} of {}", done + 1, set.records.len()), 1);
        let job = under(&set, i);
        let of_record = |error: Error| named(error, &set.records[i].id);
        let mut run = Under {
            methods: pipeline::procedures::under(&job, Excitation::Record).map_err(of_record)?,
            ..Under::default()
        };
        if let Some(mut found) = run_engine(&job, model.as_ref(), i == shown, progress).map_err(of_record)? {
            if i == shown {
                errors.clone_from(&found.result.mesh_error);
            }
            run.take(&job, &mut found, &errors);
            if i == shown {
                simulation = Some(found);
            }
        }
        runs[i] = Some(run);
    }
    let runs: Vec<Under> = runs.into_iter().flatten().collect();
    let design = design::of_set(&set, &runs, shown, rules);
    let mut job = under(&set, shown);
    // That of the results first.
    job.files.extend(set.records[shown].files.clone());
    let rest = set.records.iter().enumerate().filter(|(i, _)| *i != shown);
    job.files.extend(rest.flat_map(|(_, record)| record.files.clone()));
    if !job.case.measured.is_empty() {
        job.warnings.push(Warning::new(
            Code::NotUsed,
            "`measured`: measured values belong to one ground motion and are not compared with a set of records",
        ));
    }
    pipeline::run_set(&job, simulation.into_iter().collect(), design)
}

/// The model of a tank, which serves all records.
enum Model {
    Harmonic(Box<Shared>),
    Solid(Box<solid::Shared>),
}

/// The run of the engine under the motion of a job; none without an engine.
fn run_engine(
    job: &Job,
    model: Option<&Model>,
    shown: bool,
    progress: &dyn Progress,
) -> Result<Option<Simulation>, Error> {
    let (Some(model), Some(motion)) = (model, &job.case.ground_motion) else { return Ok(None) };
    let simulation = match model {
        Model::Harmonic(shared) => {
            let mut simulation = shared.run(motion, shown, progress)?;
            if shown {
                shared.finish(&mut simulation, motion)?;
            }
            simulation
        }
        Model::Solid(shared) => {
            let mut simulation = shared.respond(&job.case, &job.linear, progress)?;
            if shown {
                shared.finish((&job.case, &job.linear, &job.solid), &mut simulation, progress)?;
            }
            simulation
        }
    };
    if simulation.result.incomplete {
        return Err(Error::Fe(FeError::Interrupted { stage: "a set of records".into() }));
    }
    Ok(Some(simulation))
}

/// The job under one record.
fn under(set: &SetJob, i: usize) -> Job {
    let record = &set.records[i];
    let mut job = set.job.clone();
    job.case.ground_motion = Some(record.motion.clone());
    job.raw_records.clone_from(&record.raw);
    job.usable_periods.clone_from(&record.usable);
    job
}

/// The error of a record with its name.
fn named(error: Error, id: &str) -> Error {
    match error {
        Error::Files(files::error::Error::Input(code, text)) => {
            Error::input(code, format!("{}\n  record: {id}", text.trim_end()))
        }
        other => other,
    }
}

/// The record with the largest spectral acceleration at the impulsive period, 5 % damped; with the largest peak where there is no such period.
fn strongest(records: &[Earthquake], period: Option<f64>) -> usize {
    let size = |record: &Record| match period {
        Some(period) => ordinates(record, period, FIVE).psa,
        None => record.pga(),
    };
    let of = |earthquake: &Earthquake| {
        let Horizontal { along, across } = earthquake.horizontal();
        size(along).hypot(across.map_or(0.0, size))
    };
    let sizes: Vec<f64> = records.iter().map(of).collect();
    (0..sizes.len()).fold(0, |best, i| if sizes[i] > sizes[best] { i } else { best })
}

/// The set against its target, and in what it misses it; a set that is to be fitted is scaled first.
///
/// Errors: no target; one that ends too early; no periods.
fn compatible(set: &mut SetJob, wanted: &[Wanted]) -> Result<(Compatibility, Option<String>), Error> {
    if wanted.is_empty() {
        return Err(Error::missing("no procedure and no engine gives a period of this tank"));
    }
    let question =
        Question { code: set.code, table: set.table.as_ref(), target: &set.target, site: &set.job.case.site, wanted };
    let ask = |records: &[Earthquake]| {
        let horizontal: Vec<Horizontal<'_>> = records.iter().map(Earthquake::horizontal).collect();
        rule::answer(&question, &horizontal)
    };
    let mut answer = ask(&set.records)?;
    if set.fit {
        // The digits that a product loses.
        let factor = answer.factor * (1.0 + 1e-12);
        set.records.iter_mut().for_each(|record| record.scale(factor));
        set.factor *= factor;
        answer = ask(&set.records)?;
        answer.holds |= set.records.len() >= set.code.fewest() && answer.factor < 1.0 + 1e-9;
    }
    Ok((compatibility(set, &answer), answer.misses(set.code, set.records.len())))
}

fn compatibility(set: &SetJob, answer: &Answer) -> Compatibility {
    let code = set.code;
    let thin = |values: &[f64]| -> Vec<f64> { values.iter().step_by(KEPT).copied().collect() };
    let period = |(wanted, ratios): &(Wanted, Ratios)| SetPeriod {
        which: wanted.which.into(),
        period: wanted.period,
        damping: wanted.damping,
        range: code.range().map(|r| r * wanted.period),
        component: match ratios.component {
            Component::Along => "x",
            Component::Across => "y",
            Component::Both => "largest",
        }
        .into(),
        smallest_ratio: ratios.smallest.0,
        at_period: ratios.smallest.1,
        holds: ratios.smallest.0 >= code.share() * (1.0 - 1e-9),
        periods: thin(&ratios.periods),
        target: thin(&ratios.target),
        mean: thin(&ratios.mean),
        records: ratios.records.iter().map(|r| thin(r)).collect(),
    };
    Compatibility {
        clause: code.clause().into(),
        target: set.target.clone(),
        holds: answer.holds,
        factor: answer.factor,
        fewest_records: code.fewest(),
        share: code.share(),
        mean_zero_period_ratio: answer.zero,
        periods: answer.periods.iter().map(period).collect(),
    }
}
