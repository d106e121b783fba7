//! The code procedures of a job: which run, what they give, their verdict.

use std::collections::BTreeMap;

use files::code::Code;

use super::quantities::with_crest;
use super::{decision, runs};
use crate::error::Error;
use crate::job::Job;
use codes::Procedure;
use codes::procedure::CodeError;
use codes::sheet::without_lines;
use results::{Method, Status, Verdict, finite};
use tank::Quantity;
use tank::assessment::{Assessment, Excitation};
use tank::case::Site;
use tank::ingredients::Ingredients;
use tank::large_wave::LargeWave;
use tank::units::{Dimension, display};

/// A procedure's column, and what its quantities are made of.
pub(super) type Assessed = (Method, Vec<Ingredients>);

/// Ids of the procedures to run, in report order.
///
/// * `ids`: named to run; none means those that run unasked on the site, and those of `decide`
///
/// Errors: an unknown id, with the known ones.
pub fn select_procedures(ids: &[String], decide: &[String], site: &Site) -> Result<Vec<String>, Error> {
    let known: Vec<&str> = codes::ALL.iter().map(|p| p.id()).collect();
    if let Some(unknown) = ids.iter().find(|id| !known.contains(&id.as_str())) {
        let near = known.iter().find(|id| id.starts_with(unknown.as_str()) && unknown.len() > 2);
        let help = near.map_or_else(String::new, |near| format!("\n  help: did you mean `{near}`?"));
        let text = format!("procedures: found `{unknown}`, expected any of {}{help}", known.join(", "));
        return Err(Error::input(Code::UnknownId, text));
    }
    let named = |list: &[String], id: &str| list.iter().any(|named| named == id);
    let runs = |p: &&&dyn Procedure| match ids {
        [] => p.unasked(site) || named(decide, p.id()),
        ids => named(ids, p.id()),
    };
    Ok(codes::ALL.iter().filter(runs).map(|p| p.id().to_owned()).collect())
}

/// The code procedures and their verdict, without engines, spectra and comparison.
///
/// Errors: a procedure that does not converge, a result that is not finite.
pub fn decide(job: &Job) -> Result<(Vec<Method>, Verdict), Error> {
    let methods: Vec<Method> = assess(job)?.into_iter().map(|(method, _)| method).collect();
    finite::check("the procedures", &methods)?;
    let verdict = Verdict {
        unstated: job.decision.unstated.clone(),
        overruled: decision::overruled(job, &methods),
        ..results::verdict(&methods, decision::deciding(job, &methods), false, None)
    };
    Ok((methods, verdict))
}

/// The same where nobody reads the sheets: they stay empty.
///
/// Errors: as [`decide`].
pub fn decide_without_sheets(job: &Job) -> Result<(Vec<Method>, Verdict), Error> {
    without_lines(|| decide(job))
}

/// The code procedures under one excitation.
///
/// Errors: a procedure that does not converge, a result that is not finite.
pub fn under(job: &Job, excitation: Excitation) -> Result<Vec<Method>, Error> {
    let chosen = codes::ALL.iter().filter(|p| job.procedures.iter().any(|id| id == p.id()));
    let methods: Vec<Method> = chosen
        .map(|procedure| method(*procedure, job, excitation).map(|(method, _)| method))
        .collect::<Result<_, _>>()?;
    finite::check("the procedures", &methods)?;
    Ok(methods)
}

/// All chosen procedures under all excitations the case offers.
pub(super) fn assess(job: &Job) -> Result<Vec<Assessed>, Error> {
    let mut excitations = Vec::new();
    if job.case.ground_motion.is_some() {
        excitations.push(Excitation::Record);
    }
    if job.case.site.is_given() {
        excitations.push(Excitation::Site);
    }
    let chosen = |p: &&&dyn Procedure| job.procedures.iter().any(|id| id == p.id());
    let mut methods = Vec::new();
    for &excitation in &excitations {
        for procedure in codes::ALL.iter().filter(chosen) {
            methods.push(method(*procedure, job, excitation)?);
        }
    }
    methods.extend(codes::ALL.iter().filter_map(|p| Some((decision::left_out(*p, job)?, Vec::new()))));
    Ok(methods)
}

/// One procedure under one excitation as a column of the comparison.
fn method(procedure: &dyn Procedure, job: &Job, excitation: Excitation) -> Result<Assessed, Error> {
    let not_applicable =
        |clause: String, reason: String| (Assessment::default(), Status::NotApplicable { clause, reason });
    let (assessment, status) = match procedure.assess(&job.case, excitation) {
        Ok(assessment) => (assessment, Status::Computed),
        Err(CodeError::NotApplicable(n)) => not_applicable(n.clause, n.reason),
        Err(CodeError::Data { clause, reason }) => not_applicable(clause, reason),
        Err(source) => return Err(Error::Code { procedure: procedure.id().into(), source }),
    };
    let (mut assumptions, ingredients) = (assessment.assumptions, assessment.ingredients);
    let across = job.case.ground_motion.as_ref().and_then(|m| m.transverse.as_ref());
    if matches!((&status, excitation, across), (Status::Computed, Excitation::Record, Some(_))) {
        assumptions.push("One horizontal component: the record along x alone, without that along y.".into());
    }
    if let (Status::Computed, Some(layered)) = (&status, runs::layers(job)) {
        assumptions.push(layered.into());
    }
    let checks = match &status {
        Status::Computed => decision::checks(procedure, job, excitation, assessment.checks),
        Status::NotApplicable { clause, reason } => {
            decision::not_covered(procedure, job, excitation, &format!("{clause}: {reason}"))
        }
    };
    let mut notes = assessment.notes;
    notes.extend(crest(job, &assessment.values));
    let label = procedure.label();
    let method = Method {
        label: label.short.into(),
        figure_key: label.figure_key.into(),
        status,
        quantities: with_crest(&job.case, &assessment.values),
        steps: assessment.steps,
        checks,
        profiles: assessment.profiles,
        courses: assessment.courses,
        assumptions,
        notes,
        beyond_scope: assessment.beyond_scope,
        hold_down: assessment.hold_down,
        recalled: assessment.recalled,
        ..Method::new(procedure.id(), label.title, excitation)
    };
    Ok((method, ingredients))
}

/// What a procedure's wave amounts to where its height is within the freeboard and its crest is not.
fn crest(job: &Job, values: &BTreeMap<Quantity, f64>) -> Option<String> {
    let wave = *values.get(&Quantity::SloshingHeight)?;
    let (crest, freeboard) = (LargeWave::of(&job.case).crest(wave), job.case.freeboard());
    (wave <= freeboard && freeboard < crest).then(|| {
        let [wave, crest, freeboard] = [wave, crest, freeboard].map(|value| display(value, Dimension::Length));
        format!("The wave of {wave} is within the freeboard of {freeboard}; its crest, which the procedure does not ask for, is {crest}.")
    })
}
