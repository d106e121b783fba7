//! The list of files written by this program into a folder: `manifest.json`.

use std::collections::BTreeMap;
use std::io::BufRead;
use std::path::{Path, PathBuf};

use serde::{Deserialize, Serialize};
use sha2::{Digest, Sha256};

use super::{files_below, unwritten};
use crate::error::Error;

/// Name of the manifest in a folder of results.
pub const MANIFEST_FILE: &str = "manifest.json";
/// Format of the manifest.
const FORMAT: &str = "tankcheck-manifest/1";

/// Files of a folder that this program wrote.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub(crate) struct Manifest {
    format: String,
    /// Kind of the results ([`super::Kind::id`]).
    pub kind: String,
    /// Path in the folder, with `/` between its parts → SHA-256 as hexadecimal digits.
    pub files: BTreeMap<String, String>,
}

/// State of the manifest in a folder.
#[derive(Debug)]
pub(crate) enum Found {
    /// Absent.
    None,
    /// A manifest of this program.
    Own(Manifest),
    /// A file of that name that this program did not write, or a damaged one.
    Foreign,
}

impl Manifest {
    /// The manifest of the files below `folder`.
    ///
    /// Errors: a file that cannot be read.
    pub(crate) fn of(folder: &Path, kind: &str) -> Result<Manifest, Error> {
        let mut files = BTreeMap::new();
        for path in files_below(folder).map_err(|e| unwritten(folder, &e))? {
            let hash = hash(&folder.join(&path)).map_err(|e| unwritten(&path, &e))?;
            files.insert(key(&path), hash);
        }
        Ok(Manifest { format: FORMAT.into(), kind: kind.into(), files })
    }

    /// Reads the manifest of a folder.
    pub(crate) fn find(folder: &Path) -> Found {
        match super::read(&folder.join(MANIFEST_FILE)) {
            Err(e) if e.kind() == std::io::ErrorKind::NotFound => Found::None,
            Err(_) => Found::Foreign,
            Ok(text) => match serde_json::from_slice::<Manifest>(&text) {
                Ok(manifest) if manifest.format == FORMAT && manifest.inside() => Found::Own(manifest),
                _ => Found::Foreign,
            },
        }
    }

    /// Whether every file is below the folder: a manifest may have been edited.
    fn inside(&self) -> bool {
        let plain = |part: std::path::Component| matches!(part, std::path::Component::Normal(_));
        self.files.keys().all(|k| !k.is_empty() && Path::new(k).components().all(plain))
    }

    /// As text.
    pub(crate) fn text(&self) -> Result<String, Error> {
        let text = serde_json::to_string_pretty(self).map_err(|e| Error::Report(e.to_string()))?;
        Ok(text + "\n")
    }

    /// Whether a file or a folder of files of this name is in it.
    pub(crate) fn has(&self, name: &str) -> bool {
        let folder = format!("{name}/");
        self.files.contains_key(name) || self.files.keys().any(|k| k.starts_with(&folder))
    }

    /// The first file of `folder` that exists but differs from the manifest, among those that `counts` accepts.
    pub(crate) fn changed(&self, folder: &Path, counts: impl Fn(&str) -> bool) -> Option<&str> {
        let differs = |(name, written): &(&String, &String)| {
            let path = folder.join(name);
            counts(name) && path.symlink_metadata().is_ok() && !hash(&path).is_ok_and(|h| h == **written)
        };
        self.files.iter().find(differs).map(|(name, _)| name.as_str())
    }
}

/// A relative path as a key of the manifest.
pub(crate) fn key(path: &Path) -> String {
    let parts: Vec<_> = path.iter().map(|part| part.to_string_lossy()).collect();
    parts.join("/")
}

/// The path of a key.
pub(crate) fn path(key: &str) -> PathBuf {
    key.split('/').collect()
}

/// SHA-256 of a file, hexadecimal.
fn hash(path: &Path) -> std::io::Result<String> {
    let mut hash = Sha256::new();
    let mut file = std::io::BufReader::new(super::regular::open(path)?);
    loop {
        let part = file.fill_buf()?;
        if part.is_empty() {
            break;
        }
        hash.update(part);
        let read = part.len();
        file.consume(read);
    }
    Ok(hash.finalize().iter().map(|byte| format!("{byte:02x}")).collect())
}
