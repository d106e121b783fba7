//! Echo of the input, defaults marked with their source.

use serde::Serialize;

use super::{Section, Source};
use files::error::Error;

#[derive(Serialize)]
struct Row {
    path: String,
    text: String,
    default: bool,
    source: String,
}

/// Makes the section.
pub(super) fn make(source: &Source) -> Result<Option<Section>, Error> {
    let rows: Vec<Row> = source
        .results
        .input
        .iter()
        .map(|v| Row { path: v.path.clone(), text: v.text.clone(), default: v.default, source: v.source.clone() })
        .collect();
    if rows.is_empty() {
        return Ok(None);
    }
    let mut section = Section::new("input");
    section.set("defaults", &rows.iter().filter(|r| r.default).count());
    section.set("rows", &rows);
    Ok(Some(section))
}
