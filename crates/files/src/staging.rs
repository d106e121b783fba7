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
pub(super) static LEDGER: Mutex<Ledger> = Mutex::new(Ledger {
    unfinished: Vec::new(),
    kept: false,
    ended: false,
});

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
                let text = serde_json::to_vec(&Marker {
                    format: FORMAT.into(),
                    process,
                    target: target.clone(),
                })?;
                file.write_all(&text)?;
                std::fs::create_dir(folder.join(FILES))?;
                Ok(file)
            });
            return match marked {
                Ok(marker) => {
                    ledger.unfinished.push(folder.clone());
                    Ok(Staging {
                        folder,
                        _marker: marker,
                    })
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
    pub(crate) fn move_on(&self, commit: &Commit) -> std::io::Result<()> {
        let text = serde_json::to_vec(commit)?;
        let path = self.folder.join(COMMIT);
        let beside = self.folder.join("commit.part");
        let mut file = File::create(&beside)?;
        file.write_all(&text)?;
        file.sync_all()?;
        drop(file);
        std::fs::rename(beside, path)?;
        sync(&self.folder)?;
        moves(&self.folder, commit)
    }
}

impl Drop for Staging {
    fn drop(&mut self) {
        discard(&self.folder);
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
    let Ok(entries) = std::fs::read_dir(home) else {
        return;
    };
    for entry in entries.flatten() {
        let name = entry.file_name();
        let name = name.to_string_lossy();
        if name.starts_with('.') && name.ends_with(PARTIAL) && entry.file_type().is_ok_and(|t| t.is_dir()) {
            sweep_one(&entry.path());
        }
    }
}

/// The live process of another staging folder in one of `homes` that writes to `target`.
pub(super) fn owner(homes: [PathBuf; 2], target: &Path) -> Option<u32> {
    let target = std::path::absolute(target).ok()?;
    let entries = homes
        .iter()
        .filter_map(|home| std::fs::read_dir(home).ok())
        .flatten()
        .flatten();
    let markers = entries
        .filter(|entry| entry.file_name().to_string_lossy().ends_with(PARTIAL))
        .filter_map(|entry| std::fs::read(entry.path().join(MARKER)).ok());
    // Folders of dead processes have been swept.
    markers
        .filter_map(|text| serde_json::from_slice::<Marker>(&text).ok())
        .find(|marker| marker.format == FORMAT && marker.target == target)
        .map(|marker| marker.process)
}

fn sweep_one(folder: &Path) {
    let marker = match File::open(folder.join(MARKER)) {
        Ok(file) => file,
        Err(_) => {
            // Ended before the marker was written or after it was removed: empty, or not ours.
            let _ = std::fs::remove_dir(folder);
            return;
        }
    };
    let text = std::fs::read(folder.join(MARKER)).unwrap_or_default();
    let found = serde_json::from_slice::<Marker>(&text).ok();
    match (&found, text.is_empty()) {
        (Some(marker), _) if marker.format == FORMAT => {}
        // Ended while the marker was written.
        (None, true) => {}
        _ => return,
    }
    let lives = match marker.try_lock() {
        Ok(()) => false,
        Err(TryLockError::WouldBlock) => true,
        Err(TryLockError::Error(_)) => found.is_none_or(|m| process_lives(m.process)),
    };
    if lives {
        return;
    }
    let commit = std::fs::read(folder.join(COMMIT)).ok();
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
