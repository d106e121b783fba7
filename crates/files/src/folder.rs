//! The output folder of a command.

use std::collections::BTreeSet;
use std::fs::File;
use std::io::ErrorKind;
use std::path::{Path, PathBuf};

use super::manifest::{self, Found, MANIFEST_FILE, Manifest};
use super::staging::{self, Commit, Staging};
use super::{files_below, sync, unwritten, write_whole};
use crate::code::Code;
use crate::error::{Error, describe};

/// A kind of results: folders of different kinds do not replace each other.
#[derive(Clone, Copy, Debug)]
pub struct Kind {
    /// Name in the manifest.
    pub id: &'static str,
    /// The command that writes it, and the option that names its folder, for messages.
    pub option: &'static str,
    /// Names (files and folders at the top) that such results may have.
    pub names: fn(&str) -> bool,
    /// Names kept from earlier results of the same kind unless they are rewritten.
    pub keeps: fn(&str) -> bool,
}

/// An output folder under construction; removed on drop unless [`OutputFolder::commit`] was called.
#[derive(Debug)]
pub struct OutputFolder {
    target: PathBuf,
    kind: Kind,
    staging: Staging,
    /// Folders created for it, the deepest last.
    made: Vec<PathBuf>,
    committed: bool,
}

impl OutputFolder {
    /// Prepares to write results of a kind into `target`; removes the leftovers of killed runs there. Errors: the
    /// target is a file, or contains results of another kind, or foreign or changed files at the paths of the
    /// results; a folder that cannot be created.
    pub fn prepare(target: &Path, kind: Kind) -> Result<OutputFolder, Error> {
        OutputFolder::make(target, kind, false)
    }

    /// As [`OutputFolder::prepare`] for a run with a checkpoint, which two runs must not share.
    ///
    /// Errors: as there; another run that writes into the same folder.
    pub fn prepare_alone(target: &Path, kind: Kind) -> Result<OutputFolder, Error> {
        OutputFolder::make(target, kind, true)
    }

    fn make(target: &Path, kind: Kind, alone: bool) -> Result<OutputFolder, Error> {
        let fault = |code: Code, what: String| Error::File { code, path: target.into(), what };
        // Files are compared with their manifest: not while another run moves them.
        let _lock = Lock::exclusive(target);
        staging::sweep(target);
        staging::sweep(&parent(target));
        if let Some(process) = alone.then(|| staging::owner([target.to_path_buf(), parent(target)], target)).flatten() {
            return Err(Error::Taken {
                path: target.into(),
                what: format!("is in use by another run (process {process})"),
                help: format!("wait for it, or name another folder with {}", kind.option),
            });
        }
        let exists = target.symlink_metadata().is_ok();
        if exists && !target.is_dir() {
            return Err(fault(Code::FileTaken, "is a file, expected an output folder".into()));
        }
        if exists {
            vacant(target, kind)?;
            if std::fs::metadata(target).is_ok_and(|m| m.permissions().readonly()) {
                return Err(fault(Code::NotWritten, "is read-only".into()));
            }
        }
        // Inside an existing target (it may be a mount point, its parent read-only), else next to it.
        let mut made = Vec::new();
        let home = if exists {
            target.to_path_buf()
        } else {
            let parent = parent(target);
            let missing: Vec<PathBuf> = parent
                .ancestors()
                .take_while(|p| !p.as_os_str().is_empty() && !p.exists())
                .map(Path::to_path_buf)
                .collect();
            std::fs::create_dir_all(&parent).map_err(|e| Error::File {
                code: Code::NotWritten,
                path: parent.clone(),
                what: describe(&e),
            })?;
            made.extend(missing.into_iter().rev());
            parent
        };
        let name = target.file_name().map_or_else(|| "out".into(), |n| n.to_string_lossy().into_owned());
        match Staging::new(&home, &name, target) {
            Ok(staging) => Ok(OutputFolder { target: target.into(), kind, staging, made, committed: false }),
            Err(error) => {
                unmake(&made);
                match error.kind() {
                    ErrorKind::StorageFull | ErrorKind::QuotaExceeded => Err(unwritten(target, &error)),
                    _ => Err(fault(Code::NotWritten, describe(&error))),
                }
            }
        }
    }

    /// Where to write.
    pub fn path(&self) -> PathBuf {
        self.staging.files()
    }

