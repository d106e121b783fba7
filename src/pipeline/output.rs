//! The output folder: whole or not at all.
//!
//! Files are written into a staging folder beside the target and moved over at the end, so that a failure leaves
//! neither a half-written nor a mixed results folder. A folder that holds anything tankcheck did not write is refused.

use std::path::{Path, PathBuf};
use std::sync::{Mutex, PoisonError};

use crate::error::Error;
use crate::results::{self, describe};

/// What a verification writes into its output folder.
pub const OUTPUT: [&str; 4] = [results::RESULTS_FILE, results::SERIES_FILE, "report.html", "figures"];

/// Kept in golden folders beside the results: why they were accepted, and what they show.
const COMPANIONS: [&str; 2] = ["accepted.json", "README.md"];

/// Staging folders of this process, for [`discard_unfinished`].
static UNFINISHED: Mutex<Vec<PathBuf>> = Mutex::new(Vec::new());

/// Removes what is half-written, before the process is ended without unwinding.
pub fn discard_unfinished() {
    for staging in UNFINISHED.lock().unwrap_or_else(PoisonError::into_inner).drain(..) {
        // Already moved, or litter that cannot be removed: nothing to do either way.
        let _ = std::fs::remove_dir_all(staging);
    }
}

/// Whether a verification writes an entry of this name.
fn is_output(name: &str) -> bool {
    OUTPUT.contains(&name)
}

/// An output folder under construction; dropped without [`OutputFolder::commit`] it vanishes.
#[derive(Debug)]
pub struct OutputFolder {
    target: PathBuf,
    staging: PathBuf,
    /// Names this kind of folder is written with: an earlier run's are replaced, all others are foreign.
    owns: fn(&str) -> bool,
}

impl OutputFolder {
    /// Prepares to write the results of a verification into `target`.
    ///
    /// Errors: the target is a file, holds foreign files, or cannot be written.
    pub fn prepare(target: &Path) -> Result<OutputFolder, Error> {
        OutputFolder::of(target, is_output, "--out")
    }

    /// Prepares to write files whose names `owns` knows into `target`, given by `option`.
    ///
    /// Errors: as [`OutputFolder::prepare`].
    pub fn of(target: &Path, owns: fn(&str) -> bool, option: &str) -> Result<OutputFolder, Error> {
        let fault = |what: String| Error::File {
            path: target.into(),
            what,
        };
        if target.exists() {
            if !target.is_dir() {
                return Err(fault("is a file, expected an output folder".into()));
            }
            for entry in std::fs::read_dir(target).map_err(|e| fault(describe(&e)))? {
                let name = entry
                    .map_err(|e| fault(describe(&e)))?
                    .file_name()
                    .to_string_lossy()
                    .into_owned();
                if !owns(&name) && !COMPANIONS.contains(&name.as_str()) {
                    return Err(fault(format!(
                        "holds `{name}`, which tankcheck did not write; give an empty or new folder with {option}"
                    )));
                }
            }
            if std::fs::metadata(target).is_ok_and(|m| m.permissions().readonly()) {
                return Err(fault("is read-only".into()));
            }
        }
        let name = target
            .file_name()
            .map_or_else(|| "out".into(), |n| n.to_string_lossy().into_owned());
        let parent = match target.parent() {
            Some(parent) if !parent.as_os_str().is_empty() => parent.to_path_buf(),
            _ => PathBuf::from("."),
        };
        std::fs::create_dir_all(&parent).map_err(|e| Error::File {
            path: parent.clone(),
            what: describe(&e),
        })?;
        // Inside an existing target (it may be a mount point, its parent read-only), else beside it.
        let home = if target.exists() { target.to_path_buf() } else { parent };
        let staging = home.join(format!(".{name}.{}.partial", std::process::id()));
        std::fs::create_dir(&staging).map_err(|e| fault(describe(&e)))?;
        UNFINISHED
            .lock()
            .unwrap_or_else(PoisonError::into_inner)
            .push(staging.clone());
        Ok(OutputFolder {
            target: target.into(),
            staging,
            owns,
        })
    }

    /// Where to write.
    pub fn path(&self) -> &Path {
        &self.staging
    }

