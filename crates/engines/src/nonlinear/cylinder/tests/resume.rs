//! The cylinder with the liquid as an operator, interrupted and resumed.

use std::path::Path;
use std::sync::atomic::{AtomicU64, Ordering};

use fem::analysis::march::Outcome;
use fem::progress::{Progress, Silent};
use tank::options::AfterRecord;
use tank::options::nonlinear::{Contact, NonlinearOptions};
use tank::{Case, VolumeChange, WallTemperature};

use super::super::march::Cylinder;
use super::super::model::CylinderModel;
use super::{cracking, elastic, options, shaken};
use crate::checkpoint::CheckpointFile;

/// Interrupts a march after so many time steps; those of the static start are not counted.
struct StopAt {
    step: u64,
    done: AtomicU64,
}

impl Progress for StopAt {
    fn stage(&self, _: &str, _: u64) {
        self.done.store(0, Ordering::Relaxed);
    }

    fn advance(&self, steps: u64) {
        self.done.fetch_add(steps, Ordering::Relaxed);
    }

    fn interrupted(&self) -> bool {
        self.done.load(Ordering::Relaxed) >= self.step
    }
}

fn file(folder: &Path) -> CheckpointFile {
    CheckpointFile { path: folder.join("run.checkpoint"), key: "a".into(), resume: true }
}

/// A run whose systems are solved by iteration, stopped in the record and in the free vibration after it and resumed each time,
/// ends bit by bit as the uninterrupted one, though its parts take two threads, one and two.
fn resumed(case: &Case, own: &NonlinearOptions, tank: CylinderModel, stops: [u64; 2]) {
    let operator = tank.assembler.has_operators();
    // On soil the wall is elastic and round, and one product solves.
    let iterated = operator && tank.standing.is_none() && tank.slab.is_none();
    assert!(tank.slab.is_some() || operator == (tank.standing.is_some() || tank.wetted.len() > 400));
    let states = tank.standing.is_some().then_some(0.03);
    let cylinder = Cylinder { states, ..Cylinder::of(case, own, tank).unwrap() };
    let motion = case.ground_motion.as_ref().unwrap();
    let march = |threads: usize, file: Option<&CheckpointFile>, progress: &dyn Progress| {
        let (watch, run) = cylinder.march(motion, 1.0, threads, file, progress).unwrap();
        let seen = (watch.seen, watch.openings, watch.pictures.map(|p| p.states));
        ((watch.recorder.histories, seen, run.state, run.balance, run.cost), run.outcome)
    };
    let (straight, end) = march(1, None, &Silent);
    assert_eq!(end, Outcome::Completed);
    assert!(!iterated || straight.4.products > straight.4.iterations, "{:?}", straight.4);
    let folder = tempfile::tempdir().unwrap();
    let file = file(folder.path());
    for (threads, step) in [2, 1].into_iter().zip(stops) {
        let stop = StopAt { step, done: AtomicU64::new(0) };
        let (part, end) = march(threads, Some(&file), &stop);
        assert_eq!(end, Outcome::Interrupted);
        assert!(part.4.steps < straight.4.steps);
    }
    let (found, end) = march(2, Some(&file), &Silent);
    assert_eq!(end, Outcome::Completed);
    let parts = [
        ("histories", found.0 == straight.0),
        ("what was seen", found.1 == straight.1),
        ("state", found.2 == straight.2),
        ("balance", found.3 == straight.3),
        ("cost", found.4 == straight.4),
    ];
    let other: Vec<&str> = parts.iter().filter(|part| !part.1).map(|part| part.0).collect();
    assert!(other.is_empty(), "{other:?}");
}

/// A wall that cracks: a kept tangent that is not the preconditioner, and increments of several products.
#[test]
fn iterated_run_resumed_is_uninterrupted() {
    let case = shaken(cracking(), 12.0, 7);
    let own = NonlinearOptions { after_record: AfterRecord::Time(0.02), ..options(&case, 14, 64) };
    let tank = CylinderModel::new(&case, &own).unwrap();
    resumed(&case, &own, tank, [6, 15]);
}

/// A wall with prestressed bars and warmer inside that has shrunk and crept before the record, in which it cracks.
#[test]
fn crept_run_resumed_is_uninterrupted() {
    let mut case = shaken(cracking(), 12.0, 7);
    let layer = &mut case.tank.courses[0].layers[0];
    layer.material.volume_change =
        VolumeChange { thermal_expansion: Some(1e-5), shrinkage: 1e-4, creep_coefficient: 1.0 };
    layer.reinforcement.iter_mut().for_each(|bars| bars.prestress = 100e6);
    let temperature = Some(WallTemperature { inside: 30.0, outside: 10.0, stress_free: 10.0 });
    let own = NonlinearOptions { temperature, after_record: AfterRecord::Time(0.02), ..options(&case, 4, 8) };
    let tank = CylinderModel::new(&case, &own).unwrap();
    resumed(&case, &own, tank, [6, 15]);
}

/// The same with contact that opens.
#[test]
fn iterated_run_with_contact_resumed_is_uninterrupted() {
    let case = shaken(elastic(), 25.0, 5);
    let own =
        NonlinearOptions { contact: Contact::Opening, after_record: AfterRecord::Time(0.01), ..options(&case, 14, 72) };
    let tank = CylinderModel::in_form(&case, &own, |_| true).unwrap();
    resumed(&case, &own, tank, [6, 15]);
}

/// An unanchored wall that has lifted and slid, with its zone.
#[test]
fn lifted_run_resumed_is_uninterrupted() {
    let mut case = shaken(super::standing::slender(), 4.0, 20);
    case.tank.foundation.as_mut().unwrap().friction = Some(0.1);
    let own = NonlinearOptions { after_record: AfterRecord::Time(0.02), ..options(&case, 6, 8) };
    let tank = CylinderModel::new(&case, &own).unwrap();
    resumed(&case, &own, tank, [10, 25]);
}

/// A slab on soil, with the liquid as a block and as an operator.
#[test]
fn run_on_soil_resumed_is_uninterrupted() {
    let mut case = super::soil::tank(Some(150.0));
    case.ground_motion.as_mut().unwrap().horizontal.acceleration.truncate(8);
    let own = NonlinearOptions { after_record: AfterRecord::Time(0.02), ..options(&case, 6, 16) };
    for operator in [false, true] {
        let tank = CylinderModel::in_form(&case, &own, |_| operator).unwrap();
        assert!(tank.slab.is_some());
        resumed(&case, &own, tank, [6, 15]);
    }
}