    /// Top names of the earlier results in the target that these do not have: the commit removes them.
    pub fn stale(&self) -> Vec<String> {
        let Found::Own(old) = Manifest::find(&self.target) else { return Vec::new() };
        let new = files_below(&self.path()).unwrap_or_default();
        let tops = |path: &str| path.split('/').next().unwrap_or_default().to_owned();
        let written: BTreeSet<String> = new.iter().map(|path| tops(&manifest::key(path))).collect();
        let earlier: BTreeSet<String> = old.files.keys().map(|name| tops(name)).collect();
        earlier.into_iter().filter(|top| !written.contains(top) && !(self.kind.keeps)(top)).collect()
    }

    /// Moves everything to the target, replacing the results of an earlier run. Errors: [`Error::Unwritten`], with
    /// the old results kept; files created meanwhile at the paths of the results.
    pub fn commit(mut self) -> Result<(), Error> {
        let files = self.path();
        let mut manifest = Manifest::of(&files, self.kind.id)?;
        let new: Vec<PathBuf> = files_below(&files).map_err(|e| unwritten(&files, &e))?;
        // One commit at a time; one that was killed while others waited for it is finished first.
        let _lock = Lock::exclusive(&self.target);
        staging::sweep(&self.target);
        // An ending process waits until everything is in its place.
        let mut ledger = staging::ledger();
        let mut stale = Vec::new();
        let exists = self.target.is_dir();
        if exists {
            let old = vacant(&self.target, self.kind)?;
            for path in &new {
                self.free(path, old.as_ref())?;
            }
            for (name, hash) in old.map(|m| m.files).unwrap_or_default() {
                let top = name.split('/').next().unwrap_or_default();
                let written = manifest.files.contains_key(&name);
                match (self.kind.keeps)(top) {
                    true => drop(manifest.files.entry(name).or_insert(hash)),
                    false if !written => stale.push(manifest::path(&name)),
                    false => {}
                }
            }
        }
        write_whole(&files.join(MANIFEST_FILE), manifest.text()?.as_bytes())?;
        durable(&files, &new)?;
        ledger.unfinished.retain(|folder| *folder != self.staging.folder);
        self.committed = true;
        let moved = match exists {
            false => std::fs::rename(&files, &self.target).and_then(|()| sync(&parent(&self.target))),
            true => {
                let target = std::path::absolute(&self.target).map_err(|e| unwritten(&self.target, &e))?;
                self.staging.move_on(&Commit { target, stale })
            }
        };
        ledger.kept |= moved.is_ok();
        self.staging.release();
        moved.map_err(|e| unwritten(&self.target, &e))
    }

    /// Whether a new file may be placed at its path in the target.
    fn free(&self, path: &Path, old: Option<&Manifest>) -> Result<(), Error> {
        let key = manifest::key(path);
        let there = self.target.join(path).symlink_metadata().is_ok();
        match there && !old.is_some_and(|m| m.files.contains_key(&key)) {
            true => Err(foreign(&self.target, &key, self.kind)),
            false => Ok(()),
        }
    }
}

impl Drop for OutputFolder {
    fn drop(&mut self) {
        if !self.committed {
            // The staging folder first: it may be inside one of them.
            self.staging.discard();
            unmake(&self.made);
        }
    }
}

/// Names of kept files that were changed by others.
pub fn edited(folder: &Path, kind: Kind) -> Vec<String> {
    let Found::Own(manifest) = Manifest::find(folder) else { return Vec::new() };
    let names = manifest.files.keys().filter(|name| (kind.keeps)(name));
    names.filter(|name| manifest.changed(folder, |other| other == name.as_str()).is_some()).cloned().collect()
}

/// Message of an interrupted run that does not replace complete results of an earlier run.
pub fn kept_complete(folder: &Path) -> String {
    format!(
        "`{}` keeps the complete results of an earlier run; the results of this interrupted run are not written",
        folder.display()
    )
}

/// The lock of a results folder: its files are compared with their manifest, moved, and read as a set, one after the other. The folder itself is
/// locked, or its parent while it does not exist. Without effect on file systems without locks.
#[derive(Debug)]
pub struct Lock {
    _folder: Option<File>,
}

impl Lock {
    fn exclusive(target: &Path) -> Lock {
        Lock::take(target, File::lock)
    }

    fn take(target: &Path, lock: fn(&File) -> std::io::Result<()>) -> Lock {
        loop {
            let exists = target.is_dir();
            let parent = parent(target);
            let folder = File::open(if exists { target } else { &parent }).ok();
            let _ = folder.as_ref().map(lock);
            // It may have been made by the run that had the lock.
            if target.is_dir() == exists {
                return Lock { _folder: folder };
            }
        }
    }
}

