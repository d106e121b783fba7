//! Missing tasks, in threads: each takes the next one.

use std::collections::BTreeMap;
use std::path::Path;
use std::sync::Mutex;
use std::sync::atomic::{AtomicUsize, Ordering};

use fem::progress::Progress;

use super::plan::{Plan, Task};
use super::rows::plain;
use super::store::{self, Found};
use super::task;
use crate::error::Error;
use crate::input::study::StudyInput;
use engines::estimate::{Estimate, THE_PROGRAM};

/// Which tasks a run takes.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Which {
    /// All that are missing.
    All,
    /// Every n-th from the i-th, 1 ≤ i ≤ n.
    Shard {
        /// Number of this shard.
        number: usize,
        /// Number of shards.
        of: usize,
    },
    /// One, by its number from 1.
    One(usize),
}

impl Which {
    /// Whether it takes a task.
    pub fn takes(self, task: usize) -> bool {
        match self {
            Which::All => true,
            Which::Shard { number, of } => task % of == number % of,
            Which::One(one) => task == one,
        }
    }
}

/// What a run did.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Done {
    /// Tasks whose results were there.
    pub kept: usize,
    /// Tasks that were computed.
    pub computed: usize,
    /// Damaged results that were found; their tasks are computed again.
    pub damaged: usize,
    /// Tasks that failed earlier and were left alone.
    pub failed_before: usize,
    /// Tasks that failed now.
    pub failed: usize,
    /// Tasks that were not begun: the run was interrupted.
    pub left: usize,
}

/// Runs what is missing. Tasks that failed before are left alone unless `retry`.
///
/// * `limit`: memory allowed [MiB], of that of a tank file
/// * `study`: reads the study file; called if there is something to do
///
/// Errors: bad input; more memory than allowed; results that cannot be written. A task that fails is recorded, and the others go on.
pub fn run(
    folder: &Path,
    (plan, tasks): (&Plan, &[Task]),
    (which, retry, threads): (Which, bool, usize),
    limit: impl Fn(u64) -> u64,
    study: impl FnOnce() -> Result<StudyInput, Error>,
    progress: &dyn Progress,
) -> Result<Done, Error> {
    let mut done = Done::default();
    let mut todo: Vec<&Task> = Vec::new();
    for task in tasks.iter().filter(|t| which.takes(t.task)) {
        match store::find(folder, plan, task) {
            Found::Whole(_) => done.kept += 1,
            Found::Failed if !retry => done.failed_before += 1,
            Found::Damaged(_) => {
                done.damaged += 1;
                todo.push(task);
            }
            _ => todo.push(task),
        }
    }
    if todo.is_empty() {
        return Ok(done);
    }
    spread(&mut todo);
    let study = study()?;
    admit(&study, plan, &todo, threads, limit)?;
    store::survey(folder).tidy();
    progress.stage("tasks", todo.len() as u64);
    let next = AtomicUsize::new(0);
    let failed = AtomicUsize::new(0);
    let computed = AtomicUsize::new(0);
    let fault: Mutex<Option<Error>> = Mutex::new(None);
    let work = || {
        while let Some(task) = todo.get(next.fetch_add(1, Ordering::SeqCst)) {
            let stopped = fault.lock().map_or(true, |fault| fault.is_some());
            if stopped || progress.interrupted() {
                return;
            }
            let outcome = store::begin(folder, &task.key).and_then(|_mark| match task::compute(&study, plan, task) {
                Ok(lines) => store::write(folder, &task.key, &lines).map(|_| computed.fetch_add(1, Ordering::SeqCst)),
                // Input that changed since the plan is the same for all tasks; nothing is recorded.
                Err(error) if error.exit_code() == crate::error::EXIT_INPUT => Err(error),
                Err(error) => {
                    let message = plain(&error.message());
                    store::fail(folder, &task.key, task.task, &message).map(|()| failed.fetch_add(1, Ordering::SeqCst))
                }
            });
            if let Err(error) = outcome {
                if let Ok(mut fault) = fault.lock() {
                    fault.get_or_insert(error);
                }
                return;
            }
            progress.advance(1);
        }
    };
    std::thread::scope(|scope| {
        for _ in 0..threads.clamp(1, todo.len()) {
            scope.spawn(work);
        }
    });
    if let Some(error) = fault.into_inner().ok().flatten() {
        return Err(error);
    }
    done.computed = computed.into_inner();
    done.failed = failed.into_inner();
    done.left = todo.len() - done.computed - done.failed;
    Ok(done)
}

/// Holds the memory of the largest tank, as many times as tasks run at a time, against the limit.
///
/// Errors: more than that.
fn admit(
    study: &StudyInput,
    plan: &Plan,
    todo: &[&Task],
    threads: usize,
    limit: impl Fn(u64) -> u64,
) -> Result<(), Error> {
    let tanks: BTreeMap<usize, u32> = todo.iter().flat_map(|task| task.tanks.iter().copied()).collect();
    let mut largest: Option<(Estimate, u64)> = None;
    for unit in tanks {
        if let Some(found) = task::estimate(study, plan, unit)?
            && largest.as_ref().is_none_or(|(most, _)| most.bytes() < found.0.bytes())
        {
            largest = Some(found);
        }
    }
    let Some((one, given)) = largest else { return Ok(()) };
    let times = |jobs: usize| {
        let mut all = one.clone();
        for (what, bytes) in &mut all.parts {
            *bytes *= if *what == THE_PROGRAM { 1.0 } else { jobs as f64 };
        }
        all
    };
    let jobs = threads.clamp(1, todo.len().max(1));
    let mut all = times(jobs);
    let fewer = (1..jobs).rev().map(|jobs| (format!("use --jobs {jobs}"), times(jobs).bytes(), one.seconds));
    all.lever.smaller = fewer.collect();
    Ok(all.hold(limit(given))?)
}

/// Mixes tasks, always in the same way: those of tanks that take longest stand together in a plan, and the time left would be guessed from the others.
fn spread(tasks: &mut [&Task]) {
    const GOLDEN: f64 = 0.618_033_988_749_894_9;
    tasks.sort_by(|a, b| {
        let [a, b] = [a, b].map(|task| (task.task as f64 * GOLDEN).fract());
        a.total_cmp(&b)
    });
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Shards take every task once.
    #[test]
    fn shards_share_the_tasks() {
        for of in 1..=7 {
            for task in 1..=50 {
                let takes = (1..=of).filter(|&number| Which::Shard { number, of }.takes(task));
                assert_eq!(takes.count(), 1);
            }
        }
    }
}
