//! Interruptions: the missing part is named, and a resumed pushover equals an uninterrupted one.

use std::path::Path;
use std::sync::Mutex;

use fem::analysis::checkpoint::{CheckpointError, Hash, unfinished};
use tank::{Behaviour, Shape, Steel};

use super::*;
use crate::harmonic::test_tanks;
use tank::options::nonlinear::WallElements;
use tank::reference::{case, material};

/// Without formulas.
fn pushover(
    case: &Case,
    options: &NonlinearOptions,
    push: &PushOptions,
    checkpoint: Option<&CheckpointFile>,
    progress: &dyn Progress,
) -> Result<Pushed, FeError> {
    super::pushover(case, options, push, &[], checkpoint, progress)
}

/// A tank that yields at its base.
fn small() -> Case {
    let mut steel = material(2.1e11, 0.3, 7850.0);
    steel.behaviour = Behaviour::Steel(Steel {
        yield_strength: 6e7,
        tangent_modulus: 0.0,
        kinematic_share: 1.0,
        ultimate_strength: None,
    });
    case(Shape::Cylinder { radius: 4.0 }, &[(4.0, 5e-3)], &steel, (1000.0, 3.6))
}

fn options(case: &Case, height: u32) -> NonlinearOptions {
    NonlinearOptions {
        elements: Some(WallElements { height, circumference: 8 }),
        ..NonlinearOptions::new(case.damping)
    }
}

fn imperfect(form: Form) -> PushOptions {
    PushOptions { imperfection: Some(Amplitude::Thicknesses(0.5)), form, height: None, plane_foot: false }
}

/// Stops in a stage once `steps` of its steps are done.
struct Stop {
    stage: &'static str,
    steps: u64,
    now: Mutex<(String, u64)>,
}

impl Progress for Stop {
    fn stage(&self, name: &str, _steps: u64) {
        *self.now.lock().unwrap() = (name.into(), 0);
    }
    fn advance(&self, steps: u64) {
        self.now.lock().unwrap().1 += steps;
    }
    fn interrupted(&self) -> bool {
        let now = self.now.lock().unwrap();
        now.0 == self.stage && now.1 >= self.steps
    }
}

fn stopped(stage: &'static str, steps: u64) -> Result<Pushed, FeError> {
    let case = small();
    let now = Mutex::default();
    let stop = Stop { stage, steps, now };
    pushover(&case, &options(&case, 12), &imperfect(Form::Weld), None, &stop)
}

/// Finished and missing parts are distinguished.
#[test]
fn an_interruption_says_what_it_leaves_out() {
    assert!(matches!(stopped("perfect shell", 0), Err(FeError::Interrupted { .. })));
    let first = stopped("perfect shell", 3).unwrap();
    assert_eq!(first.shells.len(), 1);
    assert!(first.shells[0].interrupted && !first.shells[0].capacity.limit);
    assert!(
        first.interruption.contains("the perfect shell, whose capacity is a lower bound")
            && first.interruption.contains("the imperfect one was not run"),
        "{}",
        first.interruption
    );
    let before = stopped("imperfect shell", 0).unwrap();
    assert_eq!(before.shells.len(), 1);
    assert!(before.shells[0].capacity.limit && !before.shells[0].interrupted);
    assert_eq!(before.interruption, "the perfect shell is complete; interrupted before the imperfect one");
    let second = stopped("imperfect shell", 3).unwrap();
    assert!(second.shells[0].capacity.limit && second.shells[1].interrupted);
    assert!(second.interruption.starts_with("the perfect shell is complete; interrupted in the imperfect one"));
    let whole = stopped("none", 0).unwrap();
    assert!(whole.interruption.is_empty());
    // Between its maximum and the end of its path a shell is interrupted, and its capacity no lower bound.
    let last = whole.shells[0].path.len() as u64 - 1;
    let late = stopped("perfect shell", last).unwrap();
    assert!(late.shells[0].interrupted && late.shells[0].capacity.limit);
    assert_eq!(late.shells[0].capacity.state, whole.shells[0].capacity.state);
    assert_eq!(
        late.interruption,
        "interrupted in the perfect shell, beyond its maximum, and the imperfect one was not run"
    );
}

