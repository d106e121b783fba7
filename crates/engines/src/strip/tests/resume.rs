//! The strip interrupted and resumed.

use std::collections::HashMap;
use std::path::Path;
use std::sync::Mutex;
use std::sync::atomic::{AtomicU64, Ordering};
use std::thread::{self, ThreadId};

use fem::progress::{Progress, Silent};
use results::nonlinear::End;
use tank::options::nonlinear::{Contact, LiquidForm, NonlinearOptions};

use super::super::Strip;
use super::{options, reinforced, run};
use crate::FeError;
use crate::nonlinear::{CheckpointFile, simulate, simulate_with_states};

/// Stops each wall after a number of steps. Walls march side by side, or one after the other where all threads are busy: a thread counts its own
/// steps, and from the beginning after it has stopped.
struct StopAfter {
    steps: u64,
    done: Mutex<HashMap<ThreadId, u64>>,
}

impl StopAfter {
    fn steps(steps: u64) -> StopAfter {
        StopAfter { steps, done: Mutex::default() }
    }
}

impl Progress for StopAfter {
    fn stage(&self, _: &str, _: u64) {}

    fn advance(&self, steps: u64) {
        *self.done.lock().unwrap().entry(thread::current().id()).or_default() += steps;
    }

    fn interrupted(&self) -> bool {
        let mut done = self.done.lock().unwrap();
        let own = done.entry(thread::current().id()).or_default();
        let stops = *own >= self.steps;
        if stops {
            *own = 0;
        }
        stops
    }
}

fn file(folder: &Path, key: &str) -> CheckpointFile {
    CheckpointFile { path: folder.join("run.checkpoint"), key: key.into(), resume: true }
}

/// Interrupted twice and resumed: the same numbers as without interruption, to the last bit. No file remains.
#[test]
fn resumed_is_uninterrupted() {
    for contact in [Contact::Bonded, Contact::Opening] {
        resumed_with(contact, LiquidForm::Condensed, 2);
        // Both walls in one file.
        resumed_with(contact, LiquidForm::Displacement, 1);
    }
}

fn resumed_with(contact: Contact, liquid: LiquidForm, files: usize) {
    let case = reinforced(6.0);
    let own = NonlinearOptions { contact, liquid, ..options(&case, 12) };
    let every = Some(0.05);
    let whole = simulate_with_states(&case, &own, (every, None), &Silent).unwrap();
    assert_eq!(whole.series, run(&case, &own).series);
    let home = tempfile::tempdir().unwrap();
    let file = file(home.path(), "a");
    for steps in [75, 125] {
        let part = simulate_with_states(&case, &own, (every, Some(&file)), &StopAfter::steps(steps)).unwrap();
        assert!(part.result.incomplete);
        assert!(matches!(part.result.end, End::Interrupted { time } if time > 0.0));
        assert_eq!(std::fs::read_dir(home.path()).unwrap().count(), files);
    }
    let resumed = simulate_with_states(&case, &own, (every, Some(&file)), &Silent).unwrap();
    assert_eq!(resumed.values, whole.values);
    assert_eq!(resumed.result, whole.result);
    assert_eq!(resumed.series, whole.series);
    assert_eq!(resumed.notes, whole.notes);
    // Assertion without the text of all states.
    assert!(resumed.snapshots == whole.snapshots && whole.snapshots.is_some_and(|s| s.states.len() > 20));
    // Kept until the results are written.
    assert_eq!(std::fs::read_dir(home.path()).unwrap().count(), files);
    file.remove();
    assert_eq!(std::fs::read_dir(home.path()).unwrap().count(), 0);
}

/// Interrupts after a number of polls.
struct Patience(AtomicU64);

impl Progress for Patience {
    fn stage(&self, _: &str, _: u64) {}

    fn advance(&self, _: u64) {}

    fn interrupted(&self) -> bool {
        let left = self.0.load(Ordering::Relaxed);
        self.0.store(left.saturating_sub(1), Ordering::Relaxed);
        left == 0
    }
}

/// The same at a scale of an incremental analysis, in its second wall and in its first.
#[test]
fn resumed_run_of_a_curve_is_uninterrupted() {
    let case = reinforced(6.0);
    let strip = Strip::new(&case, &options(&case, 12)).unwrap();
    let whole = strip.incremental(&[0.8], 1, &|_| None, &Silent, |_| {}).unwrap();
    let home = tempfile::tempdir().unwrap();
    let kept = |_: f64| Some(file(home.path(), "a"));
    for polls in [100, 500] {
        let found = strip.incremental(&[0.8], 1, &kept, &Patience(AtomicU64::new(polls)), |_| {});
        assert_eq!(found.unwrap(), []);
        assert!(std::fs::read_dir(home.path()).unwrap().count() > 0);
    }
    let mut heard = 0;
    let resumed = strip.incremental(&[0.8], 1, &kept, &Silent, |_| heard += 1).unwrap();
    assert_eq!((resumed, heard), (whole, 1));
    file(home.path(), "a").remove();
    assert_eq!(std::fs::read_dir(home.path()).unwrap().count(), 0);
}

/// The checkpoint of another job, by its key: refused and kept.
#[test]
fn checkpoints_of_other_runs_are_refused_and_kept() {
    let case = reinforced(6.0);
    let own = options(&case, 12);
    let home = tempfile::tempdir().unwrap();
    simulate(&case, &own, Some(&file(home.path(), "a")), &StopAfter::steps(50)).unwrap();
    let kept = || {
        let read = |e: std::io::Result<std::fs::DirEntry>| std::fs::read(e.unwrap().path()).unwrap();
        let mut all: Vec<Vec<u8>> = std::fs::read_dir(home.path()).unwrap().map(read).collect();
        all.sort();
        all
    };
    let before = kept();
    assert_eq!(before.len(), 2);
    match simulate(&case, &own, Some(&file(home.path(), "b")), &Silent) {
        Err(FeError::Checkpoint(fault)) => assert!(fault.to_string().contains("of another run"), "{fault}"),
        other => panic!("{other:?}"),
    }
    assert!(kept() == before);
}