/// Finishes or removes the leftovers of killed runs in and next to a results folder. Call before reading results. While the value that it returns
/// lives, no run replaces them.
pub fn settle(folder: &Path) -> Lock {
    let parent = parent(folder);
    if staging::leftover(folder) || staging::leftover(&parent) {
        let _lock = Lock::exclusive(folder);
        staging::sweep(folder);
        staging::sweep(&parent);
    }
    Lock::take(folder, File::lock_shared)
}

/// The first file of a folder that was changed or removed since it was written, among those that `counts` accepts. None without a manifest.
pub fn differing(folder: &Path, counts: fn(&str) -> bool) -> Option<String> {
    match Manifest::find(folder) {
        Found::Own(manifest) => {
            let missing = |name: &&String| counts(name) && folder.join(name).symlink_metadata().is_err();
            let changed = manifest.changed(folder, counts).map(str::to_owned);
            changed.or_else(|| manifest.files.keys().find(missing).cloned())
        }
        Found::None => None,
        Found::Foreign => Some(MANIFEST_FILE.into()),
    }
}

/// Folders in a folder that have the name of a staging folder and no marker of this program: they are nobody's to remove.
pub fn unmarked(folder: &Path) -> Vec<PathBuf> {
    staging::unmarked(folder)
}

/// Whether results of a kind may be written into an existing folder; the manifest of those that are there.
///
/// Errors: results of another kind, foreign or changed files in the way.
fn vacant(target: &Path, kind: Kind) -> Result<Option<Manifest>, Error> {
    let fault = |e: std::io::Error| Error::unreadable(target, &e);
    let manifest = match Manifest::find(target) {
        Found::None => None,
        Found::Own(manifest) => Some(manifest),
        Found::Foreign => return Err(foreign(target, MANIFEST_FILE, kind)),
    };
    if let Some(other) = manifest.as_ref().filter(|m| m.kind != kind.id) {
        return Err(taken(target, format!("contains results of `tankcheck {}`", other.kind), kind));
    }
    let entries = std::fs::read_dir(target).map_err(fault)?;
    let mut names = Vec::new();
    for entry in entries {
        names.push(entry.map_err(fault)?.file_name().to_string_lossy().into_owned());
    }
    names.sort();
    let own = |name: &String| manifest.as_ref().is_some_and(|m| m.has(name));
    if let Some(name) = names.iter().find(|name| (kind.names)(name) && !own(name)) {
        return Err(foreign(target, name, kind));
    }
    if let Some(manifest) = &manifest {
        let replaced = |name: &str| !(kind.keeps)(name.split('/').next().unwrap_or_default());
        if let Some(name) = manifest.changed(target, replaced) {
            return Err(taken(target, format!("`{name}` has changed since tankcheck wrote it"), kind));
        }
    }
    Ok(manifest)
}

fn foreign(target: &Path, name: &str, kind: Kind) -> Error {
    let what = format!("contains `{name}`, which is not in the manifest of tankcheck");
    taken(target, what, kind)
}

fn taken(target: &Path, what: String, kind: Kind) -> Error {
    Error::Taken {
        path: target.into(),
        what,
        help: format!("move it elsewhere, or name another folder with {}", kind.option),
    }
}

/// Synchronises files and their folders to the disk, in parallel: a journal writes many for the cost of a few.
fn durable(files: &Path, new: &[PathBuf]) -> Result<(), Error> {
    const THREADS: usize = 8;
    let outcome = std::thread::scope(|scope| {
        let share = new.len().div_ceil(THREADS).max(1);
        let workers: Vec<_> = new
            .chunks(share)
            .map(|part| scope.spawn(move || part.iter().try_for_each(|path| sync(&files.join(path)))))
            .collect();
        let outcomes = workers.into_iter().map(|worker| match worker.join() {
            Ok(outcome) => outcome,
            Err(panic) => std::panic::resume_unwind(panic),
        });
        outcomes.collect::<std::io::Result<Vec<()>>>()
    });
    outcome.and_then(|_| sync(files)).map_err(|e| unwritten(files, &e))
}

/// Removes created folders that are empty, the deepest first.
fn unmake(made: &[PathBuf]) {
    for folder in made.iter().rev() {
        if std::fs::remove_dir(folder).is_err() {
            return;
        }
    }
}

/// The parent folder of a path.
fn parent(path: &Path) -> PathBuf {
    match path.parent() {
        Some(parent) if !parent.as_os_str().is_empty() => parent.to_path_buf(),
        // `out`, or `.` and `..`, whose parents do not have a name.
        _ if path.file_name().is_some() => PathBuf::from("."),
        _ => path.join(".."),
    }
}
