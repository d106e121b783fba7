//! The whole flow of a verification under a set of records: each record by procedures and engine, then the set.
//!
//! ```text
//! spectra of the set ─ rule of the code ─ one factor
//! one model ─ a run a record ─ quantities and checks of each ─ mean or worst ─ columns, checks, verdict
//! ```
//!
//! The harmonic engine builds its model once. Histories, spectra, profiles and sheets of the results are those of one record, which is named;
//! what stands for the set are the quantities and the checks.

use std::collections::BTreeMap;

use codes::record_set::design::{self, Combined, Scatter};
use codes::record_set::standard::{Combine, Standard};
use codes::record_set::{Component, Horizontal, Ratios};
use codes::time_history::Findings;
use fem::progress::Progress;
use files::code::{Code, Warning};
use oscillator::record::Record;
use oscillator::spectrum::ordinates;
use tank::Quantity;
use tank::assessment::{Check, Excitation};
use tank::case::GroundMotion;
use tank::demand::{Demands, Footing};
use tank::hazard::SpectrumTable;
use tank::outside::Outside;

use crate::error::Error;
use crate::job::Job;
use crate::pipeline::{self, Design, Outcome, Records, ground_motion};
use crate::study::rule::{self, Answer, FIVE, Question, Wanted};
use engines::{FeError, Shared, Simulation, engine};
use results::{
    Compatibility, EngineId, FE, Method, RecordSet, SetCheck, SetPeriod, SetQuantity, SetRun, SetScatter, SourceFile,
    Value,
};

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
            return Err(Error::input(Code::OptionConflict,
                "--fe: a set of records runs with one linear engine, expected harmonic, solid or none\n  help: run nonlinear engines record \
                 by record, or as a study (`tankcheck study`)"
                    .into(),
            ));
        }
        self.job = Job {
            case: self.job.case.clone(),
            raw_records: Vec::new(),
            usable_periods: Vec::new(),
            ..job.clone()
        };
        Ok(())
    }
}

impl Earthquake {
    fn horizontal(&self) -> Horizontal<'_> {
        Horizontal {
            along: &self.motion.horizontal,
            across: self.motion.transverse.as_ref(),
        }
    }

    /// Longest period of which both horizontal components say something [s].
    fn usable(&self) -> Option<f64> {
        let components = 1 + usize::from(self.motion.transverse.is_some());
        self.usable.iter().take(components).flatten().copied().reduce(f64::min)
    }

    fn scale(&mut self, factor: f64) {
        let GroundMotion {
            horizontal,
            transverse,
            vertical,
        } = &mut self.motion;
        let components = std::iter::once(horizontal).chain(transverse).chain(vertical);
        for record in components {
            for a in &mut record.acceleration {
                *a *= factor;
            }
            record
                .processing
                .push(format!("times the factor of the set, {factor:.6}"));
        }
    }
}

/// The run under one record.
struct Under {
    methods: Vec<Method>,
    values: BTreeMap<Quantity, f64>,
    findings: Findings,
    limits_exceeded: Vec<String>,
}

