//! Checkpoints of a march: a file is rejected with a message or read; a march resumes from it or rejects it, and never panics.
//!
//! The first byte of an input selects the meaning of the rest: a file, or the payload of a file whose head and checksum are right
//! (the checksum finds accidental damage; the reader must also survive a payload with a valid one). The untouched payload gives the
//! uninterrupted run to the last bit.

use std::path::{Path, PathBuf};
use std::sync::{Arc, OnceLock};

use fem::analysis::checkpoint::{Hash, MAGIC, Reader, Writer, inspect};
use fem::analysis::march::{Checkpoint, Outcome, Problem, Quantity, QuantityObserver, Run, Settings, march};
use fem::analysis::motion::{Grid, Motion};
use fem::analysis::observable::Observable;
use fem::analysis::system::System;
use fem::analysis::transient::Load;
use fem::assembly::Assembler;
use fem::dofs::Dof;
use fem::element::spring::{Direction, PointMass, Spring};
use fem::linalg::{Ordering, Symbolic};
use fem::model::{Builder, Model};
use fem::progress::{Progress, Silent};

use super::results::Folder;

/// Bytes of a file before its payload.
const HEAD: usize = 28;
const MASSES: usize = 3;
const DT: f64 = 0.02;
const STEPS: usize = 12;

/// Runs the target on one input.
pub fn run(bytes: &[u8]) {
    let Some((&kind, rest)) = bytes.split_first() else { return };
    match kind % 4 {
        0 => file(rest),
        1 => reader(rest),
        _ => payload(rest),
    }
}

/// Any bytes as a file.
fn file(bytes: &[u8]) {
    let folder = Folder::new();
    let path = folder.put("checkpoint", bytes);
    match inspect(&path) {
        Err(error) => assert!(error.to_string().contains("checkpoint"), "{error}"),
        Ok(()) => {
            assert!(bytes.len() >= HEAD + 8 && bytes.starts_with(&MAGIC), "no checkpoint was taken for one");
            let mut hash = Hash::default();
            hash.bytes(&bytes[HEAD..bytes.len() - 8]);
            assert_eq!(bytes[bytes.len() - 8..], hash.value().to_le_bytes(), "a damaged file was taken");
        }
    }
}

/// Values are read in the order in which they were written; reading beyond the end returns a message.
fn reader(bytes: &[u8]) {
    let folder = Folder::new();
    let path = folder.0.join("checkpoint");
    let chunks: Vec<f64> =
        bytes.chunks_exact(8).map(|c| f64::from_le_bytes(c.try_into().expect("eight bytes"))).collect();
    let text = String::from_utf8_lossy(bytes);
    let mut to = Writer::default();
    to.count(bytes.len());
    to.numbers(&chunks);
    to.text(&text);
    let mut part = Writer::default();
    chunks.iter().for_each(|v| part.number(*v));
    to.part(part);
    to.save(&path, 7).expect("the temporary folder is writable");
    assert!(Reader::open(&path, 8).is_err(), "of another run");
    let mut from = Reader::open(&path, 7).expect("written values can be read");
    assert_eq!(from.count(), Ok(bytes.len()));
    let bits = |v: &[f64]| v.iter().map(|v| v.to_bits()).collect::<Vec<u64>>();
    assert_eq!(bits(&from.numbers("numbers").expect("numbers")), bits(&chunks));
    assert_eq!(from.text().as_deref(), Ok(&*text));
    let mut part = from.part().expect("a part");
    for value in &chunks {
        assert_eq!(part.number().map(f64::to_bits), Ok(value.to_bits()));
    }
    assert!(part.number().is_err() && from.count().is_err() && from.part().is_err() && from.text().is_err());
    // The bytes themselves as a payload, read in any order.
    std::fs::write(&path, framed(bytes, 7)).expect("the temporary folder is writable");
    let mut from = Reader::open(&path, 7).expect("the head is right");
    for byte in bytes {
        let end = match byte % 5 {
            0 => from.count().is_err(),
            1 => from.number().is_err(),
            2 => from.numbers("numbers").is_err(),
            3 => from.text().is_err(),
            _ => from.part().is_err(),
        };
        if end {
            return;
        }
    }
}

/// A file of this payload.
fn framed(payload: &[u8], fingerprint: u64) -> Vec<u8> {
    let mut hash = Hash::default();
    hash.bytes(payload);
    let mut bytes = MAGIC.to_vec();
    bytes.extend(fem::analysis::checkpoint::VERSION.to_le_bytes());
    bytes.extend(fingerprint.to_le_bytes());
    bytes.extend((payload.len() as u64).to_le_bytes());
    bytes.extend(payload);
    bytes.extend(hash.value().to_le_bytes());
    bytes
}

