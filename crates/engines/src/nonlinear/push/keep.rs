//! The checkpoint of a pushover: when it is written, and its contents.
//!
//! ```text
//! perfect shell, if it is finished: end | states        buckling mode, if it is known: μ, place, φ        path under way, if
//! there is one
//! ```
//!
//! A restored path continues bit for bit (`path`); the model is rebuilt from the same numbers.

use std::time::Instant;

use fem::analysis::checkpoint::{CheckpointError, Hash, Reader, Writer};
use fem::progress::Progress;
use nalgebra::Vector3;

use super::buckling::Mode;
use super::model::Plan;
use super::seen::Seen;
use crate::FeError;
use crate::checkpoint::CheckpointFile;

/// Contents of a checkpoint.
#[derive(Default)]
pub(super) struct Kept<'a> {
    /// States of the perfect shell, and why its path ends.
    pub(super) perfect: Option<(Seen<'a>, String)>,
    /// The buckling mode.
    pub(super) mode: Option<Mode>,
    /// The path under way.
    pub(super) path: Option<Reader>,
}

/// Writes checkpoints, if there is a file for them.
pub(super) struct Keeper<'f> {
    file: Option<&'f CheckpointFile>,
    identity: u64,
    /// Computing time between two checkpoints [s].
    seconds: f64,
    /// When the last one was written, or could not be; `None`: the next is due at once.
    last: Option<Instant>,
    /// Whether this run has written one.
    written: bool,
    /// Whether the last one could not be written.
    failed: bool,
    perfect: Option<Writer>,
    mode: Option<Writer>,
}

impl<'f> Keeper<'f> {
    /// For a plan; the file is not touched yet.
    pub(super) fn new(file: Option<&'f CheckpointFile>, plan: &Plan) -> Keeper<'f> {
        let mut hash = Hash::default();
        // With the uplift of the foot.
        hash.text("pushover 2");
        hash.text(file.map_or("", |f| &f.key));
        for values in [&plan.levels, &plan.angles, &plan.impulsive.line] {
            hash.count(values.len());
        }
        hash.count(plan.plate.as_ref().map_or(0, |plate| plate.radii.len()));
        hash.count(usize::from(plan.plane));
        Keeper {
            file,
            identity: hash.value(),
            seconds: plan.options.checkpoint,
            // A run killed early can be resumed, too; an older checkpoint is not overwritten before there is something to keep.
            last: file.filter(|f| f.path.exists()).map(|_| Instant::now()),
            written: false,
            failed: false,
            perfect: None,
            mode: None,
        }
    }

    /// Contents of the file, if it exists and the run resumes.
    ///
    /// Errors: a file of another pushover, or no sound one.
    pub(super) fn resume<'a>(&mut self, plan: &'a Plan<'a>) -> Result<Kept<'a>, FeError> {
        match self.file {
            Some(file) if file.resume && file.path.exists() => {
                let kept = Reader::open(&file.path, self.identity).and_then(|from| read(plan, from));
                let kept = kept.map_err(|fault| self.unusable(fault.into()))?;
                kept.perfect.iter().for_each(|(seen, end)| self.finished(seen, end));
                kept.mode.iter().for_each(|mode| self.found(mode));
                Ok(kept)
            }
            _ => Ok(Kept::default()),
        }
    }

    /// Names the file in a fault of its payload.
    pub(super) fn unusable(&self, error: FeError) -> FeError {
        match (error, self.file) {
            (FeError::Checkpoint(fault), Some(file)) => FeError::Checkpoint(fault.of(&file.path)),
            (error, _) => error,
        }
    }

    /// Takes note of the perfect shell.
    pub(super) fn finished(&mut self, perfect: &Seen<'_>, end: &str) {
        let mut to = Writer::default();
        to.text(end);
        perfect.save(&mut to);
        self.perfect = Some(to);
    }

    /// Takes note of the buckling mode.
    pub(super) fn found(&mut self, mode: &Mode) {
        let mut to = Writer::default();
        to.numbers(&[mode.factor, mode.place.0, mode.place.1]);
        let nodes = mode.field.iter().flatten();
        let values: Vec<f64> = nodes.flatten().flat_map(|v| v.iter().copied()).collect();
        to.numbers(&values);
        self.mode = Some(to);
    }

    /// Whether it is time for another checkpoint.
    pub(super) fn due(&self) -> bool {
        let waited = |last: Instant| last.elapsed().as_secs_f64() >= self.seconds;
        self.file.is_some() && self.last.is_none_or(waited)
    }

    /// Writes a checkpoint; `path` is the one under way. The run can do without: a disk that is full may have room at the next.
    pub(super) fn save(&mut self, path: Option<Writer>, progress: &dyn Progress) {
        let Some(file) = self.file else { return };
        let mut to = Writer::default();
        for part in [self.perfect.clone(), self.mode.clone(), path] {
            to.count(usize::from(part.is_some()));
            part.into_iter().for_each(|part| to.part(part));
        }
        let saved = to.save(&file.path, self.identity);
        self.last = Some(Instant::now());
        self.written |= saved.is_ok();
        if let Err(error) = &saved {
            if progress.interrupted() {
                progress.warn(&format!("{error}; the computation since the last checkpoint is lost"));
            } else if !self.failed {
                // One warning is enough while the disk stays full.
                progress.warn(&format!("{error}; the run continues and tries again later"));
            }
        }
        self.failed = saved.is_err();
    }

    /// Removes the checkpoint of this run: it cannot be resumed.
    pub(super) fn discard(&self) {
        if let Some(file) = self.file.filter(|_| self.written) {
            file.remove();
        }
    }
}

fn read<'a>(plan: &'a Plan<'a>, mut from: Reader) -> Result<Kept<'a>, CheckpointError> {
    let mut parts = [None, None, None];
    for part in &mut parts {
        if from.count()? != 0 {
            *part = Some(from.part()?);
        }
    }
    let [perfect, mode, path] = parts;
    let perfect = perfect.map(|mut from| -> Result<_, CheckpointError> {
        let end = from.text()?;
        Ok((Seen::restore(plan, &mut from)?, end))
    });
    let mode = mode.map(|mut from| -> Result<Mode, CheckpointError> {
        let mut numbers = [0.0; 3];
        from.numbers_into("the buckling load", &mut numbers)?;
        let angles = plan.angles.len();
        let mut values = vec![0.0; 6 * plan.levels.len() * angles];
        from.numbers_into("the buckling mode", &mut values)?;
        let node = |v: &[f64]| [Vector3::new(v[0], v[1], v[2]), Vector3::new(v[3], v[4], v[5])];
        let nodes: Vec<[Vector3<f64>; 2]> = values.chunks_exact(6).map(node).collect();
        Ok(Mode {
            factor: numbers[0],
            field: nodes.chunks_exact(angles).map(<[_]>::to_vec).collect(),
            place: (numbers[1], numbers[2]),
        })
    });
    Ok(Kept { perfect: perfect.transpose()?, mode: mode.transpose()?, path })
}
