//! Staging folders: results are written here until they are complete.
//!
//! ```text
//! .out.4711.partial/
//!   staging.json     marker: format, process, target; locked while the process lives
//!   files/           the new files with their manifest
//!   commit.json      exists once all files are complete: list of obsolete files in the target
//! ```
//! The lock, not the process number, shows whether the owner lives: numbers are reused and are meaningless in another
//! container. On file systems without locks the number is used.

use std::fs::{File, TryLockError};
use std::io::{ErrorKind, Write};
use std::path::{Path, PathBuf};
use std::sync::{Mutex, MutexGuard, PoisonError, TryLockError as TryLockFailure};
use std::time::{Duration, Instant};

use serde::{Deserialize, Serialize};

use super::manifest::MANIFEST_FILE;
use super::{files_below, sync};

const FORMAT: &str = "tankcheck-staging/1";
const MARKER: &str = "staging.json";
const COMMIT: &str = "commit.json";
const FILES: &str = "files";
/// End of the name of a staging folder.
const PARTIAL: &str = ".partial";

/// Staging folders of this process, and whether it has committed. Locked while a staging folder is created and while
/// results move, so that an ending process waits for both.
pub(super) static LEDGER: Mutex<Ledger> = Mutex::new(Ledger { unfinished: Vec::new(), kept: false, ended: false });

/// See [`LEDGER`].
pub(super) struct Ledger {
    /// Staging folders that are not committed.
    pub unfinished: Vec<PathBuf>,
    /// Whether results have been committed.
    pub kept: bool,
    /// The process ends: new staging folders and commits are blocked.
    ended: bool,
}

/// The ledger of a running process. In an ending process the caller waits for the end.
pub(super) fn ledger() -> MutexGuard<'static, Ledger> {
    loop {
        let ledger = LEDGER.lock().unwrap_or_else(PoisonError::into_inner);
        if !ledger.ended {
            return ledger;
        }
        drop(ledger);
        std::thread::park();
    }
}

/// Removes partial files before the process exits without unwinding. A commit in progress is finished first; later
/// ones are blocked. Returns whether this process has committed results.
pub fn discard_unfinished() -> bool {
    const PATIENCE: Duration = Duration::from_secs(10);
    let began = Instant::now();
    loop {
        match LEDGER.try_lock() {
            Ok(mut ledger) => {
                ledger.ended = true;
                ledger.unfinished.drain(..).for_each(|staging| remove(&staging));
                return ledger.kept;
            }
            // A thread that panicked while moving results: the next run finishes the move.
            Err(TryLockFailure::Poisoned(_)) => return false,
            // It may be the ending thread itself.
            Err(TryLockFailure::WouldBlock) if began.elapsed() > PATIENCE => return false,
            Err(TryLockFailure::WouldBlock) => std::thread::sleep(Duration::from_millis(5)),
        }
    }
}

/// The marker.
#[derive(Debug, Serialize, Deserialize)]
struct Marker {
    format: String,
    process: u32,
    target: PathBuf,
}

/// Remaining work of a commit.
#[derive(Debug, Serialize, Deserialize)]
pub(super) struct Commit {
    /// Target folder.
    pub target: PathBuf,
    /// Obsolete paths in the target.
    pub stale: Vec<PathBuf>,
}

/// A staging folder of this process.
#[derive(Debug)]
pub(super) struct Staging {
    /// The folder.
    pub folder: PathBuf,
    /// Keeps the lock.
    _marker: File,
    /// Whether the folder is gone, or left to the next run. Its name may be that of another run by then.
    released: bool,
}