/// Runs a job. `volatile` of the results is empty except for the version.
///
/// Errors: as [`pipeline::run`], with the name of the record; a rule that is to be fitted without a target.
pub fn run(set: &SetJob, progress: &dyn Progress) -> Result<Outcome, Error> {
    let mut set = set.clone();
    pipeline::admit(&under(&set, 0))?;
    let case = set.job.case.clone();
    let motions: Vec<&GroundMotion> = set.records.iter().map(|r| &r.motion).collect();
    let shared = match set.job.engines.first() {
        Some(EngineId::Harmonic) => {
            progress.stage("wall, liquid and modes", 1);
            Some(Shared::new(&case, &set.job.linear, &motions)?)
        }
        _ => None,
    };
    let modes = shared.as_ref().map_or([None; 2], Shared::periods);
    let wanted = match rule::periods(&case, &set.job.decision) {
        Ok(wanted) => wanted,
        Err(_) => rule::both(&case, modes.map(|period| Some((period?, "finite elements")))),
    };
    let compatibility = compatible(&mut set, &wanted);
    let (compatibility, no_target) = match compatibility {
        Ok((found, misses)) => {
            let warning = misses.map(|text| Warning::new(Code::UnusualRecord, text));
            set.job.warnings.extend(warning);
            (Some(found), String::new())
        }
        Err(error) if set.fit => return Err(error),
        Err(error) => (None, rule::reason(&error)),
    };
    let of_site = {
        let horizontal: Vec<Horizontal<'_>> = set.records.iter().map(Earthquake::horizontal).collect();
        ground_motion::ask(&set.job, &wanted, &horizontal)
    };
    let impulsive = modes[0].or_else(|| wanted.iter().find(|w| w.which == "impulsive").map(|w| w.period));
    let shown = strongest(&set.records, impulsive);
    let (mut simulation, mut errors) = (None, BTreeMap::new());
    let mut runs: Vec<Option<Under>> = set.records.iter().map(|_| None).collect();
    let others = (0..set.records.len()).filter(|&i| i != shown);
    for (done, i) in std::iter::once(shown).chain(others).enumerate() {
        progress.stage(&format!("record {} of {}", done + 1, set.records.len()), 1);
        let record = &set.records[i];
        let job = under(&set, i);
        let of_record = |error: Error| named(error, &record.id);
        let methods = pipeline::under(&job, Excitation::Record).map_err(of_record)?;
        let found = run_engine(&job, shared.as_ref(), i == shown, progress).map_err(of_record)?;
        let (mut values, mut findings, mut limits_exceeded) = (BTreeMap::new(), Findings::default(), Vec::new());
        if let Some(mut found) = found {
            if i == shown {
                errors.clone_from(&found.result.mesh_error);
            }
            let demands = found.demands.take().unwrap_or_else(Demands::default);
            findings = pipeline::findings(&job, &demands, &errors);
            limits_exceeded = found
                .result
                .limits
                .iter()
                .filter(|l| !l.holds)
                .map(|l| l.id.clone())
                .collect();
            values.clone_from(&found.values);
            // A mean or maximum leaves out forces of a wall that is held down: the tank does not have them.
            if matches!(demands.footing, Footing::Beyond { .. }) {
                values.retain(|quantity, _| !results::compare::depends(*quantity, Outside::Uplift));
            }
            if i == shown {
                found.demands = Some(demands);
                simulation = Some(found);
            }
        }
        runs[i] = Some(Under {
            methods,
            values,
            findings,
            limits_exceeded,
        });
    }
    let runs: Vec<Under> = runs.into_iter().flatten().collect();
    let design = designed(&set, &runs, shown, (compatibility, no_target, of_site));
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

/// The run of the engine under the motion of a job; none without an engine.
fn run_engine(
    job: &Job,
    shared: Option<&Shared>,
    shown: bool,
    progress: &dyn Progress,
) -> Result<Option<Simulation>, Error> {
    let (Some(&id), Some(motion)) = (job.engines.first(), &job.case.ground_motion) else {
        return Ok(None);
    };
    let simulation = match shared {
        Some(shared) => {
            let mut simulation = shared.run(motion, shown, progress)?;
            if shown {
                shared.finish(&mut simulation, motion)?;
            }
            simulation
        }
        None => engine(id).run(&job.task(), progress)?,
    };
    if simulation.result.incomplete {
        return Err(Error::Fe(FeError::Interrupted {
            stage: "a set of records".into(),
        }));
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
        return Err(Error::input(
            Code::MissingInput,
            "no procedure and no engine gives a period of this tank".into(),
        ));
    }
    let question = Question {
        code: set.code,
        table: set.table.as_ref(),
        target: &set.target,
        site: &set.job.case.site,
        wanted,
    };
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

/// Columns and block of the set.
fn designed(
    set: &SetJob,
    runs: &[Under],
    shown: usize,
    (compatibility, no_target, of_site): (Option<Compatibility>, String, Option<Records>),
) -> Design {
    let ids: Vec<&str> = set.records.iter().map(|r| r.id.as_str()).collect();
    let (combine, count) = (set.combine, runs.len());
    let values: Vec<BTreeMap<Quantity, f64>> = runs.iter().map(|r| r.values.clone()).collect();
    let scatter = design::scatter(&values, combine);
    let raw: Vec<Vec<Check>> = runs.iter().map(|r| r.findings.checks.clone()).collect();
    let checks = design::checks(&raw, &ids, combine);
    let mut quantities = Vec::new();
    let mut procedures = BTreeMap::new();
    for method in runs.first().map_or(&[][..], |r| &r.methods) {
        let each: Vec<&Method> = runs
            .iter()
            .filter_map(|r| r.methods.iter().find(|m| m.id == method.id))
            .collect();
        if each.len() != count || each.iter().any(|m| m.quantities.is_empty() && m.checks.is_empty()) {
            continue;
        }
        let values: Vec<BTreeMap<Quantity, f64>> = each.iter().map(|m| of_method(m)).collect();
        let scatter = design::scatter(&values, combine);
        let checks: Vec<Vec<Check>> = each.iter().map(|m| m.checks.clone()).collect();
        let checks = design::checks(&checks, &ids, combine)
            .into_iter()
            .map(|c| c.check)
            .collect();
        let columns: BTreeMap<String, Value> = design_values(&scatter)
            .into_iter()
            .map(|(q, value)| {
                (
                    q.id().to_owned(),
                    Value {
                        value,
                        dimension: q.dimension(),
                    },
                )
            })
            .collect();
        quantities.extend(rows(&method.id, &scatter, &ids));
        procedures.insert(method.id.clone(), (columns, checks));
    }
    quantities.extend(rows(FE, &scatter, &ids));
    let sloshing = |under: &Under| {
        let own = under.values.get(&Quantity::SloshingPeriod).copied();
        own.or_else(|| pipeline::sloshing_period(&under.methods))
    };
    let records = set.records.iter().zip(runs).map(|(record, under)| {
        let measures = record.motion.horizontal.measures();
        let usable = record.usable();
        SetRun {
            id: record.id.clone(),
            files: record.files.clone(),
            peaks: [measures.pga, measures.pgv, measures.pgd],
            significant_duration: measures.significant_duration,
            usable_period: usable,
            sloshing_beyond_usable: sloshing(under).zip(usable).is_some_and(|(t, usable)| t > usable),
            values: by_method(under),
            utilisations: utilisations(&under.findings.checks),
            without_capacity: without_capacity(&under.findings.checks),
            limits_exceeded: under.limits_exceeded.clone(),
        }
    });
    let outside = runs.iter().find_map(|r| r.findings.outside);
    let note = format!(
        "Quantities and checks of this column are the {} of {count} records ({}); sheets and profiles are those of the record {}.",
        match combine {
            Combine::Mean => "mean of the maxima",
            Combine::Worst => "largest of the maxima",
        },
        set.code.design_clause(),
        ids[shown]
    );
    Design {
        values: design_values(&scatter),
        findings: Findings {
            checks: checks.iter().map(|c| c.check.clone()).collect(),
            outside,
            ..runs[shown].findings.clone()
        },
        procedures,
        note,
        set: RecordSet {
            name: set.name.clone(),
            rule: set.code.id().into(),
            combine: combine.id().into(),
            clause: set.code.design_clause().into(),
            fewest_for_mean: set.code.fewest_for_mean(),
            factor: set.factor,
            shown: ids[shown].into(),
            records: records.collect(),
            quantities,
            checks: checks.iter().map(|c| of_check(c, &ids)).collect(),
            compatibility,
            no_target,
        },
        records: of_site,
    }
}

/// Values of a column by quantity.
fn of_method(method: &Method) -> BTreeMap<Quantity, f64> {
    let values = method.quantities.iter();
    values
        .filter_map(|(id, v)| Some((Quantity::from_id(id)?, v.value)))
        .collect()
}

/// Design values; periods and masses are the same under every record.
fn design_values(scatter: &BTreeMap<Quantity, Scatter>) -> BTreeMap<Quantity, f64> {
    let value = |(q, s): (&Quantity, &Scatter)| (*q, if q.is_response() { s.design } else { s.mean });
    scatter.iter().map(value).collect()
}

/// Scatter of the responses of a method.
fn rows(method: &str, scatter: &BTreeMap<Quantity, Scatter>, ids: &[&str]) -> Vec<SetQuantity> {
    let responses = scatter.iter().filter(|(q, _)| q.is_response());
    let row = |(quantity, scatter): (&Quantity, &Scatter)| SetQuantity {
        method: method.into(),
        quantity: quantity.id().into(),
        title: quantity.title().into(),
        dimension: quantity.dimension(),
        scatter: numbers(scatter, ids),
    };
    responses.map(row).collect()
}

fn of_check(combined: &Combined, ids: &[&str]) -> SetCheck {
    SetCheck {
        id: combined.check.id.clone(),
        name: combined.check.name.clone(),
        status: combined.check.status,
        scatter: combined.scatter.as_ref().map(|s| numbers(s, ids)),
    }
}

fn numbers(scatter: &Scatter, ids: &[&str]) -> SetScatter {
    SetScatter {
        design: scatter.design,
        mean: scatter.mean,
        cov: scatter.cov,
        min: scatter.min.0,
        max: scatter.max.0,
        max_record: ids[scatter.max.1].into(),
    }
}

/// Responses by method and quantity.
fn by_method(under: &Under) -> BTreeMap<String, BTreeMap<String, f64>> {
    let responses = |values: BTreeMap<Quantity, f64>| -> BTreeMap<String, f64> {
        let kept = values.into_iter().filter(|(q, v)| q.is_response() && v.is_finite());
        kept.map(|(q, v)| (q.id().to_owned(), v)).collect()
    };
    let methods = under.methods.iter().map(|m| (m.id.clone(), responses(of_method(m))));
    let engine = (FE.to_owned(), responses(under.values.clone()));
    methods
        .chain([engine])
        .filter(|(_, values)| !values.is_empty())
        .collect()
}

/// Checks that fail without a capacity.
fn without_capacity(checks: &[Check]) -> Vec<String> {
    let lost = checks.iter().filter(|c| c.compared() && c.utilisation.is_none());
    lost.map(|c| c.id.clone()).collect()
}

/// Utilisation by check; of equal ids the largest.
fn utilisations(checks: &[Check]) -> BTreeMap<String, f64> {
    let mut found: BTreeMap<String, f64> = BTreeMap::new();
    for check in checks.iter().filter(|c| c.compared()) {
        if let Some(utilisation) = check.utilisation {
            let entry = found.entry(check.id.clone()).or_insert(utilisation);
            *entry = entry.max(utilisation);
        }
    }
    found
}