    /// Moves everything to the target, replacing the results of an earlier run.
    pub fn commit(self) -> Result<(), Error> {
        let fault = |path: &Path, e: std::io::Error| Error::File {
            path: path.into(),
            what: describe(&e),
        };
        if !self.target.exists() {
            return std::fs::rename(&self.staging, &self.target).map_err(|e| fault(&self.target, e));
        }
        for entry in names(&self.target).map_err(|e| fault(&self.target, e))? {
            let old = self.target.join(&entry);
            if !(self.owns)(&entry) {
                continue;
            }
            if old.is_dir() {
                std::fs::remove_dir_all(&old).map_err(|e| fault(&old, e))?;
            } else {
                std::fs::remove_file(&old).map_err(|e| fault(&old, e))?;
            }
        }
        for entry in names(&self.staging).map_err(|e| fault(&self.staging, e))? {
            let (source, target) = (self.staging.join(&entry), self.target.join(&entry));
            std::fs::rename(&source, &target).map_err(|e| fault(&target, e))?;
        }
        Ok(())
    }
}

impl Drop for OutputFolder {
    fn drop(&mut self) {
        // Nothing to do if it was moved; a staging folder that cannot be removed is only litter.
        let _ = std::fs::remove_dir_all(&self.staging);
        let mut unfinished = UNFINISHED.lock().unwrap_or_else(PoisonError::into_inner);
        unfinished.retain(|staging| *staging != self.staging);
    }
}

/// Names of the entries of a folder.
fn names(folder: &Path) -> std::io::Result<Vec<String>> {
    std::fs::read_dir(folder)?
        .map(|entry| Ok(entry?.file_name().to_string_lossy().into_owned()))
        .collect()
}

/// Copies the files of a results folder over another one.
pub fn copy_results(from: &Path, to: &Path) -> Result<(), Error> {
    let fault = |path: &Path, e: std::io::Error| Error::File {
        path: path.into(),
        what: describe(&e),
    };
    for entry in OUTPUT {
        let (source, target) = (from.join(entry), to.join(entry));
        if source.is_dir() {
            std::fs::create_dir_all(&target).map_err(|e| fault(&target, e))?;
            for file in std::fs::read_dir(&source).map_err(|e| fault(&source, e))? {
                let file = file.map_err(|e| fault(&source, e))?;
                let copy = target.join(file.file_name());
                std::fs::copy(file.path(), &copy).map_err(|e| fault(&copy, e))?;
            }
        } else if source.is_file() {
            std::fs::copy(&source, &target).map_err(|e| fault(&target, e))?;
        }
    }
    Ok(())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn nothing_is_left_behind_without_commit() {
        let home = tempfile::tempdir().expect("a temporary folder");
        let target = home.path().join("out");
        let folder = OutputFolder::prepare(&target).expect("a new folder can be prepared");
        std::fs::write(folder.path().join("report.html"), "x").expect("staging is writable");
        drop(folder);
        assert_eq!(std::fs::read_dir(home.path()).expect("readable").count(), 0);
    }

    #[test]
    fn commit_replaces_an_earlier_run_and_keeps_companions() {
        let home = tempfile::tempdir().expect("a temporary folder");
        let target = home.path().join("out");
        std::fs::create_dir_all(target.join("figures")).expect("writable");
        for name in ["report.html", "series.csv", "accepted.json", "figures/old.svg"] {
            std::fs::write(target.join(name), "old").expect("writable");
        }
        let folder = OutputFolder::prepare(&target).expect("own files are no obstacle");
        std::fs::write(folder.path().join("report.html"), "new").expect("writable");
        folder.commit().expect("can be moved");
        assert_eq!(
            std::fs::read_to_string(target.join("report.html")).expect("readable"),
            "new"
        );
        assert!(!target.join("series.csv").exists() && !target.join("figures").exists());
        assert!(target.join("accepted.json").exists());
        let left: Vec<_> = std::fs::read_dir(&target)
            .expect("readable")
            .flatten()
            .map(|e| e.file_name())
            .collect();
        assert_eq!(left.len(), 2, "{left:?}");
    }

    #[test]
    fn foreign_files_are_never_touched() {
        let home = tempfile::tempdir().expect("a temporary folder");
        std::fs::write(home.path().join("thesis.doc"), "x").expect("writable");
        let error = OutputFolder::prepare(home.path()).expect_err("a foreign file");
        assert!(error.to_string().contains("thesis.doc"), "{error}");
    }
}
