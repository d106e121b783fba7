//! Echo of the input, defaults marked with their source.

use super::{Section, Source};
use files::error::Error;

/// Makes the section.
pub(super) fn make(source: &Source) -> Result<Option<Section>, Error> {
    let rows = &source.results.input;
    if rows.is_empty() {
        return Ok(None);
    }
    let mut section = Section::new("input");
    section.set("defaults", &rows.iter().filter(|r| r.default).count());
    section.set("rows", rows);
    Ok(Some(section))
}
