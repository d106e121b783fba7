//! Unfinished work that a later run can resume: a folder inside the output folder.
//!
//! ```text
//! out/unfinished/
//!   work.json     marker: format, kind; locked while a run works here
//!   …             files of the run
//! ```

use std::fs::{File, OpenOptions, TryLockError};
use std::io::{Read, Seek, Write};
use std::path::{Path, PathBuf};

use serde::{Deserialize, Serialize};

use super::{PART, unwritten};
use crate::code::Code;
use crate::error::{Error, describe};

const FORMAT: &str = "tankcheck-work/1";
const MARKER: &str = "work.json";
/// Name of the folder.
const FOLDER: &str = "unfinished";

#[derive(Serialize, Deserialize)]
struct Marker {
    format: String,
    kind: String,
}

/// The folder of an unfinished run.
#[derive(Debug)]
pub struct WorkFolder {
    folder: PathBuf,
    /// Keeps the lock.
    marker: File,
    /// Names of the files of a run; others are not touched.
    owns: fn(&str) -> bool,
    /// The output folder, if it was created for this.
    made: Option<PathBuf>,
}

impl WorkFolder {
    /// Opens or creates the work folder of an output folder; without `resume` the files of an earlier run (names
    /// accepted by `owns`) are removed. Errors: a folder that this program did not write, of another kind of run, or
    /// in use by another process; those of the file system.
    pub fn open(out: &Path, kind: &str, owns: fn(&str) -> bool, resume: bool) -> Result<WorkFolder, Error> {
        let folder = out.join(FOLDER);
        let fault =
            |e: std::io::Error| Error::File { code: Code::NotWritten, path: folder.clone(), what: describe(&e) };
        let taken = |what: String| Error::Taken {
            path: folder.clone(),
            what,
            help: "move it elsewhere, or name another folder with --out".into(),
        };
        let marker = folder.join(MARKER);
        let found = folder.symlink_metadata().is_ok();
        if found && !marker.is_file() && !empty(&folder) {
            return Err(taken("is not a folder of unfinished work of tankcheck".into()));
        }
        let made = (!out.exists()).then(|| out.to_path_buf());
        std::fs::create_dir_all(&folder).map_err(fault)?;
        let mut options = OpenOptions::new();
        let mut file = options.read(true).write(true).create(true).truncate(false).open(&marker).map_err(fault)?;
        if let Err(TryLockError::WouldBlock) = file.try_lock() {
            return Err(Error::File {
                code: Code::FileTaken,
                path: folder,
                what: "is in use by another process; wait for it, or name another folder with --out".into(),
            });
        }
        let mut text = String::new();
        file.read_to_string(&mut text).map_err(fault)?;
        // Empty: ended while it was written.
        if !text.is_empty()
            && !serde_json::from_str::<Marker>(&text).is_ok_and(|m| m.format == FORMAT && m.kind == kind)
        {
            return Err(taken(format!("is not unfinished work of `tankcheck {kind}`")));
        }
        let work = WorkFolder { folder: folder.clone(), marker: file, owns, made };
        for name in work.names()? {
            if !resume || name.ends_with(PART) {
                let path = folder.join(&name);
                std::fs::remove_file(&path).map_err(|e| unwritten(&path, &e))?;
            }
        }
        work.mark(kind).map_err(|e| unwritten(&marker, &e))?;
        Ok(work)
    }

    fn mark(&self, kind: &str) -> std::io::Result<()> {
        let mut file = &self.marker;
        file.rewind()?;
        file.set_len(0)?;
        let marker = Marker { format: FORMAT.into(), kind: kind.into() };
        file.write_all(&serde_json::to_vec(&marker)?)
    }

    /// Path of a file in it.
    pub fn file(&self, name: &str) -> PathBuf {
        self.folder.join(name)
    }

    /// Names of the files of an earlier run, sorted.
    ///
    /// Errors: those of the file system.
    pub fn names(&self) -> Result<Vec<String>, Error> {
        let fault = |e: std::io::Error| Error::unreadable(&self.folder, &e);
        let mut names = Vec::new();
        for entry in std::fs::read_dir(&self.folder).map_err(fault)? {
            let name = entry.map_err(fault)?.file_name().to_string_lossy().into_owned();
            if name != MARKER && (self.owns)(&name) {
                names.push(name);
            }
        }
        names.sort();
        Ok(names)
    }

    /// Removes the folder: the work is done.
    pub fn done(self) {
        for name in self.names().unwrap_or_default() {
            // The next run removes the rest.
            let _ = std::fs::remove_file(self.folder.join(name));
        }
    }
}

/// Removes a folder without work and without foreign files; the marker is the last file.
impl Drop for WorkFolder {
    fn drop(&mut self) {
        let alone = || std::fs::read_dir(&self.folder).is_ok_and(|entries| entries.count() <= 1);
        if self.names().is_ok_and(|names| names.is_empty()) && alone() {
            let _ = std::fs::remove_file(self.folder.join(MARKER));
            let _ = std::fs::remove_dir(&self.folder);
            if let Some(out) = &self.made {
                let _ = std::fs::remove_dir(out);
            }
        }
    }
}

fn empty(folder: &Path) -> bool {
    std::fs::read_dir(folder).is_ok_and(|mut entries| entries.next().is_none())
}