/// Stops after so many committed states of this run, or at the so-manieth question whether to.
struct Kill {
    states: u64,
    questions: u64,
    now: Mutex<Now>,
}

#[derive(Default)]
struct Now {
    /// Whether the next count is that of the states that the checkpoint had.
    begins: bool,
    states: u64,
    questions: u64,
    warnings: Vec<String>,
}

impl Kill {
    fn after(states: u64, questions: u64) -> Kill {
        Kill { states, questions, now: Mutex::default() }
    }

    fn never() -> Kill {
        Kill::after(u64::MAX, u64::MAX)
    }
}

impl Progress for Kill {
    fn stage(&self, _name: &str, _steps: u64) {
        self.now.lock().unwrap().begins = true;
    }
    fn advance(&self, steps: u64) {
        let mut now = self.now.lock().unwrap();
        let begins = std::mem::replace(&mut now.begins, false);
        if !begins {
            now.states += steps;
        }
    }
    fn interrupted(&self) -> bool {
        let mut now = self.now.lock().unwrap();
        now.questions += 1;
        now.states >= self.states || now.questions >= self.questions
    }
    fn warn(&self, what: &str) {
        self.now.lock().unwrap().warnings.push(what.into());
    }
}

fn file(path: &Path) -> CheckpointFile {
    CheckpointFile { path: path.into(), key: "a pushover".into(), resume: true }
}

/// Every number to the last digit.
fn text(pushed: &Pushed) -> String {
    format!("{pushed:#?}")
}

/// Interrupts and resumes until the run is done; the results, and how many runs it took.
fn piecewise(case: &Case, options: &NonlinearOptions, push: &PushOptions, kill: impl Fn() -> Kill) -> (Pushed, usize) {
    let home = tempfile::tempdir().unwrap();
    let file = file(&home.path().join("push.checkpoint"));
    for runs in 1..2000 {
        match pushover(case, options, push, Some(&file), &kill()) {
            Ok(pushed) if pushed.interruption.is_empty() => {
                assert!(!unfinished(&file.path).exists());
                return (pushed, runs);
            }
            Ok(pushed) => assert!(pushed.shells.last().unwrap().interrupted || pushed.shells.len() == 1),
            Err(FeError::Interrupted { .. }) => {}
            Err(error) => panic!("run {runs}: {error}"),
        }
        assert!(file.path.exists(), "run {runs}");
    }
    panic!("no end");
}

/// Interrupted after every committed state, after every fourth one and at every seventh question (which also falls between a step
/// that failed and its half): bit by bit the uninterrupted run.
#[test]
fn a_resumed_pushover_is_the_uninterrupted_one() {
    let case = small();
    let options = options(&case, 12);
    for (form, kills) in [(Form::Weld, &[[1, u64::MAX], [u64::MAX, 7]][..]), (Form::Mode, &[[4, u64::MAX]])] {
        let push = imperfect(form);
        let whole = pushover(&case, &options, &push, None, &Kill::never()).unwrap();
        assert!(whole.shells.iter().all(|s| s.capacity.limit), "{form:?}");
        let states: usize = whole.shells.iter().map(|s| s.path.len()).sum();
        for &[each, question] in kills {
            let (pieces, runs) = piecewise(&case, &options, &push, || Kill::after(each, question));
            assert!(runs >= states / 7, "{form:?}: {runs} runs, {states} states");
            assert_eq!(text(&pieces), text(&whole), "{form:?}, {runs} runs");
        }
    }
}

/// A checkpoint that cannot be written gives a warning only.
#[test]
fn a_checkpoint_that_cannot_be_written_does_not_end_the_run() {
    let case = small();
    let mut options = options(&case, 12);
    options.checkpoint = 0.0;
    let push = PushOptions::default();
    let home = tempfile::tempdir().unwrap();
    let place = home.path().join("removed");
    let kill = Kill::never();
    let pushed = pushover(&case, &options, &push, Some(&file(&place.join("x"))), &kill).unwrap();
    let whole = pushover(&case, &options, &push, None, &Kill::never()).unwrap();
    assert_eq!(text(&pushed), text(&whole));
    let warnings = kill.now.into_inner().unwrap().warnings;
    assert_eq!(warnings.len(), 1, "{warnings:?}");
    assert!(
        warnings[0].contains("removed") && warnings[0].contains("the run continues and tries again later"),
        "{warnings:?}"
    );
    assert!(!place.exists());
}

