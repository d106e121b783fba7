//! Provenance: files with hashes; version, time and command line in the one element that may differ between two runs.

use serde::Serialize;

use super::{Section, Source};
use crate::number::fixed;
use crate::words::sections::format;
use files::error::Error;

#[derive(Serialize)]
struct File {
    role: String,
    name: String,
    sha256: String,
}

#[derive(Serialize)]
struct Volatile {
    version: String,
    created: String,
    command: String,
    seconds: String,
}

/// Makes the section.
pub(super) fn make(source: &Source) -> Result<Option<Section>, Error> {
    let results = source.results;
    let files: Vec<File> = results
        .files
        .iter()
        .map(|f| File {
            role: f.role.clone(),
            name: f.name.clone(),
            sha256: f.sha256.clone(),
        })
        .collect();
    let v = &results.volatile;
    let mut section = Section::new("provenance");
    section.set("files", &files);
    section.set("format", &format(&results.format));
    section.set(
        "volatile",
        &Volatile {
            version: v.version.clone(),
            created: v.created.clone(),
            command: v.command.clone(),
            seconds: fixed(v.seconds, 2),
        },
    );
    Ok(Some(section))
}
