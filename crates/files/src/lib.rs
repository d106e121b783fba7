//! The output folder: whole or not at all, and only its own files.
//!
//! ```text
//! prepare ─ staging next to the target ─  files ─ commit: manifest, fsync, moves ─ target
//!             └ removed by the next run if its process is gone, finished if the commit had begun
//! ```
//! * **Ownership.** A results folder contains `manifest.json` with the hash of every file written into it
//!   (`manifest`). A file that is not in it, or that changed since, is never replaced or removed; if it is at the
//!   path of a result, the run is rejected before anything is computed.
//! * **Staging.** Files are written into a separate folder with a marker, locked while the process lives (`staging`).
//!   After a kill the lock is free: the next run removes the folder, or, if all files were complete and only the
//!   moves were missing, finishes them.
//! * **Replacing.** The old files stay until the new ones are complete and on the disk; then each new file replaces
//!   its predecessor by a rename, the manifest last, and obsolete files are removed.
//! * **Unfinished work** that a later run can resume is in a folder next to the results (`work`).

pub mod code;
pub mod error;
mod folder;
mod manifest;
mod regular;
mod staging;
#[cfg(test)]
mod tests;
pub mod text;
mod work;

pub use folder::{Kind, Lock, OutputFolder, differing, edited, kept_complete, settle, unmarked};
pub use manifest::MANIFEST_FILE;
pub use regular::{open, read, read_text, special};
pub use staging::discard_unfinished;
pub use work::WorkFolder;

use std::fs::File;
use std::io::Write;
use std::path::{Path, PathBuf};

use crate::error::{Error, describe};

/// Writes text to `path` through a temporary file and a rename: complete or not at all, and synchronised to the disk.
/// Errors: [`Error::Unwritten`]; the temporary file is removed.
pub fn write_whole(path: &Path, text: &[u8]) -> Result<(), Error> {
    let mut name = path.file_name().unwrap_or_default().to_owned();
    name.push(PART);
    let beside = path.with_file_name(name);
    let write = || -> std::io::Result<()> {
        let mut file = File::create(&beside)?;
        file.write_all(text)?;
        file.sync_all()?;
        drop(file);
        std::fs::rename(&beside, path)
    };
    write().map_err(|e| {
        // A partial file is useless; if it cannot be removed either, the first error is more informative.
        let _ = std::fs::remove_file(&beside);
        unwritten(path, &e)
    })
}

/// End of the name of a file that is being written.
pub const PART: &str = ".part";

fn unwritten(path: &Path, error: &std::io::Error) -> Error {
    Error::Unwritten { path: path.into(), what: describe(error) }
}

/// Synchronises a file or folder to the disk. Not every system can synchronise folders, so their failure is ignored.
fn sync(path: &Path) -> std::io::Result<()> {
    let file = File::open(path)?;
    match file.sync_all() {
        Err(error) if !file.metadata()?.is_dir() => Err(error),
        _ => Ok(()),
    }
}

/// Files below a folder, relative to it, in the order of their names.
fn files_below(folder: &Path) -> std::io::Result<Vec<PathBuf>> {
    let mut found = Vec::new();
    let mut open = vec![PathBuf::new()];
    while let Some(relative) = open.pop() {
        for entry in std::fs::read_dir(folder.join(&relative))? {
            let entry = entry?;
            let path = relative.join(entry.file_name());
            if entry.file_type()?.is_dir() { open.push(path) } else { found.push(path) }
        }
    }
    found.sort();
    Ok(found)
}
