//! Staging folders: where results are written before they are whole.
//!
//! ```text
//! .out.4711.partial/
//!   staging.json     marker: format, process, target; locked while the process lives
//!   files/           the new files with their manifest
//!   commit.json      there from the moment on when all files are complete: what the target loses
//! ```
//!
//! The lock, not the number of the process, tells whether its owner lives: numbers are used again, and mean nothing in
//! another container. Where a file system knows no locks, the number has to do.

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

/// What this process has begun to write and what it has put in place. Held while a staging folder is made and while results
/// move to their place, so that an ending process waits for both.
pub(super) static LEDGER: Mutex<Ledger> = Mutex::new(Ledger {
    unfinished: Vec::new(),
    kept: false,
    ended: false,
});

/// See [`LEDGER`].
pub(super) struct Ledger {
    /// Staging folders that are not committed.
    pub unfinished: Vec<PathBuf>,
    /// Whether results have been put in place.
    pub kept: bool,
    /// The process ends: nothing is begun or put in place any more.
    ended: bool,
}

/// The ledger of a process that goes on. In one that is being ended the caller waits for the end.
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

/// Removes what is half-written, before the process is ended without unwinding. Results that are moving to their place get
/// there first, and none after that. Whether this process has put any in place.
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
            // A thread that panicked while it moved results: the next run finishes that.
            Err(TryLockFailure::Poisoned(_)) => return false,
            // It may be the thread that ends the process itself.
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

/// What a commit still has to do.
#[derive(Debug, Serialize, Deserialize)]
pub(super) struct Commit {
    /// Where the files go.
    pub target: PathBuf,
    /// Paths in the target that the new results do not have any more.
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
    /// Makes one in `home` for results that go to `target`.
    ///
    /// Errors: those of the file system.
    pub fn new(home: &Path, name: &str, target: &Path) -> std::io::Result<Staging> {
        let target = std::path::absolute(target)?;
        let process = std::process::id();
        let mut ledger = ledger();
        for count in 0.. {
            let end = if count == 0 { String::new() } else { format!("-{count}") };
            let folder = home.join(format!(".{name}.{process}{end}{PARTIAL}"));
            match std::fs::create_dir(&folder) {
                // Of another run in this process, or of one in another container.
                Err(e) if e.kind() == ErrorKind::AlreadyExists && count < 100 => continue,
                other => other?,
            }
            // A sweep may take the empty folder for litter in this very moment.
            let marker = match File::create_new(folder.join(MARKER)) {
                Err(e) if e.kind() == ErrorKind::NotFound && count < 100 => continue,
                other => other,
            };
            let marked = marker.and_then(|mut file| {
                // Without locks the process counts.
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

    /// Where the files are written.
    pub fn files(&self) -> PathBuf {
        self.folder.join(FILES)
    }

    /// Moves the files to their place: from here on they get there, if not by this process then by the next.
    ///
    /// Errors: those of the file system.
    pub fn move_on(&self, commit: &Commit) -> std::io::Result<()> {
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

/// Gives up a staging folder of this process.
pub(super) fn discard(folder: &Path) {
    let mut ledger = ledger();
    ledger.unfinished.retain(|other| other != folder);
    clear(folder);
}

/// Removes a staging folder. One whose commit could not move everything stays for the next run.
pub(super) fn clear(folder: &Path) {
    if !folder.join(COMMIT).exists() {
        remove(folder);
    }
}

/// Moves every file of a staging folder to its place, the manifest last, removes what is stale, then the folder itself. Can
/// be repeated after an end at any moment.
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
        // Folders that are empty now; others stay.
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

/// Removes a staging folder, its marker last: an end half-way leaves one that is recognised.
fn remove(folder: &Path) {
    // A thread of a process that is ended may still be writing: until the folder of files is gone. What cannot be removed is
    // litter that the next run tries again.
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

/// Sweeps the staging folders in `home` whose process is gone: those that were being committed move on, the others are
/// removed. Folders without a marker of this program are left alone.
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

/// The process of another staging folder in one of `homes` that lives and writes to `target`.
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
    // Folders of processes that are gone have been swept.
    markers
        .filter_map(|text| serde_json::from_slice::<Marker>(&text).ok())
        .find(|marker| marker.format == FORMAT && marker.target == target)
        .map(|marker| marker.process)
}

fn sweep_one(folder: &Path) {
    let marker = match File::open(folder.join(MARKER)) {
        Ok(file) => file,
        Err(_) => {
            // Ended before it had a marker, or after it had lost it: empty, or not ours.
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
        // What cannot be moved now stays for the next run.
        Some(commit) => drop(moves(folder, &commit)),
        None => remove(folder),
    }
}

/// Whether there is a process of this number, where that can be seen; else it is taken to live.
fn process_lives(process: u32) -> bool {
    let all = Path::new("/proc");
    !all.join("self").exists() || all.join(process.to_string()).exists()
}
