//! What a study will cost: one task of each class of tanks, timed. Its results are kept as those of any run; the times are not.
//!
//! An anchored tank is linear, and one run of a record serves all its scales; a tank that lifts or slides runs every scale. These are the classes.

use std::collections::BTreeMap;
use std::path::Path;
use std::time::Instant;

use tank::Support;

use super::plan::{Plan, Task};
use super::{store, task};
use crate::error::Error;
use crate::input::study::StudyInput;

/// A class of tanks.
#[derive(Clone, Debug, PartialEq)]
pub struct Class {
    /// Name.
    pub name: &'static str,
    /// Tasks, and how many of them have a result.
    pub tasks: [usize; 2],
    /// Rows without a result.
    pub rows_left: usize,
    /// Seconds and bytes of a row of the pilot; none where every task has a result.
    pub row: Option<[f64; 2]>,
}

impl Class {
    /// Seconds until every task has a result, one task at a time.
    pub fn seconds_left(&self) -> f64 {
        self.row.map_or(0.0, |[seconds, _]| seconds * self.rows_left as f64)
    }
}

/// Runs one task of each class and stores its result.
///
/// Errors: those of a task; a result that cannot be written.
pub fn run(folder: &Path, study: &StudyInput, plan: &Plan, tasks: &[Task]) -> Result<Vec<Class>, Error> {
    let mut classes: BTreeMap<&'static str, Class> = BTreeMap::new();
    for task in tasks {
        let name = class(study, task);
        let class = classes.entry(name).or_insert_with(|| Class { name, tasks: [0, 0], rows_left: 0, row: None });
        class.tasks[0] += 1;
        if store::find(folder, plan, task).whole() {
            class.tasks[1] += 1;
            continue;
        }
        if class.row.is_some() {
            class.rows_left += task.rows;
            continue;
        }
        let started = Instant::now();
        let lines = task::compute(study, plan, task)?;
        let seconds = started.elapsed().as_secs_f64();
        let bytes = store::write(folder, &task.key, &lines)?;
        let rows = task.rows.max(1) as f64;
        class.row = Some([seconds / rows, bytes as f64 / rows]);
        class.tasks[1] += 1;
    }
    Ok(classes.into_values().collect())
}

/// The class of a task, by its first tank without sampling.
fn class(study: &StudyInput, task: &Task) -> &'static str {
    let first = task.tanks.first().map(|(tank, _)| &study.tanks[*tank]);
    match first.and_then(|entry| entry.tank(None, 0).ok()).map(|tank| tank.case.tank.support) {
        _ if study.engine.is_none() => "codes alone",
        Some(Support::Unanchored) => "unanchored",
        Some(Support::Anchored) => "anchored",
        None => "not possible",
    }
}