impl Staging {
    /// Creates one in `home` for the results of `target`.
    ///
    /// Errors: those of the file system.
    pub(crate) fn new(home: &Path, name: &str, target: &Path) -> std::io::Result<Staging> {
        let target = std::path::absolute(target)?;
        let process = std::process::id();
        let mut ledger = ledger();
        for count in 0.. {
            let end = if count == 0 { String::new() } else { format!("-{count}") };
            let folder = home.join(format!(".{name}.{process}{end}{PARTIAL}"));
            match std::fs::create_dir(&folder) {
                // Belongs to another run in this process, or in another container.
                Err(e) if e.kind() == ErrorKind::AlreadyExists && count < 100 => continue,
                other => other?,
            }
            // A sweep may remove the empty folder at this moment.
            let marker = match File::create_new(folder.join(MARKER)) {
                Err(e) if e.kind() == ErrorKind::NotFound && count < 100 => continue,
                other => other,
            };
            let marked = marker.and_then(|mut file| {
                // Without locks the process number decides.
                let _ = file.try_lock();
                let text = serde_json::to_vec(&Marker { format: FORMAT.into(), process, target: target.clone() })?;
                file.write_all(&text)?;
                std::fs::create_dir(folder.join(FILES))?;
                Ok(file)
            });
            return match marked {
                Ok(marker) => {
                    ledger.unfinished.push(folder.clone());
                    Ok(Staging { folder, _marker: marker, released: false })
                }
                Err(error) => {
                    remove(&folder);
                    Err(error)
                }
            };
        }
        unreachable!("the count ends with an error of the file system")
    }

    /// Folder of the new files.
    pub(crate) fn files(&self) -> PathBuf {
        self.folder.join(FILES)
    }

    /// Moves the files to the target. Once started, the commit is finished by this process or by the next run.
    ///
    /// Errors: those of the file system.
    pub(crate) fn move_on(&mut self, commit: &Commit) -> std::io::Result<()> {
        let text = serde_json::to_vec(commit)?;
        let path = self.folder.join(COMMIT);
        let beside = self.folder.join("commit.part");
        let mut file = File::create(&beside)?;
        file.write_all(&text)?;
        file.sync_all()?;
        drop(file);
        std::fs::rename(beside, path)?;
        sync(&self.folder)?;
        moves(&self.folder, commit)?;
        self.released = true;
        Ok(())
    }

    /// Removes the folder, unless its commit is incomplete. The caller has the ledger.
    pub(crate) fn release(&mut self) {
        if !std::mem::replace(&mut self.released, true) {
            clear(&self.folder);
        }
    }

    /// The same for a caller without the ledger.
    pub(crate) fn discard(&mut self) {
        if !std::mem::replace(&mut self.released, true) {
            discard(&self.folder);
        }
    }
}

impl Drop for Staging {
    fn drop(&mut self) {
        self.discard();
    }
}

/// Releases a staging folder of this process.
pub(super) fn discard(folder: &Path) {
    let mut ledger = ledger();
    ledger.unfinished.retain(|other| other != folder);
    clear(folder);
}

/// Removes a staging folder, unless its commit is incomplete; then the next run finishes it.
pub(super) fn clear(folder: &Path) {
    if !folder.join(COMMIT).exists() {
        remove(folder);
    }
}

/// Moves every file of a staging folder to the target, the manifest last, then removes obsolete files and the folder
/// itself. Can be repeated after an interruption at any point.
fn moves(folder: &Path, commit: &Commit) -> std::io::Result<()> {
    let (files, target) = (folder.join(FILES), &commit.target);
    if files.is_dir() {
        let mut paths = files_below(&files)?;
        paths.sort_by_key(|p| p == Path::new(MANIFEST_FILE));
        let mut homes: Vec<PathBuf> = Vec::new();
        for path in &paths {
            let place = target.join(path);
            let home = place.parent().unwrap_or(target).to_path_buf();
            if !homes.contains(&home) {
                std::fs::create_dir_all(&home)?;
                homes.push(home);
            }
            std::fs::rename(files.join(path), place)?;
        }
        for home in &homes {
            sync(home)?;
        }
    }
    for path in &commit.stale {
        match std::fs::remove_file(target.join(path)) {
            Err(e) if e.kind() != ErrorKind::NotFound => return Err(e),
            _ => {}
        }
        // Only empty folders are removed.
        let homes = path.ancestors().skip(1).filter(|p| !p.as_os_str().is_empty());
        for home in homes {
            if std::fs::remove_dir(target.join(home)).is_err() {
                break;
            }
        }
    }
    remove(folder);
    Ok(())
}

