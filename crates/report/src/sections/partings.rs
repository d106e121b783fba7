//! Where and why the methods differ.

use serde::Serialize;

use super::{Section, Source};
use crate::words::differences::{what, why};
use files::error::Error;

#[derive(Serialize)]
struct Group {
    quantity: &'static str,
    items: Vec<Item>,
}

#[derive(Serialize)]
struct Item {
    what: String,
    why: String,
}

/// Makes the section.
pub(super) fn make(source: &Source) -> Result<Option<Section>, Error> {
    let mut groups: Vec<Group> = Vec::new();
    for difference in &source.results.comparison.differences {
        let Some(first) = difference.ratios.first() else { continue };
        let quantity = first.quantity.title();
        if groups.last().is_none_or(|g| g.quantity != quantity) {
            groups.push(Group { quantity, items: Vec::new() });
        }
        if let Some(group) = groups.last_mut() {
            group.items.push(Item { what: what(source.results, difference), why: why(source.results, difference) });
        }
    }
    if groups.is_empty() {
        return Ok(None);
    }
    let mut section = Section::new("partings");
    section.set("groups", &groups);
    Ok(Some(section))
}
