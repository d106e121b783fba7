//! What the input of a study has that its plan has not.

use std::collections::BTreeMap;
use std::path::Path;

use super::plan::{Plan, PlannedRecord, PlannedTank, Task, make};
use crate::error::Error;
use crate::input::study::StudyInput;
use files::code::Code;

/// What changed since the plan, of a task: the tanks and records whose keys are others now.
pub(super) fn changed(
    plan: &Plan,
    tanks: &BTreeMap<(usize, u32), String>,
    records: &BTreeMap<usize, String>,
) -> Option<String> {
    for (&(tank, sample), key) in tanks {
        if plan.tanks[tank].keys.get(sample as usize) != Some(key) {
            return named("tank", &[&plan.tanks[tank].id]);
        }
    }
    for (&record, key) in records {
        if &plan.records[record].key != key {
            return named("record", &[&plan.records[record].id]);
        }
    }
    None
}

/// What the input of a study has that its plan has not: another tank, record or study file. None where nothing changed.
///
/// Errors: as [`super::plan::make`].
pub fn departure(study: &StudyInput, (plan, tasks): (&Plan, &[Task]), folder: &Path) -> Result<Option<String>, Error> {
    let (now, tasks_now) = make(study, &folder.join(&plan.study), folder)?;
    if tasks.iter().map(|task| &task.key).eq(tasks_now.iter().map(|task| &task.key)) {
        return Ok(None);
    }
    let tank = |before: &PlannedTank| now.tanks.iter().any(|tank| tank.id == before.id && tank.keys != before.keys);
    let record =
        |before: &PlannedRecord| now.records.iter().any(|record| record.id == before.id && record.key != before.key);
    let tanks: Vec<&str> = plan.tanks.iter().filter(|t| tank(t)).map(|t| t.id.as_str()).collect();
    let records: Vec<&str> = plan.records.iter().filter(|r| record(r)).map(|r| r.id.as_str()).collect();
    let same_tanks = plan.tanks.iter().map(|tank| &tank.id).eq(now.tanks.iter().map(|tank| &tank.id));
    let same_records = (plan.records.iter().map(|record| &record.id)).eq(now.records.iter().map(|record| &record.id));
    let parts = [named("tank", &tanks), named("record", &records)];
    let parts: Vec<String> = parts.into_iter().flatten().collect();
    Ok(Some(match parts.is_empty() {
        false => parts.join(" and "),
        true if !same_tanks => "the list of tanks".into(),
        true if !same_records => "the list of records".into(),
        true => "the study file, or the program's methods,".into(),
    }))
}

/// Most tanks or records that a message names.
const NAMED: usize = 5;

/// "the tank `a`", "the tanks `a`, `b` and 3 more"; none without ids.
fn named(what: &str, ids: &[&str]) -> Option<String> {
    let names: Vec<String> = ids.iter().take(NAMED).map(|id| format!("`{id}`")).collect();
    let names = names.join(", ");
    match ids.len() {
        0 => None,
        1 => Some(format!("the {what} {names}")),
        n if n > NAMED => Some(format!("the {what}s {names} and {} more", n - NAMED)),
        _ => Some(format!("the {what}s {names}")),
    }
}

/// The error of input that is not as it was when the plan was made.
///
/// * `what`: as [`departure`] says it
pub fn changed_since(what: &str) -> Error {
    Error::input(
        Code::StudyChanged,
        format!(
            "{}\n  help: plan again with `tankcheck study plan`; results whose input is unchanged are kept",
            since(what)
        ),
    )
}

/// The same as a clause.
pub fn since(what: &str) -> String {
    format!("{what} changed since the plan")
}