/// Without a state to resume nothing is kept; the checkpoint of a failed run is removed.
#[test]
fn a_run_that_fails_leaves_no_checkpoint() {
    let mut case = small();
    let options = options(&case, 12);
    let home = tempfile::tempdir().unwrap();
    let file = file(&home.path().join("push.checkpoint"));
    // The hoop yields long before the tank is full.
    case.liquid.density = 4000.0;
    let failed = pushover(&case, &options, &PushOptions::default(), Some(&file), &Kill::never());
    assert!(matches!(failed, Err(FeError::Analysis(_))), "{failed:?}");
    assert_eq!(std::fs::read_dir(home.path()).unwrap().count(), 0);
}

fn interrupted(home: &Path, states: u64) -> CheckpointFile {
    let case = small();
    let file = file(&home.join("push.checkpoint"));
    let pushed =
        pushover(&case, &options(&case, 12), &imperfect(Form::Mode), Some(&file), &Kill::after(states, u64::MAX));
    assert!(!pushed.unwrap().interruption.is_empty());
    file
}

/// A checkpoint with another key, of another mesh, or damaged is refused, with the file's name and help.
#[test]
fn a_checkpoint_of_another_run_is_refused() {
    let home = tempfile::tempdir().unwrap();
    let kept = interrupted(home.path(), 5);
    let case = small();
    let resume = |file: &CheckpointFile, height: u32| {
        let found = pushover(&case, &options(&case, height), &imperfect(Form::Mode), Some(file), &Kill::after(0, 0));
        let Err(error @ FeError::Checkpoint(_)) = found else {
            panic!("{found:?}");
        };
        let text = error.to_string();
        assert!(text.contains("push.checkpoint") && text.contains("help: omit --resume"), "{text}");
        let FeError::Checkpoint(fault) = error else { unreachable!() };
        fault.cause().clone()
    };
    let other = CheckpointFile { key: "another pushover".into(), ..kept.clone() };
    assert!(matches!(resume(&other, 12), CheckpointError::Identity { .. }));
    assert!(matches!(resume(&kept, 16), CheckpointError::Identity { .. }));
    let sound = std::fs::read(&kept.path).unwrap();
    std::fs::write(&kept.path, &sound[..sound.len() - 9]).unwrap();
    assert!(matches!(resume(&kept, 12), CheckpointError::Length { .. }));
}

/// A payload that no run wrote under a checksum that fits it: refused or run, no panic.
#[test]
fn a_forged_checkpoint_does_not_panic() {
    const HEAD: usize = 28;
    let home = tempfile::tempdir().unwrap();
    let case = small();
    let options = options(&case, 12);
    let whole = pushover(&case, &options, &imperfect(Form::Mode), None, &Kill::never()).unwrap();
    let [perfect, other] = [0, 1].map(|k| whole.shells[k].path.len() as u64);
    // In the arc of the perfect shell, and in that of the imperfect one.
    for states in [perfect - 3, perfect + other - 3] {
        let kept = interrupted(home.path(), states);
        let sound = std::fs::read(&kept.path).unwrap();
        let end = sound.len() - 8;
        let mut refused = 0;
        // Each place with each value.
        for k in 0..12 {
            let mut forged = sound.clone();
            // Counts stand at the beginning of their parts, the last numbers at the end.
            let at = match k % 3 {
                0 => HEAD + 8 * (k / 3),
                1 => end - 8 * (k / 3 + 1),
                _ => HEAD + (k * 7919 * 8) % (end - HEAD),
            };
            let value: [u8; 8] = match k % 4 {
                0 => f64::NAN.to_le_bytes(),
                1 => u64::MAX.to_le_bytes(),
                2 => (-1e300_f64).to_le_bytes(),
                _ => 0_u64.to_le_bytes(),
            };
            forged[at..at + 8].copy_from_slice(&value);
            let mut hash = Hash::default();
            hash.bytes(&forged[HEAD..end]);
            forged[end..].copy_from_slice(&hash.value().to_le_bytes());
            std::fs::write(&kept.path, &forged).unwrap();
            let found = pushover(&case, &options, &imperfect(Form::Mode), Some(&kept), &Kill::after(1, u64::MAX));
            refused += usize::from(matches!(found, Err(FeError::Checkpoint(_))));
        }
        assert!(refused > 0);
        std::fs::remove_file(&kept.path).unwrap();
    }
}

