//! Marches that stop, are resumed, or cannot write.

use std::fs;

use super::*;

/// Stops a march after some steps, like a user.
struct Patience(std::sync::atomic::AtomicU64, u64);

impl Progress for Patience {
    fn stage(&self, _: &str, _: u64) {}
    fn advance(&self, steps: u64) {
        self.0.fetch_add(steps, std::sync::atomic::Ordering::Relaxed);
    }
    fn interrupted(&self) -> bool {
        self.0.load(std::sync::atomic::Ordering::Relaxed) >= self.1
    }
}

/// A march that was interrupted and resumed equals the uninterrupted one bit for bit; files of other marches are rejected.
#[test]
fn resumed_march_is_the_same() {
    let folder = std::env::temp_dir().join(format!("march-{}", std::process::id()));
    fs::create_dir_all(&folder).unwrap();
    let path = folder.join("march.checkpoint");
    let parts = Parts::new(chain(12.0, 10.0));
    let problem = parts.problem();
    let load = shaking(3.0);
    let mut settings = Settings::new(grid());
    settings.constant = parts.weight();
    settings.newton.tangent_damping = vec![0.0, 0.001];
    let recorder = || QuantityObserver::new(vec![top(problem), base_shear(problem)]);
    let mut whole = recorder();
    let expected = march(problem, &load, &settings, &mut [&mut whole], &Silent).unwrap();
    settings.checkpoint =
        Some(Checkpoint { path: path.clone(), steps: 25, seconds: f64::INFINITY, key: "test".into(), resume: true });
    // Interrupted twice, with new recorders as after a restart.
    for patience in [150, 60] {
        let patience = Patience(std::sync::atomic::AtomicU64::new(0), patience);
        let run = march(problem, &load, &settings, &mut [&mut recorder()], &patience).unwrap();
        assert_eq!(run.outcome, Outcome::Interrupted);
    }
    let mut last = recorder();
    let found = march(problem, &load, &settings, &mut [&mut last], &Silent).unwrap();
    assert_eq!(found.outcome, Outcome::Completed);
    assert_eq!(found.state, expected.state);
    assert_eq!(found.balance, expected.balance);
    assert_eq!((found.cuts, found.cost), (expected.cuts, expected.cost));
    assert_eq!((&last.histories, &last.ranges), (&whole.histories, &whole.ranges));

    let refused = |problem: Problem<'_>, load: &Load, settings: &Settings| {
        let mut recorder = QuantityObserver::new(vec![top(problem), base_shear(problem)]);
        match march(problem, load, settings, &mut [&mut recorder], &Silent) {
            Err(AnalysisError::Checkpoint(error)) => {
                // Whatever is wrong, the file is named.
                assert!(error.to_string().contains(&path.display().to_string()), "{error}");
                error.cause().clone()
            }
            other => panic!("{:?}", other.map(|r| r.outcome)),
        }
    };
    let identity = |e: CheckpointError| matches!(e, CheckpointError::Identity { .. });
    // Another input, and so another key; a model of another size; other settings.
    let mut changed = settings.clone();
    changed.checkpoint.as_mut().unwrap().key.push('2');
    assert!(identity(refused(problem, &load, &changed)));
    let other = Parts::new(chain_of(MASSES + 1, 12.0, 10.0));
    let mut longer = settings.clone();
    longer.constant = other.weight();
    assert!(identity(refused(other.problem(), &load, &longer)));
    let mut changed = settings.clone();
    changed.newton.criteria.energy = 1e-9;
    assert!(identity(refused(problem, &load, &changed)));
    // Truncated, damaged, of another version, no checkpoint at all.
    let bytes = fs::read(&path).unwrap();
    fs::write(&path, &bytes[..bytes.len() - 9]).unwrap();
    assert!(matches!(refused(problem, &load, &settings), CheckpointError::Length { .. }));
    let mut broken = bytes.clone();
    broken[200] ^= 4;
    fs::write(&path, &broken).unwrap();
    assert!(matches!(refused(problem, &load, &settings), CheckpointError::Checksum { .. }));
    broken = bytes.clone();
    broken[8] = 200;
    fs::write(&path, &broken).unwrap();
    let text = refused(problem, &load, &settings).to_string();
    let known = format!("format 200, this one reads format {}", crate::analysis::checkpoint::VERSION);
    assert!(text.contains(&known), "{text}");
    fs::write(&path, b"something else").unwrap();
    assert!(matches!(refused(problem, &load, &settings), CheckpointError::Magic { .. }));
    fs::remove_dir_all(&folder).unwrap();
}

/// Counts warnings, and makes the folder of a checkpoint after some of them: a disk that has room again.
struct Room(std::sync::atomic::AtomicU64, std::path::PathBuf);

impl Progress for Room {
    fn stage(&self, _: &str, _: u64) {}
    fn advance(&self, _: u64) {}
    fn interrupted(&self) -> bool {
        false
    }
    fn warn(&self, what: &str) {
        assert!(what.contains("march.checkpoint"), "{what}");
        if self.0.fetch_add(1, std::sync::atomic::Ordering::Relaxed) == 2 {
            fs::create_dir_all(&self.1).unwrap();
        }
    }
}

/// A checkpoint that cannot be written does not stop the march, is tried again, and leaves no partial file.
#[test]
fn a_march_continues_without_room_for_its_checkpoint() {
    let folder = std::env::temp_dir().join(format!("march-room-{}", std::process::id()));
    let parts = Parts::new(chain(12.0, 10.0));
    let problem = parts.problem();
    let load = shaking(3.0);
    let mut settings = Settings::new(grid());
    settings.constant = parts.weight();
    let expected = march(problem, &load, &settings, &mut [], &Silent).unwrap();
    settings.checkpoint = Some(Checkpoint {
        path: folder.join("march.checkpoint"),
        steps: 25,
        seconds: f64::INFINITY,
        key: "test".into(),
        resume: false,
    });
    let room = Room(std::sync::atomic::AtomicU64::new(0), folder.clone());
    let found = march(problem, &load, &settings, &mut [], &room).unwrap();
    assert_eq!((&found.outcome, &found.state), (&Outcome::Completed, &expected.state));
    // Three times in vain, then there was room.
    assert_eq!(room.0.into_inner(), 3);
    let names: Vec<_> = fs::read_dir(&folder).unwrap().flatten().map(|e| e.file_name()).collect();
    assert_eq!(names, ["march.checkpoint"]);
    fs::remove_dir_all(&folder).unwrap();
}
