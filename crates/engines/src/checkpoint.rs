//! Files that a nonlinear run keeps so that it can be resumed.

use std::path::PathBuf;

use fem::analysis::checkpoint::unfinished;
use fem::analysis::march::Checkpoint;
use results::channel::Side;

/// Checkpoint of a run. A strip writes its second wall to a separate file, `path` with `.theta_180` appended, and a cylinder on isolators
/// its second run.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct CheckpointFile {
    /// File.
    pub path: PathBuf,
    /// Hash of the input: another key is another analysis.
    pub key: String,
    /// Continue from the file if it exists.
    pub resume: bool,
}

impl CheckpointFile {
    /// The files that a run may keep.
    pub fn files(&self) -> [PathBuf; 2] {
        Side::BOTH.map(|side| self.path_of(side))
    }

    /// Removes the files of a finished run. Files that cannot be removed are left behind.
    pub fn remove(&self) {
        for path in self.files() {
            let _ = std::fs::remove_file(unfinished(&path));
            let _ = std::fs::remove_file(path);
        }
    }

    /// The checkpoint of a run of the whole tank, written every `seconds` [s] of computing time.
    pub(crate) fn whole(&self, seconds: f64) -> Checkpoint {
        Checkpoint { path: self.path.clone(), steps: 0, seconds, key: self.key.clone(), resume: self.resume }
    }

    /// The checkpoint of one wall of a strip.
    pub(crate) fn wall(&self, side: Side, seconds: f64) -> Checkpoint {
        Checkpoint { path: self.path_of(side), key: format!("{} {}", self.key, side.id()), ..self.whole(seconds) }
    }

    /// The checkpoint of a second run after the first, of a tank that moves on isolators.
    pub(crate) fn again(&self) -> CheckpointFile {
        CheckpointFile { path: self.path_of(Side::Back), key: format!("{} again", self.key), ..self.clone() }
    }

    fn path_of(&self, side: Side) -> PathBuf {
        let mut path = self.path.as_os_str().to_owned();
        if side == Side::Back {
            path.push(".");
            path.push(side.id());
        }
        path.into()
    }
}