/// Rings and attachments in a pushover: half of their weight, of their inertia and of its moment about the base, wherever the levels of
/// nodes are; half of the energy of a ring that ovals, E I (n² − 1)²/R⁴ by π R.
#[test]
fn fittings_have_their_mass_and_rings_their_stiffness() {
    let (mut bare, mut fitted) = (small(), small());
    // The ring adds a level of nodes; the attachment alone loads the other levels.
    let (ring, ladder) = ((2.6, 6e-3, 5e-6), (1.2345, 300.0));
    test_tanks::fit(&mut fitted, ring, ladder);
    let model = |case: &Case| {
        let options = NonlinearOptions {
            elements: Some(WallElements { height: 20, circumference: 48 }),
            ..NonlinearOptions::new(case.damping)
        };
        Plan::new(case, &options, false).unwrap().build(None).unwrap()
    };
    // A ring of nothing keeps the same levels of nodes.
    test_tanks::fit(&mut bare, (ring.0, 0.0, 0.0), (ladder.0, 0.0));
    let (bare, with) = (model(&bare), model(&fitted));
    let work = |model: &model::PushModel, load: &[f64], field: &dyn Fn([f64; 3]) -> [f64; 3]| -> f64 {
        let nodes = model.model.nodes();
        let x = model.model.vector(|node| {
            let [a, b, c] = field(nodes[node]);
            let mut all = [0.0; fem::dofs::KINDS];
            all[..3].copy_from_slice(&[a, b, c]);
            all
        });
        fem::linalg::dot(&x, load)
    };
    let mass = [2.0 * std::f64::consts::PI * 4.0 * 7850.0 * ring.1, ladder.1];
    let close = |found: f64, expected: f64| assert!((found / expected - 1.0).abs() < 1e-3, "{found} {expected}");
    let change = |load: &dyn Fn(&model::PushModel) -> Vec<f64>, field: &dyn Fn([f64; 3]) -> [f64; 3]| {
        work(&with, &load(&with), field) - work(&bare, &load(&bare), field)
    };
    let weight = change(&|m| m.weight.clone(), &|_| [0.0, 0.0, -1.0]);
    close(weight, 0.5 * 9.81 * (mass[0] + mass[1]));
    let inertia = change(&|m| m.inertia.clone(), &|_| [1.0, 0.0, 0.0]);
    close(inertia, 0.5 * (mass[0] + mass[1]));
    let moment = change(&|m| m.inertia.clone(), &|[x, _, z]| [z, 0.0, -x]);
    close(moment, 0.5 * (mass[0] * ring.0 + mass[1] * ladder.0));
    let beam = with.model.elements().iter().find(|e| e.kind() == "ring").unwrap();
    let n = 3.0;
    let x: Vec<f64> = beam
        .nodes()
        .iter()
        .flat_map(|&node| {
            let [x, y, _] = with.model.nodes()[node];
            let a = y.atan2(x);
            let (w, v) = ((n * a).cos(), -(n * a).sin() / n);
            [a.cos() * w - a.sin() * v, a.sin() * w + a.cos() * v, 0.0]
        })
        .collect();
    let stiffness = fem::element::reference_stiffness(&**beam).unwrap().to_matrix();
    let energy = fem::linalg::dot(&x, &stiffness.times(&x));
    let exact = 0.5 * std::f64::consts::PI * 2.1e11 * ring.2 * (n * n - 1.0f64).powi(2) / 4.0f64.powi(3);
    assert!((energy / exact - 1.0).abs() < 1e-2, "{energy} {exact}");
}
