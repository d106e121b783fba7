//! Provenance: files with hashes; version, time and command line in the one element that may differ between two runs.

use serde::Serialize;

use super::{Section, Source};
use crate::number::fixed;
use crate::words::sections::format;
use files::error::Error;
use results::SourceFile;

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
    Ok(Some(of(&results.files, &results.format, &results.volatile)))
}

/// The section of results in a format.
pub(crate) fn of(files: &[SourceFile], written: &str, v: &results::Volatile) -> Section {
    let mut section = Section::new("provenance");
    section.set("files", files);
    section.set("format", &format(written));
    section.set(
        "volatile",
        &Volatile {
            version: v.version.clone(),
            created: v.created.clone(),
            command: v.command.clone(),
            // None where the time of the run is fixed.
            seconds: if v.seconds > 0.0 { fixed(v.seconds, 2) } else { String::new() },
        },
    );
    section
}