/// Removes a staging folder, its marker last, so that it is recognised after an interruption.
fn remove(folder: &Path) {
    // A thread of an ending process may still be writing: repeat until the folder of files is gone. The next run
    // retries whatever remains.
    for _ in 0..200 {
        match std::fs::remove_dir_all(folder.join(FILES)) {
            Err(e) if e.kind() == ErrorKind::DirectoryNotEmpty => {}
            _ => break,
        }
    }
    let _ = std::fs::remove_file(folder.join("commit.part"));
    let _ = std::fs::remove_file(folder.join(COMMIT));
    let _ = std::fs::remove_file(folder.join(MARKER));
    let _ = std::fs::remove_dir(folder);
}

/// Sweeps the staging folders in `home` whose process is gone: started commits are finished, the others are removed.
/// Folders without a marker of this program are untouched.
pub(super) fn sweep(home: &Path) {
    for folder in named(home) {
        sweep_one(&folder);
    }
}

/// Folders in `home` with the name of a staging folder.
fn named(home: &Path) -> impl Iterator<Item = PathBuf> {
    let entries = std::fs::read_dir(home).into_iter().flatten().flatten();
    let staging = |entry: &std::fs::DirEntry| {
        let name = entry.file_name();
        let name = name.to_string_lossy();
        name.starts_with('.') && name.ends_with(PARTIAL) && entry.file_type().is_ok_and(|t| t.is_dir())
    };
    entries.filter(staging).map(|entry| entry.path())
}

/// Whether a run of another process writes in `home`, or was killed there.
pub(super) fn leftover(home: &Path) -> bool {
    named(home).next().is_some()
}

/// Those without a marker of this program.
pub(super) fn unmarked(home: &Path) -> Vec<PathBuf> {
    named(home).filter(|folder| marker(folder).is_none()).collect()
}

/// The marker of a staging folder.
fn marker(folder: &Path) -> Option<Marker> {
    let marker: Marker = serde_json::from_slice(&super::read(&folder.join(MARKER)).ok()?).ok()?;
    (marker.format == FORMAT).then_some(marker)
}

/// The live process of another staging folder in one of `homes` that writes to `target`.
pub(super) fn owner(homes: [PathBuf; 2], target: &Path) -> Option<u32> {
    let target = std::path::absolute(target).ok()?;
    let markers = homes.iter().flat_map(|home| named(home)).filter_map(|folder| marker(&folder));
    // Folders of dead processes have been swept.
    markers.filter(|marker| marker.target == target).map(|marker| marker.process).next()
}

fn sweep_one(folder: &Path) {
    let path = folder.join(MARKER);
    let Ok(text) = super::read(&path) else {
        // Ended before the marker was written or after it was removed: empty, or not ours.
        let _ = std::fs::remove_dir(folder);
        return;
    };
    let found = marker(folder);
    // Empty: ended while the marker was written.
    if found.is_none() && !text.is_empty() {
        return;
    }
    // Open, and so locked, until the folder is gone.
    let file = File::open(path);
    let lives = match file.as_ref().map(File::try_lock) {
        Ok(Ok(())) => false,
        Ok(Err(TryLockError::WouldBlock)) => true,
        _ => found.is_none_or(|m| process_lives(m.process)),
    };
    if lives {
        return;
    }
    let commit = super::read(&folder.join(COMMIT)).ok();
    match commit.and_then(|text| serde_json::from_slice::<Commit>(&text).ok()) {
        // The next run moves the rest.
        Some(commit) => drop(moves(folder, &commit)),
        None => remove(folder),
    }
}

/// Whether a process of this number exists; assumed true if this cannot be determined.
fn process_lives(process: u32) -> bool {
    let all = Path::new("/proc");
    !all.join("self").exists() || all.join(process.to_string()).exists()
}