/// A march resumes from a payload or rejects it.
fn payload(bytes: &[u8]) {
    let known = known();
    let folder = Folder::new();
    let path = folder.put("checkpoint", &framed(bytes, known.fingerprint));
    let mut recorder = known.chain.recorder();
    match known.chain.march(Some(&path), &mut recorder, &Silent) {
        Err(error) => assert!(error.contains("checkpoint"), "{error}"),
        Ok(run) if bytes == known.payload => {
            assert_eq!(run.state, known.run.state);
            assert_eq!(recorder.histories, known.histories);
        }
        Ok(run) => assert!(run.time.is_finite(), "a run at no time"),
    }
}

/// A chain of masses and springs, shaken.
struct Chain {
    model: Model,
    assembler: Assembler,
    symbolic: Arc<Symbolic>,
    system: System,
}

impl Chain {
    fn new() -> Chain {
        let mut builder = Builder::new();
        for k in 0..=MASSES {
            let node = builder.node([k as f64, 0.0, 0.0]);
            builder.hold(node, Dof::Uy);
            builder.hold(node, Dof::Uz);
            if k == 0 {
                builder.hold(node, Dof::Ux);
                continue;
            }
            builder.element("masses", PointMass::new(node, 2.0).expect("a mass"));
            let x = Direction::Translation([1.0, 0.0, 0.0]);
            builder.element("springs", Spring::between(k - 1, k, x, 400.0).expect("a spring"));
        }
        let model = builder.build().expect("a model");
        let assembler = Assembler::new(&model);
        let symbolic = Symbolic::new(assembler.pattern().clone(), &Ordering::MinimumDegree).expect("a pattern");
        let system = System::new(&model, &assembler).expect("a system");
        Chain { symbolic: Arc::new(symbolic), model, assembler, system }
    }

    fn recorder(&self) -> QuantityObserver {
        QuantityObserver::new(vec![Quantity::Linear(Observable::displacement(&self.model, MASSES, Dof::Ux))])
    }

    fn march(
        &self,
        checkpoint: Option<&Path>,
        recorder: &mut QuantityObserver,
        progress: &dyn Progress,
    ) -> Result<Run, String> {
        let problem =
            Problem { model: &self.model, assembler: &self.assembler, symbolic: &self.symbolic, system: &self.system };
        let grid = Grid::new(DT, STEPS as f64 * DT, 0.0, DT);
        let ground: Vec<f64> = (0..=STEPS).map(|k| (k as f64).sin()).collect();
        let load = Load::ground(0, Motion::sampled(DT, &ground, &grid));
        let mut settings = Settings::new(grid);
        settings.checkpoint = checkpoint.map(|path| Checkpoint {
            path: PathBuf::from(path),
            steps: 0,
            seconds: f64::INFINITY,
            key: "fuzz".into(),
            resume: true,
        });
        march(problem, &load, &settings, &mut [recorder], progress).map_err(|e| e.to_string())
    }
}

/// The uninterrupted run, and the checkpoint of an interrupted one.
struct Known {
    chain: Chain,
    run: Run,
    histories: Vec<Vec<f64>>,
    fingerprint: u64,
    payload: Vec<u8>,
}

fn known() -> &'static Known {
    static KNOWN: OnceLock<Known> = OnceLock::new();
    KNOWN.get_or_init(|| {
        let chain = Chain::new();
        let mut recorder = chain.recorder();
        let run = chain.march(None, &mut recorder, &Silent).expect("a chain moves");
        let folder = Folder::new();
        let path = folder.0.join("checkpoint");
        let stopped = chain.march(Some(&path), &mut chain.recorder(), &Patience::default()).expect("a chain moves");
        assert_eq!(stopped.outcome, Outcome::Interrupted);
        let bytes = std::fs::read(&path).expect("a checkpoint is written");
        let fingerprint = u64::from_le_bytes(bytes[12..20].try_into().expect("eight bytes"));
        Known { payload: bytes[HEAD..bytes.len() - 8].to_vec(), histories: recorder.histories, chain, run, fingerprint }
    })
}

/// Stops a march after some steps, as a user does.
#[derive(Default)]
struct Patience(std::sync::atomic::AtomicU64);

impl Progress for Patience {
    fn stage(&self, _: &str, _: u64) {}
    fn advance(&self, steps: u64) {
        self.0.fetch_add(steps, std::sync::atomic::Ordering::Relaxed);
    }
    fn interrupted(&self) -> bool {
        self.0.load(std::sync::atomic::Ordering::Relaxed) >= STEPS as u64 / 2
    }
}

/// The file of an interrupted run, and its payload.
pub fn seeds() -> Vec<Vec<u8>> {
    let known = known();
    let whole = framed(&known.payload, known.fingerprint);
    let marked = |kind: u8, bytes: &[u8]| [&[kind], bytes].concat();
    vec![marked(0, &whole), marked(1, &known.payload[..64]), marked(2, &known.payload)]
}
