//! Measured values: a column of the comparison where they belong to the ground motion of the run, else a list with reasons.

use tank::assessment::Excitation;
use tank::case::Reported;

use super::quantities::quantities;
use crate::job::Job;
use results::Method;
use results::compare::{self, Apart, Shaken, Why, apart};

/// The ground motion of a job, as recorded and as applied.
fn shaken(job: &Job) -> Option<Shaken> {
    let applied = &job.case.ground_motion.as_ref()?.horizontal;
    let recorded = job.raw_records.first().unwrap_or(applied);
    let file = job.files.iter().find(|f| f.role == "record");
    Some(Shaken {
        sha256: file.map(|f| f.sha256.clone()),
        peak: recorded.pga(),
        step: recorded.dt,
        duration: recorded.duration(),
        applied_peak: applied.pga(),
        applied_step: applied.dt,
    })
}

/// Measured values of the ground motion of the job, as a column.
pub(super) fn column(job: &Job) -> Option<Method> {
    let shaken = shaken(job);
    let own: Vec<&Reported> = job.case.measured.iter().filter(|m| apart(m, shaken.as_ref()).is_none()).collect();
    let first = own.first()?;
    let values = own.iter().map(|m| (m.quantity, m.value)).collect();
    let notes = own
        .iter()
        .map(|m| match &m.note {
            Some(note) => format!("{}: {}. {note}", m.quantity.title(), m.source),
            None => format!("{}: {}.", m.quantity.title(), m.source),
        })
        .collect();
    let title = format!("Measured ({})", first.source);
    Some(Method {
        label: "Measured".into(),
        figure_key: "k-measured".into(),
        quantities: quantities(&values),
        notes,
        ..Method::new(compare::MEASURED, &title, Excitation::Record)
    })
}

/// The others, each with its reason.
pub(super) fn others(job: &Job) -> Vec<Apart> {
    let shaken = shaken(job);
    let why = |value: &Reported| {
        let reason = apart(value, shaken.as_ref())?;
        Some(Apart { value: value.clone(), reason })
    };
    job.case.measured.iter().filter_map(why).collect()
}

/// Why there is no ratio to a published value, in the order of the file.
pub(super) fn published(job: &Job) -> Vec<Option<Why>> {
    let shaken = shaken(job);
    let values = job.case.published.iter();
    values.map(|value| apart(value, shaken.as_ref())).collect()
}
